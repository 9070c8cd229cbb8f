//! A planar PH curve: a row of segments, what is measured on it, and the places of what is found on it.

use super::length::Lengths;
use super::rational::RationalArc;
use super::segment::PhSegment;
use crate::geometry::method::Closure;
use crate::geometry::{GeometryError, ParamCurve, Point};

/// A place on a curve.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Place {
    /// The span, from 0.
    pub span: usize,
    /// The parameter in the span, 0 to 1.
    pub u: f64,
}

/// A place with the curvature there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvatureExtremum {
    /// Where.
    pub place: Place,
    /// The signed curvature, in 1/unit, positive where the curve turns left.
    pub curvature: f64,
}

/// A planar PH curve of one or more segments, each starting where the one before ends.
///
/// Made by [`PhCurve::spline`], [`PhCurve::hermite`] and [`PhCurve::cubics`]. Lengths, turning, extreme curvatures and
/// offsets of it are exact but for rounding.
///
/// ```
/// use grafika::geometry::ParamCurve;
/// use grafika::geometry::ph::{Knots, PhCurve, SplineEnds};
///
/// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
/// let curve = PhCurve::spline(Knots::Chord, SplineEnds::Closed, &square)?;
/// assert_eq!((curve.spans(), curve.eval(1, 0.0)), (4, Some([4.0, 0.0])));
/// // It turns left, so it once turns by a full turn, and an offset to the left is shorter.
/// assert!((curve.turning() - std::f64::consts::TAU).abs() < 1e-12);
/// assert!(curve.offset(0.5)?.length() < curve.total_length());
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PhCurve {
    segments: Vec<PhSegment>,
    closure: Closure,
    lengths: Lengths,
}

impl PhCurve {
    pub(super) fn new(closure: Closure, segments: Vec<PhSegment>) -> Self {
        let lengths = Lengths::new(segments.iter().map(PhSegment::speed_coefficients));
        Self { segments, closure, lengths }
    }

    /// The segments, one a span.
    #[must_use]
    pub fn segments(&self) -> &[PhSegment] {
        &self.segments
    }

    /// The curve as rational arcs, one a span, with all weights 1: as its offsets have them.
    #[must_use]
    pub fn arcs(&self) -> Vec<RationalArc> {
        let arc = |segment: &PhSegment| {
            RationalArc::new(segment.control().into_iter().map(|[x, y]| [x, y, 1.0]).collect())
        };
        self.segments.iter().map(arc).collect()
    }

    /// The exact length of the whole curve.
    #[must_use]
    pub fn total_length(&self) -> f64 {
        self.lengths.total()
    }

    /// The exact length of one span; `None` outside the spans.
    #[must_use]
    pub fn span_length(&self, span: usize) -> Option<f64> {
        self.lengths.of_span(span)
    }

    /// The exact length from the start of the curve to a place; `None` outside the spans.
    #[must_use]
    pub fn length_at(&self, place: Place) -> Option<f64> {
        self.lengths.at(place.span, place.u)
    }

    /// The place at the length `s` from the start, to about 1e-15 of the length; `s` is clipped to the curve. `None`
    /// only without spans.
    #[must_use]
    pub fn place_at_length(&self, s: f64) -> Option<Place> {
        self.lengths.place(s).map(|(span, u)| Place { span, u })
    }

    /// `steps + 1` places at equal lengths from each other, both ends included.
    ///
    /// # Errors
    /// [`GeometryError::Samples`] for no steps or more than [`MAX_SAMPLES`](crate::geometry::MAX_SAMPLES).
    pub fn equal_lengths(&self, steps: usize) -> Result<Vec<Place>, GeometryError> {
        super::equal_lengths(&self.lengths, steps)
    }

    /// The speed `|r'|` by the span's parameter; `None` outside the spans.
    #[must_use]
    pub fn speed(&self, place: Place) -> Option<f64> {
        Some(self.segments.get(place.span)?.speed(place.u))
    }

    /// The signed curvature, positive where the curve turns left; `None` outside the spans and at zero speed.
    #[must_use]
    pub fn curvature(&self, place: Place) -> Option<f64> {
        self.segments.get(place.span)?.curvature(place.u)
    }

