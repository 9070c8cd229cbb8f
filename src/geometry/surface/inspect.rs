//! What a surface is judged by: normals, brightness in parallel light, Gaussian curvature; also where the
//! derivatives alone have none, at the poles of a sphere's net and beside coinciding control points. There
//! they are limits along short ways into the patch.

use super::Derivatives;
use crate::geometry::param::clipped;
use crate::geometry::point::{norm, scaled_difference};
use crate::geometry::{BoundingBox, Point, cross, dot};

/// Derivatives shorter than this part of the patch may be nothing but rounding.
const SHORT: f64 = 1e-10;

/// The same in last bits of its coordinates.
const LAST_BITS: f64 = 4.0;

/// The sine of an angle between two derivatives that may be nothing but rounding.
const NARROW: f64 = 1e-8;

/// The part of the way into the patch between the places that a limit is taken from.
const STEP: f64 = 1.0 / 1024.0;

/// Where ways into the patch lead to; several, as one may run along a line without normals.
const TARGETS: [[f64; 2]; 5] = [[0.5, 0.5], [0.25, 0.6], [0.7, 0.35], [0.1, 0.15], [0.85, 0.9]];

/// The derivatives of a patch at a place.
type Patch<'a> = &'a dyn Fn([f64; 2]) -> Option<Derivatives>;

/// The unit normal, or its limit; `bounds` is round what the patch is made of.
pub(super) fn normal(patch: Patch<'_>, bounds: BoundingBox<3>, uv: [f64; 2]) -> Option<Point<3>> {
    let (uv, shortest) = (uv.map(clipped), shortest(bounds));
    let at = |uv: [f64; 2]| clear_normal(&patch(uv)?, shortest);
    at(uv).or_else(|| TARGETS.iter().find_map(|&target| normal_limit(at, way(uv, target)?)))
}

/// The Gaussian curvature, or its limit.
pub(super) fn gaussian_curvature(patch: Patch<'_>, bounds: BoundingBox<3>, uv: [f64; 2]) -> Option<f64> {
    let (uv, shortest) = (uv.map(clipped), shortest(bounds));
    let at = |uv: [f64; 2]| {
        let derivatives = patch(uv)?;
        clear_normal(&derivatives, shortest).and_then(|_| derivatives.gaussian_curvature())
    };
    at(uv).or_else(|| TARGETS.iter().find_map(|&target| curvature_limit(at, way(uv, target)?)))
}

/// The length up to which derivatives may be nothing but rounding.
fn shortest(bounds: BoundingBox<3>) -> f64 {
    (SHORT * bounds.extent()).max(LAST_BITS * bounds.last_bits())
}

/// The normal of derivatives that are certainly more than rounding.
fn clear_normal(at: &Derivatives, shortest: f64) -> Option<Point<3>> {
    let (along_u, along_v) = (norm(at.u), norm(at.v));
    // Not greater, so that a NaN is refused too.
    if !(along_u > shortest && along_v > shortest) {
        return None;
    }
    let unit = Derivatives { u: at.u.map(|x| x / along_u), v: at.v.map(|x| x / along_v), ..*at };
    let normal = cross(unit.u, unit.v);
    let sine = norm(normal);
    (sine > NARROW).then(|| normal.map(|x| x / sine))
}

/// Four places in equal steps from a place towards another; none when the other is too near.
fn way([u, v]: [f64; 2], target: [f64; 2]) -> Option<[[f64; 2]; 4]> {
    let whole = scaled_difference(STEP, [u, v], target);
    let place = |step: f64| [u + step * whole[0], v + step * whole[1]];
    (norm(whole) > 0.05 * STEP).then(|| [1.0, 2.0, 3.0, 4.0].map(place))
}

/// The value one step before four values in equal steps, by the cubic through them.
fn before([a, b, c, d]: [f64; 4]) -> f64 {
    4.0 * (a + c) - 6.0 * b - d
}

/// The normal where a way begins; `None` when one is missing on it, or they turn too fast to have a limit.
fn normal_limit(at: impl Fn([f64; 2]) -> Option<Point<3>>, way: [[f64; 2]; 4]) -> Option<Point<3>> {
    let [a, b, c, d] = way.map(at);
    let (a, b, c, d) = (a?, b?, c?, d?);
    if [b, c, d].iter().any(|&other| dot(a, other) < 0.9) {
        return None;
    }
    let start: Point<3> = std::array::from_fn(|x| before([a[x], b[x], c[x], d[x]]));
    let length = norm(start);
    (length > 0.5).then(|| start.map(|x| x / length))
}

/// The curvature where a way begins; `None` when one is missing on it, or they grow too fast to have a limit.
fn curvature_limit(at: impl Fn([f64; 2]) -> Option<f64>, way: [[f64; 2]; 4]) -> Option<f64> {
    let [a, b, c, d] = way.map(at);
    let values = [a?, b?, c?, d?];
    let largest = values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let start = before(values);
    // A pole of order 1 would be extrapolated to 4 - 3 + 4/3 - 1/4, more than twice the largest value.
    (start.abs() <= 1.5 * largest).then_some(start)
}
