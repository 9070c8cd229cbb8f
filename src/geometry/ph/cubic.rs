//! PH cubics with given end points and end directions.

use super::choice::gentlest;
use super::complex::Complex;
use super::curve::PhCurve;
use super::hermite::ends_of_spans;
use super::segment::PhSegment;
use crate::geometry::method::Closure;
use crate::geometry::point::{check_points, norm, scaled_difference};
use crate::geometry::{GeometryError, Point};
use std::f64::consts::{PI, TAU};

impl PhSegment {
    /// The PH cubics from `points[0]` to `points[1]` with the directions of `tangents` there, whose lengths do not
    /// matter: one or two, the preferred one first (least absolute rotation, then bending energy, then the shortest). They are arcs of
    /// Tschirnhausen's cubic, which has no inflection.
    ///
    /// # Errors
    /// A bad coordinate (points and tangents counted from 1), [`GeometryError::NoDirection`] for a zero tangent,
    /// [`GeometryError::EqualNeighbours`], [`GeometryError::NoPhCubic`] where there is none,
    /// [`GeometryError::Overflow`].
    pub fn cubics(points: [Point<2>; 2], tangents: [Point<2>; 2]) -> Result<Vec<Self>, GeometryError> {
        check_points(&points)?;
        check_points(&tangents)?;
        cubics(0, points, tangents, [1, 2])
    }
}

impl PhCurve {
    /// PH cubics through `points` with the directions of `tangents`, one per point: on every span the preferred one
    /// ([`PhSegment::cubics`]). The curve is G1.
    ///
    /// # Errors
    /// Fewer than 2 points (3 when closed), another number of tangents than points, a bad coordinate in either
    /// (counted from 1), [`GeometryError::EqualNeighbours`], [`GeometryError::NoDirection`],
    /// [`GeometryError::NoPhCubic`] naming the first span without one, [`GeometryError::Overflow`].
    pub fn cubics(
        closure: Closure,
        points: &[Point<2>],
        tangents: &[Point<2>],
    ) -> Result<Self, GeometryError> {
        let segment = |(span, ends, directions)| {
            let numbers = [span + 1, (span + 1) % points.len() + 1];
            let found = cubics(span, ends, directions, numbers)?;
            // There is at least one.
            found.into_iter().next().ok_or(GeometryError::NoPhCubic { number: span + 1 })
        };
        let spans = ends_of_spans(closure, points, tangents)?;
        Ok(Self::new(closure, spans.map(segment).collect::<Result<_, _>>()?))
    }
}

/// All cubics of a span, the preferred one first; `numbers` are those of the points, from 1.
fn cubics(
    span: usize,
    points: [Point<2>; 2],
    tangents: [Point<2>; 2],
    [number, next]: [usize; 2],
) -> Result<Vec<PhSegment>, GeometryError> {
    for (tangent, number) in tangents.iter().zip([number, next]) {
        if norm(*tangent) == 0.0 {
            return Err(GeometryError::NoDirection { number });
        }
    }
    let chord = scaled_difference(1.0, points[0], points[1]);
    let size = norm(chord);
    if size == 0.0 {
        return Err(GeometryError::EqualNeighbours { number, next });
    }
    // Lengths by the chord's, so that nothing overflows.
    let chord = Complex::from(chord.map(|x| x / size));
    let [from, to] = tangents.map(|[x, y]| y.atan2(x));
    let mut found = Vec::new();
    for to in [to, to - TAU, to + TAU] {
        for [a, b] in lengths(from, to, chord) {
            let w = [Complex::unit(0.5 * from) * a.sqrt(), Complex::unit(0.5 * to) * b.sqrt()];
            found.push(PhSegment::new(span, 1.0, &w.map(|value| value * size.sqrt()), points)?);
        }
    }
    let Some(first) = gentlest(&found, size) else { return Err(GeometryError::NoPhCubic { number }) };
    found.swap(0, first);
    Ok(found)
}

/// The end speeds `[|w_0|^2, |w_1|^2]` of the cubics whose tangents turn from one angle to the other, by the shortest
/// way between these very angles.
///
/// In the frame of the mean angle the chord is `C + i S`. With half the turn `phi`, the sum `s` and the difference
/// `delta` of the end speeds, integration gives `delta sin(phi) = 3 S` and
/// `s cos(phi) + sqrt(s^2 - delta^2) / 2 = 3 C`; squared, it is a quadratic equation for `s`.
fn lengths(from: f64, to: f64, chord: Complex) -> Vec<[f64; 2]> {
    let (mean, phi) = (0.5 * (from + to), 0.5 * (to - from));
    if phi.abs() >= PI {
        return Vec::new();
    }
    let Complex { re: along, im: across } = chord * Complex::unit(-mean);
    let (sin, cos) = phi.sin_cos();
    if sin.abs() < STRAIGHT {
        let straight = across.abs() < STRAIGHT && along > 0.0;
        return if straight { vec![[along, along]] } else { Vec::new() };
    }
    let delta = 3.0 * across / sin;
    let [a, b, c] = [0.25 - cos * cos, 6.0 * along * cos, -(9.0 * along * along + 0.25 * delta * delta)];
    let mut sums = if a.abs() < 1e-12 {
        vec![-c / b]
    } else {
        let under = b * b - 4.0 * a * c;
        // A double solution may be negative by rounding; the quotients below are its two forms.
        let root = if under < 0.0 && under > -1e-14 * b * b { 0.0 } else { under.sqrt() };
        let q = -0.5 * (b + root.copysign(b));
        vec![q / a, c / q]
    };
    sums.retain(|sum| {
        // Comparisons also drop what is not a number.
        *sum > delta.abs() && 3.0 * along - sum * cos >= -1e-14 * sum && sum.is_finite()
    });
    if let [first, second] = sums[..]
        && first == second
    {
        sums.truncate(1);
    }
    sums.into_iter().map(|sum| [0.5 * (sum - delta), 0.5 * (sum + delta)]).collect()
}

