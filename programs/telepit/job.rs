//! The work of installing: a plan carried out file by file. It asks before it overwrites, and a job that fails or
//! is given up leaves the disk as it was.

use super::journal::{Executable, Journal};
use super::notes::{NAME, Notes, Print};
use super::plan::{Entry, Plan, Starter, System, What};
use crate::disk::reason;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// An answer to the question whether to overwrite a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Answer {
    Yes,
    No,
    /// Yes, and every other one too.
    All,
    /// No, and no other one either.
    None,
}

/// What a step came to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// There is a different file at this place; the job continues after [`Job::answer`].
    Asks(PathBuf),
    /// The file at this path, relative to the target folder, has been handled.
    Did(PathBuf, Outcome),
    /// All is done.
    Finished(Report),
}

/// What became of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    Written,
    /// It was there already.
    Same,
    /// Another one stayed.
    Kept,
}

/// What a job did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Report {
    pub(crate) written: usize,
    pub(crate) same: usize,
    pub(crate) kept: usize,
    /// Files that were set aside and could not be removed, with the reason.
    pub(crate) left_over: Vec<String>,
}

/// A job that failed; the disk is unchanged except for `left`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Failed {
    pub(crate) path: PathBuf,
    pub(crate) problem: String,
    /// What could not be undone, with the reason.
    pub(crate) left: Vec<String>,
}

impl fmt::Display for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}; ", self.path.display(), self.problem)?;
        match self.left.as_slice() {
            [] => f.write_str("everything is as it was before"),
            left => write!(f, "this could not be undone: {}", left.join(", ")),
        }
    }
}

impl std::error::Error for Failed {}

/// What is at the place of a file.
enum Place {
    Free,
    Same,
    Other,
    Folder,
}

/// A plan being carried out. Dropping it before it has finished undoes it.
#[derive(Debug)]
pub(crate) struct Job {
    root: PathBuf,
    plan: Plan,
    system: System,
    next: usize,
    journal: Journal,
    /// The answer to the question about the next file.
    answer: Option<Answer>,
    /// The answer to all questions.
    standing: Option<Answer>,
    /// What was made, from the folder of all.
    made: Vec<PathBuf>,
    report: Report,
}

impl Job {
    /// The job of installing into a folder, which need not exist, with an answer to all questions, if any.
    pub(crate) fn new(root: PathBuf, plan: Plan, standing: Option<Answer>) -> Job {
        Job {
            root,
            plan,
            system: System::HERE,
            next: 0,
            journal: Journal::default(),
            answer: None,
            standing,
            made: Vec::new(),
            report: Report::default(),
        }
    }

    /// The folder that is installed into.
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// The number of handled files, and of all files.
    pub(crate) fn progress(&self) -> (usize, usize) {
        (self.next, self.plan.entries.len())
    }

    /// The next file, from the folder of all.
    pub(crate) fn now(&self) -> Option<PathBuf> {
        self.plan.entries.get(self.next).map(Entry::path)
    }

    /// Answers the question about the next file.
    pub(crate) fn answer(&mut self, answer: Answer) {
        match answer {
            Answer::Yes | Answer::No => self.answer = Some(answer),
            Answer::All | Answer::None => self.standing = Some(answer),
        }
    }

    /// Aborts the job: undoes what was done, and returns what could not be undone.
    pub(crate) fn give_up(&mut self) -> Vec<String> {
        self.journal.undo()
    }

    /// Deals with the next file.
    pub(crate) fn step(&mut self) -> Result<Step, Failed> {
        let Some(entry) = self.plan.entries.get(self.next).cloned() else {
            if let Err(error) = self.note() {
                let (path, left) = (self.root.join(NAME), self.journal.undo());
                return Err(Failed { path, problem: reason(&error), left });
            }
            self.report.left_over = self.journal.keep();
            return Ok(Step::Finished(std::mem::take(&mut self.report)));
        };
        let path = self.root.join(entry.path());
        match self.install(&entry, &path) {
            Ok(None) => Ok(Step::Asks(path)),
            Ok(Some(outcome)) => {
                self.next += 1;
                self.answer = None;
                let count = match outcome {
                    Outcome::Written => &mut self.report.written,
                    Outcome::Same => &mut self.report.same,
                    Outcome::Kept => &mut self.report.kept,
                };
                *count += 1;
                Ok(Step::Did(entry.path(), outcome))
            }
            Err(error) => {
                let left = self.journal.undo();
                Err(Failed { path, problem: reason(&error), left })
            }
        }
    }

