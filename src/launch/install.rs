//! `grafika install` and `telepit`: the page where there is a terminal, a plain command where groups are given.

use super::progress::Bar;
use super::{DisplayKind, Failure, RunOptions, has_terminal, progress, spoken, write_output};
use crate::machine::Language;
use crate::programs::groups::GROUPS;
#[cfg(feature = "terminal")]
use crate::programs::telepit::installer::End;
use crate::programs::telepit::installer::Installer;
use crate::programs::telepit::job::{Answer, Job, Outcome, Step};
use crate::programs::telepit::plan::{Plan, System, Way};
use crate::programs::telepit::removal::{self, Fate};
use crate::programs::telepit::{PROGRAM, place, texts};
use crate::screen::visible;
use crate::ui::{Group, Words};
use clap::Args;
use clap::builder::PossibleValuesParser;
use std::io::{BufRead, IsTerminal, Write};
use std::path::{Path, PathBuf};

/// The group that stands for all.
const ALL: &str = "all";

/// The command line of `grafika install` and of `telepit`.
#[derive(Args)]
pub struct Install {
    /// Folder to install into, which need not be there [default: grafika in your home folder]
    #[arg(value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Groups to install, without any page: all, or names with commas between them
    #[arg(long, value_name = "GROUPS", value_delimiter = ',', value_parser = group_names(), ignore_case = true)]
    groups: Vec<String>,
    /// Overwrite files without asking
    #[arg(long)]
    yes: bool,
    /// Copy the executable into the folder, once for all programs, so that nothing there needs the place it came from
    #[arg(long)]
    copy: bool,
    /// Programs alone, straight into the folder, without samples: for a folder on the path
    #[arg(long)]
    flat: bool,
    #[command(flatten)]
    run: RunOptions,
}

fn group_names() -> PossibleValuesParser {
    PossibleValuesParser::new([ALL].into_iter().chain(GROUPS.iter().map(|group| group.id)))
}

impl Install {
    /// Examples of the command line under a name.
    pub fn examples(name: &str) -> String {
        format!(
            "Examples:\n  {name}\n  {name} ~/grafika\n  {name} grafika --groups gb_2d,jatek\n  {name} grafika --groups all --yes\n  {name} ~/grafika --groups all --copy\n  {name} ~/.local/bin --groups all --flat --copy"
        )
    }

    /// The installer's page with some options.
    pub(super) fn shown(run: RunOptions) -> Install {
        Install { folder: None, groups: Vec::new(), yes: false, copy: false, flat: false, run }
    }

    /// Installs.
    ///
    /// # Errors
    /// [`Failure`] when the command line is wrong, or a file cannot be written.
    pub fn run(&self) -> Result<(), Failure> {
        self.run.check()?;
        if !self.groups.is_empty() {
            if let Some(option) = self.run.for_displays() {
                return Err(Failure::usage(format!(
                    "{option} is for the installer's page; with --groups there is none"
                )));
            }
            return self.plainly();
        }
        let pictured = self.run.script.is_some()
            || self.run.record.is_some()
            || self.run.display.is_some_and(is_picture);
        if pictured {
            let given = [
                ("DIR", self.folder.is_some()),
                ("--yes", self.yes),
                ("--copy", self.copy),
                ("--flat", self.flat),
            ];
            if let Some((option, _)) = given.into_iter().find(|(_, given)| *given) {
                return Err(Failure::usage(format!(
                    "{option}: the installer in a picture asks for this itself"
                )));
            }
            return PROGRAM.start(&self.run.with_file(None));
        }
        if !has_terminal() {
            return Err(Failure::usage(
                "there is no terminal to choose in: give the groups, as in --groups all --yes",
            ));
        }
        self.in_terminal()
    }

    /// The installer with the folder and the answer of the command line.
    fn installer(&self) -> Installer {
        let folder = self.folder.clone().unwrap_or_else(place::offered);
        let standing = self.yes.then_some(Answer::All);
        let folder = folder.display().to_string();
        Installer::new(self.run.language(), folder, standing, Box::new(place::executable)).in_way(self.way())
    }

    #[cfg(feature = "terminal")]
    fn in_terminal(&self) -> Result<(), Failure> {
        let mut installer = self.installer();
        crate::textmode::in_terminal(&mut installer)?;
        match installer.end() {
            End::Left | End::Installed => Ok(()),
            End::Cancelled => Err(Failure::work("cancelled")),
            End::Failed => Err(Failure::work("nothing was installed")),
        }
    }

    #[cfg(not(feature = "terminal"))]
    fn in_terminal(&self) -> Result<(), Failure> {
        let _ = self.installer();
        Err(Failure::usage("this build shows no pages: give the groups, as in --groups all --yes"))
    }

    fn way(&self) -> Way {
        Way { copy: self.copy, flat: self.flat }
    }

