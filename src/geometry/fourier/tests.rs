use super::*;
use crate::geometry::{Closure, Curve, MAX_SAMPLES, Method};
use proptest::prelude::*;

/// The curve of the book's example: a deltoid (figure 2.2).
fn deltoid() -> Fourier<2> {
    let wave = |amplitude, phase| Wave { amplitude, phase };
    let waves = [[wave(100.0, 0.0), wave(100.0, 0.5)], [wave(50.0, 1.0), wave(50.0, 0.5)]];
    Fourier::new([0.0; 2], &waves).unwrap()
}

/// A curve of 20 harmonics whose coefficients are all exact.
fn twenty() -> Fourier<2> {
    let row = |k: i32| {
        let x = Wave { amplitude: f64::from(k * (21 - k)) / 4.0, phase: f64::from(k) / 8.0 };
        let sign = f64::from(1 - 2 * (k % 2));
        let y = Wave { amplitude: sign * f64::from(21 - k), phase: f64::from(3 * k * k) / 64.0 };
        [x, y]
    };
    Fourier::new([3.0, -2.0], &(1..=20).map(row).collect::<Vec<_>>()).unwrap()
}

fn close(found: f64, expected: f64, error: f64) -> bool {
    (found - expected).abs() <= error
}

/// Waves of one curve in the plane, with 0 to 20 harmonics.
fn waves() -> impl Strategy<Value = Vec<[Wave; 2]>> {
    let wave = || (-300.0..300.0, -4.0..4.0).prop_map(|(amplitude, phase)| Wave { amplitude, phase });
    prop::collection::vec([wave(), wave()], 0..=20)
}

/// Sum of all amplitudes.
fn scale(waves: &[[Wave; 2]]) -> f64 {
    waves.iter().flatten().map(|wave| wave.amplitude.abs()).sum::<f64>() + 1.0
}

#[test]
fn values_agree_with_forty_digits() {
    // Computed with 40 digits from the same exact coefficients.
    let expected = [
        (0.0, [-17.44497946617634, 10.556908973158457]),
        (0.125, [4.650_343_364_587_023, -48.867_183_017_988_175]),
        (0.078125, [5.115_326_375_727_377, 50.146_499_838_895_19]),
        (-0.09375, [-213.336_955_352_218_72, 30.282_060_664_517_833]),
        (0.9775390625, [87.618_809_643_478_7, 42.829_152_648_724_35]),
        (12345.6875, [5.5, 19.908_194_366_991_405]),
    ];
    let curve = twenty();
    let sum: f64 = curve.waves().iter().map(|row| row[0].amplitude).sum();
    for (u, [x, y]) in expected {
        let [found_x, found_y] = curve.eval(u);
        assert!(close(found_x, x, 1e-14 * sum) && close(found_y, y, 1e-14 * sum), "{u}");
    }
}

#[test]
fn quarters_are_exact_and_the_seam_closes() {
    let curve = deltoid();
    assert_eq!(curve.eval(0.0), [0.0, 150.0]);
    let points = curve.polyline(1000).unwrap();
    assert_eq!(points[0], points[1000]);
    assert_eq!(turn(0.25), [1.0, 0.0]);
    assert_eq!(turn(-0.25), [-1.0, 0.0]);
    assert_eq!(turn(1e15 + 0.5)[1], -1.0);
}

#[test]
fn boxes_are_those_of_known_curves() {
    let bounds = deltoid().bounding_box().unwrap();
    // The extremes of 100 sin t - 50 sin 2t are at cos t = -1/2.
    let extreme = 75.0 * 3f64.sqrt();
    for (found, expected) in
        [(bounds.max[0], extreme), (bounds.min[0], -extreme), (bounds.max[1], 150.0), (bounds.min[1], -75.0)]
    {
        assert!(close(found, expected, 3e-10), "{found} {expected}");
    }
    let point = Fourier::new([3.0, -4.0], &[]).unwrap().bounding_box().unwrap();
    assert_eq!((point.min, point.max), ([3.0, -4.0], [3.0, -4.0]));
}

