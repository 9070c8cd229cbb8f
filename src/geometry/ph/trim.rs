//! Trimming: the parts of an offset that keep their distance from the whole curve.

use super::bernstein::{elevated, product, size, split};
use super::complex::Complex;
use super::crossings::{Crossing, crossings};
use super::curve::{JOINT, PhCurve, Place};
use super::offset::Offset;
use super::roots::roots;
use crate::geometry::method::Closure;

/// Where an offset crosses itself, and which parts of it stay.
#[derive(Clone, Debug, PartialEq)]
pub struct Trimmed {
    /// The crossings, ordered by the first place.
    pub crossings: Vec<Crossing>,
    /// The stretches `[from, to]` of the offset that keep the distance, in the order of the curve; none where the
    /// whole offset vanishes. A stretch over the start of a closed curve comes as two.
    pub kept: Vec<[Place; 2]>,
}

/// How much nearer than the distance a point may be, as a share: rounding and touching do not count.
const SLACK: f64 = 1e-7;
/// Stretches shorter than this, in the parameter, are no stretches.
const SHORTEST: f64 = 1e-11;

impl Offset {
    /// The crossings of the offset and its parts that are not nearer to the curve than the distance: the path of a
    /// tool that does not cut into the shape.
    ///
    /// The offset is cut at cusps and crossings; a piece stays when its middle keeps the distance from all spans. Of a
    /// closed curve all that stays keeps the distance. Of an open one, a piece that stays may come nearer to an end of
    /// the curve; [`Offset::trimmed_at_ends`] cuts there too.
    #[must_use]
    pub fn trimmed(&self) -> Trimmed {
        self.cut(false)
    }

    /// As [`Offset::trimmed`], but also cut at the circles of the distance round the ends of an open curve, so that
    /// all that stays keeps the distance from the ends too.
    #[must_use]
    pub fn trimmed_at_ends(&self) -> Trimmed {
        self.cut(true)
    }

    fn cut(&self, at_ends: bool) -> Trimmed {
        let crossings = crossings(self);
        let mut cuts: Vec<Place> = self.cusps().to_vec();
        cuts.extend(crossings.iter().flat_map(|crossing| crossing.places));
        let nearness = Nearness::new(self.curve(), self.distance().abs() * (1.0 - SLACK));
        if at_ends {
            cuts.extend(nearness.end_circles(self));
        }
        // The ends of spans are cuts anyway.
        cuts.retain(|cut| cut.u > JOINT && cut.u < 1.0 - JOINT);
        cuts.sort_by(|a, b| a.span.cmp(&b.span).then(a.u.total_cmp(&b.u)));
        let mut kept: Vec<[Place; 2]> = Vec::new();
        let mut cuts = cuts.into_iter().peekable();
        for (span, segment) in self.curve().segments().iter().enumerate() {
            let mut from = 0.0;
            while from < 1.0 {
                let to = cuts.next_if(|cut| cut.span == span).map_or(1.0, |cut| cut.u);
                if to - from <= SHORTEST {
                    continue;
                }
                let [middle, _] = self.moved(segment, 0.5 * (from + to));
                if !nearness.is_near(middle, span) {
                    keep(&mut kept, Place { span, u: from }, Place { span, u: to });
                }
                from = to;
            }
        }
        Trimmed { crossings, kept }
    }
}

/// Adds a stretch, or lengthens the last one where it begins there.
fn keep(kept: &mut Vec<[Place; 2]>, from: Place, to: Place) {
    match kept.last_mut() {
        Some([_, end]) if meets(*end, from) => *end = to,
        _ => kept.push([from, to]),
    }
}

/// Whether a stretch from `next` goes on where one ends.
fn meets(end: Place, next: Place) -> bool {
    let joint = end.span + 1 == next.span && end.u > 1.0 - SHORTEST && next.u < SHORTEST;
    joint || (end.span == next.span && next.u - end.u <= SHORTEST)
}

/// The question whether a point is nearer to a curve than a distance.
struct Nearness<'a> {
    curve: &'a PhCurve,
    distance: f64,
    /// A box round the control points of every span: smallest and largest coordinates.
    boxes: Vec<[Complex; 2]>,
}

/// How often a span is halved at most.
const HALVINGS: u32 = 48;

impl<'a> Nearness<'a> {
    fn new(curve: &'a PhCurve, distance: f64) -> Self {
        let around = |points: &[Complex]| {
            let far = Complex::new(f64::INFINITY, f64::INFINITY);
            points.iter().fold([far, -far], |[low, high], p| {
                [
                    Complex::new(low.re.min(p.re), low.im.min(p.im)),
                    Complex::new(high.re.max(p.re), high.im.max(p.im)),
                ]
            })
        };
        let boxes = curve.segments().iter().map(|segment| around(segment.parts().control)).collect();
        Self { curve, distance, boxes }
    }

