//! F_P_BEZR: the Bézier patch (chapter 3.3.3). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_bezr",
        about: Words("Bézier-féle felületfolt", "The Bézier patch"),
        intro: Words(
            "Egyetlen felületfolt egy 4 x 4 pontos hálóhoz. Húzzon el egy pontot, nyomja le: F, T, aztán \
             forgassa a felületet a nyilakkal. A Bernstein-polinomok keverik a pontokat: a felület a \
             sarkokon átmegy, a többi pont csak vonzza, és mindegyik az egész foltot alakítja.",
            "One patch by a net of 4 x 4 points. Drag a point, press F and T, then turn the surface with \
             the arrows. Bernstein polynomials blend the points: the surface passes through the corners, \
             the other points only attract it, and each of them shapes the whole patch.",
        ),
        keys: net::BEZIER_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fpb,
    reads: &[],
    family: Family::Bezier,
    start: Start::Plane(120.0),
    steps: 16,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.3",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fpb],
    demo: Demo { file: "A.FPB", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