    /// Installs a file; `None` if the user must be asked first.
    fn install(&mut self, entry: &Entry, path: &Path) -> io::Result<Option<Outcome>> {
        let folder = path.parent().unwrap_or(&self.root);
        self.journal.folder(folder)?;
        if !std::fs::canonicalize(folder)?.starts_with(std::fs::canonicalize(&self.root)?) {
            return Err(io::Error::other(format!(
                "{} is a link that leads out of the folder",
                folder.display()
            )));
        }
        match self.place(entry, path)? {
            Place::Free => {}
            Place::Same => return Ok(Some(Outcome::Same)),
            Place::Folder => {
                return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder, not a file"));
            }
            Place::Other => match self.answer.or(self.standing) {
                None => return Ok(None),
                Some(Answer::No | Answer::None) => return Ok(Some(Outcome::Kept)),
                Some(Answer::Yes | Answer::All) => self.journal.set_aside(path)?,
            },
        }
        match &entry.what {
            What::Data(content) => self.journal.write(path, content, Executable::No)?,
            What::Starter(starter) => self.start_by(starter, path)?,
            What::Copy(executable) => self.journal.copy(path, executable)?,
        }
        self.made.push(entry.path());
        Ok(Some(Outcome::Written))
    }

    /// Notes in the folder what was made there, for the day it is to go.
    fn note(&mut self) -> io::Result<()> {
        if self.made.is_empty() {
            return Ok(());
        }
        let path = self.root.join(NAME);
        let mut notes = Notes::read(&self.root)?.unwrap_or_default();
        let folders = self.journal.folders().filter_map(|folder| folder.strip_prefix(&self.root).ok());
        notes.add(&self.root, folders, &self.made)?;
        if std::fs::symlink_metadata(&path).is_ok() {
            self.journal.set_aside(&path)?;
        }
        self.journal.write(&path, &notes.text(), Executable::No)
    }

    /// A link where links are, else a script.
    fn start_by(&mut self, starter: &Starter, path: &Path) -> io::Result<()> {
        let linked = self.system == System::Unix && self.journal.link(path, &starter.executable).is_ok();
        if linked {
            return Ok(());
        }
        self.journal.write(path, &self.script(starter, path), Executable::Yes)
    }

    /// The script at a path, whose folder is there already.
    fn script(&self, starter: &Starter, path: &Path) -> Vec<u8> {
        let folder = path.parent().unwrap_or(&self.root);
        let folder = dunce::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf());
        starter.script(self.system, &folder)
    }

    fn place(&self, entry: &Entry, path: &Path) -> io::Result<Place> {
        let found = match std::fs::symlink_metadata(path) {
            Ok(found) => found,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Place::Free),
            Err(error) => return Err(error),
        };
        let holds = |content: &[u8]| {
            found.is_file()
                && found.len() == content.len() as u64
                && std::fs::read(path).is_ok_and(|held| held == content)
        };
        let same = match &entry.what {
            What::Data(content) => holds(content),
            What::Starter(starter) if found.is_symlink() => {
                std::fs::read_link(path).is_ok_and(|target| target == starter.executable)
            }
            What::Starter(starter) => {
                // In the folder of the executable itself.
                let same = |path: &Path| std::fs::canonicalize(path).ok();
                holds(&self.script(starter, path))
                    || starter.executable.is_absolute()
                        && same(path).is_some_and(|place| same(&starter.executable) == Some(place))
            }
            What::Copy(executable) => found.is_file() && is_copy(path, executable)?,
        };
        Ok(match (same, found.is_dir()) {
            (true, _) => Place::Same,
            (false, true) => Place::Folder,
            (false, false) => Place::Other,
        })
    }
}

/// Whether two files have the same content.
fn is_copy(path: &Path, of: &Path) -> io::Result<bool> {
    let same_length = std::fs::metadata(path)?.len() == std::fs::metadata(of)?.len();
    Ok(same_length && Print::of(path)? == Print::of(of)?)
}

#[cfg(test)]
mod tests {
    use super::super::journal::tests::{contents, scratch};
    use super::*;
    use crate::programs::groups::GROUPS;
    use crate::programs::telepit::plan::Way;
    use std::fs;

    fn plan() -> Plan {
        let find = |name: &str| Some(Path::new("/bin").join(name));
        Plan::new(&GROUPS, &find, System::HERE, Way::default()).unwrap()
    }

    /// Runs to the end with one answer to every question.
    fn run(job: &mut Job, answer: Answer) -> Result<(Report, usize), Failed> {
        let mut asked = 0;
        loop {
            match job.step()? {
                Step::Asks(_) => {
                    asked += 1;
                    job.answer(answer);
                }
                Step::Did(..) => {}
                Step::Finished(report) => return Ok((report, asked)),
            }
        }
    }

