//! Normals where the derivatives alone have none: at the poles of a sphere's net, beside coinciding control
//! points. They are limits along short ways into the patch.

use super::patch::dot;
use super::{Body, Derivatives, Surface};
use crate::geometry::Point;
use crate::geometry::point::{norm, scaled_difference};

/// Derivatives shorter than this part of the largest coordinate may be nothing but rounding.
const SHORT: f64 = 1e-10;

/// The sine of an angle between two derivatives that may be nothing but rounding.
const NARROW: f64 = 1e-8;

/// The part of the way into the patch between the places that a limit is taken from.
const STEP: f64 = 1.0 / 1024.0;

/// Where ways into the patch lead to; several, as one may run along a line without normals.
const TARGETS: [[f64; 2]; 5] = [[0.5, 0.5], [0.25, 0.6], [0.7, 0.35], [0.1, 0.15], [0.85, 0.9]];

impl Surface {
    /// The unit normal at a place as in [`Surface::eval`], in the direction of r_u x r_v. Where these two span
    /// no plane, as at a pole, it is the limit along a way into the patch, to about 1e-8.
    ///
    /// `None` outside the spans, and where the patch is no more than a line or a point.
    #[must_use]
    pub fn normal(&self, i: usize, j: usize, u: f64, v: f64) -> Option<Point<3>> {
        let size = self.largest_coordinate(i, j)?;
        let (u, v) = (u.clamp(0.0, 1.0), v.clamp(0.0, 1.0));
        let at = |u: f64, v: f64| clear_normal(&self.derivatives(i, j, u, v)?, size);
        at(u, v).or_else(|| TARGETS.iter().find_map(|&target| limit(at, [u, v], target)))
    }

    /// The brightness of a place in parallel light: the cosine of the angle between the normal and the
    /// direction to the light, -1 to 1. Lines of equal brightness are isophotes; they have a corner where
    /// the tangent plane is continuous, but the curvature is not.
    ///
    /// `None` where [`Surface::normal`] is, and when the direction has no length.
    #[must_use]
    pub fn brightness(&self, i: usize, j: usize, u: f64, v: f64, light: Point<3>) -> Option<f64> {
        let length = norm(light);
        let normal = self.normal(i, j, u, v)?;
        let cosine = dot(normal, light.map(|x| x / length));
        cosine.is_finite().then(|| cosine.clamp(-1.0, 1.0))
    }

    /// The largest coordinate of a patch's control points: what rounding is measured by.
    fn largest_coordinate(&self, i: usize, j: usize) -> Option<f64> {
        let largest = |m: f64, p: &Point<3>| p.iter().fold(m, |m, x| m.max(x.abs()));
        match &self.body {
            Body::Patches(_) => Some(self.patch(i, j)?.p.iter().flatten().fold(0.0, largest)),
            Body::Bezier(net) => Some(net.iter().flatten().fold(0.0, largest)),
        }
    }
}

/// The normal of derivatives that are certainly more than rounding.
fn clear_normal(at: &Derivatives, size: f64) -> Option<Point<3>> {
    let (along_u, along_v) = (norm(at.u), norm(at.v));
    // Not greater, so that a NaN is refused too.
    if !(along_u > SHORT * size && along_v > SHORT * size) {
        return None;
    }
    let unit = Derivatives { u: at.u.map(|x| x / along_u), v: at.v.map(|x| x / along_v), ..*at };
    let normal = super::patch::cross(unit.u, unit.v);
    let sine = norm(normal);
    (sine > NARROW).then(|| normal.map(|x| x / sine))
}

/// The value at the beginning of a way from values at four equal steps of it, by the cubic through them.
/// `None` when they are no limit: one is missing, or they turn too fast.
fn limit(at: impl Fn(f64, f64) -> Option<Point<3>>, [u, v]: [f64; 2], target: [f64; 2]) -> Option<Point<3>> {
    let way = scaled_difference(1.0, [u, v], target);
    if norm(way) < 0.05 {
        return None;
    }
    let place = |step: f64| at(u + step * STEP * way[0], v + step * STEP * way[1]);
    let normals = [place(1.0)?, place(2.0)?, place(3.0)?, place(4.0)?];
    if normals.iter().any(|&other| dot(normals[0], other) < 0.9) {
        return None;
    }
    let [a, b, c, d] = normals;
    let start: Point<3> = std::array::from_fn(|x| 4.0 * (a[x] + c[x]) - 6.0 * b[x] - d[x]);
    let length = norm(start);
    (length > 0.5).then(|| start.map(|x| x / length))
}
