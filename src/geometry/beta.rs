//! Beta-splines whose shape parameters vary along the curve (2.68).
//!
//! Bias and tension are given at the joints and blended along each span by a quintic with vanishing first
//! and second derivatives at its ends, so that at a joint the curve has the unit tangent and curvature
//! continuity of the beta-spline with the joint's own values. The spans are no polynomials: they are
//! evaluated directly. With the same shape everywhere this is the beta-spline of
//! [`Method::Beta`](super::Method::Beta).

use super::point::{check_count, check_points};
use super::{Closure, CubicBezier, GeometryError, MAX_SAMPLES, Method, Point, Sample};
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
        let s = u * u * u * (10.0 - u * (15.0 - 6.0 * u));
        Shape {
            bias: (1.0 - s) * self.bias + s * other.bias,
            tension: (1.0 - s) * self.tension + s * other.tension,
        }
    }

    /// The weights of the four control points around a span at `u` (2.64); their sum is 1.
    #[must_use]
    pub fn weights(self, u: f64) -> [f64; 4] {
        let Shape { bias: b1, tension: b2 } = self;
        let (b12, b13) = (b1 * b1, b1 * b1 * b1);
        let delta = b13 + 2.0 * (b12 + b1) + b2 + 1.0;
        let (u2, u3, w) = (u * u, u * u * u, 1.0 - u);
        let rising = b12 * u2 * (3.0 - u) + b1 * u * (3.0 - u2) + b2 * u2 * (3.0 - 2.0 * u) + 1.0 - u3;
        let falling = b13 * u * (u2 - 3.0 * u + 3.0)
            + b12 * (u3 - 3.0 * u2 + 2.0)
            + b1 * (u3 - 3.0 * u + 2.0)
            + b2 * (2.0 * u3 - 3.0 * u2 + 1.0);
        [b13 * w * w * w / delta, falling / delta, rising / delta, u3 / delta]
    }

    /// The method that draws a beta-spline of this shape.
    #[must_use]
    pub fn method(self) -> Method {
        Method::Beta { bias: self.bias, tension: self.tension }
    }
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

    /// The number of spans: one less than the points when open, as many when closed.
    #[must_use]
    pub fn spans(&self) -> usize {
        match self.closure {
            Closure::Open => self.shapes.len() - 1,
            Closure::Closed => self.shapes.len(),
        }
    }

    /// A span in equal steps of u, both ends included; nothing if there is no such span.
    pub fn span_points(&self, span: usize, steps: usize) -> impl Iterator<Item = Point<D>> {
        (0..=steps).filter_map(move |step| self.eval(span, step as f64 / steps as f64))
    }

    /// Points of every span in equal steps of u: rows u = 0, 1/n, ... 1.
    ///
    /// # Errors
    /// [`GeometryError::Samples`] for no steps at all or too many points.
    pub fn sample(&self, steps: usize) -> Result<Vec<Sample<D>>, GeometryError> {
        let most = (MAX_SAMPLES / self.spans()).saturating_sub(1);
        if steps == 0 || steps > most {
            return Err(GeometryError::Samples { per_span: steps, most });
        }
        let rows = (0..self.spans()).flat_map(|span| {
            let points = self.span_points(span, steps).enumerate();
            points.map(move |(step, point)| Sample { span, u: step as f64 / steps as f64, point })
        });
        Ok(rows.collect())
    }

    /// Cubic arcs that run through the curve and are nowhere further from it than the tolerance, in the
    /// unit of the points. Compared at quarters of every arc, which is no proof but was never seen to fail.
    ///
    /// # Errors
    /// [`GeometryError::ToleranceTooSmall`] if halving the arcs 20 times is not enough.
    pub fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        let mut arcs = Vec::new();
        for span in 0..self.spans() {
            self.add_cubics(span, [0.0, 1.0], tolerance, &mut arcs)?;
        }
        Ok(arcs)
    }

    fn add_cubics(
        &self,
        span: usize,
        [from, to]: [f64; 2],
        tolerance: f64,
        arcs: &mut Vec<CubicBezier<D>>,
    ) -> Result<(), GeometryError> {
        let length = to - from;
        let [start, a, b, end] =
            [from, from + length / 3.0, to - length / 3.0, to].map(|u| self.point(span, u));
        let arc = through(start, a, b, end);
        let off = [0.125, 0.25, 0.5, 0.75, 0.875].into_iter().any(|t| {
            let (ours, theirs) = (arc.eval(t), self.point(span, from + t * length));
            ours.iter().zip(theirs).any(|(ours, theirs)| (ours - theirs).abs() > tolerance / 2.0)
        });
        if !off {
            arcs.push(arc);
            return Ok(());
        }
        if length < SHORTEST_ARC {
            return Err(GeometryError::ToleranceTooSmall { value: tolerance, least: 2.0 * tolerance });
        }
        let middle = from + length / 2.0;
        self.add_cubics(span, [from, middle], tolerance, arcs)?;
        self.add_cubics(span, [middle, to], tolerance, arcs)
    }

    fn point(&self, span: usize, u: f64) -> Point<D> {
        // The callers count the spans themselves.
        self.eval(span, u).unwrap_or([0.0; D])
    }

    /// Where the spans join, the ends of an open curve included.
    #[must_use]
    pub fn joints(&self) -> Vec<Point<D>> {
        let end = (self.closure == Closure::Open).then(|| self.eval(self.spans() - 1, 1.0)).flatten();
        (0..self.spans()).filter_map(|span| self.eval(span, 0.0)).chain(end).collect()
    }

    fn ends(&self, span: usize) -> [Shape; 2] {
        let count = self.shapes.len();
        [self.shapes[span % count], self.shapes[(span + 1) % count]]
    }

    /// The point of a span at `u` in 0..=1; `None` if there is no such span.
    #[must_use]
    pub fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        if span >= self.spans() {
            return None;
        }
        let [from, to] = self.ends(span);
        let window = self.framed.get(span..span + 4)?;
        let weights = from.blend(to, u).weights(u);
        let mut point = [0.0; D];
        for (weight, control) in weights.iter().zip(window) {
            for (coordinate, &value) in point.iter_mut().zip(control) {
                *coordinate += weight * value;
            }
        }
        Some(point)
    }
}

/// The shortest arc, in the parameter of its span, that a span is cut into.
const SHORTEST_ARC: f64 = 1e-6;

/// The cubic arc through four points at u = 0, 1/3, 2/3, 1.
fn through<const D: usize>(a: Point<D>, b: Point<D>, c: Point<D>, d: Point<D>) -> CubicBezier<D> {
    let inner = |near: Point<D>, next: Point<D>, other: Point<D>, far: Point<D>| -> Point<D> {
        std::array::from_fn(|axis| {
            (-5.0 * near[axis] + 18.0 * next[axis] - 9.0 * other[axis] + 2.0 * far[axis]) / 6.0
        })
    };
    CubicBezier { p: [a, inner(a, b, c, d), inner(d, c, b, a), d] }
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
