//! Curves by their knots and with shape parameters on the command line: `knots`, `shape`, `sample --at`, `render` and
//! `convert`.

#![cfg(feature = "native")]

mod common;

use common::folder::Folder;
use grafika::file::{Document, FileKind, Format};
use serde_json::Value;

#[track_caller]
fn near(found: &Value, expected: &[f64]) {
    let found: Vec<f64> = found.as_array().unwrap().iter().map(|it| it.as_f64().unwrap()).collect();
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-12 * b.abs().max(1.0), "{found:?} {expected:?}");
    }
}

fn coordinates(row: &Value) -> [f64; 2] {
    ["x", "y"].map(|axis| row[axis].as_f64().unwrap())
}

#[test]
fn points_of_the_circle_at_its_knots() {
    let folder = Folder::new();
    let rows = folder.json("sample K.CSM --at 0,0.5,1,4 --derivatives 1 --to json");
    let rows = rows.as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let [x, y] = coordinates(row);
        assert!(((x - 280.0).hypot(y - 130.0) - 110.0).abs() < 1e-12);
        let [dx, dy] = ["dx", "dy"].map(|axis| row[axis].as_f64().unwrap());
        assert!(((x - 280.0) * dx + (y - 130.0) * dy).abs() < 1e-9);
    }
    // Without places, equal steps in every span by the knots.
    let table = folder.done("sample A.CSM --per-span 2");
    assert!(table.starts_with("u,x,y\n3,"), "{table}");
    assert_eq!(table.lines().count(), 1 + 10 * 2 + 1);
    let told = folder.refused(1, "sample A.CSM --at 2 --to json");
    assert!(told.contains("u is 2; it must be between 3 and 13.2"), "{told}");
}

#[test]
fn a_point_meets_the_envelope_where_the_knot_is_its_parameter() {
    let folder = Folder::new();
    let envelope = folder.json("knots envelope A.CSM --knot 6 --at 6");
    assert_eq!((envelope["order"].as_u64(), envelope["from"].as_f64()), (Some(3), Some(5.2)));
    assert_eq!(envelope["curvature_ratio"].as_f64(), Some(0.75));
    let path = folder.json("knots path A.CSM --knot 6 --span 5 --at 5.9 --values 5.9,6,6.4");
    assert_eq!(path.as_array().unwrap().len(), 3);
    let on_curve = folder.json("sample A.CSM --at 6 --to json");
    let [x, y] = coordinates(&on_curve[0]);
    let [to_x, to_y] = coordinates(&envelope["at"][0]);
    assert!((x - to_x).hypot(y - to_y) < 1e-12);
    let told = folder.refused(1, "knots path A.CSM --knot 6 --span 1 --at 1 --values 6");
    assert!(told.contains("there is no span 1 here"), "{told}");
    let told = folder.refused(1, "knots envelope A.CSM --knot 6 --multiplicity 3");
    assert!(told.contains("multiplicity"), "{told}");
}

#[test]
fn limits_are_control_points() {
    let folder = Folder::new();
    let limits = folder.json("knots limits B.CSM --knot 5");
    let Document::Knots(bowl) = document(&folder, "B.CSM") else { panic!("it has knots") };
    let points = bowl.points.plane().unwrap();
    near(&limits["minus"], &points[5]);
    near(&limits["plus"], &points[1]);
    let symmetric = folder.json("knots symmetric B.CSM --knot 1 --at 3.5 --values 0,0.25");
    assert_eq!(symmetric["straight"], true);
}

fn document(folder: &Folder, name: &str) -> Document {
    folder.done(&format!("convert {name} copy.json"));
    Document::decode(FileKind::Json, folder.read("copy.json").as_bytes()).unwrap()
}

