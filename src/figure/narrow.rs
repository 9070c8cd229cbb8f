//! Triangles without area, and triangles back to back, taken out of a mesh so that what is closed stays closed.

use super::buckets::Buckets;
use super::closed::Fans;
use crate::geometry::{Point, cross, dot, norm, triangle_width};
use std::borrow::Cow;
use std::collections::{BinaryHeap, HashMap};

/// A triangle narrower than this part of its longest side has no area.
const NARROWEST: f64 = 1e-12;
/// Steps of taking triangles out, for each triangle; far more than are ever needed.
const PATIENCE: usize = 64;

/// The triangles that have an area, without pairs that lie back to back. If that are all, they are not copied.
pub(super) fn take_out<'a>(points: &[Point<3>], triangles: Cow<'a, [[usize; 3]]>) -> Cow<'a, [[usize; 3]]> {
    let triangles = if triangles.iter().any(|&corners| longest_of_narrow(points, corners).is_some()) {
        let mut net = Net::new(points, &triangles);
        net.take_out_narrow();
        Cow::Owned(net.triangles.into_iter().flatten().collect())
    } else {
        triangles
    };
    let mut gone = opposite(points.len(), &triangles);
    if gone.is_empty() {
        return triangles;
    }
    gone.sort_unstable();
    let left = triangles.iter().enumerate().filter(|(number, _)| gone.binary_search(number).is_err());
    left.map(|(_, corners)| *corners).collect()
}

/// Whether a triangle has no area.
pub(super) fn is_narrow(corners: [Point<3>; 3]) -> bool {
    longest_of_narrow(&corners, [0, 1, 2]).is_some()
}

/// A triangle without area, turned so that its longest side runs from its last corner to its first, with its length.
fn longest_of_narrow(points: &[Point<3>], [a, b, c]: [usize; 3]) -> Option<([usize; 3], f64)> {
    let point = |number: usize| points.get(number).copied().unwrap_or([0.0; 3]);
    let leg = |from: usize, to: usize| -> Point<3> {
        let (from, to) = (point(from), point(to));
        std::array::from_fn(|d| to[d] - from[d])
    };
    let (u, v, w) = (leg(a, b), leg(a, c), leg(b, c));
    let (product, longest) = (cross(u, v), dot(u, u).max(dot(v, v)).max(dot(w, w)));
    // Far from the limit, and where nothing overflows or vanishes, this is told in a fraction of the time.
    let wide = 4.0 * NARROWEST * longest;
    if longest < 1e100 && longest > 1e-100 && dot(product, product) > wide * wide {
        return None;
    }
    let turned = |corners: [usize; 3]| (corners, norm(leg(corners[2], corners[0])));
    let all = [[a, b, c], [b, c, a], [c, a, b]].map(turned);
    let (corners, longest) = all.into_iter().max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    let width = triangle_width(corners.map(point));
    (width <= NARROWEST * longest).then_some((corners, longest))
}

/// Triangles with what lies beside them.
struct Net<'a> {
    points: &'a [Point<3>],
    triangles: Vec<Option<[usize; 3]>>,
    along: Along<'a>,
}

/// The triangles that run from one point to another.
struct Along<'a> {
    /// The triangles as they were at first, by the points that they run from.
    first: &'a [[usize; 3]],
    fans: Option<Fans>,
    /// What has been asked for or changed; for the few triangles without area this is little.
    looked: HashMap<[usize; 2], Vec<usize>>,
}

impl Along<'_> {
    /// The triangles along a side, in the order in which they came there.
    fn side(&mut self, side: [usize; 2]) -> &mut Vec<usize> {
        let (first, fans) = (self.first, &self.fans);
        self.looked
            .entry(side)
            .or_insert_with(|| fans.iter().flat_map(|fans| fans.along(first, side)).collect())
    }
}

/// A triangle without area that waits to be taken out; that with the longest side comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Narrow {
    /// The bits of the length: positive doubles and their bits have the same order.
    longest: u64,
    triangle: usize,
}

impl<'a> Net<'a> {
    fn new(points: &'a [Point<3>], first: &'a [[usize; 3]]) -> Self {
        let fans = Fans::sorted(points.len(), first);
        let along = Along { first, fans, looked: HashMap::new() };
        Net { points, triangles: first.iter().copied().map(Some).collect(), along }
    }

    /// Puts another triangle, or none, in the place of one.
    fn put(&mut self, number: usize, corners: Option<[usize; 3]>) {
        let Some(slot) = self.triangles.get_mut(number) else { return };
        for side in std::mem::replace(slot, corners).into_iter().flat_map(sides) {
            self.along.side(side).retain(|&other| other != number);
        }
        for side in corners.into_iter().flat_map(sides) {
            self.along.side(side).push(number);
        }
    }

    /// A triangle, if it has no area, turned as [`longest_of_narrow`] does.
    fn narrow(&self, number: usize) -> Option<([usize; 3], f64)> {
        longest_of_narrow(self.points, self.triangles.get(number).copied().flatten()?)
    }

