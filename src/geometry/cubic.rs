//! The cubic Bézier arc: what every piecewise curve is made of.

use super::arclen::integrate;
use super::point::{lerp, norm, scaled_difference, within_limit};
use super::{BoundingBox, GeometryError, Point};

/// A cubic Bézier arc (2.49), parameter `u` from 0 at `p[0]` to 1 at `p[3]`.
///
/// Arcs made by this room keep within [`COORDINATE_LIMIT`](super::COORDINATE_LIMIT), so that
/// everything computed from them is finite for `u` in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicBezier<const D: usize> {
    /// The Bézier points.
    pub p: [Point<D>; 4],
}

impl<const D: usize> CubicBezier<D> {
    /// The point at `u`; exactly `p[0]` at 0 and `p[3]` at 1.
    #[must_use]
    pub fn eval(&self, u: f64) -> Point<D> {
        let w = 1.0 - u;
        let [f0, f1, f2, f3] = [w * w * w, 3.0 * w * w * u, 3.0 * w * u * u, u * u * u];
        let [a, b, c, d] = &self.p;
        std::array::from_fn(|i| f0 * a[i] + f1 * b[i] + f2 * c[i] + f3 * d[i])
    }

    /// The derivative by `u` at `u`.
    #[must_use]
    pub fn derivative(&self, u: f64) -> Point<D> {
        let w = 1.0 - u;
        let [a, b, c] = self.hodograph();
        std::array::from_fn(|i| w * w * a[i] + 2.0 * w * u * b[i] + u * u * c[i])
    }

    /// The second derivative by `u` at `u`.
    #[must_use]
    pub fn second_derivative(&self, u: f64) -> Point<D> {
        let [a, b, c] = self.hodograph();
        lerp(scaled_difference(2.0, a, b), scaled_difference(2.0, b, c), u)
    }

    /// The third derivative by `u`, the same everywhere.
    #[must_use]
    pub fn third_derivative(&self) -> Point<D> {
        let [a, b, c] = self.hodograph();
        scaled_difference(2.0, scaled_difference(1.0, a, b), scaled_difference(1.0, b, c))
    }

    /// Fills `out` with points at equal steps of `u`: the first is `p[0]`, the last `p[3]`, both
    /// exactly; a single one is `p[0]`. Others agree with [`CubicBezier::eval`] to 1e-14 of the
    /// largest coordinate. This is the fast way to many points.
    pub fn sample_into(&self, out: &mut [Point<D>]) {
        let steps = out.len().saturating_sub(1);
        let scale = 1.0 / steps.max(1) as f64;
        let powers = self.powers();
        let (blocks, rest) = out.as_chunks_mut::<LANES>();
        let done = blocks.len() * LANES;
        for (k, block) in blocks.iter_mut().enumerate() {
            let first = k * LANES;
            *block = horner(&powers, std::array::from_fn(|lane| (first + lane) as f64 * scale));
        }
        for (j, point) in rest.iter_mut().enumerate() {
            [*point] = horner(&powers, [(done + j) as f64 * scale]);
        }
        if let [_, .., last] = out {
            *last = self.p[3];
        }
    }

    /// The two halves of the arc, before and after `u`.
    #[must_use]
    pub fn split(&self, u: f64) -> [Self; 2] {
        let [a, b, c, d] = self.p;
        let (ab, bc, cd) = (lerp(a, b, u), lerp(b, c, u), lerp(c, d, u));
        let (abc, bcd) = (lerp(ab, bc, u), lerp(bc, cd, u));
        let middle = lerp(abc, bcd, u);
        [Self { p: [a, ab, abc, middle] }, Self { p: [middle, bcd, cd, d] }]
    }

    /// The piece from `u = from` to `u = to`; reversed when `from > to`.
    #[must_use]
    pub fn subsegment(&self, from: f64, to: f64) -> Self {
        let p = [[from, from, from], [from, from, to], [from, to, to], [to, to, to]];
        Self { p: p.map(|parameters| self.blossom(parameters)) }
    }

