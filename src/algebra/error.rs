//! What can be wrong with formulas and their numbers, in sentences.

use std::fmt;

/// Why a formula cannot be read or computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AlgebraError {
    /// A coefficient or value leaves the range of its type: 127 bits for numerators and denominators of a
    /// [`Fraction`](super::Fraction), 64 bits for `i64`, finite numbers for `f64`.
    Overflow,
    /// An exponent is larger than `u32` holds.
    Exponent {
        /// The variable that has it.
        variable: String,
    },
    /// A product, power or substitution has more than [`MAX_WORK`](super::MAX_WORK) products of terms.
    TooLarge,
    /// A number or a rational function is divided by zero.
    DivisionByZero,
    /// A variable has no value.
    Unbound {
        /// Its name.
        variable: String,
    },
    /// A variable is given two values.
    Repeated {
        /// Its name.
        variable: String,
    },
    /// A name that no variable can have.
    Name {
        /// What was given.
        given: String,
    },
    /// A rational function where only a polynomial will do.
    NotPolynomial,
    /// Text that is no formula.
    Syntax {
        /// The place of the problem in characters, from 1.
        at: usize,
        /// What stands there.
        found: String,
        /// What would be right, as the end of a sentence.
        wanted: &'static str,
    },
    /// A part of a text cannot be computed.
    Part {
        /// The place of the operator, number or name in characters, from 1.
        at: usize,
        /// What is wrong.
        problem: Box<AlgebraError>,
    },
    /// Text longer than [`MAX_TEXT`](super::MAX_TEXT) characters.
    TextTooLong {
        /// How many characters it has.
        given: usize,
        /// How many are allowed at most.
        most: usize,
    },
    /// Parentheses nested deeper than [`MAX_DEPTH`](super::MAX_DEPTH).
    TooDeep {
        /// The place of the parenthesis in characters, from 1.
        at: usize,
        /// How many may be open at once.
        most: usize,
    },
}

impl fmt::Display for AlgebraError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overflow => {
                f.write_str("a number is too large to be computed exactly; smaller ones are needed")
            }
            Self::Exponent { variable } => {
                write!(f, "the exponent of {variable} is larger than {}, the largest possible", u32::MAX)
            }
            Self::TooLarge => {
                write!(
                    f,
                    "the result has too many terms; at most {} products of terms are formed",
                    super::MAX_WORK
                )
            }
            Self::DivisionByZero => f.write_str("division by zero; the denominator must be different from 0"),
            Self::Unbound { variable } => write!(f, "the variable {variable} has no value; one is needed"),
            Self::Repeated { variable } => {
                write!(f, "the variable {variable} is given twice; it can have one value only")
            }
            Self::Name { given } => write!(
                f,
                "{given:?} is no name of a variable; a letter is needed, then letters, digits and _, at most {} in all",
                super::variable::MAX_NAME
            ),
            Self::NotPolynomial => f.write_str(
                "the formula divides by a variable; a polynomial is needed here, without such a division",
            ),
            Self::Syntax { at, found, wanted } => {
                write!(f, "character {at}: {found}, but {wanted} is needed")
            }
            Self::Part { at, problem } => write!(f, "character {at}: {problem}"),
            Self::TextTooLong { given, most } => {
                write!(f, "the formula has {given} characters, but at most {most} can be read")
            }
            Self::TooDeep { at, most } => {
                write!(
                    f,
                    "character {at}: more than {most} parentheses are open, which is the most that can be read"
                )
            }
        }
    }
}

impl std::error::Error for AlgebraError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_say_what_is_wrong_where_and_what_is_right() {
        let text = AlgebraError::Unbound { variable: "y".to_string() }.to_string();
        assert_eq!(text, "the variable y has no value; one is needed");
        let inner = Box::new(AlgebraError::DivisionByZero);
        let text = AlgebraError::Part { at: 4, problem: inner }.to_string();
        assert_eq!(text, "character 4: division by zero; the denominator must be different from 0");
        let text =
            AlgebraError::Syntax { at: 1, found: "the end".to_string(), wanted: "a number" }.to_string();
        assert_eq!(text, "character 1: the end, but a number is needed");
    }
}
