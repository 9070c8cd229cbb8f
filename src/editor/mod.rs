//! The control-point editors that the programs share, what they have in common, and the history behind
//! undo and redo.
//!
//! A program of the book is one of these editors with its own methods and buttons; nothing here names
//! a program.

mod choice;
pub mod configuration;
pub mod fourier;
mod history;
pub mod plane;

pub use history::History;
