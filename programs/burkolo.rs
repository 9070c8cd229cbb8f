//! BURKOLO: smooth skins over circles and spheres (chapter 2.3 of M. Hoffmann's booklet). The skins are
//! `grafika::geometry::skin`; here circles and spheres are put down, dragged and linked.

mod commands;
mod craft;
mod discs;
mod dressed;
mod layers;
mod model;
mod obey;
mod space;
mod texts;
mod value;

use super::groups;
use crate::editor;
use crate::editor::passage::{self, Passage};
use crate::file::{Document, Format};
use crate::ui::{CommandLine, Demo, Manual, Phrase, Program, Start, Words};
use craft::Skinner;
use space::Strings;
use std::rc::Rc;

const MANUAL: Manual = Manual {
    name: "burkolo",
    about: Words("Körök, gömbök sima burkolója", "Smooth skins of circles and spheres"),
    intro: Words(
        "Körök láncára sima burkoló feszül, amely mindegyiket érinti. Húzzon új kört a Tárból, mozgassa a közepét \
         vagy a peremét: a burkoló követi. Ágak is lehetnek (L) és gyűrű (K); ha a körök így nem burkolhatók, \
         megmondja, miért, és F8 segít.",
        "A smooth skin is put over a chain of circles and touches each of them. Drag a new circle out of the store, \
         move its middle or its rim: the skin follows. There may be branches (L) and a ring (K); where circles have no \
         good skin, the page says why, and F8 helps.",
    ),
    keys: commands::PLANE_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "H",
    group: &groups::CLOUDS,
    opens: &[Format::Kor, Format::Gom],
    demo: Demo { file: "KIGYO.KOR", script: "key G\nkey S", motion: None },
    start,
    command_line: CommandLine::Usual,
};

/// Prepares the page that a document belongs to; F5 goes to the other one.
fn start(document: Option<Document>) -> Result<Start, Phrase> {
    let in_space = matches!(document, Some(Document::Spheres(_)));
    passage::start(in_space, document, page)
}

fn page(in_space: bool, passage: &Rc<Passage>, document: Option<Document>) -> Result<Start, Phrase> {
    if in_space {
        let manual = Manual { keys: space::SPACE_KEYS, ..MANUAL };
        editor::start(Strings::new(Rc::clone(passage)), manual, document)
    } else {
        editor::start(Skinner::new(Rc::clone(passage)), MANUAL, document)
    }
}
