//! Hits: when two balls or a ball and a wall meet, and what it does to their velocities.

use super::{Ball, Field, INERTIA, RADIUS, Surface, Vector, Wall};

/// Touching balls that approach more slowly than this, in pixels a second, stay as they are: it is the
/// rounding of earlier hits. While balls slow down to rest, it adds up to 2e-11 pixels.
const SLOWEST_APPROACH: f64 = 1e-12;

/// Hits that are less than this apart, in seconds, are at the same moment: what differs is rounding. It is a hundred
/// times what rounding does on the book's table, and the fastest balls roll 1e-8 pixels in it.
pub(super) const SAME_MOMENT: f64 = 1e-12;

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

/// Two touching balls, by their indices, and the direction from the first one's centre to the other's.
#[derive(Clone, Copy)]
struct Contact {
    balls: [usize; 2],
    normal: Vector,
}

/// What a contact does along the normal and along the tangent: velocities before, or impulses.
type Along = [f64; 2];

impl Contact {
    /// The contact of two balls. Balls in each other's centre cannot come about; they would have no line of centres.
    fn of(balls: &[Ball], [a, b]: [usize; 2]) -> Option<Contact> {
        let apart = minus(balls.get(b)?.at, balls.get(a)?.at);
        let distance = dot(apart, apart).sqrt();
        let normal = [apart[0] / distance, apart[1] / distance];
        (distance > 0.0).then_some(Contact { balls: [a, b], normal })
    }

    fn tangent(&self) -> Vector {
        [-self.normal[1], self.normal[0]]
    }

    /// How fast the balls approach, and how fast their surfaces slide on each other. Smooth surfaces do not feel that.
    fn velocities(&self, balls: &[Ball], surface: Surface) -> Along {
        let [a, b] = self.balls.map(|ball| balls[ball]);
        let velocity = minus(a.velocity, b.velocity);
        let sliding = match surface {
            Surface::Smooth => 0.0,
            Surface::Rough => dot(velocity, self.tangent()) + RADIUS * (a.spin + b.spin),
        };
        [dot(velocity, self.normal), sliding]
    }

    /// Gives both balls an impulse, which slows down what [`Contact::velocities`] tells.
    fn push(&self, balls: &mut [Ball], [along, across]: Along) {
        let change = moved(moved([0.0, 0.0], self.normal, along), self.tangent(), across);
        for (ball, sign) in self.balls.into_iter().zip([-1.0, 1.0]) {
            let ball = &mut balls[ball];
            ball.velocity = moved(ball.velocity, change, sign);
            ball.spin -= across / (INERTIA * RADIUS);
        }
    }
}

/// The elastic hits, at the same moment, of pairs of touching balls of the same mass that approach each other: every pair
/// swaps its velocities along the line of centres (4.1 to 4.7), and of rough balls the sliding velocity of the surfaces
/// is turned round as well.
///
/// A pair alone has its impulse at once. Pairs with a ball in common are solved together, so that no pair is the
/// first: the impulses are those that turn round all velocities of approach, and of these the least. That keeps energy
/// and momentum, whatever the impulses are. Where balls would have to pull, they let go.
pub(super) fn hit_together(balls: &mut [Ball], pairs: &[[usize; 2]], surface: Surface) {
    let mut contacts: Vec<Contact> = pairs.iter().filter_map(|&pair| Contact::of(balls, pair)).collect();
    loop {
        let impulses = impulses(balls, &contacts, surface);
        if impulses.iter().all(|[along, _]| *along >= 0.0) {
            contacts.iter().zip(impulses).for_each(|(contact, impulse)| contact.push(balls, impulse));
            return;
        }
        // Not all pull: the sum of impulse times velocity of approach is positive.
        let mut pushing = impulses.iter().map(|[along, _]| *along >= 0.0);
        contacts.retain(|_| pushing.next() == Some(true));
    }
}

/// The least impulses that turn round the velocities of all contacts.
fn impulses(balls: &[Ball], contacts: &[Contact], surface: Surface) -> Vec<Along> {
    if let [contact] = contacts {
        let [approach, sliding] = contact.velocities(balls, surface);
        return vec![[approach, GRIP * sliding]];
    }
    // Conjugate gradients from zero, which find the least of several solutions, in as many steps as there are unknowns
    // but for rounding. What impulses do to the velocities is seen on balls at rest.
    let resting: Vec<Ball> = balls.iter().map(|ball| Ball::resting(ball.at)).collect();
    let slowed = |impulses: &[Along]| -> Vec<Along> {
        let mut balls = resting.clone();
        contacts.iter().zip(impulses).for_each(|(contact, impulse)| contact.push(&mut balls, *impulse));
        contacts.iter().map(|contact| contact.velocities(&balls, surface).map(|v| -v)).collect()
    };
    let wanted = contacts.iter().map(|contact| contact.velocities(balls, surface).map(|v| 2.0 * v));
    let mut left: Vec<Along> = wanted.collect();
    let mut found = vec![[0.0; 2]; contacts.len()];
    let mut way = left.clone();
    let mut size = product(&left, &left);
    let enough = size * EXACT * EXACT;
    for _ in 0..8 * contacts.len() {
        let slows = slowed(&way);
        let steep = product(&way, &slows);
        // Also false for NaN.
        if !(size > enough && steep > 0.0) {
            break;
        }
        add(&mut found, &way, size / steep);
        add(&mut left, &slows, -size / steep);
        let before = std::mem::replace(&mut size, product(&left, &left));
        let ahead = std::mem::replace(&mut way, left.clone());
        add(&mut way, &ahead, size / before);
    }
    found
}

/// What part of the velocities may be left over when impulses are found: less than rounding.
const EXACT: f64 = 1e-16;

fn product(a: &[Along], b: &[Along]) -> f64 {
    a.iter().zip(b).map(|(a, b)| dot(*a, *b)).sum()
}

/// `a += t b`.
fn add(a: &mut [Along], b: &[Along], t: f64) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a = moved(*a, *b, t));
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
