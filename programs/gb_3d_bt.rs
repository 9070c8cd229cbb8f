//! GB_3D_BT: beta-splines in space with bias and tension (chapter 2.3.7). All of it is the space editor.

use super::groups;
use crate::editor::curve::{self, Tools};
use crate::file::Format;
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "gb_3d_bt",
    about: Words(
        "Térbeli béta-spline eltolással és feszültséggel",
        "Beta-splines in space with bias and tension",
    ),
    intro: Words(
        "Térgörbe a kontrollpontok közelében, amelyet két szám formál. Nyisson meg egy példát (B.IP3), \
         nyomja le: G, N, aztán C, 10, Enter. Az érintő és a görbület folytonos marad: a feszültség a \
         pontokhoz húzza a görbét, az 1-nél nagyobb eltolás az előző pontok felé.",
        "A curve in space near its control points, shaped by two numbers. Open a sample (B.IP3), press G \
         and N, then C, 10 and Enter. Direction and curvature stay continuous: tension pulls the curve to \
         its points, a bias above 1 pulls it towards the points before.",
    ),
    keys: curve::SPACE_BETA_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.3.7",
    group: &groups::SPACE_CURVES,
    opens: &[Format::Ip3],
    demo: Demo { file: "B.IP3", script: "type gn\nkey E\nkey N", motion: Some(Key::Left) },
    start: |document| curve::space(MANUAL, Tools::Beta, document),
    command_line: CommandLine::Usual,
};
