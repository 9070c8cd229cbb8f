//! How much of a step every neuron takes part in, row by row.

use super::topology::{Latitudes, steps_between};
use super::{Net, Topology, Weighting};
use crate::geometry::portable::exp;

/// Factors of a Gauss bell further away than this many radii are left out: they are below 1e-14 of the gain, which is
/// less than a double of a coordinate keeps.
const CUT: f64 = 8.1;

/// How distances and radius become factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Bell {
    /// Of nets of a fixed size.
    Of(Weighting),
    /// Of growing nets: Gauss of the sum of the distances in rows and columns.
    Sum,
}

/// The factors of one step.
#[derive(Clone, Debug)]
pub(super) struct Neighbours {
    bell: Bell,
    size: [usize; 2],
    closed: [bool; 2],
    sphere: Option<Latitudes>,
    /// The bell by distance.
    table: Vec<f64>,
    /// How far the columns of a sphere are from the winner's.
    away: Vec<usize>,
    /// The factors of one row, or the gain times the bell along the winner's.
    row: Vec<f64>,
    gain: f64,
    radius: f64,
    winner: [usize; 2],
}

impl Neighbours {
    pub(super) fn new(net: &Net, bell: Bell) -> Self {
        let size = net.size();
        let distances = if bell == Bell::Sum { size[0] + size[1] } else { size[0].max(size[1]) };
        Self {
            bell,
            size,
            closed: net.topology().closed(),
            sphere: (net.topology() == Topology::Sphere).then(|| Latitudes::new(size)),
            table: vec![0.0; distances],
            away: Vec::new(),
            row: vec![0.0; net.stride()],
            gain: 0.0,
            radius: 0.0,
            winner: [0; 2],
        }
    }

    /// Prepares a step.
    pub(super) fn set(&mut self, winner: [usize; 2], gain: f64, radius: f64) {
        (self.winner, self.gain, self.radius) = (winner, gain, radius);
        if self.sphere.is_some() {
            let columns = self.size[1];
            self.away.clear();
            self.away.extend((0..columns).map(|j| steps_between(true, columns, j, winner[1])));
            return;
        }
        match self.bell {
            Bell::Of(Weighting::Bubble) => {
                for (d, factor) in self.table.iter_mut().enumerate() {
                    *factor = f64::from(u8::from(d as f64 <= radius));
                }
            }
            _ => {
                // exp(-d^2 / (2 r^2)) by the odd powers between squares: one exponential function in all.
                let once = exp(-0.5 / (radius * radius));
                let (mut bell, mut ratio, twice) = (1.0, once, once * once);
                let within = CUT * radius;
                for (d, factor) in self.table.iter_mut().enumerate() {
                    *factor = if d as f64 <= within { bell } else { 0.0 };
                    bell *= ratio;
                    ratio *= twice;
                }
            }
        }
        if self.bell != Bell::Sum {
            let (columns, closed) = (self.size[1], self.closed[1]);
            for (j, factor) in self.row.iter_mut().enumerate().take(columns) {
                let d = steps_between(closed, columns, j, winner[1]);
                *factor = gain * self.table.get(d).copied().unwrap_or(0.0);
            }
        }
    }

    /// The factors of the neurons of a row, as one number for all and one for each place, with zeros for the room behind
    /// the last; `None` where all are 0.
    #[inline]
    pub(super) fn row(&mut self, i: usize) -> Option<(f64, &[f64])> {
        if self.sphere.is_some() {
            return self.latitude(i);
        }
        let away = steps_between(self.closed[0], self.size[0], i, self.winner[0]);
        let along = self.table.get(away).copied().filter(|factor| *factor > 0.0)?;
        if self.bell == Bell::Sum {
            let (columns, closed) = (self.size[1], self.closed[1]);
            for (j, factor) in self.row.iter_mut().enumerate().take(columns) {
                let d = away + steps_between(closed, columns, j, self.winner[1]);
                *factor = self.table.get(d).copied().unwrap_or(0.0);
            }
            return Some((self.gain, &self.row));
        }
        Some((along, &self.row))
    }

    /// The row of a sphere, where rows are of different lengths.
    fn latitude(&mut self, i: usize) -> Option<(f64, &[f64])> {
        let sphere = self.sphere.as_ref()?;
        let (bubble, radius) = (self.bell == Bell::Of(Weighting::Bubble), self.radius);
        let within = if bubble { radius } else { CUT * radius };
        // Nothing of a row is nearer than its latitude.
        if i.abs_diff(self.winner[0]) as f64 > within {
            return None;
        }
        // The bell by the difference of columns, as far as it is not 0. Neighbours in a column are 1 apart but for rounding.
        let squares = sphere.squares([self.winner[0], i]);
        let most = within * within + 1e-9;
        let count = squares.partition_point(|square| *square <= most);
        self.table.clear();
        self.table.extend_from_slice(squares.get(..count).unwrap_or(squares));
        if bubble {
            self.table.fill(1.0);
        } else {
            let scale = -0.5 / (radius * radius);
            self.table.iter_mut().for_each(|square| *square = exp(scale * *square));
        }
        for (factor, away) in self.row.iter_mut().zip(&self.away) {
            *factor = self.table.get(*away).copied().unwrap_or(0.0);
        }
        Some((self.gain, &self.row))
    }
}
