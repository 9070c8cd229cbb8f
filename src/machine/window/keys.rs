//! Keys of a window as programs see them.
//!
//! A window tells two things: which key went down, and which character the user's layout makes of it.
//! The order of the two differs from system to system, and either may come alone. Characters come from
//! the layout; everything that types none comes from the key.

use super::super::event::Key;
use minifb::{InputCallback, Key as Stroke};
use std::cell::RefCell;
use std::rc::Rc;
use std::time::{Duration, Instant};

/// What the window told, in its order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Told {
    Down(Stroke),
    Up(Stroke),
    Typed(char),
}

impl Told {
    fn typed(self) -> Option<char> {
        match self {
            Told::Typed(typed) => Some(typed),
            Told::Down(_) | Told::Up(_) => None,
        }
    }
}

/// The list that a window writes to while it looks for events.
#[derive(Clone, Default)]
pub(super) struct Heard(Rc<RefCell<Vec<Told>>>);

impl Heard {
    /// What was told since the last time.
    pub(super) fn take(&self) -> Vec<Told> {
        self.0.take()
    }
}

impl InputCallback for Heard {
    fn add_char(&mut self, code: u32) {
        if let Some(typed) = char::from_u32(code) {
            self.0.borrow_mut().push(Told::Typed(typed));
        }
    }

    fn set_key_state(&mut self, key: Stroke, down: bool) {
        self.0.borrow_mut().push(if down { Told::Down(key) } else { Told::Up(key) });
    }
}

/// Keys that mean the same on every layout.
const SPECIAL: [(Stroke, Key); 27] = [
    (Stroke::Enter, Key::Enter),
    (Stroke::NumPadEnter, Key::Enter),
    (Stroke::Escape, Key::Esc),
    (Stroke::Backspace, Key::Backspace),
    (Stroke::Tab, Key::Tab),
    (Stroke::Up, Key::Up),
    (Stroke::Down, Key::Down),
    (Stroke::Left, Key::Left),
    (Stroke::Right, Key::Right),
    (Stroke::Home, Key::Home),
    (Stroke::End, Key::End),
    (Stroke::PageUp, Key::PageUp),
    (Stroke::PageDown, Key::PageDown),
    (Stroke::Insert, Key::Insert),
    (Stroke::Delete, Key::Delete),
    (Stroke::F1, Key::F(1)),
    (Stroke::F2, Key::F(2)),
    (Stroke::F3, Key::F(3)),
    (Stroke::F4, Key::F(4)),
    (Stroke::F5, Key::F(5)),
    (Stroke::F6, Key::F(6)),
    (Stroke::F7, Key::F(7)),
    (Stroke::F8, Key::F(8)),
    (Stroke::F9, Key::F(9)),
    (Stroke::F10, Key::F(10)),
    (Stroke::F11, Key::F(11)),
    (Stroke::F12, Key::F(12)),
];

/// What the keys of the number pad do when they type nothing (Num Lock is off).
const UNLOCKED: [(Stroke, Key); 10] = [
    (Stroke::NumPad0, Key::Insert),
    (Stroke::NumPad1, Key::End),
    (Stroke::NumPad2, Key::Down),
    (Stroke::NumPad3, Key::PageDown),
    (Stroke::NumPad4, Key::Left),
    (Stroke::NumPad6, Key::Right),
    (Stroke::NumPad7, Key::Home),
    (Stroke::NumPad8, Key::Up),
    (Stroke::NumPad9, Key::PageUp),
    (Stroke::NumPadDot, Key::Delete),
];

/// The keys that make a character with Ctrl where the layout does not say which one.
const LETTERS: [(Stroke, char); 36] = [
    (Stroke::A, 'A'),
    (Stroke::B, 'B'),
    (Stroke::C, 'C'),
    (Stroke::D, 'D'),
    (Stroke::E, 'E'),
    (Stroke::F, 'F'),
    (Stroke::G, 'G'),
    (Stroke::H, 'H'),
    (Stroke::I, 'I'),
    (Stroke::J, 'J'),
    (Stroke::K, 'K'),
    (Stroke::L, 'L'),
    (Stroke::M, 'M'),
    (Stroke::N, 'N'),
    (Stroke::O, 'O'),
    (Stroke::P, 'P'),
    (Stroke::Q, 'Q'),
    (Stroke::R, 'R'),
    (Stroke::S, 'S'),
    (Stroke::T, 'T'),
    (Stroke::U, 'U'),
    (Stroke::V, 'V'),
    (Stroke::W, 'W'),
    (Stroke::X, 'X'),
    (Stroke::Y, 'Y'),
    (Stroke::Z, 'Z'),
    (Stroke::Key0, '0'),
    (Stroke::Key1, '1'),
    (Stroke::Key2, '2'),
    (Stroke::Key3, '3'),
    (Stroke::Key4, '4'),
    (Stroke::Key5, '5'),
    (Stroke::Key6, '6'),
    (Stroke::Key7, '7'),
    (Stroke::Key8, '8'),
    (Stroke::Key9, '9'),
];

