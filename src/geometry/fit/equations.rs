//! The normal equations of the least squares fit, gathered cell by cell.
//!
//! A point counts for the 16 control points of its cell by products `N_a(u) N_b(v)`. The 256 products of two of them are
//! 10 products in `u` times 10 in `v`, so a cell is a table of 100 sums and 48 of the right side.

use super::axis::{Axis, ORDER};
use crate::geometry::Point;

/// Pairs of functions of a span.
const PAIRS: usize = 10;
/// Numbers of a cell: products of pairs, then the right side by coordinate.
const CELL: usize = PAIRS * PAIRS + 3 * ORDER * ORDER;
/// How far, in rows or columns, control points have common points.
pub(super) const REACH: usize = ORDER - 1;
/// Neighbours of a control point in a direction, itself among them.
pub(super) const AROUND: usize = 2 * REACH + 1;
/// The weight of the second differences of the net, by point: it keeps cells without points determinate.
const SMOOTHNESS: f64 = 1e-6;
/// What keeps control points where they are if neither points nor smoothness say anything, as part of the largest
/// diagonal entry: clouds in one place leave much open.
const INERTIA: f64 = 1e-12;

/// Sums over points.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    cells: Vec<[f64; CELL]>,
    points: usize,
}

/// A symmetric matrix that joins every control point with those up to three rows and columns away, and right sides.
#[derive(Clone, Debug)]
pub(super) struct Equations {
    /// By control point: row by row of neighbours.
    pub(super) matrix: Vec<[f64; AROUND * AROUND]>,
    /// How far the control points are from a solution.
    pub(super) right: Vec<Point<3>>,
    /// How large the right side was before, by which that is measured.
    pub(super) size: f64,
}

/// The number of a pair.
const fn pair(a: usize, b: usize) -> usize {
    let (a, b) = if a < b { (a, b) } else { (b, a) };
    a * (2 * ORDER + 1 - a) / 2 + b - a
}

/// The products of all pairs.
#[inline]
fn products(values: &[f64; ORDER]) -> [f64; PAIRS] {
    let [a, b, c, d] = *values;
    [a * a, a * b, a * c, a * d, b * b, b * c, b * d, c * c, c * d, d * d]
}

impl Sums {
    pub(super) fn new(axes: &[Axis; 2]) -> Self {
        Self { cells: vec![[0.0; CELL]; axes[0].spans() * axes[1].spans()], points: 0 }
    }

    /// Begins anew.
    pub(super) fn clear(&mut self) {
        self.cells.fill([0.0; CELL]);
        self.points = 0;
    }

    /// Adds a point at its parameters.
    #[inline]
    pub(super) fn add(&mut self, axes: &[Axis; 2], [u, v]: [f64; 2], point: Point<3>) {
        let ((i, s), (j, t)) = (axes[0].place(u), axes[1].place(v));
        let Some(cell) = self.cells.get_mut(i * axes[1].spans() + j) else { return };
        let (nu, nv) = (axes[0].values(i, s), axes[1].values(j, t));
        let (along, across) = (products(&nu), products(&nv));
        let (squares, right) = cell.split_at_mut(PAIRS * PAIRS);
        for (row, factor) in squares.as_chunks_mut::<PAIRS>().0.iter_mut().zip(along) {
            for (sum, other) in row.iter_mut().zip(across) {
                *sum += factor * other;
            }
        }
        for (sums, x) in right.as_chunks_mut::<{ ORDER * ORDER }>().0.iter_mut().zip(point) {
            for (row, a) in sums.as_chunks_mut::<ORDER>().0.iter_mut().zip(nu) {
                let factor = a * x;
                for (sum, b) in row.iter_mut().zip(nv) {
                    *sum += factor * b;
                }
            }
        }
        self.points += 1;
    }

    /// The equations for how far the control points have to move from where they are.
    pub(super) fn equations(&self, axes: &[Axis; 2], nodes: &[Point<3>]) -> Equations {
        let [m, n] = [axes[0].count(), axes[1].count()];
        let (matrix, right) = (vec![[0.0; AROUND * AROUND]; m * n], vec![[0.0; 3]; m * n]);
        let mut equations = Equations { matrix, right, size: 0.0 };
        for (number, cell) in self.cells.iter().enumerate() {
            equations.scatter(axes, [number / axes[1].spans(), number % axes[1].spans()], cell);
        }
        equations.size = equations.right.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
        let weight = SMOOTHNESS * self.points as f64;
        (0..2).for_each(|direction| equations.smooth(axes, direction, weight));
        let now = equations.times(axes, nodes);
        for (right, now) in equations.right.iter_mut().zip(now) {
            *right = std::array::from_fn(|d| right[d] - now[d]);
        }
        let centre = AROUND * REACH + REACH;
        let largest = equations.matrix.iter().map(|row| row[centre]).fold(0.0, f64::max);
        equations.matrix.iter_mut().for_each(|row| row[centre] += INERTIA * largest);
        equations
    }
}

