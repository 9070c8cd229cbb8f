//! A B-spline or NURBS curve: a knot vector, control points, perhaps weights.

use super::local::{Hom, blossom};
use super::{KnotError, KnotVector, MAX_ORDER};
use crate::geometry::param::{followed, measured, searched_box};
use crate::geometry::point::check_points;
use crate::geometry::{Basis, BoundingBox, CubicBezier, GeometryError, ParamCurve, Point};

/// A curve `s(u) = sum N_i(u) w_i d_i / sum N_i(u) w_i`.
///
/// ```
/// use grafika::geometry::ParamCurve;
/// use grafika::geometry::knots::{KnotCurve, KnotVector};
///
/// // A quarter of the unit circle.
/// let knots = KnotVector::clamped(3, 3)?;
/// let points = vec![[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// let arc = KnotCurve::rational(knots, points, vec![1.0, 0.5_f64.sqrt(), 1.0])?;
/// assert!((arc.length(1e-12) - std::f64::consts::FRAC_PI_2).abs() < 1e-11);
/// # Ok::<(), grafika::geometry::knots::KnotError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct KnotCurve<const D: usize> {
    vector: KnotVector,
    points: Vec<Point<D>>,
    weights: Option<Vec<f64>>,
}

/// One span of a curve as an exact Bézier arc.
#[derive(Clone, Debug, PartialEq)]
pub struct KnotArc<const D: usize> {
    /// The parameters between which it is.
    pub range: [f64; 2],
    /// Its control points, as many as the order.
    pub points: Vec<Point<D>>,
    /// Their weights; all 1 without weights.
    pub weights: Vec<f64>,
}

/// The largest weight, and the reciprocal of the smallest.
const WEIGHT_LIMIT: f64 = 1e40;

impl<const D: usize> KnotCurve<D> {
    /// The curve without weights.
    ///
    /// # Errors
    /// [`GeometryError`] for another number of points than the knots are for, or a bad coordinate.
    pub fn new(vector: KnotVector, points: Vec<Point<D>>) -> Result<Self, KnotError> {
        Self::with(vector, points, None)
    }

    /// The curve with weights, which must be positive.
    ///
    /// # Errors
    /// As [`KnotCurve::new`]; a wrong number of weights or a wrong weight.
    pub fn rational(vector: KnotVector, points: Vec<Point<D>>, weights: Vec<f64>) -> Result<Self, KnotError> {
        Self::with(vector, points, Some(weights))
    }

    pub(super) fn with(
        vector: KnotVector,
        points: Vec<Point<D>>,
        weights: Option<Vec<f64>>,
    ) -> Result<Self, KnotError> {
        if points.len() != vector.points() {
            return Err(GeometryError::WrongCount { given: points.len(), needed: vector.points() }.into());
        }
        check_points(&points)?;
        if let Some(weights) = &weights {
            if weights.len() != points.len() {
                return Err(KnotError::WeightCount { given: weights.len(), needed: points.len() });
            }
            let good = |w: f64| (1.0 / WEIGHT_LIMIT..=WEIGHT_LIMIT).contains(&w);
            if let Some(point) = weights.iter().position(|w| !good(*w)) {
                return Err(KnotError::Weight { point, value: weights[point] });
            }
        }
        Ok(Self { vector, points, weights })
    }

    /// A curve of homogeneous control points, rational if `rational`.
    pub(super) fn of_homogeneous(
        vector: KnotVector,
        points: &[Hom<D>],
        rational: bool,
    ) -> Result<Self, KnotError> {
        let weights = rational.then(|| points.iter().map(|point| point.w).collect());
        let place = |point: &Hom<D>| if rational { point.p.map(|x| x / point.w) } else { point.p };
        Self::with(vector, points.iter().map(place).collect(), weights)
    }

    /// The knots.
    #[must_use]
    pub fn vector(&self) -> &KnotVector {
        &self.vector
    }

    /// The control points; those of a closed curve once.
    #[must_use]
    pub fn points(&self) -> &[Point<D>] {
        &self.points
    }

    /// The weights; `None` without.
    #[must_use]
    pub fn weights(&self) -> Option<&[f64]> {
        self.weights.as_deref()
    }

