//! F_P_BEZR: the Bézier patch (chapter 3.3.3). All of it is the surface editor.

use grafika::editor::net::{self, Family, Plan, Start};
use grafika::file::NetKind;
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const PLAN: Plan = Plan {
    manual: Manual {
        name: "f_p_bezr",
        about: Words("Bézier-féle felületfolt", "The Bézier patch"),
        keys: net::FINER_KEYS,
        lesson: &[],
    },
    kind: NetKind::Fpb,
    reads: &[],
    family: Family::Bezier,
    start: Start::Plane(120.0),
    steps: 16,
    view: NetKind::VIEW,
};

pub(crate) const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "3.3.3",
    run: |machine, file| Box::pin(net::run(machine, PLAN, file)),
    check: |document| net::check(&PLAN, document),
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
