//! The commands of the curve programs.

use super::super::keys::{HOME, QUIT, SAVE, TURN_DRAG, TURN_KEYS, UNDO, ZOOM};
use crate::machine::Key;
use crate::ui::words::{self, Words};
use crate::ui::{Button, Command, Commands, KeyHelp};

/// What a command does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// A new point by number and place.
    Insert,
    /// Another number, place or tangent of a point.
    Change,
    /// A point goes, by its number.
    Delete,
    /// The point under the mouse goes.
    DeleteHere,
    /// The form and method of the curve.
    Choose,
    /// The curve alone.
    Result,
    /// The bias of a beta-spline.
    Bias,
    /// The tension of a beta-spline.
    Tension,
    /// The coefficient of the tangents.
    K0,
    /// The questions at the end.
    Quit,
    /// Whether the curve follows changes.
    Follow,
    /// Curves of several methods together.
    Compare,
    /// Curves of several values of a parameter together.
    Series,
    /// The workshop of measured points.
    Workshop,
    /// The shape of one joint.
    ShapeJoint,
    /// All joints alike.
    JointsAlike,
    /// The characteristic polygon and its hull.
    Polygon,
    /// The weights of the points.
    Weights,
    /// The joints with their continuity, and the comb of curvature.
    Contacts,
    /// A joint of Bézier arcs smooth, or a corner.
    Smooth,
    /// A command of the program's own layer.
    Own(u8),
}

type Row = Command<Action>;

const DRAG: Row = Command::told((Words("egér", "mouse"), words::HELP_DRAG));
const DRAG_TANGENT: Row = Command::told((Words("egér", "mouse"), words::HELP_DRAG_TANGENT));
const DRAG_3D: Row = Command::told((Words("egér", "mouse"), words::HELP_DRAG_3D));
const INSERT: Row = Command::button(
    Button::new(460, 21, words::INSERT),
    (Words("B", "B"), words::HELP_INSERT),
    Action::Insert,
);
const CHANGE: Row = change(words::HELP_CHANGE);
const CHANGE_TANGENT: Row = change(words::HELP_CHANGE_TANGENT);
const DELETE: Row = Command::button(
    Button::new(550, 21, words::DELETE),
    (Words("T", "T"), words::HELP_DELETE),
    Action::Delete,
);
const DELETE_HERE: Row =
    Command::key(Key::Delete, (Words("Del", "Del"), words::HELP_DELETE_HERE), Action::DeleteHere);
const CLICK: Row = Command::told((Words("kattintás", "click"), words::HELP_CLICK));
const CLICK_3D: Row = Command::told((Words("kattintás", "click"), words::HELP_CLICK_3D));
const METHOD: Row = choose((Words("G 1-5 S", "G 1-5 S"), words::HELP_CURVE));
const FORM: Row = choose((Words("G", "G"), words::HELP_CURVE_FORM));
const RESULT: Row = Command::button(
    Button::new(460, 38, words::RESULT),
    (Words("E", "E"), words::HELP_RESULT),
    Action::Result,
);
const BIAS: Row = Command::button(
    Button::new(30, 21, words::BIAS_BUTTON),
    (Words("A C", "A C"), words::HELP_SHAPE),
    Action::Bias,
);
const TENSION: Row = Command::button(
    Button::new(120, 21, words::TENSION_BUTTON),
    (Words("C", "C"), words::HELP_SHAPE),
    Action::Tension,
)
.untold();
const LEAVE: Row = Command::button(Button::new(550, 38, words::QUIT), QUIT, Action::Quit);
const FOLLOW: Row = Command::key(Key::F(3), (Words("F3", "F3"), words::HELP_FOLLOW), Action::Follow);
const COMPARE: Row =
    Command::key(Key::F(4), (Words("F4 1-6", "F4 1-6"), words::HELP_COMPARE), Action::Compare);
const SERIES: Row = Command::key(Key::F(4), (Words("F4", "F4"), words::HELP_SERIES), Action::Series);
const WORKSHOP: Row = Command::key(Key::F(5), (Words("F5", "F5"), words::HELP_WORKSHOP), Action::Workshop);
const JOINT: Row = Command::key(Key::F(5), (Words("F5", "F5"), words::HELP_JOINTS), Action::ShapeJoint);
const ALIKE: Row = Command::key(Key::F(6), (Words("F6", "F6"), words::HELP_JOINTS_OFF), Action::JointsAlike);
const POLYGON: Row =
    Command::key(Key::Char('K'), (Words("K W J", "K W J"), words::HELP_AIDS), Action::Polygon);
const WEIGHTS: Row = Command::also(Key::Char('W'), Action::Weights);
const CONTACTS: Row = Command::also(Key::Char('J'), Action::Contacts);
const PICK: Row = Command::told((Words("Tab", "Tab"), words::HELP_PICK));
const AXIS: Row = Command::told((Words("X Y Z", "X Y Z"), words::HELP_AXIS));
const DIAL: Row = Command::told((Words("PgUp PgDn", "PgUp PgDn"), words::HELP_DIAL));
const SMOOTH: Row = Command::also(Key::Char('S'), Action::Smooth);
const STORE: Row = Command::told(SAVE);
const BACK: Row = Command::told(UNDO);
const TURN: [Row; 4] =
    [Command::told(TURN_DRAG), Command::told(TURN_KEYS), Command::told(ZOOM), Command::told(HOME)];

const fn change(help: Words) -> Row {
    Command::button(Button::new(460, 4, words::CHANGE), (Words("V", "V"), help), Action::Change)
}

const fn choose(help: KeyHelp) -> Row {
    Command::button(Button::new(550, 4, words::CURVE), help, Action::Choose)
}

