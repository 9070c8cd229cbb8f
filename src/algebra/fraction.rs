//! Exact fractions.

use super::AlgebraError;
use super::ring::{Additive, Field, Number, Ring};
use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

/// A fraction in lowest terms with a positive denominator; both numbers have at most 127 bits.
///
/// ```
/// use grafika::algebra::{Additive, Fraction};
///
/// let third = Fraction::new(2, 6)?;
/// assert_eq!(third.plus(&"-5/6".parse()?)?.to_string(), "-1/2");
/// # Ok::<(), grafika::algebra::AlgebraError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Fraction {
    numerator: i128,
    denominator: i128,
}

impl Fraction {
    /// The fraction of two whole numbers.
    ///
    /// # Errors
    /// [`AlgebraError::DivisionByZero`]; [`AlgebraError::Overflow`] for `i128::MIN`, which has no opposite.
    pub fn new(numerator: i128, denominator: i128) -> Result<Self, AlgebraError> {
        if denominator == 0 {
            return Err(AlgebraError::DivisionByZero);
        }
        if numerator == i128::MIN || denominator == i128::MIN {
            return Err(AlgebraError::Overflow);
        }
        // Not zero, since the denominator is not.
        let divisor = common_divisor(numerator, denominator) * denominator.signum();
        Ok(Self { numerator: numerator / divisor, denominator: denominator / divisor })
    }

    /// The numerator, which carries the sign.
    #[must_use]
    pub fn numerator(&self) -> i128 {
        self.numerator
    }

    /// The denominator, at least 1.
    #[must_use]
    pub fn denominator(&self) -> i128 {
        self.denominator
    }

    /// The nearest double, to about one unit of its last bit.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }
}

/// The greatest common divisor of two numbers other than `i128::MIN`; not negative.
fn common_divisor(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.abs(), b.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// The product of two whole numbers.
fn product(a: i128, b: i128) -> Result<i128, AlgebraError> {
    a.checked_mul(b).ok_or(AlgebraError::Overflow)
}

impl From<i64> for Fraction {
    fn from(value: i64) -> Self {
        Self { numerator: value.into(), denominator: 1 }
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.numerator)?;
        if self.denominator == 1 { Ok(()) } else { write!(f, "/{}", self.denominator) }
    }
}

/// Reads `3`, `-3/4`, `0.25` or `1e-3`; both parts of a quotient may have a sign and decimals.
impl FromStr for Fraction {
    type Err = AlgebraError;

    fn from_str(text: &str) -> Result<Self, AlgebraError> {
        let signed = |text: &str| {
            let text = text.trim();
            match text.strip_prefix('-') {
                Some(digits) => Self::read(digits)?.negated(),
                None => Self::read(text.strip_prefix('+').unwrap_or(text)),
            }
        };
        match text.split_once('/') {
            Some((numerator, denominator)) => signed(numerator)?.over(&signed(denominator)?),
            None => signed(text),
        }
    }
}

impl Additive for Fraction {
    fn zero() -> Self {
        Self { numerator: 0, denominator: 1 }
    }

    fn plus(self, other: &Self) -> Result<Self, AlgebraError> {
        // The least common denominator keeps the numbers small.
        let common = common_divisor(self.denominator, other.denominator);
        let (mine, its) = (other.denominator / common, self.denominator / common);
        let sum = product(self.numerator, mine)?.checked_add(product(other.numerator, its)?);
        Self::new(sum.ok_or(AlgebraError::Overflow)?, product(self.denominator, mine)?)
    }

    fn negated(&self) -> Result<Self, AlgebraError> {
        Ok(Self { numerator: -self.numerator, denominator: self.denominator })
    }

    fn multiple(&self, count: u32) -> Result<Self, AlgebraError> {
        self.times(&Self::from(i64::from(count)))
    }
}

impl Ring for Fraction {
    fn one() -> Self {
        Self::from(1)
    }

    fn times(&self, other: &Self) -> Result<Self, AlgebraError> {
        // Cancelled crosswise first, so that only results that are too large overflow.
        let (a, b) =
            (Self::new(self.numerator, other.denominator)?, Self::new(other.numerator, self.denominator)?);
        Self::new(product(a.numerator, b.numerator)?, product(a.denominator, b.denominator)?)
    }
}

impl Field for Fraction {
    fn over(&self, divisor: &Self) -> Result<Self, AlgebraError> {
        self.times(&Self::new(divisor.denominator, divisor.numerator)?)
    }
}

