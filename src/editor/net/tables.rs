//! The commands of the surface programs.

use super::plan::{Family, Plan};
use crate::design::Index;
use crate::editor::keys::{HOME, QUIT, SAVE, SIGHT, TURN_DRAG, TURN_KEYS, UNDO, ZOOM};
use crate::geometry::Topology;
use crate::machine::Key;
use crate::ui::look::SIGHT_KEY;
use crate::ui::words::{self, Words};
use crate::ui::{Button, Command, Commands, KeyHelp};

/// What a command does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    Change,
    ChangeAt(Index),
    Surface,
    Result,
    /// A parameter, with its direction if that is chosen already: u (0) or v (1).
    Bias(Option<usize>),
    Tension(Option<usize>),
    K0(Option<usize>),
    Quit,
    Follow,
    /// The next kind of border or poles.
    Border,
    /// A second patch, or what is kept at the joint.
    Join,
    Mirror,
    Refine,
    /// A normal, by the number of its point.
    Normal,
    NormalAt(Index),
    Automatic,
    Distance,
    Both,
    Shell,
    Compare,
    Gauss,
    Size,
}

type Row = Command<Action>;

const CHANGE: Row = Command::button(
    Button::new(460, 4, words::CHANGE),
    (Words("V", "V"), words::HELP_NET_CHANGE),
    Action::Change,
);
const SURFACE: Row = Command::button(
    Button::new(460, 21, words::SURFACE),
    (Words("F", "F"), words::HELP_SURFACE),
    Action::Surface,
);
const RESULT: Row = Command::button(
    Button::new(460, 38, words::RESULT),
    (Words("E", "E"), words::HELP_SURFACE_RESULT),
    Action::Result,
);
const LEAVE: Row = Command::button(Button::new(550, 38, words::NET_QUIT), QUIT, Action::Quit);
const SHAPES: KeyHelp = (Words("A C", "A C"), words::HELP_SHAPES);
const BIAS: Row = Command::button(Button::new(550, 4, words::BIAS_BUTTON), SHAPES, Action::Bias(None));
const TENSION: Row =
    Command::button(Button::new(550, 21, words::TENSION_BUTTON), SHAPES, Action::Tension(None)).untold();
const K0: Row = Command::button(
    Button::new(550, 21, words::K0_BUTTON),
    (Words("C", "C"), words::HELP_K0),
    Action::K0(None),
);
const DRAG: Row = Command::told((Words("egér", "mouse"), words::HELP_NET_DRAG));
const TURN: [Row; 4] =
    [Command::told(TURN_DRAG), Command::told(TURN_KEYS), Command::told(ZOOM), Command::told(HOME)];
const PROJECTION: Row = Command::elsewhere(SIGHT_KEY, SIGHT);
const FOLLOW: Row = Command::key(Key::F(3), (Words("F3", "F3"), words::HELP_NET_FOLLOW), Action::Follow);
const BORDER: Row = Command::key(Key::F(4), (Words("F4", "F4"), words::HELP_BORDER), Action::Border);
const POLES: Row = Command::key(Key::F(4), (Words("F4", "F4"), words::HELP_POLES), Action::Border);
const TRIPLE: Row = Command::key(Key::F(4), (Words("F4", "F4"), words::HELP_TRIPLE), Action::Border);
const JOIN: Row = Command::key(Key::Char('J'), (Words("J", "J"), words::HELP_JOIN), Action::Join);
const FRAME: Row = Command::elsewhere(Key::Char('K'), (Words("K W", "K W"), words::HELP_FRAME));
const WEIGHT: Row = Command::elsewhere(Key::Char('W'), (Words("W", "W"), words::HELP_FRAME)).untold();
const HULL: Row = Command::elsewhere(Key::Char('K'), (Words("K", "K"), words::HELP_HULL));
const INSPECT: Row = Command::elsewhere(Key::F(5), (Words("F5", "F5"), words::HELP_INSPECT));
const SECTION: Row = Command::elsewhere(Key::F(6), (Words("F6", "F6"), words::HELP_SECTION));
const MIRROR: Row = Command::key(Key::F(7), (Words("F7", "F7"), words::HELP_MIRROR), Action::Mirror);
const REFINE: Row = Command::key(Key::F(8), (Words("F8", "F8"), words::HELP_REFINE), Action::Refine);
const PICK: Row = Command::told((Words("Tab X Y Z", "Tab X Y Z"), words::HELP_PICK_3D));
const DIAL: Row = Command::told((Words("PgUp PgDn", "PgUp PgDn"), words::HELP_DIAL));
const STORE: Row = Command::told(SAVE);
const BACK: Row = Command::told(UNDO);

