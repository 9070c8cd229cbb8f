//! The storage that is a folder on disk.

use super::read::open_regular;
use super::write::{is_open_for_reading, is_special};
use super::{read_regular, reason, write_safely};
use crate::machine::{Storage, StorageError, StorageProblem, Stream, check_name, sample_or_not_found};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The files of one folder.
#[derive(Clone, Debug)]
pub struct Folder {
    path: PathBuf,
    told: bool,
}

impl Folder {
    /// The folder of this path.
    pub fn new(path: impl Into<PathBuf>) -> Folder {
        Folder { path: path.into(), told: false }
    }

    /// The folder, which messages name; a script's pictures must not depend on it.
    #[must_use]
    pub fn told(self) -> Folder {
        Folder { told: true, ..self }
    }
}

fn system(name: &str, error: &io::Error) -> StorageError {
    StorageError { name: name.to_string(), problem: StorageProblem::System(reason(error)) }
}

/// What is read under a name that no file has.
fn not_here(name: &str) -> Result<Vec<u8>, StorageError> {
    check_name(name).and_then(|()| sample_or_not_found(name))
}

impl Storage for Folder {
    fn read(&self, name: &str) -> Result<Vec<u8>, StorageError> {
        let Some(found) = self.find(name) else { return not_here(name) };
        let path = self.path.join(found);
        read_regular(&path).map_err(|error| system(name, &error))
    }

    fn stream(&self, name: &str) -> Result<Stream, StorageError> {
        let Some(found) = self.find(name) else { return not_here(name).map(Stream::from) };
        open_regular(&self.path.join(found)).map_err(|error| system(name, &error))
    }

    fn write(&mut self, name: &str, content: &[u8]) -> Result<(), StorageError> {
        let stored = match self.find(name) {
            Some(stored) => stored,
            None => check_name(name).map(|()| name.to_string())?,
        };
        let path = self.path.join(stored);
        if fs::metadata(&path).is_ok_and(|about| is_special(&about)) {
            is_open_for_reading(&path).map_err(|error| system(name, &error))?;
        }
        write_safely(&path, content).map_err(|error| system(name, &error))
    }

    fn find(&self, name: &str) -> Option<String> {
        let is_there = |path: &Path| path.exists() && !path.is_dir();
        match check_name(name) {
            Ok(()) if is_there(&self.path.join(name)) => return Some(name.to_string()),
            // Such a name would not be that of the file, even if there is one.
            Err(_) if cfg!(windows) => return None,
            // Where such a file can be, it can be read.
            _ => {}
        }
        let entries = fs::read_dir(&self.path).ok()?;
        let names = entries.flatten().filter_map(|entry| entry.file_name().into_string().ok());
        // Sorted, so that of two names that differ in case only the same one is found every time.
        let mut same: Vec<String> = names.filter(|known| known.eq_ignore_ascii_case(name)).collect();
        same.sort();
        same.into_iter().find(|known| is_there(&self.path.join(known)))
    }

    fn place(&self) -> Option<String> {
        let place = if self.path.as_os_str().is_empty() { Path::new(".") } else { &self.path };
        let path = std::path::absolute(place).ok().filter(|_| self.told);
        path.map(|path| path.display().to_string())
    }

    fn names(&self) -> Vec<String> {
        let place = if self.path.as_os_str().is_empty() { Path::new(".") } else { &self.path };
        let Ok(entries) = fs::read_dir(place) else { return Vec::new() };
        let files = entries.flatten().filter(|entry| entry.path().is_file());
        files.filter_map(|entry| entry.file_name().into_string().ok()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scratch(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("grafika-folder-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        path
    }

    #[test]
    fn reads_in_any_case_and_writes_over_the_stored_name() {
        let path = scratch("case");
        fs::write(path.join("Six.ip2"), b"old").unwrap();
        let mut folder = Folder::new(&path);
        assert_eq!(folder.read("SIX.IP2").unwrap(), b"old");
        folder.write("SIX.IP2", b"new").unwrap();
        assert_eq!(fs::read(path.join("Six.ip2")).unwrap(), b"new");
        assert_eq!(fs::read_dir(&path).unwrap().count(), 1);
        fs::remove_dir_all(path).unwrap();
    }

    #[test]
    fn a_failed_write_leaves_the_old_file_whole() {
        let path = scratch("failed");
        let mut folder = Folder::new(&path);
        folder.write("A.IP2", b"old").unwrap();
        fs::create_dir(path.join("B.IP2")).unwrap();
        assert!(folder.write("B.IP2", b"new").is_err());
        let missing = path.join("missing");
        assert!(Folder::new(missing).write("A.IP2", b"new").is_err());
        assert_eq!(folder.read("A.IP2").unwrap(), b"old");
        assert_eq!(fs::read_dir(&path).unwrap().count(), 2);
        fs::remove_dir_all(path).unwrap();
    }

    #[test]
    fn a_name_that_windows_cannot_hold_is_read_and_not_made() {
        let path = scratch("names");
        let mut folder = Folder::new(&path);
        for name in ["a:b.ip2", "C:x", "NUL", "a.ip2.", "..", "a/b"] {
            assert!(
                folder.write(name, b"new").unwrap_err().to_string().contains("is no file name"),
                "{name}"
            );
            assert!(folder.read(name).is_err() && folder.find(name).is_none(), "{name}");
        }
        assert_eq!(fs::read_dir(&path).unwrap().count(), 0);
        #[cfg(unix)]
        {
            fs::write(path.join("a:b.ip2"), b"old").unwrap();
            assert_eq!(folder.read("A:B.IP2").unwrap(), b"old");
            folder.write("a:b.ip2", b"new").unwrap();
            assert_eq!(folder.read("a:b.ip2").unwrap(), b"new");
        }
        fs::remove_dir_all(path).unwrap();
    }

    #[test]
    fn a_write_protected_file_is_not_replaced() {
        let path = scratch("protected");
        let mut folder = Folder::new(&path);
        folder.write("A.IP2", b"old").unwrap();
        let file = path.join("A.IP2");
        let mut permissions = fs::metadata(&file).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&file, permissions).unwrap();
        let message = folder.write("A.IP2", b"new").unwrap_err().to_string();
        assert!(message.contains("write-protected"), "{message}");
        assert_eq!(folder.read("a.ip2").unwrap(), b"old");
        fs::remove_dir_all(path).unwrap();
    }
}
