//! B-splines of any degree by their control points alone: knots by a rule, or given (2.50)-(2.54).

use super::{KnotCurve, KnotError, KnotVector};
use crate::geometry::ph::Knots;
use crate::geometry::point::{check_count, norm, scaled_difference};
use crate::geometry::{Closure, Curve, GeometryError, Method, ParamCurve, Point};

/// The degrees that a B-spline by a rule has.
pub const DEGREES: std::ops::RangeInclusive<usize> = 1..=5;

/// Where the knots of a B-spline come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KnotSource<'a> {
    /// A rule. By equal steps, degrees 2 and 3 are the book's B-splines (2.57), (2.58), and degrees from 3 on begin and
    /// end as the cubic one does, in end points that count as often as the degree. By chords, every control point has
    /// its place along the polygon in the middle of its function: knots are means of as many places as the degree, and
    /// those of the ends of open curves are as many times there as the order.
    By(Knots),
    /// All knots of an open curve, points + degree + 1 of them; of a closed one its breaks, points + 1.
    Given(&'a [f64]),
}

/// The B-spline of a degree by these control points. A closed one begins near its first point.
///
/// # Errors
/// A degree out of [`DEGREES`], a wrong number of points or knots, knots that descend or are too many in one place,
/// points that all lie in one place for knots by chords, and a bad coordinate.
///
/// ```
/// use grafika::geometry::knots::{KnotSource, bspline};
/// use grafika::geometry::{Closure, ParamCurve, ph::Knots};
///
/// let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0], [5.0, 1.0]];
/// let quartic = bspline(4, Closure::Open, KnotSource::Given(&[0., 0., 0., 0., 0., 1., 1., 1., 1., 1.]), &points)?;
/// assert_eq!((quartic.spans(), quartic.eval(0, 1.0)), (1, Some([5.0, 1.0])));
/// let polygon = bspline(1, Closure::Closed, KnotSource::By(Knots::Chord), &points)?;
/// assert_eq!(polygon.joints(), points);
/// # Ok::<(), grafika::geometry::knots::KnotError>(())
/// ```
pub fn bspline<const D: usize>(
    degree: usize,
    closure: Closure,
    source: KnotSource<'_>,
    points: &[Point<D>],
) -> Result<Box<dyn ParamCurve<D>>, KnotError> {
    if !DEGREES.contains(&degree) {
        let wanted = "a whole number from 1 to 5";
        return Err(GeometryError::Parameter { name: "degree", value: degree as f64, wanted }.into());
    }
    let known = match degree {
        2 => Some(Method::BSpline2),
        3 => Some(Method::BSpline3),
        _ => None,
    };
    if let (Some(method), KnotSource::By(Knots::Uniform)) = (known, source) {
        return Ok(Box::new(Curve::through(method, closure, points)?));
    }
    Ok(Box::new(by_knots(degree, closure, source, points)?))
}

/// The curve by its knots.
fn by_knots<const D: usize>(
    degree: usize,
    closure: Closure,
    source: KnotSource<'_>,
    points: &[Point<D>],
) -> Result<KnotCurve<D>, KnotError> {
    let (order, n) = (degree + 1, points.len());
    if let KnotSource::Given(knots) = source {
        let needed = if closure == Closure::Closed { n + 1 } else { n + order };
        if knots.len() != needed {
            let given = knots.len();
            return Err(GeometryError::KnotNumber { given, needed, points: n, degree }.into());
        }
    }
    match closure {
        Closure::Closed => {
            check_count(n, order.max(3))?;
            // The curve begins in the middle of what its first point reaches.
            let turned: Vec<Point<D>> = (0..n).map(|i| points[(i + n - degree / 2) % n]).collect();
            let breaks = match source {
                KnotSource::Given(knots) => knots.to_vec(),
                KnotSource::By(rule) => closed_breaks(degree, &places(rule, closure, &turned)?),
            };
            KnotCurve::new(KnotVector::closed(order, &breaks)?, turned)
        }
        Closure::Open => match source {
            KnotSource::By(Knots::Uniform) => {
                check_count(n, 2)?;
                let more = degree - 1;
                let (first, last) = (points.first().into_iter(), points.last().into_iter());
                let ends = |end: &Point<D>| std::iter::repeat_n(*end, more);
                let held: Vec<Point<D>> =
                    first.flat_map(ends).chain(points.iter().copied()).chain(last.flat_map(ends)).collect();
                KnotCurve::new(KnotVector::uniform(order, held.len())?, held)
            }
            KnotSource::By(rule) => {
                check_count(n, order)?;
                let places = places(rule, closure, points)?;
                KnotCurve::new(KnotVector::new(order, open_knots(degree, &places))?, points.to_vec())
            }
            KnotSource::Given(knots) => {
                check_count(n, order)?;
                KnotCurve::new(KnotVector::new(order, knots.to_vec())?, points.to_vec())
            }
        },
    }
}

