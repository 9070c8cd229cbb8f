//! Messages that nobody has to answer: laid over the screen, gone after a while or with the next key.

use super::frame::panel;
use super::words::Phrase;
use crate::machine::Language;
use crate::screen::{Color, Screen, WIDTH};
use std::time::Duration;

/// How long a message stays that is only for information.
pub(super) const MESSAGE_TIME: Duration = Duration::from_secs(2);

/// How long a message stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stay {
    /// Two seconds, as in the original, or until the next key or click.
    Briefly,
    /// Until the next key or click.
    UntilRead,
}

/// A message over the screen.
pub(super) struct Notice {
    pub(super) text: Phrase,
    /// The moment at which it goes by itself.
    pub(super) until: Option<Duration>,
}

/// Letters in a line of a short message, which stands where the questions stand.
const SHORT: usize = 28;
/// Letters in a line of a long message.
const LONG: usize = 56;
/// Lines of a long message; nothing that programs say is longer.
const LINES: usize = 8;

impl Notice {
    /// Draws the message over the question page when it is short, else below it on a larger panel.
    pub(super) fn draw(&self, screen: &mut Screen, language: Language) {
        let text = self.text.of(language);
        if text.chars().count() <= SHORT {
            super::frame::page(screen, (200, 200));
            let width = 8 * i32::try_from(text.chars().count()).unwrap_or(0);
            screen.text((WIDTH - width) / 2, 220, text, Color::Black);
            return;
        }
        sheet(screen, text, |_| 256);
    }
}

/// The lower edge of what is said to a question in the middle of the picture, above its page.
const ABOVE_QUESTION: i32 = 184;

/// Draws what a question in the middle of the picture is about on a panel above it.
pub(super) fn preface(screen: &mut Screen, text: &str) {
    sheet(screen, text, |height| ABOVE_QUESTION - height);
}

/// Draws a text on a panel as high as it needs, whose upper edge follows from that.
fn sheet(screen: &mut Screen, text: &str, top: impl Fn(i32) -> i32) {
    let lines = wrap(text, LONG);
    let height = 16 * i32::try_from(lines.len()).unwrap_or(0) + 8;
    let y = top(height);
    panel(screen, 88, y, 464, height);
    for (row, line) in (0..).zip(&lines) {
        screen.text(96, y + 8 + 16 * row, line, Color::Black);
    }
}

/// A text in lines of at most `width` letters, broken at blanks where there are any.
fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let mut word: Vec<char> = word.chars().collect();
        while !word.is_empty() {
            let line = lines.last_mut().expect("there is always a line: the list starts with one");
            let used = line.chars().count();
            let gap = usize::from(used > 0);
            if used + gap + word.len() <= width {
                line.extend(std::iter::repeat_n(' ', gap));
                line.extend(word.drain(..));
            } else if used > 0 {
                lines.push(String::new());
            } else {
                line.extend(word.drain(..width));
            }
        }
    }
    lines.truncate(LINES);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_at_blanks_and_long_words_anywhere() {
        assert_eq!(wrap("one two three", 7), ["one two", "three"]);
        assert_eq!(wrap("abcdefghij kl", 4), ["abcd", "efgh", "ij", "kl"]);
        assert_eq!(wrap("", 4), [""]);
        assert_eq!(wrap(&"word ".repeat(1000), 20).len(), LINES);
    }
}
