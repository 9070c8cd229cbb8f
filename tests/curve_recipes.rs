//! Bézier arcs, B-splines of any degree and splines with steps and ends of their own: on the command line, in JSON and
//! in the editors.

#![cfg(feature = "native")]

mod common;

use common::{Kept, SharedDisk, play_script, play_today, session, session_on};
use grafika::file::Document;
use grafika::geometry::{Point, norm};
use grafika::machine::{Machine, Manner, Memory, Script, Settings, play};
use grafika::programs::{gb_2d_ch, gb_2d_ip, gb_3d_ip};
use grafika::ui::Program;
use serde_json::{Value, json};
use std::path::PathBuf;
use std::process::Command;

fn folder() -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("curve_recipes");
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Exit status, standard output and standard error.
fn run(words: &str) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_grafika"))
        .current_dir(folder())
        .args(words.split_whitespace())
        .output()
        .expect("it starts");
    let [said, error] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    (output.status.code(), said, error)
}

fn done(words: &str) -> String {
    let (status, said, error) = run(words);
    assert_eq!(status, Some(0), "{words}: {error}");
    said
}

/// Writes a document of the plane with these settings.
fn write(name: &str, points: &[[f64; 2]], settings: Value) {
    let text = json!({ "format": "IP2", "points": points, "settings": settings }).to_string();
    std::fs::write(folder().join(name), text).unwrap();
}

fn rows(csv: &str) -> Vec<Vec<f64>> {
    csv.lines().skip(1).map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect()
}

const SEVEN: [[f64; 2]; 7] = [
    [100.0, 100.0],
    [140.0, 200.0],
    [180.0, 200.0],
    [220.0, 150.0],
    [300.0, 100.0],
    [340.0, 210.0],
    [400.0, 200.0],
];

#[test]
fn arcs_are_drawn_exactly() {
    write("arcs.json", &SEVEN, json!({ "method": "arcs", "smooth": [4] }));
    done("render arcs.json -o arcs.svg --joints");
    let svg = std::fs::read_to_string(folder().join("arcs.svg")).unwrap();
    assert!(svg.contains("M100 100 C140 200 180 200 220 150 C300 100 340 210 400 200"), "{svg}");
    assert_eq!(svg.matches("<circle").count(), 3);
    let sampled = rows(&done("sample arcs.json --per-span 2"));
    assert_eq!(sampled[1], [0.0, 0.5, 160.0, 181.25]);
    assert!(done("info arcs.json").contains("smooth: [4]"));
    // Back and forth without a loss; what a DOS file cannot hold is told.
    done("convert arcs.json again.json");
    assert_eq!(
        Document::from_json(&std::fs::read_to_string(folder().join("again.json")).unwrap()),
        Document::from_json(&std::fs::read_to_string(folder().join("arcs.json")).unwrap())
    );
    let (_, _, error) = run("convert arcs.json arcs.ip2");
    assert!(error.contains("method") || error.contains("smooth"), "{error}");
    for (count, part) in [
        (5, "5 points given: open Bézier arcs take 4, 7, 10, ... points; 2 more needed"),
        (6, "1 more needed"),
    ] {
        write("wrong.json", &SEVEN[..count], json!({ "method": "arcs" }));
        let (status, _, error) = run("sample wrong.json");
        assert!(status == Some(1) && error.contains(part), "{error}");
    }
    write("wrong.json", &SEVEN, json!({ "method": "arcs", "closed": true }));
    assert!(
        run("sample wrong.json").2.contains("closed Bézier arcs take 3, 6, 9, ... points; 2 more needed")
    );
    write("wrong.json", &SEVEN, json!({ "method": "arcs", "smooth": [8] }));
    assert!(run("info wrong.json").2.contains("there is no point 8 of 7"));
}

