//! What can be wrong with a data file.

use super::format::{Format, a_file};
use std::fmt;

/// Why bytes or text are no document, or a document does not go into a file.
///
/// The messages do not name the file; put its name and a colon in front.
#[derive(Clone, Debug, PartialEq)]
pub enum FileError {
    /// The file has not the size that every file of its format has.
    Size {
        /// The format that was expected.
        format: Format,
        /// The size of the file in bytes.
        found: usize,
    },
    /// A value in a DOS file cannot be.
    Value {
        /// Which value, in the user's terms: `point 3`.
        place: String,
        /// Where it is, in bytes from the start of the file.
        offset: usize,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// The values of a document do not belong together, wherever they came from.
    Invalid(String),
    /// The document holds what the file format cannot.
    Misfit {
        /// The format that was to be written.
        format: &'static str,
        /// What does not fit.
        problem: String,
    },
    /// Something is said about the columns or signs of a table, but the file holds none.
    NoTable {
        /// The command line's option.
        option: &'static str,
    },
    /// A JSON or CSV text is wrong.
    Text {
        /// The line, from 1.
        line: usize,
        /// The field and its index from 0 (`points[2][0]`) or the column; empty when there is none.
        place: String,
        /// What is wrong and what would be right.
        problem: String,
    },
}

impl FileError {
    /// A document that does not fit into a DOS file.
    pub(super) fn misfit(format: Format, problem: impl Into<String>) -> Self {
        Self::Misfit { format: format.extension(), problem: problem.into() }
    }

    /// A wrong value at a byte of a DOS file.
    pub(super) fn value(place: impl Into<String>, offset: usize, problem: impl Into<String>) -> Self {
        Self::Value { place: place.into(), offset, problem: problem.into() }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { format, found } => {
                let plural = if *found == 1 { "byte" } else { "bytes" };
                write!(f, "the file has {found} {plural}; {} has {}", a_file(*format), format.bytes())
            }
            Self::Value { place, offset, problem } => write!(f, "{place} (byte {offset}): {problem}"),
            Self::Invalid(problem) => f.write_str(problem),
            Self::Misfit { format, problem } => write!(f, "does not fit into .{format}: {problem}"),
            Self::NoTable { option } => {
                write!(f, "{option} is for tables of text, as in .csv; this file holds none")
            }
            Self::Text { line, place, problem } if place.is_empty() => write!(f, "line {line}: {problem}"),
            Self::Text { line, place, problem } => write!(f, "line {line}, {place}: {problem}"),
        }
    }
}

impl std::error::Error for FileError {}

impl From<crate::pascal::ShortRead> for FileError {
    fn from(error: crate::pascal::ShortRead) -> Self {
        Self::value("record", error.offset, error.to_string())
    }
}
