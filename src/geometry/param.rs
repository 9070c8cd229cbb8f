//! What every curve can do, whatever it is made of.
//!
//! A kind of curve says how many spans it has and what it is like at a parameter; sampling, joints, box, length and
//! cubic arcs are written here once. A kind that knows a quicker or an exact way overrides them: cubic arcs are
//! sampled by Horner's scheme, Bézier and Fourier curves have arcs with a proven bound. Pictures, tables and editors
//! take a `&dyn ParamCurve` and know no kinds.

use super::arclen::integrate;
use super::cubic::check_arcs;
use super::limits::MAX_SAMPLES;
use super::point::{norm, scaled_difference};
use super::{BoundingBox, CubicBezier, GeometryError, Point};
use std::fmt;

/// A curve of spans, each with its own parameter `u` in [0, 1].
///
/// ```
/// use grafika::geometry::{Closure, Curve, Fourier, Method, ParamCurve, Wave};
///
/// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
/// let wave = |phase| Wave { amplitude: 2.0, phase };
/// let curves: [Box<dyn ParamCurve<2>>; 2] = [
///     Box::new(Curve::through(Method::Spline, Closure::Closed, &square)?),
///     Box::new(Fourier::new([2.0, 2.0], &[[wave(0.5), wave(0.0)]])?),
/// ];
/// for curve in &curves {
///     assert!(curve.closed());
///     assert_eq!(curve.polyline(10)?.len(), 10 * curve.spans() + 1);
///     assert!(curve.to_cubics(1e-6)?.len() >= curve.spans());
/// }
/// // The circle of radius 2.
/// assert!((curves[1].length(1e-9) - 4.0 * std::f64::consts::PI).abs() < 1e-8);
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
pub trait ParamCurve<const D: usize>: fmt::Debug {
    /// The number of spans.
    fn spans(&self) -> usize;

    /// Whether the curve returns to its beginning, so that its first span follows the last.
    fn closed(&self) -> bool;

    /// The point of span `span` at `u`, the first and the second derivative by `u` there. `u` is clipped to
    /// [0, 1]; `None` outside the spans. All numbers are finite.
    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]>;

    /// The point alone, the very doubles of [`ParamCurve::at`].
    fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        self.at(span, u).map(|[point, ..]| point)
    }

    /// Fills `out` with points of one span at equal steps of `u`, from 0 to 1; a single one is at 0. Does nothing
    /// outside the spans. What all sampling goes through: a curve with a fast way to many points has it here.
    fn sample_span(&self, span: usize, out: &mut [Point<D>]) {
        let steps = out.len().saturating_sub(1).max(1) as f64;
        for (j, point) in out.iter_mut().enumerate() {
            *point = self.eval(span, j as f64 / steps).unwrap_or(*point);
        }
    }

    /// Samples at `u = 0, 1 / per_span, …, 1` of every span; joints come twice, with `u = 1` and
    /// `u = 0`.
    ///
    /// # Errors
    /// [`GeometryError::Samples`] for no steps or more than [`MAX_SAMPLES`] samples.
    fn sample(&self, per_span: usize) -> Result<Vec<Sample<D>>, GeometryError> {
        samples(self, per_span).map(Iterator::collect)
    }

    /// The points of a polyline along the curve, `per_span` steps on every span; joints come once.
    ///
    /// # Errors
    /// As [`ParamCurve::sample`].
    fn polyline(&self, per_span: usize) -> Result<Vec<Point<D>>, GeometryError> {
        if check_samples(self.spans(), per_span)? == 0 {
            return Ok(Vec::new());
        }
        let mut points = vec![[0.0; D]; self.spans() * per_span + 1];
        for span in 0..self.spans() {
            let from = span * per_span;
            // Within the length above.
            self.sample_span(span, &mut points[from..=from + per_span]);
        }
        Ok(points)
    }

    /// Where spans begin and end: joint `i` is where span `i` begins, and an open curve has one more where it ends.
    fn joints(&self) -> Vec<Point<D>> {
        let starts = (0..self.spans()).filter_map(|span| self.eval(span, 0.0));
        let end = if self.closed() { None } else { self.eval(self.spans().saturating_sub(1), 1.0) };
        starts.chain(end).collect()
    }

    /// A box round the curve; `None` without spans. Here the extreme points are searched between 16 steps of every
    /// span, and one between two that turn together may be missed; curves of polynomials and sines have a box
    /// that is never too small.
    fn bounding_box(&self) -> Option<BoundingBox<D>> {
        searched_box(self)
    }

    /// Cubic arcs that are nowhere further from the curve than `tolerance`, in the unit of the points; exactly,
    /// where the curve is cubic. Here they run through four points of the curve each and are compared with it at
    /// five more, which is no proof; a curve with waves between these places gives its own arcs.
    ///
    /// # Errors
    /// A tolerance that is not positive, [`GeometryError::ToleranceTooSmall`] where arcs of a millionth of a span are
    /// not near enough, [`GeometryError::Overflow`]. Cubic curves take any tolerance.
    fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        followed(self, tolerance)
    }

    /// The curve's length, every span with an absolute error of about `accuracy`, which is not taken smaller
    /// than 1e-14 of the length (so 0 and NaN ask for the best possible).
    fn length(&self, accuracy: f64) -> f64 {
        measured(self, accuracy)
    }
}

