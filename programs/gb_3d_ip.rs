//! GB_3D_IP: curves in space by interpolation and approximation methods (chapters 2.3.3 to
//! 2.3.6). All of it is the space editor.

use super::groups;
use crate::editor::curve::{self, Tools};
use crate::file::Format;
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "gb_3d_ip",
    about: Words(
        "Térgörbék: Coons, Bézier, spline, B-spline",
        "Curves in space: Coons, Bézier, spline, B-spline",
    ),
    intro: Words("", ""),
    keys: curve::SPACE_METHOD_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.3-2.3.6",
    group: &groups::SPACE_CURVES,
    opens: &[Format::Ip3],
    demo: Demo { file: "A.IP3", script: "type gn3\nkey E\nkey N", motion: Some(Key::Left) },
    start: |document| curve::space(MANUAL, Tools::Methods, document),
    command_line: CommandLine::Usual,
};
