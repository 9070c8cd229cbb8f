//! Tridiagonal systems with ones beside the diagonal, as splines have them (2.30), factored once.

use super::Point;
use super::point::add_scaled;

/// The elimination (2.31) of `x[i-1] + diagonal[i] x[i] + x[i+1] = rhs[i]`. Every diagonal here is
/// at least 2 in size and rows are diagonally dominant, so pivots stay above 1 and no pivoting is needed.
#[derive(Clone, Debug)]
pub(super) struct Tridiagonal {
    /// Reciprocals of the pivots.
    q: Vec<f64>,
}

impl Tridiagonal {
    /// Factors the system with this diagonal.
    pub(super) fn new(diagonal: impl Iterator<Item = f64>) -> Self {
        let mut before = 0.0;
        let pivot = |d: f64| {
            before = 1.0 / (d - before);
            before
        };
        Self { q: diagonal.map(pivot).collect() }
    }

    /// Replaces right-hand sides by solutions, all coordinates at once.
    pub(super) fn solve<const D: usize>(&self, rhs: &mut [Point<D>]) {
        let mut before = [0.0; D];
        for (x, &q) in rhs.iter_mut().zip(&self.q) {
            *x = std::array::from_fn(|d| q * (x[d] - before[d]));
            before = *x;
        }
        let mut after = [0.0; D];
        for (x, &q) in rhs.iter_mut().zip(&self.q).rev() {
            *x = add_scaled(*x, -q, after);
            after = *x;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solution_satisfies_the_equations() {
        let diagonal = [2.0, 4.0, 4.0, 4.0, 2.0];
        let rhs = [[1.0], [-7.0], [3.0], [0.5], [2.0]];
        let mut x = rhs;
        Tridiagonal::new(diagonal.into_iter()).solve(&mut x);
        for i in 0..5 {
            let before = if i > 0 { x[i - 1][0] } else { 0.0 };
            let after = x.get(i + 1).map_or(0.0, |p| p[0]);
            assert!((before + diagonal[i] * x[i][0] + after - rhs[i][0]).abs() < 1e-14);
        }
    }
}
