//! Writing files so that nothing is lost, whenever the machine stops.

use super::reason;
use std::fs::{self, File, TryLockError};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What the names of temporary files begin and end with.
const TEMPORARY: [&str; 2] = [".grafika-", ".tmp"];
/// How much of a file is written at a time.
const PIECE: usize = 1 << 16;
/// The age from which a temporary file that nobody holds locked is removed: its process locks it right after making it.
const UNLOCKED: Duration = Duration::from_secs(1);
/// The age from which a temporary file is removed where files cannot be locked.
const STALE: Duration = Duration::from_secs(24 * 60 * 60);

/// Writes a file by way of a temporary one in the same folder, which is flushed and renamed, so that a
/// crash leaves the old file or the new one, and a full disk leaves the old one. The file keeps its permissions, and
/// a link stays a link: what it points to is replaced.
///
/// What is there but is no regular file, a pipe or a device, is opened and written instead. A pipe waits for its
/// reader.
///
/// # Errors
/// The system's error; the old file is whole then and the temporary one is gone.
pub fn write_safely(path: &Path, content: &[u8]) -> io::Result<()> {
    write_safely_with(path, |file| file.write_all(content))
}

/// Like [`write_safely`], of a content that need not stand in memory: it is written piece by piece.
///
/// # Errors
/// Those of [`write_safely`], and what the content itself fails with: the old file is whole then too.
pub fn write_safely_with<E: From<io::Error>>(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    write(path, content, Access::Usual)
}

/// Like [`write_safely`]; a new file can be read by its user alone.
pub(super) fn write_private(path: &Path, content: &[u8]) -> io::Result<()> {
    write(path, |file| file.write_all(content), Access::Private)
}

/// Who may read a new file.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Access {
    /// Those who may read any new file.
    Usual,
    /// The user alone.
    Private,
}

fn write<E: From<io::Error>>(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    access: Access,
) -> Result<(), E> {
    let old = fs::metadata(path).ok();
    if old.as_ref().is_some_and(is_special) {
        return buffered(&File::options().write(true).open(path)?, content);
    }
    if old.as_ref().is_some_and(|old| old.permissions().readonly()) {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is write-protected").into());
    }
    let target = behind_links(path)?;
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    clear_temporaries(folder);
    let permissions = old.map(|old| old.permissions());
    let mut options = File::options();
    options.write(true).create_new(true);
    #[cfg(unix)]
    {
        // Nobody may read the new file, even half-written, who may not read the old one.
        use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};
        let private = (access == Access::Private).then_some(0o600);
        if let Some(mode) = permissions.as_ref().map(PermissionsExt::mode).or(private) {
            options.mode(mode);
        }
    }
    #[cfg(not(unix))]
    let _ = access;
    let mut naming = tempfile::Builder::new();
    naming.prefix(TEMPORARY[0]).suffix(TEMPORARY[1]);
    // Dropped, it is gone.
    let file = naming.make_in(folder, |path| options.open(path)).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => missing(folder, &error),
        _ => error,
    })?;
    // The lock ends with the process, and tells others whether the file is still being written. Where there are no
    // locks, its age tells.
    let _ = file.as_file().try_lock();
    buffered(file.as_file(), content)?;
    if let Some(permissions) = permissions {
        file.as_file().set_permissions(permissions)?;
    }
    file.as_file().sync_all()?;
    file.persist(&target).map_err(|failed| failed.error)?;
    // The new name is on the disk only when the folder is; where folders cannot be flushed, nothing is lost.
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
    Ok(())
}

/// Writes a content into an open file in pieces of some size.
fn buffered<E: From<io::Error>>(
    file: &File,
    content: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    let mut pieces = BufWriter::with_capacity(PIECE, file);
    content(&mut pieces)?;
    Ok(pieces.flush()?)
}

/// Whether this is neither a file nor a folder: a pipe, a device, a socket.
pub(super) fn is_special(about: &fs::Metadata) -> bool {
    !about.is_file() && !about.is_dir()
}

