//! PH_GORBE as its user sees it: the scripts of its samples, golden pictures, files, random input.

mod common;

use common::{Kept, SharedDisk, pictures, play_script, random, session};
use grafika::machine::{Memory, Script, Settings, play};
use grafika::programs::ph_gorbe::PROGRAM;
use serde_json::Value;

/// Opens a built-in sample in the manner of 1997.
fn opened(name: &str) -> String {
    format!("key T\ntype {name}\nkey Enter\n")
}

fn run(script: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{script}\nshot end.png\ndump end.json\n"))
}

fn own(script: &str) -> Value {
    run(script).models["end.json"]["own"].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn near(value: &Value, wanted: f64, within: f64) {
    assert!((number(value) - wanted).abs() <= within, "{value} is not {wanted}");
}

const NOTHING: Value = Value::Array(Vec::new());
const CAM: &str = "type gz1\n";
const BAY: &str = "type gn1\n";
const ARC: &str = "type gn3\n";

fn cam() -> String {
    opened("K") + CAM
}

fn bay() -> String {
    opened("O") + BAY
}

/// Four points of a curve that turns both ways.
const WAVE: &str = "manner today\nkey U\nclick 100 300\nclick 200 200\nclick 300 300\nclick 400 180\n";

/// The file with tangents is chosen from the list of the manner of today.
fn arc() -> String {
    format!("manner today\n{}{ARC}", opened("T.IC2"))
}

#[test]
fn the_cam_is_safe_up_to_its_smallest_radius() {
    let model = own(&cam());
    near(&model["length"], 866.479834, 1e-6);
    near(&model["energy"], 0.047615, 1e-6);
    near(&model["offset_limits"][1], 95.4977, 1e-4);
    for d in ["20", "90", "-30"] {
        let model = own(&format!("{}key P\ntype {d}\nkey Enter", cam()));
        let offset = &model["offsets"][0];
        assert_eq!((&offset["cusps"], &offset["crossings"]), (&NOTHING, &NOTHING));
        near(
            &offset["length"],
            866.479834 - number(&Value::from(d.parse::<f64>().unwrap())) * std::f64::consts::TAU,
            1e-6,
        );
    }
}

#[test]
fn the_bay_has_two_cusps_and_a_loop() {
    let model = own(&format!("{}key P\ntype 60\nkey Enter", bay()));
    near(&model["length"], 790.301522, 1e-6);
    near(&model["offset_limits"][0], -56.9210, 1e-4);
    near(&model["offset_limits"][1], 51.2589, 1e-4);
    let offset = &model["offsets"][0];
    assert_eq!(offset["cusps"].as_array().map(Vec::len), Some(2));
    assert_eq!(offset["crossings"].as_array().map(Vec::len), Some(1));
    let wanted = [[0.0, 0.0, 2.0, 0.7119], [3.0, 0.2413, 4.0, 1.0]];
    for (kept, wanted) in offset["kept"].as_array().unwrap().iter().zip(wanted) {
        for (k, wanted) in wanted.into_iter().enumerate() {
            near(&kept[k], wanted, 1e-4);
        }
    }
}

#[test]
fn the_arc_is_a_ph_cubic_whose_offset_vanishes() {
    let model = own(&format!("{}key P\ntype 60\nkey Enter", arc()));
    near(&model["length"], 193.776408, 1e-6);
    near(&model["offset_limits"][1], 82.6297, 1e-4);
    assert_eq!(model["offsets"][0]["crossings"], NOTHING);
    let swallowtail = own(&format!("{}key P\ntype 95\nkey Enter", arc()));
    let offset = &swallowtail["offsets"][0];
    near(&offset["cusps"][0]["u"], 0.248887, 1e-6);
    near(&offset["cusps"][1]["u"], 0.751113, 1e-6);
    near(&offset["kept"][0][3], 0.025648, 1e-6);
    near(&offset["kept"][1][1], 0.974352, 1e-6);
    let nothing = own(&format!("{}key P\ntype 120\nkey Enter", arc()));
    assert_eq!(nothing["offsets"][0]["kept"], NOTHING);
}

#[test]
fn the_offset_is_dragged_and_turned_by_the_wheel() {
    // The first point of the bay is at (101, 330), its offset 20 to the left.
    let turned = own(&format!("{}wheel 3\nkey PageDown\nkey .", bay()));
    near(&turned["distance"], 22.1, 1e-12);
    let script = format!("{}key P\ntype -40\nkey Enter\n", cam());
    // To the right of the cam's lowest point, (311, 390).
    let dragged = own(&format!("{script}drag 311 430 311 442\n"));
    assert!((number(&dragged["distance"]) + 52.0).abs() < 1.5, "{}", dragged["distance"]);
    let both = own(&format!("{}type pm", bay()));
    assert_eq!(both["offsets"].as_array().map(Vec::len), Some(2));
    let none = own(&format!("{}type pn", bay()));
    assert_eq!(none["offsets"], NOTHING);
}

#[test]
fn without_a_ph_cubic_the_quintic_is_offered() {
    let kept = run(&format!("{WAVE}type gn3i\n"));
    assert_eq!(kept.models["end.json"]["method"], "phhermite");
    assert_eq!(kept.models["end.json"]["tangents"].as_array().map(Vec::len), Some(4));
    let refused = run(&format!("{WAVE}type gn1gn3n\n"));
    assert_eq!(refused.models["end.json"]["method"], "phspline");
}

#[test]
fn formulas_are_dumped_in_full() {
    let model = own(&bay());
    let spans = model["spans"].as_array().unwrap();
    assert_eq!(spans.len(), 5);
    for span in spans {
        let h = number(&span["h"]);
        for (w, end) in [(&span["w"][0], 0), (&span["w"][2], 4)] {
            let [m, n] = [number(&w[0]), number(&w[1])];
            near(&span["speed"][end], h * (m * m + n * n), 1e-9);
            near(&span["hodograph"][end][0], h * (m * m - n * n), 1e-9);
            near(&span["hodograph"][end][1], 2.0 * h * m * n, 1e-9);
        }
    }
}

#[test]
fn equal_neighbours_are_refused_by_their_names() {
    let kept = run(&format!("manner today\nlang en\nkey T\ntype D.IP2\nkey Enter\n{CAM}"));
    assert!(kept.models["end.json"]["own"]["refused"].as_str().unwrap().contains("points 2 and 3"));
    pictures::assert_golden("ph_gorbe_refused_en", &kept.pictures["end.png"]);
}

#[test]
fn knots_are_chosen_among_all_and_undone() {
    let uniform = run(&format!("{}key F4\nkey 2", opened("A") + CAM));
    let chord = run(&(opened("A") + CAM));
    let length = |kept: &Kept| number(&kept.models["end.json"]["own"]["length"]);
    assert!((length(&chord) - 1660.283).abs() < 1e-3 && length(&uniform) != length(&chord));
    let undone = run(&format!("{}key F4\nkey 2\nkey Ctrl+Z", opened("A") + CAM));
    assert_eq!(length(&undone), length(&chord));
}

#[test]
fn the_path_is_saved_for_a_machine() {
    let disk = SharedDisk::default();
    let script = format!("{}key F7\nkey Backspace\ntype 0.5\nkey Enter\nkey I\ndump end.json", bay());
    let mut kept = Kept::default();
    let script = Script::parse(&script).expect("the test's script is right");
    play(&mut session(PROGRAM, disk.clone(), Settings::default()), &script, &mut kept).expect("all is taken");
    let program = String::from_utf8(disk.file("O.NC")).expect("it is text");
    assert!(program.starts_with("G21 G90\nG0 X"), "{program}");
    assert_eq!(kept.models["end.json"]["own"]["unit"], 0.5);
}

#[test]
fn tangents_are_saved_and_read_again() {
    let kept = run(&format!(
        "{}type gn2\nkey Ctrl+S\ntype TWO\nkey Enter\nkey Q\nkey N\nkey N\ndump saved.json\n",
        opened("O")
    ));
    assert_eq!(kept.models["end.json"]["tangents"].as_array().map(Vec::len), Some(6));
}

#[test]
fn a_tool_travels_at_a_constant_feed() {
    let kept = run(&format!("{}key J\nkey Enter\nwait 3000\nkey Space", bay()));
    pictures::assert_golden("ph_gorbe_travel_hu", &kept.pictures["end.png"]);
    let ended = own(&format!("{}key J\nkey 5\nkey 0\nkey Enter\nwait 500\nkey +\nkey Esc", bay()));
    near(&ended["feed"], 62.5, 1e-9);
}

#[test]
fn the_page_of_space_has_frames_and_pipes() {
    let kept = play_script(
        PROGRAM,
        Memory::default(),
        "manner today\nkey T\nkey Esc\nkey Esc\nkey F8\nkey T\ntype H.IP3\nkey Enter\nkey K\nkey P\ntype 10\nkey Enter\nshot end.png\ndump end.json\n",
    );
    let model = &kept.models["end.json"];
    assert_eq!(model["points"].as_array().map(Vec::len), Some(3), "{model}");
    assert_eq!(model["own"]["radius"], 10.0);
}

#[test]
fn pages_look_as_they_did() {
    for language in ["hu", "en"] {
        for (name, script) in [
            ("cam", format!("{}type pm", cam())),
            ("loop", format!("{}type p60\nkey Enter", bay())),
            ("vanished", format!("{}type p120\nkey Enter", arc())),
            ("distance", format!("{}type p", bay())),
            ("methods", format!("{}type gn", opened("O"))),
            ("no_cubic", format!("{WAVE}type gn3")),
            ("speed", format!("{}type s\nmove 300 430", bay())),
            ("comb", format!("{}type k\nmove 291 280", bay())),
            ("solutions", format!("{}type gn2\nkey F4", opened("O"))),
            ("knots", format!("{}type gz1\nkey F4", opened("O"))),
            ("compare", format!("{}key F5", bay())),
            ("formula", format!("{}key F6", bay())),
            ("unit", format!("{}key F7", bay())),
            ("result", format!("{}type en", bay())),
            ("help", "key F1".to_owned()),
            ("today", format!("manner today\nkey T\ntype O.IP2\nkey Enter\n{BAY}")),
        ] {
            let manner = if name == "today" { "" } else { "manner 1997\n" };
            let kept = run(&format!("lang {language}\n{manner}{script}"));
            pictures::assert_golden(&format!("ph_gorbe_{name}_{language}"), &kept.pictures["end.png"]);
        }
    }
}

#[test]
fn recordings_replay() {
    random::assert_replays(PROGRAM, &random::script(11, random::part(1500)));
}

#[test]
fn random_events_do_no_harm() {
    random::storm(PROGRAM, random::SOME);
}
