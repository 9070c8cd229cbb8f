//! The options that every program takes.

use super::{Failure, TableArgs, config, language, say};
use crate::disk::{BestsFile, ConfigFile, Folder, Offers, RecoveryFolder, UserFolder};
use crate::machine::{Keeper, Language, Machine, Manner, Preferences, Script, Settings, Shown};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::time::SystemTime;

/// Where a program shows itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DisplayKind {
    /// In a window.
    Window,
    /// In the terminal.
    Terminal,
    /// In a window by the library minifb, in builds that have it.
    Minifb,
    /// Nowhere; only useful with a script.
    None,
}

/// A language by its code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Code {
    Hu,
    En,
}

impl Code {
    fn of(language: Language) -> Code {
        match language {
            Language::Hungarian => Code::Hu,
            Language::English => Code::En,
        }
    }
}

/// A program's command line.
#[derive(Args, Clone, Debug, Default)]
pub struct Options {
    /// Data file to open at the start (.IP2, .json, ...), or the name of a built-in sample
    pub file: Option<PathBuf>,
    /// How a table in the file is read.
    #[command(flatten)]
    pub table: TableArgs,
    /// How the program runs.
    #[command(flatten)]
    pub run: RunOptions,
}

/// The options that say how a program runs.
#[derive(Args, Clone, Debug, Default)]
pub struct RunOptions {
    /// Language of the texts; without it the setting, then the locale decides
    #[arg(long, value_enum, value_name = "LANG")]
    lang: Option<Code>,
    /// Display; without it a window where one can be opened, else the terminal
    #[arg(long, value_enum, value_name = "DISPLAY")]
    pub display: Option<DisplayKind>,
    /// Whole factor by which the window is larger than 640x480
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=16))]
    pub scale: Option<u32>,
    /// Play a script without display, in virtual time; - is standard input
    #[arg(long, value_name = "FILE")]
    pub script: Option<PathBuf>,
    /// Write the session as a script
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Where random numbers start from
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Behaviour; without it that of 1997 in scripts, else as in the settings
    #[arg(long, value_name = "MANNER", value_parser = manner_parser())]
    manner: Option<Manner>,
    /// What the user has chosen for all programs, once it has been looked up.
    #[arg(skip)]
    preferences: Option<Preferences>,
}

