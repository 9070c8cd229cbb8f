//! The path of a point of the curve while one knot moves (2.3 to 2.5).

use super::local::Hom;
use super::{KnotCurve, KnotError};
use crate::geometry::Point;

/// The path of the point at `u` of one arc while knot `u_i` moves: a rational curve in the value of the knot, of
/// order `k - m` on the m-th span to the left or right of the knot (theorem 2.4). The arc's formula is used for every
/// value, also where the knot has left its neighbours ("extended path").
#[derive(Clone, Debug)]
pub struct KnotPath<'a, const D: usize> {
    curve: &'a KnotCurve<D>,
    knot: usize,
    copies: usize,
    span: usize,
    u: f64,
}

/// A path that is straight (corollary 2.5): it is parallel to a side of the polygon, or, with different weights, runs
/// through a fixed point of that side's line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Straight<const D: usize> {
    /// The control points at the ends of the side, from 0.
    pub side: [usize; 2],
    /// Where all such paths meet, `(w_a d_a - w_b d_b) / (w_a - w_b)`; `None` where they are parallel.
    pub centre: Option<Point<D>>,
}

impl<const D: usize> KnotCurve<D> {
    /// The path of the point at `u` of arc `span` while a knot moves. The arcs beside the knot go on as far as it may
    /// move: `span == knot` is for its values below `u`, `span + 1 == knot` for those above; both meet in the envelope.
    ///
    /// # Errors
    /// A span, knot or `u` that does not exist, [`KnotError::Idle`] for a knot that the arc does not depend on,
    /// [`KnotError::Closed`] for a closed curve of less than `2 k - 2` control points.
    pub fn path(&self, knot: usize, span: usize, u: f64) -> Result<KnotPath<'_, D>, KnotError> {
        self.path_of_copies(knot, 1, span, u)
    }

    /// The path of the point at `u` of arc `span` while equal copies of a knot, `knot` the first of them, move together.
    ///
    /// # Errors
    /// As [`KnotCurve::path`]; [`KnotError::Index`] for copies that are not there.
    pub fn path_of_copies(
        &self,
        knot: usize,
        copies: usize,
        span: usize,
        u: f64,
    ) -> Result<KnotPath<'_, D>, KnotError> {
        let (vector, order) = (self.vector(), self.vector().order());
        let (start, there) = vector.copies(knot)?;
        if !(1..=start + there - knot).contains(&copies) {
            let last = start + there - knot;
            return Err(KnotError::Index { name: "multiplicity", given: copies, first: 1, last });
        }
        let (first, last) = (order - 1, vector.controls() - 1);
        if !(first..=last).contains(&span) {
            return Err(KnotError::Index { name: "span", given: span, first, last });
        }
        if vector.breaks().is_some() && self.points().len() < 2 * order - 2 {
            return Err(KnotError::Closed);
        }
        let end = knot + copies - 1;
        if knot >= span + order || end + order < span + 2 {
            return Err(KnotError::Idle { knot });
        }
        // A span beside the knot reaches as far as the knot may move.
        let knots = vector.knots();
        let from = if span == end { knots[knot.saturating_sub(1)] } else { knots[span] };
        let to = if span + 1 == knot { knots[(end + 1).min(knots.len() - 1)] } else { knots[span + 1] };
        if from >= to {
            return Err(KnotError::EmptySpan { span });
        }
        if !(u >= from && u <= to) {
            return Err(KnotError::Outside { name: "u", value: u, range: [from, to] });
        }
        Ok(KnotPath { curve: self, knot, copies, span, u })
    }

    /// The arcs that change with a knot and have a length, as spans.
    #[must_use]
    pub fn changed_spans(&self, knot: usize) -> Vec<usize> {
        let order = self.vector().order();
        let near = |j: &&usize| knot < **j + order && **j + 2 <= knot + order;
        self.vector().filled_spans().iter().filter(near).copied().collect()
    }

    /// Between which values a knot may move: from the knot before to the knot after. `None` for the first and last.
    #[must_use]
    pub fn room(&self, knot: usize) -> Option<[f64; 2]> {
        let knots = self.vector().knots();
        Some([*knots.get(knot.checked_sub(1)?)?, *knots.get(knot + 1)?])
    }
}

impl<const D: usize> KnotPath<'_, D> {
    /// The number of the span, counted away from the knot: 1 for its neighbours.
    #[must_use]
    pub fn side(&self) -> usize {
        if self.span < self.knot { self.knot - self.span } else { self.span + 2 - self.knot - self.copies }
    }

    /// The order `k - m` of theorem 2.4: the degree of the rational functions of a single knot; 1 is straight.
    #[must_use]
    pub fn order(&self) -> usize {
        self.curve.vector().order() - self.side()
    }

    /// The side of the polygon that a straight path is parallel to; `None` for a path that is not straight.
    #[must_use]
    pub fn straight(&self) -> Option<Straight<D>> {
        let order = self.curve.vector().order();
        if self.copies != 1 || self.side() + 1 != order {
            return None;
        }
        let first = if self.span < self.knot { self.span - 1 } else { self.span + 1 - order };
        let [a, b] = [first, first + 1].map(|i| self.curve.homogeneous(i));
        let centre = a.mixed(1.0, -1.0, b);
        let side = [first, first + 1].map(|i| self.curve.vector().point_index(i));
        Some(Straight { side, centre: if centre.w == 0.0 { None } else { centre.point() } })
    }

    /// The point for a value of the knot, by the formula of this arc. `None` where that has no value.
    #[must_use]
    pub fn at(&self, value: f64) -> Option<Point<D>> {
        self.homogeneous(value)?.point()
    }

    fn homogeneous(&self, value: f64) -> Option<Hom<D>> {
        let mut knots = self.curve.vector().knots().to_vec();
        knots.get_mut(self.knot..self.knot + self.copies)?.fill(value);
        self.curve.homogeneous_in(&knots, self.span, self.u)
    }

    /// Points for `steps + 1` values of the knot at equal steps; those that have no value are left out.
    #[must_use]
    pub fn points(&self, [from, to]: [f64; 2], steps: usize) -> Vec<(f64, Point<D>)> {
        let value = |k: usize| {
            let t = k as f64 / steps.max(1) as f64;
            (1.0 - t) * from + t * to
        };
        (0..=steps).map(value).filter_map(|v| self.at(v).map(|point| (v, point))).collect()
    }
}
