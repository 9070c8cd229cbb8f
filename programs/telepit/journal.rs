//! A journal of changes to the disk, which can undo them: files and folders that were made, and files that were
//! set aside for others.

use crate::disk::reason;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// One thing that was done.
#[derive(Debug)]
enum Deed {
    /// A folder was made.
    Folder(PathBuf),
    /// A file or link was made where there was none.
    Made(PathBuf),
    /// A file was renamed, to be put back or to be removed at the end.
    SetAside { from: PathBuf, to: PathBuf },
}

/// All changes. They are undone if it is dropped before [`Journal::keep`].
#[derive(Debug, Default)]
pub(crate) struct Journal {
    deeds: Vec<Deed>,
}

impl Journal {
    /// Creates a folder and its missing parents.
    pub(crate) fn folder(&mut self, path: &Path) -> io::Result<()> {
        let missing: Vec<&Path> = path
            .ancestors()
            .take_while(|folder| !folder.as_os_str().is_empty() && fs::metadata(folder).is_err())
            .collect();
        for folder in missing.into_iter().rev() {
            // In "a/../b", the part "a/.." exists as soon as "a" does.
            if fs::metadata(folder).is_ok() {
                continue;
            }
            fs::create_dir(folder)?;
            self.deeds.push(Deed::Folder(folder.to_path_buf()));
        }
        match path.as_os_str().is_empty() || fs::metadata(path)?.is_dir() {
            true => Ok(()),
            false => Err(io::Error::new(io::ErrorKind::NotADirectory, "it is a file, not a folder")),
        }
    }

    /// Writes a new file, which must not exist, and makes it executable if asked to.
    pub(crate) fn write(&mut self, path: &Path, content: &[u8], executable: Executable) -> io::Result<()> {
        let mut file = File::create_new(path)?;
        self.deeds.push(Deed::Made(path.to_path_buf()));
        file.write_all(content)?;
        executable.apply(&file)?;
        file.sync_all()
    }

    /// Copies an executable to a path where nothing exists.
    pub(crate) fn copy(&mut self, path: &Path, from: &Path) -> io::Result<()> {
        let mut source = File::open(from)?;
        let mut file = File::create_new(path)?;
        self.deeds.push(Deed::Made(path.to_path_buf()));
        io::copy(&mut source, &mut file)?;
        Executable::Yes.apply(&file)?;
        file.sync_all()
    }

    /// The folders that were made.
    pub(crate) fn folders(&self) -> impl Iterator<Item = &Path> {
        self.deeds.iter().filter_map(|deed| match deed {
            Deed::Folder(path) => Some(path.as_path()),
            Deed::Made(_) | Deed::SetAside { .. } => None,
        })
    }

    /// Makes a symbolic link at a path where nothing exists.
    pub(crate) fn link(&mut self, path: &Path, target: &Path) -> io::Result<()> {
        symbolic_link(target, path)?;
        self.deeds.push(Deed::Made(path.to_path_buf()));
        Ok(())
    }

    /// Sets a file aside under an unused name in the same folder.
    pub(crate) fn set_aside(&mut self, path: &Path) -> io::Result<()> {
        let to = free_name(path)?;
        fs::rename(path, &to)?;
        self.deeds.push(Deed::SetAside { from: path.to_path_buf(), to });
        Ok(())
    }

    /// Undoes everything in reverse order, and returns what could not be undone.
    pub(crate) fn undo(&mut self) -> Vec<String> {
        let mut problems = Vec::new();
        while let Some(deed) = self.deeds.pop() {
            let (path, result) = match &deed {
                // Only if it is still empty.
                Deed::Folder(path) => (path, fs::remove_dir(path)),
                Deed::Made(path) => (path, fs::remove_file(path)),
                Deed::SetAside { from, to } => (from, fs::rename(to, from)),
            };
            if let Err(error) = result {
                problems.push(format!("{}: {}", path.display(), reason(&error)));
            }
        }
        problems
    }

    /// Keeps everything and removes what was set aside. Returns what could not be removed.
    pub(crate) fn keep(&mut self) -> Vec<String> {
        let deeds = std::mem::take(&mut self.deeds);
        let aside = deeds.into_iter().filter_map(|deed| match deed {
            Deed::SetAside { to, .. } => Some(to),
            Deed::Folder(_) | Deed::Made(_) => None,
        });
        let remove = |path: PathBuf| {
            fs::remove_file(&path).err().map(|error| format!("{}: {}", path.display(), reason(&error)))
        };
        aside.filter_map(remove).collect()
    }
}

impl Drop for Journal {
    fn drop(&mut self) {
        // Nobody is left to be told.
        let _ = self.undo();
    }
}

/// Whether a file can be started.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Executable {
    Yes,
    No,
}

