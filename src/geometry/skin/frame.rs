//! Touching circles with a place where they begin, so that those of neighbours go round together.

use super::Sphere;
use super::touching::{TouchingCircle, flattened, perpendicular, unit};
use crate::geometry::{Point, cross, dot};
use std::f64::consts::PI;

/// A touching circle and how it is gone round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Framed {
    pub(super) circle: TouchingCircle,
    pub(super) sphere: Sphere,
    /// Unit vectors from the centre of the circle to where it begins, and to a quarter turn behind.
    pub(super) across: [Point<3>; 2],
}

/// How much of a vector its projection has to keep.
const LEAST: f64 = 1e-6;

/// The circles of a chain with their frames: each begins where the one before does, as far as the planes allow. In a
/// ring what is left over after a turn is spread evenly.
pub(super) fn framed(spheres: &[Sphere], circles: &[TouchingCircle], closed: bool) -> Vec<Framed> {
    let Some(first) = circles.first() else { return Vec::new() };
    let ball = |circle: &TouchingCircle| spheres.get(circle.sphere).copied();
    // Perpendicular to the plane of a chain, so that its section is the skin in the plane.
    let mut planes = circles.windows(3).filter_map(|three| {
        let [before, here, behind] = [0, 1, 2].map(|k| ball(&three[k]));
        let ([a, _, b], [x, y]) = flattened([&before?, &here?, &behind?]);
        let bent = (a.center[0] * b.center[1] - a.center[1] * b.center[0]).abs();
        let straight = (a.center[0] * b.center[0] + a.center[1] * b.center[1]).abs();
        (bent > LEAST * straight).then(|| cross(x, y))
    });
    let start = planes.find_map(|normal| projected(normal, first.axis));
    let mut begin = start.unwrap_or_else(|| perpendicular(first.axis));
    let mut last_axis = first.axis;
    let mut begins = Vec::with_capacity(circles.len() + 1);
    for circle in circles.iter().chain(closed.then_some(first)) {
        // Where the axis has turned into what was perpendicular to it, the frame turns with it.
        begin = projected(begin, circle.axis)
            .or_else(|| projected(last_axis.map(|x| -x * dot(begin, circle.axis).signum()), circle.axis))
            .unwrap_or_else(|| perpendicular(circle.axis));
        last_axis = circle.axis;
        begins.push(begin);
    }
    let left_over = match (begins.first(), begins.last()) {
        (Some(begin), Some(end)) if closed => angle(*end, *begin, first.axis),
        _ => 0.0,
    };
    let framed = circles.iter().zip(begins).enumerate().filter_map(|(k, (circle, begin))| {
        let turn = left_over * k as f64 / circles.len() as f64;
        let quarter = cross(circle.axis, begin);
        let turned = |c: f64, s: f64| -> Point<3> { std::array::from_fn(|d| c * begin[d] + s * quarter[d]) };
        let (sine, cosine) = turn.sin_cos();
        let across = [turned(cosine, sine), turned(-sine, cosine)];
        Some(Framed { circle: *circle, sphere: ball(circle)?, across })
    });
    framed.collect()
}

/// The unit vector in a plane that is nearest to another one; `None` where it is almost perpendicular to the plane.
fn projected(x: Point<3>, axis: Point<3>) -> Option<Point<3>> {
    let along = dot(x, axis);
    let rest: Point<3> = std::array::from_fn(|d| x[d] - along * axis[d]);
    (dot(rest, rest) > LEAST * LEAST).then(|| unit(rest)).flatten()
}

/// The angle from one unit vector to another one about an axis perpendicular to both, -pi to pi.
fn angle(from: Point<3>, to: Point<3>, axis: Point<3>) -> f64 {
    let angle = dot(cross(from, to), axis).atan2(dot(from, to));
    if angle.is_finite() { angle.clamp(-PI, PI) } else { 0.0 }
}

/// A quantity that depends on the angle by its sine and cosine: `[a, b, c]` is a + b cos f + c sin f.
pub(super) type Wave<T> = [T; 3];

impl Framed {
    /// The cosine of the angle at the centre of the sphere between the axis and the circle.
    pub(super) fn height(&self) -> f64 {
        let way: Point<3> = std::array::from_fn(|d| self.circle.center[d] - self.sphere.center[d]);
        dot(way, self.circle.axis) / self.sphere.radius
    }

    /// The points of the circle.
    pub(super) fn points(&self) -> Wave<Point<3>> {
        let [x, y] = self.across.map(|across| across.map(|c| self.circle.radius * c));
        [self.circle.center, x, y]
    }

    /// The unit vectors that are perpendicular to the circle and touch the sphere, in the direction of the chain.
    pub(super) fn forward(&self) -> Wave<Point<3>> {
        let (height, width) = (self.height(), self.circle.radius / self.sphere.radius);
        let [x, y] = self.across.map(|across| across.map(|c| -height * c));
        [self.circle.axis.map(|c| width * c), x, y]
    }
}
