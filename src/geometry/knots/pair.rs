//! Through a point by the envelope of one knot and a pair of its neighbours (after Tornai 2004; Juhász-Hoffmann 2003).

use super::through::{check_cubic, solved, within};
use super::{KnotCurve, KnotError, KnotVector, Through, Unreached};
use crate::geometry::Point;

/// Which two of the knots beside `u_i` move; `u_i` itself goes to the parameter of the point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pair {
    /// `u_{i-2}` and `u_{i+2}`.
    Outer,
    /// `u_{i-2}` and `u_{i-1}`.
    Left,
    /// `u_{i+1}` and `u_{i+2}`.
    Right,
    /// `u_{i-2}` and `u_{i+1}`.
    LeftCross,
    /// `u_{i-1}` and `u_{i+2}`.
    RightCross,
    /// `u_{i-1}` and `u_{i+1}`.
    Inner,
}

impl Pair {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Outer, Self::Left, Self::Right, Self::LeftCross, Self::RightCross, Self::Inner];

    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Outer => "outer",
            Self::Left => "left",
            Self::Right => "right",
            Self::LeftCross => "left-cross",
            Self::RightCross => "right-cross",
            Self::Inner => "inner",
        }
    }
}

/// The distances of `u_{i-2}`, `u_{i-1}`, `u_{i+1}`, `u_{i+2}` from `t`.
#[derive(Clone, Copy)]
struct Distances {
    far_left: f64,
    left: f64,
    right: f64,
    far_right: f64,
}

/// The positive root of `(1 - q) x^2 - q (s + r) x - q s r`, for 0 < q < 1.
fn root(q: f64, s: f64, r: f64) -> f64 {
    let sum = q * (s + r);
    (sum + (sum * sum + 4.0 * (1.0 - q) * q * s * r).sqrt()) / (2.0 * (1.0 - q))
}

impl Distances {
    /// The distances for which the envelope has the barycentric coordinates `a`, `c` at `t`; `None` without any.
    fn solved(mut self, pair: Pair, a: f64, c: f64) -> Option<Self> {
        match pair {
            Pair::Outer => {}
            Pair::Left => self.left = root(c, self.right, self.far_right),
            Pair::Right => self.right = root(a, self.left, self.far_left),
            Pair::LeftCross => {
                self.right = self.left.powi(2) / (c * (self.left + self.far_right)) - self.left;
            }
            Pair::RightCross => {
                self.left = self.right.powi(2) / (a * (self.right + self.far_left)) - self.right;
            }
            Pair::Inner => {
                // At most one root, below it the function is negative.
                let right = |left: f64| root(a, left, self.far_left);
                let over = |left: f64| left * left >= c * (left + right(left)) * (left + self.far_right);
                if !over(self.far_left) {
                    return None;
                }
                let [_, left] = (0..200).fold([0.0, self.far_left], |[low, high], _| {
                    let middle = 0.5 * (low + high);
                    if over(middle) { [low, middle] } else { [middle, high] }
                });
                (self.left, self.right) = (left, right(left));
            }
        }
        let sum = self.left + self.right;
        if matches!(pair, Pair::Outer | Pair::Left | Pair::LeftCross) {
            self.far_left = self.right.powi(2) / (sum * a) - self.right;
        }
        if matches!(pair, Pair::Outer | Pair::Right | Pair::RightCross) {
            self.far_right = self.left.powi(2) / (sum * c) - self.left;
        }
        Some(self)
    }
}

impl KnotCurve<2> {
    /// The plane cubic through a point at `u_i = t`, the knot that is moved there, where it touches its envelope; a
    /// pair of knots beside it is moved so that the envelope runs through the point.
    ///
    /// # Errors
    /// [`KnotError::Unreached`] with the reason; a curve that is not a plane open cubic without weights; a knot
    /// without three neighbours at either side, or `t` not between the nearest.
    pub fn through_pair(
        &self,
        point: Point<2>,
        knot: usize,
        t: f64,
        pair: Pair,
    ) -> Result<Through<2>, KnotError> {
        check_cubic(self, point)?;
        let (vector, knots) = (self.vector(), self.vector().knots());
        let last = knots.len().saturating_sub(4);
        if !(3..=last).contains(&knot) {
            return Err(KnotError::Index { name: "knot", given: knot, first: 3, last });
        }
        let at = |offset: usize| knots[knot + offset - 3];
        if !(t > at(2) && t < at(4)) {
            return Err(KnotError::Outside { name: "t", value: t, range: [at(2), at(4)] });
        }
        let [domain_from, domain_to] = vector.domain();
        if t < domain_from || t > domain_to {
            return Err(KnotError::Outside { name: "t", value: t, range: [domain_from, domain_to] });
        }
        let [before, middle, after] =
            [3, 2, 1].map(|back| self.points().get(knot - back).copied().unwrap_or_default());
        let from = |p: Point<2>| [p[0] - middle[0], p[1] - middle[1]];
        let outside = Unreached::Triangle { first: knot - 3 };
        let [a, c] = solved(from(before), from(after), from(point)).ok_or(outside)?;
        if !(a > 0.0 && c > 0.0 && a + c < 1.0) {
            return Err(outside.into());
        }
        let now = Distances { far_left: t - at(1), left: t - at(2), right: at(4) - t, far_right: at(5) - t };
        let new = now.solved(pair, a, c).ok_or(Unreached::NotFound)?;
        let mut knots = knots.to_vec();
        knots[knot] = t;
        // What did not move keeps its very double.
        let moved = |old: f64, old_distance: f64, distance: f64, place: f64| {
            if old_distance == distance { old } else { place }
        };
        let near = [
            moved(at(2), now.left, new.left, t - new.left),
            moved(at(4), now.right, new.right, t + new.right),
        ];
        let far = [
            moved(at(1), now.far_left, new.far_left, t - new.far_left),
            moved(at(5), now.far_right, new.far_right, t + new.far_right),
        ];
        let far = [
            within(knot - 2, far[0], [at(0), t.min(near[0])])?,
            within(knot + 2, far[1], [t.max(near[1]), at(6)])?,
        ];
        if new.left <= 0.0 || new.left.is_nan() {
            return Err(Unreached::Knot { knot: knot - 1, value: near[0], range: [far[0], t] }.into());
        }
        if new.right <= 0.0 || new.right.is_nan() {
            return Err(Unreached::Knot { knot: knot + 1, value: near[1], range: [t, far[1]] }.into());
        }
        knots[knot - 2..=knot + 2].copy_from_slice(&[far[0], near[0], t, near[1], far[1]]);
        let curve = Self::new(KnotVector::new(4, knots)?, self.points().to_vec())?;
        if curve.point_at(t).is_none() {
            // The knots at the end of the domain have moved past the point.
            return Err(Unreached::NotFound.into());
        }
        Ok(Through { curve, u: t })
    }
}
