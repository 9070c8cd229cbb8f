//! What ends a command: one line on stderr and an exit status.

use std::fmt;
use std::process::ExitCode;

/// A command that could not do its work.
#[derive(Debug)]
pub struct Failure {
    status: u8,
    message: String,
    /// Help and version are no errors: they go to stdout, as they are.
    is_answer: bool,
}

impl Failure {
    /// The work failed: exit status 1.
    pub fn work(message: impl fmt::Display) -> Failure {
        Failure { status: 1, message: message.to_string(), is_answer: false }
    }

    /// The command line or the script is wrong: exit status 2.
    pub fn usage(message: impl fmt::Display) -> Failure {
        Failure { status: 2, message: message.to_string(), is_answer: false }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Failure {}

impl From<clap::Error> for Failure {
    /// Puts what clap says into one line, without its closing remark.
    fn from(error: clap::Error) -> Failure {
        let text = error.to_string();
        if !error.use_stderr() {
            return Failure { status: 0, message: text, is_answer: true };
        }
        let lines = text.lines().map(str::trim);
        let said = lines.filter(|line| !line.is_empty() && !line.starts_with("For more information"));
        let message = said.collect::<Vec<_>>().join("; ");
        Failure::usage(message.strip_prefix("error: ").unwrap_or(&message))
    }
}

/// Says on stderr what went wrong, if anything, and gives the exit status.
pub fn exit(program: &str, result: Result<(), Failure>) -> ExitCode {
    let Err(failure) = result else { return ExitCode::SUCCESS };
    if failure.is_answer {
        println!("{}", failure.message.trim_end());
    } else {
        // On one line, even if a library's message has several.
        eprintln!("{program}: {}", failure.message.split_whitespace().collect::<Vec<_>>().join(" "));
    }
    ExitCode::from(failure.status)
}
