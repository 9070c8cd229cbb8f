//! What a shot will hit first, for the aiming line.

use super::collide::{SAME_MOMENT, hit_together, hit_wall, minus, moved, time_to_touch, time_to_wall};
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
#[derive(Clone, Debug, PartialEq)]
pub struct Prediction {
    /// The ball's centre where it hits something or comes to rest.
    pub at: Vector,
    /// What it hits, the first of several balls; `None` if it comes to rest before.
    pub obstacle: Option<Obstacle>,
    /// Its velocity after the hit.
    pub after: Vector,
    /// The balls that are hit, by their indices, and their velocities after it.
    pub passed_on: Vec<(usize, Vector)>,
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
        let touch = |(index, other): (usize, &Ball)| {
            let time = time_to_touch(minus(other.at, start.at), [-velocity[0], -velocity[1]]);
            time.filter(|&time| index != ball && time <= reach).map(|time| (time, index))
        };
        let touched: Vec<(f64, usize)> = self.balls.iter().enumerate().filter_map(touch).collect();
        let nearest = touched.iter().map(|(time, _)| *time).min_by(f64::total_cmp);
        let wall = time_to_wall(&self.field, start.at, velocity, nearest.unwrap_or(reach));
        let Some(time) = wall.map(|(time, _)| time).or(nearest) else {
            let at = moved(start.at, velocity, reach);
            return Some(Prediction { at, obstacle: None, after: [0.0; 2], passed_on: Vec::new() });
        };
        let left = self.speed_left(time);
        let at = moved(start.at, velocity, time);
        let mut balls = vec![Ball { at, velocity: velocity.map(|v| v * left), spin: spin * left }];
        let mut passed_on = Vec::new();
        let obstacle = match wall {
            Some((_, wall)) => {
                hit_wall(&self.field, balls.first_mut()?, wall, self.cloth.surface);
                Obstacle::Wall(wall)
            }
            None => {
                let together = touched.iter().filter(|(touch, _)| *touch <= time + SAME_MOMENT);
                let hit: Vec<usize> = together.map(|(_, index)| *index).collect();
                balls.extend(
                    hit.iter().filter_map(|&index| self.balls.get(index)).map(|it| Ball::resting(it.at)),
                );
                let pairs: Vec<[usize; 2]> = (1..balls.len()).map(|other| [0, other]).collect();
                hit_together(&mut balls, &pairs, self.cloth.surface);
                passed_on = hit.iter().copied().zip(balls.iter().skip(1).map(|it| it.velocity)).collect();
                Obstacle::Ball(*hit.first()?)
            }
        };
        Some(Prediction { at, obstacle: Some(obstacle), after: balls.first()?.velocity, passed_on })
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
