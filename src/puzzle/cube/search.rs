//! The search for fillings of the cube. Every node keeps the list of places that are still free, and
//! branches on the cell with the fewest of them. How many there are for each of the 64 cells is counted for
//! all cells at once, in numbers whose binary digits lie in four words: a few operations for each place of
//! the list.

use super::place::{Filling, KINDS, Placed, SUPPLY, places};

/// A node of the search: what is filled and what may still come.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) filled: u64,
    /// Pieces that are left of every type.
    pub(super) left: [u8; KINDS],
    /// Free places, the types one after the other.
    live: Vec<u64>,
    /// Where the places of every type begin, and the end of the last.
    starts: [usize; KINDS + 1],
}

/// On what a node branches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Pivot {
    /// Nothing is left to fill.
    Full,
    /// Some cell or type cannot be served.
    Dead,
    /// A cell, as a mask of one bit.
    Cell(u64),
}

impl Node {
    /// The empty cube with these places, sorted by type.
    fn new(places: &[Placed], left: [u8; KINDS]) -> Node {
        let live = places.iter().map(|placed| placed.mask).collect();
        let start = |kind| places.partition_point(|placed| placed.kind < kind);
        Node { filled: 0, left, live, starts: std::array::from_fn(start) }
    }

    /// The places of a type.
    #[inline]
    pub(super) fn of_kind(&self, kind: usize) -> &[u64] {
        self.live.get(self.starts[kind]..self.starts[kind + 1]).unwrap_or_default()
    }

    /// Makes another node what this one becomes with a piece in a place.
    #[inline]
    fn place(&self, mask: u64, kind: usize, child: &mut Node) -> Pivot {
        child.filled = self.filled | mask;
        child.left = self.left;
        child.left[kind] = child.left[kind].saturating_sub(1);
        if !balanced(!child.filled, &child.left) || !can_be_filled(!child.filled) {
            return Pivot::Dead;
        }
        let mut end = 0;
        for other in 0..KINDS {
            let begin = end;
            child.starts[other] = begin;
            let left = usize::from(child.left[other]);
            if left == 0 {
                continue;
            }
            for &place in self.of_kind(other) {
                // A list is never longer than that of the parent.
                let Some(slot) = child.live.get_mut(end) else { break };
                *slot = place;
                end += usize::from(place & mask == 0);
            }
            if end - begin < left {
                return Pivot::Dead;
            }
        }
        child.starts[KINDS] = end;
        let [ones, twos, fours, many] = tallies(child.live.get(..end).unwrap_or_default());
        let empty = !child.filled;
        if empty == 0 {
            return Pivot::Full;
        }
        if empty & !(ones | twos | fours | many) != 0 {
            return Pivot::Dead;
        }
        let few = empty & !many;
        for count in 1..8 {
            let digit = |plane: u64, bit: usize| if count >> bit & 1 == 1 { plane } else { !plane };
            let cells = few & digit(ones, 0) & digit(twos, 1) & digit(fours, 2);
            if cells != 0 {
                return Pivot::Cell(cells & cells.wrapping_neg());
            }
        }
        // Only near the root: all cells are counted out.
        let mut counts = [0_u16; 64];
        for &place in child.live.iter().take(end) {
            let mut rest = place;
            while rest != 0 {
                counts[rest.trailing_zeros() as usize & 63] += 1;
                rest &= rest - 1;
            }
        }
        let best = (0..64).filter(|bit| empty >> bit & 1 == 1).min_by_key(|&bit: &usize| counts[bit & 63]);
        Pivot::Cell(best.map_or(0, |bit| 1 << bit))
    }

    /// The ways to go on from here.
    fn branches(&self, pivot: Pivot, into: &mut Vec<Placed>) {
        into.clear();
        let Pivot::Cell(cell) = pivot else { return };
        for kind in 0..KINDS {
            let serving = self.of_kind(kind).iter().filter(|&&mask| mask & cell != 0);
            into.extend(serving.map(|&mask| Placed { kind, mask }));
        }
    }
}

