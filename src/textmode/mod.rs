//! Pages in text mode, as the installer on the book's disk had them: a list on the left, a summary of the choice on
//! the right, keys on the last line, and questions over the page.
//!
//! A [`TextProgram`] describes its page and receives events. It draws nothing and waits for nothing, so that the
//! same program runs in a terminal ([`in_terminal`]), on the 640x480 screen of a [`Machine`] ([`on_machine`]) and
//! in tests. Pages are drawn with `ratatui`, which no program sees.
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

/// An event of a page.
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

/// Whether a program waits, works or has ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doing {
    /// It waits for the user.
    Waiting,
    /// It has work left, so [`TextProgram::work`] is called again.
    Working,
    /// It has ended.
    Ended,
}

/// A program that shows pages.
pub trait TextProgram {
    /// The present page.
    fn page(&self) -> Page;

    /// Handles an event.
    fn event(&mut self, event: TextEvent);

    /// Does the next piece of work, if any. It takes a few milliseconds, so that the page stays responsive.
    fn work(&mut self);

    /// Whether it waits, works or has ended.
    fn doing(&self) -> Doing;
}