fn find<T: Copy>(table: &[(Stroke, T)], stroke: Stroke) -> Option<T> {
    table.iter().find(|(known, _)| *known == stroke).map(|&(_, found)| found)
}

/// How a windowing system tells keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Telling {
    /// A key before the character it types, and again and again while it is held.
    KeyFirst,
    /// A key after the character it types, and once only: programs repeat it (Wayland).
    KeyLast,
}

/// How long a key is held before it repeats, and the time between repetitions.
const REPEAT: (Duration, Duration) = (Duration::from_millis(500), Duration::from_millis(33));

/// Makes keys out of what a window tells.
pub(super) struct Keyboard {
    telling: Telling,
    /// Left and right Ctrl, left and right Alt.
    modifiers: [bool; 4],
    held: Option<(Stroke, Key, Instant)>,
}

impl Keyboard {
    pub(super) fn new(telling: Telling) -> Keyboard {
        Keyboard { telling, modifiers: [false; 4], held: None }
    }

    pub(super) fn telling(&self) -> Telling {
        self.telling
    }

    /// Forgets what is held: the window lost the keyboard and will not hear of the releases.
    pub(super) fn let_go(&mut self) {
        *self = Keyboard::new(self.telling);
    }

    /// The keys of what the window told since the last time.
    pub(super) fn keys(&mut self, told: &[Told], now: Instant) -> Vec<Key> {
        let mut keys = Vec::new();
        let mut before = None;
        for (place, &item) in told.iter().enumerate() {
            match item {
                Told::Typed(typed) => keys.extend(self.typed(typed)),
                Told::Down(stroke) => {
                    self.modify(stroke, true);
                    let character = match self.telling {
                        Telling::KeyFirst => told.get(place + 1).copied().and_then(Told::typed),
                        Telling::KeyLast => before.and_then(Told::typed),
                    };
                    let own = self.stroke(stroke, character);
                    keys.extend(own);
                    self.hold(stroke, own.or(character.and_then(|typed| self.typed(typed))), now);
                }
                Told::Up(stroke) => {
                    self.modify(stroke, false);
                    self.held = self.held.filter(|held| held.0 != stroke);
                }
            }
            before = Some(item);
        }
        keys.extend(self.repetition(now));
        keys
    }

    fn ctrl(&self) -> bool {
        // Ctrl and Alt together are how some systems tell AltGr, which types characters.
        (self.modifiers[0] || self.modifiers[1]) && !(self.modifiers[2] || self.modifiers[3])
    }

    fn modify(&mut self, stroke: Stroke, down: bool) {
        let known = [Stroke::LeftCtrl, Stroke::RightCtrl, Stroke::LeftAlt, Stroke::RightAlt];
        for (modifier, state) in known.into_iter().zip(&mut self.modifiers) {
            if modifier == stroke {
                *state = down;
            }
        }
    }

    fn typed(&self, typed: char) -> Option<Key> {
        // Some systems tell arrows as characters of the private use area.
        let private = ('\u{E000}'..='\u{F8FF}').contains(&typed);
        (!typed.is_control() && !private && !self.ctrl()).then_some(Key::Char(typed))
    }

    /// The key that a stroke is by itself; `None` when its character tells it, or nothing does.
    fn stroke(&self, stroke: Stroke, character: Option<char>) -> Option<Key> {
        if let Some(key) = find(&SPECIAL, stroke) {
            return Some(match key {
                Key::F(number) if self.ctrl() => Key::CtrlF(number),
                key => key,
            });
        }
        if self.ctrl()
            && let Some(letter) = find(&LETTERS, stroke)
        {
            return Some(Key::Ctrl(character.and_then(control_letter).unwrap_or(letter)));
        }
        let types = character.is_some_and(|typed| !typed.is_control());
        find(&UNLOCKED, stroke).filter(|_| !types)
    }

