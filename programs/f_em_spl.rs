//! F_EM_SPL: spline surfaces of heights over a grid (chapter 3.3.2). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_em_spl",
        about: Words("Magasságok spline felülete", "Spline surfaces of heights over a grid"),
        intro: Words(
            "Domborzat: z magasságok felülete egy rögzített 8 x 5 pontos rács fölött. Húzzon el egy \
             pontot fel vagy le, aztán nyomja meg az F-et. Köbös spline-ok kötik össze a magasságokat \
             mindkét irányban; a felső oldal fekete, az alsó szürke.",
            "A landscape: a surface of heights z over a fixed grid of 8 x 5 points. Drag a point up or \
             down, then press F. Cubic splines join the heights in both directions; the upper side is \
             black, the lower side grey.",
        ),
        keys: net::FINER_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fem,
    reads: &[],
    family: Family::Heights,
    start: Start::Plane(70.0),
    steps: 12,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.2",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fem],
    demo: Demo { file: "A.FEM", script: "type fe", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
