//! Skins on the command line: `grafika skin` and `render`.

#![cfg(feature = "native")]

mod common;

use common::folder::Folder;
use serde_json::Value;

/// The skin of a file as JSON.
#[track_caller]
fn skin(folder: &Folder, options: &str) -> Value {
    folder.done(&format!("skin {options} -o skin.json"));
    serde_json::from_str(&folder.read("skin.json")).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|it| it.as_f64().unwrap()).collect()
}

#[test]
fn samples_are_admissible_but_one() {
    let folder = Folder::new();
    for name in ["ATFEDO.KOR", "GYURU.KOR", "KEZ.KOR", "KIGYO.KOR", "VILLA.KOR", "CSIGA.GOM"] {
        let told: Value = serde_json::from_str(&folder.done(&format!("skin {name} --check"))).unwrap();
        assert_eq!(told["admissible"], true, "{name}");
        assert_eq!(told["violations"].as_array().map(Vec::len), Some(0), "{name}");
        assert_eq!(skin(&folder, name)["unclear"].as_array().map(Vec::len), Some(0), "{name}");
    }
    let output = folder.run("skin ROSSZ.KOR --check");
    assert_eq!(output.status.code(), Some(1));
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(told["admissible"], false);
    assert_eq!(told["violations"][0], serde_json::json!({ "rule": 3, "circles": [0, 1, 2] }));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("circles 1 and 3 meet outside circle 2"), "{said}");
    assert!(std::fs::read_dir(folder.path("")).unwrap().count() == 1, "only skin.json is written");
}

/// Whatever is said of the sides: every touching point lies on its circle, arcs lead from one to the next.
#[test]
fn sides_touch_their_circles() {
    let folder = Folder::new();
    folder.write("three.kor", "{\"format\":\"KOR\",\"circles\":[[0,0,1],[4,0,2],[8,1,0.5]]}");
    let skin = skin(&folder, "three.kor");
    let circles = [[0.0, 0.0, 1.0], [4.0, 0.0, 2.0], [8.0, 1.0, 0.5]];
    assert_eq!((skin["format"].as_str(), skin["loops"].as_array().map(Vec::len)), (Some("SKN"), Some(0)));
    for side in ["left", "right"] {
        for (k, [x, y, r]) in circles.iter().enumerate() {
            let point = numbers(&skin["touch"][k][side]);
            assert!(((point[0] - x).hypot(point[1] - y) - r).abs() < 1e-12, "{side} {k}");
        }
        for k in 0..2 {
            let arc = &skin[side][k];
            assert_eq!(arc["circles"], serde_json::json!([k, k + 1]));
            assert_eq!(arc["bezier"][0], skin["touch"][k][side]);
            assert_eq!(arc["bezier"][3], skin["touch"][k + 1][side]);
        }
    }
    let left = numbers(&skin["touch"][1]["left"]);
    assert!(left[1] > 1.9, "left is above: {left:?}");
}

#[test]
fn a_tree_has_one_closed_outline() {
    let folder = Folder::new();
    let skin = skin(&folder, "VILLA.KOR --plain");
    assert_eq!(skin["touch"].as_array().map(Vec::len), Some(0));
    let pieces = skin["loops"][0].as_array().unwrap();
    assert_eq!(skin["loops"].as_array().map(Vec::len), Some(1));
    assert_eq!(pieces.iter().filter(|piece| piece["cap"].is_u64()).count(), 3);
    let ends = |piece: &Value| match piece.get("bezier") {
        Some(bezier) => [numbers(&bezier[0]), numbers(&bezier[3])],
        None => [numbers(&piece["start"]), numbers(&piece["end"])],
    };
    for (piece, next) in pieces.iter().zip(pieces.iter().cycle().skip(1)) {
        assert_eq!(ends(piece)[1], ends(next)[0]);
    }
}

