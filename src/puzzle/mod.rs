//! The logic puzzles of the book: their rules, their states, and solvers that advance by a budget.
//!
//! Nothing here draws, reads files, looks at a clock or starts threads: a solver is a value that is asked to
//! work a little, tells how far it is, and can be dropped at any time.

pub mod cube;
pub mod wheel;
