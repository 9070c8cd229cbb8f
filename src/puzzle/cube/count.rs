//! Counting all fillings of the cube, in parts that can be worked on anywhere in any order.
//!
//! No filling has a rotational symmetry. Of all fillings therefore those are counted that have a piece of
//! type 1 on one place of each class that the 48 symmetries of the cube make, mirrors among them (a mirror
//! exchanges types 2 and 3, and 4 and 5, of which there are as many). Fillings with such a piece in an
//! earlier class are left out; one with both pieces of type 1 in the same class is met twice and counts half.
//! So every class of 48 places adds twice its number, with the halves, to the number up to the 24 rotations.

use super::PIECES;
use super::ending::{Ending, MOST};
use super::place::{Placed, mapped, places, symmetries};
use super::search::{Tree, Turn};

/// Levels of the tree above the parts.
const DEPTH: usize = 2;

/// A search whose fillings are counted.
#[derive(Clone, Debug)]
struct Root {
    tree: Tree,
    /// Places of a piece of type 1 that make a filling count twice, sorted.
    twice: Vec<u64>,
}

/// A number of fillings to be counted, as a list of parts in a fixed order. The sum of the parts is the
/// number, however they are distributed.
#[derive(Clone, Debug)]
pub struct Count {
    roots: Vec<Root>,
    /// The root of each part, and the path to it.
    parts: Vec<(usize, Vec<usize>)>,
}

/// A part of a count that is being worked on.
#[derive(Clone, Debug)]
pub struct Item {
    root: Option<Root>,
    ending: Ending,
    total: u64,
    over: bool,
}

/// The count of all fillings of the cube up to its 24 rotations.
#[must_use]
pub fn all_fillings() -> Count {
    up_to_rotations(&places())
}

/// The count of the fillings of which all pieces are in these places, up to rotations. The places are sorted
/// by type, and every symmetry of the cube maps them to each other.
fn up_to_rotations(all: &[Placed]) -> Count {
    let classes = classes(all, 0, &symmetries());
    let mut roots = Vec::new();
    let mut allowed = all.to_vec();
    for class in &classes {
        // No symmetry maps a place of type 1 to itself, so that all 48 images differ: see the tests.
        let root = class.first().and_then(|&mask| Tree::new(&allowed, &[Placed { kind: 0, mask }]));
        let ours = |mask| class.binary_search(&mask).is_ok();
        let others = allowed.iter().filter(|it| it.kind == 0 && !ours(it.mask));
        let twice = others.map(|it| it.mask).collect();
        roots.extend(root.map(|tree| Root { tree, twice }));
        allowed.retain(|it| it.kind != 0 || !ours(it.mask));
    }
    Count::new(roots)
}

/// The places of a type in classes that symmetries make, each sorted.
fn classes(all: &[Placed], kind: usize, symmetries: &[[u8; 64]]) -> Vec<Vec<u64>> {
    let mut classes: Vec<Vec<u64>> = Vec::new();
    for placed in all.iter().filter(|placed| placed.kind == kind) {
        if !classes.iter().any(|class| class.binary_search(&placed.mask).is_ok()) {
            let mut class: Vec<u64> = symmetries.iter().map(|it| mapped(placed.mask, it)).collect();
            class.sort_unstable();
            class.dedup();
            classes.push(class);
        }
    }
    classes
}

impl Count {
    /// The count of the fillings with some pieces in given places. Pieces of one type are alike; rotations
    /// are different fillings.
    #[must_use]
    pub fn with_fixed(fixed: &[Placed]) -> Count {
        let places = places();
        // A full cube is one filling: the one that its last piece completes.
        let all_but_one = fixed.get(..PIECES - 1).unwrap_or(fixed);
        let tree = Tree::new(&places, fixed).and_then(|_| Tree::new(&places, all_but_one));
        Count::new(tree.into_iter().map(|tree| Root { tree, twice: Vec::new() }).collect())
    }

