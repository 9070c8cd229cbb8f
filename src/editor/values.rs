//! The parameters of curves and surfaces: the values they may have, and how a potentiometer turns them.

use std::ops::RangeInclusive;

/// The values of a parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Values {
    /// The least and the largest value.
    pub(crate) allowed: [f64; 2],
    /// The ends of a potentiometer's track.
    pub(crate) track: [f64; 2],
    /// What a step of the wheel changes.
    pub(crate) step: f64,
}

/// The coefficient of the tangents of curves.
pub(crate) const K0: Values = Values { allowed: [-10.0, 10.0], track: [-1.0, 3.0], step: 0.1 };
/// That of surfaces.
pub(crate) const SURFACE_K0: Values = Values { allowed: [0.0, 1.0], track: [0.0, 1.0], step: 0.05 };
/// The bias of beta-splines.
pub(crate) const BIAS: Values = Values { allowed: [0.05, 20.0], track: [0.05, 8.0], step: 0.1 };
/// The tension of beta-splines: everything that four characters can express.
pub(crate) const TENSION: Values = Values { allowed: [f64::MIN, f64::MAX], track: [-20.0, 20.0], step: 0.5 };

impl Values {
    /// The values as a range.
    pub(crate) const fn range(&self) -> RangeInclusive<f64> {
        self.allowed[0]..=self.allowed[1]
    }
}
