//! Which side of a surface is above it.

use super::axis::Axis;
use super::sheet::{Place, Sheet};
use crate::geometry::{Point, cross, dot};

/// 1 where distances of [`Foot`](super::sheet::Foot) are positive above the surface already, else -1.
///
/// What is closed has its outside above. An open surface has above it where its mean normal points to, taken so that
/// the normal's largest coordinate is positive: upwards, for a terrain. Open curves are run through so that the largest
/// step between their ends is positive, and have above to their left.
pub(super) fn side(axes: &[Axis; 2], sheet: &Sheet) -> f64 {
    let middles = |axis: &Axis| -> Vec<f64> {
        let spans = axis.spans();
        (0..spans).map(|span| (span as f64 + 0.5) / spans as f64).collect()
    };
    let (along, across) = (middles(&axes[0]), middles(&axes[1]));
    let places: Vec<Place> = along.iter().flat_map(|u| across.iter().map(|v| sheet.at([*u, *v]))).collect();
    let curve = axes.iter().any(Axis::is_point);
    let normal = |place: &Place| {
        if curve {
            // Turned to the left in the plane.
            let [x, y, _] = if axes[1].is_point() { place.u } else { place.v };
            return [-y, x, 0.0];
        }
        cross(place.u, place.v)
    };
    let share = 1.0 / places.len().max(1) as f64;
    let mean = |of: &dyn Fn(&Place) -> Point<3>| {
        places.iter().map(of).fold([0.0; 3], |sum, x| std::array::from_fn(|d| sum[d] + share * x[d]))
    };
    let centre = mean(&|place| place.point);
    let outwards: f64 = places
        .iter()
        .map(|place| dot(normal(place), std::array::from_fn(|d| place.point[d] - centre[d])))
        .sum();
    let closed = axes.iter().any(Axis::closed);
    let sum = mean(&normal);
    let largest =
        |v: Point<3>| v.into_iter().fold(0.0_f64, |most, x| if x.abs() > most.abs() { x } else { most });
    let sign = if closed {
        outwards
    } else if curve {
        // The left of a way to the right is above.
        largest([sum[1], -sum[0], 0.0])
    } else {
        largest(sum)
    };
    if sign < 0.0 { -1.0 } else { 1.0 }
}
