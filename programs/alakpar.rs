//! ALAKPAR: curves whose shape is changed by numbers while their control points stay (chapter 2.2 of M. Hoffmann's
//! booklet and the papers behind it). The curves are `grafika::geometry::shaped`; here are the parameters, what they
//! do, and the way to a target.

mod aim;
mod basis;
mod choose;
mod commands;
mod craft;
mod dial;
mod files;
mod form;
mod kinds;
mod layers;
mod model;
mod obey;
mod points;
mod room;
mod texts;
mod traces;

use super::groups;
use crate::editor;
use crate::editor::passage::{self, Passage};
use crate::file::{Document, Format};
use crate::ui::{CommandLine, Demo, Manual, Phrase, Program, Start, Words};
use craft::Shaper;
use std::rc::Rc;

const MANUAL: Manual = Manual {
    name: "alakpar",
    about: Words("Görbék alakparaméterekkel", "Curves with shape parameters"),
    intro: Words(
        "Görbék, amelyek alakját egy-két szám változtatja, a pontok helyükön maradnak. Tegyen le öt pontot, \
         húzza a csúszkát, majd H és egy kattintás: a görbe odamegy. A paraméter minden pontot egy-egy úton \
         visz végig (P), ezért kiszámítható, melyik értéke éri el a célt.",
        "Curves that one or two numbers reshape while the points stay. Put down five points, drag the slider, then \
         press H and click: the curve goes there. The parameter takes every point along a path of its own (P), so \
         the value that reaches a target can be computed.",
    ),
    keys: commands::PLANE_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "H",
    group: &groups::SHAPES,
    opens: &[Format::Alp, Format::Ip2, Format::Ip3, Format::Gbp],
    demo: Demo { file: "LANC.ALP", script: "key P", motion: None },
    start,
    command_line: CommandLine::Usual,
};

/// Prepares the page that a document belongs to; F3 goes to the other one.
fn start(document: Option<Document>) -> Result<Start, Phrase> {
    let in_space = document.as_ref().is_some_and(files::is_in_space);
    passage::start(in_space, document, page)
}

fn page(in_space: bool, passage: &Rc<Passage>, document: Option<Document>) -> Result<Start, Phrase> {
    if in_space {
        let manual = Manual { keys: commands::SPACE_KEYS, ..MANUAL };
        editor::start(Shaper::<3>::new(Rc::clone(passage)), manual, document)
    } else {
        editor::start(Shaper::<2>::new(Rc::clone(passage)), MANUAL, document)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Language;

    #[test]
    fn the_help_page_of_space_fits_too() {
        let manual = Manual { keys: commands::SPACE_KEYS, ..MANUAL };
        for language in [Language::Hungarian, Language::English] {
            assert_eq!(manual.misfits(language), [""; 0]);
        }
    }
}
