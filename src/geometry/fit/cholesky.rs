//! Banded Cholesky, row by row, for open nets.

use super::axis::Axis;
use super::equations::{AROUND, Equations, REACH};
use crate::geometry::Point;

/// The decomposition of the matrix as far as it has come, and the solution.
#[derive(Clone, Debug)]
pub(super) struct Cholesky {
    /// Rows and columns of the net; rows are counted along the longer direction, which makes the band small.
    size: [usize; 2],
    turned: bool,
    band: usize,
    /// Row by row: the entries of the band up to the diagonal.
    rows: Vec<f64>,
    right: Vec<Point<3>>,
    next: usize,
}

/// The sum of products in four lanes, which vectors need and one order of additions would forbid.
#[inline]
fn product(a: &[f64], b: &[f64]) -> f64 {
    let ((a, last_a), (b, last_b)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut lanes = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        for k in 0..4 {
            lanes[k] += a[k] * b[k];
        }
    }
    let rest: f64 = last_a.iter().zip(last_b).map(|(a, b)| a * b).sum();
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]) + rest
}

impl Cholesky {
    pub(super) fn new(axes: &[Axis; 2], equations: &Equations) -> Self {
        let size = [axes[0].count(), axes[1].count()];
        let [m, n] = size;
        let turned = m < n;
        let band = REACH * m.min(n) + REACH;
        let width = band + 1;
        let mut rows = vec![0.0; m * n * width];
        let mut right = vec![[0.0; 3]; m * n];
        let index = |i: usize, j: usize| if turned { j * m + i } else { i * n + j };
        for (node, (factors, side)) in equations.matrix.iter().zip(&equations.right).enumerate() {
            let (i, j) = (node / n, node % n);
            let row = index(i, j);
            right[row] = *side;
            for (place, factor) in factors.iter().enumerate() {
                let (k, l) = (i + place / AROUND, j + place % AROUND);
                let (Some(k), Some(l)) = (k.checked_sub(REACH), l.checked_sub(REACH)) else { continue };
                if k >= m || l >= n {
                    continue;
                }
                let column = index(k, l);
                if column <= row
                    && let Some(entry) = rows.get_mut(row * width + column + band - row)
                {
                    *entry = *factor;
                }
            }
        }
        Self { size, turned, band, rows, right, next: 0 }
    }

    /// What a row costs, in points that are gathered.
    pub(super) fn cost(&self) -> usize {
        1 + self.band * self.band / 1024
    }

    /// Decomposes one row more; the solution after the last.
    pub(super) fn advance(&mut self) -> Option<Vec<Point<3>>> {
        let (row, band, width) = (self.next, self.band, self.band + 1);
        if row < self.right.len() {
            let first = row.saturating_sub(band);
            let (above, this) = self.rows.split_at_mut(row * width);
            for column in first..row {
                let other = &above[column * width..(column + 1) * width];
                // From the first column that both rows have.
                let from = first.max(column.saturating_sub(band));
                let (a, b) = (from + band - row, from + band - column);
                let count = column - from;
                let entry = column + band - row;
                let sum = this[entry] - product(&this[a..a + count], &other[b..b + count]);
                this[entry] = sum / other[band];
            }
            let own = &this[first + band - row..band];
            let pivot = this[band] - product(own, own);
            // Where rounding leaves nothing of a pivot, the control point stays.
            this[band] = if pivot > 1e-15 * this[band] { pivot.sqrt() } else { 1e100 };
            self.next += 1;
            return None;
        }
        Some(self.solution())
    }

    fn solution(&mut self) -> Vec<Point<3>> {
        let (band, width, count) = (self.band, self.band + 1, self.right.len());
        let x = &mut self.right;
        for row in 0..count {
            let entries = &self.rows[row * width..(row + 1) * width];
            let first = row.saturating_sub(band);
            let mut sum = x[row];
            for (entry, known) in entries[first + band - row..band].iter().zip(&x[first..row]) {
                sum = std::array::from_fn(|d| sum[d] - entry * known[d]);
            }
            x[row] = sum.map(|sum| sum / entries[band]);
        }
        for row in (0..count).rev() {
            let entries = &self.rows[row * width..(row + 1) * width];
            let first = row.saturating_sub(band);
            let value = x[row].map(|sum| sum / entries[band]);
            x[row] = value;
            for (entry, known) in entries[first + band - row..band].iter().zip(&mut x[first..row]) {
                *known = std::array::from_fn(|d| known[d] - entry * value[d]);
            }
        }
        let [m, n] = self.size;
        let index = |node: usize| if self.turned { node % n * m + node / n } else { node };
        (0..count).map(|node| x[index(node)]).collect()
    }
}
