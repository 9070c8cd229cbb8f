//! GB_P_2D: plane curves by Fourier coefficients (chapter 2.2). All of it is the Fourier editor.

use grafika::editor::fourier;
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "gb_p_2d",
    about: Words("Síkgörbék Fourier-együtthatókkal", "Plane curves by Fourier coefficients"),
    keys: fourier::KEYS,
    lesson: &[],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.2",
    run: |machine, file| Box::pin(fourier::run(machine, MANUAL, file)),
    check: fourier::check,
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