    /// Whether the point is nearer than the distance. Spans are asked in the order of their distance from `first`
    /// along the curve, since a point that is near is mostly near to spans there.
    fn is_near(&self, point: Complex, first: usize) -> bool {
        let spans = self.boxes.len();
        let outwards = (0..spans).flat_map(|k| {
            let before = first.checked_sub(k).filter(|_| k > 0);
            [Some(first + k).filter(|span| *span < spans), before]
        });
        outwards.flatten().any(|span| {
            self.box_is_within(self.distance, span, point)
                && self.is_near_span(point, self.curve.segments()[span].parts().control)
        })
    }

    /// Whether the box of a span comes nearer to a point than `reach`.
    fn box_is_within(&self, reach: f64, span: usize, point: Complex) -> bool {
        let [low, high] = self.boxes[span];
        let outside = |x: f64, low: f64, high: f64| (low - x).max(x - high).max(0.0);
        let gap = [outside(point.re, low.re, high.re), outside(point.im, low.im, high.im)];
        // By coordinate first: most boxes are far away.
        gap[0] < reach && gap[1] < reach && gap[0].hypot(gap[1]) < reach
    }

    /// Where an offset of an open curve meets the circles of its distance round the ends `e` of the curve, in any
    /// order: the roots of `sigma (|r + d n - e|^2 - d^2) = sigma |r - e|^2 + 2 d (i r') . (r - e)`.
    fn end_circles(&self, offset: &Offset) -> Vec<Place> {
        let segments = self.curve.segments();
        let mut places = Vec::new();
        let (Closure::Open, [first, ..], [.., last]) = (self.curve.closure(), segments, segments) else {
            return places;
        };
        let twice = 2.0 * offset.distance();
        for end in [first.parts().control.first(), last.parts().control.last()].into_iter().flatten() {
            for (span, segment) in segments.iter().enumerate() {
                if !self.box_is_within(twice.abs(), span, *end) {
                    continue;
                }
                let parts = segment.parts();
                let from: Vec<Complex> = parts.control.iter().map(|&p| p - *end).collect();
                let conj: Vec<Complex> = from.iter().map(|p| p.conj()).collect();
                let square: Vec<f64> = product(&from, &conj).iter().map(|square| square.re).collect();
                let left: Vec<Complex> = parts.hodograph.iter().map(|leg| leg.left() * twice).collect();
                let along: Vec<f64> = product(&left, &conj).iter().map(|product| product.re).collect();
                let square = product(parts.speed, &square);
                let along = elevated(&along, square.len() - along.len());
                let sum: Vec<f64> = square.iter().zip(&along).map(|(a, b)| a + b).collect();
                places
                    .extend(roots(&sum, size(&square) + size(&along)).into_iter().map(|u| Place { span, u }));
            }
        }
        places
    }

