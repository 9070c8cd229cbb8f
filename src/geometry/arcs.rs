//! Rows of cubic Bézier arcs (2.49): every third point is a joint, the two between are handles of the tangents.

use super::cubic::check_arcs;
use super::method::Closure;
use super::point::{add_scaled, check_count, check_points, norm, scaled_difference};
use super::{CubicBezier, GeometryError, Point};

/// The fewest points: one arc, or one that returns to its beginning.
const FEWEST: [usize; 2] = [4, 3];

/// What a point is among the points of Bézier arcs. Indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArcPoint {
    /// Arcs end there. Its handles: that of the arc before and that of the arc after, where there are such.
    Joint([Option<usize>; 2]),
    /// It gives the tangent at a joint; on the other side of the joint may be another one.
    Handle {
        /// The joint.
        joint: usize,
        /// The handle on its other side.
        opposite: Option<usize>,
    },
}

impl ArcPoint {
    /// What point `index` of `count` is; `None` outside the points, and for numbers of points that no arcs have.
    #[must_use]
    pub fn of(closure: Closure, count: usize, index: usize) -> Option<Self> {
        check_arc_count(closure, count).ok()?;
        if index >= count {
            return None;
        }
        // Closed curves go round, open ones end.
        let at = |ahead: usize, back: usize| match closure {
            Closure::Closed => Some((index + count + ahead - back) % count),
            Closure::Open => (index + ahead).checked_sub(back).filter(|&at| at < count),
        };
        Some(match index % 3 {
            0 => Self::Joint([at(0, 1), at(1, 0)]),
            1 => Self::Handle { joint: index - 1, opposite: at(0, 2) },
            // The joint after a handle always exists.
            _ => Self::Handle { joint: at(1, 0)?, opposite: at(2, 0) },
        })
    }
}

/// The arcs of control points: open `3m + 1` of them, closed `3m`, for `m` arcs.
///
/// # Errors
/// [`GeometryError::ArcCount`] for another number, too many points, or a bad coordinate.
pub(super) fn bezier_arcs<const D: usize>(
    closure: Closure,
    points: &[Point<D>],
) -> Result<Vec<CubicBezier<D>>, GeometryError> {
    check_arc_count(closure, points.len())?;
    check_points(points)?;
    let seam = points.first().filter(|_| closure == Closure::Closed);
    let all: Vec<Point<D>> = points.iter().chain(seam).copied().collect();
    let arc = |p: &[Point<D>]| <[Point<D>; 4]>::try_from(p).ok().map(|p| CubicBezier { p });
    check_arcs(all.windows(4).step_by(3).filter_map(arc).collect())
}

/// The check on the number of points.
fn check_arc_count(closure: Closure, given: usize) -> Result<(), GeometryError> {
    let (fewest, rest) = match closure {
        Closure::Open => (FEWEST[0], 1),
        Closure::Closed => (FEWEST[1], 0),
    };
    if given < fewest || given % 3 != rest {
        let needed = if given < fewest { fewest } else { given + (rest + 3 - given % 3) % 3 };
        return Err(GeometryError::ArcCount { given, needed, closed: closure == Closure::Closed });
    }
    check_count(given, fewest)
}

/// The other handle of a smooth joint after one of them has been set: opposite to it, as far from the joint as before.
/// A handle in the joint itself gives no direction, and nothing changes.
#[must_use]
pub fn turned_handle<const D: usize>(joint: Point<D>, set: Point<D>, other: Point<D>) -> Point<D> {
    let away = scaled_difference(1.0, set, joint);
    let (distance, length) = (norm(scaled_difference(1.0, joint, other)), norm(away));
    if length > 0.0 { add_scaled(joint, distance / length, away) } else { other }
}

/// Both handles of a joint that becomes smooth, on one line with it, as far from it as before: along the mean of
/// their directions. Where these cancel each other or there is none, the handle after the joint decides.
#[must_use]
pub fn smoothed_handles<const D: usize>(joint: Point<D>, [before, after]: [Point<D>; 2]) -> [Point<D>; 2] {
    let legs = [scaled_difference(1.0, before, joint), scaled_difference(1.0, joint, after)];
    let lengths = legs.map(norm);
    let unit = |side: usize| legs[side].map(|x| if lengths[side] > 0.0 { x / lengths[side] } else { 0.0 });
    let mean = add_scaled(unit(0), 1.0, unit(1));
    let size = norm(mean);
    let along = if size > 1e-9 { mean.map(|x| x / size) } else { unit(1) };
    [add_scaled(joint, -lengths[0], along), add_scaled(joint, lengths[1], along)]
}

#[cfg(test)]
mod tests {
    use super::super::{Curve, Method, ParamCurve, dot};
    use super::*;
    use proptest::prelude::*;

    fn points(m: usize, closed: bool) -> impl Strategy<Value = Vec<Point<2>>> {
        let count = 3 * m + usize::from(!closed);
        prop::collection::vec(prop::array::uniform2(-200.0..200.0f64), count)
    }

