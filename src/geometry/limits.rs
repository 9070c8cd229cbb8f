//! How large numbers and lists may be.

/// The largest coordinate accepted and produced. Products of two derivatives of such curves are
/// still finite doubles, so nothing computed from an accepted curve overflows.
pub const COORDINATE_LIMIT: f64 = 1e150;

/// The largest number of control points of one curve.
pub const MAX_POINTS: usize = 1 << 20;

/// The largest number of samples of one curve.
pub const MAX_SAMPLES: usize = 1 << 24;
