//! F_P_HSPL: open surfaces by local splines (chapter 3.3.6). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_hspl",
        about: Words("Nyílt helyi spline felület", "Open surfaces by local splines"),
        intro: Words("", ""),
        keys: net::LOCAL_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fps,
    reads: &[],
    family: Family::Local,
    start: Start::Plane(80.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.6",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fps],
    demo: Demo { file: "A.FPS", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
