//! A whole curve: the arcs of a piecewise method, or the one arc of the Bézier curve.

use super::limits::MAX_SAMPLES;
use super::method::{Closure, Method};
use super::{Bezier, BoundingBox, CubicBezier, GeometryError, Point, Weights};

/// A curve made of spans, each with its own parameter `u` in [0, 1].
#[derive(Clone, Debug, PartialEq)]
pub enum Curve<const D: usize> {
    /// Cubic arcs, one per span.
    Piecewise(Vec<CubicBezier<D>>),
    /// One span of any degree.
    Bezier(Bezier<D>),
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

impl<const D: usize> Curve<D> {
    /// The curve of a method through or near these control points. To draw again while points
    /// move, keep [`Weights`] instead and call [`Weights::arcs`].
    ///
    /// # Errors
    /// Too few or too many points, a bad coordinate or parameter, the critical tension, or a curve
    /// beyond the coordinate limit.
    pub fn through(method: Method, closure: Closure, points: &[Point<D>]) -> Result<Self, GeometryError> {
        if method == Method::Bezier {
            return Bezier::new(closure, points).map(Self::Bezier);
        }
        let weights = Weights::new(method, closure, points.len())?;
        weights.arcs(points).map(Self::Piecewise)
    }

    /// The number of spans.
    #[must_use]
    pub fn spans(&self) -> usize {
        match self {
            Self::Piecewise(arcs) => arcs.len(),
            Self::Bezier(_) => 1,
        }
    }

    /// The point of span `span` at `u`, which is clipped to [0, 1]; `None` outside the spans.
    #[must_use]
    pub fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        self.at(span, u, CubicBezier::eval, Bezier::eval)
    }

    /// The derivative by `u` there.
    #[must_use]
    pub fn derivative(&self, span: usize, u: f64) -> Option<Point<D>> {
        self.at(span, u, CubicBezier::derivative, Bezier::derivative)
    }

    /// The second derivative by `u` there.
    #[must_use]
    pub fn second_derivative(&self, span: usize, u: f64) -> Option<Point<D>> {
        self.at(span, u, CubicBezier::second_derivative, Bezier::second_derivative)
    }

    fn at(
        &self,
        span: usize,
        u: f64,
        cubic: impl Fn(&CubicBezier<D>, f64) -> Point<D>,
        bezier: impl Fn(&Bezier<D>, f64) -> Point<D>,
    ) -> Option<Point<D>> {
        let u = u.clamp(0.0, 1.0);
        match self {
            Self::Piecewise(arcs) => arcs.get(span).map(|arc| cubic(arc, u)),
            Self::Bezier(curve) => (span == 0).then(|| bezier(curve, u)),
        }
    }

    /// Samples at `u = 0, 1 / per_span, …, 1` of every span; joints come twice, with `u = 1` and
    /// `u = 0`.
    ///
    /// # Errors
    /// [`GeometryError::Samples`] for no steps or more than [`MAX_SAMPLES`] samples.
    pub fn sample(&self, per_span: usize) -> Result<Vec<Sample<D>>, GeometryError> {
        let rows = self.check_samples(per_span)?;
        let mut points = vec![[0.0; D]; per_span + 1];
        let mut samples = Vec::with_capacity(rows);
        for span in 0..self.spans() {
            self.sample_span(span, &mut points);
            let sample = |(j, &point)| Sample { span, u: j as f64 / per_span as f64, point };
            samples.extend(points.iter().enumerate().map(sample));
        }
        Ok(samples)
    }

