//! Where scripts and commands write: files named on the command line.

use super::{Failure, in_language, spoken};
use crate::disk::{reason, write_safely, write_safely_with};
use crate::figure::screen_png;
use crate::machine::Outlet;
use crate::screen::{Screen, visible};
use std::io::{self, BufRead, BufWriter, ErrorKind, IsTerminal, Write};
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
    let sort = if is_binary(content) { Sort::Binary } else { Sort::Text };
    output_with(sort, |stdout| Ok(stdout.write_all(content)?))
}

/// Writes a file that a command line names, whatever is there.
///
/// # Errors
/// [`Failure`] when it cannot be written; a reader that has gone away ends the command quietly.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), Failure> {
    file_with(path, |file| Ok(file.write_all(content)?))
}

/// What is written piece by piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// Text.
    Text,
    /// What no terminal shows.
    Binary,
}

/// Why a content breaks off that is written piece by piece.
#[derive(Debug)]
pub enum Broken {
    /// It cannot be written.
    Unwritten(io::Error),
    /// It has an end of its own.
    Failed(Failure),
}

impl From<io::Error> for Broken {
    fn from(error: io::Error) -> Broken {
        Broken::Unwritten(error)
    }
}

impl From<Failure> for Broken {
    fn from(failure: Failure) -> Broken {
        Broken::Failed(failure)
    }
}

impl Broken {
    fn into_failure(self, name: &str) -> Failure {
        match self {
            Broken::Failed(failure) => failure,
            Broken::Unwritten(error) if error.kind() == ErrorKind::BrokenPipe => Failure::unread(),
            Broken::Unwritten(error) => Failure::work(format!("{name}: {}", reason(&error))),
        }
    }
}

fn output_with(
    sort: Sort,
    content: impl FnOnce(&mut dyn Write) -> Result<(), Broken>,
) -> Result<(), Failure> {
    let stdout = io::stdout().lock();
    if sort == Sort::Binary && stdout.is_terminal() {
        return Err(Failure::usage(BINARY));
    }
    let mut pieces = BufWriter::with_capacity(PIECE, stdout);
    let written = content(&mut pieces).and_then(|()| Ok(pieces.flush()?));
    // What could not be written is not tried again.
    let _ = pieces.into_parts();
    written.map_err(|broken| broken.into_failure("standard output"))
}

fn file_with(path: &Path, content: impl FnOnce(&mut dyn Write) -> Result<(), Broken>) -> Result<(), Failure> {
    write_safely_with(path, content).map_err(|broken| broken.into_failure(&path.display().to_string()))
}

/// How much is written to standard output at a time.
const PIECE: usize = 1 << 16;

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

    /// Writes a content that need not stand in memory, piece by piece. A file gets its name when all of it is there.
    ///
    /// # Errors
    /// Those of [`Overwrite::write`], and what the content itself fails with.
    pub fn write_with(
        &self,
        sort: Sort,
        content: impl FnOnce(&mut dyn Write) -> Result<(), Broken>,
    ) -> Result<(), Failure> {
        match self.path {
            Some(path) if self.spares && path.is_file() => Err(stays(path)),
            Some(path) => file_with(path, content),
            None => output_with(sort, content),
        }
    }

    /// Whether what is written is seen at once, so that nothing else may be drawn there.
    #[must_use]
    pub fn is_seen(&self) -> bool {
        self.path.is_none() && io::stdout().is_terminal()
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