/// Whether somebody is there to read what is written to a path that [is special](is_special): writing to a pipe without
/// a reader waits for one.
pub(super) fn is_open_for_reading(path: &Path) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        // The flag has the same bits in either type.
        let at_once = rustix::fs::OFlags::NONBLOCK.bits() as i32;
        File::options().write(true).custom_flags(at_once).open(path).map_err(|error| {
            match error.raw_os_error() == Some(rustix::io::Errno::NXIO.raw_os_error()) {
                true => io::Error::other("this is a pipe, and nobody reads from it"),
                false => error,
            }
        })?;
    }
    #[cfg(not(unix))]
    let _ = path;
    Ok(())
}

/// A new file that is written little by little; one that is there is emptied.
///
/// # Errors
/// The system's.
pub fn create(path: &Path) -> io::Result<File> {
    File::create(path).map_err(|error| match (error.kind(), path.parent()) {
        (io::ErrorKind::NotFound, Some(folder)) => missing(folder, &error),
        _ => error,
    })
}

/// What is said where the folder of a file is missing. Some that are there hold no files of ours either, as those of
/// `/proc`.
fn missing(folder: &Path, error: &io::Error) -> io::Error {
    let (empty, named) = (folder.as_os_str().is_empty(), folder.display());
    let text = match empty || folder.is_dir() {
        true if empty => format!("it cannot be written; the system says: {}", reason(error)),
        true => format!("it cannot be written into the folder {named}; the system says: {}", reason(error)),
        false => format!("there is no folder {named}"),
    };
    io::Error::new(io::ErrorKind::NotFound, text)
}

/// Where a path leads to: the file itself, or where it would be behind links that lead to nothing yet.
fn behind_links(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_path_buf();
    loop {
        match fs::canonicalize(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            // Links that lead in a circle are an error of this kind.
            found => return found,
        }
        let Ok(next) = fs::read_link(&path) else { return Ok(path) };
        path = path.parent().unwrap_or(Path::new("")).join(next);
    }
}

