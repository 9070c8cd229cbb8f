//! Complex numbers over any ring, so that planar curves can be computed with as polynomials.

use super::AlgebraError;
use super::ring::{Additive, Field, Ring};

/// The number `re + i im`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Complex<T> {
    /// The real part.
    pub re: T,
    /// The imaginary part.
    pub im: T,
}

impl<T: Additive> Complex<T> {
    /// The conjugate `re - i im`.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`].
    pub fn conjugate(&self) -> Result<Self, AlgebraError> {
        Ok(Self { re: self.re.clone(), im: self.im.negated()? })
    }
}

impl<T: Additive> Additive for Complex<T> {
    fn zero() -> Self {
        Self { re: T::zero(), im: T::zero() }
    }

    fn plus(self, other: &Self) -> Result<Self, AlgebraError> {
        Ok(Self { re: self.re.plus(&other.re)?, im: self.im.plus(&other.im)? })
    }

    fn negated(&self) -> Result<Self, AlgebraError> {
        Ok(Self { re: self.re.negated()?, im: self.im.negated()? })
    }
}

impl<T: Ring> Ring for Complex<T> {
    fn one() -> Self {
        Self { re: T::one(), im: T::zero() }
    }

    fn times(&self, other: &Self) -> Result<Self, AlgebraError> {
        Ok(Self {
            re: self.re.times(&other.re)?.minus(&self.im.times(&other.im)?)?,
            im: self.re.times(&other.im)?.plus(&self.im.times(&other.re)?)?,
        })
    }
}

impl<T: Field> Field for Complex<T> {
    fn over(&self, divisor: &Self) -> Result<Self, AlgebraError> {
        let square = divisor.re.times(&divisor.re)?.plus(&divisor.im.times(&divisor.im)?)?;
        let turned = self.times(&divisor.conjugate()?)?;
        Ok(Self { re: turned.re.over(&square)?, im: turned.im.over(&square)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn i_squared_is_minus_one() {
        let i = Complex { re: 0_i64, im: 1 };
        assert_eq!(i.power(2), Complex::one().negated());
        let (a, b) = (Complex { re: 3.0, im: -4.0 }, Complex { re: 1.0, im: 2.0 });
        assert_eq!(a.over(&b).unwrap(), Complex { re: -1.0, im: -2.0 });
        assert_eq!(a.times(&a.conjugate().unwrap()).unwrap(), Complex { re: 25.0, im: 0.0 });
        assert_eq!(a.over(&Complex::zero()), Err(AlgebraError::DivisionByZero));
    }
}
