//! What can be wrong with a net and a cloud that are to become a surface, in sentences.

use crate::geometry::knots::KnotError;
use std::fmt;

/// Why there is no such surface or curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FitError {
    /// A net that is too small to be a net of control points.
    Net {
        /// Rows and columns.
        given: [usize; 2],
    },
    /// Fewer points than control points to be found.
    TooFewPoints {
        /// How many points there are.
        given: usize,
        /// How many are needed at least.
        needed: usize,
    },
    /// Control points too far away.
    Knots(KnotError),
}

impl From<KnotError> for FitError {
    fn from(error: KnotError) -> Self {
        Self::Knots(error)
    }
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Net { given: [rows, columns] } => write!(
                f,
                "a net of {rows} x {columns} neurons makes no cubic surface; at least 4 rows and 4 columns are \
                 needed, or one of them for a curve"
            ),
            Self::TooFewPoints { given, needed } => write!(
                f,
                "the cloud has {given} points, but {needed} control points can only be found from as many or more; \
                 take a smaller net"
            ),
            Self::Knots(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for FitError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Knots(error) => Some(error),
            _ => None,
        }
    }
}
