//! Maps keys of a browser to keys of programs: characters follow the user's layout, other keys their names.

use crate::machine::Key;

/// Keys that mean the same on every layout, as browsers call them.
const NAMED: [(&str, Key); 26] = [
    ("Enter", Key::Enter),
    ("Escape", Key::Esc),
    ("Backspace", Key::Backspace),
    ("Tab", Key::Tab),
    ("ArrowUp", Key::Up),
    ("ArrowDown", Key::Down),
    ("ArrowLeft", Key::Left),
    ("ArrowRight", Key::Right),
    ("Home", Key::Home),
    ("End", Key::End),
    ("PageUp", Key::PageUp),
    ("PageDown", Key::PageDown),
    ("Insert", Key::Insert),
    ("Delete", Key::Delete),
    ("F1", Key::F(1)),
    ("F2", Key::F(2)),
    ("F3", Key::F(3)),
    ("F4", Key::F(4)),
    ("F5", Key::F(5)),
    ("F6", Key::F(6)),
    ("F7", Key::F(7)),
    ("F8", Key::F(8)),
    ("F9", Key::F(9)),
    ("F10", Key::F(10)),
    ("F11", Key::F(11)),
    ("F12", Key::F(12)),
];

/// Letters that stay with the browser when Ctrl is held: a new window, a new tab, closing one, loading again, the address,
/// printing.
const BROWSERS: [char; 6] = ['N', 'T', 'W', 'R', 'L', 'P'];

/// A key press or repeat, as a browser tells it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stroke<'s> {
    /// What the key means on the user's layout.
    pub key: &'s str,
    /// Which key it is.
    pub code: &'s str,
    /// Whether Ctrl is held.
    pub ctrl: bool,
    /// Whether Alt is held.
    pub alt: bool,
    /// Whether the key of the system is held (Windows, Command).
    pub meta: bool,
    /// Whether a sign of the third level is typed (AltGr, Option).
    pub third: bool,
}

/// The key of a stroke that a program gets; `None` for those of the browser, and those that type nothing.
#[must_use]
pub fn taken(stroke: Stroke<'_>) -> Option<Key> {
    let Stroke { key, ctrl, alt, meta, third, .. } = stroke;
    let ctrl = ctrl && !alt && !third;
    if let Some(&(_, named)) = NAMED.iter().find(|(name, _)| *name == key) {
        return match named {
            // Alt with an arrow goes back, with F4 it closes the window.
            _ if meta || (alt && !third) => None,
            Key::F(number) if ctrl => Some(Key::CtrlF(number)),
            Key::Tab if ctrl => None,
            named => Some(named),
        };
    }
    let mut typed = key.chars();
    let only = typed.next().filter(|only| typed.next().is_none() && !only.is_control())?;
    if ctrl {
        return letter(only, stroke.code).filter(|letter| !BROWSERS.contains(letter)).map(Key::Ctrl);
    }
    if meta {
        // On a Mac these are what Ctrl is elsewhere.
        let letter = letter(only, stroke.code)?;
        return ['Z', 'Y', 'S'].contains(&letter).then_some(Key::Ctrl(letter));
    }
    (third || !alt).then_some(Key::Char(only))
}

/// The letter or digit of a key held with Ctrl, in upper case; on a layout that is not Latin, that of the key.
fn letter(typed: char, code: &str) -> Option<char> {
    let of_key = || code.strip_prefix("Key").and_then(|name| name.chars().next());
    let own = Some(typed).filter(char::is_ascii_alphanumeric);
    let latin = || if typed.is_ascii() { None } else { of_key() };
    own.or_else(latin).map(|letter| letter.to_ascii_uppercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    const BARE: Stroke<'_> = Stroke { key: "", code: "", ctrl: false, alt: false, meta: false, third: false };

    fn key(key: &str, code: &str) -> Option<Key> {
        taken(Stroke { key, code, ..BARE })
    }

    fn ctrl(key: &str, code: &str) -> Option<Key> {
        taken(Stroke { key, code, ctrl: true, ..BARE })
    }

    #[test]
    fn letters_come_as_the_layout_types_them() {
        assert_eq!(key("ő", "BracketLeft"), Some(Key::Char('ő')));
        assert_eq!(key(" ", "Space"), Some(Key::Char(' ')));
        assert_eq!(
            taken(Stroke { key: "@", code: "KeyV", ctrl: true, alt: true, third: true, ..BARE }),
            Some(Key::Char('@'))
        );
        for name in ["Shift", "Dead", "Unidentified", "AltGraph", ""] {
            assert_eq!(key(name, "KeyA"), None, "{name}");
        }
    }

    #[test]
    fn special_keys_are_never_letters() {
        assert_eq!(key("Enter", "NumpadEnter"), Some(Key::Enter));
        assert_eq!(key("F5", "F5"), Some(Key::F(5)));
        assert_eq!(ctrl("F12", "F12"), Some(Key::CtrlF(12)));
    }

    #[test]
    fn ctrl_takes_the_letter_of_the_layout_and_leaves_the_browser_its_own() {
        assert_eq!(ctrl("z", "KeyY"), Some(Key::Ctrl('Z')));
        assert_eq!(ctrl("я", "KeyZ"), Some(Key::Ctrl('Z')));
        assert_eq!(ctrl("1", "Digit1"), Some(Key::Ctrl('1')));
        assert_eq!(ctrl("-", "Minus"), None);
        assert_eq!(ctrl("t", "KeyT"), None);
        assert_eq!(taken(Stroke { key: "z", code: "KeyZ", meta: true, ..BARE }), Some(Key::Ctrl('Z')));
        assert_eq!(taken(Stroke { key: "q", code: "KeyQ", meta: true, ..BARE }), None);
        assert_eq!(taken(Stroke { key: "ArrowLeft", code: "ArrowLeft", alt: true, ..BARE }), None);
    }
}
