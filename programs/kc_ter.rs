//! KC_TER: curves and surfaces by control points over extended Chebyshev spaces, after a thesis of 2018 (Babeş-Bolyai
//! University) on the theory of Á. Róth. The mathematics is `grafika::geometry::ec`; here are the scene, its pages and
//! its dialogs.

mod actions;
mod asking;
mod coefficients;
mod commands;
mod edit;
mod eye;
mod files;
mod lengths;
mod model;
mod mouse;
mod paint;
mod pointers;
mod preview;
mod rows;
mod shape;
mod space;
mod speed;
mod status;
mod studio;
mod texts;
mod values;

use super::groups;
use crate::file::{Document, Format};
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "kc_ter",
    about: Words(
        "Görbék és felületek kiterjesztett Csebisev-terekben",
        "Curves and surfaces over extended Chebyshev spaces",
    ),
    intro: Words(
        "Görbék és felületek olyan függvényekből, amelyek között szinusz és exponenciális is lehet. Kezdje B és G \
         betűkkel, majd húzzon egy pontot; G mutatja a teret. A kör, a spirál és a csigaház így pontosan leírható, \
         súlyok nélkül, csak kontrollpontokkal.",
        "Curves and surfaces of functions that may contain sines and exponentials. Start with B and G, drag a point; G \
         shows the space. Circles, spirals and snail shells are described exactly, by control points alone, without \
         weights.",
    ),
    keys: commands::KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "T",
    group: &groups::THESIS,
    opens: &[Format::Kcj, Format::Kcg, Format::Kcf, Format::Kce, Format::Kct],
    demo: Demo { file: "SNAIL.KCJ", script: "key E", motion: Some(crate::machine::Key::Right) },
    start: |document| match document {
        Some(Document::Ec(document)) => {
            Ok(Box::new(|machine| Box::pin(studio::run(machine, MANUAL, Some(Document::Ec(document))))))
        }
        Some(_) => Err(texts::NO_DOCUMENT.into()),
        None => Ok(Box::new(|machine| Box::pin(studio::run(machine, MANUAL, None)))),
    },
    command_line: CommandLine::Usual,
};
