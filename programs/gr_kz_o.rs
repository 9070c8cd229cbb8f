//! GR_KZ_O: a cursor of its own colours, put on the screen by or and exclusive-or over a background that
//! is saved and put back (chapter 1.2).

use super::groups;
use crate::cursor::{self, Cursor, Removal};
use crate::machine::Key;
use crate::screen::{Color, Put, Screen, Stroke};
use crate::ui::{CommandLine, Demo, Lesson, Manual, Program, Words, without_document};

const MANUAL: Manual = Manual {
    name: "gr_kz_o",
    about: Words(
        "Grafikus kurzor OR és XOR művelettel, mentett háttérrel",
        "A graphic cursor by or and exclusive-or, background saved",
    ),
    intro: Words(
        "Egy kurzor, amely minden háttéren ugyanolyan: fehér kereszt fekete szegéllyel. Vigye végig a \
         foltokon az egérrel vagy a nyilakkal. A VAGY (OR) fehérre állítja, a KIZÁRÓ VAGY (XOR) a \
         szegélyét feketére; a hátteret ezért előbb el kell menteni.",
        "A cursor that looks the same on every background: a white cross with a black border. Move it \
         over the patches with the mouse or the arrows. OR makes it white, exclusive-or (XOR) makes its \
         border black; so the background has to be saved first.",
    ),
    keys: cursor::KEYS,
    lesson: &[
        Lesson::Line(Words(
            "1. A kurzor helyén levő háttér mentése.",
            "1. Save the background where the cursor will be.",
        )),
        Lesson::Line(Words(
            "2. A teljes kereszt OR művelettel: c OR 15 = 15, mindenütt fehér.",
            "2. Put the whole cross by OR: c OR 15 = 15, white everywhere.",
        )),
        Lesson::Line(Words(
            "3. Csak a szegélye XOR művelettel: 15 XOR 15 = 0, fekete.",
            "3. Put its border alone by XOR: 15 XOR 15 = 0, black.",
        )),
        Lesson::Line(Words(
            "Ahol k = 0, c marad; a paletta (F9) nem számít. Végül c visszakerül.",
            "Where k = 0, c stays; no palette (F9) matters. At last c is put back.",
        )),
        Lesson::Operation(Put::Or),
        Lesson::Operation(Put::Xor),
    ],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "1.2",
    group: &groups::CURSORS,
    opens: &[],
    demo: Demo { file: "", script: "move 320 240", motion: Some(Key::Right) },
    start: |document| {
        without_document(document, |machine| {
            Box::pin(cursor::run(machine, MANUAL, cursor::patchwork(10, 71, 0), cross()))
        })
    },
    command_line: CommandLine::Usual,
};

/// A white cross with a black border: the whole cross by or, then the border alone by exclusive-or.
fn cross() -> Cursor {
    let whole = Cursor::image(|screen| arms(screen, Stroke::thick(Color::White)));
    let border = Cursor::image(|screen| {
        arms(screen, Stroke::thick(Color::White));
        arms(screen, Stroke::thin(Color::Black));
    });
    Cursor::new(vec![(whole, Put::Or), (border, Put::Xor)], Removal::PutSaved)
}

/// The two lines of the cross.
fn arms(screen: &mut Screen, stroke: Stroke) {
    let (middle, end) = (Cursor::RADIUS, 2 * Cursor::RADIUS);
    screen.line(0, middle, end, middle, stroke);
    screen.line(middle, 0, middle, end, stroke);
}
