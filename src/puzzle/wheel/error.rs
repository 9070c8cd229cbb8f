//! What can be wrong with a text or with a position.

use std::fmt;

/// A text that is no move or no position, or a move that is not possible.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WheelError {
    /// A letter that names no move.
    Letter {
        /// The letter.
        letter: char,
        /// Its place in the text, from 1.
        at: usize,
    },
    /// A drawer is pushed that is in.
    Blocked {
        /// The letter of the move.
        letter: char,
        /// Its place in the text, from 1.
        at: usize,
    },
    /// A position that the wheel cannot be in.
    Position(String),
}

impl fmt::Display for WheelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WheelError::Letter { letter, at } => {
                write!(f, "letter {at}: {letter:?} is no move; moves are A to F and I to N")
            }
            WheelError::Blocked { letter, at } => {
                write!(
                    f,
                    "letter {at}: {letter} pushes a drawer that is in; the one opposite must be pushed first"
                )
            }
            WheelError::Position(problem) => f.write_str(problem),
        }
    }
}

impl std::error::Error for WheelError {}
