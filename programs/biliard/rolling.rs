//! Balls in motion: the table's steps against the clock.

use crate::machine::FRAMES_PER_SECOND;
use crate::table::{Game, Shot, Touched};
use crate::table::{STEP, Table};
use std::cell::OnceCell;
use std::time::Duration;

/// Length of a step on the clock.
const STEP_TIME: Duration = Duration::from_millis(31);

/// How fast time passes on the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pace {
    /// As on the clock.
    Full,
    /// The replay: four times slower.
    Slow,
}

impl Pace {
    fn step_time(self) -> Duration {
        match self {
            Pace::Full => STEP_TIME,
            Pace::Slow => 4 * STEP_TIME,
        }
    }
}

/// A shot whose balls are still in motion. Steps fall on fixed times, so that the motion does not depend on the frame
/// rate.
#[derive(Clone)]
pub(crate) struct Rolling {
    pub(crate) shot: Shot,
    pub(crate) pace: Pace,
    /// The table after the last whole step.
    pub(crate) table: Table,
    pub(crate) touched: Touched,
    started: Duration,
    steps: u32,
    /// Table and touches at rest, once somebody has asked: every picture of a game with points does.
    end: OnceCell<(Table, Touched)>,
}

impl Rolling {
    /// The motion of a shot that was made at a moment of the clock; `None` if it is not possible.
    pub(crate) fn start(shot: Shot, pace: Pace, now: Duration) -> Option<Rolling> {
        let table = shot.table().ok()?;
        Some(Rolling {
            shot,
            pace,
            table,
            touched: Touched::default(),
            started: now,
            steps: 0,
            end: OnceCell::new(),
        })
    }

    /// Makes the steps that are due; `true` when the balls have come to rest.
    pub(crate) fn advance(&mut self, now: Duration) -> bool {
        while !self.table.at_rest() && self.step_end(self.steps) <= now {
            self.step();
        }
        self.table.at_rest()
    }

    /// The game after the shot, from the one before it.
    pub(crate) fn outcome(&self, game: &Game) -> Game {
        let (table, touched) = self.end.get_or_init(|| {
            let mut ahead = self.clone();
            while !ahead.table.at_rest() {
                ahead.step();
            }
            (ahead.table, ahead.touched)
        });
        game.after(self.shot.clone(), table, touched)
    }

    fn step(&mut self) {
        let (shot, touched) = (self.shot.ball, &mut self.touched);
        self.table.step_seeing(|hit| touched.note(shot, &hit));
        self.steps = self.steps.saturating_add(1);
    }

    /// When step number `steps` (from 0) is over.
    fn step_end(&self, steps: u32) -> Duration {
        self.started + self.pace.step_time().saturating_mul(steps.saturating_add(1))
    }

    /// The next moment at which there is something to do or a picture to show.
    pub(crate) fn next_moment(&self, now: Duration) -> Duration {
        let frame = Duration::from_secs(1) / FRAMES_PER_SECOND;
        let frames = now.saturating_sub(self.started).as_nanos() / frame.as_nanos() + 1;
        let next_frame = self.started + frame.saturating_mul(u32::try_from(frames).unwrap_or(u32::MAX));
        next_frame.min(self.step_end(self.steps))
    }

    /// The table at a moment between two steps.
    pub(crate) fn at(&self, now: Duration) -> Table {
        let step_time = self.pace.step_time();
        let begun = self.started + step_time.saturating_mul(self.steps);
        let part = now.saturating_sub(begun).as_secs_f64() / step_time.as_secs_f64();
        self.table.within_step(part.clamp(0.0, 1.0) * STEP)
    }
}
