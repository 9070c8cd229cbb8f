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
        intro: Words(
            "Sima felület egy 5 x 5 pontos háló közelében. Nyomja le: F, T, aztán C, U, 10, Enter, és \
             újra: F, T. A köbös B-spline általánosítása: a feszültség a hálóhoz húzza, az eltolás az \
             egyik irányba tolja a felületet, és a görbület folytonos marad.",
            "A smooth surface near the points of a 5 x 5 net. Press F and T, then C, U, 10 and Enter, \
             then F and T again. It generalises the cubic B-spline: tension pulls the surface to the net, \
             bias shifts it along the net, and the curvature stays continuous.",
        ),
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
