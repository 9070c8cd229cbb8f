//! ZY_HSPL: surfaces like a ring by local splines (chapter 3.3.6). All of it is the surface editor.

use grafika::editor::net::{self, Family, Plan, Start};
use grafika::file::NetKind;
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const PLAN: Plan = Plan {
    manual: Manual {
        name: "zy_hspl",
        about: Words("Gyűrű topológiájú helyi spline felület", "Surfaces like a ring by local splines"),
        keys: net::LOCAL_KEYS,
        lesson: &[],
    },
    kind: NetKind::Zys,
    reads: &[],
    family: Family::Local,
    start: Start::Torus(160.0, 60.0),
    steps: 10,
    view: NetKind::TORUS_VIEW,
};

pub(crate) const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.6",
    run: |machine, file| Box::pin(net::run(machine, PLAN, file)),
    check: |document| net::check(&PLAN, document),
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
