//! VJS as its user sees it: golden pictures, the motion against its equations, random input.

mod common;

use common::{Kept, pictures, play_script, random};
use grafika::machine::{Memory, Script, Settings, play};
use grafika::programs::vjs::PROGRAM;
use serde_json::{Value, json};

fn play_to_end(script: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{script}\ndump end.json\nshot end.png\n"))
}

fn model(script: &str) -> Value {
    play_to_end(script).models["end.json"].clone()
}

fn pair(model: &Value, name: &str) -> [f64; 2] {
    serde_json::from_value(model[name].clone()).unwrap()
}

fn assert_near(found: [f64; 2], expected: [f64; 2]) {
    let near = |index: usize| (found[index] - expected[index]).abs() < 1e-9;
    assert!(near(0) && near(1), "found {found:?}, expected {expected:?}");
}

/// Takes the handle and holds it 40 to the right and 30 up.
const HOLD: &str = "move 579 419\npress left\nmove 619 389";

#[test]
fn golden_pictures() {
    let cases = [
        ("vjs_start", ""),
        ("vjs_held", "move 579 419\npress left\nmove 619 389\nwait 2000"),
        ("vjs_bounced", "move 579 419\npress left\nmove 559 449\nwait 3000\nrelease left\nwait 2500"),
        ("vjs_english", "key F2\nkey Left\nkey Up\nwait 4321"),
        ("vjs_help", "key F1"),
        ("vjs_help_english", "key F1\nkey F2"),
    ];
    for (name, script) in cases {
        pictures::assert_golden(name, &play_to_end(script).pictures["end.png"]);
    }
}

#[test]
fn a_wait_is_exactly_that_much_motion() {
    for milliseconds in [1u32, 7, 16, 17, 999, 1000, 1234, 2500] {
        let end = model(&format!("{HOLD}\nwait {milliseconds}"));
        let time = f64::from(milliseconds) / 1000.0;
        assert_eq!(end["time"], json!(time));
        assert_eq!(end["acceleration"], json!([40.0, 30.0]));
        assert_near(pair(&end, "velocity"), [40.0 * time, 30.0 * time]);
        assert_near(pair(&end, "position"), [20.0 * time * time, 15.0 * time * time]);
    }
}

#[test]
fn the_motion_does_not_depend_on_how_a_wait_is_cut() {
    let whole = model(&format!("{HOLD}\nwait 60000"));
    let parts = format!("{HOLD}\n{}", "wait 1\nwait 16\nwait 983\n".repeat(60));
    assert_eq!(model(&parts), whole);
    assert_eq!(model(&format!("{HOLD}\n{}", "wait 37\nkey F2\nwait 463\n".repeat(120))), whole);
}

#[test]
fn the_walls_keep_the_energy_for_a_virtual_hour() {
    // Let go with some speed, then an hour of bounces.
    let start = model(&format!("{HOLD}\nwait 2900\nrelease left"));
    let end = model(&format!("{HOLD}\nwait 2900\nrelease left\nwait 3600000"));
    let speeds = |model: &Value| pair(model, "velocity").map(f64::abs);
    assert_eq!(speeds(&end), speeds(&start));
    assert!(pair(&end, "position").into_iter().all(|place| place.abs() <= 200.0));
    // An hour pressed to the walls: v²/2 - a x stays.
    let pressed = model(&format!("{HOLD}\nwait 3600000"));
    for ((place, speed), push) in
        pair(&pressed, "position").into_iter().zip(pair(&pressed, "velocity")).zip([40.0, 30.0])
    {
        assert!((speed * speed / 2.0 - push * place).abs() < 1e-6, "{place} {speed}");
    }
}

#[test]
fn the_handle_is_dragged_in_its_square_and_springs_back() {
    assert_eq!(model("move 579 419\npress left\nmove 0 479")["handle"], json!([-40, -40]));
    assert_eq!(model("drag 579 419 600 400")["handle"], json!([0, 0]));
    assert_eq!(model("move 560 419\npress left\nmove 600 400")["handle"], json!([0, 0]));
    let released = model("move 579 419\npress left\nmove 600 400\nkey Esc");
    assert_eq!((&released["handle"], &released["held"]), (&json!([0, 0]), &json!(false)));
    // A button that is let go on the help page is noticed afterwards.
    assert_eq!(model(&format!("{HOLD}\nkey F1\nrelease left\nkey Esc\nwait 20"))["held"], json!(false));
}

#[test]
fn the_clock_stands_on_the_help_page() {
    assert_eq!(model("wait 500\nkey F1\nwait 5000\nkey F2\nkey Esc\nwait 250")["time"], json!(0.75));
}

#[test]
fn keys_tilt_the_stick_and_start_again() {
    assert_eq!(model("key Up\nkey Left")["handle"], json!([-5, 5]));
    assert_eq!(model(&"key Down\n".repeat(20))["handle"], json!([0, -40]));
    assert_eq!(model("key Up\nkey Home")["acceleration"], json!([0.0, 0.0]));
    assert_eq!(model(&format!("{HOLD}\nkey Left"))["handle"], json!([40, 30]));
    let again = model("key Up\nwait 777\nkey Space\nwait 10");
    assert_eq!((&again["time"], &again["position"]), (&json!(0.01), &json!([0.0, 0.0])));
    assert_eq!(model("type HPKM")["handle"], json!([0, 0]));
}

#[test]
fn it_ends_with_q_or_escape() {
    let ended = |script: &str| {
        let mut session = common::session(PROGRAM, Memory::default(), Settings::default());
        play(&mut session, &Script::parse(script).unwrap(), &mut Kept::default()).unwrap();
        session.ended()
    };
    assert!(ended("key Q") && ended("key q") && ended("key Esc") && ended("close"));
    assert!(!ended(&format!("{HOLD}\nkey Esc")));
    assert!(ended(&format!("{HOLD}\nkey Esc\nkey Esc")));
    assert!(!ended("key Enter\nkey A\nkey Space"));
}

#[test]
fn a_recorded_session_replays_to_the_same_picture() {
    let calm = |line: &&str| !["key Esc", "key Q", "key q", "type q"].contains(line);
    let script: String =
        random::script(11, random::part(3000)).lines().filter(calm).map(|line| format!("{line}\n")).collect();
    random::assert_replays(PROGRAM, &script);
}

#[test]
fn random_events_do_no_harm() {
    random::storm(PROGRAM, random::MANY);
}
