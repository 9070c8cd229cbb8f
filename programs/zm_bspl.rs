//! ZM_BSPL: B-spline surfaces closed like a sphere (chapter 3.3.4). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zm_bspl",
        about: Words("Gömb topológiájú B-spline felület", "B-spline surfaces closed like a sphere"),
        intro: Words("", ""),
        keys: net::B_SPLINE_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zmb,
    reads: &[],
    family: Family::BSpline,
    start: Start::Sphere(120.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.4",
    group: &groups::SPHERES,
    opens: &[Format::Zmb],
    demo: Demo { file: "K1.ZMB", script: "type f3tet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
