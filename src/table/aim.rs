//! What a shot will hit first, for the aiming line.

use super::collide::{hit_balls, hit_wall, minus, moved, time_to_touch, time_to_wall};
use super::{Ball, STEP, Table, Vector, Wall};
use serde::Serialize;

/// What a ball can hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Obstacle {
    /// Another ball, by its index.
    Ball(usize),
    /// A wall.
    Wall(Wall),
}

/// The straight part of a shot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// The ball's centre where it hits something or comes to rest.
    pub at: Vector,
    /// What it hits; `None` if it comes to rest before.
    pub obstacle: Option<Obstacle>,
    /// Its velocity after the hit.
    pub after: Vector,
    /// The velocity of the ball that is hit; zero if there is none.
    pub passed_on: Vector,
}

impl Table {
    /// Predicts the first hit of a shot while all other balls rest where they are. `None` when there is no
    /// such ball or the shot cannot be made. The slowing down on the way is counted.
    #[must_use]
    pub fn first_hit(&self, ball: usize, velocity: Vector, spin: f64) -> Option<Prediction> {
        let mut shot = self.clone();
        shot.shoot(ball, velocity, spin).ok()?;
        let start = *shot.balls.get(ball)?;
        // Along the way all is as if the first velocity went on for a shorter time.
        let reach = self.reach(&start);
        let mut first = time_to_wall(&self.field, start.at, velocity, reach)
            .map(|(time, wall)| (time, Obstacle::Wall(wall)));
        for (index, other) in self.balls.iter().enumerate().filter(|(index, _)| *index != ball) {
            let time = time_to_touch(minus(other.at, start.at), [-velocity[0], -velocity[1]]);
            let nearest = first.map_or(reach, |(time, _)| time);
            if let Some(time) = time.filter(|&time| time <= nearest) {
                first = Some((time, Obstacle::Ball(index)));
            }
        }
        let Some((time, obstacle)) = first else {
            let at = moved(start.at, velocity, reach);
            return Some(Prediction { at, obstacle: None, after: [0.0; 2], passed_on: [0.0; 2] });
        };
        let left = self.speed_left(time);
        let mut own = Ball {
            at: moved(start.at, velocity, time),
            velocity: velocity.map(|v| v * left),
            spin: spin * left,
        };
        let at = own.at;
        let mut passed_on = [0.0; 2];
        match obstacle {
            Obstacle::Wall(wall) => hit_wall(&self.field, &mut own, wall, self.cloth.surface),
            Obstacle::Ball(index) => {
                let mut other = Ball { at: self.balls.get(index)?.at, ..Ball::default() };
                hit_balls(&mut own, &mut other, self.cloth.surface);
                passed_on = other.velocity;
            }
        }
        Some(Prediction { at, obstacle: Some(obstacle), after: own.velocity, passed_on })
    }

    /// For how many seconds of its first velocity a ball rolls until the stop rule ends it: the sum of
    /// `STEP damping^k` over the steps k that are made. The last step counts in part, 0.01 pixels at most.
    fn reach(&self, ball: &Ball) -> f64 {
        let damping = self.cloth.damping;
        let lost = 1.0 - self.cloth.stop / ball.pace();
        let reach = STEP * damping * lost / (1.0 - damping);
        // A ball that never slows down rolls forever; one that does not roll has no pace.
        if reach > 0.0 { reach.min(f64::MAX) } else { 0.0 }
    }

    /// What part of a velocity is left after so many seconds of it have been rolled, to within the slowing
    /// of one step.
    fn speed_left(&self, time: f64) -> f64 {
        let damping = self.cloth.damping;
        (1.0 - time * (1.0 - damping) / (STEP * damping)).clamp(0.0, 1.0)
    }
}
