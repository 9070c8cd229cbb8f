//! A face as the painter sees it, and the book's tests of two.

use super::Test;
use crate::geometry::Point;
use std::cmp::Ordering;

/// Part of a side at its ends where crossings do not count, as in the book's listing.
const END: f64 = 1e-3;

/// A flat face in the picture: pixels to the right and down, depth.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Face {
    pub(super) number: usize,
    pub(super) corners: Vec<Point<3>>,
    pub(super) mean: f64,
    /// The box around it in the picture.
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
    /// The least and the largest depth.
    pub(super) depths: [f64; 2],
    /// How far the corners are from one plane, in depth.
    pub(super) bent: f64,
    /// Twice the area, negative if it turns to the viewer.
    area: f64,
    /// Depth is `plane[0] x + plane[1] y + plane[2]`.
    plane: [f64; 3],
}

impl Face {
    /// `None` for what is no face.
    pub(super) fn new(number: usize, corners: &[Point<3>]) -> Option<Face> {
        if corners.len() < 3 || !corners.iter().flatten().all(|x| x.is_finite() && x.abs() < 1e9) {
            return None;
        }
        let count = corners.len() as f64;
        let middle: Point<3> =
            std::array::from_fn(|d| corners.iter().map(|corner| corner[d]).sum::<f64>() / count);
        // Newell's normal, which does not depend on where the corners begin.
        let mut normal = [0.0; 3];
        for (a, b) in sides(corners) {
            for (d, value) in normal.iter_mut().enumerate() {
                let (e, f) = ((d + 1) % 3, (d + 2) % 3);
                *value += (a[e] - b[e]) * (a[f] + b[f] - 2.0 * middle[f]);
            }
        }
        // The sum has twice the area, by (4.25) for every corner.
        let area: f64 = sides(corners).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum();
        let slopes =
            if normal[2].abs() > 1e-9 { [-normal[0] / normal[2], -normal[1] / normal[2]] } else { [0.0; 2] };
        let plane = [slopes[0], slopes[1], middle[2] - slopes[0] * middle[0] - slopes[1] * middle[1]];
        let of = |d: usize, pick: fn(f64, f64) -> f64| {
            corners.iter().map(|corner| corner[d]).reduce(pick).unwrap_or(0.0)
        };
        let mut face = Face {
            number,
            corners: corners.to_vec(),
            mean: middle[2],
            low: [of(0, f64::min), of(1, f64::min)],
            high: [of(0, f64::max), of(1, f64::max)],
            depths: [of(2, f64::min), of(2, f64::max)],
            bent: 0.0,
            area,
            plane,
        };
        // Of a face seen edge-on, that has no pixels, nothing is bent.
        if area.abs() > 1e-6 {
            face.bent = corners
                .iter()
                .map(|corner| (face.depth([corner[0], corner[1]]) - corner[2]).abs())
                .fold(0.0, f64::max);
        }
        Some(face)
    }

    /// Whether its outer side is seen: by the sign of (4.25).
    pub(super) fn turns_to_viewer(&self) -> bool {
        self.area < 0.0
    }

    /// Its depth at a place, which no corner is nearer or farther than.
    pub(super) fn depth(&self, [x, y]: [f64; 2]) -> f64 {
        (self.plane[0] * x + self.plane[1] * y + self.plane[2]).clamp(self.depths[0], self.depths[1])
    }

    /// Whether the boxes around both have more than a border in common.
    pub(super) fn boxes_overlap(&self, other: &Face) -> bool {
        (0..2).all(|d| self.low[d] < other.high[d] && other.low[d] < self.high[d])
    }

    /// What it is to another one where both are seen: `Less` if it is farther, so that it must be painted first. `None`
    /// if no test tells.
    pub(super) fn compared(&self, other: &Face, slack: f64) -> Option<(Ordering, Test)> {
        let told = |mine: f64, its: f64| ((mine - its).abs() > slack).then(|| mine.total_cmp(&its));
        for one in sides(&self.corners) {
            for another in sides(&other.corners) {
                let Some([s, t]) = crossing(one, another) else { continue };
                let at = |(a, b): (Point<3>, Point<3>), t: f64| a[2] + t * (b[2] - a[2]);
                if let Some(order) = told(at(one, s), at(another, t)) {
                    return Some((order, Test::Sides));
                }
            }
        }
        let mine = self.corners.iter().filter(|corner| other.holds([corner[0], corner[1]]));
        let its = other.corners.iter().filter(|corner| self.holds([corner[0], corner[1]]));
        let mine = mine.map(|&[x, y, depth]| (depth, other.depth([x, y])));
        let its = its.map(|&[x, y, depth]| (self.depth([x, y]), depth));
        mine.chain(its).find_map(|(mine, its)| Some((told(mine, its)?, Test::Corner)))
    }

    /// Whether a place of the picture is inside, not on the outline: by the sides that a ray to the right meets.
    fn holds(&self, [x, y]: [f64; 2]) -> bool {
        let near = |(a, b): (Point<3>, Point<3>)| {
            let way = [b[0] - a[0], b[1] - a[1]];
            let length = way[0].hypot(way[1]);
            let (along, off) =
                ((x - a[0]) * way[0] + (y - a[1]) * way[1], (x - a[0]) * way[1] - (y - a[1]) * way[0]);
            length == 0.0 || (off.abs() <= END * length && (0.0..=length * length).contains(&along))
        };
        !sides(&self.corners).any(near) && self.crossings(y).filter(|&at| at > x).count() % 2 == 1
    }

    /// Where the sides cross a row of the picture, in no order. Of a corner on the row only the side above counts.
    pub(super) fn crossings(&self, y: f64) -> impl Iterator<Item = f64> + '_ {
        let crosses = move |(a, b): &(Point<3>, Point<3>)| (a[1] <= y) != (b[1] <= y);
        sides(&self.corners)
            .filter(crosses)
            .map(move |(a, b)| a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
    }
}

/// The sides around a face.
fn sides(corners: &[Point<3>]) -> impl Iterator<Item = (Point<3>, Point<3>)> + '_ {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1))
}

/// Where two sides cross (4.29), as parts of both; not at their ends.
fn crossing((a, b): (Point<3>, Point<3>), (c, d): (Point<3>, Point<3>)) -> Option<[f64; 2]> {
    let (one, other, from) =
        ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]], [c[0] - a[0], c[1] - a[1]]);
    let whole = one[0] * other[1] - one[1] * other[0];
    let s = (from[0] * other[1] - from[1] * other[0]) / whole;
    let t = (from[0] * one[1] - from[1] * one[0]) / whole;
    // Parallel sides give no number inside.
    [s, t].iter().all(|x| (END..=1.0 - END).contains(x)).then_some([s, t])
}
