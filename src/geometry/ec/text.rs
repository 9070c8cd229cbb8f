//! Numbers and roots as people type them: `pi/2`, `-3/10+(sqrt(2))*i`, `0^3,i^2,2i`.

use super::EcError;
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::str::FromStr;

/// A number, with the expression that it was given by.
///
/// Two are equal if their values are: `1/2` is `0.5`.
///
/// ```
/// use grafika::geometry::ec::Real;
///
/// let quarter: Real = "pi/2".parse()?;
/// assert_eq!((quarter.value(), quarter.to_string().as_str()), (std::f64::consts::FRAC_PI_2, "pi/2"));
/// assert!("1/0".parse::<Real>().is_err());
/// # Ok::<(), grafika::geometry::ec::EcError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Real {
    value: f64,
    text: Option<Box<str>>,
}

impl Real {
    /// The value: a finite number where it came from a text.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.value
    }

    /// The expression, if there is one.
    #[must_use]
    pub fn text(&self) -> Option<&str> {
        self.text.as_deref()
    }

    /// What somebody typed: an expression stays as it is, a plain number is just the number.
    ///
    /// # Errors
    /// As [`Real::from_str`].
    pub fn typed(text: &str) -> Result<Self, EcError> {
        let real: Self = text.parse()?;
        Ok(if text.trim().parse::<f64>().is_ok() { Self::from(real.value) } else { real })
    }

    /// Its absolute value.
    pub(super) fn abs(self) -> Self {
        if self.value < 0.0 { Self::from(-self.value) } else { self }
    }
}

impl From<f64> for Real {
    fn from(value: f64) -> Self {
        Self { value, text: None }
    }
}

impl PartialEq for Real {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl FromStr for Real {
    type Err = EcError;

    /// The value of an expression of numbers, `+ - * / ( )`, `pi`, `e` and `sqrt(…)`, in double precision.
    fn from_str(text: &str) -> Result<Self, EcError> {
        let mut reader = Reader::new(text);
        let value = reader.sum()?;
        reader.end()?;
        if value.im != 0.0 || reader.unit {
            return Err(reader.wrong("a real number is needed here"));
        }
        Ok(Self { value: reader.finite(value.re)?, text: Some(text.trim().into()) })
    }
}

impl fmt::Display for Real {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.text {
            Some(text) => f.write_str(text),
            None => self.value.fmt(f),
        }
    }
}

impl Serialize for Real {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.text {
            Some(text) => serializer.serialize_str(text),
            None => serializer.serialize_f64(self.value),
        }
    }
}

impl<'de> Deserialize<'de> for Real {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Number;

        impl Visitor<'_> for Number {
            type Value = Real;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or an expression in quotes")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Real, E> {
                Ok(value.into())
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Real, E> {
                Ok((value as f64).into())
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Real, E> {
                Ok((value as f64).into())
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Real, E> {
                text.parse().map_err(E::custom)
            }
        }

        deserializer.deserialize_any(Number)
    }
}

/// A root of the characteristic polynomial: a real number, or `re ± im i` for the pair of both.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Root {
    /// The real part.
    pub re: Real,
    /// The imaginary part, at least 0.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub im: Real,
    /// How often the root is there, at least 1.
    #[serde(default = "once", skip_serializing_if = "is_once")]
    pub multiplicity: usize,
}

fn is_zero(number: &Real) -> bool {
    number.value == 0.0
}

fn once() -> usize {
    1
}

fn is_once(multiplicity: &usize) -> bool {
    *multiplicity == 1
}

impl Root {
    /// The root 0.
    #[must_use]
    pub fn zero(multiplicity: usize) -> Self {
        Self::of(0.0, 0.0, multiplicity)
    }

    pub(super) fn of(re: f64, im: f64, multiplicity: usize) -> Self {
        Self { re: re.into(), im: im.into(), multiplicity }
    }

    /// Whether both are the same number, or the same pair, whatever their multiplicities.
    #[must_use]
    pub fn is(&self, other: &Self) -> bool {
        self.re == other.re && self.im.value().abs() == other.im.value().abs()
    }

    /// Whether it is the root 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.re.value() == 0.0 && self.im.value() == 0.0
    }

    /// How many functions of the ordinary basis belong to it.
    #[must_use]
    pub fn dimension(&self) -> usize {
        if self.im.value() == 0.0 { self.multiplicity } else { self.multiplicity.saturating_mul(2) }
    }

    /// The root without its multiplicity, as it is typed: `0`, `1/4+i`, `2i`.
    #[must_use]
    pub fn number(&self) -> String {
        let Self { re, im, .. } = self;
        if im.value() == 0.0 {
            return re.to_string();
        }
        let factor = match im.text() {
            None if im.value() == 1.0 => String::new(),
            None => im.to_string(),
            Some(text) => format!("({text})*"),
        };
        if re.value() == 0.0 { format!("{factor}i") } else { format!("{re}+{factor}i") }
    }
}

