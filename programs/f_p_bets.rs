//! F_P_BETS: open beta-spline surfaces (chapter 3.3.5). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_bets",
        about: Words("Nyílt béta-spline felület", "Open beta-spline surfaces"),
        intro: Words("", ""),
        keys: net::BETA_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fbs,
    reads: &[],
    family: Family::Beta,
    start: Start::Plane(80.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.5",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fbs],
    demo: Demo { file: "Z.FBS", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
