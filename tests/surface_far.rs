//! Surfaces and curves that lie far from the origin, are very small, or have no area, as `grafika render` writes them.

#![cfg(feature = "native")]

use grafika::figure::Mesh;
use grafika::file::{Document, Net, NetKind};
use grafika::geometry::{Grid, ParamSurface, Plane, Point, section};
use grafika::geometry::{Method, Scheme, Surface, Topology};
use proptest::prelude::*;
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::process::Command;

type Rows = Vec<Vec<Point<3>>>;

/// The net of a ball of radius 1 with its middle at (far, far, 0).
fn ball(far: f64) -> Rows {
    let ring = |k: usize, l: usize| {
        let (psi, fi) = (k as f64 * TAU / 8.0, l as f64 * PI / 4.0);
        let radius = if l == 0 || l == 4 { 0.0 } else { fi.sin() };
        [far + radius * psi.cos(), far + radius * psi.sin(), fi.cos()]
    };
    (0..8).map(|k| (0..5).map(|l| ring(k, l)).collect()).collect()
}

/// Runs `grafika render` on a document; what it said, and the file it wrote if it succeeded.
fn render(name: &str, json: &str, output: &str, more: &[&str]) -> (String, Option<Vec<u8>>) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("far");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join(name), json).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_grafika"));
    command.args(["render", name, "-o", output]).args(more).current_dir(&folder);
    let done = command.output().unwrap();
    let said = String::from_utf8(done.stderr).unwrap();
    (said, done.status.success().then(|| std::fs::read(folder.join(output)).unwrap()))
}

fn net(kind: NetKind, points: Rows) -> String {
    Document::Net(Net::new(kind, points)).to_json().unwrap()
}

/// The corners of every triangle of a binary STL.
fn stl(bytes: &[u8]) -> Vec<[Point<3>; 3]> {
    let number = |bytes: &[u8]| f64::from(f32::from_le_bytes(bytes.try_into().unwrap()));
    let count = u32::from_le_bytes(bytes[80..84].try_into().unwrap()) as usize;
    assert_eq!(bytes.len(), 84 + 50 * count);
    let corner = |triangle: &[u8], c: usize| -> Point<3> {
        std::array::from_fn(|d| number(&triangle[12 + 12 * c + 4 * d..16 + 12 * c + 4 * d]))
    };
    bytes[84..].chunks(50).map(|triangle| [0, 1, 2].map(|c| corner(triangle, c))).collect()
}

/// How many edges are not run through as often one way as the other, and how many triangles have no area.
fn faults(triangles: &[[Point<3>; 3]]) -> [usize; 2] {
    let mut edges: HashMap<[[u64; 3]; 2], i64> = HashMap::new();
    let mut narrow = 0;
    for &[a, b, c] in triangles {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let (from, to) = (from.map(|x| (x + 0.0).to_bits()), to.map(|x| (x + 0.0).to_bits()));
            *edges.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
        }
        let leg = |p: Point<3>| -> Point<3> { std::array::from_fn(|d| p[d] - a[d]) };
        let (u, v) = (leg(b), leg(c));
        let area = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        narrow += usize::from(area == [0.0; 3]);
    }
    [edges.values().filter(|&&balance| balance != 0).count(), narrow]
}

#[test]
fn a_ball_far_away_is_closed_in_stl_and_what_is_lost_is_said() {
    for (far, confused, least) in [(0.0, 0, 6240), (1e5, 64, 6000), (1e6, 1128, 4000), (1e7, 3112, 200)] {
        let (said, written) = render("ball.json", &net(NetKind::Zms, ball(far)), "ball.stl", &[]);
        let triangles = stl(&written.expect("it is written"));
        assert_eq!(faults(&triangles), [0, 0], "{far:e}");
        assert!(triangles.len() >= least, "{far:e}: {}", triangles.len());
        match confused {
            0 => assert_eq!(said, ""),
            _ => assert!(
                said.lines().count() == 1
                    && said.contains(&format!("cannot tell {confused} of these 3122 points apart"))
                    && said.contains("nearer to the origin"),
                "{said}"
            ),
        }
        // Doubles hold them all.
        for other in ["ball.ply", "ball.obj", "ball.step"] {
            let (said, written) = render("ball.json", &net(NetKind::Zms, ball(far)), other, &[]);
            assert!(said.is_empty() && written.is_some(), "{other}: {said}");
        }
    }
}