    /// The unit normal to the left of the direction of travel; `None` outside the spans and at zero speed.
    #[must_use]
    pub fn normal(&self, place: Place) -> Option<Point<2>> {
        self.segments.get(place.span)?.normal(place.u)
    }

    /// How far the tangent turns along the whole curve, in radians, to the left positive. Corners between segments
    /// do not count.
    #[must_use]
    pub fn turning(&self) -> f64 {
        self.segments.iter().map(|segment| segment.turning(0.0, 1.0)).sum()
    }

    /// The integral of `|kappa|` over the length in full turns.
    #[must_use]
    pub fn absolute_rotation(&self) -> f64 {
        self.segments.iter().map(PhSegment::absolute_rotation).sum()
    }

    /// The bending energy, the integral of the squared curvature over the length, in 1/unit; `None` where it is
    /// infinite.
    #[must_use]
    pub fn energy(&self) -> Option<f64> {
        self.segments.iter().map(PhSegment::energy).sum()
    }

    /// The inflections in the order of the curve.
    #[must_use]
    pub fn inflections(&self) -> Vec<Place> {
        self.collect(|segment| segment.inflections())
    }

    /// The places inside the segments where the curvature has an extremum, in the order of the curve. The largest
    /// curvature may also lie at a joint or an end.
    #[must_use]
    pub fn curvature_extrema(&self) -> Vec<CurvatureExtremum> {
        let places = self.collect(|segment| segment.curvature_extrema());
        let extremum = |place| Some(CurvatureExtremum { place, curvature: self.curvature(place)? });
        places.into_iter().filter_map(extremum).collect()
    }

    /// The safe range of offset distances, `[below, above]`: for every distance between them the offset has no cusp,
    /// because `1 - d kappa` stays positive. `None` where there is no limit on that side. Both limits are 0 where the
    /// curve has a point of zero speed and infinite curvature on either side.
    #[must_use]
    pub fn offset_limits(&self) -> [Option<f64>; 2] {
        let mut extremes = [0.0_f64; 2];
        let mut note = |curvature: f64| {
            extremes = [extremes[0].min(curvature), extremes[1].max(curvature)];
        };
        for segment in &self.segments {
            let ends = [0.0, 1.0].into_iter().chain(segment.curvature_extrema());
            for u in ends {
                match segment.curvature(u) {
                    Some(curvature) => note(curvature),
                    None if segment.is_straight() => {}
                    None => [f64::NEG_INFINITY, f64::INFINITY].into_iter().for_each(&mut note),
                }
            }
        }
        let limit = |curvature: f64| Some(1.0 / curvature).filter(|_| curvature != 0.0);
        extremes.map(limit).map(|limit| limit.filter(|it| it.is_finite()))
    }

    /// What `find` finds on every segment, in the order of the curve; what the end of a segment and the beginning of
    /// the next find both comes once.
    pub(super) fn collect(&self, find: impl Fn(&PhSegment) -> Vec<f64>) -> Vec<Place> {
        let mut places: Vec<Place> = Vec::new();
        for (span, segment) in self.segments.iter().enumerate() {
            for u in find(segment) {
                let same = |last: &Place| last.span + 1 == span && last.u > 1.0 - JOINT && u < JOINT;
                if !places.last().is_some_and(same) {
                    places.push(Place { span, u });
                }
            }
        }
        places
    }

    pub(super) fn closure(&self) -> Closure {
        self.closure
    }
}

/// Places nearer to a joint than this, in the parameter, are at the joint.
pub(super) const JOINT: f64 = 1e-9;

impl ParamCurve<2> for PhCurve {
    fn spans(&self) -> usize {
        self.segments.len()
    }

    fn closed(&self) -> bool {
        self.closure == Closure::Closed
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<2>; 3]> {
        self.segments.get(span).map(|segment| segment.at(u))
    }

    /// The exact length, whatever the accuracy asked for.
    fn length(&self, _accuracy: f64) -> f64 {
        self.total_length()
    }
}
