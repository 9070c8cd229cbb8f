//! Cursors that a program draws itself (chapter 1.2): put on the screen by operations on its colours,
//! taken off again without drawing anything anew, moved by mouse and arrow keys.
//!
//! The screen that a cursor moves over is kept as it is, cursor and all: showing and hiding are the
//! puts of the technique and nothing else. The pointer of the mouse driver, which needs none of
//! this, is [`crate::screen::Masks`].

use crate::machine::{Asked, Key, Language, Machine, Mouse, Pointer};
use crate::screen::{Bitmap, Color, HEIGHT, Masks, Put, Screen, WIDTH};
use crate::ui::{Area, Command, Commands, Desk, END, Hint, KeyHelp, Manual, Picture, Words, words};
use serde::Serialize;

/// Where the mouse may go in the programs with a cursor of their own; the edges belong to it.
const RANGE: Area = Area::new(12, 12, 631, 472);

/// What a key does in a program with a cursor of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Moves the cursor by so many pixels.
    Move(i32, i32),
    /// Goes on to the next part, in a program of several.
    Next,
    /// Ends the program.
    End,
}

const MOVE_IT: KeyHelp =
    (Words("egér, nyilak", "mouse, arrows"), Words("a kurzor mozgatása", "move the cursor"));
/// The arrow keys.
pub const MOVE: [Command<Action>; 4] = [
    Command::key(Key::Up, MOVE_IT, Action::Move(0, -1)),
    Command::also(Key::Down, Action::Move(0, 1)),
    Command::also(Key::Left, Action::Move(-1, 0)),
    Command::also(Key::Right, Action::Move(1, 0)),
];
/// Esc.
pub const LEAVE: Command<Action> = Command::key(Key::Esc, END, Action::End);

const COMMANDS: Commands<Action> = Commands(&[MOVE[0], MOVE[1], MOVE[2], MOVE[3], LEAVE]);
/// The help page of [`run`].
pub const KEYS: &[KeyHelp] = &COMMANDS.help::<{ COMMANDS.lines() }>();

/// How a cursor is taken off the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Removal {
    /// The same bitmaps are put once more in the same way, which undoes exclusive-or.
    PutAgain,
    /// What was under the cursor is saved before and put back.
    PutSaved,
}

/// A cursor of 17x17 pixels with the mouse in its middle.
#[derive(Clone, Debug)]
pub struct Cursor {
    layers: Vec<(Bitmap, Put)>,
    removal: Removal,
    /// Where it is shown, and what was there before if that is kept.
    shown: Option<((i32, i32), Option<Bitmap>)>,
}

impl Cursor {
    /// Pixels from the middle of a cursor to its edge.
    pub const RADIUS: i32 = 8;

    /// A cursor of bitmaps that are put over each other in this order.
    #[must_use]
    pub fn new(layers: Vec<(Bitmap, Put)>, removal: Removal) -> Cursor {
        Cursor { layers, removal, shown: None }
    }

    /// A bitmap of a cursor's size, drawn on black around [`Cursor::RADIUS`] in both directions.
    #[must_use]
    pub fn image(draw: impl FnOnce(&mut Screen)) -> Bitmap {
        let mut screen = Screen::new();
        draw(&mut screen);
        screen.take(0, 0, 2 * Cursor::RADIUS, 2 * Cursor::RADIUS)
    }

    /// Shows the cursor at a place, where it is moved to if it was shown before.
    pub fn show(&mut self, screen: &mut Screen, (x, y): (i32, i32)) {
        self.hide(screen);
        let [left, top, right, bottom] = [
            x.saturating_sub(Cursor::RADIUS),
            y.saturating_sub(Cursor::RADIUS),
            x.saturating_add(Cursor::RADIUS),
            y.saturating_add(Cursor::RADIUS),
        ];
        let saved = match self.removal {
            Removal::PutAgain => None,
            Removal::PutSaved => Some(screen.take(left, top, right, bottom)),
        };
        self.put_layers(screen, (left, top));
        self.shown = Some(((left, top), saved));
    }

    /// Takes the cursor off the screen, which is as before it was shown.
    pub fn hide(&mut self, screen: &mut Screen) {
        match self.shown.take() {
            Some(((left, top), Some(saved))) => screen.put(left, top, &saved, Put::Copy),
            Some((corner, None)) => self.put_layers(screen, corner),
            None => {}
        }
    }

    fn put_layers(&self, screen: &mut Screen, (left, top): (i32, i32)) {
        for (bitmap, put) in &self.layers {
            screen.put(left, top, bitmap, *put);
        }
    }
}

/// The patchwork under the cursors: squares of `size` pixels, of which the one in column k and row l, both
/// counted from `first`, has the colour kl mod `modulus` mod 16.
#[must_use]
pub fn patchwork(size: i32, modulus: i32, first: i32) -> Screen {
    let (size, modulus) = (size.max(1), modulus.max(1));
    let mut screen = Screen::new();
    for (column, row) in (0..=WIDTH / size).flat_map(|k| (0..=HEIGHT / size).map(move |l| (k, l))) {
        let number = (column + first).saturating_mul(row + first).rem_euclid(modulus) % 16;
        let (x, y) = (size * column, size * row);
        screen.bar(x, y, x + size - 1, y + size - 1, Color::from_index(number as u8));
    }
    screen
}

