//! Touching points: where circles of Apollonius, which touch three neighbours, touch the middle one.

use super::Circle;
use crate::geometry::{cross, dot};

/// A point where the skin touches a circle, and the circle that touches this one and its neighbours from the same side
/// there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Contact {
    /// The unit normal of the circle.
    pub(super) normal: [f64; 2],
    /// 1 / (2 (R + r)) with R the radius of the touching circle and r that of the circle; 0 where it is a line.
    pub(super) bend: f64,
}

/// Normals of the rows with a smaller sine between them belong to no certain line of solutions.
const DEPENDENT: f64 = 1e-12;

/// The left and the right touching point of the middle one of three circles, walking from the first to the last;
/// `None` where there is none at which all three are touched from the same side.
pub(super) fn contacts(before: &Circle, here: &Circle, behind: &Circle) -> [Option<Contact>; 2] {
    pair(before, here, behind).map_or([None, None], |pair| {
        pair.map(|contact| {
            let ratio = |other: &Circle| contact.ratio(here, other);
            let finite = contact.bend.is_finite() && contact.normal.iter().all(|x| x.is_finite());
            (finite && ratio(before) > 0.0 && ratio(behind) > 0.0).then_some(contact)
        })
    })
}

/// Both solutions of |X - C_q| = |R + r_q| for the three circles. With the normal N and s = 1 / (2 (R + r)) of the middle
/// one unknown, D = C - C_q and e = r_q - r, every neighbour gives a row (D, |D|² - e²) . (N, s) = e. The solutions of
/// both rows are a line along g, the product of the rows; N is where it crosses the unit circle.
fn pair(before: &Circle, here: &Circle, behind: &Circle) -> Option<[Contact; 2]> {
    let unit = here.distance(before.center).max(here.distance(behind.center));
    let row = |other: &Circle| {
        let [x, y]: [f64; 2] = std::array::from_fn(|d| (here.center[d] - other.center[d]) / unit);
        let e = (other.radius - here.radius) / unit;
        let distance = x.hypot(y);
        let row = [x, y, (distance - e) * (distance + e)];
        let length = dot(row, row).sqrt();
        (row.map(|x| x / length), e / length)
    };
    let ((a, e), (b, f)) = (row(before), row(behind));
    let g = cross(a, b);
    let (whole, flat) = (dot(g, g), g[0].hypot(g[1]));
    // Not smaller, so that a NaN is refused too.
    if !(whole > DEPENDENT * DEPENDENT && flat > DEPENDENT * whole.sqrt()) {
        return None;
    }
    let along = [g[0] / flat, g[1] / flat];
    // The distance of the line from the origin in the plane of N: of p x g = f a - e b for every point p of it.
    let off = (f * a[2] - e * b[2]) / flat;
    let half = ((1.0 - off) * (1.0 + off)).sqrt();
    if half.is_nan() {
        return None;
    }
    // A point of the line: the one nearest to the origin of space.
    let (over_a, over_b) = (cross(b, g), cross(g, a));
    let p: [f64; 3] = std::array::from_fn(|d| (e * over_a[d] + f * over_b[d]) / whole);
    Some([-half, half].map(|half| {
        let normal = [off * along[1] + half * along[0], half * along[1] - off * along[0]];
        let t = ((normal[0] - p[0]) * along[0] + (normal[1] - p[1]) * along[1]) / flat;
        Contact { normal, bend: (p[2] + t * g[2]) / unit }
    }))
}

/// The left and the right touching points of the common outer tangents of two circles, walking from the first to the
/// second: the same normals at both. `None` where one disc is in the other.
pub(super) fn tangents(first: &Circle, second: &Circle) -> Option<[Contact; 2]> {
    let axis = first.axis(second)?;
    let cosine = (first.radius - second.radius) / axis.length;
    let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
    let [x, y] = axis.direction;
    (sine > 0.0).then(|| {
        [sine, -sine]
            .map(|sine| Contact { normal: [cosine * x - sine * y, cosine * y + sine * x], bend: 0.0 })
    })
}

impl Contact {
    /// (R + r_q) / (R + r), positive where both are touched from the same side.
    fn ratio(&self, here: &Circle, other: &Circle) -> f64 {
        1.0 + 2.0 * self.bend * (other.radius - here.radius)
    }

    /// Where the same touching circle touches a neighbour.
    pub(super) fn moved(&self, here: &Circle, other: &Circle) -> Contact {
        let ratio = self.ratio(here, other);
        let [x, y]: [f64; 2] = std::array::from_fn(|d| {
            (self.normal[d] + 2.0 * self.bend * (here.center[d] - other.center[d])) / ratio
        });
        // It is a unit vector but for rounding.
        let length = x.hypot(y);
        Contact { normal: [x / length, y / length], bend: self.bend / ratio }
    }

    /// The direction in which the skin passes when the circle lies to its left, as walked with the outline.
    pub(super) fn forward(&self) -> [f64; 2] {
        [-self.normal[1], self.normal[0]]
    }
}