    /// The same arc run through backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [a, b, c, d] = self.p;
        Self { p: [d, c, b, a] }
    }

    /// The smallest box round the arc, from the roots of its derivative; exact but for rounding
    /// in the extreme points.
    #[must_use]
    pub fn bounding_box(&self) -> BoundingBox<D> {
        let [start, .., end] = self.p;
        let mut bounds = BoundingBox::of_point(start).union(BoundingBox::of_point(end));
        let [a, b, c] = self.hodograph();
        for d in 0..D {
            for u in inner_roots([a[d], b[d], c[d]]) {
                let x = self.eval(u)[d];
                bounds.min[d] = bounds.min[d].min(x);
                bounds.max[d] = bounds.max[d].max(x);
            }
        }
        bounds
    }

    /// The arc's length with an absolute error of about `accuracy`, which is not taken smaller
    /// than 1e-14 of the control polygon (so 0 and NaN ask for the best possible).
    #[must_use]
    pub fn length(&self, accuracy: f64) -> f64 {
        let polygon: f64 = self.p.windows(2).map(|leg| norm(scaled_difference(1.0, leg[0], leg[1]))).sum();
        integrate(&|u| norm(self.derivative(u)), [0.0, 1.0], accuracy.max(1e-14 * polygon))
    }

    /// Bernstein coefficients of the derivative.
    fn hodograph(&self) -> [Point<D>; 3] {
        let [a, b, c, d] = self.p;
        [scaled_difference(3.0, a, b), scaled_difference(3.0, b, c), scaled_difference(3.0, c, d)]
    }

    /// Coefficients of 1, u, u^2, u^3.
    fn powers(&self) -> [Point<D>; 4] {
        let [a, b, c, d] = self.p;
        let second = std::array::from_fn(|i| 3.0 * ((a[i] - b[i]) + (c[i] - b[i])));
        let third = std::array::from_fn(|i| (d[i] - a[i]) + 3.0 * (b[i] - c[i]));
        [a, scaled_difference(3.0, a, b), second, third]
    }

    /// De Casteljau's scheme with another parameter in each round.
    pub(super) fn blossom(&self, [u, v, w]: [f64; 3]) -> Point<D> {
        let [a, b, c, d] = self.p;
        let (ab, bc, cd) = (lerp(a, b, u), lerp(b, c, u), lerp(c, d, u));
        lerp(lerp(ab, bc, v), lerp(bc, cd, v), w)
    }
}

/// Hands the arcs on when all their points are within the limit.
pub(super) fn check_arcs<const D: usize>(
    arcs: Vec<CubicBezier<D>>,
) -> Result<Vec<CubicBezier<D>>, GeometryError> {
    match arcs.iter().position(|arc| !arc.p.iter().all(within_limit)) {
        None => Ok(arcs),
        Some(span) => Err(GeometryError::Overflow { span }),
    }
}

/// How many samples are computed side by side, so that the compiler can use vector registers.
const LANES: usize = 4;

/// Points at `N` parameters from power coefficients, coordinate by coordinate.
fn horner<const D: usize, const N: usize>([c0, c1, c2, c3]: &[Point<D>; 4], u: [f64; N]) -> [Point<D>; N] {
    let columns: [[f64; N]; D] =
        std::array::from_fn(|d| u.map(|u| ((c3[d] * u + c2[d]) * u + c1[d]) * u + c0[d]));
    std::array::from_fn(|lane| std::array::from_fn(|d| columns[d][lane]))
}

