//! A bicubic surface through a point by the outer knots of both spans.

use super::local::functions;
use super::outer::Outer;
use super::{KnotError, KnotSurface, Unreached};
use crate::geometry::point::check_points;
use crate::geometry::{Point, cross, dot, norm};

/// Values of one unknown for which the other three are solved.
const SCANNED: u32 = 41;
/// Steps of Newton's method.
const STEPS: usize = 12;

/// What an unknown does to the four functions of its direction.
const SHIFTS: [[f64; 4]; 2] = [[1.0, -1.0, 0.0, 0.0], [0.0, 0.0, -1.0, 1.0]];

struct Bicubic {
    functions: [[f64; 4]; 2],
    /// The sixteen control points, less the point wanted.
    net: [[Point<3>; 4]; 4],
}

impl Bicubic {
    fn shifted(&self, direction: usize, x: [f64; 4]) -> [f64; 4] {
        std::array::from_fn(|a| {
            let [first, second] = [0, 1].map(|s| x[2 * direction + s] * SHIFTS[s][a]);
            self.functions[direction][a] + first + second
        })
    }

    fn blended(&self, along: [f64; 4], across: [f64; 4]) -> Point<3> {
        let mut sum = [0.0; 3];
        for (row, a) in self.net.iter().zip(along) {
            for (point, b) in row.iter().zip(across) {
                sum = std::array::from_fn(|d| sum[d] + a * b * point[d]);
            }
        }
        sum
    }

    /// All unknowns where one is given, by Newton's method from zeros.
    fn solved(&self, given: usize, value: f64, size: f64) -> Option<[f64; 4]> {
        let mut x = [0.0; 4];
        x[given] = value;
        let free: Vec<usize> = (0..4).filter(|q| *q != given).collect();
        for _ in 0..STEPS {
            let [along, across] = [0, 1].map(|direction| self.shifted(direction, x));
            let off = self.blended(along, across);
            if norm(off) <= 1e-15 * size {
                break;
            }
            let columns: Vec<Point<3>> =
                free.iter()
                    .map(|&q| {
                        if q < 2 {
                            self.blended(SHIFTS[q], across)
                        } else {
                            self.blended(along, SHIFTS[q - 2])
                        }
                    })
                    .collect();
            let det = dot(columns[0], cross(columns[1], columns[2]));
            for (k, &q) in free.iter().enumerate() {
                let normal = cross(columns[(k + 1) % 3], columns[(k + 2) % 3]);
                x[q] -= dot(off, normal) / det;
            }
            if x.iter().any(|x| !x.is_finite()) {
                return None;
            }
        }
        let off = self.blended(self.shifted(0, x), self.shifted(1, x));
        (norm(off) <= 1e-12 * size).then_some(x)
    }
}

impl KnotSurface {
    /// The bicubic surface that runs through a point at `(u, v)`, by the two outer knots of either span; of the many
    /// solutions that with the smallest change of the functions that was found.
    ///
    /// # Errors
    /// [`KnotError::Unreached`]; [`KnotError::OrderNeeded`], [`KnotError::Rational`] or [`KnotError::Closed`] for other
    /// surfaces than open bicubic ones without weights; [`KnotError::Outside`].
    pub fn through_outer(&self, point: Point<3>, at: [f64; 2]) -> Result<Self, KnotError> {
        check_points(&[point])?;
        if self.weights().is_some() {
            return Err(KnotError::Rational);
        }
        let mut outers = Vec::new();
        let mut bicubic = Bicubic { functions: [[0.0; 4]; 2], net: [[[0.0; 3]; 4]; 4] };
        let mut first = [0; 2];
        for (direction, vector) in self.vectors().iter().enumerate() {
            if vector.order() != 4 {
                return Err(KnotError::OrderNeeded { given: vector.order(), least: 4, most: 4 });
            }
            if vector.breaks().is_some() {
                return Err(KnotError::Closed);
            }
            let (name, value) = (["u", "v"][direction], at[direction]);
            let outside = KnotError::Outside { name, value, range: vector.domain() };
            let span = vector.span_of(value).ok_or(outside)?;
            outers.push(Outer::new(vector, span, value)?);
            let values = functions(vector.knots(), 4, span, value).ok_or(outside)?;
            bicubic.functions[direction] = std::array::from_fn(|a| values[a]);
            first[direction] = span - 3;
        }
        let mut size = 0.0_f64;
        for (k, row) in bicubic.net.iter_mut().enumerate() {
            for (l, place) in row.iter_mut().enumerate() {
                let given = self.homogeneous([first[0] + k, first[1] + l]).p;
                *place = std::array::from_fn(|d| given[d] - point[d]);
                size = size.max(norm(*place));
            }
        }
        let ranges: Vec<[f64; 2]> = outers.iter().flat_map(Outer::ranges).collect();
        let mut best: Option<(f64, Self)> = None;
        for (given, [low, high]) in ranges.iter().enumerate() {
            for step in 0..SCANNED {
                let t = f64::from(step) / f64::from(SCANNED - 1);
                let Some(x) = bicubic.solved(given, (1.0 - t) * low + t * high, size) else { continue };
                let effort: f64 = x.iter().map(|x| x * x).sum();
                if best.as_ref().is_some_and(|(least, _)| *least <= effort) {
                    continue;
                }
                let moved = |d: usize| outers[d].moved(&self.vectors()[d], [x[2 * d], x[2 * d + 1]]);
                if let (Ok(u), Ok(v)) = (moved(0), moved(1)) {
                    best = Some((effort, Self::new([u, v], self.net().to_vec(), None)?));
                }
            }
        }
        best.map(|(_, surface)| surface).ok_or(Unreached::NotFound.into())
    }
}
