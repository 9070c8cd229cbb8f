//! CSANGO_K: the Csángó cube, fourteen pieces that are moved and turned into a cube of 4 x 4 x 4 (chapter 4.4).
//! Rules and searches are `grafika::puzzle::cube`; here are the game, its picture and its controls.

#[path = "csango_k/eye.rs"]
mod eye;
#[path = "csango_k/hand.rs"]
mod hand;
#[path = "csango_k/panel.rs"]
mod panel;
#[path = "csango_k/picture.rs"]
mod picture;
#[path = "csango_k/player.rs"]
mod player;
#[path = "csango_k/task.rs"]
mod task;
#[path = "csango_k/texts.rs"]
mod texts;

use grafika::file::Document;
use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "csango_k",
    about: Words("A Csángó kocka tizennégy eleme", "The fourteen pieces of the Csángó cube"),
    keys: texts::KEYS,
    lesson: &[],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "4.4",
    run: |machine, file| Box::pin(player::run(machine, MANUAL, file)),
    check: |document| match document {
        Document::CsangoCube(_) => Ok(()),
        _ => Err(texts::NO_CUBE.into()),
    },
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
