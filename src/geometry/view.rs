//! The view of the programs in space: where the viewer stands, what he sees of a point, and how he turns around the
//! axis z (units KOZOS_3D and RAJZ_F3D of the book). He is far away, unless another [`Projection`] is asked for.
//!
//! A view is two angles, so that turning there and back is exact and goes on over the poles: at the
//! pole the azimuth is still known, and beyond it the axis z points down in the picture. Nothing here
//! draws, and hidden parts are not looked for.

use super::{Point, Projection, dot};
use std::f64::consts::{PI, TAU};

/// What one arrow key turns by, in radians: 3 degrees.
pub const STEP: f64 = PI / 60.0;

/// The centre of the originals' picture on their screen of 640x480 pixels.
pub const CENTRE: [f64; 2] = [331.0, 260.0];

/// An arrow key: the side of the body that looks to the viewer goes this way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Turn {
    /// The viewer goes down around the body.
    Up,
    /// The viewer goes up around the body.
    Down,
    /// The front goes to the left.
    Left,
    /// The front goes to the right.
    Right,
}

/// A view of space from a direction; the axis z is upright in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    azimuth: f64,
    elevation: f64,
    /// Unit vectors of the picture, to the right, up and towards the viewer.
    right: Point<3>,
    up: Point<3>,
    toward: Point<3>,
    projection: Projection,
    /// The place that is seen alike by every projection.
    target: Point<3>,
}

impl View {
    /// The view from a direction, which points from the origin to the viewer. A direction along z, from above or
    /// below, is seen with the axis y to the right: its azimuth is 0. Of the length nothing is kept.
    #[must_use]
    pub fn from_direction([a, b, c]: Point<3>) -> View {
        // A negative zero would be the opposite azimuth.
        let azimuth = if a == 0.0 && b == 0.0 { 0.0 } else { b.atan2(a) };
        View::from_angles(azimuth, c.atan2(a.hypot(b)))
    }

    /// The view from an azimuth, counted from the axis x to the axis y, and an elevation over the plane
    /// of both, in radians. Beyond an elevation of a right angle the view is upside down. An angle that
    /// is no finite number counts as zero.
    #[must_use]
    pub fn from_angles(azimuth: f64, elevation: f64) -> View {
        let (azimuth, elevation) = (wrapped(azimuth), wrapped(elevation));
        let (sin_a, cos_a) = azimuth.sin_cos();
        let (sin_e, cos_e) = elevation.sin_cos();
        View {
            azimuth,
            elevation,
            right: [-sin_a, cos_a, 0.0],
            up: [-sin_e * cos_a, -sin_e * sin_a, cos_e],
            toward: [cos_e * cos_a, cos_e * sin_a, sin_e],
            projection: Projection::Parallel,
            target: [0.0; 3],
        }
    }

    /// The same view by a projection around a place, which every projection shows where it was.
    #[must_use]
    pub fn projected(&self, projection: Projection, target: Point<3>) -> View {
        View { projection, target, ..*self }
    }

    /// The projection.
    #[must_use]
    pub fn projection(&self) -> Projection {
        self.projection
    }

    /// The azimuth in radians, from above -π to π.
    #[must_use]
    pub fn azimuth(&self) -> f64 {
        self.azimuth
    }

    /// The elevation in radians, from above -π to π; beyond ±π/2 the view is upside down.
    #[must_use]
    pub fn elevation(&self) -> f64 {
        self.elevation
    }

    /// The direction towards the viewer, a unit vector.
    #[must_use]
    pub fn toward(&self) -> Point<3> {
        self.toward
    }

    /// Whether the axis z points down in the picture.
    #[must_use]
    pub fn upside_down(&self) -> bool {
        self.up[2] < 0.0
    }

    /// The view turned by angles in radians, freely over the poles.
    #[must_use]
    pub fn turned(&self, azimuth: f64, elevation: f64) -> View {
        View::from_angles(self.azimuth + azimuth, self.elevation + elevation)
            .projected(self.projection, self.target)
    }

