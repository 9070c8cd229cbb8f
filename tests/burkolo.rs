//! BURKOLO as its user sees it: circles dragged, typed and linked, spheres in space, golden pictures, files, random input.

mod common;

use common::{Kept, pictures, play_script, random};
use grafika::machine::Memory;
use grafika::programs::burkolo::PROGRAM;
use serde_json::{Value, json};

/// Plays a script on a new configuration.
fn run(script: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{script}\nshot end.png\ndump end.json\n"))
}

fn model(script: &str) -> Value {
    run(script).models["end.json"].clone()
}

/// Opens a sample. Names typed in the manner of 1997 have the extension of the page; the list of today has all.
fn sample(name: &str, script: &str) -> String {
    let (name, manner) = name.strip_suffix(".GOM").map_or((name, ""), |name| (name, "manner today\n"));
    format!("{manner}key T\ntype {name}\nkey Enter\n{script}")
}

/// Three circles by number.
const THREE: &str = "key U\nkey B\ntype 100\nkey Enter\ntype 150\nkey Enter\ntype 40\nkey Enter\n\
                     key B\ntype 2\nkey Enter\ntype 220\nkey Enter\ntype 170\nkey Enter\ntype 50\nkey Enter\n\
                     key B\ntype 3\nkey Enter\ntype 340\nkey Enter\ntype 150\nkey Enter\ntype 30\nkey Enter\n";

#[test]
fn samples_are_what_they_say() {
    for (name, count, pieces) in [
        ("KIGYO", 5, vec![4, 4]),
        ("KEZ", 7, vec![6, 6]),
        ("ATFEDO", 4, vec![3, 3]),
        ("GYURU", 8, vec![8, 8]),
    ] {
        let told = model(&sample(name, ""));
        assert_eq!(told["circles"].as_array().map(Vec::len), Some(count), "{name}");
        assert_eq!(told["admissible"], true, "{name}");
        assert_eq!(told["pieces"], json!(pieces), "{name}");
        assert_eq!(told["unclear"], json!([]), "{name}");
    }
    assert_eq!(model(&sample("GYURU", ""))["closed"], true);
    let tree = model(&sample("VILLA", "key G\nkey S"));
    assert_eq!((tree["edges"].as_array().map(Vec::len), &tree["missing"]), (Some(6), &json!([])));
    assert_eq!(tree["pieces"].as_array().map(Vec::len), Some(1));
    let bad = model(&sample("ROSSZ", ""));
    assert_eq!(bad["violations"][0]["sentence"], "circles 1 and 3 meet outside circle 2");
    let snail = model(&sample("CSIGA.GOM", ""));
    assert_eq!((snail["circles"].as_array().map(Vec::len), &snail["admissible"]), (Some(5), &json!(true)));
}

#[test]
fn circles_are_typed() {
    let three = model(THREE);
    assert_eq!(three["circles"], json!([[100.0, 150.0, 40.0], [220.0, 170.0, 50.0], [340.0, 150.0, 30.0]]));
    assert_eq!(three["admissible"], true);
    // Between two neighbours it is halfway.
    let four = model(&format!("{THREE}key B\ntype 2\nkey Enter"));
    assert_eq!(four["circles"][1], json!([160.0, 160.0, 45.0]));
    let changed = model(&format!("{THREE}key V\ntype 2\nkey Enter\nkey R\ntype 21.5\nkey Enter"));
    assert_eq!(changed["circles"][1], json!([220.0, 170.0, 21.5]));
    let moved =
        model(&format!("{THREE}key V\ntype 2\nkey Enter\nkey H\ntype 230\nkey Enter\ntype 240\nkey Enter"));
    assert_eq!(moved["circles"][1], json!([230.0, 240.0, 50.0]));
    let fewer = model(&format!("{THREE}key T\ntype 1\nkey Enter"));
    assert_eq!(fewer["circles"][0], json!([220.0, 170.0, 50.0]));
    let back = model(&format!("{THREE}key T\ntype 1\nkey Enter\nkey Ctrl+Z"));
    assert_eq!(back["circles"], three["circles"]);
    assert_eq!(
        model(&format!("{THREE}key Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Y"))["circles"].as_array().unwrap().len(),
        2
    );
}

