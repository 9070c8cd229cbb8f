//! Frames that turn as little as possible.

use super::space::SpacePhSegment;
use crate::geometry::{Point, dot};

/// The frame with the vectors across turned about the first one: `cos e_2 + sin e_3`, `-sin e_2 + cos e_3`.
pub(super) fn turned([tangent, second, third]: [Point<3>; 3], angle: f64) -> [Point<3>; 3] {
    let (sin, cos) = angle.sin_cos();
    let mix = |a: f64, b: f64| std::array::from_fn(|d| a * second[d] + b * third[d]);
    [tangent, mix(cos, sin), mix(-sin, cos)]
}

/// The angle from the Euler-Rodrigues frame to the rotation-minimising one at the start of every segment, such that
/// the latter goes on over joints: zero at the first, then what its second vector has at the end of the segment before.
pub(super) fn start_angles(segments: &[SpacePhSegment]) -> Vec<f64> {
    let mut angles = Vec::with_capacity(segments.len());
    let mut carried: Option<Point<3>> = None;
    for segment in segments {
        let angle = match (carried, segment.frame(0.0)) {
            (Some(vector), Some([_, second, third])) => dot(vector, third).atan2(dot(vector, second)),
            _ => 0.0,
        };
        angles.push(angle);
        carried = segment.frame(1.0).map(|frame| turned(frame, angle - segment.twisted(1.0))[1]);
    }
    angles
}
