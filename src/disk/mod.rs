//! What a machine keeps on the disk: the files of a folder, unsaved work, the user's settings. Files are written so
//! that a crash leaves the old content or the new one.

mod bests;
mod config;
mod folder;
mod read;
mod reason;
mod recovery;
mod user_folder;
mod write;

pub use bests::BestsFile;
pub use config::ConfigFile;
pub use folder::Folder;
pub use read::{LARGEST_FILE, open_stream, read_limited, read_regular, read_stream, text};
pub use reason::reason;
pub use recovery::{Offers, RecoveryFolder};
pub use user_folder::UserFolder;
pub use write::{create, write_safely, write_safely_with};
