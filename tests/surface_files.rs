//! Surfaces as other programs read them: meshes, STEP, tables, pictures, by the library and by `grafika`.

#![cfg(feature = "native")]

mod common;

use common::pictures;
use grafika::figure::{FigureError, Mesh, surface_step, visible_lines};
use grafika::file::{Document, Net, NetKind};
use grafika::geometry::{
    BSplineSurface, Border, Method, ParamSurface, Point, Scheme, Surface, Topology, View,
};
use proptest::prelude::*;
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

type Rows = Vec<Vec<Point<3>>>;

fn rows(shape: [usize; 2], point: impl Fn(f64, f64) -> Point<3>) -> Rows {
    (0..shape[0]).map(|k| (0..shape[1]).map(|l| point(k as f64, l as f64)).collect()).collect()
}

/// The net that a kind's program starts with (of radii 120, and 120 and 40).
fn default_net(kind: NetKind) -> Rows {
    match kind {
        NetKind::Fhc => {
            let corner = |k: f64| if k < 2.0 { (k - 0.5) * 300.0 } else { 0.0 };
            rows([4, 4], |k, l| if k < 2.0 && l < 2.0 { [corner(k), corner(l), 0.0] } else { [0.0; 3] })
        }
        NetKind::Fps | NetKind::Fbs => rows([5, 5], |k, l| [(k - 2.0) * 80.0, (l - 2.0) * 80.0, 0.0]),
        NetKind::Pn => rows([4, 4], |k, l| [k - 1.5, l - 1.5, 0.1 * ((k - 1.5).powi(2) + (l - 1.5).powi(2))]),
        NetKind::Fem => rows([8, 5], |k, l| [(k - 3.5) * 70.0, (l - 2.0) * 70.0, 0.0]),
        NetKind::Fpb => rows([4, 4], |k, l| [(k - 1.5) * 120.0, (l - 1.5) * 120.0, 0.0]),
        NetKind::Zms | NetKind::Zmb => rows([8, 5], |k, l| {
            let (psi, fi) = (k * TAU / 8.0, l * PI / 4.0);
            // Poles are the same point in every row.
            let ring = if l == 0.0 || l == 4.0 { 0.0 } else { 120.0 * fi.sin() };
            [ring * psi.cos(), ring * psi.sin(), 120.0 * fi.cos()]
        }),
        NetKind::Zys | NetKind::Zyb | NetKind::Zyp => rows([8, 5], |k, l| {
            let (psi, fi) = (k * TAU / 8.0, l * TAU / 5.0 + FRAC_PI_2);
            let q = 120.0 + 40.0 * fi.sin();
            [q * psi.cos(), q * psi.sin(), 40.0 * fi.cos()]
        }),
    }
}

/// Hills on the open net, as the reference pictures have them.
fn hills() -> Rows {
    let mut net = default_net(NetKind::Fps);
    (net[2][2], net[1][3], net[3][1]) = ([0.0, 0.0, 100.0], [-80.0, 80.0, -60.0], [100.0, -60.0, 50.0]);
    net
}

const METHODS: [Method; 6] = [
    Method::Spline,
    Method::Local { k0: 0.5 },
    Method::BSpline2,
    Method::BSpline3,
    Method::Beta { bias: 1.0, tension: 0.0 },
    Method::Beta { bias: 2.0, tension: 10.0 },
];

fn closed_surfaces() -> Vec<(Surface, i64)> {
    let kinds = [(NetKind::Zms, Topology::Sphere, 2), (NetKind::Zys, Topology::Torus, 0)];
    let mut surfaces = Vec::new();
    for (kind, topology, characteristic) in kinds {
        for method in METHODS {
            let scheme = Scheme { border: Border::Reached, ..Scheme::new(method, topology) };
            let mut net = default_net(kind);
            surfaces.push((Surface::new(scheme, &net).unwrap(), characteristic));
            // The same run round the other way.
            net.reverse();
            surfaces.push((Surface::new(scheme, &net).unwrap(), characteristic));
        }
    }
    surfaces
}