#[test]
fn what_singles_leave_nothing_of_is_refused() {
    let tiny: Rows =
        ball(0.0).iter().map(|row| row.iter().map(|point| point.map(|x| x * 1e-60)).collect()).collect();
    for points in [ball(1e12), tiny] {
        let (said, written) = render("gone.json", &net(NetKind::Zms, points.clone()), "gone.stl", &[]);
        assert!(written.is_none() && said.contains("leaves nothing of this surface"), "{said}");
        let (said, written) = render("gone.json", &net(NetKind::Zms, points), "gone.obj", &[]);
        assert!(written.is_some(), "{said}");
    }
}

/// Surfaces that are no surfaces, by what they are called.
fn without_area() -> Vec<(&'static str, NetKind, Rows)> {
    let rows = |point: &dyn Fn(f64, f64) -> Point<3>| -> Rows {
        (0..8).map(|k| (0..5).map(|l| point(f64::from(k), f64::from(l))).collect()).collect()
    };
    let circle = |angle: f64| [100.0 * angle.cos(), 100.0 * angle.sin(), 0.0];
    vec![
        ("a line from pole to pole", NetKind::Zms, rows(&|_, l| [0.0, 0.0, 100.0 - 50.0 * l])),
        ("rows in a point each", NetKind::Fem, rows(&|k, _| [10.0 * k, 0.0, 0.0])),
        ("a slanting line far away", NetKind::Fem, rows(&|k, l| [1e7 + k + l / 7.0; 3])),
        ("one point", NetKind::Zys, rows(&|_, _| [7.0, 8.0, 9.0])),
        ("equal circles", NetKind::Zys, rows(&|_, l| circle(l * TAU / 5.0))),
        ("circles that are points", NetKind::Zys, rows(&|k, _| circle(k * TAU / 8.0))),
        ("equal rows of an open net", NetKind::Fem, rows(&|_, l| [10.0 * l, l * l, 3.0 * l * l * l])),
    ]
}

#[test]
fn surfaces_without_area_are_refused_in_every_format() {
    for (what, kind, points) in without_area() {
        for output in ["x.stl", "x.step", "x.obj", "x.ply", "x.svg", "x.png", "x.pdf"] {
            let (said, written) = render("line.json", &net(kind, points.clone()), output, &[]);
            assert!(written.is_none(), "{what}, {output}");
            assert!(said.lines().count() == 1 && said.contains("the surface has no area"), "{what}: {said}");
        }
    }
}

#[test]
fn flat_closed_surfaces_are_no_models_but_can_be_drawn() {
    let flat = |points: Rows, normal: Point<3>| -> Rows {
        let lower = |[x, y, _]: Point<3>| [x, y, normal[0] * x + normal[1] * y + normal[2]];
        points.into_iter().map(|row| row.into_iter().map(lower).collect()).collect()
    };
    let torus: Rows = (0..8)
        .map(|k| {
            let ring = |l: i32| {
                let (psi, fi) = (f64::from(k) * TAU / 8.0, f64::from(l) * TAU / 5.0);
                let q = 120.0 + 40.0 * fi.sin();
                [q * psi.cos(), q * psi.sin(), 40.0 * fi.cos()]
            };
            (0..5).map(ring).collect()
        })
        .collect();
    for (kind, points) in [(NetKind::Zms, ball(0.0)), (NetKind::Zms, ball(1e4)), (NetKind::Zys, torus)] {
        for normal in [[0.0; 3], [0.3, -0.7, 5.0]] {
            let json = net(kind, flat(points.clone(), normal));
            for output in ["flat.stl", "flat.step", "flat.obj", "flat.ply"] {
                let (said, written) = render("flat.json", &json, output, &[]);
                assert!(written.is_none() && said.contains("the surface has no area"), "{output}: {said}");
            }
            assert!(render("flat.json", &json, "flat.svg", &[]).1.is_some());
        }
    }
    // An open one that is flat is a plate.
    let plate: Rows = (0..8).map(|k| (0..5).map(|l| [f64::from(k), f64::from(l), 0.0]).collect()).collect();
    assert!(render("plate.json", &net(NetKind::Fem, plate), "plate.stl", &[]).1.is_some());
}