    fn new(roots: Vec<Root>) -> Count {
        let parts = roots.iter().enumerate();
        let parts =
            parts.flat_map(|(index, root)| root.tree.paths(DEPTH).into_iter().map(move |path| (index, path)));
        Count { parts: parts.collect(), roots }
    }

    /// How many parts there are.
    #[must_use]
    pub fn parts(&self) -> usize {
        self.parts.len()
    }

    /// A part, counted from 0, to be worked on; one beyond the last counts nothing.
    #[must_use]
    pub fn part(&self, index: usize) -> Item {
        let found = self.parts.get(index).and_then(|(root, path)| {
            let root = self.roots.get(*root)?;
            let mut tree = root.tree.at(path)?;
            tree.few = MOST;
            Some(Root { tree, twice: root.twice.clone() })
        });
        Item { over: found.is_none(), root: found, ending: Ending::new(), total: 0 }
    }

    /// Counts all parts, one after the other.
    #[must_use]
    pub fn total(&self) -> u64 {
        (0..self.parts()).map(|index| self.part(index).finish()).sum()
    }
}

impl Item {
    /// Makes at most so many nodes, and what lies below the last of them where that is little; the number of
    /// fillings if that was all.
    pub fn advance(&mut self, budget: u64) -> Option<u64> {
        let mut left = budget;
        while let Some(root) = self.root.as_mut().filter(|_| !self.over) {
            let found = match root.tree.advance(&mut left) {
                Turn::Spent => return None,
                Turn::Over => {
                    self.over = true;
                    continue;
                }
                Turn::Full => 1,
                Turn::Few => root.tree.below().map_or(0, |node| self.ending.fillings(node, &root.twice)),
            };
            let twice = |it: Placed| it.kind == 0 && root.twice.binary_search(&it.mask).is_ok();
            self.total += if root.tree.chosen().any(twice) { 2 * found } else { found };
        }
        Some(self.total)
    }

    /// Works until the part is done.
    #[must_use]
    pub fn finish(mut self) -> u64 {
        loop {
            if let Some(total) = self.advance(u64::MAX) {
                return total;
            }
        }
    }

    /// How many nodes have been made.
    #[must_use]
    pub fn nodes(&self) -> u64 {
        self.root.as_ref().map_or(0, |root| root.tree.nodes)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Progress, Search};
    use super::*;

    /// Counts part by part; the number and how many nodes it took.
    fn worked(count: &Count) -> (u64, u64) {
        (0..count.parts()).fold((0, 0), |(total, nodes), index| {
            let mut item = count.part(index);
            while item.advance(u64::MAX).is_none() {}
            (total + item.total, nodes + item.nodes())
        })
    }

    /// A number that another program's author counted.
    fn assert_known(mask: u64, known: u64) {
        let begun = std::time::Instant::now();
        let (total, nodes) = worked(&Count::with_fixed(&[Placed { kind: 0, mask }]));
        println!("{total} in {:.2} s, {nodes} nodes", begun.elapsed().as_secs_f64());
        assert_eq!(total, known);
    }

    #[test]
    fn the_first_small_number_is_the_known_one() {
        assert_known(0x20_0460_0020, 45_091);
    }

    #[test]
    #[cfg_attr(debug_assertions, ignore = "takes long without optimization")]
    fn the_second_small_number_is_the_known_one() {
        assert_known(0x60_0222, 151_296);
    }

    #[test]
    fn every_class_has_forty_eight_places() {
        let classes = classes(&places(), 0, &symmetries());
        assert_eq!(classes.len(), 9);
        assert!(classes.iter().all(|class| class.len() == 48));
        assert_eq!(all_fillings().roots.len(), 9);
    }

    /// The first filling around some pieces in the order of a seed.
    fn filling(fixed: &[Placed], seed: u64) -> Vec<Placed> {
        match Search::new(fixed, seed).advance(u64::MAX) {
            Progress::Found(filling) => filling.placed,
            Progress::Working | Progress::Exhausted => panic!("there are fillings"),
        }
    }

