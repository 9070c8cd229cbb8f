//! GB_3D_BT: beta-splines in space with bias and tension (chapter 2.3.7). All of it is the space editor.

use grafika::editor::space::{self, Tools};
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "gb_3d_bt",
    about: Words(
        "Térbeli béta-spline eltolással és feszültséggel",
        "Beta-splines in space with bias and tension",
    ),
    keys: space::BETA_KEYS,
    lesson: &[],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.7",
    run: |machine, file| Box::pin(space::run(machine, MANUAL, Tools::Beta, file)),
    check: space::check,
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
