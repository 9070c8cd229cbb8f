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
    intro: Words(
        "Görbe a kontrollpontokon át vagy a közelükben. Tegyen le öt pontot, nyomja le sorban: G, N, 3, \
         aztán húzzon el egy pontot. A Coons-görbe és a spline átmegy a pontokon, a Bézier és a B-spline \
         közelíti őket; egy pont a Coons- és B-spline görbének csak a környékét mozgatja.",
        "A curve through control points or near them. Put down five points, press G, N and 3, then drag \
         one of them. Coons curves and splines pass through the points, Bézier curves and B-splines \
         approximate them; with Coons and B-spline a point moves only the spans around it.",
    ),
    keys: curve::METHOD_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.1-2.3.6, 2.3.8",
    group: &groups::PLANE_CURVES,
    opens: &[Format::Ip2],
    demo: Demo { file: "A.IP2", script: "type gz3\nkey E\nkey N", motion: None },
    start: |document| curve::plane(MANUAL, Tools::Methods, document),
    command_line: CommandLine::Usual,
};
