//! The browser edition of grafika: programs on a canvas, with files, unsaved work and settings that the page keeps.
//!
//! The page calls an [`App`] with what happens and when; what has to outlive the page goes through its [`Host`]. Storage is
//! asked at once and answers at once, so that files lie here in memory, as the page has brought them, and the page writes
//! what has changed.

#![forbid(unsafe_code)]

mod app;
mod catalog;
mod files;
mod host;
mod open;
mod settings;
mod share;
mod work;

pub use app::App;
pub use host::Host;
