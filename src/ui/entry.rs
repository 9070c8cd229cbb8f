//! One line of typing in a black window (procedure iras of the book).

use super::frame::{Area, window};
use crate::machine::Key;
use crate::screen::{Color, Screen};

/// What may be typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accepts {
    /// Digits, minus sign, point and the E of an exponent.
    Number,
    /// Letters, digits, minus sign and point, raised to upper case.
    Name,
}

/// A line that is being typed.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The window around it.
    pub area: Area,
    /// Where the first character stands: upper left pixel.
    pub at: (i32, i32),
    /// How many characters fit.
    pub longest: usize,
    /// Which characters are taken.
    pub accepts: Accepts,
    /// What has been typed so far.
    pub text: String,
}

/// What a key did to a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Typed {
    /// The line goes on (or the key meant nothing to it).
    On,
    /// Enter: the line is complete.
    Done,
    /// Esc: nothing shall happen.
    Cancelled,
}

impl Entry {
    /// An empty line.
    pub fn new(area: Area, at: (i32, i32), longest: usize, accepts: Accepts) -> Entry {
        Entry { area, at, longest, accepts, text: String::new() }
    }

    /// Takes a key.
    pub fn key(&mut self, key: Key) -> Typed {
        match key {
            Key::Enter => return Typed::Done,
            Key::Esc => return Typed::Cancelled,
            Key::Backspace => {
                self.text.pop();
            }
            Key::Char(_) => {
                let letter = key.letter().filter(|&letter| self.takes(letter));
                if let Some(letter) = letter.filter(|_| self.text.len() < self.longest) {
                    self.text.push(letter);
                }
            }
            _ => {}
        }
        Typed::On
    }

    fn takes(&self, letter: char) -> bool {
        match self.accepts {
            Accepts::Number => letter.is_ascii_digit() || matches!(letter, '-' | '.' | 'E'),
            Accepts::Name => letter.is_ascii_alphanumeric() || matches!(letter, '-' | '.'),
        }
    }

    /// Draws the window with what has been typed.
    pub fn draw(&self, screen: &mut Screen) {
        window(screen, self.area);
        screen.text(self.at.0, self.at.1, &self.text, Color::White);
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
        assert_eq!(typed(Accepts::Name, 8, "six/a é\\b-1.ip2ab"), "SIXAB-1.");
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
