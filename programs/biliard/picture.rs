//! The billiard table on the screen: balls are discs put by XOR, as in the original, so that two balls that
//! share a pixel both show.

use super::texts;
use crate::machine::{Cloth, Language};
use crate::screen::{Bitmap, Color, Put, Screen, Stroke};
use crate::table::{Game, Shot};
use crate::table::{RACK, RADIUS, Surface, Table, Vector};
use crate::ui::{Area, Picture, sunken};

/// The discs' radius in pixels.
const DISC: i32 = RADIUS as i32;
/// The pixel square around a disc.
const BOX: i32 = DISC + 1;
/// Length of the arrows after the first hit, in pixels.
const ARROW: f64 = 40.0;

/// What is to be seen.
pub(crate) struct View<'a> {
    pub(crate) discs: &'a Discs,
    pub(crate) game: &'a Game,
    /// The table with the balls, at rest or in motion.
    pub(crate) table: Table,
    /// The shot that is being aimed, with the ghost's place.
    pub(crate) aimed: Option<(Shot, (i32, i32))>,
    /// Whether the path of the aimed shot is shown.
    pub(crate) line: bool,
    /// Spin of the next shot in quarters of its speed.
    pub(crate) spin: i32,
    /// Whether it is said that this is a replay.
    pub(crate) replay: bool,
    /// Whether the aimed shot has a cue, and its speed is shown.
    pub(crate) cue: bool,
}

impl Picture for View<'_> {
    fn draw(&self, screen: &mut Screen, language: Language) {
        let look = self.discs.look;
        draw_table(screen, look);
        self.draw_texts(screen, language);
        for (index, ball) in self.table.balls().iter().enumerate() {
            self.discs.put(screen, index, pixel(ball.at));
        }
        if let Some((shot, ghost)) = &self.aimed {
            self.discs.put(screen, shot.ball, *ghost);
            if self.line {
                draw_way(screen, &self.table, shot, look);
            }
            if self.cue {
                draw_cue(screen, shot);
                draw_speed(screen, shot, language);
            }
        }
    }
}

impl View<'_> {
    fn draw_texts(&self, screen: &mut Screen, language: Language) {
        if let Some(points) = &self.game.points {
            screen.text(40, 12, &texts::score(points, language), Color::Black);
        }
        if self.game.surface == Surface::Rough {
            screen.text(520, 12, &texts::spin(self.spin, language), Color::Black);
        }
        if self.replay {
            screen.text(40, 460, texts::REPLAY.of(language), Color::Black);
        }
    }
}

/// The ball at a pixel: the nearest one whose disc contains it.
pub(crate) fn ball_at(balls: &[Vector], x: i32, y: i32) -> Option<usize> {
    let distance = |at: Vector| {
        let (bx, by) = pixel(at);
        (x - bx) * (x - bx) + (y - by) * (y - by)
    };
    let nearest = balls.iter().enumerate().min_by_key(|(_, at)| distance(**at));
    // The edge of the disc is half a pixel outside its radius.
    nearest.filter(|(_, at)| distance(**at) <= DISC * DISC + DISC).map(|(index, _)| index)
}

/// The nearest pixel; the cast saturates.
fn pixel(at: Vector) -> (i32, i32) {
    (at[0].round() as i32, at[1].round() as i32)
}

fn draw_table(screen: &mut Screen, look: ClothLook) {
    screen.clear(Color::LightCyan);
    screen.bar(35, 35, 604, 444, look.cloth);
    sunken(screen, Area::new(30, 30, 609, 449), 6);
    screen.line(38, 443, 601, 443, Stroke::thin(Color::Cyan));
    screen.line(603, 38, 603, 441, Stroke::thin(Color::Cyan));
}

/// The colours of a table.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct ClothLook {
    cloth: Color,
    /// Of the aiming line.
    line: Color,
    /// Of the arrows of balls that are hit.
    hit: Color,
}

impl ClothLook {
    const fn of(cloth: Cloth) -> ClothLook {
        match cloth {
            Cloth::White => ClothLook { cloth: Color::White, line: Color::DarkGray, hit: Color::Red },
            Cloth::Green => ClothLook { cloth: Color::Green, line: Color::White, hit: Color::Yellow },
            Cloth::Blue => ClothLook { cloth: Color::Blue, line: Color::White, hit: Color::Yellow },
        }
    }
}

/// The balls' discs on black for a cloth, made once.
pub(crate) struct Discs {
    look: ClothLook,
    discs: Vec<Bitmap>,
}