impl FromStr for Root {
    type Err = EcError;

    /// A root with its multiplicity: `0^3`, `1/4+i`, `-1/(3*pi)-2i`. The sign of the imaginary part does not
    /// matter, and `±` or `+-` may stand before it.
    fn from_str(text: &str) -> Result<Self, EcError> {
        let mut reader = Reader::new(text);
        let root = reader.root()?;
        reader.end()?;
        Ok(root)
    }
}

impl fmt::Display for Root {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.number())?;
        if self.multiplicity == 1 { Ok(()) } else { write!(f, "^{}", self.multiplicity) }
    }
}

/// The roots in a list with commas.
///
/// # Errors
/// [`EcError::Syntax`] and [`EcError::NoNumber`].
pub(super) fn roots(text: &str) -> Result<Vec<Root>, EcError> {
    let mut reader = Reader::new(text);
    let mut roots = vec![reader.root()?];
    while reader.eat(',') {
        roots.push(reader.root()?);
    }
    reader.end()?;
    Ok(roots)
}

/// The most brackets inside each other.
const DEEPEST: usize = 40;

/// A complex number while a text is read.
#[derive(Clone, Copy)]
struct Complex {
    re: f64,
    im: f64,
}

impl Complex {
    fn real(re: f64) -> Self {
        Self { re, im: 0.0 }
    }
}

struct Reader<'a> {
    text: &'a str,
    /// Where reading goes on, in bytes.
    next: usize,
    depth: usize,
    /// Whether an `i` was read.
    unit: bool,
}

impl<'a> Reader<'a> {
    fn new(text: &'a str) -> Self {
        Self { text, next: 0, depth: 0, unit: false }
    }

