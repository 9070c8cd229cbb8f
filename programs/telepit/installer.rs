//! The installer as its user sees it: groups are marked, a folder is named, files are written, and it says what it
//! has done.

use super::job::{Answer, Job, Step};
use super::plan::{Plan, System, Way};
use super::texts;
use crate::machine::{Key, Language};
use crate::programs::groups::GROUPS;
use crate::textmode::{Doing, Hit, Line, Overlay, Page, Row, Summary, TextEvent, TextProgram, chosen_after};
use crate::ui::{Phrase, Words};
use std::path::PathBuf;

/// Finds the executable of a name.
pub(crate) type Find = Box<dyn Fn(&str) -> Option<PathBuf>>;

/// What the installer is at.
enum Stage {
    /// Groups are being marked.
    Choose,
    /// Nothing was marked.
    NothingMarked,
    /// The folder is being named.
    Where(Line),
    /// Files are being written.
    Works(Job),
    /// A file is in the way.
    Asks(Job, PathBuf),
    /// It has said what came of it.
    Told(Words, Vec<Phrase>),
    Ended,
}

/// How an installation ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// It was left before anything was done.
    Left,
    Installed,
    Cancelled,
    Failed,
}

/// The installer.
pub(crate) struct Installer {
    language: Language,
    chosen: usize,
    marked: Vec<bool>,
    /// The folder that is offered.
    folder: String,
    standing: Option<Answer>,
    way: Way,
    find: Find,
    stage: Stage,
    end: End,
}

impl Installer {
    /// The installer in a language, with the proposed folder and an answer to all questions, if any.
    pub(crate) fn new(language: Language, folder: String, standing: Option<Answer>, find: Find) -> Installer {
        Installer {
            language,
            chosen: 0,
            marked: vec![false; GROUPS.len()],
            folder,
            standing,
            way: Way::default(),
            find,
            stage: Stage::Choose,
            end: End::Left,
        }
    }

    /// The same, with files laid out in another way.
    pub(crate) fn in_way(self, way: Way) -> Installer {
        Installer { way, ..self }
    }

