//! What coefficients and values of polynomials can do.
//!
//! All operations answer with a `Result`: exact numbers overflow, and a double that is no longer finite is an
//! error here instead of an infinity or NaN that travels on.

use super::AlgebraError;

/// Values that can be added: the coefficients of a polynomial at the least, such as vectors.
pub trait Additive: Clone + PartialEq {
    /// The neutral element of addition.
    fn zero() -> Self;

    /// The sum.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`].
    fn plus(self, other: &Self) -> Result<Self, AlgebraError>;

    /// The additive inverse.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`].
    fn negated(&self) -> Result<Self, AlgebraError>;

    /// Whether it is the neutral element of addition.
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }

    /// The difference.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`].
    fn minus(self, other: &Self) -> Result<Self, AlgebraError> {
        self.plus(&other.negated()?)
    }

    /// The sum of `count` times itself, by doubling.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`].
    fn multiple(&self, count: u32) -> Result<Self, AlgebraError> {
        repeated(self, count, Self::zero(), |a, b| a.clone().plus(b))
    }
}

/// A commutative ring with one.
pub trait Ring: Additive {
    /// The neutral element of multiplication.
    fn one() -> Self;

    /// The product.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`], for polynomials also [`AlgebraError::TooLarge`] and [`AlgebraError::Exponent`].
    fn times(&self, other: &Self) -> Result<Self, AlgebraError>;

    /// A power by squaring; the power 0 is one, of zero too.
    ///
    /// # Errors
    /// As for [`Ring::times`].
    fn power(&self, exponent: u32) -> Result<Self, AlgebraError> {
        repeated(self, exponent, Self::one(), Self::times)
    }
}

/// A ring in which everything but zero divides.
pub trait Field: Ring {
    /// The quotient.
    ///
    /// # Errors
    /// [`AlgebraError::DivisionByZero`] and [`AlgebraError::Overflow`].
    fn over(&self, divisor: &Self) -> Result<Self, AlgebraError>;
}

/// Numbers that are written as text and read back.
pub trait Number: Field {
    /// The number of an unsigned decimal text such as `12`, `0.5` or `1.5e-3`.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`] for a number that the type cannot hold, [`AlgebraError::Syntax`] for other texts.
    fn read(text: &str) -> Result<Self, AlgebraError>;

    /// The number as text that reads back as the same: digits, with `-` before and `/` between them where
    /// needed.
    fn write(&self) -> String;
}

/// A value `count` times combined with itself, by doubling.
pub(super) fn repeated<T: Clone>(
    value: &T,
    count: u32,
    neutral: T,
    mut combined: impl FnMut(&T, &T) -> Result<T, AlgebraError>,
) -> Result<T, AlgebraError> {
    let mut result: Option<T> = None;
    for bit in (0..u32::BITS - count.leading_zeros()).rev() {
        result = match result {
            None => Some(value.clone()),
            Some(half) => {
                let doubled = combined(&half, &half)?;
                Some(if count >> bit & 1 == 1 { combined(&doubled, value)? } else { doubled })
            }
        };
    }
    Ok(result.unwrap_or(neutral))
}

/// A double, unless it is not finite.
fn finite(value: f64) -> Result<f64, AlgebraError> {
    // Adding zero turns -0 into 0, so that equal values are written alike.
    if value.is_finite() { Ok(value + 0.0) } else { Err(AlgebraError::Overflow) }
}

impl Additive for f64 {
    fn zero() -> Self {
        0.0
    }

    fn plus(self, other: &Self) -> Result<Self, AlgebraError> {
        finite(self + other)
    }

    fn negated(&self) -> Result<Self, AlgebraError> {
        finite(-self)
    }

    fn multiple(&self, count: u32) -> Result<Self, AlgebraError> {
        finite(self * f64::from(count))
    }
}

impl Ring for f64 {
    fn one() -> Self {
        1.0
    }

    fn times(&self, other: &Self) -> Result<Self, AlgebraError> {
        finite(self * other)
    }
}

impl Field for f64 {
    fn over(&self, divisor: &Self) -> Result<Self, AlgebraError> {
        if *divisor == 0.0 { Err(AlgebraError::DivisionByZero) } else { finite(self / divisor) }
    }
}

impl Number for f64 {
    fn read(text: &str) -> Result<Self, AlgebraError> {
        let syntax = |_| AlgebraError::Syntax { at: 1, found: format!("{text:?}"), wanted: "a number" };
        finite(text.parse().map_err(syntax)?)
    }

    fn write(&self) -> String {
        // Whole numbers of moderate size as such, all others in the shortest form that reads back.
        if self.fract() == 0.0 && self.abs() < 1e15 { format!("{self:.0}") } else { format!("{self:?}") }
    }
}

impl Additive for i64 {
    fn zero() -> Self {
        0
    }

    fn plus(self, other: &Self) -> Result<Self, AlgebraError> {
        self.checked_add(*other).ok_or(AlgebraError::Overflow)
    }

    fn negated(&self) -> Result<Self, AlgebraError> {
        self.checked_neg().ok_or(AlgebraError::Overflow)
    }
}

impl Ring for i64 {
    fn one() -> Self {
        1
    }

    fn times(&self, other: &Self) -> Result<Self, AlgebraError> {
        self.checked_mul(*other).ok_or(AlgebraError::Overflow)
    }
}

/// Vectors of `N` components.
impl<T: Additive, const N: usize> Additive for [T; N] {
    fn zero() -> Self {
        std::array::from_fn(|_| T::zero())
    }

    fn plus(mut self, other: &Self) -> Result<Self, AlgebraError> {
        for (mine, its) in self.iter_mut().zip(other) {
            *mine = std::mem::replace(mine, T::zero()).plus(its)?;
        }
        Ok(self)
    }

    fn negated(&self) -> Result<Self, AlgebraError> {
        let mut result = Self::zero();
        for (place, component) in result.iter_mut().zip(self) {
            *place = component.negated()?;
        }
        Ok(result)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_and_multiples_by_doubling() {
        for count in 0..40_u32 {
            assert_eq!(2_i64.power(count), Ok(1 << count));
            assert_eq!(7_i64.multiple(count), Ok(7 * i64::from(count)));
        }
        assert_eq!(0_i64.power(0), Ok(1));
        assert_eq!(1_i64.power(u32::MAX), Ok(1));
        assert_eq!(2_i64.power(u32::MAX), Err(AlgebraError::Overflow));
        assert_eq!([1.5, 2.0].multiple(4), Ok([6.0, 8.0]));
    }

    #[test]
    fn what_leaves_the_range_is_an_error() {
        assert_eq!(f64::MAX.plus(&f64::MAX), Err(AlgebraError::Overflow));
        assert_eq!(1e200.times(&1e200), Err(AlgebraError::Overflow));
        assert_eq!(1.0.over(&0.0), Err(AlgebraError::DivisionByZero));
        assert_eq!(i64::MIN.negated(), Err(AlgebraError::Overflow));
        assert_eq!(f64::read("1e999"), Err(AlgebraError::Overflow));
        assert!(matches!(f64::read("1,5"), Err(AlgebraError::Syntax { .. })));
    }

    #[test]
    fn doubles_are_written_as_they_read_back() {
        for value in [0.1, 1.0, 123_456.0, 1e300, 5e-324, 1.0 / 3.0, 9_007_199_254_740_993.0] {
            assert_eq!(f64::read(&value.write()), Ok(value));
        }
        assert_eq!(
            (1.0.write(), (-2.5).write(), 0.0.negated().unwrap().write()),
            ("1".into(), "-2.5".into(), "0".into())
        );
    }
}
