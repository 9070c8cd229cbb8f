//! Random parameters: sums, signs, derivatives by differences, continuity, straight paths, targets that are met.

use super::*;
use crate::geometry::Basis;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn families() -> impl Strategy<Value = (Family, usize, bool)> {
    let omega = || prop_oneof![-900.0..PI * PI, -30.0..PI * PI, -1e-6..1e-6, Just(-25.0), Just(PI * PI)];
    let kinds = [LambdaKind::Han, LambdaKind::Alpha, LambdaKind::Gb, LambdaKind::Spb];
    let phis = [Phi::Trig, Phi::Power, Phi::Rational];
    prop_oneof![
        omega().prop_map(|omega| (Family::FBezier { omega }, 4, false)),
        (omega(), 4usize..9, any::<bool>()).prop_map(|(omega, n, c)| (Family::FBSpline { omega }, n, c)),
        (1usize..6, 1usize..6, 0.0..9.0, 0.0..9.0, 0usize..3).prop_map(move |(n1, n2, a, b, phi)| {
            let (n1, n2) = if phis[phi] == Phi::Rational { (2, 2) } else { (n1, n2) };
            let trig = Trig::new(n1, n2, n1 as f64 + a, n2 as f64 + b, phis[phi]).unwrap();
            (Family::Trig(trig), n1 + n2 + 1, false)
        }),
        (0usize..4, prop::collection::vec(0.0..1.0, 9), 4usize..9, any::<bool>()).prop_map(
            move |(kind, all, n, closed)| {
                // The hull is kept by lambdas from 0 to 1, Han's from -8.
                let lambda = match kinds[kind] {
                    LambdaKind::Han => Lambdas::Each(all[..n].iter().map(|l: &f64| 9.0 * l - 8.0).collect()),
                    LambdaKind::Gb => Lambdas::Each(all[..n].to_vec()),
                    _ => Lambdas::One(all[0]),
                };
                (Family::Lambda { kind: kinds[kind], lambda }, n, closed)
            }
        ),
        (-1.0..1.0, 3usize..9, any::<bool>()).prop_map(|(lambda, n, c)| (
            Family::HanQuadratic { lambda },
            n,
            c
        )),
        (1usize..30).prop_map(|n| (Family::Cyclic, 2 * n + 1, true)),
    ]
}

/// A zigzag of points.
fn zigzag(n: usize, seed: u32) -> Vec<[f64; 2]> {
    let angle = |i: usize| f64::from(seed) + 2.3 * i as f64;
    (0..n).map(|i| [6.0 * i as f64 + 2.0 * angle(i).sin(), 10.0 * (1.7 * angle(i)).cos()]).collect()
}