    /// How it has ended.
    #[cfg_attr(
        not(feature = "terminal"),
        allow(dead_code, reason = "without a terminal nobody waits for it")
    )]
    pub(crate) fn end(&self) -> End {
        self.end
    }

    fn rows(&self) -> Vec<Row> {
        let row = |(group, marked): (&crate::ui::Group, &bool)| {
            Row::Mark(*marked, format!("{:8} {}", group.folder, group.name.of(self.language)))
        };
        GROUPS.into_iter().zip(&self.marked).map(row).collect()
    }

    fn overlay(&self) -> Option<Overlay> {
        let language = self.language;
        let go_on = || vec![("Enter".to_owned(), texts::GO_ON.of(language).to_owned())];
        Some(match &self.stage {
            Stage::Choose | Stage::Ended => return None,
            Stage::NothingMarked => Overlay::Message {
                title: "TELEPIT".into(),
                lines: vec![texts::NONE_MARKED.of(language).to_owned()],
                answers: go_on(),
            },
            Stage::Where(line) => {
                Overlay::Entry { title: texts::WHERE.of(language).to_owned(), line: line.clone() }
            }
            Stage::Works(job) => {
                let (done, total) = job.progress();
                let now = job.now().map(|path| path.display().to_string()).unwrap_or_default();
                Overlay::Progress { title: texts::INSTALLING.of(language).to_owned(), done, total, now }
            }
            Stage::Asks(_, path) => Overlay::Message {
                title: texts::EXISTS.of(language).to_owned(),
                lines: vec![path.display().to_string(), texts::OVERWRITE.of(language).to_owned()],
                answers: texts::answers(language),
            },
            Stage::Told(title, lines) => Overlay::Message {
                title: title.of(language).to_owned(),
                lines: lines.iter().map(|line| line.of(language).to_owned()).collect(),
                answers: go_on(),
            },
        })
    }

    /// A key while groups are being marked.
    fn choose(&mut self, event: TextEvent) {
        if let TextEvent::Click(Hit::Row(row)) = event
            && row == self.chosen
        {
            return self.mark();
        }
        if let Some(chosen) = chosen_after(&self.rows(), self.chosen, event) {
            self.chosen = chosen;
            return;
        }
        let key = match event {
            TextEvent::Key(key) => Some(key),
            TextEvent::Click(Hit::Key(index)) => texts::KEYS.get(index).map(|&(key, ..)| key),
            _ => None,
        };
        match key {
            Some(Key::Char(' ')) => self.mark(),
            Some(Key::Char('*')) => {
                let all = self.marked.iter().all(|marked| *marked);
                self.marked.fill(!all);
            }
            Some(Key::Enter) => {
                self.stage = match self.marked.contains(&true) {
                    true => Stage::Where(Line::offering(&self.folder)),
                    false => Stage::NothingMarked,
                };
            }
            Some(Key::Esc) => self.stage = Stage::Ended,
            Some(Key::F(2)) => self.language = self.language.other(),
            _ => {}
        }
    }

    fn mark(&mut self) {
        if let Some(marked) = self.marked.get_mut(self.chosen) {
            *marked = !*marked;
        }
    }

    /// The folder has been named.
    fn start(&mut self, folder: &str) -> Stage {
        let marked = GROUPS.into_iter().zip(&self.marked).filter(|(_, marked)| **marked);
        let groups: Vec<_> = marked.map(|(group, _)| group).collect();
        folder.clone_into(&mut self.folder);
        match Plan::new(&groups, &*self.find, System::HERE, self.way) {
            Ok(plan) => Stage::Works(Job::new(super::place::of_text(folder), plan, self.standing)),
            Err(missing) => {
                self.end = End::Failed;
                Stage::Told(texts::NOT_DONE, vec![Phrase::plain(&missing)])
            }
        }
    }

    fn cancel(&mut self, mut job: Job) -> Stage {
        self.end = End::Cancelled;
        let left = job.give_up();
        Stage::Told(texts::CANCELLED, texts::undone(&left))
    }

    /// What comes after a stage that holds something, at an event.
    fn after(&mut self, stage: Stage, event: TextEvent) -> Stage {
        let key = match event {
            TextEvent::Key(key) => Some(key),
            _ => None,
        };
        if key == Some(Key::F(2)) {
            self.language = self.language.other();
            return stage;
        }
        match (stage, key) {
            (Stage::Where(line), Some(Key::Enter)) if !line.text().trim().is_empty() => {
                self.start(line.text().trim())
            }
            (Stage::Where(_), Some(Key::Esc)) => Stage::Choose,
            (Stage::Where(mut line), Some(key)) => {
                line.key(key);
                Stage::Where(line)
            }
            (Stage::Works(job) | Stage::Asks(job, _), Some(Key::Esc)) => self.cancel(job),
            (Stage::Asks(mut job, path), key) => {
                let clicked = match event {
                    TextEvent::Click(Hit::Answer(index)) => {
                        texts::ANSWERS.get(index).map(|&(answer, ..)| answer)
                    }
                    _ => None,
                };
                match clicked.or_else(|| key.and_then(Key::letter).and_then(texts::answer_of)) {
                    Some(answer) => {
                        job.answer(answer);
                        Stage::Works(job)
                    }
                    None => Stage::Asks(job, path),
                }
            }
            (Stage::NothingMarked, _) if goes_on(event) => Stage::Choose,
            (Stage::Told(..), _) if goes_on(event) => Stage::Ended,
            (stage, _) => stage,
        }
    }
}

fn goes_on(event: TextEvent) -> bool {
    matches!(event, TextEvent::Key(Key::Enter | Key::Esc | Key::Char(' ')) | TextEvent::Click(Hit::Answer(_)))
}

impl TextProgram for Installer {
    fn page(&self) -> Page {
        let language = self.language;
        let group = GROUPS.get(self.chosen).copied();
        let keys =
            texts::KEYS.iter().map(|(_, key, what)| (key.of(language).into(), what.of(language).into()));
        Page {
            language,
            title: texts::TITLE.of(language).to_owned(),
            list_title: texts::GROUPS.of(language).to_owned(),
            rows: self.rows(),
            chosen: self.chosen,
            summary: Summary {
                title: group.map(|group| group.name.of(language).to_owned()).unwrap_or_default(),
                lines: group.map(|group| texts::summary(group, language)).unwrap_or_default(),
            },
            keys: keys.collect(),
            overlay: self.overlay(),
        }
    }

    fn event(&mut self, event: TextEvent) {
        let stage = std::mem::replace(&mut self.stage, Stage::Ended);
        self.stage = match (stage, event) {
            (Stage::Works(job) | Stage::Asks(job, _), TextEvent::Close) => {
                self.cancel(job);
                Stage::Ended
            }
            (_, TextEvent::Close) => Stage::Ended,
            (Stage::Choose, event) => {
                self.stage = Stage::Choose;
                return self.choose(event);
            }
            (stage, event) => self.after(stage, event),
        };
    }

    fn work(&mut self) {
        let mut job = match std::mem::replace(&mut self.stage, Stage::Ended) {
            Stage::Works(job) => job,
            other => return self.stage = other,
        };
        self.stage = match job.step() {
            Ok(Step::Asks(path)) => Stage::Asks(job, path),
            Ok(Step::Did(..)) => Stage::Works(job),
            Ok(Step::Finished(report)) => {
                self.end = End::Installed;
                Stage::Told(texts::DONE, texts::report(&report, job.root()))
            }
            Err(failed) => {
                self.end = End::Failed;
                Stage::Told(texts::NOT_DONE, texts::failure(&failed))
            }
        };
    }

