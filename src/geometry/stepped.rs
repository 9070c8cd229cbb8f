//! The interpolating cubic spline with steps of its own for every span and given tangents at its ends
//! (2.25)-(2.29).

use super::cubic::check_arcs;
use super::hermite::check_input;
use super::method::Closure;
use super::ph::Knots;
use super::point::{add_scaled, check_points, norm, scaled_difference};
use super::{CubicBezier, GeometryError, Point};

/// The arcs of the C2 cubic spline through `points`, whose spans are as long in the parameter as the rule says, with
/// steps of mean 1. `ends` are the derivatives by this parameter at the start and the end of an open curve; an end
/// without one is natural, without curvature. A closed curve has no ends.
///
/// # Errors
/// Fewer than 2 points (3 when closed), a bad coordinate (a derivative counts as point 1 or 2),
/// [`GeometryError::EqualNeighbours`] where a step would be 0, or [`GeometryError::Overflow`].
///
/// ```
/// use grafika::geometry::ph::Knots;
/// use grafika::geometry::{Closure, stepped_spline};
///
/// let points = [[0.0, 0.0], [3.0, 0.0], [4.0, 0.0]];
/// let arcs = stepped_spline(Closure::Open, Knots::Chord, [Some([0.0, 8.0]), None], &points)?;
/// // The steps are 1.5 and 0.5.
/// let [dx, dy] = arcs[0].derivative(0.0);
/// assert!(dx.abs() < 1e-12 && (dy - 12.0).abs() < 1e-12);
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
pub fn stepped_spline<const D: usize>(
    closure: Closure,
    rule: Knots,
    ends: [Option<Point<D>>; 2],
    points: &[Point<D>],
) -> Result<Vec<CubicBezier<D>>, GeometryError> {
    check_input(closure, points)?;
    let given: Vec<Point<D>> = ends.iter().map(|end| end.unwrap_or([0.0; D])).collect();
    check_points(&given)?;
    let n = points.len();
    let spans = match closure {
        Closure::Open => n - 1,
        Closure::Closed => n,
    };
    let next = |i: usize| (i + 1) % n;
    let chords: Vec<f64> =
        (0..spans).map(|i| norm(scaled_difference(1.0, points[i], points[next(i)]))).collect();
    let steps = rule.steps(&chords);
    if let Some(i) = steps.iter().position(|step| step.is_nan() || *step <= 0.0) {
        return Err(GeometryError::EqualNeighbours { number: i + 1, next: next(i) + 1 });
    }
    // Slopes of the chords; (2.28) says that neighbours' mean of them is the mean of the tangents.
    let slope = |i: usize| scaled_difference(1.0 / steps[i], points[i], points[next(i)]);
    let row = |i: usize| -> (Row, Point<D>) {
        let first = closure == Closure::Open && i == 0;
        let last = closure == Closure::Open && i + 1 == n;
        match (first, last) {
            (true, _) => end_row(ends[0], slope(0), [0.0, 2.0, 1.0]),
            (_, true) => end_row(ends[1], slope(n - 2), [1.0, 2.0, 0.0]),
            _ => {
                let before = (i + n - 1) % n;
                let both = steps[before] + steps[i];
                let (from, to) = (steps[i] / both, steps[before] / both);
                let right = add_scaled(slope(before).map(|x| 3.0 * from * x), 3.0 * to, slope(i));
                ([from, 2.0, to], right)
            }
        }
    };
    let (rows, mut tangents): (Vec<Row>, Vec<Point<D>>) = (0..n).map(row).unzip();
    match closure {
        Closure::Open => solve(&rows, &mut tangents),
        Closure::Closed => solve_cyclic(&rows, &mut tangents),
    }
    let arc = |i: usize| {
        let [from, to] = [i, next(i)].map(|at| tangents[at].map(|x| x * steps[i]));
        CubicBezier::from_hermite(points[i], points[next(i)], from, to)
    };
    check_arcs((0..spans).map(arc).collect())
}

/// A row of the system: the factors of the tangent before, of the own one and of the next.
type Row = [f64; 3];

/// A given tangent, or the end without curvature (2.24).
fn end_row<const D: usize>(given: Option<Point<D>>, slope: Point<D>, natural: Row) -> (Row, Point<D>) {
    match given {
        Some(tangent) => ([0.0, 1.0, 0.0], tangent),
        None => (natural, slope.map(|x| 3.0 * x)),
    }
}

/// The elimination (2.31). All rows are diagonally dominant, so no pivoting is needed.
fn solve<const D: usize>(rows: &[Row], x: &mut [Point<D>]) {
    let mut ahead: Vec<f64> = Vec::with_capacity(rows.len());
    for (i, [before, own, next]) in rows.iter().enumerate() {
        let (factor, above) = match i.checked_sub(1) {
            Some(k) => (ahead[k], x[k]),
            None => (0.0, [0.0; D]),
        };
        let pivot = own - before * factor;
        ahead.push(next / pivot);
        x[i] = std::array::from_fn(|d| (x[i][d] - before * above[d]) / pivot);
    }
    for i in (0..rows.len().saturating_sub(1)).rev() {
        x[i] = add_scaled(x[i], -ahead[i], x[i + 1]);
    }
}

