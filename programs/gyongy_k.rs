//! GYONGY_K: the bead wheel, 25 beads that drawers push through a centre and rings turn about it (chapter
//! 4.2). The rules and the solver are `grafika::puzzle::wheel`; here are the board, the game and the keys.

mod game;
mod picture;
mod player;
mod show;
mod texts;

use super::groups;
use crate::file::Format;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "gyongy_k",
    about: Words("Gyöngykerék, logikai játék", "The bead wheel, a logic puzzle"),
    intro: Words("", ""),
    keys: player::KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "4.2",
    group: &groups::GAMES,
    opens: &[Format::Gyk],
    demo: Demo { file: "", script: "key T\nkey A\nkey K", motion: None },
    start: |document| {
        document.as_ref().map_or(Ok(()), |document| game::Game::of(document).map(|_| ()))?;
        Ok(Box::new(move |machine| Box::pin(player::run(machine, MANUAL, document))))
    },
    command_line: CommandLine::Usual,
};
