//! The place of recovery that is a folder on disk: one file for the unsaved work of every running session.
//!
//! A thread writes the latest work, so that no picture waits for the disk. Beside a session's file lies a
//! lock file, which the session holds locked as long as it runs; the system lets go of it however the session
//! ends. A file whose lock can be had belongs to nobody any more, and is offered.

use super::place::{Place, WORK, clear_leftovers};
use super::writer::{Shared, Wish, write};
use super::{Lost, Recovery, Verdict, Work};
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::{Duration, SystemTime};

/// How often it is looked whether the thread is still there, while it is waited for.
const LOOK_AGAIN: Duration = Duration::from_millis(50);

/// Whether a session is offered what others have left behind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Offers {
    /// It is.
    Lost,
    /// It only keeps its own work.
    Nothing,
}

/// The folder where the programs keep what is to outlive them: `grafika` in `$XDG_STATE_HOME` or else
/// `~/.local/state` (`~/Library/Application Support` on macOS, `%LOCALAPPDATA%` on Windows).
pub fn state_folder() -> Option<PathBuf> {
    state_folder_of(|name| std::env::var_os(name))
}

fn state_folder_of(variable: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    // A relative path would be another folder for every current one; the standard says to ignore it.
    let path = |name| variable(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let below_home = if cfg!(target_os = "macos") { "Library/Application Support" } else { ".local/state" };
    let base = match cfg!(windows) {
        true => path("LOCALAPPDATA"),
        false => path("XDG_STATE_HOME").or_else(|| path("HOME").map(|home| home.join(below_home))),
    };
    base.map(|base| base.join("grafika"))
}

/// Unsaved work in the folder `recovery` of a state folder.
pub struct RecoveryFolder {
    folder: Option<PathBuf>,
    /// Where the program's own files are.
    files: PathBuf,
    offers: Offers,
    shared: Arc<Shared>,
    writer: Option<JoinHandle<()>>,
    offered: Option<Place>,
    /// What this session has been told of.
    told_of: BTreeSet<PathBuf>,
}

impl RecoveryFolder {
    /// The folder `recovery` in a state folder ([`state_folder`]; without one nothing can be kept, which is
    /// told), for a program whose own files are in another folder.
    pub fn new(state: Option<PathBuf>, files: &Path, offers: Offers) -> RecoveryFolder {
        RecoveryFolder {
            folder: state.map(|state| state.join("recovery")),
            files: std::path::absolute(files)
                .or_else(|_| std::env::current_dir())
                .unwrap_or_else(|_| files.to_path_buf()),
            offers,
            shared: Arc::default(),
            writer: None,
            offered: None,
            told_of: BTreeSet::new(),
        }
    }

    fn wish(&mut self, wish: Wish) {
        self.shared.state().wish = Some(wish);
        self.shared.changed.notify_all();
        if self.writer.is_none() {
            let (shared, folder) = (Arc::clone(&self.shared), self.folder.clone());
            let started = thread::Builder::new()
                .name("recovery".to_string())
                .spawn(move || write(&shared, folder.as_deref()));
            match started {
                Ok(writer) => self.writer = Some(writer),
                Err(error) => self.shared.state().note(error.to_string()),
            }
        }
    }

    /// Waits until everything wished for has been done.
    fn settle_wishes(&self) {
        let mut state = self.shared.state();
        state.hurry = true;
        self.shared.changed.notify_all();
        // A thread that has ended before its time wakes nobody.
        let works = || self.writer.as_ref().is_some_and(|writer| !writer.is_finished());
        while works() && (state.busy || state.wish.is_some()) {
            state = self.shared.wait(state, Some(LOOK_AGAIN));
        }
        state.hurry = false;
    }

    /// The files of a program's unsaved work, the newest first.
    fn left_behind(&self, program: &str) -> Vec<(Option<SystemTime>, PathBuf)> {
        let Some(entries) = self.folder.as_ref().and_then(|folder| fs::read_dir(folder).ok()) else {
            return Vec::new();
        };
        let of_program = |path: &PathBuf| {
            let name = path.file_name().and_then(|name| name.to_str());
            let rest = name.and_then(|name| name.strip_prefix(program)?.strip_suffix(WORK));
            rest.is_some_and(|rest| rest.starts_with('-')) && !self.told_of.contains(path)
        };
        let paths = entries.flatten().map(|entry| entry.path()).filter(of_program);
        let mut found: Vec<_> = paths
            .filter_map(|path| {
                // What is no plain file might be waited for without end.
                let about = fs::metadata(&path).ok().filter(fs::Metadata::is_file)?;
                Some((about.modified().ok(), path))
            })
            .collect();
        found.sort();
        found.reverse();
        found
    }

    /// The path of a file as this program's user names it.
    fn named_from_here(&self, mut work: Work) -> Work {
        if let Some(file) = &mut work.file {
            let path = Path::new(file.as_str());
            let here = path.parent() == Some(&self.files);
            if let Some(name) = path.file_name().filter(|_| here) {
                *file = name.to_string_lossy().into_owned();
            }
        }
        work
    }
}

impl Recovery for RecoveryFolder {
    fn keep(&mut self, mut work: Work) {
        // A path that is absolute already stays as it is.
        work.file = work.file.map(|file| self.files.join(file).to_string_lossy().into_owned());
        self.wish(Wish::Keep(work));
    }

    fn forget(&mut self) {
        let nothing_kept = {
            let mut state = self.shared.state();
            let nothing = state.own.is_none() && !state.busy;
            if nothing {
                state.wish = None;
            }
            nothing
        };
        if !nothing_kept {
            self.wish(Wish::Forget);
        }
    }

    fn lost(&mut self, program: &str) -> Option<Lost> {
        if self.offered.is_some() {
            self.settle(Verdict::Later);
        }
        if self.offers == Offers::Nothing {
            return None;
        }
        if let Some(folder) = &self.folder {
            clear_leftovers(folder);
        }
        for (kept, path) in self.left_behind(program) {
            let place = match Place::taken_over(path.clone()) {
                Ok(Some(place)) => place,
                Ok(None) => continue,
                Err(error) => {
                    self.told_of.insert(path.clone());
                    self.shared.state().note(format!("{}: {error}", path.display()));
                    continue;
                }
            };
            let work = match place.read(program) {
                Ok(Some(work)) => Ok(self.named_from_here(work)),
                // Its session has ended in order in the meantime.
                Ok(None) => {
                    place.remove();
                    continue;
                }
                Err(problem) => Err(problem),
            };
            let age = kept.and_then(|kept| SystemTime::now().duration_since(kept).ok());
            self.offered = Some(place);
            return Some(Lost { name: path.display().to_string(), age, work });
        }
        None
    }

    fn settle(&mut self, verdict: Verdict) {
        let Some(place) = self.offered.take() else { return };
        // Whatever comes of it: a file that cannot be removed must not be asked for without end.
        self.told_of.insert(place.work.clone());
        match verdict {
            Verdict::TakenUp => {
                self.settle_wishes();
                // Work of this session's own, if there should be any, is left behind for the next one.
                self.shared.state().own = Some(place);
            }
            Verdict::Deleted => place.remove(),
            Verdict::Later => {}
            Verdict::Broken => place.set_aside(),
        }
    }

    fn problem(&mut self) -> Option<String> {
        self.shared.state().problem.take()
    }
}

impl Drop for RecoveryFolder {
    /// Waits until the last work is on the disk; it stays there, unless it was forgotten before.
    fn drop(&mut self) {
        self.shared.state().ended = true;
        self.shared.changed.notify_all();
        if let Some(writer) = self.writer.take() {
            // A thread that has panicked has nothing more to tell.
            let _ = writer.join();
        }
    }
}
