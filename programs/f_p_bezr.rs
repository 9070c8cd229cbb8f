//! F_P_BEZR: the Bézier patch (chapter 3.3.3). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_bezr",
        about: Words("Bézier-féle felületfolt", "The Bézier patch"),
        intro: Words("", ""),
        keys: net::FINER_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fpb,
    reads: &[],
    family: Family::Bezier,
    start: Start::Plane(120.0),
    steps: 16,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.3",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fpb],
    demo: Demo { file: "A.FPB", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
