//! Complex numbers: vectors of the plane that can be multiplied.

use crate::geometry::Point;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The number `re + i im`; as a vector, `[re, im]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Complex {
    pub(super) re: f64,
    pub(super) im: f64,
}

impl Complex {
    pub(super) const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// The number `e^(i angle)`.
    pub(super) fn unit(angle: f64) -> Self {
        Self::new(angle.cos(), angle.sin())
    }

    pub(super) fn point(self) -> Point<2> {
        [self.re, self.im]
    }

    pub(super) fn conj(self) -> Self {
        Self::new(self.re, -self.im)
    }

    /// The vector turned by a quarter to the left, `i z`.
    pub(super) fn left(self) -> Self {
        Self::new(-self.im, self.re)
    }

    pub(super) fn norm(self) -> f64 {
        self.re.hypot(self.im)
    }

    pub(super) fn norm_squared(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    /// The scalar product of two vectors, `Re(a conj(b))`.
    pub(super) fn dot(self, other: Self) -> f64 {
        self.re * other.re + self.im * other.im
    }

    /// The vector product of two vectors, `Im(conj(a) b)`.
    pub(super) fn cross(self, other: Self) -> f64 {
        self.re * other.im - self.im * other.re
    }

    /// The angle from this vector to another, in (-pi, pi].
    pub(super) fn angle_to(self, other: Self) -> f64 {
        self.cross(other).atan2(self.dot(other))
    }

    /// The principal square root: its real part is not negative.
    pub(super) fn sqrt(self) -> Self {
        let length = self.norm();
        if length == 0.0 {
            return Self::default();
        }
        let large = (0.5 * (length + self.re.abs())).sqrt();
        let small = 0.5 * self.im.abs() / large;
        let (re, im) = if self.re >= 0.0 { (large, small) } else { (small, large) };
        Self::new(re, im.copysign(self.im))
    }

    pub(super) fn is_finite(self) -> bool {
        self.re.is_finite() && self.im.is_finite()
    }
}

impl From<Point<2>> for Complex {
    fn from([re, im]: Point<2>) -> Self {
        Self { re, im }
    }
}

impl Add for Complex {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Complex {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Neg for Complex {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

impl Mul for Complex {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}

impl Mul<f64> for Complex {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }
}

impl Mul<Complex> for f64 {
    type Output = Complex;

    fn mul(self, vector: Complex) -> Complex {
        vector * self
    }
}

/// Smith's division, which overflows no sooner than the quotient.
impl Div for Complex {
    type Output = Self;

    fn div(self, by: Self) -> Self {
        if by.re.abs() >= by.im.abs() {
            let ratio = by.im / by.re;
            let scale = by.re + by.im * ratio;
            Self::new((self.re + self.im * ratio) / scale, (self.im - self.re * ratio) / scale)
        } else {
            let ratio = by.re / by.im;
            let scale = by.re * ratio + by.im;
            Self::new((self.re * ratio + self.im) / scale, (self.im * ratio - self.re) / scale)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = Complex> {
        (-9.0..9.0, -9.0..9.0).prop_map(|(re, im)| Complex::new(re, im))
    }

    proptest! {
        #[test]
        fn roots_and_quotients_are_inverse(a in number(), b in number()) {
            let root = a.sqrt();
            prop_assert!(root.re >= 0.0 && (root * root - a).norm() <= 1e-15 * 9.0);
            prop_assert!((a / b * b - a).norm() < 1e-14 * 9.0);
        }

        #[test]
        fn angles_turn_vectors(a in number(), b in number()) {
            let turned = a * Complex::unit(a.angle_to(b));
            prop_assert!(turned.cross(b).abs() < 1e-13 * 81.0 && turned.dot(b) >= 0.0);
        }
    }

    #[test]
    fn roots_of_axes() {
        assert_eq!(Complex::new(-4.0, 0.0).sqrt(), Complex::new(0.0, 2.0));
        assert_eq!(Complex::new(4.0, 0.0).sqrt(), Complex::new(2.0, 0.0));
        assert_eq!(Complex::new(0.0, 0.0).sqrt(), Complex::default());
        assert_eq!(Complex::new(1.0, 2.0).left(), Complex::new(-2.0, 1.0));
    }
}
