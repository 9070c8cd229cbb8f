//! The game as a plain value: where the balls rest, the shot that led there, the points. It is what undo
//! takes back and what a file holds.

use crate::table::{Ball, Cloth, Field, Hit, Obstacle, RACK, RADIUS, Surface, Table, Vector};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// How many points win.
pub(crate) const GOAL: u32 = 30;

/// One shot, whole: it gives the same motion every time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Shot {
    /// Where the balls lay before it.
    pub(crate) from: Vec<Vector>,
    /// The ball that was shot, by its index.
    pub(crate) ball: usize,
    /// Pixels a second, y down.
    pub(crate) velocity: Vector,
    /// Radians a second.
    pub(crate) spin: f64,
    /// The surfaces of the balls.
    pub(crate) surface: Surface,
}

impl Shot {
    /// The table at the moment of the shot; `None` if there is no such shot.
    pub(crate) fn table(&self) -> Option<Table> {
        let mut table = resting(&self.from, self.surface)?;
        table.shoot(self.ball, self.velocity, self.spin).ok()?;
        Some(table)
    }
}

/// The points of two players.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Points {
    pub(crate) scores: [u32; 2],
    /// Who is to play, 0 or 1.
    pub(crate) turn: usize,
}

impl Points {
    /// Who has reached the goal.
    pub(crate) fn winner(&self) -> Option<usize> {
        self.scores.iter().position(|&score| score >= GOAL)
    }

    /// The points after a shot whose ball has touched so many others: one for each beyond the first, and
    /// who scores plays on. A game that is won stays as it is.
    fn after(mut self, touched: usize) -> Points {
        if self.winner().is_some() {
            return self;
        }
        let gained = u32::try_from(touched.saturating_sub(1)).unwrap_or(0);
        if let Some(score) = self.scores.get_mut(self.turn) {
            *score = score.saturating_add(gained);
        }
        if gained == 0 {
            self.turn = 1 - self.turn.min(1);
        }
        self
    }
}

/// A game between two shots.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Game {
    /// Where the balls lie.
    pub(crate) balls: Vec<Vector>,
    /// The surfaces that the next shot is played with.
    pub(crate) surface: Surface,
    /// The points, when two play for them.
    pub(crate) points: Option<Points>,
    /// The shot that led here.
    pub(crate) last: Option<Shot>,
}

impl Game {
    /// The start.
    pub(crate) fn new() -> Game {
        Game { balls: RACK.to_vec(), surface: Surface::Smooth, points: None, last: None }
    }

    /// The balls at rest on their table; a game that was checked has one.
    pub(crate) fn table(&self) -> Table {
        resting(&self.balls, self.surface).unwrap_or_else(Table::rack)
    }

    /// Reads a game out of a file.
    ///
    /// # Errors
    /// What is wrong with it, as a sentence.
    pub(crate) fn read(content: &[u8]) -> Result<Game, String> {
        let game: Game = serde_json::from_slice(content).map_err(|error| error.to_string())?;
        let count = RACK.len();
        let shots = game.last.iter().map(|shot| &shot.from);
        if shots.chain([&game.balls]).any(|balls| balls.len() != count) {
            return Err(format!("there should be {count} balls"));
        }
        let balls = game.balls.iter().map(|&at| Ball::resting(at)).collect();
        Table::new(Field::BILIARD, Cloth::default(), balls).map_err(|error| error.to_string())?;
        if game.points.is_some_and(|points| points.turn > 1) {
            return Err("turn should be 0 or 1".to_string());
        }
        if game.last.as_ref().is_some_and(|shot| shot.table().is_none()) {
            return Err("the last shot is not possible".to_string());
        }
        Ok(game)
    }

    /// The game with the balls' start; the players begin anew.
    pub(crate) fn racked(&self) -> Game {
        Game { surface: self.surface, points: self.points.map(|_| Points::default()), ..Game::new() }
    }

    /// The game with other surfaces.
    pub(crate) fn with_other_surface(&self) -> Game {
        let surface = match self.surface {
            Surface::Smooth => Surface::Rough,
            Surface::Rough => Surface::Smooth,
        };
        Game { surface, ..self.clone() }
    }

    /// The game for points, or without if it is for points now.
    pub(crate) fn with_other_mode(&self) -> Game {
        let points = self.points.is_none().then(Points::default);
        Game { points, ..self.clone() }
    }

    /// A shot at a ball towards a place: so many pixels away, so many pixels a second. Spin is given in
    /// quarters of the speed.
    pub(crate) fn shot(&self, ball: usize, towards: (i32, i32), quarters: i32) -> Option<Shot> {
        let at = *self.balls.get(ball)?;
        let velocity = [f64::from(towards.0) - at[0], f64::from(towards.1) - at[1]];
        let speed = (velocity[0] * velocity[0] + velocity[1] * velocity[1]).sqrt();
        let spin = match self.surface {
            Surface::Smooth => 0.0,
            Surface::Rough => f64::from(quarters) / 4.0 * speed / RADIUS,
        };
        Some(Shot { from: self.balls.clone(), ball, velocity, spin, surface: self.surface })
    }

    /// The game after a shot: where the balls came to rest and which ones the shot ball has touched.
    pub(crate) fn after(&self, shot: Shot, table: &Table, touched: &Touched) -> Game {
        let points = self.points.map(|points| points.after(touched.others.len()));
        let balls = table.balls().iter().map(|ball| ball.at).collect();
        Game { balls, points, last: Some(shot), surface: self.surface }
    }
}

/// The balls that the shot ball has touched.
#[derive(Clone, Debug, Default)]
pub(crate) struct Touched {
    others: BTreeSet<usize>,
}

impl Touched {
    /// Notes a hit.
    pub(crate) fn note(&mut self, shot: usize, hit: &Hit) {
        match hit.obstacle {
            Obstacle::Ball(other) if hit.ball == shot => self.others.insert(other),
            Obstacle::Ball(other) if other == shot => self.others.insert(hit.ball),
            _ => false,
        };
    }
}

fn resting(balls: &[Vector], surface: Surface) -> Option<Table> {
    let balls = balls.iter().map(|&at| Ball::resting(at)).collect();
    Table::new(Field::BILIARD, Cloth { surface, ..Cloth::default() }, balls).ok()
}
