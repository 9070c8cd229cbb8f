//! GB_2D_CH: Coons-Hermite curves with tangents of the user's own (chapter 2.3.3). All of it is the plane
//! editor.

use super::groups;
use crate::editor::curve::{self, Tools};
use crate::file::Format;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "gb_2d_ch",
    about: Words(
        "Coons-Hermite síkgörbék saját érintőkkel",
        "Plane Coons-Hermite curves with tangents of your own",
    ),
    intro: Words("", ""),
    keys: curve::TANGENT_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.3",
    group: &groups::PLANE_CURVES,
    opens: &[Format::Ic2, Format::Ec2],
    demo: Demo { file: "A.IC2", script: "key N\ntype gz\nkey N\nkey E\nkey N", motion: None },
    start: |document| curve::plane(MANUAL, Tools::Tangents, document),
    command_line: CommandLine::Usual,
};
