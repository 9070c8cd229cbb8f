//! Polynomials in named variables.

use super::AlgebraError;
use super::ring::{Additive, Ring, repeated};
use super::variable::{PowerProduct, Variable};
use super::work::Work;
use std::collections::{BTreeMap, BTreeSet};

/// A polynomial: power products with their coefficients, none of which is zero.
///
/// Sums need coefficients that can be added ([`Additive`], also vectors), products and powers a [`Ring`], whose
/// operations these are. A polynomial over a ring is itself an element of a ring.
///
/// ```
/// use grafika::algebra::{Fraction, Polynomial, Variable};
///
/// let p: Polynomial<Fraction> = "x^3 - 2*x*y^2 + 1".parse()?;
/// let (x, y) = (Variable::new("x")?, Variable::new("y")?);
/// assert_eq!(p.derivative(&x)?.to_string(), "3*x^2 - 2*y^2");
/// assert_eq!(p.evaluate(&[(x, 3.into()), (y, (-1).into())])?, 22.into());
/// # Ok::<(), grafika::algebra::AlgebraError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial<C> {
    terms: BTreeMap<PowerProduct, C>,
}

impl<C> Polynomial<C> {
    /// The terms, those of highest degree first.
    pub fn terms(&self) -> impl Iterator<Item = (&PowerProduct, &C)> {
        self.terms.iter().rev()
    }

    /// The term that is first in the order of [`PowerProduct`]; `None` for zero.
    #[must_use]
    pub fn leading(&self) -> Option<(&PowerProduct, &C)> {
        self.terms.last_key_value()
    }

    /// The coefficient of a power product; `None` where it is zero.
    #[must_use]
    pub fn coefficient(&self, powers: &PowerProduct) -> Option<&C> {
        self.terms.get(powers)
    }

    /// The number of terms.
    #[must_use]
    pub fn term_count(&self) -> usize {
        self.terms.len()
    }

    /// The largest exponent of a variable; `None` for zero.
    #[must_use]
    pub fn degree(&self, variable: &Variable) -> Option<u32> {
        self.terms.keys().map(|powers| powers.exponent(variable)).max()
    }

    /// The largest sum of exponents of a term; `None` for zero.
    #[must_use]
    pub fn total_degree(&self) -> Option<u64> {
        self.leading().map(|(powers, _)| powers.degree())
    }

    /// The variables that occur.
    #[must_use]
    pub fn variables(&self) -> BTreeSet<Variable> {
        self.terms.keys().flat_map(PowerProduct::factors).map(|(variable, _)| variable.clone()).collect()
    }

    /// Terms and factors together: what a step over the whole polynomial costs.
    pub(super) fn size(&self) -> usize {
        self.terms.keys().map(|powers| 1 + powers.factors().len()).sum()
    }
}

impl<C: Additive> Polynomial<C> {
    /// The polynomial of one term.
    #[must_use]
    pub fn term(coefficient: C, powers: PowerProduct) -> Self {
        let term = (!coefficient.is_zero()).then_some((powers, coefficient));
        Self { terms: term.into_iter().collect() }
    }

    /// The polynomial without variables.
    #[must_use]
    pub fn constant(value: C) -> Self {
        Self::term(value, PowerProduct::default())
    }

    /// The value of a polynomial without variables; `None` when there are some.
    #[must_use]
    pub fn as_constant(&self) -> Option<C> {
        match self.leading() {
            None => Some(C::zero()),
            Some((powers, value)) => powers.factors().is_empty().then(|| value.clone()),
        }
    }

    /// The polynomial divided by a power product that divides every term.
    pub(super) fn without(self, divisor: &PowerProduct) -> Self {
        if divisor.factors().is_empty() {
            return self;
        }
        let terms = self.terms.into_iter();
        Self { terms: terms.map(|(powers, coefficient)| (powers.without(divisor), coefficient)).collect() }
    }

