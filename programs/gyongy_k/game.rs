//! The game as a plain value, which undo restores.

use super::super::puzzles::Help;
use super::texts;
use crate::file::Document;
use crate::puzzle::wheel::{Difficulty, Move, Scramble, Wheel};
use crate::ui::Phrase;
use serde::{Deserialize, Serialize};

/// A problem that its number reproduces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Problem {
    pub(crate) difficulty: Difficulty,
    pub(crate) number: u64,
}

/// A position, and the way to it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Game {
    /// Where the game began.
    pub(crate) start: Wheel,
    pub(crate) wheel: Wheel,
    /// Moves since the start.
    pub(crate) moves: u32,
    /// The problem it began with.
    #[serde(skip)]
    pub(crate) problem: Option<Problem>,
    /// How much the machine has helped since the start.
    pub(crate) help: Help,
}

/// A game as it is kept while it is unsaved.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Work {
    start: Wheel,
    wheel: Wheel,
    moves: u32,
    problem: Option<Problem>,
    #[serde(default)]
    help: Help,
}

impl Problem {
    /// The shortest way back that is known from how the problem was made, and whether it is proven to be shortest.
    pub(crate) fn known(self) -> Option<(usize, bool)> {
        match self.difficulty {
            Difficulty::Four => Some((4, true)),
            Difficulty::Eight => Some((8, true)),
            Difficulty::Sixteen => Some((16, false)),
            // A walk of some hundred letters tells nothing, and dealt beads have none.
            Difficulty::Book | Difficulty::Any => None,
        }
    }
}

impl Game {
    /// A game that begins at a position.
    pub(crate) fn from(start: Wheel) -> Game {
        Game { start, wheel: start, moves: 0, problem: None, help: Help::None }
    }

    /// A game that begins with a problem.
    pub(crate) fn new(problem: Problem) -> Game {
        let wheel = Scramble::new(problem.difficulty, problem.number).wheel;
        Game { problem: Some(problem), ..Game::from(wheel) }
    }

    /// The game that a document holds.
    ///
    /// # Errors
    /// Why it is none.
    pub(crate) fn of(document: &Document) -> Result<Game, Phrase> {
        let Document::BeadWheel(wheel) = document else { return Err(texts::NO_WHEEL.into()) };
        Wheel::try_from(wheel).map(Game::from).map_err(|error| Phrase::plain(&error))
    }

    /// The whole game as text, including what a file does not hold.
    ///
    /// # Errors
    /// What cannot be written.
    pub(crate) fn to_work(&self) -> Result<String, Phrase> {
        let Game { start, wheel, moves, problem, help } = *self;
        serde_json::to_string(&Work { start, wheel, moves, problem, help })
            .map_err(|error| Phrase::plain(&error))
    }

    /// The game in such a text.
    ///
    /// # Errors
    /// Why there is none.
    pub(crate) fn from_work(text: &str) -> Result<Game, Phrase> {
        let work: Work = serde_json::from_str(text).map_err(|error| Phrase::plain(&error))?;
        let Work { start, wheel, moves, problem, help } = work;
        Ok(Game { start, wheel, moves, problem, help })
    }

    /// The game after a move, if it is possible.
    pub(crate) fn after(&self, a_move: Move) -> Option<Game> {
        let wheel = self.wheel.after(a_move)?;
        Some(Game { wheel, moves: self.moves.saturating_add(1), ..self.clone() })
    }

    /// The same game from its start.
    pub(crate) fn restarted(&self) -> Game {
        Game { wheel: self.start, moves: 0, help: Help::None, ..self.clone() }
    }
}
