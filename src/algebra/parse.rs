//! Formulas from text.
//!
//! A formula is made of numbers (`12`, `0.5`, `1.5e-3`), variables, `+ - * / ^` and parentheses. The sign `-`
//! before a power belongs to the whole power: -x^2 is -(x^2). Exponents are whole numbers.

use super::AlgebraError;
use super::polynomial::Polynomial;
use super::rational::Rational;
use super::ring::{Additive, Number};
use super::variable::{MAX_NAME, Variable, begins, continues};
use super::work::Work;
use std::str::FromStr;

/// The longest text that is read as a formula, in characters.
pub const MAX_TEXT: usize = 1 << 16;

/// How many parentheses may be open at once.
pub const MAX_DEPTH: usize = 64;

/// Reads a formula. Errors of [`FromStr::from_str`]: [`AlgebraError::Syntax`], [`AlgebraError::Part`],
/// [`AlgebraError::TextTooLong`] and [`AlgebraError::TooDeep`], with the place.
impl<C: Number> FromStr for Rational<C> {
    type Err = AlgebraError;

    fn from_str(text: &str) -> Result<Self, AlgebraError> {
        let mut parser = Parser::new(text)?;
        let formula = parser.sum()?;
        parser.end("an operator or the end")?;
        Ok(formula)
    }
}

/// As for [`Rational`]; [`AlgebraError::NotPolynomial`] for a formula that divides by a variable.
impl<C: Number> FromStr for Polynomial<C> {
    type Err = AlgebraError;

    fn from_str(text: &str) -> Result<Self, AlgebraError> {
        text.parse::<Rational<C>>()?.into_polynomial()
    }
}

/// Reads what variables stand for, as in `x = u^2 - 1, y = u + v`.
///
/// # Errors
/// As for a formula; [`AlgebraError::Repeated`] for a variable that is given twice.
pub fn assignments<C: Number>(text: &str) -> Result<Vec<(Variable, Rational<C>)>, AlgebraError> {
    let mut parser = Parser::new(text)?;
    let mut pairs = Vec::new();
    loop {
        let variable = parser.name()?;
        if !parser.take('=') {
            return Err(parser.unexpected("="));
        }
        pairs.push((variable, parser.sum()?));
        if !parser.take(',') {
            break;
        }
    }
    parser.end("an operator, a comma or the end")?;
    super::polynomial::assigned(&pairs)?;
    Ok(pairs)
}

/// Reads the values of variables, as in `x = 3, y = -1/2`.
///
/// # Errors
/// As for [`assignments`]; [`AlgebraError::Unbound`] for a value that depends on a variable.
pub fn values<C: Number>(text: &str) -> Result<Vec<(Variable, C)>, AlgebraError> {
    let constant = |(variable, value): (Variable, Rational<C>)| {
        let unbound = || {
            let mut names = value.numerator().variables();
            names.extend(value.denominator().variables());
            let variable = names.first().unwrap_or(&variable).name().to_string();
            AlgebraError::Unbound { variable }
        };
        Ok((variable.clone(), value.as_constant().ok_or_else(unbound)?))
    };
    assignments(text)?.into_iter().map(constant).collect()
}

/// A place in a text.
struct Parser {
    text: Vec<char>,
    /// The index of the next character.
    next: usize,
    /// The number of open parentheses.
    depth: usize,
    /// What may still be computed.
    work: Work,
}

impl Parser {
    fn new(text: &str) -> Result<Self, AlgebraError> {
        let given = text.chars().count();
        if given > MAX_TEXT {
            return Err(AlgebraError::TextTooLong { given, most: MAX_TEXT });
        }
        Ok(Self { text: text.chars().collect(), next: 0, depth: 0, work: Work::new() })
    }

    /// The next character that is no space.
    fn peek(&mut self) -> Option<char> {
        while self.text.get(self.next).is_some_and(|c| c.is_whitespace()) {
            self.next += 1;
        }
        self.text.get(self.next).copied()
    }