#[test]
fn b_splines_of_all_degrees_are_sampled() {
    for (degree, known) in [("2", "bspline2"), ("3", "bspline3")] {
        for closed in ["", "--closed"] {
            let ours = done(&format!("sample A.IP2 --method bspline --degree {degree} {closed}"));
            assert_eq!(ours, done(&format!("sample A.IP2 --method {known} {closed}")));
        }
    }
    write("seven.json", &SEVEN, json!({ "method": "bspline", "degree": 1, "knots": "chord" }));
    let polygon = rows(&done("sample seven.json --per-span 1"));
    assert!(polygon.iter().step_by(2).zip(SEVEN).all(|(row, [x, y])| (row[2] - x).hypot(row[3] - y) < 1e-9));
    // Given knots: a Bézier curve of degree 5 of six points.
    write("six.json", &SEVEN[..6], json!({}));
    let bezier = rows(&done("sample six.json --method bezier"));
    let knots = rows(&done("sample six.json --method bspline --degree 5 --knots 0,0,0,0,0,0,1,1,1,1,1,1"));
    assert_eq!(bezier.len(), knots.len());
    for (a, b) in bezier.iter().zip(&knots) {
        assert!((a[2] - b[2]).abs() + (a[3] - b[3]).abs() < 1e-10);
    }
    for (words, status, part) in [
        (
            "sample six.json --method bspline --degree 4 --knots 0,1,2",
            1,
            "6 control points need exactly 11 knots",
        ),
        ("sample six.json --method bspline --degree 6", 2, "--degree"),
        ("sample six.json --method bspline --knots round", 2, "give chord, uniform or centripetal"),
        (
            "sample six.json --method spline --degree 4",
            2,
            "--degree is for bspline; spline has no such thing",
        ),
        ("sample six.json --method spline --knots 0,1", 2, "spline takes a rule for its knots"),
        ("sample six.json --method bspline --start 1,2", 2, "--start is for phspline, spline; bspline"),
        ("render A.FBS --method bspline -o a.svg", 2, "bspline is for curves"),
    ] {
        let (found, _, error) = run(words);
        assert!(found == Some(status) && error.contains(part), "{words}: {error}");
    }
}

#[test]
fn splines_have_steps_and_ends() {
    write("seven.json", &SEVEN, json!({ "method": "spline" }));
    let natural = done("sample seven.json --derivatives 2 --per-span 1");
    assert_eq!(natural, done("sample seven.json --knots uniform --derivatives 2 --per-span 1"));
    let chord = rows(&done("sample seven.json --knots chord --per-span 1 --derivatives 2"));
    for (row, point) in chord.iter().step_by(2).zip(SEVEN) {
        assert!((row[2] - point[0]).hypot(row[3] - point[1]) < 1e-9);
    }
    // Without curvature at the ends.
    assert!(chord[0][6].abs() + chord[0][7].abs() < 1e-9);
    let clamped = rows(&done("sample seven.json --start 0,300 --end=-50,10 --per-span 1 --derivatives 1"));
    let last = clamped.last().unwrap();
    assert!((clamped[0][4].abs() + (clamped[0][5] - 300.0).abs()) < 1e-9);
    assert!((last[4] + 50.0).abs() + (last[5] - 10.0).abs() < 1e-9);
    write("ends.json", &SEVEN, json!({ "method": "spline", "start": [0, 300], "end": [-50, 10] }));
    assert_eq!(rows(&done("sample ends.json --per-span 1 --derivatives 1")), clamped);
    let (status, _, error) = run("sample seven.json --closed --start 1,2");
    assert!(status == Some(2) && error.contains("--start is for open curves"), "{error}");
    let (status, _, error) = run("sample seven.json --start 1,2,3");
    assert!(status == Some(2) && error.contains("has 3 coordinates; the points have 2"), "{error}");
    assert_eq!(done("sample A.IP3 --method spline --start 1,2,3 --per-span 1").lines().count(), 15);
    write("wrong.json", &SEVEN, json!({ "start": [1, 2, 3] }));
    assert!(run("info wrong.json").2.contains("start: 3 coordinates; there must be 2"));
}

/// Clicks on the field that make these points.
fn clicks(points: &[[f64; 2]]) -> String {
    let click = |[x, y]: &[f64; 2]| format!("click {} {}\n", 41.0 + x, 450.0 - y);
    std::iter::once("key U\n".to_owned()).chain(points.iter().map(click)).collect()
}

fn today(script: &str) -> Kept {
    play_today(gb_2d_ip::PROGRAM, &format!("{script}dump end.json\n"))
}

fn points(model: &Value) -> Vec<Point<2>> {
    serde_json::from_value(model["points"].clone()).unwrap()
}

fn sine(points: &[Point<2>], [before, joint, after]: [usize; 3]) -> f64 {
    let [a, b] =
        [before, after].map(|at| [points[at][0] - points[joint][0], points[at][1] - points[joint][1]]);
    (a[0] * b[1] - a[1] * b[0]) / (norm(a) * norm(b))
}

