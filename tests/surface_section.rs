//! Sections by planes: their points are on the plane and on the surface, their lines end where they should.

use grafika::geometry::{
    Border, GeometryError, Method, ParamSurface, Plane, Point, Scheme, Surface, Topology, section,
};
use proptest::prelude::*;
use std::f64::consts::TAU;

type Net = Vec<Vec<Point<3>>>;

fn dot(a: Point<3>, b: Point<3>) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn minus(a: Point<3>, b: Point<3>) -> Point<3> {
    std::array::from_fn(|d| a[d] - b[d])
}

fn norm(a: Point<3>) -> f64 {
    dot(a, a).sqrt()
}

fn ball(meridians: usize, radius: f64) -> Net {
    let point = |k: usize, l: usize| {
        let (psi, phi) = (TAU * k as f64 / meridians as f64, TAU * l as f64 / 8.0);
        // The poles exactly, as the same point of every meridian.
        let ring = if l.is_multiple_of(4) { 0.0 } else { radius * phi.sin() };
        [ring * psi.cos(), ring * psi.sin(), radius * phi.cos()]
    };
    (0..meridians).map(|k| (0..5).map(|l| point(k, l)).collect()).collect()
}

fn ring(large: f64, small: f64) -> Net {
    let point = |k: usize, l: usize| {
        let (psi, phi) = (TAU * k as f64 / 8.0, TAU * l as f64 / 6.0);
        let q = large + small * phi.cos();
        [q * psi.cos(), q * psi.sin(), small * phi.sin()]
    };
    (0..8).map(|k| (0..6).map(|l| point(k, l)).collect()).collect()
}

fn surface(method: Method, topology: Topology, net: &Net) -> Surface {
    Surface::new(Scheme::new(method, topology), net).unwrap()
}

/// How far a point is from a surface: from the nearest sample by Newton's method for the nearest place.
fn distance_from(surface: &Surface, p: Point<3>) -> f64 {
    let samples = surface.sample(8).unwrap();
    let near = |s: &&grafika::geometry::SurfaceSample| norm(minus(s.point, p));
    let mut order: Vec<_> = samples.iter().collect();
    order.sort_by(|a, b| near(a).total_cmp(&near(b)));
    let from = |s: &grafika::geometry::SurfaceSample| {
        let ([i, j], [mut u, mut v]) = (s.spans, s.parameters);
        let mut best = f64::INFINITY;
        for _ in 0..40 {
            let at = surface.at([i, j], [u, v]).unwrap();
            let off = minus(p, at.point);
            best = best.min(norm(off));
            let (e, f, g) = (dot(at.u, at.u), dot(at.u, at.v), dot(at.v, at.v));
            let (a, b) = (dot(at.u, off), dot(at.v, off));
            let determinant = e * g - f * f;
            if determinant <= 1e-12 * e * g {
                break;
            }
            u = (u + (g * a - f * b) / determinant).clamp(0.0, 1.0);
            v = (v + (e * b - f * a) / determinant).clamp(0.0, 1.0);
        }
        best
    };
    order.iter().take(6).map(|s| from(s)).fold(f64::INFINITY, f64::min)
}

fn is_closed(line: &[Point<3>]) -> bool {
    line.len() > 3 && line.first() == line.last()
}

fn length(line: &[Point<3>]) -> f64 {
    line.windows(2).map(|w| norm(minus(w[1], w[0]))).sum()
}

#[test]
fn parallels_of_a_ball_are_single_rings() {
    let ball = surface(Method::Spline, Topology::Sphere, &ball(8, 100.0));
    for z in [-95.0, -30.0, 0.0, 0.1, 70.0, 99.0] {
        let plane = Plane { normal: [0.0, 0.0, 5.0], offset: 5.0 * z };
        let lines = section(&ball, plane, 10).unwrap();
        assert_eq!(lines.len(), 1, "{z}");
        assert!(is_closed(&lines[0]));
        let round = TAU * f64::sqrt(1e4 - z * z);
        assert!((length(&lines[0]) / round - 1.0).abs() < 0.03, "{z}: {} {round}", length(&lines[0]));
        for &p in &lines[0] {
            assert!((p[2] - z).abs() < 1e-10);
            assert!(distance_from(&ball, p) < 1e-9, "{z} {p:?} {}", distance_from(&ball, p));
        }
    }
    assert!(section(&ball, Plane { normal: [0.0, 0.0, 1.0], offset: 101.0 }, 10).unwrap().is_empty());
}

