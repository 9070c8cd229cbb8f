//! Random data for the tests of this room.

use super::PhSegment;
use crate::geometry::point::scaled_difference;
use crate::geometry::{Point, norm};
use proptest::prelude::*;

/// A point within 100 of the origin in every coordinate.
pub(super) fn point() -> impl Strategy<Value = Point<2>> {
    [-100.0..100.0_f64, -100.0..100.0_f64]
}

/// The distance of two points.
pub(super) fn distance<const D: usize>(a: Point<D>, b: Point<D>) -> f64 {
    norm(scaled_difference(1.0, a, b))
}

/// A quintic with random ends, whose speed is nowhere less than a hundredth of its mean.
pub(super) fn quintic() -> impl Strategy<Value = PhSegment> {
    (point(), point(), point(), point()).prop_filter_map("a point of little speed", |(a, b, c, d)| {
        let (four, number) = PhSegment::hermite([a, b], [c, d]).ok()?;
        let segment = four.into_iter().nth(number)?;
        moving(&segment).then_some(segment)
    })
}

/// Whether the speed is nowhere less than a hundredth of its mean.
pub(super) fn moving(segment: &PhSegment) -> bool {
    let speeds = (0..=200).map(|k| segment.speed(f64::from(k) / 200.0));
    let mean = segment.speed_coefficients().iter().sum::<f64>() / segment.degree() as f64;
    speeds.fold(f64::INFINITY, f64::min) > 0.01 * mean
}

/// Points of an open row from left to right.
pub(super) fn row() -> impl Strategy<Value = Vec<Point<2>>> {
    let step = (10.0..60.0_f64, -60.0..60.0_f64);
    proptest::collection::vec(step, 2..12).prop_map(|steps| {
        let mut x = 0.0;
        let place = |(dx, y)| {
            x += dx;
            [x, y]
        };
        steps.into_iter().map(place).collect()
    })
}

/// Points round a centre, once about it to the left.
pub(super) fn ring() -> impl Strategy<Value = Vec<Point<2>>> {
    proptest::collection::vec((70.0..130.0_f64, -0.3..0.3_f64), 5..14).prop_map(|points| {
        let step = std::f64::consts::TAU / points.len() as f64;
        let place = |(i, (radius, off)): (usize, (f64, f64))| {
            let angle = (i as f64 + off) * step;
            [radius * angle.cos(), radius * angle.sin()]
        };
        points.into_iter().enumerate().map(place).collect()
    })
}

/// A similarity: turned by an angle, scaled, moved, and reflected in the x axis before all that if `mirrored`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Similarity {
    pub(super) angle: f64,
    pub(super) scale: f64,
    pub(super) shift: Point<2>,
    pub(super) mirrored: bool,
}

impl Similarity {
    pub(super) fn vector(self, [x, y]: Point<2>) -> Point<2> {
        let y = if self.mirrored { -y } else { y };
        let (sin, cos) = self.angle.sin_cos();
        [self.scale * (cos * x - sin * y), self.scale * (sin * x + cos * y)]
    }

    pub(super) fn point(self, p: Point<2>) -> Point<2> {
        let [x, y] = self.vector(p);
        [x + self.shift[0], y + self.shift[1]]
    }
}

pub(super) fn similarity() -> impl Strategy<Value = Similarity> {
    (-3.0..3.0_f64, 0.1..10.0_f64, point(), any::<bool>())
        .prop_map(|(angle, scale, shift, mirrored)| Similarity { angle, scale, shift, mirrored })
}
