//! The convex hull of points in space: what control points keep their surface in.
//!
//! Points are moved to a grid of 2^36 steps along the largest side of their box, a movement far below any picture's
//! accuracy. On it every question about the side of a plane has an exact answer in 128-bit integers, so that flat nets
//! and points on common lines need no tolerances.

use super::{BoundingBox, Point, cross, dot, norm};
use std::collections::HashMap;

/// Steps of the grid, as a power of two.
const BITS: i32 = 36;
/// Neighbouring triangles whose normals differ by a smaller sine make one face.
const FLAT: f64 = 1e-6;

type Whole = [i64; 3];

/// The convex hull of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hull {
    /// Its triangles as numbers of points, counterclockwise seen from outside. None where all points lie in a plane.
    pub triangles: Vec<[usize; 3]>,
    /// Its edges as numbers of points, without those between triangles of one face: the border of a flat hull, the two
    /// ends of points on a line.
    pub edges: Vec<[usize; 2]>,
}

/// The convex hull of points in space. Points that are not finite are left out.
#[must_use]
pub fn convex_hull(points: &[Point<3>]) -> Hull {
    let finite = |index: &usize| points.get(*index).is_some_and(|point| point.iter().all(|x| x.is_finite()));
    let indices: Vec<usize> = (0..points.len()).filter(finite).collect();
    let Some(bounds) = BoundingBox::around(indices.iter().map(|&index| points[index])) else {
        return Hull::default();
    };
    let side = (0..3).map(|axis| bounds.max[axis] - bounds.min[axis]).fold(0.0, f64::max);
    let scale = 2_f64.powi(BITS) / side;
    if !scale.is_finite() {
        return Hull::default();
    }
    let whole = |&index: &usize| {
        let point = points[index];
        // Not negative and at most 2^36.
        (index, std::array::from_fn(|axis| ((point[axis] - bounds.min[axis]) * scale).round() as i64))
    };
    let mut seen = HashMap::new();
    let grid: Vec<(usize, Whole)> =
        indices.iter().map(whole).filter(|(index, at)| seen.insert(*at, *index).is_none()).collect();
    match simplex(&grid) {
        Start::Point => Hull::default(),
        Start::Line(axis) => ends(&grid, axis),
        Start::Flat(axis) => border(&grid, axis),
        Start::Body(corners) => body(&grid, corners, points),
    }
}

fn minus(a: Whole, b: Whole) -> [i128; 3] {
    std::array::from_fn(|axis| i128::from(a[axis] - b[axis]))
}

fn product(a: [i128; 3], b: [i128; 3]) -> [i128; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn along(a: [i128; 3], b: [i128; 3]) -> i128 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// What the points span.
enum Start {
    Point,
    /// A line, along which this coordinate changes.
    Line(usize),
    /// A plane, whose normal has this coordinate.
    Flat(usize),
    /// Four points that lie in no plane, by their places in the list.
    Body([usize; 4]),
}

fn simplex(grid: &[(usize, Whole)]) -> Start {
    let Some(&(_, a)) = grid.first() else { return Start::Point };
    let other = |v: &[i128; 3]| v.iter().position(|x| *x != 0);
    let Some((j, ab)) = grid.iter().map(|&(_, p)| minus(p, a)).enumerate().find(|(_, v)| other(v).is_some())
    else {
        return Start::Point;
    };
    let normals = grid.iter().map(|&(_, p)| product(ab, minus(p, a)));
    let Some((k, normal)) = normals.enumerate().find(|(_, v)| other(v).is_some()) else {
        return Start::Line(other(&ab).unwrap_or(0));
    };
    match grid.iter().position(|&(_, p)| along(normal, minus(p, a)) != 0) {
        Some(l) if along(normal, minus(grid[l].1, a)) < 0 => Start::Body([0, j, k, l]),
        Some(l) => Start::Body([0, k, j, l]),
        None => Start::Flat(other(&normal).unwrap_or(0)),
    }
}

/// The two ends of points on a line.
fn ends(grid: &[(usize, Whole)], axis: usize) -> Hull {
    let end = |last: bool| {
        let by = |(_, p): &&(usize, Whole)| if last { p[axis] } else { -p[axis] };
        grid.iter().max_by_key(by).map(|(index, _)| *index)
    };
    Hull {
        triangles: Vec::new(),
        edges: end(false).zip(end(true)).map(|(a, b)| [a, b]).into_iter().collect(),
    }
}

/// The border of points in a plane: their hull after one coordinate is left out (Andrew's chains).
fn border(grid: &[(usize, Whole)], axis: usize) -> Hull {
    let flat = |p: Whole| [p[(axis + 1) % 3], p[(axis + 2) % 3]];
    let mut points: Vec<(usize, [i64; 2])> = grid.iter().map(|&(index, p)| (index, flat(p))).collect();
    points.sort_unstable_by_key(|&(_, p)| p);
    let turn = |[a, b, c]: [[i64; 2]; 3]| {
        let [u, v] = [b, c].map(|p| [i128::from(p[0] - a[0]), i128::from(p[1] - a[1])]);
        u[0] * v[1] - u[1] * v[0]
    };
    let mut ring: Vec<usize> = Vec::new();
    for back in [false, true] {
        let mut chain: Vec<(usize, [i64; 2])> = Vec::new();
        let ordered: Box<dyn Iterator<Item = _>> =
            if back { Box::new(points.iter().rev()) } else { Box::new(points.iter()) };
        for &(index, p) in ordered {
            while let [.., (_, a), (_, b)] = chain.as_slice()
                && turn([*a, *b, p]) <= 0
            {
                chain.pop();
            }
            chain.push((index, p));
        }
        // The last one begins the other chain.
        chain.pop();
        ring.extend(chain.into_iter().map(|(index, _)| index));
    }
    let edges = ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]).collect();
    Hull { triangles: Vec::new(), edges }
}