/// The pixel of (x, y) is (41 + x, 450 - y).
#[test]
fn circles_are_dragged() {
    let moved = model(&format!("{THREE}drag 141 300 151 290"));
    assert_eq!(moved["circles"][0], json!([110.0, 160.0, 40.0]));
    // Anywhere in the disc will do; it keeps its distance from the mouse.
    let moved = model(&format!("{THREE}drag 261 300 281 280"));
    assert_eq!(moved["circles"][1], json!([240.0, 190.0, 50.0]));
    let sized = model(&format!("{THREE}drag 181 300 201 300"));
    assert_eq!(sized["circles"][0], json!([100.0, 150.0, 60.0]));
    let wheeled = model(&format!("{THREE}move 141 300\nwheel 3"));
    assert_eq!(wheeled["circles"][0], json!([100.0, 150.0, 43.0]));
    // Out of the store, and off the field.
    let new = model(&format!("{THREE}drag 618 90 518 150"));
    assert_eq!(new["circles"][3], json!([477.0, 300.0, 26.0]));
    let gone = model(&format!("{THREE}drag 381 300 381 30"));
    assert_eq!(gone["circles"].as_array().map(Vec::len), Some(2));
    assert_eq!(
        model(&format!("{THREE}move 381 300\nkey Delete"))["circles"].as_array().map(Vec::len),
        Some(2)
    );
    // Esc lets go of it.
    let kept = model(&format!("{THREE}move 141 300\npress left\nmove 161 300\nkey Esc\nrelease left"));
    assert_eq!(kept["circles"], model(THREE)["circles"]);
    // In the manner of today a click on the field is a circle.
    let clicked = model(&format!("{THREE}manner today\nclick 500 200"));
    assert_eq!(clicked["circles"][3], json!([459.0, 250.0, 26.0]));
}

#[test]
fn links_make_trees_and_rings() {
    let four = format!("{THREE}drag 618 90 261 150\n");
    // The fourth hangs on the third; link it with the second instead.
    let fork =
        model(&format!("{four}key L\nclick 261 300\nclick 261 150\nkey L\nkey Enter\ntype 3 4\nkey Enter"));
    assert_eq!(fork["edges"], json!([[0, 1], [1, 2], [1, 3]]));
    assert_eq!(fork["admissible"], true);
    // And back: a chain again.
    let chain =
        model(&format!("{four}key L\nclick 261 300\nclick 261 150\nkey L\nclick 261 300\nclick 261 150"));
    assert_eq!(chain["edges"], Value::Null);
    let split = model(&sample("VILLA", "key B\nkey Enter\ntype 1 2\nkey Enter"));
    assert_eq!(split["edges"].as_array().map(Vec::len), Some(7));
    let refused = model(&sample("VILLA", "key B\nkey Enter\ntype 3 5\nkey Enter"));
    assert_eq!(refused["edges"].as_array().map(Vec::len), Some(6));
    let ring = model(&sample("KIGYO", "key K"));
    assert_eq!(ring["closed"], true);
    assert_eq!(model(&sample("KIGYO", "key K\nkey K"))["closed"], false);
    assert_eq!(model(&sample("GYURU", "key K"))["closed"], false);
    assert_eq!(model("key U\nkey K")["closed"], false);
    // Esc, and a click beside everything, cancel.
    assert_eq!(
        model(&sample("VILLA", "key L\nkey Esc\nkey L\nclick 300 30"))["edges"].as_array().map(Vec::len),
        Some(6)
    );
}

