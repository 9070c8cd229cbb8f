//! Pages of a text mode, as the installer of the book's disk had them: a list on the left, a summary of what is
//! chosen on the right, the keys on the last line, and questions over it.
//!
//! A [`TextProgram`] says what its page is and is told what happens; it draws nothing and waits for nothing, so
//! that the same program is shown in a terminal ([`in_terminal`]), on the 640x480 screen of a [`Machine`]
//! ([`on_machine`]) and in tests. Pages are drawn with `ratatui`, which is seen nowhere outside of this room.
//!
//! [`Machine`]: crate::machine::Machine

mod choose;
mod entry;
mod page;
mod paint;
#[cfg(feature = "terminal")]
mod terminal;

pub use choose::chosen_after;
pub use entry::Line;
pub use page::{Hit, LEAST, Overlay, Page, Row, Summary};
pub use paint::{COLUMNS, ROWS, on_machine};
#[cfg(feature = "terminal")]
pub use terminal::in_terminal;

use crate::machine::Key;

/// What happens to a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextEvent {
    /// A key.
    Key(Key),
    /// A click on something.
    Click(Hit),
    /// The wheel, in steps; positive is away from the user.
    Wheel(i32),
    /// The display is being closed.
    Close,
}

/// What a program does by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doing {
    /// It waits for its user.
    Waiting,
    /// It has work left: [`TextProgram::work`] wants to be called again.
    Working,
    /// It has ended.
    Ended,
}

/// A program that shows pages.
pub trait TextProgram {
    /// The page as it stands.
    fn page(&self) -> Page;

    /// Something has happened.
    fn event(&mut self, event: TextEvent);

    /// Does the next piece of the work, if there is any: a few milliseconds, so that the page stays alive.
    fn work(&mut self);

    /// Whether it waits, works or has ended.
    fn doing(&self) -> Doing;
}
