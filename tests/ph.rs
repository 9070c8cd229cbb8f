//! PH curves on the command line: `sample --quantities`, `measure`, `offset`, `render` and `poly`.

#![cfg(feature = "native")]

mod common;

use common::folder::Folder;
use grafika::file::{Document, FileKind};
use serde_json::Value;
use std::fs;

const CAM: &str = r#"{"format": "IP2", "settings": {"method": "phspline", "closed": true},
    "points": [[430,190],[395,290],[290,330],[190,300],[150,200],[185,105],[270,60],[350,85]]}"#;
const BAY: &str = r#"{"format": "IP2", "settings": {"method": "phspline"},
    "points": [[60,120],[150,300],[250,170],[330,110],[420,190],[500,320]]}"#;
const SCREW: &str = r#"{"format": "IP3", "settings": {"method": "phhermite"}, "points": [[100,0,0],[0,100,50],[-100,0,100]],
    "tangents": [[0,150,50],[-150,0,50],[0,-150,50]]}"#;

/// A folder with the documents.
fn folder() -> Folder {
    let folder = Folder::new();
    for (name, text) in [("cam.json", CAM), ("bay.json", BAY), ("screw.json", SCREW)] {
        folder.write(name, text);
    }
    folder
}

/// The columns of a table by their names.
fn column(table: &str, name: &str) -> Vec<f64> {
    let mut lines = table.lines();
    let at = lines.next().unwrap().split(',').position(|it| it == name).unwrap();
    lines.map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
}

fn close(a: f64, b: f64, within: f64) -> bool {
    (a - b).abs() <= within
}

#[test]
fn lengths_and_limits_of_the_samples() {
    let folder = folder();
    let cam = folder.json("measure cam.json --to json");
    assert!(close(cam["length"].as_f64().unwrap(), 866.479834, 1e-6));
    assert!(close(cam["energy"].as_f64().unwrap(), 0.047615, 1e-6));
    assert!(close(cam["rotation"].as_f64().unwrap(), std::f64::consts::TAU, 1e-11));
    assert!(close(cam["offset_limits"][1].as_f64().unwrap(), 95.4977, 1e-4));
    assert_eq!(cam["spans"].as_array().unwrap().len(), 8);
    let bay = folder.json("measure bay.json --to json");
    assert!(close(bay["offset_limits"][0].as_f64().unwrap(), -56.9210, 1e-4));
    assert!(close(bay["offset_limits"][1].as_f64().unwrap(), 51.2589, 1e-4));
    assert!(!bay["inflections"].as_array().unwrap().is_empty());
    let text = folder.done("measure bay.json");
    assert!(text.contains("offset to the left clean up to 51.25"), "{text}");
    assert!(folder.json("measure screw.json --to json")["length"].as_f64().unwrap() > 300.0);
}

#[test]
fn equal_lengths_and_quantities() {
    let folder = folder();
    let table = folder.done("sample cam.json --uniform 200 --quantities");
    let s = column(&table, "s");
    assert_eq!(s.len(), 201);
    let step = 866.479834 / 200.0;
    assert!(s.windows(2).all(|pair| close(pair[1] - pair[0], step, 1e-6)));
    let (x, y, nx, ny) =
        (column(&table, "x"), column(&table, "y"), column(&table, "nx"), column(&table, "ny"));
    // The cam runs to the left about (290, 190), so normals point inwards.
    assert!((0..x.len()).all(|k| (290.0 - x[k]) * nx[k] + (190.0 - y[k]) * ny[k] > 0.0));
    let table = folder.done("sample screw.json --per-span 3 --quantities");
    assert!(table.starts_with("span,u,x,y,z,s,speed,kappa,tx,ty,tz,e2x,e2y,e2z,e3x,e3y,e3z\n"));
    assert_eq!(folder.done("sample bay.json --uniform 3").lines().next(), Some("span,u,x,y"));
    let rows = folder.json("sample bay.json --uniform 3 --quantities --to json");
    assert_eq!(rows[3]["span"], 4);
    // Where the curve stops there is no curvature: an empty field, and null.
    let stop = r#"{"format": "IC2", "points": [[0, 0], [100, 0]], "tangents": [[0, 0], [50, 80]]}"#;
    fs::write(folder.path("stop.json"), stop).unwrap();
    let table = folder.done("sample stop.json --method phhermite --per-span 1 --quantities");
    assert!(table.lines().nth(1).unwrap().ends_with(",0,0,,,"), "{table}");
    let rows = folder.json("sample stop.json --method phhermite --per-span 1 --quantities --to json");
    assert_eq!(rows[0]["kappa"], Value::Null);
    // Plain samples are those of any curve.
    assert_eq!(
        folder.done("sample bay.json --per-span 4"),
        folder.done("sample bay.json --per-span 4 --method phspline --knots chord")
    );
    assert_ne!(folder.done("sample bay.json"), folder.done("sample bay.json --knots uniform --start=-50,90"));
}

