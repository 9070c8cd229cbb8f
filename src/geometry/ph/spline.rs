//! C2 PH quintic splines through points (Albrecht and Farouki 1996; Farouki, Kuspa, Manni and Sestini 2001).
//!
//! The complex function `w` of the whole curve is a quadratic C1 B-spline over the knots. Its control values are the
//! middle coefficients `z_i` of the spans, and every span asks for one complex quadratic equation between three of
//! them: that its integral is the chord.

use super::complex::Complex;
use super::curve::PhCurve;
use super::hermite::quintics;
use super::segment::PhSegment;
use super::solver::{Equations, Span};
use super::start::{Slopes, cubic_slopes, start_values};
use crate::geometry::hermite::check_input;
use crate::geometry::method::Closure;
use crate::geometry::point::{check_points, norm, scaled_difference};
use crate::geometry::{GeometryError, Point};
use serde::{Deserialize, Serialize};

/// How the knot steps of a spline follow from its points. They are scaled so that their mean is 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Knots {
    /// As long as the chords: the rule that makes the fewest loops where chords are uneven.
    #[default]
    Chord,
    /// All equal.
    Uniform,
    /// The square roots of the chords.
    Centripetal,
}

/// How an open spline ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplineEnd {
    /// The end span is a PH cubic.
    Cubic,
    /// This derivative at the end, in units per knot, with knot steps whose mean is 1.
    Derivative(Point<2>),
}

/// The ends of a spline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplineEnds {
    /// Two ends, the start first.
    Open([SplineEnd; 2]),
    /// None: the last point is followed by the first.
    Closed,
}

