//! GB_2D_BT: plane beta-splines with bias and tension (chapter 2.3.7). All of it is the plane editor.

use grafika::editor::plane::{self, Tools};
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "gb_2d_bt",
    about: Words(
        "Síkgörbék β-spline közelítéssel: eltolás, feszültség",
        "Plane beta-splines: bias and tension",
    ),
    keys: Tools::Beta.keys(),
    lesson: &[],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.7",
    run: |machine, file| Box::pin(plane::run(machine, MANUAL, Tools::Beta, file)),
    check: plane::check,
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
