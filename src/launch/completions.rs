//! Completions of command lines: shells ask the program itself, which knows its samples, settings and files.

use super::{Failure, write_output};
use crate::file::{FileKind, Format, TABLES};
use crate::machine::{Preference, SAMPLES};
use crate::programs::{ALL, by_name};
use clap::builder::{PathBufValueParser, ValueParser};
use clap::{Arg, Command};
use clap_complete::engine::{
    ArgValueCandidates, ArgValueCompleter, CompletionCandidate, PathCompleter, ValueCompleter,
};
use clap_complete::env::{Bash, Elvish, EnvCompleter, Fish, Powershell, Zsh};
use std::ffi::{OsStr, OsString};
use std::path::Path;

/// The variable in which a shell says that it asks.
const VARIABLE: &str = "GRAFIKA_COMPLETE";

/// Shells by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum ShellName {
    /// GNU Bash
    Bash,
    /// Elvish
    Elvish,
    /// fish
    Fish,
    /// PowerShell
    Powershell,
    /// Z shell
    Zsh,
}

impl ShellName {
    /// All of them.
    const ALL: [ShellName; 5] =
        [ShellName::Bash, ShellName::Elvish, ShellName::Fish, ShellName::Powershell, ShellName::Zsh];

    fn asks(self) -> &'static dyn EnvCompleter {
        match self {
            ShellName::Bash => &Bash,
            ShellName::Elvish => &Elvish,
            ShellName::Fish => &Fish,
            ShellName::Powershell => &Powershell,
            ShellName::Zsh => &Zsh,
        }
    }
}

/// What a shell reads at its start, so that it asks a program of this name.
///
/// # Errors
/// [`Failure`] when it cannot be written.
pub fn registration(shell: ShellName, name: &str) -> Result<Vec<u8>, Failure> {
    let mut script = Vec::new();
    shell.asks().write_registration(VARIABLE, name, name, name, &mut script).map_err(Failure::work)?;
    if shell == ShellName::Zsh {
        // From a folder of functions the script is read as the function of the first completion, and has to answer it too.
        let answers = format!(
            "if [[ ${{funcstack[1]}} == _{name} ]]; then _clap_dynamic_completer_{name} \"$@\"; fi\n"
        );
        script.extend(answers.into_bytes());
    }
    Ok(script)
}

/// Answers a shell that asks how the line of a command goes on; `None` where none asks.
pub fn complete(command: impl FnOnce() -> Command) -> Option<Result<(), Failure>> {
    let asking = std::env::var_os(VARIABLE).filter(|shell| !shell.is_empty())?;
    let shell = ShellName::ALL.into_iter().find(|shell| shell.asks().is(&asking.to_string_lossy()))?;
    let words: Vec<OsString> = std::env::args_os().skip_while(|word| word != "--").skip(1).collect();
    if words.is_empty() {
        return None;
    }
    let (mut command, mut answer) = (completed(command()), Vec::new());
    let folder = std::env::current_dir().ok();
    // Where nothing fits, nothing is answered.
    let _ = shell.asks().write_complete(&mut command, words, folder.as_deref(), &mut answer);
    Some(write_output(&answer))
}

/// A command that knows the values of its options and arguments.
#[must_use]
pub fn completed(command: Command) -> Command {
    let formats: Option<&'static [Format]> = by_name(command.get_name()).map(|program| program.opens);
    let command = if command.get_name() == "config" { with_settings(command) } else { command };
    command.mut_args(|arg| with_values(arg, formats)).mut_subcommands(completed)
}

/// Names to choose from, for an option whose values are read in another way.
#[must_use]
pub fn words(names: &'static [&'static str]) -> ArgValueCandidates {
    ArgValueCandidates::new(|| names.iter().map(CompletionCandidate::new).collect())
}

fn with_values(arg: Arg, formats: Option<&'static [Format]>) -> Arg {
    let named =
        |parser: &ValueParser| parser.type_id() == ValueParser::from(PathBufValueParser::new()).type_id();
    let path = named(arg.get_value_parser());
    let positional = arg.is_positional();
    match arg.get_id().as_str() {
        "folder" => arg.add(ArgValueCompleter::new(PathCompleter::dir())),
        "puzzle" | "space" | "initial" => arg.add(ArgValueCompleter::new(Data { formats: None })),
        "program" => arg.add(ArgValueCandidates::new(|| {
            let names = ALL.iter().map(|program| {
                CompletionCandidate::new(program.manual.name).help(Some(program.manual.about.1.into()))
            });
            names.collect()
        })),
        "output" if path => arg.add(ArgValueCompleter::new(PathCompleter::file().stdio())),
        _ if path && positional => arg.add(ArgValueCompleter::new(Data { formats })),
        _ if path => arg.add(ArgValueCompleter::new(PathCompleter::file())),
        id if is_kind(&arg) => {
            let reads = id == "from";
            arg.add(ArgValueCandidates::new(move || kinds(reads)))
        }
        _ => arg,
    }
}

fn is_kind(arg: &Arg) -> bool {
    let known = |_: &str| -> Result<FileKind, String> { Ok(FileKind::Json) };
    arg.get_value_parser().type_id() == ValueParser::new(known).type_id()
}

/// The extensions of data files, of those that are only read too.
fn kinds(reads: bool) -> Vec<CompletionCandidate> {
    let formats = Format::ALL.iter().map(|format| {
        CompletionCandidate::new(format.extension().to_lowercase()).help(Some(format.english().into()))
    });
    let tables = TABLES.iter().filter(|_| reads).map(CompletionCandidate::new);
    formats.chain(["json", "csv"].map(CompletionCandidate::new)).chain(tables).collect()
}

/// The settings as commands below `config`, each with its values.
fn with_settings(command: Command) -> Command {
    let setting = |preference: Preference| {
        let value = Arg::new("value");
        let value = match preference.values() {
            [] => value.add(ArgValueCompleter::new(PathCompleter::dir())),
            values => value.add(words(values)),
        };
        Command::new(preference.key()).arg(value)
    };
    command.subcommands(Preference::ALL.map(setting))
}

/// Data files and built-in samples, of some formats or all.
struct Data {
    formats: Option<&'static [Format]>,
}

impl ValueCompleter for Data {
    fn complete(&self, current: &OsStr) -> Vec<CompletionCandidate> {
        let mut found = PathCompleter::file().stdio().complete(current);
        let begun = current.to_string_lossy().to_lowercase();
        let opened = |name: &str| match (self.formats, Format::from_name(name)) {
            (None, _) => true,
            (Some(formats), Some(format)) => formats.contains(&format),
            (Some(_), None) => false,
        };
        let samples = SAMPLES.iter().map(|(name, _)| *name).filter(|name| {
            // A file of this name counts more.
            name.to_lowercase().starts_with(&begun) && opened(name) && !Path::new(name).exists()
        });
        found.extend(samples.map(|name| CompletionCandidate::new(name).help(Some("built-in sample".into()))));
        found
    }
}