#[test]
fn offsets_are_exact_documents_that_render() {
    let folder = folder();
    folder.done("offset bay.json --distance 60 --trim -o bay60.rbc");
    let offset: Value = serde_json::from_str(&folder.read("bay60.rbc")).unwrap();
    assert_eq!((&offset["format"], offset["spans"][0]["degree"].as_u64()), (&Value::from("RBC"), Some(9)));
    assert_eq!(offset["cusps"].as_array().unwrap().len(), 2);
    assert_eq!(offset["crossings"].as_array().unwrap().len(), 1);
    let kept = &offset["kept"];
    assert!(close(kept[0][3].as_f64().unwrap(), 0.7119, 1e-4), "{kept}");
    assert!(close(kept[1][1].as_f64().unwrap(), 0.2413, 1e-4), "{kept}");
    assert!(folder.done("info bay60.rbc").contains("rational curve of the plane: 5 spans"));
    // A file is what it was made from.
    let document = Document::decode(FileKind::Json, folder.read("bay60.rbc").as_bytes()).unwrap();
    assert_eq!(document.encode(FileKind::Json).unwrap(), folder.read("bay60.rbc").as_bytes());
    folder.done("render bay60.rbc -o bay60.svg");
    folder.done("render bay60.rbc -o bay60.step");
    assert!(folder.read("bay60.svg").contains("<path"));
    assert!(folder.read("bay60.step").contains("RATIONAL_B_SPLINE_CURVE"));
    // Without --trim there are neither crossings nor stretches.
    let whole = folder.json("offset bay.json --distance 60");
    assert!(whole.get("kept").is_none() && whole.get("crossings").is_none());
    // The length of a ring's offset is less by as many turns.
    let ring = folder.json("offset cam.json --distance 20");
    assert!(close(ring["length"].as_f64().unwrap(), 866.479834 - 40.0 * std::f64::consts::PI, 1e-6));
    assert_eq!(ring["closed"], Value::from(true));
}

#[test]
fn offsets_as_points_pictures_and_moves() {
    let folder = folder();
    let (table, curve) = (
        folder.done("offset cam.json --distance=-15 --to csv --per-span 5"),
        folder.done("sample cam.json --per-span 5"),
    );
    let columns = |table: &str| ["span", "u", "x", "y"].map(|name| column(table, name));
    let ([span, u, x, y], [span0, u0, x0, y0]) = (columns(&table), columns(&curve));
    assert_eq!((span, u), (span0, u0));
    assert!((0..x.len()).all(|k| close((x[k] - x0[k]).hypot(y[k] - y0[k]), 15.0, 1e-10)));
    for name in ["a.svg", "a.pdf", "a.png", "a.step"] {
        folder.done(&format!("offset cam.json --distance 90 --trim -o {name}"));
        assert!(fs::metadata(folder.path(name)).unwrap().len() > 500, "{name}");
    }
    let text = folder.done("offset cam.json --distance 10 --nc a.nc --tolerance 0.01 --unit 0.5 --feed 250");
    assert_eq!(text, "", "moves alone need nothing else");
    let moves = folder.read("a.nc");
    let lines: Vec<&str> = moves.lines().filter(|line| line.starts_with("G1 ")).collect();
    assert!(lines.len() > 60 && lines.iter().all(|line| line.ends_with(" F250")), "{moves}");
    // Half a millimetre a unit: all moves lie in the field, halved.
    let number = |line: &str, letter: char| -> f64 {
        line.split(' ').find_map(|word| word.strip_prefix(letter)).unwrap().parse().unwrap()
    };
    assert!(lines.iter().all(|line| (70.0..225.0).contains(&number(line, 'X'))));
    let coarse = folder.done("offset cam.json --distance 10 --nc b.nc --tolerance 1");
    assert!(coarse.is_empty() && folder.read("b.nc").lines().count() < moves.lines().count());
    // Nothing is kept of an offset inside a ring that is too small; that is said, and is no failure.
    let output = folder.run("offset cam.json --distance 200 --trim --to json");
    assert_eq!(output.status.code(), Some(0));
    assert!(String::from_utf8_lossy(&output.stderr).contains("nothing of it is kept"));
}

#[test]
fn pictures_show_offsets_combs_and_speeds() {
    let folder = folder();
    let arcs = |options: &str| {
        folder.done(&format!("render bay.json {options} -o a.svg"));
        folder.read("a.svg").matches(['C', 'L']).count()
    };
    let plain = arcs("");
    assert!(arcs("--distance 10") > plain && arcs("--distance 10 --distance=-10") > arcs("--distance 10"));
    assert!(arcs("--comb") > plain + 100);
    assert!(arcs("--speed") > plain);
    assert!(arcs("--tolerance 1e-3") < plain && arcs("--tolerance 1e-9") > plain);
    folder.done("render bay.json --distance=-40 -o both.step");
    let step = folder.read("both.step");
    assert!(step.contains("B_SPLINE_CURVE_WITH_KNOTS('',5,(") && step.contains("B_SPLINE_CURVE(9,("));
    folder.done("render screw.json -o screw.svg");
}

