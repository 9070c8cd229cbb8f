//! What two patches with a common border keep at their joint (3.2): conditions on the points of every line across it.
//!
//! Bézier patches of degree m have rows 0 to m and m to 2m, row m is the border. With a = m - 1, b = m, c = m + 1 and
//! their outer neighbours z and d:
//!
//! - tangent plane: c - b = r (b - a) in every column, with one ratio r > 0;
//! - C1: the same with r = 1;
//! - C2: C1, and d - 2c + b = b - 2a + z, so that d = z + 2 (c - a).
//!
//! Hermite patches have the places P0, P1, P2 and the derivatives U0, U1 of the first patch, V1 and U2 of the second:
//! V1 = r U1, and for C2 V1 = U1 and U0 + 4 U1 + U2 = 3 (P2 - P0), which is the equation of the spline: the second
//! derivatives of (2.12) at the end and at the start are 6 P0 - 6 P1 + 2 U0 + 4 U1 and -6 P1 + 6 P2 - 4 V1 - 2 U2.

use crate::geometry::Point;
use crate::geometry::point::add_scaled;
use serde::{Deserialize, Serialize};

/// What is kept at the joint of two patches.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Joint {
    /// Nothing but the common border.
    #[default]
    C0,
    /// A common tangent plane: the derivatives across the border have one direction, and one ratio of lengths.
    Plane,
    /// The same first derivatives.
    C1,
    /// The same first and second derivatives.
    C2,
}

impl Joint {
    /// Every condition, from the weakest.
    pub const ALL: [Self; 4] = [Self::C0, Self::Plane, Self::C1, Self::C2];

    /// Its name in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::C0 => "c0",
            Self::Plane => "plane",
            Self::C1 => "c1",
            Self::C2 => "c2",
        }
    }

    /// The ratio that it has, where the user's is `ratio`.
    fn ratio(self, ratio: f64) -> f64 {
        if self == Self::Plane { ratio } else { 1.0 }
    }

    /// Keeps the condition in a column of two Bézier patches after its point `moved` went from `from` to where it is
    /// now: the border takes its neighbours along, a neighbour moves its opposite. Columns without a middle row, and
    /// other points, stay.
    pub fn keep_bezier(self, ratio: f64, column: &mut [Point<3>], moved: usize, from: Point<3>) {
        let m = column.len() / 2;
        if self == Self::C0 || column.len() < 5 || column.len().is_multiple_of(2) {
            return;
        }
        let r = self.ratio(ratio);
        let (z, a, b, c, d) = (m - 2, m - 1, m, m + 1, m + 2);
        if moved == b {
            // Bits of the sums may differ, so that the opposite is set by its rule.
            let by = add_scaled(column[b], -1.0, from);
            column[a] = add_scaled(column[a], 1.0, by);
            column[c] = beyond(column[b], r, column[a]);
        } else if moved == a {
            column[c] = beyond(column[b], r, column[a]);
        } else if moved == c {
            column[a] = beyond(column[b], 1.0 / r, column[c]);
        }
        if self != Self::C2 {
            return;
        }
        let across = add_scaled(column[c], -1.0, column[a]);
        if moved == a || moved == z {
            column[d] = add_scaled(column[z], 2.0, across);
        } else if moved == c || moved == d {
            column[z] = add_scaled(column[d], -2.0, across);
        }
    }

    /// Makes a column of two Bézier patches fulfil the condition; the second patch follows the first.
    pub fn impose_bezier(self, ratio: f64, column: &mut [Point<3>]) {
        if let Some(a) = (column.len() / 2).checked_sub(1) {
            self.keep_bezier(ratio, column, a, [0.0; 3]);
        }
    }

    /// Keeps the condition in a column P0, P1, P2, U0, U1, V1, U2 of two Hermite patches after its entry `moved`
    /// changed: derivatives at the joint follow each other; for C2 they follow places and derivatives of the outer
    /// borders, and those of the opposite border follow them.
    pub fn keep_hermite(self, ratio: f64, column: &mut [Point<3>; 7], moved: usize) {
        let r = self.ratio(ratio);
        if self == Self::C0 {
            return;
        }
        match moved {
            4 => column[5] = column[4].map(|x| r * x),
            5 => column[4] = column[5].map(|x| x / r),
            _ => {}
        }
        if self != Self::C2 {
            return;
        }
        let [p0, _, p2, u0, u1, _, u2] = *column;
        let chord = add_scaled(p2, -1.0, p0);
        let rest = |k: f64, outer: Point<3>| {
            let sum = add_scaled(outer, k, u1);
            std::array::from_fn(|axis| 3.0 * chord[axis] - sum[axis])
        };
        match moved {
            4 => column[6] = rest(4.0, u0),
            5 => column[3] = rest(4.0, u2),
            0 | 2 | 3 | 6 => {
                column[4] = std::array::from_fn(|axis| (3.0 * chord[axis] - u0[axis] - u2[axis]) / 4.0);
                column[5] = column[4];
            }
            _ => {}
        }
    }

    /// Makes a column of two Hermite patches fulfil the condition; the second patch follows the first.
    pub fn impose_hermite(self, ratio: f64, column: &mut [Point<3>; 7]) {
        self.keep_hermite(ratio, column, 4);
    }
}

/// The point beyond `border` from `near`, `ratio` times as far from it.
fn beyond(border: Point<3>, ratio: f64, near: Point<3>) -> Point<3> {
    add_scaled(border, ratio, add_scaled(border, -1.0, near))
}
