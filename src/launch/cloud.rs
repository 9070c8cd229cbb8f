//! Clouds of points from the files that a command line names. They are read piece by piece, whatever their size.

use super::open::{Tables, failure, input_kind, is_large, open_for};
use super::{Failure, progress};
use crate::disk::{open_stream, reason};
use crate::file::{Cloud, CloudFormat, CloudReader, Document, FileKind, Format, Skipped, TableOptions};
use crate::machine::Stream;
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

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
    let reader = CloudReader::new(format, table).map_err(|error| failure(name, &error))?;
    read_by(name, stream, reader, |_| Ok(()))
}

/// Reads a cloud; between two pieces something is done with the reader.
fn read_by<E: From<Failure>>(
    name: &str,
    stream: Stream,
    mut reader: CloudReader,
    mut each: impl FnMut(&mut CloudReader) -> Result<(), E>,
) -> Result<Cloud, E> {
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
            Err(error) => return Err(Failure::work(format!("{name}: {}", reason(&error))).into()),
        };
        reader.feed(piece.get(..length).unwrap_or_default()).map_err(|error| failure(name, &error))?;
        each(&mut reader)?;
        if let Some(bar) = &bar {
            bar.advance();
        }
    }
    drop(bar);
    Ok(reader.finish().map_err(|error| failure(name, &error))?)
}

/// A cloud in a regular file, which is read as often as it is needed instead of standing in memory.
#[derive(Debug)]
pub struct CloudFile {
    path: PathBuf,
    format: CloudFormat,
    table: TableOptions,
}

/// What is known of a cloud that has been read once.
#[derive(Clone, Copy, Debug)]
pub struct CloudSurvey {
    /// How many points it has.
    pub count: usize,
    /// Whether all of them lie in the plane z = 0.
    pub plane: bool,
    /// What was left out.
    pub skipped: Skipped,
}

impl CloudFile {
    /// The file at a path, of a kind that is said or follows from its name, where tables are clouds or not. `None` if it is
    /// no regular file there, or one that is no cloud: [`open_cloud`] and [`open_as`](super::open_as) know what it is then.
    #[must_use]
    pub fn new(path: &Path, from: Option<FileKind>, table: &TableOptions, tables: bool) -> Option<CloudFile> {
        let format = format_of(from.or_else(|| input_kind(path))?, tables || is_large(path))?;
        let regular = std::fs::metadata(path).is_ok_and(|about| about.is_file());
        regular.then(|| CloudFile { path: path.to_path_buf(), format, table: table.clone() })
    }

    /// The name as it was given.
    #[must_use]
    pub fn name(&self) -> String {
        self.path.display().to_string()
    }

    /// Reads all of it once.
    ///
    /// # Errors
    /// Those of [`open_cloud`].
    pub fn survey(&self) -> Result<CloudSurvey, Failure> {
        let (mut count, mut plane) = (0, true);
        let skipped = self.points(|points| {
            count += points.len();
            plane &= points.iter().all(|&[_, _, z]| z == 0.0);
            Ok::<(), Failure>(())
        })?;
        Ok(CloudSurvey { count, plane, skipped })
    }

    /// Reads all of it, and gives the points piece by piece. Only the corners of STL, which tell what is equal, come in one
    /// piece.
    ///
    /// # Errors
    /// Those of [`open_cloud`], and what `each` fails with.
    pub fn points<E: From<Failure>>(
        &self,
        mut each: impl FnMut(&[[f64; 3]]) -> Result<(), E>,
    ) -> Result<Skipped, E> {
        let name = self.name();
        let stream =
            open_stream(&self.path).map_err(|error| Failure::work(format!("{name}: {}", reason(&error))))?;
        let reader = CloudReader::new(self.format, &self.table).map_err(|error| failure(&name, &error))?;
        let mut points = Vec::new();
        let rest = read_by(&name, stream, reader, |reader| {
            reader.take(&mut points);
            each(&points)
        })?;
        each(&rest.points)?;
        Ok(rest.skipped)
    }
}
