//! Axis-parallel boxes.

use super::Point;

/// Points nearer to each other than this part of the extent are one but for rounding.
const ROUNDING: f64 = 1e-12;
/// The same in units of the last bit of the largest coordinate: far from the origin doubles keep no more.
const LAST_BITS: f64 = 16.0;
/// However far away something lies, points farther from each other than this part of its extent are two.
const APART: f64 = 1e-3;

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
        Self::around(points.iter().copied())
    }

    /// The box of any points, `None` for none.
    #[must_use]
    pub fn around(points: impl IntoIterator<Item = Point<D>>) -> Option<Self> {
        points.into_iter().map(Self::of_point).reduce(Self::union)
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

    /// The largest of the extents.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.size().into_iter().fold(0.0, f64::max)
    }

    /// The largest coordinate, without its sign.
    #[must_use]
    pub fn largest_coordinate(&self) -> f64 {
        self.min.iter().chain(&self.max).fold(0.0, |largest, x| largest.max(x.abs()))
    }

    /// What calculations lose with coordinates of this box: some last bits of the largest.
    #[must_use]
    pub fn last_bits(&self) -> f64 {
        LAST_BITS * f64::EPSILON * self.largest_coordinate()
    }

    /// The distance up to which two points of what fills the box are one but for rounding: 1e-12 of its extent,
    /// and far from the origin the last bits of its coordinates. Never more than a thousandth of the extent, so
    /// that nothing is closed or joined because it lies far away.
    #[must_use]
    pub fn rounding(&self) -> f64 {
        let extent = self.extent();
        (ROUNDING * extent).max(self.last_bits()).min(APART * extent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_goes_by_the_extent_wherever_the_box_is() {
        let at = |x: f64| BoundingBox { min: [x, 0.0], max: [x + 2.0, 1.0] };
        assert_eq!(at(0.0).rounding(), 2e-12);
        assert!((at(1e9).rounding() / 3.55e-6 - 1.0).abs() < 0.01);
        assert_eq!(at(1e15).rounding(), 2e-3);
        assert_eq!(BoundingBox::of_point([1e15, 1.0]).rounding(), 0.0);
    }
}