fn mesh(surface: &Surface, per_cell: usize) -> Mesh {
    Mesh::from_grid(&surface.grid(per_cell).unwrap()).unwrap()
}

#[test]
fn spheres_and_tori_are_watertight_and_look_outwards() {
    for (surface, characteristic) in closed_surfaces() {
        for per_cell in [1, 2, 5] {
            let mesh = mesh(&surface, per_cell);
            let found = mesh.closed_characteristic();
            assert_eq!(found, Some(characteristic), "{:?}, {per_cell} steps", surface.topology());
            assert!(mesh.volume() > 0.0);
        }
        let [coarse, fine] = [6, 12].map(|steps| mesh(&surface, steps).volume());
        assert!((coarse / fine - 1.0).abs() < 0.01, "{coarse} {fine}");
    }
}

#[test]
fn the_books_cubic_b_spline_has_holes_at_the_poles() {
    let net = default_net(NetKind::Zmb);
    let surface = Surface::new(Scheme::new(Method::BSpline3, Topology::Sphere), &net).unwrap();
    assert_eq!(mesh(&surface, 5).closed_characteristic(), None);
    let step = surface_step(&surface, "tube").unwrap();
    assert!(step.contains("OPEN_SHELL") && !step.contains("MANIFOLD_SOLID_BREP"));
}

#[test]
fn open_surfaces_keep_their_borders() {
    let surface = Surface::new(Scheme::new(Method::Spline, Topology::Open), &hills()).unwrap();
    let mesh = mesh(&surface, 3);
    assert_eq!((mesh.vertices().len(), mesh.triangles().len()), (13 * 13, 2 * 12 * 12));
    assert_eq!(mesh.closed_characteristic(), None);
}

#[test]
fn meshes_read_back() {
    let surface = Surface::new(Scheme::new(Method::Spline, Topology::Sphere), &default_net(NetKind::Zms));
    let mesh = mesh(&surface.unwrap(), 4);
    let corners: Vec<Point<3>> =
        mesh.triangles().iter().flatten().map(|&number| mesh.vertices()[number]).collect();
    // OBJ and PLY give every double back.
    assert_eq!(obj_corners(&mesh.to_obj()), corners);
    assert_eq!(ply_corners(&mesh.to_ply().unwrap()), corners);
    let stl = stl_corners(&mesh.to_stl().unwrap().bytes);
    assert_eq!(stl, corners.iter().map(|point| point.map(|x| f64::from(x as f32))).collect::<Vec<_>>());
}

fn obj_corners(text: &str) -> Vec<Point<3>> {
    let mut vertices = Vec::new();
    let mut corners = Vec::new();
    for line in text.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        match words[..] {
            ["v", x, y, z] => vertices.push([x, y, z].map(|word| word.parse().unwrap())),
            ["f", a, b, c] => {
                corners.extend([a, b, c].map(|word| vertices[word.parse::<usize>().unwrap() - 1]));
            }
            _ => panic!("{line}"),
        }
    }
    corners
}

fn ply_corners(bytes: &[u8]) -> Vec<Point<3>> {
    let end = bytes.windows(11).position(|text| text == b"end_header\n").unwrap() + 11;
    let header = std::str::from_utf8(&bytes[..end]).unwrap();
    let count = |element: &str| -> usize {
        header.lines().find_map(|line| line.strip_prefix(element)).unwrap().trim().parse().unwrap()
    };
    let (vertices, faces) = bytes[end..].split_at(24 * count("element vertex"));
    assert_eq!(faces.len(), 13 * count("element face"));
    let double = |bytes: &[u8]| f64::from_le_bytes(bytes.try_into().unwrap());
    let point = |n: usize| -> Point<3> {
        std::array::from_fn(|d| double(&vertices[24 * n + 8 * d..24 * n + 8 * d + 8]))
    };
    let face = |face: &[u8]| -> [Point<3>; 3] {
        assert_eq!(face[0], 3);
        std::array::from_fn(|c| {
            point(i32::from_le_bytes(face[1 + 4 * c..5 + 4 * c].try_into().unwrap()) as usize)
        })
    };
    faces.chunks(13).flat_map(face).collect()
}

