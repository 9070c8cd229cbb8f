//! Control points of curves that pass given points at their joints.

use super::super::cyclic::Cyclic;
use super::super::point::{add_scaled, check_count, check_points};
use super::super::tridiagonal::Tridiagonal;
use super::super::{GeometryError, Point};
use super::family::Family;
use super::lambda::{LambdaKind, Lambdas};
use super::waves;

/// The control points of an interpolating curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Interpolated<const D: usize> {
    /// As many as data of a closed curve; of an open one two more, one before and one after the data.
    pub points: Vec<Point<D>>,
    /// The polygon that is blended in, of alpha-, GB- and SPB-splines.
    pub blend: Option<Vec<Point<D>>>,
}

impl<const D: usize> Interpolated<D> {
    /// The curve; its joint `i` is datum `i`, of a closed one `i + 1`, as every spline's joint 0 is at its second point.
    ///
    /// # Errors
    /// As [`ShapedCurve::new`](super::ShapedCurve::new).
    pub fn curve(self, family: Family, closed: bool) -> Result<super::ShapedCurve<D>, GeometryError> {
        let curve = super::ShapedCurve::new(family, self.points, closed)?;
        match self.blend {
            Some(blend) => curve.with_blend(blend),
            None => Ok(curve),
        }
    }
}

/// The control points of the spline of this family through `data`.
///
/// Han's with lambda 4 passes its control points. Alpha-, GB- and SPB-splines keep the data as control points and blend in
/// another polygon (Hoffmann and Juhász), so that every datum has influence on near arcs only. The others are solved for all
/// points at once; their open curves have the second difference 0 at the first and the last datum.
///
/// # Errors
/// [`GeometryError::Parameter`] for a lambda or omega without a sure solution: Han's needs one lambda, larger than -2, the
/// blended kinds lambdas that are not 0, C-B-splines an `alpha` smaller than pi; also for families that are no
/// uniform splines of cubic kind. At least 2 data, 3 for closed curves; bad coordinates; control points
/// that leave the coordinate limit.
pub fn interpolate<const D: usize>(
    family: &Family,
    data: &[Point<D>],
    closed: bool,
) -> Result<Interpolated<D>, GeometryError> {
    check_count(data.len(), if closed { 3 } else { 2 })?;
    check_points(data)?;
    let count = data.len() + if closed { 0 } else { 2 };
    family.check(count)?;
    let bad = |name, value, wanted| Err(GeometryError::Parameter { name, value, wanted });
    let found = match family {
        Family::FBSpline { omega } => {
            let outer = waves::b_spline(*omega, 0.0)[0].0[0];
            if outer > 0.25 - 1e-7 {
                return bad("omega", *omega, "less than pi^2 to go through points (alpha less than pi)");
            }
            Interpolated { points: solved(outer, data, closed), blend: None }
        }
        Family::Lambda { kind: LambdaKind::Han, lambda: Lambdas::One(lambda) } => {
            if *lambda <= -2.0 + 1e-6 {
                return bad("lambda", *lambda, "larger than -2 to go through points");
            }
            Interpolated { points: solved((4.0 - lambda) / 24.0, data, closed), blend: None }
        }
        Family::Lambda { kind: LambdaKind::Han, lambda: Lambdas::Each(all) } => {
            return bad("the number of lambdas", all.len() as f64, "1 to go through points");
        }
        Family::Lambda { lambda, .. } => {
            // A closed curve's control points are the data themselves, with the same indices.
            let shift = usize::from(!closed);
            if let Some(i) = (0..data.len()).find(|i| lambda.of(i + shift) == 0.0) {
                return bad("lambda", lambda.of(i + shift), "other than 0 to go through points");
            }
            let points = if closed { data.to_vec() } else { reflected(data) };
            let blend: Vec<Point<D>> = (0..data.len())
                .map(|i| {
                    let of = |index: usize| points[index % points.len()];
                    let [before, here, after] =
                        [i + shift + points.len() - 1, i + shift, i + shift + 1].map(of);
                    let lambda = lambda.of(i + shift);
                    std::array::from_fn(|d| {
                        let b = (before[d] + 4.0 * here[d] + after[d]) / 6.0;
                        (here[d] - (1.0 - lambda) * b) / lambda
                    })
                })
                .collect();
            let blend = if closed { blend } else { reflected(&blend) };
            Interpolated { points, blend: Some(blend) }
        }
        _ => return bad("points to go through", data.len() as f64, "0 in this family"),
    };
    let limit = |list: &[Point<D>]| check_points(list).map_err(|_| GeometryError::Overflow { span: 0 });
    limit(&found.points)?;
    limit(found.blend.as_deref().unwrap_or(&[]))?;
    Ok(found)
}

/// The points with one more at either end, reflected at the end.
fn reflected<const D: usize>(points: &[Point<D>]) -> Vec<Point<D>> {
    let [first, second, ..] = *points else { return points.to_vec() };
    let [.., before, last] = *points else { return points.to_vec() };
    let mirror = |end: Point<D>, next: Point<D>| std::array::from_fn(|d| 2.0 * end[d] - next[d]);
    let mut all = vec![mirror(first, second)];
    all.extend_from_slice(points);
    all.push(mirror(last, before));
    all
}

/// The control points whose joints, `outer`, `1 - 2 outer` and `outer` times three of them, are the data.
fn solved<const D: usize>(outer: f64, data: &[Point<D>], closed: bool) -> Vec<Point<D>> {
    // x[i-1] + diagonal x[i] + x[i+1] = (diagonal + 2) data; where it is beyond all digits, x is data.
    let diagonal = (1.0 - 2.0 * outer) / outer;
    let decoupled = diagonal.abs() > 1e17 || !diagonal.is_finite();
    let right = |point: &Point<D>| point.map(|x| (diagonal + 2.0) * x);
    match (decoupled, closed) {
        (true, true) => data.to_vec(),
        (true, false) => reflected(data),
        (false, true) => {
            let mut x: Vec<Point<D>> = data.iter().map(right).collect();
            Cyclic::with_diagonal(x.len(), diagonal).solve(&mut x);
            x
        }
        (false, false) => {
            // With a second difference 0 the end points are the end data.
            let ([first, .., last], inner) = (data, data.get(1..data.len() - 1).unwrap_or(&[])) else {
                return data.to_vec();
            };
            let mut x: Vec<Point<D>> = inner.iter().map(right).collect();
            if let Some(start) = x.first_mut() {
                *start = add_scaled(*start, -1.0, *first);
            }
            if let Some(end) = x.last_mut() {
                *end = add_scaled(*end, -1.0, *last);
            }
            Tridiagonal::new(inner.iter().map(|_| diagonal)).solve(&mut x);
            x.insert(0, *first);
            x.push(*last);
            reflected(&x)
        }
    }
}
