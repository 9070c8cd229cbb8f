//! Slopes of curves along x, and those of the curves that smooth measured points.
//!
//! A derivative makes noise worse, so that measured points are smoothed above all for their slopes (section 2.3.8).

use super::binomial::equal_steps;
use super::point::scaled_difference;
use super::smooth::spline_points;
use super::{Closure, Curve, GeometryError, ParamCurve, Point, Smoothing, Stage};

/// What rounding leaves of a run of zero, relative to the rise.
const UPRIGHT: f64 = 1e-12;

/// The slopes of a curve with this tangent: dy/dx, in space dz/dx too. There is none where the curve stands still or
/// goes straight up, as far as doubles can tell.
///
/// ```
/// use grafika::geometry::slopes;
///
/// assert_eq!(slopes([2.0, 1.0]), [Some(0.5)]);
/// assert_eq!(slopes([2.0, 1.0, -4.0]), [Some(0.5), Some(-2.0)]);
/// assert_eq!(slopes([0.0, 1.0]), [None]);
/// ```
#[must_use]
pub fn slopes<const D: usize>(tangent: Point<D>) -> Vec<Option<f64>> {
    let largest = tangent.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let Some((&run, rises)) = tangent.split_first() else { return Vec::new() };
    let steep = run.abs() <= UPRIGHT * largest;
    rises.iter().map(|rise| Some(rise / run).filter(|slope| !steep && slope.is_finite())).collect()
}

/// The tangents of the curve that smooths, at the smoothed points of [`smooth`](super::smooth()), by its own
/// parameter: their directions and slopes mean something, their lengths do not. Where the cubic B-spline stands
/// still, in its ends, it is the side of the polygon, which it leaves along.
///
/// # Errors
/// Those of [`smooth`](super::smooth()).
pub fn smoothed_tangents<const D: usize>(
    measured: &[Point<D>],
    smoothing: Smoothing,
) -> Result<Vec<Point<D>>, GeometryError> {
    smoothing.check(measured)?;
    let Smoothing { degree, stage, density } = smoothing;
    match stage {
        Stage::BSpline => {
            let n = measured.len();
            let curve = Curve::through(degree.method(), Closure::Open, measured)?;
            let last = curve.spans().saturating_sub(1);
            let tangent = |index: usize| {
                let t = degree.parameter(index, n);
                // Not negative and at most the number of spans; the end belongs to the last one.
                let span = (t as usize).min(last);
                let tangent = curve.at(span, t - span as f64).map_or([0.0; D], |[_, tangent, _]| tangent);
                if tangent == [0.0; D] { side(measured, index) } else { tangent }
            };
            Ok((0..n).map(tangent).collect())
        }
        Stage::Bezier => Ok(bezier_tangents(measured.to_vec(), measured.len())),
        Stage::Both => Ok(bezier_tangents(spline_points(measured, degree, density)?, measured.len())),
    }
}

/// The side of the polygon that begins at a point, and the last one at the last point.
fn side<const D: usize>(points: &[Point<D>], index: usize) -> Point<D> {
    let from = index.min(points.len().saturating_sub(2));
    match points.get(from..from + 2) {
        Some([from, to]) => std::array::from_fn(|d| to[d] - from[d]),
        _ => [0.0; D],
    }
}

/// The tangents at `0, 1 / (n - 1), ..., 1` of the Bézier curve by these control points.
fn bezier_tangents<const D: usize>(mut control: Vec<Point<D>>, n: usize) -> Vec<Point<D>> {
    // The derivative is the curve by the sides of the polygon, times the degree.
    let degree = control.len().saturating_sub(1) as f64;
    for k in 1..control.len() {
        control[k - 1] = scaled_difference(degree, control[k - 1], control[k]);
    }
    control.pop();
    equal_steps(&control, n)
}

#[cfg(test)]
mod tests {
    use super::super::{Bezier, Degree, smooth};
    use super::*;
    use proptest::prelude::*;

    const STAGES: [Stage; 3] = [Stage::BSpline, Stage::Bezier, Stage::Both];

    #[test]
    fn steep_and_resting_places_have_no_slope() {
        assert_eq!(slopes([1e-17, 1.0]), [None]);
        assert_eq!(slopes([0.0, 0.0]), [None]);
        assert_eq!(slopes([-1.0, 0.0, 3.0]), [Some(-0.0), Some(-3.0)]);
        assert_eq!(slopes([1e-300, 1e-300]), [Some(1.0)]);
    }

    #[test]
    fn what_cannot_be_smoothed_has_no_tangents() {
        let two = [[0.0, 1.0], [1.0, 2.0]];
        let smoothing = Smoothing::default();
        assert_eq!(smoothed_tangents(&two, smoothing).unwrap_err(), smooth(&two, smoothing).unwrap_err());
        let three = [[0.0, 1.0], [1.0, 2.0], [2.0, 0.0]];
        assert!(smoothed_tangents(&three, Smoothing { density: 0, ..smoothing }).is_err());
    }

    proptest! {
        #[test]
        fn a_straight_line_keeps_its_slope(slope in -5.0..5.0f64, n in 3usize..40, density in 1usize..6) {
            let line: Vec<Point<2>> = (0..n).map(|i| [3.0 * i as f64, 7.0 + slope * 3.0 * i as f64]).collect();
            for stage in STAGES {
                for degree in [Degree::Quadratic, Degree::Cubic] {
                    for tangent in smoothed_tangents(&line, Smoothing { degree, stage, density }).unwrap() {
                        let [Some(found)] = slopes(tangent)[..] else { panic!("{tangent:?}") };
                        prop_assert!((found - slope).abs() < 1e-9, "{found} {slope}");
                    }
                }
            }
        }

        #[test]
        fn tangents_are_those_of_differences(
            heights in prop::collection::vec(-50.0..50.0f64, 4..20),
            density in 1usize..4,
        ) {
            // The tangents are linear in the points: a Bézier curve by differences of points is the other way to them.
            let points: Vec<Point<2>> = (0..).zip(&heights).map(|(i, &y)| [f64::from(i), y]).collect();
            let smoothing = Smoothing { density, ..Smoothing::default() };
            let control = spline_points(&points, Degree::Cubic, density).unwrap();
            let legs: Vec<Point<2>> =
                control.windows(2).map(|p| [p[1][0] - p[0][0], p[1][1] - p[0][1]]).collect();
            let hodograph = Bezier::new(Closure::Open, &legs).unwrap();
            for (i, tangent) in smoothed_tangents(&points, smoothing).unwrap().into_iter().enumerate() {
                let [dx, dy] = hodograph.eval(i as f64 / (points.len() - 1) as f64);
                prop_assert!((tangent[0] * dy - tangent[1] * dx).abs() < 1e-8 * (1.0 + tangent[1].abs()));
            }
        }
    }
}
