//! Maps keys of a window to keys of programs: characters follow the user's layout, other keys their names.

use crate::machine::Key;
use winit::keyboard::{Key as Logical, KeyCode, ModifiersState, NamedKey, PhysicalKey, SmolStr};

/// Keys that mean the same on every layout.
const NAMED: [(NamedKey, Key); 26] = [
    (NamedKey::Enter, Key::Enter),
    (NamedKey::Escape, Key::Esc),
    (NamedKey::Backspace, Key::Backspace),
    (NamedKey::Tab, Key::Tab),
    (NamedKey::ArrowUp, Key::Up),
    (NamedKey::ArrowDown, Key::Down),
    (NamedKey::ArrowLeft, Key::Left),
    (NamedKey::ArrowRight, Key::Right),
    (NamedKey::Home, Key::Home),
    (NamedKey::End, Key::End),
    (NamedKey::PageUp, Key::PageUp),
    (NamedKey::PageDown, Key::PageDown),
    (NamedKey::Insert, Key::Insert),
    (NamedKey::Delete, Key::Delete),
    (NamedKey::F1, Key::F(1)),
    (NamedKey::F2, Key::F(2)),
    (NamedKey::F3, Key::F(3)),
    (NamedKey::F4, Key::F(4)),
    (NamedKey::F5, Key::F(5)),
    (NamedKey::F6, Key::F(6)),
    (NamedKey::F7, Key::F(7)),
    (NamedKey::F8, Key::F(8)),
    (NamedKey::F9, Key::F(9)),
    (NamedKey::F10, Key::F(10)),
    (NamedKey::F11, Key::F(11)),
    (NamedKey::F12, Key::F(12)),
];

/// The Latin letter of a key on a non-Latin layout, for use with Ctrl.
const LATIN: [(KeyCode, char); 26] = [
    (KeyCode::KeyA, 'A'),
    (KeyCode::KeyB, 'B'),
    (KeyCode::KeyC, 'C'),
    (KeyCode::KeyD, 'D'),
    (KeyCode::KeyE, 'E'),
    (KeyCode::KeyF, 'F'),
    (KeyCode::KeyG, 'G'),
    (KeyCode::KeyH, 'H'),
    (KeyCode::KeyI, 'I'),
    (KeyCode::KeyJ, 'J'),
    (KeyCode::KeyK, 'K'),
    (KeyCode::KeyL, 'L'),
    (KeyCode::KeyM, 'M'),
    (KeyCode::KeyN, 'N'),
    (KeyCode::KeyO, 'O'),
    (KeyCode::KeyP, 'P'),
    (KeyCode::KeyQ, 'Q'),
    (KeyCode::KeyR, 'R'),
    (KeyCode::KeyS, 'S'),
    (KeyCode::KeyT, 'T'),
    (KeyCode::KeyU, 'U'),
    (KeyCode::KeyV, 'V'),
    (KeyCode::KeyW, 'W'),
    (KeyCode::KeyX, 'X'),
    (KeyCode::KeyY, 'Y'),
    (KeyCode::KeyZ, 'Z'),
];

fn find<A: PartialEq, B: Copy>(table: &[(A, B)], wanted: &A) -> Option<B> {
    table.iter().find(|(known, _)| known == wanted).map(|&(_, found)| found)
}

/// The key that a system gives commands with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CommandKey {
    Ctrl,
    /// Cmd, as well as Ctrl.
    Cmd,
}

impl CommandKey {
    /// The one of this system.
    pub(super) const HERE: CommandKey =
        if cfg!(target_os = "macos") { CommandKey::Cmd } else { CommandKey::Ctrl };

    /// Whether Cmd is held, where there is one.
    fn cmd(self, modifiers: ModifiersState) -> bool {
        self == CommandKey::Cmd && modifiers.super_key()
    }

    /// Whether a key for commands is held, be it with others.
    pub(super) fn is_held(self, modifiers: ModifiersState) -> bool {
        modifiers.control_key() || self.cmd(modifiers)
    }
}

/// A key press or repeat.
#[derive(Clone, Debug)]
pub(super) struct Stroke {
    pub(super) command: CommandKey,
    pub(super) logical: Logical,
    pub(super) physical: PhysicalKey,
    pub(super) text: Option<SmolStr>,
    pub(super) modifiers: ModifiersState,
}

impl Stroke {
    /// The keys of the stroke: usually one, none for a key that types nothing, several where a dead key did not
    /// combine.
    pub(super) fn keys(&self) -> Vec<Key> {
        // Some systems report AltGr, which types characters, as Ctrl and Alt together.
        let ctrl = self.modifiers.control_key() && !self.modifiers.alt_key();
        let ctrl = ctrl || self.command.cmd(self.modifiers);
        let named = match &self.logical {
            Logical::Named(name) => find(&NAMED, name),
            _ => None,
        };
        if let Some(key) = named {
            return vec![match key {
                Key::F(number) if ctrl => Key::CtrlF(number),
                key => key,
            }];
        }
        if ctrl {
            return self.letter().map(Key::Ctrl).into_iter().collect();
        }
        if self.modifiers.super_key() {
            return Vec::new();
        }
        let typed = self.text.as_deref().unwrap_or_default().chars();
        typed.filter(|typed| !typed.is_control()).map(Key::Char).collect()
    }