    /// Whether a span comes nearer: whether the polynomial `|r - p|^2 - distance^2` is negative somewhere. Pieces
    /// whose coefficients are all positive are not; the others are halved.
    fn is_near_span(&self, point: Complex, control: &[Complex]) -> bool {
        // By the distance, so that nothing overflows or vanishes.
        let scale = 1.0 / self.distance;
        let from: Vec<Complex> = control.iter().map(|&p| (p - point) * scale).collect();
        if [from.first(), from.last()].into_iter().flatten().any(|end| end.norm_squared() < 1.0) {
            return true;
        }
        let conj: Vec<Complex> = from.iter().map(|p| p.conj()).collect();
        let gap: Vec<f64> = product(&from, &conj).iter().map(|square| square.re - 1.0).collect();
        // Less than this is rounding.
        let noise = -1e-15 * from.iter().fold(1.0_f64, |most, p| most.max(p.norm_squared()));
        let mut waiting = vec![(gap, HALVINGS)];
        while let Some((piece, depth)) = waiting.pop() {
            if depth > 0 && piece.iter().any(|gap| *gap < noise) {
                let [left, right] = split(&piece, 0.5);
                // The halves meet at the middle of the piece; the other ends have been seen.
                if right.first().is_some_and(|gap| *gap < noise) {
                    return true;
                }
                waiting.extend([(right, depth - 1), (left, depth - 1)]);
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{distance, ring, row};
    use super::super::{Knots, PhSegment, SplineEnd, SplineEnds};
    use super::*;
    use crate::geometry::{ParamCurve, Point};
    use proptest::prelude::*;

    /// The arc of the analytic cubic x = t - c^2 t^3 / 3, y = c t^2 for t from -end to end.
    fn tschirnhausen(c: f64, end: f64) -> PhCurve {
        let w = [Complex::new(1.0, -c * end), Complex::new(1.0, c * end)];
        let at = |t: f64| [t - c * c * t.powi(3) / 3.0, c * t * t];
        let segment = PhSegment::new(0, 2.0 * end, &w, [at(-end), at(end)]).unwrap();
        PhCurve::new(Closure::Open, vec![segment])
    }

    fn near(a: Place, b: (usize, f64)) -> bool {
        a.span == b.0 && (a.u - b.1).abs() < 1e-9
    }

    #[test]
    fn the_analytic_swallowtail() {
        let (c, end) = (0.7, 2.4);
        let curve = tschirnhausen(c, end);
        // Below 1/2 nothing happens; above, cusps at c^2 t^2 = sqrt(2 c d) - 1 and crossings on the axis at
        // c^2 t^2 = 1 -+ sqrt(4 - 6 c d).
        for cd in [0.3, 0.52, 0.55, 0.6, 0.66] {
            let offset = curve.offset(cd / c).unwrap();
            let trimmed = offset.trimmed();
            let u = |square: f64, sign: f64| 0.5 * (1.0 + sign * square.sqrt() / c / end);
            if cd < 0.5 {
                assert!(offset.cusps().is_empty());
            } else {
                let square = (2.0_f64 * cd).sqrt() - 1.0;
                assert!(
                    near(offset.cusps()[0], (0, u(square, -1.0)))
                        && near(offset.cusps()[1], (0, u(square, 1.0)))
                );
            }
            let root = (4.0_f64 - 6.0 * cd).sqrt();
            let squares = [1.0 + root, 1.0 - root];
            let want: Vec<f64> = squares.into_iter().filter(|it| *it > 0.0 && it.sqrt() < c * end).collect();
            assert_eq!(trimmed.crossings.len(), want.len(), "{cd}: {:?}", trimmed.crossings);
            for (crossing, square) in trimmed.crossings.iter().zip(want) {
                let [first, second] = crossing.places;
                assert!(near(first, (0, u(square, -1.0))) && near(second, (0, u(square, 1.0))), "{cd}");
                assert!(crossing.point[0].abs() < 1e-12);
            }
        }
    }

    #[test]
    fn reference_values_of_the_swallowtail() {
        let trimmed = tschirnhausen(0.7, 2.4).offset(0.55 / 0.7).unwrap().trimmed();
        let [a, b] = [0.09665645628686054, 0.37971624899320516];
        let firsts: Vec<f64> = trimmed.crossings.iter().map(|crossing| crossing.places[0].u).collect();
        assert!((firsts[0] - a).abs() < 1e-14 && (firsts[1] - b).abs() < 1e-14, "{firsts:?}");
        assert_eq!(trimmed.kept.len(), 2);
        let [[from, to], [other, end]] = [trimmed.kept[0], trimmed.kept[1]];
        assert!(
            near(from, (0, a)) && near(to, (0, b)) && near(other, (0, 1.0 - b)) && near(end, (0, 1.0 - a))
        );
    }

    #[test]
    fn a_bay_is_trimmed_as_by_reference() {
        let points =
            [[60.0, 120.0], [150.0, 300.0], [250.0, 170.0], [330.0, 110.0], [420.0, 190.0], [500.0, 320.0]];
        let ends = SplineEnds::Open([SplineEnd::Cubic; 2]);
        let curve = PhCurve::spline(Knots::Chord, ends, &points).unwrap();
        assert!((curve.total_length() - 790.301522).abs() < 1e-6);
        let [below, above] = curve.offset_limits().map(Option::unwrap);
        assert!((below + 56.9210).abs() < 1e-4 && (above - 51.2589).abs() < 1e-4);
        for (d, kept) in [(60.0, [(2, 0.7119), (3, 0.2413)]), (-70.0, [(0, 0.48), (1, 0.2939)])] {
            let offset = curve.offset(d).unwrap();
            let trimmed = offset.trimmed();
            assert_eq!((offset.cusps().len(), trimmed.crossings.len(), trimmed.kept.len()), (2, 1, 2));
            let [[from, to], [other, end]] = [trimmed.kept[0], trimmed.kept[1]];
            assert_eq!((from, end), (Place { span: 0, u: 0.0 }, Place { span: 4, u: 1.0 }));
            for (place, (span, u)) in [to, other].into_iter().zip(kept) {
                assert!(place.span == span && (place.u - u).abs() < 1e-4, "{place:?}");
            }
        }
    }

    #[test]
    fn the_arms_of_a_cusp_do_not_cross() {
        let segment = PhSegment::cubics([[200.0, 300.0], [360.0, 300.0]], [[150.0, -225.0], [150.0, 225.0]]);
        let curve = PhCurve::new(Closure::Open, vec![segment.unwrap().swap_remove(0)]);
        for (d, crossings, kept) in [(60.0, 0, 1), (95.0, 1, 2), (120.0, 0, 0)] {
            let offset = curve.offset(d).unwrap();
            let trimmed = offset.trimmed();
            assert_eq!((trimmed.crossings.len(), trimmed.kept.len()), (crossings, kept), "{d}");
            assert_eq!(offset.cusps().len(), if d > 82.0 { 2 } else { 0 });
        }
    }

    #[test]
    fn a_ring_offset_too_far_inside_vanishes() {
        let points: Vec<Point<2>> = (0..6)
            .map(|k| std::f64::consts::PI * f64::from(k) / 3.0)
            .map(|angle| [100.0 * angle.cos(), 100.0 * angle.sin()])
            .collect();
        let curve = PhCurve::spline(Knots::Chord, SplineEnds::Closed, &points).unwrap();
        assert!(curve.offset(130.0).unwrap().trimmed().kept.is_empty());
        let whole = vec![[Place { span: 0, u: 0.0 }, Place { span: 5, u: 1.0 }]];
        assert_eq!(curve.offset(90.0).unwrap().trimmed().kept, whole);
        assert_eq!(curve.offset(-500.0).unwrap().trimmed().kept, whole);
        assert_eq!(curve.offset(0.0).unwrap().trimmed().kept, whole);
    }

    #[test]
    fn an_arch_may_come_too_near_to_its_ends() {
        let points = [[0.0, 0.0], [100.0, 0.0]];
        let curve = PhCurve::hermite(Closure::Open, &points, &[[50.0, 100.0], [50.0, -100.0]]).unwrap();
        let offset = curve.offset(-54.315).unwrap();
        let cusps: Vec<f64> = offset.cusps().iter().map(|cusp| cusp.u).collect();
        assert!(
            (cusps[0] - 0.21240029391577198).abs() < 1e-14 && (cusps[1] - 0.7875997060842279).abs() < 1e-14
        );
        let plain = offset.trimmed().kept;
        assert!(plain.len() == 1 && near(plain[0][0], (0, cusps[0])) && near(plain[0][1], (0, cusps[1])));
        // Between the cusps it first runs within the circle round the start.
        let [[from, to]] = offset.trimmed_at_ends().kept[..] else { panic!("one stretch") };
        for (place, end) in [(from, points[0]), (to, points[1])] {
            let point = ParamCurve::eval(&offset, 0, place.u).unwrap();
            assert!(place.u > 0.3 && place.u < 0.7 && (distance(point, end) - 54.315).abs() < 1e-12);
        }
    }

    /// Checks the kept stretches against the distance from a fine polyline.
    fn check(curve: &PhCurve, d: f64) -> Result<(), TestCaseError> {
        let offset = curve.offset(d).unwrap();
        let trimmed = offset.trimmed_at_ends();
        for crossing in &trimmed.crossings {
            let [p, q] = crossing.places.map(|place| ParamCurve::eval(&offset, place.span, place.u).unwrap());
            prop_assert!(distance(p, q) < 1e-9 * 300.0 && distance(p, crossing.point) < 1e-9 * 300.0);
        }
        let line = curve.polyline(400).unwrap();
        let nearest = |p: Point<2>| line.iter().map(|q| distance(p, *q)).fold(f64::INFINITY, f64::min);
        for span in 0..offset.spans() {
            for k in 0..10 {
                let place = Place { span, u: (f64::from(k) + 0.5) / 10.0 };
                let gap = nearest(ParamCurve::eval(&offset, span, place.u).unwrap()) - d.abs();
                let kept = trimmed.kept.iter().any(|[from, to]| *from <= place && place <= *to);
                // The polyline is a little off, so points at about the distance may be either.
                prop_assert!(!(kept && gap < -0.1), "kept at {:?}, {} too near", place, -gap);
                prop_assert!(kept || gap < 0.1, "cut at {:?}, {}", place, gap);
            }
        }
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn rows_keep_what_keeps_the_distance(points in row(), d in -60.0..60.0) {
            let ends = SplineEnds::Open([SplineEnd::Cubic; 2]);
            check(&PhCurve::spline(Knots::Chord, ends, &points).unwrap(), d)?;
        }

        #[test]
        fn rings_keep_what_keeps_the_distance(points in ring(), d in -60.0..120.0) {
            check(&PhCurve::spline(Knots::Chord, SplineEnds::Closed, &points).unwrap(), d)?;
        }
    }
}
