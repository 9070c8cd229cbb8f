//! What the program does by itself: looking for a filling, for the moves that build it, and making them.

use super::game::Deal;
use crate::puzzle::cube::{CsangoCube, Move, Progress, Rules, Search, Way, WayError};
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
    from: CsangoCube,
    rules: Rules,
    stage: Stage,
    /// Whether the pieces that lie in the cube may have to come out.
    all_out: bool,
}

enum Stage {
    Filling(Search),
    Way(Box<Way>),
}

impl Quest {
    /// A search that leaves the pieces which lie in the cube's place where they are, if it can.
    pub(crate) fn new(from: CsangoCube, rules: Rules, wanted: Wanted, seed: u64) -> Quest {
        let search = Search::new(&from.placed(), seed);
        Quest { wanted, from, rules, stage: Stage::Filling(search), all_out: false }
    }

    /// How far it is: nodes of the search, pieces that have their way.
    pub(crate) fn progress(&self) -> (u64, usize) {
        match &self.stage {
            Stage::Filling(search) => (search.nodes(), 0),
            Stage::Way(way) => (0, way.done()),
        }
    }

    /// Goes on for a frame's time; the moves when they are found.
    ///
    /// # Errors
    /// [`WayError`] if there are none.
    pub(crate) fn advance(&mut self) -> Result<Option<Vec<Move>>, WayError> {
        match &mut self.stage {
            Stage::Filling(search) => match search.advance(NODES) {
                Progress::Working => {}
                Progress::Exhausted => self.anew(WayError::NoFilling)?,
                Progress::Found(filling) => match Way::new(&self.from, &filling, self.rules) {
                    Ok(way) => self.stage = Stage::Way(Box::new(way)),
                    Err(problem) => self.anew(problem)?,
                },
            },
            Stage::Way(way) => match way.advance() {
                Ok(found) => return Ok(found),
                Err(problem) => self.anew(problem)?,
            },
        }
        Ok(None)
    }

    /// Begins again without keeping anything in its place; that failing is the end.
    fn anew(&mut self, problem: WayError) -> Result<(), WayError> {
        if self.all_out {
            return Err(problem);
        }
        self.all_out = true;
        self.stage = Stage::Filling(Search::new(&[], 0));
        Ok(())
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
    /// The plan after a move: it goes on if that was its own.
    pub(crate) fn after(mut self, step: Move, cube: CsangoCube) -> Option<Plan> {
        let own = self.moves.pop_front() == Some(step);
        own.then_some(Plan { at: cube, ..self })
    }
}