#[test]
fn the_editor_draws_arcs_with_handles() {
    let start = format!("{}type gn5", clicks(&SEVEN));
    let plain = today(&format!("{start}\n"));
    let model = &plain.models["end.json"];
    assert_eq!((&model["method"], &model["visible"]), (&json!("arcs"), &json!(true)));
    assert_eq!(points(model), SEVEN);
    // The joint in the middle becomes smooth, and a corner again.
    let smooth = today(&format!("{start}\nmove 265 305\nkey S\n"));
    let model = &smooth.models["end.json"];
    assert_eq!(model["smooth"], json!([4]));
    assert!(sine(&points(model), [2, 3, 4]).abs() < 1e-9);
    assert_eq!(today(&format!("{start}\nkey S\nkey S\n")).models["end.json"]["smooth"], Value::Null);
    let undone = today(&format!("{start}\nkey S\nkey Ctrl+Z\n"));
    assert_eq!(points(&undone.models["end.json"]), SEVEN);
    // Dragging the joint carries its handles; dragging a handle turns the other.
    let dragged = today(&format!("{start}\ndrag 261 300 281 290\n"));
    let moved = points(&dragged.models["end.json"]);
    assert_eq!([moved[2], moved[3], moved[4]], [[200.0, 210.0], [240.0, 160.0], [320.0, 110.0]]);
    let turned = today(&format!("{start}\nkey S\ndrag 221 250 231 230\n"));
    let turned = points(&turned.models["end.json"]);
    assert!(sine(&turned, [2, 3, 4]).abs() < 1e-6, "{turned:?}");
    // The joint goes with its handles; a click on the curve divides an arc.
    let deleted = today(&format!("{start}\nmove 261 300\nkey Delete\n"));
    assert_eq!(points(&deleted.models["end.json"]), [SEVEN[0], SEVEN[1], SEVEN[5], SEVEN[6]]);
    let divided = today(&format!("{start}\nclick 201 269\n"));
    assert_eq!(points(&divided.models["end.json"]).len(), 10);
    assert_eq!(divided.models["end.json"]["smooth"], json!([4]));
    // A point more is no arc yet, and the curve is there again with two others.
    let more = today(&format!("{start}\nclick 541 100\n"));
    assert_eq!(more.models["end.json"]["visible"], json!(false));
    let whole = today(&format!("{start}\nclick 541 100\nclick 541 200\nclick 541 300\n"));
    assert_eq!(whole.models["end.json"]["visible"], json!(true));
}

#[test]
fn handles_between_whole_numbers_are_saved() {
    let saved = |keys: &str| {
        let disk = SharedDisk::default();
        let script = format!(
            "lang en\nmanner today\n{}type gn5\n{keys}key Ctrl+S\ntype ARCS\nkey Enter\nwait 10\nkey Enter\nwait 10\n",
            clicks(&SEVEN)
        );
        let script = Script::parse(&script).unwrap();
        let mut session = session(gb_2d_ip::PROGRAM, disk.clone(), script.begun_with(Settings::default()));
        play(&mut session, &script, &mut Kept::default()).unwrap();
        disk.names()
    };
    // Whole numbers go into a file of 1997, with the method beside it.
    assert_eq!(saved(""), ["ARCS.IP2", "ARCS.JSON"]);
    assert_eq!(saved("move 261 300\nkey S\n"), ["ARCS.JSON"]);
}

#[test]
fn a_wrong_number_of_points_keeps_the_method() {
    let kept = today(&format!("{}type gn5", clicks(&SEVEN[..5])).replace("gn5", "gn5\nkey Esc\n"));
    assert_eq!(kept.models["end.json"]["method"], json!("spline"));
    // The original has four methods, and no key S.
    let kept = play_script(
        gb_2d_ip::PROGRAM,
        Memory::default(),
        "key U\ndrag 618 90 161 150\ndrag 618 90 261 110\ndrag 618 90 361 330\ndrag 618 90 461 390\n\
         type gn5\nkey Esc\nkey S\ndump end.json\n",
    );
    assert_eq!(kept.models["end.json"]["method"], Value::Null);
}

#[test]
fn the_editor_asks_for_any_degree() {
    for (keys, method, degree) in [
        ("44", "bspline", json!(4)),
        ("45", "bspline", json!(5)),
        ("41", "bspline", json!(1)),
        ("42", "bspline2", Value::Null),
        ("43", "bspline3", Value::Null),
        ("44gz2", "bezier", Value::Null),
    ] {
        let kept = today(&format!("{}type gn{keys}\n", clicks(&SEVEN)));
        let model = &kept.models["end.json"];
        assert_eq!(
            (&model["method"], &model["degree"], &model["visible"]),
            (&json!(method), &degree, &json!(true))
        );
    }
    let left = today(&format!("{}type gn44\ntype gn4\nkey Esc\n", clicks(&SEVEN)));
    assert_eq!(left.models["end.json"]["degree"], json!(4));
    let undone = today(&format!("{}type gn44\nkey Ctrl+Z\n", clicks(&SEVEN)));
    assert_eq!(undone.models["end.json"]["degree"], Value::Null);
}

