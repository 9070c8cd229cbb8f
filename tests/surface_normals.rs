//! Normals, brightness and curvature against exact surfaces and finite differences, and normals where the
//! derivatives have none.

use grafika::file::{Document, Format};
use grafika::geometry::{Border, Method, ParamSurface, Point, Scheme, Surface, Topology};
use proptest::prelude::*;
use std::f64::consts::TAU;

type Net = Vec<Vec<Point<3>>>;

fn dot(a: Point<3>, b: Point<3>) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn cross(a: Point<3>, b: Point<3>) -> Point<3> {
    std::array::from_fn(|d| a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3])
}

fn unit(a: Point<3>) -> Point<3> {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

fn angle(a: Point<3>, b: Point<3>) -> f64 {
    let c = cross(a, b);
    dot(c, c).sqrt().atan2(dot(a, b))
}

fn surface(method: Method, topology: Topology, net: &Net) -> Surface {
    let scheme = Scheme { border: Border::Reached, ..Scheme::new(method, topology) };
    Surface::new(scheme, net).unwrap()
}

/// A ball's net, turned and moved so that nothing is exactly 0.
fn ball(meridians: usize, parallels: usize, radius: f64) -> Net {
    let point = |k: usize, l: usize| {
        let psi = TAU * k as f64 / meridians as f64;
        let phi = TAU / 2.0 * l as f64 / (parallels - 1) as f64;
        let flat = if l == 0 || l + 1 == parallels { 0.0 } else { radius * phi.sin() };
        let [x, y, z] = [flat * psi.cos(), flat * psi.sin(), radius * phi.cos()];
        [0.6 * x + 0.8 * z + 31.0, y - 17.0, 0.6 * z - 0.8 * x + 5.0]
    };
    (0..meridians).map(|k| (0..parallels).map(|l| point(k, l)).collect()).collect()
}

const AXIS: Point<3> = [0.8, 0.0, 0.6];

#[test]
fn poles_have_the_normal_of_their_tangent_plane() {
    let net = ball(8, 5, 120.0);
    let methods = [
        Method::Spline,
        Method::Local { k0: 0.5 },
        Method::BSpline3,
        Method::Beta { bias: 1.7, tension: 3.0 },
    ];
    for method in methods {
        let surface = surface(method, Topology::Sphere, &net);
        let [rows, columns] = surface.spans();
        let mut worst = 0.0_f64;
        for i in 0..rows {
            for u in [0.0, 0.3, 0.5, 1.0] {
                for (j, v) in [(0, 0.0), (columns - 1, 1.0)] {
                    let normal = surface.normal([i, j], [u, v]).unwrap();
                    // East times south is inwards.
                    let inward = if v == 0.0 { AXIS.map(|x| -x) } else { AXIS };
                    worst = worst.max(angle(normal, inward));
                    let near = surface.normal([i, j], [u, (v - 0.01).abs()]).unwrap();
                    assert!(dot(near, normal) > 0.99);
                }
            }
        }
        println!("{}: {worst:e}", method.name());
        assert!(worst < 1e-8, "{method:?}: {worst:e}");
    }
}

#[test]
fn coinciding_control_points_have_normals() {
    // A corner of a Bézier patch where three points coincide: both derivatives vanish there.
    let mut net: Net = (0..4)
        .map(|k| (0..4).map(|l| [f64::from(k), f64::from(l), 0.2 * f64::from(k * l)]).collect())
        .collect();
    net[0][1] = net[0][0];
    net[1][0] = net[0][0];
    net[1][1] = net[0][0];
    let patch = surface(Method::Bezier, Topology::Open, &net);
    assert_eq!(patch.at([0, 0], [0.0, 0.0]).unwrap().normal(), None);
    let normal = patch.normal([0, 0], [0.0, 0.0]).unwrap();
    assert!(normal.iter().all(|x| x.is_finite()) && (dot(normal, normal) - 1.0).abs() < 1e-12);
    // A row that is one point: normals along it, and the same from both sides of a place.
    let mut net: Net = (0..4)
        .map(|k| (0..4).map(|l| [f64::from(k * l), f64::from(k), f64::from(k * k)]).collect())
        .collect();
    net[0].fill([0.0; 3]);
    let patch = surface(Method::Bezier, Topology::Open, &net);
    for v in [0.0, 0.25, 0.5, 1.0] {
        let (at, near) = (patch.normal([0, 0], [0.0, v]).unwrap(), patch.normal([0, 0], [1e-6, v]).unwrap());
        assert!(angle(at, near) < 1e-5, "{v} {}", angle(at, near));
    }
}

#[test]
fn what_is_no_surface_has_no_normal() {
    let point = vec![vec![[1.0, 2.0, 3.0]; 4]; 4];
    let line: Net = (0..4).map(|k| (0..4).map(|l| [f64::from(k), f64::from(k + l), 0.0]).collect()).collect();
    let line: Net = line
        .iter()
        .map(|row| row.iter().map(|p| [p[0] + p[1], 2.0 * (p[0] + p[1]), 7.0]).collect())
        .collect();
    for net in [point, line] {
        for method in [Method::Spline, Method::BSpline2, Method::BSpline3, Method::Bezier] {
            let surface = surface(method, Topology::Open, &net);
            for place in [0.0, 0.3, 0.5, 1.0] {
                assert_eq!(surface.normal([0, 0], [place, 0.5]), None, "{method:?}");
                assert_eq!(surface.gaussian_curvature([0, 0], [place, 0.5]), None, "{method:?}");
            }
        }
    }
    let ball = surface(Method::Spline, Topology::Sphere, &ball(8, 5, 10.0));
    assert_eq!(ball.normal([8, 0], [0.5, 0.5]), None);
    assert_eq!(ball.brightness([0, 0], [0.5, 0.5], [0.0; 3]), None);
    assert_eq!(ball.brightness([0, 0], [0.5, 0.5], [f64::NAN, 0.0, 1.0]), None);
}

/// The graph z = a x² + b y² over [-1, 1] x [-1, 1] as a Bézier patch of degrees 3 and 3 or 2 and 2.
fn bowl(a: f64, b: f64, points: usize) -> Surface {
    let last = (points - 1) as f64;
    let at = |k: usize| 2.0 * k as f64 / last - 1.0;
    // The blossom of x², with one more point for a degree more.
    let squares: Vec<f64> =
        if points == 3 { vec![1.0, -1.0, 1.0] } else { vec![1.0, -1.0 / 3.0, -1.0 / 3.0, 1.0] };
    let net: Net = (0..points)
        .map(|k| (0..points).map(|l| [at(k), at(l), a * squares[k] + b * squares[l]]).collect())
        .collect();
    surface(Method::Bezier, Topology::Open, &net)
}

#[test]
fn graphs_have_their_exact_normals_and_curvature() {
    let (a, b) = (0.7, -1.3);
    for points in [3, 4] {
        let bowl = bowl(a, b, points);
        for (u, v) in (0..=10).flat_map(|k| (0..=10).map(move |l| (f64::from(k) / 10.0, f64::from(l) / 10.0)))
        {
            let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
            let normal = unit([-2.0 * a * x, -2.0 * b * y, 1.0]);
            assert!(angle(bowl.normal([0, 0], [u, v]).unwrap(), normal) < 1e-14 * 100.0);
            let steep = 1.0 + 4.0 * (a * a * x * x + b * b * y * y);
            let curvature = bowl.gaussian_curvature([0, 0], [u, v]).unwrap();
            assert_eq!(Some(curvature), bowl.at([0, 0], [u, v]).unwrap().gaussian_curvature());
            assert!((curvature - 4.0 * a * b / (steep * steep)).abs() < 1e-12);
            let light = [1.0, 2.0, 3.0];
            let bright = bowl.brightness([0, 0], [u, v], light).unwrap();
            assert!((bright - dot(normal, unit(light))).abs() < 1e-13);
        }
    }
}

#[test]
fn a_fine_ball_has_the_curvature_of_a_sphere() {
    // Spline surfaces through a sphere approach it: curvature 1 / r² as the square of the step.
    let mut before = f64::INFINITY;
    for fineness in [8, 16, 32] {
        let ball = surface(Method::Spline, Topology::Sphere, &ball(2 * fineness, fineness + 1, 10.0));
        let mut worst = 0.0_f64;
        for j in 1..fineness - 1 {
            let at = ball.at([3, j], [0.4, 0.6]).unwrap();
            worst = worst.max((at.gaussian_curvature().unwrap() * 100.0 - 1.0).abs());
        }
        for (j, v) in [(0, 0.0), (fineness - 1, 1.0)] {
            // At a pole the limit, which nearby places confirm.
            let at_pole = ball.gaussian_curvature([3, j], [0.4, v]).unwrap();
            let near = ball.gaussian_curvature([3, j], [0.4, (v - 1e-4_f64).abs()]).unwrap();
            assert!((at_pole / near - 1.0).abs() < 1e-3, "{fineness}: {at_pole} {near}");
            worst = worst.max((at_pole * 100.0 - 1.0).abs());
        }
        println!("{fineness}: {worst:e}");
        assert!(worst < 0.4 * before);
        before = worst;
    }
    assert!(before < 0.01, "{before}");
}

fn nets() -> impl Strategy<Value = Net> {
    let point = [-100.0..100.0, -100.0..100.0, -100.0..100.0];
    prop::collection::vec(prop::collection::vec(point, 5), 6)
}

fn method() -> impl Strategy<Value = Method> {
    prop_oneof![
        Just(Method::Spline),
        Just(Method::BSpline2),
        Just(Method::BSpline3),
        Just(Method::Bezier),
        Just(Method::Local { k0: 0.6 }),
        (0.4..2.5, 0.0..9.0).prop_map(|(bias, tension)| Method::Beta { bias, tension }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn derivatives_are_limits_of_differences(
        net in nets(), method in method(), u in 0.01..0.99_f64, v in 0.01..0.99_f64,
    ) {
        let surface = surface(method, Topology::Open, &net);
        let [i, j] = surface.spans().map(|spans| spans / 2);
        let h = 1e-4;
        let at = |du: f64, dv: f64| surface.at([i, j], [u + du * h, v + dv * h]).unwrap();
        let slope = |f: &dyn Fn(f64) -> Point<3>| -> Point<3> {
            let (before, after) = (f(-1.0), f(1.0));
            std::array::from_fn(|d| (after[d] - before[d]) / (2.0 * h))
        };
        let close = |a: Point<3>, b: Point<3>| (0..3).all(|d| (a[d] - b[d]).abs() < 1e-3);
        let here = at(0.0, 0.0);
        prop_assert!(close(here.u, slope(&|s| at(s, 0.0).point)));
        prop_assert!(close(here.v, slope(&|s| at(0.0, s).point)));
        prop_assert!(close(here.uu, slope(&|s| at(s, 0.0).u)));
        prop_assert!(close(here.uv, slope(&|s| at(0.0, s).u)));
        prop_assert!(close(here.uv, slope(&|s| at(s, 0.0).v)));
        prop_assert!(close(here.vv, slope(&|s| at(0.0, s).v)));
    }

    /// Gauss: the curvature is the area that the normals run through, by the area of the surface.
    #[test]
    fn curvature_is_the_spread_of_normals(
        net in nets(), method in method(), u in 0.1..0.9_f64, v in 0.1..0.9_f64,
    ) {
        let surface = surface(method, Topology::Open, &net);
        let [i, j] = surface.spans().map(|spans| spans / 2);
        let here = surface.at([i, j], [u, v]).unwrap();
        let area = cross(here.u, here.v);
        // Where the surface is nearly folded, differences of normals are coarse.
        prop_assume!(dot(area, area) > 0.04 * dot(here.u, here.u) * dot(here.v, here.v));
        prop_assume!(dot(here.u, here.u) > 100.0 && dot(here.v, here.v) > 100.0);
        let h = 1e-4;
        let normal = |du: f64, dv: f64| surface.normal([i, j], [u + du * h, v + dv * h]).unwrap();
        let difference = |a: Point<3>, b: Point<3>| -> Point<3> {
            std::array::from_fn(|d| (a[d] - b[d]) / (2.0 * h))
        };
        let spread = cross(
            difference(normal(1.0, 0.0), normal(-1.0, 0.0)),
            difference(normal(0.0, 1.0), normal(0.0, -1.0)),
        );
        let ours = here.gaussian_curvature().unwrap() * dot(area, area).sqrt();
        let theirs = dot(spread, unit(area));
        prop_assert!((ours - theirs).abs() < 1e-3 * (1.0 + ours.abs()), "{ours} {theirs}");
    }

    #[test]
    fn normals_are_units_or_nothing(
        net in prop::collection::vec(prop::collection::vec([-1_i8..2, -1_i8..2, -1_i8..2], 5), 6),
        method in method(), u in 0_u8..3, v in 0_u8..3,
        scale in prop_oneof![Just(1.0), Just(1e149), Just(1e-140), Just(1e-310)],
    ) {
        let net: Net = net.iter().map(|row| row.iter().map(|p| p.map(|x| scale * f64::from(x))).collect()).collect();
        let surface = surface(method, Topology::Open, &net);
        let [rows, columns] = surface.spans();
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            if let Some(n) = surface.normal([i, j], [f64::from(u) / 2.0, f64::from(v) / 2.0]) {
                prop_assert!((dot(n, n) - 1.0).abs() < 1e-12);
            }
        }
    }
}

/// The unit tangents of all meridians in the north pole, by differences of points alone.
fn tangents_in_the_pole(surface: &Surface) -> Vec<Point<3>> {
    let step = 1e-6;
    let [rows, _] = surface.spans();
    let tangent = |i: usize| {
        let [pole, near] = [0.0, step].map(|v| surface.eval([i, 0], [0.0, v]).unwrap());
        unit(std::array::from_fn(|d| near[d] - pole[d]))
    };
    (0..rows).map(tangent).collect()
}

/// The largest angle, in degrees, by which a meridian leaves the direction of the opposite one.
fn kink(tangents: &[Point<3>]) -> f64 {
    let (front, back) = tangents.split_at(tangents.len() / 2);
    let angles = front.iter().zip(back).map(|(&there, &opposite)| angle(there, opposite.map(|x| -x)));
    angles.fold(0.0, f64::max).to_degrees()
}

#[test]
fn a_pole_of_beta_splines_has_a_tangent_plane_only_where_its_neighbours_lie_in_one() {
    let surface = |name: &str| {
        let bytes = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/data/").to_owned() + name).unwrap();
        let Ok(Document::Net(net)) = Document::read(Format::Zmb, &bytes) else { panic!("{name} is a net") };
        let method = Method::Beta { bias: 1.0, tension: 0.0 };
        surface(method, Topology::Sphere, &net.points)
    };
    // Opposite neighbours of the pole lie symmetrically in all of them, but only in a plane in these.
    for name in ["A.ZMB", "B.ZMB", "K2.ZMB", "K3.ZMB"] {
        let kink = kink(&tangents_in_the_pole(&surface(name)));
        assert!(kink < 1e-3, "{name}: {kink}");
    }
    let kink = kink(&tangents_in_the_pole(&surface("K1.ZMB")));
    assert!((kink - 32.8).abs() < 0.05, "{kink}");
}
