//! PH quintics with given end points and end derivatives (Farouki and Neff 1995).

use super::choice::best;
use super::complex::Complex;
use super::curve::PhCurve;
use super::segment::PhSegment;
use crate::geometry::hermite::check_input;
use crate::geometry::method::Closure;
use crate::geometry::point::{check_points, norm, scaled_difference};
use crate::geometry::{GeometryError, Point};

impl PhSegment {
    /// The four PH quintics from `points[0]` to `points[1]` with the derivatives `tangents` there, in the order of
    /// the signs (s, D) = (+,+), (+,-), (-,+), (-,-), and the number of the one to prefer.
    ///
    /// With `w_0^2 = d_0` and `w_2^2 = d_1`, the middle coefficient solves a quadratic equation:
    /// `w_1 = (-3 (w_0 + w_2) +- D) / 4`, `D^2 = 120 (P_1 - P_0) - 15 (w_0^2 + w_2^2) + 10 w_0 w_2`. Preferred is the
    /// least bending energy, then the shortest; where all energies are infinite, the least absolute rotation.
    ///
    /// # Errors
    /// A bad coordinate (points and tangents counted from 1), [`GeometryError::EqualNeighbours`] where points are
    /// equal and tangents zero, so that there is no curve, [`GeometryError::Overflow`].
    pub fn hermite(
        points: [Point<2>; 2],
        tangents: [Point<2>; 2],
    ) -> Result<([Self; 4], usize), GeometryError> {
        check_points(&points)?;
        check_points(&tangents)?;
        quintics(0, points, tangents)
    }
}

impl PhCurve {
    /// PH quintics through `points` with these derivatives, one per point, by every span's parameter in [0, 1]: of
    /// the four on every span the preferred one ([`PhSegment::hermite`]). The curve is C1.
    ///
    /// # Errors
    /// Fewer than 2 points (3 when closed), another number of tangents than points, a bad coordinate in either
    /// (counted from 1), [`GeometryError::EqualNeighbours`] where two successive points are equal and both
    /// tangents zero, [`GeometryError::Overflow`].
    pub fn hermite(
        closure: Closure,
        points: &[Point<2>],
        tangents: &[Point<2>],
    ) -> Result<Self, GeometryError> {
        let segment = |(span, points, tangents)| {
            let (found, number) = quintics(span, points, tangents)?;
            // The number is one of the four.
            let mut found = found.into_iter();
            found.nth(number).ok_or(GeometryError::Overflow { span })
        };
        let spans = ends_of_spans(closure, points, tangents)?;
        Ok(Self::new(closure, spans.map(segment).collect::<Result<_, _>>()?))
    }
}

/// A span's number, end points and end tangents.
pub(super) type SpanEnds<const D: usize> = (usize, [Point<D>; 2], [Point<D>; 2]);

/// The end points and end tangents of every span.
///
/// # Errors
/// As [`PhCurve::hermite`], but for what a span may find wrong.
pub(super) fn ends_of_spans<const D: usize>(
    closure: Closure,
    points: &[Point<D>],
    tangents: &[Point<D>],
) -> Result<impl Iterator<Item = SpanEnds<D>>, GeometryError> {
    check_input(closure, points)?;
    if tangents.len() != points.len() {
        return Err(GeometryError::WrongCount { given: tangents.len(), needed: points.len() });
    }
    check_points(tangents)?;
    let spans = match closure {
        Closure::Open => points.len() - 1,
        Closure::Closed => points.len(),
    };
    Ok((0..spans).map(|span| {
        let next = (span + 1) % points.len();
        (span, [points[span], points[next]], [tangents[span], tangents[next]])
    }))
}

/// The four quintics of a span and the number of the preferred one.
pub(super) fn quintics(
    span: usize,
    points: [Point<2>; 2],
    tangents: [Point<2>; 2],
) -> Result<([PhSegment; 4], usize), GeometryError> {
    let chord = scaled_difference(1.0, points[0], points[1]);
    let size = norm(chord).max(norm(tangents[0])).max(norm(tangents[1]));
    if size == 0.0 {
        return Err(GeometryError::EqualNeighbours { number: span + 1, next: span + 2 });
    }
    let chord = Complex::from(chord);
    let first = Complex::from(tangents[0]).sqrt();
    let candidate = |sign: f64, branch: f64| {
        let last = Complex::from(tangents[1]).sqrt() * sign;
        let under = chord * 120.0 - (first * first + last * last) * 15.0 + first * last * 10.0;
        let middle = ((first + last) * -3.0 + under.sqrt() * branch) * 0.25;
        PhSegment::new(span, 1.0, &[first, middle, last], points)
    };
    let four = [candidate(1.0, 1.0)?, candidate(1.0, -1.0)?, candidate(-1.0, 1.0)?, candidate(-1.0, -1.0)?];
    let number = best(&four, size).unwrap_or(0);
    Ok((four, number))
}

