//! What an installation has put into a folder, noted there in a file, so that it can be taken back.

use crate::disk::{read_regular, reason};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

/// The file of the notes.
pub(crate) const NAME: &str = ".telepit.json";

/// What was put into a folder.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Notes {
    /// Folders that were made; an empty name is the folder of all.
    pub(crate) folders: BTreeSet<String>,
    /// Files with what was in them.
    pub(crate) files: BTreeMap<String, Print>,
}

/// By what a file is known again.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Print {
    /// Where a link leads.
    Link(String),
    /// The length of a file and the sum of its bytes.
    File(u64, String),
}

impl Print {
    /// That of a file or link.
    pub(crate) fn of(path: &Path) -> io::Result<Print> {
        if fs::symlink_metadata(path)?.is_symlink() {
            return Ok(Print::Link(fs::read_link(path)?.to_string_lossy().into_owned()));
        }
        let mut file = File::open(path)?;
        let (mut length, mut sum) = (0, OFFSET);
        let mut piece = vec![0; 1 << 16];
        loop {
            let read = file.read(&mut piece)?;
            if read == 0 {
                return Ok(Print::File(length, format!("{sum:016x}")));
            }
            length += read as u64;
            for byte in piece.iter().take(read) {
                sum = (sum ^ u64::from(*byte)).wrapping_mul(PRIME);
            }
        }
    }
}

/// The numbers of the Fowler-Noll-Vo sum FNV-1a of 64 bits: it finds changes, and is no protection against forgery.
const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

impl Notes {
    /// The notes in a folder, if there are any.
    ///
    /// # Errors
    /// The system's, and that the notes cannot be understood.
    pub(crate) fn read(root: &Path) -> io::Result<Option<Notes>> {
        let text = match read_regular(&root.join(NAME)) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(error),
        };
        let wrong = |why: String| io::Error::new(io::ErrorKind::InvalidData, format!("{NAME}: {why}"));
        let notes: Notes = serde_json::from_slice(&text).map_err(|error| wrong(error.to_string()))?;
        let mut names = notes.folders.iter().chain(notes.files.keys());
        match names.find(|name| !stays_inside(Path::new(name))) {
            Some(name) => Err(wrong(format!("{name:?} is not in this folder"))),
            None => Ok(Some(notes)),
        }
    }

    /// Adds what was made in a folder.
    pub(crate) fn add<'a>(
        &mut self,
        root: &Path,
        folders: impl Iterator<Item = &'a Path>,
        files: &[PathBuf],
    ) -> io::Result<()> {
        self.folders.extend(folders.map(name));
        for path in files {
            let print = Print::of(&root.join(path))
                .map_err(|error| io::Error::other(format!("{}: {}", path.display(), reason(&error))))?;
            self.files.insert(name(path), print);
        }
        Ok(())
    }

    /// The notes as they are stored.
    pub(crate) fn text(&self) -> Vec<u8> {
        // Names and numbers are always JSON.
        serde_json::to_vec_pretty(self).unwrap_or_default()
    }
}

/// A path with the same signs on every system.
fn name(path: &Path) -> String {
    let parts = path.components().map(|part| part.as_os_str().to_string_lossy());
    parts.collect::<Vec<_>>().join("/")
}

fn stays_inside(path: &Path) -> bool {
    path.components().all(|part| matches!(part, Component::Normal(_)))
}

#[cfg(test)]
mod tests {
    use super::super::journal::tests::scratch;
    use super::*;

    #[test]
    fn notes_are_read_as_they_were_written() {
        let root = scratch("notes");
        fs::create_dir(root.join("A")).unwrap();
        fs::write(root.join("A/b"), b"a").unwrap();
        let mut notes = Notes::default();
        notes.add(&root, [Path::new(""), Path::new("A")].into_iter(), &["A/b".into()]).unwrap();
        // The sum of "a" as its authors give it.
        assert_eq!(notes.files["A/b"], Print::File(1, "af63dc4c8601ec8c".to_owned()));
        assert_eq!(Notes::read(&root).unwrap(), None);
        fs::write(root.join(NAME), notes.text()).unwrap();
        assert_eq!(Notes::read(&root).unwrap(), Some(notes));
        fs::remove_dir_all(root).unwrap();
    }

    #[test]
    fn notes_about_other_folders_are_refused() {
        let root = scratch("notes-out");
        for name in ["../a", "/etc/passwd", "a/../../b"] {
            let text = format!("{{\"folders\": [], \"files\": {{ {name:?}: {{ \"link\": \"x\" }} }} }}");
            fs::write(root.join(NAME), text).unwrap();
            assert!(Notes::read(&root).unwrap_err().to_string().contains("is not in this folder"), "{name}");
        }
        fs::write(root.join(NAME), "{").unwrap();
        assert!(Notes::read(&root).is_err());
        fs::remove_dir_all(root).unwrap();
    }
}