impl RunOptions {
    /// An option that says how a program is shown or played, if one is given.
    pub(super) fn for_displays(&self) -> Option<&'static str> {
        let given = [
            ("--display", self.display.is_some()),
            ("--scale", self.scale.is_some()),
            ("--script", self.script.is_some()),
            ("--record", self.record.is_some()),
            ("--seed", self.seed.is_some()),
            ("--manner", self.manner.is_some()),
        ];
        given.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
    }

    /// Refuses options that have no effect together.
    ///
    /// # Errors
    /// [`Failure`] that says which.
    pub fn check(&self) -> Result<(), Failure> {
        let shown = self.display.filter(|display| *display != DisplayKind::None);
        let refused = match (&self.script, shown, self.scale) {
            (Some(_), Some(_), _) => "--display: a script plays without display; --record keeps what it does",
            (Some(_), _, Some(_)) => "--scale is for windows; a script plays without display",
            (None, Some(DisplayKind::Terminal), Some(_)) => {
                "--scale is for windows; the terminal has its own size"
            }
            _ => return Ok(()),
        };
        Err(Failure::usage(refused))
    }

    /// The language of the program's texts: as asked for, Hungarian in scripts, else as it is told what goes wrong.
    pub fn language(&self) -> Language {
        match self.lang {
            None if self.script.is_some() => Language::Hungarian,
            _ => self.spoken(),
        }
    }

    /// The language of answers and errors: as asked for, else that of the settings or the locale.
    pub(super) fn spoken(&self) -> Language {
        match self.lang {
            Some(Code::Hu) => Language::Hungarian,
            Some(Code::En) => Language::English,
            None => language::usual(),
        }
    }

    /// How programs behave: as asked for, as in 1997 in scripts, else as the user prefers.
    pub(super) fn manner(&self) -> Manner {
        let usual = || self.preferences.as_ref().map_or(Manner::Today, |preferences| preferences.manner);
        self.manner.unwrap_or_else(|| if self.script.is_some() { Manner::Original } else { usual() })
    }

    /// These options with a language.
    #[must_use]
    pub fn in_language(&self, language: Language) -> RunOptions {
        RunOptions { lang: Some(Code::of(language)), ..self.clone() }
    }

    /// These options with a language that the user has chosen and prefers from now on. A file that cannot be written keeps
    /// nobody from going on.
    #[must_use]
    pub fn preferring(&self, language: Language) -> RunOptions {
        let preferences = self.preferences.clone().map(|it| Preferences { language: Some(language), ..it });
        if let Some(Err(problem)) = preferences.as_ref().map(|it| ConfigFile.keep(it)) {
            say("grafika", &problem);
        }
        RunOptions { preferences, ..self.in_language(language) }
    }

    /// These options, completed by the user's preferences. A script ignores these, so that it plays alike everywhere.
    #[must_use]
    pub fn preferred(&self) -> RunOptions {
        if self.script.is_some() || self.preferences.is_some() {
            return self.clone();
        }
        let preferences = config::preferences();
        let display = preferences.display.map(|shown| match shown {
            Shown::Window => DisplayKind::Window,
            Shown::Terminal => DisplayKind::Terminal,
        });
        RunOptions {
            lang: self.lang.or(preferences.language.map(Code::of)),
            display: self.display.or(display),
            scale: self.scale.or(preferences.scale),
            preferences: Some(preferences),
            ..self.clone()
        }
    }

    /// The folder of a program that is given no file: the user's, or the current one.
    pub(super) fn folder(&self) -> PathBuf {
        let chosen = self.preferences.as_ref().and_then(|preferences| preferences.folder.as_ref());
        chosen.map(PathBuf::from).unwrap_or_default()
    }

    /// These options with a file, or without.
    pub fn with_file(&self, file: Option<PathBuf>) -> Options {
        Options { file, table: TableArgs::default(), run: self.clone() }
    }

    /// A machine with these options and a folder for its files. Scripts keep no unsaved work, so that they play alike
    /// every time. A recorded session keeps its work but is offered none, since the question would not come again when
    /// it is replayed.
    pub(super) fn machine(&self, folder: PathBuf, script: Option<&Script>) -> Machine {
        let live = self.script.is_none() && self.display != Some(DisplayKind::None);
        // A script and a recording play alike every time; who plays for pleasure gets other problems every day.
        let alike = !live || self.record.is_some();
        let usual = if alike { Settings::default().seed } else { random_seed() };
        let seed = self.seed.unwrap_or(usual);
        let settings = Settings { language: self.language(), seed, manner: self.manner() };
        let settings = script.map_or(settings, |script| script.begun_with(settings));
        let recovery = || {
            let offers = if self.record.is_some() { Offers::Nothing } else { Offers::Lost };
            RecoveryFolder::new(UserFolder::State.path(), &folder, offers)
        };
        let recovery = live.then(recovery);
        let storage = Folder::new(folder);
        let storage = if live && self.record.is_none() { storage.told() } else { storage };
        let machine = Machine::new(Box::new(storage), settings);
        let machine = match recovery {
            Some(recovery) => machine.with_recovery(recovery),
            None => machine,
        };
        // The best results are seen on the screen: a recording without them is replayed alike.
        let machine = if alike { machine } else { machine.with_bests(BestsFile::default()) };
        match &self.preferences {
            Some(preferences) => {
                machine.with_preferences(preferences.clone(), ConfigFile, language::locale())
            }
            None => machine,
        }
    }
}

/// A seed from the time of day, short enough to be typed.
fn random_seed() -> u64 {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    u64::try_from(since.as_millis() % 1_000_000).unwrap_or_default()
}

/// The manners by their names.
fn manner_parser() -> impl TypedValueParser<Value = Manner> {
    let names = [Manner::Today, Manner::Original].map(Manner::name);
    PossibleValuesParser::new(names).map(|name| Manner::from_name(&name).unwrap_or_default())
}
