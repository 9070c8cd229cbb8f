//! The place of recovery that is a folder on disk: one file (`place.rs`) for the unsaved work of every running session.
//!
//! A thread (`writer.rs`) writes the latest work, so that no picture waits for the disk. Beside a session's file lies a
//! lock file, which the session holds locked as long as it runs; the system lets go of it however the session
//! ends. A file whose lock can be had belongs to nobody any more, and is offered.

mod place;
mod writer;

use super::reason;
use crate::machine::{Lost, Recovery, Verdict, Work};
use place::{Place, WORK, clear_leftovers};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::{Duration, SystemTime};
use writer::{Shared, Wish, write};

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
    /// The folder `recovery` in a state folder ([`UserFolder::State`](super::UserFolder); without one nothing can be kept, which is
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
                Err(error) => self.shared.state().note(reason(&error)),
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
                    self.shared.state().note(format!("{}: {}", path.display(), reason(&error)));
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Instant;

    /// A scratch folder, gone at the end.
    struct Scratch(PathBuf);

    impl Scratch {
        fn new(name: &str) -> Scratch {
            let path = std::env::temp_dir().join(format!("grafika-recovery-{name}-{}", std::process::id()));
            let _ = fs::remove_dir_all(&path);
            fs::create_dir_all(&path).unwrap();
            Scratch(path)
        }

        fn session(&self) -> RecoveryFolder {
            RecoveryFolder::new(Some(self.0.join("state")), &self.0.join("files"), Offers::Lost)
        }

        fn folder(&self) -> PathBuf {
            self.0.join("state").join("recovery")
        }

        fn names(&self) -> Vec<String> {
            let entries = fs::read_dir(self.folder()).map(|entries| entries.flatten().collect::<Vec<_>>());
            let name = |entry: &fs::DirEntry| entry.file_name().into_string().unwrap();
            let mut names: Vec<String> = entries.unwrap_or_default().iter().map(name).collect();
            names.sort();
            names
        }

        /// Leaves a file behind as a session would that broke off.
        fn leave(&self, name: &str, content: &[u8]) {
            fs::create_dir_all(self.folder()).unwrap();
            fs::write(self.folder().join(name), content).unwrap();
        }
    }

    impl Drop for Scratch {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    fn work(content: &str) -> Work {
        Work { program: "p".to_string(), file: None, content: content.to_string() }
    }

    fn content(lost: Option<Lost>) -> Option<String> {
        lost.and_then(|lost| lost.work.ok()).map(|work| work.content)
    }

    /// Waits until a condition holds; fails after a time far longer than any pace.
    #[track_caller]
    fn wait(what: impl Fn() -> bool) -> Duration {
        let begun = Instant::now();
        while !what() {
            assert!(begun.elapsed() < Duration::from_secs(10), "it does not come");
            thread::sleep(Duration::from_millis(2));
        }
        begun.elapsed()
    }

    #[test]
    fn work_outlives_its_session_and_is_offered_once_it_is_over() {
        let scratch = Scratch::new("life");
        let (mut one, mut other) = (scratch.session(), scratch.session());
        assert_eq!(one.lost("p"), None);
        one.keep(work("first"));
        wait(|| scratch.names().len() == 2);
        assert_eq!(other.lost("p"), None, "its session still runs");
        one.keep(work("second"));
        drop(one);
        assert_eq!(other.lost("q"), None, "it is of another program");
        let lost = other.lost("p").unwrap();
        assert!(lost.age.unwrap() < Duration::from_secs(10));
        assert_eq!(lost.work.unwrap(), work("second"), "the end waits for the last work");
        assert_eq!(scratch.session().lost("p"), None, "it is offered to somebody already");
        other.settle(Verdict::TakenUp);
        other.keep(work("third"));
        wait(|| fs::read_to_string(scratch.folder().join(&scratch.names()[1])).unwrap().ends_with("third"));
        assert_eq!(scratch.names().len(), 2, "the place was taken over");
        other.forget();
        wait(|| scratch.names().is_empty());
        other.keep(work("fourth"));
        drop(other);
        assert_eq!(content(scratch.session().lost("p")).as_deref(), Some("fourth"));
    }

    #[test]
    fn whatever_is_wished_last_before_the_end_is_done() {
        let scratch = Scratch::new("last");
        for _ in 0..20 {
            let mut session = scratch.session();
            session.keep(work("x"));
            session.forget();
            drop(session);
            assert_eq!(scratch.names().len(), 0);
        }
        let mut session = scratch.session();
        (0..1000).for_each(|number| session.keep(work(&number.to_string())));
        drop(session);
        assert_eq!(content(scratch.session().lost("p")).as_deref(), Some("999"));
    }

    #[test]
    fn a_stream_of_changes_is_written_at_its_pace() {
        let scratch = Scratch::new("pace");
        let mut session = scratch.session();
        let (mut latest, mut oldest) = (0u64, Duration::ZERO);
        let mut made: Vec<Instant> = Vec::new();
        while made.first().is_none_or(|first| first.elapsed() < Duration::from_millis(1500)) {
            made.push(Instant::now());
            session.keep(work(&(made.len() - 1).to_string()));
            thread::sleep(Duration::from_millis(2));
            let kept = scratch.names().into_iter().find(|name| name.ends_with(WORK));
            let kept = kept.and_then(|name| fs::read_to_string(scratch.folder().join(name)).ok());
            let Some(number) = kept.and_then(|text| text.lines().last()?.parse::<u64>().ok()) else {
                continue;
            };
            assert!(number >= latest);
            latest = number;
            // The first change that is not in the file.
            oldest = oldest.max(made.get(number as usize + 1).map_or(Duration::ZERO, Instant::elapsed));
        }
        println!("the oldest change that was not kept was {oldest:?} old");
        assert!(latest > 0 && oldest < Duration::from_secs(1), "{oldest:?}");
    }

    #[test]
    fn verdicts() {
        let scratch = Scratch::new("verdicts");
        for (name, age) in [("p-1-0", 30), ("p-2-0", 10), ("p-3-0", 20)] {
            let head = r#"{"unsaved_work_of":"p","version":1,"file":null}"#;
            scratch.leave(&format!("{name}.unsaved"), format!("{head}\n{name}").as_bytes());
            let file = fs::File::options().write(true).open(scratch.folder().join(format!("{name}.unsaved")));
            file.unwrap().set_modified(SystemTime::now() - Duration::from_secs(age)).unwrap();
        }
        let mut session = scratch.session();
        assert_eq!(content(session.lost("p")).as_deref(), Some("p-2-0"), "the newest first");
        session.settle(Verdict::Later);
        assert_eq!(content(session.lost("p")).as_deref(), Some("p-3-0"));
        session.settle(Verdict::Deleted);
        assert_eq!(content(session.lost("p")).as_deref(), Some("p-1-0"));
        session.settle(Verdict::Broken);
        assert_eq!(session.lost("p"), None);
        drop(session);
        assert_eq!(scratch.names(), ["p-1-0.unsaved.broken", "p-2-0.lock", "p-2-0.unsaved"]);
        // Not deciding is deciding later; a name that is taken is not lost.
        let mut session = scratch.session();
        assert_eq!(content(session.lost("p")).as_deref(), Some("p-2-0"));
        assert_eq!(session.lost("p"), None);
        drop(session);
        scratch.leave("p-1-0.unsaved", b"new");
        let mut session = scratch.session();
        assert!(session.lost("p").unwrap().work.is_err());
        session.settle(Verdict::Broken);
        assert!(scratch.names().contains(&"p-1-0.unsaved.broken1".to_string()), "{:?}", scratch.names());
    }

    #[test]
    fn broken_files_are_told_and_never_followed() {
        let scratch = Scratch::new("broken");
        let head = |of: &str, version: u32| {
            format!("{{\"unsaved_work_of\":\"{of}\",\"version\":{version},\"file\":null}}\n{{}}").into_bytes()
        };
        let cases: [(&[u8], &str); 8] = [
            (b"", "no end"),
            (b"no line", "no end"),
            (b"\n", "first line"),
            (b"{}\n{}", "first line: missing field"),
            (b"[1,2\n{}", "first line"),
            (b"\xff\xfe\n", "no text"),
            (&head("q", 1), "work of \"q\""),
            (&head("p", 2), "version 2"),
        ];
        for (content, said) in cases {
            scratch.leave("p-1-0.unsaved", content);
            let mut session = scratch.session();
            let problem = session.lost("p").unwrap().work.unwrap_err();
            assert!(problem.contains(said), "{problem}");
        }
        let file = fs::File::create(scratch.folder().join("p-1-0.unsaved")).unwrap();
        file.set_len(1 << 40).unwrap();
        assert!(scratch.session().lost("p").unwrap().work.unwrap_err().contains("64 MB"));
        fs::remove_file(scratch.folder().join("p-1-0.unsaved")).unwrap();
        fs::create_dir(scratch.folder().join("p-1-0.unsaved")).unwrap();
        // Neither folders nor others' files.
        scratch.leave("p2-1-0.unsaved", b"");
        scratch.leave("p-1-0.unsaved.broken", b"");
        scratch.leave("p-1-1.json", b"");
        assert_eq!(scratch.session().lost("p"), None);
    }

    #[test]
    fn a_place_that_cannot_be_written_is_told_once_and_work_goes_on() {
        let scratch = Scratch::new("unwritable");
        fs::write(scratch.0.join("state"), b"a file where the folder should be").unwrap();
        for state in [Some(scratch.0.join("state")), None] {
            let mut session = RecoveryFolder::new(state, &scratch.0, Offers::Lost);
            assert_eq!(session.lost("p"), None);
            session.keep(work("1"));
            session.settle_wishes();
            assert!(session.problem().is_some() && session.problem().is_none());
            session.keep(work("2"));
            session.settle_wishes();
            assert_eq!(session.problem(), None);
            session.forget();
        }
        // What is mended meanwhile works.
        let mut session = scratch.session();
        session.keep(work("1"));
        session.settle_wishes();
        fs::remove_file(scratch.0.join("state")).unwrap();
        session.keep(work("2"));
        drop(session);
        assert_eq!(content(scratch.session().lost("p")).as_deref(), Some("2"));
    }

    #[test]
    fn the_file_is_named_as_the_user_sees_it() {
        let scratch = Scratch::new("named");
        let mut session = scratch.session();
        session.keep(Work { file: Some("A.IP2".to_string()), ..work("") });
        drop(session);
        let file = |session: &mut RecoveryFolder| session.lost("p").unwrap().work.unwrap().file.unwrap();
        assert_eq!(file(&mut scratch.session()), "A.IP2");
        let elsewhere = RecoveryFolder::new(Some(scratch.0.join("state")), &scratch.0, Offers::Lost);
        let mut session = elsewhere;
        let path = file(&mut session);
        assert_eq!(Path::new(&path), scratch.0.join("files").join("A.IP2"));
        // From there it goes on being that file.
        session.settle(Verdict::TakenUp);
        session.keep(Work { file: Some(path), ..work("") });
        drop(session);
        assert_eq!(file(&mut scratch.session()), "A.IP2");
    }

    #[test]
    fn who_only_keeps_is_offered_nothing() {
        let scratch = Scratch::new("keeps");
        let keeper = || RecoveryFolder::new(Some(scratch.0.join("state")), &scratch.0, Offers::Nothing);
        keeper().keep(work("1"));
        assert_eq!(keeper().lost("p"), None);
        assert_eq!(content(scratch.session().lost("p")).as_deref(), Some("1"));
    }

    #[test]
    fn old_leftovers_are_cleared_away_but_never_work() {
        let scratch = Scratch::new("leftovers");
        for name in [".grafika-1-0.tmp", "p-1-0.lock", "p-2-0.lock", "p-2-0.unsaved", "note.txt"] {
            scratch.leave(name, b"");
            let file = fs::File::options().write(true).open(scratch.folder().join(name)).unwrap();
            file.set_modified(SystemTime::now() - Duration::from_secs(100_000)).unwrap();
        }
        scratch.leave(".grafika-2-0.tmp", b"");
        assert_eq!(scratch.session().lost("q"), None);
        assert_eq!(scratch.names(), [".grafika-2-0.tmp", "note.txt", "p-2-0.lock", "p-2-0.unsaved"]);
    }
}
