//! The failure of a command: one line on stderr and an exit status.

use super::language::page_in_hungarian;
use super::{in_language, say, spoken, write_output};
#[cfg(feature = "terminal")]
use crate::display::terminal::TerminalError;
use crate::machine::Language;
use std::fmt;
use std::process::ExitCode;

/// A command that could not do its work.
#[derive(Debug)]
pub struct Failure {
    status: u8,
    told: Told,
}

/// What a user is told in the end.
#[derive(Debug)]
enum Told {
    /// What went wrong.
    Problem(String),
    /// Help or version, which is no error.
    Answer(String),
    /// Nothing: nobody reads it.
    Nothing,
}

impl Failure {
    /// The work failed: exit status 1.
    pub fn work(message: impl fmt::Display) -> Failure {
        Failure::with_status(1, message)
    }

    /// The command line or the script is wrong: exit status 2.
    pub fn usage(message: impl fmt::Display) -> Failure {
        Failure::with_status(2, message)
    }

    /// A signal ended the work: exit status 128 and the signal's number, as shells have it.
    pub fn signal(number: u8, message: impl fmt::Display) -> Failure {
        Failure::with_status(128_u8.saturating_add(number), message)
    }

    /// Nobody reads on: the end of the command, but no error.
    pub(super) fn unread() -> Failure {
        Failure { status: 0, told: Told::Nothing }
    }

    /// What went wrong, in a language.
    pub fn told(&self, language: Language) -> String {
        in_language(&self.to_string(), language)
    }

    fn with_status(status: u8, message: impl fmt::Display) -> Failure {
        Failure { status, told: Told::Problem(message.to_string()) }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.told {
            Told::Problem(text) | Told::Answer(text) => f.write_str(text),
            Told::Nothing => f.write_str("nobody reads the output"),
        }
    }
}

impl std::error::Error for Failure {}

impl From<clap::Error> for Failure {
    /// Turns clap's message into one line, without its closing remark.
    fn from(error: clap::Error) -> Failure {
        let text = error.to_string();
        if !error.use_stderr() {
            return Failure { status: 0, told: Told::Answer(text) };
        }
        let lines = text.lines().map(|line| (line.len() - line.trim_start().len(), line.trim()));
        let said = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with("For more information"));
        let mut message = String::new();
        for (indent, line) in said {
            let line = number(&tip(line));
            // What is indented goes on with a list; tips and possible values are sentences of their own.
            let goes_on = indent > 0
                && !line.starts_with("tip: ")
                && !line.starts_with('[')
                && !line.starts_with(MEANT);
            message += match message.chars().last() {
                None => "",
                Some(':') => " ",
                Some(_) if goes_on => ", ",
                Some(_) => "; ",
            };
            message += &line;
        }
        Failure::usage(message.strip_prefix("error: ").unwrap_or(&message))
    }
}

/// How a question about what was meant begins.
const MEANT: &str = "did you mean";

/// clap's line about names that are alike, as the other messages say it.
fn tip(line: &str) -> String {
    let alike = line.strip_prefix("tip: ").and_then(|tip| tip.split_once(": ")).filter(|(what, _)| {
        what.contains("similar") && (what.ends_with("exists") || what.ends_with("exist"))
    });
    alike.map_or_else(
        || line.to_owned(),
        |(_, names)| format!("{MEANT} {}?", names.replace(", ", " or ").replace('\'', "\"")),
    )
}

/// What clap says of a wrong number, as the other messages say it.
fn number(line: &str) -> String {
    let Some((start, problem)) = line.rsplit_once(": ") else { return line.to_owned() };
    let negative = line.split('\'').nth(1).is_some_and(|value| value.parse::<i64>().is_ok_and(|it| it < 0));
    let told = match problem {
        "invalid digit found in string" if negative => "it must not be negative".to_owned(),
        "invalid digit found in string" => "this is not a whole number".to_owned(),
        "invalid float literal" => "this is not a number".to_owned(),
        "cannot parse integer from empty string" | "cannot parse float from empty string" => {
            "a number is needed here".to_owned()
        }
        "number too large to fit in target type" => "the number is too large".to_owned(),
        "number too small to fit in target type" => "the number is too small".to_owned(),
        other => match other.split_once(" is not in ").and_then(|(_, range)| range.split_once("..")) {
            Some((least, "")) => format!("it must be at least {least}"),
            Some((least, most)) => format!("it must be {least} to {}", most.trim_start_matches('=')),
            None => return line.to_owned(),
        },
    };
    format!("{start}: {told}")
}

#[cfg(feature = "terminal")]
impl From<TerminalError> for Failure {
    fn from(error: TerminalError) -> Failure {
        match error {
            TerminalError::Stopped(signal) => Failure::signal(signal, error),
            error => Failure::work(error),
        }
    }
}

/// Says what went wrong, if anything, and gives the exit status.
pub fn exit(program: &str, result: Result<(), Failure>) -> ExitCode {
    let Err(Failure { status, told }) = result else { return ExitCode::SUCCESS };
    match told {
        Told::Problem(text) => {
            say(program, &text);
            ExitCode::from(status)
        }
        Told::Answer(text) => {
            let text = format!("{}\n", text.trim_end());
            let text = if spoken() == Language::Hungarian { page_in_hungarian(&text) } else { text };
            exit(program, write_output(text.as_bytes()))
        }
        Told::Nothing => ExitCode::from(status),
    }
}