    #[test]
    fn everything_is_installed_and_again_is_the_same() {
        let folder = scratch("all");
        let root = folder.join("below/grafika");
        let files = plan().entries.len();
        let mut job = Job::new(root.clone(), plan(), None);
        let (report, asked) = run(&mut job, Answer::No).unwrap();
        assert_eq!((report.written, report.same, report.kept, asked), (files, 0, 0, 0));
        let after = contents(&root);
        drop(job);
        let (report, asked) = run(&mut Job::new(root.clone(), plan(), None), Answer::No).unwrap();
        assert_eq!((report.written, report.same, asked), (0, files, 0));
        assert_eq!(contents(&root), after);
        assert_eq!(fs::read(root.join("GB_2D/A.IP2")).ok().as_deref(), crate::machine::sample("A.IP2"));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn answers_decide_what_is_overwritten() {
        for (answer, written, asked) in
            [(Answer::Yes, 2, 2), (Answer::No, 0, 2), (Answer::All, 2, 1), (Answer::None, 0, 1)]
        {
            let root = scratch("answers");
            fs::create_dir(root.join("GB_2D")).unwrap();
            for name in ["A.IP2", "B.IP2"] {
                fs::write(root.join("GB_2D").join(name), b"mine").unwrap();
            }
            let (report, questions) = run(&mut Job::new(root.clone(), plan(), None), answer).unwrap();
            assert_eq!(questions, asked, "{answer:?}");
            assert_eq!(report.kept, 2 - written, "{answer:?}");
            let mine = |name| fs::read(root.join("GB_2D").join(name)).unwrap() == b"mine";
            assert_eq!([mine("A.IP2"), mine("B.IP2")], [written == 0; 2], "{answer:?}");
            // Nothing that was set aside is left.
            assert!(contents(&root).iter().all(|(path, _)| path.extension().is_none_or(|end| end != "old")));
            fs::remove_dir_all(root).unwrap();
        }
    }

    /// A failure at any file of the plan leaves the disk as it was, overwritten files included.
    #[test]
    fn a_failure_anywhere_is_undone() {
        let every = plan().entries;
        for at in (0..every.len()).step_by(7).chain([every.len() - 1]) {
            let folder = scratch("failure");
            let root = folder.join("new");
            let old = root.join(every[0].path());
            fs::create_dir_all(&root).unwrap();
            fs::write(&old, b"mine").unwrap();
            if at > 0 {
                // A folder where the file should be.
                fs::create_dir_all(root.join(every[at].path())).unwrap();
            } else {
                fs::remove_file(&old).unwrap();
                fs::create_dir(&old).unwrap();
            }
            let before = contents(&folder);
            let failed = run(&mut Job::new(root.clone(), plan(), None), Answer::All).unwrap_err();
            assert_eq!((&failed.path, failed.left.len()), (&root.join(every[at].path()), 0));
            assert!(
                failed.to_string().ends_with("it is a folder, not a file; everything is as it was before")
            );
            assert_eq!(contents(&folder), before, "{at}");
            fs::remove_dir_all(folder).unwrap();
        }
    }

    /// As on Windows, or on a disk without links.
    #[test]
    fn without_links_scripts_start_the_programs() {
        let root = scratch("scripts");
        let find = |name: &str| (name == "grafika").then(|| PathBuf::from("/bin/echo"));
        let plan = Plan::new(&[GROUPS[0]], &find, System::Windows, Way::default()).unwrap();
        for written in [plan.entries.len(), 0] {
            let mut job = Job::new(root.clone(), plan.clone(), None);
            job.system = System::Windows;
            assert_eq!(run(&mut job, Answer::No).unwrap().0.written, written);
        }
        let script = fs::read_to_string(root.join("KURZOR/vjs.cmd")).unwrap();
        // From the folder up to the root of all.
        let up = "..\\".repeat(fs::canonicalize(&root).unwrap().components().count());
        assert_eq!(script, format!("@\"%~dp0{up}bin\\echo\" vjs %*\r\n"));
        fs::remove_dir_all(root).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn scripts_of_sh_hand_their_arguments_on() {
        let root = scratch("sh");
        let starter = Starter { executable: "/bin/echo".into(), program: Some("vjs") };
        let path = root.join("vjs");
        fs::write(&path, starter.script(System::Unix, &root)).unwrap();
        let told = std::process::Command::new("sh").arg(&path).args(["a b", "c"]).output().unwrap();
        assert_eq!(told.stdout, b"vjs a b c\n");
        fs::remove_dir_all(root).unwrap();
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_undone() {
        let root = scratch("subfolder");
        fs::write(root.join("JATEK"), b"a file of that name").unwrap();
        let before = contents(&root);
        let failed = run(&mut Job::new(root.clone(), plan(), None), Answer::All).unwrap_err();
        assert!(failed.to_string().contains("it is a file, not a folder"), "{failed}");
        assert_eq!(contents(&root), before);
        fs::remove_dir_all(root).unwrap();
    }

    #[test]
    fn a_job_given_up_at_any_step_is_undone() {
        let files = plan().entries.len();
        for steps in (1..files).step_by(9) {
            let folder = scratch("given-up");
            let mut job = Job::new(folder.join("a/b"), plan(), None);
            for _ in 0..steps {
                job.step().unwrap();
            }
            assert_eq!(job.progress(), (steps, files));
            if steps % 2 == 0 {
                assert_eq!(job.give_up(), [""; 0]);
            }
            drop(job);
            assert_eq!(contents(&folder), []);
            fs::remove_dir_all(folder).unwrap();
        }
    }
}
