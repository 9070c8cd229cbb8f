//! B-splines and NURBS by their knots, and what becomes of them when a knot moves.
//!
//! A [`KnotVector`] is a [`Basis`](super::Basis) like any other; a [`KnotCurve`] has control points and perhaps weights,
//! a [`KnotSurface`] a net. A point of the curve runs along a [`KnotPath`] while one knot moves; all curves of such a
//! family touch an [`Envelope`]; two knots moved against each other draw points along lines ([`Opposed`]). The other
//! way round, knots (and weights) are found for a curve through a given point: [`KnotCurve::through_outer`],
//! [`KnotCurve::through_pair`], [`KnotCurve::through_knot`], [`KnotCurve::through_weights`], or the least move of all,
//! [`KnotCurve::through_any`].
//!
//! Order `k` is degree + 1; knots, spans and control points are counted from 0. The theorems are M. Hoffmann's and
//! I. Juhász's ("On the knot modification of a B-spline curve", 2001; "The effect of knot modifications on the shape
//! of B-spline curves", 2001); numbers such as 2.6 are those of Hoffmann's dissertation.

mod curve;
mod degree;
mod elevate;
mod envelope;
mod error;
mod exact;
mod inflections;
mod insert;
mod limits;
mod local;
mod opposed;
mod outer;
mod pair;
mod path;
mod remove;
mod search;
mod single;
mod surface;
mod surface_through;
#[cfg(test)]
mod tests;
mod through;
mod vector;
mod weights;

pub use curve::{KnotArc, KnotCurve};
pub use degree::{DEGREES, KnotSource, bspline};
pub use envelope::Envelope;
pub use error::{KnotError, Unreached};
pub use limits::Limits;
pub use opposed::Opposed;
pub use pair::Pair;
pub use path::{KnotPath, Straight};
pub use search::Way;
pub use surface::KnotSurface;
pub use through::Through;
pub use vector::KnotVector;

/// The smallest order: polygons.
pub const MIN_ORDER: usize = 2;
/// The largest order.
pub const MAX_ORDER: usize = 8;
