//! Formulas as text that reads back.

use super::polynomial::Polynomial;
use super::rational::Rational;
use super::ring::{Number, Ring};
use std::fmt;

/// The terms from the highest degree down: `x^3 - 2*x*y^2 + 1`.
impl<C: Number> fmt::Display for Polynomial<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.term_count() == 0 {
            return f.write_str("0");
        }
        for (index, (powers, coefficient)) in self.terms().enumerate() {
            let text = coefficient.write();
            let (negative, size) = match text.strip_prefix('-') {
                Some(size) => (true, size),
                None => (false, text.as_str()),
            };
            f.write_str(match (index, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            if powers.factors().is_empty() {
                f.write_str(size)?;
            } else if size == C::one().write() {
                write!(f, "{powers}")?;
            } else {
                write!(f, "{size}*{powers}")?;
            }
        }
        Ok(())
    }
}

/// Numerator and denominator, in parentheses where they need them: `x/(y + 1)`.
impl<C: Number> fmt::Display for Rational<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (numerator, denominator) = (self.numerator(), self.denominator());
        if *denominator == Polynomial::one() {
            return write!(f, "{numerator}");
        }
        match numerator.term_count() {
            0 | 1 => write!(f, "{numerator}/")?,
            _ => write!(f, "({numerator})/")?,
        }
        let mut terms = denominator.terms();
        let one_power =
            matches!((terms.next(), terms.next()), (Some((powers, _)), None) if powers.factors().len() == 1);
        if one_power { write!(f, "{denominator}") } else { write!(f, "({denominator})") }
    }
}
