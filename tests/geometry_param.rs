//! Curves behind their trait: the same doubles as ever, derivatives that belong to the points, arcs within
//! their tolerance.

use grafika::geometry::{
    Bezier, Closure, CubicBezier, Curve, Fourier, GeometryError, Method, ParamCurve, Point, Sample, Shape,
    VaryingBeta, Wave,
};
use proptest::prelude::*;

/// Control points that every machine has the same doubles of.
fn polygon<const D: usize>(count: usize) -> Vec<Point<D>> {
    let factors = [(37, 101), (53, 89), (71, 97)];
    let point = |i: usize| std::array::from_fn(|d| 0.7 * ((i * factors[d].0) % factors[d].1) as f64 - 20.0);
    (0..count).map(point).collect()
}

/// Every method with parameters that are no special case.
const METHODS: [Method; 7] = [
    Method::Coons { k0: 0.625 },
    Method::Bezier,
    Method::Spline,
    Method::BSpline2,
    Method::BSpline3,
    Method::Beta { bias: 1.5, tension: 2.25 },
    Method::Local { k0: 0.375 },
];

const CLOSURES: [Closure; 2] = [Closure::Open, Closure::Closed];

fn shapes() -> Vec<Shape> {
    (0..6).map(|i| Shape { bias: [0.5, 1.0, 2.0][i % 3], tension: 3.0 * i as f64 }).collect()
}

fn varying(closure: Closure) -> VaryingBeta<2> {
    VaryingBeta::new(closure, &polygon(6), &shapes()).unwrap()
}