#[test]
fn knots_bring_the_curve_through_a_point() {
    let folder = Folder::new();
    let found = folder.json("knots through B.CSM --point 280,219 --by any");
    assert_eq!(found["admissible"], true);
    let knots: Vec<f64> = found["knots"].as_array().unwrap().iter().map(|it| it.as_f64().unwrap()).collect();
    assert!(knots.windows(2).all(|pair| pair[0] <= pair[1]));
    let Document::Knots(mut bowl) = document(&folder, "B.CSM") else { panic!("it has knots") };
    bowl.knots = knots;
    folder.write("moved.csm", &Document::Knots(bowl).to_json().unwrap());
    let at = found["u"].as_f64().unwrap();
    let row = folder.json(&format!("sample moved.csm --at {at} --to json"));
    let [x, y] = coordinates(&row[0]);
    assert!((x - 280.0).hypot(y - 219.0) < 1e-7, "{x} {y}");

    // Outside, the answer is printed as well, with the nearest point.
    let output = folder.run("knots through B.CSM --point 280,900 --by any");
    assert_eq!(output.status.code(), Some(1));
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&told["admissible"], told["nearest"].as_array().unwrap().len()), (&Value::from(false), 2));
    let told = folder.refused(2, "knots through B.CSM --point 280,219 --by outer --at 4.5");
    assert!(told.contains("--span"), "{told}");
    let told = folder.refused(2, "knots through B.CSM --point 280 --by any");
    assert!(told.contains("give X,Y"), "{told}");
    assert!(folder.run("knots through B.CSM --point 280,219 --by magic").status.code() == Some(2));
}

#[test]
fn what_keeps_the_curve_keeps_it() {
    let folder = Folder::new();
    let before = folder.json("sample D.CSM --at 5.5,6.2,7.9 --to json");
    for (command, file) in
        [("knots insert D.CSM --at 5.7", "more.csm"), ("knots elevate D.CSM", "higher.csm")]
    {
        folder.done(&format!("{command} -o {file}"));
        let after = folder.json(&format!("sample {file} --at 5.5,6.2,7.9 --to json"));
        for (a, b) in before.as_array().unwrap().iter().zip(after.as_array().unwrap()) {
            let ([x, y], [to_x, to_y]) = (coordinates(a), coordinates(b));
            assert!((x - to_x).hypot(y - to_y) < 1e-10);
        }
    }
    folder.done("knots remove more.csm --knot 6 -o back.csm");
    let Document::Knots(back) = document(&folder, "back.csm") else { panic!("it has knots") };
    assert_eq!(back.points.len(), 8);
    let told = folder.refused(1, "knots remove A.CSM --knot 6");
    assert!(told.contains("the curve would move by"), "{told}");
    folder.done("knots remove A.CSM --knot 6 --tolerance 1000 -o less.csm");
}

#[test]
fn parameters_move_points_and_are_found() {
    let folder = Folder::new();
    let path =
        folder.json("shape path FELKOR.ALP --at 0.5 --parameter alpha --values 0.001,3.141592653589793");
    let [_, top] = coordinates(&path[1]);
    assert!((top - 230.0).abs() < 1e-12, "{top}");
    let [x, y] = coordinates(&path[0]);
    let found = folder.json(&format!("shape through FELKOR.ALP --parameter alpha --point {x},{y}"));
    assert!(found["parameters"]["alpha"].as_f64().unwrap() < 0.01);
    let local = folder.json("shape through HAN.ALP --parameter lambda:4 --point 280,290");
    assert_eq!(local["parameters"]["lambda"].as_array().unwrap().len(), 9);
    let output = folder.run("shape through FELKOR.ALP --parameter alpha --point 0,0");
    assert_eq!(output.status.code(), Some(1));
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(told["admissible"], false);
    let told = folder.refused(1, "shape path FELKOR.ALP --at 2 --parameter alpha --values 1");
    assert!(told.contains("it must be between 0 and 1"), "{told}");
    let told = folder.refused(1, "shape path FELKOR.ALP --at 0.5 --parameter beta --values 1");
    assert!(told.contains("beta"), "{told}");
}

