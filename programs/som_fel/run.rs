//! What goes on by itself: learning, a slow step, a fit, the reading of a file. It advances by pieces that the session's
//! clock counts, so that it comes equally far in a recording, and no result depends on the size of a piece.

use super::reading::Reading;
use crate::geometry::cloud::Cloud;
use crate::geometry::fit::{Fit, Report, Stage};
use crate::geometry::kohonen::{End, Learning, Net};
use std::time::Duration;

/// The time between two pictures.
pub(super) const FRAME: Duration = Duration::from_nanos(1_000_000_000 / 60);
/// Pictures that learning has at least, one size of a growing net, and one pass of a fit: quicker ones could not be seen.
const PICTURES: u64 = 180;
const STAGE_PICTURES: u64 = 12;
const SOLUTION_PICTURES: usize = 12;
/// What a piece may cost: neurons times steps, about 5 ms, and points of a fit, about 7 ms.
const MOST_MOVES: u64 = 1_600_000;
const MOST_POINTS: usize = 5_000;
/// What of a solution may be done between two pictures in units of [`Fit::advance`], and at a time, so that hardly any of
/// what follows is.
const SOLUTION: usize = 20_000;
const SOLUTION_PIECE: usize = 200;
/// How long one slow step is shown, and its parts: the point, the winner, the neighbours, the movement.
const STEP: Duration = Duration::from_millis(2000);
pub(super) const PARTS: f64 = 4.0;

/// What goes on.
#[derive(Debug, Default)]
pub(super) enum Run {
    #[default]
    Nothing,
    Learning(Box<Learning>),
    /// The last step of learning, slowly.
    Slow(Box<Slow>),
    Fitting(Box<Fit>),
    Reading(Box<Reading>),
}

/// A slow step: what is learnt with it, the net before it, and when it was begun.
#[derive(Debug)]
pub(super) struct Slow {
    pub(super) learning: Learning,
    pub(super) before: Net,
    pub(super) begun: Duration,
}

impl Slow {
    /// How far it is, from 0 to [`PARTS`].
    pub(super) fn part(&self, now: Duration) -> f64 {
        let part = now.saturating_sub(self.begun).as_secs_f64() / STEP.as_secs_f64();
        (PARTS * part).min(PARTS)
    }
}

/// The steps of learning between two pictures.
fn steps_of(learning: &Learning) -> u64 {
    let [rows, columns] = learning.net().size();
    let most = MOST_MOVES / (rows * columns).max(1) as u64;
    // A growing net has many stages.
    let pictures = if learning.is_growing() { STAGE_PICTURES } else { PICTURES };
    learning.schedule().steps().div_ceil(pictures).clamp(1, most.max(1))
}

/// Advances learning by a picture; why it is over when it is.
pub(super) fn learn(learning: &mut Learning) -> Option<End> {
    learning.advance(steps_of(learning))
}

/// Advances a fit by a picture, at most to the end of a solution, so that each is shown; the report at the end.
pub(super) fn fit(fit: &mut Fit, cloud: &Cloud) -> Option<Report> {
    if fit.stage() == Stage::Solution {
        for _ in 0..SOLUTION / SOLUTION_PIECE {
            let report = fit.advance(SOLUTION_PIECE).cloned();
            if report.is_some() || fit.stage() != Stage::Solution {
                return report;
            }
        }
        return None;
    }
    let points = cloud.points().len().div_ceil(SOLUTION_PICTURES).clamp(1, MOST_POINTS);
    fit.advance(points).cloned()
}
