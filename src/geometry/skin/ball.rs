//! Circles and spheres.

use crate::geometry::Point;
use crate::geometry::point::{norm, scaled_difference};

/// A closed disc of the plane (`D` = 2) or ball of space (3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball<const D: usize> {
    /// The centre.
    pub center: Point<D>,
    /// The radius, in the unit of the centre.
    pub radius: f64,
}

/// A circle of the plane with its disc.
pub type Circle = Ball<2>;

/// A sphere with its ball.
pub type Sphere = Ball<3>;

impl<const D: usize> Ball<D> {
    /// The ball of a centre and a radius.
    #[must_use]
    pub fn new(center: Point<D>, radius: f64) -> Self {
        Self { center, radius }
    }

    /// The point of the surface in the direction of a unit vector.
    #[must_use]
    pub fn point(&self, normal: Point<D>) -> Point<D> {
        std::array::from_fn(|d| self.center[d] + self.radius * normal[d])
    }

    /// The distance of a point from the centre.
    #[must_use]
    pub fn distance(&self, point: Point<D>) -> f64 {
        norm(scaled_difference(1.0, self.center, point))
    }

    /// The power of a point, its squared distance from the centre less the squared radius: negative inside, and for
    /// the points of the surface 0.
    #[must_use]
    pub fn power(&self, point: Point<D>) -> f64 {
        let distance = self.distance(point);
        (distance - self.radius) * (distance + self.radius)
    }

    /// Whether a point is inside or no further outside than `tolerance`.
    pub(super) fn contains(&self, point: Point<D>, tolerance: f64) -> bool {
        self.distance(point) <= self.radius + tolerance
    }

    /// Whether a ball is inside this one as a whole.
    pub(super) fn holds(&self, other: &Self, tolerance: f64) -> bool {
        self.distance(other.center) + other.radius <= self.radius + tolerance
    }

    /// Whether two balls have a point in common.
    pub(super) fn meets(&self, other: &Self, tolerance: f64) -> bool {
        self.distance(other.center) <= self.radius + other.radius + tolerance
    }

    /// The way from one centre to the other and where on it the radical line (plane) crosses, both as distances from
    /// this centre, with the unit vector of the way; `None` for equal centres.
    pub(super) fn axis(&self, other: &Self) -> Option<Axis<D>> {
        let way = scaled_difference(1.0, self.center, other.center);
        let length = norm(way);
        let direction = way.map(|x| x / length);
        // |x - a|² - r² = |x - b|² - s² along the way from a to b.
        let radical = 0.5 * (length + (self.radius - other.radius) * ((self.radius + other.radius) / length));
        let finite = radical.is_finite() && direction.iter().all(|x| x.is_finite());
        finite.then_some(Axis { direction, length, radical })
    }
}

/// The line through the centres of two balls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis<const D: usize> {
    /// From the first centre to the second.
    pub(super) direction: Point<D>,
    /// The distance of the centres.
    pub(super) length: f64,
    /// How far from the first centre the radical line (plane) crosses.
    pub(super) radical: f64,
}
