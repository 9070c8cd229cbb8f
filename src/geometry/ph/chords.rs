//! Straight moves along a curve for machines that know no other.

use crate::geometry::param::check_tolerance;
use crate::geometry::{GeometryError, MAX_SAMPLES, ParamCurve, Point, norm};

/// Where a chord is compared with its curve.
const COMPARED: [f64; 5] = [0.125, 0.25, 0.5, 0.75, 0.875];
/// A span is halved at least so often, so that no wave is overlooked.
const FEWEST_HALVINGS: u32 = 2;
/// A span is halved at most so often.
const MOST_HALVINGS: u32 = 40;

/// The corners of a polyline along a curve whose chords are nowhere further from it than `error`, in the unit of the
/// points: every span is halved until five points of it are near enough.
///
/// # Errors
/// [`GeometryError::Parameter`] for an error that is not positive, [`GeometryError::Samples`] for more than
/// [`MAX_SAMPLES`] chords.
pub fn chords<const D: usize>(curve: &dyn ParamCurve<D>, error: f64) -> Result<Vec<Point<D>>, GeometryError> {
    check_tolerance(error)?;
    let mut corners = Vec::new();
    for span in 0..curve.spans() {
        let point = |u: f64| curve.eval(span, u).unwrap_or([0.0; D]);
        if corners.is_empty() {
            corners.push(point(0.0));
        }
        let mut waiting = vec![([0.0, 1.0], 0)];
        while let Some(([from, to], depth)) = waiting.pop() {
            let ends = [from, to].map(point);
            let away = |t: &f64| distance_from(point(from + t * (to - from)), ends) > error;
            let halve = depth < FEWEST_HALVINGS || (depth < MOST_HALVINGS && COMPARED.iter().any(away));
            if halve {
                let middle = 0.5 * (from + to);
                waiting.extend([([middle, to], depth + 1), ([from, middle], depth + 1)]);
            } else {
                corners.push(ends[1]);
            }
            if corners.len() > MAX_SAMPLES {
                return Err(GeometryError::Samples { per_span: corners.len(), most: MAX_SAMPLES });
            }
        }
    }
    Ok(corners)
}

/// The distance of a point from a straight piece.
fn distance_from<const D: usize>(point: Point<D>, [start, end]: [Point<D>; 2]) -> f64 {
    let along: Point<D> = std::array::from_fn(|d| end[d] - start[d]);
    let length = norm(along);
    let from: Point<D> = std::array::from_fn(|d| point[d] - start[d]);
    if length == 0.0 {
        return norm(from);
    }
    let share: f64 = (0..D).map(|d| from[d] / length * (along[d] / length)).sum();
    let share = share.clamp(0.0, 1.0);
    norm(std::array::from_fn::<f64, D, _>(|d| from[d] - share * along[d]))
}

#[cfg(test)]
mod tests {
    use super::super::{Knots, PhCurve, SplineEnds};
    use super::*;

    #[test]
    fn chords_keep_to_the_error() {
        let points: Vec<Point<2>> = (0..6)
            .map(|k| std::f64::consts::PI * f64::from(k) / 3.0)
            .map(|angle| [100.0 * angle.cos(), 100.0 * angle.sin()])
            .collect();
        let ring = PhCurve::spline(Knots::Chord, SplineEnds::Closed, &points).unwrap();
        let mut last = 0;
        for error in [1.0, 0.1, 0.01, 0.001] {
            let corners = chords(&ring, error).unwrap();
            assert!(corners.len() > last && corners.first() == Some(&points[0]));
            last = corners.len();
            // All corners lie on the curve, whose radius is 100 within a hundredth.
            for pair in corners.windows(2) {
                let middle = [0, 1].map(|d| 0.5 * (pair[0][d] + pair[1][d]));
                let sagitta = 100.0 - norm(middle);
                assert!(sagitta < error + 0.6 && norm(pair[0]) > 99.0);
            }
        }
        // The sagitta of a chord c is c^2 / 8 r: so many chords are needed, and at most twice as many come out.
        let fewest = std::f64::consts::TAU * 100.0 / (8.0 * 100.0 * 0.001_f64).sqrt();
        assert!((fewest..3.0 * fewest).contains(&(last as f64)), "{last} {fewest}");
        assert!(chords(&ring, 0.0).is_err() && chords(&ring, f64::NAN).is_err());
    }

    #[test]
    fn distances_from_a_piece() {
        let piece = [[0.0, 0.0], [10.0, 0.0]];
        assert_eq!(distance_from([5.0, 3.0], piece), 3.0);
        assert_eq!(distance_from([13.0, 4.0], piece), 5.0);
        assert_eq!(distance_from([3.0, 4.0], [[0.0, 0.0]; 2]), 5.0);
    }
}
