//! Theorems, and what belongs together by independent ways.

use super::super::{KnotCurve, KnotError, KnotSurface, KnotVector, Pair, Unreached};
use super::apart;
use crate::geometry::{Basis, Blend, ParamCurve, ParamSurface, Point, cross, norm};
use proptest::prelude::*;

/// Exact fractions of whole numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Fraction(i128, i128);

impl Fraction {
    fn new(a: i128, b: i128) -> Self {
        let (mut x, mut y) = (a.abs(), b.abs());
        while y != 0 {
            (x, y) = (y, x % y);
        }
        let sign = b.signum() * x.max(1);
        Self(a / sign, b / sign)
    }

    fn value(self) -> f64 {
        self.0 as f64 / self.1 as f64
    }
}

/// B-spline functions by the very definition 2.1, in exact arithmetic.
fn exact(knots: &[i128], order: usize, i: usize, u: Fraction) -> Fraction {
    if order == 1 {
        let inside = knots[i] * u.1 <= u.0 && u.0 < knots[i + 1] * u.1;
        return Fraction(i128::from(inside), 1);
    }
    let part = |near: i128, width: i128, lower: usize| {
        if width == 0 {
            return Fraction(0, 1);
        }
        let factor = Fraction::new(u.0 - near * u.1, u.1 * width);
        let value = exact(knots, order - 1, lower, u);
        Fraction::new(factor.0 * value.0, factor.1 * value.1)
    };
    let a = part(knots[i], knots[i + order - 1] - knots[i], i);
    let b = part(knots[i + order], knots[i + order] - knots[i + 1], i + 1);
    // The second factor is (u_{i+k} - u) over the width.
    Fraction::new(a.0 * b.1 - b.0 * a.1, a.1 * b.1)
}

/// A vector of small whole knots with some multiple ones, and its order.
fn vectors() -> impl Strategy<Value = KnotVector> {
    (2..=8_usize, proptest::collection::vec(0..3_u32, 30), 0..6_usize).prop_filter_map(
        "the domain has a length",
        |(order, steps, more)| {
            let mut at = 0;
            let knots = steps.iter().take(2 * order + more).map(|step| {
                at += step;
                f64::from(at)
            });
            KnotVector::new(order, knots.collect()).ok()
        },
    )
}

fn curves() -> impl Strategy<Value = KnotCurve<2>> {
    let numbers = proptest::collection::vec((-9.0..9.0, -9.0..9.0, 0.3..3.0), 24);
    (vectors(), numbers, any::<bool>(), any::<bool>()).prop_map(|(vector, numbers, rational, closed)| {
        let vector = if closed {
            let mut breaks: Vec<f64> = vector.knots().to_vec();
            breaks.dedup();
            KnotVector::closed(vector.order(), &breaks).unwrap_or(vector)
        } else {
            vector
        };
        let points = numbers.iter().take(vector.points()).map(|&(x, y, _)| [x, y]).collect();
        let weights = numbers.iter().take(vector.points()).map(|(.., w)| *w).collect();
        KnotCurve::with(vector, points, rational.then_some(weights)).unwrap()
    })
}

/// Simple knots in general position.
fn simple(order: usize, points: usize, seed: &[f64]) -> Vec<f64> {
    let steps = seed.iter().cycle().take(points + order);
    steps.scan(0.0, |at, step| Some(std::mem::replace(at, *at + 0.5 + step))).collect()
}

