//! GB_2D_CH: Coons-Hermite curves with tangents of the user's own (chapter 2.3.3). All of it is the plane
//! editor.

use grafika::editor::plane::{self, Tools};
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "gb_2d_ch",
    about: Words(
        "Coons-Hermite síkgörbék saját érintőkkel",
        "Plane Coons-Hermite curves with tangents of your own",
    ),
    keys: Tools::Tangents.keys(),
    lesson: &[],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.3",
    run: |machine, file| Box::pin(plane::run(machine, MANUAL, Tools::Tangents, file)),
    check: plane::check,
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
