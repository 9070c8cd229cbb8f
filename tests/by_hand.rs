//! The editors in the manner of today by keys, wheel and potentiometers, and the aids that show how a curve comes from
//! its points.

mod common;

use common::{Kept, SharedDisk, pictures, session};
use grafika::machine::{Script, Settings, Storage, play, sample};
use grafika::programs::{f_p_bets, f_p_hspl, gb_2d_bt, gb_2d_ch, gb_2d_ip, gb_3d_ip};
use grafika::ui::Program;
use serde_json::{Value, json};

/// Plays a script on a sample in the manner of today, and returns what it kept with the disk.
fn played(program: Program, name: &str, script: &str) -> (Kept, SharedDisk) {
    let mut disk = SharedDisk::default();
    disk.write(name, sample(name).unwrap()).unwrap();
    let stem = name.split('.').next().unwrap();
    let script = format!("lang en\nmanner today\nkey T\ntype {stem}\nkey Enter\n{script}dump end.json\n");
    let script = Script::parse(&script).unwrap();
    let mut kept = Kept::default();
    let mut session = session(program, disk.clone(), script.begun_with(Settings::default()));
    play(&mut session, &script, &mut kept).unwrap();
    (kept, disk)
}

fn model(program: Program, name: &str, script: &str) -> Value {
    played(program, name, script).0.models["end.json"].clone()
}

const IP: Program = gb_2d_ip::PROGRAM;
const BT: Program = gb_2d_bt::PROGRAM;

#[test]
fn tab_chooses_a_point_and_the_arrows_move_it() {
    let start = model(IP, "O.IP2", "");
    let [x, y] = [0, 1].map(|d| start["points"][1][d].as_f64().unwrap());
    let moved = model(IP, "O.IP2", "key Tab\nkey Tab\nkey Right\nkey Right\nkey Up\n");
    assert_eq!(moved["points"][1], json!([x + 2.0, y + 1.0]));
    assert_eq!(moved["chosen"], "point 2");
    let fast = model(IP, "O.IP2", "key Tab\nkey Tab\npress shift\nkey Left\nrelease shift\n");
    assert_eq!(fast["points"][1], json!([x - 10.0, y]));
    // One undo takes the whole row back; another choice begins another row.
    let undone = model(IP, "O.IP2", "key Tab\nkey Tab\nkey Right\nkey Right\nkey Up\nkey Ctrl+Z\n");
    assert_eq!(undone["points"], start["points"]);
    let rows = "key Tab\nkey Up\nkey Up\nkey Tab\nkey Up\nkey Ctrl+Z\n";
    assert_eq!(
        model(IP, "O.IP2", rows)["points"][0][1],
        json!(start["points"][0][1].as_f64().unwrap() + 2.0)
    );
    // The last Tab chooses nothing, and Esc lets go.
    let count = start["points"].as_array().unwrap().len();
    assert_eq!(model(IP, "O.IP2", &"key Tab\n".repeat(count + 1)).get("chosen"), None);
    assert_eq!(model(IP, "O.IP2", "key Tab\nkey Esc\nkey Right\n")["points"], start["points"]);
    // A point stays in the field.
    let edge = format!("key Tab\n{}", "press shift\nkey Left\nrelease shift\n".repeat(60));
    assert_eq!(model(IP, "O.IP2", &edge)["points"][0][0], 0.0);
}

#[test]
fn tips_of_tangents_are_chosen_after_their_points() {
    let script = "key Esc\nkey Tab\nkey Tab\nkey Up\n";
    let [before, after] = ["key Esc\n", script].map(|script| model(gb_2d_ch::PROGRAM, "A.IC2", script));
    assert_eq!(after["chosen"], "tangent 1");
    assert_eq!(after["tangents"][0][1].as_f64().unwrap(), before["tangents"][0][1].as_f64().unwrap() + 2.0);
    assert_eq!(after["points"], before["points"]);
}

#[test]
fn a_letter_keeps_a_point_in_space_to_an_axis() {
    let program = gb_3d_ip::PROGRAM;
    let start = model(program, "A.IP3", "");
    let moved = model(program, "A.IP3", "key Tab\nkey Z\nkey Up\nkey Up\n");
    let place = |model: &Value| [0, 1, 2].map(|d| model["points"][0][d].as_f64().unwrap());
    let [x, y, z] = place(&start);
    assert_eq!(place(&moved), [x, y, z + 2.0]);
    // Dragged, too: wherever the mouse goes. The disc of the point lies where the picture of 1997 has it.
    let (picture, _) = played(program, "A.IP3", "key Tab\nshot s.png\n");
    pictures::assert_golden("by_hand_space", &picture.pictures["s.png"]);
    let dragged = |keys: &str| {
        let script = format!("move 262 305\npress left\nmove 270 300\n{keys}move 260 300\nrelease left\n");
        place(&model(program, "A.IP3", &script))
    };
    let free = dragged("");
    let along = dragged("key Z\n");
    assert!(free != [x, y, z] && (free[0] != x || free[1] != y), "{free:?}");
    assert_eq!([along[0], along[1]], [x, y]);
    assert_ne!(along[2], z);
    assert_eq!(dragged("key Z\nkey Z\n"), free);
}

