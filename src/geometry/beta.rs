//! Beta-splines whose shape parameters vary along the curve (2.68).
//!
//! Bias and tension are given at the joints and blended along each span by a quintic with vanishing first
//! and second derivatives at its ends, so that at a joint the curve has the unit tangent and curvature
//! continuity of the beta-spline with the joint's own values. The spans are no polynomials: they are
//! evaluated directly. With the same shape everywhere this is the beta-spline of
//! [`Method::Beta`](super::Method::Beta).

use super::jet::{Jet, Number};
use super::param::{ParamCurve, clipped};
use super::point::{add_scaled, check_count, check_points};
use super::{Closure, GeometryError, Method, Point};
use serde::{Deserialize, Serialize};

/// Bias and tension of a beta-spline, or of one of its joints.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shape {
    /// The bias (β1), larger than 0; 1 is unbiased.
    pub bias: f64,
    /// The tension (β2), half of Barsky's; 0 is none.
    pub tension: f64,
}

impl Default for Shape {
    /// The cubic B-spline.
    fn default() -> Shape {
        Shape { bias: 1.0, tension: 0.0 }
    }
}

impl Shape {
    /// The shape on the way from this one to another, at `u` in 0..=1 (2.68).
    #[must_use]
    pub fn blend(self, other: Shape, u: f64) -> Shape {
        let [bias, tension] = blended([self, other], u);
        Shape { bias, tension }
    }

    /// The weights of the four control points around a span at `u` (2.64); their sum is 1.
    #[must_use]
    pub fn weights(self, u: f64) -> [f64; 4] {
        weights([self.bias, self.tension], u)
    }

    /// The method that draws a beta-spline of this shape.
    #[must_use]
    pub fn method(self) -> Method {
        Method::Beta { bias: self.bias, tension: self.tension }
    }
}

/// Bias and tension on the way from one shape to another (2.68).
fn blended<N: Number>([from, to]: [Shape; 2], u: N) -> [N; 2] {
    let n = N::from;
    let s = u * u * u * (n(10.0) - u * (n(15.0) - n(6.0) * u));
    let between = |from: f64, to: f64| (n(1.0) - s) * n(from) + s * n(to);
    [between(from.bias, to.bias), between(from.tension, to.tension)]
}

/// The weights (2.64) of the four control points around a span, by bias and tension.
fn weights<N: Number>([b1, b2]: [N; 2], u: N) -> [N; 4] {
    let n = N::from;
    let (b12, b13) = (b1 * b1, b1 * b1 * b1);
    let delta = b13 + n(2.0) * (b12 + b1) + b2 + n(1.0);
    let (u2, u3, w) = (u * u, u * u * u, n(1.0) - u);
    let rising =
        b12 * u2 * (n(3.0) - u) + b1 * u * (n(3.0) - u2) + b2 * u2 * (n(3.0) - n(2.0) * u) + n(1.0) - u3;
    let falling = b13 * u * (u2 - n(3.0) * u + n(3.0))
        + b12 * (u3 - n(3.0) * u2 + n(2.0))
        + b1 * (u3 - n(3.0) * u + n(2.0))
        + b2 * (n(2.0) * u3 - n(3.0) * u2 + n(1.0));
    [b13 * w * w * w / delta, falling / delta, rising / delta, u3 / delta]
}

/// A beta-spline with a shape at every joint. Joint `i` lies near control point `i`.
#[derive(Clone, Debug, PartialEq)]
pub struct VaryingBeta<const D: usize> {
    /// The control points with one more before the first and, when closed, two more behind the last.
    framed: Vec<Point<D>>,
    shapes: Vec<Shape>,
    closure: Closure,
}

