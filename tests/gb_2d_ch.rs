//! GB_2D_CH as its user sees it: the originals' screens, tangents by mouse and number, its two files.

mod common;

use common::reference::Allowance;
use common::{Kept, pictures, play_script, storage};
use grafika::machine::{Memory, Storage};
use grafika::programs::gb_2d_ch::PROGRAM;

#[test]
fn every_reference_script_gives_the_originals_screen() {
    common::reference::assert_screens_within(PROGRAM, "reference/curves", "GB_2D_CH_", 15, Allowance::Curve);
}

/// Three points with automatic tangents, k0 = 0.5, open.
const THREE: &str =
    "key U\ndrag 618 90 141 350\ndrag 618 90 291 150\ndrag 618 90 441 350\ntype in.5\nkey Enter\n";

fn play_three(rest: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{THREE}{rest}\ndump end.json\nshot end.png\n"))
}

fn tangents(kept: &Kept) -> Vec<[f64; 2]> {
    serde_json::from_value(kept.models["end.json"]["tangents"].clone()).unwrap()
}

#[test]
fn automatic_tangents_are_half_the_way_between_the_neighbours() {
    assert_eq!(tangents(&play_three("")), [[75.0, 100.0], [150.0, 0.0], [75.0, -100.0]]);
    assert_eq!(tangents(&play_three("type gn\ntype iz1\nkey Enter"))[0], [-150.0, 200.0]);
}

#[test]
fn a_tip_is_dragged_and_the_point_wins_over_it() {
    // The tip of the second tangent stands half its length to the right of the point.
    let kept = play_three("drag 366 150 391 100\nkey N");
    assert_eq!(tangents(&kept)[1], [200.0, 100.0]);
    let kept = play_three("type v2\nkey Enter\ntype eh0\nkey Enter\nkey N\ndrag 291 150 291 250\nkey N");
    assert_eq!(tangents(&kept)[1], [0.0, 0.0]);
    assert_eq!(kept.models["end.json"]["points"][1], serde_json::json!([250.0, 200.0]));
}

#[test]
fn length_and_direction_by_number() {
    assert_eq!(tangents(&play_three("type v1\nkey Enter\ntype eh250\nkey Enter\nkey N"))[0], [150.0, 200.0]);
    assert_eq!(tangents(&play_three("type v2\nkey Enter\ntype es90\nkey Enter\nkey N"))[1], [0.0, 150.0]);
    // Numbers out of range become the nearest end; Esc changes nothing.
    assert_eq!(tangents(&play_three("type v2\nkey Enter\ntype es999\nkey Enter\nkey N"))[1], [150.0, -3.0]);
    assert_eq!(tangents(&play_three("type v2\nkey Enter\ntype eh9\nkey Esc\nkey N"))[1], [150.0, 0.0]);
}

#[test]
fn every_change_is_undone() {
    let changed =
        "drag 366 150 391 100\nkey N\ntype v1\nkey Enter\ntype es0\nkey Enter\nkey N\ntype t3\nkey Enter\n";
    let before = play_three("");
    let undone = play_three(&format!("{changed}{}", "key Ctrl+Z\n".repeat(3)));
    assert_eq!(tangents(&undone), tangents(&before));
    assert_eq!(undone.models["end.json"]["points"], before.models["end.json"]["points"]);
}

#[test]
fn points_and_tangents_are_saved_and_loaded() {
    let kept =
        play_three("drag 366 150 391 100\nkey N\ntype qitwo\nkey Enter\ntype nittwo\nkey Enter\nkey N");
    assert_eq!(tangents(&kept)[1], [200.0, 100.0]);
    assert_eq!(kept.models["end.json"]["unsaved"], false);
}

#[test]
fn a_missing_twin_means_automatic_tangents_and_says_so() {
    let mut disk = storage("reference/curves", &["CH.IC2"]);
    assert!(disk.find("CH.EC2").is_none());
    let kept = play_script(PROGRAM, disk.clone(), "type tch\nkey Enter\nshot end.png\nkey N\ndump end.json");
    assert_eq!(tangents(&kept)[1], [100.0, 35.0]);
    pictures::assert_golden("ch_no_twin", &kept.pictures["end.png"]);
    disk.write("CH.EC2", &[0; 7]).unwrap();
    let kept = play_script(PROGRAM, disk, "type tch\nkey Enter\nkey N\ndump end.json");
    assert_eq!(tangents(&kept)[1], [100.0, 35.0]);
}

#[test]
fn golden_pictures() {
    for (name, script) in [
        ("ch_curve", "type gn\nkey N"),
        ("ch_tip_held", "type gz\nkey N\nmove 366 150\npress left\nmove 391 100"),
        ("ch_angle", "type v2\nkey Enter\ntype es4"),
        ("ch_help", "key F1\nkey F2"),
    ] {
        pictures::assert_golden(name, &play_three(script).pictures["end.png"]);
    }
}

#[test]
fn a_recorded_session_replays_to_the_same_picture() {
    common::random::assert_replays(PROGRAM, &common::random::script(3, common::random::part(3000)));
}

#[test]
fn random_events_do_no_harm() {
    common::random::storm(PROGRAM, common::random::MANY);
}
