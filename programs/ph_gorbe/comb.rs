//! The comb of curvature with its extrema and inflections, the circle of curvature, and the cusps of offsets.

use super::analysis::Analysis;
use super::plane::Options;
use crate::editor::curve::layer::{Canvas, Map, Trace};
use crate::geometry::ph::{PhCurve, Place};
use crate::geometry::{ParamCurve, Point};
use crate::screen::{Color, Screen, Stroke};

/// Pixels of the curve between two teeth.
const APART: f64 = 7.0;
/// Teeth at most.
const MOST: usize = 1500;
/// The longest tooth in pixels.
const LONGEST: f64 = 400.0;
/// The largest radius of a circle that is drawn, in pixels.
const LARGEST: f64 = 3000.0;

/// The teeth, on the outer side of the bend, and the line over their tips.
pub(super) fn traces(curve: &PhCurve, scale: f64) -> Vec<Trace<2>> {
    let length = curve.total_length();
    let steps = ((length / APART).round().clamp(8.0, MOST as f64)) as usize;
    let places = curve.equal_lengths(steps).unwrap_or_default();
    let tooth = |place: Place| -> Option<[Point<2>; 2]> {
        let at = curve.eval(place.span, place.u)?;
        let (normal, curvature) = (curve.normal(place)?, curve.curvature(place)?);
        let long = (-curvature * scale).clamp(-LONGEST, LONGEST);
        Some([at, [at[0] + long * normal[0], at[1] + long * normal[1]]])
    };
    let teeth: Vec<[Point<2>; 2]> = places.into_iter().filter_map(tooth).collect();
    let tips = teeth.windows(2).map(|pair| [pair[0][1], pair[1][1]]);
    let lines = teeth.iter().copied().map(|ends| (ends, Color::Green));
    lines
        .chain(tips.map(|ends| (ends, Color::LightGreen)))
        .map(|(ends, ink)| Trace::Line { ends, ink })
        .collect()
}

/// Cusps of the offsets as crosses; with the comb, extrema as triangles with their radius, inflections as dots.
pub(super) fn draw_marks(analysis: &Analysis, options: &Options, map: Map<'_, 2>, canvas: &mut Canvas<'_>) {
    let screen = &mut *canvas.screen;
    for side in &analysis.sides {
        for cusp in side.offset.cusps() {
            if let Some(at) = side.offset.eval(cusp.span, cusp.u) {
                cross(screen, map(at));
            }
        }
    }
    if options.comb.is_none() {
        return;
    }
    let curve = &analysis.curve;
    for extremum in curve.curvature_extrema() {
        let Some(at) = curve.eval(extremum.place.span, extremum.place.u) else { continue };
        let (x, y) = map(at);
        screen.polygon(
            &[(x - 4, y + 4), (x + 4, y + 4), (x, y - 4)],
            Color::LightGreen,
            Stroke::thin(Color::Black),
        );
        if let Some(radius) = analysis.radius(extremum.place) {
            label(screen, (x + 8, y - 12), &format!("r {radius:.1}"), Color::LightGreen);
        }
    }
    for inflection in curve.inflections() {
        if let Some((x, y)) = curve.eval(inflection.span, inflection.u).map(map) {
            screen.disc(x, y, 3, Color::LightCyan, Color::Black);
        }
    }
}

/// The circle of curvature at a place.
pub(super) fn draw_circle(
    analysis: &Analysis,
    place: Place,
    options: &Options,
    map: Map<'_, 2>,
    canvas: &mut Canvas<'_>,
) {
    let Some(at) = analysis.curve.eval(place.span, place.u) else { return };
    let (x, y) = map(at);
    canvas.screen.circle(x, y, 4, Stroke::thick(Color::LightCyan));
    let round = analysis.curve.normal(place).zip(analysis.radius(place)).filter(|_| options.comb.is_some());
    let Some((normal, radius)) = round.filter(|(_, radius)| radius.abs() <= LARGEST) else { return };
    let (x, y) = map([at[0] + radius * normal[0], at[1] + radius * normal[1]]);
    canvas.screen.circle(x, y, (radius.abs().round() as i32).max(1), Stroke::thin(Color::LightCyan));
    let (x, y) = map(at);
    label(canvas.screen, (x + 8, y + 6), &format!("r {radius:.2}"), Color::LightCyan);
}

/// A cross at a cusp.
fn cross(screen: &mut Screen, (x, y): (i32, i32)) {
    for (dx, dy) in [(4, 4), (4, -4)] {
        screen.line(x - dx, y - dy, x + dx, y + dy, Stroke::thick(Color::LightRed));
    }
}

/// A text on black, kept in the field.
pub(super) fn label(screen: &mut Screen, (x, y): (i32, i32), text: &str, ink: Color) {
    let width = 8 * i32::try_from(text.chars().count()).unwrap_or(0);
    let (x, y) = (x.clamp(31, (630 - width).max(31)), y.clamp(60, 450));
    screen.bar(x - 1, y - 1, x + width, y + 8, Color::Black);
    screen.text(x, y, text, ink);
}
