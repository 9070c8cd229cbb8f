//! Arcs of the skin between two touching points.

use super::Ball;
use super::ball::Axis;
use crate::geometry::point::{add_scaled, norm, scaled_difference, within_limit};
use crate::geometry::{CubicBezier, Point, dot};

/// A cubic arc by Hermite's data: a point of the skin on each of two circles (spheres), and the tangents there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hermite<const D: usize> {
    /// Where the arc begins and ends.
    pub(super) points: [Point<D>; 2],
    /// The derivatives there, in the direction of the arc.
    pub(super) tangents: [Point<D>; 2],
}

/// A touching point and the unit vector in which the skin passes it.
pub(super) type End<const D: usize> = (Point<D>, Point<D>);

/// The share of the distance from the radical line in the length of a tangent: with it the arc between equal circles
/// is a segment of constant speed.
const SHARE: f64 = 2.0;

impl<const D: usize> Hermite<D> {
    /// The arc from one touching point to another; the lengths of the tangents are twice the distances from the radical
    /// line (plane), or the length of the chord where concentric circles have none.
    pub(super) fn between(balls: [&Ball<D>; 2], ends: [End<D>; 2]) -> Self {
        let points = ends.map(|(point, _)| point);
        let axis = balls[0].axis(balls[1]);
        let chord = norm(scaled_difference(1.0, points[0], points[1]));
        let tangents = ends.map(|(point, direction)| {
            let length =
                axis.as_ref().map_or(chord, |axis| SHARE * radical_distance(balls[0], axis, point).abs());
            direction.map(|x| length * x)
        });
        Self { points, tangents }
    }

    /// The arc with its tangents scaled by two factors.
    pub(super) fn scaled(&self, [first, last]: [f64; 2]) -> CubicBezier<D> {
        let ([p, q], [m, n]) = (self.points, self.tangents);
        CubicBezier { p: [p, add_scaled(p, first / 3.0, m), add_scaled(q, -last / 3.0, n), q] }
    }

    /// Whether the arc can be drawn: its numbers keep within the limit of all arcs, with the largest factors too.
    pub(super) fn is_drawn(&self) -> bool {
        self.scaled([2.0; 2]).p.iter().all(within_limit)
    }
}

/// The signed distance of a point from the radical line (plane) across the axis that begins at a ball.
pub(super) fn radical_distance<const D: usize>(ball: &Ball<D>, axis: &Axis<D>, point: Point<D>) -> f64 {
    dot(scaled_difference(1.0, ball.center, point), axis.direction) - axis.radical
}
