//! ZM_SPLN: spline surfaces closed like a sphere (chapter 3.3.2). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zm_spln",
        about: Words("Gömb topológiájú spline felület", "Spline surfaces closed like a sphere"),
        intro: Words(
            "Gömb módjára zárt felület 8 délgörbe pontjain át. Húzzon el egy pontot, nyomja le: F, T, \
             aztán forgassa a felületet a nyilakkal. A szemközti délgörbék egy-egy zárt köbös spline-ná \
             kapcsolódnak a pólusokon át, és körben is zárt spline-ok futnak.",
            "A surface closed like a sphere, through the points of 8 meridians. Drag a point, press F and \
             T, then turn the surface with the arrows. Opposite meridians join over the poles into closed \
             cubic splines, and closed splines run around too.",
        ),
        keys: net::SPLINE_POLES_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zms,
    reads: &[],
    family: Family::Spline,
    start: Start::Sphere(120.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.2",
    group: &groups::SPHERES,
    opens: &[Format::Zms],
    demo: Demo { file: "A.ZMS", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
