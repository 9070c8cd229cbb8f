//! A file of unsaved work and the lock beside it.

use super::super::write::{clear_temporaries, is_locked, is_older, write_private};
use super::super::{read_regular, reason};
use crate::machine::Work;
use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The age at which locks of broken-off sessions without unsaved work are cleared away.
const LEFTOVER: Duration = Duration::from_secs(24 * 60 * 60);
/// What the files of unsaved work end with.
pub(super) const WORK: &str = ".unsaved";
/// What is added to the names of those that cannot be read.
const BROKEN: &str = ".broken";
/// What the locks beside them end with.
const LOCK: &str = ".lock";

/// The first line of a file; the work follows.
#[derive(Serialize, Deserialize)]
struct Head {
    unsaved_work_of: String,
    version: u32,
    file: Option<String>,
}

const VERSION: u32 = 1;

/// A file of unsaved work that nobody else may touch, because the lock beside it is held.
pub(super) struct Place {
    pub(super) work: PathBuf,
    lock: PathBuf,
    _held: File,
}

impl Place {
    /// A place that nobody uses.
    pub(super) fn new(folder: &Path, program: &str) -> io::Result<Place> {
        make_private_folder(folder)?;
        let process = std::process::id();
        for number in 0..1000 {
            let name = format!("{program}-{process}-{number}");
            let [work, lock] = [WORK, LOCK].map(|ending| folder.join(format!("{name}{ending}")));
            let held = match File::create_new(&lock) {
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => continue,
                created => created?,
            };
            match held.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => continue,
                Err(TryLockError::Error(error)) => {
                    let _ = fs::remove_file(&lock);
                    return Err(error);
                }
            }
            if !work.exists() {
                return Ok(Place { work, lock, _held: held });
            }
            // An earlier process of the same number has left its work without a lock.
            let _ = fs::remove_file(&lock);
        }
        Err(io::Error::new(io::ErrorKind::AlreadyExists, "all names are taken"))
    }

    /// The place of a file that a session has left behind; `None` if its session still runs.
    pub(super) fn taken_over(work: PathBuf) -> io::Result<Option<Place>> {
        let lock = work.with_extension(LOCK.trim_start_matches('.'));
        if fs::metadata(&lock).is_ok_and(|about| !about.is_file()) {
            // Opening a pipe would wait for its other end.
            return Err(io::Error::other(format!("{} is no regular file", lock.display())));
        }
        let held = File::options().read(true).write(true).create(true).truncate(false).open(&lock)?;
        match held.try_lock() {
            Ok(()) => Ok(Some(Place { work, lock, _held: held })),
            Err(TryLockError::WouldBlock) => Ok(None),
            Err(TryLockError::Error(error)) => Err(error),
        }
    }

    /// The work in the file; `None` if the file is gone.
    pub(super) fn read(&self, program: &str) -> Result<Option<Work>, String> {
        let content = match read_regular(&self.work) {
            Ok(content) => content,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(reason(&error)),
        };
        let text = String::from_utf8(content).map_err(|_| "it is no text".to_string())?;
        let (head, content) = text.split_once('\n').ok_or("its first line has no end")?;
        let head: Head = serde_json::from_str(head).map_err(|error| format!("its first line: {error}"))?;
        if head.unsaved_work_of != program {
            return Err(format!("it is work of {:?}, not of {program:?}", head.unsaved_work_of));
        }
        if head.version != VERSION {
            return Err(format!("it is of version {}; this program knows version {VERSION}", head.version));
        }
        Ok(Some(Work { program: head.unsaved_work_of, file: head.file, content: content.to_string() }))
    }

    /// Writes work into the file, so that a crash leaves the work before or this.
    pub(super) fn write(&self, work: &Work) -> io::Result<()> {
        let head = Head { unsaved_work_of: work.program.clone(), version: VERSION, file: work.file.clone() };
        let head = serde_json::to_string(&head)?;
        write_private(&self.work, format!("{head}\n{}", work.content).as_bytes())
    }

    /// Removes the work and then its lock.
    pub(super) fn remove(self) {
        // What cannot be removed is offered again at the next start, which is the right thing to do.
        if fs::remove_file(&self.work).is_ok() || !self.work.exists() {
            let _ = fs::remove_file(&self.lock);
        }
    }

    /// Gives the file a name under which it is not offered again; a free one, for an earlier broken file may
    /// be worth as much.
    pub(super) fn set_aside(self) {
        let name = |number: u32| {
            let mut name = OsString::from(&self.work);
            name.push(if number == 0 { BROKEN.to_string() } else { format!("{BROKEN}{number}") });
            PathBuf::from(name)
        };
        let free = (0..1000).map(name).find(|path| !path.exists());
        if free.is_some_and(|free| fs::rename(&self.work, free).is_ok()) {
            let _ = fs::remove_file(&self.lock);
        }
    }
}

/// Makes a folder that only its user can look into.
fn make_private_folder(path: &Path) -> io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.recursive(true).create(path)
}

/// Removes what broken-off sessions may leave that holds no work: half-written files and locks of nothing.
pub(super) fn clear_leftovers(folder: &Path) {
    clear_temporaries(folder);
    let Ok(entries) = fs::read_dir(folder) else { return };
    let is_lock = |path: &PathBuf| path.extension().is_some_and(|it| it == LOCK.trim_start_matches('.'));
    for path in entries.flatten().map(|entry| entry.path()).filter(is_lock) {
        // What is no regular file might be waited for without end.
        let old = fs::metadata(&path).is_ok_and(|about| about.is_file() && is_older(&about, LEFTOVER));
        let lonely = !path.with_extension(WORK.trim_start_matches('.')).exists();
        if old && lonely && is_locked(&path).is_ok_and(|locked| !locked) {
            let _ = fs::remove_file(&path);
        }
    }
}