#[test]
fn a_plane_through_both_poles_gives_one_ring() {
    let ball = surface(Method::Spline, Topology::Sphere, &ball(8, 100.0));
    for angle in [0.0, 0.2, TAU / 16.0, TAU / 8.0, 1.0, 2.0, 3.0, TAU / 4.0] {
        let normal = [f64::cos(angle), f64::sin(angle), 0.0];
        let lines = section(&ball, Plane { normal, offset: 0.0 }, 6).unwrap();
        assert_eq!(lines.len(), 1, "{angle}");
        assert!(is_closed(&lines[0]));
        assert!((length(&lines[0]) / (TAU * 100.0) - 1.0).abs() < 0.02);
        let reach = |z: f64| lines[0].iter().any(|p| norm(minus(*p, [0.0, 0.0, z])) < 1e-9);
        assert!(reach(100.0) && reach(-100.0));
    }
}

#[test]
fn lines_end_at_the_holes_of_doubled_poles() {
    let ball = surface(Method::BSpline3, Topology::Sphere, &ball(8, 100.0));
    let lines = section(&ball, Plane { normal: [0.3, 1.0, 0.0], offset: 0.0 }, 6).unwrap();
    assert_eq!(lines.len(), 2);
    let ends: Vec<_> = lines.iter().flat_map(|line| [line[0], line[line.len() - 1]]).collect();
    let hole = ball.eval([0, 0], [0.0, 0.0]).unwrap()[2];
    assert!(ends.iter().all(|end| (end[2].abs() - hole).abs() < 1e-9), "{ends:?}");
}

#[test]
fn touching_planes_give_nothing_or_a_speck() {
    let ball = surface(Method::Spline, Topology::Sphere, &ball(8, 100.0));
    for normal in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]] {
        for line in section(&ball, Plane { normal, offset: 100.0 }, 10).unwrap() {
            assert!(length(&line) < 1e-3, "{normal:?} {}", length(&line));
        }
        for line in section(&ball, Plane { normal, offset: -100.0 }, 10).unwrap() {
            assert!(length(&line) < 1e-3, "{normal:?} {}", length(&line));
        }
    }
}

#[test]
fn a_torus_has_two_rings_three_ways() {
    let torus = surface(Method::Spline, Topology::Torus, &ring(100.0, 40.0));
    for normal in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.3, 1.0, 0.0], [0.38, 0.0, 1.0]] {
        let lines = section(&torus, Plane { normal, offset: 0.0 }, 10).unwrap();
        assert_eq!(lines.len(), 2, "{normal:?}");
        for line in &lines {
            assert!(is_closed(line));
            for &p in line.iter().step_by(5) {
                assert!(dot(p, normal).abs() < 1e-10 && distance_from(&torus, p) < 1e-9);
            }
        }
    }
    let lines = section(&torus, Plane { normal: [1.0, 0.0, 0.0], offset: 65.0 }, 20).unwrap();
    assert!(lines.iter().all(|line| is_closed(line)) && !lines.is_empty());
}

/// The graph z = a x² + b y² over [-1, 1] x [-1, 1] as a bicubic Bézier patch.
fn bowl(a: f64, b: f64) -> Surface {
    let square = [1.0, -1.0 / 3.0, -1.0 / 3.0, 1.0];
    let net: Net = (0..4)
        .map(|k| {
            let (x, xx) = (k as f64 / 1.5 - 1.0, square[k]);
            (0..4).map(|l| [x, l as f64 / 1.5 - 1.0, a * xx + b * square[l]]).collect()
        })
        .collect();
    surface(Method::Bezier, Topology::Open, &net)
}

#[test]
fn sections_of_graphs_are_conics() {
    let lines = section(&bowl(2.0, 3.0), Plane { normal: [0.0, 0.0, 1.0], offset: 1.0 }, 20).unwrap();
    assert_eq!(lines.len(), 1);
    assert!(is_closed(&lines[0]));
    for [x, y, z] in lines[0].iter().copied() {
        assert!((z - 1.0).abs() < 1e-12 && (2.0 * x * x + 3.0 * y * y - z).abs() < 1e-12);
    }
    // A saddle at its height: two straight lines that cross, in four arms that end at the border.
    let lines = section(&bowl(1.0, -1.0), Plane { normal: [0.0, 0.0, 1.0], offset: 0.0 }, 7).unwrap();
    assert_eq!(lines.len(), 2);
    for line in &lines {
        for end in [line[0], line[line.len() - 1]] {
            assert!((end[0].abs() - 1.0).abs() < 1e-12 && (end[1].abs() - 1.0).abs() < 1e-12, "{end:?}");
        }
    }
}