    /// Adds a term.
    fn add(&mut self, powers: PowerProduct, coefficient: &C) -> Result<(), AlgebraError> {
        let old = self.terms.remove(&powers).unwrap_or_else(C::zero);
        let sum = old.plus(coefficient)?;
        if !sum.is_zero() {
            self.terms.insert(powers, sum);
        }
        Ok(())
    }

    /// The polynomial with other coefficients.
    ///
    /// # Errors
    /// Those of `change`.
    pub fn map<D: Additive>(
        &self,
        mut change: impl FnMut(&C) -> Result<D, AlgebraError>,
    ) -> Result<Polynomial<D>, AlgebraError> {
        let mut terms = BTreeMap::new();
        for (powers, coefficient) in &self.terms {
            let changed = change(coefficient)?;
            if !changed.is_zero() {
                terms.insert(powers.clone(), changed);
            }
        }
        Ok(Polynomial { terms })
    }

    /// The partial derivative by a variable.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`].
    pub fn derivative(&self, variable: &Variable) -> Result<Self, AlgebraError> {
        let one = PowerProduct::power_of(variable, 1);
        let mut terms = BTreeMap::new();
        for (powers, coefficient) in &self.terms {
            let exponent = powers.exponent(variable);
            let multiple = coefficient.multiple(exponent)?;
            if exponent > 0 && !multiple.is_zero() {
                terms.insert(powers.without(&one), multiple);
            }
        }
        Ok(Self { terms })
    }

    /// The derivatives by several variables, one each.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`].
    pub fn gradient(&self, variables: &[Variable]) -> Result<Vec<Self>, AlgebraError> {
        variables.iter().map(|variable| self.derivative(variable)).collect()
    }

    /// The value where the variables have values of a ring that may be another than that of the coefficients;
    /// `scaled` multiplies a coefficient with a value. So a polynomial with vectors as coefficients has a vector
    /// as value at numbers.
    ///
    /// # Errors
    /// [`AlgebraError::Unbound`] for a variable without value, [`AlgebraError::Repeated`] for one with two, and
    /// those of the ring.
    pub fn evaluate_with<X: Ring, Y: Additive>(
        &self,
        at: &[(Variable, X)],
        scaled: impl Fn(&C, &X) -> Result<Y, AlgebraError>,
    ) -> Result<Y, AlgebraError> {
        let values = assigned(at)?;
        let power = |variable: &Variable, exponent| match values.get(variable) {
            Some(value) => value.power(exponent),
            None => Err(AlgebraError::Unbound { variable: variable.name().to_string() }),
        };
        self.combined(&X::one(), power, X::times, scaled, Y::plus)
    }

    /// The sum of the coefficients times the products of powers, whatever powers, products and sums are.
    pub(super) fn combined<X: Clone, Y: Additive>(
        &self,
        one: &X,
        power: impl Fn(&Variable, u32) -> Result<X, AlgebraError>,
        times: impl Fn(&X, &X) -> Result<X, AlgebraError>,
        scaled: impl Fn(&C, &X) -> Result<Y, AlgebraError>,
        plus: impl Fn(Y, &Y) -> Result<Y, AlgebraError>,
    ) -> Result<Y, AlgebraError> {
        let mut sum = Y::zero();
        for (powers, coefficient) in &self.terms {
            let mut product: Option<X> = None;
            for (variable, exponent) in powers.factors() {
                let factor = power(variable, *exponent)?;
                product = Some(match product {
                    Some(before) => times(&before, &factor)?,
                    None => factor,
                });
            }
            sum = plus(sum, &scaled(coefficient, product.as_ref().unwrap_or(one))?)?;
        }
        Ok(sum)
    }
}

/// What variables are given, each once.
///
/// # Errors
/// [`AlgebraError::Repeated`].
pub(super) fn assigned<T>(pairs: &[(Variable, T)]) -> Result<BTreeMap<&Variable, &T>, AlgebraError> {
    let mut values = BTreeMap::new();
    for (variable, value) in pairs {
        if values.insert(variable, value).is_some() {
            return Err(AlgebraError::Repeated { variable: variable.name().to_string() });
        }
    }
    Ok(values)
}

