//! GB_2D_IP as its user sees it: the originals' screens, our own golden pictures, random input.

mod common;

use common::reference::Allowance;
use common::{Kept, pictures, play_script};
use grafika::machine::{Memory, Storage};
use grafika::programs::gb_2d_ip::PROGRAM;

#[test]
fn every_reference_script_gives_the_originals_screen() {
    common::reference::assert_screens_within(PROGRAM, "reference/curves", "GB_2D_IP_", 30, Allowance::Curve);
}

/// Six points in a new configuration.
const SIX: &str = "key U\ntype b1\nkey Enter\ntype 60\nkey Enter\ntype 80\nkey Enter\n\
    drag 618 90 161 150\ndrag 618 90 261 110\ndrag 618 90 361 330\ndrag 618 90 461 390\ndrag 618 90 561 170\n";

fn play_six(rest: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{SIX}{rest}\ndump end.json\nshot end.png\n"))
}

fn points(kept: &Kept) -> Vec<[f64; 2]> {
    serde_json::from_value(kept.models["end.json"]["points"].clone()).unwrap()
}

#[test]
fn golden_pictures() {
    let cases = [
        ("ip_points", ""),
        ("ip_spline_closed", "type gz3"),
        ("ip_coons", "type gn1.5\nkey Enter"),
        ("ip_bezier_closed", "type gz2"),
        ("ip_compared", "type gz3\nkey F4\ntype 1245\nkey Enter"),
        ("ip_compared_result", "type gz3\nkey F4\ntype 1245\nkey Enter\ntype ei"),
        ("ip_dragged", "type gz3\nmove 361 330\npress left\nmove 400 300"),
        ("ip_followed", "key F3\ntype gz3\ndrag 361 330 400 300\nwait 2500"),
        ("ip_help", "key F1"),
        ("ip_help_english", "key F1\nkey F2"),
        ("ip_question_english", "key Q\nkey F2"),
        ("ip_message", "key E"),
        ("ip_overshoot", "type gz1-9\nkey Enter"),
    ];
    for (name, script) in cases {
        pictures::assert_golden(name, &play_six(script).pictures["end.png"]);
    }
}

#[test]
fn a_golden_picture_can_fail_and_says_where() {
    let mut screen = play_six("").pictures["end.png"].clone();
    screen.bar(100, 200, 104, 203, grafika::screen::Color::Red);
    let golden = common::path("golden/ip_points.png");
    let message = pictures::compare("a_golden_picture_can_fail", &screen, &golden).unwrap_err();
    assert!(message.contains("20 pixels differ, all within (100,200)-(104,203)"), "{message}");
}

#[test]
fn points_are_dragged_out_of_the_store_over_the_field_and_off_it() {
    let kept = play_six("drag 361 330 300 200\ndrag 101 370 615 300");
    let expected = [[120.0, 300.0], [220.0, 340.0], [259.0, 250.0], [420.0, 60.0], [520.0, 280.0]];
    assert_eq!(points(&kept), expected);
}

#[test]
fn the_topmost_disc_is_taken_and_escape_puts_it_back() {
    let kept = play_six("drag 161 150 261 115\nmove 261 112\npress left\nmove 50 300\nkey Esc\nrelease left");
    assert_eq!(points(&kept)[2], [220.0, 340.0]);
    let kept = play_six("drag 161 150 261 115\ndrag 261 112 50 300");
    assert_eq!(points(&kept)[2], [9.0, 150.0]);
}

#[test]
fn every_change_is_undone_and_redone() {
    let changed = "drag 361 330 300 200\ntype t1\nkey Enter\ntype v1\nkey Enter\ntype s3\nkey Enter\n";
    let undo = "key Ctrl+Z\n".repeat(3);
    let before = points(&play_six(""));
    let after = points(&play_six(changed));
    assert_ne!(before, after);
    assert_eq!(points(&play_six(&format!("{changed}{undo}"))), before);
    assert_eq!(points(&play_six(&format!("{changed}{undo}{}", "key Ctrl+Y\n".repeat(3)))), after);
    let nothing = points(&play_six(&"key Ctrl+Z\n".repeat(50)));
    assert!(nothing.is_empty());
}

