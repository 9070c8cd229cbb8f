//! Named edits of Bézier arcs: joints carry their handles, the handles of smooth joints stay on a line, and arcs come
//! and go as a whole.

use super::{Edit, Place, Sketch};
use crate::file::{MAX_POINTS, Method};
use crate::geometry::{
    ArcPoint, CubicBezier, Curve, Method as Formula, ParamCurve, Point, norm, smoothed_handles, turned_handle,
};

/// How near to the curve a place is on it, as a part of the curve's size.
const ON_CURVE: f64 = 0.02;
/// Steps between which the nearest place of an arc is searched, and halvings of the way to the neighbours.
const STEPS: u32 = 40;
const HALVINGS: u32 = 40;

impl<const D: usize> Sketch<D> {
    /// What a point is among Bézier arcs; `None` for other methods and for numbers of points that no arcs have.
    pub fn arc_point(&self, index: usize) -> Option<ArcPoint> {
        let arcs = self.method() == Some(Method::Arcs);
        ArcPoint::of(self.closure(), self.points.len(), index).filter(|_| arcs)
    }

    /// Whether a point is marked as a smooth joint.
    pub fn is_smooth(&self, joint: usize) -> bool {
        self.settings.smooth.iter().flatten().any(|number| *number == joint + 1)
    }

    /// The joints with the handles that belong to them.
    pub fn handles(&self) -> Vec<[Point<D>; 2]> {
        let line = |index: usize| match self.arc_point(index)? {
            ArcPoint::Handle { joint, .. } => Some([*self.points.get(joint)?, *self.points.get(index)?]),
            ArcPoint::Joint(_) => None,
        };
        (0..self.points.len()).filter_map(line).collect()
    }

    /// Marks a joint as smooth or as a corner; the handles stay.
    fn marked(&mut self, joint: usize, smooth: bool) {
        let mut numbers = self.settings.smooth.take().unwrap_or_default();
        numbers.retain(|number| *number != joint + 1);
        if smooth {
            numbers.push(joint + 1);
            numbers.sort_unstable();
        }
        self.settings.smooth = Some(numbers).filter(|numbers| !numbers.is_empty());
    }
}

impl<const D: usize> Sketch<D>
where
    Point<D>: Place<D>,
{
    /// The sketch with a point at another place. A joint of Bézier arcs carries its handles; a handle of a smooth joint
    /// turns the other one, which keeps its length. Handles that would leave the allowed range become shorter.
    #[must_use]
    pub fn dragged(&self, index: usize, at: Point<D>) -> Sketch<D> {
        let mut sketch = self.edited(Edit::Move(index, at));
        match (self.arc_point(index), self.points.get(index), sketch.points.get(index).copied()) {
            (Some(ArcPoint::Joint(handles)), Some(old), Some(joint)) => {
                for handle in handles.into_iter().flatten() {
                    let carried = std::array::from_fn(|d| joint[d] + (self.points[handle][d] - old[d]));
                    sketch.points[handle] = shortened(joint, carried);
                }
            }
            (Some(ArcPoint::Handle { joint, opposite: Some(other) }), _, Some(set))
                if self.is_smooth(joint) =>
            {
                let place = self.points[joint];
                sketch.points[other] = shortened(place, turned_handle(place, set, self.points[other]));
            }
            _ => {}
        }
        sketch
    }

    /// The sketch with a joint of Bézier arcs as a smooth one or as a corner. The handles of one that becomes smooth are
    /// put on a line. Without such a joint, and at the ends of open curves, nothing changes.
    #[must_use]
    pub fn with_smooth(&self, joint: usize, smooth: bool) -> Sketch<D> {
        let mut sketch = self.clone();
        if let Some(ArcPoint::Joint([Some(before), Some(after)])) = self.arc_point(joint) {
            sketch.marked(joint, smooth);
            if smooth {
                let place = self.points[joint];
                let handles = smoothed_handles(place, [before, after].map(|handle| self.points[handle]));
                for (handle, at) in [before, after].into_iter().zip(handles) {
                    sketch.points[handle] = shortened(place, at);
                }
            }
        }
        sketch
    }

    /// The sketch without a point. A joint of Bézier arcs goes with its handles, or with the arc at an end, as long as
    /// there are other arcs; any other point goes alone.
    #[must_use]
    pub fn removed(&self, index: usize) -> Sketch<D> {
        let count = self.points.len();
        let first = match self.arc_point(index) {
            Some(ArcPoint::Joint([None, Some(_)])) if count > 4 => Some(0),
            Some(ArcPoint::Joint([Some(_), None])) if count > 4 => Some(count - 3),
            Some(ArcPoint::Joint([Some(before), Some(_)])) if count > 4 => Some(before),
            _ => None,
        };
        let Some(first) = first else { return self.edited(Edit::Delete(index)) };
        if first + 3 > count {
            // The first joint of a closed curve, whose handle before it is the last point.
            let rest = [Edit::Delete(count - 1), Edit::Delete(1), Edit::Delete(0)];
            let rest = rest.into_iter().fold(self.clone(), |sketch, edit| sketch.edited(edit));
            return rest.edited(Edit::Renumber(0, count - 4));
        }
        (0..3).fold(self.clone(), |sketch, _| sketch.edited(Edit::Delete(first)))
    }

    /// The sketch with a new point that will have an index. On a curve of Bézier arcs it divides its arc, as a smooth
    /// joint with handles of its own, and the curve stays as it is.
    #[must_use]
    pub fn with_new(&self, index: usize, at: Point<D>) -> Sketch<D> {
        self.divided(at).unwrap_or_else(|| self.edited(Edit::Insert(index, at)))
    }

    /// The sketch with the arc divided at a place on it; `None` off the curve, and without room for three points.
    fn divided(&self, at: Point<D>) -> Option<Sketch<D>> {
        self.arc_point(0).filter(|_| self.points.len() + 3 <= MAX_POINTS)?;
        let curve = Curve::through(Formula::Arcs, self.closure(), &self.points).ok()?;
        let reach = ON_CURVE * curve.bounding_box()?.extent();
        let Curve::Piecewise(arcs) = curve else { return None };
        let nearest = arcs.iter().enumerate().map(|(span, arc)| (nearest(arc, at), span));
        let ((distance, u), span) = nearest.min_by(|(a, _), (b, _)| a.0.total_cmp(&b.0))?;
        if distance > reach {
            return None;
        }
        let [left, right] = arcs.get(span)?.split(u);
        let inner = [left.p[1], left.p[2], left.p[3], right.p[1]];
        let from = 3 * span + 1;
        let inserted = (from..).zip(inner).take(3);
        let mut sketch = self.edited(Edit::Move(from, inner[0]));
        for (index, place) in inserted.skip(1) {
            sketch = sketch.edited(Edit::Insert(index, place));
        }
        sketch = sketch.edited(Edit::Insert(from + 3, inner[3]));
        sketch = sketch.edited(Edit::Move(from + 4, right.p[2]));
        sketch.marked(from + 2, true);
        Some(sketch)
    }
}

