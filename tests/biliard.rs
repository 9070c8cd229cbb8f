//! BILIARD as its user sees it: the originals' screens, shots, undo, replay, points, saved games, random input.

mod common;

use common::{Kept, pictures, play_script};
use grafika::machine::{Memory, Script, Storage, play};
use grafika::programs::biliard::PROGRAM;
use serde_json::Value;

#[test]
fn every_reference_script_gives_the_originals_screen() {
    common::reference::assert_screens(PROGRAM, "reference/games", "BILIARD_", 3);
}

#[test]
fn the_start_has_the_originals_pixels() {
    let kept = run("pointer on\nmove 60 240");
    let theirs = pictures::read(&common::path("reference/games/BILIARD_start_mouse_on_ball1.png"));
    let difference = pictures::difference(kept.pictures["end.png"].pixels(), &theirs);
    assert_eq!(difference, None);
}

fn run(script: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{script}\nshot end.png\ndump end.json\n"))
}

/// The last picture's model.
fn model(script: &str) -> Value {
    run(script).models["end.json"].clone()
}

/// Numbers of a ball: x, y, and the velocity's x and y.
fn ball(model: &Value, index: usize) -> [f64; 4] {
    let ball = &model["table"]["balls"][index];
    let number = |name: &str, axis: usize| ball[name][axis].as_f64().unwrap();
    [number("at", 0), number("at", 1), number("velocity", 0), number("velocity", 1)]
}

/// The shot of the book's table of numbers: velocity (300, 0).
const SHOT: &str = "drag 60 240 360 240\n";
/// A break from a little above the middle.
const BREAK: &str = "drag 60 240 560 246\n";

#[test]
fn the_books_shot_agrees_up_to_the_first_hit() {
    let text = std::fs::read_to_string(common::path("reference/games/biliard_shot1.csv")).unwrap();
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    let script: String = (1..=36).map(|step| format!("wait 31\ndump {step}.json\n")).collect();
    let kept = run(&format!("{SHOT}{script}"));
    let hit = (1..rows.len()).find(|&step| rows[step][7] != 0.0).unwrap();
    assert!(hit > 30);
    for (step, row) in rows.iter().enumerate().take(hit).skip(1) {
        let model = &kept.models[&format!("{step}.json")];
        for index in 0..11 {
            let [x, y, vx, vy] = ball(model, index);
            let theirs = &row[1 + 4 * index..5 + 4 * index];
            for (a, b) in [x, y, vx, -vy].iter().zip(theirs) {
                assert!((a - b).abs() < 0.01, "step {step}, ball {index}: {a} {b}");
            }
        }
    }
}

#[test]
fn the_break_is_the_same_bytes_twice() {
    let dump = || model(&format!("{BREAK}wait 60000")).to_string();
    assert_eq!(dump(), dump());
    // However the time is cut into pieces.
    let pieces = format!("{BREAK}{}wait 59000", "wait 1\n".repeat(1000));
    assert_eq!(model(&pieces).to_string(), dump());
}

#[test]
fn balls_come_to_rest_and_enter_goes_there_at_once() {
    let waited = model(&format!("{BREAK}wait 200000"));
    assert_eq!(waited["rolling"], false);
    assert_eq!(model(&format!("{BREAK}wait 777\nkey Enter")), waited);
}

#[test]
fn golden_pictures() {
    let cases = [
        ("biliard_aimed", "move 60 240\npress left\nmove 420 262"),
        ("biliard_aimed_at_neighbour", "move 414 232\npress left\nmove 450 90"),
        ("biliard_aimed_weakly", "move 60 240\npress left\nmove 64 250"),
        ("biliard_without_line", "key A\nmove 60 240\npress left\nmove 420 262"),
        ("biliard_rolling", "drag 60 240 560 246\nwait 2000"),
        ("biliard_points", "key P\ndrag 60 240 560 246\nkey Enter"),
        ("biliard_spin", "key S\nkey P\nkey Right\nwheel 2\nmove 60 240\npress left\nmove 300 100"),
        ("biliard_replay", "drag 60 240 560 246\nkey Enter\nkey R\nwait 5000"),
        ("biliard_english", "key F2\nkey P\nkey S"),
        ("biliard_end", "key Q"),
        ("biliard_help", "key F1"),
        ("biliard_help_english", "key F1\nkey F2"),
        ("biliard_today", "manner today"),
        ("biliard_today_aimed", "manner today\nmove 60 240\npress left\nmove 420 262"),
        ("biliard_today_rolling", "lang en\nmanner today\nkey T\ndrag 60 240 560 246\nwait 2000"),
        ("biliard_today_blue", "manner today\nkey T\nkey T\nmove 60 240\npress left\nmove 460 240"),
    ];
    for (name, script) in cases {
        pictures::assert_golden(name, &run(script).pictures["end.png"]);
    }
}

