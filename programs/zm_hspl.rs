//! ZM_HSPL: surfaces like a sphere by local splines (chapter 3.3.6). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zm_hspl",
        about: Words("Gömb topológiájú helyi spline felület", "Surfaces like a sphere by local splines"),
        intro: Words(
            "Gömb módjára zárt felület 8 délgörbe pontjain át. Nyomja le: F, T, aztán C, U, 1, Enter, és \
             újra: F, T. Az érintők a szomszédok különbségei k0-val szorozva, a póluson túl a szemközti \
             délgörbe a szomszéd; egy pont csak a környékét mozgatja.",
            "A surface closed like a sphere, through the points of 8 meridians. Press F and T, then C, U, \
             1 and Enter, then F and T again. Tangents are k0 times the difference of the neighbours, \
             beyond a pole those of the opposite meridian; a point moves only what is near it.",
        ),
        keys: net::LOCAL_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zms,
    reads: &[],
    family: Family::Local,
    start: Start::Sphere(160.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.6",
    group: &groups::SPHERES,
    opens: &[Format::Zms],
    demo: Demo { file: "B.ZMS", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