#[test]
fn the_box_of_the_flattest_curve_is_found_in_time() {
    // (1 + cos t)^20 is flat to the order 40 at its minimum 0.
    let mut binomial = 1.0;
    let mut waves = Vec::new();
    for k in 1..=20 {
        binomial *= f64::from(21 - k) / f64::from(20 + k);
        waves.push([Wave { amplitude: 2.0 * binomial, phase: 0.5 }]);
    }
    let bounds = Fourier::new([1.0], &waves).unwrap().bounding_box().unwrap();
    let sum: f64 = waves.iter().map(|wave| wave[0].amplitude).sum();
    assert!(close(bounds.min[0], 0.0, 2e-12 * sum), "{bounds:?}");
    assert!(close(bounds.max[0], 1.0 + sum, 2e-12 * sum));
}

#[test]
fn wrong_coefficients_are_named() {
    let wave = |amplitude, phase| [Wave { amplitude, phase }];
    let message = |offset: f64, waves: &[[Wave; 1]]| Fourier::new([offset], waves).unwrap_err().to_string();
    assert_eq!(message(f64::NAN, &[]), "offset of harmonic 0 is NaN, but must be a number of at most 1e150");
    let second = [wave(1.0, 0.0), wave(f64::INFINITY, 0.0)];
    assert_eq!(
        message(0.0, &second),
        "amplitude of harmonic 2 is inf, but must be a number of at most 1e150"
    );
    assert!(message(0.0, &[wave(1.0, f64::NAN)]).starts_with("phase of harmonic 1 is NaN"));
    assert_eq!(
        Fourier::new([0.0], &[wave(8e149, 0.0), wave(8e149, 0.0)]),
        Err(GeometryError::Overflow { span: 0 })
    );
    let many = vec![wave(0.0, 0.0); MAX_HARMONICS + 1];
    assert!(matches!(Fourier::new([0.0], &many), Err(GeometryError::TooManyHarmonics { .. })));
    for steps in [0, MAX_SAMPLES, usize::MAX] {
        assert!(matches!(deltoid().polyline(steps), Err(GeometryError::Samples { .. })));
    }
    for tolerance in [0.0, -1.0, f64::NAN] {
        assert!(matches!(deltoid().to_cubics(tolerance), Err(GeometryError::Parameter { .. })));
    }
    assert!(matches!(deltoid().to_cubics(1e-13), Err(GeometryError::ToleranceTooSmall { .. })));
}

