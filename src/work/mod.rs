//! The life of a document, the same for editors, puzzles and billiards: new or stored, edited, undone, saved, left,
//! and rescued after a session that broke off.

mod choose;
mod files;
mod history;
mod life;
mod rescue;

pub(crate) use choose::choose_file;
pub use files::{Files, dos_files, read_document, with_json, with_twin};
pub use history::History;
pub use life::{Next, Work, common_key, event, quit, run};
pub(crate) use life::{load, offer_to_save, save};
pub use rescue::keep;
