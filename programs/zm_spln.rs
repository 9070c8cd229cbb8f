//! ZM_SPLN: spline surfaces closed like a sphere (chapter 3.3.2). All of it is the surface editor.

use grafika::editor::net::{self, Family, Plan, Start};
use grafika::file::NetKind;
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zm_spln",
        about: Words("Gömb topológiájú spline felület", "Spline surfaces closed like a sphere"),
        keys: net::FINER_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zms,
    reads: &[],
    family: Family::Spline,
    start: Start::Sphere(120.0),
    steps: 10,
    view: NetKind::VIEW,
};

pub(crate) const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.2",
    run: |machine, file| Box::pin(net::run(machine, PLAN, file)),
    check: |document| net::check(&PLAN, document),
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
