//! A curve of PH quintics in space.

use super::curve::Place;
use super::frame::{start_angles, turned};
use super::hermite::ends_of_spans;
use super::length::Lengths;
use super::space::{SpacePhSegment, quintic};
use crate::geometry::method::Closure;
use crate::geometry::{GeometryError, ParamCurve, Point};

/// PH quintics in space in a row, each starting where the one before ends.
///
/// ```
/// use grafika::geometry::ph::{Place, SpacePhCurve};
/// use grafika::geometry::{Closure, ParamCurve, norm};
///
/// let points = [[100.0, 0.0, 0.0], [0.0, 100.0, 50.0]];
/// let curve = SpacePhCurve::hermite(Closure::Open, &points, &[[0.0, 150.0, 50.0], [-150.0, 0.0, 50.0]])?;
/// let half = curve.place_at_length(0.5 * curve.total_length()).expect("there is a span");
/// assert!((half.u - 0.5).abs() < 1e-12);
/// let [tangent, second, _] = curve.frame(half).expect("the curve does not stop");
/// assert!((norm(tangent) - 1.0).abs() < 1e-12 && (norm(second) - 1.0).abs() < 1e-12);
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpacePhCurve {
    segments: Vec<SpacePhSegment>,
    closure: Closure,
    lengths: Lengths,
    /// The angle from the Euler-Rodrigues frame to the rotation-minimising one at the start of every segment.
    angles: Vec<f64>,
}

impl SpacePhCurve {
    /// PH quintics through `points` with these derivatives, one per point, by every span's parameter in [0, 1]
    /// ([`SpacePhSegment::hermite`]). The curve is C1.
    ///
    /// # Errors
    /// Fewer than 2 points (3 when closed), another number of tangents than points, a bad coordinate in either
    /// (counted from 1), [`GeometryError::EqualNeighbours`] where two successive points are equal and both
    /// tangents zero, [`GeometryError::Overflow`].
    pub fn hermite(
        closure: Closure,
        points: &[Point<3>],
        tangents: &[Point<3>],
    ) -> Result<Self, GeometryError> {
        let spans = ends_of_spans(closure, points, tangents)?;
        let segments: Vec<SpacePhSegment> = spans
            .map(|(span, points, tangents)| quintic(span, points, tangents))
            .collect::<Result<_, _>>()?;
        let lengths = Lengths::new(segments.iter().map(SpacePhSegment::speed_coefficients));
        let angles = start_angles(&segments);
        Ok(Self { segments, closure, lengths, angles })
    }

    /// The segments, one a span.
    #[must_use]
    pub fn segments(&self) -> &[SpacePhSegment] {
        &self.segments
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

    /// The curvature, not negative; `None` outside the spans and at zero speed.
    #[must_use]
    pub fn curvature(&self, place: Place) -> Option<f64> {
        self.segments.get(place.span)?.curvature(place.u)
    }

    /// The Euler-Rodrigues frame of the span: unit tangent and two unit vectors across it. It depends on the span's
    /// standard position and may jump at joints. `None` outside the spans and at zero speed.
    #[must_use]
    pub fn frame(&self, place: Place) -> Option<[Point<3>; 3]> {
        self.segments.get(place.span)?.frame(place.u)
    }

    /// The rotation-minimising frame: unit tangent and two unit vectors across it that do not turn about the tangent.
    /// It starts as the Euler-Rodrigues frame of the first span and goes on over joints. `None` outside the spans and
    /// at zero speed.
    #[must_use]
    pub fn minimal_frame(&self, place: Place) -> Option<[Point<3>; 3]> {
        let segment = self.segments.get(place.span)?;
        let angle = self.angles.get(place.span)? - segment.twisted(place.u);
        Some(turned(segment.frame(place.u)?, angle))
    }

    /// The bending energy, in 1/unit; `None` where it is infinite.
    #[must_use]
    pub fn energy(&self) -> Option<f64> {
        self.segments.iter().map(SpacePhSegment::energy).sum()
    }
}

impl ParamCurve<3> for SpacePhCurve {
    fn spans(&self) -> usize {
        self.segments.len()
    }

    fn closed(&self) -> bool {
        self.closure == Closure::Closed
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<3>; 3]> {
        self.segments.get(span).map(|segment| segment.at(u))
    }

