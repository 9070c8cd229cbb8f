//! ZM_BETSP: Beta-spline surfaces closed like a sphere (chapter 3.3.5). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zm_betsp",
        about: Words("Gömb topológiájú béta-spline felület", "Beta-spline surfaces closed like a sphere"),
        intro: Words(
            "Gömb módjára zárt felület 8 délgörbe pontjainak közelében. Nyomja le: F, T, aztán C, U, 10, \
             Enter, és újra: F, T. A feszültség a hálóhoz húzza a felületet, az eltolás az egyik irányba \
             tolja; a pólusok mögötti segédpontok zárják be.",
            "A surface closed like a sphere, near the points of 8 meridians. Press F and T, then C, U, 10 \
             and Enter, then F and T again. Tension pulls the surface to the net, bias shifts it along \
             the net; auxiliary points beyond the poles close it.",
        ),
        keys: net::BETA_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zmb,
    reads: &[],
    family: Family::Beta,
    start: Start::Sphere(160.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.5",
    group: &groups::SPHERES,
    opens: &[Format::Zmb],
    demo: Demo { file: "K2.ZMB", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