impl Discs {
    /// Discs in the book's colours: ball i, from 1, has colour i, which put by XOR on white shows as 15 - i. On any
    /// other cloth it shows so, too.
    pub(crate) fn new(cloth: Cloth) -> Discs {
        let look = ClothLook::of(cloth);
        let mut scratch = Screen::new();
        let colors =
            (1..).take(RACK.len()).map(|ball: u8| Color::from_index((15 - ball) ^ look.cloth.index()));
        let disc = |color| {
            scratch.disc(BOX, BOX, DISC, color, color);
            scratch.take(0, 0, 2 * BOX, 2 * BOX)
        };
        Discs { look, discs: colors.map(disc).collect() }
    }

    /// Makes the discs anew where the cloth is another one.
    pub(crate) fn cover(&mut self, cloth: Cloth) {
        if self.look != ClothLook::of(cloth) {
            *self = Discs::new(cloth);
        }
    }

    fn put(&self, screen: &mut Screen, ball: usize, (x, y): (i32, i32)) {
        if let Some(disc) = self.discs.get(ball) {
            screen.put(x - BOX, y - BOX, disc, Put::Xor);
        }
    }
}

/// The aiming line up to the first hit, the ball's place there, and where the two balls go on to.
fn draw_way(screen: &mut Screen, table: &Table, shot: &Shot, look: ClothLook) {
    let Some(start) = table.balls().get(shot.ball) else { return };
    let Some(way) = table.first_hit(shot.ball, shot.velocity, shot.spin) else { return };
    draw_line(screen, start.at, way.at, Stroke::thin(look.line));
    let (x, y) = pixel(way.at);
    screen.circle(x, y, DISC, Stroke::thin(look.line));
    draw_arrow(screen, way.at, way.after, Stroke::thin(look.line));
    for (other, velocity) in way.passed_on {
        if let Some(other) = table.balls().get(other) {
            draw_arrow(screen, other.at, velocity, Stroke::thin(look.hit));
        }
    }
}

/// Length of a cue in pixels, and of its tip.
const CUE: [f64; 2] = [130.0, 8.0];
/// How far a cue is drawn back for every pixel a second of its shot.
const DRAWN_BACK: f64 = 0.03;

/// The cue behind the ball: the faster the shot, the farther it is drawn back.
fn draw_cue(screen: &mut Screen, shot: &Shot) {
    let Some(ball) = shot.from.get(shot.ball) else { return };
    let speed = speed(shot);
    if speed > 1e-6 {
        let back = shot.velocity.map(|v| -v / speed);
        let at = |distance: f64| [ball[0] + distance * back[0], ball[1] + distance * back[1]];
        let tip = RADIUS + 3.0 + DRAWN_BACK * speed;
        let [length, point] = CUE;
        draw_line(screen, at(tip + point), at(tip + length), Stroke::thick(Color::Brown));
        draw_line(screen, at(tip), at(tip + point), Stroke::thick(Color::LightGray));
    }
}

/// The speed of a shot under the table: a bar that a shot across the whole table fills, and the number.
fn draw_speed(screen: &mut Screen, shot: &Shot, language: Language) {
    const BAR: Area = Area::new(460, 456, 600, 463);
    let text = format!("{} {:.0}", texts::STRENGTH.of(language), speed(shot));
    let letters = i32::try_from(text.chars().count()).unwrap_or(0);
    screen.text(BAR.x1 - 12 - 8 * letters, BAR.y1, &text, Color::Black);
    // The cast saturates.
    let filled = (speed(shot) * f64::from(BAR.x2 - BAR.x1) / FULL).min(f64::from(BAR.x2 - BAR.x1)) as i32;
    screen.rectangle(BAR.x1 - 1, BAR.y1 - 1, BAR.x2 + 1, BAR.y2 + 1, Stroke::thin(Color::Black));
    screen.bar(BAR.x1, BAR.y1, BAR.x1 + filled, BAR.y2, Color::LightRed);
}

/// Pixels a second of a shot across the whole table.
const FULL: f64 = 560.0;

/// Pixels a second.
fn speed(shot: &Shot) -> f64 {
    let [x, y] = shot.velocity;
    (x * x + y * y).sqrt()
}

fn draw_line(screen: &mut Screen, from: Vector, to: Vector, stroke: Stroke) {
    let ((x1, y1), (x2, y2)) = (pixel(from), pixel(to));
    screen.line(x1, y1, x2, y2, stroke);
}

/// A line of fixed length in the direction of motion; none for a ball that stops.
fn draw_arrow(screen: &mut Screen, from: Vector, velocity: Vector, stroke: Stroke) {
    let speed = (velocity[0] * velocity[0] + velocity[1] * velocity[1]).sqrt();
    if speed > 1e-6 {
        let length = ARROW / speed;
        draw_line(screen, from, [from[0] + length * velocity[0], from[1] + length * velocity[1]], stroke);
    }
}