#[test]
fn escape_cancels_every_question_and_entry() {
    let before = points(&play_six(""));
    for question in [
        "b",
        "b2\nkey Enter\ntype ",
        "v",
        "v1\nkey Enter\ntype ",
        "v1\nkey Enter\ntype s",
        "v1\nkey Enter\ntype h5",
        "t",
        "g",
        "gn",
        "gn1",
        "gn4",
        "q",
        "qi",
        "qia",
        "qn",
    ] {
        let kept = play_six(&format!("type {question}\nkey Esc\nkey Esc\nkey Esc\ntype t6\nkey Enter"));
        assert_eq!(points(&kept), before[..5], "{question:?}");
    }
}

#[test]
fn nonsense_in_numbers_is_asked_for_again() {
    let kept = play_six(
        "type v1abc\nkey Enter\ntype h\ntype 1234567890123456789012345678901234567890\nkey Enter\ntype x--5\nkey Enter\ntype 7\nkey Enter",
    );
    assert_eq!(points(&kept)[0], [123.0, 7.0]);
}

#[test]
fn special_keys_are_never_letters() {
    let keys = "Up Down Left Right Home End PageUp PageDown Insert F5 F7 F8 F9 Tab";
    let script: String = keys.split(' ').map(|key| format!("key {key}\n")).collect();
    assert_eq!(points(&play_six(&script)), points(&play_six("")));
}

#[test]
fn a_saved_configuration_is_loaded_again() {
    let kept = play_six("type qisix\nkey Enter\ntype ni\ndump empty.json\ntype tsix\nkey Enter");
    assert!(kept.models["empty.json"]["points"].as_array().unwrap().is_empty());
    assert_eq!(points(&kept), points(&play_six("")));
    assert_eq!(kept.models["end.json"]["unsaved"], false);
}

#[test]
fn a_wrong_file_is_refused_and_nothing_is_lost() {
    let mut disk = Memory::default();
    disk.write("SHORT.IP2", &[0; 1299]).unwrap();
    let script = "type tshort\nkey Enter\nshot message.png\nkey U\ndrag 618 90 161 150\ndump end.json";
    let kept = play_script(PROGRAM, disk, script);
    assert_eq!(points(&kept), [[120.0, 300.0]]);
    pictures::assert_golden("ip_wrong_file", &kept.pictures["message.png"]);
}

#[test]
fn a_full_disk_is_told_and_the_points_are_still_there() {
    let mut kept = Kept::default();
    let script = format!("{SIX}type qisix\nkey Enter\nshot message.png\nkey Esc\ndump end.json");
    let script = grafika::machine::Script::parse(&script).unwrap();
    let mut session = common::session(PROGRAM, common::Refusing::default(), Default::default());
    grafika::machine::play(&mut session, &script, &mut kept).unwrap();
    assert_eq!(points(&kept), points(&play_six("")));
    assert_eq!(kept.models["end.json"]["unsaved"], true);
    pictures::assert_golden("ip_full_disk", &kept.pictures["message.png"]);
}

#[test]
fn closing_with_unsaved_changes_asks_first() {
    let ended = |rest: &str| {
        let mut session = common::session(PROGRAM, Memory::default(), Default::default());
        let script = grafika::machine::Script::parse(&format!("{SIX}{rest}")).unwrap();
        grafika::machine::play(&mut session, &script, &mut Kept::default()).unwrap();
        session.ended()
    };
    assert!(!ended("close"));
    assert!(!ended("close\nclose\nclose"));
    assert!(ended("close\nkey N"));
    assert!(!ended("close\nkey Esc"));
    assert!(ended("close\ntype isix\nkey Enter"));
    assert!(ended("type qisix\nkey Enter\ntype nn\nclose"));
    assert!(!ended("type gn1\nclose"));
    assert!(ended("type gn1\nclose\nkey N"));
}

/// Plays a script with the editor opened on a document, as the command line opens it.
fn play_opened(document: grafika::file::Document, script: &str) -> Kept {
    let mut kept = Kept::default();
    let script = grafika::machine::Script::parse(script).unwrap();
    let machine = grafika::machine::Machine::new(Box::new(Memory::default()), Default::default());
    let mut session = common::session_on(PROGRAM, machine, Some(document));
    grafika::machine::play(&mut session, &script, &mut kept).unwrap();
    kept
}

