//! How far each colour alone is from home: the least number of moves that brings its four beads and the
//! drawers home, whatever becomes of the other beads. No position is nearer to solved than any of its colours.
//!
//! There are 341 550 patterns, at most 16 moves deep. One table serves all six colours: a pattern is turned
//! until its colour is the first one. A second one, of the grey bead, only serves the scores.
//!
//! Scores say how promising a position is, the lower the better. Every colour adds the square of its mean
//! distance after three random moves: that tells patterns of the same distance apart by how many ways lead on.
//! A beam of positions chosen so finds ways as short as one three times as wide chosen by the distances alone.

use super::moves::{Action, Move};
use super::state::{moved, turned};
use super::{ARMS, Wheel};

/// Arrangements of the three pairs of drawers.
const DRAWERS: usize = 27;
/// Ways to choose four of 31 places.
const CHOICES: usize = 31_465;
/// Places of a bead.
const PLACES: usize = 31;
/// Moves.
const MOVES: usize = Move::ALL.len();
/// The score after a move that is not possible.
pub(super) const BLOCKED: u16 = u16::MAX;
/// No pattern.
const NONE: u32 = u32::MAX;
/// Mean distances are counted in parts of a move.
const ONE: u32 = 1 << 12;
/// Patterns that are rated, or moved at random, in the time that a position takes.
const AT_ONCE: usize = 8;
/// A pattern is rated by its mean distance after so many random moves.
const RANDOM_MOVES: usize = 3;
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

/// Scores of the twelve positions after a move, in the order of the moves.
pub(super) type Scores = [u16; MOVES];

/// The distances of some beads with the drawers, made piece by piece.
#[derive(Clone, Debug)]
struct Table {
    distance: Vec<u8>,
    /// What the beads add to the scores of the positions after the moves; nothing until all is made.
    after: Vec<Scores>,
    making: Making,
}

/// What is only needed while a table is made.
#[derive(Clone, Debug, Default)]
struct Making {
    /// Patterns in the order in which they were reached: places of the beads, places with any bead.
    reached: Vec<(u32, u32)>,
    /// The place of a pattern in that order.
    order: Vec<u32>,
    /// For every pattern, those after the twelve moves in that order; [`NONE`] where one is impossible.
    next: Vec<[u32; MOVES]>,
    /// The mean distances after some random moves, in parts of [`ONE`], and after how many.
    means: Vec<u32>,
    random_moves: usize,
    /// Those after one more, as far as they are known.
    further: Vec<u32>,
    /// How many patterns have given their scores.
    rated: usize,
}

/// The tables of one colour and of the grey bead.
#[derive(Clone, Debug)]
pub(super) struct Patterns {
    colour: Table,
    grey: Table,
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

/// The place in a table of a pattern that is turned back by some arms.
fn index(arms: usize, places: u32, out: &[usize; ARMS]) -> usize {
    let out = |arm: usize| out[(arms + arm) % ARMS];
    let drawers = out(0) + 3 * out(1) + 9 * out(2);
    rank(turned(places, (ARMS - arms) % ARMS)) * DRAWERS + drawers
}

/// What a mean distance beyond that of the solved pattern adds to the score of a position: 32 times its square.
/// Distances are at most 16, so the seven sorts of beads together stay below [`BLOCKED`].
fn score(mean: u32) -> u16 {
    u16::try_from(u64::from(mean).pow(2) * 32 / u64::from(ONE).pow(2)).unwrap_or(BLOCKED)
}

impl Table {
    /// The table of beads that are at home in these places, one of `choices` sets of as many places.
    fn new(home: u32, choices: usize) -> Table {
        let size = choices * DRAWERS;
        let making = Making { order: vec![NONE; size], ..Making::default() };
        let mut table = Table { distance: vec![UNKNOWN; size], after: Vec::new(), making };
        table.reach(home, Wheel::solved().occupied(), 0);
        table
    }

