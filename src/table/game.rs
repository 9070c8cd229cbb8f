//! A game of billiards as a plain value: where the balls rest, the shot that led there, the points.

use super::{Ball, Cloth, Field, GameError, Hit, Obstacle, RACK, RADIUS, Surface, Table, TableError, Vector};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// How many points win.
pub const GOAL: u32 = 30;

/// A complete shot; it always gives the same motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shot {
    /// Where the balls lay before it.
    pub from: Vec<Vector>,
    /// The ball that was shot, by its index.
    pub ball: usize,
    /// Pixels a second, y down.
    pub velocity: Vector,
    /// Radians a second.
    pub spin: f64,
    /// The surfaces of the balls.
    pub surface: Surface,
}

impl Shot {
    /// The table at the moment of the shot.
    ///
    /// # Errors
    /// [`TableError`] if there is no such shot.
    pub fn table(&self) -> Result<Table, TableError> {
        let mut table = resting(&self.from, self.surface)?;
        table.shoot(self.ball, self.velocity, self.spin)?;
        Ok(table)
    }
}

/// The points of two players.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Points {
    /// The points of each.
    pub scores: [u32; 2],
    /// Who is to play, 0 or 1.
    pub turn: usize,
}

impl Points {
    /// Who has reached the goal.
    #[must_use]
    pub fn winner(&self) -> Option<usize> {
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
#[serde(deny_unknown_fields)]
pub struct Game {
    /// Where the balls lie.
    pub balls: Vec<Vector>,
    /// The surfaces that the next shot is played with.
    pub surface: Surface,
    /// The points, when two play for them.
    pub points: Option<Points>,
    /// The shot that led here.
    pub last: Option<Shot>,
}

impl Default for Game {
    fn default() -> Game {
        Game::new()
    }
}

impl Game {
    /// The start.
    #[must_use]
    pub fn new() -> Game {
        Game { balls: RACK.to_vec(), surface: Surface::Smooth, points: None, last: None }
    }

    /// The balls at rest on their table; a game that was checked has one.
    pub fn table(&self) -> Table {
        resting(&self.balls, self.surface).unwrap_or_else(|_| Table::rack())
    }

    /// Checks what every game must keep.
    ///
    /// # Errors
    /// [`GameError`] with what is wrong.
    pub fn check(&self) -> Result<(), GameError> {
        let count = RACK.len();
        let lists = self.last.iter().map(|shot| &shot.from).chain([&self.balls]);
        if let Some(found) = lists.map(Vec::len).find(|&found| found != count) {
            return Err(GameError::Balls { found, wanted: count });
        }
        resting(&self.balls, self.surface).map_err(GameError::Table)?;
        match &self.last {
            _ if self.points.is_some_and(|points| points.turn > 1) => Err(GameError::Turn),
            Some(shot) => shot.table().map(|_| ()).map_err(GameError::Shot),
            None => Ok(()),
        }
    }

    /// The game with the balls' start; the players begin anew.
    #[must_use]
    pub fn racked(&self) -> Game {
        Game { surface: self.surface, points: self.points.map(|_| Points::default()), ..Game::new() }
    }

    /// The game with other surfaces.
    #[must_use]
    pub fn with_other_surface(&self) -> Game {
        let surface = match self.surface {
            Surface::Smooth => Surface::Rough,
            Surface::Rough => Surface::Smooth,
        };
        Game { surface, ..self.clone() }
    }

    /// The game for points, or without if it is for points now.
    #[must_use]
    pub fn with_other_mode(&self) -> Game {
        let points = self.points.is_none().then(Points::default);
        Game { points, ..self.clone() }
    }

    /// A shot at a ball towards a place: so many pixels away, so many pixels a second. Spin is given in
    /// quarters of the speed.
    pub fn shot(&self, ball: usize, towards: (i32, i32), quarters: i32) -> Option<Shot> {
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
    #[must_use]
    pub fn after(&self, shot: Shot, table: &Table, touched: &Touched) -> Game {
        let points = self.points.map(|points| points.after(touched.others.len()));
        let balls = table.balls().iter().map(|ball| ball.at).collect();
        Game { balls, points, last: Some(shot), surface: self.surface }
    }
}

/// The balls that the shot ball has touched.
#[derive(Clone, Debug, Default)]
pub struct Touched {
    others: BTreeSet<usize>,
}

impl Touched {
    /// Notes a hit.
    pub fn note(&mut self, shot: usize, hit: &Hit) {
        match hit.obstacle {
            Obstacle::Ball(other) if hit.ball == shot => self.others.insert(other),
            Obstacle::Ball(other) if other == shot => self.others.insert(hit.ball),
            _ => false,
        };
    }
}

fn resting(balls: &[Vector], surface: Surface) -> Result<Table, TableError> {
    let balls = balls.iter().map(|&at| Ball::resting(at)).collect();
    Table::new(Field::BILIARD, Cloth { surface, ..Cloth::default() }, balls)
}
