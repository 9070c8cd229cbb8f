//! The cyclic system `x[i-1] + d x[i] + x[i+1] = rhs[i]` of closed splines (2.39), where `d` is 4.

use super::Point;
use super::point::add_scaled;
use super::tridiagonal::Tridiagonal;

/// The cyclic system as a tridiagonal one plus a rank-one correction (Sherman-Morrison). The
/// book's elimination (2.40)-(2.46) divides by small numbers again and again; this one does not:
/// with the corner moved by `gamma` every row stays diagonally dominant.
#[derive(Clone, Debug)]
pub(super) struct Cyclic {
    base: Tridiagonal,
    /// Solution of the base system for the right-hand side `(gamma, 0, …, 0, 1)`.
    correction: Vec<[f64; 1]>,
    /// `1 + v . correction`.
    scale: f64,
    gamma: f64,
}

impl Cyclic {
    /// Factors the system of `n` unknowns with 4 in the diagonal, `n` at least 3.
    pub(super) fn new(n: usize) -> Self {
        Self::with_diagonal(n, 4.0)
    }

    /// Factors the system of `n` unknowns, `n` at least 3, with this diagonal, larger than 2 or smaller than -2.
    pub(super) fn with_diagonal(n: usize, d: f64) -> Self {
        let (last, gamma) = (n.saturating_sub(1), -d);
        let diagonal = |i| match i {
            0 => d - gamma,
            i if i == last => d - 1.0 / gamma,
            _ => d,
        };
        let base = Tridiagonal::new((0..n).map(diagonal));
        let column = |i| match i {
            0 => [gamma],
            i if i == last => [1.0],
            _ => [0.0],
        };
        let mut correction: Vec<[f64; 1]> = (0..n).map(column).collect();
        base.solve(&mut correction);
        let [dot] = corner_dot(&correction, gamma);
        Self { base, correction, scale: 1.0 + dot, gamma }
    }

    /// Replaces right-hand sides by solutions, all coordinates at once.
    pub(super) fn solve<const D: usize>(&self, rhs: &mut [Point<D>]) {
        self.base.solve(rhs);
        let factor = corner_dot(rhs, self.gamma).map(|x| x / self.scale);
        for (x, &[z]) in rhs.iter_mut().zip(&self.correction) {
            *x = add_scaled(*x, -z, factor);
        }
    }
}

/// `v . x` with `v = (1, 0, …, 0, 1 / gamma)`.
fn corner_dot<const D: usize>(x: &[Point<D>], gamma: f64) -> Point<D> {
    match (x.first(), x.last()) {
        (Some(&first), Some(&last)) => add_scaled(first, 1.0 / gamma, last),
        _ => [0.0; D],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solution_satisfies_the_cyclic_equations() {
        for n in [3, 4, 5, 8, 99, 1000] {
            let rhs: Vec<[f64; 2]> =
                (0..n).map(|i| [(i as f64 * 1.7).sin(), f64::from(u8::from(i == n / 2))]).collect();
            let mut x = rhs.clone();
            Cyclic::new(n).solve(&mut x);
            for i in 0..n {
                for d in 0..2 {
                    let left = x[(i + n - 1) % n][d] + 4.0 * x[i][d] + x[(i + 1) % n][d];
                    assert!((left - rhs[i][d]).abs() < 4e-16 * 8.0, "n = {n}, row {i}");
                }
            }
        }
    }
}
