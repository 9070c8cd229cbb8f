//! The commands of PH_GORBE: those of the editor of curves, and its own.

use crate::editor::curve::layer::{Action, rows};
use crate::machine::Key;
use crate::ui::{Button, Command, Commands, Hot, KeyHelp, Words, line};

/// Its own commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Own {
    Curve,
    Distance,
    Speed,
    Comb,
    Travel,
    Solutions,
    Compare,
    Formula,
    Unit,
    Elsewhere,
}

impl Own {
    const ALL: [Own; 10] = [
        Own::Curve,
        Own::Distance,
        Own::Speed,
        Own::Comb,
        Own::Travel,
        Own::Solutions,
        Own::Compare,
        Own::Formula,
        Own::Unit,
        Own::Elsewhere,
    ];

    /// The command of a number.
    pub(super) fn of(number: u8) -> Option<Own> {
        Own::ALL.get(usize::from(number)).copied()
    }

    const fn action(self) -> Action {
        Action::Own(self as u8)
    }
}

type Row = Command<Action>;

const CURVE: Row = Command::button(
    Button::new(550, 4, Hot::new('G', "örbe", "-curve")),
    line(
        "G",
        "görbe: nyitott/zárt, 1 spline, 2 Hermite, 3 köbös",
        "curve: open/closed, 1 spline, 2 Hermite, 3 cubic",
    ),
    Own::Curve.action(),
);
const SPACE_CURVE: Row = Command::button(
    Button::new(550, 4, Hot::new('G', "örbe", "-curve")),
    line("G", "a görbe alakja: nyitott, zárt", "the form of the curve: open, closed"),
    Own::Curve.action(),
);
const DISTANCE: Row = Command::button(
    Button::new(30, 21, Hot::new('P', "árhuzam", " offset")),
    line(
        "P",
        "párhuzamos: szám, M két oldal, C vágás, N nincs",
        "offset: number, M both sides, C trim, N none",
    ),
    Own::Distance.action(),
);
const PIPE: Row = Command::button(
    Button::new(30, 21, Hot::new('P', "-cső", "ipe")),
    line("P", "cső: a sugara; N nincs", "pipe: its radius; N none"),
    Own::Distance.action(),
);
const SPEED: Row = Command::button(
    Button::new(120, 21, Hot::new('S', "ebesség", "peed")),
    line("S", "a sebesség rajza az út fölött", "the speed over the length"),
    Own::Speed.action(),
);
const COMB: Row = Command::button(
    Button::new(30, 38, Hot::new('K', "-görbül", "-comb")),
    line("K + -", "görbületi fésű; nagyobb, kisebb", "comb of curvature; larger, smaller"),
    Own::Comb.action(),
);
const FRAMES: Row = Command::button(
    Button::new(30, 38, Hot::new('K', "-keret", "-frame")),
    line(
        "K",
        "kísérő keret: Frenet, Euler-Rodrigues, forgásmentes",
        "frames: Frenet, Euler-Rodrigues, minimising",
    ),
    Own::Comb.action(),
);
const TRAVEL: Row = Command::button(
    Button::new(120, 38, Hot::new('J', "árat", "ourney")),
    line("J", "járat egyenletes előtolással; szóköz: áll", "travel at a constant feed; Space stops"),
    Own::Travel.action(),
);
const WHEEL: Row = Command::told((
    Words("görgő PgUp PgDn", "wheel PgUp PgDn"),
    Words(
        "a távolság 1-gyel; , . tizeddel; a párhuzamos húzható",
        "distance by 1; , . by a tenth; drag the offset itself",
    ),
));
const RADIUS: Row =
    Command::told((Words("PgUp PgDn", "PgUp PgDn"), Words("a cső sugara 1-gyel", "radius of the pipe by 1")));
const SOLUTIONS: Row =
    own_key(4, line("F4", "minden megoldás együtt", "all solutions together"), Own::Solutions);
const COMPARE: Row = own_key(
    5,
    line("F5 + -", "közelítő párhuzamosok hibája", "approximate offsets and their errors"),
    Own::Compare,
);
const FORMULA: Row = own_key(6, line("F6", "egy ív képletei", "the formulas of a span"), Own::Formula);
const UNIT: Row = own_key(
    7,
    line("F7", "egység: 1 képpont hány mm; NC-program", "unit: mm in a pixel; NC program"),
    Own::Unit,
);
const TO_SPACE: Row = own_key(8, line("F8", "a tér lapja", "the page of space"), Own::Elsewhere);
const TO_PLANE: Row = own_key(8, line("F8", "a sík lapja", "the page of the plane"), Own::Elsewhere);

const fn own_key(key: u8, help: KeyHelp, own: Own) -> Row {
    Command::key(Key::F(key), help, own.action())
}

/// In the plane.
pub(super) const PLANE: Commands<Action> = Commands(&[
    rows::DRAG,
    rows::CLICK,
    rows::INSERT,
    rows::CHANGE,
    rows::DELETE,
    rows::DELETE_HERE,
    CURVE,
    rows::RESULT,
    rows::LEAVE,
    DISTANCE,
    WHEEL,
    SPEED,
    COMB,
    TRAVEL,
    rows::FOLLOW,
    SOLUTIONS,
    COMPARE,
    FORMULA,
    UNIT,
    rows::PICK,
    TO_SPACE,
    rows::SAVE,
    rows::UNDO,
]);

/// In space.
pub(super) const SPACE: Commands<Action> = Commands(&[
    rows::INSERT,
    rows::CHANGE,
    rows::DELETE,
    rows::DELETE_HERE,
    SPACE_CURVE,
    rows::RESULT,
    rows::LEAVE,
    PIPE,
    RADIUS,
    FRAMES,
    rows::DRAG_3D,
    rows::CLICK_3D,
    rows::TURN[0],
    rows::TURN[1],
    rows::TURN[2],
    rows::TURN[3],
    rows::FOLLOW,
    rows::PICK,
    rows::AXIS,
    TO_PLANE,
    rows::SAVE,
    rows::UNDO,
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
        }
        assert!(Own::ALL.iter().enumerate().all(|(at, &own)| own as usize == at));
    }
}
