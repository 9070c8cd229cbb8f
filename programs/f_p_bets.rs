//! F_P_BETS: open beta-spline surfaces (chapter 3.3.5). All of it is the surface editor.

use grafika::editor::net::{self, Family, Plan, Start};
use grafika::file::NetKind;
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_bets",
        about: Words("Nyílt béta-spline felület", "Open beta-spline surfaces"),
        keys: net::BETA_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fbs,
    reads: &[],
    family: Family::Beta,
    start: Start::Plane(80.0),
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
