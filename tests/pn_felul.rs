//! PN_FELUL as its user sees it: the samples, offsets and maps, golden pictures, files, random input.

mod common;

use common::{Kept, pictures, play_script, random};
use grafika::machine::Memory;
use grafika::programs::pn_felul::PROGRAM;
use serde_json::Value;

/// Plays a script on a new net.
fn run(script: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{script}\nshot end.png\ndump end.json\n"))
}

fn model(script: &str) -> Value {
    run(script).models["end.json"].clone()
}

/// Opens a sample.
fn sample(name: &str, script: &str) -> String {
    format!("key T\ntype {name}\nkey Enter\n{script}")
}

fn facts(model: &Value) -> &Value {
    &model["normals"]["facts"]
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

/// A new net.
const NEW: &str = "key U\n";
/// A normal in the middle turned far to one side.
const TURNED: &str = "key N\ntype 11\ntype 0\nkey Enter\ntype -20\nkey Enter\n";

#[test]
fn samples_are_what_they_say() {
    let sphere = model(&sample("G", ""));
    assert!((number(&facts(&sphere)["r1"][0]) - 30.0).abs() < 1e-9);
    assert!((number(&facts(&sphere)["r2"][1]) - 30.0).abs() < 1e-9);
    assert!(number(&facts(&sphere)["sphere"]) < 1e-9);
    let vault = model(&sample("P", ""));
    assert!((number(&facts(&vault)["limits"][0]) + 15.626).abs() < 1e-3);
    assert!(facts(&vault)["limits"][1].is_null());
    let saddle = model(&sample("N", ""));
    assert!(number(&facts(&saddle)["limits"][0]) < 0.0 && number(&facts(&saddle)["limits"][1]) > 0.0);
    let torus = model(&sample("Y", ""));
    assert_eq!(facts(&torus)["parabolic"], 0);
}

#[test]
fn distance_is_part_of_the_value() {
    let given = model(&sample("P", "key P\ntype 6.5\nkey Enter\nkey M\nkey H"));
    assert_eq!(given["normals"]["distance"], 6.5);
    assert_eq!(given["normals"]["beside"]["both"], true);
    assert_eq!(given["normals"]["beside"]["shell"], true);
    assert_eq!(model(&sample("P", "key P\ntype 6.5\nkey Enter\nkey Ctrl+Z"))["normals"]["distance"], 0.0);
}

#[test]
fn normals_are_typed_and_made() {
    let typed = model(&format!("{NEW}key N\ntype 11\ntype 90\nkey Enter\ntype 60\nkey Enter"));
    let normal: [f64; 3] = serde_json::from_value(typed["normals"]["normals"][1][1].clone()).unwrap();
    let expected = [0.0, 0.5, 0.75_f64.sqrt()];
    assert!(normal.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{normal:?}");
    // A says what the points say, whatever the normals were.
    let fresh = model(&format!("{NEW}key A"));
    let again = model(&format!("{NEW}key N\ntype 11\ntype 90\nkey Enter\ntype 60\nkey Enter\nkey A"));
    assert_eq!(fresh["normals"]["normals"], again["normals"]["normals"]);
    assert!((number(&facts(&model(NEW))["limits"][0]) + 114.2).abs() < 0.1);
}

#[test]
fn a_moved_point_keeps_its_normal() {
    let script = format!("{NEW}key V\ntype 12\ntype 10\nkey Enter\ntype 20\nkey Enter\ntype 130\nkey Enter");
    let (before, after) = (model(NEW), model(&script));
    assert_eq!(after["points"][1][2], serde_json::json!([10.0, 20.0, 130.0]));
    assert_eq!(before["normals"]["normals"], after["normals"]["normals"]);
}

#[test]
fn methods_are_compared_and_exchanged() {
    let both = model(&sample("P", "key F4"));
    assert!(number(&facts(&both)["apart"]) > 1e-3, "{both}");
    assert_eq!(both["normals"]["method"], "pn");
    assert_eq!(model(&sample("P", "key F4\nkey F4"))["normals"]["method"], "pn-thesis");
    assert_eq!(model(&sample("P", "key F4\nkey F4\nkey F4\nkey F4"))["normals"]["method"], "pn");
}

#[test]
fn nets_of_other_sizes_lie_on_the_surface() {
    let sized = model(&sample("G", "key R\ntype 6\nkey Enter\ntype 8\nkey Enter"));
    let points: Vec<Vec<[f64; 3]>> = serde_json::from_value(sized["points"].clone()).unwrap();
    assert_eq!((points.len(), points[0].len()), (6, 8));
    for [x, y, z] in points.into_iter().flatten() {
        let from = ((x - 2.0).powi(2) + (y + 1.0).powi(2) + (z - 3.0).powi(2)).sqrt();
        assert!((from - 30.0).abs() < 1e-9, "{from}");
    }
}

#[test]
fn a_parabolic_patch_is_left_out_and_the_rest_stays() {
    let bent = model(&sample("P", TURNED));
    let facts = facts(&bent);
    assert!(facts["parabolic"].as_u64() >= Some(1) && facts["parabolic"].as_u64() < Some(9), "{facts}");
    assert!(facts["r1"].is_array());
}

#[test]
fn a_net_is_saved_with_all_that_is_its_own_and_read_again() {
    let kept = run(&sample(
        "N",
        "key F4\nkey F4\nkey P\ntype 0.5\nkey Enter\nkey Ctrl+S\ntype TWO\nkey Enter\ndump a.json\nkey Q\nkey N\nkey N\n\
         key T\ntype TWO\nkey Enter",
    ));
    let (before, after) = (&kept.models["a.json"], &kept.models["end.json"]);
    for name in ["points", "normals"] {
        assert_eq!(before[name], after[name], "{name}");
    }
    assert_eq!(after["normals"]["method"], "pn-thesis");
    assert_eq!(after["unsaved"], false);
}

#[test]
fn nets_without_normals_get_them() {
    let opened = model("manner today\nkey T\ntype A.FPS\nkey Enter\n");
    assert_eq!(opened["points"].as_array().map(Vec::len), Some(5));
    assert_eq!(opened["normals"]["normals"].as_array().map(Vec::len), Some(5));
}

#[test]
fn pages_look_as_they_did() {
    for language in ["hu", "en"] {
        for (name, script) in [
            ("new", NEW.to_owned()),
            ("offset", sample("P", "key P\ntype 6\nkey Enter\nkey M")),
            ("shell", sample("N", "key P\ntype .5\nkey Enter\nkey H\ntype ft")),
            ("compared", sample("P", "key F4")),
            ("radii", sample("Y", "key P\ntype 12\nkey Enter\nkey F\nkey T\nkey F5\nkey F5\nkey F5")),
            ("gauss", sample("Y", "key F8")),
            ("red", sample("P", TURNED)),
            ("gauss_red", sample("P", &format!("{TURNED}key F8"))),
            ("folded", sample("P", "key P\ntype -20\nkey Enter")),
            ("section", sample("G", "key P\ntype 4\nkey Enter\nkey M\nkey F\nkey D\nkey F6")),
            ("help", format!("{NEW}key F1")),
        ] {
            let kept = run(&format!("lang {language}\n{script}\nwait 4000"));
            pictures::assert_golden(&format!("pn_felul_{name}_{language}"), &kept.pictures["end.png"]);
        }
    }
}

#[test]
fn recordings_replay() {
    random::assert_replays(PROGRAM, &random::script(7, random::part(400)));
}

#[test]
fn random_events_do_no_harm() {
    random::storm(PROGRAM, random::SOME);
}