const NORMAL: Row = Command::button(
    Button::new(550, 4, words::NORMAL_BUTTON),
    (Words("N", "N"), words::HELP_NORMAL),
    Action::Normal,
);
const DISTANCE: Row = Command::button(
    Button::new(550, 21, words::OFFSET_BUTTON),
    (Words("P", "P"), words::HELP_OFFSET),
    Action::Distance,
);
const AUTOMATIC: Row =
    Command::key(Key::Char('A'), (Words("A", "A"), words::HELP_AUTOMATIC_NORMALS), Action::Automatic);
const SIDES: Row = Command::key(Key::Char('M'), (Words("M H", "M H"), words::HELP_SIDES), Action::Both);
const SHELL: Row = Command::also(Key::Char('H'), Action::Shell);
const SIZE: Row = Command::key(Key::Char('R'), (Words("R", "R"), words::HELP_NET_SIZE), Action::Size);
const COMPARE: Row = Command::key(Key::F(4), (Words("F4", "F4"), words::HELP_COMPARE_PN), Action::Compare);
const INSPECT_RADII: Row = Command::elsewhere(Key::F(5), (Words("F5", "F5"), words::HELP_INSPECT_RADII));
const GAUSS: Row = Command::key(Key::F(8), (Words("F8", "F8"), words::HELP_GAUSS), Action::Gauss);
const DRAG_NORMALS: Row = Command::told((Words("egér", "mouse"), words::HELP_NORMALS_DRAG));

const NORMALS: Commands<Action> = Commands(&[
    CHANGE,
    NORMAL,
    SURFACE,
    DISTANCE,
    RESULT,
    LEAVE,
    AUTOMATIC,
    SIDES,
    SHELL,
    SIZE,
    DRAG_NORMALS,
    TURN[0],
    TURN[1],
    TURN[2],
    TURN[3],
    PROJECTION,
    FOLLOW,
    COMPARE,
    INSPECT_RADII,
    SECTION,
    HULL,
    MIRROR,
    GAUSS,
    PICK,
    STORE,
    BACK,
]);
const HERMITE: Commands<Action> = Commands(&[
    CHANGE, SURFACE, RESULT, LEAVE, DRAG, TURN[0], TURN[1], TURN[2], TURN[3], PROJECTION, FOLLOW, JOIN,
    INSPECT, SECTION, FRAME, WEIGHT, MIRROR, PICK, STORE, BACK,
]);
const LOCAL: Commands<Action> = Commands(&[
    CHANGE, SURFACE, RESULT, K0, LEAVE, DRAG, TURN[0], TURN[1], TURN[2], TURN[3], PROJECTION, FOLLOW,
    INSPECT, SECTION, FRAME, WEIGHT, MIRROR, DIAL, PICK, STORE, BACK,
]);
const BETA: Commands<Action> = Commands(&[
    CHANGE, SURFACE, RESULT, BIAS, TENSION, LEAVE, DRAG, TURN[0], TURN[1], TURN[2], TURN[3], PROJECTION,
    FOLLOW, INSPECT, SECTION, FRAME, WEIGHT, MIRROR, DIAL, PICK, STORE, BACK,
]);
const B_SPLINE: Commands<Action> = Commands(&[
    CHANGE, SURFACE, RESULT, LEAVE, DRAG, TURN[0], TURN[1], TURN[2], TURN[3], PROJECTION, FOLLOW, BORDER,
    INSPECT, SECTION, FRAME, WEIGHT, MIRROR, REFINE, PICK, STORE, BACK,
]);
const B_SPLINE_POLES: Commands<Action> = Commands(&[
    CHANGE, SURFACE, RESULT, LEAVE, DRAG, TURN[0], TURN[1], TURN[2], TURN[3], PROJECTION, FOLLOW, TRIPLE,
    INSPECT, SECTION, FRAME, WEIGHT, MIRROR, REFINE, PICK, STORE, BACK,
]);
const FINER: Commands<Action> = Commands(&[
    CHANGE, SURFACE, RESULT, LEAVE, DRAG, TURN[0], TURN[1], TURN[2], TURN[3], PROJECTION, FOLLOW, INSPECT,
    SECTION, FRAME, WEIGHT, MIRROR, REFINE, PICK, STORE, BACK,
]);
const SPLINE_POLES: Commands<Action> = Commands(&[
    CHANGE, SURFACE, RESULT, LEAVE, DRAG, TURN[0], TURN[1], TURN[2], TURN[3], PROJECTION, FOLLOW, POLES,
    INSPECT, SECTION, FRAME, WEIGHT, MIRROR, REFINE, PICK, STORE, BACK,
]);
const BEZIER: Commands<Action> = Commands(&[
    CHANGE, SURFACE, RESULT, LEAVE, DRAG, TURN[0], TURN[1], TURN[2], TURN[3], PROJECTION, FOLLOW, JOIN,
    INSPECT, SECTION, FRAME, WEIGHT, MIRROR, REFINE, PICK, STORE, BACK,
]);