#[test]
fn the_largest_coefficients_stay_finite() {
    let row = [Wave { amplitude: 4e148, phase: 1e300 }; 2];
    let curve = Fourier::new([1e149; 2], &[row; 20]).unwrap();
    let bounds = curve.bounding_box().unwrap();
    assert!(bounds.size().iter().all(|size| size.is_finite()));
    assert!(curve.derivative(0.3).iter().all(|x| x.is_finite()));
    assert!(curve.to_cubics(1e140).unwrap().iter().flat_map(|arc| arc.p).flatten().all(f64::is_finite));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn values_and_derivatives_agree_with_sines(waves in waves(), u in -2.0..2.0) {
        let curve = Fourier::new([5.0, -7.0], &waves).unwrap();
        let (point, speed) = (curve.eval(u), curve.derivative(u));
        for d in 0..2 {
            let angle = |k: f64, wave: Wave| TAU * k * u + PI * wave.phase;
            let terms = || waves.iter().zip(1u32..).map(|(row, k)| (row[d], f64::from(k)));
            let value: f64 = terms().map(|(w, k)| w.amplitude * angle(k, w).sin()).sum();
            let slope: f64 = terms().map(|(w, k)| w.amplitude * TAU * k * angle(k, w).cos()).sum();
            let error = 1e-12 * scale(&waves);
            prop_assert!(close(point[d], [5.0, -7.0][d] + value, error));
            prop_assert!(close(speed[d], slope, 130.0 * error));
        }
    }

    #[test]
    fn polylines_samples_and_waves_are_the_same_curve(waves in waves(), steps in 1usize..60) {
        let curve = Fourier::new([0.0; 2], &waves).unwrap();
        let again = Fourier::new(curve.offset(), &curve.waves()).unwrap();
        prop_assert!(curve.waves().iter().flatten().all(|w| w.amplitude >= 0.0 && (0.0..2.0).contains(&w.phase)));
        let error = 1e-13 * scale(&waves);
        for sample in curve.sample(steps).unwrap() {
            for other in [curve.eval(sample.u), again.eval(sample.u)] {
                prop_assert!((0..2).all(|d| close(sample.point[d], other[d], error)));
            }
        }
    }

    #[test]
    fn boxes_hold_the_curve_and_touch_it(waves in waves()) {
        let curve = Fourier::new([1.0, 2.0], &waves).unwrap();
        let bounds = curve.bounding_box().unwrap();
        let points = curve.polyline(4000).unwrap();
        let sampled = BoundingBox::of_points(&points).unwrap();
        let (slack, between) = (1e-14 * scale(&waves), scale(&waves) * (TAU * 20.0 / 8000.0).powi(2) / 2.0);
        for d in 0..2 {
            let over = [bounds.max[d] - sampled.max[d], sampled.min[d] - bounds.min[d]];
            prop_assert!(over.iter().all(|over| -slack <= *over && *over <= between), "{over:?}");
        }
    }

    #[test]
    fn cubics_keep_the_tolerance(waves in waves(), exponent in -6.0..2.0) {
        let curve = Fourier::new([1.0, 2.0], &waves).unwrap();
        let tolerance = 10f64.powf(exponent);
        let arcs = curve.to_cubics(tolerance).unwrap();
        let count = arcs.len();
        prop_assert_eq!(arcs[0].p[0], arcs[count - 1].p[3]);
        for j in 0..2000 {
            let place = f64::from(j) / 2000.0 * count as f64;
            let arc = &arcs[(place as usize).min(count - 1)];
            let [x, y] = arc.eval(place - place.floor());
            let [expected_x, expected_y] = curve.eval(place / count as f64);
            prop_assert!((x - expected_x).hypot(y - expected_y) <= tolerance + 1e-12 * scale(&waves));
        }
    }
}

fn star() -> Vec<[f64; 2]> {
    let corner = |k: i32| {
        let (sin, cos) = (f64::from(k) * PI / 5.0).sin_cos();
        let radius = if k % 2 == 0 { 180.0 } else { 70.0 + f64::from(k) };
        [300.0 + radius * sin, 190.0 + radius * cos]
    };
    (0..10).map(corner).collect()
}

/// Cosine and sine coefficient of harmonic `k` in one coordinate by the jumps of a derivative that is
/// piecewise constant: `order` times integrated by parts.
fn by_jumps(pieces: &[(f64, f64, f64)], k: u32, order: i32) -> [f64; 2] {
    let omega = TAU * f64::from(k);
    let mut integral = [0.0; 2];
    for &(from, to, height) in pieces {
        integral[0] += height * ((omega * to).sin() - (omega * from).sin()) / omega;
        integral[1] += height * ((omega * from).cos() - (omega * to).cos()) / omega;
    }
    // Every integration by parts turns [cos, sin] into [-sin, cos] / omega.
    for _ in 0..order {
        integral = [-integral[1] / omega, integral[0] / omega];
    }
    integral.map(|x| 2.0 * x)
}

#[test]
fn polygons_have_their_elliptic_descriptors() {
    // A double corner has no length and must not matter.
    let mut points = star();
    points.insert(3, points[3]);
    let path = ClosedPath::polygon(&points).unwrap();
    let curve = Fourier::fit(&path, 20).unwrap();
    for d in 0..2 {
        let mut pieces = Vec::new();
        for (side, joints) in path.arcs().iter().zip(path.joints().windows(2)).filter(|(_, j)| j[1] > j[0]) {
            pieces.push((joints[0], joints[1], (side.p[3][d] - side.p[0][d]) / (joints[1] - joints[0])));
        }
        for (harmonic, k) in curve.harmonics.iter().zip(1..) {
            let [cos, sin] = by_jumps(&pieces, k, 1);
            assert!(close(harmonic.cos[d], cos, 1e-11) && close(harmonic.sin[d], sin, 1e-11), "{k}");
        }
    }
    let share = |(side, joints): (&CubicBezier<2>, &[f64])| {
        (joints[1] - joints[0]) * 0.5 * (side.p[0][0] + side.p[3][0])
    };
    let mean: f64 = path.arcs().iter().zip(path.joints().windows(2)).map(share).sum();
    assert!(close(curve.offset()[0], mean, 1e-11));
}

