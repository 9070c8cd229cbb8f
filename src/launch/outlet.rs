//! Where scripts and commands write: files named on the command line.

use super::{Failure, in_language, spoken};
use crate::disk::write_safely;
use crate::figure::screen_png;
use crate::machine::Outlet;
use crate::screen::{Screen, visible};
use std::io::{ErrorKind, Write};
use std::path::Path;

/// Writes a script's pictures and models to disk.
pub(super) struct Disk;

impl Outlet for Disk {
    fn picture(&mut self, path: &str, screen: &Screen) -> Result<(), String> {
        let picture = screen_png(screen).map_err(|error| format!("{path}: {error}"))?;
        write_safely(Path::new(path), &picture).map_err(|error| format!("{path}: {error}"))
    }

    fn text(&mut self, path: &str, text: &str) -> Result<(), String> {
        write_safely(Path::new(path), text.as_bytes()).map_err(|error| format!("{path}: {error}"))
    }
}

/// Writes a command's output to a file, or to stdout without one or for `-`.
///
/// # Errors
/// [`Failure`] with the path and what the system says; one that ends the command quietly when nobody reads stdout any
/// more.
pub fn write_output(path: Option<&Path>, content: &[u8]) -> Result<(), Failure> {
    match path.filter(|path| *path != Path::new("-")) {
        Some(path) => write_safely(path, content).map_err(|error| match error.kind() {
            ErrorKind::BrokenPipe => Failure::unread(),
            _ => Failure::work(format!("{}: {error}", path.display())),
        }),
        None => {
            let mut stdout = std::io::stdout().lock();
            let written = stdout.write_all(content).and_then(|()| stdout.flush());
            written.map_err(|error| match error.kind() {
                ErrorKind::BrokenPipe => Failure::unread(),
                _ => Failure::work(format!("standard output: {error}")),
            })
        }
    }
}

/// Writes an answer in words to standard output, in the user's language.
///
/// # Errors
/// Those of [`write_output`].
pub fn answer(text: &str) -> Result<(), Failure> {
    write_output(None, in_language(text, spoken()).as_bytes())
}

/// Says something on stderr in one line and in the user's language: who says it, and what, with control characters
/// escaped. Where nobody can be told, nothing else fails.
pub fn say(who: &str, what: &str) {
    let line = what.split_whitespace().collect::<Vec<_>>().join(" ");
    let line = in_language(&line, spoken());
    let _ = std::io::stderr().write_all(format!("{who}: {}\n", visible(&line)).as_bytes());
}
