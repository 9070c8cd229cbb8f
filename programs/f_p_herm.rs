//! F_P_HERM: a Hermite patch: corners, tangents, twists (chapter 3.3.1). All of it is the surface editor.

use grafika::editor::net::{self, Family, Plan, Start};
use grafika::file::NetKind;
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_herm",
        about: Words("Hermite-féle felületfolt", "A Hermite patch: corners, tangents, twists"),
        keys: net::KEYS,
        lesson: &[],
    },
    kind: NetKind::Fhc,
    reads: &[],
    family: Family::Hermite,
    start: Start::Square(300.0),
    steps: 16,
    view: NetKind::HERMITE_VIEW,
};

pub(crate) const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.1",
    run: |machine, file| Box::pin(net::run(machine, PLAN, file)),
    check: |document| net::check(&PLAN, document),
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
