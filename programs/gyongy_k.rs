//! GYONGY_K: the bead wheel, 25 beads that drawers push through a centre and rings turn about it (chapter
//! 4.2). The rules and the solver are `grafika::puzzle::wheel`; here are the board, the game and the keys.

mod game;
mod hand;
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
    intro: Words(
        "Cél: minden karban egyszínű gyöngyök, középen a szürke, a fiókok a helyükön. Kezdje egy könnyű játékkal: \
         húzza a gyűrűket, tolja be a fiókokat, ha elakad, H segít. A betolt fiók a szemköztit kitolja; minden \
         lépésnek van ellenkezője.",
        "The goal: beads of one colour in every arm, the grey one in the centre, the drawers at home. Start with an \
         easy game: drag rings, push drawers in, H helps when you are stuck. A drawer pushed in pushes the opposite \
         one out; every move has an opposite.",
    ),
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
