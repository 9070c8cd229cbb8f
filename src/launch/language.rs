//! In which language the command line speaks, and its help in that language.
//!
//! The first of these that says something decides, for help, answers and errors as for the screen: `--lang`, wherever
//! it stands; the setting; the locale. Only the screen of a script is Hungarian without any of them, as the book's
//! programs are; what goes wrong with a script is told in the language of who reads it.

use crate::disk::ConfigFile;
use crate::machine::Language;
use crate::ui::hungarian;
use clap::{Arg, Command};
use std::ffi::{OsStr, OsString};

/// The option that chooses a language.
const OPTION: &str = "--lang";

/// The language of this process's help, answers and errors.
#[must_use]
pub fn spoken() -> Language {
    asked(std::env::args_os().skip(1)).unwrap_or_else(usual)
}

/// The language that a command line asks for; words behind `--` are no options.
fn asked(words: impl IntoIterator<Item = OsString>) -> Option<Language> {
    let mut words = words.into_iter().take_while(|word| word != OsStr::new("--"));
    while let Some(word) = words.next() {
        let code = match word.to_str().and_then(|word| word.strip_prefix(OPTION)) {
            Some("") => words.next()?,
            Some(value) if value.starts_with('=') => OsString::from(value.trim_start_matches('=')),
            _ => continue,
        };
        return code.to_str().and_then(Language::from_code);
    }
    None
}

/// The language without an option: that of the settings, else the locale's. What is wrong with the settings is told
/// where they are used.
pub(super) fn usual() -> Language {
    ConfigFile::read().0.language.unwrap_or_else(locale)
}

/// Hungarian where the locale says so, English elsewhere.
pub(super) fn locale() -> Language {
    of_locale(|name| std::env::var(name).ok(), system_locale)
}

fn of_locale(variable: impl Fn(&str) -> Option<String>, system: impl FnOnce() -> Option<String>) -> Language {
    let variables = ["LC_ALL", "LC_MESSAGES", "LANG"];
    let named = variables.into_iter().filter_map(variable).find(|set| !set.is_empty());
    match named.or_else(system) {
        Some(locale) if locale.to_ascii_lowercase().starts_with("hu") => Language::Hungarian,
        _ => Language::English,
    }
}

/// The locale of a system that does not put it into the environment: Windows, and macOS outside a shell.
fn system_locale() -> Option<String> {
    #[cfg(any(windows, target_os = "macos"))]
    return sys_locale::get_locale();
    #[cfg(not(any(windows, target_os = "macos")))]
    None
}

/// A text of ours in a language: line by line, so that lines which the list lacks stay as they are.
#[must_use]
pub fn in_language(text: &str, language: Language) -> String {
    match language {
        Language::English => text.to_owned(),
        Language::Hungarian => text.split_inclusive('\n').map(line).collect(),
    }
}

fn line(line: &str) -> String {
    let (text, end) = line.strip_suffix('\n').map_or((line, ""), |text| (text, "\n"));
    let told = hungarian::told(text);
    // The command line behind a mistake in it has the words of the parser.
    let told = if text.contains("Usage: ") { in_brackets(told) } else { told };
    format!("{told}{end}")
}

/// A command line that takes `--lang` behind every command of it, and whose help is in a language.
#[must_use]
pub fn speaking(command: Command, language: Language) -> Command {
    let command = signed(command.mut_arg("lang", |lang| lang.global(true)));
    match language {
        Language::English => command,
        Language::Hungarian => in_hungarian(command),
    }
}

/// The options of a command and of all below it take negative numbers as values: where one is wrong, what the option is
/// for says so, and not that there is no option of this name.
fn signed(command: Command) -> Command {
    let option = |arg: Arg| match arg.is_positional() || !arg.get_action().takes_values() {
        true => arg,
        false => arg.allow_negative_numbers(true),
    };
    command.mut_args(option).mut_subcommands(signed)
}

/// The words of a command line, `--lang` before a command moved behind it, where the command takes it. `help` takes no
/// option: it needs none, since it is in the language already.
#[must_use]
pub fn ordered(words: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
    let mut words: Vec<OsString> = words.into_iter().collect();
    let count = words.get(1).and_then(|word| length(word)).unwrap_or(0);
    if words.get(count + 1).is_some_and(|word| word == OsStr::new("help")) {
        let mut kept = Vec::new();
        let mut words = words.into_iter();
        while let Some(word) = words.next() {
            match length(&word) {
                Some(2) => drop(words.next()),
                Some(_) => {}
                None => kept.push(word),
            }
        }
        return kept;
    }
    let follows = words.get(count + 1).is_some_and(|word| !word.to_string_lossy().starts_with('-'));
    if follows && let Some(moved) = words.get_mut(1..=count + 1) {
        moved.rotate_right(1);
    }
    words
}

/// How many words the option is that begins with this one: its value is the next, or stands behind a sign of equality.
fn length(word: &OsStr) -> Option<usize> {
    match word.to_str()?.strip_prefix(OPTION)? {
        "" => Some(2),
        value => value.starts_with('=').then_some(1),
    }
}