    /// The same points and weights with one knot at another place between its neighbours.
    ///
    /// # Errors
    /// [`KnotError::Index`], or what makes the knots wrong then.
    pub fn with_knot(&self, knot: usize, value: f64) -> Result<Self, KnotError> {
        Ok(Self { vector: self.vector.with_knot(knot, value)?, ..self.clone() })
    }

    /// The point at a parameter, and its derivatives by it up to `degree`. `None` outside the domain, or where a
    /// derivative is no double any more.
    #[must_use]
    pub fn derivatives(&self, u: f64, degree: usize) -> Option<Vec<Point<D>>> {
        self.derivatives_in(self.vector.span_of(u)?, u, degree, 1.0)
    }

    /// The point at a parameter. `None` outside the domain.
    #[must_use]
    pub fn point_at(&self, u: f64) -> Option<Point<D>> {
        self.homogeneous_in(self.vector.knots(), self.vector.span_of(u)?, u)?.point()
    }

    /// The spans that have a length, as exact Bézier arcs.
    #[must_use]
    pub fn arcs(&self) -> Vec<KnotArc<D>> {
        let knots = self.vector.knots();
        let arc = |&span: &usize| {
            let (local, range) = (self.local(span), [knots[span], knots[span + 1]]);
            let order = self.vector.order();
            let corner = |c: usize| {
                let argument = |r: usize| range[usize::from(r < c)];
                blossom(knots, span, &local[..order], 0, 1.0, argument)
            };
            let corners: Option<Vec<Hom<D>>> = (0..order).map(corner).collect();
            let corners = corners?;
            let points: Option<Vec<Point<D>>> = corners.iter().map(|corner| corner.point()).collect();
            Some(KnotArc { range, points: points?, weights: corners.iter().map(|corner| corner.w).collect() })
        };
        self.vector.filled_spans().iter().filter_map(arc).collect()
    }

    /// The derivative by the parameter as a curve of the next lower order.
    ///
    /// # Errors
    /// [`KnotError::OrderNeeded`] for polygons, [`KnotError::Rational`], [`KnotError::TooMultiple`] where the curve
    /// has a gap.
    pub fn hodograph(&self) -> Result<Self, KnotError> {
        let (order, knots) = (self.vector.order(), self.vector.knots());
        if order < 3 {
            return Err(KnotError::OrderNeeded { given: order, least: 3, most: MAX_ORDER });
        }
        if self.weights.is_some() {
            return Err(KnotError::Rational);
        }
        let difference = |i: usize| -> Point<D> {
            // Leg i of the polygon, from point i.
            let width = knots[i + order] - knots[i + 1];
            let (a, b) = (self.homogeneous(i).p, self.homogeneous(i + 1).p);
            let factor = if width > 0.0 { (order - 1) as f64 / width } else { 0.0 };
            std::array::from_fn(|d| factor * (b[d] - a[d]))
        };
        if let Some(breaks) = self.vector.breaks() {
            let count = self.points.len();
            let points = (0..count).map(|i| difference((i + count - 1) % count)).collect::<Vec<_>>();
            // Control point i of the lower order begins one knot later.
            let vector = KnotVector::closed(order - 1, breaks)?;
            return Self::new(vector, (0..count).map(|i| points[(i + 1) % count]).collect());
        }
        let vector = KnotVector::new(order - 1, knots[1..knots.len() - 1].to_vec())?;
        Self::new(vector, (0..self.points.len() - 1).map(difference).collect())
    }

    /// Control point `i` as the formulas count, with its weight.
    pub(super) fn homogeneous(&self, i: usize) -> Hom<D> {
        let i = self.vector.point_index(i);
        let w = self.weights.as_ref().and_then(|weights| weights.get(i)).copied().unwrap_or(1.0);
        self.points.get(i).map_or(Hom::ZERO, |&point| Hom::of(point, w))
    }

    /// The control points of an arc.
    pub(super) fn local(&self, span: usize) -> [Hom<D>; MAX_ORDER] {
        let order = self.vector.order();
        std::array::from_fn(|l| if l < order { self.homogeneous(span + 1 + l - order) } else { Hom::ZERO })
    }