/// Removes the temporary files of processes that broke off.
pub(super) fn clear_temporaries(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let ours = |entry: &fs::DirEntry| {
        let name = entry.file_name();
        name.to_str().is_some_and(|name| name.starts_with(TEMPORARY[0]) && name.ends_with(TEMPORARY[1]))
    };
    for entry in entries.flatten().filter(ours) {
        let abandoned = |about: fs::Metadata| {
            about.is_file()
                && is_older(&about, UNLOCKED)
                && (is_older(&about, STALE) || !is_locked(&entry.path()).unwrap_or(true))
        };
        if entry.metadata().is_ok_and(abandoned) {
            // What cannot be removed is only untidy.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Whether a process holds a regular file locked.
pub(super) fn is_locked(path: &Path) -> io::Result<bool> {
    match File::open(path)?.try_lock() {
        Ok(()) => Ok(false),
        Err(TryLockError::WouldBlock) => Ok(true),
        Err(TryLockError::Error(error)) => Err(error),
    }
}

/// Whether a file was written last longer ago than a time, if the clocks tell.
pub(super) fn is_older(about: &fs::Metadata, age: Duration) -> bool {
    about.modified().ok().and_then(|time| time.elapsed().ok()).is_some_and(|passed| passed > age)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::SystemTime;

    /// A scratch folder, gone at the end.
    fn scratch() -> tempfile::TempDir {
        tempfile::tempdir().unwrap()
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap().flatten();
        let mut names: Vec<String> = entries.map(|entry| entry.file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_failed_write_leaves_nothing_behind() {
        let folder = scratch();
        fs::create_dir(folder.path().join("a")).unwrap();
        assert!(write_safely(&folder.path().join("a"), b"new").is_err());
        let missing = write_safely(&folder.path().join("b").join("c"), b"new").unwrap_err();
        assert_eq!(missing.kind(), io::ErrorKind::NotFound);
        assert!(!missing.to_string().contains(TEMPORARY[0]), "nobody knows that name: {missing}");
        assert_eq!(names(folder.path()), ["a"]);
    }

    #[test]
    fn a_content_that_breaks_off_leaves_the_old_file() {
        let folder = scratch();
        let path = folder.path().join("a");
        fs::write(&path, "old").unwrap();
        let broken = write_safely_with(&path, |file| {
            // More than is written at a time.
            file.write_all(&vec![7; 3 * PIECE])?;
            Err(io::Error::other("no more"))
        });
        assert_eq!(broken.unwrap_err().to_string(), "no more");
        assert_eq!((fs::read(&path).unwrap(), names(folder.path())), (b"old".to_vec(), vec!["a".to_owned()]));
        write_safely_with(&path, |file| (0..PIECE).try_for_each(|_| file.write_all(b"new"))).unwrap();
        assert!(fs::read(&path).unwrap() == b"new".repeat(PIECE));
    }

    #[test]
    fn temporary_files_that_nobody_writes_go() {
        let folder = scratch();
        let make = |name: &str, age| {
            let file = File::create(folder.path().join(name)).unwrap();
            file.set_modified(SystemTime::now() - Duration::from_secs(age)).unwrap();
            file
        };
        let held = make(".grafika-held.tmp", 60);
        held.lock().unwrap();
        make(".grafika-left.tmp", 60);
        make(".grafika-new.tmp", 0);
        make("old.tmp", 100_000);
        write_safely(&folder.path().join("a"), b"new").unwrap();
        assert_eq!(names(folder.path()), [".grafika-held.tmp", ".grafika-new.tmp", "a", "old.tmp"]);
    }

    #[cfg(unix)]
    mod unix {
        use super::*;
        use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};

        #[test]
        fn permissions_stay_and_new_files_have_those_of_any_new_file() {
            let folder = scratch();
            let [own, any, new] = ["own", "any", "new"].map(|name| folder.path().join(name));
            for (path, mode) in [(&own, 0o600), (&any, 0o666)] {
                fs::write(path, "old").unwrap();
                fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
                write_safely(path, b"new").unwrap();
                assert_eq!(fs::metadata(path).unwrap().permissions().mode() & 0o7777, mode);
            }
            write_safely(&new, b"new").unwrap();
            let usual = File::create(folder.path().join("usual")).unwrap().metadata().unwrap();
            assert_eq!(fs::metadata(&new).unwrap().mode(), usual.mode());
        }

        #[test]
        fn links_stay_links() {
            let folder = scratch();
            let at = |name: &str| folder.path().join(name);
            fs::create_dir(at("there")).unwrap();
            fs::write(at("there/file"), "old").unwrap();
            symlink("there/file", at("link")).unwrap();
            symlink("link", at("second")).unwrap();
            // It leads to what is not there yet.
            symlink("there/new", at("future")).unwrap();
            symlink("circle", at("circle")).unwrap();
            write_safely(&at("second"), b"second").unwrap();
            write_safely(&at("future"), b"future").unwrap();
            assert!(write_safely(&at("circle"), b"circle").is_err());
            assert_eq!(fs::read(at("there/file")).unwrap(), b"second");
            assert_eq!(fs::read(at("there/new")).unwrap(), b"future");
            assert!(["link", "second", "future", "circle"].iter().all(|name| at(name).is_symlink()));
        }

        #[test]
        fn pipes_and_devices_are_written_and_stay() {
            let folder = scratch();
            let pipe = folder.path().join("pipe");
            let made = std::process::Command::new("mkfifo").arg(&pipe).status().unwrap();
            assert!(made.success());
            let reader = std::thread::spawn({
                let pipe = pipe.clone();
                move || fs::read(pipe).unwrap()
            });
            let content = vec![7; 200_000];
            write_safely(&pipe, &content).unwrap();
            assert!(reader.join().unwrap() == content);
            assert_eq!(names(folder.path()), ["pipe"]);
            write_safely(Path::new("/dev/null"), b"new").unwrap();
            assert!(!fs::metadata("/dev/null").unwrap().is_file());
            let socket = folder.path().join("socket");
            let _listens = std::os::unix::net::UnixListener::bind(&socket).unwrap();
            assert!(write_safely(&socket, b"new").is_err());
            assert_eq!(names(folder.path()), ["pipe", "socket"]);
        }
    }
}
