//! F_P_SPLN: open spline surfaces (chapter 3.3.2). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_spln",
        about: Words("Nyílt spline felület", "Open spline surfaces"),
        intro: Words(
            "Sima felület egy 5 x 5 pontos háló pontjain át. Húzzon el egy pontot, nyomja le: F, T, aztán \
             forgassa a felületet a nyilakkal. Természetes köbös spline-ok futnak a háló mindkét \
             irányában: a görbület is folytonos, de egy pont az egész felületet mozgatja.",
            "A smooth surface through the points of a 5 x 5 net. Drag a point, press F and T, then turn \
             the surface with the arrows. Natural cubic splines run along both directions of the net: the \
             curvature is continuous too, but one point moves the whole surface.",
        ),
        keys: net::FINER_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fps,
    reads: &[],
    family: Family::Spline,
    start: Start::Plane(80.0),
    steps: 12,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.2",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fps],
    demo: Demo { file: "A.FPS", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
