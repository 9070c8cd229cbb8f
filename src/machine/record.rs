//! Writes a session down as a script that replays to the same pictures.

use super::event::{Event, Key};
use super::{Language, Manner, Pointing};
use std::io::{self, Write};
use std::time::Duration;

/// Writes events as the lines of a script, with the time between them.
pub struct Recorder {
    output: Box<dyn Write>,
    written_until: Duration,
    /// The first error of writing; the program goes on, and it is reported at the end.
    problem: Option<io::Error>,
}

impl Recorder {
    /// A recorder that writes a comment of one line first.
    pub fn new(output: Box<dyn Write>, comment: &str) -> Recorder {
        let mut recorder = Recorder { output, written_until: Duration::ZERO, problem: None };
        recorder.line(&format!("# {comment}"));
        recorder
    }

    /// Writes how the program speaks and behaves at the start.
    pub(super) fn begin(&mut self, language: Language, manner: Manner) {
        self.line(&format!("lang {}", language.code()));
        self.line(&format!("manner {}", manner.name()));
    }

    /// Writes what moves the pointer.
    pub(super) fn pointing(&mut self, pointing: Pointing) {
        self.line(match pointing {
            Pointing::Mouse => "pointing mouse",
            Pointing::Keys => "pointing keys",
        });
    }

    /// Writes one event that happened at `now`, a moment in whole milliseconds.
    pub fn event(&mut self, event: Event, now: Duration) {
        self.wait_until(now);
        let line = match event {
            Event::Key(Key::Char(typed)) if Key::from_name(&typed.to_string()) != Some(Key::Char(typed)) => {
                // `key` means the capital letter; a small one is written as `type`.
                match typed {
                    ' ' => "key Space".to_string(),
                    typed => format!("type {typed}"),
                }
            }
            Event::Key(key) => format!("key {key}"),
            Event::Move(x, y) => format!("move {x} {y}"),
            Event::Press(button) => format!("press {}", button.name()),
            Event::Release(button) => format!("release {}", button.name()),
            Event::Wheel(steps) => format!("wheel {steps}"),
            Event::Hold(modifier, true) => format!("press {}", modifier.name()),
            Event::Hold(modifier, false) => format!("release {}", modifier.name()),
            Event::Close => "close".to_string(),
        };
        self.line(&line);
    }

    /// Writes the rest, and returns the first error there was.
    pub(super) fn finish(mut self, now: Duration) -> io::Result<()> {
        self.wait_until(now);
        match self.problem {
            Some(problem) => Err(problem),
            None => self.output.flush(),
        }
    }

    fn wait_until(&mut self, now: Duration) {
        let pause = now.saturating_sub(self.written_until).as_millis();
        if pause > 0 {
            self.written_until = now;
            self.line(&format!("wait {pause}"));
        }
    }

    fn line(&mut self, line: &str) {
        // Flushed line by line: recordings matter most when the program crashes.
        let written = writeln!(self.output, "{line}").and_then(|()| self.output.flush());
        if let Err(error) = written {
            self.problem.get_or_insert(error);
        }
    }
}
