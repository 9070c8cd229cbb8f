//! Billiard balls on a table (chapters 4.1 and 4.3): equal balls that roll, slow down, and hit each other and
//! the walls. A [`Table`] is a plain value that advances by steps; it knows of no screen, player or clock.
//!
//! As in the book, a step is [`STEP`] seconds, every velocity is multiplied by the damping at its start and
//! constant within it. The hits inside a step are found exactly and in the order of their times (`sweep`), so
//! that balls never lie in each other and no hit loses energy. Only `+ - * /` and square roots are used, which
//! every processor rounds alike: the same table gives the same bits everywhere.
//!
//! Lengths are pixels, times seconds, the mass of a ball is 1; x points right and y down, for positions and
//! velocities. Not here: pockets, rolling spin, friction of the cloth that depends on speed.
//!
//! ```
//! use grafika::table::{Table, RACK};
//!
//! let mut table = Table::rack();
//! table.shoot(0, [300.0, 0.0], 0.0).unwrap();
//! while !table.at_rest() {
//!     table.step();
//! }
//! assert_ne!(table.balls()[5].at, RACK[5]);
//! ```

mod aim;
mod collide;
mod error;
mod game;
mod sweep;
#[cfg(test)]
mod tests;

pub use aim::{Obstacle, Prediction};
pub use error::{GameError, TableError};
pub use game::{GOAL, Game, Points, Shot, Touched};

use serde::{Deserialize, Serialize};

/// A place or a velocity: x to the right, y down.
pub type Vector = [f64; 2];

/// Radius of every ball in pixels.
pub const RADIUS: f64 = 8.0;
/// Length of a step in seconds.
pub const STEP: f64 = 0.031;
/// No ball may start faster than this, in pixels a second; a shot across the whole screen has 675.
pub const FASTEST: f64 = 10_000.0;
/// How far two balls may lie in each other by rounding, in pixels.
pub const OVERLAP: f64 = 1e-9;
/// A solid ball's moment of inertia in units of mass times radius squared.
pub const INERTIA: f64 = 0.4;

/// The centres of the eleven balls at the start; the first one is meant to be shot.
pub const RACK: [Vector; 11] = [
    [60.0, 240.0],
    [400.0, 240.0],
    [414.0, 232.0],
    [414.0, 248.0],
    [428.0, 256.0],
    [428.0, 240.0],
    [428.0, 224.0],
    [442.0, 216.0],
    [442.0, 232.0],
    [442.0, 248.0],
    [442.0, 264.0],
];

/// One ball.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ball {
    /// Its centre.
    pub at: Vector,
    /// Pixels a second.
    pub velocity: Vector,
    /// Its turning about the vertical axis in radians a second, from x to y positive: clockwise as seen on
    /// the screen.
    #[serde(default)]
    pub spin: f64,
}

impl Ball {
    /// A ball at rest.
    #[must_use]
    pub fn resting(at: Vector) -> Ball {
        Ball { at, ..Ball::default() }
    }

    /// The sum of the velocity's two parts, which the book compares with the stop rule's limit.
    fn pace(&self) -> f64 {
        self.velocity[0].abs() + self.velocity[1].abs()
    }
}

/// The rectangle in which the balls' centres stay: one radius inside the walls.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Field {
    /// Left and upper limit.
    pub min: Vector,
    /// Right and lower limit.
    pub max: Vector,
}

impl Field {
    /// The book's table.
    pub const BILIARD: Field = Field { min: [44.0, 44.0], max: [595.0, 435.0] };

    /// Whether a centre is within the limits.
    #[must_use]
    pub fn holds(&self, at: Vector) -> bool {
        (0..2).all(|axis| self.min[axis] <= at[axis] && at[axis] <= self.max[axis])
    }
}

/// One of the four walls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Wall {
    /// x smallest.
    Left,
    /// x largest.
    Right,
    /// y smallest.
    Top,
    /// y largest.
    Bottom,
}

/// What the surfaces of balls and walls do to each other in a hit. Either way no energy is lost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Surface {
    /// They slide: only the velocities along the line of centres change (4.1 to 4.7), spin does nothing.
    #[default]
    Smooth,
    /// They grip and spring back: the velocity with which the surfaces slide on each other is turned round
    /// too, so that spin bends the way after a hit and passes on to other balls.
    Rough,
}

/// How balls slow down and what their surfaces are like.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cloth {
    /// What velocities and spins are multiplied by at the start of a step, 0 to 1.
    pub damping: f64,
    /// When |vx| + |vy| of no ball is above this after a step, all stop; pixels a second.
    pub stop: f64,
    /// The surfaces of balls and walls.
    pub surface: Surface,
}

impl Default for Cloth {
    /// The book's: damping 0.998, stop at 0.2, smooth.
    fn default() -> Cloth {
        Cloth { damping: 0.998, stop: 0.2, surface: Surface::Smooth }
    }
}

