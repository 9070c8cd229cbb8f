//! The unit in which everything is computed: the cloud about 1 wide, round its middle.

use crate::geometry::{BoundingBox, Point};

/// A middle and a power of two, so that scaling loses no digit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    middle: Point<3>,
    scale: f64,
}

impl Frame {
    pub(super) fn new(bounds: BoundingBox<3>) -> Self {
        let middle = std::array::from_fn(|d| 0.5 * bounds.min[d] + 0.5 * bounds.max[d]);
        let extent = bounds.extent();
        // The exponent of a double; the smallest ones have none, and nothing may overflow.
        let exponent = ((extent.to_bits() >> 52) & 0x7FF) as i32 - 1023;
        let scale = if extent > 0.0 { 2.0_f64.powi(-exponent.clamp(-900, 900)) } else { 1.0 };
        Self { middle, scale }
    }

    /// A point of the data in this unit.
    #[inline]
    pub(super) fn inside(&self, point: Point<3>) -> Point<3> {
        std::array::from_fn(|d| (point[d] - self.middle[d]) * self.scale)
    }

    /// Back in the unit of the data.
    pub(super) fn outside(&self, point: Point<3>) -> Point<3> {
        std::array::from_fn(|d| point[d] / self.scale + self.middle[d])
    }

    /// A distance in the unit of the data.
    pub(super) fn length(&self, length: f64) -> f64 {
        length / self.scale
    }
}
