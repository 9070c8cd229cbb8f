//! Exact data of known surfaces, for tests.

use super::PnData;
use crate::geometry::Point;
use crate::geometry::point::norm;

/// A surface by parameters s and t in [-1, 1]: point and normal of any length.
pub(super) type Example = fn(f64, f64) -> (Point<3>, Point<3>);

/// The data of an example in rows of s.
pub(super) fn data(example: Example, rows: usize, columns: usize) -> PnData {
    let at = |i: usize, j: usize| {
        let place = |k: usize, count: usize| 2.0 * k as f64 / (count - 1) as f64 - 1.0;
        let (point, normal) = example(place(i, rows), place(j, columns));
        let length = norm(normal);
        (point, normal.map(|x| x / length))
    };
    let points: Vec<_> = (0..rows).map(|i| (0..columns).map(|j| at(i, j).0).collect()).collect();
    let normals: Vec<_> = (0..rows).map(|i| (0..columns).map(|j| at(i, j).1).collect()).collect();
    PnData::new(&points, &normals).expect("the examples are right")
}

/// A cap of the sphere round (2, -1, 3) with radius 30.
pub(super) fn sphere(s: f64, t: f64) -> (Point<3>, Point<3>) {
    let normal = [(0.7 * s).tan(), (0.7 * t).tan(), -1.0];
    let factor = 30.0 / norm(normal);
    ([2.0 + factor * normal[0], -1.0 + factor * normal[1], 3.0 + factor * normal[2]], normal)
}

/// The graph of a x² + b y².
fn graph(a: f64, b: f64, [x, y]: [f64; 2]) -> (Point<3>, Point<3>) {
    ([x, y, a * x * x + b * y * y], [2.0 * a * x, 2.0 * b * y, -1.0])
}

/// A vault.
pub(super) fn paraboloid(s: f64, t: f64) -> (Point<3>, Point<3>) {
    graph(0.01, 0.025, [20.0 * s, 15.0 * t])
}

/// A saddle.
pub(super) fn saddle(s: f64, t: f64) -> (Point<3>, Point<3>) {
    graph(0.15, -0.1, [2.0 * s, 2.0 * t])
}

/// A cylinder.
pub(super) fn cylinder(s: f64, t: f64) -> (Point<3>, Point<3>) {
    ([5.0 * s.sin(), 3.0 * t, -5.0 * s.cos()], [s.sin(), 0.0, -s.cos()])
}

/// A torus of radii 60 and 25 at the angle `t` about its circle, 0 outside.
fn torus(s: f64, t: f64) -> (Point<3>, Point<3>) {
    let normal = [t.cos() * s.cos(), t.cos() * s.sin(), t.sin()];
    let point = [60.0 * s.cos() + 25.0 * normal[0], 60.0 * s.sin() + 25.0 * normal[1], 25.0 * normal[2]];
    (point, normal)
}

/// The outside of the torus.
pub(super) fn torus_outside(s: f64, t: f64) -> (Point<3>, Point<3>) {
    torus(0.6 * s, 0.6 * t)
}

/// Over the crest of the torus, where it is parabolic.
pub(super) fn torus_crest(s: f64, t: f64) -> (Point<3>, Point<3>) {
    torus(0.6 * s, 1.5 + 0.6 * t)
}
