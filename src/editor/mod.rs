//! The control-point editors that the programs share, what they have in common, and the history behind
//! undo and redo.
//!
//! A program of the book is one of these editors with its own methods and buttons; nothing here names
//! a program.

mod axes;
mod beta;
mod choice;
pub mod drawing;
mod field;
pub mod fourier;
pub mod keys;
mod look;
pub mod net;
mod place;
pub mod plane;
mod points;
pub mod space;
mod stage;
