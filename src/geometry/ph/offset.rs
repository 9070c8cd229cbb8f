//! Offsets of planar PH curves: exact points, exact length, cusps, and the exact rational form.

use super::bernstein::{elevated, eval, product, size};
use super::complex::Complex;
use super::curve::{PhCurve, Place};
use super::rational::RationalArc;
use super::roots::roots;
use super::segment::PhSegment;
use crate::geometry::cubic::check_arcs;
use crate::geometry::method::Closure;
use crate::geometry::param::{check_tolerance, clipped};
use crate::geometry::point::within_limit;
use crate::geometry::{COORDINATE_LIMIT, CubicBezier, GeometryError, ParamCurve, Point};

/// The offset of a planar PH curve at a signed distance: `r + d n` with the unit normal `n` to the left.
///
/// Every span has the parameter of the curve's span. It is a rational curve of degree 9 over quintics and 5 over
/// cubics ([`Offset::arcs`]).
#[derive(Clone, Debug, PartialEq)]
pub struct Offset {
    curve: PhCurve,
    distance: f64,
    /// The cusps by span.
    cusps: Vec<Place>,
}

impl PhCurve {
    /// The offset at the distance `distance`, in the unit of the points: to the left of the direction of travel where
    /// positive, to the right where negative.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for a distance that is not finite or beyond the coordinate limit,
    /// [`GeometryError::Overflow`] for an offset that leaves it.
    pub fn offset(&self, distance: f64) -> Result<Offset, GeometryError> {
        if distance.is_nan() || distance.abs() > COORDINATE_LIMIT {
            let wanted = "a finite number, not larger than coordinates may be";
            return Err(GeometryError::Parameter { name: "distance", value: distance, wanted });
        }
        for (span, segment) in self.segments().iter().enumerate() {
            let most = segment.parts().control.iter().fold(0.0_f64, |most, point| most.max(point.norm()));
            let slope = segment.parts().hodograph.iter().fold(0.0_f64, |most, leg| most.max(leg.norm()));
            // Products of both appear in the rational form and where crossings are searched.
            if !within_limit(&[(most + distance.abs()) * slope.max(1.0)]) {
                return Err(GeometryError::Overflow { span });
            }
        }
        let cusps = self.collect(|segment| cusps_of(segment, distance));
        Ok(Offset { curve: self.clone(), distance, cusps })
    }
}

/// The roots of `sigma^2 - 2 d h g`, which is `sigma^2 (1 - d kappa)`.
fn cusps_of(segment: &PhSegment, distance: f64) -> Vec<f64> {
    let parts = segment.parts();
    let square = product(parts.speed, parts.speed);
    let bend = elevated(parts.bend, square.len() - parts.bend.len());
    let turn = 2.0 * distance * parts.step;
    let difference: Vec<f64> = square.iter().zip(bend).map(|(square, bend)| square - turn * bend).collect();
    roots(&difference, size(&square) + turn.abs() * size(parts.bend))
}

impl Offset {
    /// The curve that this is the offset of.
    #[must_use]
    pub fn curve(&self) -> &PhCurve {
        &self.curve
    }

    /// The signed distance, positive to the left.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// The cusps in the order of the curve: where `1 - d kappa` is zero.
    #[must_use]
    pub fn cusps(&self) -> &[Place] {
        &self.cusps
    }

    /// The exact length: between cusps, the change of the curve's length less `d` times its turning.
    #[must_use]
    pub fn length(&self) -> f64 {
        let mut sum = 0.0;
        for (span, segment) in self.curve.segments().iter().enumerate() {
            let mut from = Place { span, u: 0.0 };
            let cusps = self.cusps_of_span(span).chain(std::iter::once(1.0));
            for u in cusps {
                let to = Place { span, u };
                let lengths = [from, to].map(|place| self.curve.length_at(place).unwrap_or(0.0));
                let turning = segment.turning(from.u, to.u);
                sum += ((lengths[1] - lengths[0]) - self.distance * turning).abs();
                from = to;
            }
        }
        sum
    }

