//! KC_TER as its user sees it: the scripts of its examples, golden pictures, files, random input.

mod common;

use common::{Kept, pictures, play_script, random};
use grafika::machine::Memory;
use grafika::programs::kc_ter::PROGRAM;
use serde_json::Value;

fn run(script: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{script}\nshot end.png\ndump end.json\n"))
}

fn model(script: &str) -> Value {
    run(script).models["end.json"].clone()
}

fn points(item: &Value) -> Vec<[f64; 3]> {
    serde_json::from_value(item["points"].clone()).expect("the points are there")
}

/// A new curve over the space of the logarithmic spiral, on its first quarter turn.
const SPACE: &str = "key B\nkey G\nkey G\nkey V\nkey 1\ntype 1\nkey Enter\nkey B\ntype 1/4+i\nkey Enter\ntype 1\nkey Enter\n\
                     key V\nkey E\ntype pi/2\nkey Enter\n";
/// Its coefficients: the second function in x, the third in y.
const COEFFICIENTS: &str =
    "key R\nkey K\nkey Right\ntype 1\nkey Enter\nkey Right\nkey Down\ntype 1\nkey Enter\n";

#[test]
fn the_spiral_of_the_thesis_comes_from_its_coefficients() {
    let model = model(&format!("{SPACE}{COEFFICIENTS}key R\n"));
    let item = &model["items"][0];
    let expected =
        [[1.0, 0.0, 0.0], [1.289640628350567, 1.1585625134022681, 0.0], [0.0, 1.48097267048991, 0.0]];
    for (point, expected) in points(item).iter().zip(expected) {
        assert!(point.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-13), "{point:?}");
    }
    assert_eq!((&item["is_exact"], &item["interval"][1]), (&Value::Bool(true), &Value::from("pi/2")));
    assert!((item["critical"][0].as_f64().unwrap() - std::f64::consts::PI).abs() < 1e-12);
}

#[test]
fn a_strip_is_made_over_a_longer_interval() {
    let model =
        model(&format!("{SPACE}{COEFFICIENTS}key R\nkey C\ntype 0, 3*pi\nkey Enter\ntype 6\nkey Enter"));
    let items = model["items"].as_array().unwrap();
    assert_eq!(items.len(), 6);
    let last = points(&items[5])[2];
    assert!((last[0] + 10.550_724_074_197_761).abs() < 1e-12 && last[1].abs() < 1e-12, "{last:?}");
}

#[test]
fn a_bad_interval_is_not_accepted_and_nothing_is_lost() {
    let kept = run(
        "key B\nkey G\nkey G\nkey P\ntype T1\nkey Enter\nkey V\nkey E\ntype 4\nkey Enter\ndump bad.json\nkey R\nkey Esc",
    );
    assert_eq!(kept.models["bad.json"]["dialog"]["verdict"], "too long");
    assert!(
        (kept.models["bad.json"]["dialog"]["critical"].as_f64().unwrap() - std::f64::consts::PI).abs()
            < 1e-12
    );
    // Esc left the curve as it was.
    let model = &kept.models["end.json"];
    assert_eq!((points(&model["items"][0]).len(), &model["items"][0]["interval"][1]), (4, &Value::from(1.0)));
}

#[test]
fn raising_and_dividing_keep_the_curve_and_are_undone() {
    let raised = model("key B\nkey G\nkey O");
    assert_eq!(points(&raised["items"][0]).len(), 5);
    let divided = model("key B\nkey G\nkey D");
    let items = divided["items"].as_array().unwrap();
    assert_eq!(items.len(), 2);
    assert_eq!(points(&items[0])[3], points(&items[1])[0]);
    let undone = model("key B\nkey G\nkey D\nkey Ctrl+Z");
    assert_eq!(undone["items"].as_array().unwrap().len(), 1);
}

#[test]
fn a_dragged_point_moves_and_a_dragged_item_too() {
    let before = model("key B\nkey G");
    let after = model("key B\nkey G\ndrag 295 286 340 150");
    let (before, after) = (points(&before["items"][0]), points(&after["items"][0]));
    let moved: Vec<usize> = (0..4).filter(|&k| before[k] != after[k]).collect();
    assert_eq!(moved.len(), 1);
    let scaled = model("key B\nkey G\nkey PageUp");
    assert!((points(&scaled["items"][0])[0][0] + 105.0).abs() < 1e-9);
}

#[test]
fn a_scene_is_saved_and_read_again() {
    let kept = run(
        "key B\nkey G\nkey B\nkey F\nkey Ctrl+S\ntype TWO\nkey Enter\ndump a.json\nkey Q\nkey N\nkey N\nkey I\n\
                    dump empty.json\nkey O\ntype TWO\nkey Enter",
    );
    assert_eq!(kept.models["empty.json"]["items"], Value::Array(Vec::new()));
    assert_eq!(kept.models["end.json"]["items"], kept.models["a.json"]["items"]);
    assert_eq!(kept.models["end.json"]["unsaved"], false);
}

#[test]
fn joined_curves_stay_joined_while_a_point_moves() {
    let script =
        "key B\nkey G\nkey B\nkey G\nkey Tab\nkey Tab\nkey J\ntype 2\nkey Enter\ntype 1\nkey Enter\n";
    let model = model(&format!("{script}key V\nkey P"));
    assert_eq!(model["joins"].as_array().map(Vec::len), Some(1), "{}", model["joins"]);
}

#[test]
fn pages_and_dialogs_look_as_they_did() {
    let snail = "key O\ntype SNAIL\nkey Enter\n";
    for language in ["hu", "en"] {
        for (name, script) in [
            ("view", format!("{snail}key F3")),
            ("curve", "key B\nkey G\nkey V\nkey F".to_owned()),
            ("surface", format!("{snail}key Tab")),
            ("point", "key B\nkey F\nclick 137 284".to_owned()),
            ("space", SPACE.to_owned()),
            ("coefficients", format!("{SPACE}{COEFFICIENTS}")),
        ] {
            let kept = run(&format!("lang {language}\n{script}"));
            pictures::assert_golden(&format!("kc_ter_{name}_{language}"), &kept.pictures["end.png"]);
        }
    }
}

#[test]
fn recordings_replay() {
    random::assert_replays(PROGRAM, &random::script(7, random::part(1500)));
}

#[test]
fn random_events_do_no_harm() {
    random::storm(PROGRAM, random::SOME);
}

#[test]
fn random_events_in_the_dialogs_do_no_harm() {
    for dialog in [SPACE.to_owned(), format!("{SPACE}{COEFFICIENTS}")] {
        random::storm_after(PROGRAM, &dialog, 60, random::SOME);
    }
}
