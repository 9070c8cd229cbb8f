//! Numbers of twice a double's precision: unevaluated sums of two doubles, about 32 digits.
//!
//! After Dekker (1971) and Knuth. Products are split by Dekker's method and not by `mul_add`, which is a slow call
//! on processors that are not asked for it.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// `hi + lo` with `|lo|` at most half a unit in the last place of `hi`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Dd {
    hi: f64,
    lo: f64,
}

pub(super) const ZERO: Dd = Dd { hi: 0.0, lo: 0.0 };
pub(super) const ONE: Dd = Dd { hi: 1.0, lo: 0.0 };
const LN_2: Dd = Dd { hi: std::f64::consts::LN_2, lo: 2.319_046_813_846_299_6e-17 };
const HALF_PI: Dd = Dd { hi: std::f64::consts::FRAC_PI_2, lo: 6.123_233_995_736_766e-17 };

/// `a + b` and its rounding error.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// The same where `|a| >= |b|`.
fn quick(a: f64, b: f64) -> Dd {
    let hi = a + b;
    Dd { hi, lo: b - (hi - a) }
}

/// `a * b` and its rounding error.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

fn split(a: f64) -> (f64, f64) {
    let t = 134_217_729.0 * a;
    let hi = t - (t - a);
    (hi, a - hi)
}

impl Dd {
    /// `a - b` without rounding.
    pub(super) fn difference(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, -b);
        Self { hi, lo }
    }

    /// The nearest double.
    pub(super) fn value(self) -> f64 {
        self.hi + self.lo
    }

    pub(super) fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    pub(super) fn is_finite(self) -> bool {
        self.hi.is_finite() && self.lo.is_finite()
    }

    /// Times a power of two, exactly.
    fn scaled(self, factor: f64) -> Self {
        Self { hi: self.hi * factor, lo: self.lo * factor }
    }

    /// The whole number of `unit`s nearest to it, and the rest.
    fn reduced(self, unit: Self) -> (f64, Self) {
        let count = (self.hi / unit.hi).round();
        (count, self - unit * Self::from(count))
    }

    /// e to this power. Relative error about 1e-30; infinite beyond the range of doubles.
    pub(super) fn exp(self) -> Self {
        let (twos, rest) = self.reduced(LN_2);
        if !(-1000.0..=1000.0).contains(&twos) {
            return Self::from(self.hi.exp());
        }
        // e^r - 1 of a small r, squared nine times: (1 + p)² - 1 = 2p + p².
        let r = rest.scaled(1.0 / 512.0);
        let mut p = ZERO;
        for k in (1..=12).rev() {
            p = (p + ONE) * r / Self::from(f64::from(k));
        }
        for _ in 0..9 {
            p = p.scaled(2.0) + p * p;
        }
        (p + ONE).scaled(2.0_f64.powi(twos as i32))
    }

    /// Sine and cosine. Absolute error about 1e-31 times the larger of 1 and the argument.
    pub(super) fn sin_cos(self) -> (Self, Self) {
        let (quarters, r) = self.reduced(HALF_PI);
        let square = -(r * r);
        let (mut sin, mut cos) = (ZERO, ZERO);
        for k in (0..14_u8).rev() {
            let even = 2.0 * f64::from(k);
            cos = ONE + cos * square / Self::from((even + 1.0) * (even + 2.0));
            sin = ONE + sin * square / Self::from((even + 2.0) * (even + 3.0));
        }
        sin = sin * r;
        match quarters.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
}

impl From<f64> for Dd {
    fn from(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }
}

impl Add for Dd {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.hi, other.hi);
        let (t, f) = two_sum(self.lo, other.lo);
        let Self { hi, lo } = quick(s, e + t);
        quick(hi, lo + f)
    }
}

impl AddAssign for Dd {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Neg for Dd {
    type Output = Self;

    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for Dd {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dd {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (p, e) = two_product(self.hi, other.hi);
        quick(p, e + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Mul<f64> for Dd {
    type Output = Self;

    fn mul(self, other: f64) -> Self {
        let (p, e) = two_product(self.hi, other);
        quick(p, e + self.lo * other)
    }
}

impl Div for Dd {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other * first;
        let second = rest.hi / other.hi;
        let rest = rest - other * second;
        quick(first, second) + Self::from(rest.hi / other.hi)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A whole number of up to 105 bits as a sum of two doubles.
    fn whole(value: i128) -> Dd {
        let hi = value as f64;
        Dd { hi, lo: (value - hi as i128) as f64 }
    }

    fn back(value: Dd) -> i128 {
        value.hi as i128 + value.lo as i128
    }

    proptest! {
        #[test]
        fn whole_numbers_are_exact(a in -(1_i128 << 100)..1 << 100, b in -(1_i128 << 100)..1 << 100) {
            prop_assert_eq!(back(whole(a) + whole(b)), a + b);
            prop_assert_eq!(back(whole(a) - whole(b)), a - b);
            let (a, b) = (a >> 50, b >> 50);
            prop_assert_eq!(back(whole(a) * whole(b)), a * b);
            if b != 0 {
                prop_assert_eq!(back(whole(a * b) / whole(b)), a);
            }
        }

        #[test]
        fn exponentials_and_sines_keep_their_theorems(a in -20.0..20.0, b in -20.0..20.0) {
            let [x, y] = [a, b].map(Dd::from);
            let (product, sum) = (x.exp() * y.exp(), (x + y).exp());
            prop_assert!(((product - sum) / sum).abs().value() < 1e-28);
            let ((sx, cx), (sy, cy), (s, c)) = (x.sin_cos(), y.sin_cos(), (x + y).sin_cos());
            prop_assert!((sx * cy + cx * sy - s).abs().value() < 1e-29);
            prop_assert!((cx * cy - sx * sy - c).abs().value() < 1e-29);
            prop_assert!((sx * sx + cx * cx - ONE).abs().value() < 1e-30);
        }
    }

    #[test]
    fn digits_beyond_a_double() {
        // e, and the sine of 1, to 32 digits.
        let e = Dd::from(1.0).exp();
        assert_eq!((e.hi, e.lo), (std::f64::consts::E, 1.445_646_891_729_250_2e-16));
        let sin = Dd::from(1.0).sin_cos().0;
        assert_eq!(sin.hi, 0.841_470_984_807_896_5);
        assert!((sin - Dd { hi: 0.841_470_984_807_896_5, lo: 6.844_471_7e-18 }).abs().value() < 1e-17);
        assert_eq!(Dd::difference(1.0, 1e-30), Dd { hi: 1.0, lo: -1e-30 });
    }
}