    /// Passes the next character, if it is this one.
    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        self.next += usize::from(found);
        found
    }

    /// Passes as many characters as fit.
    fn run(&mut self, fits: impl Fn(char) -> bool) -> String {
        let run: String = self.text.iter().skip(self.next).take_while(|c| fits(**c)).collect();
        self.next += run.chars().count();
        run
    }

    fn unexpected(&mut self, wanted: &'static str) -> AlgebraError {
        let found = match self.peek() {
            Some(c) => format!("{c:?}"),
            None => "the end of the formula".to_string(),
        };
        AlgebraError::Syntax { at: self.next + 1, found, wanted }
    }

    fn end(&mut self, wanted: &'static str) -> Result<(), AlgebraError> {
        if self.peek().is_none() { Ok(()) } else { Err(self.unexpected(wanted)) }
    }

    /// The sign of what follows, of any number of signs; true is minus.
    fn sign(&mut self) -> bool {
        let mut negative = false;
        loop {
            if self.take('-') {
                negative = !negative;
            } else if !self.take('+') {
                return negative;
            }
        }
    }

    fn sum<C: Number>(&mut self) -> Result<Rational<C>, AlgebraError> {
        let mut sum = self.product()?;
        loop {
            let at = self.next;
            let negative = match self.peek() {
                Some('+') => false,
                Some('-') => true,
                _ => return Ok(sum),
            };
            self.next += 1;
            let term: Rational<C> = self.product()?;
            let term = if negative { term.negated() } else { Ok(term) };
            sum = term.and_then(|term| sum.plus_within(&term, &self.work)).map_err(part(at))?;
        }
    }

    fn product<C: Number>(&mut self) -> Result<Rational<C>, AlgebraError> {
        let mut product: Rational<C> = self.power()?;
        loop {
            let at = self.next;
            let divided = match self.peek() {
                Some('*') => false,
                Some('/') => true,
                _ => return Ok(product),
            };
            self.next += 1;
            let factor = self.power()?;
            let next = match divided {
                false => product.times_within(&factor, &self.work),
                true => product.over_within(&factor, &self.work),
            };
            product = next.map_err(part(at))?;
        }
    }

    fn power<C: Number>(&mut self) -> Result<Rational<C>, AlgebraError> {
        let negative = self.sign();
        let mut power: Rational<C> = self.atom()?;
        let at = self.next;
        if self.take('^') {
            let exponent = self.exponent()?;
            power = power.signed_power_within(exponent, &self.work).map_err(part(at))?;
            if self.peek() == Some('^') {
                return Err(self.unexpected("a parenthesis round one of the powers"));
            }
        }
        if negative { power.negated() } else { Ok(power) }
    }

    /// A whole number with or without sign and parentheses.
    fn exponent(&mut self) -> Result<i64, AlgebraError> {
        const WANTED: &str = "a whole number as exponent";
        let parenthesis = self.take('(');
        let negative = self.sign();
        self.peek();
        let at = self.next;
        let digits = self.run(|c| c.is_ascii_digit());
        if digits.is_empty() || matches!(self.text.get(self.next), Some(c) if *c == '.' || continues(*c)) {
            return Err(self.unexpected(WANTED));
        }
        if parenthesis && !self.take(')') {
            return Err(self.unexpected(")"));
        }
        // What u32 does not hold is refused as too large by the power.
        let size = digits.parse::<u32>().map_err(|_| part(at)(AlgebraError::TooLarge))?;
        Ok(if negative { -i64::from(size) } else { i64::from(size) })
    }

    fn atom<C: Number>(&mut self) -> Result<Rational<C>, AlgebraError> {
        match self.peek() {
            Some('(') => {
                let at = self.next + 1;
                if self.depth == MAX_DEPTH {
                    return Err(AlgebraError::TooDeep { at, most: MAX_DEPTH });
                }
                self.next += 1;
                self.depth += 1;
                let inner = self.sum()?;
                self.depth -= 1;
                if self.take(')') { Ok(inner) } else { Err(self.unexpected("an operator or )")) }
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if begins(c) => Ok(Polynomial::variable(&self.name()?).into()),
            _ => Err(self.unexpected("a number, a variable or (")),
        }
    }

    fn name(&mut self) -> Result<Variable, AlgebraError> {
        if !self.peek().is_some_and(begins) {
            return Err(self.unexpected("the name of a variable"));
        }
        let at = self.next;
        let name = self.run(continues);
        if name.chars().count() > MAX_NAME {
            Variable::new(&name).map_err(part(at))
        } else {
            Variable::new(&name)
        }
    }

    fn number<C: Number>(&mut self) -> Result<Rational<C>, AlgebraError> {
        let at = self.next;
        let digits = |parser: &mut Self| parser.run(|c| c.is_ascii_digit());
        let mut text = digits(self);
        if self.text.get(self.next) == Some(&'.') {
            self.next += 1;
            text.push('.');
            text += &digits(self);
        }
        text += &self.power_of_ten();
        if text == "." {
            return Err(AlgebraError::Syntax { at: at + 1, found: "'.'".to_string(), wanted: "a number" });
        }
        if self.text.get(self.next).is_some_and(|c| continues(*c) || *c == '.') {
            return Err(self.unexpected("an operator, such as *,"));
        }
        let number = C::read(&text).map_err(part(at))?;
        Ok(Polynomial::constant(number).into())
    }

    /// `e` with an exponent; nothing where no digits follow.
    fn power_of_ten(&mut self) -> String {
        let rest = self.text.get(self.next..).unwrap_or_default();
        let sign = matches!(rest.get(1), Some('+' | '-'));
        let digit = rest.get(if sign { 2 } else { 1 });
        if !matches!(rest.first(), Some('e' | 'E')) || !digit.is_some_and(char::is_ascii_digit) {
            return String::new();
        }
        let start = self.next;
        self.next += if sign { 2 } else { 1 };
        let digits = self.run(|c| c.is_ascii_digit());
        let head = self.text.iter().skip(start).take(if sign { 2 } else { 1 });
        head.collect::<String>() + &digits
    }
}

/// The error of a part that begins at a character counted from 0.
fn part(at: usize) -> impl Fn(AlgebraError) -> AlgebraError {
    move |problem| AlgebraError::Part { at: at + 1, problem: Box::new(problem) }
}

#[cfg(test)]
mod tests;
