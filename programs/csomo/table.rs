//! The commands of CSOMO.

use super::texts;
use crate::editor::keys::{QUIT, SAVE, UNDO};
use crate::machine::Key;
use crate::ui::{Button, Command, Commands, KeyHelp, Words, line, words};

/// What a command does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Action {
    Insert,
    Change,
    Delete,
    DeleteHere,
    Choose,
    Through,
    Paths,
    NextKnot,
    Envelope,
    Elevate,
    Opposed,
    Result,
    Quit,
    Follow,
    Compare,
    Surface,
    Comb,
    Hodograph,
    Region,
}

type Row = Command<Action>;

const ROWS: &[Row] = &[
    Command::told((Words("egér", "mouse"), words::HELP_DRAG)),
    Command::told((
        Words("csomósor", "knot line"),
        Words(
            "húzható; az alsó mind együtt, egy felső szétválaszt",
            "drag: the lowest takes all copies, a higher splits",
        ),
    )),
    Command::told((
        Words("Shift, görgő", "Shift, wheel"),
        Words(
            "a szomszédokon túl; görgő: század, Ctrl-lal ezred",
            "beyond neighbours; 1/100, with Ctrl 1/1000",
        ),
    )),
    Command::told((Words("csík", "strip"), Words("kattintás: az u paraméter", "click: the parameter u"))),
    Command::button(
        Button::new(460, 4, words::CHANGE),
        line("V", "változás: pont, csomó vagy súly", "change: point, knot or weight"),
        Action::Change,
    ),
    Command::button(
        Button::new(460, 21, words::INSERT),
        line("B", "pont vagy csomó beszúrása", "insert a point or a knot"),
        Action::Insert,
    ),
    Command::button(
        Button::new(550, 21, words::DELETE),
        line(
            "T",
            "pont vagy csomó törlése; előbb megmondja a hibát",
            "delete a point or a knot; tells the error",
        ),
        Action::Delete,
    ),
    Command::key(Key::Delete, (Words("Del", "Del"), words::HELP_DELETE_HERE), Action::DeleteHere),
    Command::button(
        Button::new(550, 4, words::CURVE),
        line("G", "rend 2-8; nyitott, rögzített végű, zárt", "order 2-8; open, clamped, closed"),
        Action::Choose,
    ),
    Command::button(
        Button::new(460, 38, words::RESULT),
        (Words("E", "E"), words::HELP_RESULT),
        Action::Result,
    ),
    Command::button(Button::new(550, 38, words::QUIT), QUIT, Action::Quit),
    Command::button(
        Button::new(30, 21, texts::THROUGH),
        line("A", "görbe egy ponton át csak a csomókkal", "through a point by knots alone"),
        Action::Through,
    ),
    Command::button(
        Button::new(120, 21, texts::PATHS),
        line(
            "P Tab",
            "a csomó mozgásának pályái; a következő csomó",
            "paths while the knot moves; next knot",
        ),
        Action::Paths,
    ),
    Command::also(Key::Tab, Action::NextKnot),
    Command::button(
        Button::new(30, 38, texts::ENVELOPE),
        line("U", "a csomó görbéinek burkolója", "the envelope of the knot's curves"),
        Action::Envelope,
    ),
    Command::button(
        Button::new(120, 38, texts::ELEVATE),
        line("F", "fokszámemelés, a görbe marad", "raise the degree, the curve stays"),
        Action::Elevate,
    ),
    Command::key(
        Key::Char('L'),
        line("L", "két csomó egymás ellen", "two knots against each other"),
        Action::Opposed,
    ),
    Command::key(Key::F(3), line("F3", "húzás közben is él", "live while dragging"), Action::Follow),
    Command::key(
        Key::F(4),
        line("F4", "mellette a kezdeti görbe", "the curve at the start too"),
        Action::Compare,
    ),
    Command::key(Key::F(5), line("F5", "a felületek lapja", "the page of surfaces"), Action::Surface),
    Command::key(Key::F(6), line("F6", "görbületi fésű", "comb of curvature"), Action::Comb),
    Command::key(Key::F(7), line("F7", "hodográf", "hodograph"), Action::Hodograph),
    Command::key(Key::F(8), line("F8", "az elérhető tartomány", "the reachable region"), Action::Region),
    Command::told(SAVE),
    Command::told(UNDO),
];

/// The table.
pub(super) const COMMANDS: Commands<Action> = Commands(ROWS);
/// Its help page.
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