fn stl_corners(bytes: &[u8]) -> Vec<Point<3>> {
    let single = |bytes: &[u8]| f64::from(f32::from_le_bytes(bytes.try_into().unwrap()));
    let count = u32::from_le_bytes(bytes[80..84].try_into().unwrap()) as usize;
    assert_eq!(bytes.len(), 84 + 50 * count);
    let corner = |triangle: &[u8], c: usize| -> Point<3> {
        std::array::from_fn(|d| single(&triangle[12 + 12 * c + 4 * d..16 + 12 * c + 4 * d]))
    };
    bytes[84..].chunks(50).flat_map(|triangle| (0..3).map(move |c| corner(triangle, c))).collect()
}

/// Whether triangles, of which only the corners are known, leave no edge open.
fn is_watertight(corners: &[Point<3>]) -> bool {
    let key = |point: &Point<3>| point.map(|x| (x + 0.0).to_bits());
    let mut edges = HashMap::new();
    for triangle in corners.chunks(3) {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let (a, b) = (key(&triangle[a]), key(&triangle[b]));
            *edges.entry((a.min(b), a.max(b))).or_insert(0) += if a < b { 1 } else { -1 };
        }
    }
    edges.values().all(|&balance| balance == 0)
}

/// The entities of a STEP file by their numbers; all references lead to one.
fn entities(text: &str) -> HashMap<usize, String> {
    assert!(text.starts_with("ISO-10303-21;\nHEADER;\n") && text.ends_with("ENDSEC;\nEND-ISO-10303-21;\n"));
    let data = text.split("\nDATA;\n").nth(1).unwrap().split("ENDSEC;").next().unwrap();
    let mut entities = HashMap::new();
    for line in data.lines() {
        let (number, entity) = line.strip_prefix('#').and_then(|line| line.split_once('=')).expect(line);
        let entity = entity.strip_suffix(';').expect(line).to_string();
        for reference in entity.split('#').skip(1) {
            let digits: String = reference.chars().take_while(char::is_ascii_digit).collect();
            assert!(entities.contains_key(&digits.parse::<usize>().unwrap()), "{line}");
        }
        assert!(entities.insert(number.parse().unwrap(), entity).is_none(), "{line}");
    }
    entities
}

/// The surface in a STEP file.
fn step_surface(text: &str) -> BSplineSurface {
    let entities = entities(text);
    let arguments = |entity: &str| {
        entities.values().find_map(|found| Some(found.strip_prefix(entity)?.to_string())).unwrap()
    };
    let numbers = |list: &str| -> Vec<f64> {
        list.split(',').filter(|word| !word.is_empty()).map(|word| word.parse().unwrap()).collect()
    };
    let point = |number: &str| -> Point<3> {
        let entity = &entities[&number.parse::<usize>().unwrap()];
        let list = entity.strip_prefix("CARTESIAN_POINT('',(").unwrap().trim_end_matches(')');
        numbers(list).try_into().unwrap()
    };
    let surface = arguments("B_SPLINE_SURFACE_WITH_KNOTS('',");
    let (degrees, rest) = surface.split_once(",((").unwrap();
    let (net, rest) = rest.split_once(")),").unwrap();
    let lists: Vec<Vec<f64>> =
        rest.split('(').skip(1).map(|list| numbers(list.split(')').next().unwrap())).collect();
    let [mu, mv, ku, kv] = lists.try_into().unwrap();
    let degrees: Vec<usize> = numbers(degrees).into_iter().map(|degree| degree as usize).collect();
    let counts = |list: Vec<f64>| list.into_iter().map(|count| count as usize).collect();
    BSplineSurface {
        degrees: degrees.try_into().unwrap(),
        knots: [ku, kv],
        multiplicities: [counts(mu), counts(mv)],
        net: net
            .split("),(")
            .map(|row| row.split(',').map(|name| point(name.trim_start_matches('#'))).collect())
            .collect(),
        weights: None,
    }
}

