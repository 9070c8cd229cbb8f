//! The reasons why a question has no answer.

use std::fmt;

/// Why a program does not get what it waits for. Both reasons travel by `?`: closing leaves the program, Esc leaves
/// the command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The display is being closed, or a guest returns to its host. A program with unsaved work catches this and
    /// asks.
    Closed,
    /// Esc: the command is not carried out. Only questions end like this, never a wait for an event.
    Cancelled,
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Stop::Closed => "the display is being closed",
            Stop::Cancelled => "Esc was pressed",
        })
    }
}

impl std::error::Error for Stop {}

/// An answer, or why there is none.
pub type Asked<T> = Result<T, Stop>;

/// What can be done with an [`Asked`] besides `?`.
pub trait Asking<T> {
    /// `None` for Esc, where it has a meaning of its own.
    ///
    /// # Errors
    /// [`Stop::Closed`] and nothing else.
    fn unless_cancelled(self) -> Asked<Option<T>>;
}

impl<T> Asking<T> for Asked<T> {
    fn unless_cancelled(self) -> Asked<Option<T>> {
        match self {
            Ok(answer) => Ok(Some(answer)),
            Err(Stop::Cancelled) => Ok(None),
            Err(Stop::Closed) => Err(Stop::Closed),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_esc_can_be_given_a_meaning() {
        assert_eq!(Ok(1).unless_cancelled(), Ok(Some(1)));
        assert_eq!(Err::<i32, _>(Stop::Cancelled).unless_cancelled(), Ok(None));
        assert_eq!(Err::<i32, _>(Stop::Closed).unless_cancelled(), Err(Stop::Closed));
    }
}
