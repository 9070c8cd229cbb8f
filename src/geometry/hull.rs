//! The convex hull of points in the plane, in which Bézier curves and B-splines stay (2.3.5, 2.3.6).

use super::Point;

/// The corners of the convex hull as indices into `points`, counter-clockwise from the leftmost one (of those the
/// lowest); points on its sides are no corners. Two different points have a hull of two corners, points that all are the
/// same one of one. Points that are not finite are left out.
///
/// Andrew's monotone chain: O(n log n). Sides are compared by the sign of a determinant in doubles, which is exact for
/// whole numbers up to 2^25.
///
/// ```
/// use grafika::geometry::plane_hull;
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.5], [2.0, 2.0], [0.0, 2.0], [1.0, 0.0]];
/// assert_eq!(plane_hull(&points), [0, 1, 3, 4]);
/// ```
#[must_use]
pub fn plane_hull(points: &[Point<2>]) -> Vec<usize> {
    let finite = |&index: &usize| points[index].iter().all(|x| x.is_finite());
    let mut order: Vec<usize> = (0..points.len()).filter(finite).collect();
    let place = |index: usize| points.get(index).copied().unwrap_or_default();
    order.sort_by(|&a, &b| {
        let ([ax, ay], [bx, by]) = (place(a), place(b));
        ax.total_cmp(&bx).then(ay.total_cmp(&by)).then(a.cmp(&b))
    });
    order.dedup_by(|a, b| place(*a) == place(*b));
    if order.len() < 3 {
        return order;
    }
    let mut hull = chain(order.iter().copied(), place);
    let upper = chain(order.iter().rev().copied(), place);
    // Each chain ends where the other begins.
    hull.pop();
    hull.extend(&upper[..upper.len().saturating_sub(1)]);
    hull
}

/// The corners of one half of the hull, in the order of the points: only turns to the left.
fn chain(order: impl Iterator<Item = usize>, place: impl Fn(usize) -> Point<2>) -> Vec<usize> {
    let mut chain: Vec<usize> = Vec::new();
    for next in order {
        while let [.., before, last] = chain[..] {
            let ([ax, ay], [bx, by], [cx, cy]) = (place(before), place(last), place(next));
            if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(next);
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn side([ax, ay]: Point<2>, [bx, by]: Point<2>, [cx, cy]: Point<2>) -> f64 {
        (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    }

    #[test]
    fn few_points_and_lines_have_their_hull() {
        assert_eq!(plane_hull(&[]), [0; 0]);
        assert_eq!(plane_hull(&[[1.0, 2.0]; 3]), [0]);
        assert_eq!(plane_hull(&[[2.0, 2.0], [0.0, 0.0], [1.0, 1.0]]), [1, 0]);
        assert_eq!(plane_hull(&[[f64::NAN, 0.0], [1.0, 0.0]]), [1]);
    }

    proptest! {
        /// Against the definition: a pair of points is a side exactly when no point is on its right.
        #[test]
        fn no_point_is_outside_and_every_corner_is_one(
            points in prop::collection::vec(prop::array::uniform2(-20i32..20), 3..40),
        ) {
            let points: Vec<Point<2>> = points.into_iter().map(|it| it.map(f64::from)).collect();
            let hull = plane_hull(&points);
            for (at, &from) in hull.iter().enumerate() {
                let to = hull[(at + 1) % hull.len()];
                prop_assert!(points.iter().all(|&it| side(points[from], points[to], it) >= 0.0));
            }
            // A corner is no mean of two others.
            for &corner in &hull {
                let at = points[corner];
                let between = |a: &Point<2>, b: &Point<2>| {
                    *a != at && *b != at && side(*a, *b, at) == 0.0
                        && (a[0] - at[0]) * (b[0] - at[0]) + (a[1] - at[1]) * (b[1] - at[1]) < 0.0
                };
                prop_assert!(!points.iter().any(|a| points.iter().any(|b| between(a, b))));
            }
        }
    }
}