#[test]
fn pictures_and_models_are_written() {
    let folder = Folder::new();
    // Two sides of four arcs each, exactly; with caps more.
    folder.done("skin KIGYO.KOR -o open.svg");
    folder.done("skin KIGYO.KOR -o caps.svg --caps");
    let [open, caps] = ["open.svg", "caps.svg"].map(|name| folder.read(name));
    assert!(caps.matches('C').count() > open.matches('C').count());
    let skin = skin(&folder, "KIGYO.KOR");
    let arc = numbers(&skin["right"][0]["bezier"][0]);
    // Up is down in SVG.
    assert!(open.contains(&format!("M{} ", arc[0])), "{open}");
    folder.done("skin GYURU.KOR -o ring.step --caps");
    let step = folder.read("ring.step");
    assert_eq!(step.matches("B_SPLINE_CURVE_WITH_KNOTS('',3").count(), 2, "an outer and an inner outline");
    folder.done("skin VILLA.KOR -o tree.step --caps");
    assert!(folder.read("tree.step").contains("RATIONAL_B_SPLINE_CURVE"), "caps are exact");
    assert!(folder.run("skin KEZ.KOR -o - --to png").stdout.starts_with(b"\x89PNG"));
    for name in ["a.pdf", "a.png"] {
        folder.done(&format!("skin KEZ.KOR -o {name}"));
    }
    // `render` shows the same outlines.
    folder.done("render KIGYO.KOR -o render.svg");
    assert_eq!(folder.read("render.svg").matches("<path").count(), 1);
    folder.done("render KIGYO.KOR --points -o points.svg");
    folder.done("render KIGYO.KOR -o render.step");
    let rows = folder.done("sample KIGYO.KOR --per-span 2");
    // Eight arcs and two caps.
    assert_eq!(rows.lines().count(), 1 + 10 * 3);
}

#[test]
fn spheres_are_solids() {
    let folder = Folder::new();
    let circles = skin(&folder, "CSIGA.GOM")["circles"].as_array().cloned().unwrap();
    assert_eq!(circles.len(), 5);
    let axis = numbers(&circles[2]["axis"]);
    assert!((axis.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12);
    folder.done("skin CSIGA.GOM -o snail.obj");
    let mesh = folder.read("snail.obj");
    // A closed surface without handles: V - E + F = 2, and two triangles an edge.
    let count = |kind: &str| mesh.lines().filter(|line| line.starts_with(kind)).count();
    let (vertices, faces) = (count("v "), count("f "));
    assert_eq!(2 * vertices, faces + 4, "{vertices} {faces}");
    folder.done("skin CSIGA.GOM -o snail.step");
    assert!(folder.read("snail.step").contains("RATIONAL_B_SPLINE_SURFACE"));
    for name in ["snail.stl", "snail.ply", "snail.svg", "snail.png", "snail.pdf"] {
        folder.done(&format!("skin CSIGA.GOM -o {name} --plain --caps"));
    }
    folder.write("bad.gom", "{\"format\":\"GOM\",\"spheres\":[[0,0,0,2],[1.5,3,0,1],[3,0,0,2]]}");
    let told = folder.refused(1, "skin bad.gom --check");
    assert!(told.contains("spheres 1 and 3 meet outside sphere 2"), "{told}");
}

#[test]
fn what_is_wrong_is_said() {
    let folder = Folder::new();
    assert!(folder.refused(1, "skin A.IP2 -o a.svg").contains("holds no circles or spheres"));
    assert!(folder.refused(2, "skin KIGYO.KOR").contains("--output"));
    assert!(folder.refused(2, "skin KIGYO.KOR -o a.doc").contains(".svg"));
    assert!(folder.refused(2, "skin KIGYO.KOR -o -").contains("--to"));
    assert!(folder.refused(2, "skin KIGYO.KOR -o a.stl").contains("spheres"));
    assert!(folder.refused(2, "skin KIGYO.KOR --check -o a.svg").contains("--check"));
    folder.write("one.kor", "{\"format\":\"KOR\",\"circles\":[[0,0,1]]}");
    // The skin of one circle is the circle; without caps there is nothing to draw.
    folder.done("skin one.kor -o a.svg");
    assert!(folder.refused(1, "render one.kor -o a.svg").contains("no whole skin"));
    folder.write("none.kor", "{\"format\":\"KOR\",\"circles\":[]}");
    folder.refused(1, "skin none.kor --check");
    folder.write("inside.kor", "{\"format\":\"KOR\",\"circles\":[[0,0,3],[0.5,0,1],[6,0,2]]}");
    let told = folder.refused(1, "skin inside.kor -o a.svg");
    assert!(told.contains("circle 2 is covered by the others"), "{told}");
    // What can still be skinned is, and the rule is told.
    let output = folder.run("skin ROSSZ.KOR -o bad.svg");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("meet outside circle 2"), "{said}");
    assert!(folder.refused(2, "render KIGYO.KOR --per-span 3 -o a.svg").contains("--per-span"));
}