    /// The place of a pattern in the order in which they are reached.
    fn reach(&mut self, places: u32, occupied: u32, distance: u8) -> u32 {
        let index = index(0, places, &drawers(occupied));
        let Making { reached, order, means, .. } = &mut self.making;
        if self.distance[index] == UNKNOWN {
            self.distance[index] = distance;
            order[index] = reached.len() as u32; // fewer than there are patterns
            reached.push((places, occupied));
            means.push(u32::from(distance) * ONE);
        }
        order[index]
    }

    /// Works until the budget of moves is used up or all distances are known; whether they are.
    fn measure(&mut self, budget: &mut u64) -> bool {
        while let Some(&(places, occupied)) = self.making.reached.get(self.making.next.len()) {
            if *budget == 0 {
                return false;
            }
            let distance = self.distance[index(0, places, &drawers(occupied))].saturating_add(1);
            let next = Move::ALL.map(Move::action).map(|action| {
                let possible = !matches!(action, Action::Push(arm) if occupied >> (18 + arm) & 1 == 0);
                if possible {
                    self.reach(moved(places, action), moved(occupied, action), distance)
                } else {
                    NONE
                }
            });
            self.making.next.push(next);
            *budget -= 1; // the moves of a pattern take hardly longer than one position
        }
        true
    }

    /// Works until the budget is used up or all scores are known, after the distances; whether they are.
    fn score(&mut self, budget: &mut u64) -> bool {
        // What was only needed on the way is gone when all is done.
        while self.making.rated < self.making.reached.len() {
            if *budget == 0 {
                return false;
            }
            let piece = usize::try_from(*budget).unwrap_or(usize::MAX).saturating_mul(AT_ONCE);
            let done = match self.making.random_moves {
                RANDOM_MOVES => self.rate(piece),
                _ => self.making.move_at_random(piece),
            };
            *budget = budget.saturating_sub(done.div_ceil(AT_ONCE) as u64);
        }
        self.making = Making::default();
        true
    }

    /// Gives their scores to at most so many patterns more; how many.
    fn rate(&mut self, piece: usize) -> usize {
        if self.after.is_empty() {
            self.after = vec![[BLOCKED; MOVES]; self.distance.len()];
        }
        let Making { reached, next, means, rated, .. } = &mut self.making;
        let home = means.first().copied().unwrap_or(0);
        let score =
            |next: u32| means.get(next as usize).map_or(BLOCKED, |mean| score(mean.saturating_sub(home)));
        let before = *rated;
        for (&(places, occupied), next) in reached.iter().zip(next.iter()).skip(before).take(piece) {
            self.after[index(0, places, &drawers(occupied))] = next.map(score);
            *rated += 1;
        }
        *rated - before
    }
}

impl Making {
    /// The mean distances of at most so many patterns more after one random move more; how many.
    fn move_at_random(&mut self, piece: usize) -> usize {
        let before = self.further.len();
        let mean = |next: &[u32; MOVES]| {
            let means = next.iter().filter_map(|&next| self.means.get(next as usize));
            let (sum, count) = means.fold((0, 0), |(sum, count), mean| (sum + mean, count + 1));
            sum / u32::max(count, 1)
        };
        self.further.extend(self.next.iter().skip(before).take(piece).map(mean));
        let done = self.further.len() - before;
        if self.further.len() == self.next.len() {
            self.means = std::mem::take(&mut self.further);
            self.random_moves += 1;
        }
        done
    }
}

impl Default for Patterns {
    fn default() -> Patterns {
        let solved = Wheel::solved();
        Patterns { colour: Table::new(solved.colour(0), CHOICES), grey: Table::new(solved.grey(), PLACES) }
    }
}

impl Patterns {
    /// Works until the budget of moves is used up or the distances are known; whether they are.
    pub(super) fn measure(&mut self, budget: &mut u64) -> bool {
        self.colour.measure(budget) && self.grey.measure(budget)
    }

    /// Works until the budget is used up or the scores are known too, after the distances; whether they are.
    pub(super) fn score(&mut self, budget: &mut u64) -> bool {
        self.colour.score(budget) && self.grey.score(budget)
    }