#[test]
fn formulas_are_exact() {
    let folder = folder();
    assert_eq!(folder.done("poly (x+y)^2-x^2"), "2*x*y + y^2\n");
    assert_eq!(folder.done("poly x/(1+x) --derivative x --at x=1/2"), "4/9\n");
    // Substitutions go together.
    assert_eq!(folder.done("poly x-2*y --substitute x=y --substitute y=x"), "-2*x + y\n");
    let json = folder.json("poly 3-x^2/4 --to json");
    assert_eq!(json["terms"].as_array().unwrap().len(), 2);
    let json = folder.json("poly 1/x --to json");
    assert!(json["numerator"]["terms"].is_array() && json["denominator"]["terms"].is_array());
}

#[test]
fn refusals_are_one_line_and_write_nothing() {
    let folder = folder();
    let files = [
        ("equal.json", r#"{"format": "IP2", "points": [[0,0],[100,50],[100,50],[200,0]]}"#),
        ("s.json", r#"{"format": "IC2", "points": [[0,0],[100,0]], "tangents": [[1,0.5],[1,0.5]]}"#),
        (
            "zero.rbc",
            r#"{"format": "RBC", "distance": 1, "length": 2, "spans": [{"degree": 1, "homogeneous": [[0,0,0],[1,1,1]]}]}"#,
        ),
        (
            "odd.rbc",
            r#"{"format": "RBC", "distance": 1, "length": 2, "spans": [{"degree": 3, "homogeneous": [[0,0,0],[1,1,1]]}]}"#,
        ),
        ("stop.json", r#"{"format": "IC2", "points": [[0,0],[100,0]], "tangents": [[0,0],[50,80]]}"#),
    ];
    for (name, text) in files {
        fs::write(folder.path(name), text).unwrap();
    }
    for (line, status, says) in [
        ("sample equal.json --method phspline -o out", 1, "points 2 and 3 are the same"),
        ("measure equal.json --method phspline --to json -o out", 1, "points 2 and 3"),
        ("offset equal.json --method phspline --distance 3 --to json -o out", 1, "points 2 and 3"),
        ("sample s.json --method phcubic -o out", 1, "no PH cubic"),
        ("render s.json --method phcubic --to svg -o out", 1, "no PH cubic"),
        ("render zero.rbc --to svg -o out", 1, "weight"),
        ("render odd.rbc --to svg -o out", 1, "degree 3 and 2 points"),
        ("offset stop.json --method phhermite --distance 3 --to step -o out", 1, "weight"),
        ("offset bay.json --distance 1e200 --to json -o out", 1, "distance"),
        ("poly 1/(x-x) --to txt -o out", 1, "zero"),
        ("poly x --at y=1 --to txt -o out", 1, "x has no value"),
        ("poly x+ --to txt -o out", 1, "character"),
        ("measure bay.json --method spline --to json -o out", 2, "spline has no exact lengths"),
        ("sample bay.json --method bezier --uniform 5 -o out", 2, "bezier has no exact lengths"),
        ("sample screw.json --method phspline -o out", 2, "curves of the plane"),
        ("offset screw.json --distance 3 --to json -o out", 2, "curves of the plane"),
        ("render screw.json --comb --to svg -o out", 2, "curves of the plane"),
        ("render bay.json --method bezier --knots chord --to svg -o out", 2, "--knots is for phspline"),
        ("sample A.ZMS --start 1,2 -o out", 2, "--start is for phspline"),
        ("sample bay.json --start 1 -o out", 2, "DX,DY"),
        ("sample A.ZMS --method phspline -o out", 2, "phspline is for curves"),
        ("measure A.ZMS --to json -o out", 2, "spline has no exact normals and offsets"),
        ("render bay.json --to stl -o out", 2, "meshes are of surfaces"),
        ("render bay.json --comb --to step -o out", 2, "for pictures"),
        ("offset bay.json --distance 3 --to obj -o out", 2, "not .obj"),
        ("offset bay.json --distance 3 -o out.obj", 2, "not .obj"),
        ("offset bay.json --distance 1e300 --to json -o out", 1, "distance is 1e300, but"),
        ("offset bay.json -o out", 2, "--distance"),
        ("offset bay.json --distance 3 --nc out --tolerance 0", 2, "positive number"),
    ] {
        let output = folder.run(line);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{line}: {said}");
        assert!(said.contains(says) && said.trim_end().lines().count() == 1, "{line}: {said}");
        assert!(!folder.path("out").exists() && !folder.path("out.obj").exists(), "{line}");
    }
}
