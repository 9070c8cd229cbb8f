//! ZM_BETSP: Beta-spline surfaces closed like a sphere (chapter 3.3.5). All of it is the surface editor.

use grafika::editor::net::{self, Family, Plan, Start};
use grafika::file::NetKind;
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zm_betsp",
        about: Words("Gömb topológiájú béta-spline felület", "Beta-spline surfaces closed like a sphere"),
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

pub(crate) const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.5",
    run: |machine, file| Box::pin(net::run(machine, PLAN, file)),
    check: |document| net::check(&PLAN, document),
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
