//! F_P_BSPL: open B-spline surfaces (chapter 3.3.4). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_bspl",
        about: Words("Nyílt B-spline felület", "Open B-spline surfaces"),
        intro: Words(
            "Sima felület egy 5 x 5 pontos háló közelében. Nyomja le: F, 3, T, aztán húzzon el egy \
             pontot, és forgasson a nyilakkal. Egy pont csak a környékét mozgatja; másodfokon az \
             érintősík, harmadfokon a görbület is folytonos. F4: egészen a peremig.",
            "A smooth surface near the points of a 5 x 5 net. Press F, 3 and T, then drag a point and \
             turn the surface with the arrows. A point moves only what is near it; degree 2 keeps the \
             tangent plane continuous, degree 3 the curvature too. F4: up to the border.",
        ),
        keys: net::B_SPLINE_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fbs,
    reads: &[],
    family: Family::BSpline,
    start: Start::Plane(80.0),
    steps: 12,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.4",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fbs],
    demo: Demo { file: "A.FBS", script: "type f3tet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