#[test]
fn step_holds_the_surface_itself() {
    let mut surfaces: Vec<Surface> = closed_surfaces().into_iter().map(|(surface, _)| surface).collect();
    for method in METHODS.into_iter().chain([Method::Bezier]) {
        surfaces.push(Surface::new(Scheme::new(method, Topology::Open), &hills()).unwrap());
    }
    for surface in surfaces {
        let text = surface_step(&surface, "A'b").unwrap();
        assert!(text.contains("PRODUCT('A''b'"));
        assert_eq!(text.contains("MANIFOLD_SOLID_BREP"), surface.topology() != Topology::Open);
        let read = step_surface(&text);
        assert_eq!(Some(&read), surface.to_bspline().as_ref());
        for sample in surface.sample(3).unwrap() {
            let at = |d: usize| {
                let (span, knots) = (sample.spans[d], &read.knots[d]);
                knots[span] + sample.parameters[d] * (knots[span + 1] - knots[span])
            };
            let point = read.eval(at(0), at(1)).unwrap();
            assert!(point.iter().zip(sample.point).all(|(a, b)| (a - b).abs() < 1e-10), "{sample:?}");
        }
    }
}

#[test]
fn step_has_one_edge_a_border_one_a_seam_none_a_pole() {
    let edges = |surface: &Surface| surface_step(surface, "").unwrap().matches("=EDGE_CURVE").count();
    let woven = |topology, net: &Rows| Surface::new(Scheme::new(Method::Spline, topology), net).unwrap();
    assert_eq!(edges(&woven(Topology::Open, &hills())), 4);
    assert_eq!(edges(&woven(Topology::Sphere, &default_net(NetKind::Zms))), 1);
    assert_eq!(edges(&woven(Topology::Torus, &default_net(NetKind::Zys))), 2);
    let mut collapsed = hills();
    collapsed[0].fill([-160.0, 0.0, 0.0]);
    assert_eq!(edges(&woven(Topology::Open, &collapsed)), 3);
    let many = vec![vec![[0.0, 1.0, 2.0]; 2]; 27];
    let long = Surface::new(Scheme::new(Method::Bezier, Topology::Open), &many).unwrap();
    assert_eq!(surface_step(&long, ""), Err(FigureError::Degree { given: 26, most: 25 }));
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![3 => -100.0..100.0, 1 => Just(0.0), 1 => -1e149..1e149, 1 => -1e-200..1e-200]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn any_surface_is_written_or_refused(
        net in prop::collection::vec(prop::collection::vec(prop::array::uniform3(coordinate()), 4), 4),
        method in prop::sample::select(METHODS.to_vec()),
        topology in prop::sample::select(vec![Topology::Open, Topology::Sphere, Topology::Torus]),
        direction in prop::array::uniform3(-1.0..1.0),
    ) {
        let Ok(surface) = Surface::new(Scheme::new(method, topology), &net) else { return Ok(()) };
        let Ok(grid) = surface.grid(3) else { return Ok(()) };
        let finite = |points: &[Point<2>]| points.iter().flatten().all(|x| x.is_finite());
        let lines = visible_lines(std::slice::from_ref(&grid), &View::from_direction(direction));
        prop_assert!(lines.iter().all(|line| line.len() > 1 && finite(line)));
        if let Ok(mesh) = Mesh::from_grid(&grid) {
            prop_assert_eq!(obj_corners(&mesh.to_obj()).len(), 3 * mesh.triangles().len());
            prop_assert!(mesh.to_ply().is_ok());
            prop_assert!(!mesh.volume().is_nan());
            let _ = mesh.to_stl();
        }
        if let Ok(step) = surface_step(&surface, "any") {
            prop_assert_eq!(Some(step_surface(&step)), surface.to_bspline());
        }
    }
}

/// A net as a JSON file among the files of tests.
fn net_file(name: &str, kind: NetKind, points: Rows) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, Document::Net(Net::new(kind, points)).to_json().unwrap()).unwrap();
    path
}

fn grafika(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_grafika"));
    command.args(arguments).current_dir(env!("CARGO_TARGET_TMPDIR")).output().unwrap()
}

