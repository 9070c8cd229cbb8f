//! A file with a cloud while it is read: piece by piece, so that one with millions of points shows how far it is and can
//! be stopped.

use super::texts;
use crate::file::{CloudFormat, CloudReader, TableOptions};
use crate::geometry::cloud::Cloud;
use crate::machine::{Storage, StorageProblem, Stream};
use crate::ui::Phrase;
use crate::ui::words;
use std::fmt;
use std::io::{ErrorKind, Read};

/// Bytes of a piece, which is read between two pictures.
const PIECE: usize = 1 << 18;

/// A file that is being read.
pub(super) struct Reading {
    pub(super) name: String,
    reader: CloudReader,
    content: Box<dyn Read>,
    length: Option<u64>,
    read: u64,
    piece: Vec<u8>,
}

impl fmt::Debug for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Reading").field("name", &self.name).finish_non_exhaustive()
    }
}

/// What a file held.
pub(super) struct Found {
    pub(super) cloud: Cloud,
    /// What is said about it.
    pub(super) told: Phrase,
}

impl Reading {
    /// Begins to read a file.
    ///
    /// # Errors
    /// There is no such file, or none of points.
    pub(super) fn begin(storage: &dyn Storage, name: &str) -> Result<Reading, Phrase> {
        let format = name.rsplit_once('.').and_then(|(_, extension)| CloudFormat::from_extension(extension));
        let format = format.ok_or(Phrase::from(texts::WHICH_FILES))?;
        let Stream { length, content } = storage.stream(name).map_err(|error| match error.problem {
            StorageProblem::NotFound => words::NO_SUCH_FILE.into(),
            _ => words::storage_problem(&error),
        })?;
        let reader = CloudReader::new(format, &TableOptions::default())
            .map_err(|error| words::in_file(name, &error))?;
        Ok(Reading { name: name.to_owned(), reader, content, length, read: 0, piece: vec![0; PIECE] })
    }

    /// The points so far.
    pub(super) fn points(&self) -> usize {
        self.reader.points().len()
    }

    /// How much is read, from 0 to 1, if the length is known.
    pub(super) fn progress(&self) -> Option<f64> {
        let length = self.length.filter(|length| *length > 0)?;
        Some((self.read as f64 / length as f64).min(1.0))
    }

    /// Reads the next piece; whether that was the last.
    ///
    /// # Errors
    /// What is wrong with the file, and where.
    pub(super) fn advance(&mut self) -> Result<bool, Phrase> {
        if self.reader.is_done() {
            return Ok(true);
        }
        let read = match self.content.read(&mut self.piece) {
            Ok(0) => return Ok(true),
            Ok(read) => read,
            Err(error) if error.kind() == ErrorKind::Interrupted => return Ok(false),
            Err(error) => return Err(Phrase::plain(&format!("{}: {error}", self.name))),
        };
        self.read += read as u64;
        let piece = self.piece.get(..read).unwrap_or_default();
        self.reader.feed(piece).map_err(|error| words::in_file(&self.name, &error))?;
        Ok(false)
    }

    /// The cloud, at the end.
    ///
    /// # Errors
    /// What is wrong with the file.
    pub(super) fn finish(self) -> Result<Found, Phrase> {
        let cloud = self.reader.finish().map_err(|error| words::in_file(&self.name, &error))?;
        let told = texts::file_told(&self.name, &cloud);
        let cloud = Cloud::new(cloud.points).map_err(|error| Phrase::plain(&error))?;
        Ok(Found { cloud, told })
    }
}
