//! The envelope of the curves that a moving knot makes (2.6, 2.7, 2.9, 2.10).

use super::local::Hom;
use super::{KnotCurve, KnotError, KnotVector};
use crate::geometry::Point;

/// The curve that all curves of the family touch: one arc of order `k - m` for `m` copies of a knot.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope<const D: usize> {
    /// The arc, over the range that the knot may move in: from the knot before the copies to the knot after. Its
    /// knots are as many as its order needs.
    pub curve: KnotCurve<D>,
    /// All knots of the given curve without the copies.
    pub knots: Vec<f64>,
    /// The present value of the knot: there the given curve touches the envelope.
    pub at: f64,
    /// The curvature of the envelope as a multiple of that of the curve at the touching point,
    /// `(k-1)(k-m-2) / ((k-2)(k-m-1))`; `None` where the denominator is 0.
    pub curvature_ratio: Option<f64>,
}

impl<const D: usize> Envelope<D> {
    /// Where the given curve touches the envelope, and every path of its points beside the knot (2.7).
    #[must_use]
    pub fn touching(&self) -> Option<Point<D>> {
        self.curve.point_at(self.at)
    }
}

impl<const D: usize> KnotCurve<D> {
    /// The envelope for `multiplicity` copies of a knot, `knot` the first of them, that are moved together.
    ///
    /// # Errors
    /// [`KnotError::NoEnvelope`], [`KnotError::Index`], [`KnotError::NoSpan`] where the knot has no room.
    pub fn envelope(&self, knot: usize, multiplicity: usize) -> Result<Envelope<D>, KnotError> {
        let order = self.vector().order();
        self.check_copies(knot, multiplicity, order)?;
        let (first, last) = (order - multiplicity, self.vector().controls());
        let low = envelope_order(order, multiplicity)?;
        if !(first..=last).contains(&knot) {
            return Err(KnotError::Index { name: "knot", given: knot, first, last });
        }
        let (vector, knots) = envelope_knots(self.vector().knots(), knot, multiplicity, low)?;
        let points: Vec<Hom<D>> = (knot - low..knot).map(|i| self.homogeneous(i)).collect();
        let [k, m] = [order, multiplicity].map(|x| x as f64);
        let below = (k - 2.0) * (k - m - 1.0);
        Ok(Envelope {
            curve: Self::of_homogeneous(vector, &points, self.weights().is_some())?,
            knots,
            at: self.vector().knots()[knot],
            curvature_ratio: (below != 0.0).then(|| (k - 1.0) * (k - m - 2.0) / below),
        })
    }
}

/// The order of the envelope.
pub(super) fn envelope_order(order: usize, multiplicity: usize) -> Result<usize, KnotError> {
    match order.checked_sub(multiplicity) {
        Some(low) if low >= 2 => Ok(low),
        _ => Err(KnotError::NoEnvelope { order, multiplicity }),
    }
}

/// The knots of the envelope's arc, and all knots without the copies.
pub(super) fn envelope_knots(
    knots: &[f64],
    knot: usize,
    multiplicity: usize,
    low: usize,
) -> Result<(KnotVector, Vec<f64>), KnotError> {
    let kept = knots.iter().enumerate().filter(|(i, _)| !(knot..knot + multiplicity).contains(i));
    let knots: Vec<f64> = kept.map(|(_, u)| *u).collect();
    let own = knots.get(knot - low..knot + low).ok_or(KnotError::NoSpan)?.to_vec();
    Ok((KnotVector::new(low, own)?, knots))
}