impl<C: Ring> Polynomial<C> {
    /// The polynomial that is a variable.
    #[must_use]
    pub fn variable(variable: &Variable) -> Self {
        Self::term(C::one(), PowerProduct::power_of(variable, 1))
    }

    /// The value where the variables have values of the coefficients' ring.
    ///
    /// # Errors
    /// As for [`Polynomial::evaluate_with`].
    pub fn evaluate(&self, at: &[(Variable, C)]) -> Result<C, AlgebraError> {
        self.evaluate_with(at, C::times)
    }

    /// The composition: polynomials in place of variables, all at once, so that x = y, y = x swaps them.
    /// Variables that are not given stay.
    ///
    /// # Errors
    /// [`AlgebraError::Repeated`] for a variable given twice, and those of [`Ring::times`].
    pub fn substitute(&self, with: &[(Variable, Polynomial<C>)]) -> Result<Self, AlgebraError> {
        let (polynomials, work) = (assigned(with)?, Work::new());
        let power = |variable: &Variable, exponent| match polynomials.get(variable) {
            Some(polynomial) => polynomial.power_within(exponent, &work),
            None => Ok(Self::term(C::one(), PowerProduct::power_of(variable, exponent))),
        };
        let times = |a: &Self, b: &Self| a.times_within(b, &work);
        let scaled = |coefficient: &C, powers: &Self| powers.scaled_within(coefficient, &work);
        self.combined(&Self::one(), power, times, scaled, Self::plus)
    }

    /// The product with a number of the coefficients' ring.
    ///
    /// # Errors
    /// [`AlgebraError::Overflow`].
    pub fn scaled(&self, factor: &C) -> Result<Self, AlgebraError> {
        self.map(|coefficient| coefficient.times(factor))
    }

    pub(super) fn scaled_within(&self, factor: &C, work: &Work) -> Result<Self, AlgebraError> {
        work.spend(self.size())?;
        self.scaled(factor)
    }

    /// The product of two polynomials, counted.
    pub(super) fn times_within(&self, other: &Self, work: &Work) -> Result<Self, AlgebraError> {
        let cost = |a: usize, b: usize| a.saturating_mul(b);
        let all = cost(self.size(), other.term_count()).saturating_add(cost(self.term_count(), other.size()));
        work.spend(all)?;
        let mut product = Self::zero();
        for (mine, a) in &self.terms {
            for (its, b) in &other.terms {
                product.add(mine.times(its)?, &a.times(b)?)?;
            }
        }
        Ok(product)
    }

    /// A power by squaring, counted.
    pub(super) fn power_within(&self, exponent: u32, work: &Work) -> Result<Self, AlgebraError> {
        repeated(self, exponent, Self::one(), |a, b| a.times_within(b, work))
    }
}

impl<C: Additive> Additive for Polynomial<C> {
    fn zero() -> Self {
        Self { terms: BTreeMap::new() }
    }

    fn plus(mut self, other: &Self) -> Result<Self, AlgebraError> {
        for (powers, coefficient) in &other.terms {
            self.add(powers.clone(), coefficient)?;
        }
        Ok(self)
    }

    fn negated(&self) -> Result<Self, AlgebraError> {
        self.map(C::negated)
    }

    fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    fn multiple(&self, count: u32) -> Result<Self, AlgebraError> {
        self.map(|coefficient| coefficient.multiple(count))
    }
}

impl<C: Ring> Ring for Polynomial<C> {
    fn one() -> Self {
        Self::constant(C::one())
    }

    fn times(&self, other: &Self) -> Result<Self, AlgebraError> {
        self.times_within(other, &Work::new())
    }

    fn power(&self, exponent: u32) -> Result<Self, AlgebraError> {
        self.power_within(exponent, &Work::new())
    }
}

#[cfg(test)]
mod tests;
