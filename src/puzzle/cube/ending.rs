//! The end of a count: how often the last pieces fill what is left, once so few places are left that a set
//! of them is four words. Which places a piece takes away, and which serve a cell, are then a few operations
//! on sets. Unlike the search this does not tell the fillings, and is not interrupted: it takes microseconds.

use super::place::KINDS;
use super::search::{Node, beside};

/// Words of a set.
const WORDS: usize = 4;

/// So many places can be left at most.
pub(super) const MOST: usize = 64 * WORDS - 1;

/// A cell with so few places is branched on, whether or not another has fewer.
const FEW: u64 = 3;

/// A set of places, by their numbers.
type Set = [u64; WORDS];

/// What is to be filled, after the last piece.
#[derive(Clone, Copy, Debug)]
struct Rest {
    empty: u64,
    /// Cells beside the last piece.
    near: u64,
    left: [u8; KINDS],
    pieces: usize,
}

/// The places that are left at a node of the search.
#[derive(Clone, Debug)]
pub(super) struct Ending {
    masks: Vec<u64>,
    kinds: Vec<usize>,
    of_cell: [Set; 64],
    of_kind: [Set; KINDS],
    /// Places whose fillings count twice.
    twice: Set,
}

impl Ending {
    pub(super) fn new() -> Ending {
        let none = [0; WORDS];
        let (of_cell, of_kind) = ([none; 64], [none; KINDS]);
        Ending { masks: Vec::new(), kinds: Vec::new(), of_cell, of_kind, twice: none }
    }

    /// The number of fillings from a node on that has at most [`MOST`] places. Those with one of the places
    /// `twice` (sorted, of the first type, of which one at most is left) count twice.
    pub(super) fn fillings(&mut self, node: &Node, twice: &[u64]) -> u64 {
        self.number(node, twice);
        let pieces = node.left.iter().map(|&left| usize::from(left)).sum();
        let rest = Rest { empty: !node.filled, near: 0, left: node.left, pieces };
        let mut live = [0; WORDS];
        for own in &self.of_kind {
            for word in 0..WORDS {
                live[word] |= own[word];
            }
        }
        self.count(rest, &live)
    }

    /// Numbers the places of a node and makes the sets.
    fn number(&mut self, node: &Node, twice: &[u64]) {
        self.masks.clear();
        self.kinds.clear();
        (self.of_kind, self.twice) = ([[0; WORDS]; KINDS], [0; WORDS]);
        for kind in 0..KINDS {
            let own = node.of_kind(kind);
            let before = self.masks.len();
            for (index, mask) in own.iter().enumerate() {
                let number = before + index;
                let (word, bit) = (number / 64 % WORDS, 1 << (number % 64));
                self.of_kind[kind][word] |= bit;
                if kind == 0 && twice.binary_search(mask).is_ok() {
                    self.twice[word] |= bit;
                }
            }
            self.masks.extend_from_slice(own);
            self.kinds.resize(self.masks.len(), kind);
        }
        let mut blocks = self.masks.chunks(64);
        for word in 0..WORDS {
            let mut matrix = [0; 64];
            let block = blocks.next().unwrap_or_default();
            matrix[..block.len()].copy_from_slice(block); // at most 64
            transpose(&mut matrix);
            for (cell, &own) in matrix.iter().enumerate() {
                self.of_cell[cell & 63][word] = own;
            }
        }
    }

    /// The places for a cell that has few; none if any cell has none.
    #[inline]
    fn narrowest(&self, rest: Rest, live: &Set) -> Set {
        let (mut fewest, mut narrowest) = (u64::MAX, [0; WORDS]);
        // What the last piece has cut off shows beside it.
        for mut cells in [rest.empty & rest.near, rest.empty & !rest.near] {
            while cells != 0 {
                let own = both(live, &self.of_cell[lowest(cells)]);
                cells &= cells - 1;
                if own[0] | own[1] | own[2] | own[3] == 0 {
                    return own;
                }
                if fewest > FEW {
                    let number = size(&own);
                    if number < fewest {
                        (fewest, narrowest) = (number, own);
                    }
                }
            }
        }
        narrowest
    }