    /// The formula of an arc at `u`, with other values of the knots.
    pub(super) fn homogeneous_in(&self, knots: &[f64], span: usize, u: f64) -> Option<Hom<D>> {
        blossom(knots, span, &self.local(span)[..self.vector.order()], 0, 1.0, |_| u)
    }

    /// Point and derivatives in a span, times powers of `scale`.
    pub(super) fn derivatives_in(
        &self,
        span: usize,
        u: f64,
        degree: usize,
        scale: f64,
    ) -> Option<Vec<Point<D>>> {
        let (order, local) = (self.vector.order(), self.local(span));
        let value = |r: usize| {
            if r >= order {
                return Some(Hom::ZERO);
            }
            blossom(self.vector.knots(), span, &local[..order], r, scale, |_| u)
        };
        let rows: Option<Vec<Hom<D>>> = (0..=degree).map(value).collect();
        divided(&rows?)
    }

    /// The largest absolute coordinate difference of control points: what tolerances are measured by.
    pub(super) fn size(&self) -> f64 {
        let bounds = BoundingBox::of_points(&self.points);
        bounds.map_or(0.0, |it| (0..D).fold(0.0_f64, |most, d| most.max(it.max[d] - it.min[d])))
    }
}

/// The derivatives of a quotient by Leibniz' rule.
fn divided<const D: usize>(rows: &[Hom<D>]) -> Option<Vec<Point<D>>> {
    let mut out: Vec<Point<D>> = Vec::with_capacity(rows.len());
    let w = rows.first()?.w;
    for (r, row) in rows.iter().enumerate() {
        let mut value = row.p;
        let mut binomial = 1.0;
        for s in 1..=r {
            binomial *= (r + 1 - s) as f64 / s as f64;
            let (below, factor) = (out[r - s], binomial * rows[s].w);
            value = std::array::from_fn(|d| value[d] - factor * below[d]);
        }
        out.push(value.map(|x| x / w));
    }
    out.iter().flatten().all(|x| x.is_finite()).then_some(out)
}

impl<const D: usize> ParamCurve<D> for KnotCurve<D> {
    fn spans(&self) -> usize {
        self.vector.spans()
    }

    fn closed(&self) -> bool {
        self.vector.closed()
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        let (span, u, width) = self.vector.place(span, u)?;
        let all = self.derivatives_in(span, u, 2, width);
        // Too large numbers can only be derivatives, for weights of very different size.
        let point =
            all.as_ref().map_or_else(|| self.derivatives_in(span, u, 0, 1.0), |all| Some(all.clone()))?;
        let row = |r: usize| point.get(r).copied().unwrap_or([0.0; D]);
        Some([row(0), row(1), row(2)])
    }

    fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        let (span, u, _) = self.vector.place(span, u)?;
        self.homogeneous_in(self.vector.knots(), span, u)?.point()
    }

    fn bounding_box(&self) -> Option<BoundingBox<D>> {
        self.cubics().map_or_else(|| searched_box(self), |arcs| arcs.bounding_box())
    }

    fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        self.cubics().map_or_else(|| followed(self, tolerance), Ok)
    }

    fn length(&self, accuracy: f64) -> f64 {
        self.cubics().map_or_else(|| measured(self, accuracy), |arcs| arcs.length(accuracy))
    }
}

impl<const D: usize> KnotCurve<D> {
    /// The curve as cubic arcs, where it is made of them.
    fn cubics(&self) -> Option<Vec<CubicBezier<D>>> {
        if self.weights.is_some() || self.vector.order() > 4 {
            return None;
        }
        self.arcs().iter().map(|arc| cubic(&arc.points)).collect()
    }
}

/// A Bézier arc of 2 to 4 points as a cubic one.
fn cubic<const D: usize>(points: &[Point<D>]) -> Option<CubicBezier<D>> {
    let mixed = |a: Point<D>, b: Point<D>, u: f64| std::array::from_fn(|d| (1.0 - u) * a[d] + u * b[d]);
    let p = match *points {
        [a, b] => [a, mixed(a, b, 1.0 / 3.0), mixed(a, b, 2.0 / 3.0), b],
        [a, b, c] => [a, mixed(a, b, 2.0 / 3.0), mixed(b, c, 1.0 / 3.0), c],
        [a, b, c, d] => [a, b, c, d],
        _ => return None,
    };
    Some(CubicBezier { p })
}
