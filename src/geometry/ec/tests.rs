//! The bases against closed forms and the properties that define them.

use super::*;
use crate::geometry::{Basis, Blend, ParamCurve};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

fn basis(roots: &str, interval: [f64; 2]) -> EcBasis {
    EcBasis::new(&roots.parse().unwrap(), interval).unwrap()
}

fn values(basis: &EcBasis, order: usize, s: f64) -> Vec<f64> {
    let mut out = Vec::new();
    basis.derivatives(order, s, &mut out);
    out
}

fn choose(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

#[test]
fn polynomials_are_those_of_bernstein() {
    for n in 1..=30 {
        let basis = basis(&format!("0^{}", n + 1), [-3.0, 5.0]);
        for s in [0.0, 0.1, 0.35, 0.5, 0.9, 1.0_f64] {
            for (i, value) in values(&basis, 0, s).into_iter().enumerate() {
                let expected = choose(n, i) * s.powi(i as i32) * (1.0 - s).powi((n - i) as i32);
                assert!((value - expected).abs() < 1e-14, "{n} {i} {s}: {value} {expected}");
            }
        }
    }
}

/// Section 1.13 of the thesis's theory: waves and their hyperbolic counterparts.
fn closed_form(n: usize, h: f64, s: f64, wave: fn(f64) -> f64, even: fn(f64) -> f64) -> Vec<f64> {
    let scale = wave(h / 2.0).powi(-(2 * n as i32));
    let c = |i: usize| {
        let i = i.min(2 * n - i);
        let terms = (0..=i / 2)
            .map(|r| choose(n, i - r) * choose(i - r, r) * (2.0 * even(h / 2.0)).powi((i - 2 * r) as i32));
        scale * terms.sum::<f64>()
    };
    (0..=2 * n)
        .map(|i| c(i) * wave((1.0 - s) * h / 2.0).powi((2 * n - i) as i32) * wave(s * h / 2.0).powi(i as i32))
        .collect()
}

#[test]
fn waves_and_hyperbolic_functions_have_closed_forms() {
    for n in 1..=5 {
        for h in [0.3, 1.5, 3.0] {
            for s in [0.05, 0.3, 0.5, 0.8] {
                let cases = [
                    ('T', closed_form(n, h, s, f64::sin, f64::cos)),
                    ('H', closed_form(n, h, s, f64::sinh, f64::cosh)),
                ];
                for (family, expected) in cases {
                    let basis = basis(&format!("{family}{n}"), [1.0, 1.0 + h]);
                    for (value, expected) in values(&basis, 0, s).into_iter().zip(expected) {
                        assert!((value - expected).abs() < 1e-13, "{family}{n} {h} {s}: {value} {expected}");
                    }
                }
            }
        }
    }
}

#[test]
fn the_length_of_the_interval_is_a_shape_parameter() {
    for (h, height) in [(0.1, 0.49969), (1.0, 0.46740), (1.5, 0.42253), (2.0, 0.35078)] {
        assert!((values(&basis("0,i", [0.0, h]), 0, 0.5)[1] - height).abs() < 5e-6);
    }
}

#[test]
fn maxima_of_the_figures() {
    let maxima = |basis: &EcBasis| -> Vec<(f64, f64)> {
        (0..basis.points())
            .map(|i| {
                (0..=1000)
                    .map(|k| f64::from(k) / 1000.0)
                    .map(|s| (s, values(basis, 0, s)[i]))
                    .max_by(|a, b| a.1.total_cmp(&b.1))
                    .unwrap()
            })
            .collect()
    };
    let near = |found: Vec<(f64, f64)>, places: &[f64], heights: &[f64]| {
        for ((found, &s), &height) in found.iter().zip(places).zip(heights) {
            assert!((found.0 - s).abs() < 6e-3 && (found.1 - height).abs() < 6e-5, "{found:?} {s} {height}");
        }
    };
    let at8 = maxima(&basis("0^3,i^2,2i", [-FRAC_PI_2, FRAC_PI_2]));
    near(at8, &[0.0, 0.14, 0.265, 0.385, 0.5], &[1.0, 0.3801, 0.2946, 0.2621, 0.2527]);
    let ae5 = maxima(&basis("0^2,1^2,2^2", [-1.0, 1.0]));
    near(ae5, &[0.0, 0.27, 0.5, 0.69, 0.855, 1.0], &[1.0, 0.4146, 0.3494, 0.3482, 0.4108, 1.0]);
}

#[test]
fn bad_intervals_say_what_would_be_right() {
    let said =
        |roots: &str, interval| EcBasis::new(&roots.parse().unwrap(), interval).unwrap_err().to_string();
    assert_eq!(said("0,i", [1.0, 1.0]), "the interval is [1, 1]; its start must be less than its end");
    let long = said("0,1/4+i", [0.0, 3.0 * PI]);
    assert!(long.starts_with("the interval is too long: its length is 9.42"), "{long}");
    assert!(long.contains("l' = 3.14159265358979"), "{long}");
    assert!(said("0,i", [0.0, 1e-9]).contains("at least 1e-6 is needed"));
    assert!(said("0,1,-1", [0.0, 30.0]).ends_with("it may be 24 at most"));
    assert!(said("0,i", [0.0, f64::INFINITY]).starts_with("the interval is [0, inf]"));
    assert!(said("0,i", [f64::NAN, 1.0]).starts_with("the interval is [NaN, 1]"));
}

#[test]
fn what_decays_is_as_precise_as_what_grows() {
    // The mirror rule: without it {0^2, -4^2} on [0, 10] is wrong by a per cent.
    let (down, up) = (basis("0^2,-4^2", [0.0, 10.0]), basis("0^2,4^2", [0.0, 10.0]));
    for s in [0.0, 0.2, 0.7, 1.0] {
        for order in 0..4 {
            let mirror = values(&up, order, 1.0 - s);
            let sign = if order % 2 == 1 { -1.0 } else { 1.0 };
            for (value, other) in values(&down, order, s).into_iter().zip(mirror.into_iter().rev()) {
                assert!((value - sign * other).abs() <= 1e-12 * (1.0 + other.abs()), "{value} {other}");
            }
        }
    }
}

#[test]
fn too_imprecise_functions_are_refused() {
    // Growing and decaying at once within the limits, with digits lost in both directions.
    let error = EcBasis::new(&"0^2,4^2,-4^2".parse().unwrap(), [0.0, 6.0]).map(|it| it.precision());
    assert!(matches!(error, Err(EcError::Imprecise { .. }) | Ok(..=1e-11)), "{error:?}");
}

#[test]
fn the_quarter_of_the_circle_and_its_transformation() {
    let basis = basis("0,i", [0.0, 2.0 * PI / 3.0]);
    let points = basis.exact(&[[0.0, 0.0], [5.0, 0.0], [0.0, 5.0]]).unwrap();
    let curve = Blend::new(&basis, points).unwrap();
    for k in 0..=50 {
        let [x, y] = curve.eval(0, f64::from(k) / 50.0).unwrap();
        assert!((x.hypot(y) - 5.0).abs() < 3e-15 * 5.0);
    }
    assert_eq!(basis.transformation().unwrap()[0], [1.0; 3]);
}

#[test]
fn spiral_points_of_the_thesis() {
    let growth = (PI / 8.0).exp();
    for k in 0..6 {
        let [from, to] = [f64::from(k) * FRAC_PI_2, f64::from(k + 1) * FRAC_PI_2];
        let points = basis("0,1/4+i", [from, to]).exact(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
        // Every arc is the one before, turned by a right angle and grown.
        let turn = |[x, y]: [f64; 2]| (0..k).fold([x, y], |[x, y], _| [-growth * y, growth * x]);
        let first = [[1.0, 0.0], [1.289640628350567, 1.1585625134022681], [0.0, 1.48097267048991]];
        for (found, expected) in points.iter().zip(first.map(turn)) {
            assert!((found[0] - expected[0]).abs() < 1e-13 && (found[1] - expected[1]).abs() < 1e-13);
        }
    }
}

#[test]
fn elevating_a_line_keeps_it() {
    let (line, target) = (basis("0^2", [0.0, 2.0]), basis("0^6,1", [0.0, 2.0]));
    let points = line.transfer(&[[0.0, 0.0], [4.0, 8.0]], &target).unwrap();
    assert_eq!(points.len(), 7);
    assert!(points.iter().all(|[x, y]| (y - 2.0 * x).abs() < 1e-14));
    let line = Blend::new(target, points).unwrap();
    assert!((line.eval(0, 0.25).unwrap()[0] - 1.0).abs() < 1e-14);
}

#[test]
fn joins_have_equal_derivatives() {
    let (left, right) = (basis("0^3,i", [0.0, 2.0]), basis("0^3,1", [1.0, 2.5]));
    let zigzag = [[0.0, 0.0], [10.0, 25.0], [20.0, -10.0], [30.0, 30.0], [40.0, 5.0]];
    let end = left.end_derivatives(&zigzag, true, 2).unwrap();
    let joined = right.set_end_derivatives(&zigzag[..4], false, &end).unwrap();
    let start = right.end_derivatives(&joined, false, 2).unwrap();
    for (a, b) in end.iter().flatten().zip(start.iter().flatten()) {
        assert!((a - b).abs() < 1e-12 * (1.0 + a.abs()));
    }
    // The same at the other end, and with a mirrored basis.
    for roots in ["0^3,1", "0^3,-1"] {
        let other = basis(roots, [1.0, 2.5]);
        let joined = other.set_end_derivatives(&zigzag[..4], true, &end).unwrap();
        for (a, b) in
            end.iter().flatten().zip(other.end_derivatives(&joined, true, 2).unwrap().iter().flatten())
        {
            assert!((a - b).abs() < 1e-12 * (1.0 + a.abs()), "{roots} {a} {b}");
        }
    }
}

/// Random admissible spaces on intervals of a part of their critical length.
fn admissible() -> impl Strategy<Value = EcBasis> {
    let root =
        (prop_oneof![Just(0.0), -3.0..3.0_f64], prop_oneof![Just(0.0), Just(1.0), 0.1..4.0_f64], 1_usize..4);
    let roots = prop::collection::vec(root, 0..5);
    (1_usize..6, roots, 0.05..0.95_f64, -5.0..5.0_f64).prop_filter_map(
        "a space",
        |(zeros, more, part, start)| {
            let more = more.into_iter().map(|(re, im, m)| Root::of(re, im, m));
            let space = Space::new(std::iter::once(Root::zero(zeros)).chain(more).collect()).ok()?;
            if space.dimension() > MAX_DIMENSION {
                return None;
            }
            // The walk alone, without the bisection.
            let mut search = CriticalLength::new(&space);
            let most =
                (1..40).map(|k| 0.1 * f64::from(k)).take_while(|&length| search.decide(length)).last()?;
            EcBasis::new(&space, [start, start + part * most]).ok()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn functions_sum_to_one_and_are_not_negative(basis in admissible()) {
        let n = basis.points() - 1;
        for k in 0..=60 {
            let all = values(&basis, 0, f64::from(k) / 60.0);
            prop_assert!((all.iter().sum::<f64>() - 1.0).abs() <= 1e-15, "{} {:e}", basis.space(), all.iter().sum::<f64>() - 1.0);
            prop_assert!(all.iter().all(|&value| value >= -1e-15), "{} {:?}", basis.space(), all);
        }
        // The zeros at the ends.
        for order in 0..4.min(n + 1) {
            let (start, end) = (values(&basis, order, 0.0), values(&basis, order, 1.0));
            let size = (0..=20).flat_map(|k| values(&basis, order, f64::from(k) / 20.0)).fold(1.0_f64, |m, x| m.max(x.abs()));
            prop_assert!(start.iter().skip(order + 1).all(|x| x.abs() <= 1e-13 * size));
            prop_assert!(end.iter().rev().skip(order + 1).all(|x| x.abs() <= 1e-13 * size));
            prop_assert!(start[order] > 0.0);
        }
    }

    #[test]
    fn a_space_does_not_feel_shifts_and_scales(basis in admissible()) {
        let [start, _] = basis.interval();
        let length = basis.length();
        let shifted = EcBasis::new(basis.space(), [0.0, length]).unwrap();
        let doubled = basis.space().roots().iter().map(|root| Root::of(2.0 * root.re.value(), 2.0 * root.im.value(), root.multiplicity));
        let scaled = EcBasis::new(&Space::new(doubled.collect()).unwrap(), [0.0, length / 2.0]).unwrap();
        for s in [0.1, 0.5, 0.77] {
            let all = [&shifted, &scaled].map(|other| values(other, 0, s));
            for (i, value) in values(&basis, 0, s).into_iter().enumerate() {
                prop_assert!((value - all[0][i]).abs() < 1e-13 * (1.0 + start.abs()));
                prop_assert!((value - all[1][i]).abs() < 1e-13 * (1.0 + start.abs()));
            }
        }
    }

    #[test]
    fn elevated_and_divided_curves_are_the_same(
        basis in admissible(), heights in prop::collection::vec(-10.0..10.0_f64, 31), part in 0.1..0.9_f64,
    ) {
        let points: Vec<[f64; 2]> = heights.iter().take(basis.points()).enumerate().map(|(k, &y)| [k as f64, y]).collect();
        let curve = Blend::new(&basis, points.clone()).unwrap();
        let [start, end] = basis.interval();
        let middle = start + part * (end - start);
        if let Ok(target) = basis.space().with(&Root::zero(2)).and_then(|space| EcBasis::new(&space, [start, end])) {
            let raised = Blend::new(&target, basis.transfer(&points, &target).unwrap()).unwrap();
            for s in [0.0, 0.2, 0.5, 0.9, 1.0] {
                let [a, b] = [&curve.eval(0, s).unwrap(), &raised.eval(0, s).unwrap()];
                prop_assert!((a[1] - b[1]).abs() < 1e-12, "{:?} {:?}", a, b);
            }
        }
        let halves = [[start, middle], [middle, end]].map(|interval| EcBasis::new(basis.space(), interval).unwrap());
        for half in halves {
            let arc = basis.transfer(&points, &half).unwrap();
            let curve_of_half = Blend::new(&half, arc.clone()).unwrap();
            for s in [0.0, 0.3, 1.0] {
                let u = half.interval()[0] + s * half.length();
                let (a, b) = (curve.eval(0, (u - start) / basis.length()).unwrap(), curve_of_half.eval(0, s).unwrap());
                prop_assert!((a[1] - b[1]).abs() < 1e-12, "{:?} {:?}", a, b);
            }
            // Prolonged to the whole interval, the old points.
            if part > 0.3 && part < 0.7 && basis.points() < 10 {
                for (a, b) in half.transfer(&arc, &basis).unwrap().iter().zip(&points) {
                    prop_assert!((a[1] - b[1]).abs() < 1e-6, "{:?} {:?}", a, b);
                }
            }
        }
    }

    #[test]
    fn exact_descriptions_are_the_functions(basis in admissible(), factors in prop::collection::vec(-2.0..2.0_f64, 31)) {
        let coefficients: Vec<[f64; 1]> = factors.iter().take(basis.points()).map(|&x| [x]).collect();
        let points = basis.exact(&coefficients).unwrap();
        let curve = Blend::new(&basis, points.clone()).unwrap();
        let size = points.iter().fold(1.0_f64, |most, [x]| most.max(x.abs()));
        for s in [0.0, 0.31, 0.8, 1.0] {
            let u = basis.interval()[0] + s * basis.length();
            let functions = basis.space().ordinary(0, u);
            let scale = functions.iter().fold(size, |most, x| most.max(x.abs()));
            let sum: f64 = functions.iter().zip(&coefficients).map(|(f, [c])| f * c).sum();
            prop_assert!((curve.eval(0, s).unwrap()[0] - sum).abs() < 1e-12 * scale);
        }
    }

    #[test]
    fn interpolating_curves_meet_their_data(basis in admissible(), heights in prop::collection::vec(-1.0..1.0_f64, 31)) {
        let n = basis.points() - 1;
        if n <= 10 {
            let places: Vec<f64> = (0..=n).map(|k| k as f64 / n as f64).collect();
            let data: Vec<[f64; 1]> = heights.iter().take(n + 1).map(|&y| [y]).collect();
            let points = basis.interpolate(&places, &data).unwrap();
            let size = points.iter().fold(1.0_f64, |most, [y]| most.max(y.abs()));
            let curve = Blend::new(&basis, points).unwrap();
            for (&s, [y]) in places.iter().zip(&data) {
                prop_assert!((curve.eval(0, s).unwrap()[0] - y).abs() < 1e-13 * size);
            }
        }
    }
}