    fn rest(&self) -> &'a str {
        self.text.get(self.next..).unwrap_or_default()
    }

    /// Skips blanks and says what comes.
    fn peek(&mut self) -> Option<char> {
        self.next = self.text.len() - self.rest().trim_start().len();
        self.rest().chars().next()
    }

    fn eat(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        self.next += if found { wanted.len_utf8() } else { 0 };
        found
    }

    fn eat_word(&mut self, word: &str) -> bool {
        self.peek();
        let found = self.rest().get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word));
        self.next += if found { word.len() } else { 0 };
        found
    }

    fn wrong(&self, problem: &'static str) -> EcError {
        let before = self.text.get(..self.next).unwrap_or_default();
        EcError::Syntax { text: self.text.to_owned(), at: before.chars().count() + 1, problem }
    }

    fn finite(&self, value: f64) -> Result<f64, EcError> {
        let problem = "is not a finite number";
        // The negative zero is zero.
        let value = value + 0.0;
        value.is_finite().then_some(value).ok_or(EcError::NoNumber { text: self.text.to_owned(), problem })
    }

    fn end(&mut self) -> Result<(), EcError> {
        match self.peek() {
            None => Ok(()),
            Some(',') => Err(self.wrong("one is enough here, without a comma")),
            Some('^') => Err(self.wrong("there are no powers; ^ is the multiplicity of a root")),
            Some(_) => Err(self.wrong("an operator + - * / is needed here, or nothing more")),
        }
    }

    fn root(&mut self) -> Result<Root, EcError> {
        self.peek();
        let from = self.next;
        let value = self.sum()?;
        let [re, im] = [self.finite(value.re)?, self.finite(value.im)?];
        let typed = self.text.get(from..self.next).unwrap_or_default().trim();
        // An expression is kept where it is one of the two parts alone.
        let part = |value: f64, text: &str| match Real::typed(text) {
            Ok(real) if real.value == value => real,
            _ => Real::from(value),
        };
        let (re, im) = match typed.rsplit_once(['i', 'I']).map(|(before, _)| before) {
            Some(before) if im != 0.0 => {
                let (re, im) = parts(before, re, im.abs());
                (re, im)
            }
            _ => (part(re, typed), Real::from(im.abs())),
        };
        let mut multiplicity = 1;
        if self.eat('^') {
            self.peek();
            let digits = self.rest().bytes().take_while(u8::is_ascii_digit).count();
            let number = self.rest().get(..digits).and_then(|digits| digits.parse().ok());
            multiplicity = number
                .filter(|m| (1..=super::MAX_DIMENSION).contains(m))
                .ok_or_else(|| self.wrong("the multiplicity must be a whole number, 1 to 31"))?;
            self.next += digits;
        }
        Ok(Root { re, im, multiplicity })
    }

    fn sum(&mut self) -> Result<Complex, EcError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.wrong("too many brackets inside each other"));
        }
        let mut sum = Complex::real(0.0);
        let mut sign = if self.eat('-') { -1.0 } else { 1.0 };
        if sign > 0.0 {
            self.eat('+');
        }
        loop {
            let term = self.product()?;
            sum = Complex { re: sum.re + sign * term.re, im: sum.im + sign * term.im };
            sign = if self.eat('+') || self.eat('±') {
                // `+-` is `±`.
                self.eat('-');
                1.0
            } else if self.eat('-') {
                -1.0
            } else {
                break;
            };
        }
        self.depth -= 1;
        Ok(sum)
    }

    fn product(&mut self) -> Result<Complex, EcError> {
        let mut product = self.factor()?;
        loop {
            let by_unit = matches!(self.peek(), Some('i' | 'I'));
            if by_unit || self.eat('*') {
                let factor = self.factor()?;
                if product.im != 0.0 && factor.im != 0.0 {
                    return Err(self.wrong("i may be a factor once"));
                }
                product = match factor.im == 0.0 {
                    true => Complex { re: product.re * factor.re, im: product.im * factor.re },
                    false => Complex { re: product.re * factor.re, im: product.re * factor.im },
                };
            } else if self.eat('/') {
                let divisor = self.factor()?;
                if divisor.im != 0.0 {
                    return Err(self.wrong("only real numbers can be divided by"));
                }
                if divisor.re == 0.0 {
                    let problem = "divides by zero";
                    return Err(EcError::NoNumber { text: self.text.to_owned(), problem });
                }
                product = Complex { re: product.re / divisor.re, im: product.im / divisor.re };
            } else {
                return Ok(product);
            }
        }
    }

    fn factor(&mut self) -> Result<Complex, EcError> {
        match self.peek() {
            Some('(') => self.bracket(),
            Some('-') => {
                self.next += 1;
                self.depth += 1;
                if self.depth > DEEPEST {
                    return Err(self.wrong("too many signs"));
                }
                let Complex { re, im } = self.factor()?;
                self.depth -= 1;
                Ok(Complex { re: -re, im: -im })
            }
            Some('π') => {
                self.next += 'π'.len_utf8();
                Ok(Complex::real(std::f64::consts::PI))
            }
            Some('0'..='9' | '.') => self.digits().map(Complex::real),
            _ if self.eat_word("sqrt") => {
                let Complex { re, im } = self.bracket()?;
                if im != 0.0 || re < 0.0 {
                    let problem = "has a root of what is negative";
                    return Err(EcError::NoNumber { text: self.text.to_owned(), problem });
                }
                Ok(Complex::real(re.sqrt()))
            }
            _ if self.eat_word("pi") => Ok(Complex::real(std::f64::consts::PI)),
            _ if self.eat_word("e") => Ok(Complex::real(std::f64::consts::E)),
            _ if self.eat_word("i") => {
                self.unit = true;
                Ok(Complex { re: 0.0, im: 1.0 })
            }
            _ => Err(self.wrong("a number is needed here, as 2, 1/4, pi/2, sqrt(2) or 2i")),
        }
    }

    fn bracket(&mut self) -> Result<Complex, EcError> {
        if !self.eat('(') {
            return Err(self.wrong("a bracket ( is needed here"));
        }
        let value = self.sum()?;
        if self.eat(')') { Ok(value) } else { Err(self.wrong("a bracket ) is needed here")) }
    }

    fn digits(&mut self) -> Result<f64, EcError> {
        let bytes = self.rest().as_bytes();
        let run = |from: usize| bytes.iter().skip(from).take_while(|b| b.is_ascii_digit()).count();
        let mut length = run(0);
        if bytes.get(length) == Some(&b'.') {
            length += 1 + run(length + 1);
        }
        if matches!(bytes.get(length), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(length + 1), Some(b'+' | b'-')));
            let exponent = run(length + 1 + sign);
            length += if exponent > 0 { 1 + sign + exponent } else { 0 };
        }
        let value = self.rest().get(..length).and_then(|digits| digits.parse().ok());
        let value = value.ok_or_else(|| self.wrong("a number is needed here"))?;
        self.next += length;
        Ok(value)
    }
}

