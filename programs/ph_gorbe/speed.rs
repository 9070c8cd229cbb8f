//! The strip of the speed over the bottom of the field: how evenly the parameter runs along the curve.

use super::analysis::STEPS;
use super::texts;
use crate::design::Sketch;
use crate::editor::curve::layer::Canvas;
use crate::file::Method;
use crate::geometry::ParamCurve;
use crate::geometry::ph::{PhCurve, Place};
use crate::screen::{Color, Stroke};
use crate::ui::Area;

/// The strip, and the part of it where the lines are.
const STRIP: Area = Area::new(29, 386, 633, 462);
const PLOT: Area = Area::new(41, 401, 601, 459);

/// Whether a pixel is on the strip.
pub(super) fn holds((x, y): (i32, i32)) -> bool {
    STRIP.holds(x, y)
}

/// The place of the curve over a pixel of the strip.
pub(super) fn place_at(curve: &PhCurve, (x, _): (i32, i32)) -> Option<Place> {
    let part = f64::from(x - PLOT.x1) / f64::from(PLOT.x2 - PLOT.x1);
    curve.place_at_length(part.clamp(0.0, 1.0) * curve.total_length())
}

/// The speed by a parameter that runs on evenly over the spans, against the share of the length.
fn of_ph(curve: &PhCurve) -> Vec<[f64; 2]> {
    let length = curve.total_length();
    let places = (0..curve.spans())
        .flat_map(|span| (0..=STEPS).map(move |k| Place { span, u: k as f64 / STEPS as f64 }));
    let row = |place: Place| {
        let step = curve.segments().get(place.span)?.step();
        Some([curve.length_at(place)? / length, curve.speed(place)? / step])
    };
    places.filter_map(row).collect()
}

/// The same of any curve, its length summed up by chords.
fn of_other(curve: &dyn ParamCurve<2>) -> Vec<[f64; 2]> {
    let mut rows: Vec<[f64; 2]> = Vec::new();
    let (mut along, mut last) = (0.0, None);
    for span in 0..curve.spans() {
        for k in 0..=STEPS {
            let Some([at, slope, _]) = curve.at(span, k as f64 / STEPS as f64) else { continue };
            along += last.map_or(0.0, |[x, y]: [f64; 2]| (at[0] - x).hypot(at[1] - y));
            last = Some(at);
            rows.push([along, slope[0].hypot(slope[1])]);
        }
    }
    let length = if along > 0.0 { along } else { 1.0 };
    rows.into_iter().map(|[s, speed]| [s / length, speed]).collect()
}

/// Draws the strip, with the ordinary cubic spline behind, and what is known at a place.
pub(super) fn draw(
    analysis: &super::analysis::Analysis,
    sketch: &Sketch<2>,
    at: Option<Place>,
    canvas: &mut Canvas<'_>,
) {
    let Canvas { screen, language } = canvas;
    let curve = &analysis.curve;
    let own = of_ph(curve);
    let usual = Sketch { tangents: None, ..sketch.by(Method::Spline) }.curve();
    let usual = usual.map(|curve| of_other(&*curve)).unwrap_or_default();
    let most = own.iter().chain(&usual).map(|row| row[1]).filter(|it| it.is_finite()).fold(1e-9, f64::max);
    let [wide, high] = [PLOT.x2 - PLOT.x1, PLOT.y2 - PLOT.y1].map(f64::from);
    let pixel = |row: &[f64; 2]| {
        let part = |it: f64| if it.is_finite() { it.clamp(0.0, 1.0) } else { 0.0 };
        let (x, y) = (part(row[0]) * wide, part(row[1] / most) * high);
        (PLOT.x1 + x.round() as i32, PLOT.y2 - y.round() as i32)
    };
    screen.bar(STRIP.x1, STRIP.y1, STRIP.x2, STRIP.y2, Color::Black);
    screen.line(STRIP.x1, STRIP.y1, STRIP.x2, STRIP.y1, Stroke::thin(Color::LightGray));
    screen.line(PLOT.x1, PLOT.y2, PLOT.x2, PLOT.y2, Stroke::thin(Color::DarkGray));
    for (rows, stroke) in [(&usual, Stroke::thin(Color::LightGray)), (&own, Stroke::thick(Color::White))] {
        let pixels: Vec<(i32, i32)> = rows.iter().map(pixel).collect();
        screen.polyline(&pixels, stroke);
    }
    let facts = at.and_then(|place| {
        let s = curve.length_at(place)?;
        let x = PLOT.x1 + (wide * (s / curve.total_length()).clamp(0.0, 1.0)).round() as i32;
        screen.line(x, STRIP.y1 + 14, x, PLOT.y2, Stroke::thin(Color::LightCyan));
        Some(texts::at_place(place, s, curve.speed(place)?, curve.curvature(place)))
    });
    match facts {
        Some(facts) => screen.text(PLOT.x1, STRIP.y1 + 4, facts.of(*language), Color::LightCyan),
        None => screen.text(PLOT.x1, STRIP.y1 + 4, texts::SPEED_LEGEND.of(*language), Color::LightGray),
    }
}