    /// The view turned by one step of an arrow key. A step over a pole is not made, as in the original.
    #[must_use]
    pub fn stepped(&self, turn: Turn) -> View {
        let turned = self.stepped_across(turn);
        if turned.upside_down() == self.upside_down() { turned } else { *self }
    }

    /// The view turned by one step of an arrow key, without end: beyond a pole the view is upside down, and
    /// the front goes on following the arrows.
    #[must_use]
    pub fn stepped_across(&self, turn: Turn) -> View {
        let side = if self.upside_down() { -STEP } else { STEP };
        match turn {
            Turn::Up => self.turned(0.0, -STEP),
            Turn::Down => self.turned(0.0, STEP),
            Turn::Left => self.turned(side, 0.0),
            Turn::Right => self.turned(-side, 0.0),
        }
    }

    /// Where a point is from the origin before it is projected: to the right, up, and towards the viewer.
    #[must_use]
    pub fn seen(&self, point: Point<3>) -> Point<3> {
        [self.right, self.up, self.toward].map(|axis| dot(axis, point))
    }

    /// The same from the place that every projection shows alike.
    pub(crate) fn beside_target(&self, point: Point<3>) -> Point<3> {
        let (seen, target) = (self.seen(point), self.seen(self.target));
        std::array::from_fn(|d| seen[d] - target[d])
    }

    /// The image of a point: its place in the plane of the picture, to the right and up from the origin, and how near
    /// it is, a number that grows linearly along straight lines of the picture.
    #[must_use]
    pub fn image(&self, point: Point<3>) -> Point<3> {
        let seen = self.seen(point);
        if self.projection == Projection::Parallel {
            return seen;
        }
        let target = self.seen(self.target);
        let image = self.projection.image(std::array::from_fn(|d| seen[d] - target[d]));
        std::array::from_fn(|d| image[d] + target[d])
    }

    /// The place of a point in the plane of the picture: to the right and up from the origin.
    #[must_use]
    pub fn place(&self, point: Point<3>) -> Point<2> {
        let [right, up, _] = self.image(point);
        [right, up]
    }

    /// How near to the viewer a point is; of parallel rays, its place along the direction towards him.
    #[must_use]
    pub fn depth(&self, point: Point<3>) -> f64 {
        self.image(point)[2]
    }

    /// How much larger than in the plane of the picture things at a point look; 1 by parallel rays.
    #[must_use]
    pub fn magnification(&self, point: Point<3>) -> f64 {
        self.projection.magnification(dot(self.toward, point) - dot(self.toward, self.target))
    }

    /// The point that lies elsewhere in the picture, and as deep: moved to the right and up.
    #[must_use]
    pub fn moved(&self, point: Point<3>, by: Point<2>) -> Point<3> {
        let [right, up] = by.map(|x| x / self.magnification(point));
        std::array::from_fn(|d| point[d] + right * self.right[d] + up * self.up[d])
    }

    /// The place of a point on the originals' screen in pixels, which are whole numbers (halves
    /// rounded to even), at so many pixels for a unit of length.
    #[must_use]
    pub fn pixel(&self, point: Point<3>, scale: f64) -> [f64; 2] {
        let [right, up] = self.place(point);
        [CENTRE[0] + (scale * right).round_ties_even(), CENTRE[1] - (scale * up).round_ties_even()]
    }

    /// The indices of points from the farthest to the nearest, as they are painted; points of equal
    /// depth keep their order.
    #[must_use]
    pub fn far_to_near(&self, points: &[Point<3>]) -> Vec<usize> {
        let mut depths: Vec<(usize, f64)> =
            points.iter().map(|&point| self.depth(point)).enumerate().collect();
        depths.sort_by(|(_, one), (_, other)| one.total_cmp(other));
        depths.into_iter().map(|(index, _)| index).collect()
    }
}

