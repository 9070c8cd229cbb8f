//! The editors in the manner of today: what a user does who has never seen them.

mod common;

use common::{Kept, SharedDisk, pictures, session};
use grafika::machine::{Memory, Script, Settings, Storage, play, sample};
use grafika::programs::{gb_2d_bt, gb_2d_ch, gb_2d_ip, gb_3d_ip, gb_p_2d, zm_hspl};
use grafika::ui::Program;
use serde_json::Value;

const IP: Program = gb_2d_ip::PROGRAM;

/// Plays a script in English in the manner of today.
fn played_on(program: Program, storage: impl Storage + 'static, script: &str) -> Kept {
    let script = Script::parse(&format!("lang en\nmanner today\n{script}dump end.json\n")).unwrap();
    let mut kept = Kept::default();
    let mut session = session(program, storage, script.begun_with(Settings::default()));
    play(&mut session, &script, &mut kept).unwrap();
    kept
}

fn model(program: Program, script: &str) -> Value {
    played_on(program, Memory::default(), script).models["end.json"].clone()
}

fn points(model: &Value) -> Vec<Value> {
    model["points"].as_array().unwrap().clone()
}

const THREE: &str = "key U\nclick 141 350\nclick 241 150\nclick 341 350\n";

#[test]
fn a_click_adds_a_point_and_the_curve_is_there_at_once() {
    let two = model(IP, "key U\nclick 141 350\nclick 241 150\n");
    assert_eq!(points(&two), [serde_json::json!([100.0, 100.0]), serde_json::json!([200.0, 300.0])]);
    assert_eq!(two["visible"], false);
    let three = model(IP, THREE);
    assert_eq!((&three["visible"], &three["method"]), (&Value::from(true), &Value::from("spline")));
    // A click that became a drag puts the point where it is let go.
    let dragged = model(IP, &format!("{THREE}drag 441 350 461 330\n"));
    assert_eq!(points(&dragged)[3], serde_json::json!([420.0, 120.0]));
    // One step of undo for a point; the curve follows.
    let undone = model(IP, &format!("{THREE}key Ctrl+Z\n"));
    assert_eq!((points(&undone).len(), &undone["visible"]), (2, &Value::from(false)));
}

#[test]
fn a_click_on_the_curve_inserts_a_point_between_its_neighbours() {
    // The spline through four points on a line is that line.
    let line = "key U\nclick 141 350\nclick 241 350\nclick 341 350\nclick 441 350\n";
    let inserted = points(&model(IP, &format!("{line}click 291 350\n")));
    assert_eq!(inserted[2], serde_json::json!([250.0, 100.0]));
    assert_eq!(inserted.len(), 5);
}

#[test]
fn delete_takes_the_point_under_the_mouse() {
    let left = model(IP, &format!("{THREE}move 241 150\nkey Delete\n"));
    assert_eq!(points(&left), [serde_json::json!([100.0, 100.0]), serde_json::json!([300.0, 100.0])]);
    let none = model(IP, &format!("{THREE}move 500 400\nkey Delete\n"));
    assert_eq!(points(&none).len(), 3);
}

#[test]
fn the_result_works_with_what_is_shown() {
    let kept = played_on(IP, Memory::default(), &format!("{THREE}key E\nkey Enter\nshot r.png\nkey Esc\n"));
    pictures::assert_golden("today_result", &kept.pictures["r.png"]);
    assert_eq!(kept.models["end.json"]["visible"], true);
    for (program, start) in [(gb_2d_bt::PROGRAM, THREE), (gb_2d_ch::PROGRAM, "key T\nkey Enter\nkey Esc\n")] {
        assert_eq!(model(program, start)["visible"], true, "{}", program.manual.name);
    }
}

#[test]
fn what_a_file_of_1997_cannot_name_is_not_asked_for() {
    // The usual method is not lost, so saving asks for nothing but the name.
    let disk = SharedDisk::default();
    let script = format!("{THREE}key Ctrl+S\ntype ARC\nkey Enter\nwait 10\n");
    let kept = played_on(IP, disk.clone(), &script);
    assert_eq!(disk.names(), ["ARC.IP2"]);
    assert_eq!(kept.models["end.json"]["unsaved"], false);
    // Its name is proposed the next time, and nothing is overwritten by Enter alone.
    let script = format!("{THREE}key Ctrl+S\ntype ARC\nkey Enter\nkey Enter\nwait 10\nkey Esc\n");
    let before = disk.file("ARC.IP2");
    played_on(IP, disk.clone(), &script.replace("341 350", "361 350"));
    assert_eq!(disk.file("ARC.IP2"), before);
}

