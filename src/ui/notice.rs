//! Messages that need no answer: drawn over the screen, gone after a while or at the next key.

use super::frame::panel;
use super::words::Phrase;
use crate::figure::wrap;
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
    /// Whether a film shows it.
    pub(super) filmed: bool,
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
    let mut lines = wrap(text, LONG);
    lines.truncate(LINES);
    let height = 16 * i32::try_from(lines.len()).unwrap_or(0) + 8;
    let y = top(height);
    panel(screen, 88, y, 464, height);
    for (row, line) in (0..).zip(&lines) {
        screen.text(96, y + 8 + 16 * row, line, Color::Black);
    }
}
