//! A whole curve: the arcs of a piecewise method, or the one arc of the Bézier curve.

use super::arcs::bezier_arcs;
use super::method::{Closure, Method};
use super::{Bezier, BoundingBox, CubicBezier, GeometryError, ParamCurve, Point, Weights};

/// A curve made of spans, each with its own parameter `u` in [0, 1].
#[derive(Clone, Debug, PartialEq)]
pub enum Curve<const D: usize> {
    /// Cubic arcs, one per span.
    Piecewise(Vec<CubicBezier<D>>),
    /// One span of any degree.
    Bezier(Bezier<D>),
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
        if method == Method::Arcs {
            return bezier_arcs(closure, points).map(Self::Piecewise);
        }
        let weights = Weights::new(method, closure, points.len())?;
        weights.arcs(points).map(Self::Piecewise)
    }

    /// What the curve is made of.
    fn parts(&self) -> &dyn ParamCurve<D> {
        match self {
            Self::Piecewise(arcs) => arcs,
            Self::Bezier(curve) => curve,
        }
    }
}

impl<const D: usize> ParamCurve<D> for Curve<D> {
    fn spans(&self) -> usize {
        self.parts().spans()
    }

    fn closed(&self) -> bool {
        self.parts().closed()
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        self.parts().at(span, u)
    }

    fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        self.parts().eval(span, u)
    }

    fn sample_span(&self, span: usize, out: &mut [Point<D>]) {
        self.parts().sample_span(span, out);
    }

    fn bounding_box(&self) -> Option<BoundingBox<D>> {
        self.parts().bounding_box()
    }

    fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        self.parts().to_cubics(tolerance)
    }

    fn length(&self, accuracy: f64) -> f64 {
        self.parts().length(accuracy)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::MAX_SAMPLES;

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
        assert_eq!(curve.at(usize::MAX, 0.5), None);
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