    fn doing(&self) -> Doing {
        match self.stage {
            Stage::Works(_) => Doing::Working,
            Stage::Ended => Doing::Ended,
            _ => Doing::Waiting,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::golden::assert_golden;
    use super::super::journal::tests::{contents, scratch};
    use super::*;
    use std::path::Path;

    fn installer(language: Language, folder: &Path) -> Installer {
        let find: Find = Box::new(|name| Some(Path::new("/bin").join(name)));
        Installer::new(language, folder.display().to_string(), None, find)
    }

    fn press(installer: &mut Installer, keys: &[Key]) {
        for &key in keys {
            installer.event(TextEvent::Key(key));
        }
    }

    fn work(installer: &mut Installer) {
        while installer.doing() == Doing::Working {
            installer.work();
        }
    }

    #[test]
    fn pages_look_as_they_did() {
        for (language, code) in [(Language::Hungarian, "hu"), (Language::English, "en")] {
            let folder = Path::new("/tmp/grafika");
            let mut page = installer(language, folder);
            press(&mut page, &[Key::Char(' '), Key::Down, Key::Char(' ')]);
            assert_golden(&page.page(), &format!("telepit_choose_{code}.txt"));
            press(&mut page, &[Key::Enter]);
            assert_golden(&page.page(), &format!("telepit_where_{code}.txt"));
            press(&mut page, &[Key::Esc]);
            let plan = Plan::new(&[GROUPS[1]], &*page.find, System::Unix, Way::default()).unwrap();
            let job = Job::new(folder.to_path_buf(), plan.clone(), None);
            page.stage = Stage::Works(job);
            assert_golden(&page.page(), &format!("telepit_works_{code}.txt"));
            page.stage = Stage::Asks(Job::new(folder.to_path_buf(), plan, None), folder.join("GB_2D/A.IP2"));
            assert_golden(&page.page(), &format!("telepit_asks_{code}.txt"));
            let report = super::super::job::Report { written: 21, same: 2, kept: 1, left_over: Vec::new() };
            page.stage = Stage::Told(texts::DONE, texts::report(&report, folder));
            assert_golden(&page.page(), &format!("telepit_done_{code}.txt"));
        }
    }

    #[test]
    fn marked_groups_are_installed() {
        let root = scratch("installer");
        let mut installer = installer(Language::English, &root.join("new"));
        press(&mut installer, &[Key::Enter]);
        assert!(matches!(installer.stage, Stage::NothingMarked));
        press(&mut installer, &[Key::Enter, Key::Down, Key::Char(' '), Key::Enter, Key::Char('/')]);
        // The offer was replaced; back, and it is offered again.
        press(&mut installer, &[Key::Esc, Key::Enter, Key::Enter]);
        work(&mut installer);
        assert_eq!(installer.end(), End::Installed);
        assert!(root.join("new/GB_2D/A.IP2").is_file() && !root.join("new/JATEK").exists());
        press(&mut installer, &[Key::Enter]);
        assert_eq!(installer.doing(), Doing::Ended);
        std::fs::remove_dir_all(root).unwrap();
    }

    #[test]
    fn cancelling_anywhere_leaves_the_disk_as_it_was() {
        let root = scratch("cancel");
        std::fs::create_dir(root.join("JATEK")).unwrap();
        std::fs::write(root.join("JATEK/A.CSK"), b"mine").unwrap();
        let before = contents(&root);
        for (steps, event) in [
            (0, TextEvent::Key(Key::Esc)),
            (9, TextEvent::Key(Key::Esc)),
            (20, TextEvent::Close),
            (999, TextEvent::Close),
        ] {
            let mut installer = installer(Language::English, &root);
            press(&mut installer, &[Key::Char('*'), Key::Enter, Key::Enter]);
            for _ in 0..steps {
                installer.work();
            }
            assert_eq!(matches!(installer.stage, Stage::Asks(..)), steps == 999);
            assert_eq!(contents(&root) == before, steps == 0);
            installer.event(event);
            assert_eq!(installer.end(), End::Cancelled);
            assert_eq!(contents(&root), before, "{steps}");
        }
        std::fs::remove_dir_all(root).unwrap();
    }

    #[test]
    fn a_click_chooses_and_a_second_one_marks() {
        let mut installer = installer(Language::English, Path::new("x"));
        let row = |row| TextEvent::Click(Hit::Row(row));
        installer.event(row(3));
        assert_eq!((installer.chosen, installer.marked[3]), (3, false));
        installer.event(row(3));
        assert!(installer.marked[3]);
        installer.event(TextEvent::Click(Hit::Key(3)));
        assert_eq!(installer.language, Language::Hungarian);
    }
}
