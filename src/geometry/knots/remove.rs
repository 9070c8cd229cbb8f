//! One knot less, if the curve allows it.

use super::local::Hom;
use super::{KnotCurve, KnotError, KnotVector};
use crate::geometry::{Basis, ParamCurve, norm};

/// Steps of a span at which the distance of two curves is measured.
const STEPS: u32 = 64;

impl<const D: usize> KnotCurve<D> {
    /// The curve without one knot inside the domain, its control points by least squares, and how far it has moved at
    /// most (measured at 64 steps a span). The inverse of insertion where the curve did not need the knot.
    ///
    /// # Errors
    /// [`KnotError::WouldMove`] where it would move by more than `tolerance` (in the unit of the points; a billionth
    /// of the curve's size is what rounding needs), [`KnotError::Index`] for a knot that is not inside the domain.
    pub fn with_removed(&self, knot: usize, tolerance: f64) -> Result<(Self, f64), KnotError> {
        let curve = self.without(knot)?;
        let by = self.distance(&curve);
        if by <= tolerance { Ok((curve, by)) } else { Err(KnotError::WouldMove { by, tolerance }) }
    }

    fn without(&self, knot: usize) -> Result<Self, KnotError> {
        let (vector, fine, order) = (self.vector(), self.vector().knots(), self.vector().order());
        let (first, copies) = vector.copies(knot)?;
        let [from, to] = vector.domain();
        let (u, closed) = (fine[knot], vector.breaks().is_some());
        if !(u > from && u < to) || vector.points() <= order {
            let [begin, end] = [fine.partition_point(|x| *x <= from), fine.partition_point(|x| *x < to)];
            let last = if vector.points() <= order { 0 } else { end - 1 };
            return Err(KnotError::Index { name: "knot", given: knot, first: begin, last });
        }
        let (removed, times) = (first + copies - 1, copies - 1);
        let mut coarse = fine.to_vec();
        coarse.remove(removed);
        let span = removed - 1;
        let middle = self.coarse_points(&coarse, span, times);
        let new = |i: usize| {
            // The first unknown is span - k + 2; before it nothing changed, behind the last one knot less.
            let low = span + 2 - order;
            match i.checked_sub(low) {
                None if times + 1 == order && i + 1 == low => middle[0],
                None => self.homogeneous(i),
                Some(l) => middle
                    .get(l)
                    .filter(|_| times + 1 < order)
                    .copied()
                    .unwrap_or_else(|| self.homogeneous(i + 1)),
            }
        };
        let rational = self.weights().is_some();
        if !closed {
            let points: Vec<Hom<D>> = (0..vector.controls() - 1).map(new).collect();
            return Self::of_homogeneous(KnotVector::new(order, coarse)?, &points, rational);
        }
        let mut breaks = fine[order - 1..order + vector.points()].to_vec();
        // Inside the domain: neither the first break nor the last.
        let place = removed + 1 - order;
        breaks.remove(place);
        let count = breaks.len() - 1;
        let low = span + 1 - order;
        let mut points = vec![Hom::ZERO; count];
        for i in low..low + count {
            points[i % count] = new(i);
        }
        Self::of_homogeneous(KnotVector::closed(order, &breaks)?, &points, rational)
    }

    /// The control points `span - k + 2 ..` of the coarse curve that an insertion would mix: `q_l = (1 - a_l) d_{l-1} +
    /// a_l d_l` is one equation more than unknowns. The residual of least squares lies along the one vector that
    /// annihilates the matrix; without it the equations fit together and are solved from both ends.
    fn coarse_points(&self, coarse: &[f64], span: usize, times: usize) -> Vec<Hom<D>> {
        let order = self.vector().order();
        if times + 1 >= order {
            // A gap: both sides become their middle.
            let [a, b] = [span + 1 - order, span + 2 - order].map(|i| self.homogeneous(i));
            return vec![a.mixed(0.5, 0.5, b)];
        }
        let low = span + 2 - order;
        let rows = order - 1 - times;
        let u = self.vector().knots()[span + 1];
        let shares: Vec<f64> =
            (low..low + rows).map(|i| (u - coarse[i]) / (coarse[i + order - 1] - coarse[i])).collect();
        let (before, after) = (self.homogeneous(low - 1), self.homogeneous(low + rows));
        let mut right: Vec<Hom<D>> = (low..low + rows).map(|i| self.homogeneous(i)).collect();
        right[0] = right[0].mixed(1.0, -(1.0 - shares[0]), before);
        right[rows - 1] = right[rows - 1].mixed(1.0, -shares[rows - 1], after);
        let mut null = vec![1.0; rows];
        for l in 1..rows {
            null[l] = -null[l - 1] * shares[l - 1] / (1.0 - shares[l]);
        }
        let square: f64 = null.iter().map(|x| x * x).sum();
        let along = null.iter().zip(&right).fold(Hom::ZERO, |sum, (x, row)| sum.mixed(1.0, x / square, *row));
        for (x, row) in null.iter().zip(&mut right) {
            *row = row.mixed(1.0, -x, along);
        }
        let unknowns = rows - 1;
        let mut found = vec![Hom::ZERO; unknowns];
        for l in 0..unknowns.div_ceil(2) {
            let last = if l == 0 { Hom::ZERO } else { found[l - 1] };
            found[l] = right[l].mixed(1.0 / shares[l], -(1.0 - shares[l]) / shares[l], last);
        }
        for l in (unknowns.div_ceil(2)..unknowns).rev() {
            let next = found.get(l + 1).copied().unwrap_or(Hom::ZERO);
            let rest = 1.0 - shares[l + 1];
            found[l] = right[l + 1].mixed(1.0 / rest, -shares[l + 1] / rest, next);
        }
        found
    }

    /// The largest distance at the same parameters.
    fn distance(&self, other: &Self) -> f64 {
        let mut most = 0.0_f64;
        for span in 0..self.spans() {
            // Its span there too, as both may have gaps at the ends.
            let Some((_, middle, _)) = self.vector().place(span, 0.5) else { continue };
            let Some(there) = other.vector().span_of(middle) else { continue };
            for t in (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS)) {
                let Some((j, u, _)) = self.vector().place(span, t) else { continue };
                let [a, b] = [(self, j), (other, there)].map(|(curve, span)| {
                    curve.homogeneous_in(curve.vector().knots(), span, u).and_then(Hom::point)
                });
                if let (Some(a), Some(b)) = (a, b) {
                    most = most.max(norm::<D>(std::array::from_fn(|d| a[d] - b[d])));
                }
            }
        }
        most
    }
}