impl Knots {
    /// Every rule with its name in JSON and on command lines.
    pub const ALL: [(&'static str, Self); 3] =
        [("chord", Self::Chord), ("uniform", Self::Uniform), ("centripetal", Self::Centripetal)];

    /// The rule of a name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|&(_, knots)| knots)
    }

    /// The steps of the knots over chords of these lengths, scaled to mean 1.
    #[must_use]
    pub fn steps(self, chords: &[f64]) -> Vec<f64> {
        let step = |chord: &f64| match self {
            Self::Uniform => 1.0,
            Self::Chord => *chord,
            Self::Centripetal => chord.sqrt(),
        };
        let steps: Vec<f64> = chords.iter().map(step).collect();
        let mean = steps.iter().sum::<f64>() / steps.len().max(1) as f64;
        steps.into_iter().map(|step| step / mean).collect()
    }
}

impl SplineEnds {
    fn closure(self) -> Closure {
        match self {
            Self::Open(_) => Closure::Open,
            Self::Closed => Closure::Closed,
        }
    }
}

impl PhCurve {
    /// The C2 PH quintic spline through `points`, of several the one near the ordinary C2 cubic spline over the same
    /// knots. Two points with two cubic ends give the straight line, with two derivatives the quintic of
    /// [`PhSegment::hermite`].
    ///
    /// # Errors
    /// Fewer than 2 points (3 when closed), a bad coordinate (an end derivative counts as tangent 1 or 2),
    /// [`GeometryError::EqualNeighbours`] for successive points that are equal, [`GeometryError::NotSolved`],
    /// [`GeometryError::Overflow`].
    pub fn spline(knots: Knots, ends: SplineEnds, points: &[Point<2>]) -> Result<Self, GeometryError> {
        let closure = ends.closure();
        check_input(closure, points)?;
        let spans = match closure {
            Closure::Open => points.len() - 1,
            Closure::Closed => points.len(),
        };
        let ends_of = |span: usize| [points[span], points[(span + 1) % points.len()]];
        let mut chords = Vec::with_capacity(spans);
        for span in 0..spans {
            let [from, to] = ends_of(span);
            if from == to {
                return Err(GeometryError::EqualNeighbours {
                    number: span + 1,
                    next: (span + 1) % points.len() + 1,
                });
            }
            chords.push(scaled_difference(1.0, from, to));
        }
        // Lengths near 1 by a power of 4, so that nothing overflows and the roots are scaled exactly too.
        let longest = chords.iter().map(|chord| norm(*chord)).fold(0.0, f64::max);
        let root_scale = (0.5 * longest.log2()).round().exp2();
        let scaled = |vector: Point<2>| Complex::from(vector.map(|x| x / root_scale / root_scale));
        let chords: Vec<Complex> = chords.into_iter().map(scaled).collect();
        let steps = knots.steps(&chords.iter().map(|chord| chord.norm()).collect::<Vec<_>>());
        let derivatives = match ends {
            SplineEnds::Closed => [None; 2],
            SplineEnds::Open(ends) => {
                let given = ends.map(|end| match end {
                    SplineEnd::Cubic => None,
                    SplineEnd::Derivative(derivative) => Some(derivative),
                });
                check_points(&given.map(Option::unwrap_or_default))?;
                given
            }
        };
        if let ([Some(first), Some(last)], 1) = (derivatives, spans) {
            let (four, number) = quintics(0, ends_of(0), [first, last])?;
            return Ok(Self::new(closure, four.into_iter().skip(number).take(1).collect()));
        }
        let found = solved(closure, &chords, &steps, derivatives.map(|it| it.map(scaled)))?;
        let segment = |(span, w): (usize, [Complex; 3])| {
            PhSegment::new(span, steps[span], &w.map(|value| value * root_scale), ends_of(span))
        };
        Ok(Self::new(closure, found.into_iter().enumerate().map(segment).collect::<Result<_, _>>()?))
    }
}

/// The coefficients of every span.
fn solved(
    closure: Closure,
    chords: &[Complex],
    steps: &[f64],
    derivatives: [Option<Complex>; 2],
) -> Result<Vec<[Complex; 3]>, GeometryError> {
    let slopes = match closure {
        Closure::Closed => Slopes::Periodic,
        Closure::Open => Slopes::Ends(derivatives),
    };
    let unsolved = GeometryError::NotSolved { remainder: 1.0 };
    let knot_slopes = cubic_slopes(chords, steps, slopes).ok_or(unsolved)?;
    let values = start_values(chords, steps, &knot_slopes);
    let (Some(&first), Some(&last)) = (values.first(), values.last()) else { return Err(unsolved) };
    let root = |derivative: Complex, near: Complex| {
        let root = derivative.sqrt();
        if root.dot(near) < 0.0 { -root } else { root }
    };
    let [start, end] = derivatives;
    let fixed = [start.map(|it| root(it, first)), end.map(|it| root(it, last))];
    // A closed curve that turns an odd number of times has w of opposite sign where it returns.
    let seam = (closure == Closure::Closed).then(|| if first.dot(last) < 0.0 { -1.0 } else { 1.0 });
    let equations = Equations { chords, spans: spans_of(steps, fixed, seam), cyclic: seam.is_some() };
    let middles = equations.fit_middles(&values).ok_or(unsolved)?;
    let middles = equations.solve(middles).map_err(|remainder| GeometryError::NotSolved { remainder })?;
    Ok(equations.coefficients(&middles))
}

/// How the coefficients of every span follow from the unknown middle ones:
/// `w_0 = (h_i z_(i-1) + h_(i-1) z_i) / (h_(i-1) + h_i)`, and likewise at its end.
fn spans_of(steps: &[f64], [start, end]: [Option<Complex>; 2], seam: Option<f64>) -> Vec<Span> {
    let last = steps.len() - 1;
    let spans = 0..steps.len();
    spans
        .map(|i| {
            let own = steps[i];
            let share = |other: f64, sign: f64| {
                let sum = own + other;
                (sign * own / sum, other / sum)
            };
            let before = match (i, seam) {
                (0, None) => None,
                (0, Some(sign)) => Some(share(steps[last], sign)),
                _ => Some(share(steps[i - 1], 1.0)),
            };
            let after = match seam {
                None if i == last => None,
                Some(sign) if i == last => Some(share(steps[0], sign)),
                _ => Some(share(steps[i + 1], 1.0)),
            };
            Span::new(own, [before, after], [start, end])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::testing::{distance, ring, row, similarity};
    use super::*;
    use crate::geometry::ParamCurve;
    use proptest::prelude::*;

    const CUBIC: SplineEnds = SplineEnds::Open([SplineEnd::Cubic; 2]);

    fn knots() -> impl Strategy<Value = Knots> {
        prop_oneof![Just(Knots::Chord), Just(Knots::Uniform), Just(Knots::Centripetal)]
    }

    /// Whether the curve passes through the points by its hodographs and is C2 in the knots.
    fn check(curve: &PhCurve, points: &[Point<2>]) -> Result<(), TestCaseError> {
        let spans = curve.spans();
        for (span, segment) in curve.segments().iter().enumerate() {
            let mut end = points[span];
            for leg in segment.hodograph() {
                end = [0, 1].map(|d| end[d] + leg[d] / 5.0);
            }
            let next = points[(span + 1) % points.len()];
            prop_assert!(distance(end, next) < 1e-11, "span {} ends at {:?}, not {:?}", span, end, next);
            prop_assert_eq!(segment.at(0.0)[0], points[span]);
            if span + 1 == spans && !curve.closed() {
                continue;
            }
            let after = &curve.segments()[(span + 1) % spans];
            let ([_, first, second], [_, other, bend]) = (segment.at(1.0), after.at(0.0));
            let (h, k) = (segment.step(), after.step());
            let by_knots = |v: Point<2>, factor: f64| v.map(|x| x / factor);
            prop_assert!(distance(by_knots(first, h), by_knots(other, k)) < 1e-10);
            prop_assert!(distance(by_knots(second, h * h), by_knots(bend, k * k)) < 1e-9 * 300.0);
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn rows_are_interpolated_with_two_derivatives(points in row(), knots in knots()) {
            let curve = PhCurve::spline(knots, CUBIC, &points).unwrap();
            prop_assert_eq!(curve.spans(), points.len() - 1);
            check(&curve, &points)?;
            // The end spans are cubics: w is linear there.
            for segment in [&curve.segments()[0], &curve.segments()[curve.spans() - 1]] {
                let w = segment.preimage();
                let bend = [0, 1].map(|d| w[0][d] - 2.0 * w[1][d] + w[2][d]);
                prop_assert!(distance(bend, [0.0; 2]) < 1e-12 * 10.0);
            }
        }

        #[test]
        fn rings_are_smooth_where_they_close_and_turn_once(points in ring(), knots in knots()) {
            let curve = PhCurve::spline(knots, SplineEnds::Closed, &points).unwrap();
            prop_assert_eq!(curve.spans(), points.len());
            check(&curve, &points)?;
            prop_assert!((curve.turning() - std::f64::consts::TAU).abs() < 1e-10);
        }

        #[test]
        fn end_derivatives_are_kept(points in row(), start in [-90.0..90.0, -90.0..90.0], last: bool) {
            let derivative = SplineEnd::Derivative(start);
            let ends = if last { [SplineEnd::Cubic, derivative] } else { [derivative, SplineEnd::Cubic] };
            // Tangents against the row may have no solution near the cubic spline.
            let Ok(curve) = PhCurve::spline(Knots::Chord, SplineEnds::Open(ends), &points) else { return Ok(()) };
            check(&curve, &points)?;
            let (span, u) = if last { (curve.spans() - 1, 1.0) } else { (0, 0.0) };
            let segment = &curve.segments()[span];
            let got = segment.at(u)[1].map(|x| x / segment.step());
            prop_assert!(distance(got, start) < 1e-11, "{:?} {:?}", got, start);
        }

        #[test]
        fn a_similarity_of_the_points_is_one_of_the_curve(points in row(), map in similarity()) {
            let mapped: Vec<Point<2>> = points.iter().map(|p| map.point(*p)).collect();
            let [plain, mapped] =
                [&points, &mapped].map(|points| PhCurve::spline(Knots::Chord, CUBIC, points).unwrap());
            for span in 0..plain.spans() {
                for k in 0..=4 {
                    let u = f64::from(k) / 4.0;
                    let (p, q) = (plain.eval(span, u).unwrap(), mapped.eval(span, u).unwrap());
                    prop_assert!(distance(map.point(p), q) < 1e-10 * 300.0 * map.scale);
                }
            }
            let sign = if map.mirrored { -1.0 } else { 1.0 };
            prop_assert!((plain.turning() * sign - mapped.turning()).abs() < 1e-10);
        }

        #[test]
        fn any_points_give_a_curve_or_a_sentence(
            points in proptest::collection::vec([-300_i32..300, -300_i32..300], 0..9),
            knots in knots(),
            closed: bool,
            exponent in -140_i32..140,
        ) {
            let scale = 10.0_f64.powi(exponent);
            let points: Vec<Point<2>> = points.iter().map(|p| p.map(|x| f64::from(x) * scale)).collect();
            let ends = if closed { SplineEnds::Closed } else { CUBIC };
            if let Ok(curve) = PhCurve::spline(knots, ends, &points) {
                for span in 0..curve.spans() {
                    let numbers = curve.at(span, 0.3).unwrap();
                    prop_assert!(numbers.iter().flatten().all(|x| x.is_finite()));
                }
                prop_assert!(curve.total_length().is_finite() && curve.turning().is_finite());
            }
        }
    }

    #[test]
    fn a_regular_ring_is_nearly_a_circle() {
        let points: Vec<Point<2>> = (0..6)
            .map(|k| std::f64::consts::PI * f64::from(k) / 3.0)
            .map(|angle| [100.0 * angle.cos(), 100.0 * angle.sin()])
            .collect();
        let curve = PhCurve::spline(Knots::Chord, SplineEnds::Closed, &points).unwrap();
        assert!((curve.absolute_rotation() - 1.0).abs() < 1e-12);
        for k in 0..=20 {
            let place = super::super::Place { span: 2, u: f64::from(k) / 20.0 };
            assert!((curve.curvature(place).unwrap() * 100.0 - 1.0).abs() < 0.03);
        }
    }

    #[test]
    fn two_points_are_a_line_or_a_quintic() {
        let points = [[1.0, 2.0], [4.0, 6.0]];
        let line = PhCurve::spline(Knots::Chord, CUBIC, &points).unwrap();
        assert!((line.total_length() - 5.0).abs() < 1e-14);
        assert!(distance(line.eval(0, 0.25).unwrap(), [1.75, 3.0]) < 1e-14);
        let ends = [[9.0, 0.0], [0.0, 9.0]].map(SplineEnd::Derivative);
        let curve = PhCurve::spline(Knots::Uniform, SplineEnds::Open(ends), &points).unwrap();
        assert_eq!(curve, PhCurve::hermite(Closure::Open, &points, &[[9.0, 0.0], [0.0, 9.0]]).unwrap());
        let one = SplineEnds::Open([SplineEnd::Derivative([9.0, 0.0]), SplineEnd::Cubic]);
        let curve = PhCurve::spline(Knots::Uniform, one, &points).unwrap();
        assert!(distance(curve.at(0, 0.0).unwrap()[1], [9.0, 0.0]) < 1e-13);
    }

    #[test]
    fn bad_input_is_named() {
        let spline = |ends, points: &[Point<2>]| PhCurve::spline(Knots::Chord, ends, points);
        let points = [[0.0, 0.0], [100.0, 50.0], [100.0, 50.0], [200.0, 0.0]];
        assert_eq!(spline(CUBIC, &points), Err(GeometryError::EqualNeighbours { number: 2, next: 3 }));
        let closed = [[0.0, 0.0], [100.0, 50.0], [100.0, 0.0], [0.0, 0.0]];
        let error = spline(SplineEnds::Closed, &closed);
        assert_eq!(error, Err(GeometryError::EqualNeighbours { number: 4, next: 1 }));
        let error = spline(CUBIC, &points[..1]);
        assert_eq!(error, Err(GeometryError::TooFewPoints { given: 1, needed: 2 }));
        let error = spline(SplineEnds::Closed, &closed[..2]);
        assert_eq!(error, Err(GeometryError::TooFewPoints { given: 2, needed: 3 }));
        let bad = SplineEnds::Open([SplineEnd::Cubic, SplineEnd::Derivative([f64::NAN, 0.0])]);
        assert_eq!(spline(bad, &closed), Err(GeometryError::NotFinite { number: 2 }));
    }
}
