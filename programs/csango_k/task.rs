//! What the program does by itself: searching for a filling and for the moves that build it, and playing them.

use super::game::Deal;
use crate::puzzle::cube::{CsangoCube, Move, Rules, Solver, WayError};
use std::collections::VecDeque;
use std::time::Duration;

/// Nodes of the search in a frame.
const NODES: u64 = 2000;
/// Time between two moves that are played.
pub(crate) const PACE: Duration = Duration::from_millis(150);

/// What the moves are wanted for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// The first one is shown.
    Hint,
    /// All are played.
    Solution,
    /// A game begins somewhere on their way.
    Deal(Deal),
}

/// The search for the moves to the finished cube.
pub(crate) struct Quest {
    pub(crate) wanted: Wanted,
    solver: Solver,
}

impl Quest {
    pub(crate) fn new(from: CsangoCube, rules: Rules, wanted: Wanted, seed: u64) -> Quest {
        Quest { wanted, solver: Solver::new(&from, rules, seed) }
    }

    /// The progress: nodes searched, pieces with a path.
    pub(crate) fn progress(&self) -> (u64, usize) {
        self.solver.progress()
    }

    /// Continues for the time of a frame; returns the moves when they are found.
    ///
    /// # Errors
    /// [`WayError`] if there are none.
    pub(crate) fn advance(&mut self) -> Result<Option<Vec<Move>>, WayError> {
        self.solver.advance(NODES)
    }
}

/// What goes on without the player.
pub(crate) enum Task {
    /// Nothing.
    Idle,
    /// A search.
    Seeking(Box<Quest>),
    /// Moves, and when the next one is due.
    Playing(VecDeque<Move>, Duration),
}

/// Moves that lead from a position to the finished cube.
pub(crate) struct Plan {
    pub(crate) at: CsangoCube,
    pub(crate) rules: Rules,
    pub(crate) moves: VecDeque<Move>,
}

impl Plan {
    /// The plan after a move, which continues if the move was its own.
    pub(crate) fn after(mut self, step: Move, cube: CsangoCube) -> Option<Plan> {
        let own = self.moves.pop_front() == Some(step);
        own.then_some(Plan { at: cube, ..self })
    }
}
