//! Events of a program: keys, mouse and time, in the order in which they happened.

use std::fmt;
use std::time::Duration;

/// A key as a program sees it. Special keys are special keys, never letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Key {
    /// A key that types a character, the space bar included.
    Char(char),
    /// A letter held together with Ctrl, in upper case.
    Ctrl(char),
    /// A function key, `F(1)` to `F(12)`.
    F(u8),
    /// Ctrl and a function key.
    CtrlF(u8),
    /// The Enter key.
    Enter,
    /// The Escape key.
    Esc,
    /// The Backspace key.
    Backspace,
    /// The Tab key.
    Tab,
    /// Arrow up.
    Up,
    /// Arrow down.
    Down,
    /// Arrow left.
    Left,
    /// Arrow right.
    Right,
    /// The Home key.
    Home,
    /// The End key.
    End,
    /// The Page Up key.
    PageUp,
    /// The Page Down key.
    PageDown,
    /// The Insert key.
    Insert,
    /// The Delete key.
    Delete,
}

/// The keys with a name in scripts.
const NAMED: [(&str, Key); 15] = [
    ("Enter", Key::Enter),
    ("Esc", Key::Esc),
    ("Backspace", Key::Backspace),
    ("Tab", Key::Tab),
    ("Space", Key::Char(' ')),
    ("Up", Key::Up),
    ("Down", Key::Down),
    ("Left", Key::Left),
    ("Right", Key::Right),
    ("Home", Key::Home),
    ("End", Key::End),
    ("PageUp", Key::PageUp),
    ("PageDown", Key::PageDown),
    ("Insert", Key::Insert),
    ("Delete", Key::Delete),
];

impl Key {
    /// The key of a name as scripts write it (`A`, `7`, `Enter`, `F1`, `Ctrl+Z`); case does not matter.
    pub fn from_name(name: &str) -> Option<Key> {
        let mut chars = name.chars();
        if let (Some(only), None) = (chars.next(), chars.next()) {
            return (!only.is_control() && !only.is_whitespace()).then(|| Key::Char(upper(only)));
        }
        if let Some(&(_, key)) = NAMED.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)) {
            return Some(key);
        }
        if let Some(rest) = strip_prefix_ignore_case(name, "Ctrl+") {
            return match Key::from_name(rest)? {
                Key::Char(letter) if letter.is_ascii_alphanumeric() => Some(Key::Ctrl(letter)),
                Key::F(number) => Some(Key::CtrlF(number)),
                _ => None,
            };
        }
        let number = strip_prefix_ignore_case(name, "F")?.parse().ok()?;
        (1..=12).contains(&number).then_some(Key::F(number))
    }

    /// The letter or sign that the key types, raised to upper case, as the hot letters are matched.
    pub fn letter(self) -> Option<char> {
        match self {
            Key::Char(typed) => Some(upper(typed)),
            _ => None,
        }
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Key::Ctrl(letter) => write!(f, "Ctrl+{letter}"),
            Key::F(number) => write!(f, "F{number}"),
            Key::CtrlF(number) => write!(f, "Ctrl+F{number}"),
            key => match (NAMED.iter().find(|(_, named)| named == key), key) {
                (Some((name, _)), _) => f.write_str(name),
                (None, Key::Char(typed)) => write!(f, "{typed}"),
                (None, _) => Ok(()),
            },
        }
    }
}

/// A character in upper case; unchanged if its upper case is several characters.
fn upper(letter: char) -> char {
    let mut capital = letter.to_uppercase();
    match (capital.next(), capital.next()) {
        (Some(one), None) => one,
        _ => letter,
    }
}

fn strip_prefix_ignore_case<'a>(text: &'a str, prefix: &str) -> Option<&'a str> {
    let head = text.get(..prefix.len())?;
    head.eq_ignore_ascii_case(prefix).then(|| &text[prefix.len()..])
}

/// A mouse button.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Button {
    /// The left button, which does nearly everything.
    Left,
    /// The right button.
    Right,
    /// The middle button.
    Middle,
}

impl Button {
    /// Every button with its name in scripts.
    pub const ALL: [(&'static str, Button); 3] =
        [("left", Button::Left), ("right", Button::Right), ("middle", Button::Middle)];

    /// The button of a name as scripts write it.
    pub fn from_name(name: &str) -> Option<Button> {
        Button::ALL.iter().find(|(known, _)| *known == name).map(|&(_, button)| button)
    }

    /// The name in scripts.
    pub fn name(self) -> &'static str {
        match self {
            Button::Left => "left",
            Button::Right => "right",
            Button::Middle => "middle",
        }
    }
}

/// A key that, while it is held, changes what the mouse does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Modifier {
    /// Shift.
    Shift,
    /// Ctrl.
    Ctrl,
}