    /// The parameters of the cusps of one span, in ascending order.
    pub(super) fn cusps_of_span(&self, span: usize) -> impl Iterator<Item = f64> + '_ {
        let first = self.cusps.partition_point(|cusp| cusp.span < span);
        self.cusps[first..].iter().take_while(move |cusp| cusp.span == span).map(|cusp| cusp.u)
    }

    /// The exact rational Bézier form of every span: weights `sigma` and numerators `sigma r + i d r'`, raised to the
    /// degree `4 m + 1`: 9 for quintics, 5 for cubics. Weights may be zero or negative; they are never divided by.
    #[must_use]
    pub fn arcs(&self) -> Vec<RationalArc> {
        self.curve.segments().iter().map(|segment| self.arc(segment)).collect()
    }

    fn arc(&self, segment: &PhSegment) -> RationalArc {
        let parts = segment.parts();
        let degree = segment.degree();
        let weights = elevated(parts.speed, degree);
        let moved: Vec<Complex> = parts.hodograph.iter().map(|leg| leg.left() * self.distance).collect();
        let numerators = product(parts.speed, parts.control).into_iter().zip(elevated(&moved, degree));
        let points = numerators.zip(&weights).map(|((point, moved), &weight)| {
            let [x, y] = (point + moved).point();
            [x, y, weight]
        });
        RationalArc::new(points.collect())
    }

    /// The point and the derivative at a place, by the span's parameter: `r' (1 - d kappa)`.
    pub(super) fn moved(&self, segment: &PhSegment, u: f64) -> [Complex; 2] {
        let parts = segment.parts();
        let u = clipped(u);
        let w = eval(segment.w(), u);
        let square = w.norm_squared();
        let normal = if square > 0.0 { (w * w).left() * (1.0 / square) } else { segment.limit_normal(u) };
        let curvature = 2.0 * eval(parts.bend, u) / (parts.step * square * square);
        let shrunk =
            if square > 0.0 && curvature.is_finite() { 1.0 - self.distance * curvature } else { 1.0 };
        [eval(parts.control, u) + normal * self.distance, w * w * (parts.step * shrunk)]
    }
}

impl ParamCurve<2> for Offset {
    fn spans(&self) -> usize {
        self.curve.spans()
    }

    fn closed(&self) -> bool {
        self.curve.closure() == Closure::Closed
    }

    /// Where the curve has zero speed, the normal is its limit, and derivatives are those of the curve.
    fn at(&self, span: usize, u: f64) -> Option<[Point<2>; 3]> {
        let segment = self.curve.segments().get(span)?;
        let [point, slope] = self.moved(segment, u);
        let [_, first, second] = segment.at(u);
        let [first, second] = [first, second].map(Complex::from);
        // r_d'' = r'' (1 - d kappa) - d kappa' r'.
        let bent = segment.curvature(u).zip(segment.curvature_slope(u)).map(|(curvature, change)| {
            second * (1.0 - self.distance * curvature) - first * (self.distance * change)
        });
        let second = bent.filter(|it| it.is_finite()).unwrap_or(second);
        Some([point, slope, second].map(Complex::point))
    }

    fn eval(&self, span: usize, u: f64) -> Option<Point<2>> {
        self.curve.segments().get(span).map(|segment| self.moved(segment, u)[0].point())
    }

    /// Arcs end at cusps and at the inflections of the curve.
    fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<2>>, GeometryError> {
        check_tolerance(tolerance)?;
        let mut arcs = Vec::new();
        for span in 0..self.curve.spans() {
            self.add_cubics_of((span, [0.0, 1.0]), tolerance, &mut arcs)?;
        }
        check_arcs(arcs)
    }

