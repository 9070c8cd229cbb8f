//! The commands of the page of surfaces.

use super::super::texts;
use crate::editor::keys::{HOME, QUIT, SAVE, TURN_DRAG, TURN_KEYS, UNDO, ZOOM};
use crate::machine::Key;
use crate::ui::{Button, Command, Commands, KeyHelp, Words, line, words};

/// What a command does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) enum Action {
    Change,
    Through,
    NextKnot,
    Envelope,
    Result,
    Quit,
    Curves,
}

const ROWS: &[Command<Action>] = &[
    Command::told((Words("egér", "mouse"), words::HELP_DRAG_3D)),
    Command::told((
        Words("csomósor", "knot lines"),
        Words(
            "u lent, v balra: húzható; kattintás: a paraméter",
            "u below, v at the left: drag a knot; click sets u, v",
        ),
    )),
    Command::told((
        Words("görgő", "wheel"),
        Words("csomó fölött: század, Ctrl-lal ezred", "over a knot: 1/100, with Ctrl 1/1000"),
    )),
    Command::button(
        Button::new(460, 4, words::CHANGE),
        line("V", "változás: pont helye, csomó értéke", "change: place of a point, value of a knot"),
        Action::Change,
    ),
    Command::button(
        Button::new(30, 21, texts::THROUGH),
        line("A", "felület egy ponton át az (u, v) helyen", "through a point at (u, v), by knots alone"),
        Action::Through,
    ),
    Command::key(Key::Tab, line("Tab", "a következő csomó", "the next knot"), Action::NextKnot),
    Command::button(
        Button::new(30, 38, texts::ENVELOPE),
        line("U", "a csomó felületeinek burkolója", "the envelope of the knot's surfaces"),
        Action::Envelope,
    ),
    Command::button(
        Button::new(460, 38, words::RESULT),
        line("E", "csak a felület", "the surface alone"),
        Action::Result,
    ),
    Command::button(Button::new(550, 38, words::QUIT), QUIT, Action::Quit),
    Command::key(Key::F(5), line("F5", "a görbék lapja", "the page of curves"), Action::Curves),
    Command::told(TURN_DRAG),
    Command::told(TURN_KEYS),
    Command::told(ZOOM),
    Command::told(HOME),
    Command::told(SAVE),
    Command::told(UNDO),
];

/// The table.
pub(super) const COMMANDS: Commands<Action> = Commands(ROWS);
/// Its help page.
pub(in super::super) const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_buttons_are_right() {
        assert_eq!(COMMANDS.too_wide(), [""; 0]);
        assert_eq!(COMMANDS.shared_keys(), []);
    }
}