fn done(arguments: &[&str]) -> Vec<u8> {
    let output = grafika(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

fn rendered(file: &Path, output: &str, arguments: &[&str]) -> Vec<u8> {
    let file = file.display().to_string();
    done(&[&["render", file.as_str(), "-o", output], arguments].concat());
    std::fs::read(Path::new(env!("CARGO_TARGET_TMPDIR")).join(output)).unwrap()
}

#[test]
fn every_kind_has_its_method() {
    for kind in NetKind::ALL {
        let name = format!("{kind:?}.json");
        let file = net_file(&name, kind, default_net(kind)).display().to_string();
        let table = String::from_utf8(done(&["sample", &file, "--per-span", "2"])).unwrap();
        let method = match kind {
            NetKind::Fhc => "hermite",
            NetKind::Fps | NetKind::Fem | NetKind::Zms | NetKind::Zys => "spline",
            NetKind::Fpb => "bezier",
            NetKind::Fbs | NetKind::Zmb | NetKind::Zyb => "bspline3",
            NetKind::Zyp => "beta",
            NetKind::Pn => "pn",
        };
        let named = done(&["sample", &file, "--per-span", "2", "--method", method]);
        assert_eq!(table.as_bytes(), named, "{kind:?}");
    }
}

#[test]
fn samples_are_those_of_the_library() {
    let net = hills();
    let file = net_file("hills.json", NetKind::Fps, net.clone()).display().to_string();
    let beta = ["--method", "beta", "--bias", "2", "--tension", "1", "--tension-v", "7", "--bias-u", "0.5"];
    let table = String::from_utf8(done(&[&["sample", &file], &beta[..]].concat())).unwrap();
    let [u, v] = [(0.5, 1.0), (2.0, 7.0)].map(|(bias, tension)| Method::Beta { bias, tension });
    let scheme = Scheme { u, v, topology: Topology::Open, border: Border::Doubled };
    let samples = Surface::new(scheme, &net).unwrap().sample(10).unwrap();
    assert!(table.starts_with("i,j,u,v,x,y,z\n"));
    assert_eq!(table.lines().count(), samples.len() + 1);
    for (line, sample) in table.lines().skip(1).zip(&samples) {
        let numbers: Vec<f64> = line.split(',').map(|number| number.parse().unwrap()).collect();
        let [i, j] = sample.spans.map(|span| span as f64);
        let ([u, v], [x, y, z]) = (sample.parameters, sample.point);
        assert_eq!(numbers, [i, j, u, v, x, y, z]);
    }
    done(&["sample", &file, "--method", "local", "--k0", "0.2", "--per-span", "1", "-o", "hills.out.json"]);
    let text =
        std::fs::read_to_string(Path::new(env!("CARGO_TARGET_TMPDIR")).join("hills.out.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json.as_array().unwrap().len(), 4 * 16);
    assert_eq!(json[0]["z"].as_f64(), Some(0.0));
}

#[test]
fn settings_of_the_file_count_where_the_command_line_is_silent() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("set.json");
    let points = serde_json::to_string(&hills()).unwrap();
    let settings = r#"{"method": "beta", "bias": [1.5, 2.0], "tension": [3.0, 4.0]}"#;
    std::fs::write(&path, format!(r#"{{"format": "FBS", "points": {points}, "settings": {settings}}}"#))
        .unwrap();
    let file = path.display().to_string();
    let silent = done(&["sample", &file]);
    let words = "--method beta --bias-u 1.5 --bias-v 2 --tension-u 3 --tension-v 4";
    let said = done(&[&["sample", file.as_str()], &words.split(' ').collect::<Vec<_>>()[..]].concat());
    assert_eq!(silent, said);
    assert_ne!(silent, done(&["sample", &file, "--bias", "1.5"]));
    assert_ne!(silent, done(&["sample", &file, "--method", "bspline3"]));
}

#[test]
fn surfaces_are_drawn_without_hidden_lines() {
    let open = net_file("open.json", NetKind::Fps, hills());
    let look = ["--points", "--polygon", "--title", "F_P_SPLN", "--width", "400"];
    pictures::assert_golden_png("figure_surface_open", &rendered(&open, "open.png", &look));
    let torus = net_file("torus.json", NetKind::Zys, default_net(NetKind::Zys));
    let look = ["--width", "400", "--view", "0.3,-0.7,0.4", "--per-span", "6"];
    pictures::assert_golden_png("figure_surface_torus", &rendered(&torus, "torus.png", &look));
    let svg = String::from_utf8(rendered(&torus, "torus.svg", &look)).unwrap();
    assert!(svg.contains("<path") && !svg.contains("NaN"));
}

#[test]
fn models_are_chosen_by_the_extension() {
    let ball = net_file("ball.json", NetKind::Zmb, default_net(NetKind::Zmb));
    assert!(is_watertight(&stl_corners(&rendered(&ball, "ball.stl", &["--per-span", "4"]))));
    assert!(is_watertight(&ply_corners(&rendered(&ball, "ball.ply", &["--method", "bspline2"]))));
    let obj = String::from_utf8(rendered(&ball, "ball.obj", &["--method", "local"])).unwrap();
    assert!(is_watertight(&obj_corners(&obj)));
    let step = String::from_utf8(rendered(&ball, "ball.step", &["--title", "Golyó"])).unwrap();
    assert!(step.contains(r"PRODUCT('Goly\X4\000000F3\X0\'") && step.contains("MANIFOLD_SOLID_BREP"));
    assert!(step_surface(&step).net.len() > 8);
}

#[test]
fn wrong_combinations_are_refused_in_a_line() {
    let file = |name: &str, kind| net_file(name, kind, default_net(kind)).display().to_string();
    let (open, ball) = (file("wrong_open.json", NetKind::Fps), file("wrong_ball.json", NetKind::Zms));
    let (torus, matrix) = (file("wrong_torus.json", NetKind::Zyb), file("wrong_matrix.json", NetKind::Fhc));
    let mut crooked = default_net(NetKind::Fhc);
    crooked.pop();
    let crooked = net_file("wrong_crooked.json", NetKind::Fhc, crooked).display().to_string();
    let curve = common::path("files/SIX.IP2").display().to_string();
    let cases: [(&str, &str, i32, &str); 17] = [
        (&open, "-o a.step --method hermite", 2, "needs tangents and twists"),
        (&open, "-o a.step --method coons", 2, "called local"),
        (&open, "-o a.step --method fourier", 2, "for curves"),
        (&open, "-o a.step --closed", 2, "extension says, here .FPS"),
        (&open, "-o a.step --extended", 2, "--method bspline3"),
        (&torus, "-o a.step --extended", 2, "--method bspline3"),
        (&open, "-o a.stl --points", 2, "--points is for pictures"),
        (&open, "-o a.gif", 2, ".obj .stl .ply .step"),
        (&open, "-o a.png --view 0,0,0", 2, "three numbers"),
        (&open, "-o a.png --per-span 0", 2, "1 to 100000"),
        (&open, "-o a.png --per-span 100000", 1, "steps per span"),
        (&open, "-o a.png --method beta --bias-v -1", 1, "bias is -1"),
        (&ball, "-o a.png --method bezier", 1, "topology of a sphere"),
        (&matrix, "-o a.png --method spline", 2, "no other method than hermite"),
        (&crooked, "-o a.png", 1, "4 rows of 4"),
        (&curve, "-o a.stl --method spline", 2, "models are of surfaces"),
        (&curve, "-o a.png --method spline --k0-u 1", 2, "--k0-u is for surfaces"),
    ];
    for (file, arguments, status, said) in cases {
        let arguments: Vec<&str> = ["render", file].into_iter().chain(arguments.split(' ')).collect();
        let output = grafika(&arguments);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(
            (output.status.code(), message.lines().count()),
            (Some(status), 1),
            "{arguments:?}: {message}"
        );
        assert!(message.contains(said), "{arguments:?}: {message}");
    }
}
