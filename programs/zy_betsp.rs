//! ZY_BETSP: Beta-spline surfaces closed like a ring (chapter 3.3.5). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zy_betsp",
        about: Words("Gyűrű topológiájú béta-spline felület", "Beta-spline surfaces closed like a ring"),
        intro: Words(
            "Gyűrű módjára zárt felület a cső körüli 8 kör pontjainak közelében. Nyomja le: F, T, aztán \
             C, U, 10, Enter, és újra: F, T. A köbös B-spline általánosítása: a feszültség a hálóhoz \
             húzza, az eltolás az egyik irányba tolja a felületet.",
            "A surface closed like a ring, near the points of 8 circles around its tube. Press F and T, \
             then C, U, 10 and Enter, then F and T again. It generalises the cubic B-spline: tension \
             pulls the surface to the net, bias shifts it along the net.",
        ),
        keys: net::BETA_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zyb,
    reads: &[NetKind::Zyp],
    family: Family::Beta,
    start: Start::Torus(160.0, 60.0),
    steps: 10,
    view: NetKind::TORUS_VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.5",
    group: &groups::RINGS,
    opens: &[Format::Zyb, Format::Zyp],
    demo: Demo { file: "A.ZYB", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
