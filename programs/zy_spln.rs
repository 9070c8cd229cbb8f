//! ZY_SPLN: spline surfaces closed like a ring (chapter 3.3.2). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zy_spln",
        about: Words("Gyűrű topológiájú spline felület", "Spline surfaces closed like a ring"),
        intro: Words(
            "Gyűrű módjára zárt felület: a cső körüli 8 kör pontjain megy át. Húzzon el egy pontot, \
             nyomja le: F, T, aztán forgassa a felületet a nyilakkal. Zárt köbös spline-ok futnak mindkét \
             irányban: sehol sincs perem, a görbület folytonos, de egy pont az egész felületet mozgatja.",
            "A surface closed like a ring, through the points of 8 circles around its tube. Drag a point, \
             press F and T, then turn the surface with the arrows. Closed cubic splines run in both \
             directions: no border, continuous curvature, and one point moves the whole surface.",
        ),
        keys: net::FINER_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zys,
    reads: &[],
    family: Family::Spline,
    start: Start::Torus(120.0, 40.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.2",
    group: &groups::RINGS,
    opens: &[Format::Zys],
    demo: Demo { file: "A.ZYS", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