/// The same with the corners of a closed curve, as a correction of rank one (Sherman and Morrison).
fn solve_cyclic<const D: usize>(rows: &[Row], x: &mut [Point<D>]) {
    let (Some(&[corner, first, _]), Some(&[_, _, other])) = (rows.first(), rows.last()) else { return };
    let (gamma, last) = (-first, rows.len() - 1);
    let mut base = rows.to_vec();
    base[0][1] -= gamma;
    base[last][1] -= corner * other / gamma;
    let mut column = vec![[0.0; 1]; rows.len()];
    (column[0], column[last]) = ([gamma], [other]);
    solve(&base, &mut column);
    solve(&base, x);
    let ratio = corner / gamma;
    let scale = 1.0 + column[0][0] + ratio * column[last][0];
    let factor: Point<D> = std::array::from_fn(|d| (x[0][d] + ratio * x[last][d]) / scale);
    for (x, [z]) in x.iter_mut().zip(column) {
        *x = add_scaled(*x, -z, factor);
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Curve, Method, ParamCurve};
    use super::*;
    use proptest::prelude::*;

    fn apart(closed: bool) -> impl Strategy<Value = Vec<Point<2>>> {
        // Steps to the next point, so that no two are the same.
        let least = if closed { 3 } else { 2 };
        prop::collection::vec((1.0..40.0f64, -30.0..30.0f64), least..12).prop_map(|legs| {
            let mut at = [0.0, 0.0];
            legs.into_iter()
                .map(|(dx, dy)| {
                    at = [at[0] + dx, at[1] + dy];
                    at
                })
                .collect()
        })
    }

    fn rules() -> impl Strategy<Value = Knots> {
        prop::sample::select(Knots::ALL.map(|(_, rule)| rule).to_vec())
    }

    fn near(a: Point<2>, b: Point<2>, size: f64) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-10 * size)
    }

    #[test]
    fn equal_neighbours_have_no_step() {
        let points = [[0.0, 0.0], [1.0, 1.0], [1.0, 1.0]];
        let error = stepped_spline(Closure::Open, Knots::Chord, [None; 2], &points).unwrap_err();
        assert_eq!(error, GeometryError::EqualNeighbours { number: 2, next: 3 });
        assert!(stepped_spline(Closure::Open, Knots::Uniform, [None; 2], &points).is_ok());
        let all = [[5.0, 5.0]; 3];
        assert!(stepped_spline(Closure::Closed, Knots::Centripetal, [None; 2], &all).is_err());
        assert!(stepped_spline(Closure::Open, Knots::Chord, [Some([f64::NAN, 0.0]), None], &points).is_err());
    }

    proptest! {
        #[test]
        fn equal_steps_and_natural_ends_are_the_spline(points in apart(true), closed in any::<bool>()) {
            let closure = if closed { Closure::Closed } else { Closure::Open };
            let ours = stepped_spline(closure, Knots::Uniform, [None; 2], &points).unwrap();
            let theirs = Curve::through(Method::Spline, closure, &points).unwrap().to_cubics(1.0).unwrap();
            prop_assert_eq!(ours.len(), theirs.len());
            for (ours, theirs) in ours.iter().zip(&theirs) {
                for (a, b) in ours.p.iter().zip(theirs.p) {
                    prop_assert!(near(*a, b, 1000.0), "{ours:?} {theirs:?}");
                }
            }
        }

        #[test]
        fn points_tangents_and_curvature_go_on(
            points in apart(true),
            rule in rules(),
            closed in any::<bool>(),
            ends in prop::array::uniform2(prop::option::of(prop::array::uniform2(-50.0..50.0f64))),
        ) {
            let closure = if closed { Closure::Closed } else { Closure::Open };
            let arcs = stepped_spline(closure, rule, ends, &points).unwrap();
            let n = points.len();
            let chords: Vec<f64> =
                (0..arcs.len()).map(|i| norm(scaled_difference(1.0, points[i], points[(i + 1) % n]))).collect();
            let steps = rule.steps(&chords);
            for (i, arc) in arcs.iter().enumerate() {
                prop_assert_eq!((arc.p[0], arc.p[3]), (points[i], points[(i + 1) % n]));
                let j = (i + 1) % arcs.len();
                if j == 0 && !closed {
                    continue;
                }
                // Derivatives by the common parameter.
                let by = |vector: Point<2>, step: f64| vector.map(|x| x / step);
                prop_assert!(near(by(arc.derivative(1.0), steps[i]), by(arcs[j].derivative(0.0), steps[j]), 1e4));
                let bends = [arc.second_derivative(1.0), arcs[j].second_derivative(0.0)];
                let bends = [by(by(bends[0], steps[i]), steps[i]), by(by(bends[1], steps[j]), steps[j])];
                prop_assert!(near(bends[0], bends[1], 1e5), "{bends:?}");
            }
            if !closed {
                let last = arcs.len() - 1;
                let found = [arcs[0].derivative(0.0).map(|x| x / steps[0]), arcs[last].derivative(1.0).map(|x| x / steps[last])];
                let bends = [arcs[0].second_derivative(0.0), arcs[last].second_derivative(1.0)];
                for ((end, found), bend) in ends.into_iter().zip(found).zip(bends) {
                    match end {
                        Some(end) => prop_assert!(near(end, found, 1e3), "{end:?} {found:?}"),
                        None => prop_assert!(near(bend, [0.0; 2], 1e4), "{bend:?}"),
                    }
                }
            }
        }
    }
}
