//! What a parameter does to a curve: the paths of its points, and the value that brings it to a given point.

use super::super::point::{add_scaled, check_points, norm, scaled_difference};
use super::super::{Basis, BoundingBox, GeometryError, ParamCurve, Point, dot};
use super::basis::ShapedBasis;
use super::curve::ShapedCurve;
use super::family::{Family, Parameter};
use super::newton::{Problem, solve};
use super::trig::MAX_EXPONENT;
use super::waves::OMEGA;
use std::f64::consts::PI;

/// A point further from the curve than this share of the control points' size is not reached.
const REACHED: f64 = 1e-9;
/// Steps of the search along a span for parameters that move points on straight lines.
const STEPS: usize = 200;
/// Golden sections of such a step: what is left is rounding.
const SECTIONS: usize = 60;
/// How many arcs of a spline, the nearest ones, are searched for parameters that move points on curves.
const NEAREST_ARCS: usize = 4;
/// The largest lambda that a target is reached with. Almost every point of the plane lies on some line of a curve, but with
/// lambdas in the thousands, which make no curve that is of use.
const FAR_LAMBDA: f64 = 100.0;
/// The smallest `omega` that stands for an `alpha`, which may not be 0.
const LEAST_OMEGA: f64 = 1e-16;
/// The largest exponent of a trigonometric curve that searches start from.
const FAR_EXPONENT: f64 = 100.0;

/// Where a parameter brings a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach<const D: usize> {
    /// Whether the curve goes through the point asked for, within 1e-9 of the control points' size.
    pub admissible: bool,
    /// The parameter's value; where the point cannot be reached, one that comes as near as the search found.
    pub value: f64,
    /// The span of the curve's point.
    pub span: usize,
    /// Its place in the span, 0 to 1.
    pub x: f64,
    /// The curve's point there: the nearest one that was found where the point is not reached.
    pub point: Point<D>,
    /// Its distance from the point asked for.
    pub distance: f64,
}

impl<const D: usize> ShapedCurve<D> {
    /// The basis with another value of a parameter.
    fn basis_with(&self, parameter: Parameter, value: f64) -> Result<ShapedBasis, GeometryError> {
        let count = self.points().len();
        ShapedBasis::new(self.basis().family().with(parameter, value, count)?, count, self.basis().closed())
    }

    /// Where the point of span `span` at `x` goes while a parameter takes these values. On C-curves this is the point at
    /// `t = alpha / c`, `c = 1 / x`: `alpha` ends the domain too.
    ///
    /// # Errors
    /// As [`Family::with`], and [`GeometryError::Parameter`] for a span that does not exist.
    pub fn path(
        &self,
        parameter: Parameter,
        span: usize,
        x: f64,
        values: &[f64],
    ) -> Result<Vec<Point<D>>, GeometryError> {
        let point = |value: &f64| {
            let basis = self.basis_with(parameter, *value)?;
            let wanted = "less than the number of spans";
            let missing = GeometryError::Parameter { name: "the span", value: span as f64, wanted };
            self.at_by(&basis, span, x).map(|[point, ..]| point).ok_or(missing)
        };
        values.iter().map(point).collect()
    }

    /// The value of a parameter with which the curve passes `target`, its control points kept; of several the one
    /// that changes least of those found.
    ///
    /// A lambda moves points on straight lines: every span is searched for lines that meet the target with
    /// a lambda from -100 to 100. Other parameters move
    /// them on curves: a damped Newton iteration in the parameter and the place, from a grid of starts, in
    /// the arcs nearest to the target.
    ///
    /// # Errors
    /// [`GeometryError::NoParameter`] or [`GeometryError::NoControlPoint`] for a parameter that the curve does not have;
    /// a target with a bad coordinate.
    pub fn through(&self, parameter: Parameter, target: Point<D>) -> Result<Reach<D>, GeometryError> {
        check_points(&[target])?;
        let size =
            BoundingBox::of_points(self.points()).map_or(0.0, |b| norm(scaled_difference(1.0, b.min, b.max)));
        let enough = REACHED * size;
        if self.basis().family().paths_are_straight() {
            self.through_lines(parameter, target, enough)
        } else {
            self.through_curves(parameter, target, enough)
        }
    }

