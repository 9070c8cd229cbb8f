//! How a program starts: its command line, its file, its display. Every program of the book starts
//! through here, by its own name or by way of `grafika`.
//!
//! Exit status: 0 done, 1 the work failed, 2 the command line or the script is wrong.

mod config;
mod display;
mod failure;
mod open;
mod options;
mod outlet;
pub mod progress;

pub use config::{config_path, configure};
pub use display::{has_terminal, in_terminal};
pub use failure::{Failure, exit};
pub use open::{Opened, kind_of, open, open_as, read_stdin};
use open::{folder_of, open_in};
pub use options::{DisplayKind, Options, RunOptions};
pub use outlet::write_output;

use crate::file::{Document, Format};
use crate::machine::{Asked, Language, Machine, SAMPLES, Session};
use crate::ui::{Manual, Phrase};
use clap::{Args, Command, FromArgMatches};
use std::ffi::OsString;
use std::future::Future;
use std::pin::Pin;
use std::process::ExitCode;

/// A running program: ready when it has ended.
pub type Run<'m> = Pin<Box<dyn Future<Output = Asked<()>> + 'm>>;

/// The check of a program that works without any file.
///
/// # Errors
/// Always: that it takes none.
pub fn no_file(_: &Document) -> Result<(), Phrase> {
    Err(Phrase::new("ez a program file nélkül működik", "this program takes no file"))
}

/// Examples of a program's command line, with a sample where it has one.
fn examples(name: &str) -> String {
    let reads = |format: &&Format| format.programs().iter().any(|program| program.eq_ignore_ascii_case(name));
    let sample = |format: &Format| {
        let has = |(file, _): &&(&'static str, _)| Format::from_name(file) == Some(*format);
        SAMPLES.iter().find(has).map(|(file, _)| *file)
    };
    let file = Format::ALL.iter().filter(reads).find_map(sample);
    let with_file = file.map(|file| format!("  {name} {file}\n")).unwrap_or_default();
    format!(
        "Examples:\n  {name}\n{with_file}  {name} --lang en --display terminal\n  {name} --script demo.txt"
    )
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
        let matches = self.command().try_get_matches_from(arguments)?;
        self.start(&Options::from_arg_matches(&matches)?)
    }

    /// The program's command line as it is described: help, completions and manual page come from it.
    pub fn command(&self) -> Command {
        // The options bring a line of their own with them, which is about options.
        let command = Options::augment_args(Command::new(self.manual.name)).about(self.manual.about.1);
        command.version(env!("CARGO_PKG_VERSION")).after_help(examples(self.manual.name))
    }

    /// Starts the program with the options of a command line and stays until it has ended.
    ///
    /// # Errors
    /// [`Failure`] when a file, a script or a display does not work.
    pub fn start(&self, options: &Options) -> Result<(), Failure> {
        let (path, run_options) = (options.file.as_deref(), options.run.preferred());
        let mut machine = run_options.machine(path.map_or_else(|| run_options.folder(), folder_of));
        // Through the machine's own storage, which remembers what was read.
        let opened = path.map(|path| open_in(machine.storage(), path, None)).transpose()?;
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
        display::show(session, self.manual.name, &run_options)
    }
}
