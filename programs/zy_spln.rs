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
        intro: Words("", ""),
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
