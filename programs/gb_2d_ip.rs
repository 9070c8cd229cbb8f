//! GB_2D_IP: plane curves by interpolation and approximation methods (chapters 2.3.1, 2.3.2, 2.3.5 to
//! 2.3.8). All of it is the plane editor.

use super::groups;
use crate::editor::curve::{self, Tools};
use crate::file::Format;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "gb_2d_ip",
    about: Words(
        "Síkgörbék: Coons, Bézier, spline, B-spline",
        "Plane curves: Coons, Bézier, spline, B-spline",
    ),
    intro: Words("", ""),
    keys: curve::METHOD_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.1, 2.3.2, 2.3.5-2.3.8",
    group: &groups::PLANE_CURVES,
    opens: &[Format::Ip2],
    demo: Demo { file: "A.IP2", script: "type gz3\nkey E\nkey N", motion: None },
    start: |document| curve::plane(MANUAL, Tools::Methods, document),
    command_line: CommandLine::Usual,
};
