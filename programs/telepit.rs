//! TELEPIT: the installer of the book's disk (chapter 5). It puts the programs and their samples, by groups, into a
//! folder: on a page of a text mode, or as a plain command.
//!
//! It is the one program that touches the disk itself, since that is what it is for: it writes into a folder that
//! is named while it runs.

#[cfg(test)]
pub(crate) mod golden;
pub(crate) mod installer;
pub(crate) mod job;
mod journal;
pub(crate) mod notes;
pub(crate) mod place;
pub(crate) mod plan;
pub(crate) mod removal;
pub(crate) mod texts;

use super::groups;
use crate::machine::{Asked, Machine};
use crate::textmode::on_machine;
use crate::ui::{CommandLine, Demo, Manual, Program, Words, without_document};
use installer::Installer;

const MANUAL: Manual = Manual {
    name: "telepit",
    about: Words("Telepítő: programok és példák mappába", "Installer: programs and samples into a folder"),
    intro: Words(
        "A könyv programjait és példáit telepíti csoportonként egy mappába. Jelöljön ki csoportokat a \
         szóközzel, aztán nyomja meg az Entert. Előbb mindent megtervez, és naplót vezet: ha megszakítja, \
         vagy baj van, minden úgy lesz, ahogy előtte volt.",
        "It installs the programs and samples of the book, by groups, into a folder. Select groups with \
         Space, then press Enter. Everything is planned first and written into a journal: if you cancel \
         or something fails, all is as it was before.",
    ),
    keys: texts::HELP,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "5",
    group: &groups::INSTALLER,
    opens: &[],
    demo: Demo { file: "", script: "", motion: None },
    start: |document| without_document(document, |machine| Box::pin(run(machine))),
    command_line: CommandLine::Install,
};

async fn run(machine: &mut Machine) -> Asked<()> {
    let folder = place::offered().display().to_string();
    let find = Box::new(place::executable);
    on_machine(machine, &mut Installer::new(machine.language(), folder, None, find)).await
}
