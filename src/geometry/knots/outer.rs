//! Through a point by the two outer knots of a span, both of whose paths are straight.

use super::through::{check_cubic, solved, within};
use super::{KnotCurve, KnotError, KnotVector, Through, Unreached};
use crate::geometry::Point;

/// What the outer knots `u_{j-2}` and `u_{j+3}` of span `j` do to the cubic functions at `u`: the first function grows
/// and the second falls by the same, and so at the other end.
pub(super) struct Outer {
    span: usize,
    /// `u_{j+1}` and `u_j`: what the moved knots are counted from.
    anchors: [f64; 2],
    /// The first and the last function are these numbers over the distance of the moved knot from its anchor.
    factors: [f64; 2],
    /// The first and the last function as they are.
    values: [f64; 2],
    /// Where the knots may be.
    rooms: [[f64; 2]; 2],
}

impl Outer {
    /// For a cubic vector and `u` inside span `span`.
    pub(super) fn new(vector: &KnotVector, span: usize, u: f64) -> Result<Self, KnotError> {
        vector.check_inside("u", span, u)?;
        let knots = vector.knots();
        let at = |offset: usize| knots[span + offset - 3];
        let (left, right) = (at(4) - u, u - at(3));
        if left <= 0.0 || right <= 0.0 {
            return Err(KnotError::OnKnot { name: "u", value: u, span: [at(3), at(4)] });
        }
        let width = at(4) - at(3);
        let factors = [left.powi(3) / (width * (at(4) - at(2))), right.powi(3) / (width * (at(5) - at(3)))];
        Ok(Self {
            span,
            anchors: [at(4), at(3)],
            factors,
            values: [factors[0] / (at(4) - at(1)), factors[1] / (at(6) - at(3))],
            rooms: [[at(0), at(2)], [at(5), at(7)]],
        })
    }

    /// The differences that the functions may have, for the knots at either end of their rooms.
    pub(super) fn ranges(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|end| {
            let ends = self.rooms[end]
                .map(|knot| self.factors[end] / (knot - self.anchors[end]).abs() - self.values[end]);
            [ends[0].min(ends[1]), ends[0].max(ends[1])]
        })
    }

    /// The knots for differences of the first and the last function.
    pub(super) fn moved(&self, vector: &KnotVector, by: [f64; 2]) -> Result<KnotVector, KnotError> {
        let mut knots = vector.knots().to_vec();
        for (end, knot) in [self.span - 2, self.span + 3].into_iter().enumerate() {
            let value = self.values[end] + by[end];
            if value <= 0.0 {
                let point = if end == 0 { self.span - 3 } else { self.span };
                return Err(Unreached::Function { point, value }.into());
            }
            let distance = self.factors[end] / value;
            let place = if end == 0 { self.anchors[0] - distance } else { self.anchors[1] + distance };
            knots[knot] = within(knot, place, self.rooms[end])?;
        }
        KnotVector::new(vector.order(), knots)
    }
}

impl KnotCurve<2> {
    /// The plane cubic through a point at `u` in span `j`, by the knots `u_{j-2}` and `u_{j+3}` in closed form.
    ///
    /// # Errors
    /// [`KnotError::Unreached`] with the reason; a curve that is not a plane open cubic without weights; a bad span or `u`.
    pub fn through_outer(&self, point: Point<2>, span: usize, u: f64) -> Result<Through<2>, KnotError> {
        check_cubic(self, point)?;
        let outer = Outer::new(self.vector(), span, u)?;
        let now = self.point_at(u).ok_or(Unreached::NotFound)?;
        let side = |a: usize, b: usize| {
            let [a, b] = [a, b].map(|i| self.points().get(i).copied().unwrap_or_default());
            [a[0] - b[0], a[1] - b[1]]
        };
        let wanted = [point[0] - now[0], point[1] - now[1]];
        let by = solved(side(span - 3, span - 2), side(span, span - 1), wanted).ok_or(Unreached::Parallel)?;
        let curve = Self::new(outer.moved(self.vector(), by)?, self.points().to_vec())?;
        Ok(Through { curve, u })
    }
}