/// A triangle of the growing hull: places in the list, and its plane.
#[derive(Clone)]
struct Face {
    corners: [usize; 3],
    normal: [i128; 3],
    /// The same in doubles, and how far a value of it may be off.
    near: [f64; 3],
    off: f64,
}

impl Face {
    fn new(grid: &[(usize, Whole)], corners: [usize; 3]) -> Self {
        let [a, b, c] = corners.map(|corner| grid[corner].1);
        let normal = product(minus(b, a), minus(c, a));
        let near = normal.map(|x| x as f64);
        // Differences are exact; three products and their sum round by a few units in the last place.
        let off = 1e-14 * 3.0 * 2_f64.powi(BITS) * near.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        Self { corners, normal, near, off }
    }

    /// Whether a point lies outside of it.
    fn sees(&self, grid: &[(usize, Whole)], point: Whole) -> bool {
        let from = grid[self.corners[0]].1;
        let rough: f64 = (0..3).map(|axis| self.near[axis] * (point[axis] - from[axis]) as f64).sum();
        if rough.abs() > self.off { rough > 0.0 } else { along(self.normal, minus(point, from)) > 0 }
    }
}

/// The hull of points that do not lie in a plane: one point after the other, every face that it sees gives way to
/// triangles from the rim of what it sees.
fn body(grid: &[(usize, Whole)], [a, b, c, d]: [usize; 4], points: &[Point<3>]) -> Hull {
    let mut faces: Vec<Face> =
        [[a, b, c], [a, d, b], [b, d, c], [c, d, a]].map(|corners| Face::new(grid, corners)).into();
    for (place, &(_, point)) in grid.iter().enumerate() {
        let (gone, stay): (Vec<Face>, Vec<Face>) = faces.into_iter().partition(|face| face.sees(grid, point));
        faces = stay;
        let sides = |face: &Face| {
            let [a, b, c] = face.corners;
            [[a, b], [b, c], [c, a]]
        };
        let inner: std::collections::HashSet<[usize; 2]> = gone.iter().flat_map(sides).collect();
        let rim = gone.iter().flat_map(sides).filter(|[a, b]| !inner.contains(&[*b, *a]));
        faces.extend(rim.map(|[a, b]| Face::new(grid, [a, b, place])));
    }
    let triangles: Vec<[usize; 3]> =
        faces.iter().map(|face| face.corners.map(|corner| grid[corner].0)).collect();
    let edges = sharp(&triangles, points);
    Hull { triangles, edges }
}