fn same(a: &KnotCurve<2>, b: &KnotCurve<2>, tolerance: f64) {
    let [from, to] = a.vector().domain();
    assert_eq!(b.vector().domain(), [from, to]);
    for k in 0..=40 {
        let u = (from + (to - from) * f64::from(k) / 40.0).min(to);
        let (p, q) = (a.point_at(u).unwrap(), b.point_at(u).unwrap());
        assert!(apart(p, q) < tolerance, "{u}: {p:?} {q:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn functions_are_those_of_the_definition(vector in vectors(), t in 0..8_i128) {
        let [from, to] = vector.domain().map(|u| u as i128);
        let u = Fraction::new(from * 8 + (to - from) * t, 8);
        let knots: Vec<i128> = vector.knots().iter().map(|u| *u as i128).collect();
        let (first, all) = vector.all_derivatives(u.value()).unwrap();
        for (l, rows) in all.iter().enumerate() {
            let value = exact(&knots, vector.order(), first + l, u);
            prop_assert!((rows[0] - value.value()).abs() < 1e-13, "{rows:?} {value:?}");
        }
        for r in 0..vector.order() {
            let (sum, size) = all.iter().fold((0.0, 1.0), |(s, m), row| (s + row[r], f64::max(m, row[r].abs())));
            let wanted = if r == 0 { 1.0 } else { 0.0 };
            prop_assert!((sum - wanted).abs() < 1e-13 * size);
        }
    }

    #[test]
    fn curves_blends_arcs_and_derivatives_agree(curve in curves(), t in 0.0..1.0) {
        for (span, arc) in curve.arcs().iter().enumerate() {
            let here = ParamCurve::eval(&curve, span, t).unwrap();
            // De Casteljau in homogeneous coordinates.
            let mut row: Vec<[f64; 3]> =
                arc.points.iter().zip(&arc.weights).map(|(p, w)| [p[0] * w, p[1] * w, *w]).collect();
            while row.len() > 1 {
                row = row.windows(2).map(|p| std::array::from_fn(|d| (1.0 - t) * p[0][d] + t * p[1][d])).collect();
            }
            prop_assert!(apart(here, [row[0][0] / row[0][2], row[0][1] / row[0][2]]) < 1e-11);
            let [_, slope, bend] = curve.at(span, t).unwrap();
            let h = 1e-4;
            if t > h && t < 1.0 - h {
                let [a, b] = [t - h, t + h].map(|t| curve.eval(span, t).unwrap());
                let size = 1.0 + norm(slope) + norm(bend);
                let numeric: Point<2> = std::array::from_fn(|d| (b[d] - a[d]) / (2.0 * h));
                prop_assert!(apart(numeric, slope) < 1e-4 * size * 50.0);
                let numeric: Point<2> = std::array::from_fn(|d| (a[d] - 2.0 * here[d] + b[d]) / (h * h));
                prop_assert!(apart(numeric, bend) < 1e-3 * size * 50.0);
            }
        }
        if curve.weights().is_none() {
            let blend = Blend::new(curve.vector().clone(), curve.points().to_vec()).unwrap();
            for span in 0..curve.spans() {
                let (a, b) = (blend.at(span, t).unwrap(), curve.at(span, t).unwrap());
                for r in 0..3 {
                    prop_assert!(apart(a[r], b[r]) < 1e-11 * (1.0 + norm(b[r])));
                }
            }
            if let Ok(hodograph) = curve.hodograph() {
                let [from, to] = curve.vector().domain();
                let u = from + t * (to - from);
                let slope = curve.derivatives(u, 1).unwrap()[1];
                prop_assert!(apart(hodograph.point_at(u).unwrap(), slope) < 1e-10 * (1.0 + norm(slope)));
            }
        }
    }

    #[test]
    fn tools_keep_the_curve(curve in curves(), t in 0.01..0.99) {
        let [from, to] = curve.vector().domain();
        let u = from + t * (to - from);
        let fine = curve.with_inserted(u).unwrap();
        prop_assert_eq!(fine.points().len(), curve.points().len() + 1);
        same(&curve, &fine, 1e-11);
        let knot = fine.vector().knots().iter().position(|x| *x == u).unwrap();
        let (back, by) = fine.with_removed(fine.vector().copies(knot).unwrap().0, 1e-8).unwrap();
        prop_assert!(by < 1e-9);
        for (a, b) in back.points().iter().zip(curve.points()) {
            prop_assert!(apart(*a, *b) < 1e-6);
        }
        if curve.vector().order() < 8 {
            let raised = curve.elevated().unwrap();
            prop_assert_eq!(raised.vector().order(), curve.vector().order() + 1);
            same(&curve, &raised, 1e-8);
        }
        if !curve.closed() {
            let clamped = curve.clamped().unwrap();
            same(&curve, &clamped, 1e-9);
            prop_assert!(apart(clamped.points()[0], curve.point_at(from).unwrap()) < 1e-9);
            if let Ok(free) = clamped.unclamped() {
                same(&clamped, &free, 1e-7);
            }
        }
    }

    #[test]
    fn knots_and_envelopes(
        order in 3..=6_usize,
        seed in proptest::collection::vec(0.0..1.0, 7),
        numbers in proptest::collection::vec((-9.0..9.0, -9.0..9.0, 0.5..2.0), 12),
        t in 0.05..0.95,
        rational: bool,
    ) {
        let vector = KnotVector::new(order, simple(order, 12, &seed)).unwrap();
        let points: Vec<Point<2>> = numbers.iter().map(|&(x, y, _)| [x, y]).collect();
        let weights = numbers.iter().map(|(.., w)| *w).collect();
        let curve = KnotCurve::with(vector, points, rational.then_some(weights)).unwrap();
        let knot = order + 2;
        let [low, high] = curve.room(knot).unwrap();
        let envelope = curve.envelope(knot, 1).unwrap();
        // 2.6: every curve of the family touches it, and 2.9: how the derivatives compare.
        let value = low + t * (high - low);
        let moved = curve.with_knot(knot, value).unwrap();
        let (s, b) = (moved.derivatives(value, 2).unwrap(), envelope.curve.derivatives(value, 2).unwrap());
        prop_assert!(apart(s[0], b[0]) < 1e-11);
        prop_assert!(cross3(s[1], b[1]).abs() < 1e-10 * norm(s[1]) * norm(b[1]) + 1e-12);
        if !rational {
            let k = order as f64;
            for r in 1..(order - 1).min(3) {
                let factor = (k - 1.0 - r as f64) / (k - 1.0);
                let want = s[r].map(|x| factor * x);
                prop_assert!(apart(b[r], want) < 1e-9 * (1.0 + norm(want)));
            }
        }
        // 2.7: so do the paths.
        let by_knot = moved.derivative_by_knot(knot, value).unwrap();
        prop_assert!(cross3(by_knot, b[1]).abs() < 1e-9 * (1.0 + norm(b[1]) * norm(by_knot)));
        // The derivative by the knot is that of the path.
        for span in curve.changed_spans(knot) {
            let knots = curve.vector().knots();
            let u = knots[span] + t * (knots[span + 1] - knots[span]);
            let path = curve.path(knot, span, u).unwrap();
            let (at, h) = (knots[knot], 1e-5);
            let [a, b] = [at - h, at + h].map(|v| path.at(v).unwrap());
            let numeric: Point<2> = std::array::from_fn(|d| (b[d] - a[d]) / (2.0 * h));
            prop_assert!(apart(numeric, curve.derivative_by_knot(knot, u).unwrap()) < 1e-6);
            // 2.5: straight, parallel to its side or through its centre.
            if let Some(straight) = path.straight() {
                let (p, q) = (path.at(low).unwrap(), path.at(high).unwrap());
                let along = [q[0] - p[0], q[1] - p[1]];
                let m = path.at(at).unwrap();
                prop_assert!(cross3(along, [m[0] - p[0], m[1] - p[1]]).abs() < 1e-11 * (1.0 + norm(along)));
                let toward = straight.centre.map_or_else(
                    || {
                        let [a, b] = straight.side.map(|i| curve.points()[i]);
                        [b[0] - a[0], b[1] - a[1]]
                    },
                    |centre| [centre[0] - p[0], centre[1] - p[1]],
                );
                prop_assert!(cross3(along, toward).abs() < 1e-10 * (1.0 + norm(toward)));
            }
            // 2.8: both neighbours shrink to their limits.
            let limits = curve.limits(knot, 1).unwrap();
            let limit = [(knot, limits.after), (knot - 1, limits.before)];
            if let Some((_, Some(end))) = limit.into_iter().find(|(j, _)| *j == span) {
                for far in [-1e9, 1e9] {
                    prop_assert!(apart(path.at(far).unwrap(), end) < 1e-5);
                }
            }
        }
    }

    #[test]
    fn pairs_hit(
        seed in proptest::collection::vec(0.0..1.0, 5),
        numbers in proptest::collection::vec((-3.0..3.0, -9.0..9.0), 9),
        a in 0.05..0.5,
        c in 0.05..0.5,
    ) {
        let vector = KnotVector::new(4, simple(4, 9, &seed)).unwrap();
        let points: Vec<Point<2>> =
            numbers.iter().enumerate().map(|(i, &(x, y))| [10.0 * i as f64 + x, y]).collect();
        let curve = KnotCurve::new(vector, points.clone()).unwrap();
        let knot = 6;
        let t = curve.vector().knots()[knot];
        let target: Point<2> =
            std::array::from_fn(|d| a * points[3][d] + (1.0 - a - c) * points[4][d] + c * points[5][d]);
        for pair in Pair::ALL {
            match curve.through_pair(target, knot, t, pair) {
                Ok(found) => {
                    prop_assert!(found.miss(target) < 1e-9, "{pair:?}");
                    let old = curve.vector().knots();
                    let moved = found.curve.vector().knots().iter().zip(old).filter(|(a, b)| a != b).count();
                    prop_assert!(moved <= 2 && found.effort(curve.vector()) >= 0.0);
                }
                Err(error) => prop_assert!(matches!(error, KnotError::Unreached(_)), "{error}"),
            }
        }
    }
}

fn cross3(a: Point<2>, b: Point<2>) -> f64 {
    cross([a[0], a[1], 0.0], [b[0], b[1], 0.0])[2]
}

#[test]
fn the_circle_of_nine_points() {
    let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0];
    let square = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]]
        .map(|p| p.map(f64::from));
    let weights = (0..9).map(|i| if i % 2 == 0 { 1.0 } else { 0.5_f64.sqrt() }).collect();
    let circle = KnotCurve::rational(KnotVector::new(3, knots).unwrap(), square.to_vec(), weights).unwrap();
    for k in 0..=64 {
        let u = f64::from(k) / 16.0;
        assert!((norm(circle.point_at(u).unwrap()) - 1.0).abs() < 1e-15);
        assert!((circle.curvature(u).unwrap() - 1.0).abs() < 1e-12);
    }
    assert!((circle.length(1e-12) - std::f64::consts::TAU).abs() < 1e-10);
    assert_eq!(circle.inflections(), [0.0; 0]);
    let wave = [[0.0, 0.0], [1.0, 1.0], [2.0, -1.0], [3.0, 0.0]].to_vec();
    let wave = KnotCurve::new(KnotVector::clamped(4, 4).unwrap(), wave).unwrap();
    let [at] = wave.inflections()[..] else { panic!("one inflection") };
    assert!((at - 0.5).abs() < 1e-9);
}