/// The places of the points along the polygon, from 0 in steps of mean 1; of a closed one the place of the first point
/// after one turn as well.
fn places<const D: usize>(rule: Knots, closure: Closure, points: &[Point<D>]) -> Result<Vec<f64>, KnotError> {
    crate::geometry::point::check_points(points)?;
    let seam = points.first().filter(|_| closure == Closure::Closed);
    let nexts = points.iter().skip(1).chain(seam);
    let chords: Vec<f64> =
        points.iter().zip(nexts).map(|(&a, &b)| norm(scaled_difference(1.0, a, b))).collect();
    if !chords.iter().any(|chord| *chord > 0.0) {
        return Err(KnotError::NoSpan);
    }
    let mut at = 0.0;
    let steps = rule.steps(&chords).into_iter().map(|step| {
        at += step;
        at
    });
    Ok(std::iter::once(0.0).chain(steps).collect())
}

/// Knots whose inner ones are means of so many places.
fn open_knots(degree: usize, places: &[f64]) -> Vec<f64> {
    let (first, last) = (places[0], places[places.len() - 1]);
    let inner = places.len().saturating_sub(degree + 1);
    let mean = |j: usize| places[j + 1..=j + degree].iter().sum::<f64>() / degree as f64;
    let end = |value: f64| std::iter::repeat_n(value, degree + 1);
    end(first).chain((0..inner).map(mean)).chain(end(last)).collect()
}

