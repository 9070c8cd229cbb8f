//! The Csángó cube (chapter 4.4): fourteen pieces of four and five cells on a table of 10 x 10 x 7 cells,
//! which are moved and turned cell by cell until they make a cube of 4 x 4 x 4.
//!
//! [`CsangoCube`] is a position and knows which moves it allows. [`Search`] finds the ways to fill the cube,
//! [`Count`] counts them, and [`Way`] finds the moves that lead there.

mod count;
mod ending;
mod moves;
mod place;
mod position;
mod reach;
mod search;
mod shape;
mod solver;
mod state;
mod way;

pub use count::{Count, Item, all_fillings};
pub use moves::{Action, Move, Refused, Rules};
pub use place::{Filling, Placed};
pub use position::{CsangoCube, CubePiece, Fault, ROTATIONS};
pub(crate) use position::{add, turned};
pub use search::{Progress, Search};
pub use shape::{PIECES, PieceShape, TABLE, shape};
pub use solver::Solver;
pub use state::StateError;
pub use way::{CORNER, Way, WayError};
