//! A line of text being typed.

use crate::machine::Key;

/// Greatest length in characters, longer than any usual path.
const LONGEST: usize = 1024;

/// A line being typed, with its cursor.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Line {
    letters: Vec<char>,
    cursor: usize,
    /// Whether it is still the proposal, which the first letter replaces.
    untouched: bool,
}

impl Line {
    /// A line with a proposal, which the first letter replaces.
    pub fn offering(text: &str) -> Line {
        let letters: Vec<char> = text.chars().filter(|letter| !letter.is_control()).take(LONGEST).collect();
        Line { cursor: letters.len(), letters, untouched: true }
    }

    /// The present text.
    pub fn text(&self) -> String {
        self.letters.iter().collect()
    }

    /// The number of letters before the cursor.
    pub fn cursor(&self) -> usize {
        self.cursor
    }

    /// Inserts, deletes or moves the cursor; returns `false` for other keys.
    pub fn key(&mut self, key: Key) -> bool {
        match key {
            Key::Char(typed) if !typed.is_control() => self.insert(typed),
            Key::Backspace => {
                if let Some(before) = self.cursor.checked_sub(1) {
                    self.letters.remove(before);
                    self.cursor = before;
                }
            }
            Key::Delete => {
                if self.cursor < self.letters.len() {
                    self.letters.remove(self.cursor);
                }
            }
            Key::Left => self.cursor = self.cursor.saturating_sub(1),
            Key::Right => self.cursor = (self.cursor + 1).min(self.letters.len()),
            Key::Home => self.cursor = 0,
            Key::End => self.cursor = self.letters.len(),
            _ => return false,
        }
        self.untouched = false;
        true
    }

    fn insert(&mut self, typed: char) {
        if self.untouched {
            self.letters.clear();
            self.cursor = 0;
        }
        if self.letters.len() < LONGEST {
            self.letters.insert(self.cursor, typed);
            self.cursor += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn type_into(line: &mut Line, keys: &[Key]) {
        for &key in keys {
            line.key(key);
        }
    }

    #[test]
    fn the_offer_is_replaced_or_changed() {
        let mut line = Line::offering("abc");
        type_into(&mut line, &[Key::Char('x'), Key::Char('y')]);
        assert_eq!(line.text(), "xy");
        let mut line = Line::offering("abc");
        type_into(&mut line, &[Key::Left, Key::Char('ő'), Key::Home, Key::Delete, Key::End, Key::Backspace]);
        assert_eq!((line.text().as_str(), line.cursor()), ("bő", 2));
    }

    #[test]
    fn nothing_leaves_the_line() {
        let mut line = Line::default();
        type_into(&mut line, &[Key::Backspace, Key::Delete, Key::Left, Key::Right]);
        assert_eq!((line.text().as_str(), line.cursor()), ("", 0));
        assert!(!line.key(Key::Enter));
        for _ in 0..2 * LONGEST {
            line.key(Key::Char('x'));
        }
        assert_eq!(line.text().len(), LONGEST);
    }
}
