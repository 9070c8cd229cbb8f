//! What stands in the corner of the picture and under it.

use super::Beside;
use super::facts::Told;
use crate::design::NetDesign;
use crate::editor::Editor;
use crate::editor::net::Nets;
use crate::machine::Language;
use crate::screen::{Color, Screen};
use crate::ui::words::Words;

/// Where the lines in the corner begin, and their distance.
const CORNER: (i32, i32) = (36, 64);
const LINE: i32 = 11;
/// Where the line under the picture stands.
const UNDER: (i32, i32) = (30, 470);

const EVERYWHERE: [Words; 2] = [
    Words("J < 0 minden foltban", "J < 0 in every patch"),
    Words("J > 0 minden foltban", "J > 0 in every patch"),
];
const CHANGES: Words = Words("J előjelet vált: ", "J changes sign: ");
const PATCHES: Words = Words(" folt", " patches");
const FOLDED: Words = Words("a felület gyűrött", "the surface is folded");
const NO_LIMITS: Words = Words("nincs határ", "no limits");
const SPHERE: Words = Words("eltérés a gömbtől: ", "off the sphere: ");
const OFFSET_FOLDED: Words = Words("gyűrött", "folded");

/// A number with four digits that mean something.
fn short(value: f64) -> String {
    let size = value.abs();
    match size {
        _ if size == 0.0 => "0".to_owned(),
        _ if !(1e-3..1e5).contains(&size) => format!("{value:.1e}"),
        _ if size >= 100.0 => format!("{value:.1}"),
        _ if size >= 10.0 => format!("{value:.2}"),
        _ => format!("{value:.3}"),
    }
}

impl Editor<Nets, 3> {
    /// Distance, limits, sign of J and the distance between the methods, in the corner of the picture.
    pub(in crate::editor::net) fn draw_corner(&self, screen: &mut Screen, language: Language) {
        let Some(facts) = &self.craft.facts else { return };
        let lines = corner(&self.preview(), facts.told(), self.craft.beside, language);
        for ((text, ink), at) in lines.into_iter().zip(0..) {
            screen.text(CORNER.0, CORNER.1 + LINE * at, &text, ink);
        }
    }

    /// The radii of curvature, under the picture.
    pub(in crate::editor::net) fn draw_radii(&self, screen: &mut Screen, language: Language) {
        let Some(Told { r1: Some(r1), r2: Some(r2), sphere, .. }) =
            self.craft.facts.as_ref().map(|it| it.told().clone())
        else {
            return;
        };
        let range = |[low, high]: [f64; 2]| format!("{} .. {}", short(low), short(high));
        let sphere = sphere.map(|apart| format!("   {}{}", SPHERE.of(language), short(apart)));
        let text = format!("r1 = {}   r2 = {}{}", range(r1), range(r2), sphere.unwrap_or_default());
        screen.text(UNDER.0, UNDER.1, &text, Color::Black);
    }
}

fn corner(net: &NetDesign, told: &Told, beside: Beside, language: Language) -> Vec<(String, Color)> {
    let d = net.distance();
    let mut lines = Vec::new();
    let [low, high] = told.limits.unwrap_or_default();
    let outside = low.is_some_and(|low| d <= low) || high.is_some_and(|high| d >= high);
    let limits = match (told.limits, low, high) {
        (None, ..) => FOLDED.of(language).to_owned(),
        (_, None, None) => NO_LIMITS.of(language).to_owned(),
        (_, Some(low), None) => format!("{} < d", short(low)),
        (_, None, Some(high)) => format!("d < {}", short(high)),
        (_, Some(low), Some(high)) => format!("{} < d < {}", short(low), short(high)),
    };
    if told.r1.is_some() {
        let folded = if outside { format!("  {}", OFFSET_FOLDED.of(language)) } else { String::new() };
        let bad = outside || told.limits.is_none();
        let ink = if bad { Color::LightRed } else { Color::Yellow };
        lines.push((format!("d = {}   {limits}{folded}", short(d)), ink));
    }
    if told.patches > 0 {
        lines.push(match told.parabolic {
            0 => {
                let text = EVERYWHERE[usize::from(told.positive)].of(language);
                (format!("{text}   (11,11)"), Color::LightGray)
            }
            count => {
                let (says, patches) = (CHANGES.of(language), PATCHES.of(language));
                let text = format!("{says}{count} / {}{patches}", told.patches);
                (text, Color::LightRed)
            }
        });
    }
    let method = net.method().name();
    lines.push(match told.apart.filter(|_| beside.compared) {
        Some(apart) => {
            let other = super::other(net.method()).name();
            (format!("{method} - {other}: {}", short(apart)), Color::LightMagenta)
        }
        None => (method.to_owned(), Color::LightGray),
    });
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let texts = [0.0, -15.626, 91.649, 12345.678, 0.0123456, 1e-9, -2e17].map(short);
        assert_eq!(texts, ["0", "-15.63", "91.65", "12345.7", "0.012", "1.0e-9", "-2.0e17"]);
    }
}
