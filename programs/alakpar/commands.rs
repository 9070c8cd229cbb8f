//! The commands of ALAKPAR: those of the editor of curves under their own keys, and those of parameters.

use crate::editor::curve::layer::rows as common;
use crate::machine::Key;
use crate::ui::{Area, Button, Command, Commands, Hot, KeyHelp, Pad, Words, line, words};

/// What a command does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    Insert,
    Change,
    Delete,
    DeleteHere,
    Family,
    Result,
    Quit,
    /// The first or the second parameter, by its number.
    Number(usize),
    Paths,
    Through,
    Series,
    Data,
    Comb,
    Elsewhere,
    Cubic,
    Joint,
    Alike,
    Basis,
    Elevate,
}

type Row = Command<Action>;

/// The windows of the two parameters.
pub(super) const WINDOWS: [Area; 2] = [Area::new(6, 14, 100, 27), Area::new(105, 14, 199, 27)];

const fn pad(letter: char, at: i32, text: Words, help: KeyHelp, action: Action) -> Row {
    Command::pad(Key::Char(letter), Pad { area: Area::new(at, 41, at + 46, 52), text }, help, action)
}

/// A row of the editor of curves with an action of this program.
const fn own(row: common::Row, action: Action) -> Row {
    Command { key: row.key, button: row.button, pad: row.pad, help: row.help, action: Some(action) }
}

/// A row of the editor of curves that only tells.
const fn told(row: common::Row) -> Row {
    Command { key: None, button: None, pad: None, help: row.help, action: None }
}

const CHANGE: Row = Command::button(
    Button::new(460, 4, words::CHANGE),
    (Words("V", "V"), words::HELP_CHANGE),
    Action::Change,
);
const FAMILY: Row = Command::button(
    Button::new(550, 4, Hot::new('G', "-család", "-family")),
    line("G 1-9 0 K", "család; a többi kérdés utána", "family; further questions follow"),
    Action::Family,
);
const FIRST: Row = Command::key(
    Key::Char('A'),
    line("A C", "első, második paraméter: szám", "first, second parameter: a number"),
    Action::Number(0),
);
const SECOND: Row = Command::also(Key::Char('C'), Action::Number(1));
const TURN: Row = Command::told((
    Words("görgő PgUp PgDn", "wheel PgUp PgDn"),
    Words("az ablakon, csúszkán: a paraméter", "on a window or the slider: the parameter"),
));
const PATHS: Row = pad(
    'P',
    6,
    Words("utak", "path"),
    line("P", "9 pont útja, míg a paraméter változik", "paths of 9 points while the parameter moves"),
    Action::Paths,
);
const THROUGH: Row = pad(
    'H',
    55,
    Words("célt", "hit"),
    line("H", "át egy ponton: kattintás vagy Enter, hely", "through a point: click, or Enter and place"),
    Action::Through,
);
const SERIES: Row = pad(
    'S',
    104,
    Words("sor", "fan"),
    line("S", "11 görbe a paraméter tartományában", "11 curves over the parameter's range"),
    Action::Series,
);
const DATA: Row = pad(
    'I',
    153,
    Words("adat", "data"),
    line("I", "a görbe átmegy a pontokon: be, ki", "the curve passes the points: on, off"),
    Action::Data,
);
const COMB: Row = Command::key(
    Key::Char('K'),
    line("K + -", "görbületi fésű; nagyobb, kisebb", "comb of curvature; larger, smaller"),
    Action::Comb,
);
const TO_SPACE: Row =
    Command::key(Key::F(3), line("F3", "a tér lapja", "the page of space"), Action::Elsewhere);
const TO_PLANE: Row =
    Command::key(Key::F(3), line("F3", "a sík lapja", "the page of the plane"), Action::Elsewhere);
const CUBIC: Row = Command::key(
    Key::F(4),
    line("F4", "a köbös görbe ugyanezekkel, szürkén", "the cubic curve of the same points, grey"),
    Action::Cubic,
);
const JOINT: Row = Command::key(
    Key::F(5),
    line("F5", "egy pont saját lambdája (Han, GB)", "the lambda of one point (Han, GB)"),
    Action::Joint,
);
const ALIKE: Row = Command::key(
    Key::F(6),
    line("F6", "minden lambda újra egyforma", "make all lambdas alike again"),
    Action::Alike,
);
const BASIS: Row = Command::key(
    Key::F(7),
    line("F7", "bázisfüggvények ablaka", "the blending functions in a window"),
    Action::Basis,
);
const ELEVATE: Row = Command::key(
    Key::F(8),
    line("F8", "ciklikus görbe fokának emelése", "elevate the degree of a cyclic curve"),
    Action::Elevate,
);

/// In the plane.
pub(super) const PLANE: Commands<Action> = Commands(&[
    told(common::DRAG),
    told(common::CLICK),
    own(common::INSERT, Action::Insert),
    CHANGE,
    own(common::DELETE, Action::Delete),
    own(common::DELETE_HERE, Action::DeleteHere),
    FAMILY,
    own(common::RESULT, Action::Result),
    own(common::LEAVE, Action::Quit),
    FIRST,
    SECOND,
    TURN,
    PATHS,
    THROUGH,
    SERIES,
    DATA,
    COMB,
    TO_SPACE,
    CUBIC,
    JOINT,
    ALIKE,
    BASIS,
    ELEVATE,
    told(common::SAVE),
    told(common::UNDO),
]);

/// In space.
pub(super) const SPACE: Commands<Action> = Commands(&[
    own(common::INSERT, Action::Insert),
    CHANGE,
    own(common::DELETE, Action::Delete),
    own(common::DELETE_HERE, Action::DeleteHere),
    FAMILY,
    own(common::RESULT, Action::Result),
    own(common::LEAVE, Action::Quit),
    FIRST,
    SECOND,
    TURN,
    PATHS,
    THROUGH,
    SERIES,
    DATA,
    COMB,
    told(common::DRAG_3D),
    told(common::TURN[0]),
    told(common::TURN[1]),
    told(common::TURN[2]),
    told(common::TURN[3]),
    TO_PLANE,
    CUBIC,
    JOINT,
    ALIKE,
    BASIS,
    ELEVATE,
    told(common::SAVE),
    told(common::UNDO),
]);

/// The help page of the plane.
pub(super) const PLANE_KEYS: &[KeyHelp] = &PLANE.help::<{ PLANE.lines() }>();
/// The help page of space.
pub(super) const SPACE_KEYS: &[KeyHelp] = &SPACE.help::<{ SPACE.lines() }>();

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_buttons_are_right() {
        for commands in [PLANE, SPACE] {
            assert_eq!(commands.too_wide(), [""; 0]);
            assert_eq!(commands.shared_keys(), []);
            for pad in commands.0.iter().filter_map(|command| command.pad) {
                for text in [pad.text.0, pad.text.1] {
                    assert!(text.chars().count() <= 4, "{text}");
                }
            }
        }
    }
}
