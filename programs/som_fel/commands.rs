//! The commands of SOM_FEL.

use super::texts;
use crate::editor::keys;
use crate::machine::Key;
use crate::ui::{Button, Command, Commands, Hot, KeyHelp, Words, line, words};

/// What a command does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    File,
    Cloud,
    Net,
    Learn,
    Step,
    Grow,
    Surface,
    Fit,
    Result,
    Quit,
    Shown,
    Errors,
    Colours,
    Section,
    Up,
    Down,
    Display,
    Mirror,
}

type Row = Command<Action>;

const fn button(x: i32, y: i32, text: Hot, help: KeyHelp, action: Action) -> Row {
    Command::button(Button::new(x, y, text), help, action)
}

/// Left edges of the buttons at the top and of those beside the picture.
const LEFT: i32 = 460;
const RIGHT: i32 = 550;
const BESIDE: i32 = 562;

pub(super) const COMMANDS: Commands<Action> = Commands(&[
    button(LEFT, 4, Hot::new('F', "-fájl", "-file"), texts::HELP_FILE, Action::File),
    button(RIGHT, 4, Hot::new('K', "-felhő", "-cloud"), texts::HELP_CLOUD, Action::Cloud),
    button(LEFT, 21, Hot::new('H', "-háló", "-net"), texts::HELP_NET, Action::Net),
    button(RIGHT, 21, Hot::new('T', "-tanul", "-learn"), texts::HELP_LEARN, Action::Learn),
    Command::also(Key::Char(' '), Action::Learn),
    button(BESIDE, 113, Hot::new('L', "-lépés", "-step"), texts::HELP_STEP, Action::Step),
    button(BESIDE, 96, Hot::new('N', "-növel", "-grow"), texts::HELP_GROW, Action::Grow),
    button(BESIDE, 62, Hot::new('S', "-felület", "-surface"), texts::HELP_SURFACE, Action::Surface),
    button(BESIDE, 79, Hot::new('I', "lleszt", "-fit"), texts::HELP_FIT, Action::Fit),
    button(LEFT, 38, words::RESULT, texts::HELP_RESULT, Action::Result),
    button(RIGHT, 38, words::QUIT, keys::QUIT, Action::Quit),
    Command::key(Key::F(3), texts::HELP_SHOWN, Action::Shown),
    Command::key(Key::F(4), texts::HELP_ERRORS, Action::Errors),
    Command::key(Key::F(5), line("F5", "zebra, görbület", "zebra, curvature"), Action::Colours),
    Command::key(
        Key::F(6),
        line("F6 + -", "metszet x, y, z; sík mozgatása", "section by x, y, z; move it"),
        Action::Section,
    ),
    Command::also(Key::Char('+'), Action::Up),
    Command::also(Key::Char('-'), Action::Down),
    Command::key(Key::Char('D'), texts::HELP_DISPLAY, Action::Display),
    Command::also(Key::F(8), Action::Mirror),
    Command::told(texts::HELP_LOOK),
    Command::told((Words("Ctrl+S", "Ctrl+S"), texts::HELP_SAVE)),
    Command::told(keys::UNDO),
    Command::told(texts::HELP_STOP),
]);

/// The help page.
pub(super) const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_buttons_are_right() {
        assert_eq!(COMMANDS.too_wide(), [""; 0]);
        assert_eq!(COMMANDS.shared_keys(), []);
    }
}