#[test]
fn flat_surfaces_in_the_plane_have_no_section() {
    let flat: Net = (0..5).map(|k| (0..5).map(|l| [f64::from(k), f64::from(l), 0.0]).collect()).collect();
    for method in [Method::Spline, Method::BSpline2, Method::BSpline3, Method::Local { k0: 0.5 }] {
        let flat = surface(method, Topology::Open, &flat);
        assert_eq!(section(&flat, Plane { normal: [0.0, 0.0, 1.0], offset: 0.0 }, 5), Ok(Vec::new()));
        let across = section(&flat, Plane { normal: [1.0, 0.0, 0.0], offset: 2.0 }, 5).unwrap();
        assert_eq!(across.len(), 1);
    }
    // One end raised: the border of the part that stays in the plane.
    let mut lowered = flat.clone();
    lowered[0].iter_mut().for_each(|p| p[2] = -5.0);
    let lines = section(
        &surface(Method::BSpline3, Topology::Open, &lowered),
        Plane { normal: [0.0, 0.0, 1.0], offset: 0.0 },
        4,
    );
    assert_eq!(lines.unwrap().len(), 1);
    // All points are one.
    let point = vec![vec![[1.0, 2.0, 3.0]; 4]; 4];
    for topology in [Topology::Open, Topology::Sphere, Topology::Torus] {
        let lines =
            section(&surface(Method::Spline, topology, &point), Plane::through([1.0, 2.0, 3.0], [1.0; 3]), 3);
        assert_eq!(lines, Ok(Vec::new()));
    }
}

#[test]
fn wrong_input_is_an_error() {
    let ball = surface(Method::Spline, Topology::Sphere, &ball(8, 100.0));
    let at = |normal, offset, steps| section(&ball, Plane { normal, offset }, steps);
    assert!(matches!(at([0.0; 3], 0.0, 5), Err(GeometryError::Parameter { .. })));
    assert!(matches!(at([f64::NAN, 0.0, 1.0], 0.0, 5), Err(GeometryError::NotFinite { .. })));
    assert!(matches!(at([0.0, 0.0, 1.0], f64::NAN, 5), Err(GeometryError::Parameter { name: "offset", .. })));
    assert!(matches!(at([0.0, 0.0, 1.0], 0.0, 0), Err(GeometryError::Samples { .. })));
    assert!(matches!(at([0.0, 0.0, 1.0], 0.0, usize::MAX), Err(GeometryError::Samples { .. })));
    assert!(at([1e-200, 0.0, 0.0], 0.0, 3).unwrap().len() == 1);
}

fn method() -> impl Strategy<Value = Method> {
    prop_oneof![
        Just(Method::Spline),
        Just(Method::BSpline2),
        Just(Method::BSpline3),
        (0.4..2.5, 0.0..9.0).prop_map(|(bias, tension)| Method::Beta { bias, tension }),
        (-1.0..1.0).prop_map(|k0| Method::Local { k0 }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn points_are_on_the_plane_and_lines_end_at_borders(
        // Whole coordinates from few, so that places, rows and poles often lie on the plane.
        net in prop::collection::vec(prop::collection::vec([-2_i8..3, -2_i8..3, -2_i8..3], 5), 6),
        topology in prop_oneof![Just(Topology::Open), Just(Topology::Sphere), Just(Topology::Torus)],
        method in method(),
        normal in [-2_i8..3, -2_i8..3, -2_i8..3],
        offset in -2_i8..3,
        scale in prop_oneof![Just(1.0), Just(1e-3), Just(1e147), Just(1e-140)],
    ) {
        prop_assume!(normal != [0; 3]);
        let scaled = |x: i8| scale * f64::from(x);
        let mut net: Net = net.iter().map(|row| row.iter().map(|p| p.map(scaled)).collect()).collect();
        if topology == Topology::Sphere {
            let poles = [net[0][0], net[0][4]];
            net.iter_mut().for_each(|row| (row[0], row[4]) = (poles[0], poles[1]));
        }
        let scheme = Scheme { border: Border::Reached, ..Scheme::new(method, topology) };
        let surface = Surface::new(scheme, &net).unwrap();
        let plane = Plane { normal: normal.map(f64::from), offset: scaled(offset) };
        for line in section(&surface, plane, 4).unwrap() {
            prop_assert!(line.len() > 1);
            for &p in &line {
                prop_assert!((dot(p, plane.normal) - plane.offset).abs() < 1e-11 * scale);
            }
            if topology != Topology::Open {
                prop_assert_eq!(line.first(), line.last());
            }
        }
    }
}
