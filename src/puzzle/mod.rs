//! Rules and solvers of the puzzles: positions, moves and searches, without files, screens or threads.
//!
//! A long search is a value that advances by a budget and tells how far it is, so that a program can draw
//! it, stop it, or run its parts on threads.

pub mod cube;
