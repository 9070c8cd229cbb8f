//! Finding and reading the file that a command line names.

use super::{Failure, cloud, meant};
use crate::disk::{Folder, LARGEST_FILE, open_stream, read_limited, read_stream, reason};
use crate::file::{Document, FileError, FileKind, Format, TABLES, TableOptions};
use crate::machine::{SAMPLES, Storage, StorageError, StorageProblem, Stream};
use crate::work::with_twin;
use std::io;
use std::path::{Path, PathBuf};

/// A document and its origin.
#[derive(Clone, Debug)]
pub struct Opened {
    /// The name as it was given.
    pub name: String,
    /// The name without the folder, of the file with the points if there are two.
    pub file_name: String,
    /// The folder it lies in, where the program will save.
    pub folder: PathBuf,
    /// What it holds.
    pub document: Document,
}

/// Opens a data file by its path. A bare name is looked up in the current folder first, whatever its
/// case, then among the built-in samples.
///
/// # Errors
/// [`Failure`] with the name and what is wrong: no such file, an unknown extension, a wrong content.
pub fn open(path: &Path) -> Result<Opened, Failure> {
    open_as(path, None, &TableOptions::default())
}

/// Like [`open`], with the kind of file if it is not to follow from the name, and what is said about a table. `-`
/// is standard input and needs a kind.
///
/// # Errors
/// Those of [`open`], `-` without a kind, and options of a table for another file.
pub fn open_as(path: &Path, from: Option<FileKind>, table: &TableOptions) -> Result<Opened, Failure> {
    open_for(path, from, table, Tables::Documents)
}

/// What the tables of a command line are read as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tables {
    /// Control points, unless there are too many.
    Documents,
    /// Clouds of points.
    Clouds,
}

/// Like [`open_as`], with what tables are.
pub(super) fn open_for(
    path: &Path,
    from: Option<FileKind>,
    table: &TableOptions,
    tables: Tables,
) -> Result<Opened, Failure> {
    if path == Path::new("-") {
        return open_stdin(from, table, tables);
    }
    open_in(&Folder::new(folder_of(path)), path, from, table, tables)
}

/// The folder of a path.
pub(super) fn folder_of(path: &Path) -> PathBuf {
    path.parent().map(Path::to_path_buf).unwrap_or_default()
}

/// Opens a data file by its path, through the storage of its folder.
pub(super) fn open_in(
    storage: &dyn Storage,
    path: &Path,
    from: Option<FileKind>,
    table: &TableOptions,
    tables: Tables,
) -> Result<Opened, Failure> {
    let name = path.display().to_string();
    if path.is_dir() {
        return Err(Failure::work(format!("{name}: this is a folder, not a file")));
    }
    let Some(file_name) = path.file_name().and_then(|name| name.to_str()) else {
        return Err(Failure::work(format!("{name:?} is not the name of a file")));
    };
    let folder = folder_of(path);
    let kind = from.or_else(|| input_kind(path)).map_or_else(|| kind_of(path), Ok)?;
    let document = match cloud::format_of(kind, tables == Tables::Clouds || is_large(path)) {
        Some(format) => {
            let stream = stream_of(storage, path, file_name)?;
            Document::Cloud(cloud::read(&name, stream, format, table)?)
        }
        None => {
            let content = content_of(storage, path, file_name)?;
            Document::decode_table(kind, &content, table).map_err(|error| failure(&name, &error))?
        }
    };
    let (document, file_name) = with_twin(document, storage, file_name);
    Ok(Opened { name, file_name, folder, document })
}

/// The content of the file at a path, through the storage of its folder, which knows names in any case and remembers
/// what was read. What the user names is read even if it is a pipe or a device.
fn content_of(storage: &dyn Storage, path: &Path, file_name: &str) -> Result<Vec<u8>, Failure> {
    of_path(storage, path, file_name, read_limited, |storage| storage.read(file_name))
}

/// The same, piece by piece.
fn stream_of(storage: &dyn Storage, path: &Path, file_name: &str) -> Result<Stream, Failure> {
    of_path(storage, path, file_name, open_stream, |storage| storage.stream(file_name))
}

fn of_path<T>(
    storage: &dyn Storage,
    path: &Path,
    file_name: &str,
    special: impl FnOnce(&Path) -> io::Result<T>,
    stored: impl FnOnce(&dyn Storage) -> Result<T, StorageError>,
) -> Result<T, Failure> {
    let failure = |problem: String| Failure::work(format!("{}: {problem}", path.display()));
    if std::fs::metadata(path).is_ok_and(|about| !about.is_file()) {
        return special(path).map_err(|error| failure(reason(&error)));
    }
    let bare = folder_of(path).as_os_str().is_empty();
    if !bare && storage.find(file_name).is_none() {
        return Err(failure("there is no such file".to_owned()));
    }
    stored(storage).map_err(|error| match &error.problem {
        StorageProblem::NotFound => {
            let samples = SAMPLES.iter().map(|(name, _)| *name);
            failure(format!(
                "there is no such file, neither in this folder nor among the built-in samples{}",
                meant(file_name, samples)
            ))
        }
        StorageProblem::System(message) => failure(message.clone()),
        StorageProblem::BadName(_) => Failure::work(error),
    })
}

/// Whether a file is larger than all but clouds of points.
pub(super) fn is_large(path: &Path) -> bool {
    std::fs::metadata(path).is_ok_and(|about| about.is_file() && about.len() > LARGEST_FILE)
}

/// Why a file is not read; options that it does not take are a matter of usage.
pub(super) fn failure(name: &str, error: &FileError) -> Failure {
    let message = format!("{name}: {error}");
    match error {
        FileError::NoTable { .. } => Failure::usage(message),
        _ => Failure::work(message),
    }
}

fn open_stdin(from: Option<FileKind>, table: &TableOptions, tables: Tables) -> Result<Opened, Failure> {
    let kind = from.ok_or_else(|| Failure::usage("- has no extension: say what comes, as in --from ip2"))?;
    let name = "standard input".to_owned();
    let document = match cloud::format_of(kind, tables == Tables::Clouds) {
        Some(format) => {
            let stream = Stream { length: None, content: Box::new(io::stdin()) };
            Document::Cloud(cloud::read(&name, stream, format, table)?)
        }
        None => {
            let content = read_stream(io::stdin().lock())
                .map_err(|error| Failure::work(format!("{name}: {}", reason(&error))))?;
            Document::decode_table(kind, &content, table).map_err(|error| failure(&name, &error))?
        }
    };
    Ok(Opened { name, file_name: String::new(), folder: PathBuf::new(), document })
}

/// The kind of a file that is read, by its name: also tables that are written under another one.
#[must_use]
pub fn input_kind(path: &Path) -> Option<FileKind> {
    path.extension().and_then(|extension| FileKind::from_input_extension(&extension.to_string_lossy()))
}

/// The kind of a file that is written, by its name.
///
/// # Errors
/// [`Failure`] that lists the extensions there are.
pub fn kind_of(path: &Path) -> Result<FileKind, Failure> {
    let name = path.display().to_string();
    FileKind::from_name(&name).ok_or_else(|| {
        let known: Vec<String> =
            Format::ALL.iter().map(|format| format!(".{}", format.extension())).collect();
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        let names = known.iter().map(String::as_str).chain([".json", ".csv"]);
        let alike = meant(&format!(".{extension}"), names);
        let (known, tables) = (known.join(" "), TABLES.join(" ."));
        Failure::work(format!(
            "{name}: no data file has this extension{alike}; there are {known} .json .csv, and for reading .{tables}"
        ))
    })
}
