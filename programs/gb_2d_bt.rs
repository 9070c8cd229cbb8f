//! GB_2D_BT: plane beta-splines with bias and tension (chapter 2.3.7). All of it is the plane editor.

use super::groups;
use crate::editor::curve::{self, Tools};
use crate::file::Format;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "gb_2d_bt",
    about: Words(
        "Síkgörbék béta-spline közelítéssel: eltolás, feszültség",
        "Plane beta-splines: bias and tension",
    ),
    intro: Words("", ""),
    keys: curve::BETA_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.7",
    group: &groups::PLANE_CURVES,
    opens: &[Format::Ip2],
    demo: Demo { file: "B.IP2", script: "type gz\nkey E\nkey N", motion: None },
    start: |document| curve::plane(MANUAL, Tools::Beta, document),
    command_line: CommandLine::Usual,
};