#[test]
fn the_skin_is_drawn_as_chosen() {
    for (key, style, pieces) in
        [("N", "open", vec![4, 4]), ("S", "caps", vec![10]), ("K", "filled", vec![10])]
    {
        let told = model(&sample("KIGYO", &format!("key G\nkey {key}")));
        assert_eq!((told["style"].as_str(), &told["pieces"]), (Some(style), &json!(pieces)));
    }
    assert_eq!(model(&sample("KIGYO", "key G\nkey P"))["plain"], true);
    assert_eq!(model(&sample("KIGYO", "key G\nkey P\nkey G\nkey T"))["plain"], false);
    let shown = model(&sample("KIGYO", "key M\nkey R"));
    assert_eq!((&shown["apollonius"], &shown["radical"]), (&json!(true), &json!(true)));
}

#[test]
fn the_nearest_admissible_circles_are_found() {
    let mended = model(&sample("ROSSZ", "key F8"));
    assert_eq!(mended["admissible"], true);
    assert_eq!(mended["circles"][1], model(&sample("ROSSZ", ""))["circles"][1], "the middle one stays");
    assert_eq!(model(&sample("ROSSZ", "key F8\nkey Ctrl+Z"))["admissible"], false);
    assert_eq!(model(&sample("KIGYO", "key F8"))["unsaved"], false);
}

#[test]
fn bad_input_does_no_harm() {
    for keys in [
        "key V\n",
        "key T\n",
        "key L\n",
        "key E\n",
        "key F8\n",
        "key Delete\n",
        "key M\nkey R\nkey G\nkey K\n",
    ] {
        assert_eq!(model(&format!("key U\n{keys}key Esc\n"))["circles"], json!([]), "{keys}");
    }
    // No such circle; a radius that is none.
    let kept = model(&format!(
        "{THREE}key V\ntype 9\nkey Enter\nwait 4000\nkey V\ntype 1\nkey Enter\nkey R\ntype 0\nkey Enter\nkey Esc\nkey Esc"
    ));
    assert_eq!(kept["circles"], model(THREE)["circles"]);
    // A single circle has no skin.
    let one = model("key U\nkey B\ntype 100\nkey Enter\ntype 150\nkey Enter\ntype 40\nkey Enter\nkey E");
    assert_eq!(one["pieces"], json!([]));
}

#[test]
fn circles_are_saved_and_read_again() {
    let kept = run(&sample(
        "VILLA",
        "drag 618 90 561 400\nkey Ctrl+S\ntype TWO\nkey Enter\ndump a.json\nkey Q\nkey N\nkey N\nkey T\ntype TWO\nkey Enter",
    ));
    let (before, after) = (&kept.models["a.json"], &kept.models["end.json"]);
    for name in ["circles", "edges", "unsaved"] {
        assert_eq!(before[name], after[name], "{name}");
    }
    assert_eq!(after["edges"].as_array().map(Vec::len), Some(7));
}

#[test]
fn the_same_chain_in_space() {
    let space = model(&sample("KIGYO", "key F5"));
    assert_eq!(space["spheres"].as_array().map(Vec::len), Some(5));
    assert_eq!(space["spheres"][0], json!([-190.0, -70.0, 0.0, 26.0]));
    assert_eq!(space["admissible"], true);
    let back = model(&sample("KIGYO", "key F5\nkey F5"));
    assert_eq!(back["circles"], model(&sample("KIGYO", ""))["circles"]);
    assert_eq!(model(&sample("VILLA", "key F5"))["chains"].as_array().map(Vec::len), Some(6));
    let raised =
        model(&sample("KIGYO", "key F5\nkey V\ntype 2\nkey Enter\nkey H\ntype -110 -44 30.5\nkey Enter"));
    assert_eq!(raised["spheres"][1], json!([-110.0, -44.0, 30.5, 36.4]));
    let sized = model(&sample("KIGYO", "key F5\nkey V\ntype 2\nkey Enter\nkey R\ntype 12.5\nkey Enter"));
    assert_eq!(sized["spheres"][1][3], json!(12.5));
}

