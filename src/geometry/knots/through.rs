//! What all ways through a given point have in common.

use super::{KnotCurve, KnotError, KnotVector, Unreached};
use crate::geometry::point::check_points;
use crate::geometry::{Point, norm};

/// A curve with other knots (or weights) that runs through the point asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Through<const D: usize> {
    /// The curve.
    pub curve: KnotCurve<D>,
    /// The parameter of the point on it.
    pub u: f64,
}

impl<const D: usize> Through<D> {
    /// How far the curve misses a point.
    #[must_use]
    pub fn miss(&self, point: Point<D>) -> f64 {
        let found = self.curve.point_at(self.u);
        found.map_or(f64::INFINITY, |found| norm::<D>(std::array::from_fn(|d| found[d] - point[d])))
    }

    /// How far the knots have moved from those of `before`: the sum of the squares of `moved / mean span`, by which
    /// solutions are compared.
    #[must_use]
    pub fn effort(&self, before: &KnotVector) -> f64 {
        let [from, to] = before.domain();
        let mean = (to - from) / before.filled_spans().len() as f64;
        let moves = self.curve.vector().knots().iter().zip(before.knots());
        moves.map(|(new, old)| ((new - old) / mean).powi(2)).sum()
    }
}

/// The checks on a plane cubic without weights, and on the point.
pub(super) fn check_cubic(curve: &KnotCurve<2>, point: Point<2>) -> Result<(), KnotError> {
    check_points(&[point])?;
    let given = curve.vector().order();
    if given != 4 {
        return Err(KnotError::OrderNeeded { given, least: 4, most: 4 });
    }
    if curve.weights().is_some() {
        return Err(KnotError::Rational);
    }
    if curve.vector().breaks().is_some() {
        return Err(KnotError::Closed);
    }
    Ok(())
}

/// The check that a new knot stays in its room, which rounding may exceed.
pub(super) fn within(knot: usize, value: f64, range: [f64; 2]) -> Result<f64, KnotError> {
    let slack = 1e-12 * (range[1] - range[0]).abs();
    if value >= range[0] - slack && value <= range[1] + slack {
        return Ok(value.clamp(range[0], range[1].max(range[0])));
    }
    Err(Unreached::Knot { knot, value, range }.into())
}

/// The solution of `x a + y b = c` in the plane; `None` for parallel vectors.
pub(super) fn solved(a: Point<2>, b: Point<2>, c: Point<2>) -> Option<[f64; 2]> {
    let det = a[0] * b[1] - a[1] * b[0];
    if det.abs() <= 1e-14 * norm(a) * norm(b) {
        return None;
    }
    let found = [(c[0] * b[1] - c[1] * b[0]) / det, (a[0] * c[1] - a[1] * c[0]) / det];
    found.iter().all(|x| x.is_finite()).then_some(found)
}