    /// Every image of some pieces, sorted by type.
    fn images(pieces: &[Placed]) -> Vec<Placed> {
        let masks: Vec<u64> =
            symmetries().iter().flat_map(|it| pieces.iter().map(|piece| mapped(piece.mask, it))).collect();
        places().into_iter().filter(|placed| masks.contains(&placed.mask)).collect()
    }

    #[test]
    fn classes_and_halves_give_the_number_that_all_fillings_give() {
        let symmetries = symmetries();
        let mut same_class = [0; 2];
        for (seed, &place) in (1..).zip(places().iter().take(432).step_by(43)) {
            let pieces = filling(&[place], seed);
            let all = images(&pieces);
            let every = Root { tree: Tree::new(&all, &[]).expect("it is empty"), twice: Vec::new() };
            let (number, reduced) = (Count::new(vec![every]).total(), up_to_rotations(&all).total());
            // A filling, its rotations and their mirror images.
            assert!(reduced >= 1 && number >= 24, "{seed}");
            assert_eq!(number, 24 * reduced, "{seed}");
            let ones: Vec<u64> = pieces.iter().filter(|it| it.kind == 0).map(|it| it.mask).collect();
            same_class[usize::from(symmetries.iter().any(|it| mapped(ones[0], it) == ones[1]))] += 1;
        }
        assert!(same_class.iter().all(|&number| number > 0), "{same_class:?}");
    }

    #[test]
    fn what_is_almost_full_is_counted() {
        let pieces = filling(&[], 3);
        for fixed in 9..=PIECES {
            let (mut search, mut number) = (Search::new(&pieces[..fixed], 0), 0);
            while let Progress::Found(_) = search.advance(u64::MAX) {
                number += 1;
            }
            assert!(number > 0);
            assert_eq!(Count::with_fixed(&pieces[..fixed]).total(), number, "{fixed} pieces");
        }
        let mut twice = pieces.clone();
        twice[13] = twice[12];
        assert_eq!(Count::with_fixed(&twice).total(), 0);
    }

    #[test]
    fn a_count_does_not_depend_on_the_budget() {
        let count = Count::with_fixed(&[Placed { kind: 0, mask: 0x60_0222 }]);
        let index = count.parts() / 2;
        let mut item = count.part(index);
        let total = loop {
            if let Some(total) = item.advance(777) {
                break total;
            }
        };
        assert_eq!(total, count.part(index).finish());
    }

    /// The number of fillings up to rotations. What this search found, and the next test in another way; no
    /// other program's number is known.
    const ALL: u64 = 4_407_560;

    /// Takes about a minute: `cargo test --release -- --ignored all_fillings`.
    #[test]
    #[ignore = "takes long"]
    fn all_fillings_up_to_rotations() {
        let begun = std::time::Instant::now();
        let (total, nodes) = worked(&all_fillings());
        println!("{total} in {:.2} s, {nodes} nodes", begun.elapsed().as_secs_f64());
        assert_eq!(total, ALL);
    }

    /// Every filling has three pieces of type 2 and 24 rotations, so the fillings around one place of each
    /// class that the rotations make, times its 24 places, are 72 times the number: without mirrors, halves
    /// or places left out. The sum is 13 222 680. Takes three to four minutes of processor time:
    /// `cargo test --release -- --ignored around_pieces`.
    #[test]
    #[ignore = "takes long"]
    fn all_fillings_around_pieces_of_type_two() {
        // The turns without the mirrors, which take turns in the list.
        let rotations: Vec<_> = symmetries().into_iter().step_by(2).collect();
        let classes = classes(&places(), 1, &rotations);
        assert_eq!(classes.iter().map(Vec::len).collect::<Vec<_>>(), [24; 18]);
        let around = |class: &Vec<u64>| Count::with_fixed(&[Placed { kind: 1, mask: class[0] }]).total();
        let sum: u64 = classes.iter().map(around).sum();
        println!("{sum} fillings around pieces of type 2");
        assert_eq!(sum * 24, ALL * 24 * 3);
    }
}
