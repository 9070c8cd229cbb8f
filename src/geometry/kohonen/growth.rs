//! The growing net after Fritzke's growing grid (1995).

use super::{Net, Schedule};
use crate::geometry::Point;
use crate::geometry::norm;

/// The gain of growing, and the one that fine tuning ends with.
const GAIN: [f64; 2] = [0.1, 0.005];
/// The radius in neurons.
const RADIUS: f64 = 0.7;
/// Steps a neuron between two insertions.
const BETWEEN: u64 = 30;
/// Steps a neuron of fine tuning.
const TUNING: u64 = 100;

/// How far a growing net has come.
#[derive(Clone, Debug)]
pub(super) struct Growth {
    limit: usize,
    growing: bool,
}

/// What comes after a stage.
pub(super) enum Turn {
    /// The net is perhaps larger, and learns on.
    Next(Schedule),
    /// Nothing.
    Over,
}

impl Growth {
    pub(super) fn new(limit: usize, start: &Net) -> (Self, Schedule) {
        let neurons = start.size().into_iter().product();
        (Self { limit, growing: true }, Self::stage(neurons))
    }

    fn stage(neurons: usize) -> Schedule {
        Schedule::constant(BETWEEN * neurons as u64, [GAIN[0]; 2], RADIUS)
    }

    pub(super) fn is_growing(&self) -> bool {
        self.growing
    }

    /// After all steps of a stage: a row or column more, or fine tuning, or the end.
    pub(super) fn turn(&mut self, net: &mut Net, wins: &[u64]) -> Turn {
        if !self.growing {
            return Turn::Over;
        }
        if let Some(larger) = grown(net, wins, self.limit) {
            *net = larger;
            return Turn::Next(Self::stage(net.size().into_iter().product()));
        }
        self.growing = false;
        let steps = TUNING * net.size().into_iter().product::<usize>() as u64;
        Turn::Next(Schedule::constant(steps, GAIN, RADIUS))
    }

    /// A guess at the part of all steps that is done, when `share` of the present stage is: up to `N` neurons a net makes
    /// a number of steps in proportion to `N^(3/2)`, if it is about as long as wide.
    pub(super) fn progress(&self, net: &Net, share: f64) -> f64 {
        let steps = |neurons: usize| {
            let neurons = neurons.min(self.limit) as f64;
            2.0 / 3.0 * BETWEEN as f64 * neurons * neurons.sqrt()
        };
        let tuning = TUNING as f64 * self.limit as f64;
        let all = steps(self.limit) + tuning;
        if !self.growing {
            return (steps(self.limit) + share * tuning) / all;
        }
        let [rows, columns] = net.size();
        let (from, to) = (steps(rows * columns), steps(rows * columns + rows.min(columns)));
        (from + share * (to - from)) / all
    }
}

/// The net with a row or column between the neuron that won most and its neighbour farthest in space; `None` where that
/// would be too many neurons, or there is no neighbour.
fn grown(net: &Net, wins: &[u64], limit: usize) -> Option<Net> {
    let size = net.size();
    let mut most = 0;
    for (index, count) in wins.iter().enumerate() {
        if *count > wins[most] {
            most = index;
        }
    }
    let busiest = [most / size[1], most % size[1]];
    let at = net.point(busiest);
    // Direction, the index after which to insert, the length of the edge.
    let mut longest: Option<(usize, usize, f64)> = None;
    for (direction, step) in [(0, -1), (0, 1), (1, -1), (1, 1)] {
        let Some(beside) = net.topology().beside(direction, size[direction], busiest[direction], step) else {
            continue;
        };
        let mut other = busiest;
        other[direction] = beside;
        let there = net.point(other);
        let length = norm::<3>(std::array::from_fn(|d| there[d] - at[d]));
        let after = if step > 0 { busiest[direction] } else { beside };
        if other != busiest && longest.is_none_or(|(.., other)| length > other) {
            longest = Some((direction, after, length));
        }
    }
    let (direction, after, _) = longest?;
    let rows = net.rows();
    let mean = |a: Point<3>, b: Point<3>| -> Point<3> { std::array::from_fn(|d| 0.5 * a[d] + 0.5 * b[d]) };
    let next = (after + 1) % size[direction];
    let rows: Vec<Vec<Point<3>>> = if direction == 0 {
        let new = rows[after].iter().zip(&rows[next]).map(|(a, b)| mean(*a, *b)).collect();
        let (before, behind) = rows.split_at(after + 1);
        before.iter().cloned().chain([new]).chain(behind.iter().cloned()).collect()
    } else {
        let longer = |row: Vec<Point<3>>| {
            let new = mean(row[after], row[next]);
            let (before, behind) = row.split_at(after + 1);
            before.iter().copied().chain([new]).chain(behind.iter().copied()).collect()
        };
        rows.into_iter().map(longer).collect()
    };
    let neurons = rows.len() * rows.first().map_or(0, Vec::len);
    if neurons > limit {
        return None;
    }
    Net::new(net.topology(), &rows).ok()
}