/// A hit that happened within a step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Hit {
    /// Seconds since the start of the step.
    pub time: f64,
    /// The ball, by its index.
    pub ball: usize,
    /// What it hit.
    pub obstacle: Obstacle,
}

/// Balls on a table.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Table {
    field: Field,
    cloth: Cloth,
    balls: Vec<Ball>,
}

impl Table {
    /// A table with balls on it.
    ///
    /// # Errors
    /// [`TableError`] when a number is not finite, the field is empty, the damping is not within 0 to 1, a
    /// ball is outside or too fast, or two balls lie in each other by more than [`OVERLAP`].
    pub fn new(field: Field, cloth: Cloth, balls: Vec<Ball>) -> Result<Table, TableError> {
        error::check(&field, &cloth, &balls)?;
        Ok(Table { field, cloth, balls })
    }

    /// The book's table with the eleven balls of the start.
    #[must_use]
    pub fn rack() -> Table {
        let balls = RACK.into_iter().map(Ball::resting).collect();
        Table { field: Field::BILIARD, cloth: Cloth::default(), balls }
    }

    /// The balls.
    #[must_use]
    pub fn balls(&self) -> &[Ball] {
        &self.balls
    }

    /// The limits of the centres.
    #[must_use]
    pub fn field(&self) -> Field {
        self.field
    }

    /// How balls slow down and hit.
    #[must_use]
    pub fn cloth(&self) -> Cloth {
        self.cloth
    }

    /// Gives a ball a velocity and a spin.
    ///
    /// # Errors
    /// [`TableError`] when there is no such ball, or the velocity or spin is not finite or too fast.
    pub fn shoot(&mut self, ball: usize, velocity: Vector, spin: f64) -> Result<(), TableError> {
        let count = self.balls.len();
        let shot = self.balls.get_mut(ball).ok_or(TableError::NoBall { ball, count })?;
        let moved = Ball { at: shot.at, velocity, spin };
        error::check_motion(ball, &moved)?;
        *shot = moved;
        Ok(())
    }

    /// Advances by one step of [`STEP`] seconds.
    pub fn step(&mut self) {
        self.step_seeing(|_| {});
    }

    /// Advances by one step and tells every hit in the order of time.
    pub fn step_seeing(&mut self, seen: impl FnMut(Hit)) {
        if self.at_rest() {
            return;
        }
        self.slow_down();
        self.roll(STEP, seen);
        if self.balls.iter().all(|ball| ball.pace() <= self.cloth.stop) {
            for ball in &mut self.balls {
                *ball = Ball::resting(ball.at);
            }
        }
    }

    /// Advances by some steps, or until all balls are at rest. Returns the number of steps made.
    pub fn advance(&mut self, steps: u64) -> u64 {
        (0..steps)
            .find(|_| {
                let over = self.at_rest();
                self.step();
                over
            })
            .unwrap_or(steps)
    }

    /// The table some seconds after the start of the next step, at most [`STEP`]: what lies between two
    /// steps, for pictures.
    #[must_use]
    pub fn within_step(&self, seconds: f64) -> Table {
        let mut table = self.clone();
        if !table.at_rest() {
            table.slow_down();
            table.roll(seconds, |_| {});
        }
        table
    }

    /// Whether no ball moves.
    #[must_use]
    pub fn at_rest(&self) -> bool {
        self.balls.iter().all(|ball| ball.velocity == [0.0, 0.0])
    }

    /// Kinetic energy of all balls, rolling left out: pixels squared by seconds squared, mass 1. The energy
    /// of the spin about the vertical axis counts where hits can change it.
    #[must_use]
    pub fn energy(&self) -> f64 {
        let turning = match self.cloth.surface {
            Surface::Smooth => 0.0,
            Surface::Rough => INERTIA * RADIUS * RADIUS,
        };
        let twice = self.balls.iter().map(|ball| {
            let [x, y] = ball.velocity;
            x * x + y * y + turning * ball.spin * ball.spin
        });
        twice.sum::<f64>() / 2.0
    }

    /// Momentum of all balls: pixels by seconds, mass 1.
    #[must_use]
    pub fn momentum(&self) -> Vector {
        self.balls.iter().fold([0.0, 0.0], |sum, ball| [sum[0] + ball.velocity[0], sum[1] + ball.velocity[1]])
    }

    fn slow_down(&mut self) {
        let damping = self.cloth.damping;
        for ball in &mut self.balls {
            ball.velocity = [ball.velocity[0] * damping, ball.velocity[1] * damping];
            ball.spin *= damping;
        }
    }

    /// Lets the balls roll without slowing down; at most [`STEP`] seconds.
    fn roll(&mut self, seconds: f64, seen: impl FnMut(Hit)) {
        // The comparison is false for NaN too.
        if seconds > 0.0 {
            sweep::roll(&self.field, self.cloth.surface, &mut self.balls, seconds.min(STEP), seen);
        }
    }
}