#[test]
fn curves_pass_their_data() {
    let folder = Folder::new();
    folder.write("six.csv", "x,y\n60,120\n150,300\n250,170\n330,110\n420,190\n500,320\n");
    for family in ["han", "alpha", "gb", "spb", "c-bspline", "f-bspline"] {
        folder.done(&format!("shape interpolate six.csv --family {family} --value 0.7 -o through.alp"));
        let rows = folder.json("sample through.alp --at 0,1,5 --to json");
        for (row, [x, y]) in
            rows.as_array().unwrap().iter().zip([[60.0, 120.0], [150.0, 300.0], [500.0, 320.0]])
        {
            let [to_x, to_y] = coordinates(row);
            assert!((x - to_x).hypot(y - to_y) < 1e-9, "{family}");
        }
    }
    // Points under their name alone are points.
    folder.write("bare.json", "{\"points\": [[0, 0], [1, 2], [3, 1]]}");
    let closed = folder.json("shape interpolate bare.json --family han --value 4 --closed");
    assert_eq!(closed["points"].as_array().unwrap().len(), 3);
    let told = folder.refused(1, "shape interpolate six.csv --family han --value -3");
    assert!(told.contains("larger than -2"), "{told}");
}

#[test]
fn elevation_keeps_the_circle() {
    let folder = Folder::new();
    folder.done("shape elevate KOR.ALP --by 3 -o more.alp");
    let rows = folder.json("sample more.alp --at 0,1,2.5 --to json");
    for row in rows.as_array().unwrap() {
        let [x, y] = coordinates(row);
        // The corners of the sample are whole numbers, so that its circle is one but for half a pixel.
        assert!(((x - 280.0).hypot(y - 190.0) - 80.0).abs() < 0.5);
    }
    let told = folder.refused(1, "shape elevate HAN.ALP --by 1");
    assert!(told.contains("cyclic"), "{told}");
}

#[test]
fn pictures_and_models() {
    let folder = Folder::new();
    for file in ["A.CSM", "K.CSM", "A.CSF", "HAN.ALP", "CSAVAR.ALP", "TRIG.ALP"] {
        folder.done(&format!("render {file} --points --polygon -o a.svg"));
        assert!(folder.read("a.svg").contains("<path"), "{file}");
    }
    folder.done("render K.CSM -o k.step");
    assert!(folder.read("k.step").contains("RATIONAL_B_SPLINE_CURVE"));
    folder.done("render HAN.ALP -o h.step");
    assert!(folder.read("h.step").contains("B_SPLINE_CURVE_WITH_KNOTS('',4,"), "a Han spline has degree 4");
    let fitted = folder.run("render FELKOR.ALP -o f.step");
    assert!(String::from_utf8_lossy(&fitted.stderr).contains("fitted by"));
    folder.done("render A.CSF -o a.step");
    let model = folder.read("a.step");
    assert!(model.contains("B_SPLINE_SURFACE_WITH_KNOTS('',3,3,"), "it is bicubic");
    let told = folder.refused(2, "render A.CSM --method spline -o a.svg");
    assert!(told.contains("--method"), "{told}");
}

#[test]
fn points_change_between_programs() {
    let folder = Folder::new();
    folder.done("convert A.IP2 a.csm");
    let told = folder.run("convert A.CSM points.csv");
    assert_eq!(folder.read("points.csv").lines().count(), 14);
    assert!(String::from_utf8_lossy(&told.stderr).contains("order, knots"));
    folder.done("convert A.GBP a.alp");
    folder.done("convert a.alp a.gbp");
    let Document::Fourier(again) = Document::read(Format::Gbp, &folder.bytes("a.gbp")).unwrap() else {
        panic!("coefficients")
    };
    let sample = grafika::machine::sample("A.GBP").unwrap();
    let Document::Fourier(before) = Document::read(Format::Gbp, sample).unwrap() else {
        panic!("coefficients")
    };
    assert!(again.a.iter().zip(before.a).all(|(a, b)| (a - b).abs() < 1e-3));
    let info = folder.done("info a.csm");
    assert!(info.starts_with("B-spline curve of the plane: "), "{info}");
}
