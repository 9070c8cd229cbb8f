//! One hit: when two balls or a ball and a wall meet, and what it does to their velocities.

use super::{Ball, Field, INERTIA, RADIUS, Surface, Vector, Wall};

/// Touching balls that approach more slowly than this, in pixels a second, stay as they are: it is the
/// rounding of earlier hits. While balls slow down to rest, it adds up to 2e-11 pixels.
const SLOWEST_APPROACH: f64 = 1e-12;

/// Distance of the centres of touching balls.
const CONTACT: f64 = 2.0 * RADIUS;

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

/// `a + t b`.
pub(super) fn moved(a: Vector, b: Vector, t: f64) -> Vector {
    [a[0] + t * b[0], a[1] + t * b[1]]
}

/// Seconds until two balls touch that lie `apart` from each other and move with a relative velocity; `None`
/// if they never do or get apart. This is equation (4.12) solved exactly, by the root that does not cancel.
pub(super) fn time_to_touch(apart: Vector, velocity: Vector) -> Option<f64> {
    let b = dot(apart, velocity);
    // Also false for NaN.
    if b >= 0.0 || b.is_nan() {
        return None;
    }
    let c = dot(apart, apart) - CONTACT * CONTACT;
    if c <= 0.0 {
        return (-b > SLOWEST_APPROACH * CONTACT).then_some(0.0);
    }
    let discriminant = b * b - dot(velocity, velocity) * c;
    (discriminant > 0.0).then(|| c / (discriminant.sqrt() - b))
}

/// The wall that a ball reaches first and the seconds until then, if that is not after `most` seconds.
pub(super) fn time_to_wall(field: &Field, at: Vector, velocity: Vector, most: f64) -> Option<(f64, Wall)> {
    let mut first: Option<(f64, Wall)> = None;
    for (axis, walls) in [[Wall::Left, Wall::Right], [Wall::Top, Wall::Bottom]].into_iter().enumerate() {
        let speed = velocity[axis];
        let end = at[axis] + speed * most;
        let (limit, wall) = if speed < 0.0 && end < field.min[axis] {
            (field.min[axis], walls[0])
        } else if speed > 0.0 && end > field.max[axis] {
            (field.max[axis], walls[1])
        } else {
            continue;
        };
        let time = ((limit - at[axis]) / speed).max(0.0);
        if first.is_none_or(|(earlier, _)| time < earlier) {
            first = Some((time, wall));
        }
    }
    first
}

/// How much of the sliding velocity one touch changes: the part of a rough hit's impulse that goes into
/// the velocity, for a ball of [`INERTIA`].
const GRIP: f64 = INERTIA / (1.0 + INERTIA);

/// The elastic hit of two touching balls of the same mass: they swap their velocities along the line of
/// centres (4.1 to 4.7). Of rough balls the sliding velocity of the surfaces is turned round as well.
pub(super) fn hit_balls(a: &mut Ball, b: &mut Ball, surface: Surface) {
    let apart = minus(b.at, a.at);
    let distance = dot(apart, apart).sqrt();
    // Balls in each other's centre cannot come about; they would have no line of centres.
    if distance <= 0.0 {
        return;
    }
    let normal = [apart[0] / distance, apart[1] / distance];
    let tangent = [-normal[1], normal[0]];
    let velocity = minus(a.velocity, b.velocity);
    let mut change = moved([0.0, 0.0], normal, dot(velocity, normal));
    if surface == Surface::Rough {
        let sliding = dot(velocity, tangent) + RADIUS * (a.spin + b.spin);
        let impulse = GRIP * sliding;
        change = moved(change, tangent, impulse);
        a.spin -= impulse / (INERTIA * RADIUS);
        b.spin -= impulse / (INERTIA * RADIUS);
    }
    a.velocity = minus(a.velocity, change);
    b.velocity = moved(b.velocity, change, 1.0);
}

/// The elastic hit of a ball on a wall. The ball is put exactly on its limit.
pub(super) fn hit_wall(field: &Field, ball: &mut Ball, wall: Wall, surface: Surface) {
    let (axis, limit, normal) = match wall {
        Wall::Left => (0, field.min[0], [-1.0, 0.0]),
        Wall::Right => (0, field.max[0], [1.0, 0.0]),
        Wall::Top => (1, field.min[1], [0.0, -1.0]),
        Wall::Bottom => (1, field.max[1], [0.0, 1.0]),
    };
    ball.at[axis] = limit;
    ball.velocity[axis] = -ball.velocity[axis];
    if surface == Surface::Rough {
        let tangent = [-normal[1], normal[0]];
        let sliding = dot(ball.velocity, tangent) + RADIUS * ball.spin;
        // A wall does not give way: twice what two balls do to each other.
        let impulse = 2.0 * GRIP * sliding;
        ball.velocity = moved(ball.velocity, tangent, -impulse);
        ball.spin -= impulse / (INERTIA * RADIUS);
    }
}
