//! CSANGO_K: the Csángó cube, fourteen pieces that are moved and turned into a cube of 4 x 4 x 4 (chapter 4.4).
//! Rules and searches are `grafika::puzzle::cube`; here are the game, its picture and its controls.

mod eye;
mod hand;
mod panel;
mod picture;
mod player;
mod task;
mod texts;

use super::groups;
use crate::file::{Document, Format};
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "csango_k",
    about: Words("A Csángó kocka tizennégy eleme", "The fourteen pieces of the Csángó cube"),
    intro: Words("", ""),
    keys: player::KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "4.4",
    group: &groups::GAMES,
    opens: &[Format::Csk],
    demo: Demo { file: "A.CSK", script: "", motion: Some(Key::Left) },
    start: |document| match document {
        Some(document) if !matches!(document, Document::CsangoCube(_)) => Err(texts::NO_CUBE.into()),
        document => Ok(Box::new(move |machine| Box::pin(player::run(machine, MANUAL, document)))),
    },
    command_line: CommandLine::Usual,
};
