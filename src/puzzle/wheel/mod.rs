//! The bead wheel (GYONGY_K, chapter 4.2): 25 beads in six arms round a centre, pushed through the centre by
//! drawers and turned about it in three rings.
//!
//! [`Wheel`] is a position, [`Move`] one of the twelve moves, [`Scramble`] a way to make a problem that others
//! can make again, [`Solver`] looks for the shortest way back. Colours are counted by their home arm, 1 to 6,
//! and the one bead without equals, at home in the centre, is 0.

mod ball;
mod beam;
mod deepen;
mod error;
mod moves;
mod patterns;
mod scramble;
mod solver;
mod state;
mod text;

pub use error::WheelError;
pub use moves::Move;
pub use scramble::{Difficulty, Scramble};
pub use solver::{Progress, Search, Solution, Solver, Tables};
pub use state::{ARMS, RINGS, Wheel};
pub use text::{moves_from_text, moves_to_text};
