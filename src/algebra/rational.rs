//! Rational functions: quotients of polynomials.

use super::AlgebraError;
use super::polynomial::{Polynomial, assigned};
use super::ring::{Additive, Field, Ring, repeated};
use super::variable::{PowerProduct, Variable};
use super::work::Work;

/// A quotient of two polynomials.
///
/// The denominator's leading coefficient is 1, constants and common powers of variables are cancelled, and so
/// is a denominator that divides the numerator. Other common factors stay: no greatest common divisor is looked
/// for. Sums of equal denominators keep them. As usual for rational functions, x/x is 1.
///
/// ```
/// use grafika::algebra::{Fraction, Rational, Variable};
///
/// let r: Rational<Fraction> = "(x^2 - 1)/(x^2 + y)".parse()?;
/// let (x, y) = (Variable::new("x")?, Variable::new("y")?);
/// let value = r.derivative(&x)?.evaluate(&[(x, 2.into()), (y, "1/3".parse()?)])?;
/// assert_eq!(value, "48/169".parse()?);
/// # Ok::<(), grafika::algebra::AlgebraError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Rational<C> {
    numerator: Polynomial<C>,
    denominator: Polynomial<C>,
}

impl<C: Field> Rational<C> {
    /// The quotient of two polynomials.
    ///
    /// # Errors
    /// [`AlgebraError::DivisionByZero`] and [`AlgebraError::Overflow`].
    pub fn new(numerator: Polynomial<C>, denominator: Polynomial<C>) -> Result<Self, AlgebraError> {
        Self::reduced(numerator, denominator, &Work::new())
    }

    /// The quotient with all cancelled that can be.
    fn reduced(
        numerator: Polynomial<C>,
        denominator: Polynomial<C>,
        work: &Work,
    ) -> Result<Self, AlgebraError> {
        let (powers, leading) = denominator.leading().ok_or(AlgebraError::DivisionByZero)?;
        if numerator.is_zero() {
            return Ok(Self::zero());
        }
        let leading = leading.clone();
        let cancelled = |polynomial: Polynomial<C>| {
            if leading == C::one() { Ok(polynomial) } else { polynomial.map(|c| c.over(&leading)) }
        };
        if powers.factors().is_empty() {
            return Ok(Self::from(cancelled(numerator)?));
        }
        work.spend(numerator.size().saturating_add(denominator.size()))?;
        let all = numerator.terms().chain(denominator.terms());
        let common =
            all.map(|(powers, _)| powers).fold(powers.clone(), |common, powers| common.common(powers));
        let numerator = cancelled(numerator)?.without(&common);
        let denominator = cancelled(denominator)?.without(&common);
        if denominator.as_constant().is_some() {
            return Ok(Self::from(numerator));
        }
        Ok(match quotient(&numerator, &denominator, work) {
            Some(whole) => Self::from(whole),
            None => Self { numerator, denominator },
        })
    }

    /// The numerator.
    #[must_use]
    pub fn numerator(&self) -> &Polynomial<C> {
        &self.numerator
    }

    /// The denominator, whose leading coefficient is 1.
    #[must_use]
    pub fn denominator(&self) -> &Polynomial<C> {
        &self.denominator
    }

    /// The polynomial, where the denominator is 1.
    ///
    /// # Errors
    /// [`AlgebraError::NotPolynomial`].
    pub fn into_polynomial(self) -> Result<Polynomial<C>, AlgebraError> {
        if self.denominator.as_constant().is_some() {
            Ok(self.numerator)
        } else {
            Err(AlgebraError::NotPolynomial)
        }
    }

    /// The value of a function without variables; `None` when there are some.
    #[must_use]
    pub fn as_constant(&self) -> Option<C> {
        self.denominator.as_constant().and_then(|_| self.numerator.as_constant())
    }

    /// The partial derivative (n' d - n d') / d² by a variable.
    ///
    /// # Errors
    /// Those of [`Ring::times`].
    pub fn derivative(&self, variable: &Variable) -> Result<Self, AlgebraError> {
        let (n, d) = (&self.numerator, &self.denominator);
        let (by_n, by_d) = (n.derivative(variable)?, d.derivative(variable)?);
        if by_d.is_zero() {
            return Self::new(by_n, d.clone());
        }
        Self::new(by_n.times(d)?.minus(&n.times(&by_d)?)?, d.power(2)?)
    }

    /// The value where the variables have these values.
    ///
    /// # Errors
    /// [`AlgebraError::Unbound`], [`AlgebraError::Repeated`], [`AlgebraError::DivisionByZero`] at a pole,
    /// [`AlgebraError::Overflow`].
    pub fn evaluate(&self, at: &[(Variable, C)]) -> Result<C, AlgebraError> {
        self.numerator.evaluate(at)?.over(&self.denominator.evaluate(at)?)
    }