#[cfg(test)]
mod tests {
    use super::super::testing::{distance, point, similarity};
    use super::*;
    use crate::geometry::ParamCurve;
    use proptest::prelude::*;

    /// The end that the hodograph leads to, not the one that was put there.
    fn integrated(segment: &PhSegment) -> Point<2> {
        let mut end = segment.control()[0];
        for leg in segment.hodograph() {
            end = [0, 1].map(|d| end[d] + leg[d] / 5.0);
        }
        end
    }

    proptest! {
        #[test]
        fn all_four_have_the_data(a in point(), b in point(), c in point(), d in point()) {
            let (four, number) = PhSegment::hermite([a, b], [c, d]).unwrap();
            let least = four.iter().filter_map(PhSegment::energy).fold(f64::INFINITY, f64::min);
            prop_assert!(four[number].energy().unwrap() <= least * (1.0 + 1e-8));
            for segment in &four {
                prop_assert!(distance(integrated(segment), b) < 1e-12 * 300.0);
                let ([start, first, _], [end, last, _]) = (segment.at(0.0), segment.at(1.0));
                prop_assert_eq!((start, end), (a, b));
                prop_assert!(distance(first, c) < 1e-13 * 100.0 && distance(last, d) < 1e-13 * 100.0);
            }
        }

        #[test]
        fn a_similarity_of_the_data_is_one_of_the_curve(
            a in point(), b in point(), c in point(), d in point(), map in similarity(),
        ) {
            let plain = PhCurve::hermite(Closure::Open, &[a, b], &[c, d]).unwrap();
            let ends = [a, b].map(|p| map.point(p));
            let mapped = PhCurve::hermite(Closure::Open, &ends, &[c, d].map(|v| map.vector(v))).unwrap();
            let size = 300.0 * map.scale;
            // Two solutions may be equally good, or equal but for rounding where the root vanishes.
            let (four, number) = PhSegment::hermite([a, b], [c, d]).unwrap();
            let energy = four[number].energy().unwrap();
            let others = four.iter().enumerate().filter(|(k, _)| *k != number);
            prop_assume!(others.filter_map(|(_, it)| it.energy()).all(|other| other > energy * 1.01));
            for k in 0..=8 {
                let u = f64::from(k) / 8.0;
                let (p, q) = (plain.eval(0, u).unwrap(), mapped.eval(0, u).unwrap());
                prop_assert!(distance(map.point(p), q) < 1e-9 * size, "{} {:?} {:?}", u, map.point(p), q);
            }
            prop_assert!((plain.total_length() * map.scale - mapped.total_length()).abs() < 1e-9 * size);
        }
    }

    #[test]
    fn a_row_is_smooth_and_may_be_closed() {
        let points = [[300.0, 190.0], [200.0, 290.0], [100.0, 190.0], [200.0, 90.0]];
        let tangents = [[0.0, 150.0], [-150.0, 0.0], [0.0, -150.0], [150.0, 0.0]];
        let curve = PhCurve::hermite(Closure::Closed, &points, &tangents).unwrap();
        assert_eq!((curve.spans(), curve.closed(), curve.joints()), (4, true, points.to_vec()));
        for span in 0..4 {
            let [[p, first, _], [q, last, _]] =
                [curve.at(span, 1.0), curve.at((span + 1) % 4, 0.0)].map(Option::unwrap);
            assert!(distance(p, q) == 0.0 && distance(first, last) < 1e-12);
        }
        assert!((curve.turning() - std::f64::consts::TAU).abs() < 1e-13);
    }

    #[test]
    fn bad_input_is_named() {
        let origin = [0.0; 2];
        let nothing = PhCurve::hermite(Closure::Open, &[origin, origin], &[origin, origin]);
        assert_eq!(nothing, Err(GeometryError::EqualNeighbours { number: 1, next: 2 }));
        let few = PhCurve::hermite(Closure::Open, &[origin], &[origin]);
        assert_eq!(few, Err(GeometryError::TooFewPoints { given: 1, needed: 2 }));
        let short = PhCurve::hermite(Closure::Open, &[origin, [1.0, 0.0]], &[[1.0, 0.0]]);
        assert_eq!(short, Err(GeometryError::WrongCount { given: 1, needed: 2 }));
        let bad = PhSegment::hermite([origin, [f64::NAN, 0.0]], [[1.0, 0.0]; 2]);
        assert_eq!(bad, Err(GeometryError::NotFinite { number: 2 }));
        let far = PhSegment::hermite([origin, [1e150, 0.0]], [[1e150, 1e150]; 2]);
        assert!(far.is_ok() || far == Err(GeometryError::Overflow { span: 0 }));
        // Equal points with tangents are a loop.
        assert!(PhSegment::hermite([origin, origin], [[1.0, 0.0], [0.0, 1.0]]).is_ok());
    }
}