/// The samples of [`ParamCurve::sample`] one by one, in memory of one span.
///
/// # Errors
/// As [`ParamCurve::sample`].
///
/// ```
/// use grafika::geometry::{Closure, Curve, Method, ParamCurve, samples};
///
/// let curve = Curve::through(Method::Spline, Closure::Open, &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]])?;
/// assert!(samples(&curve, 10)?.eq(curve.sample(10)?));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
pub fn samples<const D: usize>(
    curve: &(impl ParamCurve<D> + ?Sized),
    per_span: usize,
) -> Result<impl ExactSizeIterator<Item = Sample<D>>, GeometryError> {
    let rows = check_samples(curve.spans(), per_span)?;
    let mut points = Vec::new();
    Ok((0..rows).map(move |row| {
        let (span, step) = (row / (per_span + 1), row % (per_span + 1));
        if step == 0 {
            points.resize(per_span + 1, [0.0; D]);
            curve.sample_span(span, &mut points);
        }
        // The points are those of this span.
        let point = points.get(step).copied().unwrap_or([0.0; D]);
        Sample { span, u: step as f64 / per_span as f64, point }
    }))
}

/// A point of a curve with its place on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<const D: usize> {
    /// The span, from 0.
    pub span: usize,
    /// The parameter in the span, 0 to 1.
    pub u: f64,
    /// The point.
    pub point: Point<D>,
}

/// A parameter clipped to [0, 1]; what is not a number is 0.
pub(super) fn clipped(u: f64) -> f64 {
    if u > 0.0 { u.min(1.0) } else { 0.0 }
}

/// The check on a tolerance.
///
/// # Errors
/// [`GeometryError::Parameter`] for one that is not positive.
pub(super) fn check_tolerance(tolerance: f64) -> Result<(), GeometryError> {
    if tolerance > 0.0 {
        return Ok(());
    }
    let wanted = "a positive number";
    Err(GeometryError::Parameter { name: "tolerance", value: tolerance, wanted })
}

/// The number of samples for `per_span` steps.
fn check_samples(spans: usize, per_span: usize) -> Result<usize, GeometryError> {
    let most = (MAX_SAMPLES / spans.max(1)).saturating_sub(1);
    if per_span == 0 || per_span > most {
        return Err(GeometryError::Samples { per_span, most });
    }
    Ok(spans * (per_span + 1))
}

/// The box of a curve by search: [`ParamCurve::bounding_box`] where a curve has no better one.
pub(super) fn searched_box<const D: usize>(curve: &(impl ParamCurve<D> + ?Sized)) -> Option<BoundingBox<D>> {
    (0..curve.spans()).filter_map(|span| box_of_span(&|u| curve.at(span, u))).reduce(BoundingBox::union)
}

/// Cubic arcs that follow a curve: [`ParamCurve::to_cubics`] where a curve has no better ones.
pub(super) fn followed<const D: usize>(
    curve: &(impl ParamCurve<D> + ?Sized),
    tolerance: f64,
) -> Result<Vec<CubicBezier<D>>, GeometryError> {
    check_tolerance(tolerance)?;
    let mut arcs = Vec::new();
    for span in 0..curve.spans() {
        add_cubics(&|u| curve.eval(span, u), tolerance, &mut arcs)?;
    }
    check_arcs(arcs)
}

/// The length of a curve by its speed: [`ParamCurve::length`] where a curve has no better one.
pub(super) fn measured<const D: usize>(curve: &(impl ParamCurve<D> + ?Sized), accuracy: f64) -> f64 {
    (0..curve.spans()).map(|span| length_of_span(&|u| curve.at(span, u), accuracy)).sum()
}

/// A span as a function of its parameter.
pub(super) type Span<'a, T> = &'a dyn Fn(f64) -> Option<T>;

/// Steps between which the extreme points of a span are searched.
const BOX_STEPS: u32 = 16;
/// Halvings of such a step: the parameter is then a double's neighbour.
const HALVINGS: u32 = 50;

/// The box round a span whose derivatives vanish once a step at most.
fn box_of_span<const D: usize>(at: Span<'_, [Point<D>; 3]>) -> Option<BoundingBox<D>> {
    let places: Option<Vec<(f64, [Point<D>; 3])>> = (0..=BOX_STEPS)
        .map(|step| f64::from(step) / f64::from(BOX_STEPS))
        .map(|u| Some((u, at(u)?)))
        .collect();
    let places = places?;
    let points: Vec<Point<D>> = places.iter().map(|(_, [point, ..])| *point).collect();
    let mut bounds = BoundingBox::of_points(&points)?;
    for pair in places.windows(2) {
        let [(from, [_, slope, _]), (to, [_, other, _])] = [pair[0], pair[1]];
        for d in (0..D).filter(|&d| slope[d] * other[d] < 0.0) {
            let (mut near, mut far) = (from, to);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (near + far);
                let [point, between, _] = at(middle)?;
                bounds = bounds.union(BoundingBox::of_point(point));
                if between[d] * slope[d] > 0.0 {
                    near = middle;
                } else {
                    far = middle;
                }
            }
        }
    }
    Some(bounds)
}

