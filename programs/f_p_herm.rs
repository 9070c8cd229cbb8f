//! F_P_HERM: a Hermite patch: corners, tangents, twists (chapter 3.3.1). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_herm",
        about: Words("Hermite-féle felületfolt", "A Hermite patch: corners, tangents, twists"),
        intro: Words("", ""),
        keys: net::KEYS,
        lesson: &[],
    },
    kind: NetKind::Fhc,
    reads: &[],
    family: Family::Hermite,
    start: Start::Square(300.0),
    steps: 16,
    view: NetKind::HERMITE_VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.1",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fhc],
    demo: Demo { file: "A.FHC", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