impl Modifier {
    /// Every modifier with its name in scripts.
    pub const ALL: [(&'static str, Modifier); 2] = [("shift", Modifier::Shift), ("ctrl", Modifier::Ctrl)];

    /// The modifier of a name as scripts write it.
    pub fn from_name(name: &str) -> Option<Modifier> {
        Modifier::ALL.iter().find(|(known, _)| *known == name).map(|&(_, modifier)| modifier)
    }

    /// The name in scripts.
    pub fn name(self) -> &'static str {
        match self {
            Modifier::Shift => "shift",
            Modifier::Ctrl => "ctrl",
        }
    }
}

/// An event of the display.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A key was pressed (or repeats).
    Key(Key),
    /// The mouse moved to this pixel of the 640x480 screen.
    Move(i32, i32),
    /// A mouse button went down.
    Press(Button),
    /// A mouse button went up.
    Release(Button),
    /// The wheel turned, in steps, away from the user positive.
    Wheel(i32),
    /// A modifier went down (`true`) or up.
    Hold(Modifier, bool),
    /// The window's close button.
    Close,
}

/// Where the mouse is and which buttons are down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mouse {
    /// Pixels from the left edge, 0 to 639.
    pub x: i32,
    /// Pixels from the top, 0 to 479.
    pub y: i32,
    /// Whether left, right and middle button are down.
    pub down: [bool; 3],
    /// Whether Shift and Ctrl are.
    pub with: [bool; 2],
}

impl Default for Mouse {
    /// In the middle of the screen, nothing pressed.
    fn default() -> Self {
        Mouse {
            x: crate::screen::WIDTH / 2,
            y: crate::screen::HEIGHT / 2,
            down: [false; 3],
            with: [false; 2],
        }
    }
}

impl Mouse {
    /// Whether a button is held.
    pub fn holds(&self, button: Button) -> bool {
        self.down[button as usize]
    }

    /// Whether a modifier is held.
    pub fn with(&self, modifier: Modifier) -> bool {
        self.with[modifier as usize]
    }

    /// The mouse after an event.
    pub(super) fn after(mut self, event: Event) -> Mouse {
        match event {
            Event::Move(x, y) => {
                self.x = x.clamp(0, crate::screen::WIDTH - 1);
                self.y = y.clamp(0, crate::screen::HEIGHT - 1);
            }
            Event::Press(button) => self.down[button as usize] = true,
            Event::Release(button) => self.down[button as usize] = false,
            Event::Hold(modifier, down) => self.with[modifier as usize] = down,
            Event::Key(_) | Event::Wheel(_) | Event::Close => {}
        }
        self
    }
}

/// What a program wakes up with: an event, or none when a deadline or frame is due.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    /// What happened; `None` when only time passed.
    pub event: Option<Event>,
    /// Time since the program started.
    pub now: Duration,
    /// The mouse after the event.
    pub mouse: Mouse,
}

impl Tick {
    /// The key of this tick.
    pub fn key(&self) -> Option<Key> {
        match self.event {
            Some(Event::Key(key)) => Some(key),
            _ => None,
        }
    }

    /// The letter of this tick in upper case, as the hot letters are matched.
    pub fn letter(&self) -> Option<char> {
        self.key().and_then(Key::letter)
    }

    /// Whether this very key was pressed.
    pub fn pressed(&self, key: Key) -> bool {
        self.key() == Some(key)
    }

    /// Where the left button went down.
    pub fn click(&self) -> Option<(i32, i32)> {
        (self.event == Some(Event::Press(Button::Left))).then_some((self.mouse.x, self.mouse.y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_name_reads_back() {
        let mut keys: Vec<Key> = NAMED.iter().map(|&(_, key)| key).collect();
        keys.extend((1..=12).flat_map(|n| [Key::F(n), Key::CtrlF(n)]));
        keys.extend(('A'..='Z').chain('0'..='9').flat_map(|c| [Key::Char(c), Key::Ctrl(c)]));
        keys.extend(['.', '-', '+', 'Ő'].map(Key::Char));
        for key in keys {
            assert_eq!(Key::from_name(&key.to_string()), Some(key), "{key}");
        }
    }

    #[test]
    fn case_does_not_matter_and_nonsense_has_no_key() {
        assert_eq!(Key::from_name("enter"), Some(Key::Enter));
        assert_eq!(Key::from_name("f12"), Some(Key::F(12)));
        assert_eq!(Key::from_name("ctrl+z"), Some(Key::Ctrl('Z')));
        assert_eq!(Key::from_name("a"), Some(Key::Char('A')));
        for nonsense in ["", " ", "F0", "F13", "Ctrl+", "Ctrl+Enter", "Return", "Ctrl+Ctrl+Z"] {
            assert_eq!(Key::from_name(nonsense), None, "{nonsense:?}");
        }
    }

    #[test]
    fn mouse_stays_on_the_screen() {
        let mouse = Mouse::default().after(Event::Move(i32::MIN, i32::MAX));
        assert_eq!((mouse.x, mouse.y), (0, 479));
        assert!(mouse.after(Event::Press(Button::Right)).holds(Button::Right));
    }
}
