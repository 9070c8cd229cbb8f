//! The commands of the page of space.

use super::super::commands::told;
use crate::editor::curve::layer::rows as common;
use crate::machine::Key;
use crate::ui::{Area, Button, Command, Commands, Hot, KeyHelp, Pad, Words, line, words};

/// What a command does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Action {
    Insert,
    Change,
    Delete,
    DeleteHere,
    Clearing,
    Result,
    Quit,
    Ring,
    Elsewhere,
    Touching,
    Filled,
    Nearest,
}

type Row = Command<Action>;

const fn pad(key: Key, (x, y): (i32, i32), text: Words, help: KeyHelp, action: Action) -> Row {
    Command::pad(key, Pad { area: Area::new(x, y, x + 92, y + 12), text }, help, action)
}

const DRAG: Row = Command::told((
    Words("egér", "mouse"),
    Words(
        "gömb húzása a kép síkjában; pereme: sugár",
        "drag a sphere in the picture's plane; its rim: radius",
    ),
));
const SIZE: Row =
    Command::told((Words("görgő gömbön", "wheel on it"), Words("a gömb sugara", "the radius of the sphere")));
const CHANGE: Row = Command::button(
    Button::new(460, 4, words::CHANGE),
    line("V", "gömb változtatása: hely vagy sugár", "change a sphere: place or radius"),
    Action::Change,
);
const SKIN: Row = Command::button(
    Button::new(550, 4, Hot::new('G', "-burok", "-skin")),
    line("G", "burkoló: sima út vagy tiszta út", "skin: plain or cleared"),
    Action::Clearing,
);
const INSERT: Row = Command::button(
    Button::new(460, 21, words::INSERT),
    line("B", "új gömb: sorszám; a végén hely, sugár", "a new sphere: number; at an end place, radius"),
    Action::Insert,
);
const DELETE: Row = Command::button(
    Button::new(550, 21, words::DELETE),
    line("T", "gömb törlése: sorszám", "delete a sphere: number"),
    Action::Delete,
);
const DELETE_HERE: Row = Command::key(
    Key::Delete,
    line("Del", "az egér alatti gömb törlése", "delete the sphere under the mouse"),
    Action::DeleteHere,
);
const RESULT: Row = Command::button(
    Button::new(460, 38, words::RESULT),
    line("E", "eredmény: a burkoló keret nélkül", "result: the skin alone, without the frame"),
    Action::Result,
);
const LEAVE: Row =
    Command::button(Button::new(550, 38, words::QUIT), (Words("Q", "Q"), words::HELP_QUIT), Action::Quit);
const RING: Row = pad(
    Key::Char('K'),
    (6, 37),
    Words("gyűrű", "ring"),
    line("K", "gyűrű vagy lánc", "a ring or a chain"),
    Action::Ring,
);
const ELSEWHERE: Row = pad(
    Key::F(5),
    (105, 37),
    Words("sík", "plane"),
    line("F5", "a sík lapja ugyanezzel a lánccal", "the page of the plane with the same chain"),
    Action::Elsewhere,
);
const TOUCHING: Row = pad(
    Key::F(6),
    (6, 20),
    Words("körök", "circles"),
    line("F6", "érintőkörök", "the touching circles"),
    Action::Touching,
);
const FILLED: Row = pad(
    Key::F(7),
    (105, 20),
    Words("felület", "surface"),
    line("F7", "felület: vonalak vagy kitöltve", "the surface by lines or filled"),
    Action::Filled,
);
const NEAREST: Row = Command::key(
    Key::F(8),
    line("F8", "a legközelebbi megengedett sugarak", "the nearest admissible radii"),
    Action::Nearest,
);

/// In space.
pub(super) const SPACE: Commands<Action> = Commands(&[
    DRAG,
    SIZE,
    INSERT,
    CHANGE,
    DELETE,
    DELETE_HERE,
    SKIN,
    RESULT,
    LEAVE,
    RING,
    ELSEWHERE,
    TOUCHING,
    FILLED,
    NEAREST,
    told(common::TURN[0]),
    told(common::TURN[1]),
    told(common::TURN[2]),
    told(common::TURN[3]),
    told(common::SAVE),
    told(common::UNDO),
]);

/// The help page.
pub(crate) const SPACE_KEYS: &[KeyHelp] = &SPACE.help::<{ SPACE.lines() }>();

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_buttons_are_right() {
        assert_eq!(SPACE.too_wide(), [""; 0]);
        assert_eq!(SPACE.shared_keys(), []);
        for pad in SPACE.0.iter().filter_map(|command| command.pad) {
            for text in [pad.text.0, pad.text.1] {
                assert!(text.chars().count() <= 8, "{text}");
            }
        }
    }
}
