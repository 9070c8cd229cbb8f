//! Finding and reading the file that a command line names.

use super::Failure;
use crate::disk::{Folder, LARGEST_FILE};
use crate::file::{Document, FileError, FileKind, Format, TABLES, TableOptions};
use crate::machine::Storage;
use crate::work::with_twin;
use std::io::Read;
use std::path::{Path, PathBuf};

/// A document and where it came from.
#[derive(Clone, Debug)]
pub struct Opened {
    /// The name as it was given.
    pub name: String,
    /// The name without the folder.
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
    if path == Path::new("-") {
        return open_stdin(from, table);
    }
    open_in(&Folder::new(folder_of(path)), path, from, table)
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
) -> Result<Opened, Failure> {
    let name = path.display().to_string();
    let Some(file_name) = path.file_name().and_then(|name| name.to_str()) else {
        return Err(Failure::work(format!("{name:?} is not the name of a file")));
    };
    let folder = folder_of(path);
    let bare = folder.as_os_str().is_empty();
    if !bare && storage.find(file_name).is_none() {
        return Err(Failure::work(format!("{name}: there is no such file")));
    }
    let content = storage.read(file_name).map_err(|error| match bare {
        true => Failure::work(format!("{error}, neither in this folder nor among the built-in samples")),
        false => Failure::work(format!("{}: {error}", folder.display())),
    })?;
    let kind = from.or_else(|| input_kind(path)).map_or_else(|| kind_of(path), Ok)?;
    let document = Document::decode_table(kind, &content, table).map_err(|error| failure(&name, &error))?;
    let document = with_twin(document, storage, file_name);
    Ok(Opened { name, file_name: file_name.to_string(), folder, document })
}

/// Why a file is not read; options that it does not take are a matter of usage.
fn failure(name: &str, error: &FileError) -> Failure {
    let message = format!("{name}: {error}");
    match error {
        FileError::NoTable { .. } => Failure::usage(message),
        _ => Failure::work(message),
    }
}

fn open_stdin(from: Option<FileKind>, table: &TableOptions) -> Result<Opened, Failure> {
    let kind = from.ok_or_else(|| Failure::usage("- has no extension: say what comes, as in --from ip2"))?;
    let name = "standard input".to_owned();
    let content = read_stdin().map_err(|error| Failure::work(format!("{name}: {error}")))?;
    let document = Document::decode_table(kind, &content, table).map_err(|error| failure(&name, &error))?;
    Ok(Opened { name, file_name: String::new(), folder: PathBuf::new(), document })
}

/// All of standard input, up to the size of the largest data file.
///
/// # Errors
/// The system's, or that there is more.
pub fn read_stdin() -> std::io::Result<Vec<u8>> {
    let mut content = Vec::new();
    std::io::stdin().lock().take(LARGEST_FILE + 1).read_to_end(&mut content)?;
    if content.len() as u64 > LARGEST_FILE {
        return Err(std::io::Error::other(format!("it is longer than any data file ({LARGEST_FILE} bytes)")));
    }
    Ok(content)
}

/// The kind of a file that is read, by its name: also tables that are written under another one.
fn input_kind(path: &Path) -> Option<FileKind> {
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
        let (known, tables) = (known.join(" "), TABLES.join(" ."));
        Failure::work(format!(
            "{name}: no data file has this extension; there are {known} .json .csv, and for reading .{tables}"
        ))
    })
}