/// How many of the masks have each bit: three binary digits, and whether it is eight or more.
fn tallies(masks: &[u64]) -> [u64; 4] {
    const LANES: usize = 4;
    let [mut ones, mut twos, mut fours, mut many] = [[0_u64; LANES]; 4];
    let mut add = |lane: usize, mask: u64| {
        let carry = ones[lane] & mask;
        ones[lane] ^= mask;
        let carry_on = twos[lane] & carry;
        twos[lane] ^= carry;
        many[lane] |= fours[lane] & carry_on;
        fours[lane] ^= carry_on;
    };
    // Lanes that do not wait for each other, of which the processor works on several at once.
    let chunks = masks.chunks_exact(LANES);
    for (lane, &mask) in chunks.remainder().iter().enumerate() {
        add(lane % LANES, mask);
    }
    for chunk in chunks {
        for (lane, &mask) in chunk.iter().enumerate() {
            add(lane % LANES, mask);
        }
    }
    let [mut one, mut two, mut four, mut lot] = [0; 4];
    for lane in 0..LANES {
        let carry = one & ones[lane];
        one ^= ones[lane];
        let carry_on = two & twos[lane] | carry & (two ^ twos[lane]);
        two ^= twos[lane] ^ carry;
        lot |= many[lane] | four & fours[lane] | carry_on & (four ^ fours[lane]);
        four ^= fours[lane] ^ carry_on;
    }
    [one, two, four, lot]
}

/// Whether black and white cells can come out even, the cells coloured as a chessboard in space: a piece of
/// four cells has two of each colour, one of five (the first three types) has one more of either.
#[inline]
const fn balanced(empty: u64, left: &[u8; KINDS]) -> bool {
    const BLACK: u64 = 0xA5A5_5A5A_A5A5_5A5A;
    let [one, two, three, ..] = *left;
    let (black, white) = ((empty & BLACK).count_ones(), (empty & !BLACK).count_ones());
    black.abs_diff(white) <= (one + two + three) as u32
}

/// Numbers of cells that pieces of four and five cannot fill, as bits.
const NO_SUMS: u64 = 1 << 1 | 1 << 2 | 1 << 3 | 1 << 6 | 1 << 7 | 1 << 11;

/// The cells beside those of a mask.
#[inline]
pub(super) const fn beside(cells: u64) -> u64 {
    const LEFT: u64 = 0x1111_1111_1111_1111;
    const FRONT: u64 = 0x000F_000F_000F_000F;
    let x = (cells & !LEFT) >> 1 | (cells << 1) & !LEFT;
    let y = (cells & !FRONT) >> 4 | (cells << 4) & !FRONT;
    x | y | cells >> 16 | cells << 16
}

/// Whether every connected part of the empty cells has a number of cells that pieces can have together: a
/// quick look before all places are gone through.
#[inline]
fn can_be_filled(empty: u64) -> bool {
    if empty & !beside(empty) != 0 {
        return false;
    }
    let mut rest = empty;
    while rest != 0 {
        let mut part = rest & rest.wrapping_neg();
        loop {
            let grown = part | beside(part) & rest;
            let more = grown | beside(grown) & rest;
            if more == part {
                break;
            }
            part = more;
        }
        // At most 64 cells; so many can be filled.
        if NO_SUMS.checked_shr(part.count_ones()).unwrap_or(0) & 1 == 1 {
            return false;
        }
        rest &= !part;
    }
    true
}

/// A node with its ways to go on.
#[derive(Clone, Debug)]
struct Level {
    node: Node,
    branches: Vec<Placed>,
    next: usize,
}

/// The tree of the search with the node that it is at.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    levels: Vec<Level>,
    /// The node that is worked on; `None` at the end.
    depth: Option<usize>,
    /// Nodes above this one are fixed: the search ends below it.
    floor: usize,
    /// Nodes with at most so many places are told, and not gone into.
    pub(super) few: usize,
    /// Nodes made so far.
    pub(super) nodes: u64,
}

/// What came of some work on a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turn {
    /// A filling is found; [`Tree::chosen`] tells it.
    Full,
    /// A node is met that has few places ([`Tree::few`]); what lies below it is left out.
    Few,
    /// The budget is used up.
    Spent,
    /// There is no more.
    Over,
}

impl Tree {
    /// The search from an empty cube with some places, sorted by type, and some pieces fixed in it.
    /// `None` if they cannot lie so, or nothing can be added to them.
    pub(super) fn new(places: &[Placed], fixed: &[Placed]) -> Option<Tree> {
        let mut root = Node::new(places, SUPPLY);
        let mut pivot = Pivot::Dead;
        // A piece that fills nothing finds the first branching of the empty cube.
        let mut lay = |placed: Placed| {
            let there_is_one = root.left.get(placed.kind).is_some_and(|&left| left > 0);
            if !there_is_one || root.filled & placed.mask != 0 {
                return false;
            }
            let mut child = root.clone();
            pivot = root.place(placed.mask, placed.kind, &mut child);
            root = child;
            true
        };
        if !fixed.iter().all(|&placed| lay(placed)) {
            return None;
        }
        if fixed.is_empty() {
            pivot = Pivot::Cell(1);
        }
        if pivot == Pivot::Dead {
            return None;
        }
        let empty = Level { node: root, branches: Vec::new(), next: 0 };
        // One for every piece and one for the end.
        let mut levels = vec![empty; super::PIECES + 2];
        let top = levels.first_mut()?; // there are sixteen
        top.node.branches(pivot, &mut top.branches);
        Some(Tree { levels, depth: Some(0), floor: 0, few: 0, nodes: 0 })
    }