#[test]
fn files_are_chosen_by_pictures_keys_mouse_and_typing() {
    let disk = SharedDisk::default();
    let mut own = disk.clone();
    own.write("MINE.IP2", sample("C.IP2").unwrap()).unwrap();
    let count = |script: &str| points(&played_on(IP, disk.clone(), script).models["end.json"]).len();
    let c = count("key T\ntype C\nkey Enter\n");
    assert_eq!(count("key T\nkey Enter\n"), c, "files of the folder come first");
    let a = count("key T\ntype A\nkey Enter\n");
    assert_ne!(a, c);
    assert_eq!(count("key T\nkey Right\nkey Enter\n"), a);
    let kept = played_on(IP, disk.clone(), "key T\nmove 220 120\nshot files.png\nclick 220 120\n");
    pictures::assert_golden("today_files", &kept.pictures["files.png"]);
    assert_eq!(points(&kept.models["end.json"]).len(), a);
    // Esc, and a click that cancels, lead back to the question.
    let kept = played_on(IP, disk.clone(), "key T\nclick 540 74\nkey T\nkey Esc\nkey U\n");
    assert_eq!(points(&kept.models["end.json"]).len(), 0);
    // A name that is not there is told.
    let kept = played_on(IP, disk, "key T\ntype NONE\nkey Enter\nshot none.png\n");
    pictures::assert_golden("today_no_file", &kept.pictures["none.png"]);
}

#[test]
fn a_left_drag_beside_the_points_turns() {
    for (program, file) in [(gb_3d_ip::PROGRAM, "A"), (zm_hspl::PROGRAM, "A")] {
        let open = format!("key T\ntype {file}\nkey Enter\n");
        let before = model(program, &open);
        let after = model(program, &format!("{open}drag 560 420 460 320\n"));
        assert_ne!(before["azimuth"], after["azimuth"], "{}", program.manual.name);
        assert_eq!(points(&before), points(&after));
    }
}

#[test]
fn a_double_click_on_a_value_changes_it() {
    let open = "key T\nkey Enter\n";
    let typed = |x, y| format!("{open}click {x} {y}\nclick {x} {y}\ntype 0.7\nkey Enter\n");
    assert_eq!(model(gb_2d_bt::PROGRAM, &typed(60, 8))["bias"], 0.7);
    assert_eq!(model(gb_2d_bt::PROGRAM, &typed(60, 43))["tension"], 0.7);
    // The direction is that of the value.
    assert_eq!(model(zm_hspl::PROGRAM, &typed(360, 473))["k0"][1], 0.7);
    // Coons curves show their coefficient until the next change.
    let coons = "key G\nkey Z\nkey 1\ntype 0.5\nkey Enter\nclick 290 26\nclick 290 26\ntype 0.7\nkey Enter\n";
    assert_eq!(model(IP, &format!("{THREE}{coons}"))["k0"], 0.7);
    // A click alone, and two slow ones, do nothing.
    let slow = format!("{open}click 60 8\nwait 600\nclick 60 8\ntype 0.7\nkey Enter\n");
    assert_eq!(model(gb_2d_bt::PROGRAM, &slow)["bias"], 1.0);
}

#[test]
fn the_first_key_chooses_a_coefficient_and_the_next_one_changes_it() {
    let a1 = |keys: &str| model(gb_p_2d::PROGRAM, &format!("key U\n{keys}"))["a"][1].clone();
    assert_eq!((a1("key Up\n"), a1("key Up\nkey Up\n")), (Value::from(100.0), Value::from(101.0)));
}

#[test]
fn questions_propose_cancel_and_say_which_keys_are_right() {
    let kept = played_on(
        IP,
        Memory::default(),
        &format!("{THREE}key G\nshot question.png\nkey Enter\nshot next.png\n"),
    );
    pictures::assert_golden("today_question", &kept.pictures["question.png"]);
    let cancelled = played_on(IP, Memory::default(), &format!("{THREE}key G\nclick 430 58\n"));
    assert_eq!(cancelled.models["end.json"]["method"], "spline");
    // Y says yes in English.
    let kept = played_on(IP, Memory::default(), &format!("{THREE}key E\nkey Y\nshot points.png\n"));
    let other = played_on(IP, Memory::default(), &format!("{THREE}key E\nkey I\nshot points.png\n"));
    assert!(kept.pictures["points.png"] == other.pictures["points.png"]);
}

#[test]
fn the_manner_of_1997_knows_nothing_of_it() {
    let script = Script::parse("key U\nclick 141 350\ndump end.json\n").unwrap();
    let mut kept = Kept::default();
    play(&mut session(IP, Memory::default(), Settings::default()), &script, &mut kept).unwrap();
    assert_eq!(points(&kept.models["end.json"]).len(), 0);
}

#[test]
fn surfaces_leave_the_program_as_models() {
    for (key, name, begin) in
        [('E', "S.step", "ISO-10303-21"), ('L', "S.stl", ""), ('O', "S.obj", ""), ('Y', "S.ply", "ply")]
    {
        let disk = SharedDisk::default();
        let script = format!(
            "key T\ntype A\nkey Enter\nkey F10\nshot kinds.png\nkey {key}\ntype S\nkey Enter\nwait 10\n"
        );
        let kept = played_on(zm_hspl::PROGRAM, disk.clone(), &script);
        assert_eq!(disk.names(), [name]);
        assert!(disk.file(name).starts_with(begin.as_bytes()), "{name}");
        pictures::assert_golden("today_kinds", &kept.pictures["kinds.png"]);
    }
}