/// The help of a command and of all below it in Hungarian. What the list lacks stays English.
fn in_hungarian(command: Command) -> Command {
    let about = command.get_about().and_then(|about| hungarian::help(&about.to_string()));
    let long = command.get_long_about().and_then(|about| hungarian::help(&about.to_string()));
    let command = about.into_iter().fold(command, |command, about| command.about(about));
    let command = long.into_iter().fold(command, |command, about| command.long_about(about));
    command.mut_args(option).mut_subcommands(in_hungarian)
}

/// An option's help and the name of its value in Hungarian.
fn option(arg: Arg) -> Arg {
    let help = arg.get_help().and_then(|help| hungarian::help(&help.to_string()));
    let long = arg.get_long_help().and_then(|help| hungarian::help(&help.to_string()));
    let names: Option<Vec<&'static str>> =
        arg.get_value_names().and_then(|names| names.iter().map(|name| hungarian::word(name)).collect());
    let arg = help.into_iter().fold(arg, |arg, help| arg.help(help));
    let arg = long.into_iter().fold(arg, |arg, help| arg.long_help(help));
    names.into_iter().fold(arg, |arg, names| arg.value_names(names))
}

/// What clap writes itself in brackets.
const BRACKETS: [(&str, &str); 6] = [
    ("[default: ", "[alapértelmezés: "),
    ("[possible values: ", "[lehet: "),
    ("[aliases: ", "[más nevei: "),
    (" [OPTIONS]", " [KAPCSOLÓK]"),
    (" [COMMAND]", " [PARANCS]"),
    (" <COMMAND>", " <PARANCS>"),
];

/// A page of help whose texts are in Hungarian already, with clap's own words.
pub(super) fn page_in_hungarian(page: &str) -> String {
    page.split_inclusive('\n').map(line_of_page).collect()
}

fn line_of_page(line: &str) -> String {
    let (text, end) = line.strip_suffix('\n').map_or((line, ""), |text| (text, "\n"));
    // The help stands behind the option, at least two blanks away, or in a line of its own; that of a value behind the
    // value and a colon.
    let blanks = text.len() - text.trim_start().len();
    let behind = text.get(blanks..).and_then(|rest| rest.rfind("  ")).map_or(blanks, |at| blanks + at + 2);
    let value = text.trim_start().strip_prefix("- ").and_then(|_| text.find(": ")).map(|at| at + 2);
    let value = value.map(|at| at + text.get(at..).map_or(0, |rest| rest.len() - rest.trim_start().len()));
    let told = [Some(blanks), Some(behind), value].into_iter().flatten().find_map(|at| {
        let (before, help) = text.split_at_checked(at)?;
        hungarian::heading(help).map(|help| format!("{before}{help}"))
    });
    let usage = || text.strip_prefix("Usage: ").map(|usage| format!("Használat: {usage}"));
    let told = told.or_else(usage).unwrap_or_else(|| text.to_owned());
    format!("{}{end}", in_brackets(told))
}

fn in_brackets(text: String) -> String {
    BRACKETS.iter().fold(text, |told, (english, hungarian)| told.replace(english, hungarian))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(line: &str) -> Vec<OsString> {
        line.split(' ').map(OsString::from).collect()
    }

    #[test]
    fn a_language_is_asked_for_anywhere_before_the_end_of_options() {
        for (line, language) in [
            ("info A.IP2 --lang hu", Some(Language::Hungarian)),
            ("--lang=hu info", Some(Language::Hungarian)),
            ("open --lang en a", Some(Language::English)),
            ("info -- --lang hu", None),
            ("info --lang", None),
            ("info --lang de", None),
            ("info --language hu", None),
            ("info", None),
        ] {
            assert_eq!(asked(words(line)), language, "{line}");
        }
    }

    #[test]
    fn the_system_is_asked_where_no_variable_is_set() {
        let of = |set: &[(&str, &str)], system: Option<&str>| {
            let variable =
                |name: &str| set.iter().find(|(known, _)| *known == name).map(|(_, it)| (*it).to_owned());
            of_locale(variable, || system.map(str::to_owned))
        };
        assert_eq!(of(&[], Some("hu-HU")), Language::Hungarian);
        assert_eq!(of(&[("LC_ALL", ""), ("LANG", "")], Some("hu_HU")), Language::Hungarian);
        assert_eq!(of(&[("LANG", "en_US.UTF-8")], Some("hu-HU")), Language::English);
        assert_eq!(of(&[("LANG", "C"), ("LC_MESSAGES", "hu_HU.UTF-8")], None), Language::Hungarian);
        assert_eq!(of(&[], None), Language::English);
    }

    #[test]
    fn the_language_before_a_command_goes_behind_it() {
        for (line, right) in [
            ("grafika --lang hu list", "grafika list --lang hu"),
            ("grafika --lang=hu info A.IP2", "grafika info --lang=hu A.IP2"),
            ("grafika --lang hu", "grafika --lang hu"),
            ("grafika --lang", "grafika --lang"),
            ("grafika --lang hu --help", "grafika --lang hu --help"),
            ("grafika list", "grafika list"),
            ("grafika", "grafika"),
            ("grafika --lang hu help fit", "grafika help fit"),
            ("grafika help fit --lang=hu", "grafika help fit"),
        ] {
            assert_eq!(ordered(words(line)), words(right), "{line}");
        }
    }
}