    /// The exact length, whatever the accuracy asked for.
    fn length(&self, _accuracy: f64) -> f64 {
        self.total_length()
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::distance;
    use super::*;
    use crate::geometry::dot;

    const POINTS: [Point<3>; 3] = [[100.0, 0.0, 0.0], [0.0, 100.0, 50.0], [-100.0, 0.0, 100.0]];
    const TANGENTS: [Point<3>; 3] = [[0.0, 150.0, 50.0], [-150.0, 0.0, 50.0], [0.0, -150.0, 50.0]];

    fn screw() -> SpacePhCurve {
        SpacePhCurve::hermite(Closure::Open, &POINTS, &TANGENTS).unwrap()
    }

    #[test]
    fn equal_lengths_are_equal() {
        let curve = screw();
        let places = curve.equal_lengths(20).unwrap();
        let lengths: Vec<f64> = places.iter().map(|place| curve.length_at(*place).unwrap()).collect();
        let step = curve.total_length() / 20.0;
        assert!(lengths.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() < 1e-12));
        assert!((curve.length(1e-9) - crate::geometry::param::measured(&curve, 1e-10)).abs() < 1e-8);
        assert!(curve.equal_lengths(0).is_err());
    }

    #[test]
    fn the_minimal_frame_does_not_turn_about_the_tangent() {
        let curve = screw();
        let h = 1e-5;
        for span in 0..2 {
            for k in 1..10 {
                let u = f64::from(k) / 10.0;
                let [_, _, third] = curve.minimal_frame(Place { span, u }).unwrap();
                let [before, after] =
                    [u - h, u + h].map(|u| curve.minimal_frame(Place { span, u }).unwrap()[1]);
                let change: Point<3> = std::array::from_fn(|d| (after[d] - before[d]) / (2.0 * h));
                assert!(dot(change, third).abs() < 1e-8);
            }
        }
        // It goes on over the joint, where the Euler-Rodrigues frame need not.
        let ends = [Place { span: 0, u: 1.0 }, Place { span: 1, u: 0.0 }];
        let [end, start] = ends.map(|place| curve.minimal_frame(place).unwrap());
        assert!((0..3).all(|axis| distance(end[axis], start[axis]) < 1e-12));
        let [end, start] = ends.map(|place| curve.frame(place).unwrap());
        assert!(distance(end[1], start[1]) > 0.01);
    }

    #[test]
    fn the_minimal_frame_agrees_with_double_reflection() {
        // Wang, Juettler, Zheng and Liu 2008: two reflections carry a frame from one point to the next.
        let curve = screw();
        let steps = 400;
        let place = |k: usize| Place { span: 2 * k / steps, u: (2 * k % steps) as f64 / steps as f64 };
        let tangent = |k: usize| curve.frame(place(k)).unwrap()[0];
        let reflect = |v: Point<3>, axis: Point<3>| -> Point<3> {
            let factor = 2.0 * dot(v, axis) / dot(axis, axis);
            std::array::from_fn(|d| v[d] - factor * axis[d])
        };
        let minus = |a: Point<3>, b: Point<3>| -> Point<3> { std::array::from_fn(|d| a[d] - b[d]) };
        let mut carried = curve.minimal_frame(place(0)).unwrap()[1];
        for k in 0..steps - 1 {
            let [p, q] = [k, k + 1].map(|k| curve.eval(place(k).span, place(k).u).unwrap());
            let chord = minus(q, p);
            let (vector, direction) = (reflect(carried, chord), reflect(tangent(k), chord));
            carried = reflect(vector, minus(tangent(k + 1), direction));
        }
        assert!(distance(carried, curve.minimal_frame(place(steps - 1)).unwrap()[1]) < 1e-7);
    }

    #[test]
    fn a_closed_curve_comes_back() {
        let curve = SpacePhCurve::hermite(Closure::Closed, &POINTS, &TANGENTS).unwrap();
        assert_eq!((curve.spans(), curve.closed()), (3, true));
        assert_eq!(curve.eval(2, 1.0), Some(POINTS[0]));
        assert!(curve.energy().is_some_and(|energy| energy > 0.0));
        assert_eq!(curve.frame(Place { span: 3, u: 0.0 }), None);
    }
}
