//! Messages that need no answer. They are drawn over the screen and disappear after a while or at the next key.

use super::frame::panel;
use super::words::Phrase;
use crate::figure::wrap;
use crate::machine::Language;
use crate::screen::{Color, Screen, WIDTH};
use std::time::Duration;

/// How long a short message stays.
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
    /// The moment at which it disappears by itself.
    pub(super) until: Option<Duration>,
    /// Whether a film shows it.
    pub(super) filmed: bool,
}

/// Letters in a line of a short message, which is drawn at the place of questions.
const SHORT: usize = 28;
/// Letters in a line of a long message.
const LONG: usize = 56;
/// Lines of a long message; no program has a longer one.
const LINES: usize = 8;

impl Notice {
    /// Draws a short message over the question page, a long one below it on a larger panel.
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

/// Lower edge of the panel above a question in the middle of the picture.
const ABOVE_QUESTION: i32 = 184;

/// Draws the facts about a question in the middle of the picture, on a panel above it.
pub(super) fn preface(screen: &mut Screen, text: &str) {
    sheet(screen, text, |height| ABOVE_QUESTION - height);
}

/// Draws a text on a panel of the height it needs; the upper edge is computed from the height.
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