/// The bits of numbers in one (FNV-1a).
fn digest(numbers: impl Iterator<Item = f64>) -> u64 {
    numbers
        .flat_map(|number| number.to_bits().to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

fn numbers<const D: usize>(sample: &Sample<D>) -> impl Iterator<Item = f64> + use<D> {
    [sample.span as f64, sample.u].into_iter().chain(sample.point)
}

fn curve_digest<const D: usize>(curve: &dyn ParamCurve<D>) -> u64 {
    let samples = curve.sample(9).unwrap();
    let line = curve.polyline(7).unwrap();
    digest(samples.iter().flat_map(numbers).chain(line.into_iter().flatten()))
}

/// Digests from the time when `Curve` was sampled by methods of its own (commit e85c4e1): by method, open and
/// closed, through 7 points of the plane and 5 in space.
const DIGESTS: [[[u64; 2]; 2]; 7] = [
    [[0x8844_c389_c65a_492f, 0x116d_ff9c_a563_44c2], [0x01f5_9312_cdb6_2447, 0x47bb_7529_e9ec_28ea]],
    [[0x3d88_8344_767c_e161, 0x36a8_ff1d_9655_3080], [0x3eb4_b260_83a8_7392, 0xd542_b007_5c90_84b8]],
    [[0x6249_6b8d_4a71_b9df, 0xe214_0c8f_8c8e_3042], [0x68ff_6fc3_965e_a3a8, 0x5794_b721_bdba_8274]],
    [[0x6cbf_d1a6_2616_0c9c, 0xeb47_fba5_ea10_a355], [0x3ff0_0b3c_e2d6_901d, 0xcd7e_7ec5_94fa_e0bd]],
    [[0x95d9_41af_ad0a_cfd4, 0x1cdb_07d3_b914_27a8], [0x33c8_6776_0426_ee59, 0x24aa_9420_0c81_2ff2]],
    [[0xefee_72d8_5980_f354, 0x2ca5_b281_da99_cdb5], [0x382c_03e7_592c_33b5, 0x29b0_5f14_5d29_b53c]],
    [[0xa3b5_9816_1bd3_151b, 0xa705_c319_be38_386b], [0x7e86_2fe3_58eb_f9ad, 0xead5_9249_0736_cda1]],
];

#[test]
fn curves_behind_the_trait_have_the_same_doubles_as_before() {
    for (method, want) in METHODS.into_iter().zip(DIGESTS) {
        for (closure, want) in CLOSURES.into_iter().zip(want) {
            let plane = Curve::through(method, closure, &polygon::<2>(7)).unwrap();
            let space = Curve::through(method, closure, &polygon::<3>(5)).unwrap();
            assert_eq!([curve_digest(&plane), curve_digest(&space)], want, "{method:?}, {closure:?}");
        }
    }
    // The beta-spline of many shapes: its samples, and its arcs to a thousandth.
    let wanted =
        [[0xbf73_a137_67de_3a8a, 0x8937_0188_6438_be75], [0x0f6f_b0b7_16f9_ee6e_u64, 0x5adf_0018_a447_d8a3]];
    for (closure, want) in CLOSURES.into_iter().zip(wanted) {
        let curve = varying(closure);
        let arcs = curve.to_cubics(1e-3).unwrap();
        let samples = digest(curve.sample(9).unwrap().iter().flat_map(numbers));
        let arcs = digest(arcs.iter().flat_map(|arc| arc.p).flatten());
        assert_eq!([samples, arcs], want, "{closure:?}");
    }
}

fn distance<const D: usize>(a: Point<D>, b: Point<D>) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

fn points() -> impl Strategy<Value = Vec<Point<2>>> {
    prop::collection::vec(prop::array::uniform2(-100.0..100.0), 3..12)
}

fn method() -> impl Strategy<Value = Method> {
    prop::sample::select(METHODS.to_vec())
}

fn closure() -> impl Strategy<Value = Closure> {
    prop::sample::select(CLOSURES.to_vec())
}

fn shape() -> impl Strategy<Value = Shape> {
    (0.4..2.5, 0.0..9.0).prop_map(|(bias, tension)| Shape { bias, tension })
}

/// Any kind of curve.
fn any_curve() -> impl Strategy<Value = Box<dyn ParamCurve<2>>> {
    let by_method = (method(), closure(), points())
        .prop_map(|(method, closure, points)| boxed(Curve::through(method, closure, &points).unwrap()));
    let varying =
        (closure(), points(), prop::collection::vec(shape(), 12)).prop_map(|(closure, points, shapes)| {
            boxed(VaryingBeta::new(closure, &points, &shapes[..points.len()]).unwrap())
        });
    let wave = (-9.0..9.0, -2.0..2.0).prop_map(|(amplitude, phase)| Wave { amplitude, phase });
    let fourier = prop::collection::vec(prop::array::uniform2(wave), 0..6)
        .prop_map(|waves| boxed(Fourier::new([3.0, -4.0], &waves).unwrap()));
    prop_oneof![by_method, varying, fourier]
}

fn boxed(curve: impl ParamCurve<2> + 'static) -> Box<dyn ParamCurve<2>> {
    Box::new(curve)
}

/// What the derivatives of a curve are measured by.
fn size(curve: &dyn ParamCurve<2>) -> f64 {
    let bounds = curve.bounding_box().unwrap();
    bounds.min.iter().chain(&bounds.max).fold(1.0, |m: f64, x| m.max(x.abs()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn derivatives_agree_with_differences(curve in any_curve(), place in 0.0..1.0, u in 0.01..0.99) {
        let span = ((place * curve.spans() as f64) as usize).min(curve.spans() - 1);
        let h = 1e-5;
        let at = |u: f64| curve.at(span, u).unwrap();
        let [before, here, after] = [at(u - h), at(u), at(u + h)];
        prop_assert_eq!(Some(here[0]), curve.eval(span, u));
        // The error of a difference is h² of the third derivative, and rounding by h.
        let scale = size(&*curve).max(distance(here[1], [0.0; 2])).max(distance(here[2], [0.0; 2]));
        for order in 0..2 {
            let slope = std::array::from_fn(|d| (after[order][d] - before[order][d]) / (2.0 * h));
            prop_assert!(distance(slope, here[order + 1]) < 1e-5 * scale, "{slope:?} {here:?}");
        }
    }

    #[test]
    fn derivatives_of_cubic_curves_are_those_of_their_arcs(
        method in method(), closure in closure(), points in points(), u in 0.0..=1.0,
    ) {
        prop_assume!(method != Method::Bezier);
        let curve = Curve::through(method, closure, &points).unwrap();
        let arcs = curve.to_cubics(1.0).unwrap();
        prop_assert_eq!(arcs.len(), curve.spans());
        for (span, arc) in arcs.iter().enumerate() {
            let want = [arc.eval(u), arc.derivative(u), arc.second_derivative(u)];
            prop_assert_eq!(curve.at(span, u), Some(want));
        }
    }

    #[test]
    fn arcs_of_any_curve_are_within_the_tolerance(curve in any_curve(), exponent in -6..0) {
        let tolerance = 10.0_f64.powi(exponent);
        let arcs = curve.to_cubics(tolerance).unwrap();
        // Spans are cut into equal halves, turns into equal parts: every arc's place is found by its end points.
        let fine: Vec<Point<2>> = curve.polyline(256).unwrap();
        let lines: Vec<[Point<2>; 2]> =
            arcs.iter().flat_map(|arc| {
                let at = |t: i32| arc.eval(f64::from(t) / 64.0);
                (0..64).map(move |t| [at(t), at(t + 1)])
            }).collect();
        // Chords are off their arcs by an eighth of the second derivative times the squared step.
        let bend = arcs.iter().flat_map(|arc| [arc.second_derivative(0.0), arc.second_derivative(1.0)]);
        let chord = bend.map(|b| distance(b, [0.0; 2])).fold(0.0, f64::max) / 8.0 / 64.0 / 64.0;
        for point in fine.iter().step_by(17) {
            let nearest = lines.iter().map(|line| to_segment(*point, *line)).fold(f64::MAX, f64::min);
            prop_assert!(nearest <= tolerance + chord + 1e-12, "{nearest} of {tolerance}, {chord}");
        }
        for (arc, next) in arcs.iter().zip(arcs.iter().skip(1)) {
            prop_assert!(distance(arc.p[3], next.p[0]) < 1e-10 * size(&*curve));
        }
    }

    #[test]
    fn boxes_hold_and_lengths_are_those_of_polylines(curve in any_curve()) {
        let line = curve.polyline(2000).unwrap();
        let (bounds, scale) = (curve.bounding_box().unwrap(), size(&*curve));
        for point in &line {
            prop_assert!((0..2).all(|d| {
                bounds.min[d] <= point[d] + 1e-9 * scale && point[d] <= bounds.max[d] + 1e-9 * scale
            }), "{point:?} {bounds:?}");
        }
        let polygon: f64 = line.windows(2).map(|leg| distance(leg[0], leg[1])).sum();
        let length = curve.length(1e-9);
        prop_assert!(polygon <= length + 1e-6 && length - polygon < 1e-3 * polygon + 1e-9, "{length} {polygon}");
    }

    #[test]
    fn joints_are_where_spans_begin_and_an_open_curve_ends(curve in any_curve()) {
        let joints = curve.joints();
        prop_assert_eq!(joints.len(), curve.spans() + usize::from(!curve.closed()));
        for (span, &joint) in joints.iter().enumerate().take(curve.spans()) {
            prop_assert_eq!(Some(joint), curve.eval(span, 0.0));
        }
        let (start, end) = (joints[0], curve.eval(curve.spans() - 1, 1.0).unwrap());
        prop_assert!(curve.closed() || joints[joints.len() - 1] == end);
        prop_assert_eq!(curve.closed(), distance(start, end) < 1e-9 * size(&*curve));
    }

    #[test]
    fn parameters_are_clipped(curve in any_curve()) {
        let last = curve.spans() - 1;
        prop_assert_eq!(curve.at(0, -3.0), curve.at(0, 0.0));
        prop_assert_eq!(curve.at(0, f64::NAN), curve.at(0, 0.0));
        prop_assert_eq!(curve.at(last, f64::INFINITY), curve.at(last, 1.0));
        prop_assert_eq!(curve.at(last + 1, 0.5), None);
        prop_assert_eq!(curve.eval(usize::MAX, 0.5), None);
        let mut untouched = [[7.0; 2]; 3];
        curve.sample_span(last + 1, &mut untouched);
        prop_assert_eq!(untouched, [[7.0; 2]; 3]);
    }
}

fn to_segment(p: Point<2>, [a, b]: [Point<2>; 2]) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    let t = ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / square;
    let t = if t.is_finite() { t.clamp(0.0, 1.0) } else { 0.0 };
    distance(p, [a[0] + t * along[0], a[1] + t * along[1]])
}

/// A curve that says only what it must: a spiral of many turns a span.
#[derive(Debug)]
struct Spiral;

impl ParamCurve<2> for Spiral {
    fn spans(&self) -> usize {
        2
    }

    fn closed(&self) -> bool {
        false
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<2>; 3]> {
        let t = span as f64 + u.clamp(0.0, 1.0);
        let ([r, r1], (s, c), w) = ([1.0 + t, 1.0], (8.0 * t).sin_cos(), 8.0);
        let place = |c: f64, s: f64| [r * c, r1 * c - r * w * s, -2.0 * r1 * w * s - r * w * w * c];
        let ([x, x1, x2], [y, y1, y2]) = (place(c, s), place(s, -c));
        (span < 2).then_some([[x, y], [x1, y1], [x2, y2]])
    }
}

#[test]
fn what_a_curve_does_not_say_itself_is_found() {
    let bounds = Spiral.bounding_box().unwrap();
    let line = Spiral.polyline(100_000).unwrap();
    for d in 0..2 {
        let (low, high) = line.iter().fold((9.0_f64, -9.0_f64), |(l, h), p| (l.min(p[d]), h.max(p[d])));
        assert!((bounds.min[d] - low).abs() < 1e-7 && (bounds.max[d] - high).abs() < 1e-7);
    }
    let polygon: f64 = line.windows(2).map(|leg| distance(leg[0], leg[1])).sum();
    assert!((Spiral.length(1e-9) - polygon).abs() < 1e-6);
    for tolerance in [1e-2, 1e-5, 1e-8] {
        let arcs = Spiral.to_cubics(tolerance).unwrap();
        // No further, and no more arcs than the order of the error asks for.
        assert!(arcs.len() < (40.0 * tolerance.powf(-0.25)) as usize, "{} at {tolerance}", arcs.len());
        for arc in &arcs {
            for t in 0..=10 {
                let [x, y] = arc.eval(f64::from(t) / 10.0);
                // The distance from a spiral is that of its radius, but for its slant.
                let radius = x.hypot(y);
                let turns = (8.0 * (radius - 1.0) - y.atan2(x)) / std::f64::consts::TAU;
                let off = (turns - turns.round()).abs() * std::f64::consts::TAU / 8.0;
                assert!(off < tolerance, "{off} of {tolerance}");
            }
        }
    }
    for bad in [0.0, -1.0, f64::NAN] {
        assert!(matches!(Spiral.to_cubics(bad), Err(GeometryError::Parameter { name: "tolerance", .. })));
    }
    assert!(matches!(Spiral.to_cubics(1e-18), Err(GeometryError::ToleranceTooSmall { .. })));
    assert!(matches!(Spiral.sample(0), Err(GeometryError::Samples { .. })));
}

#[test]
fn no_arcs_are_no_curve() {
    let nothing: Vec<CubicBezier<3>> = Vec::new();
    assert_eq!((nothing.spans(), nothing.closed(), nothing.bounding_box()), (0, false, None));
    assert_eq!((nothing.joints(), nothing.length(0.0), nothing.polyline(2)), (vec![], 0.0, Ok(vec![])));
    let bezier = Bezier::new(Closure::Closed, &polygon::<3>(4)).unwrap();
    assert!(ParamCurve::closed(&bezier) && bezier.joints() == [polygon::<3>(4)[0]]);
}
