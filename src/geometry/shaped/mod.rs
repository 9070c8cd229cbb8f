//! Curves with shape parameters: numbers that change a curve while its control points stay.
//!
//! A [`Family`] is a kind of curve with its parameters; with a number of control points it is a [`ShapedBasis`], with
//! the points a [`ShapedCurve`]. C- and F-Bézier curves and B-splines, generalized trigonometric Bézier curves, the
//! uniform cubic B-splines with a lambda, Han's quadratic trigonometric spline, and cyclic curves, which are Fourier
//! series by control points. [`ShapedCurve::path`] is where a point goes while a parameter moves,
//! [`ShapedCurve::through`] the parameter that brings the curve to a point, and [`interpolate`] finds the control points
//! of a curve through given ones. After M. Hoffmann's dissertation (booklet, chapter 2) and the papers named
//! at each family.
//!
//! Splines have arcs of four control points (three for Han's quadratic one) without any rule at the ends: an open one of
//! `n` points has `n - 3` (`n - 2`) arcs, a closed one as many as points.
//!
//! ```
//! use grafika::geometry::ParamCurve;
//! use grafika::geometry::shaped::{Family, ShapedCurve};
//! use std::f64::consts::PI;
//!
//! // Half an arch of the cycloid: (t - sin t, 1 - cos t).
//! let points = vec![[0.0, 0.0], [0.0, 0.0], [0.0, 2.0], [PI, 2.0]];
//! let curve = ShapedCurve::new(Family::c_bezier(PI)?, points, false)?;
//! let [x, y] = curve.eval(0, 0.5).expect("a Bézier curve has one span");
//! assert!((x - (PI / 2.0 - 1.0)).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
//! # Ok::<(), grafika::geometry::GeometryError>(())
//! ```

mod arcs;
mod basis;
mod change;
mod curve;
mod cyclic;
mod family;
mod interpolate;
mod lambda;
mod newton;
mod stumpff;
mod trig;
mod waves;

#[cfg(test)]
mod tests;

pub use basis::ShapedBasis;
pub use change::Reach;
pub use curve::ShapedCurve;
pub use cyclic::{cyclic_from_fourier, cyclic_to_fourier, elevate_cyclic, harmonic_factor};
pub use family::{Family, Parameter};
pub use interpolate::{Interpolated, interpolate};
pub use lambda::{LambdaKind, Lambdas, MAX_LAMBDA};
pub use trig::{MAX_EXPONENT, MAX_SIDE_POINTS, Phi, Trig};
pub use waves::{OMEGA, bezier_points};
