//! Where scripts and commands write: files named on the command line.

use super::Failure;
use crate::disk::write_safely;
use crate::figure::screen_png;
use crate::machine::Outlet;
use crate::screen::Screen;
use std::io::Write;
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
/// [`Failure`] with the path and what the system says.
pub fn write_output(path: Option<&Path>, content: &[u8]) -> Result<(), Failure> {
    match path.filter(|path| *path != Path::new("-")) {
        Some(path) => {
            write_safely(path, content).map_err(|error| Failure::work(format!("{}: {error}", path.display())))
        }
        None => {
            let mut stdout = std::io::stdout().lock();
            let written = stdout.write_all(content).and_then(|()| stdout.flush());
            written.map_err(|error| Failure::work(format!("standard output: {error}")))
        }
    }
}
