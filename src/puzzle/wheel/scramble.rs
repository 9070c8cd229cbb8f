//! Problems that a number and a difficulty make again anywhere.

use super::{Move, Wheel, moves::Tail, state::ARMS};
use crate::geometry::Dice;
use serde::{Deserialize, Serialize};

/// How hard a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Difficulty {
    /// The shortest solution has four moves.
    Four,
    /// The shortest solution has eight moves.
    Eight,
    /// Sixteen moves from solved, none of them plainly needless; the shortest solution may be a little
    /// shorter.
    Sixteen,
    /// The book's way: 97 random letters, then every drawer that is out is pushed in.
    #[default]
    Book,
    /// Every position with the drawers at home is equally likely.
    Any,
}

/// A problem and how it was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scramble {
    /// The position.
    pub wheel: Wheel,
    /// The moves from the solved wheel that led there; none for [`Difficulty::Any`], which is dealt.
    pub moves: Vec<Move>,
}

/// Draws of the book's scramble.
const DRAWS: usize = 97;

impl Scramble {
    /// The problem of a number.
    #[must_use]
    pub fn new(difficulty: Difficulty, number: u64) -> Scramble {
        let mut dice = Dice::new(number);
        match difficulty {
            Difficulty::Four => really_far(4, &mut dice),
            Difficulty::Eight => really_far(8, &mut dice),
            Difficulty::Sixteen => walk(16, &mut dice),
            Difficulty::Book => book(&mut dice),
            Difficulty::Any => deal(&mut dice),
        }
    }

    /// Makes a move, if it is possible.
    fn push(&mut self, a_move: Move) {
        if let Some(next) = self.wheel.after(a_move) {
            self.wheel = next;
            self.moves.push(a_move);
        }
    }
}

/// A walk from solved without moves that are plainly needless.
fn walk(length: usize, dice: &mut Dice) -> Scramble {
    let (mut wheel, mut tail, mut moves) = (Wheel::solved(), Tail::default(), Vec::new());
    while moves.len() < length {
        // Some move is always possible: no more than three drawers are in.
        let a_move = Move::ALL[dice.below(Move::ALL.len())];
        if let (Some(next), Some(longer)) = (wheel.after(a_move), tail.then(a_move)) {
            (wheel, tail) = (next, longer);
            moves.push(a_move);
        }
    }
    Scramble { wheel, moves }
}

/// A walk that is no detour. Walks of four and eight moves are known to be no detours when those of half
/// the length from either end do not meet earlier.
fn really_far(length: usize, dice: &mut Dice) -> Scramble {
    loop {
        let scramble = walk(length, dice);
        // Nearly half of the walks of eight moves are no detours.
        if no_shorter(&scramble.wheel, length) {
            return scramble;
        }
    }
}

/// Whether no fewer than so many moves lead from solved to a position: positions around both, half of the
/// moves each, have nothing in common earlier.
fn no_shorter(wheel: &Wheel, length: usize) -> bool {
    let mut ends = [around(Wheel::solved()), around(*wheel)];
    let mut known: [Vec<Wheel>; 2] = [vec![Wheel::solved()], vec![*wheel]];
    let mut apart = 0;
    while apart < length {
        if known[0].iter().any(|near| known[1].binary_search(near).is_ok()) {
            return false;
        }
        let side = apart % 2;
        known[side] = ends[side].grow();
        apart += 1;
    }
    true
}

/// Layers of positions around one.
struct Layers {
    all: std::collections::HashSet<Wheel>,
    layer: Vec<Wheel>,
}

fn around(wheel: Wheel) -> Layers {
    Layers { all: [wheel].into(), layer: vec![wheel] }
}

impl Layers {
    /// Goes one move further; the new outermost layer, sorted.
    fn grow(&mut self) -> Vec<Wheel> {
        let next = |wheel: &Wheel| Move::ALL.map(|a_move| wheel.after(a_move));
        let reached = self.layer.iter().flat_map(next).flatten();
        self.layer = reached.filter(|&wheel| self.all.insert(wheel)).collect();
        self.layer.sort_unstable();
        self.layer.clone()
    }
}

fn book(dice: &mut Dice) -> Scramble {
    let mut scramble = Scramble { wheel: Wheel::solved(), moves: Vec::new() };
    for _ in 0..DRAWS {
        scramble.push(Move::ALL[dice.below(Move::ALL.len())]);
    }
    for (arm, drawer) in (1..=ARMS).zip(Move::ALL) {
        if scramble.wheel.drawer(arm) == 3 {
            scramble.push(drawer);
        }
    }
    scramble
}

/// Beads dealt at random, each arrangement equally likely.
fn deal(dice: &mut Dice) -> Scramble {
    let mut beads: Vec<u8> = (0..25).map(|index| if index == 0 { 0 } else { (index - 1) / 4 + 1 }).collect();
    for last in (1..beads.len()).rev() {
        beads.swap(last, dice.below(last + 1));
    }
    let arm = |arm: usize| beads.get(1 + 4 * arm..5 + 4 * arm).unwrap_or(&[]);
    let arms: [&[u8]; ARMS] = std::array::from_fn(arm);
    // These are the beads of the wheel, four in every arm.
    let wheel =
        Wheel::from_beads(beads.first().copied().unwrap_or(0), &arms).unwrap_or_else(|_| Wheel::solved());
    Scramble { wheel, moves: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::super::{Search, Solver};
    use super::*;

    #[test]
    fn a_number_makes_the_same_problem_again() {
        for difficulty in
            [Difficulty::Four, Difficulty::Eight, Difficulty::Sixteen, Difficulty::Book, Difficulty::Any]
        {
            let problem = Scramble::new(difficulty, 7);
            assert_eq!(problem, Scramble::new(difficulty, 7));
            assert_ne!(problem.wheel, Scramble::new(difficulty, 8).wheel);
            if difficulty != Difficulty::Any {
                assert_eq!(Wheel::solved().replay(&problem.moves), Ok(problem.wheel));
            }
        }
    }

    #[test]
    fn four_is_four_and_eight_is_eight() {
        for (difficulty, length) in [(Difficulty::Four, 4), (Difficulty::Eight, 8)] {
            for number in 0..3 {
                let mut solver = Solver::new(Scramble::new(difficulty, number).wheel);
                let progress = solver.step(u64::MAX);
                assert_eq!((progress.search, progress.best), (Search::Done, Some(length)));
            }
        }
    }

    #[test]
    fn the_books_problems_have_their_drawers_at_home() {
        for number in 0..50 {
            let problem = Scramble::new(Difficulty::Book, number);
            assert!((1..=ARMS).all(|arm| problem.wheel.drawer(arm) == 1));
            assert!(problem.moves.len() <= 100);
        }
    }
}
