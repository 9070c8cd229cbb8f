//! The neurons of a net and their places in space.

use super::{KohonenError, MAX_NEURONS, MAX_SIDE, Topology};
use crate::geometry::cloud::Cloud;
use crate::geometry::point::check_points;
use crate::geometry::{Dice, GeometryError, Point};

/// Neurons that are moved at once: two vectors of two doubles, which every machine has.
pub(super) const LANES: usize = 4;
/// Where there is no neuron: nothing is nearer to it than to a neuron, and its distance squared is no NaN.
const NOWHERE: f64 = 1e160;
/// The start is this part of the cloud's deviation wide to either side of its centre.
const START: f64 = 0.05;

/// A net of `m x n` neurons in space; row `i` counts first, column `j` second.
///
/// A net of one row or one column is a polygon. The neurons of a pole of a sphere are always in the same place.
#[derive(Clone, Debug, PartialEq)]
pub struct Net {
    size: [usize; 2],
    topology: Topology,
    /// Columns that a row has room for, a multiple of [`LANES`].
    stride: usize,
    /// The coordinates, row by row.
    at: [Vec<f64>; 3],
}

/// Room for the search for the nearest neuron, which is done millions of times.
#[derive(Clone, Debug, Default)]
pub(in crate::geometry) struct Search {
    distances: Vec<f64>,
    rows: Vec<f64>,
}

impl Net {
    /// The net of given places. The neurons of a sphere's pole come to their mean.
    ///
    /// # Errors
    /// A wrong size, rows of different lengths, a bad coordinate.
    pub fn new(topology: Topology, rows: &[Vec<Point<3>>]) -> Result<Self, KohonenError> {
        let columns = rows.first().map_or(0, Vec::len);
        let mut net = Self::empty(topology, [rows.len(), columns])?;
        for (i, row) in rows.iter().enumerate() {
            if row.len() != columns {
                return Err(GeometryError::Ragged { row: i, given: row.len(), needed: columns }.into());
            }
            check_points(row)?;
            row.iter().enumerate().for_each(|(j, point)| net.set([i, j], *point));
        }
        net.join_poles();
        Ok(net)
    }

    /// The start of learning: every neuron at random within 5 % of the cloud's standard deviation from its centre.
    ///
    /// # Errors
    /// A wrong size.
    pub fn random(
        cloud: &Cloud,
        size: [usize; 2],
        topology: Topology,
        seed: u64,
    ) -> Result<Self, KohonenError> {
        let mut net = Self::empty(topology, size)?;
        let mut dice = Dice::new(seed);
        let (centre, deviation) = (cloud.centre(), cloud.deviation());
        for i in 0..size[0] {
            for j in 0..size[1] {
                let place = std::array::from_fn(|d| centre[d] + START * deviation[d] * dice.signed());
                net.set([i, j], place);
            }
        }
        net.join_poles();
        Ok(net)
    }

    fn empty(topology: Topology, size: [usize; 2]) -> Result<Self, KohonenError> {
        let least = if topology == Topology::Sphere { [3, 1] } else { [1, 1] };
        let [rows, columns] = size;
        let possible = (0..2).all(|d| (least[d]..=MAX_SIDE).contains(&size[d]));
        if !possible || rows * columns > MAX_NEURONS {
            return Err(KohonenError::Size { given: size, least });
        }
        let stride = columns.div_ceil(LANES) * LANES;
        Ok(Self { size, topology, stride, at: std::array::from_fn(|_| vec![NOWHERE; rows * stride]) })
    }

    /// Brings the neurons of each pole together.
    fn join_poles(&mut self) {
        if self.topology != Topology::Sphere {
            return;
        }
        let [rows, columns] = self.size;
        for i in [0, rows - 1] {
            let share = 1.0 / columns as f64;
            let mean = (0..columns).fold([0.0; 3], |sum, j| {
                let point = self.point([i, j]);
                std::array::from_fn(|d| sum[d] + share * point[d])
            });
            (0..columns).for_each(|j| self.set([i, j], mean));
        }
    }

    /// Rows and columns.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// How rows and columns are joined.
    #[must_use]
    pub fn topology(&self) -> Topology {
        self.topology
    }

    /// Whether the net has one row or one column.
    #[must_use]
    pub fn is_polygon(&self) -> bool {
        self.size.contains(&1)
    }

    /// Where a neuron is; indices beyond the last row or column are those of the last.
    #[must_use]
    pub fn point(&self, [i, j]: [usize; 2]) -> Point<3> {
        let index = i.min(self.size[0] - 1) * self.stride + j.min(self.size[1] - 1);
        self.at.each_ref().map(|at| at.get(index).copied().unwrap_or(0.0))
    }

