//! F_P_BSPL: open B-spline surfaces (chapter 3.3.4). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_bspl",
        about: Words("Nyílt B-spline felület", "Open B-spline surfaces"),
        intro: Words("", ""),
        keys: net::B_SPLINE_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fbs,
    reads: &[],
    family: Family::BSpline,
    start: Start::Plane(80.0),
    steps: 12,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.4",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fbs],
    demo: Demo { file: "A.FBS", script: "type f3tet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
