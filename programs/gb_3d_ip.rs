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
    intro: Words(
        "Térgörbe a kontrollpontokon át vagy a közelükben. Nyisson meg egy példát (A.IP3), nyomja le \
         sorban: G, N, 3, aztán forgassa a nyilakkal. A módszerek a síkból ismertek: a Coons-görbe és a \
         spline átmegy a pontokon, a Bézier és a B-spline közelíti őket.",
        "A curve in space, through control points or near them. Open a sample (A.IP3), press G, N and 3, \
         then turn the curve with the arrows. The methods are those of the plane: Coons curves and \
         splines pass through the points, Bézier curves and B-splines approximate them.",
    ),
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
