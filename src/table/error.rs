//! Invalid tables, and the checks that find them.

use super::{Ball, Cloth, FASTEST, Field, OVERLAP, RADIUS};
use std::fmt;

/// Why there is no such table or shot. Balls are counted from 0; the messages count them from 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TableError {
    /// The field's limits are not finite, or the lower one is above the upper one.
    Field,
    /// The damping is not within 0 to 1, or the stop rule's limit is no finite number from 0.
    Cloth,
    /// There is no such ball.
    NoBall {
        /// The ball asked for.
        ball: usize,
        /// How many there are.
        count: usize,
    },
    /// A ball's centre is not within the limits.
    Outside {
        /// The ball.
        ball: usize,
    },
    /// A velocity or the surface speed of a spin is not finite or above [`FASTEST`].
    TooFast {
        /// The ball.
        ball: usize,
    },
    /// Two balls lie in each other.
    Overlap {
        /// The two balls.
        balls: [usize; 2],
        /// Distance of their centres in pixels.
        distance: f64,
    },
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Field => {
                f.write_str("the field's limits should be finite, the lower ones below the upper ones")
            }
            Self::Cloth => f.write_str(
                "the damping should be within 0 to 1, and the stop rule's limit finite and not below 0",
            ),
            Self::NoBall { ball, count } => {
                write!(f, "there is no ball {}; there are {count}", ball.saturating_add(1))
            }
            Self::Outside { ball } => {
                write!(f, "ball {}: its centre should be within the field's limits", ball.saturating_add(1))
            }
            Self::TooFast { ball } => {
                write!(
                    f,
                    "ball {}: velocity and spin should be finite and at most {FASTEST} pixels a second",
                    ball.saturating_add(1)
                )
            }
            Self::Overlap { balls: [a, b], distance } => {
                let least = 2.0 * RADIUS;
                write!(
                    f,
                    "balls {} and {} lie in each other: {distance} pixels apart, at least {least} is right",
                    a.saturating_add(1),
                    b.saturating_add(1)
                )
            }
        }
    }
}

impl std::error::Error for TableError {}

/// Why there is no such game.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GameError {
    /// Not as many balls as every game has.
    Balls {
        /// How many there are.
        found: usize,
        /// How many there should be.
        wanted: usize,
    },
    /// The balls cannot lie like this.
    Table(TableError),
    /// Neither player's turn.
    Turn,
    /// The last shot is not possible.
    Shot(TableError),
}

impl fmt::Display for GameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Balls { found, wanted } => write!(f, "there are {found} balls; there should be {wanted}"),
            Self::Table(error) => error.fmt(f),
            Self::Turn => f.write_str("points.turn should be 0 or 1"),
            Self::Shot(error) => write!(f, "the last shot is not possible: {error}"),
        }
    }
}

impl std::error::Error for GameError {}

/// Checks all that a table must keep.
pub(super) fn check(field: &Field, cloth: &Cloth, balls: &[Ball]) -> Result<(), TableError> {
    let bounded = |axis: usize| {
        field.min[axis].is_finite() && field.max[axis].is_finite() && field.min[axis] <= field.max[axis]
    };
    if !(bounded(0) && bounded(1)) {
        return Err(TableError::Field);
    }
    if !((0.0..=1.0).contains(&cloth.damping) && cloth.stop >= 0.0 && cloth.stop.is_finite()) {
        return Err(TableError::Cloth);
    }
    for (index, ball) in balls.iter().enumerate() {
        if !field.holds(ball.at) {
            return Err(TableError::Outside { ball: index });
        }
        check_motion(index, ball)?;
    }
    check_overlaps(balls)
}

/// Checks a ball's velocity and spin.
pub(super) fn check_motion(index: usize, ball: &Ball) -> Result<(), TableError> {
    let speeds = [ball.velocity[0], ball.velocity[1], ball.spin * RADIUS];
    match speeds.iter().all(|speed| speed.abs() <= FASTEST) {
        true => Ok(()),
        false => Err(TableError::TooFast { ball: index }),
    }
}

/// Goes through the balls from left to right; only those less than a diameter apart in x are compared.
fn check_overlaps(balls: &[Ball]) -> Result<(), TableError> {
    let mut order: Vec<usize> = (0..balls.len()).collect();
    order.sort_by(|&a, &b| balls[a].at[0].total_cmp(&balls[b].at[0]));
    for (place, &a) in order.iter().enumerate() {
        for &b in &order[place + 1..] {
            let [dx, dy] = [balls[b].at[0] - balls[a].at[0], balls[b].at[1] - balls[a].at[1]];
            if dx >= 2.0 * RADIUS {
                break;
            }
            let distance = (dx * dx + dy * dy).sqrt();
            if distance < 2.0 * RADIUS - OVERLAP {
                return Err(TableError::Overlap { balls: [a.min(b), a.max(b)], distance });
            }
        }
    }
    Ok(())
}
