//! TELEPIT: the installer of the book's disk (chapter 5).

#[path = "grafika/groups.rs"]
pub(crate) mod groups;

use grafika::launch::{Program, no_file};
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "telepit",
    about: Words("Telepítő: programok és példák mappába", "Installer: programs and samples into a folder"),
    keys: &[],
    lesson: &[],
};

pub(crate) const PROGRAM: Program =
    Program { manual: MANUAL, chapter: "5", run: |_, _| Box::pin(async { Ok(()) }), check: no_file };

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