/// The expressions of both parts of a number that ends in `i`, where they can be told apart: `1/4+`, `-(pi)*`.
fn parts(before: &str, re: f64, im: f64) -> (Real, Real) {
    let factor = |text: &str| {
        let text = text.trim().trim_end_matches('*').trim_end();
        let bare = text.strip_prefix('(').and_then(|text| text.strip_suffix(')')).unwrap_or(text);
        match Real::typed(bare) {
            Ok(real) if real.value == im => real,
            _ => Real::from(im),
        }
    };
    let mut depth = 0;
    let mut sign = None;
    for (at, c) in before.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            '+' | '-' | '±' if depth == 0 && !before[..at].trim().is_empty() => {
                sign = sign.or(Some(at));
            }
            _ => {}
        }
    }
    let whole = |text: &str| match Real::typed(text.trim()) {
        Ok(real) if real.value == re => Some(real),
        _ => None,
    };
    match sign.and_then(|at| Some((whole(before.get(..at)?)?, before.get(at..)?))) {
        Some((re, rest)) => (re, factor(rest.trim_start_matches(['+', '-', '±']))),
        None => (Real::from(re), factor(before.trim_start_matches(['+', '-', '±']))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::{E, PI, SQRT_2};

    fn real(text: &str) -> f64 {
        text.parse::<Real>().unwrap().value()
    }

    fn root(text: &str) -> (f64, f64, usize) {
        let root: Root = text.parse().unwrap();
        (root.re.value(), root.im.value(), root.multiplicity)
    }

    #[test]
    fn expressions_have_their_values() {
        assert_eq!(real(" 5*pi/8 "), 5.0 * PI / 8.0);
        assert_eq!(real("-(1 + 2) * 3 / -4"), 2.25);
        assert_eq!(real("sqrt(2)*e"), SQRT_2 * E);
        assert_eq!((real("1e-3"), real(".5"), real("2.E2"), real("1*e")), (1e-3, 0.5, 200.0, E));
        assert_eq!((real("-0").to_bits(), real("1/3")), (0, 1.0 / 3.0));
    }

    #[test]
    fn roots_have_two_parts_and_a_multiplicity() {
        assert_eq!(root("0^3"), (0.0, 0.0, 3));
        assert_eq!((root("i"), root("-i^2"), root("2i")), ((0.0, 1.0, 1), (0.0, 1.0, 2), (0.0, 2.0, 1)));
        assert_eq!(
            (root("1/4+i"), root("1/4±i"), root("1/4+-i")),
            ((0.25, 1.0, 1), (0.25, 1.0, 1), (0.25, 1.0, 1))
        );
        assert_eq!(root("-3/10+(sqrt(2))*i"), (-0.3, SQRT_2, 1));
        assert_eq!(root("-1/(3*pi)-2i"), (-1.0 / (3.0 * PI), 2.0, 1));
        assert_eq!((root("1/4i"), root("pi*i")), ((0.0, 0.25, 1), (0.0, PI, 1)));
    }

    #[test]
    fn roots_are_written_as_they_were_typed() {
        for text in ["0^3", "1/4+i", "-3/10+(sqrt(2))*i", "(pi)*i^2", "-1/(3*pi)+2i", "-1.5", "2i"] {
            assert_eq!(text.parse::<Root>().unwrap().to_string(), text);
        }
        assert_eq!(roots("0, i ^ 2,2i").unwrap().len(), 3);
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        let said = |text: &str| text.parse::<Root>().unwrap_err().to_string();
        assert_eq!(
            said("1+"),
            "\"1+\", character 3: a number is needed here, as 2, 1/4, pi/2, sqrt(2) or 2i"
        );
        assert_eq!(said("1/0"), "\"1/0\" divides by zero");
        assert_eq!(said("i^32"), "\"i^32\", character 3: the multiplicity must be a whole number, 1 to 31");
        assert_eq!(said("i*i"), "\"i*i\", character 4: i may be a factor once");
        assert_eq!(said("1e999"), "\"1e999\" is not a finite number");
        assert_eq!(said("sqrt(-1)"), "\"sqrt(-1)\" has a root of what is negative");
        assert!("2i".parse::<Real>().unwrap_err().to_string().ends_with("a real number is needed here"));
        assert!(said(&"(".repeat(100_000)).ends_with("too many brackets inside each other"));
        assert!(said(&"-".repeat(100_000)).ends_with("too many signs"));
    }

    proptest! {
        #[test]
        fn no_text_does_harm(text in "[0-9eipsqrt()+*/^., ±-]{0,40}") {
            let _ = roots(&text);
            if let Ok(root) = text.parse::<Root>() {
                prop_assert_eq!(root.to_string().parse::<Root>(), Ok(root));
            }
        }

        #[test]
        fn written_roots_read_back(re in -100.0..100.0, im in 0.0..100.0, multiplicity in 1_usize..31) {
            let root = Root::of(re, im, multiplicity);
            prop_assert_eq!(root.to_string().parse::<Root>(), Ok(root));
        }
    }
}