/// The edges between triangles that do not make one face.
fn sharp(triangles: &[[usize; 3]], points: &[Point<3>]) -> Vec<[usize; 2]> {
    let normal = |&[a, b, c]: &[usize; 3]| {
        let side = |to: usize| std::array::from_fn(|axis| points[to][axis] - points[a][axis]);
        let normal: Point<3> = cross(side(b), side(c));
        normal.map(|x| x / norm(normal))
    };
    let mut of: HashMap<[usize; 2], Point<3>> = HashMap::new();
    for triangle in triangles {
        let [a, b, c] = *triangle;
        let normal = normal(triangle);
        of.extend([[a, b], [b, c], [c, a]].map(|side| (side, normal)));
    }
    let bends = |&[a, b]: &[usize; 2]| match (of.get(&[a, b]), of.get(&[b, a])) {
        (Some(&one), Some(&other)) => {
            let sine = norm(cross(one, other));
            // A needle's normal is no number, and tells nothing.
            !(sine < FLAT && dot(one, other) > 0.0) && sine.is_finite()
        }
        _ => true,
    };
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    sides.filter(|[a, b]| a < b).filter(bends).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn side([a, b, c]: [Point<3>; 3], p: Point<3>) -> f64 {
        let from = |q: Point<3>| std::array::from_fn(|axis| q[axis] - a[axis]);
        dot(cross(from(b), from(c)), from(p))
    }

    /// Corners of all triangles that have every point on one side.
    fn brute(points: &[Point<3>]) -> Vec<usize> {
        let n = points.len();
        let mut corners = std::collections::BTreeSet::new();
        for (i, j, k) in (0..n).flat_map(|i| (i + 1..n).flat_map(move |j| (j + 1..n).map(move |k| (i, j, k))))
        {
            // The corners themselves are off their plane by rounding.
            let others = (0..n).filter(|p| ![i, j, k].contains(p));
            let sides: Vec<f64> =
                others.map(|p| side([points[i], points[j], points[k]], points[p])).collect();
            if sides.iter().all(|s| *s >= 0.0) != sides.iter().all(|s| *s <= 0.0) {
                corners.extend([i, j, k]);
            }
        }
        corners.into_iter().collect()
    }

    fn corners(hull: &Hull) -> Vec<usize> {
        let all: std::collections::BTreeSet<usize> = hull.triangles.iter().flatten().copied().collect();
        all.into_iter().collect()
    }

    /// Euler's formula for closed bodies of triangles, every edge in both directions once.
    fn closed(hull: &Hull) -> bool {
        let sides = hull.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let all: std::collections::HashSet<[usize; 2]> = sides.collect();
        let both = all.iter().all(|[a, b]| all.contains(&[*b, *a]));
        both && all.len() == 3 * hull.triangles.len()
            && corners(hull).len() + hull.triangles.len() == all.len() / 2 + 2
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(128))]
        #[test]
        fn is_that_of_all_triangles(points in prop::collection::vec(prop::array::uniform3(-50.0..50.0), 4..14)) {
            let hull = convex_hull(&points);
            prop_assert!(closed(&hull));
            prop_assert_eq!(corners(&hull), brute(&points));
            for triangle in &hull.triangles {
                let plane = triangle.map(|index| points[index]);
                prop_assert!(points.iter().all(|&p| side(plane, p) < 1e-4), "outside");
            }
        }

        /// Whole numbers lie in common planes and on common lines.
        #[test]
        fn has_all_points_inside_wherever_they_lie(
            points in prop::collection::vec(prop::array::uniform3(-2_i8..3), 1..40),
        ) {
            let points: Vec<Point<3>> = points.iter().map(|p| p.map(f64::from)).collect();
            let hull = convex_hull(&points);
            for triangle in &hull.triangles {
                let plane = triangle.map(|index| points[index]);
                prop_assert!(points.iter().all(|&p| side(plane, p) <= 0.0));
            }
            prop_assert!(hull.triangles.is_empty() || closed(&hull));
            // Every edge is on the hull: no point is on the other side of some plane through it.
            prop_assert!(hull.edges.iter().flatten().all(|index| *index < points.len()));
        }
    }

    #[test]
    fn a_cube_has_twelve_edges_with_and_without_points_on_its_faces() {
        let mut cube: Vec<Point<3>> =
            (0..8).map(|k| [k & 1, (k >> 1) & 1, k >> 2].map(|x| 100.0 * f64::from(x))).collect();
        assert_eq!(convex_hull(&cube).edges.len(), 12);
        cube.extend([[50.0, 50.0, 0.0], [50.0, 50.0, 50.0], [100.0, 20.0, 30.0], [0.0, 0.0, 0.0]]);
        let hull = convex_hull(&cube);
        assert!(closed(&hull));
        assert_eq!((hull.edges.len(), corners(&hull)), (12, (0..8).collect()));
    }

    #[test]
    fn flat_points_have_a_border_and_points_on_a_line_two_ends() {
        let net: Vec<Point<3>> =
            (0..25).map(|k| [f64::from(k % 5), f64::from(k / 5), f64::from(k % 5) * 2.0]).collect();
        let hull = convex_hull(&net);
        assert_eq!(hull.triangles.len(), 0);
        let mut corners: Vec<usize> = hull.edges.iter().flatten().copied().collect();
        corners.sort_unstable();
        assert_eq!(corners, [0, 0, 4, 4, 20, 20, 24, 24]);
        let line: Vec<Point<3>> = [3.0, 1.0, 2.0].map(|x| [x, 2.0 * x, 0.0]).into();
        assert_eq!(convex_hull(&line).edges, [[1, 0]]);
        assert_eq!(convex_hull(&[[1.0; 3]; 4]), Hull::default());
        assert_eq!(convex_hull(&[[f64::NAN; 3]; 4]), Hull::default());
        assert_eq!(convex_hull(&[]), Hull::default());
    }
}
