//! Unsaved work that outlives a crash: what a program is working on is kept beside its files, and a later
//! start of the program finds what a session that broke off has left.
//!
//! Here is only what programs see of it; the place on the disk is in `disk`. A machine without a [`Recovery`] keeps
//! nothing, as in scripts and in the library without file system.

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

/// Work that a session has left behind without an end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lost {
    /// What the place of recovery calls it, for messages.
    pub name: String,
    /// How long ago it was kept last, if the clocks tell.
    pub age: Option<Duration>,
    /// The work; else why what is there is none.
    pub work: Result<Work, String>,
}

/// What becomes of lost work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It is this session's unsaved work from now on.
    TakenUp,
    /// Nobody wants it any more.
    Deleted,
    /// The next start of the program shall ask again.
    Later,
    /// It cannot be read, and is set aside for somebody who can.
    Broken,
}

/// A place where unsaved work is safe from a crash.
pub trait Recovery {
    /// Makes this the session's unsaved work, instead of what was kept before. Returns at once; the work is
    /// safe in less than a second.
    fn keep(&mut self, work: Work);

    /// The session has nothing unsaved any more.
    fn forget(&mut self);

    /// The newest work that a session of a program has left behind and that this session has not been told
    /// of. It stays this session's until [`Recovery::settle`], so that no other one is offered the same; work
    /// of a session that still runs is nobody else's.
    fn lost(&mut self, program: &str) -> Option<Lost>;

    /// Decides on the work of the last [`Recovery::lost`].
    fn settle(&mut self, verdict: Verdict);

    /// Why work could not be kept; told once.
    fn problem(&mut self) -> Option<String>;
}
