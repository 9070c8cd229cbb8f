//! Curves and surfaces over extended Chebyshev spaces: spaces of functions that contain polynomials, exponentials and
//! waves, and blending functions for them with all good properties of the Bernstein polynomials.
//!
//! A [`Space`] is given by the roots of a polynomial and has an [`EcBasis`] on every interval that is shorter than its
//! [`CriticalLength`]. Circles, spirals, cycloids, tori and shells are described exactly by control points, without
//! weights. After Á. Róth (arXiv 1708.04440, ACM Algorithm 992) and Carnicer, Mainar and Peña (2004); set up in
//! double-double arithmetic by power series, which keeps all digits where the formulas of the ordinary basis lose them.

mod basis;
mod critical;
mod dd;
mod error;
mod ordinary;
mod series;
mod space;
mod text;
mod transfer;

#[cfg(test)]
mod tests;

pub use basis::EcBasis;
pub use critical::CriticalLength;
pub use error::EcError;
pub use space::Space;
pub use text::{Real, Root};

/// The largest dimension of a space.
pub const MAX_DIMENSION: usize = 31;