/// The noisy measurement of section 2.3.8.
fn measurement() -> grafika::file::Document {
    let bytes = std::fs::read(common::path("../data/Y.IP2")).unwrap();
    grafika::file::Document::read(grafika::file::Format::Ip2, &bytes).unwrap()
}

#[test]
fn the_workshop_shows_the_smoothed_points() {
    let kept = play_opened(measurement(), "key F5\nshot hu.png\nkey F2\nshot en.png");
    pictures::assert_golden("ip_workshop", &kept.pictures["hu.png"]);
    pictures::assert_golden("ip_workshop_english", &kept.pictures["en.png"]);
}

#[test]
fn the_workshop_takes_the_smoothed_points_over_in_one_change() {
    let script = "dump before.json\nkey F5\nkey Enter\ndump taken.json\nkey Ctrl+Z\ndump undone.json\n\
        key Ctrl+Z\nkey Ctrl+Y\ndump end.json";
    let kept = play_opened(measurement(), script);
    assert_eq!(kept.models["undone.json"], kept.models["before.json"]);
    assert_eq!(kept.models["taken.json"], kept.models["end.json"]);
    assert_eq!(kept.models["taken.json"]["unsaved"], true);
    let grafika::file::Document::PlanePoints(measured) = measurement() else { panic!() };
    let smoothed = grafika::geometry::smooth(&measured.points, Default::default()).unwrap();
    let rounded: Vec<[f64; 2]> = smoothed.points.iter().map(|p| p.map(f64::round_ties_even)).collect();
    assert_eq!(points(&kept), rounded);
}

#[test]
fn the_workshop_left_by_escape_leaves_everything_as_it_was() {
    // A closed curve that follows, and curves compared with it.
    let before = "key F3\ntype gz3\nkey F4\ntype 14\nkey Enter\nwait 5000\n";
    let left = play_six(&format!("{before}key F5\ntype t1\nkey Esc"));
    let never = play_six(before);
    assert_eq!(left.models["end.json"], never.models["end.json"]);
    assert_eq!(left.png("end.png"), never.png("end.png"));
}

#[test]
fn the_workshop_needs_points_and_can_be_closed_from() {
    let kept =
        play_script(PROGRAM, Memory::default(), "key U\nkey F5\nshot end.png\nkey Enter\ndump end.json");
    pictures::assert_golden("ip_workshop_empty", &kept.pictures["end.png"]);
    assert!(points(&kept).is_empty());
    let mut session = common::session(PROGRAM, Memory::default(), Default::default());
    let script = format!("{SIX}key F4\ntype 1\nkey Enter\nkey F5\nclose\nkey Esc\ndump end.json");
    let script = grafika::machine::Script::parse(&script).unwrap();
    let mut kept = Kept::default();
    grafika::machine::play(&mut session, &script, &mut kept).unwrap();
    assert!(!session.ended());
    assert_eq!(kept.models["end.json"]["compared"], serde_json::json!(["coons"]));
}

#[test]
fn measured_points_are_opened_from_csv_with_their_fractions() {
    let csv = "x,y\n0,10.5\n100.25,20\n200,15.125\n300,25\n";
    let document = grafika::file::Document::from_csv(csv).unwrap();
    assert!((PROGRAM.start)(Some(document.clone())).is_ok());
    let kept = play_opened(document, "dump end.json\nkey F5\nkey Enter\ndump taken.json");
    assert_eq!(points(&kept), [[0.0, 10.5], [100.25, 20.0], [200.0, 15.125], [300.0, 25.0]]);
    let smoothed = grafika::geometry::smooth(&points(&kept), Default::default()).unwrap().points;
    let rounded: Vec<[f64; 2]> = smoothed.iter().map(|point| point.map(f64::round_ties_even)).collect();
    assert_eq!(kept.models["taken.json"]["points"], serde_json::json!(rounded));
    let outside = grafika::file::Document::from_csv("x,y\n0,0\n561,0\n2,2\n").unwrap();
    assert!((PROGRAM.start)(Some(outside.clone())).is_err());
}

#[test]
fn a_recorded_session_replays_to_the_same_picture() {
    let script = common::random::script(7, common::random::part(3000));
    common::random::assert_replays(PROGRAM, &script);
}

#[test]
fn random_events_do_no_harm() {
    common::random::storm(PROGRAM, common::random::MANY);
}