/// Where a cursor goes: to the mouse, or on from there with an arrow key, but not out of the range, whose edges
/// belong to it.
#[must_use]
pub fn place(mouse: Mouse, action: Option<Action>, range: Area) -> (i32, i32) {
    let (dx, dy) = if let Some(Action::Move(dx, dy)) = action { (dx, dy) } else { (0, 0) };
    (bounded(mouse.x + dx, range.x1, range.x2), bounded(mouse.y + dy, range.y1, range.y2))
}

fn bounded(value: i32, low: i32, high: i32) -> i32 {
    value.min(high).max(low)
}

/// A screen with its cursor, and what can be done there.
#[derive(Debug)]
pub struct Ground<'s> {
    /// What is shown.
    pub screen: &'s Screen,
    /// Where the cursor is.
    pub cursor: (i32, i32),
    /// What can be done, by mouse and by keys.
    pub hint: [Words; 2],
}

impl Picture for Ground<'_> {
    fn draw(&self, screen: &mut Screen, _: Language) {
        screen.clone_from(self.screen);
    }

    /// At the bottom; where the cursor is low, at the top.
    fn hint(&self) -> Option<Hint> {
        let y = if self.cursor.1 < HEIGHT * 3 / 4 { HEIGHT - 48 } else { 6 };
        let [mouse, keys] = self.hint;
        Some(Hint::framed((WIDTH / 2 - 120, y), mouse).by_keys(keys))
    }
}

/// Where the cursor is, for `dump`.
#[derive(Serialize)]
struct Model {
    x: i32,
    y: i32,
}

/// Runs a program with a cursor of its own over a screen, until Esc.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub async fn run(machine: &mut Machine, manual: Manual, screen: Screen, cursor: Cursor) -> Asked<()> {
    machine.set_pointer(Pointer::Hidden);
    let ended = follow(&mut Desk::new(machine, manual), screen, cursor).await;
    machine.set_pointer(Pointer::Shown(&Masks::ARROW));
    ended
}

async fn follow(desk: &mut Desk<'_>, mut screen: Screen, mut cursor: Cursor) -> Asked<()> {
    let mut at = (WIDTH / 2, HEIGHT / 2);
    loop {
        desk.machine.put_mouse(at.0, at.1);
        desk.machine.publish(Model { x: at.0, y: at.1 });
        cursor.show(&mut screen, at);
        let tick = desk.event(&Ground { screen: &screen, cursor: at, hint: [words::HINT_CURSOR; 2] }).await?;
        match COMMANDS.find(&tick) {
            Some(Action::End) => return Ok(()),
            action => at = place(tick.mouse, action, RANGE),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cursors() -> [Cursor; 2] {
        let disc = || Cursor::image(|screen| screen.disc(8, 8, 8, Color::White, Color::Black));
        [
            Cursor::new(vec![(disc(), Put::Xor)], Removal::PutAgain),
            Cursor::new(vec![(disc(), Put::Or), (disc(), Put::And)], Removal::PutSaved),
        ]
    }

    #[test]
    fn no_key_has_two_meanings() {
        assert_eq!(COMMANDS.shared_keys(), []);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]
        #[test]
        fn a_hidden_cursor_leaves_the_screen_as_it_was(
            places in prop::collection::vec((-20..660, -20..500), 1..8),
        ) {
            let before = patchwork(10, 71, 0);
            for mut cursor in cursors() {
                let mut screen = before.clone();
                for &place in &places {
                    cursor.show(&mut screen, place);
                }
                cursor.hide(&mut screen);
                prop_assert!(screen == before);
                cursor.hide(&mut screen);
                prop_assert!(screen == before);
            }
        }
    }

    #[test]
    fn exclusive_or_inverts_under_white_and_keeps_under_black() {
        let [mut cursor, _] = cursors();
        let mut screen = patchwork(4, 163, 0);
        let before = screen.clone();
        cursor.show(&mut screen, (100, 100));
        let color = |screen: &Screen, x, y| screen.pixel(x, y).unwrap().index();
        assert_eq!(color(&screen, 100, 100), 15 - color(&before, 100, 100));
        assert_eq!(color(&screen, 92, 92), color(&before, 92, 92));
    }

    #[test]
    fn patchwork_is_the_product_of_column_and_row() {
        let screen = patchwork(40, 17, 1);
        assert_eq!(screen.pixel(0, 0), Some(Color::Blue));
        assert_eq!(screen.pixel(639, 0), Some(Color::Black));
        assert_eq!(screen.pixel(40, 40), Some(Color::from_index(4)));
        assert_eq!(patchwork(0, 0, 0), patchwork(1, 1, 0));
    }
}
