//! Curves that families describe exactly, and what is told about wrong parameters.

use super::*;
use crate::geometry::{Fourier, GeometryError, Wave};
use std::f64::consts::{PI, TAU};

#[test]
fn cycloid_half_circle_and_quarter_circle() {
    let cycloid = vec![[0.0, 0.0], [0.0, 0.0], [0.0, 2.0], [PI, 2.0]];
    let cycloid = ShapedCurve::new(Family::c_bezier(PI).unwrap(), cycloid, false).unwrap();
    let half = bezier_points(PI * PI, [[1.0, 0.0], [0.0, PI]], [[-1.0, 0.0], [0.0, -PI]]);
    let expected = [[1.0, 0.0], [1.0, PI / 2.0], [-1.0, PI / 2.0], [-1.0, 0.0]];
    assert!(half.iter().zip(expected).all(|(a, b)| off(*a, b) < 1e-15));
    let half = ShapedCurve::new(Family::c_bezier(PI).unwrap(), half.to_vec(), false).unwrap();
    let q = PI / 2.0;
    let quarter = vec![[1.0, 0.0], [1.0, q - 1.0], [q - 1.0, 1.0], [0.0, 1.0]];
    let quarter = ShapedCurve::new(Family::c_bezier(q).unwrap(), quarter, false).unwrap();
    for k in 0..=64 {
        let x = f64::from(k) / 64.0;
        let t = PI * x;
        assert!(off(at(&cycloid, x), [t - t.sin(), 1.0 - t.cos()]) < 2e-15);
        assert!(off(at(&half, x), [t.cos(), t.sin()]) < 2e-15);
        assert!(off(at(&quarter, x), [(t / 2.0).cos(), (t / 2.0).sin()]) < 2e-15);
        let [_, slope, bend] = half.at(0, x).unwrap();
        assert!(off(slope, [-PI * t.sin(), PI * t.cos()]) < 2e-14);
        assert!(off(bend, [-PI * PI * t.cos(), -PI * PI * t.sin()]) < 1e-13);
    }
}

#[test]
fn helix_and_catenary() {
    let helix = |x: f64| [(2.0 * x).cos(), (2.0 * x).sin(), 2.0 * x / 3.0];
    let along = |x: f64| [-2.0 * (2.0 * x).sin(), 2.0 * (2.0 * x).cos(), 2.0 / 3.0];
    let points = bezier_points(4.0, [helix(0.0), along(0.0)], [helix(1.0), along(1.0)]);
    let curve = ShapedCurve::new(Family::c_bezier(2.0).unwrap(), points.to_vec(), false).unwrap();
    for k in 0..=64 {
        let x = f64::from(k) / 64.0;
        assert!(off(at(&curve, x), helix(x)) < 2e-15);
    }
    // (t, cosh t) for t from 0 to alpha, also where the product form is used.
    for alpha in [2.0_f64, 4.999, 5.001, 12.0] {
        let end = [[alpha, alpha.cosh()], [alpha, alpha * alpha.sinh()]];
        let points = bezier_points(-alpha * alpha, [[0.0, 1.0], [alpha, 0.0]], end).to_vec();
        let curve = ShapedCurve::new(Family::FBezier { omega: -alpha * alpha }, points, false).unwrap();
        for k in 0..=64 {
            let x = f64::from(k) / 64.0;
            let (t, size) = (alpha * x, alpha.cosh());
            let [point, slope, bend] = curve.at(0, x).unwrap();
            assert!(off(point, [t, t.cosh()]) < 1e-14 * size, "{alpha} {x}");
            assert!(off(slope, [alpha, alpha * t.sinh()]) < 1e-12 * size, "{alpha} {x}");
            assert!(off(bend, [0.0, alpha * alpha * t.cosh()]) < 1e-11 * size, "{alpha} {x}");
        }
    }
}

#[test]
fn the_limit_at_zero_is_the_cubic_curve() {
    let points = vec![[0.0, 1.0], [2.0, 5.0], [4.0, -3.0], [7.0, 2.0]];
    let curve = ShapedCurve::new(Family::FBezier { omega: 0.0 }, points.clone(), false).unwrap();
    let bezier = crate::geometry::CubicBezier { p: std::array::from_fn(|i| points[i]) };
    for k in 0..=10 {
        let x = f64::from(k) / 10.0;
        assert!(off(at(&curve, x), bezier.eval(x)) < 1e-14);
    }
}

#[test]
fn a_cyclic_polygon_is_a_circle_and_fourier_series_come_back() {
    for n in [1, 2, 5, 20] {
        let corner = |i: usize| {
            let (sin, cos) = (TAU * i as f64 / (2 * n + 1) as f64).sin_cos();
            [3.0 * cos, 3.0 * sin]
        };
        let points: Vec<[f64; 2]> = (0..2 * n + 1).map(corner).collect();
        let curve = ShapedCurve::new(Family::Cyclic, points.clone(), true).unwrap();
        let series = cyclic_to_fourier(&points).unwrap();
        let radius = 3.0 * n as f64 / (n + 1) as f64;
        for k in 0..50 {
            let t = TAU * f64::from(k) / 50.0;
            assert!(off(at(&curve, t), [radius * t.cos(), radius * t.sin()]) < 4e-14);
            assert!(off(series.eval(t / TAU), at(&curve, t)) < 4e-14);
        }
    }
    let wave = |amplitude, phase| Wave { amplitude, phase };
    let flat = wave(0.0, 0.0);
    let waves = [[wave(2.0, 0.5), wave(2.0, 0.0)], [flat, wave(0.3, 1.2)], [wave(0.1, 0.7), flat]];
    let series = Fourier::new([1.0, -2.0], &waves).unwrap();
    let curve = ShapedCurve::new(Family::Cyclic, cyclic_from_fourier(&series, 3).unwrap(), true).unwrap();
    for k in 0..50 {
        let u = f64::from(k) / 50.0;
        assert!(off(at(&curve, TAU * u), series.eval(u)) < 1e-13);
    }
    assert!(cyclic_from_fourier(&series, 4).is_err() && cyclic_from_fourier(&series, 0).is_err());
    assert!((1.0 / harmonic_factor(20, 20) / 137_846_528_820.0 - 1.0).abs() < 1e-13);
}