    /// The number of ways to fill the rest with these places.
    fn count(&self, rest: Rest, live: &Set) -> u64 {
        let narrowest = self.narrowest(rest, live);
        let mut total = 0;
        for (word, mut serving) in narrowest.into_iter().enumerate() {
            while serving != 0 {
                let number = 64 * word + lowest(serving);
                let weight = 1 + (self.twice[word % WORDS] >> (number % 64) & 1);
                serving &= serving - 1;
                let (Some(&mask), Some(&kind)) = (self.masks.get(number), self.kinds.get(number)) else {
                    break;
                };
                let mut below =
                    Rest { empty: rest.empty & !mask, pieces: rest.pieces.saturating_sub(1), ..rest };
                below.left[kind] = below.left[kind].saturating_sub(1);
                let mut live = *live;
                let mut cells = mask;
                while cells != 0 {
                    live = without(&live, &self.of_cell[lowest(cells)]);
                    cells &= cells - 1;
                }
                if below.left[kind] == 0 {
                    live = without(&live, &self.of_kind[kind]);
                }
                total += weight
                    * match below.pieces {
                        0 => 1,
                        // A place that is left has just the right size: it fills the rest.
                        1 => size(&live) + size(&both(&live, &self.twice)),
                        _ => {
                            below.near = beside(mask);
                            self.count(below, &live)
                        }
                    };
            }
        }
        total
    }
}

/// The number of the lowest bit.
#[inline]
fn lowest(word: u64) -> usize {
    word.trailing_zeros() as usize & 63
}

/// How many places there are in a set. Not every processor that the program may run on counts bits in one
/// operation; four words together cost less than four times one.
#[inline]
fn size(set: &Set) -> u64 {
    let [a, b, c, d] = *set;
    let bytes = in_bytes(in_nibbles(a) + in_nibbles(b)) + in_bytes(in_nibbles(c) + in_nibbles(d));
    // The sum of the bytes is at most MOST, so it is a byte.
    bytes.wrapping_mul(0x0101_0101_0101_0101) >> 56
}

/// How many bits each four bits have.
#[inline]
const fn in_nibbles(word: u64) -> u64 {
    const ODD: u64 = 0x5555_5555_5555_5555;
    const PAIRS: u64 = 0x3333_3333_3333_3333;
    let pairs = word - (word >> 1 & ODD);
    (pairs & PAIRS) + (pairs >> 2 & PAIRS)
}

/// The sums of the two halves of each byte.
#[inline]
const fn in_bytes(nibbles: u64) -> u64 {
    const LOW: u64 = 0x0F0F_0F0F_0F0F_0F0F;
    (nibbles & LOW) + (nibbles >> 4 & LOW)
}

#[inline]
fn both([a, b, c, d]: &Set, [e, f, g, h]: &Set) -> Set {
    [a & e, b & f, c & g, d & h]
}

#[inline]
fn without([a, b, c, d]: &Set, [e, f, g, h]: &Set) -> Set {
    [a & !e, b & !f, c & !g, d & !h]
}

/// Exchanges rows and columns of a matrix of bits: squares of 32 by 32 bits first, then smaller ones
/// (Warren, Hacker's Delight, 7-3).
fn transpose(matrix: &mut [u64; 64]) {
    let (mut width, mut low) = (32, 0x0000_0000_FFFF_FFFF_u64);
    while width != 0 {
        for pair in matrix.chunks_exact_mut(2 * width) {
            let (upper, lower) = pair.split_at_mut(width);
            // Without iterators: the compiler then takes several rows at once.
            for row in 0..width.min(upper.len()).min(lower.len()) {
                let exchanged = (upper[row] >> width ^ lower[row]) & low;
                upper[row] ^= exchanged << width;
                lower[row] ^= exchanged;
            }
        }
        width /= 2;
        low ^= low << width;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn rows_become_columns(seed: [u64; 32]) {
            let matrix: [u64; 64] = std::array::from_fn(|row| seed[row / 2].rotate_left(29 * row as u32));
            let mut other = matrix;
            transpose(&mut other);
            for (row, bits) in matrix.iter().enumerate() {
                for (column, turned) in other.iter().enumerate() {
                    prop_assert_eq!(bits >> column & 1, turned >> row & 1);
                }
            }
        }

        #[test]
        fn sizes_are_numbers_of_bits(mut set: Set) {
            prop_assert_eq!(size(&set), set.iter().map(|word| u64::from(word.count_ones())).sum::<u64>());
            set = [u64::MAX >> 1, u64::MAX, u64::MAX, u64::MAX];
            prop_assert_eq!(size(&set), MOST as u64);
        }
    }
}
