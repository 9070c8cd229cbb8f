//! Formulas written with operators.

use super::AlgebraError;
use super::polynomial::Polynomial;
use super::rational::Rational;
use super::ring::{Additive, Field, Ring};
use super::variable::Variable;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A rational function that is put together with `+ - * /`, which cannot fail in between: the first error is
/// kept and comes out at the end.
///
/// ```
/// use grafika::algebra::Formula;
///
/// let [x, y] = ["x", "y"].map(Formula::<f64>::variable);
/// let p = (x.pow(3) - Formula::from(2.0) * x * y.pow(2) + 1.0.into()).polynomial()?;
/// assert_eq!(p.to_string(), "x^3 - 2*x*y^2 + 1");
/// # Ok::<(), grafika::algebra::AlgebraError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Formula<C>(Result<Rational<C>, AlgebraError>);

impl<C: Field> Formula<C> {
    /// The variable of a name.
    #[must_use]
    pub fn variable(name: &str) -> Self {
        Self(Variable::new(name).map(|variable| Polynomial::variable(&variable).into()))
    }

    /// A power with any whole exponent; the power 0 is one.
    #[must_use]
    pub fn pow(&self, exponent: i64) -> Self {
        Self(self.0.as_ref().map_err(Clone::clone).and_then(|it| it.signed_power(exponent)))
    }

    /// What has been put together.
    ///
    /// # Errors
    /// The first error on the way.
    pub fn rational(self) -> Result<Rational<C>, AlgebraError> {
        self.0
    }

    /// What has been put together, as a polynomial.
    ///
    /// # Errors
    /// The first error on the way; [`AlgebraError::NotPolynomial`].
    pub fn polynomial(self) -> Result<Polynomial<C>, AlgebraError> {
        self.0?.into_polynomial()
    }
}

impl<C: Field> From<C> for Formula<C> {
    fn from(value: C) -> Self {
        Self(Ok(Polynomial::constant(value).into()))
    }
}

impl<C: Field> Add for Formula<C> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0.and_then(|it| it.plus(&other.0?)))
    }
}

impl<C: Field> Sub for Formula<C> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(self.0.and_then(|it| it.minus(&other.0?)))
    }
}

impl<C: Field> Mul for Formula<C> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0.and_then(|it| it.times(&other.0?)))
    }
}

impl<C: Field> Div for Formula<C> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self(self.0.and_then(|it| it.over(&other.0?)))
    }
}

impl<C: Field> Neg for Formula<C> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.and_then(|it| it.negated()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Fraction;

    #[test]
    fn operators_agree_with_the_parser() {
        let [x, y] = ["x", "y"].map(Formula::<Fraction>::variable);
        let three = Formula::from(Fraction::from(3));
        let built = -(x.pow(2) - y.clone()) / (three * x + y.pow(-1));
        assert_eq!(built.rational(), "-(x^2 - y)/(3*x + 1/y)".parse());
    }

    #[test]
    fn the_first_error_comes_out() {
        let bad = Formula::<f64>::variable("2x") + Formula::from(1.0) / Formula::from(0.0);
        assert_eq!(bad.polynomial(), Err(AlgebraError::Name { given: "2x".to_string() }));
        let bad = (Formula::from(1.0) / Formula::from(0.0)).pow(2);
        assert_eq!(bad.rational(), Err(AlgebraError::DivisionByZero));
    }
}