impl<const D: usize> VaryingBeta<D> {
    /// The curve by control points with a shape for each of their joints. Open curves begin and end at the
    /// first and last control point by auxiliary ones (2.65), with the shapes of the ends.
    ///
    /// # Errors
    /// [`GeometryError`]: fewer than 2 points (3 when closed), another number of shapes, a number that is
    /// not finite, a bias of 0 or less, or two neighbouring joints between which the tension passes its
    /// critical value (2.67), where the curve runs to infinity.
    pub fn new(closure: Closure, points: &[Point<D>], shapes: &[Shape]) -> Result<Self, GeometryError> {
        check_count(points.len(), if closure == Closure::Open { 2 } else { 3 })?;
        check_points(points)?;
        if shapes.len() != points.len() {
            return Err(GeometryError::WrongCount { given: shapes.len(), needed: points.len() });
        }
        let (first, last) = (points[0], points[points.len() - 1]);
        let (before, behind) = match closure {
            Closure::Closed => (last, [first, points[1]]),
            Closure::Open => {
                let start = shapes[0].bias.powi(3);
                let end = shapes[shapes.len() - 1].bias.powi(3);
                let before = extended(first, points[1], 1.0 / start);
                (before, [extended(last, points[points.len() - 2], end); 2])
            }
        };
        let framed = std::iter::once(before).chain(points.iter().copied()).chain(behind).collect();
        let curve = Self { framed, shapes: shapes.to_vec(), closure };
        curve.check_shapes()?;
        check_points(&curve.framed)?;
        Ok(curve)
    }

    /// Every joint has a curve, and no span passes the critical tension: `delta` keeps its sign.
    fn check_shapes(&self) -> Result<(), GeometryError> {
        self.shapes.iter().try_for_each(|shape| shape.method().check())?;
        for span in 0..self.spans() {
            let [from, to] = self.ends(span);
            for step in 0..=SHAPE_STEPS {
                let shape = from.blend(to, f64::from(step) / f64::from(SHAPE_STEPS));
                let gap = |shape: Shape| shape.tension - Method::critical_tension(shape.bias);
                shape.method().check()?;
                if gap(shape) * gap(from) < 0.0 {
                    let critical = Method::critical_tension(shape.bias);
                    return Err(GeometryError::CriticalTension {
                        bias: shape.bias,
                        tension: shape.tension,
                        critical,
                    });
                }
            }
        }
        Ok(())
    }

    fn ends(&self, span: usize) -> [Shape; 2] {
        let count = self.shapes.len();
        [self.shapes[span % count], self.shapes[(span + 1) % count]]
    }

    /// The shapes of a span's ends and the control points around it.
    fn window(&self, span: usize) -> Option<([Shape; 2], &[Point<D>])> {
        let window = self.framed.get(span..span.checked_add(4)?)?;
        (span < self.spans()).then(|| (self.ends(span), window))
    }
}

impl<const D: usize> ParamCurve<D> for VaryingBeta<D> {
    /// One less than the points when open, as many when closed.
    fn spans(&self) -> usize {
        match self.closure {
            Closure::Open => self.shapes.len() - 1,
            Closure::Closed => self.shapes.len(),
        }
    }

    fn closed(&self) -> bool {
        self.closure == Closure::Closed
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        let (shapes, window) = self.window(span)?;
        let u = Jet::parameter(clipped(u));
        let weights = weights(blended(shapes, u), u);
        Some(std::array::from_fn(|order| weighted(weights.map(|Jet(values)| values[order]), window)))
    }

    fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        let ([from, to], window) = self.window(span)?;
        let u = clipped(u);
        Some(weighted(from.blend(to, u).weights(u), window))
    }
}

/// Weights times points.
fn weighted<const D: usize>(weights: [f64; 4], points: &[Point<D>]) -> Point<D> {
    weights.iter().zip(points).fold([0.0; D], |sum, (&weight, &point)| add_scaled(sum, weight, point))
}

/// In how many steps a span is searched for the critical tension.
const SHAPE_STEPS: u32 = 64;