    /// [`ShapedCurve::through`] by lines: the distance of the target from the line of every place.
    fn through_lines(
        &self,
        parameter: Parameter,
        target: Point<D>,
        enough: f64,
    ) -> Result<Reach<D>, GeometryError> {
        let (zero, one) = (self.basis_with(parameter, 0.0)?, self.basis_with(parameter, 1.0)?);
        let most =
            if matches!(self.basis().family(), Family::HanQuadratic { .. }) { 1.0 } else { FAR_LAMBDA };
        let present = self.basis().family().value(parameter).unwrap_or(0.0);
        let reach = |span: usize, x: f64| {
            let at = |basis| self.at_by(basis, span, x).map_or([0.0; D], |[point, ..]| point);
            let (start, end) = (at(&zero), at(&one));
            let (along, way) = (scaled_difference(1.0, start, end), scaled_difference(1.0, start, target));
            let length = norm(along);
            let value = dot(way.map(|x| x / length), along.map(|x| x / length));
            // Where lambda has no effect, it stays.
            let value = if value.is_finite() { value.clamp(-most, most) } else { present };
            let point = add_scaled(start, value, along);
            let distance = norm(scaled_difference(1.0, point, target));
            Reach { admissible: distance <= enough, value, span, x, point, distance }
        };
        let spans = match parameter {
            Parameter::LambdaOf(index) => {
                let count = self.points().len();
                let mut near = vec![(index + count - 2) % count, (index + count - 1) % count];
                near.retain(|span| *span < self.spans());
                near
            }
            _ => (0..self.spans()).collect(),
        };
        let mut best = None;
        for span in spans {
            let samples: Vec<Reach<D>> = (0..=STEPS).map(|k| reach(span, k as f64 / STEPS as f64)).collect();
            for k in 0..=STEPS {
                let (low, high) = (k.saturating_sub(1), (k + 1).min(STEPS));
                let here = samples[k];
                better(&mut best, here, present);
                if here.distance <= samples[low].distance && here.distance <= samples[high].distance {
                    let found = narrowed(&|x| reach(span, x), samples[low].x, samples[high].x);
                    better(&mut best, found, present);
                }
            }
        }
        Ok(best.unwrap_or_else(|| reach(0, 0.0)))
    }

    /// [`ShapedCurve::through`] by Newton's iteration. C- and F-curves are solved for `omega`: at 0 `alpha` has no effect.
    fn through_curves(
        &self,
        parameter: Parameter,
        target: Point<D>,
        enough: f64,
    ) -> Result<Reach<D>, GeometryError> {
        let family = self.basis().family();
        // Also the check that the family has it.
        let present = match (family.value(parameter), family, parameter) {
            (Some(value), ..) => value,
            (None, Family::FBezier { .. } | Family::FBSpline { .. }, Parameter::Alpha) => 0.0,
            _ => return Err(family.lacks(parameter)),
        };
        let square = |root: f64| root * root.abs();
        let (moved, limits, starts) = match (family, parameter) {
            (Family::Trig(trig), _) => {
                let least = trig.sides()[usize::from(parameter == Parameter::Beta)] as f64;
                let start = move |t: f64| least + (FAR_EXPONENT - least) * t * t;
                (parameter, [least, MAX_EXPONENT], sixteen(start))
            }
            (_, Parameter::Alpha) => (Parameter::Omega, [LEAST_OMEGA, OMEGA[1]], sixteen(|t| square(PI * t))),
            _ => (Parameter::Omega, OMEGA, sixteen(|t| square((PI + 30.0) * t - 30.0))),
        };
        let outward = |value: f64| if moved == parameter { value } else { value.sqrt().min(PI) };
        let mut arcs: Vec<(f64, usize)> = (0..self.spans())
            .map(|span| {
                let far = |k: u32| {
                    let point = self.eval(span, f64::from(k) / 16.0).unwrap_or([0.0; D]);
                    norm(scaled_difference(1.0, point, target))
                };
                ((0..=16).map(far).fold(f64::INFINITY, f64::min), span)
            })
            .collect();
        arcs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut best = None;
        for (_, span) in arcs.into_iter().take(NEAREST_ARCS) {
            let at = |value: f64, x: f64| self.at_by(&self.basis_with(moved, value).ok()?, span, x);
            for [value, x] in solve(&Problem { at: &at, target, limits, enough }, &starts) {
                let Some([point, ..]) = at(value, x) else { continue };
                let distance = norm(scaled_difference(1.0, point, target));
                let admissible = distance <= enough;
                let found = Reach { admissible, value: outward(value), span, x, point, distance };
                better(&mut best, found, present);
            }
            if best.is_some_and(|found: Reach<D>| found.admissible) {
                break;
            }
        }
        best.ok_or(GeometryError::Overflow { span: 0 })
    }
}

/// Sixteen values of a function between 0 and 1.
fn sixteen(value: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..16).map(|k| value((f64::from(k) + 0.5) / 16.0)).collect()
}

/// Keeps the better of two: what reaches the point, then the smaller change, then the smaller distance.
fn better<const D: usize>(best: &mut Option<Reach<D>>, found: Reach<D>, present: f64) {
    let wins = match best {
        None => true,
        Some(old) if old.admissible && found.admissible => {
            let (change, before) = ((found.value - present).abs(), (old.value - present).abs());
            // The same solution, found twice, is taken where it is met better.
            let same = (change - before).abs() <= 1e-6 * (1.0 + before);
            if same { found.distance < old.distance } else { change < before }
        }
        Some(old) if old.admissible || found.admissible => found.admissible,
        Some(old) => found.distance < old.distance,
    };
    if wins {
        *best = Some(found);
    }
}

/// The place of least distance between two, by golden sections.
fn narrowed<const D: usize>(reach: &dyn Fn(f64) -> Reach<D>, mut low: f64, mut high: f64) -> Reach<D> {
    let ratio = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (reach(high - ratio * (high - low)), reach(low + ratio * (high - low)));
    for _ in 0..SECTIONS {
        if a.distance < b.distance {
            (high, b) = (b.x, a);
            a = reach(high - ratio * (high - low));
        } else {
            (low, a) = (a.x, b);
            b = reach(low + ratio * (high - low));
        }
    }
    if a.distance < b.distance { a } else { b }
}