#[test]
fn han_with_lambda_four_passes_its_points() {
    let points = vec![[0.0, 0.0], [3.0, 4.0], [5.0, -1.0], [9.0, 2.0], [11.0, 0.0]];
    let lambda = Lambdas::Each(vec![0.0, 1.0, 4.0, -2.0, 0.0]);
    let curve = ShapedCurve::new(Family::Lambda { kind: LambdaKind::Han, lambda }, points, false).unwrap();
    assert!(off(curve.eval(1, 0.0).unwrap(), [5.0, -1.0]) < 2e-15);
    // One lambda alone moves the two arcs beside its point.
    let reach = curve.through(Parameter::LambdaOf(2), [4.8, 0.0]).unwrap();
    assert!(reach.admissible && reach.span < 2, "{reach:?}");
    let moved = curve.with(Parameter::LambdaOf(2), reach.value).unwrap();
    assert!(off(moved.eval(reach.span, reach.x).unwrap(), [4.8, 0.0]) < 1e-12);
}

#[test]
fn wrong_parameters_are_told() {
    let points = vec![[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [3.0, 1.0]];
    let told = |result: Result<(), GeometryError>| result.unwrap_err().to_string();
    assert_eq!(
        told(Family::c_bezier(4.0).map(|_| ())),
        "alpha is 4, but must be larger than 0 and at most pi"
    );
    let of = |family: Family, points: &[[f64; 2]], closed| {
        told(ShapedCurve::new(family, points.to_vec(), closed).map(|_| ()))
    };
    assert_eq!(
        of(Family::FBezier { omega: f64::NAN }, &points, false),
        "omega is NaN, but must be a number from -900 to pi^2"
    );
    assert_eq!(
        of(Family::Cyclic, &points, true),
        "the number of points of a cyclic curve is 4, but must be an odd number from 3 to 1001"
    );
    assert!(of(Family::FBezier { omega: 0.0 }, &points[..3], false).contains("exactly 4 needed"));
    let han = Family::Lambda { kind: LambdaKind::Han, lambda: Lambdas::Each(vec![1.0; 3]) };
    assert!(of(han, &points, false).contains("the number of lambdas is 3"));
    assert!(
        Trig::new(3, 2, 3.0, 2.0, Phi::Rational).is_err() && Trig::new(2, 2, 1.5, 2.0, Phi::Trig).is_err()
    );
    assert!(Trig::new(2, 2, 2.0, 2.0, Phi::Trig).unwrap().middle_is_dead());
    let curve = ShapedCurve::new(Family::c_bezier(1.0).unwrap(), points.clone(), false).unwrap();
    assert!(curve.path(Parameter::Lambda, 0, 0.5, &[1.0]).is_err());
    assert!(curve.path(Parameter::Alpha, 1, 0.5, &[1.0]).is_err());
    assert!(curve.through(Parameter::Beta, [0.0, 0.0]).is_err());
    assert!(curve.through(Parameter::Alpha, [f64::NAN, 0.0]).is_err());
    let zero = Family::Lambda { kind: LambdaKind::Gb, lambda: Lambdas::One(0.0) };
    assert!(interpolate(&zero, &points, false).is_err());
    assert!(interpolate(&Family::c_b_spline(PI).unwrap(), &points, true).is_err());
    assert!(interpolate(&Family::Cyclic, &points, true).is_err());
}

#[test]
fn two_cyclic_bases_make_a_torus() {
    use crate::geometry::{ParamSurface, Weave};
    // The polygon's radius is that of the circle times (n + 1) / n.
    let turn = |i: usize, n: usize| (TAU * i as f64 / (2 * n + 1) as f64).sin_cos();
    let net = |i: usize| {
        let (sin, cos) = turn(i, 2);
        let row = |j: usize| {
            let (up, out) = turn(j, 1);
            let far = 1.5 * (3.0 + 2.0 * out);
            [far * cos, far * sin, 2.0 * up]
        };
        (0..3).map(row).collect()
    };
    let [u, v] = [5, 3].map(|n| ShapedBasis::new(Family::Cyclic, n, true).unwrap());
    let torus = Weave::new(u, v, (0..5).map(net).collect()).unwrap();
    assert_eq!((torus.spans(), torus.closed()), ([5, 3], [true, true]));
    for k in 0..30 {
        let [x, y, z] = torus.eval([k % 5, k % 3], [k as f64 / 30.0, 0.7]).unwrap();
        assert!((x.hypot(y) - 3.0).hypot(z) - 1.0 < 1e-14 && (x.hypot(y) - 3.0).hypot(z) > 1.0 - 1e-14);
    }
}

#[test]
fn cyclic_points_of_a_rough_curve_beyond_all_limits_are_told() {
    let wave = |amplitude| Wave { amplitude, phase: 0.25 };
    let waves = vec![[wave(1.0), wave(1.0)]; 400];
    let series = Fourier::new([0.0, 0.0], &waves).unwrap();
    assert!(cyclic_from_fourier(&series, 400).is_err());
    assert!(cyclic_from_fourier(&series, 20).unwrap().iter().flatten().all(|x| x.is_finite()));
}
