//! The commands of SOM_FEL.

use super::texts;
use crate::editor::keys;
use crate::machine::Key;
use crate::ui::{Area, Button, Command, Commands, Hot, KeyHelp, Pad, Words, line, words};

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

/// Left edges of the buttons at the top.
const LEFT: i32 = 460;
const RIGHT: i32 = 550;
/// The buttons beside the picture, which is where the words are too long for the others.
const fn beside(letter: char, row: i32, text: Words, help: KeyHelp, action: Action) -> Row {
    let y = 62 + 18 * row;
    Command::pad(Key::Char(letter), Pad { area: Area::new(558, y, 634, y + 13), text }, help, action)
}

pub(super) const COMMANDS: Commands<Action> = Commands(&[
    button(LEFT, 4, Hot::new('F', "-fájl", "-file"), texts::HELP_FILE, Action::File),
    button(RIGHT, 4, Hot::new('K', "-felhő", "-cloud"), texts::HELP_CLOUD, Action::Cloud),
    button(LEFT, 21, Hot::new('H', "-háló", "-net"), texts::HELP_NET, Action::Net),
    button(RIGHT, 21, Hot::new('T', "-tanul", "-learn"), texts::HELP_LEARN, Action::Learn),
    Command::also(Key::Char(' '), Action::Learn),
    beside('L', 3, Words("lépés", "step"), texts::HELP_STEP, Action::Step),
    beside('N', 2, Words("növel", "grow"), texts::HELP_GROW, Action::Grow),
    beside('S', 0, Words("felület", "surface"), texts::HELP_SURFACE, Action::Surface),
    beside('I', 1, Words("illeszt", "fit"), texts::HELP_FIT, Action::Fit),
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
        for pad in COMMANDS.0.iter().filter_map(|command| command.pad) {
            for text in [pad.text.0, pad.text.1] {
                assert!(text.chars().count() <= 7, "{text}");
            }
        }
    }
}