    fn set(&mut self, [i, j]: [usize; 2], point: Point<3>) {
        let index = i * self.stride + j;
        for (at, x) in self.at.iter_mut().zip(point) {
            if let Some(place) = at.get_mut(index) {
                *place = x;
            }
        }
    }

    /// The places of all neurons, row by row.
    #[must_use]
    pub fn rows(&self) -> Vec<Vec<Point<3>>> {
        let [rows, columns] = self.size;
        (0..rows).map(|i| (0..columns).map(|j| self.point([i, j])).collect()).collect()
    }

    /// The lines to draw: every row, then every column, closed ones with their first neuron again at the end. A polygon
    /// is one line.
    #[must_use]
    pub fn lines(&self) -> Vec<Vec<Point<3>>> {
        let line = |direction: usize, index: usize| -> Vec<Point<3>> {
            let place = |k: usize| if direction == 1 { [index, k] } else { [k, index] };
            let count = self.size[direction];
            let back = (self.topology.closed()[direction] && count > 2).then_some(0);
            (0..count).chain(back).map(|k| self.point(place(k))).collect()
        };
        let all = |direction: usize| (0..self.size[1 - direction]).map(move |index| line(direction, index));
        all(1).chain(all(0)).filter(|line| line.len() > 1).collect()
    }

    /// The neuron nearest to a point, the first of several, and the square of its distance.
    #[must_use]
    pub fn nearest(&self, point: Point<3>) -> ([usize; 2], f64) {
        self.search(point, &mut Search::default())
    }

    /// As [`Net::nearest`]: all distances, the least of every row, the row, the place in it.
    pub(in crate::geometry) fn search(&self, point: Point<3>, room: &mut Search) -> ([usize; 2], f64) {
        room.distances.resize(self.at[0].len(), 0.0);
        room.rows.clear();
        let [x, y, z] = self.at.each_ref().map(|at| at.chunks_exact(self.stride));
        for (((x, y), z), distances) in x.zip(y).zip(z).zip(room.distances.chunks_exact_mut(self.stride)) {
            let mut least = [f64::INFINITY; LANES];
            let [x, y, z] = [x, y, z].map(|row| row.as_chunks::<LANES>().0);
            for (((x, y), z), distances) in x.iter().zip(y).zip(z).zip(distances.as_chunks_mut::<LANES>().0) {
                let mut squares = [0.0; LANES];
                for k in 0..LANES {
                    let a = x[k] - point[0];
                    squares[k] = a * a;
                }
                for k in 0..LANES {
                    let a = y[k] - point[1];
                    squares[k] += a * a;
                }
                for k in 0..LANES {
                    let a = z[k] - point[2];
                    squares[k] += a * a;
                }
                *distances = squares;
                for k in 0..LANES {
                    least[k] = if squares[k] < least[k] { squares[k] } else { least[k] };
                }
            }
            room.rows.push(least.into_iter().fold(f64::INFINITY, f64::min));
        }
        let (mut row, mut least) = (0, f64::INFINITY);
        for (i, &square) in room.rows.iter().enumerate() {
            if square < least {
                (row, least) = (i, square);
            }
        }
        let distances = room.distances.iter().skip(row * self.stride).take(self.size[1]);
        let column = distances.clone().position(|square| *square == least).unwrap_or(0);
        ([row, column], least)
    }

    /// Moves the neurons of a row towards a point by these factors, one for each place of a row with its room, all times
    /// `share`.
    #[inline]
    pub(super) fn pull(&mut self, row: usize, (share, factors): (f64, &[f64]), point: Point<3>) {
        let range = row * self.stride..(row + 1) * self.stride;
        let [x, y, z] = self.at.each_mut().map(|at| at.get_mut(range.clone()).unwrap_or_default());
        let [x, y, z] = [x, y, z].map(|row| row.as_chunks_mut::<LANES>().0.iter_mut());
        for (((x, y), z), factors) in x.zip(y).zip(z).zip(factors.as_chunks::<LANES>().0) {
            let h = factors.map(|factor| share * factor);
            for k in 0..LANES {
                x[k] += h[k] * (point[0] - x[k]);
            }
            for k in 0..LANES {
                y[k] += h[k] * (point[1] - y[k]);
            }
            for k in 0..LANES {
                z[k] += h[k] * (point[2] - z[k]);
            }
        }
    }

    /// Columns that a row has room for.
    pub(super) fn stride(&self) -> usize {
        self.stride
    }

    /// The mean distance of the neurons from where those of another net of this size are.
    pub(super) fn mean_distance(&self, other: &Self) -> f64 {
        let [rows, columns] = self.size;
        let places = (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j]));
        let sum: f64 = places
            .map(|place| {
                let (a, b) = (self.point(place), other.point(place));
                crate::geometry::norm::<3>(std::array::from_fn(|d| a[d] - b[d]))
            })
            .sum();
        sum / (rows * columns) as f64
    }
}
