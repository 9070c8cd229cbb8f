//! Functions that control points are blended by, and the curves of them.
//!
//! A basis knows neither points nor dimensions: it gives the weights of a place, and serves every curve of as many
//! points, and both directions of a surface ([`Weave`](super::Weave)).

use super::param::{ParamCurve, clipped, followed, measured, searched_box};
use super::point::{add_scaled, check_points};
use super::{BoundingBox, Chebyshev, CubicBezier, GeometryError, Point, Weights};
use std::fmt;
use std::sync::Arc;

/// Functions that control points are blended by: "span `s` at `u` is these weights times those points".
///
/// A weight comes with its first two derivatives at once: tangents and curvature are what curves and surfaces are
/// asked for, nothing asks for more, and bases that are derived by recursion have all three on the way.
pub trait Basis: fmt::Debug {
    /// The number of control points.
    fn points(&self) -> usize;

    /// The number of spans.
    fn spans(&self) -> usize;

    /// Whether the curves return to their beginning.
    fn closed(&self) -> bool;

    /// The number of the first control point that span `span` sees; `None` outside the spans. `out` is replaced by
    /// the weights of this point and its followers (after the last comes the first again), each with its first and
    /// second derivative by `u`, which is clipped to [0, 1]. All are numbers within 1e100.
    ///
    /// The weights of a place sum to 1 and their derivatives to 0, unless a basis says otherwise.
    fn weights(&self, span: usize, u: f64, out: &mut Vec<[f64; 3]>) -> Option<usize>;

    /// The weights of [`Basis::weights`] without their derivatives, the very doubles. A basis with a faster way to
    /// them has it here.
    fn values(&self, span: usize, u: f64, out: &mut Vec<f64>) -> Option<usize> {
        let mut weights = Vec::new();
        let first = self.weights(span, u, &mut weights)?;
        out.clear();
        out.extend(weights.into_iter().map(|[value, ..]| value));
        Some(first)
    }

    /// The values of all points' weights in a span as Chebyshev series, where the basis has them. They serve many points
    /// of a span at once; at its ends such a curve is at its first and last control point exactly.
    fn chebyshev(&self, _span: usize) -> Option<&Chebyshev> {
        None
    }

    /// The same as exact cubic arcs, where the functions are cubic at most.
    fn cubic(&self) -> Option<&Weights> {
        None
    }
}

/// What refers to a basis is one.
macro_rules! references {
    ($($reference:ty),*) => {$(
        impl<B: Basis + ?Sized> Basis for $reference {
            fn points(&self) -> usize {
                (**self).points()
            }

            fn spans(&self) -> usize {
                (**self).spans()
            }

            fn closed(&self) -> bool {
                (**self).closed()
            }

            fn weights(&self, span: usize, u: f64, out: &mut Vec<[f64; 3]>) -> Option<usize> {
                (**self).weights(span, u, out)
            }

            fn values(&self, span: usize, u: f64, out: &mut Vec<f64>) -> Option<usize> {
                (**self).values(span, u, out)
            }

            fn chebyshev(&self, span: usize) -> Option<&Chebyshev> {
                (**self).chebyshev(span)
            }

            fn cubic(&self) -> Option<&Weights> {
                (**self).cubic()
            }
        }
    )*};
}

references!(&B, Box<B>, Arc<B>);

/// A spline through the points sees all of them in every span, the other methods four at most.
impl Basis for Weights {
    fn points(&self) -> usize {
        Weights::points(self)
    }

    fn spans(&self) -> usize {
        Weights::spans(self)
    }

    fn closed(&self) -> bool {
        Weights::closed(self)
    }

    fn weights(&self, span: usize, u: f64, out: &mut Vec<[f64; 3]>) -> Option<usize> {
        let (first, coefficients) = self.functions(span)?;
        let u = clipped(u);
        out.clear();
        out.extend(coefficients.into_iter().map(|bernstein| {
            let function = CubicBezier { p: bernstein.map(|c| [c]) };
            let [[value], [slope], [bend]] =
                [function.eval(u), function.derivative(u), function.second_derivative(u)];
            [value, slope, bend]
        }));
        Some(first)
    }

    fn cubic(&self) -> Option<&Weights> {
        Some(self)
    }
}

