//! What can be wrong with a net and what it is to learn, in sentences.

use super::{MAX_NEURONS, MAX_SIDE, MAX_STEPS};
use crate::geometry::GeometryError;
use std::fmt;

/// Why there is no such net, or nothing to learn for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KohonenError {
    /// Too few or too many rows or columns.
    Size {
        /// Rows and columns.
        given: [usize; 2],
        /// The fewest of the topology.
        least: [usize; 2],
    },
    /// Rows of different lengths, or a bad coordinate.
    Points(GeometryError),
    /// A number of steps that is 0 or too large.
    Steps {
        /// What was given.
        given: u64,
    },
    /// A parameter outside its range.
    Parameter {
        /// Its name: `radius` or `settle`.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What would be right, as the end of a sentence.
        wanted: &'static str,
    },
    /// A limit to growth that the net exceeds already, or that is too large.
    Limit {
        /// What was given.
        given: usize,
        /// How many neurons there are at the start.
        least: usize,
    },
}

impl From<GeometryError> for KohonenError {
    fn from(error: GeometryError) -> Self {
        Self::Points(error)
    }
}

impl fmt::Display for KohonenError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Size { given: [rows, columns], least: [m, n] } => write!(
                f,
                "a net of {rows} x {columns} neurons is not possible; {m} x {n} to {MAX_SIDE} rows and columns and \
                 {MAX_NEURONS} neurons are"
            ),
            Self::Points(error) => write!(f, "{error}"),
            Self::Steps { given } => {
                write!(f, "{given} steps are not possible; 1 to {MAX_STEPS} are")
            }
            Self::Parameter { name, value, wanted } => write!(f, "{name} is {value}, but must be {wanted}"),
            Self::Limit { given, least } => write!(
                f,
                "a net cannot grow to {given} neurons; the limit must be a number from {least} to {MAX_NEURONS}"
            ),
        }
    }
}

impl std::error::Error for KohonenError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Points(error) => Some(error),
            _ => None,
        }
    }
}