#[test]
fn wheel_keys_and_potentiometer_turn_bias_and_tension() {
    let of = |script: &str| {
        let model = model(BT, "K.IP2", script);
        [&model["bias"], &model["tension"]].map(|value| value.as_f64().unwrap())
    };
    assert_eq!(of("move 60 44\nwheel 2\n"), [1.0, 1.0]);
    assert_eq!(of("move 60 8\nkey Up\nkey PageUp\n"), [1.2, 0.0]);
    assert_eq!(of("move 60 44\npress shift\nwheel -1\nrelease shift\n"), [1.0, -0.05]);
    // The knob of the tension is in the middle of its track.
    assert_eq!(of("drag 114 51 191 51\n"), [1.0, 20.0]);
    // One undo takes a row of turns back, and another the drag before it.
    assert_eq!(of("drag 114 51 191 51\nmove 60 44\nwheel -1\nwheel -1\nkey Ctrl+Z\n"), [1.0, 20.0]);
    // A joint of its own for the chosen point.
    let joint = model(BT, "K.IP2", "key Tab\nmove 60 44\nwheel 4\n");
    assert_eq!((&joint["tension"], &joint["joints"][0]["tension"]), (&json!(0.0), &json!(2.0)));
    assert_eq!(joint["joints"][1]["tension"], 0.0);
    // In the manner of 1997 there is no potentiometer.
    let old = model(BT, "K.IP2", "manner 1997\nmove 60 44\nwheel 2\nkey PageUp\nkey Tab\nkey Up\n");
    assert_eq!((&old["bias"], &old["tension"], old.get("chosen")), (&json!(1.0), &json!(0.0), None));
    let (picture, _) = played(BT, "K.IP2", "key Tab\nmove 60 44\nwheel 4\nshot s.png\n");
    pictures::assert_golden("by_hand_beta", &picture.pictures["s.png"]);
}

/// The values of surfaces have potentiometers under the picture.
#[test]
fn the_values_of_a_surface_are_turned_too() {
    let of = |program: Program, name: &str, key: &str, script: &str| -> [f64; 2] {
        serde_json::from_value(model(program, name, script)[key].clone()).unwrap()
    };
    for surface in ["", "type ft\n"] {
        let tension = |script: &str| of(f_p_bets::PROGRAM, "Z.FBS", "tension", &format!("{surface}{script}"));
        let [along_u, along_v] = tension("drag 343 466 383 466\n");
        assert!(along_u > 10.0 && along_v == 0.0, "{along_u} {along_v}");
        assert_eq!(tension("drag 343 466 383 466\nkey Ctrl+Z\n"), [0.0; 2]);
        assert_eq!(tension("move 480 474\nwheel 2\nkey PageUp\n"), [0.0, 1.5]);
        // While the knob is held, the surface follows it.
        let held = "move 343 466\npress left\nmove 383 466\nshot held.png\n";
        assert_ne!(tension(&format!("{held}release left\n")), [0.0; 2]);
        assert_eq!(tension(&format!("{held}key Esc\nrelease left\n")), [0.0; 2]);
        let k0 = format!("{surface}move 125 474\nwheel -4\n");
        assert_eq!(of(f_p_hspl::PROGRAM, "A.FPS", "k0", &k0).map(|it| (it * 100.0).round()), [30.0, 50.0]);
    }
}

