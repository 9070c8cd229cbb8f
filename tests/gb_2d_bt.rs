//! GB_2D_BT as its user sees it: the originals' screens, bias and tension of the curve and of single
//! joints, the critical tension.

mod common;

use common::reference::Allowance;
use common::{Kept, pictures, play_script};
use grafika::machine::Memory;
use grafika::programs::gb_2d_bt::PROGRAM;

#[test]
fn every_reference_script_gives_the_originals_screen() {
    common::reference::assert_screens_within(PROGRAM, "reference/curves", "GB_2D_BT_", 8, Allowance::Curve);
}

/// Four points.
const FOUR: &str =
    "key U\ndrag 618 90 101 350\ndrag 618 90 241 150\ndrag 618 90 381 350\ndrag 618 90 521 150\n";

fn play_four(rest: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{FOUR}{rest}\ndump end.json\nshot end.png\n"))
}

#[test]
fn bias_is_limited_and_tension_is_not() {
    let model = |rest: &str| play_four(rest).models["end.json"].clone();
    assert_eq!(model("type a99\nkey Enter")["bias"], 20.0);
    assert_eq!(model("type a0\nkey Enter")["bias"], 0.05);
    assert_eq!(model("type c-99\nkey Enter")["tension"], -99.0);
    assert_eq!(model("type a5\nkey Enter\nkey Ctrl+Z")["bias"], 1.0);
    // The shape survives a new configuration, as in the original.
    assert_eq!(model("type c3\nkey Enter\ntype qnni\nkey U")["tension"], 3.0);
}

#[test]
fn the_critical_tension_is_explained_and_kept() {
    let kept = play_four("type c-6\nkey Enter\ntype gn");
    assert_eq!(kept.models["end.json"]["tension"], -6.0);
    assert_eq!(kept.models["end.json"]["visible"], false);
    pictures::assert_golden("bt_critical", &kept.pictures["end.png"]);
}

#[test]
fn a_joint_has_a_shape_of_its_own_that_goes_with_its_point() {
    let joint = "key F5\ntype 2\nkey Enter\ntype 3\nkey Enter\ntype 20\nkey Enter\n";
    let kept = play_four(joint);
    assert_eq!(kept.models["end.json"]["joints"][1], serde_json::json!({"bias": 3.0, "tension": 20.0}));
    let kept = play_four(&format!("{joint}type t1\nkey Enter"));
    assert_eq!(kept.models["end.json"]["joints"][0], serde_json::json!({"bias": 3.0, "tension": 20.0}));
    assert_eq!(kept.models["end.json"]["joints"].as_array().unwrap().len(), 3);
    assert!(play_four(&format!("{joint}key F6")).models["end.json"].get("joints").is_none());
}

#[test]
fn shapes_of_joints_are_saved_beside_a_plain_file() {
    let kept = play_four(
        "key F5\ntype 2\nkey Enter\ntype 3\nkey Enter\ntype 20\nkey Enter\n\
         type qijoint\nkey Enter\ntype nitjoint\nkey Enter",
    );
    assert_eq!(kept.models["end.json"]["joints"][1]["tension"], 20.0);
    assert_eq!(kept.models["end.json"]["unsaved"], false);
}

#[test]
fn golden_pictures() {
    let joint = "key F5\ntype 2\nkey Enter\ntype 3\nkey Enter\ntype 20\nkey Enter\n";
    for (name, script) in [
        ("bt_open", "type c2\nkey Enter\ntype gn".to_string()),
        ("bt_joint", format!("{joint}type gz")),
        ("bt_joint_entry", "key F5\ntype 2\nkey Enter\ntype 3".to_string()),
        ("bt_dragged", "type gz\nmove 381 350\npress left\nmove 400 250".to_string()),
        ("bt_help", "key F1".to_string()),
    ] {
        pictures::assert_golden(name, &play_four(&script).pictures["end.png"]);
    }
}

#[test]
fn a_recorded_session_replays_to_the_same_picture() {
    common::random::assert_replays(PROGRAM, &common::random::script(4, common::random::part(3000)));
}

#[test]
fn random_events_do_no_harm() {
    common::random::storm(PROGRAM, common::random::MANY);
}
