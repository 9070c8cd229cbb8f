//! PH_GORBE: Pythagorean-hodograph curves, whose lengths and offsets are exact, in the plane and in space. Points,
//! tangents, files and undo are those of the editor of curves; here are the offsets and what is told about them.

mod analysis;
mod comb;
mod compare;
mod distance;
mod formula;
mod plane;
mod recipe;
mod solutions;
mod space;
mod speed;
mod status;
mod table;
mod texts;
mod travel;
mod unit;

use super::groups;
use crate::editor::curve;
use crate::editor::passage::{self, Passage};
use crate::file::{Document, Format};
use crate::geometry::Point;
use crate::screen::{Screen, Stroke};
use crate::ui::{CommandLine, Demo, Manual, Phrase, Program, Start, Words};
use std::rc::Rc;

const MANUAL: Manual = Manual {
    name: "ph_gorbe",
    about: Words(
        "PH görbék: pontos hossz, pontos párhuzamos görbék",
        "PH curves: exact lengths, exact offsets",
    ),
    intro: Words(
        "Görbék, amelyek hossza és párhuzamosa pontos. Tegyen le öt pontot, nyomja le: G, N, 1, aztán húzza a \
         sárga görbét. Ha x' = m² - n² és y' = 2mn, akkor a sebesség m² + n²: nincs gyök, ezért a szerszám \
         útja, a falvastagság, az előtolás képlettel adódik.",
        "Curves whose length and offset are exact. Put down five points, press G, N, 1, then drag the yellow \
         curve. If x' = m² - n² and y' = 2mn, the speed is m² + n²: no square root, so the path of a tool, the \
         thickness of a wall and a constant feed come from a formula.",
    ),
    keys: table::PLANE_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "P",
    group: &groups::OFFSETS,
    opens: &[Format::Ip2, Format::Ic2, Format::Ip3],
    demo: Demo { file: "K.IP2", script: "type gz1\nkey E\nkey N", motion: None },
    start,
    command_line: CommandLine::Usual,
};

/// Prepares the page that a document belongs to; F8 goes to the other one.
fn start(document: Option<Document>) -> Result<Start, Phrase> {
    let in_space = matches!(document, Some(Document::SpacePoints(_)));
    if !matches!(document, None | Some(Document::PlanePoints(_) | Document::SpacePoints(_))) {
        return Err(texts::NO_FILE.into());
    }
    passage::start(in_space, document, page)
}

fn page(in_space: bool, passage: &Rc<Passage>, document: Option<Document>) -> Result<Start, Phrase> {
    let other = Rc::clone(passage);
    if in_space {
        let manual = Manual { keys: table::SPACE_KEYS, ..MANUAL };
        curve::space_with(manual, Box::new(space::Space::new(other)), document)
    } else {
        curve::plane_with(MANUAL, Box::new(plane::Plane::new(other)), document)
    }
}

/// The pixel of a place in the field; what is far outside comes no further than matters.
fn pixel(at: Point<2>) -> (i32, i32) {
    let [x, y] = at.map(|it| if it.is_finite() { it.clamp(-2000.0, 3000.0).round() as i32 } else { -2000 });
    (41 + x, 450 - y)
}

/// Draws a line, but nothing of it that leaves the picture.
fn in_field(screen: &mut Screen, pixels: &[(i32, i32)], stroke: Stroke) {
    let inside = |&(x, y): &(i32, i32)| (30..=632).contains(&x) && (59..=461).contains(&y);
    for part in pixels.split(|pixel| !inside(pixel)).filter(|part| part.len() > 1) {
        screen.polyline(part, stroke);
    }
}
