//! CSOMO: curves by their knots, after M. Hoffmann's and I. Juhász's work on what knots do to B-splines and NURBS. Dragging,
//! files and undo are those of the editor; the mathematics is `grafika::geometry::knots`.

mod actions;
mod bench;
mod facts;
mod model;
mod rail;
mod region;
mod seen;
mod sheet;
mod status;
mod strip;
mod surface;
mod table;
mod texts;
mod through;

use super::groups;
use crate::editor;
use crate::editor::passage::{self, Passage};
use crate::file::{Document, Format};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Phrase, Program, Start, Words};
use std::rc::Rc;

const MANUAL: Manual = Manual {
    name: "csomo",
    about: Words("B-spline görbék a csomóikkal", "B-spline curves by their knots"),
    intro: Words(
        "B-spline görbék, amelyeket nem pontjaik, hanem csomóik alakítanak. Nyissa meg: A.CSM, nyomja le: P, U, \
         aztán húzzon egy háromszöget lent. A görbe pontjai törtfüggvények pályáin futnak, és a görbék mind \
         érintik az eggyel alacsonyabb rendű burkolót.",
        "B-spline curves shaped not by their points but by their knots. Open A.CSM, press P and U, then drag a \
         triangle at the bottom. Points of the curve run along rational paths, and all the curves touch one \
         envelope whose order is lower by one.",
    ),
    keys: table::KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "H",
    group: &groups::SHAPES,
    opens: &[Format::Csm, Format::Csf],
    demo: Demo { file: "A.CSM", script: "type pu", motion: Some(Key::Tab) },
    start,
    command_line: CommandLine::Usual,
};

/// Prepares the page that a document belongs to; F5 goes to the other one.
fn start(document: Option<Document>) -> Result<Start, Phrase> {
    let surfaces = matches!(document, Some(Document::KnotNet(_)));
    passage::start(surfaces, document, page)
}

fn page(surfaces: bool, passage: &Rc<Passage>, document: Option<Document>) -> Result<Start, Phrase> {
    let other = Rc::clone(passage);
    if surfaces {
        let manual = Manual { keys: surface::KEYS, ..MANUAL };
        return editor::start(surface::Nets::new(other), manual, document);
    }
    editor::start(bench::Bench::new(other), MANUAL, document)
}
