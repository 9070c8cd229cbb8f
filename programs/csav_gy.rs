//! CSAV_GY: a twisted ring (3.9), viewed from all sides (chapter 3.1).

use super::groups;
use crate::editor::net::{self, Show};
use crate::geometry::Grid;
use crate::machine::Key;
use crate::ui::{CommandLine, Demo, Manual, Program, Words, without_document};
use std::f64::consts::TAU;

const MANUAL: Manual = Manual {
    name: "csav_gy",
    about: Words("Csavart gyűrű minden oldalról", "A twisted ring from all sides"),
    intro: Words(
        "Egy csavart gyűrű: cső egy olyan vonal körül, amely hatszor tekeredik egy kör köré. Nyomja meg a \
         T-t, és forgassa a nyilakkal. A drótváz minden vonalat mutat, és nem dönthető el, mi van elöl; a \
         takart vonalak nélkül minden képpontban a legközelebbi lap látszik.",
        "A twisted ring: a tube around a line that winds six times about a circle. Press T and turn it \
         with the arrows. The wireframe shows every line and does not tell front from back; with hidden \
         lines removed, the nearest cell is seen in every pixel.",
    ),
    keys: net::SHOW_KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "3.1",
    group: &groups::RINGS,
    opens: &[],
    demo: Demo { file: "", script: "key T", motion: Some(Key::Left) },
    start: |document| {
        without_document(document, |machine| {
            Box::pin(net::show(machine, Show { manual: MANUAL, view: [0.3, 0.4, 0.2], grid: ring() }))
        })
    },
    command_line: CommandLine::Usual,
};

/// Numbers of lines around the ring and around its tube; the last line of each is the first again.
const LINES: [usize; 2] = [72, 36];

/// The ring: a circle of radius 60 around a centre line with six waves outwards and upwards (3.9).
fn ring() -> Grid {
    Grid::from_fn(LINES.map(|lines| lines + 1), [true; 2], |k, l| {
        let (along, around) = (TAU * k as f64 / LINES[0] as f64, TAU * l as f64 / LINES[1] as f64);
        let out = 160.0 + 20.0 * (6.0 * along).sin() + 60.0 * around.sin();
        [out * along.cos(), out * along.sin(), 20.0 * (6.0 * along).cos() + 60.0 * around.cos()]
    })
}
