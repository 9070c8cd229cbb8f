//! The lines of the help page as keys, for displays that offer them to be touched.

use super::desk::KeyHelp;
use super::help::COMMON_KEYS;
use crate::machine::{Key, KeyLine};

/// Names of keys on the help page that scripts do not know.
const NAMED: [(&str, &[Key]); 9] = [
    ("PgUp", &[Key::PageUp]),
    ("PgDn", &[Key::PageDown]),
    ("Del", &[Key::Delete]),
    ("Ins", &[Key::Insert]),
    ("←", &[Key::Left]),
    ("→", &[Key::Right]),
    ("↑", &[Key::Up]),
    ("↓", &[Key::Down]),
    ("arrows", &[Key::Left, Key::Right, Key::Up, Key::Down]),
];

/// The lines of a manual and those of all programs. What is no key, such as the mouse, is left out.
pub(super) fn key_lines(manual: &[KeyHelp]) -> Vec<KeyLine> {
    let all = manual.iter().chain(COMMON_KEYS);
    let lines = all.map(|(label, about)| KeyLine { keys: keys_of(label.1), about: [about.0, about.1] });
    lines.filter(|line| !line.keys.is_empty()).collect()
}

/// The keys in a label such as `Ctrl+Z Ctrl+Y`, `X Y Z, U V W` or `G 1-5 S`.
fn keys_of(label: &str) -> Vec<Key> {
    let words = label.split([' ', ',']).filter(|word| !word.is_empty());
    let mut keys = Vec::new();
    for word in words {
        match NAMED.iter().find(|(name, _)| *name == word) {
            Some((_, named)) => keys.extend(*named),
            None => keys.extend(digits(word)),
        }
    }
    keys
}

/// A key by its name, or a row of digits.
fn digits(word: &str) -> Vec<Key> {
    let signs: Vec<char> = word.chars().collect();
    match signs.as_slice() {
        [from, '-', to] if from.is_ascii_digit() && to.is_ascii_digit() => {
            (*from..=*to).map(Key::Char).collect()
        }
        // Keys have names in capitals; "right" is a button of the mouse.
        [first, _, ..] if first.is_lowercase() => Vec::new(),
        _ => Key::from_name(word).into_iter().collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_keys() {
        let char = |letter| Key::Char(letter);
        assert_eq!(keys_of("Ctrl+Z Ctrl+Y"), [Key::Ctrl('Z'), Key::Ctrl('Y')]);
        assert_eq!(keys_of("X Y, U"), [char('X'), char('Y'), char('U')]);
        assert_eq!(keys_of("G 1-3 +"), [char('G'), char('1'), char('2'), char('3'), char('+')]);
        assert_eq!(keys_of("PgUp PgDn"), [Key::PageUp, Key::PageDown]);
        assert_eq!(keys_of("right button"), []);
        assert_eq!(key_lines(&[]).len(), COMMON_KEYS.len());
    }
}
