//! What runs by itself: a search, the playing of a solution, the demonstration.

use crate::puzzle::wheel::{Difficulty, Move, Scramble, Search, Solver, Tables, Wheel};
use std::time::Duration;

/// Time between two moves.
const PACE: Duration = Duration::from_millis(600);
/// Time before the first and after the last move of the demonstration.
const PAUSE: Duration = Duration::from_millis(3000);
/// Positions that a search looks at in one piece, and the time on the clock that a piece has: more than it takes.
/// Pieces are counted by the clock, so that a search comes equally far in a recording.
const PIECE: u64 = 10_000;
const PIECE_TIME: Duration = Duration::from_millis(8);

/// What a search is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Aim {
    /// The next move.
    Hint,
    /// The whole solution, to be played.
    Solve,
}

impl Aim {
    /// How many positions a search for this looks at before it is content with what it has: as many as the
    /// solver's second and third beam need.
    fn enough(self) -> u64 {
        match self {
            Aim::Hint => 2_300_000,
            Aim::Solve => 12_500_000,
        }
    }
}

/// A search in the picture.
pub(crate) struct Seeking {
    pub(crate) aim: Aim,
    pub(crate) solver: Box<Solver>,
    /// When the next piece is due.
    pub(crate) due: Duration,
}

impl Seeking {
    /// Starts a search with the tables of an earlier one.
    pub(crate) fn new(aim: Aim, wheel: Wheel, tables: Tables, now: Duration) -> Seeking {
        Seeking { aim, solver: Box::new(Solver::with_tables(wheel, tables)), due: now + PIECE_TIME }
    }

    /// Continues the search if a piece is due; returns whether the search has ended.
    pub(crate) fn advance(&mut self, now: Duration) -> bool {
        if now < self.due {
            return false;
        }
        self.due = now + PIECE_TIME;
        let progress = self.solver.step(PIECE);
        progress.search == Search::Done || (progress.best.is_some() && progress.spent >= self.aim.enough())
    }
}

/// Moves that are made one after the other.
pub(crate) struct Playing {
    /// The moves to come, the next one last.
    to_come: Vec<Move>,
    /// How many there were.
    pub(crate) count: usize,
    /// Whether no way is shorter.
    pub(crate) proven: bool,
    /// When the next move is due.
    pub(crate) due: Duration,
}

impl Playing {
    /// Plays a solution from a moment on.
    pub(crate) fn new(moves: &[Move], proven: bool, now: Duration) -> Playing {
        let to_come = moves.iter().rev().copied().collect();
        Playing { to_come, count: moves.len(), proven, due: now + PACE }
    }

    /// The move that is due.
    pub(crate) fn next(&mut self, now: Duration) -> Option<Move> {
        if now < self.due {
            return None;
        }
        self.due += PACE;
        self.to_come.pop()
    }

    /// Whether all moves are made.
    pub(crate) fn is_over(&self) -> bool {
        self.to_come.is_empty()
    }
}

/// The demonstration: a wheel of its own is disarranged by the book's rule and led back the same way.
pub(crate) struct Demonstration {
    pub(crate) wheel: Wheel,
    /// The moves to undo, the next one last.
    made: Vec<Move>,
    pub(crate) due: Duration,
}

impl Demonstration {
    /// Begins with the problem of a number.
    pub(crate) fn new(number: u64, now: Duration) -> Demonstration {
        let Scramble { wheel, moves } = Scramble::new(Difficulty::Book, number);
        Demonstration { wheel, made: moves, due: now + PAUSE }
    }

    /// Makes the moves that are due; returns whether the demonstration is over.
    pub(crate) fn advance(&mut self, now: Duration) -> bool {
        while self.due <= now {
            let Some(made) = self.made.pop() else { return true };
            self.wheel = self.wheel.after(made.inverse()).unwrap_or(self.wheel);
            self.due += if self.made.is_empty() { PAUSE } else { PACE };
        }
        false
    }
}

/// What goes on by itself, if anything.
pub(crate) enum Show {
    Nothing,
    Seeking(Seeking),
    Playing(Playing),
    Demonstration(Demonstration),
}