/// A curve: control points blended by a basis. Exact cubic arcs where the basis is cubic.
///
/// ```
/// use grafika::geometry::{Blend, Closure, Method, ParamCurve, Weights};
///
/// let weights = Weights::new(Method::BSpline3, Closure::Closed, 4)?;
/// let square = vec![[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]];
/// let curve = Blend::new(&weights, square)?;
/// let [point, tangent, _] = curve.at(0, 0.0).expect("span 0 exists");
/// assert_eq!((point, tangent), ([1.0, 1.0], [3.0, -3.0]));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Blend<B, const D: usize> {
    basis: B,
    points: Vec<Point<D>>,
    /// Where the basis is cubic.
    arcs: Option<Vec<CubicBezier<D>>>,
}

impl<B: Basis, const D: usize> Blend<B, D> {
    /// The curve of these control points.
    ///
    /// # Errors
    /// [`GeometryError::WrongCount`] for another number of points than the basis is for, a bad coordinate, or
    /// [`GeometryError::Overflow`].
    pub fn new(basis: B, points: Vec<Point<D>>) -> Result<Self, GeometryError> {
        if points.len() != basis.points() {
            return Err(GeometryError::WrongCount { given: points.len(), needed: basis.points() });
        }
        check_points(&points)?;
        let arcs = basis.cubic().map(|weights| weights.arcs(&points)).transpose()?;
        Ok(Self { basis, points, arcs })
    }

    /// What the points are blended by.
    #[must_use]
    pub fn basis(&self) -> &B {
        &self.basis
    }

    /// The control points.
    #[must_use]
    pub fn points(&self) -> &[Point<D>] {
        &self.points
    }

    /// The point alone.
    fn point(&self, span: usize, u: f64, values: &mut Vec<f64>) -> Option<Point<D>> {
        let first = self.basis.values(span, u, values)?;
        Some(summed(values, self.points.iter().cycle().skip(first).copied()))
    }
}

/// Points blended by weights, by their first and by their second derivatives.
pub(super) fn blended<const D: usize>(
    weights: &[[f64; 3]],
    points: impl Iterator<Item = Point<D>>,
) -> [Point<D>; 3] {
    let mut sums = [[0.0; D]; 3];
    for (weights, point) in weights.iter().zip(points) {
        for (sum, &weight) in sums.iter_mut().zip(weights) {
            *sum = add_scaled(*sum, weight, point);
        }
    }
    sums
}

/// Points blended by weights alone.
pub(super) fn summed<const D: usize>(values: &[f64], points: impl Iterator<Item = Point<D>>) -> Point<D> {
    values.iter().zip(points).fold([0.0; D], |sum, (&value, point)| add_scaled(sum, value, point))
}

impl<B: Basis, const D: usize> ParamCurve<D> for Blend<B, D> {
    fn spans(&self) -> usize {
        self.basis.spans()
    }

    fn closed(&self) -> bool {
        self.basis.closed()
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        match &self.arcs {
            Some(arcs) => arcs.at(span, u),
            None => {
                let mut weights = Vec::new();
                let first = self.basis.weights(span, u, &mut weights)?;
                Some(blended(&weights, self.points.iter().cycle().skip(first).copied()))
            }
        }
    }

    fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        match &self.arcs {
            Some(arcs) => arcs.eval(span, u),
            None => self.point(span, u, &mut Vec::new()),
        }
    }

    fn sample_span(&self, span: usize, out: &mut [Point<D>]) {
        if let Some(arcs) = &self.arcs {
            return arcs.sample_span(span, out);
        }
        if let Some(functions) = self.basis.chebyshev(span) {
            functions.blend(&self.points, out);
            if let [start, .., end] = out {
                (*start, *end) = (self.points[0], self.points[self.points.len() - 1]);
            }
            return;
        }
        let steps = out.len().saturating_sub(1).max(1) as f64;
        let mut values = Vec::new();
        for (j, point) in out.iter_mut().enumerate() {
            *point = self.point(span, j as f64 / steps, &mut values).unwrap_or(*point);
        }
    }

    fn bounding_box(&self) -> Option<BoundingBox<D>> {
        self.arcs.as_ref().map_or_else(|| searched_box(self), ParamCurve::bounding_box)
    }

    fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        self.arcs.as_ref().map_or_else(|| followed(self, tolerance), |arcs| Ok(arcs.clone()))
    }

    fn length(&self, accuracy: f64) -> f64 {
        self.arcs.as_ref().map_or_else(|| measured(self, accuracy), |arcs| arcs.length(accuracy))
    }
}