#[test]
fn no_shot_without_a_drag() {
    let start = model("");
    for script in [
        "click 60 240",
        "drag 60 240 61 240",
        "drag 200 200 300 300",
        "drag 60 240 300 300 right",
        "move 60 240\npress left\nmove 300 240\nkey Esc\nrelease left",
        "move 60 240\npress left\nmove 300 240\nmove 60 240\nrelease left",
        "move 60 240\npress left\nmove 300 240\nkey F1\nrelease left\nkey Esc\nmove 310 240",
    ] {
        assert_eq!(model(&format!("{script}\nwait 100")), start, "{script}");
    }
}

#[test]
fn a_click_ends_the_motion_in_the_manner_of_today() {
    let rest = model(&format!("{BREAK}wait 200000"));
    assert_eq!(model(&format!("manner today\n{BREAK}wait 500\nclick 320 100")), rest);
    assert_eq!(model(&format!("{BREAK}wait 500\nclick 320 100"))["rolling"], true);
    // The click that ended it is no grip on a ball.
    assert_eq!(model(&format!("manner today\n{BREAK}wait 500\ndrag 414 232 300 300")), rest);
}

#[test]
fn balls_keep_their_colours_on_any_cloth() {
    let colors = |script: &str| {
        let picture = &run(script).pictures["end.png"];
        [(60, 240), (400, 240), (428, 240), (442, 264)].map(|(x, y)| picture.pixel(x, y))
    };
    let white = colors("");
    assert_eq!(white, colors("key T"));
    assert_eq!(white, colors("key T\nkey T"));
    let cloth = |script: &str| run(script).pictures["end.png"].pixel(200, 100);
    assert_ne!(cloth(""), cloth("key T"));
    assert_eq!(cloth(""), cloth("key T\nkey T\nkey T"));
}

#[test]
fn any_ball_is_taken_anywhere_on_its_disc() {
    // The ghost's way counts from the ball's centre, wherever it was taken.
    let rim = model("drag 56 246 360 240\nwait 31");
    assert_eq!(ball(&rim, 0), ball(&model(&format!("{SHOT}wait 31")), 0));
    let other = model("drag 446 262 500 300\nwait 31");
    assert_eq!(ball(&other, 10)[2..], [58.0 * 0.998, 36.0 * 0.998]);
}

#[test]
fn the_ghost_stays_on_the_cloth() {
    let model = model("drag 60 240 639 0\nwait 31");
    assert_eq!(ball(&model, 0)[2..], [541.0 * 0.998, -202.0 * 0.998]);
}

#[test]
fn shots_are_undone_and_redone() {
    let first = format!("{BREAK}key Enter\n");
    let second = format!("{first}drag 442 264 300 300\nkey Enter\n");
    let [start, one] = [model(""), model(&first)];
    // A ball may have rolled away from there; then the second drag is no shot.
    assert_ne!(start, one);
    assert_eq!(model(&format!("{first}key Ctrl+Z")), start);
    assert_eq!(model(&format!("{first}key Ctrl+Z\nkey Ctrl+Y")), one);
    assert_eq!(model(&format!("{second}{}", "key Ctrl+Z\n".repeat(5))), start);
    assert_eq!(model(&format!("{BREAK}wait 500\nkey Ctrl+Z")), start, "a shot in motion is stopped");
}

#[test]
fn the_replay_shows_the_shot_four_times_slower() {
    let before = format!("{BREAK}wait 200000\n");
    let at_rest = model(&before);
    let replayed = run(&format!("{before}key R\nwait 4000"));
    let played = run(&format!("{BREAK}wait 1000"));
    assert_eq!(replayed.models["end.json"]["table"], played.models["end.json"]["table"]);
    assert_eq!(model(&format!("{before}key R\nwait 4000\nkey Enter")), at_rest);
    assert_eq!(model(&format!("{before}key R\nwait 4000\nkey Esc")), at_rest);
    assert_eq!(model(&format!("{before}key R\nwait 800000")), at_rest);
    assert_eq!(model("key R"), model(""));
}

