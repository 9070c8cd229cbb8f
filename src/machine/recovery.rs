//! Unsaved work that outlives a crash: it is kept outside the process, and a later start finds what a broken session
//! left.
//!
//! This is the programs' view; the implementation on disk is in `disk`. Scripts, and the library without a file
//! system, have no [`Recovery`] and keep nothing.

use std::time::Duration;

/// Unsaved work of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Work {
    /// The program's name.
    pub program: String,
    /// The file that the work was read from or saved in last, if there is one.
    pub file: Option<String>,
    /// The work itself, as the program writes and reads it.
    pub content: String,
}

/// Work left behind by a session that broke off.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lost {
    /// Its name in the place of recovery, for messages.
    pub name: String,
    /// How long ago it was last kept, if known.
    pub age: Option<Duration>,
    /// The work, or why it cannot be read.
    pub work: Result<Work, String>,
}

/// What becomes of lost work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It becomes the unsaved work of this session.
    TakenUp,
    /// It is deleted.
    Deleted,
    /// The next start of the program asks again.
    Later,
    /// It cannot be read and is set aside for the user.
    Broken,
}

/// A place that keeps unsaved work across a crash.
pub trait Recovery {
    /// Replaces the session's unsaved work. Returns at once; the work is safe within a second.
    fn keep(&mut self, work: Work);

    /// The session has nothing unsaved any more.
    fn forget(&mut self);

    /// The newest work of a program that a session left behind and that has not been offered here yet. It is reserved
    /// for this session until [`Recovery::settle`]. Work of a running session is never offered.
    fn lost(&mut self, program: &str) -> Option<Lost>;

    /// Decides on the work of the last [`Recovery::lost`].
    fn settle(&mut self, verdict: Verdict);

    /// Why work could not be kept; reported once.
    fn problem(&mut self) -> Option<String>;
}
