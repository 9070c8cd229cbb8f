//! Counting all fillings of the cube, in parts that can be worked on anywhere in any order.
//!
//! No filling has a rotational symmetry. Of all fillings therefore those are counted that have a piece of
//! type 1 on one place of each class that the 48 symmetries of the cube make, mirrors among them (a mirror
//! exchanges types 2 and 3, and 4 and 5, of which there are as many). Fillings with such a piece in an
//! earlier class are left out; one with both pieces of type 1 in the same class is met twice and counts half.
//! So every class of 48 places adds twice its number, with the halves, to the number up to the 24 rotations.

use super::place::{Placed, mapped, places, symmetries};
use super::search::{Tree, Turn};

/// Levels of the tree above the parts.
const DEPTH: usize = 2;

/// A search whose fillings are counted.
#[derive(Clone, Debug)]
struct Root {
    tree: Tree,
    /// What a filling counts.
    weight: u64,
    /// Places of a piece of type 1 that make a filling count half, sorted.
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
    total: u64,
    over: bool,
}

/// The count of all fillings of the cube up to its 24 rotations.
#[must_use]
pub fn all_fillings() -> Count {
    let all = places();
    let symmetries = symmetries();
    let mut classes: Vec<Vec<u64>> = Vec::new();
    for placed in all.iter().filter(|placed| placed.kind == 0) {
        if !classes.iter().any(|class| class.contains(&placed.mask)) {
            let mut class: Vec<u64> = symmetries.iter().map(|it| mapped(placed.mask, it)).collect();
            class.sort_unstable();
            class.dedup();
            classes.push(class);
        }
    }
    let mut roots = Vec::new();
    for (number, class) in classes.iter().enumerate() {
        let earlier = |mask| classes.iter().take(number).any(|class| class.contains(&mask));
        let allowed: Vec<Placed> =
            all.iter().filter(|it| it.kind != 0 || !earlier(it.mask)).copied().collect();
        let Some(&mask) = class.first() else { continue };
        let Some(tree) = Tree::new(&allowed, &[Placed { kind: 0, mask }]) else { continue };
        // A class has 48 places, as no symmetry maps a place of type 1 to itself: see the tests.
        roots.push(Root { tree, weight: class.len() as u64 / 24, twice: class.clone() });
    }
    Count::new(roots)
}

impl Count {
    /// The count of the fillings with some pieces in given places. Pieces of one type are alike; rotations
    /// are different fillings.
    #[must_use]
    pub fn with_fixed(fixed: &[Placed]) -> Count {
        let tree = Tree::new(&places(), fixed);
        Count::new(tree.into_iter().map(|tree| Root { tree, weight: 1, twice: Vec::new() }).collect())
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
            Some(Root { tree: root.tree.at(path)?, weight: root.weight, twice: root.twice.clone() })
        });
        Item { over: found.is_none(), root: found, total: 0 }
    }

    /// Counts all parts, one after the other.
    #[must_use]
    pub fn total(&self) -> u64 {
        (0..self.parts()).map(|index| self.part(index).finish()).sum()
    }
}

impl Item {
    /// Makes at most so many nodes; the number of fillings if that was all.
    pub fn advance(&mut self, budget: u64) -> Option<u64> {
        let mut left = budget;
        while let Some(root) = self.root.as_mut().filter(|_| !self.over) {
            match root.tree.advance(&mut left) {
                Turn::Spent => return None,
                Turn::Over => self.over = true,
                Turn::Full => {
                    let half = !root.twice.is_empty()
                        && root
                            .tree
                            .chosen()
                            .any(|it| it.kind == 0 && root.twice.binary_search(&it.mask).is_ok());
                    self.total += if half { root.weight / 2 } else { root.weight };
                }
            }
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
        let count = all_fillings();
        assert_eq!(count.roots.len(), 9);
        assert!(count.roots.iter().all(|root| root.twice.len() == 48 && root.weight == 2));
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

    /// Takes about a minute: `cargo test --release -- --ignored all_fillings`.
    #[test]
    #[ignore = "takes long"]
    fn all_fillings_up_to_rotations() {
        let begun = std::time::Instant::now();
        let count = all_fillings();
        let (total, nodes) = worked(&count);
        println!("{total} in {:.2} s, {nodes} nodes", begun.elapsed().as_secs_f64());
        // What this search found; no other program's number is known.
        assert_eq!(total, 4_407_560);
    }
}
