//! What can be done now, shown where nothing is asked.

use super::ask::TOP;
use super::frame::panel;
use super::words::Phrase;
use crate::figure::wrap;
use crate::machine::{Key, Language, Pointing};
use crate::screen::{Color, Screen};

/// What can be done now, in at most [`HINT_LINES`] lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The upper left corner of the text.
    pub at: (i32, i32),
    /// Letters in a line.
    pub letters: usize,
    /// The text, with its keys.
    pub text: Phrase,
    /// The text where keys move the pointer, if that is another one.
    pub by_keys: Option<Phrase>,
    /// Whether it has a page of its own, over the picture.
    pub framed: bool,
}

/// Lines of a hint.
pub const HINT_LINES: usize = 3;

/// Letters in a line of the communication page.
const PAGE_LETTERS: usize = 28;
/// From the corner of the communication page to that of its text.
const INSET: (i32, i32) = (8, 7);

impl Hint {
    /// A hint on the communication page at the top.
    pub fn new(text: impl Into<Phrase>) -> Hint {
        Hint::at((TOP.0 + INSET.0, TOP.1 + INSET.1), PAGE_LETTERS, text)
    }

    /// A hint in a free place of the picture, with so many letters in a line.
    pub fn at(at: (i32, i32), letters: usize, text: impl Into<Phrase>) -> Hint {
        Hint { at, letters, text: text.into(), by_keys: None, framed: false }
    }

    /// A hint on a page of its own with its upper left corner at a place.
    pub fn framed((x, y): (i32, i32), text: impl Into<Phrase>) -> Hint {
        Hint { framed: true, ..Hint::at((x + INSET.0, y + INSET.1), PAGE_LETTERS, text) }
    }

    /// The hint with another text where keys move the pointer.
    #[must_use]
    pub fn by_keys(self, text: impl Into<Phrase>) -> Hint {
        Hint { by_keys: Some(text.into()), ..self }
    }

    /// Its lines in a language.
    pub fn lines(&self, language: Language, pointing: Pointing) -> Vec<String> {
        let text = match (pointing, &self.by_keys) {
            (Pointing::Keys, Some(text)) => text,
            _ => &self.text,
        };
        lines(text.of(language), self.letters)
    }

    pub(super) fn draw(&self, screen: &mut Screen, language: Language, pointing: Pointing) {
        let (x, y) = self.at;
        if self.framed {
            panel(screen, x - INSET.0, y - INSET.1, 240, 40);
        }
        for (row, line) in (0..).zip(self.lines(language, pointing).iter().take(HINT_LINES)) {
            screen.text(x, y + 11 * row, line, Color::Black);
        }
    }
}

/// Keeps two words on one line.
const BOUND: char = '\u{a0}';

/// Breaks a text into lines, but not between a key and what it does.
fn lines(text: &str, letters: usize) -> Vec<String> {
    let mut bound = String::new();
    let mut words = text.split_whitespace().peekable();
    while let Some(word) = words.next() {
        bound.push_str(word);
        if words.peek().is_some() {
            bound.push(if names_a_key(word) { BOUND } else { ' ' });
        }
    }
    wrap(&bound, letters).into_iter().map(|line| line.replace(BOUND, " ")).collect()
}

/// Whether a word is the name of a key, such as `G`, `(D` or `F1:`. Articles at the start of a sentence pass as
/// keys, which does no harm.
fn names_a_key(word: &str) -> bool {
    let name = word.trim_start_matches('(').trim_end_matches(':');
    name.starts_with(|first: char| first.is_uppercase()) && Key::from_name(name).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_stays_with_what_it_does() {
        assert_eq!(lines("one two G curve", 9), ["one two", "G curve"]);
        assert_eq!(lines("one two. Ctrl+Z: undo (D wires)", 15), ["one two.", "Ctrl+Z: undo", "(D wires)"]);
        assert_eq!(lines("what a G", 6), ["what a", "G"]);
    }
}
