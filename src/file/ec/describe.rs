//! What a file of KC_TER tells about itself.

use super::{Coefficients, CurveTerm, EcCurve, EcDocument, EcPatch, Interval, Item, PatchTerm, values};
use crate::file::check::{self, Bounds};
use crate::geometry::ec::{CriticalLength, Space};

impl EcDocument {
    /// Facts, one a line.
    pub(in crate::file) fn describe(&self) -> Vec<String> {
        match self {
            Self::Space(file) => {
                let mut lines = vec![match &file.name {
                    Some(name) => format!("space {name}"),
                    None => "space".to_owned(),
                }];
                lines.extend(space("", &file.space, file.interval.as_ref()));
                lines
            }
            Self::Curve(it) => curve(it),
            Self::Patch(it) => patch(it),
            Self::Coefficients(Coefficients::Curve { space: it, interval, coefficients }) => {
                let mut lines = vec!["exact description of a curve".to_owned()];
                lines.extend(space("", it, Some(interval)));
                lines.extend(curve_formulas(it, coefficients));
                lines
            }
            Self::Coefficients(Coefficients::Surface {
                space_u,
                interval_u,
                space_v,
                interval_v,
                coefficients,
            }) => {
                let mut lines = vec!["exact description of a surface".to_owned()];
                lines.extend(space("u: ", space_u, Some(interval_u)));
                lines.extend(space("v: ", space_v, Some(interval_v)));
                lines.extend(patch_formulas(space_u, space_v, coefficients));
                lines
            }
            Self::Scene(scene) => {
                let curves = scene.items.iter().filter(|item| matches!(item, Item::Curve(_))).count();
                let patches = scene.items.len() - curves;
                let mut lines = vec![format!("scene, curves: {curves}, patches: {patches}")];
                let points = scene.items.iter().flat_map(|item| match item {
                    Item::Curve(curve) => curve.points.iter().collect::<Vec<_>>(),
                    Item::Patch(patch) => patch.net.iter().flatten().collect(),
                });
                lines.extend(Bounds::of(points).map(|bounds| bounds.describe()));
                for (number, item) in (1..).zip(&scene.items) {
                    let number: usize = number;
                    let facts = match item {
                        Item::Curve(curve) => curve_in_short(curve),
                        Item::Patch(patch) => patch_in_short(patch),
                    };
                    lines.push(format!("item {number}: {facts}"));
                }
                lines
            }
        }
    }
}

fn named(name: Option<&str>) -> String {
    name.map(|name| format!(" {name}")).unwrap_or_default()
}

fn in_brackets(interval: &Interval) -> String {
    format!("[{}, {}]", interval[0], interval[1])
}

fn curve_in_short(curve: &EcCurve) -> String {
    let exact = if curve.exact.is_some() { ", exact" } else { "" };
    format!(
        "curve{}, {{{}}} on {}{exact}",
        named(curve.name.as_deref()),
        curve.space,
        in_brackets(&curve.interval)
    )
}

fn patch_in_short(patch: &EcPatch) -> String {
    format!(
        "patch{}, {{{}}} on {} by {{{}}} on {}{}",
        named(patch.name.as_deref()),
        patch.space_u,
        in_brackets(&patch.interval_u),
        patch.space_v,
        in_brackets(&patch.interval_v),
        if patch.exact.is_some() { ", exact" } else { "" }
    )
}

fn curve(curve: &EcCurve) -> Vec<String> {
    let mut lines = vec![curve_in_short(curve)];
    lines.extend(space("", &curve.space, Some(&curve.interval)));
    lines.extend(Bounds::of(curve.points.iter()).map(|bounds| bounds.describe()));
    lines.extend(check::table("point", &curve.points));
    lines.extend(curve.exact.iter().flat_map(|terms| curve_formulas(&curve.space, terms)));
    lines
}