#[test]
fn k0_is_turned_while_the_curve_is_a_coons_curve() {
    let coons = "key G\nkey N\nkey 1\ntype 0.5\nkey Enter\n";
    assert_eq!(model(IP, "O.IP2", &format!("{coons}move 280 26\nwheel 3\n"))["k0"], 0.8);
    assert_eq!(model(IP, "O.IP2", "move 280 26\nwheel 3\nkey PageUp\n")["k0"], 0.5);
    // Tangents of the user's own are not turned away, automatic ones follow.
    let own = model(gb_2d_ch::PROGRAM, "A.IC2", "key Esc\n");
    let turned = model(gb_2d_ch::PROGRAM, "A.IC2", "key Esc\nkey PageUp\n");
    assert_eq!(own["tangents"], turned["tangents"]);
    let automatic = "key Esc\nkey G\nkey N\nkey I\nkey N\ntype 0.5\nkey Enter\n";
    let [half, more] =
        ["", "key PageUp\n"].map(|then| model(gb_2d_ch::PROGRAM, "A.IC2", &format!("{automatic}{then}")));
    assert_eq!((&half["k0"], &more["k0"]), (&json!(0.5), &json!(0.6)));
    assert_ne!(half["tangents"], more["tangents"]);
}

#[test]
fn polygon_hull_weights_joints_and_comb_are_shown_and_leave_as_a_figure() {
    let (kept, disk) = played(
        IP,
        "O.IP2",
        "key K\nkey K\nmove 192 150\nkey W\nkey J\nkey Space\nshot s.png\nkey F10\nkey Enter\nkey Enter\nkey Enter\nkey Enter\nkey Enter\n",
    );
    let aids = &kept.models["end.json"]["aids"];
    assert_eq!(*aids, json!({"polygon": "hull", "weights": true, "joints": "contact"}));
    pictures::assert_golden("by_hand_aids", &kept.pictures["s.png"]);
    let svg = String::from_utf8(disk.file("gb_2d_ip-1.svg")).unwrap();
    let plain = played(IP, "O.IP2", "key F10\nkey Enter\nkey Enter\nkey Enter\nkey Enter\nkey Enter\n").1;
    let plain = String::from_utf8(plain.file("gb_2d_ip-1.svg")).unwrap();
    let lines = |svg: &str| svg.matches("stroke-dasharray").count();
    assert!(lines(&svg) >= lines(&plain) + 5, "the polygon has five sides");
    assert!(svg.contains(">C2<") && !plain.contains(">C2<"));
    let comb = model(IP, "O.IP2", "key J\nkey J\n");
    assert_eq!(comb["aids"]["joints"], "comb");
    assert_eq!(
        model(IP, "O.IP2", "key K\nkey K\nkey K\nkey J\nkey J\nkey J\nkey W\nkey W\n").get("aids"),
        None
    );
    let (kept, _) = played(
        gb_3d_ip::PROGRAM,
        "A.IP3",
        "key K\nkey K\nkey Tab\nkey W\nkey J\nkey J\nkey Space\nshot s.png\n",
    );
    pictures::assert_golden("by_hand_space_aids", &kept.pictures["s.png"]);
}

#[test]
fn several_values_of_a_parameter_are_shown_together() {
    let (kept, disk) = played(
        BT,
        "K.IP2",
        "key G\nkey Z\nkey F4\nkey Tab\nkey Enter\ntype 2 5, 20\nkey Enter\nshot s.png\n\
         key F10\nkey Enter\nkey Enter\nkey Enter\nkey Enter\nkey Enter\n",
    );
    assert_eq!(
        kept.models["end.json"]["series"],
        json!({"parameter": "tension", "values": [2.0, 5.0, 20.0]})
    );
    pictures::assert_golden("by_hand_series", &kept.pictures["s.png"]);
    let svg = String::from_utf8(disk.file("gb_2d_bt-1.svg")).unwrap();
    assert!(["tension=2", "tension=5", "tension=20"].iter().all(|name| svg.contains(name)));
    // A wrong value is told and asked for again; nothing ends the series.
    let again = model(BT, "K.IP2", "key F4\nkey C\ntype 2 x\nkey Enter\nkey Space\nkey Esc\n");
    assert_eq!(again.get("series"), None);
    let coons = model(IP, "O.IP2", "key F4\nkey 6\ntype 0.3 1\nkey Enter\n");
    assert_eq!(coons["series"], json!({"parameter": "k0", "values": [0.3, 1.0]}));
}

#[test]
fn points_and_values_of_nets_are_changed_by_keys_too() {
    let program = grafika::programs::zm_betsp::PROGRAM;
    let start = model(program, "K2.ZMB", "");
    let moved = model(program, "K2.ZMB", "key Tab\nkey Tab\nkey Z\nkey Up\nkey Up\n");
    let z = |model: &Value| model["points"][0][1][2].as_f64().unwrap();
    assert_eq!(z(&moved), z(&start) + 2.0);
    let turned = model(program, "K2.ZMB", "key PageUp\nkey PageUp\nmove 300 474\nwheel 3\n");
    assert_eq!((&turned["bias"], &turned["tension"]), (&json!([1.2, 1.0]), &json!([1.5, 0.0])));
    let undone = model(program, "K2.ZMB", "move 300 474\nwheel 3\nkey Ctrl+Z\n");
    assert_eq!(undone["tension"], json!([0.0, 0.0]));
    let (kept, _) = played(program, "K2.ZMB", "key F\nkey D\nmove 300 474\nwheel 12\nshot s.png\n");
    pictures::assert_golden("by_hand_net", &kept.pictures["s.png"]);
}

