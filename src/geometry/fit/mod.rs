//! From a net to a surface: the neurons as control points, and the least squares fit to a cloud.
//!
//! [`Fitted::of_net`] is the base surface of a net, a bicubic B-spline surface with the neurons as control points; of a
//! polygon it is a curve. [`Fit`] gives every point of the cloud parameters by the net, solves for the control points with
//! the least squares of the distances, corrects the parameters and solves again. Kohonen nets never reach the border of
//! a cloud and lie on the inside of bends; the fit removes both faults.
//!
//! A fit is a value that is asked to work on some more points, tells how far it is, and can be dropped at any time.
//! Between two budgets it shows what it has.
//!
//! ```
//! use grafika::geometry::cloud::{Cloud, CloudShape};
//! use grafika::geometry::fit::{ErrorClass, Fit, Fitted};
//! use grafika::geometry::kohonen::{Learning, Net, Rule, Topology};
//!
//! let cloud = Cloud::of_shape(CloudShape::Hemisphere, 2000, 0.02, 1)?;
//! let start = Net::random(&cloud, [8, 8], Topology::Open, 1)?;
//! let mut learning = Learning::new(&cloud, start, Rule::default())?;
//! while learning.advance(12_000).is_none() {}
//!
//! let mut fit = Fit::new(&cloud, learning.net(), Fit::CORRECTIONS)?;
//! let report = loop {
//!     // 5000 points, a picture, the next 5000.
//!     if let Some(report) = fit.advance(5000) {
//!         break report.clone();
//!     }
//!     assert!(fit.progress() < 1.0);
//! };
//! assert!(report.rms < 0.023 && report.largest < 0.12);
//! assert!(matches!(fit.fitted()?, Fitted::Surface(_)));
//! // The colour of the first point.
//! let class = ErrorClass::of(fit.distances()[0], report.rms);
//! assert!(class.level < ErrorClass::LEVELS);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axis;
mod chart;
mod cholesky;
mod equations;
mod error;
mod fitted;
mod frame;
mod gradients;
mod orientation;
mod report;
mod sheet;
mod step;
mod task;
#[cfg(test)]
mod tests;

pub use error::FitError;
pub use fitted::Fitted;
pub use report::{ErrorClass, Report};
pub use task::{Fit, Stage};
