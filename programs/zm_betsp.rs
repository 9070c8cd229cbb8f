//! ZM_BETSP: Beta-spline surfaces closed like a sphere (chapter 3.3.5). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zm_betsp",
        about: Words("Gömb topológiájú béta-spline felület", "Beta-spline surfaces closed like a sphere"),
        intro: Words("", ""),
        keys: net::BETA_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zmb,
    reads: &[],
    family: Family::Beta,
    start: Start::Sphere(160.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.5",
    group: &groups::SPHERES,
    opens: &[Format::Zmb],
    demo: Demo { file: "K2.ZMB", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
