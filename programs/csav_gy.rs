//! CSAV_GY: a twisted ring (3.9), viewed from all sides (chapter 3.1).

use super::groups;
use crate::editor::net::{self, Constant, Show};
use crate::geometry::{Derivatives, Grid, ParamSurface};
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
            let grid = |values: &[i32]| Ring::new(values).grid();
            let surface = |values: &[i32]| -> Box<dyn ParamSurface> { Box::new(Ring::new(values)) };
            let show = Show { manual: MANUAL, view: [0.3, 0.4, 0.2], constants: &CONSTANTS, grid, surface };
            Box::pin(net::show(machine, show))
        })
    },
    command_line: CommandLine::Usual,
};

/// The constants of (3.9), and the numbers of cells of the listing, which count from 0: nu along and nv = (nu - 1) / 2
/// around, n lines each. The second set is the one that the book leaves to its readers, because of the memory.
const CONSTANTS: [Constant; 6] = [
    Constant { name: "k", sets: [6, 6], range: 0..=24, step: 1 },
    Constant { name: "R", sets: [160, 160], range: 0..=240, step: 5 },
    Constant { name: "r", sets: [20, 20], range: 0..=120, step: 5 },
    Constant { name: "q", sets: [60, 60], range: 0..=120, step: 5 },
    Constant { name: "nu", sets: [5, 7], range: 3..=9, step: 2 },
    Constant { name: "n", sets: [12, 16], range: 2..=24, step: 1 },
];

/// A circle of radius q around a centre line with k waves outwards and upwards of radius r, around the circle of radius
/// R (3.9).
#[derive(Clone, Copy, Debug)]
struct Ring {
    waves: f64,
    large: f64,
    small: f64,
    tube: f64,
    /// Cells along the ring and around it.
    cells: [usize; 2],
    /// Lines of a cell.
    lines: usize,
}

impl Ring {
    fn new(values: &[i32]) -> Ring {
        let value = |at: usize| values.get(at).copied().unwrap_or_default();
        let count = |at: usize| usize::try_from(value(at)).unwrap_or(0);
        let nu = count(4).max(1);
        Ring {
            waves: f64::from(value(0)),
            large: f64::from(value(1)),
            small: f64::from(value(2)),
            tube: f64::from(value(3)),
            cells: [nu + 1, (nu - 1) / 2 + 1],
            lines: count(5).max(1),
        }
    }

    /// The last line of each direction is the first again.
    fn grid(self) -> Grid {
        let lines = self.cells.map(|cells| cells * self.lines);
        Grid::from_fn(lines.map(|lines| lines + 1), [true; 2], |k, l| {
            let (along, around) = (TAU * k as f64 / lines[0] as f64, TAU * l as f64 / lines[1] as f64);
            let out = self.large + self.small * (self.waves * along).sin() + self.tube * around.sin();
            let up = self.small * (self.waves * along).cos() + self.tube * around.cos();
            [out * along.cos(), out * along.sin(), up]
        })
    }
}

impl ParamSurface for Ring {
    fn spans(&self) -> [usize; 2] {
        self.cells
    }

    fn closed(&self) -> [bool; 2] {
        [true; 2]
    }

    fn at(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<Derivatives> {
        if spans.iter().zip(self.cells).any(|(span, cells)| *span >= cells) {
            return None;
        }
        // The angles of a cell, and the places in it.
        let step = self.cells.map(|cells| TAU / cells as f64);
        let [(sin_a, cos_a), (sin_b, cos_b), (sin_w, cos_w)] = {
            let at = |d: usize| step[d] * (spans[d] as f64 + uv[d].clamp(0.0, 1.0));
            [at(0), at(1), self.waves * at(0)].map(f64::sin_cos)
        };
        let Ring { waves: k, large, small: r, tube: q, .. } = *self;
        // Outwards and upwards, with their derivatives along and around.
        let out = [large + r * sin_w + q * sin_b, r * k * cos_w, -r * k * k * sin_w, q * cos_b, -q * sin_b];
        let up = [r * cos_w + q * cos_b, -r * k * sin_w, -r * k * k * cos_w, -q * sin_b, -q * cos_b];
        let turned = |out: f64, side: f64, up: f64, by: f64| {
            [(out * cos_a - side * sin_a) * by, (out * sin_a + side * cos_a) * by, up * by]
        };
        let [u, v] = step;
        Some(Derivatives {
            point: turned(out[0], 0.0, up[0], 1.0),
            u: turned(out[1], out[0], up[1], u),
            v: turned(out[3], 0.0, up[3], v),
            uu: turned(out[2] - out[0], 2.0 * out[1], up[2], u * u),
            uv: turned(0.0, out[3], 0.0, u * v),
            vv: turned(out[4], 0.0, up[4], v * v),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(set: usize) -> Ring {
        Ring::new(&CONSTANTS.each_ref().map(|constant| constant.sets[set]))
    }

    #[test]
    fn the_sets_are_those_of_the_listing() {
        for (set, lines) in [(0, [73, 37]), (1, [129, 65])] {
            let grid = ring(set).grid();
            assert_eq!([grid.rows(), grid.columns()], lines);
            // The surface is the grid.
            let other = ring(set).grid_of_surface();
            for (one, other) in grid.points().iter().zip(other.points()) {
                assert!(one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-10), "{one:?} {other:?}");
            }
        }
    }

    impl Ring {
        fn grid_of_surface(self) -> Grid {
            ParamSurface::grid(&self, self.lines).expect("few points")
        }
    }

    #[test]
    fn derivatives_are_differences() {
        let (ring, h) = (Ring::new(&[5, 120, 35, 40, 5, 12]), 1e-4);
        for (spans, [u, v]) in [([0, 0], [0.3, 0.6]), ([4, 2], [0.7, 0.2]), ([5, 1], [0.5, 0.9])] {
            let at = |du: f64, dv: f64| ring.eval(spans, [u + du, v + dv]).expect("inside");
            let told = ring.at(spans, [u, v]).expect("inside");
            for d in 0..3 {
                let near =
                    |told: f64, found: f64| assert!((told - found).abs() < 1e-2, "{d}: {told} {found}");
                near(told.u[d], (at(h, 0.0)[d] - at(-h, 0.0)[d]) / (2.0 * h));
                near(told.v[d], (at(0.0, h)[d] - at(0.0, -h)[d]) / (2.0 * h));
                near(told.uu[d], (at(h, 0.0)[d] - 2.0 * at(0.0, 0.0)[d] + at(-h, 0.0)[d]) / (h * h));
                near(told.vv[d], (at(0.0, h)[d] - 2.0 * at(0.0, 0.0)[d] + at(0.0, -h)[d]) / (h * h));
                near(told.uv[d], (at(h, h)[d] - at(h, -h)[d] - at(-h, h)[d] + at(-h, -h)[d]) / (4.0 * h * h));
            }
        }
        assert_eq!(ring.at([6, 0], [0.0; 2]), None);
    }
}
