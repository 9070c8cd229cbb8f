//! Named variables and products of their powers.

use super::AlgebraError;
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

/// The longest name of a variable, in characters.
pub(super) const MAX_NAME: usize = 64;

/// A variable. Equal names are the same variable, wherever they come from.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Variable(Arc<str>);

impl Variable {
    /// The variable of this name: a letter or `_`, then letters, digits and `_`, at most 64 characters.
    ///
    /// # Errors
    /// [`AlgebraError::Name`].
    pub fn new(name: &str) -> Result<Self, AlgebraError> {
        let fits =
            name.starts_with(begins) && name.chars().all(continues) && name.chars().count() <= MAX_NAME;
        if fits {
            Ok(Self(name.into()))
        } else {
            let given = name.chars().take(MAX_NAME + 1).collect();
            Err(AlgebraError::Name { given })
        }
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.0
    }
}

/// Whether a name can begin with this character.
pub(super) fn begins(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

/// Whether a name can go on with this character.
pub(super) fn continues(c: char) -> bool {
    begins(c) || c.is_ascii_digit()
}

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A product of powers of variables with exponents from 1; the empty product is 1.
///
/// Products are ordered by total degree, then by the exponents of the variables in the order of their names.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct PowerProduct(Vec<(Variable, u32)>);

impl PowerProduct {
    /// The power of one variable; 1 for the exponent 0.
    #[must_use]
    pub fn power_of(variable: &Variable, exponent: u32) -> Self {
        Self((exponent > 0).then(|| (variable.clone(), exponent)).into_iter().collect())
    }

    /// The variables with their exponents, in the order of names.
    #[must_use]
    pub fn factors(&self) -> &[(Variable, u32)] {
        &self.0
    }

    /// The exponent of a variable, 0 where it does not occur.
    #[must_use]
    pub fn exponent(&self, variable: &Variable) -> u32 {
        let found = self.0.binary_search_by(|(own, _)| own.cmp(variable));
        found.ok().and_then(|index| self.0.get(index)).map_or(0, |factor| factor.1)
    }

    /// The sum of the exponents.
    #[must_use]
    pub fn degree(&self) -> u64 {
        self.0.iter().map(|factor| u64::from(factor.1)).sum()
    }

    /// The product of both.
    ///
    /// # Errors
    /// [`AlgebraError::Exponent`].
    pub fn times(&self, other: &Self) -> Result<Self, AlgebraError> {
        let (mut a, mut b) = (self.0.iter().peekable(), other.0.iter().peekable());
        let mut factors = Vec::with_capacity(self.0.len() + other.0.len());
        loop {
            let order = match (a.peek(), b.peek()) {
                (Some(mine), Some(its)) => mine.0.cmp(&its.0),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (None, None) => return Ok(Self(factors)),
            };
            let mine = if order == Ordering::Greater { None } else { a.next() };
            let its = if order == Ordering::Less { None } else { b.next() };
            let exponent = |factor: Option<&(Variable, u32)>| factor.map_or(0, |it| it.1);
            if let Some((variable, _)) = mine.or(its) {
                let sum = exponent(mine).checked_add(exponent(its));
                let overflow = || AlgebraError::Exponent { variable: variable.name().to_string() };
                factors.push((variable.clone(), sum.ok_or_else(overflow)?));
            }
        }
    }

    /// The greatest product that divides both.
    #[must_use]
    pub fn common(&self, other: &Self) -> Self {
        let least = |(variable, exponent): &(Variable, u32)| {
            let exponent = other.exponent(variable).min(*exponent);
            (exponent > 0).then(|| (variable.clone(), exponent))
        };
        Self(self.0.iter().filter_map(least).collect())
    }

    /// The quotient; variables that the divisor has more of are left out.
    pub(super) fn without(&self, divisor: &Self) -> Self {
        let rest = |(variable, exponent): &(Variable, u32)| {
            let exponent = exponent.saturating_sub(divisor.exponent(variable));
            (exponent > 0).then(|| (variable.clone(), exponent))
        };
        Self(self.0.iter().filter_map(rest).collect())
    }
}

impl PartialOrd for PowerProduct {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for PowerProduct {
    fn cmp(&self, other: &Self) -> Ordering {
        self.degree().cmp(&other.degree()).then_with(|| {
            for (mine, its) in self.0.iter().zip(&other.0) {
                // Of two first variables that differ, the earlier name makes the greater product.
                let order = its.0.cmp(&mine.0).then(mine.1.cmp(&its.1));
                if order != Ordering::Equal {
                    return order;
                }
            }
            self.0.len().cmp(&other.0.len())
        })
    }
}

impl fmt::Display for PowerProduct {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (variable, exponent)) in self.0.iter().enumerate() {
            let sign = if index == 0 { "" } else { "*" };
            write!(f, "{sign}{variable}")?;
            if *exponent > 1 {
                write!(f, "^{exponent}")?;
            }
        }
        if self.0.is_empty() { f.write_str("1") } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn power(name: &str, exponent: u32) -> PowerProduct {
        PowerProduct::power_of(&Variable::new(name).unwrap(), exponent)
    }

    #[test]
    fn equal_names_are_the_same_variable() {
        assert_eq!(Variable::new("x"), Variable::new("x"));
        assert_eq!(Variable::new("α_2").unwrap().name(), "α_2");
        for name in ["", "2x", "a b", "x^2", "x²", "a".repeat(65).as_str()] {
            assert!(matches!(Variable::new(name), Err(AlgebraError::Name { .. })), "{name}");
        }
    }

    #[test]
    fn exponents_add_up() {
        let product = power("y", 2).times(&power("x", 1)).unwrap().times(&power("y", 3)).unwrap();
        assert_eq!((product.to_string().as_str(), product.degree()), ("x*y^5", 6));
        assert_eq!(product.common(&power("y", 9)), power("y", 5));
        assert_eq!(product.without(&power("y", 5)), power("x", 1));
        assert_eq!(power("x", 0), PowerProduct::default());
        let error = power("x", u32::MAX).times(&power("x", 1));
        assert_eq!(error, Err(AlgebraError::Exponent { variable: "x".to_string() }));
    }

    #[test]
    fn order_is_by_degree_then_by_names() {
        let mut all = [power("y", 2), power("x", 1), power("z", 3), power("x", 2), PowerProduct::default()];
        all.sort();
        assert_eq!(all.map(|one| one.to_string()).join(" "), "1 x y^2 x^2 z^3");
        let xy = power("x", 1).times(&power("y", 1)).unwrap();
        assert!(power("y", 2) < xy && xy < power("x", 2));
    }
}
