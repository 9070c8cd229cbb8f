//! How a program starts: its command line, its file, its display. Every program of the book starts
//! through here, by its own name or by way of `grafika`.
//!
//! Exit status: 0 done, 1 the work failed, 2 the command line or the script is wrong.

mod display;
mod failure;
mod open;
mod options;
mod outlet;

pub use failure::{Failure, exit};
pub use open::{Opened, kind_of, open};
use open::{folder_of, open_in};
pub use options::{DisplayKind, Options, RunOptions};
pub use outlet::write_output;

use crate::file::Document;
use crate::machine::{Language, Machine, Quit, Session};
use crate::ui::{Manual, Phrase};
use clap::{Args, Command, FromArgMatches};
use std::ffi::OsString;
use std::future::Future;
use std::pin::Pin;
use std::process::ExitCode;

/// A running program: ready when it has ended.
pub type Run<'m> = Pin<Box<dyn Future<Output = Result<(), Quit>> + 'm>>;

/// The check of a program that works without any file.
///
/// # Errors
/// Always: that it takes none.
pub fn no_file(_: &Document) -> Result<(), Phrase> {
    Err(Phrase::new("ez a program file nélkül működik", "this program takes no file"))
}

/// A program of the book.
#[derive(Clone, Copy)]
pub struct Program {
    /// Its name, a line about it, its keys.
    pub manual: Manual,
    /// The book's chapters about it.
    pub chapter: &'static str,
    /// Runs it on a machine, with a file or without.
    pub run: for<'m> fn(&'m mut Machine, Option<Document>) -> Run<'m>,
    /// Whether it can work with a document; else why not.
    pub check: fn(&Document) -> Result<(), Phrase>,
}

impl Program {
    /// The `main` of a program that has a binary of its own.
    pub fn main(&self) -> ExitCode {
        exit(self.manual.name, self.start_from(std::env::args_os()))
    }

    /// Starts the program with a command line, whose first word is the program's name.
    ///
    /// # Errors
    /// [`Failure`] when the command line is wrong, or a file, a script or a display does not work.
    pub fn start_from(&self, arguments: impl IntoIterator<Item = OsString>) -> Result<(), Failure> {
        let command = Command::new(self.manual.name).about(self.manual.about.1);
        let command = Options::augment_args(command).version(env!("CARGO_PKG_VERSION"));
        let matches = command.try_get_matches_from(arguments)?;
        self.start(&Options::from_arg_matches(&matches)?)
    }

    /// Starts the program with the options of a command line and stays until it has ended.
    ///
    /// # Errors
    /// [`Failure`] when a file, a script or a display does not work.
    pub fn start(&self, options: &Options) -> Result<(), Failure> {
        let path = options.file.as_deref();
        let mut machine = options.run.machine(path.map(folder_of).unwrap_or_default());
        // Through the machine's own storage, which remembers what was read.
        let opened = path.map(|path| open_in(machine.storage(), path)).transpose()?;
        if let Some(opened) = &opened {
            (self.check)(&opened.document).map_err(|problem| {
                Failure::work(format!("{}: {}", opened.name, problem.of(Language::English)))
            })?;
        }
        machine.set_file(opened.as_ref().map(|opened| opened.file_name.clone()));
        let document = opened.map(|opened| opened.document);
        let run = self.run;
        let session =
            Session::start(machine, move |mut machine| async move { run(&mut machine, document).await });
        display::show(session, self.manual.name, &options.run)
    }
}
