//! How a program starts: its command line, its file, its display. Every program starts here, under its own name or
//! through `grafika`.
//!
//! Exit status: 0 done, 1 the work failed, 2 the command line or the script is wrong.

mod cloud;
mod completions;
mod config;
#[cfg(any(windows, test))]
mod console;
mod display;
mod failure;
mod install;
mod language;
mod meant;
mod open;
mod options;
mod outlet;

pub mod progress;
mod table;

pub use cloud::{CloudFile, CloudSurvey, open_cloud};
pub use completions::{ShellName, complete, completed, registration, words};
pub use config::{configure, settings};
pub use display::{has_terminal, in_terminal};
pub use failure::{Failure, exit};
pub use install::{Install, Uninstall};
pub use language::{in_language, ordered, speaking, spoken};
pub use meant::meant;
pub use open::{Opened, input_kind, kind_of, open, open_as};
use open::{Tables, folder_of, open_in};
pub use options::{DisplayKind, Options, RunOptions};
pub use outlet::{Broken, Overwrite, Sort, Target, answer, say, write_file, write_output};
pub use table::TableArgs;

use crate::file::{Document, Format};
use crate::machine::{SAMPLES, Session};
use crate::ui::{CommandLine, Program};
use crate::work::with_json;
use clap::{Args, Command, FromArgMatches};
use std::ffi::OsString;
use std::process::ExitCode;

/// Examples of a program's command line, with a sample where it has one.
fn examples(program: &Program) -> String {
    let sample = |format: &Format| {
        let has = |(file, _): &&(&'static str, _)| Format::from_name(file) == Some(*format);
        SAMPLES.iter().find(has).map(|(file, _)| *file)
    };
    let name = program.manual.name;
    let file = program.opens.iter().find_map(sample);
    let with_file = file.map(|file| format!("  {name} {file}\n")).unwrap_or_default();
    format!(
        "Examples:\n  {name}\n{with_file}  {name} --lang en --display terminal\n  {name} --script demo.txt"
    )
}

impl Program {
    /// The `main` of a program with its own binary.
    pub fn main(&self) -> ExitCode {
        let asked = complete(|| self.command());
        exit(self.manual.name, asked.unwrap_or_else(|| self.start_from(std::env::args_os())))
    }

    /// Starts the program with a command line, whose first word is the program's name.
    ///
    /// # Errors
    /// [`Failure`] when the command line is wrong, or a file, a script or a display does not work.
    pub fn start_from(&self, arguments: impl IntoIterator<Item = OsString>) -> Result<(), Failure> {
        let language = spoken();
        // A program's own description is in both languages already.
        let command = speaking(self.command(), language).about(self.manual.about.of(language));
        let matches = command.try_get_matches_from(arguments)?;
        match self.command_line {
            CommandLine::Usual => self.start(&Options::from_arg_matches(&matches)?),
            CommandLine::Install => Install::from_arg_matches(&matches)?.run(),
        }
    }

    /// Starts the program without a file, as a menu does.
    ///
    /// # Errors
    /// [`Failure`] when its display does not work, or its work failed.
    pub fn visit(&self, options: RunOptions) -> Result<(), Failure> {
        match self.command_line {
            CommandLine::Usual => self.start(&options.with_file(None)),
            CommandLine::Install => Install::shown(options).run(),
        }
    }

    /// The definition of the program's command line, from which help, completions and manual page are made.
    pub fn command(&self) -> Command {
        let command = Command::new(self.manual.name);
        let (command, examples) = match self.command_line {
            CommandLine::Usual => (self.with_tables(Options::augment_args(command)), examples(self)),
            CommandLine::Install => (Install::augment_args(command), Install::examples(self.manual.name)),
        };
        // Set last, because the options have their own description.
        command.about(self.manual.about.1).version(env!("CARGO_PKG_VERSION")).after_help(examples)
    }

    /// Hides the options of tables where no points are opened.
    fn with_tables(&self, command: Command) -> Command {
        let points = [Format::Ip2, Format::Ic2, Format::Ip3, Format::Xyz];
        let hidden = !self.opens.iter().any(|format| points.contains(format));
        TableArgs::NAMES
            .into_iter()
            .fold(command, |command, name| command.mut_arg(name, |arg| arg.hide(hidden)))
    }

    /// Starts the program with the options of a command line and stays until it has ended.
    ///
    /// # Errors
    /// [`Failure`] when a file, a script or a display does not work.
    pub fn start(&self, options: &Options) -> Result<(), Failure> {
        options.run.check()?;
        let (path, run_options) = (options.file.as_deref(), options.run.preferred());
        let table = options.table.options();
        if let (Some(option), None) = (options.table.given(), path) {
            return Err(Failure::usage(format!("{option} is for a table that is opened; no file is named")));
        }
        let script = run_options.script.as_deref().map(display::read_script).transpose()?;
        let folder = path.map_or_else(|| run_options.folder(), folder_of);
        let mut machine = run_options.machine(folder, script.as_ref());
        // Through the machine's own storage, which remembers what was read.
        let tables = if self.opens.contains(&Format::Xyz) { Tables::Clouds } else { Tables::Documents };
        let opened = path.map(|path| open_in(machine.storage(), path, None, &table, tables)).transpose()?;
        if let Some(Opened { name, document: Document::Tangents(_), .. }) = &opened {
            return Err(Failure::work(format!(
                "{name} holds tangents only; no .IC2 file with the points lies beside it"
            )));
        }
        machine.set_file(opened.as_ref().map(|opened| opened.file_name.clone()));
        let (name, document) = opened
            .map(|opened| (opened.name, with_json(opened.document, machine.storage(), &opened.file_name)))
            .unzip();
        let start = (self.start)(document).map_err(|problem| {
            let problem = problem.of(run_options.spoken());
            Failure::work(
                name.map_or_else(|| problem.to_owned(), |name: String| format!("{name}: {problem}")),
            )
        })?;
        let session = Session::start(machine, move |mut machine| async move { start(&mut machine).await });
        display::show(session, self.manual.name, &run_options, script.as_ref())
    }
}