    fn chosen(&self) -> Vec<&'static Group> {
        let named = |group: &&Group| self.groups.iter().any(|name| name.eq_ignore_ascii_case(group.id));
        let all = self.groups.iter().any(|name| name.eq_ignore_ascii_case(ALL));
        GROUPS.into_iter().filter(|group| all || named(group)).collect()
    }

    /// Installs without any page: a line for each file.
    fn plainly(&self) -> Result<(), Failure> {
        let plan =
            Plan::new(&self.chosen(), &place::executable, System::HERE, self.way()).map_err(Failure::work)?;
        let folder = self.folder.clone().unwrap_or_else(place::offered);
        let language = self.run.language();
        let signals = Signals::watch();
        let mut job = Job::new(folder, plan, self.yes.then_some(Answer::All));
        let bar = progress::bar("", job.progress().1);
        loop {
            if let Some(signal) = signals.stop() {
                return Err(Failure::signal(signal, given_up(&mut job, "stopped by a signal")));
            }
            match job.step().map_err(Failure::work)? {
                Step::Asks(path) => match bar.aside(|| ask(&path, language)) {
                    Some(answer) => job.answer(answer),
                    None => {
                        let message = format!("{} is there already; --yes overwrites it", path.display());
                        return Err(Failure::work(given_up(&mut job, &message)));
                    }
                },
                Step::Did(path, outcome) => tell(&bar, &path, outcome, language),
                Step::Finished(report) => {
                    drop(bar);
                    let lines = texts::report(&report, job.root());
                    let text: String = lines.iter().map(|line| format!("{}\n", line.of(language))).collect();
                    return write_output(text.as_bytes());
                }
            }
        }
    }
}

/// The command line of `grafika uninstall`.
#[derive(Args)]
#[command(after_help = "Examples:\n  grafika uninstall\n  grafika uninstall ~/grafika")]
pub struct Uninstall {
    /// Folder that was installed into [default: grafika in your home folder]
    #[arg(value_name = "DIR")]
    folder: Option<PathBuf>,
}

impl Uninstall {
    /// Takes an installation back, with a line for each file.
    ///
    /// # Errors
    /// [`Failure`] when nothing was installed there, or something cannot be removed.
    pub fn run(&self) -> Result<(), Failure> {
        let folder = self.folder.clone().unwrap_or_else(place::offered);
        let (language, mut text) = (spoken(), String::new());
        let done = removal::remove(&folder, |path, fate| {
            let what = match fate {
                Fate::Removed => Words("eltávolítva", "removed"),
                Fate::Missing => Words("már nem volt ott", "was gone already"),
                Fate::Changed => {
                    Words("nem az, ami telepítve lett, és marad", "is not what was installed, and stays")
                }
            };
            text += &format!("{}: {}\n", path.display(), what.of(language));
        });
        write_output(text.as_bytes())?;
        done.map_err(Failure::work)
    }
}

fn is_picture(display: DisplayKind) -> bool {
    display != DisplayKind::Terminal
}

fn tell(bar: &Bar, path: &Path, outcome: Outcome, language: Language) {
    let what = match outcome {
        Outcome::Written => Words("kész", "written"),
        Outcome::Same => Words("már ott volt", "was there already"),
        Outcome::Kept => Words("a régi maradt", "stays the old one"),
    };
    bar.advance();
    bar.line(&format!("{}: {}", path.display(), what.of(language)));
}

fn given_up(job: &mut Job, why: &str) -> String {
    let left = texts::undone(&job.give_up());
    let left: Vec<&str> = left.iter().map(|line| line.of(Language::English)).collect();
    format!("{why}; {}", left.join(", "))
}

/// Asks whether a file is to be overwritten; `None` when nobody can be asked, or wishes to cancel.
fn ask(path: &Path, language: Language) -> Option<Answer> {
    let stdin = std::io::stdin();
    if !stdin.is_terminal() {
        return None;
    }
    let answers = texts::answers(language).into_iter().map(|(letter, word)| format!("{letter}={word}"));
    let answers: Vec<String> = answers.collect();
    loop {
        let question = texts::OVERWRITE.of(language);
        let name = path.display().to_string();
        let asked = format!("{}: {question} [{}] ", visible(&name), answers.join(" "));
        // Who sees no question gives no answer either.
        std::io::stderr().write_all(asked.as_bytes()).ok()?;
        let mut line = String::new();
        if stdin.lock().read_line(&mut line).ok()? == 0 {
            return None;
        }
        let letter = line.trim().chars().next().and_then(|letter| letter.to_uppercase().next());
        if let Some(answer) = letter.and_then(texts::answer_of) {
            return Some(answer);
        }
    }
}

#[cfg(feature = "terminal")]
use crate::display::terminal::Signals;

/// Without the terminal's libraries a signal ends the process at once.
#[cfg(not(feature = "terminal"))]
struct Signals;

#[cfg(not(feature = "terminal"))]
impl Signals {
    fn watch() -> Signals {
        Signals
    }

    fn stop(&self) -> Option<u8> {
        None
    }
}