/// The length of a span.
fn length_of_span<const D: usize>(at: Span<'_, [Point<D>; 3]>, accuracy: f64) -> f64 {
    let points: Vec<Point<D>> =
        (0..=8).filter_map(|step| at(f64::from(step) / 8.0)).map(|[point, ..]| point).collect();
    let polygon: f64 = points.windows(2).map(|leg| norm(scaled_difference(1.0, leg[0], leg[1]))).sum();
    let speed = |u: f64| at(u).map_or(0.0, |[_, derivative, _]| norm(derivative));
    integrate(&speed, [0.0, 1.0], accuracy.max(1e-14 * polygon))
}

/// The shortest arc, in the parameter of its span, that a span is cut into.
const SHORTEST_ARC: f64 = 1e-6;

/// Where an arc is compared with the curve that it has four points of: its error has its extremes near the first,
/// third and last of these.
const COMPARED: [f64; 5] = [0.125, 0.25, 0.5, 0.75, 0.875];

/// Adds the arcs of a span, which is halved until each of them is near enough.
pub(super) fn add_cubics<const D: usize>(
    at: Span<'_, Point<D>>,
    tolerance: f64,
    arcs: &mut Vec<CubicBezier<D>>,
) -> Result<(), GeometryError> {
    // The callers count the spans themselves.
    let point = |u: f64| at(u).unwrap_or([0.0; D]);
    let mut waiting = vec![[0.0, 1.0]];
    while let Some([from, to]) = waiting.pop() {
        let length = to - from;
        let [start, a, b, end] = [from, from + length / 3.0, to - length / 3.0, to].map(point);
        let arc = through(start, a, b, end);
        let off = COMPARED.iter().fold(0.0_f64, |off, t| {
            let (ours, theirs) = (arc.eval(*t), point(from + t * length));
            ours.iter().zip(theirs).fold(off, |off, (ours, theirs)| off.max((ours - theirs).abs()))
        });
        // Half of it by coordinate: together they are then below it in space too, with some room.
        if off <= tolerance / 2.0 {
            arcs.push(arc);
        } else if length < SHORTEST_ARC || arcs.len() > MAX_SAMPLES {
            return Err(GeometryError::ToleranceTooSmall { value: tolerance, least: 2.0 * off });
        } else {
            let middle = from + length / 2.0;
            waiting.extend([[middle, to], [from, middle]]);
        }
    }
    Ok(())
}

/// The cubic arc through four points at u = 0, 1/3, 2/3, 1.
fn through<const D: usize>(a: Point<D>, b: Point<D>, c: Point<D>, d: Point<D>) -> CubicBezier<D> {
    let inner = |near: Point<D>, next: Point<D>, other: Point<D>, far: Point<D>| -> Point<D> {
        std::array::from_fn(|axis| {
            (-5.0 * near[axis] + 18.0 * next[axis] - 9.0 * other[axis] + 2.0 * far[axis]) / 6.0
        })
    };
    CubicBezier { p: [a, inner(a, b, c, d), inner(d, c, b, a), d] }
}

/// Rows of cubic arcs, one a span.
impl<const D: usize> ParamCurve<D> for Vec<CubicBezier<D>> {
    fn spans(&self) -> usize {
        self.len()
    }

    /// Whether the last arc ends where the first begins; rounding does not count.
    fn closed(&self) -> bool {
        let (Some(first), Some(last)) = (self.first(), self.last()) else { return false };
        let bounds = BoundingBox::around(self.iter().flat_map(|arc| arc.p));
        let rounding = bounds.map_or(0.0, |it| it.rounding());
        first.p[0].iter().zip(last.p[3]).all(|(a, b)| (a - b).abs() <= rounding)
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        let (arc, u) = (self.get(span)?, clipped(u));
        Some([arc.eval(u), arc.derivative(u), arc.second_derivative(u)])
    }

    fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        self.get(span).map(|arc| arc.eval(clipped(u)))
    }

    fn sample_span(&self, span: usize, out: &mut [Point<D>]) {
        if let Some(arc) = self.get(span) {
            arc.sample_into(out);
        }
    }

    fn bounding_box(&self) -> Option<BoundingBox<D>> {
        self.iter().map(CubicBezier::bounding_box).reduce(BoundingBox::union)
    }

    fn to_cubics(&self, _tolerance: f64) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        Ok(self.clone())
    }

    fn length(&self, accuracy: f64) -> f64 {
        self.iter().map(|arc| arc.length(accuracy)).sum()
    }
}
