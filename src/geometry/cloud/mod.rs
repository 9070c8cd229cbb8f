//! Clouds: points in space without any order, as scanners give them, and clouds of known surfaces to play with.
//!
//! A [`Cloud`] is checked and measured once and cheap to clone, so that a net that learns it, the surface fitted to
//! it and the picture share one. [`CloudShape`] makes clouds of surfaces, with noise, and knows how far a point is from
//! the true one.
//!
//! ```
//! use grafika::geometry::cloud::{Cloud, CloudShape};
//!
//! let cloud = Cloud::of_shape(CloudShape::Torus, 2000, 0.02, 1)?;
//! assert_eq!(cloud.points().len(), 2000);
//! assert!(cloud.points().iter().all(|point| CloudShape::Torus.distance(*point) < 0.15));
//! # Ok::<(), grafika::geometry::cloud::CloudError>(())
//! ```

mod principal;
mod shape;

pub use shape::CloudShape;

use super::point::{norm, within_limit};
use super::{BoundingBox, COORDINATE_LIMIT, Point};
use std::fmt;
use std::sync::Arc;

/// The most points of a cloud.
pub const MAX_CLOUD: usize = 10_000_000;

/// Points in space, one at least, with finite coordinates. Clones share them.
#[derive(Clone, Debug)]
pub struct Cloud {
    points: Arc<[Point<3>]>,
    bounds: BoundingBox<3>,
    centre: Point<3>,
    deviation: Point<3>,
}

impl Cloud {
    /// A cloud of these points.
    ///
    /// # Errors
    /// No point, more than [`MAX_CLOUD`], a coordinate that is not finite or larger than [`COORDINATE_LIMIT`].
    pub fn new(points: impl Into<Arc<[Point<3>]>>) -> Result<Self, CloudError> {
        let points = points.into();
        if points.len() > MAX_CLOUD {
            return Err(CloudError::TooMany { given: points.len() });
        }
        if let Some(index) = points.iter().position(|point| !within_limit(point)) {
            return Err(CloudError::Coordinate { number: index + 1 });
        }
        let bounds = BoundingBox::of_points(&points).ok_or(CloudError::Empty)?;
        let share = 1.0 / points.len() as f64;
        let mean = |of: &dyn Fn(&Point<3>) -> Point<3>| {
            points.iter().map(of).fold([0.0; 3], |sum, x| std::array::from_fn(|d| sum[d] + share * x[d]))
        };
        let centre = mean(&|point| *point);
        let variance = mean(&|point| std::array::from_fn(|d| (point[d] - centre[d]).powi(2)));
        Ok(Self { bounds, centre, deviation: variance.map(f64::sqrt), points })
    }

    /// The cloud of a shape: so many points on it, each moved by normal noise of this deviation in every coordinate (in
    /// the plane for [`CloudShape::Letter`]).
    ///
    /// # Errors
    /// As [`Cloud::new`]; noise that is not a number from 0 to 1000.
    pub fn of_shape(shape: CloudShape, points: usize, noise: f64, seed: u64) -> Result<Self, CloudError> {
        if points > MAX_CLOUD {
            return Err(CloudError::TooMany { given: points });
        }
        if !(0.0..=1000.0).contains(&noise) {
            return Err(CloudError::Noise { given: noise });
        }
        Self::new(shape.points(points, noise, seed))
    }

    /// The points in their order.
    #[must_use]
    pub fn points(&self) -> &[Point<3>] {
        &self.points
    }

    /// The box round all points.
    #[must_use]
    pub fn bounds(&self) -> BoundingBox<3> {
        self.bounds
    }

    /// The mean of the points.
    #[must_use]
    pub fn centre(&self) -> Point<3> {
        self.centre
    }

    /// The standard deviations of the coordinates.
    #[must_use]
    pub fn deviation(&self) -> Point<3> {
        self.deviation
    }

    /// The diagonal of the box, by which movements are measured.
    #[must_use]
    pub fn diagonal(&self) -> f64 {
        norm(self.bounds.size())
    }
}

/// Why points are no cloud. They are counted from 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CloudError {
    /// No points at all.
    Empty,
    /// More than [`MAX_CLOUD`].
    TooMany {
        /// How many were given.
        given: usize,
    },
    /// A coordinate that is no number within [`COORDINATE_LIMIT`].
    Coordinate {
        /// The point.
        number: usize,
    },
    /// A deviation of the noise that cannot be.
    Noise {
        /// What was given.
        given: f64,
    },
}

impl fmt::Display for CloudError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Empty => f.write_str("the cloud has no points; one at least is needed"),
            Self::TooMany { given } => {
                write!(f, "the cloud has {given} points, but {MAX_CLOUD} are allowed at most")
            }
            Self::Coordinate { number } => write!(
                f,
                "point {number} of the cloud has a coordinate that is not a number up to {COORDINATE_LIMIT:e}"
            ),
            Self::Noise { given } => write!(f, "the noise is {given}, but must be a number from 0 to 1000"),
        }
    }
}

impl std::error::Error for CloudError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cloud_is_measured_once() {
        let cloud = Cloud::new(vec![[1.0, 0.0, 2.0], [3.0, 4.0, 2.0]]).unwrap();
        assert_eq!((cloud.centre(), cloud.deviation()), ([2.0, 2.0, 2.0], [1.0, 2.0, 0.0]));
        assert!((cloud.diagonal() - 20.0_f64.sqrt()).abs() < 1e-15);
        let far = Cloud::new(vec![[1e150; 3], [-1e150; 3]]).unwrap();
        assert!(far.deviation()[0].is_finite() && far.diagonal().is_finite());
    }

    #[test]
    fn what_is_no_cloud_is_told() {
        assert_eq!(Cloud::new(Vec::new()).unwrap_err(), CloudError::Empty);
        let error = Cloud::new(vec![[0.0; 3], [0.0, f64::NAN, 0.0]]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "point 2 of the cloud has a coordinate that is not a number up to 1e150"
        );
        assert!(Cloud::of_shape(CloudShape::Ring, 10, f64::NAN, 1).is_err());
        assert!(Cloud::of_shape(CloudShape::Ring, MAX_CLOUD + 1, 0.0, 1).is_err());
    }
}
