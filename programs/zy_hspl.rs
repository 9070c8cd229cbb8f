//! ZY_HSPL: surfaces like a ring by local splines (chapter 3.3.6). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zy_hspl",
        about: Words("Gyűrű topológiájú helyi spline felület", "Surfaces like a ring by local splines"),
        intro: Words(
            "Gyűrű módjára zárt felület: a cső körüli 8 kör pontjain megy át. Nyomja le: F, T, aztán C, \
             U, 1, Enter, és újra: F, T. Az érintők a szomszédok különbségei k0-val szorozva: egy pont \
             csak a környékét mozgatja, de a görbület a foltok között ugrik.",
            "A surface closed like a ring, through the points of 8 circles around its tube. Press F and \
             T, then C, U, 1 and Enter, then F and T again. Tangents are k0 times the difference of the \
             neighbours: a point moves only what is near it, but the curvature jumps between patches.",
        ),
        keys: net::LOCAL_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zys,
    reads: &[],
    family: Family::Local,
    start: Start::Torus(160.0, 60.0),
    steps: 10,
    view: NetKind::TORUS_VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.6",
    group: &groups::RINGS,
    opens: &[Format::Zys],
    demo: Demo { file: "A.ZYS", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