/// The breaks of a closed curve, means of so many places each, so that control point `i`, whose function has the knots
/// from break `i - degree` to `i + 1`, is at home in place `i`.
fn closed_breaks(degree: usize, places: &[f64]) -> Vec<f64> {
    let n = places.len() - 1;
    let period = places[n] - places[0];
    let place = |k: usize| places[k % n] + period * (k / n) as f64;
    (0..=n).map(|k| (k..k + degree).map(place).sum::<f64>() / degree as f64).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Basis;
    use proptest::prelude::*;

    fn rows() -> impl Strategy<Value = Vec<Point<2>>> {
        prop::collection::vec(prop::array::uniform2(-100.0..100.0f64), 6..12)
    }

    fn near(a: Point<2>, b: Point<2>) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9)
    }

    #[test]
    fn what_is_wrong_is_told() {
        let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
        let said = |degree, source| bspline(degree, Closure::Open, source, &points).unwrap_err().to_string();
        let uniform = KnotSource::By(Knots::Uniform);
        assert!(said(0, uniform).contains("degree is 0") && said(6, uniform).contains("degree is 6"));
        let few = said(3, KnotSource::Given(&[0.0, 1.0]));
        assert_eq!(few, "2 knots given, but 4 control points need exactly 8 knots at degree 3");
        assert!(said(2, KnotSource::Given(&[0.0, 0.0, 0.0, 2.0, 1.0, 1.0, 1.0])).contains("knot"));
        assert!(said(5, KnotSource::By(Knots::Chord)).contains("at least 6 needed"));
        assert_eq!(
            bspline(2, Closure::Open, KnotSource::By(Knots::Chord), &[[1.0, 1.0]; 5]).unwrap_err(),
            KnotError::NoSpan
        );
    }

    proptest! {
        #[test]
        fn equal_steps_by_knots_are_the_books_curves(points in rows()) {
            // By hand: the knots of (2.57) are clamped, the cubic's end points are threefold.
            for closure in [Closure::Open, Closure::Closed] {
                let cubic = by_knots(3, closure, KnotSource::By(Knots::Uniform), &points).unwrap();
                let theirs = Curve::through(Method::BSpline3, closure, &points).unwrap();
                prop_assert_eq!(cubic.spans(), theirs.spans());
                for span in 0..cubic.spans() {
                    for u in [0.0, 0.3, 1.0] {
                        prop_assert!(near(cubic.eval(span, u).unwrap(), theirs.eval(span, u).unwrap()));
                    }
                }
            }
            let quadratic = Curve::through(Method::BSpline2, Closure::Open, &points).unwrap();
            let clamped = KnotVector::clamped(3, points.len()).unwrap();
            let ours = bspline(2, Closure::Open, KnotSource::Given(clamped.knots()), &points).unwrap();
            for span in 0..ours.spans() {
                prop_assert!(near(ours.eval(span, 0.4).unwrap(), quadratic.eval(span, 0.4).unwrap()));
            }
            let closed = by_knots(2, Closure::Closed, KnotSource::By(Knots::Uniform), &points).unwrap();
            let theirs = Curve::through(Method::BSpline2, Closure::Closed, &points).unwrap();
            for span in 0..theirs.spans() {
                prop_assert!(near(closed.eval(span, 0.7).unwrap(), theirs.eval(span, 0.7).unwrap()));
            }
        }

        #[test]
        fn degree_1_is_the_polygon(points in rows(), closed in any::<bool>(), rule in 0usize..3) {
            let closure = if closed { Closure::Closed } else { Closure::Open };
            let rule = Knots::ALL[rule].1;
            let curve = bspline(1, closure, KnotSource::By(rule), &points).unwrap();
            prop_assert_eq!(curve.joints().len(), points.len());
            for (joint, point) in curve.joints().into_iter().zip(&points) {
                prop_assert!(near(joint, *point));
            }
            for span in 0..curve.spans() {
                let (a, b) = (points[span], points[(span + 1) % points.len()]);
                let middle = [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
                prop_assert!(near(curve.eval(span, 0.5).unwrap(), middle));
            }
        }

        #[test]
        fn places_of_the_points_are_means_of_knots(points in rows(), degree in 1usize..=5, closed in any::<bool>()) {
            // Greville's abscissae: the function x(t) = t is reproduced where they are the coefficients. By chords
            // they are the places of the points smoothed twice; what is checked is that they ascend strictly with them.
            let closure = if closed { Closure::Closed } else { Closure::Open };
            let curve = by_knots(degree, closure, KnotSource::By(Knots::Chord), &points).unwrap();
            let knots = curve.vector().knots();
            let greville = |i: usize| knots[i + 1..=i + degree].iter().sum::<f64>() / degree as f64;
            let count = curve.vector().controls();
            prop_assert!((1..count).all(|i| greville(i) > greville(i - 1)));
            if !closed {
                prop_assert!(near(curve.eval(0, 0.0).unwrap(), points[0]));
                let last = curve.spans() - 1;
                prop_assert!(near(curve.eval(last, 1.0).unwrap(), points[points.len() - 1]));
            }
        }

        #[test]
        fn derivatives_below_the_degree_go_on_over_single_knots(
            points in rows(),
            degree in 2usize..=5,
            steps in prop::collection::vec(0.2..3.0f64, 24),
            closed in any::<bool>(),
        ) {
            // Of polynomials p and q of degree d on either side of a knot, whose first d - 1 derivatives agree there,
            // the difference is c (t - knot)^d: the divided difference of order d - 1 of p - q over any d places,
            // halved steps towards the knot, shrinks as the distance; here it is compared with that of one side.
            let n = points.len();
            let count = if closed { n + 1 } else { n + degree + 1 };
            let knots: Vec<f64> = steps.iter().scan(0.0, |at, step| { *at += step; Some(*at) }).take(count).collect();
            let closure = if closed { Closure::Closed } else { Closure::Open };
            let curve = by_knots(degree, closure, KnotSource::Given(&knots), &points).unwrap();
            let arcs = curve.arcs();
            for pair in arcs.windows(2) {
                // Exact routes: Bézier points give the derivatives as differences of forward and backward rows.
                let widths = [pair[0].range[1] - pair[0].range[0], pair[1].range[1] - pair[1].range[0]];
                let rows: [Vec<Point<2>>; 2] =
                    [pair[0].points.iter().rev().copied().collect(), pair[1].points.clone()];
                for r in 0..degree {
                    let ends = [0usize, 1].map(|side| {
                        let mut row = rows[side].clone();
                        for _ in 0..r {
                            row = row.windows(2).map(|p| [p[1][0] - p[0][0], p[1][1] - p[0][1]]).collect();
                        }
                        let sign = if side == 0 && r % 2 == 1 { -1.0 } else { 1.0 };
                        row[0].map(|x| sign * x / widths[side].powi(r as i32))
                    });
                    for (a, b) in ends[0].iter().zip(ends[1]) {
                        let size = 1e-8 * (1.0 + a.abs()) * 200.0 / 0.2_f64.powi(r as i32);
                        prop_assert!((a - b).abs() < size, "derivative {r}: {a} {b}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_closed_curve_begins_near_its_first_point() {
        let ring: Vec<Point<2>> =
            (0..8).map(|i| f64::from(i) * std::f64::consts::FRAC_PI_4).map(|t| [t.cos(), t.sin()]).collect();
        for degree in [1, 3, 5] {
            for rule in [Knots::Uniform, Knots::Chord] {
                let curve = bspline(degree, Closure::Closed, KnotSource::By(rule), &ring).unwrap();
                let [x, y] = curve.eval(0, 0.0).unwrap();
                assert!(y.abs() < 1e-9 && x > 0.5, "{degree} {rule:?}: {x} {y}");
                assert!(curve.closed());
            }
        }
        let vector = KnotVector::closed(5, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]).unwrap();
        assert_eq!(vector.points(), 5);
    }
}
