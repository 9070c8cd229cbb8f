//! Two knots moved against each other (Juhász 2001).

use super::{KnotCurve, KnotError};
use crate::geometry::Point;

/// The path of a point while `u_i` grows by `t` and `u_{i+2k-3}` falls by it.
#[derive(Clone, Debug)]
pub struct Opposed<'a, const D: usize> {
    curve: &'a KnotCurve<D>,
    knot: usize,
    u: f64,
}

impl<const D: usize> KnotCurve<D> {
    /// The path of the point at `u` in span `knot + k - 2`.
    ///
    /// # Errors
    /// [`KnotError::Index`] for a knot without partner, [`KnotError::Outside`] for `u` in another span,
    /// [`KnotError::Closed`].
    pub fn opposed(&self, knot: usize, u: f64) -> Result<Opposed<'_, D>, KnotError> {
        let (vector, order) = (self.vector(), self.vector().order());
        if vector.breaks().is_some() {
            return Err(KnotError::Closed);
        }
        let last = (vector.knots().len() + 1).saturating_sub(2 * order);
        if knot == 0 || knot > last {
            return Err(KnotError::Index { name: "knot", given: knot, first: 1, last });
        }
        vector.check_inside("u", knot + order - 2, u)?;
        Ok(Opposed { curve: self, knot, u })
    }
}

impl<const D: usize> Opposed<'_, D> {
    fn partner(&self) -> usize {
        self.knot + 2 * self.curve.vector().order() - 3
    }

    /// Whether the path is straight: the two knots must be equally far from the ends of the span's row of knots,
    /// `u_{i+k-1} - u_i = u_{i+2k-3} - u_{i+k-2}`. Otherwise it is rational of order 3.
    #[must_use]
    pub fn straight(&self) -> bool {
        let (knots, order) = (self.curve.vector().knots(), self.curve.vector().order());
        let (a, b) = (self.knot, self.partner());
        let left = knots[a + order - 1] - knots[a];
        let right = knots[b] - knots[a + order - 2];
        (left - right).abs() <= 1e-12 * (knots[b] - knots[a]).max(knots[b].abs() * 1e-3)
    }

    /// The control point that all straight paths of curves of order 3 run through, from 0.
    #[must_use]
    pub fn pencil(&self) -> Option<usize> {
        (self.curve.vector().order() == 3 && self.straight()).then_some(self.knot)
    }

    /// The values of `t` for which all knots stay in order.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        let (knots, a, b) = (self.curve.vector().knots(), self.knot, self.partner());
        let end = |i: usize, other: f64| knots.get(i).copied().unwrap_or(other);
        [
            (knots[a - 1] - knots[a]).max(knots[b] - end(b + 1, f64::INFINITY)),
            (knots[a + 1] - knots[a]).min(knots[b] - knots[b - 1]),
        ]
    }

    /// The point for a `t`. `None` where knots coincide.
    #[must_use]
    pub fn at(&self, t: f64) -> Option<Point<D>> {
        let mut knots = self.curve.vector().knots().to_vec();
        knots[self.knot] += t;
        *knots.get_mut(self.partner())? -= t;
        self.curve.homogeneous_in(&knots, self.knot + self.curve.vector().order() - 2, self.u)?.point()
    }
}