#[test]
fn tab_and_arrows_change_the_prepared_answer() {
    let closed = |keys: &str| model(BT, "K.IP2", &format!("key G\n{keys}key Enter\n"))["closed"].clone();
    assert_eq!(
        [closed(""), closed("key Tab\n"), closed("key Tab\nkey Tab\n")],
        [false, true, false].map(Value::from)
    );
    assert_eq!(closed("key Right\n"), true);
}

#[test]
fn a_chosen_point_is_let_go_when_it_may_be_another_one() {
    let count = |model: &Value| model["points"].as_array().unwrap().len();
    let start = model(IP, "O.IP2", "");
    let deleted = model(IP, "O.IP2", "key Tab\nkey Tab\nkey Tab\nkey T\ntype 1\nkey Enter\nkey Up\n");
    assert_eq!((count(&deleted), deleted.get("chosen")), (5, None));
    assert_eq!(deleted["points"].as_array().unwrap()[..], start["points"].as_array().unwrap()[1..]);
    // Delete takes the chosen point, where nothing is under the mouse.
    let deleted = model(IP, "O.IP2", "move 600 80\nkey Tab\nkey Tab\nkey Delete\n");
    assert_eq!((count(&deleted), &deleted["points"][1]), (5, &start["points"][2]));
    // Undo that takes the chosen point away lets it go.
    let undone = model(
        IP,
        "O.IP2",
        "click 300 400\nkey Tab\nkey Tab\nkey Tab\nkey Tab\nkey Tab\nkey Tab\nkey Tab\nkey Ctrl+Z\n",
    );
    assert_eq!((count(&undone), undone.get("chosen")), (6, None));
    // Shift belongs to the row that one undo takes back.
    let row = "key Tab\nkey Right\npress shift\nkey Right\nrelease shift\nkey Right\nkey Ctrl+Z\n";
    assert_eq!(model(IP, "O.IP2", row)["points"], start["points"]);
    // What the weights cover cannot be clicked.
    assert_eq!(count(&model(IP, "O.IP2", "key W\nkey Space\nclick 102 440\n")), 6);
    assert_eq!(count(&model(IP, "O.IP2", "click 102 440\n")), 7);
}

#[test]
fn what_changes_nothing_begins_no_row_of_changes() {
    // At the edge of the field an arrow does nothing; the next one can be undone alone.
    let edge = format!("key Tab\n{}", "press shift\nkey Left\nrelease shift\n".repeat(7));
    let there = model(IP, "O.IP2", &edge);
    assert_eq!(there["points"][0][0], 0.0);
    let back =
        model(IP, "O.IP2", &format!("{edge}key Tab\nkey Esc\nkey Tab\nkey Left\nkey Right\nkey Ctrl+Z\n"));
    assert_eq!(back["points"], there["points"]);
    // A knob that is dragged begins a change of its own.
    let turned = "move 60 44\nwheel 1\ndrag 114 51 191 51\nmove 60 44\nwheel -1\nkey Ctrl+Z\n";
    assert_eq!(model(BT, "K.IP2", turned)["tension"], 20.0);
}

#[test]
fn handles_between_whole_numbers_are_kept_whatever_the_method_is() {
    // A click on an arc divides it; its handles lie between whole numbers, and an .IP2 file cannot hold them.
    let arcs = "key G\nkey N\nkey 5\nclick 205 238\nkey G\nkey N\nkey 3\nkey Ctrl+S\n";
    let (kept, disk) = played(
        IP,
        "O.IP2",
        &format!(
            "click 560 200\n{arcs}type NEW\nkey Enter\nwait 10\nkey Enter\nwait 10\nkey Enter\nwait 10\n"
        ),
    );
    let points = kept.models["end.json"]["points"].as_array().unwrap();
    let whole =
        points.iter().flat_map(|point| point.as_array().unwrap()).all(|x| x.as_f64().unwrap().fract() == 0.0);
    assert!(!whole, "{points:?}");
    assert_eq!(kept.models["end.json"]["unsaved"], false);
    assert!(disk.names().iter().any(|name| name == "NEW.JSON"), "{:?}", disk.names());
}
