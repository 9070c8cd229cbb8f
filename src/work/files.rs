//! The files of a document: the DOS file by its name, the tangents beside an `.IC2` file, and the JSON file that
//! holds what a DOS file cannot.

use crate::file::{Document, FileKind, Format, PlanePoints};
use crate::machine::{Storage, StorageProblem};
use crate::ui::words::{self, Phrase};

/// Files to be written: their names and contents.
pub(super) type Files = Vec<(String, Vec<u8>)>;

/// The same name with another extension.
fn twin(name: &str, extension: &str) -> String {
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    format!("{stem}.{extension}")
}

/// The name of the JSON file beside a file.
pub(super) fn json_name(name: &str) -> String {
    twin(name, "JSON")
}

/// Reads a file; one that is not there is told in the original's words.
pub(crate) fn read_content(storage: &dyn Storage, name: &str) -> Result<Vec<u8>, Phrase> {
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

/// The document of an `.IC2` file with the tangents of its twin, where there is one; others as they are.
pub fn with_twin(document: Document, storage: &dyn Storage, name: &str) -> Document {
    let is_ic2 = Format::from_name(name) == Some(Format::Ic2);
    match (document, is_ic2) {
        (Document::PlanePoints(plane), true) if plane.tangents.is_none() => {
            match read_document(storage, &twin(name, Format::Ec2.extension()), Format::Ec2) {
                Ok(Document::Tangents(tangents)) => Document::PlanePoints(plane.with_tangents(&tangents)),
                _ => Document::PlanePoints(plane),
            }
        }
        (document, _) => document,
    }
}

/// The document of the JSON file beside a DOS file, if that would be saved as this very file; else the document
/// as it is.
pub fn with_json(document: Document, storage: &dyn Storage, name: &str) -> Document {
    let Some(format) = Format::from_name(name) else { return document };
    let json = storage.read(&json_name(name)).ok();
    let json = json.and_then(|content| Document::decode(FileKind::Json, &content).ok());
    match json {
        Some(json) if dos_files(&json, format, name).is_ok_and(|files| all_there(storage, &files)) => json,
        _ => document,
    }
}

fn all_there(storage: &dyn Storage, files: &Files) -> bool {
    files.iter().all(|(name, content)| storage.read(name).is_ok_and(|there| there == *content))
}

/// The DOS files of a document, the first under its name: what they have room for.
///
/// # Errors
/// What is wrong with the points.
pub(super) fn dos_files(document: &Document, format: Format, name: &str) -> Result<Files, Phrase> {
    let bare = match document.clone().adapted(format).without_settings() {
        Document::PlanePoints(plane) => Document::PlanePoints(PlanePoints { joints: None, ..plane }),
        other => other,
    };
    let file = |format: Format, name: String| {
        let content = bare.write(format).map_err(|error| words::in_file(&name, &error))?;
        Ok::<_, Phrase>((name, content))
    };
    let mut files = vec![file(format, name.to_owned())?];
    if format == Format::Ic2 {
        files.push(file(Format::Ec2, twin(name, Format::Ec2.extension()))?);
    }
    Ok(files)
}
