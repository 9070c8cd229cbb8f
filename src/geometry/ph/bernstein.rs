//! Polynomials on [0, 1] by their Bernstein coefficients.
//!
//! A polynomial of degree `n` is the slice of its `n + 1` coefficients `c_0 … c_n`: it is the sum of
//! `C(n, k) (1 - u)^(n - k) u^k c_k`. An empty slice is zero.

use super::complex::Complex;
use std::ops::{Add, Mul, Sub};

/// What coefficients can do: real numbers, and vectors of the plane.
pub(super) trait Coefficient:
    Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self>
{
}

impl Coefficient for f64 {}
impl Coefficient for Complex {}

/// The binomial coefficient C(n, k), exact for the small degrees here.
pub(super) fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

/// Rows of binomial coefficients up to this degree are kept ready for [`product`].
const ROWS: usize = 15;

/// Pascal's triangle.
const PASCAL: [[f64; ROWS]; ROWS] = {
    let mut rows = [[0.0; ROWS]; ROWS];
    let mut n = 0;
    while n < ROWS {
        rows[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            rows[n][k] = rows[n - 1][k - 1] + rows[n - 1][k];
            k += 1;
        }
        n += 1;
    }
    rows
};

/// C(n, k) from the table, or computed.
fn choose(n: usize, k: usize) -> f64 {
    PASCAL.get(n).and_then(|row| row.get(k)).copied().unwrap_or_else(|| binomial(n, k))
}

/// The product of two polynomials: `(ab)_k` is the sum of `C(m, j) C(n, k - j) / C(m + n, k) a_j b_(k-j)`.
pub(super) fn product<A, B>(a: &[A], b: &[B]) -> Vec<<A as Mul<B>>::Output>
where
    A: Copy + Mul<B>,
    B: Copy,
    <A as Mul<B>>::Output: Coefficient,
{
    if a.is_empty() || b.is_empty() {
        return Vec::new();
    }
    let (m, n) = (a.len() - 1, b.len() - 1);
    let mut sums = vec![<A as Mul<B>>::Output::default(); m + n + 1];
    for (j, &x) in a.iter().enumerate() {
        for (i, &y) in b.iter().enumerate() {
            sums[i + j] = sums[i + j] + x * y * (choose(m, j) * choose(n, i));
        }
    }
    for (k, sum) in sums.iter_mut().enumerate() {
        *sum = *sum * (1.0 / choose(m + n, k));
    }
    sums
}

/// The same polynomial with `by` more coefficients.
pub(super) fn elevated<T: Coefficient>(c: &[T], by: usize) -> Vec<T>
where
    f64: Mul<T, Output = T>,
{
    product(&vec![1.0; by + 1], c)
}

/// The derivative: `n (c_(k+1) - c_k)`.
pub(super) fn derivative<T: Coefficient>(c: &[T]) -> Vec<T> {
    let degree = c.len().saturating_sub(1) as f64;
    c.windows(2).map(|pair| (pair[1] - pair[0]) * degree).collect()
}

/// The antiderivative that is `start` at 0: `S_(k+1) = S_k + c_k / (n + 1)`.
pub(super) fn antiderivative<T: Coefficient>(start: T, c: &[T]) -> Vec<T> {
    let share = 1.0 / c.len().max(1) as f64;
    let mut sum = start;
    let after = c.iter().map(|&value| {
        sum = sum + value * share;
        sum
    });
    std::iter::once(start).chain(after).collect()
}

/// The value at `u` in [0, 1], exactly the end coefficients at 0 and 1: Horner's scheme in `u / (1 - u)`.
pub(super) fn eval<T: Coefficient>(c: &[T], u: f64) -> T {
    let Some((&last, rest)) = c.split_last() else { return T::default() };
    let (mut sum, mut power) = (T::default(), 1.0);
    if let Some(row) = PASCAL.get(rest.len()) {
        for (&value, factor) in rest.iter().zip(row) {
            sum = (sum + value * (power * factor)) * (1.0 - u);
            power *= u;
        }
    } else {
        for (k, &value) in rest.iter().enumerate() {
            sum = (sum + value * (power * binomial(rest.len(), k))) * (1.0 - u);
            power *= u;
        }
    }
    sum + last * power
}

/// The coefficients of the two parts before and after `u`, each again on [0, 1] (de Casteljau).
pub(super) fn split<T: Coefficient>(c: &[T], u: f64) -> [Vec<T>; 2] {
    let mut right = c.to_vec();
    let mut left = Vec::with_capacity(c.len());
    for finished in 0..c.len() {
        left.extend(right.first());
        for i in 1..c.len() - finished {
            right[i - 1] = right[i - 1] * (1.0 - u) + right[i] * u;
        }
    }
    [left, right]
}

/// The largest absolute value of real coefficients, a bound of the polynomial.
pub(super) fn size(c: &[f64]) -> f64 {
    c.iter().fold(0.0, |most, value| most.max(value.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The definition, term by term.
    fn defined(c: &[f64], u: f64) -> f64 {
        let n = c.len() - 1;
        let term =
            |(k, c): (usize, &f64)| binomial(n, k) * (1.0 - u).powi((n - k) as i32) * u.powi(k as i32) * c;
        c.iter().enumerate().map(term).sum()
    }

    fn coefficients() -> impl Strategy<Value = Vec<f64>> {
        proptest::collection::vec(-5.0..5.0, 1..11)
    }

    proptest! {
        #[test]
        fn operations_agree_with_the_definition(a in coefficients(), b in coefficients(), u in 0.0..1.0) {
            let (at, other) = (defined(&a, u), defined(&b, u));
            prop_assert!((eval(&a, u) - at).abs() < 1e-13);
            prop_assert!((eval(&product(&a, &b), u) - at * other).abs() < 1e-12);
            prop_assert!((eval(&elevated(&a, 4), u) - at).abs() < 1e-13);
            let [left, right] = split(&a, u);
            prop_assert!((eval(&left, 0.3) - defined(&a, 0.3 * u)).abs() < 1e-13);
            prop_assert!((eval(&right, 0.3) - defined(&a, u + 0.3 * (1.0 - u))).abs() < 1e-13);
            let back = derivative(&antiderivative(7.0, &a));
            prop_assert!(back.iter().zip(&a).all(|(x, y)| (x - y).abs() < 1e-12));
            prop_assert_eq!((eval(&a, 0.0), eval(&a, 1.0)), (a[0], a[a.len() - 1]));
        }
    }

    #[test]
    fn derivative_agrees_with_a_difference() {
        let c = [1.0, -3.0, 2.0, 5.0, 0.5];
        let slope = (defined(&c, 0.4 + 1e-5) - defined(&c, 0.4 - 1e-5)) / 2e-5;
        assert!((eval(&derivative(&c), 0.4) - slope).abs() < 1e-8);
        assert!(derivative(&c[..1]).is_empty());
        assert_eq!(eval::<f64>(&[], 0.5), 0.0);
        assert!(product::<f64, f64>(&[], &c).is_empty());
    }

    #[test]
    fn binomials_beyond_the_table() {
        assert_eq!(choose(14, 7), 3432.0);
        assert_eq!(choose(20, 10), 184_756.0);
    }
}