    /// The distances of the six colours, once they are known.
    fn distances(&self, wheel: &Wheel) -> [u8; ARMS] {
        let out = drawers(wheel.occupied());
        std::array::from_fn(|colour| self.colour.distance[index(colour, wheel.colour(colour), &out)])
    }

    /// No less than so many moves lead to solved.
    pub(super) fn bound(&self, wheel: &Wheel) -> u8 {
        self.distances(wheel).into_iter().max().unwrap_or(0)
    }

    /// Once the scores are known: the bound, and the scores of the positions after the twelve moves, each below
    /// [`BLOCKED`] unless the move is impossible.
    pub(super) fn look(&self, wheel: &Wheel) -> (u8, Scores) {
        let out = drawers(wheel.occupied());
        let mut scores = self.grey.after[index(0, wheel.grey(), &out)];
        let mut bound = 0;
        for colour in 0..ARMS {
            let row = index(colour, wheel.colour(colour), &out);
            bound = bound.max(self.colour.distance[row]);
            let after = &self.colour.after[row];
            for arm in 0..ARMS {
                // The colour's table has turned arms.
                scores[arm] = scores[arm].saturating_add(after[(arm + ARMS - colour) % ARMS]);
            }
            for ring in ARMS..MOVES {
                scores[ring] = scores[ring].saturating_add(after[ring]);
            }
        }
        (bound, scores)
    }
}

#[cfg(test)]
pub(super) fn whole() -> Patterns {
    let mut patterns = Patterns::default();
    assert!(patterns.measure(&mut u64::MAX.clone()) && patterns.score(&mut u64::MAX.clone()));
    patterns
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn as_many_patterns_as_there_are() {
        let patterns = whole();
        let known = patterns.colour.distance.iter().filter(|&&distance| distance != UNKNOWN);
        assert_eq!(known.clone().count(), 341_550);
        assert_eq!(known.max(), Some(&16));
        assert_eq!(patterns.distances(&Wheel::solved()), [0; 6]);
    }

    #[test]
    fn a_position_has_the_same_score_from_everywhere() {
        let patterns = whole();
        proptest!(|(moves in prop::collection::vec(0usize..12, 0..40))| {
            let moves: Vec<Move> = moves.into_iter().map(|index| Move::ALL[index]).collect();
            let wheel = Wheel::solved().after_all(&moves);
            prop_assert_eq!(patterns.look(&wheel).0, patterns.bound(&wheel));
            let from = |a_move: Move| {
                let before = wheel.after(a_move.inverse())?;
                Some(patterns.look(&before).1[a_move as usize])
            };
            let scores: Vec<u16> = Move::ALL.into_iter().filter_map(from).collect();
            prop_assert!(scores.iter().all(|&score| score == scores[0] && score < BLOCKED));
            for a_move in Move::ALL {
                let blocked = patterns.look(&wheel).1[a_move as usize] == BLOCKED;
                prop_assert_eq!(blocked, !wheel.allows(a_move));
            }
        });
    }

    #[test]
    fn scores_are_means_over_random_moves() {
        let patterns = whole();
        // Colour 1 of the solved wheel, all ways of three moves written out.
        let mean = |wheel: Wheel| {
            let mut mean = [(wheel, 1.0)].to_vec();
            for _ in 0..RANDOM_MOVES {
                let next = |(wheel, share): (Wheel, f64)| {
                    let next: Vec<Wheel> = Move::ALL.iter().filter_map(|&it| wheel.after(it)).collect();
                    let share = share / next.len() as f64;
                    next.into_iter().map(move |wheel| (wheel, share))
                };
                mean = mean.into_iter().flat_map(next).collect();
            }
            mean.iter().map(|(wheel, share)| f64::from(patterns.distances(wheel)[0]) * share).sum::<f64>()
        };
        let (solved, out) = (Wheel::solved(), drawers(Wheel::solved().occupied()));
        let scores = patterns.colour.after[index(0, solved.colour(0), &out)];
        for a_move in Move::ALL {
            let expected = mean(solved.after(a_move).unwrap()) - mean(solved);
            assert!((f64::from(scores[a_move as usize]) - 32.0 * expected.powi(2)).abs() <= 1.0);
        }
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
