//! Parallel and central projection: how what a viewer sees comes into the plane of the picture (chapter 4.4.1).

use super::Point;

/// The part of the way to the viewer that is seen as it is. What lies nearer to him, beside or behind him is magnified
/// as a place so near.
const NEAREST: f64 = 0.9;

/// A projection onto the plane through a middle, across the direction of view.
///
/// Both kinds are one map of space, after which the viewer is far away: straight lines stay straight, and of two
/// places on a ray of sight the nearer one stays nearer. So what finds hidden parts asks nothing else.
///
/// ```
/// use grafika::geometry::Projection;
///
/// // A place half way to the viewer looks twice as large.
/// assert_eq!(Projection::central(600.0).image([10.0, 20.0, 300.0]), [20.0, 40.0, 600.0]);
/// assert_eq!(Projection::Parallel.image([10.0, 20.0, 300.0]), [10.0, 20.0, 300.0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Projection {
    /// By parallel rays: the viewer is infinitely far away.
    #[default]
    Parallel,
    /// By rays to the viewer (4.18), at a distance from the middle in the unit of the points. It is positive.
    Central(f64),
}

impl Projection {
    /// The central projection from a distance; parallel if that is no positive number.
    #[must_use]
    pub fn central(distance: f64) -> Projection {
        if distance > 0.0 && distance.is_finite() {
            Projection::Central(distance)
        } else {
            Projection::Parallel
        }
    }

    /// How much larger than in the plane of the picture things look that are so much nearer to the viewer, (4.18):
    /// above 0, at most 10.
    #[must_use]
    pub fn magnification(self, near: f64) -> f64 {
        match self {
            Projection::Parallel => 1.0,
            Projection::Central(distance) => distance / (distance - near.min(NEAREST * distance)),
        }
    }

    /// The image of a place, both to the right, up, and to the viewer from the middle. How near the image is grows
    /// linearly along straight lines of the picture.
    #[must_use]
    pub fn image(self, seen: Point<3>) -> Point<3> {
        match self {
            Projection::Parallel => seen,
            Projection::Central(_) => seen.map(|x| x * self.magnification(seen[2])),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn no_place_is_without_an_image() {
        for distance in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300, 600.0, 1e300] {
            for near in [-1e300, -600.0, 0.0, 599.0, 600.0, 601.0, 1e300] {
                let image = Projection::central(distance).image([1.0, -1.0, near]);
                assert!(image.iter().all(|x| !x.is_nan()), "{distance} {near}: {image:?}");
            }
        }
    }

    proptest! {
        /// By similar triangles: the image lies on the ray from the viewer through the place.
        #[test]
        fn images_lie_on_rays(
            place in prop::array::uniform3(-400.0..400.0f64),
            distance in 500.0..3000.0f64,
        ) {
            let [x, y, _] = Projection::central(distance).image(place);
            // The ray from (0, 0, distance) meets the plane of the picture where its third coordinate is 0.
            let way = distance / (distance - place[2]);
            prop_assert!((x - place[0] * way).abs() < 1e-9 && (y - place[1] * way).abs() < 1e-9);
        }

        #[test]
        fn straight_lines_stay_straight_and_depth_is_linear_along_them(
            ends in prop::array::uniform2(prop::array::uniform3(-400.0..400.0f64)),
            t in 0.0..1.0f64,
        ) {
            let projection = Projection::Central(600.0);
            let between: Point<3> = std::array::from_fn(|d| ends[0][d] + t * (ends[1][d] - ends[0][d]));
            let [a, b] = ends.map(|end| projection.image(end));
            let image = projection.image(between);
            let way: Point<3> = std::array::from_fn(|d| b[d] - a[d]);
            let longest = (0..3).fold(0, |m, d| if way[d].abs() > way[m].abs() { d } else { m });
            prop_assume!(way[longest].abs() > 1e-3);
            let part = (image[longest] - a[longest]) / way[longest];
            for d in 0..3 {
                prop_assert!((a[d] + part * way[d] - image[d]).abs() < 1e-7);
            }
        }

        #[test]
        fn a_far_viewer_sees_in_parallel(place in prop::array::uniform3(-400.0..400.0f64)) {
            let image = Projection::Central(1e12).image(place);
            prop_assert!(image.iter().zip(place).all(|(x, y)| (x - y).abs() < 1e-6));
        }
    }
}