#[test]
fn spheres_are_edited() {
    let snail = |script: &str| model(&sample("CSIGA.GOM", script));
    assert_eq!(snail("key B\ntype 2\nkey Enter")["spheres"][1], json!([1.5, 0.5, 0.25, 1.15]));
    let more = snail("key B\nkey Enter\ntype 9 9 7\nkey Enter\ntype 0.5\nkey Enter");
    assert_eq!(more["spheres"][5], json!([9.0, 9.0, 7.0, 0.5]));
    assert_eq!(snail("key T\ntype 1\nkey Enter")["spheres"].as_array().map(Vec::len), Some(4));
    assert_eq!(snail("key K")["closed"], true);
    let shown = snail("key F6\nkey F7\nkey G\nkey P");
    assert_eq!(
        (&shown["touching"], &shown["filled"], &shown["plain"]),
        (&json!(true), &json!(true), &json!(true))
    );
    let turned = snail("key Right\nwheel 2");
    assert_ne!(turned["angles"], snail("")["angles"]);
    assert_eq!(
        snail("key V\ntype 2\nkey Enter\nkey H\ntype a b c\nkey Enter\nkey Esc\nkey Esc")["unsaved"],
        false
    );
    // A new chain of its own.
    let new = model(
        "key U\nkey F5\nkey B\ntype 0 0 0\nkey Enter\ntype 30\nkey Enter\nkey B\nkey Enter\ntype 100 0 20\nkey Enter\n\
         type 20\nkey Enter",
    );
    assert_eq!(new["spheres"], json!([[0.0, 0.0, 0.0, 30.0], [100.0, 0.0, 20.0, 20.0]]));
    assert_eq!(new["circles"].as_array().map(Vec::len), Some(2));
    assert_eq!(snail("key E\nkey I\nkey Esc")["spheres"].as_array().map(Vec::len), Some(5));
}

#[test]
fn pages_look_as_they_did() {
    for language in ["hu", "en"] {
        for (name, script) in [
            ("new", "key U".to_owned()),
            ("open", sample("KIGYO", "")),
            ("caps", sample("KEZ", "key G\nkey S\nkey M")),
            ("filled", sample("GYURU", "key G\nkey K")),
            ("radical", sample("KIGYO", "key R")),
            ("tree", sample("VILLA", "key G\nkey S\nkey R")),
            ("bad", sample("ROSSZ", "")),
            ("overlapping", sample("ATFEDO", "")),
            ("choice", sample("KIGYO", "key G")),
            ("picking", sample("KIGYO", "key L\nclick 131 330")),
            ("result", sample("KEZ", "key G\nkey S\nkey E\nkey N")),
            ("space", sample("CSIGA.GOM", "key F6")),
            ("space_filled", sample("CSIGA.GOM", "key F7")),
            ("help", "key U\nkey F1".to_owned()),
            ("space_help", sample("CSIGA.GOM", "key F1")),
        ] {
            let kept = run(&format!("lang {language}\n{script}\nwait 4000"));
            pictures::assert_golden(&format!("burkolo_{name}_{language}"), &kept.pictures["end.png"]);
        }
    }
    let held = run(&sample("KIGYO", "move 131 330\npress left\nmove 131 380"));
    pictures::assert_golden("burkolo_held", &held.pictures["end.png"]);
}

#[test]
fn recordings_replay() {
    random::assert_replays(PROGRAM, &random::script(7, random::part(400)));
}

#[test]
fn random_events_do_no_harm() {
    random::storm(PROGRAM, random::SOME);
    random::storm_after(PROGRAM, "key T\ntype VILLA\nkey Enter\n", 200, random::SOME / 3);
    random::storm_after(PROGRAM, "key T\ntype CSIGA.GOM\nkey Enter\n", 200, random::SOME / 3);
}