/// Roots strictly between 0 and 1 of the quadratic with these Bernstein coefficients.
fn inner_roots(coefficients: [f64; 3]) -> impl Iterator<Item = f64> {
    // Scaled, so that products neither overflow nor vanish.
    let largest = coefficients.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let [d0, d1, d2] = coefficients.map(|x| if largest > 0.0 { x / largest } else { 0.0 });
    // d0 + 2 linear u + square u^2. A negative discriminant is taken for 0: the parameter found is
    // then no root, but its point is on the arc, so no box suffers.
    let (linear, square) = (d1 - d0, (d0 - d1) + (d2 - d1));
    let root = (d1 * d1 - d0 * d2).max(0.0).sqrt();
    // Without cancellation; the other root comes from the product of both.
    let q = -(linear + root.copysign(linear));
    [q / square, d0 / q].into_iter().filter(|u| *u > 0.0 && *u < 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn arc() -> impl Strategy<Value = CubicBezier<3>> {
        prop::array::uniform4(prop::array::uniform3(-100.0..100.0)).prop_map(|p| CubicBezier { p })
    }

    fn distance(a: Point<3>, b: Point<3>) -> f64 {
        norm(scaled_difference(1.0, a, b))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn samples_agree_with_eval(arc in arc(), count in 2_usize..200) {
            let mut out = vec![[0.0; 3]; count];
            arc.sample_into(&mut out);
            prop_assert_eq!((out[0], out[count - 1]), (arc.p[0], arc.p[3]));
            for (j, p) in out.iter().enumerate() {
                let u = j as f64 / (count - 1) as f64;
                prop_assert!(distance(*p, arc.eval(u)) < 1e-14 * 100.0 * 3.0);
            }
        }

        #[test]
        fn derivatives_agree_with_differences(arc in arc(), u in 0.0..1.0) {
            let h = 1e-4;
            let slope = scaled_difference(0.5 / h, arc.eval(u - h), arc.eval(u + h));
            prop_assert!(distance(slope, arc.derivative(u)) < 1e-4);
            let bend = scaled_difference(0.5 / h, arc.derivative(u - h), arc.derivative(u + h));
            prop_assert!(distance(bend, arc.second_derivative(u)) < 1e-6);
            let third = scaled_difference(1.0, arc.second_derivative(0.0), arc.second_derivative(1.0));
            prop_assert!(distance(third, arc.third_derivative()) < 1e-9);
        }

        #[test]
        fn pieces_lie_on_the_arc(arc in arc(), from in 0.0..1.0, to in 0.0..1.0, u in 0.0..1.0) {
            let piece = arc.subsegment(from, to);
            prop_assert!(distance(piece.eval(u), arc.eval(from + u * (to - from))) < 1e-11);
            let [before, after] = arc.split(from);
            prop_assert!(distance(before.eval(u), arc.eval(u * from)) < 1e-11);
            prop_assert!(distance(after.eval(u), arc.eval(from + u * (1.0 - from))) < 1e-11);
            prop_assert_eq!(before.p[3], after.p[0]);
        }

        #[test]
        fn box_is_the_smallest(arc in arc()) {
            let bounds = arc.bounding_box();
            let mut reached = BoundingBox::of_point(arc.p[0]);
            for j in 0..=4000 {
                reached = reached.union(BoundingBox::of_point(arc.eval(f64::from(j) / 4000.0)));
            }
            for d in 0..3 {
                prop_assert!((bounds.min[d] - reached.min[d]).abs() < 1e-4);
                prop_assert!((bounds.max[d] - reached.max[d]).abs() < 1e-4);
                prop_assert!(bounds.min[d] <= reached.min[d] + 1e-12 && reached.max[d] <= bounds.max[d] + 1e-12);
            }
        }

        #[test]
        fn length_adds_up(arc in arc(), u in 0.0..1.0) {
            let [before, after] = arc.split(u);
            let whole = arc.length(1e-11);
            prop_assert!((before.length(1e-11) + after.length(1e-11) - whole).abs() < 1e-10);
        }
    }

    #[test]
    fn known_lengths() {
        // A straight line run through unevenly, a parabola y = x^2 on [0, 1], and a cusp.
        let line = CubicBezier { p: [[0.0, 0.0], [0.0, 0.0], [3.0, 4.0], [3.0, 4.0]] };
        assert!((line.length(1e-13) - 5.0).abs() < 1e-13);
        let parabola = CubicBezier { p: [[0.0, 0.0], [1.0 / 3.0, 0.0], [2.0 / 3.0, 1.0 / 3.0], [1.0, 1.0]] };
        let want = 5.0_f64.sqrt() / 2.0 + 2.0_f64.asinh() / 4.0;
        assert!((parabola.length(1e-14) - want).abs() < 1e-14);
        // x = 3 t^2, y = 2 t^3 for t from -1 to 1: twice 2 (2 sqrt 2 - 1).
        let cusp = CubicBezier { p: [[3.0, -2.0], [-1.0, 2.0], [-1.0, -2.0], [3.0, 2.0]] };
        assert!((cusp.length(1e-12) - 4.0 * (8.0_f64.sqrt() - 1.0)).abs() < 1e-11);
        assert_eq!(CubicBezier { p: [[7.0; 2]; 4] }.length(0.0), 0.0);
    }

    #[test]
    fn box_of_a_tiny_arc_is_found_too() {
        let arc = CubicBezier { p: [[0.0], [4e-200], [4e-200], [0.0]] };
        assert!((arc.bounding_box().max[0] / 3e-200 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn few_samples() {
        let arc = CubicBezier { p: [[1.0], [2.0], [3.0], [5.0]] };
        arc.sample_into(&mut []);
        let mut one = [[0.0]];
        arc.sample_into(&mut one);
        assert_eq!(one, [[1.0]]);
        let mut two = [[0.0]; 2];
        arc.sample_into(&mut two);
        assert_eq!(two, [[1.0], [5.0]]);
    }
}
