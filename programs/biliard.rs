//! BILIARD: eleven balls on a table, shot by dragging a ball's ghost away (chapters 4.1 and 4.3). The physics
//! is `grafika::table`; here are the game, its picture and its controls.

mod picture;
mod player;
mod rolling;
mod texts;

use super::groups;
use crate::file::{Document, Format};
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "biliard",
    about: Words("Biliárd tizenegy golyóval", "Billiards with eleven balls"),
    intro: Words(
        "Tizenegy egyforma golyó gurul egy asztalon, és veszteség nélkül ütközik. Húzza el az egérrel a bal oldali golyó képét a \
         többi felé, és engedje el. Ahány képponttal odébb, annyi képpont másodpercenként: a mozgás az ütközések \
         egyenleteiből (4.1-4.12) pontosan következik.",
        "Eleven equal balls roll on a table and hit each other without loss. Drag the ghost of the ball on the left towards the \
         others and let go. So many pixels away, so many pixels a second: the motion follows exactly from the \
         equations of the hits (4.1 to 4.12).",
    ),
    keys: player::KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "4.1, 4.3",
    group: &groups::GAMES,
    opens: &[Format::Bil],
    demo: Demo { file: "", script: "drag 60 240 560 246", motion: None },
    start: |document| match document {
        Some(Document::Billiards(game)) => {
            Ok(Box::new(|machine| Box::pin(player::run(machine, MANUAL, Some(game)))))
        }
        Some(_) => Err(texts::NO_DOCUMENT.into()),
        None => Ok(Box::new(|machine| Box::pin(player::run(machine, MANUAL, None)))),
    },
    command_line: CommandLine::Usual,
};
