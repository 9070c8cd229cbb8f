//! Properties that hold for any points: interpolation, continuity at every joint and the seam,
//! convex hull, affine invariance, symmetry, and errors instead of nonsense.

use grafika::geometry::{
    Bezier, COORDINATE_LIMIT, Closure, CubicBezier, Curve, Ends, GeometryError, Method, ParamCurve, Point,
    Weights,
};
use proptest::prelude::*;

const TOLERANCE: f64 = 1e-9; // coordinates are up to 1000, so 1e-12 of the size

fn points() -> impl Strategy<Value = Vec<Point<2>>> {
    let any = prop::collection::vec([-1000.0..1000.0, -1000.0..1000.0], 3..40);
    // Often repeat a point two or three times.
    (any, 0_usize..40, 0_usize..3).prop_map(|(mut points, at, times): (Vec<Point<2>>, usize, usize)| {
        let at = at % points.len();
        for _ in 0..times {
            points.insert(at, points[at]);
        }
        points
    })
}

fn closure() -> impl Strategy<Value = Closure> {
    prop_oneof![Just(Closure::Open), Just(Closure::Closed)]
}

fn method() -> impl Strategy<Value = Method> {
    prop_oneof![
        (-3.0..3.0).prop_map(|k0| Method::Coons { k0 }),
        (-3.0..3.0).prop_map(|k0| Method::Local { k0 }),
        Just(Method::Spline),
        Just(Method::BSpline2),
        Just(Method::BSpline3),
        (0.3..3.0, 0.0..20.0).prop_map(|(bias, tension)| Method::Beta { bias, tension }),
    ]
}

fn arcs(method: Method, closure: Closure, points: &[Point<2>]) -> Vec<CubicBezier<2>> {
    Weights::new(method, closure, points.len()).unwrap().arcs(points).unwrap()
}

fn distance(a: Point<2>, b: Point<2>) -> f64 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}

/// Pairs of arcs that meet, the seam included when there is one.
fn joints(arcs: &[CubicBezier<2>], closure: Closure) -> Vec<(CubicBezier<2>, CubicBezier<2>)> {
    let seam = (closure == Closure::Closed).then(|| (arcs[arcs.len() - 1], arcs[0]));
    arcs.windows(2).map(|w| (w[0], w[1])).chain(seam).collect()
}

