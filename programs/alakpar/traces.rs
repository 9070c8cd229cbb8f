//! What a parameter does to the curve: paths and series.

use super::form::Form;
use super::kinds::Knob;
use super::points::steps;
use crate::editor::seen::Item;
use crate::geometry::{Closure, ParamCurve, Point};
use crate::screen::{Color, Stroke};

/// Points of the curve whose paths are shown.
const PATHS: usize = 9;
/// Steps of a path that is not straight.
const PATH_STEPS: usize = 64;
/// Ticks of a path at most; where whole values are more, every second, fifth, tenth has one.
const TICKS: f64 = 12.0;
/// Curves of a series.
const SERIES: usize = 11;
/// The colours of a series, from the smallest value to the largest.
const SHADES: [Color; SERIES] = [
    Color::Blue,
    Color::LightBlue,
    Color::Cyan,
    Color::LightCyan,
    Color::Green,
    Color::LightGreen,
    Color::Yellow,
    Color::Brown,
    Color::LightRed,
    Color::Magenta,
    Color::LightMagenta,
];
/// A line through points, as a curve.
#[derive(Debug)]
struct Line<const D: usize>(Vec<Point<D>>);

impl<const D: usize> ParamCurve<D> for Line<D> {
    fn spans(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    fn closed(&self) -> bool {
        false
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        let (from, to) = (self.0.get(span)?, self.0.get(span + 1)?);
        let u = u.clamp(0.0, 1.0);
        let along: Point<D> = std::array::from_fn(|d| to[d] - from[d]);
        Some([std::array::from_fn(|d| from[d] + u * along[d]), along, [0.0; D]])
    }
}

/// The paths of points of a curve, with the places where the parameter has whole values.
#[derive(Debug)]
pub(super) struct Paths<const D: usize> {
    pub(super) lines: Vec<Vec<Point<D>>>,
    pub(super) ticks: Vec<Point<D>>,
}

/// Whole values of a range, or every second, fifth, tenth of them.
fn whole([low, high]: [f64; 2]) -> Vec<f64> {
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().find(|step| (high - low) / step <= TICKS).unwrap_or(100.0);
    let first = (low / step).ceil() as i64;
    let last = (high / step).floor() as i64;
    (first..=last).map(|k| k as f64 * step).collect()
}

/// The paths of nine points while a parameter takes the values of its range.
pub(super) fn paths<const D: usize>(form: &Form<D>, knob: &Knob) -> Paths<D> {
    let [low, high] = knob.range;
    let values: Vec<f64> =
        (0..=PATH_STEPS).map(|k| low + (high - low) * k as f64 / PATH_STEPS as f64).collect();
    let mut all = Paths { lines: vec![Vec::new(); PATHS], ticks: Vec::new() };
    for value in values {
        for (line, point) in all.lines.iter_mut().zip(places(form, knob, value)) {
            line.push(point);
        }
    }
    all.ticks = whole(knob.range).into_iter().flat_map(|value| places(form, knob, value)).collect();
    all
}

/// The nine points for a value of the parameter. The ends of an open curve of one span, which stay, are none of them.
fn places<const D: usize>(form: &Form<D>, knob: &Knob, value: f64) -> Vec<Point<D>> {
    let curve = form.with(knob.parameter, value).and_then(|form| form.curve());
    let Ok(curve) = curve else { return Vec::new() };
    let spans = curve.spans();
    let part = |k: usize| match (form.closure(), spans) {
        (Closure::Closed, _) => k as f64 / PATHS as f64,
        (Closure::Open, 1) => (k + 1) as f64 / (PATHS + 1) as f64,
        (Closure::Open, _) => k as f64 / (PATHS - 1) as f64,
    };
    let place = |k: usize| {
        let along = part(k) * spans as f64;
        let span = (along as usize).min(spans.saturating_sub(1));
        curve.eval(span, along - span as f64)
    };
    (0..PATHS).filter_map(place).collect()
}

/// The paths as items.
pub(super) fn add_paths<const D: usize>(paths: &Paths<D>, items: &mut Vec<Item<D>>) {
    for line in paths.lines.iter().filter(|line| line.len() > 1) {
        let curve = Box::new(Line(line.clone()));
        items.push(Item::Curve { curve, steps: 1, stroke: Stroke::thin(Color::LightGreen), name: None });
    }
}

/// Curves over the range of a parameter.
pub(super) fn add_series<const D: usize>(form: &Form<D>, knob: &Knob, items: &mut Vec<Item<D>>) {
    let [low, high] = knob.range;
    for (k, shade) in SHADES.into_iter().enumerate() {
        let value = if k + 1 == SERIES { high } else { low + (high - low) * k as f64 / (SERIES - 1) as f64 };
        if let Ok(curve) = form.with(knob.parameter, value).and_then(|form| form.curve()) {
            let steps = steps(curve.spans());
            items.push(Item::Curve {
                curve: Box::new(curve),
                steps,
                stroke: Stroke::thin(shade),
                name: None,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_at_whole_values_and_not_too_many() {
        assert_eq!(whole([0.01, 3.2]), [1.0, 2.0, 3.0]);
        assert_eq!(whole([-25.0, 9.87]), [-25.0, -20.0, -15.0, -10.0, -5.0, 0.0, 5.0]);
        assert_eq!(whole([-1.0, 2.0]), [-1.0, 0.0, 1.0, 2.0]);
    }
}
