//! Curves by control points and tangents (Coons-Hermite, 2.13), with tangents from anywhere.

use super::cubic::check_arcs;
use super::method::Closure;
use super::point::{add_scaled, check_count, check_points, scaled_difference};
use super::{CubicBezier, GeometryError, Method, Point};

impl<const D: usize> CubicBezier<D> {
    /// The arc from `start` to `end` with the derivatives `from` and `to` there (2.11)-(2.13).
    #[must_use]
    pub fn from_hermite(start: Point<D>, end: Point<D>, from: Point<D>, to: Point<D>) -> Self {
        let third = 1.0 / 3.0;
        Self { p: [start, add_scaled(start, third, from), add_scaled(end, -third, to), end] }
    }
}

/// The tangents that Coons interpolation sets by itself (2.15): `k0` times the difference of the
/// neighbours, at open ends `k0` times the difference to the only neighbour. One per point.
///
/// # Errors
/// Fewer than 2 points (3 when closed), a bad coordinate, `k0` not finite, or a tangent beyond
/// the coordinate limit ([`GeometryError::Overflow`], with the point's number from 0).
pub fn automatic_tangents<const D: usize>(
    closure: Closure,
    k0: f64,
    points: &[Point<D>],
) -> Result<Vec<Point<D>>, GeometryError> {
    Method::Coons { k0 }.check()?;
    check_input(closure, points)?;
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else {
        return Ok(Vec::new());
    };
    let (before, after) = match closure {
        Closure::Open => (first, last),
        Closure::Closed => (last, first),
    };
    let befores = std::iter::once(&before).chain(points);
    let nexts = points.iter().skip(1).chain(std::iter::once(&after));
    let tangents: Vec<_> = befores.zip(nexts).map(|(&b, &n)| scaled_difference(k0, b, n)).collect();
    match tangents.iter().position(|t| !super::point::within_limit(t)) {
        None => Ok(tangents),
        Some(span) => Err(GeometryError::Overflow { span }),
    }
}

/// The arcs through `points` with these `tangents`, one per point (2.13)-(2.14): `n - 1` arcs when
/// open, `n` when closed.
///
/// # Errors
/// Fewer than 2 points (3 when closed), another number of tangents than points, a bad coordinate
/// in either (counted from 1), or [`GeometryError::Overflow`].
pub fn hermite_arcs<const D: usize>(
    closure: Closure,
    points: &[Point<D>],
    tangents: &[Point<D>],
) -> Result<Vec<CubicBezier<D>>, GeometryError> {
    check_input(closure, points)?;
    if tangents.len() != points.len() {
        return Err(GeometryError::WrongCount { given: tangents.len(), needed: points.len() });
    }
    check_points(tangents)?;
    check_arcs(arcs_through(closure, points, tangents))
}

/// The arcs of [`hermite_arcs`] for points and tangents that need no checking.
pub(super) fn arcs_through<const D: usize>(
    closure: Closure,
    points: &[Point<D>],
    tangents: &[Point<D>],
) -> Vec<CubicBezier<D>> {
    let spans = match closure {
        Closure::Open => points.len().saturating_sub(1),
        Closure::Closed => points.len(),
    };
    let starts = points.iter().zip(tangents);
    let ends = points.iter().zip(tangents).cycle().skip(1);
    let arc = |((&p, &m), (&q, &n))| CubicBezier::from_hermite(p, q, m, n);
    starts.zip(ends).take(spans).map(arc).collect()
}

/// The checks on points that a curve passes through.
pub(super) fn check_input<const D: usize>(
    closure: Closure,
    points: &[Point<D>],
) -> Result<(), GeometryError> {
    let needed = match closure {
        Closure::Open => 2,
        Closure::Closed => 3,
    };
    check_count(points.len(), needed)?;
    check_points(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [Point<2>; 4] = [[0.0, 0.0], [3.0, 1.0], [4.0, 5.0], [-2.0, 6.0]];

    #[test]
    fn tangents_follow_equation_2_15() {
        let open = automatic_tangents(Closure::Open, 2.0, &POINTS);
        assert_eq!(open, Ok(vec![[6.0, 2.0], [8.0, 10.0], [-10.0, 10.0], [-12.0, 2.0]]));
        let closed = automatic_tangents(Closure::Closed, 1.0, &POINTS);
        assert_eq!(closed, Ok(vec![[5.0, -5.0], [4.0, 5.0], [-5.0, 5.0], [-4.0, -5.0]]));
    }

    #[test]
    fn arcs_keep_points_and_tangents() {
        let tangents = [[1.0, 0.0], [0.0, 2.0], [-3.0, 0.0], [0.0, -4.0]];
        let arcs = hermite_arcs(Closure::Closed, &POINTS, &tangents).unwrap();
        assert_eq!(arcs.len(), 4);
        for (i, arc) in arcs.iter().enumerate() {
            let next = (i + 1) % 4;
            assert_eq!((arc.eval(0.0), arc.eval(1.0)), (POINTS[i], POINTS[next]));
            let close = |a: Point<2>, b: Point<2>| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-14;
            assert!(close(arc.derivative(0.0), tangents[i]));
            assert!(close(arc.derivative(1.0), tangents[next]));
        }
        assert_eq!(hermite_arcs(Closure::Open, &POINTS, &tangents).unwrap().len(), 3);
    }

    #[test]
    fn wrong_input_is_an_error() {
        let short = hermite_arcs(Closure::Open, &POINTS, &POINTS[..3]);
        assert_eq!(short, Err(GeometryError::WrongCount { given: 3, needed: 4 }));
        let few = automatic_tangents(Closure::Closed, 1.0, &POINTS[..2]);
        assert_eq!(few, Err(GeometryError::TooFewPoints { given: 2, needed: 3 }));
        let large = automatic_tangents(Closure::Open, 1e300, &POINTS);
        assert_eq!(large, Err(GeometryError::Overflow { span: 0 }));
    }
}
