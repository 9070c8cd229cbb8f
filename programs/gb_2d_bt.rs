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
    intro: Words(
        "Görbe a kontrollpontok közelében, amelyet két szám formál. Tegyen le öt pontot, nyomja le: G, Z, \
         aztán C, 10, Enter. Az érintő és a görbület a csatlakozásokon folytonos marad: a feszültség a \
         pontokhoz húzza a görbét, az 1-nél nagyobb eltolás az előző pontok felé.",
        "A curve near its control points, shaped by two numbers. Put down five points, press G and Z, \
         then C, 10 and Enter. Direction and curvature stay continuous at the joints: tension pulls the \
         curve to its points, a bias above 1 pulls it towards the points before.",
    ),
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
