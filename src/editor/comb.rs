//! The comb of curvature: how a curve bends, tooth by tooth.

use super::seen::Item;
use crate::geometry::{ParamCurve, Point, curvature_vector, dot};
use crate::screen::Color;

/// Pixels between two teeth of the comb, teeth at most, and the longest of them in pixels.
const APART: f64 = 7.0;
const TEETH: f64 = 600.0;
const LONGEST: f64 = 400.0;

/// The length of a curve as it is drawn.
pub(crate) fn length<const D: usize>(curve: &dyn ParamCurve<D>) -> f64 {
    let steps = if curve.spans() < 4 { 200 } else { 50 };
    let line = curve.polyline(steps).unwrap_or_default();
    let side =
        |pair: &[Point<D>]| pair[0].iter().zip(pair[1]).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    line.windows(2).map(side).sum()
}

/// The comb of curvature, on the outer side of the bend, and the line over its tips.
pub(crate) fn add_comb<const D: usize>(curve: &dyn ParamCurve<D>, scale: f64, items: &mut Vec<Item<D>>) {
    let teeth = (length(curve) / APART).clamp(8.0, TEETH);
    let per_span = (teeth / curve.spans().max(1) as f64).ceil().max(2.0) as usize;
    let teeth: Vec<[Point<D>; 2]> = (0..curve.spans())
        .flat_map(|span| (0..=per_span).map(move |k| (span, k as f64 / per_span as f64)))
        .filter_map(|(span, u)| tooth(curve, span, u, scale))
        .collect();
    let tips = teeth.windows(2).map(|pair| ([pair[0][1], pair[1][1]], Color::LightGreen));
    let lines = teeth.iter().map(|ends| (*ends, Color::Green));
    items.extend(lines.chain(tips).map(|(ends, ink)| Item::Line { ends, ink }));
}

/// A point of the curve, and the tip of its tooth.
fn tooth<const D: usize>(
    curve: &dyn ParamCurve<D>,
    span: usize,
    u: f64,
    scale: f64,
) -> Option<[Point<D>; 2]> {
    let [at, slope, bend] = curve.at(span, u)?;
    let curvature = curvature_vector(slope, bend);
    let size = dot(curvature, curvature).sqrt();
    let long = (scale * size).min(LONGEST);
    if !size.is_finite() || !long.is_finite() {
        return None;
    }
    let outward = if size > 0.0 { long / size } else { 0.0 };
    Some([at, std::array::from_fn(|d| at[d] - outward * curvature[d])])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_comb_of_a_circle_is_a_circle() {
        let circle = crate::geometry::Fourier::new(
            [0.0; 2],
            &[[0.5, 0.0].map(|phase| crate::geometry::Wave { amplitude: 100.0, phase })],
        );
        let mut items = Vec::new();
        add_comb(&circle.expect("it is one"), 2000.0, &mut items);
        for item in &items {
            if let Item::Line { ends: [_, tip], ink: Color::Green } = item {
                assert!((tip[0].hypot(tip[1]) - 120.0).abs() < 1e-9);
            }
        }
    }
}
