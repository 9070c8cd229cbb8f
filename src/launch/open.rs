//! Finding and reading the file that a command line names.

use super::Failure;
use crate::file::{Document, Format};
use crate::machine::{Folder, Storage};
use std::path::{Path, PathBuf};

/// A document with where it came from.
#[derive(Clone, Debug)]
pub struct Opened {
    /// The name as it was given.
    pub name: String,
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
    let name = path.display().to_string();
    let Some(file_name) = path.file_name().and_then(|name| name.to_str()) else {
        return Err(Failure::work(format!("{name:?} is not the name of a file")));
    };
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let storage = Folder::new(&folder);
    let bare = folder.as_os_str().is_empty();
    if !bare && storage.find(file_name).is_none() {
        return Err(Failure::work(format!("{name}: there is no such file")));
    }
    let content = storage.read(file_name).map_err(|error| match bare {
        true => Failure::work(format!("{error}, neither in this folder nor among the built-in samples")),
        false => Failure::work(format!("{}: {error}", folder.display())),
    })?;
    let document =
        read(file_name, &content).map_err(|problem| Failure::work(format!("{name}: {problem}")))?;
    Ok(Opened { name, folder, document })
}

/// The document in the content of a file, by the extension of its name.
fn read(name: &str, content: &[u8]) -> Result<Document, String> {
    let is_json = Path::new(name).extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json"));
    if is_json {
        let text =
            std::str::from_utf8(content).map_err(|error| format!("JSON is UTF-8 text, but {error}"))?;
        return Document::from_json(text).map_err(|error| error.to_string());
    }
    let Some(format) = Format::from_name(name) else {
        let known: Vec<String> =
            Format::ALL.iter().map(|format| format!(".{}", format.extension())).collect();
        return Err(format!("no data file has this extension; there are {} and .json", known.join(" ")));
    };
    Document::read(format, content).map_err(|error| error.to_string())
}
