//! Games of the cube by difficulty and number.

use crate::puzzle::cube::{CsangoCube, Move, PIECES, Rules};
use serde::{Deserialize, Serialize};

/// How much of the cube is missing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Preset {
    /// The last three pieces.
    #[default]
    Three,
    Six,
    /// All pieces lie as at the start of the book's program.
    All,
    /// All pieces are thrown about.
    Mixed,
}

/// A game that a number makes again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Deal {
    pub(crate) preset: Preset,
    pub(crate) number: u64,
}

impl Preset {
    /// How many pieces are missing; `None` if there is no cube to take them from.
    fn missing(self) -> Option<usize> {
        match self {
            Preset::Three => Some(3),
            Preset::Six => Some(6),
            Preset::All => Some(PIECES),
            Preset::Mixed => None,
        }
    }

    /// The position in which so many pieces are missing, on the way of a solution from the start, with the moves that are
    /// left.
    pub(crate) fn along(self, moves: &[Move], rules: Rules) -> (CsangoCube, Vec<Move>) {
        let there = PIECES - self.missing().unwrap_or(PIECES);
        let mut cube = CsangoCube::start();
        for (made, &step) in moves.iter().enumerate() {
            if cube.placed().len() >= there {
                return (cube, moves.get(made..).unwrap_or_default().to_vec());
            }
            cube = cube.after(step, rules).unwrap_or(cube);
        }
        (cube, Vec::new())
    }
}
