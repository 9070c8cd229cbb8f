//! Numbers as tables have them: with a decimal point or comma, and digits in groups of three.

use super::super::check;
use super::{Decimal, TableOptions};

/// A number in a cell, before it is known which sign its fraction has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::file) struct Number<'c> {
    cell: &'c str,
    pub(in crate::file) signs: Signs,
}

/// What the signs of a number say about the decimal sign of its table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::file) enum Signs {
    /// There is none: `12`.
    None,
    /// It is this one, for the number could not be written otherwise: `1,5`, `1.234,5`, `1.234.567`.
    Sure(Decimal),
    /// It is this one, or the sign stands between thousands: `1,234`.
    Doubtful(Decimal),
}

/// Signs between groups of three digits that are no decimal signs: blanks that do not break, thin ones,
/// apostrophes.
const GROUPING: [char; 5] = ['\u{a0}', '\u{202f}', '\u{2009}', '\'', '’'];

impl<'c> Number<'c> {
    /// The number in a cell without blanks around it.
    pub(in crate::file) fn read(cell: &'c str) -> Option<Number<'c>> {
        let (_, mantissa, exponent) = parts(cell);
        if !exponent.is_empty() && !is_exponent(exponent) {
            return None;
        }
        let signs = match mantissa.contains(GROUPING) {
            false => signs(mantissa, exponent.is_empty()),
            true => {
                let whole = mantissa.split(['.', ',']).next().unwrap_or("");
                let rest = mantissa.get(whole.len()..).unwrap_or("");
                if !in_thousands(whole.split(GROUPING)) || rest.contains(GROUPING) {
                    return None;
                }
                // With groups in front of it, a sign begins the fraction.
                match signs(&format!("0000{rest}"), true) {
                    Some(Signs::Doubtful(decimal)) => Some(Signs::Sure(decimal)),
                    sure => sure,
                }
            }
        }?;
        Some(Number { cell, signs })
    }

    /// Its value with this decimal sign; the other one stands between thousands. Infinite if it is too large.
    pub(in crate::file) fn value(self, decimal: Decimal) -> f64 {
        // Almost all numbers are as Rust writes them.
        let plain = |sign: u8| sign.is_ascii_digit() || b"+-.eE".contains(&sign);
        let value =
            self.cell.parse().ok().filter(|_| decimal == Decimal::Point && self.cell.bytes().all(plain));
        if let Some(value) = value {
            return value;
        }
        let (negative, mantissa, exponent) = parts(self.cell);
        let mut text = String::from(if negative { "-" } else { "" });
        for sign in mantissa.chars() {
            match sign {
                '0'..='9' => text.push(sign),
                _ if sign == decimal.sign() => text.push('.'),
                _ => {}
            }
        }
        if !exponent.is_empty() {
            text.push('e');
            text.extend(exponent.chars().skip(1).map(|sign| if sign == MINUS { '-' } else { sign }));
        }
        // It has been looked at in `read`: this is a number.
        text.parse().unwrap_or(f64::INFINITY)
    }
}

/// The decimal sign of the numbers in some cells: the first that is sure, else a point.
///
/// # Errors
/// The place of the first number whose comma may be the decimal sign or stand between thousands.
pub(in crate::file) fn decimal<'c, P>(cells: impl Iterator<Item = (P, &'c str)>) -> Result<Decimal, P> {
    let mut doubtful = None;
    for (place, cell) in cells {
        match Number::read(cell).map(|number| number.signs) {
            Some(Signs::Sure(decimal)) => return Ok(decimal),
            Some(Signs::Doubtful(Decimal::Comma)) => doubtful = doubtful.or(Some(place)),
            // A point is a decimal point unless something speaks against it.
            Some(Signs::Doubtful(Decimal::Point) | Signs::None) | None => {}
        }
    }
    doubtful.map_or(Ok(Decimal::Point), Err)
}

/// The number in a cell of a table with this decimal sign, which follows from the cells before it unless it is said.
///
/// # Errors
/// What is wrong with it.
pub(in crate::file) fn value(cell: &str, decimal: Decimal, said: Option<Decimal>) -> Result<f64, String> {
    let Some(number) = Number::read(cell) else {
        return Err(match cell.is_empty() {
            true => "the cell is empty; a point needs every coordinate".to_owned(),
            false => format!("\"{cell}\" is not a finite number"),
        });
    };
    match number.signs {
        Signs::Sure(other) if other != decimal => Err(match said {
            Some(said) => format!("\"{cell}\" has a decimal {other}, not a decimal {said}"),
            None => format!("\"{cell}\" has a decimal {other}, a number before it a decimal {decimal}"),
        }),
        Signs::Doubtful(other) if other != decimal && said.is_none() => Err(doubt(cell)),
        _ => match number.value(decimal) {
            value if value.is_finite() => Ok(value),
            _ => Err(format!("\"{cell}\" is not a finite number")),
        },
    }
}

/// The message about a number whose sign may be the decimal one or stand between thousands.
pub(in crate::file) fn doubt(cell: &str) -> String {
    let values = [Decimal::Point, Decimal::Comma]
        .map(|decimal| Number::read(cell).map_or(f64::NAN, |number| number.value(decimal)));
    let [small, large] = match values {
        [a, b] if a.abs() <= b.abs() => [a, b],
        [a, b] => [b, a],
    };
    let option = TableOptions::DECIMAL;
    format!(
        "\"{cell}\" may be {} or {}; {option} point or {option} comma decides",
        check::number(small),
        check::number(large)
    )
}

