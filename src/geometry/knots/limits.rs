//! Where extended paths end (theorem 2.8).

use super::{KnotCurve, KnotError};
use crate::geometry::Point;

/// Where arcs shrink to while a knot runs to infinity, the same at both infinities. The limit belongs to the arc, not
/// to the sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<const D: usize> {
    /// Of the arc after the knot; `None` where there is none.
    pub after: Option<Point<D>>,
    /// Of the arc before the knot.
    pub before: Option<Point<D>>,
}

impl<const D: usize> KnotCurve<D> {
    /// The limits of both arcs beside `multiplicity` copies of a knot, `knot` the first of them, that are moved together.
    ///
    /// # Errors
    /// [`KnotError::Index`] for a knot or a multiplicity that is not there.
    pub fn limits(&self, knot: usize, multiplicity: usize) -> Result<Limits<D>, KnotError> {
        let order = self.vector().order();
        self.check_copies(knot, multiplicity, order - 1)?;
        let (first, last) = (order - 1, self.vector().controls() - 1);
        let spans = first..=last;
        let point = |i: usize| self.points().get(self.vector().point_index(i)).copied();
        let after =
            spans.contains(&(knot + multiplicity - 1)).then(|| point(knot + multiplicity - 1)).flatten();
        let before = knot.checked_sub(order).filter(|_| spans.contains(&(knot - 1))).and_then(point);
        Ok(Limits { after, before })
    }

    /// The check on copies of a knot that are moved together.
    pub(super) fn check_copies(
        &self,
        knot: usize,
        multiplicity: usize,
        most: usize,
    ) -> Result<(), KnotError> {
        let (first, copies) = self.vector().copies(knot)?;
        if knot == 0 || knot + multiplicity >= self.vector().knots().len() {
            let last = self.vector().knots().len() - 2;
            return Err(KnotError::Index { name: "knot", given: knot, first: 1, last });
        }
        let last = most.min(first + copies - knot);
        if (1..=last).contains(&multiplicity) {
            return Ok(());
        }
        Err(KnotError::Index { name: "multiplicity", given: multiplicity, first: 1, last })
    }
}
