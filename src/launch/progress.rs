//! Progress of long work on stderr, if that is a terminal.

use super::{in_language, spoken, write_output};
use crate::machine::Language;
use crate::screen::visible;
use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// Time between two steps of the spinner.
const TURN: Duration = Duration::from_millis(120);

/// A bar of `total` parts; it vanishes when it is dropped.
pub fn bar(what: &'static str, total: usize) -> Bar {
    let language = spoken();
    let bar = ProgressBar::new(total as u64).with_message(in_language(what, language));
    Bar(styled(bar, "{msg} [{bar:40}] {pos}/{len} {eta}"), language)
}

/// A spinner with the elapsed time, for work of unknown length.
pub fn alive(what: &'static str) -> Bar {
    let language = spoken();
    let spinner = ProgressBar::new_spinner().with_message(in_language(what, language));
    let bar = styled(spinner, "{spinner} {msg} {elapsed}");
    bar.enable_steady_tick(TURN);
    Bar(bar, language)
}

fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    // Both templates above are valid; an invalid one would only give a plain bar.
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style.progress_chars("##-")),
        Err(_) => bar,
    }
}

/// A bar that is removed when the work ends, however it ends, with the language it speaks.
pub struct Bar(ProgressBar, Language);

impl Bar {
    /// One more part is done.
    pub fn advance(&self) {
        self.0.inc(1);
    }

    /// Writes a line to standard output, above the bar. A line that cannot be written does not stop the work.
    pub fn line(&self, text: &str) {
        self.0.suspend(|| {
            let _ = write_output(format!("{}\n", visible(text)).as_bytes());
        });
    }

    /// Does something that needs the terminal to itself.
    pub fn aside<T>(&self, what: impl FnOnce() -> T) -> T {
        self.0.suspend(what)
    }

    /// Says what is being done now.
    pub fn say(&self, what: String) {
        self.0.set_message(in_language(&what, self.1));
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
