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
        "Cél: minden karban egyszínű gyöngyök, középen a szürke, a fiókok a helyükön; a betolt fiók sora átcsúszik a \
         középponton és kitolja a szemközti fiókot, a három gyűrű pedig körbeviszi a gyöngyöket. Kezdje egy könnyű \
         játékkal: tolja a fiókokat, forgassa a gyűrűket egérrel vagy betűkkel, és ha elakad, kérjen segítséget. Minden \
         lépésnek van ellenkezője, ezért minden állásból vissza lehet jutni.",
        "The goal: each arm holds beads of one colour, the grey bead is in the centre and the drawers are at home; a \
         drawer that is pushed in moves its row through the centre and the opposite drawer out, and three rings carry \
         beads around. Start with an easy game: push drawers and turn rings with the mouse or by their letters, and \
         ask for a hint when you are stuck. Every move has an opposite, so there is a way back from every position.",
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