#[test]
fn surfaces_are_their_lines() {
    let vectors = [(4, 7), (3, 6)].map(|(k, n)| KnotVector::new(k, simple(k, n, &[0.1, 0.7, 0.4])).unwrap());
    let point = |k: usize, l: usize| [k as f64, l as f64, ((3 * k + l * l) % 5) as f64];
    let net: Vec<Vec<Point<3>>> = (0..7).map(|k| (0..6).map(|l| point(k, l)).collect()).collect();
    let weights = (0..7).map(|k| (0..6).map(|l| 1.0 + ((k + 2 * l) % 3) as f64 * 0.25).collect()).collect();
    let surface = KnotSurface::new(vectors, net, Some(weights)).unwrap();
    for (spans, uv) in [([0, 0], [0.3, 0.6]), ([3, 2], [1.0, 0.1])] {
        let [u, v] = [0, 1].map(|d| surface.vectors()[d].place(spans[d], uv[d]).unwrap().1);
        let at = surface.at(spans, uv).unwrap();
        assert!(apart(at.point, surface.point_at([u, v]).unwrap()) < 1e-13);
        assert!(apart(at.point, surface.line(1, u).unwrap().point_at(v).unwrap()) < 1e-13);
        let width = surface.vectors()[0].place(spans[0], uv[0]).unwrap().2;
        let along = surface.line(0, v).unwrap().derivatives(u, 2).unwrap();
        assert!(apart(at.u, along[1].map(|x| x * width)) < 1e-12);
        assert!(apart(at.uu, along[2].map(|x| x * width * width)) < 1e-12);
    }
    // The point of both knots stays on the envelope of both directions.
    let both = surface.envelope(0, 5, 1).unwrap().envelope(1, 4, 1).unwrap();
    let [rooms, columns] = [surface.vectors()[0].knots(), surface.vectors()[1].knots()];
    let (u, v) = (0.5 * (rooms[5] + rooms[6]), 0.5 * (columns[3] + columns[4]));
    let moved = surface.with_knot(0, 5, u).unwrap().with_knot(1, 4, v).unwrap();
    assert!(apart(moved.point_at([u, v]).unwrap(), both.point_at([u, v]).unwrap()) < 1e-12);
}