/// The commands of a program.
pub(super) fn of(plan: &Plan) -> Commands<Action> {
    let poles = plan.kind.topology() == Topology::Sphere;
    match plan.family {
        Family::Hermite => HERMITE,
        Family::Local => LOCAL,
        Family::Beta => BETA,
        Family::BSpline if poles => B_SPLINE_POLES,
        Family::BSpline => B_SPLINE,
        Family::Normals => NORMALS,
        Family::Spline if poles => SPLINE_POLES,
        Family::Bezier => BEZIER,
        Family::Spline | Family::Heights => FINER,
    }
}

/// The help page of surfaces with normals.
pub const NORMALS_KEYS: &[KeyHelp] = &NORMALS.help::<{ NORMALS.lines() }>();
/// The help page of Hermite patches.
pub const HERMITE_KEYS: &[KeyHelp] = &HERMITE.help::<{ HERMITE.lines() }>();
/// The help page of surfaces with a coefficient in each direction.
pub const LOCAL_KEYS: &[KeyHelp] = &LOCAL.help::<{ LOCAL.lines() }>();
/// The same with bias and tension in each direction.
pub const BETA_KEYS: &[KeyHelp] = &BETA.help::<{ BETA.lines() }>();
/// The help page of B-splines.
pub const B_SPLINE_KEYS: &[KeyHelp] = &B_SPLINE.help::<{ B_SPLINE.lines() }>();
/// The same with poles.
pub const B_SPLINE_POLES_KEYS: &[KeyHelp] = &B_SPLINE_POLES.help::<{ B_SPLINE_POLES.lines() }>();
/// The help page of splines.
pub const FINER_KEYS: &[KeyHelp] = &FINER.help::<{ FINER.lines() }>();
/// The same with poles.
pub const SPLINE_POLES_KEYS: &[KeyHelp] = &SPLINE_POLES.help::<{ SPLINE_POLES.lines() }>();
/// The help page of Bézier patches.
pub const BEZIER_KEYS: &[KeyHelp] = &BEZIER.help::<{ BEZIER.lines() }>();

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Commands<Action>; 9] =
        [HERMITE, LOCAL, BETA, B_SPLINE, B_SPLINE_POLES, FINER, SPLINE_POLES, BEZIER, NORMALS];

    #[test]
    fn every_text_fits_its_button() {
        for commands in ALL {
            assert_eq!(commands.too_wide(), [""; 0]);
        }
    }

    #[test]
    fn no_key_has_two_meanings() {
        for commands in ALL {
            assert_eq!(commands.shared_keys(), []);
        }
        assert_eq!(super::super::show::COMMANDS.shared_keys(), []);
    }
}
