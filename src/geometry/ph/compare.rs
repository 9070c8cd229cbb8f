//! Approximate offsets for comparison with the exact one: by Tiller and Hanson (1984), and by Hermite cubics.

use super::bernstein::{eval, split};
use super::complex::Complex;
use super::curve::{PhCurve, Place};
use super::offset::Offset;
use super::rational::RationalArc;
use super::rational_curve::RationalCurve;
use super::segment::PhSegment;
use crate::geometry::{GeometryError, ParamCurve};

/// How an offset is approximated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rule {
    /// The legs of the control polygon are moved by the distance and intersected. The error falls by 4 where pieces
    /// are halved.
    TillerHanson,
    /// Cubics with the exact end points and end derivatives. The error falls by 16.
    Hermite,
}

/// A curve of polynomial pieces near an offset.
#[derive(Clone, Debug, PartialEq)]
pub struct ApproximateOffset {
    curve: RationalCurve,
    /// The span and the range of its parameter that every piece is for.
    ranges: Vec<(usize, [f64; 2])>,
    of: PhCurve,
    distance: f64,
}

/// The most pieces a span.
const MOST_PIECES: usize = 1024;
/// How often a piece is halved where legs of its polygon turn back.
const HALVINGS: u32 = 8;

impl Offset {
    /// An approximation of this offset by so many pieces a span; where the legs of a control polygon turn back,
    /// Tiller and Hanson's has some more.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for no pieces or more than 1024 a span, [`GeometryError::Overflow`].
    pub fn approximated(&self, rule: Rule, pieces: usize) -> Result<ApproximateOffset, GeometryError> {
        if !(1..=MOST_PIECES).contains(&pieces) {
            let value = pieces as f64;
            return Err(GeometryError::Parameter { name: "number of pieces", value, wanted: "1 to 1024" });
        }
        let mut found: Vec<(Vec<Complex>, (usize, [f64; 2]))> = Vec::new();
        for (span, segment) in self.curve().segments().iter().enumerate() {
            for k in 0..pieces {
                let range = [k, k + 1].map(|k| k as f64 / pieces as f64);
                match rule {
                    Rule::TillerHanson => {
                        let control = part(segment.parts().control, range);
                        self.add_moved(&control, (span, range), HALVINGS, &mut found);
                    }
                    Rule::Hermite => found.push((self.cubic(segment, range), (span, range))),
                }
            }
        }
        let (arcs, ranges): (Vec<RationalArc>, Vec<_>) = found
            .into_iter()
            .map(|(points, range)| {
                let points = points.into_iter().map(|point| [point.re, point.im, 1.0]);
                (RationalArc::new(points.collect()), range)
            })
            .unzip();
        let curve = RationalCurve::new(arcs, ParamCurve::closed(self))?;
        Ok(ApproximateOffset { curve, ranges, of: self.curve().clone(), distance: self.distance() })
    }

    /// The cubic with the offset's end points and end derivatives over a range.
    fn cubic(&self, segment: &PhSegment, range: [f64; 2]) -> Vec<Complex> {
        let [(start, first), (end, last)] = range.map(|u| {
            let [point, slope] = self.moved(segment, u);
            (point, slope * ((range[1] - range[0]) / 3.0))
        });
        vec![start, start + first, end - last, end]
    }

    /// The polygon with its legs moved, in halves where two of them turn back.
    fn add_moved(
        &self,
        control: &[Complex],
        (span, [from, to]): (usize, [f64; 2]),
        depth: u32,
        found: &mut Vec<(Vec<Complex>, (usize, [f64; 2]))>,
    ) {
        let legs: Vec<Complex> = control.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let unit = |leg: &Complex| {
            let length = leg.norm();
            (length > 0.0).then(|| (*leg * (1.0 / length)).left())
        };
        let mut normals: Vec<Option<Complex>> = legs.iter().map(unit).collect();
        // A leg of no length has the direction of the one before, or of the first that has one.
        let mut known = normals.iter().flatten().next().copied();
        for normal in &mut normals {
            known = normal.or(known);
            *normal = known;
        }
        let normals: Vec<Complex> = normals.into_iter().flatten().collect();
        let back = |pair: &[Complex]| pair[0].dot(pair[1]) < -0.99;
        if depth > 0 && normals.windows(2).any(back) {
            let [left, right] = split(control, 0.5);
            let middle = 0.5 * (from + to);
            self.add_moved(&left, (span, [from, middle]), depth - 1, found);
            self.add_moved(&right, (span, [middle, to]), depth - 1, found);
            return;
        }
        let shift = |k: usize| match (k.checked_sub(1).and_then(|k| normals.get(k)), normals.get(k)) {
            // P + d (n + m) / (1 + n . m), where the moved legs meet.
            (Some(&before), Some(&after)) if !back(&[before, after]) => {
                (before + after) * (1.0 / (1.0 + before.dot(after)))
            }
            (Some(&normal), _) | (None, Some(&normal)) => normal,
            (None, None) => Complex::default(),
        };
        let moved = control.iter().enumerate().map(|(k, &point)| point + shift(k) * self.distance());
        found.push((moved.collect(), (span, [from, to])));
    }
}

/// The control points of a part of a polynomial.
fn part(control: &[Complex], [from, to]: [f64; 2]) -> Vec<Complex> {
    let [before, _] = split(control, to);
    let [_, part] = split(&before, from / to);
    part
}

impl ApproximateOffset {
    /// The approximation as a curve; its spans are the pieces.
    #[must_use]
    pub fn curve(&self) -> &RationalCurve {
        &self.curve
    }

