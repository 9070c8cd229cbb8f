//! Traces, laws, and what nets have learnt.

mod laws;
mod learnt;
mod trace;