/// Angles, and parts of the unit chord, below this are zero: the tangents lie on the chord.
const STRAIGHT: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::super::testing::{distance, point};
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn cubics_have_the_data_and_the_right_form(a in point(), b in point(), c in point(), d in point()) {
            let found = match PhSegment::cubics([a, b], [c, d]) {
                Ok(found) => found,
                Err(error) => {
                    prop_assert_eq!(error, GeometryError::NoPhCubic { number: 1 });
                    return Ok(());
                }
            };
            prop_assert!(found.len() <= 2);
            for segment in &found {
                let control = segment.control();
                let size = control.windows(2).map(|leg| distance(leg[0], leg[1])).fold(distance(a, b), f64::max);
                let mut end = a;
                for leg in segment.hodograph() {
                    end = [0, 1].map(|d| end[d] + leg[d] / 3.0);
                }
                prop_assert!(distance(end, b) < 1e-8 * size, "{:?} {:?}", end, b);
                let legs: Vec<Complex> =
                    segment.hodograph().windows(1).map(|leg| Complex::from(leg[0])).collect();
                for (leg, tangent) in [(legs[0], c), (legs[2], d)] {
                    let tangent = Complex::from(tangent);
                    prop_assert!(leg.dot(tangent) > 0.0);
                    prop_assert!(leg.cross(tangent).abs() < 1e-12 * leg.norm() * tangent.norm());
                }
                // Geometric means and equal angles make a cubic a PH cubic.
                let middle = legs[1].norm_squared() - legs[0].norm() * legs[2].norm();
                prop_assert!(middle.abs() < 1e-11 * size * size);
                prop_assert!((legs[0].angle_to(legs[1]) - legs[1].angle_to(legs[2])).sin().abs() < 1e-6);
            }
        }
    }

    #[test]
    fn the_analytic_cubic_is_found() {
        // w = 1 + i c t on [-T, T]: x = t - c^2 t^3 / 3, y = c t^2.
        let (c, end) = (0.3_f64, 1.7_f64);
        let at = |t: f64| [t - c * c * t.powi(3) / 3.0, c * t * t];
        let slope = |t: f64| [1.0 - c * c * t * t, 2.0 * c * t];
        let found = PhSegment::cubics([at(-end), at(end)], [slope(-end), slope(end)]).unwrap();
        let best = found.iter().min_by(|a, b| {
            let off = |segment: &PhSegment| distance(segment.at(0.5)[0], at(0.0));
            off(a).total_cmp(&off(b))
        });
        let segment = best.unwrap();
        for k in 0..=10 {
            let u = f64::from(k) / 10.0;
            let t = end * (2.0 * u - 1.0);
            assert!(distance(segment.at(u)[0], at(t)) < 1e-14 * 4.0);
            let curvature = 2.0 * c / (1.0 + c * c * t * t).powi(2);
            assert!((segment.curvature(u).unwrap() - curvature).abs() < 1e-13);
        }
        let length = 2.0 * (end + c * c * end.powi(3) / 3.0);
        let curve = PhCurve::new(Closure::Open, vec![segment.clone()]);
        assert!((curve.total_length() - length).abs() < 1e-14 * length);
        assert!(segment.inflections().is_empty());
        let extrema = segment.curvature_extrema();
        assert!(extrema.len() == 1 && (extrema[0] - 0.5).abs() < 1e-14);
    }

    #[test]
    fn the_way_round_a_large_loop_is_not_preferred() {
        // The loop of length 2113.8 has the smaller energy, but turns twice as far.
        let found =
            PhSegment::cubics([[200.0, 300.0], [360.0, 300.0]], [[150.0, -225.0], [150.0, 225.0]]).unwrap();
        let length = |at: usize| PhCurve::new(Closure::Open, vec![found[at].clone()]).total_length();
        assert!(found.len() == 2 && (length(0) - 193.776408).abs() < 1e-6 && length(1) > 2000.0);
        assert!(found[0].energy() > found[1].energy());
    }

    #[test]
    fn shapes_that_need_an_inflection_are_refused() {
        let chord = [[0.0, 0.0], [100.0, 0.0]];
        let none = PhSegment::cubics(chord, [[1.0, 0.5], [1.0, 0.5]]);
        assert_eq!(none, Err(GeometryError::NoPhCubic { number: 1 }));
        let straight = PhSegment::cubics(chord, [[2.0, 0.0], [5.0, 0.0]]).unwrap();
        assert!(distance(straight[0].at(0.5)[0], [50.0, 0.0]) < 1e-13);
        let zero = PhSegment::cubics(chord, [[1.0, 0.0], [0.0, 0.0]]);
        assert_eq!(zero, Err(GeometryError::NoDirection { number: 2 }));
        let same = PhSegment::cubics([[1.0, 1.0]; 2], [[1.0, 0.0]; 2]);
        assert_eq!(same, Err(GeometryError::EqualNeighbours { number: 1, next: 2 }));
        let points = [[0.0, 0.0], [100.0, 0.0], [200.0, 0.0]];
        let second = PhCurve::cubics(Closure::Open, &points, &[[1.0, 1.0], [1.0, -1.0], [1.0, -0.9]]);
        assert_eq!(second, Err(GeometryError::NoPhCubic { number: 2 }));
    }
}