fn weights(basis: &ShapedBasis, span: usize, x: f64) -> Vec<[f64; 3]> {
    let mut weights = Vec::new();
    basis.weights(span, x, &mut weights).unwrap();
    weights
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn weights_sum_to_one_and_are_not_negative((family, n, closed) in families(), x in 0.0..=1.0) {
        let basis = ShapedBasis::new(family, n, closed).unwrap();
        for x in [x, 0.0, 1.0] {
            for span in 0..basis.spans() {
                let weights = weights(&basis, span, x);
                for order in 0..3 {
                    let size = weights.iter().fold(1.0_f64, |m, w| m.max(w[order].abs()));
                    let sum: f64 = weights.iter().map(|w| w[order]).sum();
                    prop_assert!(size < 1e100);
                    let expected = if order == 0 { 1.0 } else { 0.0 };
                    prop_assert!((sum - expected).abs() < 1e-11 * size, "{basis:?} {x} {order}: {sum}");
                }
                prop_assert!(weights.iter().all(|w| w[0] > -1e-14), "{basis:?} {x}: {weights:?}");
            }
        }
        prop_assert!(basis.weights(basis.spans(), x, &mut Vec::new()).is_none());
    }

    #[test]
    fn derivatives_are_those_of_the_values((family, n, closed) in families(), x in 0.05..0.95) {
        let basis = ShapedBasis::new(family, n, closed).unwrap();
        let h = 1e-5;
        let [before, here, after] = [x - h, x, x + h].map(|x| weights(&basis, 0, x));
        for ((a, b), c) in before.iter().zip(&here).zip(&after) {
            for order in 0..2 {
                let slope = (c[order] - a[order]) / (2.0 * h);
                let near = (slope - b[order + 1]).abs() < 1e-4 * (1.0 + slope.abs());
                prop_assert!(near, "{basis:?} {x} {order}: {slope} {b:?}");
            }
        }
    }

    #[test]
    fn arcs_join((family, n, closed) in families(), seed in 0u32..1000) {
        let curve = ShapedCurve::new(family, zigzag(n, seed), closed).unwrap();
        let orders = if matches!(curve.basis().family(), Family::HanQuadratic { .. }) { 2 } else { 3 };
        for span in 0..curve.spans() {
            let next = (span + 1) % curve.spans();
            if next == 0 && !curve.closed() {
                break;
            }
            let (end, start) = (curve.at(span, 1.0).unwrap(), curve.at(next, 0.0).unwrap());
            let size = end.iter().flatten().fold(10.0_f64, |m, x| m.max(x.abs()));
            for order in 0..orders {
                prop_assert!(off(end[order], start[order]) < 1e-11 * size, "{:?} {span} {order}", curve.basis());
            }
        }
    }

    #[test]
    fn lambda_paths_are_straight(lambda in -3.0..3.0, other in -3.0..3.0, x in 0.0..=1.0, seed in 0u32..99) {
        for kind in [LambdaKind::Han, LambdaKind::Alpha, LambdaKind::Gb, LambdaKind::Spb] {
            let family = Family::Lambda { kind, lambda: Lambdas::One(0.0) };
            let curve = ShapedCurve::new(family, zigzag(4, seed), false).unwrap();
            let path = curve.path(Parameter::Lambda, 0, x, &[0.0, lambda, other]).unwrap();
            let [a, b] = [1, 2].map(|i| [path[i][0] - path[0][0], path[i][1] - path[0][1]]);
            prop_assert!((a[0] * b[1] - a[1] * b[0]).abs() < 1e-10);
        }
    }

    // The way of the ordinary basis: the function with its first derivatives at the ends, of 1, t, sin t and cos t.
    #[test]
    fn c_bezier_functions_solve_their_end_conditions(alpha in 0.5..3.1, x in 0.0..=1.0) {
        let basis = ShapedBasis::new(Family::c_bezier(alpha).unwrap(), 4, false).unwrap();
        let weights = weights(&basis, 0, x);
        let t = alpha * x;
        let last = (t - t.sin()) / (alpha - alpha.sin());
        prop_assert!((weights[3][0] - last).abs() < 1e-13);
        // Z2 is a (1 - cos t) + b (t - sin t) with Z2(alpha) = 0 and Z2'(alpha) = -Z3'(alpha).
        let (sin, cos) = alpha.sin_cos();
        let ratio = -(1.0 - cos) / (alpha - sin);
        let a = -(1.0 - cos) / (alpha - sin) / (sin + ratio * (1.0 - cos));
        let z2 = a * (1.0 - t.cos() + ratio * (t - t.sin()));
        prop_assert!((weights[2][0] - z2).abs() < 1e-11, "{} {z2}", weights[2][0]);
    }

    #[test]
    fn elevation_keeps_the_curve(n in 1usize..12, by in 0usize..9, seed in 0u32..1000, turn in 0.0..1.0) {
        let points = zigzag(2 * n + 1, seed);
        let raised = elevate_cyclic(&points, by).unwrap();
        prop_assert_eq!(raised.len(), points.len() + 2 * by);
        let [a, b] = [points, raised].map(|p| ShapedCurve::new(Family::Cyclic, p, true).unwrap());
        prop_assert!(off(at(&a, turn * TAU), at(&b, turn * TAU)) < 1e-11);
    }

    #[test]
    fn random_data_are_passed(
        (family, n, closed) in families(),
        data in prop::collection::vec(prop::array::uniform3(-100.0..100.0), 3..12),
    ) {
        let family = match family {
            Family::Lambda { kind, .. } => Family::Lambda { kind, lambda: Lambdas::One(n as f64 / 3.0) },
            other => other,
        };
        let Ok(found) = interpolate(&family, &data, closed) else { return Ok(()) };
        let curve = found.curve(family, closed).unwrap();
        let joints = curve.joints();
        for (i, datum) in data.iter().enumerate() {
            let joint = if closed { joints[(i + data.len() - 1) % data.len()] } else { joints[i] };
            prop_assert!(off(joint, *datum) < 1e-8, "{:?} {i}", curve.basis());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn points_of_a_curve_are_reached(
        (family, n, closed) in families(), part in 0.2..0.8, x in 0.15..0.85, seed in 0u32..1000,
    ) {
        let curve = ShapedCurve::new(family, zigzag(n, seed), closed).unwrap();
        let (parameter, value) = match curve.basis().family() {
            Family::FBezier { .. } | Family::FBSpline { .. } => (Parameter::Alpha, PI * part),
            Family::Trig(trig) => (Parameter::Beta, trig.sides()[1] as f64 + 8.0 * part),
            Family::Cyclic => return Ok(()),
            _ => (Parameter::Lambda, part),
        };
        let target = curve.with(parameter, value).unwrap().eval(0, x).unwrap();
        let reach = curve.through(parameter, target).unwrap();
        prop_assert!(reach.admissible, "{:?} {parameter:?} {value} {x}: {reach:?}", curve.basis());
        let there = curve.with(parameter, reach.value).unwrap().eval(reach.span, reach.x).unwrap();
        prop_assert!(off(there, target) < 1e-7);
    }
}

/// A parameter that moves the point almost along its curve: Newton's iteration ends 3e-4 beside the target.
#[test]
fn a_target_that_the_curve_glides_past_is_reached() {
    let trig = Trig::new(2, 4, 5.742260519308427, 4.0, Phi::Trig).unwrap();
    let curve = ShapedCurve::new(Family::Trig(trig), zigzag(7, 375), false).unwrap();
    let target = curve.with(Parameter::Beta, 5.6).unwrap().eval(0, 0.22757348147730513).unwrap();
    let reach = curve.through(Parameter::Beta, target).unwrap();
    assert!(reach.admissible, "{reach:?}");
    assert!((reach.value - 5.6).abs() < 1e-3, "{reach:?}");
}