    /// The composition: rational functions in place of variables, all at once. Variables that are not given
    /// stay.
    ///
    /// # Errors
    /// [`AlgebraError::Repeated`] for a variable given twice, [`AlgebraError::DivisionByZero`] where the
    /// denominator becomes zero, and those of [`Ring::times`].
    pub fn substitute(&self, with: &[(Variable, Rational<C>)]) -> Result<Self, AlgebraError> {
        let (functions, work) = (assigned(with)?, Work::new());
        let power = |variable: &Variable, exponent| match functions.get(variable) {
            Some(function) => function.power_within(exponent, &work),
            None => Ok(Self::from(Polynomial::term(C::one(), PowerProduct::power_of(variable, exponent)))),
        };
        let times = |a: &Self, b: &Self| a.times_within(b, &work);
        let scaled = |coefficient: &C, powers: &Self| {
            Self::reduced(
                powers.numerator.scaled_within(coefficient, &work)?,
                powers.denominator.clone(),
                &work,
            )
        };
        let plus = |a: Self, b: &Self| a.plus_within(b, &work);
        let composed = |p: &Polynomial<C>| p.combined(&Self::one(), power, times, scaled, plus);
        composed(&self.numerator)?.over_within(&composed(&self.denominator)?, &work)
    }

    /// A power with any whole exponent; the power 0 is one.
    ///
    /// # Errors
    /// [`AlgebraError::DivisionByZero`] for a negative power of zero, and those of [`Ring::times`].
    pub fn signed_power(&self, exponent: i64) -> Result<Self, AlgebraError> {
        self.signed_power_within(exponent, &Work::new())
    }

    pub(super) fn signed_power_within(&self, exponent: i64, work: &Work) -> Result<Self, AlgebraError> {
        let size = u32::try_from(exponent.unsigned_abs()).map_err(|_| AlgebraError::TooLarge)?;
        let power = self.power_within(size, work)?;
        if exponent < 0 { Self::one().over_within(&power, work) } else { Ok(power) }
    }

    pub(super) fn plus_within(self, other: &Self, work: &Work) -> Result<Self, AlgebraError> {
        if self.denominator == other.denominator {
            work.spend(other.numerator.size())?;
            return Self::reduced(self.numerator.plus(&other.numerator)?, self.denominator, work);
        }
        let (a, b) = (
            self.numerator.times_within(&other.denominator, work)?,
            other.numerator.times_within(&self.denominator, work)?,
        );
        Self::reduced(a.plus(&b)?, self.denominator.times_within(&other.denominator, work)?, work)
    }

    pub(super) fn times_within(&self, other: &Self, work: &Work) -> Result<Self, AlgebraError> {
        Self::reduced(
            self.numerator.times_within(&other.numerator, work)?,
            self.denominator.times_within(&other.denominator, work)?,
            work,
        )
    }

    pub(super) fn over_within(&self, other: &Self, work: &Work) -> Result<Self, AlgebraError> {
        Self::reduced(
            self.numerator.times_within(&other.denominator, work)?,
            self.denominator.times_within(&other.numerator, work)?,
            work,
        )
    }

    fn power_within(&self, exponent: u32, work: &Work) -> Result<Self, AlgebraError> {
        repeated(self, exponent, Self::one(), |a, b| a.times_within(b, work))
    }
}

/// The quotient where the divisor, whose leading coefficient is 1, divides without a rest and it takes little
/// work to see that.
fn quotient<C: Field>(
    numerator: &Polynomial<C>,
    divisor: &Polynomial<C>,
    work: &Work,
) -> Option<Polynomial<C>> {
    let (leading, _) = divisor.leading()?;
    let (mut rest, mut result) = (numerator.clone(), Polynomial::zero());
    while let Some((powers, coefficient)) = rest.leading() {
        if powers.common(leading) != *leading {
            return None;
        }
        let next = Polynomial::term(coefficient.clone(), powers.without(leading));
        let before = powers.clone();
        work.try_to_divide(divisor.size()).ok()?;
        rest = rest.minus(&next.times(divisor).ok()?).ok()?;
        // With rounded coefficients the leading term may survive by its last bits.
        if rest.leading().is_some_and(|(powers, _)| *powers >= before) {
            return None;
        }
        result = result.plus(&next).ok()?;
    }
    Some(result)
}

impl<C: Ring> From<Polynomial<C>> for Rational<C> {
    fn from(numerator: Polynomial<C>) -> Self {
        Self { numerator, denominator: Polynomial::one() }
    }
}

/// By cross-multiplication; `false` where the products are too large to be formed.
impl<C: Ring> PartialEq for Rational<C> {
    fn eq(&self, other: &Self) -> bool {
        if self.denominator == other.denominator {
            return self.numerator == other.numerator;
        }
        let cross = |a: &Self, b: &Self| a.numerator.times(&b.denominator);
        cross(self, other).is_ok_and(|one| cross(other, self).is_ok_and(|two| one == two))
    }
}

impl<C: Field> Additive for Rational<C> {
    fn zero() -> Self {
        Self::from(Polynomial::zero())
    }

