//! What a net is joined to itself by, and how far its neurons are from each other on it.

use crate::geometry::{cross, dot, norm};
use std::f64::consts::{PI, TAU};

/// How the rows and columns of a net are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Topology {
    /// Four borders.
    #[default]
    Open,
    /// Every row is a ring: after the last column comes the first.
    Cylinder,
    /// Rows and columns are rings.
    Torus,
    /// Every row is a circle of latitude; all neurons of the first are one, the north pole, and all of the last.
    Sphere,
}

impl Topology {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Open, Self::Cylinder, Self::Torus, Self::Sphere];

    /// What it is called: `open`, `cylinder`, `torus`, `sphere`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Cylinder => "cylinder",
            Self::Torus => "torus",
            Self::Sphere => "sphere",
        }
    }

    /// The topology of a name.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|topology| topology.name() == name)
    }

    /// Whether the last row is joined to the first, and the last column to the first.
    #[must_use]
    pub fn closed(self) -> [bool; 2] {
        match self {
            Self::Open => [false, false],
            Self::Cylinder | Self::Sphere => [false, true],
            Self::Torus => [true, true],
        }
    }

    /// The index after (or with -1 before) another in a direction, if there is one.
    pub(super) fn beside(self, direction: usize, count: usize, index: usize, step: isize) -> Option<usize> {
        match index.checked_add_signed(step) {
            Some(next) if next < count => Some(next),
            _ if !self.closed()[direction] => None,
            Some(_) => Some(0),
            None => Some(count - 1),
        }
    }
}

/// The distance of two indices in a direction of `count`.
pub(super) fn steps_between(closed: bool, count: usize, a: usize, b: usize) -> usize {
    let steps = a.abs_diff(b);
    if closed { steps.min(count - steps) } else { steps }
}

/// The squares of the distances on a sphere, where neighbours in a column are 1 apart.
#[derive(Clone, Debug)]
pub(super) struct Latitudes {
    rows: usize,
    /// Differences of columns from 0 to half way round.
    around: usize,
    /// By row, other row, difference of columns.
    squares: Vec<f64>,
}

impl Latitudes {
    pub(super) fn new([rows, columns]: [usize; 2]) -> Self {
        let around = columns / 2 + 1;
        let unit = (rows.max(2) - 1) as f64 / PI;
        let latitude = |i: usize| PI * i as f64 / (rows.max(2) - 1) as f64;
        let square = |i: usize, k: usize, d: usize| {
            let pole = |i| i == 0 || i + 1 == rows;
            if pole(i) || pole(k) {
                // The same for all columns to the last bit, for the neurons of a pole must stay one.
                return (i.abs_diff(k) as f64).powi(2);
            }
            let (a, b, c) = (latitude(i), latitude(k), TAU * d as f64 / columns as f64);
            // By sine and cosine of the angle, which is exact for neighbours and for opposite neurons.
            let (one, other) = ([a.sin(), 0.0, a.cos()], [b.sin() * c.cos(), b.sin() * c.sin(), b.cos()]);
            (norm(cross(one, other)).atan2(dot(one, other)) * unit).powi(2)
        };
        let pairs = (0..rows).flat_map(|i| (0..rows).map(move |k| (i, k)));
        let squares =
            pairs.flat_map(|(i, k)| (0..around).map(move |d| (i, k, d))).map(|(i, k, d)| square(i, k, d));
        Self { rows, around, squares: squares.collect() }
    }

    /// The squares of the distances of neurons of two rows, by the difference of their columns.
    pub(super) fn squares(&self, [i, k]: [usize; 2]) -> &[f64] {
        let first = (i * self.rows + k) * self.around;
        self.squares.get(first..first + self.around).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_are_counted_the_shorter_way() {
        assert_eq!(steps_between(true, 10, 1, 9), 2);
        assert_eq!(steps_between(false, 10, 1, 9), 8);
        assert_eq!(Topology::Torus.beside(0, 5, 0, -1), Some(4));
        assert_eq!(Topology::Cylinder.beside(0, 5, 0, -1), None);
        assert_eq!(Topology::Cylinder.beside(1, 5, 4, 1), Some(0));
    }

    #[test]
    fn distances_on_the_sphere_are_angles() {
        let sphere = Latitudes::new([9, 16]);
        let square =
            |[i, j]: [usize; 2], [k, l]: [usize; 2]| sphere.squares([i, k])[steps_between(true, 16, j, l)];
        // From the pole to the equator, along it, to the other side of it and to the other pole.
        assert_eq!(square([0, 3], [4, 9]), 16.0);
        assert!((square([4, 15], [4, 1]) - 4.0).abs() < 1e-12);
        assert!((square([4, 0], [4, 8]) - 64.0).abs() < 1e-12);
        assert_eq!(square([0, 0], [8, 5]), 64.0);
        let place = |[i, j]: [usize; 2]| {
            let (a, b) = (PI * i as f64 / 8.0, TAU * j as f64 / 16.0);
            [a.sin() * b.cos(), a.sin() * b.sin(), a.cos()]
        };
        for (a, b) in [([1, 2], [5, 13]), ([3, 0], [4, 7]), ([2, 2], [2, 2])] {
            let cosine: f64 = place(a).iter().zip(place(b)).map(|(x, y)| x * y).sum();
            let angle = cosine.min(1.0).acos() * 8.0 / PI;
            assert!((square(a, b).sqrt() - angle).abs() < 1e-7);
        }
    }
}
