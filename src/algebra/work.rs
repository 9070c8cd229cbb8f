//! How much may be computed at once.

use super::AlgebraError;
use std::cell::Cell;

/// The most products of terms that a product, a power, a substitution or the formula of a text may take; the
/// factors of terms count. It bounds memory to some hundred megabytes and time to a second or so.
pub const MAX_WORK: usize = 1 << 21;

/// How much of that may be spent on finding out which denominators divide their numerators.
const DIVISION: usize = 1 << 18;

/// What is left of it.
pub(super) struct Work {
    all: Cell<usize>,
    division: Cell<usize>,
}

impl Work {
    /// All of it.
    pub(super) fn new() -> Self {
        Self { all: Cell::new(MAX_WORK), division: Cell::new(DIVISION) }
    }

    /// Takes a part.
    ///
    /// # Errors
    /// [`AlgebraError::TooLarge`] when there is not so much left.
    pub(super) fn spend(&self, part: usize) -> Result<(), AlgebraError> {
        take(&self.all, part)
    }

    /// Takes a part for a step of a division that may turn out to leave a rest.
    ///
    /// # Errors
    /// [`AlgebraError::TooLarge`] when there is not so much left for divisions.
    pub(super) fn try_to_divide(&self, part: usize) -> Result<(), AlgebraError> {
        take(&self.division, part)
    }
}

fn take(left: &Cell<usize>, part: usize) -> Result<(), AlgebraError> {
    left.set(left.get().checked_sub(part).ok_or(AlgebraError::TooLarge)?);
    Ok(())
}
