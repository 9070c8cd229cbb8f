//! What stands around the picture: the line about the selected item, the list of items, the weight of a point; and the
//! scene as a figure.

use super::edit::{self, Index};
use super::rows::{self, PANEL, short};
use super::shape::Shape;
use super::studio::{Page, Studio};
use super::{paint, texts};
use crate::design::ec::patch_space;
use crate::figure::{Figure, Hidden, print_ink};
use crate::file::ec::{Fill, Item};
use crate::geometry::{Basis, Closure, Grid};
use crate::machine::Language;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::{Area, window};

/// Where the line about the selected item stands, and its letters.
const STATUS: (i32, i32) = (28, 471);
const LETTERS: usize = 75;
/// Rows of the list of items, and letters in one.
const ROWS: usize = 13;
const ROW_LETTERS: usize = 17;

/// Draws all of it.
pub(super) fn draw(studio: &Studio, list: Option<usize>, screen: &mut Screen, language: Language) {
    let line: String = told(studio, language).chars().take(LETTERS).collect();
    screen.text(STATUS.0, STATUS.1, &line, Color::Black);
    match studio.page {
        Page::View => draw_list(studio, list, screen),
        Page::Point => draw_weight(studio, screen, language),
        Page::Curve | Page::Surface => {}
    }
}

/// The selected item in a line.
fn told(studio: &Studio, language: Language) -> String {
    let Some((item, number)) = studio.item().zip(studio.selected) else {
        return match studio.scene().items.len() {
            0 => texts::EMPTY.of(language).to_owned(),
            count => match language {
                Language::Hungarian => format!("{count} elem"),
                Language::English => format!("items: {count}"),
            },
        };
    };
    let spaces = match item {
        Item::Curve(curve) => vec![(&curve.space, &curve.interval)],
        Item::Patch(patch) => vec![patch_space(patch, 0), patch_space(patch, 1)],
    };
    let line = |whole: bool| {
        let parts = spaces.iter().map(|(space, interval)| {
            let length = short(interval[1].value() - interval[0].value());
            let name = if whole { "l' = " } else { "" };
            let critical = match studio.critical(space) {
                Some(critical) if critical.is_finite() => format!(" < {name}{critical:.4}"),
                Some(_) => String::new(),
                None => format!(" < {name}..."),
            };
            match whole {
                true => format!("{{{space}}} h = {length}{critical}"),
                false => format!("dim {}, h = {length}{critical}", space.dimension()),
            }
        });
        let exact = if edit::is_exact(item) { texts::EXACT.of(language) } else { "" };
        format!("{}: {}  {exact}", number + 1, parts.collect::<Vec<_>>().join(" x "))
    };
    Some(line(true)).filter(|line| line.chars().count() <= LETTERS).unwrap_or_else(|| line(false))
}

fn first_row(studio: &Studio, list: Option<usize>) -> usize {
    let chosen = list.or(studio.selected).unwrap_or(0);
    chosen.saturating_sub(ROWS - 1)
}

fn draw_list(studio: &Studio, list: Option<usize>, screen: &mut Screen) {
    let top = rows::below(Page::View);
    let first = first_row(studio, list);
    for (at, item) in studio.scene().items.iter().enumerate().skip(first).take(ROWS) {
        let y = top + 13 * i32::try_from(at - first).unwrap_or(0);
        let (name, size) = match item {
            Item::Curve(curve) => (curve.name.as_deref(), format!("{}", curve.points.len())),
            Item::Patch(patch) => (
                patch.name.as_deref(),
                format!("{}x{}", patch.space_u.dimension(), patch.space_v.dimension()),
            ),
        };
        let mark = match () {
            () if studio.selected == Some(at) => '>',
            () if paint::is_hidden(item) => '-',
            () => ' ',
        };
        let kind = if matches!(item, Item::Curve(_)) { "~" } else { "#" };
        let text = format!("{mark}{:<2}{kind}{size} {}", at + 1, name.unwrap_or_default());
        let text: String = text.chars().take(ROW_LETTERS).collect();
        if list == Some(at) {
            screen.bar(PANEL.x1 + 3, y - 2, PANEL.x2 - 3, y + 9, Color::White);
        }
        screen.text(PANEL.x1 + 5, y, &text, Color::Black);
    }
}

/// The item of the list under a pixel.
pub(super) fn row_at(studio: &Studio, (x, y): (i32, i32)) -> Option<usize> {
    if studio.page != Page::View || !(PANEL.x1..PANEL.x2).contains(&x) {
        return None;
    }
    let row = usize::try_from((y - rows::below(Page::View) + 2).checked_div(13)?).ok()?;
    let inside = y >= rows::below(Page::View) - 2 && row < ROWS;
    let at = first_row(studio, None) + row;
    (inside && at < studio.scene().items.len()).then_some(at)
}

