//! Clouds of points from the files that a command line names. They are read piece by piece, whatever their size.

use super::open::{Tables, failure, input_kind, open_for};
use super::{Failure, progress};
use crate::disk::reason;
use crate::file::{Cloud, CloudFormat, CloudReader, Document, FileKind, Format, TableOptions};
use crate::machine::Stream;
use std::io::{ErrorKind, Read};
use std::path::Path;

/// The bytes that are read at a time.
const PIECE: usize = 1 << 18;
/// Files with more pieces show how far they have been read.
const MANY: u64 = 64;

/// The cloud of points in a file, also in one that holds points for something else: control points, or a table, in which
/// columns behind the coordinates are passed over. And the name of the file for messages.
///
/// # Errors
/// Those of [`open_as`](super::open_as), and that the file holds no points.
pub fn open_cloud(
    path: &Path,
    from: Option<FileKind>,
    table: &TableOptions,
) -> Result<(String, Cloud), Failure> {
    let kind = from.or_else(|| input_kind(path));
    let opened = open_for(path, kind, table, Tables::Clouds)?;
    match opened.document.adapted(Format::Xyz) {
        Document::Cloud(cloud) => Ok((opened.name, cloud)),
        other => {
            let found = other.format().english();
            let problem =
                format!("this is {found}; a cloud of points is needed, as .xyz .csv .ply .obj .stl hold it");
            Err(Failure::work(format!("{}: {problem}", opened.name)))
        }
    }
}

/// The format of the cloud that a file is, if it is one; a table may be.
pub(super) fn format_of(kind: FileKind, tables: bool) -> Option<CloudFormat> {
    match kind {
        FileKind::Dos(format) => CloudFormat::of(format),
        FileKind::Csv => tables.then_some(CloudFormat::Csv),
        FileKind::Json => None,
    }
}

/// Reads a cloud; `name` is for messages.
pub(super) fn read(
    name: &str,
    stream: Stream,
    format: CloudFormat,
    table: &TableOptions,
) -> Result<Cloud, Failure> {
    let mut reader = CloudReader::new(format, table).map_err(|error| failure(name, &error))?;
    let Stream { length, mut content } = stream;
    let pieces = length.map_or(0, |length| length.div_ceil(PIECE as u64));
    let bar =
        (pieces > MANY).then(|| progress::bar("reading", usize::try_from(pieces).unwrap_or(usize::MAX)));
    let mut piece = vec![0; PIECE];
    while !reader.is_done() {
        let length = match content.read(&mut piece) {
            Ok(0) => break,
            Ok(length) => length,
            Err(error) if error.kind() == ErrorKind::Interrupted => continue,
            Err(error) => return Err(Failure::work(format!("{name}: {}", reason(&error)))),
        };
        reader.feed(piece.get(..length).unwrap_or_default()).map_err(|error| failure(name, &error))?;
        if let Some(bar) = &bar {
            bar.advance();
        }
    }
    drop(bar);
    reader.finish().map_err(|error| failure(name, &error))
}