const MINUS: char = '\u{2212}';

/// Whether there is a minus, the digits, and the exponent with its letter.
fn parts(cell: &str) -> (bool, &str, &str) {
    let (negative, digits) = match cell.strip_prefix(['-', MINUS]) {
        Some(rest) => (true, rest),
        None => (false, cell.strip_prefix('+').unwrap_or(cell)),
    };
    let (mantissa, exponent) = digits.split_at(digits.find(['e', 'E', 'd', 'D']).unwrap_or(digits.len()));
    (negative, mantissa, exponent)
}

/// `e-5`, with the letter of Fortran too.
fn is_exponent(text: &str) -> bool {
    let digits = text.strip_prefix(['e', 'E', 'd', 'D']).unwrap_or(text);
    all_digits(digits.strip_prefix(['+', '-', MINUS]).unwrap_or(digits))
}

fn all_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Whether digits stand in groups of three, as in 12 345 678: two groups at least.
fn in_thousands<'t>(mut groups: impl Iterator<Item = &'t str>) -> bool {
    let first = groups.next().unwrap_or("");
    let others: Vec<&str> = groups.collect();
    all_digits(first)
        && first.len() <= 3
        && !first.starts_with('0')
        && !others.is_empty()
        && others.iter().all(|group| group.len() == 3 && all_digits(group))
}

/// What the points and commas of a mantissa say; nothing if it is no number.
fn signs(mantissa: &str, may_be_grouped: bool) -> Option<Signs> {
    let Some(last) = mantissa.rfind(['.', ',']) else {
        return all_digits(mantissa).then_some(Signs::None);
    };
    let (whole, rest) = mantissa.split_at(last);
    let (decimal, other) = match rest.starts_with('.') {
        true => (Decimal::Point, Decimal::Comma),
        false => (Decimal::Comma, Decimal::Point),
    };
    let fraction = rest.get(1..).unwrap_or("");
    match (whole.contains(decimal.sign()), whole.contains(other.sign())) {
        // Groups only: the sign between them is not the decimal one.
        (true, false) => {
            let grouped = may_be_grouped && in_thousands(mantissa.split(decimal.sign()));
            grouped.then_some(Signs::Sure(other))
        }
        (true, true) => None,
        (false, true) => {
            let grouped = in_thousands(whole.split(other.sign()));
            (grouped && all_digits(fraction)).then_some(Signs::Sure(decimal))
        }
        (false, false) => {
            let missing = |part: &str| part.is_empty() && decimal == Decimal::Point;
            // `.5` and `5.` are written with points only.
            let sound = (all_digits(whole) || missing(whole)) && (all_digits(fraction) || missing(fraction));
            if !sound || whole.len() + fraction.len() == 0 {
                return None;
            }
            let doubtful = may_be_grouped && in_thousands([whole, fraction].into_iter());
            Some(if doubtful { Signs::Doubtful(decimal) } else { Signs::Sure(decimal) })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Decimal::{Comma, Point};

    #[test]
    fn what_numbers_say_about_the_decimal_sign() {
        for (cell, signs) in [
            ("12", Some(Signs::None)),
            ("-1e-5", Some(Signs::None)),
            ("1.5", Some(Signs::Sure(Point))),
            (".5", Some(Signs::Sure(Point))),
            ("5.", Some(Signs::Sure(Point))),
            ("1,5", Some(Signs::Sure(Comma))),
            ("1.234", Some(Signs::Doubtful(Point))),
            ("1,234", Some(Signs::Doubtful(Comma))),
            ("0,234", Some(Signs::Sure(Comma))),
            ("1,234e3", Some(Signs::Sure(Comma))),
            ("1234,567", Some(Signs::Sure(Comma))),
            ("1,234,567", Some(Signs::Sure(Point))),
            ("1.234.567", Some(Signs::Sure(Comma))),
            ("1.234,5", Some(Signs::Sure(Comma))),
            ("1,234.5", Some(Signs::Sure(Point))),
            ("1\u{a0}234,567", Some(Signs::Sure(Comma))),
            ("12'345.678", Some(Signs::Sure(Point))),
            ("1\u{a0}234", Some(Signs::None)),
            (",5", None),
            ("5,", None),
            (".", None),
            ("", None),
            ("-", None),
            ("e5", None),
            ("1e", None),
            ("inf", None),
            ("NaN", None),
            ("01.02.2024", None),
            ("1,23,456", None),
            ("12:30", None),
            ("1 2", None),
            ("1\u{a0}23", None),
            ("--1", None),
        ] {
            assert_eq!(Number::read(cell).map(|number| number.signs), signs, "{cell}");
        }
    }

    #[test]
    fn values() {
        for (cell, decimal, value) in [
            ("1,234", Comma, 1.234),
            ("1,234", Point, 1234.0),
            ("1.234,5", Comma, 1234.5),
            ("\u{2212}1\u{a0}234,5e\u{2212}1", Comma, -123.45),
            ("1.5D+03", Point, 1500.0),
            ("+2.5", Point, 2.5),
            ("-0", Comma, -0.0),
            ("1e999", Point, f64::INFINITY),
        ] {
            let read = Number::read(cell).unwrap().value(decimal);
            assert_eq!(read.to_bits(), value.to_bits(), "{cell}: {read}");
        }
    }
}