/// The blending function of the chosen point, its height and its place.
fn draw_weight(studio: &Studio, screen: &mut Screen, language: Language) {
    let (Some(item), Some(index)) = (studio.item(), studio.point) else { return };
    let Some(shape) = studio.selected.and_then(|at| studio.shapes.of(at)) else { return };
    let mut y = rows::below(Page::Point) + 4;
    let functions: Vec<(String, Vec<f64>)> = match (item, shape) {
        (Item::Curve(_), Shape::Curve { arc, .. }) => {
            vec![(format!("b{}", index[0]), values(arc.basis(), index[0]))]
        }
        (Item::Patch(_), Shape::Patch { weave, .. }) => {
            let [u, v] = weave.bases();
            [(u, 0), (v, 1)]
                .map(|(basis, d): (_, usize)| {
                    (format!("b{} ({})", index[d], ["u", "v"][d]), values(basis, index[d]))
                })
                .into()
        }
        _ => return,
    };
    for (name, values) in functions {
        let highest = values.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((at, height)) = highest else { continue };
        let place = at as f64 / (values.len() - 1).max(1) as f64;
        let weight = match language {
            Language::Hungarian => "súly",
            Language::English => "weight",
        };
        screen.text(PANEL.x1 + 5, y, &format!("{weight} {name}:"), Color::Black);
        screen.text(PANEL.x1 + 5, y + 11, &format!("max {height:.4}"), Color::Black);
        screen.text(PANEL.x1 + 5, y + 22, &format!("s = {place:.3}"), Color::Black);
        let area = Area::new(PANEL.x1 + 30, y + 36, PANEL.x1 + 110, y + 80);
        window(screen, area);
        let pixel = |(k, value): (usize, &f64)| {
            let x = area.x1 + 6 + (68 * k / (values.len() - 1).max(1)) as i32;
            (x, area.y2 - 4 - (36.0 * value.clamp(0.0, 1.0)) as i32)
        };
        let line: Vec<(i32, i32)> = values.iter().enumerate().map(pixel).collect();
        screen.polyline(&line, Stroke::thin(Color::Yellow));
        y += 92;
    }
}

fn values(basis: &(impl Basis + ?Sized), function: usize) -> Vec<f64> {
    let mut values = Vec::new();
    let value = |k: u32| {
        basis.values(0, f64::from(k) / 100.0, &mut values);
        values.get(function).copied().unwrap_or(0.0)
    };
    (0..=100).map(value).collect()
}

/// The scene as a figure for other programs: curves exactly, patches by the lines that nothing hides.
pub(super) fn figure(studio: &Studio) -> Option<Figure> {
    let scene = studio.scene();
    let view = studio.eye.view;
    let mut figure = Figure::new();
    let (mut hidden, mut wires): (Vec<Grid>, Vec<Grid>) = (Vec::new(), Vec::new());
    let show = studio.show();
    let seen = || scene.items.iter().enumerate().filter(|(_, item)| !paint::is_hidden(item));
    for (at, item) in seen() {
        if let (Item::Patch(patch), Some(Shape::Patch { grid, .. })) = (item, studio.shapes.of(at)) {
            let fill = show.fill.unwrap_or(patch.style.fill);
            if fill == Fill::Wires { &mut wires } else { &mut hidden }.push(grid.clone());
        }
    }
    figure.plot_surfaces(&hidden, &view, Hidden::LeftOut);
    figure.plot_surfaces(&wires, &view, Hidden::Drawn);
    for (at, item) in seen() {
        if let (Item::Curve(curve), Some(Shape::Curve { arc, .. })) = (item, studio.shapes.of(at)) {
            let ink = match Color::from_index(curve.style.colour) {
                Color::White => crate::figure::CURVE_INK,
                color => print_ink(color),
            };
            figure.plot_space_curve(arc, &view, ink).ok()?;
        }
        if show.selected == Some(at) {
            let points: Vec<(Index, _)> = edit::control_points(item);
            if let (Item::Curve(curve), true) = (item, show.handles) {
                let line = curve.points.iter().map(|&point| view.place(point)).collect();
                figure.plot_polygon(line, Closure::Open);
            }
            for (index, point) in points {
                let label = match item {
                    Item::Curve(_) => index[0].to_string(),
                    Item::Patch(_) => format!("{},{}", index[0], index[1]),
                };
                figure.plot_point(view.place(point), Some(label));
            }
        }
    }
    Some(figure)
}
