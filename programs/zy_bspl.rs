//! ZY_BSPL: B-spline surfaces closed like a ring (chapter 3.3.4). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zy_bspl",
        about: Words("Gyűrű topológiájú B-spline felület", "B-spline surfaces closed like a ring"),
        intro: Words(
            "Gyűrű módjára zárt felület a cső körüli 8 kör pontjainak közelében. Nyomja le: F, 3, T, \
             aztán húzzon el egy pontot, és forgasson a nyilakkal. Egy pont csak a környékét mozgatja; \
             másodfokon az érintősík, harmadfokon a görbület is folytonos, és sehol sincs perem.",
            "A surface closed like a ring, near the points of 8 circles around its tube. Press F, 3 and \
             T, then drag a point and turn the surface with the arrows. A point moves only what is near \
             it; degree 2 keeps the tangent plane continuous, degree 3 the curvature too.",
        ),
        keys: net::B_SPLINE_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zyb,
    reads: &[NetKind::Zyp],
    family: Family::BSpline,
    start: Start::Torus(120.0, 40.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.4",
    group: &groups::RINGS,
    opens: &[Format::Zyb],
    demo: Demo { file: "A.ZYB", script: "type f3tet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