fn patch(patch: &EcPatch) -> Vec<String> {
    let mut lines = vec![patch_in_short(patch)];
    lines.extend(space("u: ", &patch.space_u, Some(&patch.interval_u)));
    lines.extend(space("v: ", &patch.space_v, Some(&patch.interval_v)));
    lines.extend(Bounds::of(patch.net.iter().flatten()).map(|bounds| bounds.describe()));
    for (i, row) in patch.net.iter().enumerate() {
        lines.extend(check::table(&format!("row {}, point", i + 1), row));
    }
    lines.extend(patch.exact.iter().flat_map(|terms| patch_formulas(&patch.space_u, &patch.space_v, terms)));
    lines
}

/// Facts about a space and its interval.
fn space(prefix: &str, space: &Space, interval: Option<&Interval>) -> Vec<String> {
    let polynomial: Vec<String> = space.polynomial().into_iter().map(check::number).collect();
    let mut lines = vec![
        format!("{prefix}dimension {}", space.dimension()),
        format!("{prefix}roots {space}"),
        format!("{prefix}polynomial, ascending {}", polynomial.join(", ")),
        format!("{prefix}equation {}", space.equation("v")),
        format!("{prefix}functions {}", space.functions("u").join(", ")),
    ];
    if let Some(interval) = interval {
        let [start, end] = values(interval);
        lines.push(format!(
            "{prefix}interval {}, length {}",
            in_brackets(interval),
            check::number(end - start)
        ));
    }
    let critical = CriticalLength::new(space).finish();
    lines.push(format!("{prefix}critical length for design l' = {}", length(critical)));
    let itself = CriticalLength::of_itself(space).finish();
    // A multiple zero, as many spaces have it there, is known to a few digits only.
    lines.push(format!(
        "{prefix}critical length l = {}",
        if itself.is_finite() { format!("{itself:.4}") } else { length(itself) }
    ));
    lines.push(format!(
        "{prefix}{}",
        if space.is_symmetric() { "invariant under reflection" } else { "not invariant under reflection" }
    ));
    lines
}

fn length(length: f64) -> String {
    if length.is_finite() { check::number(length) } else { "infinite".to_owned() }
}

/// x, y and z as sums of functions.
pub(super) fn formulas(terms: impl Iterator<Item = (String, [String; 3], [f64; 3])>) -> Vec<String> {
    let mut sums = [const { String::new() }; 3];
    for (function, texts, values) in terms {
        for ((sum, text), value) in sums.iter_mut().zip(texts).zip(values) {
            if value == 0.0 {
                continue;
            }
            let negative = text.starts_with('-');
            let size = text.strip_prefix('-').unwrap_or(&text);
            sum.push_str(match (sum.is_empty(), negative) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            });
            let bracketed = size.contains(['+', '-']);
            match (function.as_str(), size) {
                ("1", _) => sum.push_str(size),
                (_, "1") => sum.push_str(&function),
                _ if bracketed => sum.push_str(&format!("({size}) {function}")),
                _ => sum.push_str(&format!("{size} {function}")),
            }
        }
    }
    let name = |(axis, sum): (&str, String)| format!("{axis} = {}", if sum.is_empty() { "0" } else { &sum });
    check::AXES.into_iter().zip(sums).map(name).collect()
}

/// The coordinates of an exact curve as formulas, one a line.
#[must_use]
pub fn curve_formulas(space: &Space, terms: &[CurveTerm]) -> Vec<String> {
    let functions = space.functions("u");
    formulas(terms.iter().filter_map(|term| {
        let function = functions.get(term.function)?.clone();
        Some((
            function,
            term.value.each_ref().map(ToString::to_string),
            term.value.each_ref().map(|c| c.value()),
        ))
    }))
}

/// The coordinates of an exact patch as formulas, one a line.
#[must_use]
pub fn patch_formulas(u: &Space, v: &Space, terms: &[PatchTerm]) -> Vec<String> {
    let (along_u, along_v) = (u.functions("u"), v.functions("v"));
    formulas(terms.iter().filter_map(|term| {
        let function = match (along_u.get(term.u)?.as_str(), along_v.get(term.v)?.as_str()) {
            (one, "1") | ("1", one) => one.to_owned(),
            (one, other) => format!("{one} {other}"),
        };
        Some((
            function,
            term.value.each_ref().map(ToString::to_string),
            term.value.each_ref().map(|c| c.value()),
        ))
    }))
}