    /// The pieces that lead to the present node, without the fixed ones.
    pub(super) fn chosen(&self) -> impl Iterator<Item = Placed> {
        let depth = self.depth.map_or(0, |depth| depth + 1);
        self.levels
            .iter()
            .take(depth)
            .filter_map(|level| level.branches.get(level.next.checked_sub(1)?).copied())
    }

    /// Goes on until a filling is found or so many nodes are made.
    pub(super) fn advance(&mut self, budget: &mut u64) -> Turn {
        while let Some(depth) = self.depth {
            if *budget == 0 {
                return Turn::Spent;
            }
            // The depth is at most the number of pieces, so there are levels for it and its child.
            let Some((upper, lower)) = self.levels.split_at_mut_checked(depth + 1) else { return Turn::Over };
            let (Some(level), Some(below)) = (upper.last_mut(), lower.first_mut()) else { return Turn::Over };
            let Some(&Placed { kind, mask }) = level.branches.get(level.next) else {
                self.depth = depth.checked_sub(1).filter(|&up| up >= self.floor);
                continue;
            };
            level.next += 1;
            *budget -= 1;
            self.nodes += 1;
            match level.node.place(mask, kind, &mut below.node) {
                Pivot::Dead => {}
                Pivot::Full => return Turn::Full,
                _ if below.node.starts[KINDS] <= self.few => return Turn::Few,
                pivot => {
                    below.node.branches(pivot, &mut below.branches);
                    below.next = 0;
                    self.depth = Some(depth + 1);
                }
            }
        }
        Turn::Over
    }

    /// The paths to all nodes at a depth, in their order: numbers of branches from the root. Only the path
    /// to the root itself if so few pieces are left that fillings end there.
    pub(super) fn paths(&self, depth: usize) -> Vec<Vec<usize>> {
        let mut paths = vec![Vec::new()];
        let left: u8 = self.levels.first().map_or(0, |root| root.node.left.iter().sum());
        if usize::from(left) <= depth {
            return paths;
        }
        for _ in 0..depth {
            let mut longer = Vec::new();
            for path in paths {
                let ways = self.at(&path).map_or(0, |tree| tree.ways());
                longer.extend((0..ways).map(|way| [path.as_slice(), &[way]].concat()));
            }
            paths = longer;
        }
        paths
    }

    /// The node that [`Turn::Few`] told.
    pub(super) fn below(&self) -> Option<&Node> {
        self.levels.get(self.depth? + 1).map(|level| &level.node)
    }

    fn ways(&self) -> usize {
        self.depth.and_then(|depth| self.levels.get(depth)).map_or(0, |level| level.branches.len())
    }

    /// The part of the tree below the node of a path; `None` if there is nothing.
    pub(super) fn at(&self, path: &[usize]) -> Option<Tree> {
        let mut tree = self.clone();
        for (depth, &way) in path.iter().enumerate() {
            let (upper, lower) = tree.levels.split_at_mut_checked(depth + 1)?;
            let (level, below) = (upper.last_mut()?, lower.first_mut()?);
            let &Placed { kind, mask } = level.branches.get(way)?;
            level.next = way + 1;
            let pivot = level.node.place(mask, kind, &mut below.node);
            below.node.branches(pivot, &mut below.branches);
            below.next = 0;
            if matches!(pivot, Pivot::Dead | Pivot::Full) {
                return None;
            }
            (tree.depth, tree.floor) = (Some(depth + 1), depth + 1);
        }
        Some(tree)
    }

    /// How much of the tree is done, 0 to 1, as if all branches of a node were alike.
    fn share(&self) -> f64 {
        let Some(depth) = self.depth else { return 1.0 };
        let (mut share, mut width) = (0.0, 1.0);
        for level in self.levels.iter().take(depth + 1) {
            width /= level.branches.len().max(1) as f64;
            share += width * level.next.saturating_sub(1) as f64;
        }
        share
    }
}

