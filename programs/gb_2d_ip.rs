//! GB_2D_IP: plane curves by interpolation and approximation methods (chapters 2.3.1, 2.3.2, 2.3.5 to
//! 2.3.8). All of it is the plane editor.

use grafika::editor::plane::{self, Tools};
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "gb_2d_ip",
    about: Words(
        "Síkgörbék: Coons, Bézier, spline, B-spline",
        "Plane curves: Coons, Bézier, spline, B-spline",
    ),
    keys: Tools::Methods.keys(),
    lesson: &[],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.1, 2.3.2, 2.3.5-2.3.8",
    run: |machine, file| Box::pin(plane::run(machine, MANUAL, Tools::Methods, file)),
    check: plane::check,
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
