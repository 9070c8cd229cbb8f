//! The life of what a program works on, the same for editors, puzzles and billiards: new or stored, edited, undone,
//! saved, left, and rescued after a session that broke off.

mod files;
mod history;
mod life;
pub mod rescue;

pub use files::{Files, dos_files, read_document, with_json, with_twin};
pub use history::History;
pub use life::{Configuration, Next, common_key, event, keep, quit, run};