    /// The points of a polyline along the curve, `per_span` steps on every span; joints come once.
    ///
    /// # Errors
    /// As [`Curve::sample`].
    pub fn polyline(&self, per_span: usize) -> Result<Vec<Point<D>>, GeometryError> {
        if self.check_samples(per_span)? == 0 {
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

    /// The curve as cubic arcs: piecewise curves as they are, a Bézier curve of higher degree with
    /// an error of no more than `tolerance` at any parameter (see [`Bezier::to_cubics`]).
    ///
    /// # Errors
    /// A tolerance that is not positive or too small; piecewise curves take any.
    pub fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        match self {
            Self::Piecewise(arcs) => Ok(arcs.clone()),
            Self::Bezier(curve) => curve.to_cubics(tolerance),
        }
    }

    /// The smallest box round the curve; `None` for a piecewise curve without arcs.
    #[must_use]
    pub fn bounding_box(&self) -> Option<BoundingBox<D>> {
        match self {
            Self::Piecewise(arcs) => arcs.iter().map(CubicBezier::bounding_box).reduce(BoundingBox::union),
            Self::Bezier(curve) => Some(curve.bounding_box()),
        }
    }

    /// The curve's length, every span with an absolute error of about `accuracy`.
    #[must_use]
    pub fn length(&self, accuracy: f64) -> f64 {
        match self {
            Self::Piecewise(arcs) => arcs.iter().map(|arc| arc.length(accuracy)).sum(),
            Self::Bezier(curve) => curve.length(accuracy),
        }
    }

    /// Fills `out` with points of one span at equal steps of `u`.
    fn sample_span(&self, span: usize, out: &mut [Point<D>]) {
        match self {
            Self::Piecewise(arcs) => {
                if let Some(arc) = arcs.get(span) {
                    arc.sample_into(out);
                }
            }
            Self::Bezier(curve) => {
                let steps = out.len().saturating_sub(1).max(1) as f64;
                for (j, point) in out.iter_mut().enumerate() {
                    *point = curve.eval(j as f64 / steps);
                }
            }
        }
    }

    /// The number of samples for `per_span` steps.
    fn check_samples(&self, per_span: usize) -> Result<usize, GeometryError> {
        let most = (MAX_SAMPLES / self.spans().max(1)).saturating_sub(1);
        if per_span == 0 || per_span > most {
            return Err(GeometryError::Samples { per_span, most });
        }
        Ok(self.spans() * (per_span + 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Point<2>; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];

    fn curve(method: Method) -> Curve<2> {
        Curve::through(method, Closure::Open, &SQUARE).unwrap()
    }

    #[test]
    fn samples_are_rows_of_every_span() {
        for method in [Method::Spline, Method::Bezier] {
            let curve = curve(method);
            let samples = curve.sample(4).unwrap();
            assert_eq!(samples.len(), 5 * curve.spans());
            for (row, sample) in samples.iter().enumerate() {
                assert_eq!((sample.span, sample.u), (row / 5, (row % 5) as f64 / 4.0));
                let [x, y] = curve.eval(sample.span, sample.u).unwrap();
                assert!((sample.point[0] - x).abs() < 1e-14 && (sample.point[1] - y).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn polyline_has_every_joint_once() {
        let line = curve(Method::Spline).polyline(10).unwrap();
        assert_eq!(line.len(), 31);
        assert_eq!([line[0], line[10], line[20], line[30]], SQUARE);
    }

    #[test]
    fn places_outside_are_clipped_or_none() {
        let curve = curve(Method::Spline);
        assert_eq!(curve.eval(3, 0.5), None);
        assert_eq!(curve.derivative(usize::MAX, 0.5), None);
        assert_eq!(curve.eval(0, -7.0), Some(SQUARE[0]));
        assert_eq!(curve.eval(2, 1e300), Some(SQUARE[3]));
    }

    #[test]
    fn absurd_sample_counts_are_errors() {
        let curve = curve(Method::Spline);
        for per_span in [0, MAX_SAMPLES, usize::MAX] {
            assert!(matches!(curve.sample(per_span), Err(GeometryError::Samples { .. })));
            assert!(matches!(curve.polyline(per_span), Err(GeometryError::Samples { .. })));
        }
    }

    #[test]
    fn curve_without_arcs_answers_with_nothing() {
        let nothing = Curve::<2>::Piecewise(Vec::new());
        assert_eq!((nothing.spans(), nothing.eval(0, 0.0), nothing.bounding_box()), (0, None, None));
        assert_eq!((nothing.sample(3), nothing.polyline(3)), (Ok(Vec::new()), Ok(Vec::new())));
        assert_eq!(nothing.length(1e-9), 0.0);
    }
}