impl Executable {
    #[cfg(unix)]
    fn apply(self, file: &File) -> io::Result<()> {
        use std::os::unix::fs::PermissionsExt;
        match self {
            // Whoever may read it, by the umask, may also run it.
            Executable::Yes => {
                let mode = file.metadata()?.permissions().mode();
                file.set_permissions(fs::Permissions::from_mode(mode | (mode & 0o444) >> 2))
            }
            Executable::No => Ok(()),
        }
    }

    #[cfg(not(unix))]
    fn apply(self, _: &File) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(unix)]
fn symbolic_link(target: &Path, path: &Path) -> io::Result<()> {
    std::os::unix::fs::symlink(target, path)
}

#[cfg(not(unix))]
fn symbolic_link(_: &Path, _: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// A name beside a file that nobody uses.
fn free_name(path: &Path) -> io::Result<PathBuf> {
    let process = std::process::id();
    (0..1000)
        .map(|number| path.with_file_name(format!(".telepit-{process}-{number}.old")))
        .find(|name| fs::symlink_metadata(name).is_err())
        .ok_or_else(|| io::Error::new(io::ErrorKind::AlreadyExists, "too many files were set aside here"))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// An empty folder for a test.
    pub(crate) fn scratch(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("telepit-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        path
    }

    /// Every file below a folder with its content, links with their target, folders with nothing.
    pub(crate) fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
        let mut found = Vec::new();
        for entry in fs::read_dir(folder).unwrap().flatten() {
            let path = entry.path();
            if let Ok(target) = fs::read_link(&path) {
                found.push((path, target.as_os_str().as_encoded_bytes().to_vec()));
            } else if path.is_dir() {
                found.extend(contents(&path));
                found.push((path, Vec::new()));
            } else {
                found.push((path.clone(), fs::read(path).unwrap()));
            }
        }
        found.sort();
        found
    }

    fn busy(journal: &mut Journal, folder: &Path) {
        journal.folder(&folder.join("a/b/c")).unwrap();
        journal.write(&folder.join("a/b/c/new"), b"new", Executable::No).unwrap();
        journal.set_aside(&folder.join("old")).unwrap();
        journal.write(&folder.join("old"), b"other", Executable::Yes).unwrap();
        #[cfg(unix)]
        journal.link(&folder.join("a/link"), Path::new("/nowhere")).unwrap();
    }

    #[test]
    fn undo_leaves_everything_as_it_was() {
        let folder = scratch("undo");
        fs::write(folder.join("old"), b"old").unwrap();
        let before = contents(&folder);
        let mut journal = Journal::default();
        busy(&mut journal, &folder);
        assert_ne!(contents(&folder), before);
        assert_eq!(journal.undo(), [""; 0]);
        assert_eq!(contents(&folder), before);
        busy(&mut journal, &folder);
        drop(journal);
        assert_eq!(contents(&folder), before);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn keep_leaves_nothing_aside() {
        let folder = scratch("keep");
        fs::write(folder.join("old"), b"old").unwrap();
        let mut journal = Journal::default();
        busy(&mut journal, &folder);
        assert_eq!(journal.keep(), [""; 0]);
        drop(journal);
        let names: Vec<_> =
            contents(&folder).into_iter().filter(|(_, content)| !content.is_empty()).collect();
        assert_eq!(names.len(), 2 + usize::from(cfg!(unix)));
        assert_eq!(fs::read(folder.join("old")).unwrap(), b"other");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_file_in_the_way_of_a_folder_or_file_is_an_error() {
        let folder = scratch("way");
        fs::write(folder.join("file"), b"old").unwrap();
        let mut journal = Journal::default();
        assert!(journal.folder(&folder.join("file/below")).is_err());
        assert!(journal.folder(&folder.join("file")).is_err());
        assert!(journal.write(&folder.join("file"), b"new", Executable::No).is_err());
        assert_eq!(journal.undo(), [""; 0]);
        assert_eq!(fs::read(folder.join("file")).unwrap(), b"old");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn paths_that_go_back_are_made_and_undone() {
        let folder = scratch("back");
        let mut journal = Journal::default();
        journal.folder(&folder.join("a/../b")).unwrap();
        assert!(folder.join("b").is_dir());
        journal.undo();
        assert_eq!(contents(&folder), []);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_others_put_into_a_new_folder_stays() {
        let folder = scratch("others");
        let mut journal = Journal::default();
        journal.folder(&folder.join("new")).unwrap();
        fs::write(folder.join("new/theirs"), b"theirs").unwrap();
        let problems = journal.undo();
        assert!(problems.len() == 1 && problems[0].contains("new"), "{problems:?}");
        assert_eq!(fs::read(folder.join("new/theirs")).unwrap(), b"theirs");
        fs::remove_dir_all(folder).unwrap();
    }
}
