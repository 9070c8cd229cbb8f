//! How far each colour alone is from home: the least number of moves that brings its four beads and the
//! drawers home, whatever becomes of the other beads. No position is nearer to solved than any of its colours.
//!
//! There are 341 550 patterns, at most 16 moves deep. One table serves all six colours: a pattern is turned
//! until its colour is the first one.

use super::moves::{Action, Move};
use super::state::{moved, turned};
use super::{ARMS, Wheel};

/// Arrangements of the three pairs of drawers.
const DRAWERS: usize = 27;
/// Ways to choose four of 31 places.
const CHOICES: usize = 31_465;
/// The distance of a pattern that has not been reached.
const UNKNOWN: u8 = u8::MAX;

/// `CHOOSE[k][n]`: ways to choose k + 1 of n.
const CHOOSE: [[u16; 32]; 4] = {
    let mut table = [[0; 32]; 4];
    let mut n = 1;
    while n < 32 {
        table[0][n] = n as u16;
        let mut k = 1;
        while k < 4 {
            table[k][n] = table[k][n - 1] + table[k - 1][n - 1];
            k += 1;
        }
        n += 1;
    }
    table
};

/// The table, which is made piece by piece.
#[derive(Clone, Debug)]
pub(super) struct Patterns {
    distance: Vec<u8>,
    /// Patterns in the order in which they were reached: places of the colour, places with any bead.
    reached: Vec<(u32, u32)>,
    /// How many of them have been followed up.
    followed: usize,
}

/// A number for four places; below [`CHOICES`].
fn rank(mut places: u32) -> usize {
    let mut rank = 0;
    for row in &CHOOSE {
        // Four bits of 31 are set; without any, 32 would be masked to 0.
        rank += usize::from(row[(places.trailing_zeros() & 31) as usize]);
        places &= places.wrapping_sub(1);
    }
    rank
}

/// How far the drawers are out: 0, 1, 2 for each arm.
fn drawers(occupied: u32) -> [usize; ARMS] {
    std::array::from_fn(|arm| ((occupied >> (18 + arm) & 1) + (occupied >> (24 + arm) & 1)) as usize)
}

/// The place in the table of a pattern whose colour's home is the given arm.
fn index(home: usize, places: u32, out: &[usize; ARMS]) -> usize {
    let out = |arm: usize| out[(home + arm) % ARMS];
    let drawers = out(0) + 3 * out(1) + 9 * out(2);
    rank(turned(places, (ARMS - home) % ARMS)) * DRAWERS + drawers
}

impl Default for Patterns {
    fn default() -> Patterns {
        let solved = Wheel::solved();
        let mut patterns =
            Patterns { distance: vec![UNKNOWN; CHOICES * DRAWERS], reached: Vec::new(), followed: 0 };
        patterns.reach(solved.colour(0), solved.occupied(), 0);
        patterns
    }
}

impl Patterns {
    fn reach(&mut self, places: u32, occupied: u32, distance: u8) {
        if let Some(entry) = self.distance.get_mut(index(0, places, &drawers(occupied)))
            && *entry == UNKNOWN
        {
            *entry = distance;
            self.reached.push((places, occupied));
        }
    }

    /// Works until the budget of moves is used up or the table is whole; whether it is.
    pub(super) fn advance(&mut self, budget: &mut u64) -> bool {
        while let Some(&(places, occupied)) = self.reached.get(self.followed) {
            if *budget == 0 {
                return false;
            }
            let distance = self.distance[index(0, places, &drawers(occupied))].saturating_add(1);
            for action in Move::ALL.map(Move::action) {
                if !matches!(action, Action::Push(arm) if occupied >> (18 + arm) & 1 == 0) {
                    self.reach(moved(places, action), moved(occupied, action), distance);
                }
            }
            self.followed += 1;
            *budget -= 1; // the moves of a pattern take hardly longer than one position
        }
        if self.reached.capacity() > 0 {
            (self.reached, self.followed) = (Vec::new(), 0);
        }
        true
    }

    /// The distances of the six colours, once the table is whole.
    pub(super) fn distances(&self, wheel: &Wheel) -> [u8; ARMS] {
        let out = drawers(wheel.occupied());
        std::array::from_fn(|colour| self.distance[index(colour, wheel.colour(colour), &out)])
    }

    /// No less than so many moves lead to solved.
    pub(super) fn bound(&self, wheel: &Wheel) -> u8 {
        self.distances(wheel).into_iter().max().unwrap_or(0)
    }
}

#[cfg(test)]
pub(super) fn whole() -> Patterns {
    let mut patterns = Patterns::default();
    assert!(patterns.advance(&mut u64::MAX.clone()));
    patterns
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn as_many_patterns_as_there_are() {
        let patterns = whole();
        let known = patterns.distance.iter().filter(|&&distance| distance != UNKNOWN);
        assert_eq!(known.clone().count(), 341_550);
        assert_eq!(known.max(), Some(&16));
        assert_eq!(patterns.distances(&Wheel::solved()), [0; 6]);
    }

    #[test]
    fn a_colour_is_never_further_than_the_position() {
        let patterns = whole();
        proptest!(|(moves in prop::collection::vec(0usize..12, 0..14))| {
            let moves: Vec<Move> = moves.into_iter().map(|index| Move::ALL[index]).collect();
            let mut wheel = Wheel::solved();
            for &a_move in &moves {
                let before = patterns.distances(&wheel);
                wheel = wheel.after_all(&[a_move]);
                let after = patterns.distances(&wheel);
                prop_assert!(before.iter().zip(after).all(|(&a, b)| a.abs_diff(b) <= 1));
            }
            prop_assert!(usize::from(patterns.bound(&wheel)) <= moves.len());
        });
    }
}