#[test]
fn an_open_curve_stays_open_however_far_away_it_lies() {
    for far in ["0", "1e9", "1e12", "1e15"] {
        let x = |near: f64| far.parse::<f64>().unwrap() + near;
        let points = [[x(0.0), x(0.0)], [x(300.0), x(800.0)], [x(600.0), x(0.0)], [x(100.0), x(40.0)]];
        for (method, closed) in [("spline", false), ("bezier", false), ("bspline3", true), ("spline", true)] {
            let json = format!(
                r#"{{"format": "IP2", "points": {points:?}, "settings": {{"method": "{method}", "closed": {closed}}}}}"#
            );
            let (said, written) = render("open.json", &json, "open.svg", &[]);
            let svg = String::from_utf8(written.unwrap_or_else(|| panic!("{method}: {said}"))).unwrap();
            assert_eq!(svg.contains(" Z\""), closed, "{far} {method}: {svg}");
        }
    }
}

#[test]
fn axes_that_cannot_be_drawn_are_said() {
    for (far, lacking) in [(0.0, false), (1e9, true)] {
        let points: Vec<Point<2>> = [[0.0, 0.0], [3.0, 8.0], [6.0, 0.0]].map(|[x, y]| [far + x, y]).to_vec();
        let json = format!(r#"{{"format": "IP2", "points": {points:?}}}"#);
        for output in ["axes.svg", "axes.png", "axes.pdf"] {
            let (said, written) =
                render("axes.json", &json, output, &["--method", "spline", "--axes", "--width", "200"]);
            assert!(written.is_some(), "{said}");
            assert_eq!(said.contains("the picture has no axes"), lacking, "{said}");
            assert_eq!(said.lines().count(), usize::from(lacking), "{said}");
        }
        assert_eq!(render("axes.json", &json, "axes.svg", &["--method", "spline"]).0, "");
    }
}

#[test]
fn normals_and_sections_are_the_same_far_away() {
    let surface = |far: f64| Surface::new(Scheme::new(Method::Spline, Topology::Sphere), &ball(far)).unwrap();
    let (near, far) = (surface(0.0), surface(1e9));
    for (spans, uv) in [([0, 0], [0.3, 0.4]), ([3, 1], [0.5, 0.9]), ([7, 3], [0.2, 0.1])] {
        let [a, b] = [&near, &far].map(|it| it.normal(spans, uv).expect("a ball has normals"));
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-5), "{a:?} {b:?}");
    }
    let at = |surface: &Surface, far: f64| {
        let plane = Plane { normal: [1.0, 0.0, 0.0], offset: far + 0.3 };
        section(surface, plane, 6).unwrap()
    };
    let [a, b] = [at(&near, 0.0), at(&far, 1e9)];
    assert_eq!((a.len(), a[0].len()), (b.len(), b[0].len()));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn closed_meshes_are_closed_in_stl_wherever_they_lie(
        power in 3.0..9.0, direction in prop::array::uniform3(-1.0..1.0), size in [5..14_usize, 5..14_usize],
    ) {
        let place = |k: usize, l: usize| -> Point<3> {
            let (psi, fi) = (k as f64 / size[0] as f64 * TAU, l as f64 / size[1] as f64 * TAU);
            let q = 2.0 + fi.sin();
            let round = [q * psi.cos(), q * psi.sin(), fi.cos()];
            std::array::from_fn(|d| round[d] + direction[d] * 10_f64.powf(power))
        };
        // The last line repeats the first.
        let grid = Grid::from_fn(size.map(|n| n + 1), [true; 2], |k, l| place(k % size[0], l % size[1]));
        let mesh = Mesh::from_grid(&grid).unwrap();
        if let Ok(written) = mesh.to_stl() {
            let triangles = stl(&written.bytes);
            prop_assert_eq!(faults(&triangles), [0, 0]);
            prop_assert!(!triangles.is_empty() && triangles.len() <= mesh.triangles().len());
            prop_assert!(written.confused > 0 || triangles.len() == mesh.triangles().len());
        }
    }
}
