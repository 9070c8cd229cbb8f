//! The billiard table on the screen: balls are discs put by XOR, as in the original, so that two balls that
//! share a pixel both show.

use super::texts;
use crate::machine::Language;
use crate::screen::{Bitmap, Color, Put, Screen, Stroke};
use crate::table::{Game, Shot};
use crate::table::{Obstacle, RACK, RADIUS, Surface, Table, Vector};
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
    /// Whether this is a replay.
    pub(crate) replay: bool,
}

impl Picture for View<'_> {
    fn draw(&self, screen: &mut Screen, language: Language) {
        draw_table(screen);
        self.draw_texts(screen, language);
        for (index, ball) in self.table.balls().iter().enumerate() {
            self.discs.put(screen, index, pixel(ball.at));
        }
        if let Some((shot, ghost)) = &self.aimed {
            self.discs.put(screen, shot.ball, *ghost);
            if self.line {
                draw_way(screen, &self.table, shot);
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

fn draw_table(screen: &mut Screen) {
    screen.clear(Color::LightCyan);
    screen.bar(35, 35, 604, 444, Color::White);
    sunken(screen, Area::new(30, 30, 609, 449), 6);
    screen.line(38, 443, 601, 443, Stroke::thin(Color::Cyan));
    screen.line(603, 38, 603, 441, Stroke::thin(Color::Cyan));
}

/// The balls' discs on black, made once.
pub(crate) struct Discs(Vec<Bitmap>);

impl Discs {
    /// Discs in the book's colours: ball i, from 1, has colour i, which put by XOR on white shows as 15 - i.
    pub(crate) fn new() -> Discs {
        let mut scratch = Screen::new();
        let colors = Color::ALL.into_iter().skip(1).take(RACK.len());
        let disc = |color| {
            scratch.disc(BOX, BOX, DISC, color, color);
            scratch.take(0, 0, 2 * BOX, 2 * BOX)
        };
        Discs(colors.map(disc).collect())
    }

    fn put(&self, screen: &mut Screen, ball: usize, (x, y): (i32, i32)) {
        if let Some(disc) = self.0.get(ball) {
            screen.put(x - BOX, y - BOX, disc, Put::Xor);
        }
    }
}

/// The aiming line up to the first hit, the ball's place there, and where the two balls go on to.
fn draw_way(screen: &mut Screen, table: &Table, shot: &Shot) {
    let Some(start) = table.balls().get(shot.ball) else { return };
    let Some(way) = table.first_hit(shot.ball, shot.velocity, shot.spin) else { return };
    draw_line(screen, start.at, way.at, Stroke::thin(Color::DarkGray));
    let (x, y) = pixel(way.at);
    screen.circle(x, y, DISC, Stroke::thin(Color::DarkGray));
    draw_arrow(screen, way.at, way.after, Stroke::thin(Color::DarkGray));
    if let Some(Obstacle::Ball(other)) = way.obstacle
        && let Some(other) = table.balls().get(other)
    {
        draw_arrow(screen, other.at, way.passed_on, Stroke::thin(Color::Red));
    }
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