#[test]
fn what_is_wrong_is_said() {
    let wrong = |order, knots: &[f64]| KnotVector::new(order, knots.to_vec()).unwrap_err();
    assert_eq!(wrong(9, &[0.0; 20]), KnotError::Order { given: 9 });
    assert!(matches!(wrong(3, &[0.0; 5]), KnotError::KnotCount { given: 5, least: 6, .. }));
    assert_eq!(wrong(2, &[0.0, 1.0, f64::NAN, 3.0]), KnotError::NotFinite { knot: 2 });
    assert_eq!(wrong(2, &[0.0, 2.0, 1.0, 3.0]), KnotError::NotAscending { knot: 2, before: 2.0, value: 1.0 });
    assert_eq!(wrong(2, &[0.0, 1.0, 1.0, 1.0]), KnotError::TooMultiple { knot: 3, most: 2 });
    assert_eq!(wrong(2, &[0.0, 1.0, 1.0, 2.0]), KnotError::NoSpan);
    let line = KnotCurve::new(KnotVector::uniform(2, 4).unwrap(), vec![[0.0, 0.0]; 4]).unwrap();
    assert_eq!(line.envelope(2, 1), Err(KnotError::NoEnvelope { order: 2, multiplicity: 1 }));
    assert!(matches!(line.through_outer([0.0, 0.0], 1, 1.5), Err(KnotError::OrderNeeded { given: 2, .. })));
    let reached = line.through_knot([5.0, 5.0], 2);
    assert_eq!(reached, Err(KnotError::Unreached(Unreached::NotFound)));
    let weights = vec![1.0, 0.0, 1.0, 1.0];
    let vector = KnotVector::uniform(2, 4).unwrap();
    assert!(KnotCurve::rational(vector, vec![[0.0, 0.0]; 4], weights).is_err());
}
