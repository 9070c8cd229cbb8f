//! BILIARD: eleven balls on a table, shot by dragging a ball's ghost away (chapters 4.1 and 4.3). The physics
//! is `grafika::table`; here are the game, its picture and its controls.

#[path = "biliard/game.rs"]
mod game;
#[path = "biliard/picture.rs"]
mod picture;
#[path = "biliard/player.rs"]
mod player;
#[path = "biliard/rolling.rs"]
mod rolling;
#[path = "biliard/texts.rs"]
mod texts;

use grafika::launch::Program;
use grafika::ui::{Manual, Words};
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "biliard",
    about: Words("Biliárd tizenegy golyóval", "Billiards with eleven balls"),
    keys: texts::KEYS,
    lesson: &[],
};

pub(crate) const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "4.1, 4.3",
    run: |machine, _| Box::pin(player::run(machine, MANUAL)),
    check: |_| Err(texts::NO_DOCUMENT.into()),
};

#[allow(dead_code, reason = "the same file is a module of the menu, which starts the program itself")]
fn main() -> ExitCode {
    PROGRAM.main()
}
