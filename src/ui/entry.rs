//! A line of input in a black window (procedure iras of the book).

use super::frame::{Area, window};
use crate::machine::Key;
use crate::screen::{Color, Screen, base_letter};

/// What may be typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accepts {
    /// Digits, minus sign, point and the E of an exponent; a comma is taken as the point.
    Number,
    /// Letters, digits, minus sign and point, converted to upper case.
    Name,
    /// Anything, as it is typed.
    Text,
}

/// A line being typed.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The window around it.
    pub area: Area,
    /// Upper left pixel of the first character.
    pub at: (i32, i32),
    /// How many characters fit.
    pub longest: usize,
    /// The characters that are accepted.
    pub accepts: Accepts,
    /// The text so far.
    pub text: String,
    /// Whether the text is a proposal, which the first character replaces.
    proposed: bool,
}

/// The effect of a key on a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Typed {
    /// Typing continues; the key may have been ignored.
    On,
    /// Enter: the line is complete.
    Done,
    /// Esc: the line is cancelled.
    Cancelled,
}

impl Entry {
    /// An empty line.
    pub fn new(area: Area, at: (i32, i32), longest: usize, accepts: Accepts) -> Entry {
        Entry { area, at, longest, accepts, text: String::new(), proposed: false }
    }

    /// The line with a proposal: Enter accepts it, the first character replaces it, Backspace edits it and Delete
    /// clears it.
    #[must_use]
    pub fn proposing(self, text: impl Into<String>) -> Entry {
        Entry { text: text.into(), proposed: true, ..self }
    }

    /// Handles a key.
    pub fn key(&mut self, key: Key) -> Typed {
        match key {
            Key::Enter => return Typed::Done,
            Key::Esc => return Typed::Cancelled,
            Key::Backspace => {
                self.text.pop();
                self.proposed = false;
            }
            Key::Delete if self.proposed => {
                self.text.clear();
                self.proposed = false;
            }
            Key::Char(typed) => {
                let letter = match self.accepts {
                    Accepts::Text => Some(typed),
                    // The Hungarian decimal separator: dropped, it would make 15 of 1,5.
                    Accepts::Number if typed == ',' => Some('.'),
                    Accepts::Number => key.letter(),
                    // File names are those of DOS, which have no accents.
                    Accepts::Name => key.letter().map(base_letter),
                };
                if let Some(letter) = letter.filter(|&letter| self.takes(letter)) {
                    self.push(letter);
                }
            }
            _ => {}
        }
        Typed::On
    }

    fn push(&mut self, letter: char) {
        if std::mem::take(&mut self.proposed) {
            self.text.clear();
        }
        if self.text.chars().count() < self.longest {
            self.text.push(letter);
        }
    }

    fn takes(&self, letter: char) -> bool {
        match self.accepts {
            Accepts::Number => letter.is_ascii_digit() || matches!(letter, '-' | '.' | 'E'),
            Accepts::Name => letter.is_ascii_alphanumeric() || matches!(letter, '-' | '.'),
            Accepts::Text => !letter.is_control(),
        }
    }

    /// Draws the window with the text.
    pub fn draw(&self, screen: &mut Screen) {
        window(screen, self.area);
        let ink = if self.proposed { Color::Yellow } else { Color::White };
        screen.text(self.at.0, self.at.1, self.shown(), ink);
    }

    /// The end of the text, as much as fits into the window.
    fn shown(&self) -> &str {
        if self.accepts != Accepts::Text {
            return &self.text;
        }
        let fitting = usize::try_from((self.area.x2 - self.at.0) / 8).unwrap_or(0);
        let hidden = self.text.chars().count().saturating_sub(fitting);
        let start = self.text.char_indices().nth(hidden).map_or(self.text.len(), |(index, _)| index);
        self.text.get(start..).unwrap_or("")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed(accepts: Accepts, longest: usize, keys: &str) -> String {
        let mut entry = Entry::new(Area::new(0, 0, 40, 12), (0, 0), longest, accepts);
        keys.chars().for_each(|letter| assert_eq!(entry.key(Key::Char(letter)), Typed::On));
        entry.text
    }

    #[test]
    fn only_what_makes_sense_is_taken() {
        assert_eq!(typed(Accepts::Number, 4, "a1-.x2345678901234567890"), "1-.2");
        assert_eq!(typed(Accepts::Number, 8, "1,5"), "1.5");
        assert_eq!(typed(Accepts::Name, 8, "six/a é\\b-1.ip2ab"), "SIXAEB-1");
    }

    #[test]
    fn a_proposal_is_taken_replaced_changed_or_emptied() {
        let after = |keys: &[Key]| {
            let entry = Entry::new(Area::new(0, 0, 40, 12), (0, 0), 8, Accepts::Text);
            let mut entry = entry.proposing("Ábra");
            keys.iter().for_each(|&key| assert_eq!(entry.key(key), Typed::On));
            entry.text
        };
        let letters = ['ő', ' ', 'B'].map(Key::Char);
        assert_eq!(after(&[]), "Ábra");
        assert_eq!(after(&letters), "ő B");
        assert_eq!(after(&[Key::Backspace, Key::Char('á')]), "Ábrá");
        assert_eq!(after(&[Key::Delete]), "");
        assert_eq!(after(&[Key::Delete, Key::Char('x'), Key::Delete]), "x");
    }

    #[test]
    fn of_a_long_text_the_end_is_shown() {
        let mut entry = Entry::new(Area::new(0, 0, 44, 12), (4, 3), 30, Accepts::Text);
        "egy hosszú cím, űrlap".chars().for_each(|letter| {
            entry.key(Key::Char(letter));
        });
        assert_eq!((entry.text.as_str(), entry.shown()), ("egy hosszú cím, űrlap", "űrlap"));
    }

    #[test]
    fn backspace_deletes_and_special_keys_type_nothing() {
        let mut entry = Entry::new(Area::new(0, 0, 40, 12), (0, 0), 3, Accepts::Name);
        for key in [
            Key::Backspace,
            Key::Char('a'),
            Key::Char('b'),
            Key::Left,
            Key::F(9),
            Key::Ctrl('K'),
            Key::Backspace,
        ] {
            assert_eq!(entry.key(key), Typed::On);
        }
        assert_eq!(entry.text, "A");
        assert_eq!(entry.key(Key::Enter), Typed::Done);
        assert_eq!(entry.key(Key::Esc), Typed::Cancelled);
    }
}
