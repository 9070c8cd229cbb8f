//! GYONGY_K: the bead wheel, 25 beads that drawers push through a centre and rings turn about it (chapter
//! 4.2). The rules and the solver are `grafika::puzzle::wheel`; here are the board, the game and the keys.

#[path = "gyongy_k/game.rs"]
mod game;
#[path = "gyongy_k/picture.rs"]
mod picture;
#[path = "gyongy_k/player.rs"]
mod player;
#[path = "gyongy_k/show.rs"]
mod show;
#[path = "gyongy_k/texts.rs"]
mod texts;

use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "gyongy_k",
    about: Words("Gyöngykerék, logikai játék", "The bead wheel, a logic puzzle"),
    keys: texts::KEYS,
    lesson: &[],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "4.2",
    run: |machine, document| Box::pin(player::run(machine, MANUAL, document)),
    check: |document| game::Game::of(document).map(|_| ()),
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