    /// The exact length, whatever the accuracy asked for.
    fn length(&self, _accuracy: f64) -> f64 {
        Self::length(self)
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{distance, quintic, ring};
    use super::super::{Knots, SplineEnds};
    use super::*;
    use crate::geometry::arclen::integrate;
    use proptest::prelude::*;

    fn curve_of(segment: PhSegment) -> PhCurve {
        PhCurve::new(Closure::Open, vec![segment])
    }

    proptest! {
        #[test]
        fn the_rational_form_is_the_offset(segment in quintic(), d in -80.0..80.0, u in 0.0..1.0) {
            let offset = curve_of(segment).offset(d).unwrap();
            let arcs = offset.arcs();
            prop_assert_eq!((arcs.len(), arcs[0].degree()), (1, 9));
            let (point, exact) = (ParamCurve::eval(&offset, 0, u).unwrap(), arcs[0].eval(u).unwrap());
            prop_assert!(distance(point, exact) < 1e-11, "{:?} {:?}", point, exact);
            let place = Place { span: 0, u };
            let normal = offset.curve().normal(place).unwrap();
            let base = offset.curve().eval(0, u).unwrap();
            prop_assert!(distance(point, [0, 1].map(|k| base[k] + d * normal[k])) < 1e-12);
            // Back again by the same normal: it is the curve.
            prop_assert!(distance(base, [0, 1].map(|k| point[k] - d * normal[k])) < 1e-12);
        }

        #[test]
        fn derivatives_agree_with_differences(segment in quintic(), d in -80.0..80.0, u in 0.01..0.99) {
            let offset = curve_of(segment).offset(d).unwrap();
            let h = 1e-5;
            let [at, before, after] = [u, u - h, u + h].map(|u| offset.at(0, u).unwrap());
            let bend = offset.curve().segments()[0].curvature(u).unwrap().abs();
            let sharp = 1.0 + (bend * 1e3).powi(3);
            for k in 0..2 {
                let slope = (after[0][k] - before[0][k]) / (2.0 * h);
                prop_assert!((slope - at[1][k]).abs() < 1e-3 * sharp, "{} {}", slope, at[1][k]);
                let slope = (after[1][k] - before[1][k]) / (2.0 * h);
                prop_assert!((slope - at[2][k]).abs() < 1e-1 * sharp, "{} {}", slope, at[2][k]);
            }
        }

        #[test]
        fn length_is_that_of_the_speed(segment in quintic(), d in -80.0..80.0) {
            let offset = curve_of(segment).offset(d).unwrap();
            let segment = &offset.curve().segments()[0];
            let speed = |u: f64| segment.speed(u) * (1.0 - d * segment.curvature(u).unwrap()).abs();
            let mut ends = vec![0.0];
            ends.extend(offset.cusps().iter().map(|cusp| cusp.u));
            ends.push(1.0);
            let measured: f64 = ends.windows(2).map(|pair| integrate(&speed, [pair[0], pair[1]], 1e-11)).sum();
            prop_assert!((offset.length() - measured).abs() < 1e-9 * (1.0 + measured));
        }

        #[test]
        fn cusps_are_where_the_factor_changes_its_sign(segment in quintic(), d in -80.0..80.0) {
            let offset = curve_of(segment).offset(d).unwrap();
            let segment = &offset.curve().segments()[0];
            let factor = |u: f64| 1.0 - d * segment.curvature(u).unwrap();
            let values: Vec<f64> = (0..=2000).map(|k| factor(f64::from(k) / 2000.0)).collect();
            let changes = values.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
            prop_assert!(offset.cusps().len() >= changes, "{:?}", offset.cusps());
            for cusp in offset.cusps() {
                // The factor is steep where the curve is tight.
                let near = (factor((cusp.u - 1e-9).max(0.0)), factor((cusp.u + 1e-9).min(1.0)));
                prop_assert!(near.0 * near.1 <= 0.0 || near.0.abs() < 1e-6, "{:?}", near);
            }
            // No cusps within the limits, and some just beyond.
            let [below, above] = offset.curve().offset_limits();
            for limit in [below, above].into_iter().flatten() {
                prop_assume!(limit.abs() < 1e6);
                prop_assert!(offset.curve().offset(limit * 0.9999).unwrap().cusps().is_empty());
                prop_assert!(!offset.curve().offset(limit * 1.01).unwrap().cusps().is_empty());
            }
        }

        #[test]
        fn offsets_of_rings_differ_by_whole_turns(points in ring(), share in 0.1..0.9) {
            let curve = PhCurve::spline(Knots::Chord, SplineEnds::Closed, &points).unwrap();
            let [below, above] = curve.offset_limits();
            for d in [below.map_or(-50.0, |it| it * share), above.map_or(50.0, |it| it * share)] {
                let want = curve.total_length() - d * std::f64::consts::TAU;
                prop_assert!((curve.offset(d).unwrap().length() - want).abs() < 1e-9 * want.abs().max(1.0));
            }
        }
    }

    #[test]
    fn left_is_positive() {
        let line = PhCurve::hermite(Closure::Open, &[[0.0, 0.0], [9.0, 0.0]], &[[9.0, 0.0]; 2]).unwrap();
        let offset = line.offset(2.0).unwrap();
        assert_eq!(ParamCurve::eval(&offset, 0, 0.5).map(|[_, y]| y), Some(2.0));
        assert!((offset.length() - 9.0).abs() < 1e-14);
        assert!(offset.cusps().is_empty());
        assert_eq!(line.offset_limits(), [None, None]);
    }

    #[test]
    fn points_of_zero_speed_have_the_limit_of_the_normal() {
        let points = [[0.0, 0.0], [100.0, 0.0]];
        let curve = PhCurve::hermite(Closure::Open, &points, &[[0.0, 0.0], [50.0, 80.0]]).unwrap();
        let offset = curve.offset(7.0).unwrap();
        let [start, near] = [0.0, 1e-7].map(|u| ParamCurve::eval(&offset, 0, u).unwrap());
        assert!(distance(start, near) < 1e-5 && (distance(start, points[0]) - 7.0).abs() < 1e-14);
        assert!(offset.at(0, 0.0).unwrap().iter().flatten().all(|x| x.is_finite()));
        assert!(offset.length().is_finite());
    }

    #[test]
    fn bad_distances_are_named() {
        let line = PhCurve::hermite(Closure::Open, &[[0.0, 0.0], [9.0, 0.0]], &[[9.0, 0.0]; 2]).unwrap();
        for value in [f64::NAN, f64::INFINITY, -1e200] {
            assert!(matches!(line.offset(value), Err(GeometryError::Parameter { name: "distance", .. })));
        }
        assert_eq!(line.offset(1e150), Err(GeometryError::Overflow { span: 0 }));
    }
}