/// What derivative of the next arc follows from the derivatives of this one at the joint:
/// `first * r'`, and `first^2 * r'' + second * r'` (2.61)-(2.62); `None` where nothing does.
fn joint_law(method: Method) -> (f64, Option<f64>) {
    match method {
        Method::Spline | Method::BSpline3 => (1.0, Some(0.0)),
        Method::Beta { bias, tension } => (bias, Some(2.0 * tension)),
        _ => (1.0, None),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn joints_are_smooth(method in method(), closure in closure(), points in points()) {
        let (first, second) = joint_law(method);
        for (this, next) in joints(&arcs(method, closure, &points), closure) {
            prop_assert!(distance(this.p[3], next.p[0]) < TOLERANCE);
            let (slope, bend) = (this.derivative(1.0), this.second_derivative(1.0));
            prop_assert!(distance(next.derivative(0.0), slope.map(|x| first * x)) < 10.0 * TOLERANCE);
            if let Some(second) = second {
                let want = [0, 1].map(|d| first * first * bend[d] + second * slope[d]);
                prop_assert!(distance(next.second_derivative(0.0), want) < 100.0 * TOLERANCE);
            }
        }
    }

    #[test]
    fn interpolating_methods_interpolate_exactly(method in method(), closure in closure(), points in points()) {
        prop_assume!(method.interpolates());
        for (i, arc) in arcs(method, closure, &points).iter().enumerate() {
            prop_assert_eq!(arc.eval(0.0), points[i]);
            prop_assert_eq!(arc.eval(1.0), points[(i + 1) % points.len()]);
        }
    }

    #[test]
    fn approximating_methods_stay_in_the_convex_hull(method in method(), closure in closure(), points in points()) {
        prop_assume!(!method.interpolates());
        // The farthest point in 16 directions is a control point.
        for k in 0..16 {
            let (sin, cos) = (f64::from(k) * std::f64::consts::PI / 8.0).sin_cos();
            let along = |p: &Point<2>| cos * p[0] + sin * p[1];
            let farthest = points.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
            for arc in arcs(method, closure, &points) {
                prop_assert!(arc.p.iter().map(along).fold(f64::NEG_INFINITY, f64::max) <= farthest + TOLERANCE);
            }
        }
    }

    #[test]
    fn affine_maps_commute_with_curves(
        method in method(), closure in closure(), points in points(), m in prop::array::uniform6(-2.0..2.0),
    ) {
        let map = |p: Point<2>| [m[0] * p[0] + m[1] * p[1] + m[2], m[3] * p[0] + m[4] * p[1] + m[5]];
        let mapped: Vec<_> = points.iter().copied().map(map).collect();
        for (a, b) in arcs(method, closure, &points).iter().zip(arcs(method, closure, &mapped)) {
            prop_assert!((0..4).all(|c| distance(map(a.p[c]), b.p[c]) < 10.0 * TOLERANCE));
        }
    }

    #[test]
    fn reversed_points_give_the_reversed_curve(method in method(), closure in closure(), points in points()) {
        let backwards: Vec<_> = points.iter().rev().copied().collect();
        // A beta-spline backwards has the inverse bias.
        let mirrored = match method {
            Method::Beta { bias, tension } => Method::Beta { bias: 1.0 / bias, tension: tension / bias.powi(3) },
            other => other,
        };
        let (there, back) = (arcs(method, closure, &points), arcs(mirrored, closure, &backwards));
        let n = there.len();
        let shift = usize::from(closure == Closure::Closed && method != Method::BSpline2);
        for (s, arc) in back.iter().enumerate() {
            let other = there[(2 * n - 1 - shift - s) % n].reversed();
            prop_assert!((0..4).all(|c| distance(arc.p[c], other.p[c]) < TOLERANCE));
        }
    }

    #[test]
    fn rows_are_the_weights_of_the_arcs(method in method(), closure in closure(), points in points()) {
        let weights = Weights::new(method, closure, points.len()).unwrap();
        let arcs = weights.arcs(&points).unwrap();
        prop_assert_eq!(arcs.len(), weights.spans());
        for (s, arc) in arcs.iter().enumerate() {
            for c in 0..4 {
                let row = weights.row(s, c).unwrap();
                prop_assert!((row.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                let sum = [0, 1].map(|d| row.iter().zip(&points).map(|(w, p)| w * p[d]).sum());
                prop_assert!(distance(sum, arc.p[c]) < TOLERANCE);
            }
        }
        prop_assert_eq!(weights.row(arcs.len(), 0), None);
        prop_assert_eq!(weights.row(0, 4), None);
    }

    #[test]
    fn bezier_approximation_keeps_its_tolerance(
        closure in closure(), points in points(), exponent in -6..2,
    ) {
        let tolerance = 10_f64.powi(exponent);
        let bezier = Bezier::new(closure, &points).unwrap();
        let cubics = bezier.to_cubics(tolerance).unwrap();
        // Each arc covers a dyadic piece of the parameter; find it again by halving.
        let mut pieces = vec![bezier.clone()];
        let mut rest = cubics.as_slice();
        let mut depth = 0;
        while let (Some(piece), [arc, ..]) = (pieces.pop(), rest) {
            let same_end = piece.points().last() == Some(&arc.p[3]);
            let worst = (0..=16).map(|j| f64::from(j) / 16.0)
                .map(|u| { let (a, b) = (piece.eval(u), arc.eval(u)); (a[0] - b[0]).hypot(a[1] - b[1]) })
                .fold(0.0, f64::max);
            if same_end && worst <= tolerance + 1e-11 {
                rest = &rest[1..];
            } else {
                prop_assert!(depth < 100_000);
                depth += 1;
                let [left, right] = piece.split(0.5);
                pieces.push(right);
                pieces.push(left);
            }
        }
        prop_assert!(pieces.is_empty() && rest.is_empty());
        for pair in cubics.windows(2) {
            prop_assert_eq!(pair[0].p[3], pair[1].p[0]);
        }
    }

    #[test]
    fn boxes_are_tight(method in method(), closure in closure(), points in points(), all in any::<bool>()) {
        let method = if all { Method::Bezier } else { method };
        let curve = Curve::through(method, closure, &points).unwrap();
        let bounds = curve.bounding_box().unwrap();
        let mut reached = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let steps = if all { 4000 } else { 200 };
        for p in curve.polyline(steps).unwrap() {
            for d in 0..2 {
                prop_assert!(bounds.min[d] - TOLERANCE <= p[d] && p[d] <= bounds.max[d] + TOLERANCE);
                reached[0][d] = reached[0][d].min(p[d]);
                reached[1][d] = reached[1][d].max(p[d]);
            }
        }
        // Samples come as near as their distance allows (error of second order in the step).
        prop_assert!(distance(reached[0], bounds.min) < 2.0 && distance(reached[1], bounds.max) < 2.0);
    }

    #[test]
    fn nothing_but_finite_curves_or_errors(
        method in any_method(), open in any::<bool>(),
        points in prop::collection::vec(prop::array::uniform2(any::<f64>()), 0..12),
    ) {
        let closure = if open { Closure::Open } else { Closure::Closed };
        if let Ok(curve) = Curve::through(method, closure, &points) {
            let finite = |p: Point<2>| p.iter().all(|x| x.is_finite());
            for sample in curve.sample(8).unwrap() {
                let (span, u) = (sample.span, sample.u);
                prop_assert!(finite(sample.point) && finite(curve.eval(span, u).unwrap()));
                prop_assert!(curve.at(span, u).unwrap().into_iter().all(finite));
            }
            let bounds = curve.bounding_box().unwrap();
            prop_assert!(finite(bounds.min) && finite(bounds.max));
            prop_assert!(curve.length(1e140).is_finite());
        }
    }
}

fn any_method() -> impl Strategy<Value = Method> {
    let parameter = prop_oneof![any::<f64>(), -10.0..10.0];
    (0..7, parameter.clone(), parameter).prop_map(|(kind, a, b)| match kind {
        0 => Method::Coons { k0: a },
        1 => Method::Bezier,
        2 => Method::Spline,
        3 => Method::BSpline2,
        4 => Method::BSpline3,
        5 => Method::Beta { bias: a, tension: b },
        _ => Method::Local { k0: a },
    })
}

#[test]
fn joint_check_can_fail() {
    // The cubic B-spline is not C2 when a beta-spline's tension is expected of it.
    let points = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
    let (this, next) = joints(&arcs(Method::BSpline2, Closure::Closed, &points), Closure::Closed)[0];
    assert!(distance(this.derivative(1.0), next.derivative(0.0)) < TOLERANCE);
    assert!(distance(this.second_derivative(1.0), next.second_derivative(0.0)) > 1.0);
}

#[test]
fn huge_coordinates_are_an_error_not_infinity() {
    let far = COORDINATE_LIMIT;
    let points = [[far, 0.0], [-far, far], [far, -far], [0.0, far]];
    let coons = Curve::through(Method::Coons { k0: 1.0 }, Closure::Open, &points);
    assert!(matches!(coons, Err(GeometryError::Overflow { span: 0 })), "{coons:?}");
    let inside = Curve::through(Method::BSpline3, Closure::Closed, &points).unwrap();
    assert!(inside.length(f64::NAN).is_finite());
    let beyond = Curve::through(Method::Bezier, Closure::Open, &[[0.0, 0.0], [0.0, 1e200]]);
    assert_eq!(beyond, Err(GeometryError::TooLarge { number: 2, value: 1e200 }));
}

#[test]
fn too_few_points_say_how_many_are_needed() {
    let points = [[0.0, 0.0], [1.0, 1.0]];
    let needed = |method, closure| Curve::through(method, closure, &points).map(|c| c.spans());
    let error = Err(GeometryError::TooFewPoints { given: 2, needed: 3 });
    assert_eq!(needed(Method::Spline, Closure::Open), Ok(1));
    assert_eq!(needed(Method::BSpline3, Closure::Open), Ok(3));
    assert_eq!(needed(Method::BSpline2, Closure::Open), error);
    for method in [Method::Bezier, Method::Spline, Method::BSpline3, Method::Coons { k0: 1.0 }] {
        assert_eq!(needed(method, Closure::Closed), error);
    }
    let count = usize::MAX;
    assert!(matches!(
        Weights::with_ends(Method::Spline, Ends::Closed, count).map(|_| ()),
        Err(GeometryError::TooManyPoints { .. })
    ));
}