    /// How far points of every piece, at `steps` equal steps, are from the distance: the places of the exact curve that
    /// they belong to, and `| |p - r| - |d| |` with the point `r` of the curve nearest to `p`, in the unit of the points.
    #[must_use]
    pub fn deviations(&self, steps: usize) -> Vec<(Place, f64)> {
        let steps = steps.max(1);
        let mut found = Vec::with_capacity(self.ranges.len() * (steps + 1));
        for (piece, &(span, [from, to])) in self.ranges.iter().enumerate() {
            for k in 0..=steps {
                let t = k as f64 / steps as f64;
                let u = from + (to - from) * t;
                let (Some(point), Some(segment)) = (self.curve.eval(piece, t), self.of.segments().get(span))
                else {
                    continue;
                };
                let gap = gap(segment, point.into(), u);
                found.push((Place { span, u }, (gap - self.distance.abs()).abs()));
            }
        }
        found
    }

    /// The largest of [`ApproximateOffset::deviations`].
    #[must_use]
    pub fn largest_deviation(&self, steps: usize) -> f64 {
        self.deviations(steps).into_iter().fold(0.0, |most, (_, off)| most.max(off))
    }
}

/// The distance of a point from a segment, whose nearest point is searched from `u` on by Newton's method for
/// `(r - p) . r' = 0`. Beyond its ends the segment goes on as the same polynomial.
fn gap(segment: &PhSegment, point: Complex, mut u: f64) -> f64 {
    let control = segment.parts().control;
    let from = |u: f64| eval(control, u) - point;
    let mut best = from(u).norm();
    for _ in 0..20 {
        let [_, slope, bend] = segment.at(u).map(Complex::from);
        let away = from(u);
        let steep = slope.norm_squared() + away.dot(bend);
        let step = away.dot(slope) / if steep > 0.0 { steep } else { slope.norm_squared() };
        let next = (u - step).clamp(0.0, 1.0);
        let gap = from(next).norm();
        if !(gap < best) {
            break;
        }
        (u, best) = (next, gap);
    }
    best
}

#[cfg(test)]
mod tests {
    use super::super::{Knots, SplineEnd, SplineEnds};
    use super::*;

    fn cam() -> PhCurve {
        let points = [
            [430.0, 190.0],
            [395.0, 290.0],
            [290.0, 330.0],
            [190.0, 300.0],
            [150.0, 200.0],
            [185.0, 105.0],
            [270.0, 60.0],
            [350.0, 85.0],
        ];
        PhCurve::spline(Knots::Chord, SplineEnds::Closed, &points).unwrap()
    }

    fn bay() -> PhCurve {
        let points =
            [[60.0, 120.0], [150.0, 300.0], [250.0, 170.0], [330.0, 110.0], [420.0, 190.0], [500.0, 320.0]];
        PhCurve::spline(Knots::Chord, SplineEnds::Open([SplineEnd::Cubic; 2]), &points).unwrap()
    }

    #[test]
    fn errors_are_those_that_were_measured() {
        // The largest errors in pixels for 1, 2, 4 and 8 pieces a span.
        let table = [
            (cam(), 20.0, Rule::TillerHanson, [0.474, 0.161, 0.0476, 0.0129]),
            (cam(), 20.0, Rule::Hermite, [0.295, 0.0186, 0.00129, 8.3e-5]),
            (bay(), -40.0, Rule::TillerHanson, [5.43, 1.88, 0.524, 0.133]),
            (bay(), -40.0, Rule::Hermite, [3.71, 0.761, 0.0709, 0.0046]),
        ];
        for (curve, d, rule, errors) in table {
            let offset = curve.offset(d).unwrap();
            for (pieces, want) in [1, 2, 4, 8].into_iter().zip(errors) {
                let found = offset.approximated(rule, pieces).unwrap().largest_deviation(64);
                assert!((found - want).abs() < 0.03 * want, "{rule:?} {pieces}: {found}, not {want}");
            }
        }
    }

    #[test]
    fn errors_fall_by_4_and_by_16() {
        for (curve, d) in [(cam(), 20.0), (bay(), -40.0)] {
            let offset = curve.offset(d).unwrap();
            for (rule, least) in [(Rule::TillerHanson, 3.7), (Rule::Hermite, 13.0)] {
                let of = |pieces| offset.approximated(rule, pieces).unwrap().largest_deviation(32);
                let ratio = of(16) / of(32);
                assert!((least..least * 1.4).contains(&ratio), "{rule:?}: {ratio}");
            }
        }
    }

    #[test]
    fn straight_lines_and_turned_legs() {
        let line =
            PhCurve::hermite(crate::geometry::Closure::Open, &[[0.0, 0.0], [9.0, 0.0]], &[[9.0, 0.0]; 2]);
        let offset = line.unwrap().offset(2.0).unwrap();
        for rule in [Rule::TillerHanson, Rule::Hermite] {
            let near = offset.approximated(rule, 3).unwrap();
            assert!(near.largest_deviation(9) < 1e-14);
            assert_eq!(near.curve().eval(0, 0.0), Some([0.0, 2.0]), "to the left");
            assert!(offset.approximated(rule, 0).is_err() && offset.approximated(rule, 2000).is_err());
        }
        // Runs back and forth: legs turn back.
        let points = [[0.0, 0.0], [100.0, 0.0]];
        let loops =
            PhCurve::hermite(crate::geometry::Closure::Open, &points, &[[-900.0, 1.0], [-900.0, 0.0]]);
        let near = loops.unwrap().offset(5.0).unwrap().approximated(Rule::TillerHanson, 1).unwrap();
        assert!(near.deviations(8).iter().all(|(_, off)| off.is_finite()));
    }
}
