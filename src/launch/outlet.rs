//! Where scripts and commands write: files named on the command line.

use super::{Failure, in_language, spoken};
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

/// Writes an answer to standard output. What is no text is not written to a terminal.
///
/// # Errors
/// [`Failure`] when it cannot be written; a reader that has gone away ends the command quietly.
pub fn write_output(content: &[u8]) -> Result<(), Failure> {
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

/// Writes a file that a command line names, whatever is there.
///
/// # Errors
/// [`Failure`] when it cannot be written; a reader that has gone away ends the command quietly.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), Failure> {
    write_safely(path, content).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => Failure::unread(),
        _ => Failure::work(format!("{}: {}", path.display(), reason(&error))),
    })
}

/// What is said instead of filling a terminal with signs that are none.
const BINARY: &str = "this is not text, and standard output is a terminal: name a file, as in -o FILE, or redirect it, \
                      as in > FILE";

/// Whether this is no text: control characters count as none, beside tabs and ends of lines.
fn is_binary(content: &[u8]) -> bool {
    std::str::from_utf8(content).is_err()
        || content.iter().any(|byte| *byte < b' ' && !matches!(byte, b'\t' | b'\n' | b'\r'))
}

/// Whether files that are there are overwritten: every command that writes a file it is given has these options.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
pub struct Overwrite {
    /// Overwrite files that are there, without asking
    #[arg(short, long, conflicts_with = "no_clobber")]
    force: bool,
    /// Leave files that are there as they are; else a terminal asks, and elsewhere they are overwritten
    #[arg(short, long)]
    no_clobber: bool,
}

/// A place that may be written to.
#[derive(Debug)]
pub struct Target<'a> {
    /// Standard output, if none.
    path: Option<&'a Path>,
    /// Whether a file that has come in the meantime stays.
    spares: bool,
}

impl Overwrite {
    /// Writes a file, or to standard output where the name is `-` or there is none. A file that is there is asked for in
    /// a terminal, and overwritten elsewhere, unless an option says what to do.
    ///
    /// # Errors
    /// [`Failure`] when it cannot be written, or a file that is there shall stay; a reader that has gone away ends the
    /// command quietly.
    pub fn write(self, path: Option<&Path>, content: &[u8]) -> Result<(), Failure> {
        self.target(path)?.write(content)
    }

    /// The same question before long work, whose result is written in the end.
    ///
    /// # Errors
    /// [`Failure`] when a file that is there shall stay; when an option is for files and none is named.
    pub fn target(self, path: Option<&Path>) -> Result<Target<'_>, Failure> {
        let path = path.filter(|path| *path != Path::new("-"));
        match path {
            Some(path) if path.is_file() && !self.may(path) => Err(stays(path)),
            None if self.force || self.no_clobber => {
                let option = if self.force { "--force" } else { "--no-clobber" };
                Err(Failure::usage(format!(
                    "{option} is for files; this is written to standard output, as no file is named"
                )))
            }
            _ => Ok(Target { path, spares: self.no_clobber }),
        }
    }

    fn may(self, path: &Path) -> bool {
        let stdin = std::io::stdin();
        if self.force || self.no_clobber || !stdin.is_terminal() || !std::io::stderr().is_terminal() {
            return !self.no_clobber;
        }
        let question =
            format!("{} is there already. Overwrite it? [y/N]", visible(&path.display().to_string()));
        let question = format!("{} ", in_language(&question, spoken()));
        let mut answer = String::new();
        // Who sees no question gives no answer either.
        std::io::stderr().write_all(question.as_bytes()).is_ok()
            && stdin.lock().read_line(&mut answer).is_ok()
            && matches!(answer.trim_start().chars().next(), Some('y' | 'Y' | 'i' | 'I'))
    }
}

impl Target<'_> {
    /// Writes.
    ///
    /// # Errors
    /// Those of [`Overwrite::write`].
    pub fn write(&self, content: &[u8]) -> Result<(), Failure> {
        match self.path {
            Some(path) if self.spares && path.is_file() => Err(stays(path)),
            Some(path) => write_file(path, content),
            None => write_output(content),
        }
    }
}

fn stays(path: &Path) -> Failure {
    Failure::work(format!("{} is there already and stays as it is; --force overwrites it", path.display()))
}

/// Writes an answer in words to standard output, in the user's language.
///
/// # Errors
/// Those of [`write_output`].
pub fn answer(text: &str) -> Result<(), Failure> {
    write_output(in_language(text, spoken()).as_bytes())
}

/// Says something on stderr in one line and in the user's language: who says it, and what, with control characters
/// escaped. Where nobody can be told, nothing else fails.
pub fn say(who: &str, what: &str) {
    let line = what.split_whitespace().collect::<Vec<_>>().join(" ");
    let line = in_language(&line, spoken());
    let _ = std::io::stderr().write_all(format!("{who}: {}\n", visible(&line)).as_bytes());
}