/// The distance of a place from an arc, and the parameter of the nearest point.
fn nearest<const D: usize>(arc: &CubicBezier<D>, at: Point<D>) -> (f64, f64) {
    let distance = |u: f64| norm::<D>(std::array::from_fn(|d| arc.eval(u)[d] - at[d]));
    let tried: Vec<(f64, f64)> =
        (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS)).map(|u| (distance(u), u)).collect();
    // The nearest of those tried need not lie in the deepest of the dells: all of them are followed down.
    let at = |index: Option<usize>| index.and_then(|it| tried.get(it)).map_or(f64::INFINITY, |it| it.0);
    let dells = tried
        .iter()
        .enumerate()
        .filter(|(index, (here, _))| *here <= at(index.checked_sub(1)) && *here <= at(index.checked_add(1)));
    let followed = dells.map(|(_, &dell)| {
        let (mut best, mut step) = (dell, 0.5 / f64::from(STEPS));
        for _ in 0..HALVINGS {
            for u in [best.1 - step, best.1 + step].into_iter().filter(|u| (0.0..=1.0).contains(u)) {
                let there = distance(u);
                if there < best.0 {
                    best = (there, u);
                }
            }
            step /= 2.0;
        }
        best
    });
    followed.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, 0.0))
}

/// A handle, or the last place on the way from its joint to it that is allowed.
fn shortened<const D: usize>(joint: Point<D>, handle: Point<D>) -> Point<D>
where
    Point<D>: Place<D>,
{
    if handle.fits() {
        return handle;
    }
    let at = |part: f64| -> Point<D> { std::array::from_fn(|d| joint[d] + part * (handle[d] - joint[d])) };
    let (mut near, mut far) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (near + far);
        if at(middle).fits() {
            near = middle;
        } else {
            far = middle;
        }
    }
    at(near)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{cross, norm};
    use proptest::prelude::*;

    fn arcs(points: Vec<Point<2>>, closed: bool) -> Sketch<2> {
        let mut sketch = Sketch { points, ..Sketch::default() }.by(Method::Arcs);
        sketch.settings.closed = Some(closed);
        sketch
    }

    fn sketches() -> impl Strategy<Value = Sketch<2>> {
        (2usize..6, any::<bool>()).prop_flat_map(|(m, closed)| {
            let place = (20.0..540.0f64, 20.0..360.0f64).prop_map(|(x, y)| [x, y]);
            prop::collection::vec(place, 3 * m + usize::from(!closed))
                .prop_map(move |points| arcs(points, closed))
        })
    }

    /// How far the handles of a smooth joint are from a line through it, as the sine of an angle.
    fn bent(sketch: &Sketch<2>, joint: usize) -> f64 {
        let Some(ArcPoint::Joint([Some(before), Some(after)])) = sketch.arc_point(joint) else { return 0.0 };
        let [from, to] = [before, after].map(|handle| {
            let at = sketch.points[handle];
            [at[0] - sketch.points[joint][0], at[1] - sketch.points[joint][1], 0.0]
        });
        norm(cross(from, to)) / (norm(from) * norm(to)).max(1e-3)
    }

    #[test]
    fn a_joint_goes_with_its_handles() {
        let points: Vec<Point<2>> = (0..9).map(|x| [10.0 * f64::from(x), 5.0]).collect();
        let open = arcs(points[..7].to_vec(), false);
        let xs = |sketch: &Sketch<2>| sketch.points.iter().map(|p| p[0] / 10.0).collect::<Vec<_>>();
        assert_eq!(xs(&open.removed(0)), [3.0, 4.0, 5.0, 6.0]);
        assert_eq!(xs(&open.removed(3)), [0.0, 1.0, 5.0, 6.0]);
        assert_eq!(xs(&open.removed(6)), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(xs(&open.removed(1)), [0.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        let closed = arcs(points, true);
        assert_eq!(xs(&closed.removed(0)), [3.0, 4.0, 5.0, 6.0, 7.0, 2.0]);
        assert_eq!(xs(&closed.removed(6)), [0.0, 1.0, 2.0, 3.0, 4.0, 8.0]);
        let spline = open.by(Method::Spline);
        assert_eq!(spline.removed(3).points.len(), 6);
    }

    /// Steps of the arc that are near the place in another part of the loop do not hide the place itself.
    #[test]
    fn a_place_on_a_loop_is_found() {
        let p = [[25.8, 181.6], [498.3, 168.3], [85.6, 283.0], [29.3, 76.9]];
        let arc = CubicBezier { p };
        for u in (0..=1000).map(|k| f64::from(k) * 1e-3) {
            assert!(nearest(&arc, arc.eval(u)).0 < 1e-9, "{u}");
        }
    }

    #[test]
    fn marks_follow_their_points() {
        let points: Vec<Point<2>> = (0..10).map(|x| [10.0 * f64::from(x), 50.0]).collect();
        let sketch = arcs(points, false).with_smooth(3, true).with_smooth(6, true);
        assert_eq!(sketch.settings.smooth, Some(vec![4, 7]));
        assert_eq!(sketch.removed(3).settings.smooth, Some(vec![4]));
        assert_eq!(sketch.removed(0).settings.smooth, Some(vec![1, 4]));
        assert_eq!(sketch.with_smooth(3, false).with_smooth(6, false).settings.smooth, None);
        // Ends and handles are no joints of two arcs.
        assert_eq!(sketch.with_smooth(0, true), sketch);
        assert_eq!(sketch.with_smooth(4, true), sketch);
    }

    proptest! {
        #[test]
        fn smooth_joints_stay_smooth_in_the_field(
            sketch in sketches(),
            moves in prop::collection::vec((0usize..16, -100.0..700.0f64, -100.0..500.0f64), 1..8),
        ) {
            let count = sketch.points.len();
            let mut sketch = (0..count).step_by(3).fold(sketch, |sketch, joint| sketch.with_smooth(joint, true));
            for (index, x, y) in moves {
                sketch = sketch.dragged(index % count, [x, y]);
                for joint in (0..count).step_by(3) {
                    prop_assert!(bent(&sketch, joint) < 1e-6, "{joint}: {:?}", sketch.points);
                }
            }
            prop_assert!(sketch.fitting().is_ok());
        }

        #[test]
        fn a_joint_carries_its_handles(sketch in sketches(), joint in 0usize..6, dx in -10.0..10.0f64) {
            let joint = 3 * (joint % (sketch.points.len() / 3));
            let [x, y] = sketch.points[joint];
            let moved = sketch.dragged(joint, [x + dx, y]);
            let Some(ArcPoint::Joint(handles)) = sketch.arc_point(joint) else { panic!() };
            for (index, (old, new)) in sketch.points.iter().zip(&moved.points).enumerate() {
                let carried = index == joint || handles.contains(&Some(index));
                let by = if carried { dx } else { 0.0 };
                prop_assert!((new[0] - old[0] - by).abs() < 1e-9 && (new[1] - old[1]).abs() < 1e-9);
            }
        }

        #[test]
        fn a_divided_arc_stays_where_it_is(sketch in sketches(), span in 0usize..6, u in 0.05..0.95f64) {
            let curve = sketch.curve().unwrap();
            let span = span % curve.spans();
            let divided = sketch.with_new(99, curve.eval(span, u).unwrap());
            prop_assert_eq!(divided.points.len(), sketch.points.len() + 3);
            let new = divided.curve().unwrap();
            prop_assert_eq!(new.spans(), curve.spans() + 1);
            // The curve crosses itself perhaps: its whole length and box stay.
            prop_assert!((new.length(1e-9) - curve.length(1e-9)).abs() < 1e-4 * curve.length(1e-9));
            let joint = divided.settings.smooth.clone().unwrap()[0] - 1;
            prop_assert!(bent(&divided, joint) < 1e-6);
        }
    }
}