impl Equations {
    fn scatter(&mut self, axes: &[Axis; 2], [i, j]: [usize; 2], cell: &[f64; CELL]) {
        let (rows, columns) = (axes[0].width(), axes[1].width());
        for a in 0..rows {
            for b in 0..columns {
                let node = axes[0].node(i + a) * axes[1].count() + axes[1].node(j + b);
                let (Some(row), Some(right)) = (self.matrix.get_mut(node), self.right.get_mut(node)) else {
                    continue;
                };
                for c in 0..rows {
                    for d in 0..columns {
                        let place = (c + REACH - a) * AROUND + d + REACH - b;
                        row[place] += cell[pair(a, c) * PAIRS + pair(b, d)];
                    }
                }
                for (axis, sum) in right.iter_mut().enumerate() {
                    *sum += cell[PAIRS * PAIRS + (axis * ORDER + a) * ORDER + b];
                }
            }
        }
    }

    /// Adds the squares of the second differences along a direction.
    fn smooth(&mut self, axes: &[Axis; 2], direction: usize, weight: f64) {
        let columns = axes[1].count();
        let factors = [1.0, -2.0, 1.0];
        let stride = if direction == 0 { AROUND } else { 1 };
        for node in 0..self.matrix.len() {
            let place = [node / columns, node % columns];
            let axis = &axes[direction];
            let beside = |step: isize| {
                let mut other = place;
                other[direction] = axis.beside(place[direction], step)?;
                Some(other[0] * columns + other[1])
            };
            let (Some(before), Some(after)) = (beside(-1), beside(1)) else { continue };
            if axis.is_point() {
                continue;
            }
            for (a, at) in [before, node, after].into_iter().enumerate() {
                let Some(row) = self.matrix.get_mut(at) else { continue };
                for (b, factor) in factors.iter().enumerate() {
                    let centre = AROUND * REACH + REACH;
                    row[centre + b * stride - a * stride] += weight * factors[a] * factor;
                }
            }
        }
    }

    /// The matrix times vectors, one a coordinate.
    pub(super) fn times(&self, axes: &[Axis; 2], vectors: &[Point<3>]) -> Vec<Point<3>> {
        let (mut room, mut product) = (Vec::new(), Vec::new());
        self.times_into(axes, vectors, &mut room, &mut product);
        product
    }

    /// The same into a vector, with room for the vectors going on beyond borders and seams.
    pub(super) fn times_into(
        &self,
        axes: &[Axis; 2],
        vectors: &[Point<3>],
        room: &mut Vec<[f64; 4]>,
        product: &mut Vec<Point<3>>,
    ) {
        let [m, n] = [axes[0].count(), axes[1].count()];
        let stride = n + 2 * REACH;
        room.clear();
        for e in 0..m + 2 * REACH {
            // Nothing is beyond a border, and its factors are 0.
            let row = axes[0].beside(0, e as isize - REACH as isize);
            for f in 0..stride {
                let column = axes[1].beside(0, f as isize - REACH as isize);
                let node = row.zip(column).and_then(|(i, j)| vectors.get(i * n + j));
                room.push(node.map_or([0.0; 4], |&[x, y, z]| [x, y, z, 0.0]));
            }
        }
        product.clear();
        for (node, factors) in self.matrix.iter().enumerate() {
            let (i, j) = (node / n, node % n);
            let mut sum = [0.0; 4];
            for (a, factors) in factors.as_chunks::<AROUND>().0.iter().enumerate() {
                let first = (i + a) * stride + j;
                let Some(row) = room.get(first..first + AROUND) else { continue };
                for (factor, point) in factors.iter().zip(row) {
                    for d in 0..4 {
                        sum[d] += factor * point[d];
                    }
                }
            }
            product.push([sum[0], sum[1], sum[2]]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_counted_in_the_order_of_their_products() {
        let values = [2.0, 3.0, 5.0, 7.0];
        let products = products(&values);
        for a in 0..ORDER {
            for b in 0..ORDER {
                assert_eq!(products[pair(a, b)], values[a] * values[b]);
            }
        }
    }
}