    fn hold(&mut self, stroke: Stroke, made: Option<Key>, now: Instant) {
        if self.telling == Telling::KeyLast
            && let Some(key) = made
        {
            self.held = Some((stroke, key, now + REPEAT.0));
        }
    }

    fn repetition(&mut self, now: Instant) -> Option<Key> {
        let (_, key, due) = self.held.as_mut().filter(|held| held.2 <= now)?;
        *due = now + REPEAT.1;
        Some(*key)
    }
}

/// The letter of a control character: the layout's own word on which letter was held with Ctrl.
fn control_letter(typed: char) -> Option<char> {
    matches!(typed, '\u{1}'..='\u{1A}').then(|| char::from_u32(u32::from(typed) + 64)).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;
    use Told::{Down, Typed, Up};

    fn keys(told: &[Told]) -> Vec<Key> {
        Keyboard::new(Telling::KeyFirst).keys(told, Instant::now())
    }

    fn wayland_keys(told: &[Told]) -> Vec<Key> {
        Keyboard::new(Telling::KeyLast).keys(told, Instant::now())
    }

    #[test]
    fn a_letter_is_one_key_in_whatever_order_it_is_told() {
        assert_eq!(keys(&[Down(Stroke::A), Typed('á')]), [Key::Char('á')]);
        assert_eq!(wayland_keys(&[Typed('á'), Down(Stroke::A)]), [Key::Char('á')]);
        assert_eq!(keys(&[Down(Stroke::Enter), Typed('\r'), Up(Stroke::Enter)]), [Key::Enter]);
        assert_eq!(keys(&[Down(Stroke::Up), Typed('\u{F700}')]), [Key::Up]);
    }

    #[test]
    fn ctrl_takes_the_letter_of_the_layout() {
        let ctrl = Down(Stroke::LeftCtrl);
        assert_eq!(keys(&[ctrl, Down(Stroke::Y), Typed('\u{1A}')]), [Key::Ctrl('Z')]);
        assert_eq!(wayland_keys(&[ctrl, Typed('z'), Down(Stroke::Z)]), [Key::Ctrl('Z')]);
        assert_eq!(keys(&[ctrl, Down(Stroke::F2)]), [Key::CtrlF(2)]);
        assert_eq!(keys(&[ctrl, Down(Stroke::Enter), Typed('\n')]), [Key::Enter]);
        let released = [ctrl, Up(Stroke::LeftCtrl), Down(Stroke::Z), Typed('z')];
        assert_eq!(keys(&released), [Key::Char('z')]);
    }

    #[test]
    fn alt_gr_types() {
        let told = [Down(Stroke::LeftCtrl), Down(Stroke::RightAlt), Down(Stroke::V), Typed('@')];
        assert_eq!(keys(&told), [Key::Char('@')]);
    }

    #[test]
    fn number_pad_types_or_moves() {
        assert_eq!(keys(&[Down(Stroke::NumPad4), Typed('4')]), [Key::Char('4')]);
        assert_eq!(wayland_keys(&[Typed('4'), Down(Stroke::NumPad4)]), [Key::Char('4')]);
        let quickly = [Down(Stroke::X), Typed('x'), Down(Stroke::NumPad4)];
        assert_eq!(keys(&quickly), [Key::Char('x'), Key::Left]);
        assert_eq!(keys(&[Down(Stroke::NumPad4)]), [Key::Left]);
        assert_eq!(keys(&[Down(Stroke::NumPadPlus), Typed('+')]), [Key::Char('+')]);
    }

    #[test]
    fn the_window_repeats_where_nobody_else_does() {
        let start = Instant::now();
        let mut keyboard = Keyboard::new(Telling::KeyLast);
        assert_eq!(keyboard.keys(&[Typed('x'), Down(Stroke::X)], start), [Key::Char('x')]);
        assert_eq!(keyboard.keys(&[], start + Duration::from_millis(400)), []);
        assert_eq!(keyboard.keys(&[], start + Duration::from_millis(501)), [Key::Char('x')]);
        assert_eq!(keyboard.keys(&[], start + Duration::from_millis(510)), []);
        assert_eq!(keyboard.keys(&[Up(Stroke::X)], start + Duration::from_millis(900)), []);
        assert_eq!(keyboard.keys(&[], start + Duration::from_secs(9)), []);
    }
}
