//! Where scripts and commands write: files named on the command line.

use super::Failure;
use crate::disk::{reason, write_safely};
use crate::figure::screen_png;
use crate::machine::Outlet;
use crate::screen::{Screen, visible};
use std::io::{BufRead, ErrorKind, IsTerminal, Write};
use std::path::Path;

/// Writes a script's pictures and models to disk.
pub(super) struct Disk;

impl Outlet for Disk {
    fn picture(&mut self, path: &str, screen: &Screen) -> Result<(), String> {
        let picture = screen_png(screen).map_err(|error| format!("{path}: {error}"))?;
        write_safely(Path::new(path), &picture).map_err(|error| format!("{path}: {}", reason(&error)))
    }

    fn text(&mut self, path: &str, text: &str) -> Result<(), String> {
        write_safely(Path::new(path), text.as_bytes()).map_err(|error| format!("{path}: {}", reason(&error)))
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
            _ => Failure::work(format!("{}: {}", path.display(), reason(&error))),
        }),
        None => {
            let mut stdout = std::io::stdout().lock();
            if stdout.is_terminal() && is_binary(content) {
                return Err(Failure::usage(BINARY));
            }
            let written = stdout.write_all(content).and_then(|()| stdout.flush());
            written.map_err(|error| match error.kind() {
                ErrorKind::BrokenPipe => Failure::unread(),
                _ => Failure::work(format!("standard output: {}", reason(&error))),
            })
        }
    }
}

/// What is said instead of filling a terminal with signs that are none.
const BINARY: &str = "this is not text, and standard output is a terminal: name a file, as in -o FILE, or redirect it, \
                      as in > FILE";

/// Whether this is no text: control characters of terminals count as none, beside tabs and ends of lines.
fn is_binary(content: &[u8]) -> bool {
    std::str::from_utf8(content).is_err()
        || content.iter().any(|byte| *byte < b' ' && !matches!(byte, b'\t' | b'\n' | b'\r'))
}

/// Writes a new file; one that is there already as the user wants: it is asked for in a terminal, and overwritten
/// elsewhere, unless an option says it.
///
/// # Errors
/// Those of [`write_output`]; that the file is there and shall stay.
pub fn write_new(path: &Path, content: &[u8], overwrite: &Overwrite) -> Result<(), Failure> {
    if path != Path::new("-") && path.is_file() && !overwrite.may(path) {
        let shown = path.display();
        return Err(Failure::work(format!(
            "{shown} is there already and stays as it is; --force overwrites it"
        )));
    }
    write_output(Some(path), content)
}

/// Whether files that are there are overwritten.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
pub struct Overwrite {
    /// Overwrite a file that is there, without asking
    #[arg(short, long, conflicts_with = "no_clobber")]
    force: bool,
    /// Leave a file that is there as it is [default: ask in a terminal, overwrite elsewhere]
    #[arg(short, long)]
    no_clobber: bool,
}

impl Overwrite {
    fn may(self, path: &Path) -> bool {
        let stdin = std::io::stdin();
        if self.force || self.no_clobber || !stdin.is_terminal() || !std::io::stderr().is_terminal() {
            return !self.no_clobber;
        }
        let question =
            format!("{} is there already. Overwrite it? [y/N] ", visible(&path.display().to_string()));
        let mut answer = String::new();
        let asked = std::io::stderr().write_all(question.as_bytes());
        asked.is_ok()
            && stdin.lock().read_line(&mut answer).is_ok()
            && matches!(answer.trim_start().chars().next(), Some('y' | 'Y' | 'i' | 'I'))
    }
}

/// Says something on stderr in one line: who says it, and what, with control characters escaped. Where nobody can be
/// told, nothing else fails.
pub fn say(who: &str, what: &str) {
    let line = what.split_whitespace().collect::<Vec<_>>().join(" ");
    let _ = std::io::stderr().write_all(format!("{who}: {}\n", visible(&line)).as_bytes());
}
