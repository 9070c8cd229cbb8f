//! CSANGO_K: the Csángó cube, fourteen pieces that are moved and turned into a cube of 4 x 4 x 4 (chapter 4.4).
//! Rules and searches are `grafika::puzzle::cube`; here are the game, its picture and its controls.

mod eye;
mod game;
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
    intro: Words(
        "Cél: a tizennégy elemből 4 x 4 x 4-es kocka az asztal közepén. Kezdje egy könnyű játékkal: kattintson egy \
         elemre, húzza, emelje a görgővel, fordítsa az R, S, T betűkkel; H segít. Az elemek milliónyi módon töltik ki \
         a kockát: a betolásuk sorrendje a feladvány.",
        "The goal: a cube of 4 x 4 x 4 out of the fourteen pieces in the middle of the table. Start with an easy \
         game: click a piece, drag it, lift it by the wheel, turn it with R, S, T; H helps. The pieces fill the cube \
         in millions of ways: the order in which they go in is the puzzle.",
    ),
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
