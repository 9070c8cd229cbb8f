//! The storage that is a folder on disk.

use super::storage::{Storage, StorageError, StorageProblem, check_name, sample_or_not_found};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// More than any data file can have; a larger file is refused before it fills the memory.
pub const LARGEST_FILE: u64 = 64 * 1024 * 1024;

/// The files of one folder.
#[derive(Clone, Debug)]
pub struct Folder {
    path: PathBuf,
}

impl Folder {
    /// The folder of this path.
    pub fn new(path: impl Into<PathBuf>) -> Folder {
        Folder { path: path.into() }
    }
}

fn system(name: &str, error: &io::Error) -> StorageError {
    StorageError { name: name.to_string(), problem: StorageProblem::System(error.to_string()) }
}

impl Storage for Folder {
    fn read(&self, name: &str) -> Result<Vec<u8>, StorageError> {
        check_name(name)?;
        let Some(found) = self.find(name) else { return sample_or_not_found(name) };
        let path = self.path.join(found);
        let size = fs::metadata(&path).map_err(|error| system(name, &error))?.len();
        if size > LARGEST_FILE {
            let message = format!("the file has {size} bytes; no data file has more than {LARGEST_FILE}");
            return Err(StorageError { name: name.to_string(), problem: StorageProblem::System(message) });
        }
        fs::read(path).map_err(|error| system(name, &error))
    }

    fn write(&mut self, name: &str, content: &[u8]) -> Result<(), StorageError> {
        check_name(name)?;
        let stored = self.find(name).unwrap_or_else(|| name.to_string());
        write_safely(&self.path.join(stored), content).map_err(|error| system(name, &error))
    }

    fn find(&self, name: &str) -> Option<String> {
        let exact = self.path.join(name);
        if check_name(name).is_ok() && exact.is_file() {
            return Some(name.to_string());
        }
        let entries = fs::read_dir(&self.path).ok()?;
        let names = entries.flatten().filter_map(|entry| entry.file_name().into_string().ok());
        // Sorted, so that of two names that differ in case only the same one is found every time.
        let mut same: Vec<String> = names.filter(|known| known.eq_ignore_ascii_case(name)).collect();
        same.sort();
        same.into_iter().find(|known| self.path.join(known).is_file())
    }
}

/// Writes a file by way of a temporary one in the same folder, which is flushed and renamed, so that a
/// crash leaves the old file or the new one, and a full disk leaves the old one.
///
/// # Errors
/// The system's error; the old file is whole then and the temporary one is gone.
pub fn write_safely(path: &Path, content: &[u8]) -> io::Result<()> {
    // A link stays a link: what it points to is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    if let Ok(old) = fs::metadata(&target)
        && old.permissions().readonly()
    {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is write-protected"));
    }
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let (mut file, temporary) = create_temporary(folder)?;
    let written = file
        .write_all(content)
        .and_then(|()| keep_permissions(&target, &file))
        .and_then(|()| file.sync_all())
        .and_then(|()| fs::rename(&temporary, &target));
    if written.is_err() {
        // The first error is the one worth telling; a leftover file would only be untidy.
        let _ = fs::remove_file(&temporary);
    }
    written?;
    // The new name is on the disk only when the folder is; where folders cannot be flushed, nothing is lost.
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
    Ok(())
}

/// A new file of a name that nobody uses.
fn create_temporary(folder: &Path) -> io::Result<(File, PathBuf)> {
    let process = std::process::id();
    let mut number = 0u32;
    loop {
        let path = folder.join(format!(".grafika-{process}-{number}.tmp"));
        match File::create_new(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && number < 1000 => number += 1,
            result => return result.map(|file| (file, path)),
        }
    }
}

fn keep_permissions(old: &Path, new: &File) -> io::Result<()> {
    match fs::metadata(old) {
        Ok(metadata) => new.set_permissions(metadata.permissions()),
        Err(_) => Ok(()),
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