/// Plays a script in the manner of today with a document opened.
fn opened(program: Program, document: &Value, script: &str) -> Value {
    let document = Document::from_json(&document.to_string()).unwrap();
    let settings = Settings { manner: Manner::Today, ..Settings::default() };
    let mut session =
        session_on(program, Machine::new(Box::new(Memory::default()), settings), Some(document));
    let mut kept = Kept::default();
    play(&mut session, &Script::parse(&format!("{script}dump end.json\n")).unwrap(), &mut kept).unwrap();
    kept.models["end.json"].clone()
}

#[test]
fn arcs_in_space_are_smooth_too() {
    let corner = json!([
        [0, 0, 0],
        [50, 80, 0],
        [120, 60, 40],
        [150, 0, 60],
        [200, 20, 0],
        [260, 60, 10],
        [300, 0, 0]
    ]);
    let document = json!({ "format": "IP3", "points": corner, "settings": { "method": "arcs" } });
    let model = opened(gb_3d_ip::PROGRAM, &document, "key S\n");
    assert_eq!(
        (&model["method"], &model["smooth"], &model["visible"]),
        (&json!("arcs"), &json!([4]), &json!(true))
    );
    let places: Vec<Point<3>> = serde_json::from_value(model["points"].clone()).unwrap();
    let leg = |at: usize| -> Point<3> { std::array::from_fn(|d| places[at][d] - places[3][d]) };
    let (a, b) = (leg(2), leg(4));
    assert!(norm(grafika::geometry::cross(a, b)) < 1e-6 * norm(a) * norm(b));
}

#[test]
fn a_recipe_stays_with_its_document() {
    let document = json!({
        "format": "IP2",
        "points": SEVEN,
        "settings": { "method": "bspline", "degree": 4, "knots": "chord" },
    });
    let model = opened(gb_2d_ip::PROGRAM, &document, "drag 261 300 281 290\n");
    assert_eq!((&model["degree"], &model["visible"]), (&json!(4), &json!(true)));
}

#[test]
fn one_arc_with_two_tangents_is_a_curve() {
    let script = format!("{}type in.5\nkey Enter\ndump end.json\n", clicks(&SEVEN[..2]));
    let kept = play_today(gb_2d_ch::PROGRAM, &script);
    let model = &kept.models["end.json"];
    assert_eq!((&model["visible"], &model["tangents"]), (&json!(true), &json!([[20.0, 50.0], [20.0, 50.0]])));
    // Closed curves and the original want three.
    let script = format!("{}type n\ntype gz\nkey Esc\ndump end.json\n", clicks(&SEVEN[..2]));
    let model = &play_today(gb_2d_ch::PROGRAM, &script).models["end.json"];
    assert_eq!(model["points"].as_array().unwrap().len(), 2);
    let script = "key U\ndrag 618 90 141 350\ndrag 618 90 291 150\ntype gn\nkey Esc\ndump end.json\n";
    let kept = play_script(gb_2d_ch::PROGRAM, Memory::default(), script);
    assert_eq!(kept.models["end.json"]["visible"], json!(false));
}

#[test]
fn the_workshop_tells_value_and_slope_of_a_point() {
    let document = std::fs::read(common::path("../data/Y.IP2")).unwrap();
    let document = Document::read(grafika::file::Format::Ip2, &document).unwrap();
    let text = document.to_json().unwrap();
    let settings = |manner| Settings { manner, ..Settings::default() };
    let picture = |manner, script: &str| {
        let document = Document::from_json(&text).unwrap();
        let machine = Machine::new(Box::new(Memory::default()), settings(manner));
        let mut session = session_on(gb_2d_ip::PROGRAM, machine, Some(document));
        let mut kept = Kept::default();
        play(&mut session, &Script::parse(script).unwrap(), &mut kept).unwrap();
        kept.png("end.png")
    };
    // The first smoothed point is the first measured one, at (0, 26).
    let (off, on) =
        ("key F5\nmove 300 20\nshot end.png\n", "key F5\nmove 300 20\nmove 41 424\nshot end.png\n");
    let away = "pointer off\n";
    let with = |script: &str| format!("{away}{script}");
    assert_ne!(picture(Manner::Today, &with(on)), picture(Manner::Today, &with(off)));
    assert_eq!(picture(Manner::Original, &with(on)), picture(Manner::Original, &with(off)));
}
