//! The net in the space of (p, q, r), where it is a C1 patchwork of bicubic patches.

use super::chart::Projection;
use crate::geometry::surface::indices;
use crate::geometry::{Patch, Point, dot};

/// The image (n_x, n_y, h)/(1 - n_z) of a point with its normal, where h = x·n.
fn image(point: Point<3>, normal: Point<3>) -> Point<3> {
    let below = 1.0 - normal[2];
    [normal[0] / below, normal[1] / below, dot(point, normal) / below]
}

/// The derivative nearest to the given one among those that a surface with this point and normal can have:
/// v·y' = 0 with v = (X + p Z, Y + q Z, -1).
fn admissible(derivative: Point<3>, [x, y, z]: Point<3>, at: Point<3>, projection: Projection) -> Point<3> {
    let v = [x + at[0] * z, y + at[1] * z, -1.0];
    match projection {
        Projection::Vertical => [derivative[0], derivative[1], v[0] * derivative[0] + v[1] * derivative[1]],
        Projection::Orthogonal(unit) => {
            let v = [v[0] / unit, v[1] / unit, -1.0];
            let b = [derivative[0], derivative[1], derivative[2] / unit];
            let part = dot(v, b) / dot(v, v);
            [b[0] - part * v[0], b[1] - part * v[1], unit * (b[2] - part * v[2])]
        }
    }
}

/// The patches of a net of points and normals in the chart, patch (i, j) at `i * (columns - 1) + j`: partially
/// bicubically blended Coons patches with Hermite borders, whose twists at the corners are zero.
///
/// Derivatives are half the difference of the neighbours, at the borders the difference of the last two points,
/// made admissible.
pub(super) fn patches(
    size: [usize; 2],
    points: &[Point<3>],
    normals: &[Point<3>],
    projection: Projection,
) -> Vec<Patch> {
    let images: Vec<Point<3>> = points.iter().zip(normals).map(|(x, n)| image(*x, *n)).collect();
    let index = |[i, j]: [usize; 2]| i * size[1] + j;
    let slope = |at: [usize; 2], direction: usize| {
        let (mut before, mut after) = (at, at);
        before[direction] = at[direction].saturating_sub(1);
        after[direction] = (at[direction] + 1).min(size[direction] - 1);
        let steps = (after[direction] - before[direction]).max(1) as f64;
        let (a, b) = (images[index(before)], images[index(after)]);
        let difference = std::array::from_fn(|d| (b[d] - a[d]) / steps);
        admissible(difference, points[index(at)], images[index(at)], projection)
    };
    let slopes: Vec<[Point<3>; 2]> = indices(size).map(|at| [slope(at, 0), slope(at, 1)]).collect();
    let patch = |[i, j]: [usize; 2]| {
        let (a, b, c, d) = (index([i, j]), index([i, j + 1]), index([i + 1, j]), index([i + 1, j + 1]));
        let twists = [0.0; 3];
        Patch::from_hermite(&[
            [images[a], images[b], slopes[a][1], slopes[b][1]],
            [images[c], images[d], slopes[c][1], slopes[d][1]],
            [slopes[a][0], slopes[b][0], twists, twists],
            [slopes[c][0], slopes[d][0], twists, twists],
        ])
    };
    indices(size.map(|count| count - 1)).map(patch).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Along a curve on a surface, y' of exact data is admissible: here of the paraboloid 2z = a x² + b y².
    #[test]
    fn exact_derivatives_are_admissible() {
        let (a, b) = (0.7, -0.4);
        let at = |t: f64| {
            let (x, y) = (0.3 + t, 0.5 - 2.0 * t + t * t);
            let length = (1.0 + (a * x).powi(2) + (b * y).powi(2)).sqrt();
            let normal = [a * x / length, b * y / length, -1.0 / length];
            ([x, y, 0.5 * (a * x * x + b * y * y)], normal)
        };
        let y = |t: f64| image(at(t).0, at(t).1);
        let h = 1e-5;
        let exact: Point<3> = std::array::from_fn(|d| (y(h)[d] - y(-h)[d]) / (2.0 * h));
        for projection in [Projection::Vertical, Projection::Orthogonal(1.0), Projection::Orthogonal(3.0)] {
            let same = admissible(exact, at(0.0).0, y(0.0), projection);
            assert!(same.iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-9), "{same:?} {exact:?}");
        }
        // The projection is idempotent, and what it takes away is perpendicular in the scaled space.
        let other = admissible([0.3, -1.0, 2.0], at(0.0).0, y(0.0), Projection::Orthogonal(3.0));
        let again = admissible(other, at(0.0).0, y(0.0), Projection::Orthogonal(3.0));
        assert!(again.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-15));
        let rest = [0.3 - other[0], -1.0 - other[1], (2.0 - other[2]) / 3.0];
        assert!(dot(rest, [other[0], other[1], other[2] / 3.0]).abs() < 1e-14);
    }
}
