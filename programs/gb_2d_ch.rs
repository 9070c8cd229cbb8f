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
    intro: Words(
        "Görbe a kontrollpontokon át, saját érintőkkel. Tegyen le három pontot, kérjen automatikus \
         érintőket (I), rajzoljon görbét (G), aztán húzza az egyik érintő végét. Két szomszédos pont és \
         érintőjük egy harmadfokú Hermite-ívet ad; a közös érintő miatt az ívek simán csatlakoznak.",
        "A curve through its control points with tangents of your own. Put down three points, ask for \
         automatic tangents (I), draw a curve (G), then drag the tip of a tangent. Two neighbouring \
         points and their tangents give a Hermite cubic; spans share a tangent, so they join smoothly.",
    ),
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