/// What a search has come to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Progress {
    /// The budget is used up; there may be more.
    Working,
    /// A filling; there may be more.
    Found(Filling),
    /// There is none any more.
    Exhausted,
}

/// The search for the fillings of the cube that have some pieces in given places, one after the other.
#[derive(Clone, Debug)]
pub struct Search {
    fixed: Vec<Placed>,
    tree: Option<Tree>,
    /// Whether the fixed pieces are all, and have not been told yet.
    complete: bool,
}

impl Search {
    /// A search with some pieces fixed. Another seed finds the fillings in another order; a seed of 0 is
    /// the order of the cells.
    #[must_use]
    pub fn new(fixed: &[Placed], seed: u64) -> Search {
        let mut places = places();
        if seed != 0 {
            // Numbers that look random: the high half of a product (Knuth's multiplicative hashing).
            let mixed = |mask: u64| (mask ^ seed).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(29);
            places.sort_by_key(|placed| (placed.kind, mixed(mixed(placed.mask))));
        }
        let complete =
            fixed.len() == super::PIECES && fixed.iter().fold(0, |all, it| all | it.mask) == u64::MAX;
        let tree = if complete { None } else { Tree::new(&places, fixed) };
        Search { fixed: fixed.to_vec(), tree, complete }
    }

    /// Makes at most so many nodes, and stops at the next filling.
    pub fn advance(&mut self, budget: u64) -> Progress {
        if std::mem::take(&mut self.complete) {
            return Progress::Found(Filling { placed: self.fixed.clone() });
        }
        let Some(tree) = &mut self.tree else { return Progress::Exhausted };
        let mut left = budget;
        match tree.advance(&mut left) {
            Turn::Spent => Progress::Working,
            // No node is told for its few places here.
            Turn::Over | Turn::Few => Progress::Exhausted,
            Turn::Full => {
                Progress::Found(Filling { placed: self.fixed.iter().copied().chain(tree.chosen()).collect() })
            }
        }
    }

    /// How many nodes have been made.
    #[must_use]
    pub fn nodes(&self) -> u64 {
        self.tree.as_ref().map_or(0, |tree| tree.nodes)
    }

    /// How much of the search is done, 0 to 1, roughly.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.tree.as_ref().map_or(1.0, Tree::share)
    }
}

#[cfg(test)]
mod tests {
    use super::super::CsangoCube;
    use super::*;

    fn first(fixed: &[Placed], seed: u64) -> (Filling, u64) {
        let mut search = Search::new(fixed, seed);
        loop {
            match search.advance(1000) {
                Progress::Found(filling) => return (filling, search.nodes()),
                Progress::Working => {}
                Progress::Exhausted => panic!("there are fillings"),
            }
        }
    }

    fn check(filling: &Filling) -> CsangoCube {
        let cube = filling.position([3, 2, 0]).expect("it has the fourteen pieces");
        assert_eq!(cube.fault(), None);
        assert!(cube.is_finished());
        cube
    }

    #[test]
    fn first_fillings_come_soon_whatever_the_order() {
        let nodes: Vec<u64> = (0..40)
            .map(|seed| {
                let (filling, nodes) = first(&[], seed);
                check(&filling);
                nodes
            })
            .collect();
        println!("{nodes:?}");
        assert!(nodes.iter().all(|&nodes| nodes < 20_000), "{nodes:?}");
    }

    #[test]
    fn any_part_of_a_filling_can_be_filled_up() {
        let (filling, _) = first(&[], 7);
        for chosen in 0_u32..200 {
            let kept = |k: &usize| chosen.wrapping_mul(0x9E37_79B9) >> (k + 8) & 1 == 1;
            let fixed: Vec<Placed> =
                filling.placed.iter().enumerate().filter(|(k, _)| kept(k)).map(|(_, &it)| it).collect();
            let (found, _) = first(&fixed, 0);
            check(&found);
            assert!(fixed.iter().all(|placed| found.placed.contains(placed)));
        }
        assert_eq!(first(&filling.placed, 0).0, filling);
    }

    #[test]
    fn what_cannot_lie_so_has_no_filling() {
        let place = Placed { kind: 0, mask: 0x600222 };
        for fixed in
            [vec![place; 2], vec![Placed { kind: 9, mask: 1 }], vec![Placed { kind: 5, mask: 0xF }; 1]]
        {
            // A straight row of four is none of the pieces, but its cells are free for the others.
            let mut search = Search::new(&fixed, 0);
            let found = search.advance(0);
            assert!(matches!(found, Progress::Exhausted | Progress::Working), "{fixed:?}");
        }
    }
}
