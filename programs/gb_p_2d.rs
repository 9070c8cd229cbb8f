//! GB_P_2D: plane curves by Fourier coefficients (chapter 2.2). All of it is the Fourier editor.

use super::groups;
use crate::editor::fourier;
use crate::file::Format;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "gb_p_2d",
    about: Words("Síkgörbék Fourier-együtthatókkal", "Plane curves by Fourier coefficients"),
    intro: Words("", ""),
    keys: fourier::KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.2",
    group: &groups::PLANE_CURVES,
    opens: &[Format::Gbp],
    demo: Demo { file: "A.GBP", script: "key E", motion: None },
    start: |document| fourier::start(MANUAL, document),
    command_line: CommandLine::Usual,
};
