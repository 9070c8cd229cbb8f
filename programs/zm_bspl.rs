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
        intro: Words(
            "Gömb módjára zárt felület 8 délgörbe pontjainak közelében. Nyomja le: F, 3, T, aztán húzzon \
             el egy pontot, és forgasson a nyilakkal. Egy pont csak a környékét mozgatja; harmadfokon \
             mindkét pólusnál lyuk marad, ahogy a könyvben: az F4 bezárja.",
            "A surface closed like a sphere, near the points of 8 meridians. Press F, 3 and T, then drag \
             a point and turn the surface with the arrows. A point moves only what is near it; degree 3 \
             leaves a hole at either pole, as in the book: F4 closes it.",
        ),
        keys: net::B_SPLINE_POLES_KEYS,
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
