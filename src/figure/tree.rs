//! Which triangles may hide an edge: boxes around triangles, around boxes, and so on.
//!
//! Neighbours in a grid are neighbours in the picture, so the boxes are taken over squares of cells: they are found in
//! one pass, fit as closely where a net is dense as where it is wide, and an outlier makes a few of them large, not all
//! of them full.

/// A place in the picture with its depth; larger is nearer.
pub(super) type Place = [f64; 3];

/// Triangles of a box of the lowest level, and boxes of one of the next.
const TOGETHER: usize = 4;

/// The extent of triangles in the picture, and the nearest depth of them.
#[derive(Clone, Copy, Debug)]
struct Cover {
    low: [f64; 2],
    high: [f64; 2],
    nearest: f64,
}

impl Cover {
    fn of(places: &[Place]) -> Cover {
        let nothing =
            Cover { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2], nearest: f64::NEG_INFINITY };
        places.iter().fold(nothing, |cover, &[x, y, depth]| {
            cover.with(&Cover { low: [x, y], high: [x, y], nearest: depth })
        })
    }

    fn with(&self, other: &Cover) -> Cover {
        Cover {
            low: [self.low[0].min(other.low[0]), self.low[1].min(other.low[1])],
            high: [self.high[0].max(other.high[0]), self.high[1].max(other.high[1])],
            nearest: self.nearest.max(other.nearest),
        }
    }

    fn meets(&self, other: &Cover) -> bool {
        (0..2).all(|d| self.low[d] <= other.high[d] && other.low[d] <= self.high[d])
    }
}

/// Boxes over triangles in an order in which neighbours are near each other.
pub(super) struct Tree {
    /// Boxes of so many triangles, of so many of those, up to a single one.
    levels: Vec<Vec<Cover>>,
    triangles: usize,
}

impl Tree {
    /// The boxes over triangles by their corners.
    pub(super) fn new(triangles: impl Iterator<Item = [Place; 3]>) -> Tree {
        let covers: Vec<Cover> = triangles.map(|corners| Cover::of(&corners)).collect();
        let joined = |covers: &[Cover]| -> Vec<Cover> {
            let nothing = Cover::of(&[]);
            covers.chunks(TOGETHER).map(|part| part.iter().fold(nothing, |all, one| all.with(one))).collect()
        };
        let mut levels = vec![joined(&covers)];
        while let Some(level) = levels.last().filter(|level| level.len() > 1) {
            levels.push(joined(level));
        }
        Tree { levels, triangles: covers.len() }
    }

    /// Calls `look` for the numbers of triangles that may be over an edge in the picture and nearer somewhere than its
    /// farther end by more than `nearer`, roughly the nearest ones first, until it returns `true`.
    pub(super) fn visit(&self, ends: [Place; 2], nearer: f64, mut look: impl FnMut(usize) -> bool) {
        let edge = Cover::of(&ends);
        let least = ends[0][2].min(ends[1][2]) + nearer;
        let may_hide = |cover: &Cover| cover.nearest > least && cover.meets(&edge);
        let mut waiting = vec![(self.levels.len().saturating_sub(1), 0)];
        while let Some((level, number)) = waiting.pop() {
            let parts = TOGETHER * number..TOGETHER * (number + 1);
            let Some(below) = level.checked_sub(1) else {
                let here = self.levels.first().and_then(|level| level.get(number));
                if here.is_some_and(may_hide) && parts.take_while(|&it| it < self.triangles).any(&mut look) {
                    return;
                }
                continue;
            };
            let covers = self.levels.get(below).map_or(&[][..], Vec::as_slice);
            let first = waiting.len();
            let meeting = parts.filter(|&part| covers.get(part).is_some_and(may_hide));
            waiting.extend(meeting.map(|part| (below, part)));
            let nearest = |part: usize| covers.get(part).map_or(f64::NEG_INFINITY, |cover| cover.nearest);
            waiting[first..].sort_unstable_by(|one, other| nearest(one.1).total_cmp(&nearest(other.1)));
        }
    }
}

/// A number that grows along a curve through squares of cells, squares of squares, and so on, by row and column.
pub(super) fn along_squares([row, column]: [usize; 2]) -> u64 {
    // Every bit of a number of 32 moves apart from the next.
    let apart = |number: usize| {
        let steps = [(16, 0x0000_FFFF_0000_FFFF), (8, 0x00FF_00FF_00FF_00FF), (4, 0x0F0F_0F0F_0F0F_0F0F)];
        let last = [(2, 0x3333_3333_3333_3333), (1, 0x5555_5555_5555_5555)];
        let whole = number as u64 & 0xFFFF_FFFF;
        steps.into_iter().chain(last).fold(whole, |bits, (by, mask)| (bits | bits << by) & mask)
    };
    apart(row) << 1 | apart(column)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn squares_follow_each_other() {
        let mut cells: Vec<_> = (0..4).flat_map(|k| (0..4).map(move |l| [k, l])).collect();
        cells.sort_by_key(|&cell| along_squares(cell));
        assert_eq!(cells[..6], [[0, 0], [0, 1], [1, 0], [1, 1], [0, 2], [0, 3]]);
        assert_eq!(along_squares([0xFFFF_FFFF, 0]), 0xAAAA_AAAA_AAAA_AAAA);
    }

    proptest! {
        #[test]
        fn no_triangle_is_missed(
            triangles in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-1.0..1.0)), 0..99),
            ends in prop::array::uniform2(prop::array::uniform3(-1.0..1.0)),
        ) {
            let mut found = Vec::new();
            Tree::new(triangles.iter().copied()).visit(ends, 0.0, |number| {
                found.push(number);
                false
            });
            for (number, corners) in triangles.iter().enumerate() {
                let (cover, edge) = (Cover::of(corners), Cover::of(&ends));
                let may_hide = cover.meets(&edge) && cover.nearest > ends[0][2].min(ends[1][2]);
                prop_assert!(!may_hide || found.contains(&number));
            }
            let count = found.len();
            found.sort_unstable();
            found.dedup();
            prop_assert_eq!(found.len(), count);
        }
    }
}
