//! What can be wrong with spaces, intervals and numbers, in sentences.

use super::{MAX_DIMENSION, series};
use crate::geometry::GeometryError;
use std::fmt;

/// Why there is no such space, basis or number.
#[derive(Clone, Debug, PartialEq)]
pub enum EcError {
    /// A text is no number, root or list of roots.
    Syntax {
        /// The text.
        text: String,
        /// The character that is wrong, from 1.
        at: usize,
        /// What is wrong or would be right.
        problem: &'static str,
    },
    /// The value of an expression is not a finite number.
    NoNumber {
        /// The text.
        text: String,
        /// Why.
        problem: &'static str,
    },
    /// The root 0 is not there.
    NoZero,
    /// A root is there twice.
    Twice {
        /// The root.
        root: String,
    },
    /// A root is there no time or too often.
    Multiplicity {
        /// The root.
        root: String,
        /// What was given.
        given: usize,
    },
    /// The dimension is not 2 to [`MAX_DIMENSION`].
    Dimension {
        /// What was given.
        given: usize,
    },
    /// An interval does not start before it ends.
    Interval {
        /// Its start.
        start: f64,
        /// Its end.
        end: f64,
    },
    /// The interval is too short for doubles.
    TooShort {
        /// Its length.
        length: f64,
    },
    /// The interval is not shorter than the critical length for design.
    TooLong {
        /// Its length.
        length: f64,
        /// The critical length.
        critical: f64,
    },
    /// The roots are too large for an interval of this length.
    TooStiff {
        /// Its length.
        length: f64,
        /// The longest that is computed.
        most: f64,
    },
    /// The functions would not have enough right digits.
    Imprecise {
        /// The length of the interval.
        length: f64,
        /// The measured error of the functions.
        error: f64,
    },
    /// A parameter does not lie inside the interval.
    Outside {
        /// The parameter.
        at: f64,
        /// The interval.
        interval: [f64; 2],
    },
    /// A function of the ordinary basis that the space does not have.
    Function {
        /// Its number, from 0.
        given: usize,
        /// How many there are.
        dimension: usize,
    },
    /// The control points are wrong.
    Points(GeometryError),
}

impl fmt::Display for EcError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Syntax { text, at, problem } => write!(f, "\"{text}\", character {at}: {problem}"),
            Self::NoNumber { text, problem } => write!(f, "\"{text}\" {problem}"),
            Self::NoZero => f.write_str("the root 0 is missing; without it no basis sums to 1"),
            Self::Twice { root } => {
                write!(f, "the root {root} is there twice; raise its multiplicity instead, as in {root}^2")
            }
            Self::Multiplicity { root, given } => {
                write!(f, "the root {root} has multiplicity {given}; it must be 1 to {MAX_DIMENSION}")
            }
            Self::Dimension { given } => {
                write!(f, "the space has dimension {given}; it must be 2 to {MAX_DIMENSION}")
            }
            Self::Interval { start, end } => {
                write!(f, "the interval is [{start}, {end}]; its start must be less than its end")
            }
            Self::TooShort { length } => {
                write!(
                    f,
                    "the interval is too short: its length is {length:e}, at least {:e} is needed",
                    series::SHORTEST
                )
            }
            Self::TooLong { length, critical } => write!(
                f,
                "the interval is too long: its length is {length}, but it must be less than the critical length l' = {critical}"
            ),
            Self::TooStiff { length, most } => write!(
                f,
                "the interval is too long for the precision: its length is {length}, but with these roots it may be {most} at most"
            ),
            Self::Imprecise { length, error } => write!(
                f,
                "the interval is too long for the precision: with the length {length} the functions would be wrong by {error:.0e}; a shorter one is right"
            ),
            Self::Outside { at, interval: [start, end] } => {
                write!(f, "{at} does not lie inside the interval; it must be between {start} and {end}")
            }
            Self::Function { given, dimension } => write!(
                f,
                "there is no function {given}; the space has {dimension}, numbered 0 to {}",
                dimension.saturating_sub(1)
            ),
            Self::Points(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for EcError {}

impl From<GeometryError> for EcError {
    fn from(error: GeometryError) -> Self {
        Self::Points(error)
    }
}