    /// Whether the stroke closes a window on this system: Cmd+Q and Cmd+W. Elsewhere the desktop tells by itself.
    pub(super) fn closes(&self) -> bool {
        self.command.cmd(self.modifiers) && matches!(self.letter(), Some('Q' | 'W'))
    }

    /// The letter or digit of a key held with Ctrl, in upper case.
    fn letter(&self) -> Option<char> {
        let own = match &self.logical {
            Logical::Character(text) => text.chars().next().filter(char::is_ascii_alphanumeric),
            _ => None,
        };
        let latin = || match &self.physical {
            PhysicalKey::Code(code) => find(&LATIN, code),
            PhysicalKey::Unidentified(_) => None,
        };
        own.or_else(latin).map(|letter| letter.to_ascii_uppercase())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stroke(
        command: CommandKey,
        logical: Logical,
        code: KeyCode,
        text: &str,
        modifiers: ModifiersState,
    ) -> Stroke {
        let text = (!text.is_empty()).then(|| SmolStr::new(text));
        Stroke { command, logical, physical: PhysicalKey::Code(code), text, modifiers }
    }

    fn keys(logical: Logical, code: KeyCode, text: &str, modifiers: ModifiersState) -> Vec<Key> {
        stroke(CommandKey::Ctrl, logical, code, text, modifiers).keys()
    }

    fn character(text: &str) -> Logical {
        Logical::Character(SmolStr::new(text))
    }

    const NONE: ModifiersState = ModifiersState::empty();
    const CTRL: ModifiersState = ModifiersState::CONTROL;

    #[test]
    fn letters_come_as_the_layout_types_them() {
        assert_eq!(keys(character("ő"), KeyCode::BracketLeft, "ő", NONE), [Key::Char('ő')]);
        assert_eq!(keys(Logical::Named(NamedKey::Space), KeyCode::Space, " ", NONE), [Key::Char(' ')]);
        assert_eq!(keys(character("4"), KeyCode::Numpad4, "4", NONE), [Key::Char('4')]);
        let alt_gr = CTRL | ModifiersState::ALT;
        assert_eq!(keys(character("@"), KeyCode::KeyV, "@", alt_gr), [Key::Char('@')]);
        assert_eq!(keys(character("x"), KeyCode::KeyX, "´x", NONE), [Key::Char('´'), Key::Char('x')]);
    }

    #[test]
    fn special_keys_are_never_letters() {
        assert_eq!(keys(Logical::Named(NamedKey::Enter), KeyCode::NumpadEnter, "\r", NONE), [Key::Enter]);
        assert_eq!(keys(Logical::Named(NamedKey::ArrowLeft), KeyCode::Numpad4, "", NONE), [Key::Left]);
        assert_eq!(keys(Logical::Named(NamedKey::F2), KeyCode::F2, "", CTRL), [Key::CtrlF(2)]);
        assert_eq!(keys(Logical::Named(NamedKey::Shift), KeyCode::ShiftLeft, "", NONE), []);
    }

    #[test]
    fn ctrl_takes_the_letter_of_the_layout() {
        assert_eq!(keys(character("z"), KeyCode::KeyY, "\u{1A}", CTRL), [Key::Ctrl('Z')]);
        assert_eq!(keys(character("я"), KeyCode::KeyZ, "\u{1A}", CTRL), [Key::Ctrl('Z')]);
        assert_eq!(keys(character("1"), KeyCode::Digit1, "1", CTRL), [Key::Ctrl('1')]);
        assert_eq!(keys(character("-"), KeyCode::Minus, "-", CTRL), []);
    }
    #[test]
    fn cmd_is_ctrl_on_a_mac_and_nothing_elsewhere() {
        let cmd = ModifiersState::SUPER;
        let on = |command, logical, code, text| stroke(command, logical, code, text, cmd);
        let z = |command| on(command, character("z"), KeyCode::KeyZ, "z");
        assert_eq!((z(CommandKey::Cmd).keys(), z(CommandKey::Ctrl).keys()), (vec![Key::Ctrl('Z')], vec![]));
        let f12 = |command| on(command, Logical::Named(NamedKey::F12), KeyCode::F12, "").keys();
        assert_eq!((f12(CommandKey::Cmd), f12(CommandKey::Ctrl)), (vec![Key::CtrlF(12)], vec![Key::F(12)]));
        // Option types characters there, with Ctrl it is no AltGr.
        let shift_cmd =
            stroke(CommandKey::Cmd, character("Z"), KeyCode::KeyZ, "Z", cmd | ModifiersState::SHIFT);
        assert_eq!(shift_cmd.keys(), [Key::Ctrl('Z')]);
        assert!(
            CommandKey::Cmd.is_held(cmd) && !CommandKey::Ctrl.is_held(cmd) && CommandKey::Ctrl.is_held(CTRL)
        );
    }

    #[test]
    fn cmd_q_and_cmd_w_close() {
        let closes = |command, letter: &str, modifiers| {
            stroke(command, character(letter), KeyCode::KeyA, letter, modifiers).closes()
        };
        let cmd = ModifiersState::SUPER;
        assert!(closes(CommandKey::Cmd, "q", cmd) && closes(CommandKey::Cmd, "w", cmd));
        assert!(!closes(CommandKey::Cmd, "e", cmd) && !closes(CommandKey::Cmd, "q", CTRL));
        assert!(!closes(CommandKey::Ctrl, "q", cmd) && !closes(CommandKey::Cmd, "q", NONE));
    }
}