#[test]
fn splines_have_the_coefficients_of_their_third_derivative() {
    for count in [3, 10] {
        let points = &star()[..count];
        let path = ClosedPath::spline(points).unwrap();
        let curve = Fourier::fit(&path, 20).unwrap();
        for d in 0..2 {
            let arcs = path.arcs().iter().zip(path.joints().windows(2));
            let height = |arc: &CubicBezier<2>| arc.third_derivative()[d] * (count as f64).powi(3);
            let pieces: Vec<_> = arcs.map(|(arc, j)| (j[0], j[1], height(arc))).collect();
            for (harmonic, k) in curve.harmonics.iter().zip(1..) {
                let [cos, sin] = by_jumps(&pieces, k, 3);
                assert!(close(harmonic.cos[d], cos, 1e-10) && close(harmonic.sin[d], sin, 1e-10), "{k}");
            }
        }
    }
}

#[test]
fn no_curve_comes_nearer_and_more_harmonics_do() {
    for path in [ClosedPath::polygon(&star()).unwrap(), ClosedPath::spline(&star()).unwrap()] {
        let mut last = f64::INFINITY;
        for harmonics in [0, 1, 2, 3, 5, 8, 13, 20, 40] {
            let curve = Fourier::fit(&path, harmonics).unwrap();
            let error = curve.deviation(&path, 4000).unwrap();
            assert!(error.rms < last && error.rms <= error.largest, "{harmonics}");
            last = error.rms;
            for wrong in 0..harmonics {
                let mut other = curve.clone();
                other.harmonics[wrong].sin[0] += 0.5;
                assert!(other.deviation(&path, 4000).unwrap().rms > error.rms);
            }
        }
    }
    let fine = Fourier::fit(&ClosedPath::spline(&star()).unwrap(), 1000).unwrap();
    assert!(fine.deviation(&ClosedPath::spline(&star()).unwrap(), 500).unwrap().largest < 1e-4);
}

#[test]
fn a_path_passes_its_points_in_their_time() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]];
    let polygon = ClosedPath::polygon(&square).unwrap();
    for (u, point) in [(0.0, [0.0, 0.0]), (0.25, [3.0, 0.0]), (0.5, [4.0, 2.0]), (1.0, [0.0, 0.0])] {
        let found = polygon.eval(u);
        assert!((0..2).all(|d| close(found[d], point[d], 1e-14)), "{u} {found:?}");
    }
    let spline = ClosedPath::spline(&square).unwrap();
    assert_eq!(spline.eval(0.25), square[1]);
    let sampled = Curve::through(Method::Spline, Closure::Closed, &square).unwrap();
    assert_eq!(Some(spline.eval(0.375)), sampled.eval(1, 0.5));
}

#[test]
fn paths_that_are_none_are_refused() {
    assert_eq!(ClosedPath::polygon(&[[1.0, 2.0]; 5]), Err(GeometryError::NoLength));
    assert!(matches!(ClosedPath::polygon(&[[1.0]; 2]), Err(GeometryError::TooFewPoints { .. })));
    assert!(matches!(ClosedPath::spline(&[[1.0]; 2]), Err(GeometryError::TooFewPoints { .. })));
    let bad = [[0.0], [f64::NAN], [1.0]];
    assert_eq!(ClosedPath::polygon(&bad), Err(GeometryError::NotFinite { number: 2 }));
    let path = ClosedPath::polygon(&star()).unwrap();
    assert!(matches!(Fourier::fit(&path, MAX_HARMONICS + 1), Err(GeometryError::TooManyHarmonics { .. })));
    assert!(matches!(deltoid().deviation(&path, 0), Err(GeometryError::Samples { .. })));
}