/// GB_2D_IP.
pub(super) const METHODS: Commands<Action> = Commands(&[
    DRAG,
    CLICK,
    INSERT,
    CHANGE,
    DELETE,
    DELETE_HERE,
    METHOD,
    RESULT,
    LEAVE,
    FOLLOW,
    COMPARE,
    WORKSHOP,
    POLYGON,
    WEIGHTS,
    CONTACTS,
    PICK,
    DIAL,
    SMOOTH,
    STORE,
    BACK,
]);
/// GB_2D_CH.
pub(super) const TANGENTS: Commands<Action> = Commands(&[
    DRAG,
    DRAG_TANGENT,
    CLICK,
    INSERT,
    CHANGE_TANGENT,
    DELETE,
    DELETE_HERE,
    FORM,
    RESULT,
    LEAVE,
    FOLLOW,
    SERIES,
    POLYGON,
    WEIGHTS,
    CONTACTS,
    PICK,
    DIAL,
    STORE,
    BACK,
]);
/// GB_2D_BT.
pub(super) const BETA: Commands<Action> = Commands(&[
    DRAG,
    CLICK,
    INSERT,
    CHANGE,
    DELETE,
    DELETE_HERE,
    BIAS,
    TENSION,
    FORM,
    RESULT,
    LEAVE,
    FOLLOW,
    SERIES,
    JOINT,
    ALIKE,
    POLYGON,
    WEIGHTS,
    CONTACTS,
    PICK,
    DIAL,
    STORE,
    BACK,
]);
/// GB_3D_IP.
pub(super) const SPACE_METHODS: Commands<Action> = Commands(&[
    INSERT,
    CHANGE,
    DELETE,
    DELETE_HERE,
    METHOD,
    RESULT,
    LEAVE,
    DRAG_3D,
    CLICK_3D,
    TURN[0],
    TURN[1],
    TURN[2],
    TURN[3],
    FOLLOW,
    COMPARE,
    WORKSHOP,
    POLYGON,
    WEIGHTS,
    CONTACTS,
    PICK,
    AXIS,
    DIAL,
    SMOOTH,
    STORE,
    BACK,
]);
/// GB_3D_BT.
pub(super) const SPACE_BETA: Commands<Action> = Commands(&[
    INSERT,
    CHANGE,
    DELETE,
    DELETE_HERE,
    BIAS,
    TENSION,
    FORM,
    RESULT,
    LEAVE,
    DRAG_3D,
    CLICK_3D,
    TURN[0],
    TURN[1],
    TURN[2],
    TURN[3],
    FOLLOW,
    SERIES,
    POLYGON,
    WEIGHTS,
    CONTACTS,
    PICK,
    AXIS,
    DIAL,
    STORE,
    BACK,
]);

/// Rows for the tables of programs with a layer of their own.
pub mod rows {
    use super::{Action, Command};

    /// The table's rows.
    pub type Row = Command<Action>;
    /// Points are dragged out of the store.
    pub const DRAG: Row = super::DRAG;
    /// Points are dragged in space.
    pub const DRAG_3D: Row = super::DRAG_3D;
    /// Tips of tangents are dragged.
    pub const DRAG_TANGENT: Row = super::DRAG_TANGENT;
    /// A click makes a point.
    pub const CLICK: Row = super::CLICK;
    /// A click on a curve in space makes a point.
    pub const CLICK_3D: Row = super::CLICK_3D;
    /// The key B.
    pub const INSERT: Row = super::INSERT;
    /// The key V, for points with tangents.
    pub const CHANGE: Row = super::CHANGE_TANGENT;
    /// The key T.
    pub const DELETE: Row = super::DELETE;
    /// The key Delete.
    pub const DELETE_HERE: Row = super::DELETE_HERE;
    /// The key E.
    pub const RESULT: Row = super::RESULT;
    /// The key Q.
    pub const LEAVE: Row = super::LEAVE;
    /// The key F3.
    pub const FOLLOW: Row = super::FOLLOW;
    /// Tab and the arrows.
    pub const PICK: Row = super::PICK;
    /// The axes of space.
    pub const AXIS: Row = super::AXIS;
    /// Saving.
    pub const SAVE: Row = super::STORE;
    /// Undo and redo.
    pub const UNDO: Row = super::BACK;
    /// Turning and zooming in space.
    pub const TURN: [Row; 4] = super::TURN;
}

/// The help page of GB_2D_IP.
pub const METHOD_KEYS: &[KeyHelp] = &METHODS.help::<{ METHODS.lines() }>();
/// The help page of GB_2D_CH.
pub const TANGENT_KEYS: &[KeyHelp] = &TANGENTS.help::<{ TANGENTS.lines() }>();
/// The help page of GB_2D_BT.
pub const BETA_KEYS: &[KeyHelp] = &BETA.help::<{ BETA.lines() }>();
/// The help page of GB_3D_IP.
pub const SPACE_METHOD_KEYS: &[KeyHelp] = &SPACE_METHODS.help::<{ SPACE_METHODS.lines() }>();
/// The help page of GB_3D_BT.
pub const SPACE_BETA_KEYS: &[KeyHelp] = &SPACE_BETA.help::<{ SPACE_BETA.lines() }>();

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_text_fits_its_button() {
        for commands in [METHODS, TANGENTS, BETA, SPACE_METHODS, SPACE_BETA] {
            assert_eq!(commands.too_wide(), [""; 0]);
        }
    }

    #[test]
    fn no_key_has_two_meanings() {
        for commands in [METHODS, TANGENTS, BETA, SPACE_METHODS, SPACE_BETA] {
            assert_eq!(commands.shared_keys(), []);
        }
    }
}