#[test]
fn points_are_for_balls_beyond_the_first() {
    let after = model("key P\ndrag 60 240 60 300\nkey Enter");
    assert_eq!(after["game"]["points"], serde_json::json!({ "scores": [0, 0], "turn": 1 }));
    let after = model(&format!("key P\n{BREAK}key Enter"));
    let points = &after["game"]["points"];
    let score = points["scores"][0].as_u64().unwrap();
    assert!(score > 0, "{points}");
    assert_eq!(points["turn"], 0);
    assert_eq!(after["unsaved"], true);
}

#[test]
fn spin_bends_the_way_and_is_only_for_rough_balls() {
    let way = |keys: &str| ball(&model(&format!("{keys}drag 60 240 60 60\nkey Enter")), 0);
    assert_eq!(way(""), way("key Right\nkey Right\n"));
    assert_eq!(way("")[0], 60.0);
    assert_ne!(way("key S\nkey Right\n")[0], 60.0);
    assert_ne!(way("key S\nkey Right\n"), way("key S\nkey Left\n"));
}

#[test]
fn a_saved_game_is_loaded_again() {
    let played = format!("key P\n{BREAK}key Enter\nkey Ctrl+S\ntype break\nkey Enter\n");
    let kept = run(&format!(
        "{played}dump saved.json\nkey N\nkey I\ndump new.json\nkey Ctrl+O\ntype break\nkey Enter"
    ));
    assert_eq!(kept.models["saved.json"]["unsaved"], false);
    assert_ne!(kept.models["new.json"]["game"], kept.models["saved.json"]["game"]);
    assert_eq!(kept.models["end.json"], kept.models["saved.json"]);
}

#[test]
fn a_wrong_file_is_refused_and_nothing_is_lost() {
    let good = serde_json::to_string(&model(&format!("{BREAK}key Enter"))["game"]).unwrap();
    let wrong = [
        "".to_string(),
        "{}".to_string(),
        good.replacen("\"balls\":[", "\"balls\":[[1e999,0],", 1),
        good.replacen("\"balls\":[", "\"balls\":[[60,240],", 1),
        good.replacen("\"ball\":0", "\"ball\":99", 1),
        good.replacen("[60.0,240.0]", "[400.0,240.0]", 1),
        good.replacen("\"points\":null", "\"points\":{\"scores\":[0,0],\"turn\":7}", 1),
    ];
    let start = model("");
    for content in wrong {
        assert_ne!(content, good);
        let mut disk = Memory::default();
        disk.write("X.JSON", content.as_bytes()).unwrap();
        let kept = play_script(PROGRAM, disk, "key Ctrl+O\ntype x\nkey Enter\nkey Esc\nkey N\ndump end.json");
        assert_eq!(kept.models["end.json"], start, "{content}");
    }
}

#[test]
fn the_end_is_asked_for_and_points_are_not_lost() {
    let ended = |script: &str| {
        let mut session = common::session(PROGRAM, Memory::default(), Default::default());
        let script = Script::parse(script).unwrap();
        play(&mut session, &script, &mut Kept::default()).unwrap();
        session.ended()
    };
    assert!(ended("close"));
    assert!(ended("key Q\nkey I") && ended("key Esc\nkey I"));
    assert!(!ended("key Q\nkey N") && !ended("key Q\nkey Esc"));
    let points = format!("key P\n{BREAK}");
    assert!(!ended(&format!("{points}close")) && !ended(&format!("{points}close\nclose")));
    assert!(ended(&format!("{points}close\nkey N")) && !ended(&format!("{points}close\nkey Esc")));
    assert!(ended(&format!("{points}close\nkey I\ntype game\nkey Enter")));
    assert!(!ended(&format!("{points}key Q\nkey I")) && ended(&format!("{points}key Q\nkey I\nkey N")));
}

#[test]
fn a_recorded_session_replays_to_the_same_picture() {
    common::random::assert_replays(PROGRAM, &common::random::script(7, common::random::part(3000)));
    common::random::assert_replays(PROGRAM, &format!("{BREAK}wait 1234\nkey R\nwait 999\n"));
}

#[test]
fn random_events_do_no_harm() {
    common::random::storm(PROGRAM, common::random::MANY);
}
