//! Rational arcs of the plane in a row, as a curve like any other.

use super::bernstein::{derivative, eval};
use super::rational::RationalArc;
use crate::geometry::param::clipped;
use crate::geometry::{COORDINATE_LIMIT, GeometryError, ParamCurve, Point};

/// Rational Bézier arcs in a row, such as the exact offset of a PH curve as a file holds it. Arcs need not meet.
///
/// ```
/// use grafika::geometry::ParamCurve;
/// use grafika::geometry::ph::{RationalArc, RationalCurve};
///
/// // A quarter of the unit circle.
/// let arc = RationalArc::new(vec![[1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 2.0, 2.0]]);
/// let curve = RationalCurve::new(vec![arc], false)?;
/// assert!((curve.length(1e-12) - std::f64::consts::FRAC_PI_2).abs() < 1e-11);
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RationalCurve {
    arcs: Vec<RationalArc>,
    closed: bool,
}

/// The highest degree of an arc.
const MOST_DEGREES: usize = 60;

impl RationalCurve {
    /// The curve of these arcs; a closed one returns to its beginning.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for an arc of degree 0 or above 60 and for a weight that is not positive all along
    /// an arc, [`GeometryError::Overflow`] for an arc that leaves the coordinate limit.
    pub fn new(arcs: Vec<RationalArc>, closed: bool) -> Result<Self, GeometryError> {
        for (span, arc) in arcs.iter().enumerate() {
            if !(1..=MOST_DEGREES).contains(&arc.degree()) {
                let value = arc.degree() as f64;
                return Err(GeometryError::Parameter { name: "degree", value, wanted: "1 to 60" });
            }
            if !arc.homogeneous().iter().flatten().all(|x| x.abs() <= COORDINATE_LIMIT) {
                return Err(GeometryError::Overflow { span });
            }
            let Some(pieces) = arc.with_positive_weights() else {
                let value = arc.homogeneous().iter().fold(f64::INFINITY, |least, point| least.min(point[2]));
                let wanted = "positive all along an arc, as it is where the curve does not stop";
                return Err(GeometryError::Parameter { name: "weight", value, wanted });
            };
            let inside = |&[x, y, w]: &[f64; 3]| [x / w, y / w].iter().all(|x| x.abs() <= COORDINATE_LIMIT);
            if !pieces.iter().all(|(piece, _)| piece.homogeneous().iter().all(inside)) {
                return Err(GeometryError::Overflow { span });
            }
        }
        Ok(Self { arcs, closed })
    }

    /// The arcs, one a span.
    #[must_use]
    pub fn arcs(&self) -> &[RationalArc] {
        &self.arcs
    }
}

impl ParamCurve<2> for RationalCurve {
    fn spans(&self) -> usize {
        self.arcs.len()
    }

    fn closed(&self) -> bool {
        self.closed
    }

    /// By the quotient rule: `p' = (X' - p w') / w` and `p'' = (X'' - 2 p' w' - p w'') / w`.
    fn at(&self, span: usize, u: f64) -> Option<[Point<2>; 3]> {
        let (arc, u) = (self.arcs.get(span)?, clipped(u));
        let of_axis = |axis: usize| {
            let values: Vec<f64> = arc.homogeneous().iter().map(|point| point[axis]).collect();
            let slopes = derivative(&values);
            [eval(&values, u), eval(&slopes, u), eval(&derivative(&slopes), u)]
        };
        let weight = of_axis(2);
        // Too large numbers can only be derivatives.
        let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
        let [x, y] = [0, 1].map(|axis| {
            let value = of_axis(axis);
            let point = value[0] / weight[0];
            let slope = finite((value[1] - point * weight[1]) / weight[0]);
            let bend = finite((value[2] - 2.0 * slope * weight[1] - point * weight[2]) / weight[0]);
            [finite(point), slope, bend]
        });
        Some([0, 1, 2].map(|order| [x[order], y[order]]))
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{distance, quintic};
    use super::super::{PhCurve, Place};
    use super::*;
    use crate::geometry::Closure;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn an_offset_read_from_its_arcs_is_the_offset(segment in quintic(), d in -60.0..60.0, u in 0.0..1.0) {
            let offset = PhCurve::new(Closure::Open, vec![segment]).offset(d).unwrap();
            let curve = RationalCurve::new(offset.arcs(), false).unwrap();
            let ([p, slope, bend], [q, other, turn]) = (curve.at(0, u).unwrap(), offset.at(0, u).unwrap());
            let size = 1.0 + [slope, bend, turn].iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
            prop_assert!(distance(p, q) < 1e-11);
            prop_assert!(distance(slope, other) < 1e-10 * size, "{:?} {:?}", slope, other);
            prop_assert!(distance(bend, turn) < 1e-8 * size, "{:?} {:?}", bend, turn);
        }

        #[test]
        fn parts_are_pieces_of_the_offset(segment in quintic(), d in -60.0..60.0, a in 0.0..0.5, b in 0.55..1.0) {
            let offset = PhCurve::new(Closure::Open, vec![segment]).offset(d).unwrap();
            let part = offset.part([Place { span: 0, u: a }, Place { span: 0, u: b }]);
            let exact = RationalCurve::new(part.arcs(), false).unwrap();
            prop_assert_eq!(part.spans(), 1);
            for k in 0..=8 {
                let t = f64::from(k) / 8.0;
                let want = ParamCurve::eval(&offset, 0, a + (b - a) * t).unwrap();
                prop_assert!(distance(part.eval(0, t).unwrap(), want) < 1e-12);
                prop_assert!(distance(exact.eval(0, t).unwrap(), want) < 1e-11);
            }
        }
    }

    #[test]
    fn wrong_arcs_are_named() {
        let of = |points: Vec<[f64; 3]>| RationalCurve::new(vec![RationalArc::new(points)], false);
        assert!(matches!(of(vec![[0.0, 0.0, 1.0]]), Err(GeometryError::Parameter { name: "degree", .. })));
        assert!(matches!(of(Vec::new()), Err(GeometryError::Parameter { name: "degree", .. })));
        let zero = of(vec![[0.0, 0.0, 1.0], [1.0, 1.0, -1.0], [2.0, 0.0, 1.0]]);
        assert!(matches!(zero, Err(GeometryError::Parameter { name: "weight", .. })));
        for bad in [f64::NAN, 1e151] {
            assert_eq!(of(vec![[0.0, bad, 1.0], [1.0, 0.0, 1.0]]), Err(GeometryError::Overflow { span: 0 }));
        }
        assert!(of(vec![[1e100, 0.0, 1e-100], [1.0, 0.0, 1.0]]).is_err());
    }
}
