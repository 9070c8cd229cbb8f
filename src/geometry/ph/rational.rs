//! Rational Bézier curves of the plane by homogeneous control points.

use super::bernstein::{eval, split};
use crate::geometry::Point;

/// A rational Bézier curve: its homogeneous control points `[x w, y w, w]`, one more than the degree. Weights may be
/// zero or negative; they are divided by only where a point is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct RationalArc {
    points: Vec<[f64; 3]>,
}

/// How often an arc is halved at most to make its weights positive.
const HALVINGS: u32 = 24;

impl RationalArc {
    /// The curve by its homogeneous control points.
    #[must_use]
    pub fn new(points: Vec<[f64; 3]>) -> Self {
        Self { points }
    }

    /// The homogeneous control points `[x w, y w, w]`.
    #[must_use]
    pub fn homogeneous(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// The degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.points.len().saturating_sub(1)
    }

    /// The point at `u` in [0, 1]; `None` where the weight is zero.
    #[must_use]
    pub fn eval(&self, u: f64) -> Option<Point<2>> {
        let u = crate::geometry::param::clipped(u);
        let [x, y, weight] = [0, 1, 2].map(|axis| eval(&self.axis(axis), u));
        let point = [x / weight, y / weight];
        point.iter().all(|x| x.is_finite()).then_some(point)
    }

    /// The two parts before and after `u` in [0, 1].
    #[must_use]
    pub fn split(&self, u: f64) -> [Self; 2] {
        let u = crate::geometry::param::clipped(u);
        let [x, y, weight] = [0, 1, 2].map(|axis| split(&self.axis(axis), u));
        [0, 1].map(|part| {
            let points = x[part].iter().zip(&y[part]).zip(&weight[part]);
            Self::new(points.map(|((&x, &y), &weight)| [x, y, weight]).collect())
        })
    }

    /// The part over a range of `u` in [0, 1]; `None` for a range of no length.
    #[must_use]
    pub fn part(&self, [from, to]: [f64; 2]) -> Option<Self> {
        let [from, to] = [from, to].map(crate::geometry::param::clipped);
        if from >= to {
            return None;
        }
        let [before, _] = if to < 1.0 { self.split(to) } else { [self.clone(), self.clone()] };
        let [_, part] = if from > 0.0 { before.split(from / to) } else { [before.clone(), before] };
        Some(part)
    }

    /// The same curve in pieces with positive weights only, as files of other programs want them, each with the
    /// range of `u` it comes from; `None` where the weight is zero or negative somewhere on the curve.
    #[must_use]
    pub fn with_positive_weights(&self) -> Option<Vec<(Self, [f64; 2])>> {
        let mut pieces = Vec::new();
        let mut waiting = vec![(self.clone(), [0.0, 1.0], HALVINGS)];
        while let Some((piece, [from, to], depth)) = waiting.pop() {
            if piece.points.iter().all(|[.., weight]| *weight > 0.0) {
                pieces.push((piece, [from, to]));
                continue;
            }
            let ends = [piece.points.first(), piece.points.last()];
            let positive = ends.into_iter().flatten().all(|[.., weight]| *weight > 0.0);
            let less = depth.checked_sub(1).filter(|_| positive)?;
            let [left, right] = piece.split(0.5);
            let middle = 0.5 * (from + to);
            waiting.extend([(right, [middle, to], less), (left, [from, middle], less)]);
        }
        Some(pieces)
    }

    /// The same curve with all homogeneous points multiplied by `factor`, which must not be zero: so that its first
    /// weight is the last one of the arc before, as in one B-spline over several spans.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self::new(self.points.iter().map(|point| point.map(|x| x * factor)).collect())
    }

    fn axis(&self, axis: usize) -> Vec<f64> {
        self.points.iter().map(|point| point[axis]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quarter of the unit circle, with weights 1, 1, 2.
    fn quarter() -> RationalArc {
        RationalArc::new(vec![[1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 2.0, 2.0]])
    }

    #[test]
    fn the_circle_is_exact() {
        let arc = quarter();
        assert_eq!((arc.degree(), arc.homogeneous().len()), (2, 3));
        let [left, right] = arc.split(0.3);
        for k in 0..=20 {
            let u = f64::from(k) / 20.0;
            let [x, y] = arc.eval(u).unwrap();
            assert!((x.hypot(y) - 1.0).abs() < 1e-15);
            let (before, after) = (left.eval(u).unwrap(), right.eval(u).unwrap());
            let (p, q) = (arc.eval(0.3 * u).unwrap(), arc.eval(0.3 + 0.7 * u).unwrap());
            assert!((before[0] - p[0]).abs() < 1e-15 && (after[1] - q[1]).abs() < 1e-15);
            let [scaled, _] = arc.scaled(-3.0).eval(u).unwrap();
            assert!((scaled - x).abs() < 1e-15);
        }
    }

    #[test]
    fn weights_become_positive_by_halving() {
        assert_eq!(quarter().with_positive_weights(), Some(vec![(quarter(), [0.0, 1.0])]));
        // The weight is 1 - 2.4 u (1 - u), positive but for its middle coefficient.
        let arc = RationalArc::new(vec![[0.0, 0.0, 1.0], [1.0, 1.0, -0.2], [2.0, 0.0, 1.0]]);
        let pieces = arc.with_positive_weights().unwrap();
        assert!(pieces.len() > 1);
        let mut end = 0.0;
        for (piece, [from, to]) in &pieces {
            assert!(piece.homogeneous().iter().all(|[.., weight]| *weight > 0.0));
            assert_eq!(*from, end);
            let (p, q) = (piece.eval(0.5).unwrap(), arc.eval(0.5 * (from + to)).unwrap());
            assert!((p[0] - q[0]).abs() < 1e-14 && (p[1] - q[1]).abs() < 1e-14);
            end = *to;
        }
        assert_eq!(end, 1.0);
        // A weight that is zero somewhere, or negative everywhere, has no such pieces.
        let zero = RationalArc::new(vec![[0.0, 0.0, 1.0], [1.0, 1.0, -1.0], [2.0, 0.0, 1.0]]);
        assert_eq!(zero.with_positive_weights(), None);
        assert_eq!(zero.eval(0.5), None);
        assert_eq!(quarter().scaled(-1.0).with_positive_weights(), None);
    }
}
