//! GR_KZ_X, GR_KZ_O and EG_KZ_K as their user sees them: the originals' screens, our own golden pictures,
//! random input.

mod common;

use grafika::programs::{eg_kz_k, gr_kz_o, gr_kz_x};

use common::reference::Allowance;
use common::{Kept, pictures, play_script, random, reference};
use grafika::machine::{Memory, Script, Settings, play};
use grafika::ui::Program;
use grafika::ui::{Lesson, Words};
use serde_json::{Value, json};

const XOR: Program = gr_kz_x::PROGRAM;
const OR: Program = gr_kz_o::PROGRAM;
const MASKS: Program = eg_kz_k::PROGRAM;

#[test]
fn every_reference_script_gives_the_originals_screen() {
    // The originals' discs are drawn by another routine.
    for (program, prefix, count) in [(XOR, "GR_KZ_X_", 1), (OR, "GR_KZ_O_", 1), (MASKS, "EG_KZ_K_", 3)] {
        reference::assert_screens_within(program, "reference/games", prefix, count, Allowance::Pixels(40));
    }
}

/// The picture of the winking right eye holds only the right button, although its script has the left one
/// down too; with the right one alone ours is the same to the pixel.
#[test]
fn the_right_button_shuts_the_right_eye() {
    let ours = &play_to_end(MASKS, "key Enter\npress right").pictures["end.png"];
    let theirs = common::path("reference/games/EG_KZ_K_smiley_right.png");
    pictures::compare("eg_kz_k_right_eye", ours, &theirs).unwrap();
}

#[test]
fn lessons_fit_on_the_help_page() {
    let lines = [XOR, OR, MASKS].into_iter().flat_map(|program| program.manual.lesson);
    for line in lines {
        if let Lesson::Line(Words(hungarian, english)) = line {
            assert!(hungarian.chars().count() <= 70 && english.chars().count() <= 70, "{hungarian}");
        }
    }
}

fn play_to_end(program: Program, script: &str) -> Kept {
    let script = format!("pointer on\n{script}\ndump end.json\nshot end.png\n");
    play_script(program, Memory::default(), &script)
}

fn place(program: Program, script: &str) -> (i64, i64) {
    let model = &play_to_end(program, script).models["end.json"];
    (model["x"].as_i64().unwrap(), model["y"].as_i64().unwrap())
}

fn ended(program: Program, script: &str) -> bool {
    let mut session = common::session(program, Memory::default(), Settings::default());
    play(&mut session, &Script::parse(script).unwrap(), &mut Kept::default()).unwrap();
    session.ended()
}

#[test]
fn golden_pictures() {
    let cases = [
        (XOR, "gr_kz_x", "move 300 200"),
        (XOR, "gr_kz_x_help", "key F1"),
        (XOR, "gr_kz_x_help_english", "key F1\nkey F2"),
        (OR, "gr_kz_o", "move 300 200"),
        (OR, "gr_kz_o_help", "key F1"),
        (OR, "gr_kz_o_help_english", "key F1\nkey F2"),
        (MASKS, "eg_kz_k_edge", "move 639 0"),
        (MASKS, "eg_kz_k_both_eyes", "key Enter\nmove 300 200\npress left\npress right"),
        (MASKS, "eg_kz_k_help", "key F1"),
        (MASKS, "eg_kz_k_help_english", "key F1\nkey F2"),
    ];
    for (program, name, script) in cases {
        pictures::assert_golden(name, &play_to_end(program, script).pictures["end.png"]);
    }
}

#[test]
fn wherever_the_cursor_has_been_the_background_is_whole() {
    for program in [XOR, OR] {
        let direct = play_to_end(program, "move 400 300");
        let wandered = play_to_end(
            program,
            "move 0 0\nmove 639 479\nmove 405 295\nkey Up\nkey F1\nmove 1 1\nkey Esc\nmove 401 300\nkey Left",
        );
        assert!(direct.pictures["end.png"] == wandered.pictures["end.png"], "{}", program.manual.name);
    }
}

#[test]
fn the_cursor_stays_in_its_range() {
    for program in [XOR, OR] {
        assert_eq!(place(program, ""), (320, 240));
        assert_eq!(place(program, "move 0 0\nkey Left\nkey Up"), (12, 12));
        assert_eq!(place(program, "move 639 479\nkey Right\nkey Down"), (631, 472));
        assert_eq!(place(program, "move 639 479\nkey Left\nkey Left"), (629, 472));
    }
    assert_eq!(place(MASKS, "move 0 0\nkey Left"), (2, 2));
    assert_eq!(place(MASKS, "key Right\nkey Enter\nmove 639 479\nkey Down\nkey Left"), (637, 478));
}

#[test]
fn letters_are_no_arrows() {
    for program in [XOR, OR] {
        assert_eq!(place(program, "type HPKMhpkm"), (320, 240));
    }
}

#[test]
fn buttons_shut_the_eyes_of_the_second_part_only() {
    let model = |script: &str| play_to_end(MASKS, script).models["end.json"].clone();
    let shut =
        |model: &Value| [model["left_shut"].as_bool().unwrap(), model["right_shut"].as_bool().unwrap()];
    assert_eq!(shut(&model("press left")), [false, false]);
    assert_eq!(model("press left")["part"], json!("quarters"));
    assert_eq!(shut(&model("key Enter\npress left")), [true, false]);
    assert_eq!(shut(&model("key Enter\npress left\npress right")), [true, true]);
    assert_eq!(shut(&model("key Enter\npress left\npress right\nrelease left")), [false, true]);
    assert_eq!(shut(&model("press right\nkey Enter\npress middle")), [false, true]);
}

/// The book's text has part 1 go on at the first key; its program waits for Enter.
#[test]
fn in_the_manner_of_today_any_key_ends_the_first_part() {
    let part = |script: &str| play_to_end(MASKS, script).models["end.json"]["part"].clone();
    for key in ["Space", "A", "Enter", "PageDown"] {
        assert_eq!(part(&format!("manner today\nkey {key}")), json!("face"), "{key}");
        let original = if key == "Enter" { "face" } else { "quarters" };
        assert_eq!(part(&format!("key {key}")), json!(original), "{key}");
    }
    for stays in ["key Up", "key F2", "press left", "key F1\nkey A"] {
        assert_eq!(part(&format!("manner today\n{stays}")), json!("quarters"), "{stays}");
    }
    assert!(ended(MASKS, "manner today\nkey Esc"));
}

#[test]
fn each_program_ends_with_its_keys() {
    for program in [XOR, OR, MASKS] {
        assert!(ended(program, "key Esc"));
        assert!(ended(program, "key F1\nclose"));
        assert!(!ended(program, "type q1 x\nkey F1\nkey Esc\nclick 5 5\nkey Up"));
    }
    assert!(!ended(MASKS, "key Enter\nkey Up\nkey F2\npress left"));
    assert!(ended(MASKS, "key Enter\nkey A"));
    assert!(ended(MASKS, "key Enter\nkey Enter"));
}

#[test]
fn a_recorded_session_replays_to_the_same_picture() {
    for program in [XOR, OR, MASKS] {
        let calm: String = random::script(7, random::part(1500))
            .lines()
            .filter(|line| *line != "key Esc")
            .map(|line| format!("{line}\n"))
            .collect();
        random::assert_replays(program, &calm);
    }
}

#[test]
fn random_events_do_no_harm() {
    for program in [XOR, OR, MASKS] {
        random::storm(program, random::MANY);
    }
}
