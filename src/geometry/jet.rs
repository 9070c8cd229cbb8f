//! Numbers with their derivatives, so that a formula written once gives its derivatives too.

use std::ops::{Add, Div, Mul, Sub};

/// What formulas are written for: doubles, and [`Jet`]s of them.
pub(super) trait Number:
    Copy + From<f64> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
}

impl<T> Number for T where
    T: Copy + From<f64> + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T>
{
}

/// A function's value with its first and second derivative. The value is the very double of the formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jet(pub(super) [f64; 3]);

impl Jet {
    /// The parameter itself.
    pub(super) fn parameter(u: f64) -> Self {
        Self([u, 1.0, 0.0])
    }

    /// The same function run through from the other end: this is its jet at `1 - x`, by `1 - x`.
    pub(super) fn reversed(self) -> Self {
        let Self([value, first, second]) = self;
        Self([value, -first, second])
    }

    /// A power of a function that is not negative; `0^0 = 1`.
    pub(super) fn powf(self, exponent: f64) -> Self {
        let Self([u, u1, u2]) = self;
        // A factor 0 ends the terms: 0 times the infinite power of 0 beside it would be no number.
        let term =
            |factor: f64, less: f64| if factor == 0.0 { 0.0 } else { factor * u.powf(exponent - less) };
        let (slope, bend) = (term(exponent, 1.0), term(exponent * (exponent - 1.0), 2.0));
        Self([u.powf(exponent), slope * u1, bend * u1 * u1 + slope * u2])
    }
}

impl From<f64> for Jet {
    fn from(value: f64) -> Self {
        Self([value, 0.0, 0.0])
    }
}

impl Add for Jet {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|order| self.0[order] + other.0[order]))
    }
}

impl Sub for Jet {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|order| self.0[order] - other.0[order]))
    }
}

impl Mul for Jet {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (Self([a, a1, a2]), Self([b, b1, b2])) = (self, other);
        Self([a * b, a1 * b + a * b1, a2 * b + 2.0 * a1 * b1 + a * b2])
    }
}

impl Div for Jet {
    type Output = Self;

    /// From `q b = a`, derived twice.
    fn div(self, other: Self) -> Self {
        let (Self([a, a1, a2]), Self([b, b1, b2])) = (self, other);
        let q = a / b;
        let q1 = (a1 - q * b1) / b;
        Self([q, q1, (a2 - 2.0 * q1 * b1 - q * b2) / b])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_of_a_fraction() {
        fn formula<N: Number>(u: N) -> N {
            (u * u * u - N::from(2.0)) / (u + N::from(1.0))
        }
        let [value, first, second] = formula(Jet::parameter(0.5)).0;
        assert_eq!(value, formula(0.5));
        // (2 u^3 + 3 u^2 + 2) / (u + 1)^2, and 2 (u^3 + 3 u^2 + 3 u - 2) / (u + 1)^3.
        assert!((first - 3.0 / 2.25).abs() < 1e-15);
        assert!((second - 2.0 * 0.375 / 3.375).abs() < 1e-15);
    }
}
