//! F_P_HERM: a Hermite patch: corners, tangents, twists (chapter 3.3.1). All of it is the surface editor.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_herm",
        about: Words("Hermite-féle felületfolt", "A Hermite patch: corners, tangents, twists"),
        intro: Words(
            "Egyetlen felületfolt négy sarokból, az ottani érintőkből és csavarásokból (twist). Válasszon \
             sarkot (V), adjon meg érintőt (U, V) vagy twistet (T), aztán: F, T. Harmadfokú Hermite- \
             függvények keverik őket; a twist a folt belsejét hajlítja, a peremgörbék maradnak.",
            "One patch made of four corners, the tangents there and the twists. Choose a corner (V), give \
             it a tangent (U, V) or a twist (T), then press F and T. Cubic Hermite functions blend them \
             all; a twist bends the inside of the patch and leaves the border curves as they are.",
        ),
        keys: net::HERMITE_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fhc,
    reads: &[],
    family: Family::Hermite,
    start: Start::Square(300.0),
    steps: 16,
    view: NetKind::HERMITE_VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.1",
    group: &groups::OPEN_SURFACES,
    opens: &[Format::Fhc],
    demo: Demo { file: "A.FHC", script: "type ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
