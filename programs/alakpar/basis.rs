//! The key F7: the blending functions in a window at the lower right.

use super::form::Form;
use super::texts;
use crate::geometry::shaped::{Family, ShapedCurve};
use crate::geometry::{Basis, ParamCurve};
use crate::machine::Language;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::Area;

/// The window, and the part of it where the lines are.
const WINDOW: Area = Area::new(430, 356, 630, 459);
const PLOT: Area = Area::new(440, 372, 622, 452);
/// Steps along the window.
const STEPS: usize = 90;
/// The colours of the functions, in turn.
const INKS: [Color; 6] =
    [Color::LightRed, Color::Yellow, Color::LightGreen, Color::LightCyan, Color::LightMagenta, Color::White];

/// Whether a pixel is on the window.
pub(super) fn holds((x, y): (i32, i32)) -> bool {
    WINDOW.holds(x, y)
}

/// The functions of a curve: all over the whole of a curve of one formula, those of an arc of a spline. Values are at
/// equal steps of the parameter.
pub(super) fn functions<const D: usize>(curve: &ShapedCurve<D>, span: usize) -> Vec<Vec<f64>> {
    let basis = curve.basis();
    let whole = matches!(basis.family(), Family::Cyclic);
    let spans = if whole { basis.spans() } else { 1 };
    let mut rows: Vec<Vec<f64>> = Vec::new();
    let mut weights = Vec::new();
    for step in 0..=STEPS {
        let along = step as f64 / STEPS as f64 * spans as f64;
        let here = (along as usize).min(spans - 1);
        let at = if whole { here } else { span };
        if basis.weights(at, along - here as f64, &mut weights).is_none() {
            return Vec::new();
        }
        rows.resize(weights.len(), Vec::new());
        for (row, weight) in rows.iter_mut().zip(&weights) {
            row.push(weight[0]);
        }
    }
    rows
}

/// Draws the window.
pub(super) fn draw<const D: usize>(
    form: &Form<D>,
    curve: &ShapedCurve<D>,
    span: usize,
    screen: &mut Screen,
    language: Language,
) {
    let Area { x1, y1, x2, y2 } = WINDOW;
    screen.bar(x1, y1, x2, y2, Color::Black);
    screen.rectangle(x1, y1, x2, y2, Stroke::thin(Color::LightGray));
    let spline = curve.spans() > 1 && form.family() != crate::file::FamilyName::Cyclic;
    let title = texts::functions(spline.then_some(span + 1));
    screen.text(x1 + 8, y1 + 5, title.of(language), Color::LightGray);
    let rows = functions(curve, span);
    let most = rows.iter().flatten().copied().fold(1e-9, f64::max);
    let least = rows.iter().flatten().copied().fold(0.0, f64::min);
    let (wide, high) = (f64::from(PLOT.x2 - PLOT.x1), f64::from(PLOT.y2 - PLOT.y1));
    let y = |value: f64| PLOT.y2 - ((value - least) / (most - least) * high).round() as i32;
    screen.line(PLOT.x1, y(0.0), PLOT.x2, y(0.0), Stroke::thin(Color::DarkGray));
    for (row, ink) in rows.iter().zip(INKS.into_iter().cycle()) {
        let pixel = |(step, value): (usize, &f64)| {
            (PLOT.x1 + (wide * step as f64 / STEPS as f64).round() as i32, y(*value))
        };
        let pixels: Vec<(i32, i32)> = row.iter().enumerate().map(pixel).collect();
        screen.polyline(&pixels, Stroke::thin(ink));
    }
}
