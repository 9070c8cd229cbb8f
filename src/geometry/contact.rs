//! How smoothly the spans of a curve meet: the orders of continuity of chapter 2.1.

use super::point::{curvature_vector, norm};
use super::{ParamCurve, Point};
use std::fmt;

/// How two spans meet in a joint. Orders beyond the second, which no eye sees, are not told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpanContact {
    /// The order of the derivatives by the parameter that agree: C0, C1 or C2; `None` where the spans do not meet.
    pub parametric: Option<u8>,
    /// The order that the curve itself has, whatever its parameter: 1 for one tangent, 2 for one curvature as well;
    /// `None` where the spans do not meet.
    pub geometric: Option<u8>,
}

impl fmt::Display for SpanContact {
    /// `C2`, `C1 G2`, `G1`, or a dash for spans that do not meet.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.parametric, self.geometric) {
            (Some(c), Some(g)) if g <= c => write!(f, "C{c}"),
            (Some(0), Some(g)) => write!(f, "G{g}"),
            (Some(c), Some(g)) => write!(f, "C{c} G{g}"),
            _ => f.write_str("-"),
        }
    }
}

/// Relative differences up to this count as none: what rounding of the points' last digits leaves.
const NONE: f64 = 1e-7;

/// What is shorter than this part of the curve's size has no direction of its own.
const FLAT: f64 = 1e-3;

/// How the span before a joint meets the one behind it; joint `i` is where span `i` begins. `None` at the ends of an
/// open curve and outside.
///
/// The derivatives are compared relative to their size, within 1e-7.
pub fn contact<const D: usize>(curve: &dyn ParamCurve<D>, joint: usize) -> Option<SpanContact> {
    let before = match joint {
        0 if curve.closed() => curve.spans().checked_sub(1)?,
        _ => joint.checked_sub(1)?,
    };
    let [from, to] = [curve.at(before, 1.0)?, curve.at(joint, 0.0)?];
    let size = curve.bounding_box().map_or(0.0, |bounds| bounds.extent());
    let near = |a: Point<D>, b: Point<D>, least: f64| {
        let difference: Point<D> = std::array::from_fn(|d| a[d] - b[d]);
        norm(difference) <= NONE * norm(a).max(norm(b)).max(least)
    };
    if !near(from[0], to[0], size) {
        return Some(SpanContact { parametric: None, geometric: None });
    }
    let [first, second] = [1, 2].map(|order| near(from[order], to[order], FLAT * size));
    let parametric = match (first, second) {
        (true, true) => 2,
        (true, false) => 1,
        (false, _) => 0,
    };
    let shape = |[_, slope, bend]: [Point<D>; 3]| {
        let speed = norm(slope);
        let tangent: Point<D> = slope.map(|x| x / speed);
        // Without a speed there is no direction.
        (speed > NONE * size).then(|| (tangent, curvature_vector(slope, bend)))
    };
    let geometric = match (shape(from), shape(to)) {
        (Some((tangent, curvature)), Some((other, bend))) => {
            match (near(tangent, other, 1.0), near(curvature, bend, FLAT / size.max(f64::MIN_POSITIVE))) {
                (true, true) => 2,
                (true, false) => 1,
                (false, _) => 0,
            }
        }
        _ => 0,
    };
    Some(SpanContact { parametric: Some(parametric), geometric: Some(geometric) })
}
