//! The files of a document: the DOS file by its name, the tangents beside an `.IC2` file, and the JSON file that
//! holds what a DOS file cannot.

use crate::file::{Document, FileKind, Format, PlanePoints};
use crate::machine::{self, Standing, Storage, StorageProblem};
use crate::ui::words::{self, Phrase};

/// Files to be written: their names and contents.
pub type Files = Vec<(String, Vec<u8>)>;

/// The name with another extension, in lower case if the old extension is.
fn twin(name: &str, extension: &str) -> String {
    let (stem, old) = name.rsplit_once('.').unwrap_or((name, ""));
    let small = old.chars().any(char::is_lowercase);
    format!("{stem}.{}", if small { extension.to_lowercase() } else { extension.to_owned() })
}

/// The name of the JSON file beside a file.
pub(super) fn json_name(name: &str) -> String {
    twin(name, "JSON")
}

/// Reads a file; a missing one is reported in the original's words.
fn read_content(storage: &dyn Storage, name: &str) -> Result<Vec<u8>, Phrase> {
    storage.read(name).map_err(|error| match error.problem {
        StorageProblem::NotFound => words::NO_SUCH_FILE.into(),
        _ => words::storage_problem(&error),
    })
}

/// Reads a document of a format.
///
/// # Errors
/// What is wrong with the file.
pub fn read_document(storage: &dyn Storage, name: &str, format: Format) -> Result<Document, Phrase> {
    let content = read_content(storage, name)?;
    Document::read(format, &content).map_err(|error| words::in_file(name, &error))
}

/// The document of an `.IC2` file with the tangents of the `.EC2` file beside it, or the other way round, if there is
/// one, and the name of the file with the points; other documents unchanged.
pub fn with_twin(document: Document, storage: &dyn Storage, name: &str) -> (Document, String) {
    let beside = |format: Format| {
        let name = twin(name, format.extension());
        read_document(storage, &name, format).ok().map(|document| (document, name))
    };
    match (document, Format::from_name(name)) {
        (Document::PlanePoints(plane), Some(Format::Ic2)) if plane.tangents.is_none() => {
            let plane = match beside(Format::Ec2) {
                Some((Document::Tangents(tangents), _)) => plane.with_tangents(&tangents),
                _ => plane,
            };
            (Document::PlanePoints(plane), name.to_owned())
        }
        (Document::Tangents(tangents), Some(Format::Ec2)) => match beside(Format::Ic2) {
            Some((Document::PlanePoints(plane), name)) => {
                (Document::PlanePoints(plane.with_tangents(&tangents)), name)
            }
            _ => (Document::Tangents(tangents), name.to_owned()),
        },
        (document, _) => (document, name.to_owned()),
    }
}

/// The document of the JSON file beside a DOS file, if saving it would give exactly this file; otherwise the document
/// unchanged.
pub fn with_json(document: Document, storage: &dyn Storage, name: &str) -> Document {
    let Some(format) = Format::from_name(name).filter(|format| format.size().is_some()) else {
        return document;
    };
    let read = |name: &str| storage.read(name).ok();
    match beside(read, name, format) {
        Some((json, files)) if all_there(read, &files) => json,
        _ => document,
    }
}

/// Whether the JSON file beside a DOS file belongs to the present files, or to those about to be written. This does
/// not count as reading, so that changes by others are still noticed.
pub(super) fn has_json(disk: &machine::Files, name: &str, format: Format, new: &Files) -> bool {
    let read = |name: &str| match disk.standing(name) {
        Standing::Free => None,
        Standing::There(content) | Standing::Changed(content) => content,
    };
    beside(read, name, format).is_some_and(|(_, files)| files == *new || all_there(read, &files))
}

/// The document of the JSON file beside a DOS file, and the DOS files it would be saved as.
fn beside(read: impl Fn(&str) -> Option<Vec<u8>>, name: &str, format: Format) -> Option<(Document, Files)> {
    let json = Document::decode(FileKind::Json, &read(&json_name(name))?).ok()?;
    let files = dos_files(&json, format, name).ok()?;
    // Without tangents it would omit an `.EC2` file.
    let whole = format != Format::Ic2 || json.format() == Format::Ic2;
    whole.then_some((json, files))
}

fn all_there(read: impl Fn(&str) -> Option<Vec<u8>>, files: &Files) -> bool {
    files.iter().all(|(name, content)| read(name).as_ref() == Some(content))
}

/// A document as DOS files: the named file, and the `.EC2` file beside an `.IC2` file if there are tangents.
/// [`design::lost`](crate::design::lost) names what they omit.
///
/// # Errors
/// What is wrong with the points.
pub fn dos_files(document: &Document, format: Format, name: &str) -> Result<Files, Phrase> {
    if format.size().is_none() {
        let adapted = document.clone().adapted(format);
        let content = adapted.write(format).map_err(|error| words::in_file(name, &error))?;
        return Ok(vec![(name.to_owned(), content)]);
    }
    let bare = match document.clone().adapted(format).without_settings() {
        Document::PlanePoints(plane) => Document::PlanePoints(PlanePoints { joints: None, ..plane }),
        other => other,
    };
    let file = |format: Format, name: String| {
        let content = bare.write(format).map_err(|error| words::in_file(&name, &error))?;
        Ok::<_, Phrase>((name, content))
    };
    let mut files = vec![file(format, name.to_owned())?];
    let has_tangents = matches!(&bare, Document::PlanePoints(plane) if plane.tangents.is_some());
    if format == Format::Ic2 && has_tangents {
        files.push(file(Format::Ec2, twin(name, Format::Ec2.extension()))?);
    }
    Ok(files)
}
