//! The best results of games, which outlive a session. Values only: where they are kept is decided by whoever starts
//! the programs.

use serde::{Deserialize, Serialize};

/// The best that a player has reached in a game of some difficulty; each number may be of another game.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Best {
    /// The fewest moves.
    pub moves: u32,
    /// The shortest time in seconds.
    pub seconds: u64,
}

impl Best {
    /// The better of both in either number.
    #[must_use]
    pub fn with(self, other: Best) -> Best {
        Best { moves: self.moves.min(other.moves), seconds: self.seconds.min(other.seconds) }
    }
}

/// A place that keeps the best results. Scripts, and the library without a file system, have none.
pub trait Bests {
    /// The best result of a game, which is named after its program and difficulty.
    fn best(&self, game: &str) -> Option<Best>;

    /// Keeps a result if it is better than what is known in either number.
    ///
    /// # Errors
    /// Why it cannot be kept, for the user.
    fn keep(&mut self, game: &str, result: Best) -> Result<(), String>;
}
