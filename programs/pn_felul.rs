//! PN_FELUL: surfaces through points with normals, whose offsets are exact, after a thesis of 2025 (Babeş-Bolyai
//! University). All of it is the surface editor; the mathematics is `grafika::geometry::pn`.

use super::groups;
use crate::editor::net::{self, Family, Plan, Start};
use crate::file::{Format, NetKind};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const PLAN: Plan = Plan {
    manual: Manual {
        name: "pn_felul",
        about: Words("Felületek pontos párhuzamosokkal", "Surfaces with exact offsets"),
        intro: Words(
            "Felület pontokon és normálisokon át, amelynek minden párhuzamosa pontos. Nyomja le: P, 30, Enter, \
             aztán húzzon egy pontot vagy egy zöld normálist; F8 mutatja, miért lesz piros egy folt. A normálisok \
             törtfüggvények, gyökvonás nélkül, ezért azok a párhuzamosok is.",
            "A surface through points and normals, all of whose offsets are exact. Press P, 30 and Enter, then \
             drag a point or a green normal; F8 shows why a patch turns red. The normals are quotients of \
             polynomials, without a root, and so are all offsets.",
        ),
        keys: net::NORMALS_KEYS,
        lesson: &[],
    },
    kind: NetKind::Pn,
    reads: &[NetKind::Fps, NetKind::Fbs, NetKind::Fpb, NetKind::Fem],
    family: Family::Normals,
    start: Start::Vault(80.0, 90.0),
    steps: 10,
    view: NetKind::VIEW,
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: PLAN.manual,
    chapter: "P",
    group: &groups::OFFSETS,
    opens: &[Format::Pn],
    demo: Demo { file: "P.PN", script: "type p6\nkey Enter\ntype ftet", motion: Some(Key::Left) },
    start: |document| net::start(&PLAN, document),
    command_line: CommandLine::Usual,
};
