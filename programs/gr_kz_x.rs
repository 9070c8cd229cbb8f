//! GR_KZ_X: a cursor that is put on the screen by exclusive-or and taken off by the same (chapter 1.2).

use super::groups;
use crate::cursor::{self, Cursor, Removal};
use crate::machine::Key;
use crate::screen::{Color, Put};
use crate::ui::{CommandLine, Demo, Lesson, Manual, Program, Words, without_document};

const MANUAL: Manual = Manual {
    name: "gr_kz_x",
    about: Words("Grafikus kurzor XOR művelettel", "A graphic cursor by exclusive-or"),
    intro: Words(
        "Egy kurzor, amely KIZÁRÓ VAGY (XOR) művelettel kerül a képernyőre. Vigye végig a foltokon az \
         egérrel vagy a nyilakkal. A fehér korong alatt minden szín az ellentettjére vált, és ugyanaz a \
         művelet még egyszer visszaadja a hátteret: nem kell elmenteni.",
        "A cursor that is put on the screen by exclusive-or (XOR). Move it over the patches with the \
         mouse or the arrows. Under the white disc every colour becomes its inverse, and the same \
         operation once more brings the background back: nothing has to be saved.",
    ),
    keys: cursor::KEYS,
    lesson: &[
        Lesson::Line(Words(
            "A kép XOR művelettel kerül a színszámokra: a paletta (F9) nem számít.",
            "The image is put by XOR on colour numbers: palettes (F9) change none.",
        )),
        Lesson::Line(Words(
            "Fekete (0) képpontja alatt c marad c, fehér (15) alatt NOT c = 15-c.",
            "Under its black pixels (0) c stays, under white ones (15) it is NOT c,",
        )),
        Lesson::Line(Words(
            "Még egyszer kitéve eltűnik: (c XOR k) XOR k = c. A hátteret nem kell",
            "15-c. Once more it vanishes: (c XOR k) XOR k = c. Nothing is saved,",
        )),
        Lesson::Line(Words(
            "menteni, de a kurzor színe c-től függ. AND: a közös bitek maradnak.",
            "but the cursor's colour depends on c. AND keeps the bits both have.",
        )),
        Lesson::Operation(Put::Xor),
        Lesson::Operation(Put::And),
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
            Box::pin(cursor::run(machine, MANUAL, cursor::patchwork(4, 163, 0), disc()))
        })
    },
    command_line: CommandLine::Usual,
};

/// A white disc, put by exclusive-or.
fn disc() -> Cursor {
    let r = Cursor::RADIUS;
    let image = Cursor::image(|screen| screen.disc(r, r, r, Color::White, Color::Black));
    Cursor::new(vec![(image, Put::Xor)], Removal::PutAgain)
}
