//! The commands of BURKOLO.

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
    Skin,
    Result,
    Quit,
    Link,
    Ring,
    Apollonius,
    Radical,
    Elsewhere,
    Nearest,
}

type Row = Command<Action>;

const fn pad(letter: char, (x, y): (i32, i32), text: Words, help: KeyHelp, action: Action) -> Row {
    Command::pad(Key::Char(letter), Pad { area: Area::new(x, y, x + 92, y + 12), text }, help, action)
}

/// A row of the editor of curves that only tells.
pub(super) const fn told<A>(row: common::Row) -> Command<A> {
    Command { key: None, button: None, pad: None, help: row.help, action: None }
}

const DRAG: Row = Command::told((
    Words("egér", "mouse"),
    Words("kör húzása; új a Tárból; ki a mezőről: törlés", "drag a disc (new: New); off the field to delete"),
));
const SIZE: Row =
    Command::told((Words("perem, görgő", "rim, wheel"), Words("a kör sugara", "the radius of a circle")));
const CLICK: Row =
    Command::told((Words("kattintás", "click"), Words("a mezőn: új kör", "on the field: a new circle")));
const CHANGE: Row = Command::button(
    Button::new(460, 4, words::CHANGE),
    line("V", "kör változtatása: hely vagy sugár", "change a circle: place or radius"),
    Action::Change,
);
const SKIN: Row = Command::button(
    Button::new(550, 4, Hot::new('G', "-burok", "-skin")),
    line(
        "G N S K P T",
        "burkoló: nyitott, sapkás, kitöltött; sima, tiszta",
        "skin: open, caps, filled; plain, cleared",
    ),
    Action::Skin,
);
const INSERT: Row = Command::button(
    Button::new(460, 21, words::INSERT),
    line("B", "új kör két szomszéd között", "a new circle between two neighbours"),
    Action::Insert,
);
const DELETE: Row = Command::button(
    Button::new(550, 21, words::DELETE),
    line("T", "kör törlése: sorszám", "delete a circle: number"),
    Action::Delete,
);
const DELETE_HERE: Row = Command::key(
    Key::Delete,
    line("Del", "az egér alatti kör törlése", "delete the circle under the mouse"),
    Action::DeleteHere,
);
const RESULT: Row = Command::button(
    Button::new(460, 38, words::RESULT),
    line("E", "eredmény: a burkoló keret nélkül", "result: the skin alone, without the frame"),
    Action::Result,
);
const LEAVE: Row =
    Command::button(Button::new(550, 38, words::QUIT), (Words("Q", "Q"), words::HELP_QUIT), Action::Quit);
const LINK: Row = pad(
    'L',
    (6, 20),
    Words("kötés", "link"),
    line("L", "két kör összekötése, szétválasztása", "link two circles, or no longer"),
    Action::Link,
);
const APOLLONIUS: Row = pad(
    'M',
    (105, 20),
    Words("Apoll.", "Apoll."),
    line("M", "Apollóniosz körei", "the circles of Apollonius"),
    Action::Apollonius,
);
const RING: Row = pad(
    'K',
    (6, 37),
    Words("gyűrű", "ring"),
    line("K", "gyűrű vagy lánc", "a ring or a chain"),
    Action::Ring,
);
const RADICAL: Row = pad(
    'R',
    (105, 37),
    Words("hatvány", "radical"),
    line("R", "hatványvonalak, hatványpontok", "radical lines and power points"),
    Action::Radical,
);
const ELSEWHERE: Row = Command::key(
    Key::F(5),
    line("F5", "a tér lapja: ugyanez a lánc gömbökkel", "the page of space: the same chain of spheres"),
    Action::Elsewhere,
);
const NEAREST: Row = Command::key(
    Key::F(8),
    line("F8", "a legközelebbi megengedett sugarak", "the nearest admissible radii"),
    Action::Nearest,
);

/// In the plane.
pub(super) const PLANE: Commands<Action> = Commands(&[
    DRAG,
    SIZE,
    CLICK,
    INSERT,
    CHANGE,
    DELETE,
    DELETE_HERE,
    SKIN,
    RESULT,
    LEAVE,
    LINK,
    RING,
    APOLLONIUS,
    RADICAL,
    ELSEWHERE,
    NEAREST,
    told(common::SAVE),
    told(common::UNDO),
]);

/// The help page.
pub(super) const PLANE_KEYS: &[KeyHelp] = &PLANE.help::<{ PLANE.lines() }>();

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_buttons_are_right() {
        assert_eq!(PLANE.too_wide(), [""; 0]);
        assert_eq!(PLANE.shared_keys(), []);
        for pad in PLANE.0.iter().filter_map(|command| command.pad) {
            for text in [pad.text.0, pad.text.1] {
                assert!(text.chars().count() <= 9, "{text}");
            }
        }
    }
}
