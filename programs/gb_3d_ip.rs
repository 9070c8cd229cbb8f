//! GB_3D_IP: curves in space by interpolation and approximation methods (chapters 2.3.3 to
//! 2.3.6). All of it is the space editor.

use grafika::editor::space::{self, Tools};
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "gb_3d_ip",
    about: Words(
        "Térgörbék: Coons, Bézier, spline, B-spline",
        "Curves in space: Coons, Bézier, spline, B-spline",
    ),
    keys: space::METHOD_KEYS,
    lesson: &[],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.3-2.3.6",
    run: |machine, file| Box::pin(space::run(machine, MANUAL, Tools::Methods, file)),
    check: space::check,
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
