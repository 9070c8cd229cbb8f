//! Axis-parallel boxes.

use super::Point;

/// The smallest axis-parallel box round something: `min[d] <= max[d]` for every coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundingBox<const D: usize> {
    /// The smallest coordinates.
    pub min: Point<D>,
    /// The largest coordinates.
    pub max: Point<D>,
}

impl<const D: usize> BoundingBox<D> {
    /// The box of one point.
    #[must_use]
    pub fn of_point(p: Point<D>) -> Self {
        Self { min: p, max: p }
    }

    /// The box of several points, `None` for none.
    #[must_use]
    pub fn of_points(points: &[Point<D>]) -> Option<Self> {
        points.iter().map(|&p| Self::of_point(p)).reduce(Self::union)
    }

    /// The box round both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: std::array::from_fn(|d| self.min[d].min(other.min[d])),
            max: std::array::from_fn(|d| self.max[d].max(other.max[d])),
        }
    }

    /// Whether the point lies in the box, borders included.
    #[must_use]
    pub fn contains(&self, p: Point<D>) -> bool {
        (0..D).all(|d| self.min[d] <= p[d] && p[d] <= self.max[d])
    }

    /// The extents along each coordinate.
    #[must_use]
    pub fn size(&self) -> Point<D> {
        std::array::from_fn(|d| self.max[d] - self.min[d])
    }
}