    fn plus(self, other: &Self) -> Result<Self, AlgebraError> {
        self.plus_within(other, &Work::new())
    }

    fn negated(&self) -> Result<Self, AlgebraError> {
        Ok(Self { numerator: self.numerator.negated()?, denominator: self.denominator.clone() })
    }

    fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }
}

impl<C: Field> Ring for Rational<C> {
    fn one() -> Self {
        Self::from(Polynomial::one())
    }

    fn times(&self, other: &Self) -> Result<Self, AlgebraError> {
        self.times_within(other, &Work::new())
    }

    fn power(&self, exponent: u32) -> Result<Self, AlgebraError> {
        self.power_within(exponent, &Work::new())
    }
}

impl<C: Field> Field for Rational<C> {
    fn over(&self, divisor: &Self) -> Result<Self, AlgebraError> {
        self.over_within(divisor, &Work::new())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Fraction;
    use proptest::prelude::*;

    fn rational(text: &str) -> Rational<Fraction> {
        text.parse().unwrap()
    }

    fn var(name: &str) -> Variable {
        Variable::new(name).unwrap()
    }

    #[test]
    fn constants_and_common_powers_are_cancelled() {
        for (given, simple) in [
            ("(2*x + 2)/4", "1/2*x + 1/2"),
            ("(x^3*y + x^2)/(2*x^2*y)", "(1/2*x*y + 1/2)/y"),
            ("(x^2 - y^2)/(x - y)", "x + y"),
            ("x/x", "1"),
            ("0/(x + 1)", "0"),
            ("1/(x + 1) + x/(x + 1)", "1"),
            ("1/(2*x + 2) + 1/(x + 1)", "3/2/(x + 1)"),
            ("x^-2", "1/x^2"),
        ] {
            assert_eq!(rational(given).to_string(), simple, "{given}");
        }
        assert_eq!(rational("(x^2 - 1)/(x^2 + 2*x + 1)"), rational("(x - 1)/(x + 1)"), "equal all the same");
    }

    #[test]
    fn zero_denominators_are_errors() {
        let zero = Rational::<Fraction>::zero();
        assert_eq!(Rational::one().over(&zero), Err(AlgebraError::DivisionByZero));
        let pole = rational("1/(x - 1)");
        assert_eq!(pole.evaluate(&[(var("x"), 1.into())]), Err(AlgebraError::DivisionByZero));
        assert_eq!(pole.substitute(&[(var("x"), rational("1"))]), Err(AlgebraError::DivisionByZero));
        assert_eq!(zero.signed_power(-1), Err(AlgebraError::DivisionByZero));
        assert_eq!(pole.into_polynomial(), Err(AlgebraError::NotPolynomial));
    }

    #[test]
    fn substitution_is_simultaneous() {
        let swapped =
            rational("x/(y + 1)").substitute(&[(var("x"), rational("y")), (var("y"), rational("x"))]);
        assert_eq!(swapped.unwrap().to_string(), "y/(x + 1)");
        let composed = rational("(1 - t^2)/(1 + t^2)").substitute(&[(var("t"), rational("a/b"))]).unwrap();
        assert_eq!(composed, rational("(b^2 - a^2)/(a^2 + b^2)"));
    }

    /// All sums and products of one substitution are counted together.
    #[test]
    fn large_substitutions_are_refused() {
        let large: Rational<f64> = "x - y/(a^99*(1 - a + z)^17 + y)/2".parse().unwrap();
        assert_eq!(large.substitute(&[(var("x"), large.clone())]), Err(AlgebraError::TooLarge));
    }

    fn small() -> impl Strategy<Value = Rational<Fraction>> {
        let coefficients = prop::array::uniform6(-3_i64..4);
        coefficients.prop_map(|[a, b, c, d, e, f]| {
            rational(&format!("({a} + {b}*x + {c}*y)/({d} + {e}*x*y + {f}*x^2 + 7*y^3)"))
        })
    }

    proptest! {
        #[test]
        fn is_a_field(a in small(), b in small()) {
            let sum = a.clone().plus(&b).unwrap();
            prop_assert_eq!(&sum, &b.clone().plus(&a).unwrap());
            prop_assert_eq!(sum.minus(&b).unwrap(), a.clone());
            let product = a.times(&b).unwrap();
            prop_assert_eq!(&product, &b.times(&a).unwrap());
            if !b.is_zero() {
                prop_assert_eq!(product.over(&b).unwrap(), a);
            }
        }

        #[test]
        fn derivative_follows_leibniz(a in small(), b in small()) {
            let x = var("x");
            let by = |r: &Rational<Fraction>| r.derivative(&x).unwrap();
            let rule = by(&a).times(&b).unwrap().plus(&a.times(&by(&b)).unwrap()).unwrap();
            prop_assert_eq!(by(&a.times(&b).unwrap()), rule);
        }

        #[test]
        fn reads_back_what_it_prints(a in small()) {
            prop_assert_eq!(rational(&a.to_string()), a);
        }
    }
}
