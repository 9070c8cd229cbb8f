//! SOM_FEL: surfaces from scattered points by nets of neurons (chapter 4 of M. Hoffmann's booklet and the papers behind
//! it). The mathematics is `grafika::geometry::kohonen` and `grafika::geometry::fit`; here are the picture of learning,
//! the files and the questions.

mod commands;
mod gauges;
mod life;
mod model;
mod obey;
mod paint;
mod panels;
mod reading;
mod run;
mod state;
mod texts;
mod trainer;

use super::groups;
use crate::file::{Document, Format};
use crate::ui::{CommandLine, Demo, Manual, Phrase, Program, Start, Words};

const MANUAL: Manual = Manual {
    name: "som_fel",
    about: Words("Felületek szétszórt pontokból", "Surfaces from scattered points"),
    intro: Words(
        "Felület rendezetlen pontokból: egy háló neuronjai megtanulják, hol vannak a pontok. Nyomjon T-t és nézze, majd \
         I illeszti rá a felületet, F4 a hibákat színezi. Mindig a ponthoz legközelebbi neuron győz, és magával húzza \
         a szomszédait, ezért simul a háló a felhőre.",
        "A surface from points without any order: the neurons of a net learn where the points are. Press T and watch, then \
         I fits the surface and F4 colours the errors. The neuron nearest to a point wins and takes its neighbours \
         along, and so the net unfolds over the cloud.",
    ),
    keys: commands::KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "H",
    group: &groups::CLOUDS,
    opens: &[Format::Som, Format::Xyz, Format::Ply, Format::Obj, Format::Stl],
    demo: Demo { file: "NYEREG.XYZ", script: "key T\nwait 4000", motion: Some(crate::machine::Key::Right) },
    start,
    command_line: CommandLine::Usual,
};

fn start(document: Option<Document>) -> Result<Start, Phrase> {
    if let Some(document) = &document {
        trainer::check(document)?;
    }
    Ok(Box::new(|machine| Box::pin(trainer::run(machine, MANUAL, document))))
}
