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
        intro: Words(
            "Sima felület egy 5 x 5 pontos háló pontjain át. Nyomja le: F, T, aztán C, U, 1, Enter, és \
             újra: F, T. Az érintők a szomszédok különbségei k0-val szorozva: egy pont csak a környékét \
             mozgatja, az érintősík folytonos, de a görbület ugrik.",
            "A smooth surface through the points of a 5 x 5 net. Press F and T, then C, U, 1 and Enter, \
             then F and T again. Tangents are k0 times the difference of the neighbours: a point moves \
             only what is near it; the tangent plane is continuous, the curvature jumps.",
        ),
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