/// An angle as from above -π to π.
fn wrapped(angle: f64) -> f64 {
    if !angle.is_finite() {
        return 0.0;
    }
    if -PI < angle && angle <= PI { angle } else { PI - (PI - angle).rem_euclid(TAU) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const TURNS: [(Turn, Turn); 4] = [
        (Turn::Up, Turn::Down),
        (Turn::Down, Turn::Up),
        (Turn::Left, Turn::Right),
        (Turn::Right, Turn::Left),
    ];

    /// The original's formulas: its view vector after an arrow, if it makes the step.
    fn original_step([a, b, c]: [f64; 3], turn: Turn) -> [f64; 3] {
        let (sin, cos) = STEP.sin_cos();
        let flat = a.hypot(b);
        let over = |sin: f64| {
            let factor = cos + c / flat * sin;
            [a * factor, b * factor, c * cos - flat * sin]
        };
        let around = |sin: f64| [a * cos + b * sin, -a * sin + b * cos, c];
        let to = match turn {
            Turn::Up => over(sin),
            Turn::Down => over(-sin),
            Turn::Right => around(sin),
            Turn::Left => around(-sin),
        };
        if to[0] * a > 0.0 || to[1] * b > 0.0 { to } else { [a, b, c] }
    }

    /// The original's projection.
    fn original_place([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 2] {
        let flat = a.hypot(b);
        let scale = flat * flat.hypot(c);
        [(a * y - b * x) / flat, (flat * flat * z - c * (a * x + b * y)) / scale]
    }

    fn close(a: &[f64], b: &[f64], tolerance: f64) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
    }

    #[test]
    fn a_view_along_z_is_a_view() {
        for direction in [[0.0, 0.0, 1.0], [0.0, 0.0, -2.0], [0.0; 3], [f64::NAN, 1.0, 0.0]] {
            let view = View::from_direction(direction);
            assert!(view.place([1.0, 2.0, 3.0]).iter().all(|value| value.is_finite()));
        }
        assert_eq!(View::from_direction([0.0, 0.0, 1.0]).place([0.0, 5.0, 0.0]), [5.0, 0.0]);
    }

    /// The top view of (4.17) has an azimuth however its zeros are signed, and is the limit of steep views.
    #[test]
    fn the_top_view_is_definite() {
        for (z, x_up) in [(1.0, -1.0), (-1.0, 1.0)] {
            for [x, y] in [[0.0, 0.0], [-0.0, 0.0], [0.0, -0.0], [-0.0, -0.0]] {
                let top = View::from_direction([x, y, z]);
                assert_eq!((top.azimuth(), top.elevation()), (0.0, z * PI / 2.0));
                assert!(close(&top.place([0.0, 3.0, 7.0]), &[3.0, 0.0], 1e-12));
                assert!(close(&top.place([3.0, 0.0, 7.0]), &[0.0, 3.0 * x_up], 1e-12));
                let steep = View::from_direction([1e-9, 0.0, z]);
                assert!(close(&top.place([3.0, 4.0, 0.0]), &steep.place([3.0, 4.0, 0.0]), 1e-8));
            }
        }
    }

    #[test]
    fn the_target_stays_where_it_was() {
        let (view, target) = (View::from_direction([0.4, -0.7, 0.2]), [30.0, -20.0, 90.0]);
        for distance in [200.0, 600.0, 1500.0] {
            let central = view.projected(Projection::Central(distance), target);
            assert!(close(&central.image(target), &view.image(target), 1e-12));
            let side = View { projection: Projection::Parallel, ..central.turned(0.1, 0.2) };
            assert_eq!(side, view.turned(0.1, 0.2).projected(Projection::Parallel, target));
        }
    }

    #[test]
    fn arrows_stop_before_the_poles_and_free_turning_goes_on() {
        let mut view = View::from_direction([0.7, 0.2, 0.3]);
        (0..100).for_each(|_| view = view.stepped(Turn::Down));
        assert!(view.elevation() < PI / 2.0 && view.elevation() + STEP > PI / 2.0);
        let over = view.turned(0.0, 2.0 * STEP);
        assert!(over.upside_down() && over.elevation() > PI / 2.0);
        // Beyond the pole, too, the front follows the arrows.
        for (turn, sign) in [(Turn::Right, 1.0), (Turn::Left, -1.0)] {
            for view in [view, over] {
                assert!(view.stepped(turn).place(view.toward)[0] * sign > 0.0);
            }
        }
    }

    #[test]
    fn far_points_have_places() {
        let view = View::from_direction([1.0, 0.3, 0.2]);
        let [x, y] = view.pixel([1e300, 1e300, -1e300], 8.0);
        assert!(!x.is_nan() && !y.is_nan());
        assert_eq!(view.far_to_near(&[[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), [1, 0, 2]);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(128))]

        #[test]
        fn turning_keeps_lengths(
            point in prop::array::uniform3(-1e4..1e4f64),
            angles in prop::array::uniform2(-9.0..9.0f64),
        ) {
            let view = View::from_angles(angles[0], angles[1]);
            let [right, up] = view.place(point);
            let seen = right.hypot(up).hypot(view.depth(point));
            let length = point[0].hypot(point[1]).hypot(point[2]);
            prop_assert!((seen - length).abs() <= 1e-11, "{seen} {length}");
            let back = view.moved(view.toward.map(|t| t * view.depth(point)), [right, up]);
            prop_assert!(close(&back, &point, 1e-11));
        }

        #[test]
        fn an_arrow_there_and_back_is_nothing(angles in prop::array::uniform2(-9.0..9.0f64), count in 1..200) {
            let start = View::from_angles(angles[0], angles[1]);
            for (there, back) in TURNS {
                let mut view = start;
                let mut made = 0;
                for _ in 0..count {
                    let next = view.stepped(there);
                    made += usize::from(next != view);
                    view = next;
                }
                (0..made).for_each(|_| view = view.stepped(back));
                for (one, other) in [(view.right, start.right), (view.up, start.up), (view.toward, start.toward)] {
                    prop_assert!(close(&one, &other, 1e-12), "{view:?} {start:?}");
                }
            }
        }

        #[test]
        fn steps_are_the_originals(
            direction in prop::array::uniform3(-1.0..1.0f64),
            turns in prop::collection::vec(0..4usize, 0..60),
            point in prop::array::uniform3(-500.0..500.0f64),
        ) {
            prop_assume!(direction[0].hypot(direction[1]) > 0.05);
            let mut vector = direction;
            let mut view = View::from_direction(direction);
            for turn in turns {
                vector = original_step(vector, TURNS[turn].0);
                view = view.stepped(TURNS[turn].0);
            }
            // Close to a pole the original's vector has lost digits.
            prop_assume!(vector[0].hypot(vector[1]) > 1e-3);
            prop_assert!(close(&view.place(point), &original_place(vector, point), 1e-8));
        }

        #[test]
        fn a_moved_point_is_as_deep(
            angles in prop::array::uniform2(-9.0..9.0f64),
            point in prop::array::uniform3(-1e3..1e3f64),
            by in prop::array::uniform2(-1e3..1e3f64),
        ) {
            let view = View::from_angles(angles[0], angles[1]);
            let moved = view.moved(point, by);
            prop_assert!((view.depth(moved) - view.depth(point)).abs() < 1e-11);
            let central = view.projected(Projection::Central(4000.0), [5.0, -7.0, 11.0]);
            let (from, to) = (central.image(point), central.image(central.moved(point, by)));
            prop_assert!(close(&to, &[from[0] + by[0], from[1] + by[1], from[2]], 1e-8));
            let (from, to) = (view.place(point), view.place(moved));
            prop_assert!(close(&[to[0] - from[0], to[1] - from[1]], &by, 1e-11));
        }
    }
}
