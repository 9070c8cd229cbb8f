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
        intro: Words("", ""),
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