    fn rows() -> impl Strategy<Value = (Closure, Vec<Point<2>>)> {
        (1usize..7, any::<bool>()).prop_flat_map(|(m, closed)| {
            let closure = if closed { Closure::Closed } else { Closure::Open };
            points(m, closed).prop_map(move |points| (closure, points))
        })
    }

    #[test]
    fn numbers_of_points_are_told() {
        for (closure, given, needed) in [
            (Closure::Open, 3, 4),
            (Closure::Open, 5, 7),
            (Closure::Open, 6, 7),
            (Closure::Closed, 2, 3),
            (Closure::Closed, 7, 9),
        ] {
            let error = Curve::through(Method::Arcs, closure, &vec![[0.0; 2]; given]).unwrap_err();
            let closed = closure == Closure::Closed;
            assert_eq!(error, GeometryError::ArcCount { given, needed, closed });
        }
        let text = GeometryError::ArcCount { given: 6, needed: 7, closed: false }.to_string();
        assert_eq!(text, "6 points given: open Bézier arcs take 4, 7, 10, ... points; 1 more needed");
        let text = GeometryError::ArcCount { given: 7, needed: 9, closed: true }.to_string();
        assert_eq!(text, "7 points given: closed Bézier arcs take 3, 6, 9, ... points; 2 more needed");
    }

    #[test]
    fn joints_and_handles_know_each_other() {
        use ArcPoint::{Handle, Joint};
        let open = |index| ArcPoint::of(Closure::Open, 7, index);
        assert_eq!(open(0), Some(Joint([None, Some(1)])));
        assert_eq!(open(1), Some(Handle { joint: 0, opposite: None }));
        assert_eq!(open(2), Some(Handle { joint: 3, opposite: Some(4) }));
        assert_eq!(open(3), Some(Joint([Some(2), Some(4)])));
        assert_eq!(open(5), Some(Handle { joint: 6, opposite: None }));
        assert_eq!((open(6), open(7)), (Some(Joint([Some(5), None])), None));
        let closed = |index| ArcPoint::of(Closure::Closed, 6, index);
        assert_eq!(closed(0), Some(Joint([Some(5), Some(1)])));
        assert_eq!(closed(1), Some(Handle { joint: 0, opposite: Some(5) }));
        assert_eq!(closed(5), Some(Handle { joint: 0, opposite: Some(1) }));
        assert_eq!(ArcPoint::of(Closure::Closed, 7, 0), None);
    }

    proptest! {
        #[test]
        fn arcs_are_those_of_de_casteljau((closure, points) in rows(), u in 0.0..=1.0f64) {
            let curve = Curve::through(Method::Arcs, closure, &points).unwrap();
            prop_assert_eq!(curve.spans(), points.len() / 3);
            prop_assert_eq!(curve.closed() || closure == Closure::Open, true);
            for span in 0..curve.spans() {
                let mut row: Vec<Point<2>> =
                    (0..4).map(|k| points[(3 * span + k) % points.len()]).collect();
                if closure == Closure::Open {
                    row = points[3 * span..3 * span + 4].to_vec();
                }
                while row.len() > 1 {
                    row = row
                        .windows(2)
                        .map(|p| std::array::from_fn(|d| (1.0 - u) * p[0][d] + u * p[1][d]))
                        .collect();
                }
                let [x, y] = curve.eval(span, u).unwrap();
                prop_assert!((x - row[0][0]).abs() < 1e-12 * 400.0 && (y - row[0][1]).abs() < 1e-12 * 400.0);
            }
        }

        #[test]
        fn smooth_joints_have_parallel_tangents((closure, mut points) in rows(), joint in 0usize..6) {
            let count = points.len();
            let joint = 3 * (joint % (count / 3));
            if let Some(ArcPoint::Joint([Some(before), Some(after)])) = ArcPoint::of(closure, count, joint) {
                let old = [points[before], points[after]];
                [points[before], points[after]] = smoothed_handles(points[joint], old);
                for (now, was) in [points[before], points[after]].into_iter().zip(old) {
                    let length = |handle| norm(scaled_difference(1.0, points[joint], handle));
                    prop_assert!((length(now) - length(was)).abs() < 1e-9);
                }
                // Then one of them is moved.
                let set = [points[joint][0] + 30.0, points[joint][1] - 7.0];
                for moved in [false, true] {
                    if moved {
                        points[after] = set;
                        points[before] = turned_handle(points[joint], set, points[before]);
                    }
                    let curve = Curve::through(Method::Arcs, closure, &points).unwrap();
                    let span = joint / 3;
                    let last = (span + curve.spans() - 1) % curve.spans();
                    let [_, out, _] = curve.at(span, 0.0).unwrap();
                    let [_, into, _] = curve.at(last, 1.0).unwrap();
                    let cross = into[0] * out[1] - into[1] * out[0];
                    prop_assert!(cross.abs() < 1e-9 * norm(into) * norm(out).max(1.0), "{into:?} {out:?}");
                    prop_assert!(dot(into, out) >= 0.0);
                }
            }
        }
    }
}