    /// Takes out the triangles whose corners lie on a line. One beside a border goes; else the side between it
    /// and its neighbour over the longest side is turned: the neighbour is cut where the third corner lies on
    /// its border, and nothing opens. The longest first, so that sides only become shorter.
    fn take_out_narrow(&mut self) {
        let waiting = |net: &Self, triangle: usize| {
            net.narrow(triangle).map(|(_, longest)| Narrow { longest: longest.to_bits(), triangle })
        };
        let mut heap: BinaryHeap<Narrow> =
            (0..self.triangles.len()).filter_map(|number| waiting(self, number)).collect();
        let mut patience = PATIENCE.saturating_mul(self.triangles.len());
        while let (Some(Narrow { triangle, .. }), true) = (heap.pop(), patience > 0) {
            patience -= 1;
            let Some(([a, b, c], _)) = self.narrow(triangle) else { continue };
            let Some((neighbour, d)) = self.beside([a, c], b) else {
                self.put(triangle, None);
                continue;
            };
            if b == d {
                // Two triangles back to back.
                self.put(triangle, None);
                self.put(neighbour, None);
                continue;
            }
            self.put(triangle, Some([b, c, d]));
            self.put(neighbour, Some([a, b, d]));
            heap.extend([triangle, neighbour].into_iter().filter_map(|number| waiting(self, number)));
        }
    }

    /// A triangle that runs along a side, with its third corner: the one back to back, if there is one.
    fn beside(&mut self, side: [usize; 2], back: usize) -> Option<(usize, usize)> {
        let triangles = &self.triangles;
        let third = |&number: &usize| {
            let corners = triangles.get(number).copied().flatten()?;
            Some((number, corners.into_iter().find(|corner| !side.contains(corner))?))
        };
        let beside = self.along.side(side);
        let all = || beside.iter().filter_map(third);
        all().find(|&(_, corner)| corner == back).or_else(|| all().next())
    }
}

/// The numbers of triangles that lie back to back in pairs, each with the last one before it that is still alone.
fn opposite(points: usize, triangles: &[[usize; 3]]) -> Vec<usize> {
    let least = triangles.iter().map(|corners| corners.iter().copied().min().unwrap_or(0));
    let Some(mut by_least) = Buckets::new(points, least) else { return Vec::new() };
    // The other two corners, the smaller one first, and whether they are so in the triangle.
    let others = |number: u32| {
        let [a, b, c] = triangles.get(number as usize).copied().unwrap_or_default();
        let (next, last) = if a < b && a < c {
            (b, c)
        } else if b < c {
            (c, a)
        } else {
            (a, b)
        };
        ([next.min(last), next.max(last)], next < last)
    };
    let mut gone = Vec::new();
    for of_corner in by_least.each_mut() {
        of_corner.sort_unstable_by_key(|&number| (others(number).0, number));
        for same in of_corner.chunk_by(|one, other| others(*one).0 == others(*other).0) {
            let mut alone = [Vec::new(), Vec::new()];
            for &number in same.iter().filter(|_| same.len() > 1) {
                let way = usize::from(others(number).1);
                match alone[1 - way].pop() {
                    Some(other) => gone.extend([number as usize, other]),
                    None => alone[way].push(number as usize),
                }
            }
        }
    }
    gone
}

fn sides([a, b, c]: [usize; 3]) -> [[usize; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    /// Pairs back to back by a map of the triangles.
    fn opposite_by_map(triangles: &[[usize; 3]]) -> Vec<usize> {
        let mut facing: BTreeMap<[usize; 3], Vec<usize>> = BTreeMap::new();
        let first = |[a, b, c]: [usize; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap();
        let mut gone = Vec::new();
        for (number, &[a, b, c]) in triangles.iter().enumerate() {
            match facing.get_mut(&first([a, c, b])).and_then(Vec::pop) {
                Some(other) => gone.extend([number, other]),
                None => facing.entry(first([a, b, c])).or_default().push(number),
            }
        }
        gone.sort_unstable();
        gone
    }

    proptest! {
        #[test]
        fn pairs_are_found(triangles in prop::collection::vec([0_usize..4, 0_usize..4, 0_usize..5], 0..40)) {
            let triangles: Vec<_> = triangles.into_iter().filter(|[a, b, c]| a != b && b != c && c != a).collect();
            let mut gone = opposite(5, &triangles);
            gone.sort_unstable();
            prop_assert_eq!(gone, opposite_by_map(&triangles));
        }

        /// A triangle that is told wide at once is so by its measures.
        #[test]
        fn wide_triangles_are_wide(corners in prop::array::uniform3(prop::array::uniform3(-1.0..1.0)), near in -16..0) {
            let [a, b, c] = corners;
            let beside = |d: usize| a[d] + 0.3 * (b[d] - a[d]) + 10.0_f64.powi(near) * c[d];
            let points = [a, b, std::array::from_fn(beside)];
            let sides = [[0, 1], [1, 2], [2, 0]].map(|[a, b]| norm::<3>(std::array::from_fn(|d| points[a][d] - points[b][d])));
            let longest = sides.into_iter().fold(0.0, f64::max);
            let narrow = triangle_width(points) <= NARROWEST * longest;
            prop_assert_eq!(longest_of_narrow(&points, [0, 1, 2]).is_some(), narrow);
        }
    }
}
