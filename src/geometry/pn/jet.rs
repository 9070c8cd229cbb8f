//! Numbers with their derivatives by two parameters.

use std::ops::{Add, Div, Mul, Sub};

/// A function of u and v: value, derivatives by u, v, uu, uv, vv.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jet2(pub(super) [f64; 6]);

impl From<f64> for Jet2 {
    fn from(value: f64) -> Self {
        Self([value, 0.0, 0.0, 0.0, 0.0, 0.0])
    }
}

impl Add for Jet2 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for Jet2 {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl Mul for Jet2 {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let ([a, au, av, auu, auv, avv], [b, bu, bv, buu, buv, bvv]) = (self.0, other.0);
        Self([
            a * b,
            au * b + a * bu,
            av * b + a * bv,
            auu * b + 2.0 * au * bu + a * buu,
            auv * b + au * bv + av * bu + a * buv,
            avv * b + 2.0 * av * bv + a * bvv,
        ])
    }
}

impl Div for Jet2 {
    type Output = Self;

    /// By the product rule for the quotient times the divisor.
    fn div(self, other: Self) -> Self {
        let ([a, au, av, auu, auv, avv], [b, bu, bv, buu, buv, bvv]) = (self.0, other.0);
        let q = a / b;
        let (qu, qv) = ((au - q * bu) / b, (av - q * bv) / b);
        Self([
            q,
            qu,
            qv,
            (auu - 2.0 * qu * bu - q * buu) / b,
            (auv - qu * bv - qv * bu - q * buv) / b,
            (avv - 2.0 * qv * bv - q * bvv) / b,
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotient_agrees_with_differences() {
        let (u, v) = (0.4, -0.7);
        let formula = |u: f64, v: f64| (u * v + 2.0) / (u * u - 3.0 * v);
        let jets = |u: f64, v: f64| {
            let (ju, jv) = (Jet2([u, 1.0, 0.0, 0.0, 0.0, 0.0]), Jet2([v, 0.0, 1.0, 0.0, 0.0, 0.0]));
            (ju * jv + 2.0.into()) / (ju * ju - Jet2::from(3.0) * jv)
        };
        let h = 1e-4;
        let f = |i: i32, j: i32| formula(u + h * f64::from(i), v + h * f64::from(j));
        let expected = [
            f(0, 0),
            (f(1, 0) - f(-1, 0)) / (2.0 * h),
            (f(0, 1) - f(0, -1)) / (2.0 * h),
            (f(1, 0) - 2.0 * f(0, 0) + f(-1, 0)) / (h * h),
            (f(1, 1) - f(1, -1) - f(-1, 1) + f(-1, -1)) / (4.0 * h * h),
            (f(0, 1) - 2.0 * f(0, 0) + f(0, -1)) / (h * h),
        ];
        assert_eq!(jets(u, v).0[0], formula(u, v));
        assert!(jets(u, v).0.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6));
    }
}