impl Number for Fraction {
    fn read(text: &str) -> Result<Self, AlgebraError> {
        let syntax = || AlgebraError::Syntax { at: 1, found: format!("{text:?}"), wanted: "a number" };
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().map_err(|_| syntax())?),
            None => (text, 0),
        };
        let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = || whole.bytes().chain(decimals.bytes());
        if digits().next().is_none() || !digits().all(|byte| byte.is_ascii_digit()) {
            return Err(syntax());
        }
        // Zeros at the end of the decimals mean nothing and would only overflow.
        let decimals = decimals.trim_end_matches('0');
        let mut number = 0_i128;
        for byte in whole.bytes().chain(decimals.bytes()) {
            let next = product(number, 10)?.checked_add(i128::from(byte - b'0'));
            number = next.ok_or(AlgebraError::Overflow)?;
        }
        if number == 0 {
            return Ok(Self::zero());
        }
        let places = i64::try_from(decimals.len()).map_err(|_| AlgebraError::Overflow)?;
        let exponent = exponent.checked_sub(places).ok_or(AlgebraError::Overflow)?;
        let size = u32::try_from(exponent.unsigned_abs()).map_err(|_| AlgebraError::Overflow)?;
        let number = Self::new(number, 1)?;
        let ten = Self::new(10_i128.checked_pow(size).ok_or(AlgebraError::Overflow)?, 1)?;
        if exponent < 0 { number.over(&ten) } else { number.times(&ten) }
    }

    fn write(&self) -> String {
        self.to_string()
    }
}

impl PartialOrd for Fraction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// By value, exactly, however large the numbers are.
impl Ord for Fraction {
    fn cmp(&self, other: &Self) -> Ordering {
        let (mut a, mut b) = (*self, *other);
        // Whole parts first; where they agree, the reciprocals of the rests decide the other way round.
        let mut turned = false;
        loop {
            let whole = |x: &Self| x.numerator.div_euclid(x.denominator);
            let rest = |x: &Self| x.numerator.rem_euclid(x.denominator);
            let (ra, rb) = (rest(&a), rest(&b));
            let order = match whole(&a).cmp(&whole(&b)) {
                Ordering::Equal if ra == 0 || rb == 0 => ra.cmp(&rb),
                order => order,
            };
            if order != Ordering::Equal || ra == 0 {
                return if turned { order.reverse() } else { order };
            }
            a = Self { numerator: a.denominator, denominator: ra };
            b = Self { numerator: b.denominator, denominator: rb };
            turned = !turned;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn fraction(text: &str) -> Fraction {
        text.parse().unwrap()
    }

    #[test]
    fn texts_are_read_exactly() {
        for (text, numerator, denominator) in [
            ("0", 0, 1),
            ("-6/4", -3, 2),
            ("0.125", 1, 8),
            (".5", 1, 2),
            ("1.50e2", 150, 1),
            ("25e-2", 1, 4),
            ("1/-3", -1, 3),
            ("0e999999999999", 0, 1),
            ("1.0000000000000000000000000000000000000000000000", 1, 1),
        ] {
            assert_eq!(fraction(text), Fraction::new(numerator, denominator).unwrap(), "{text}");
        }
        for text in ["", "-", "1.2.3", "x", "1/", "1e", "1e1.5", "--1", "٣"] {
            assert!(matches!(text.parse::<Fraction>(), Err(AlgebraError::Syntax { .. })), "{text}");
        }
        assert_eq!("1/0".parse::<Fraction>(), Err(AlgebraError::DivisionByZero));
        for text in ["1e39", "1e-39", "1e999999999", "9".repeat(60).as_str()] {
            assert_eq!(text.parse::<Fraction>(), Err(AlgebraError::Overflow), "{text}");
        }
    }

    #[test]
    fn the_largest_numbers_overflow_without_panic() {
        let largest = Fraction::new(i128::MAX, 1).unwrap();
        assert_eq!(largest.plus(&largest), Err(AlgebraError::Overflow));
        assert_eq!(largest.over(&largest), Ok(Fraction::one()));
        assert_eq!(largest.negated().unwrap().minus(&Fraction::one()), Err(AlgebraError::Overflow));
        assert_eq!(Fraction::new(i128::MIN, 2), Err(AlgebraError::Overflow));
        assert!(Fraction::new(1, i128::MAX).unwrap() > Fraction::zero());
    }

    proptest! {
        #[test]
        fn is_a_field(a in -999_i128..999, b in 1_i128..999, c in -999_i128..999, d in 1_i128..999) {
            let (x, y) = (Fraction::new(a, b).unwrap(), Fraction::new(c, d).unwrap());
            prop_assert_eq!(x.plus(&y).unwrap(), Fraction::new(a * d + b * c, b * d).unwrap());
            prop_assert_eq!(x.minus(&y).unwrap().plus(&y).unwrap(), x);
            prop_assert_eq!(x.times(&y).unwrap(), Fraction::new(a * c, b * d).unwrap());
            if c != 0 {
                prop_assert_eq!(x.over(&y).unwrap().times(&y).unwrap(), x);
            }
            prop_assert_eq!(x.cmp(&y), (a * d).cmp(&(c * b)));
            prop_assert_eq!(fraction(&x.to_string()), x);
        }
    }
}
