//! GR_KZ_X: a cursor that is put on the screen by exclusive-or and taken off by the same (chapter 1.2).

use grafika::cursor::{self, Cursor, Removal};
use grafika::launch::{Program, no_file};
use grafika::screen::{Color, Put};
use grafika::ui::{Lesson, Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "gr_kz_x",
    about: Words("Grafikus kurzor XOR művelettel", "A graphic cursor by exclusive-or"),
    keys: &[
        (Words("egér, nyilak", "mouse, arrows"), Words("a kurzor mozgatása", "move the cursor")),
        (Words("Esc", "Esc"), Words("vége", "end")),
    ],
    lesson: &[
        Lesson::Line(Words(
            "A kurzor képe XOR művelettel kerül a képernyőre, a színszámok bitjein.",
            "The image of the cursor is put by XOR, on the bits of colour numbers.",
        )),
        Lesson::Line(Words(
            "Fekete (0) képpontja alatt c marad c, fehér (15) alatt 15-c lesz.",
            "Under its black pixels (0) c stays, under white ones (15) it is 15-c.",
        )),
        Lesson::Line(Words(
            "Ugyanoda még egyszer kitéve eltűnik: (c XOR k) XOR k = c. A hátteret",
            "Put there once more it vanishes: (c XOR k) XOR k = c. The background",
        )),
        Lesson::Line(Words(
            "nem kell elmenteni, de a kurzor színe attól függ, mi van alatta.",
            "need not be saved, but the colour of the cursor depends on it.",
        )),
        Lesson::Operation(Put::Xor),
    ],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "1.2",
    run: |machine, _| Box::pin(cursor::run(machine, MANUAL, cursor::patchwork(4, 163, 0), disc())),
    check: no_file,
};

/// A white disc, put by exclusive-or.
fn disc() -> Cursor {
    let r = Cursor::RADIUS;
    let image = Cursor::image(|screen| screen.disc(r, r, r, Color::White, Color::Black));
    Cursor::new(vec![(image, Put::Xor)], Removal::PutAgain)
}

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