/// The auxiliary point beyond `end`, seen from `inner`, at a multiple of their distance.
fn extended<const D: usize>(end: Point<D>, inner: Point<D>, factor: f64) -> Point<D> {
    std::array::from_fn(|axis| end[axis] + factor * (end[axis] - inner[axis]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Curve;
    use proptest::prelude::*;

    fn polygon(count: usize) -> Vec<Point<2>> {
        (0..count).map(|i| [(i * 37 % 101) as f64, (i * 53 % 89) as f64]).collect()
    }

    #[test]
    fn bad_input_has_its_sentence() {
        let shapes = vec![Shape::default(); 4];
        assert!(VaryingBeta::new(Closure::Open, &polygon(1), &shapes[..1]).is_err());
        assert!(VaryingBeta::new(Closure::Open, &polygon(4), &shapes[..3]).is_err());
        let mut wrong = shapes.clone();
        wrong[2].bias = 0.0;
        assert!(VaryingBeta::new(Closure::Open, &polygon(4), &wrong).is_err());
        let mut passing = shapes.clone();
        passing[1].tension = -20.0;
        let error = VaryingBeta::new(Closure::Closed, &polygon(4), &passing).unwrap_err();
        assert!(matches!(error, GeometryError::CriticalTension { .. }), "{error}");
    }

    #[test]
    fn cubics_run_along_the_curve() {
        let shapes: Vec<Shape> =
            (0..6).map(|i| Shape { bias: 0.5 + f64::from(i), tension: f64::from(3 * i) }).collect();
        let curve = VaryingBeta::new(Closure::Closed, &polygon(6), &shapes).unwrap();
        let arcs = curve.to_cubics(1e-6).unwrap();
        let ends: Vec<Point<2>> = arcs.iter().map(|arc| arc.p[3]).collect();
        for (arc, end) in arcs.iter().skip(1).zip(&ends) {
            assert_eq!(arc.p[0], *end);
        }
        // Every sampled point lies near some arc.
        for sample in curve.sample(37).unwrap() {
            let distance = arcs.iter().flat_map(|arc| (0..=200).map(|t| arc.eval(f64::from(t) / 200.0)));
            let nearest = distance
                .map(|p| (p[0] - sample.point[0]).hypot(p[1] - sample.point[1]))
                .fold(f64::MAX, f64::min);
            assert!(nearest < 0.05, "{nearest}");
        }
        assert_eq!(curve.sample(10).unwrap().len(), 66);
        assert!(curve.sample(0).is_err());
    }

    proptest! {
        #[test]
        fn weights_sum_to_one(bias in 0.05..20.0f64, tension in 0.0..100.0f64, u in 0.0..=1.0f64) {
            let sum: f64 = Shape { bias, tension }.weights(u).iter().sum();
            prop_assert!((sum - 1.0).abs() < 1e-13);
        }

        #[test]
        fn the_same_shape_everywhere_is_the_beta_spline(
            count in 3usize..20, closed: bool, bias in 0.05..20.0f64, tension in -4.0..40.0f64, u in 0.0..=1.0f64,
        ) {
            prop_assume!((tension - Method::critical_tension(bias)).abs() > 0.1);
            let closure = if closed { Closure::Closed } else { Closure::Open };
            let points = polygon(count);
            let varying = VaryingBeta::new(closure, &points, &vec![Shape { bias, tension }; count]).unwrap();
            let plain = Curve::through(Method::Beta { bias, tension }, closure, &points).unwrap();
            prop_assert_eq!(varying.spans(), plain.spans());
            let scale = points.iter().flatten().fold(1.0 + bias.powi(3), |a: f64, b| a.max(b.abs()));
            for span in 0..plain.spans() {
                let (a, b) = (varying.eval(span, u).unwrap(), plain.eval(span, u).unwrap());
                for (a, b) in a.iter().zip(b) {
                    prop_assert!((a - b).abs() < 1e-11 * scale * (1.0 + bias.powi(3)), "{} {}", a, b);
                }
            }
        }

        #[test]
        fn spans_join_with_one_tangent_direction(
            count in 4usize..12, closed: bool,
            values in prop::collection::vec((0.2..5.0f64, 0.0..20.0f64), 12),
        ) {
            let closure = if closed { Closure::Closed } else { Closure::Open };
            let shapes: Vec<Shape> = values.iter().take(count).map(|&(bias, tension)| Shape { bias, tension }).collect();
            let curve = VaryingBeta::new(closure, &polygon(count), &shapes).unwrap();
            let h = 1e-5;
            for (span, shape) in shapes.iter().enumerate().take(curve.spans()).skip(1) {
                let joint = curve.eval(span, 0.0).unwrap();
                let end = curve.eval(span - 1, 1.0).unwrap();
                for axis in 0..2 {
                    prop_assert!((joint[axis] - end[axis]).abs() < 1e-10);
                }
                let before = curve.eval(span - 1, 1.0 - h).unwrap();
                let behind = curve.eval(span, h).unwrap();
                let a = [joint[0] - before[0], joint[1] - before[1]];
                let b = [behind[0] - joint[0], behind[1] - joint[1]];
                let (la, lb) = (a[0].hypot(a[1]), b[0].hypot(b[1]));
                prop_assume!(la > 1e-7 && lb > 1e-7);
                prop_assert!((a[0] * b[1] - a[1] * b[0]).abs() / (la * lb) < 1e-2);
                // The derivatives differ by the joint's bias.
                prop_assert!((lb / la - shape.bias).abs() < 0.02 * shape.bias);
            }
        }
    }
}
