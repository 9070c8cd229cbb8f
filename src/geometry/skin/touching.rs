//! Circles along which a surface touches spheres.

use super::contact::{Contact, contacts, tangents};
use super::{Ball, Circle, Sphere};
use crate::geometry::point::{norm, scaled_difference};
use crate::geometry::{Point, cross, dot};

/// A circle on a sphere along which the surface touches it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchingCircle {
    /// The number of the sphere.
    pub sphere: usize,
    /// The centre of the circle.
    pub center: Point<3>,
    /// The unit normal of its plane, in the direction of the chain.
    pub axis: Point<3>,
    /// Its radius.
    pub radius: f64,
}

/// The plane of three centres, by two unit vectors.
type Plane = [Point<3>; 2];

/// Circles with a smaller part of the radius of their sphere are points.
const SMALLEST: f64 = 1e-9;

/// Three spheres in the plane of their centres, the middle one at the origin, and the plane.
pub(super) fn flattened([before, here, behind]: [&Sphere; 3]) -> ([Circle; 3], Plane) {
    let ways = [before, behind].map(|other| scaled_difference(1.0, here.center, other.center));
    let (long, short) = if norm(ways[0]) > norm(ways[1]) { (ways[0], ways[1]) } else { (ways[1], ways[0]) };
    let x = unit(long).unwrap_or([1.0, 0.0, 0.0]);
    let along = dot(short, x);
    let y = across(short, x, along);
    let flat = |ball: &Sphere, way: Point<3>| Ball::new([dot(way, x), dot(way, y)], ball.radius);
    ([flat(before, ways[0]), flat(here, [0.0; 3]), flat(behind, ways[1])], [x, y])
}

/// The unit vector perpendicular to `x` in the plane of it and another one; any, if both are parallel.
fn across(other: Point<3>, x: Point<3>, along: f64) -> Point<3> {
    let rest: Point<3> = std::array::from_fn(|d| other[d] - along * x[d]);
    let length = norm(rest);
    // What is left of nearly parallel vectors need not be perpendicular; once more it is.
    let first = (length > 1e-14 * norm(other)).then(|| rest.map(|c| c / length));
    let second = first.and_then(|y| unit(std::array::from_fn(|d| y[d] - dot(y, x) * x[d])));
    second.unwrap_or_else(|| perpendicular(x))
}

/// A unit vector perpendicular to another one.
pub(super) fn perpendicular(x: Point<3>) -> Point<3> {
    let least = (0..3).min_by(|&a, &b| x[a].abs().total_cmp(&x[b].abs())).unwrap_or(0);
    let mut edge = [0.0; 3];
    edge[least] = 1.0;
    unit(cross(x, edge)).unwrap_or([0.0, 0.0, 1.0])
}

/// A vector with the length 1; `None` for one without length or direction.
pub(super) fn unit(x: Point<3>) -> Option<Point<3>> {
    let length = norm(x);
    let unit = x.map(|c| c / length);
    unit.iter().all(|c| c.is_finite()).then_some(unit)
}

/// The touching circles of a chain of spheres, and those of a ring, which has no ends; `None` where there is none.
pub(super) fn touching_circles(
    spheres: &[Sphere],
    chain: &[usize],
    closed: bool,
) -> Vec<Option<TouchingCircle>> {
    let count = chain.len();
    let at = |k: usize| chain.get(k % count).and_then(|&number| Some((number, spheres.get(number)?)));
    let triple =
        |k: usize| -> Option<[(usize, &Sphere); 3]> { Some([at(k + count - 1)?, at(k)?, at(k + 1)?]) };
    (0..count)
        .map(|k| {
            let end = !closed && (k == 0 || k + 1 == count);
            if !end {
                return inner(triple(k)?);
            }
            match count {
                0 | 1 => None,
                2 => cone([at(0)?, at(1)?], k),
                _ => outer(triple(if k == 0 { 1 } else { k - 1 })?, if k == 0 { 0 } else { 2 }),
            }
        })
        .collect()
}

/// The touching circle of the middle one of three spheres.
fn inner(triple: [(usize, &Sphere); 3]) -> Option<TouchingCircle> {
    let ([before, here, behind], plane) = flattened(triple.map(|(_, sphere)| sphere));
    let [left, right] = contacts(&before, &here, &behind);
    spanned(triple[1], [left?, right?], plane)
}

/// That of an end sphere (0 or 2 of the three), from the circles that touch the middle one.
fn outer(triple: [(usize, &Sphere); 3], end: usize) -> Option<TouchingCircle> {
    let (flat, plane) = flattened(triple.map(|(_, sphere)| sphere));
    let [before, here, behind] = &flat;
    let [left, right] = contacts(before, here, behind).map(|contact| Some(contact?.moved(here, &flat[end])));
    spanned(triple[end], [left?, right?], plane)
}

/// That of one of two spheres, by the cone that touches both.
fn cone(pair: [(usize, &Sphere); 2], which: usize) -> Option<TouchingCircle> {
    // Any plane through the axis cuts it alike.
    let ([_, first, last], plane) = flattened([pair[0].1, pair[0].1, pair[1].1]);
    spanned(pair[which], tangents(&first, &last)?, plane)
}

/// The circle across the plane through two touching points of a sphere that lie in it.
fn spanned((number, sphere): (usize, &Sphere), pair: [Contact; 2], [x, y]: Plane) -> Option<TouchingCircle> {
    let [left, right] = pair.map(|contact| contact.normal);
    let across = [0.5 * (left[0] - right[0]), 0.5 * (left[1] - right[1])];
    let (middle, half) = ([0.5 * (left[0] + right[0]), 0.5 * (left[1] + right[1])], norm(across));
    let radius = half * sphere.radius;
    let is_circle = half > SMALLEST && radius.is_normal() && middle.iter().all(|x| x.is_finite());
    if !is_circle {
        return None;
    }
    let space = |[a, b]: [f64; 2]| -> Point<3> { std::array::from_fn(|d| a * x[d] + b * y[d]) };
    let axis = unit(space([across[1] / half, -across[0] / half]))?;
    Some(TouchingCircle { sphere: number, center: sphere.point(space(middle)), axis, radius })
}
