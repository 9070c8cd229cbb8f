//! TELEPIT: the installer of the book's disk (chapter 5). It puts the programs and their samples, by groups, into a
//! folder: on a page of a text mode, or as a plain command.
//!
//! It is the one program that touches the disk itself, since that is what it is for: it writes into a folder that
//! is named while it runs.

#[path = "telepit/command.rs"]
mod command;
#[cfg(test)]
#[path = "telepit/golden.rs"]
pub(crate) mod golden;
#[path = "grafika/groups.rs"]
pub(crate) mod groups;
#[path = "telepit/installer.rs"]
mod installer;
#[path = "telepit/job.rs"]
mod job;
#[path = "telepit/journal.rs"]
mod journal;
#[path = "telepit/place.rs"]
mod place;
#[path = "telepit/plan.rs"]
mod plan;
#[path = "telepit/texts.rs"]
mod texts;

use clap::{Args, Command, FromArgMatches};
pub(crate) use command::{Install, examples};
use grafika::launch::{Failure, Program, exit, no_file};
use grafika::machine::{Asked, Machine};
use grafika::textmode::on_machine;
use grafika::ui::{Manual, Words};
use installer::Installer;
use std::ffi::OsString;
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "telepit",
    about: Words("Telepítő: programok és példák mappába", "Installer: programs and samples into a folder"),
    keys: texts::HELP,
    lesson: &[],
};

pub(crate) const PROGRAM: Program =
    Program { manual: MANUAL, chapter: "5", run: |machine, _| Box::pin(run(machine)), check: no_file };

async fn run(machine: &mut Machine) -> Asked<()> {
    let folder = place::offered().display().to_string();
    let find = Box::new(place::executable);
    on_machine(machine, &mut Installer::new(machine.language(), folder, None, find)).await
}

/// The command line of the program.
pub(crate) fn described() -> Command {
    // The options bring a line of their own with them, which is about the command.
    let command = Install::augment_args(Command::new(MANUAL.name)).about(MANUAL.about.1);
    command.version(env!("CARGO_PKG_VERSION")).after_help(examples(MANUAL.name))
}

/// Starts the program with a command line, whose first word is its name.
pub(crate) fn start_from(arguments: impl IntoIterator<Item = OsString>) -> Result<(), Failure> {
    let matches = described().try_get_matches_from(arguments)?;
    Install::from_arg_matches(&matches)?.run()
}

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    exit(MANUAL.name, start_from(std::env::args_os()))
}
