//! CSOMO as its user sees it: knots, points and marks by mouse and key, files, golden pictures, random input.

mod common;

use common::{Kept, SharedDisk, pictures, play_script, random, session, session_on};
use grafika::file::Document;
use grafika::machine::{Machine, Memory, Script, Settings, play};
use grafika::programs::csomo::PROGRAM;
use grafika::ui::Program;
use serde_json::{Value, json};

/// Opens a built-in sample in the manner of 1997.
fn opened(name: &str) -> String {
    format!("key T\ntype {name}\nkey Enter\n")
}

fn run(script: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{script}\nshot end.png\ndump end.json\n"))
}

fn model(script: &str) -> Value {
    run(script).models["end.json"].clone()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap_or_else(|| panic!("{value}")).iter().map(|x| x.as_f64().unwrap()).collect()
}

/// The pixel column of a value of A.CSM's knots, 0 to 16.2, 8 pixels from either end of 560.
fn column(knot: f64) -> i32 {
    41 + (8.0 + knot / 16.2 * 544.0).round() as i32
}

/// Drags a knot of A.CSM.
fn dragged(from: f64, to: f64) -> String {
    format!("drag {} 452 {} 452\n", column(from), column(to))
}

fn same(value: &Value, wanted: &[f64], within: f64) {
    let found = numbers(value);
    assert_eq!(found.len(), wanted.len(), "{value}");
    assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() <= within), "{value} is not {wanted:?}");
}

const KNOTS: [f64; 17] =
    [0.0, 1.2, 2.2, 3.0, 4.2, 5.2, 6.0, 7.2, 8.2, 9.0, 10.2, 11.2, 12.0, 13.2, 14.2, 15.0, 16.2];

#[test]
fn a_sample_opens_with_its_knots() {
    let model = model(&opened("A"));
    same(&model["knots"], &KNOTS, 0.0);
    assert_eq!((&model["order"], &model["ends"], &model["curve"]), (&json!(4), &json!("open"), &json!(true)));
    assert_eq!(model["inflections"], 3);
    assert_eq!(model["ratio"], 0.75);
    assert_eq!(model["unsaved"], false);
}

#[test]
fn a_knot_is_dragged_and_stops_at_its_neighbours() {
    let moved = model(&(opened("A") + &dragged(8.2, 8.6)));
    let knots = numbers(&moved["knots"]);
    assert!((knots[8] - 8.6).abs() < 0.03 && knots[7] == 7.2 && knots[9] == 9.0, "{knots:?}");
    assert_eq!((&moved["knot"], &moved["unsaved"]), (&json!(8), &json!(true)));
    let stopped = numbers(&model(&(opened("A") + &dragged(8.2, 12.5)))["knots"]);
    assert_eq!(stopped[8], 9.0);
    let undone = model(&(opened("A") + &dragged(8.2, 8.6) + "key Ctrl+Z\n"));
    same(&undone["knots"], &KNOTS, 0.0);
    let redone = model(&(opened("A") + &dragged(8.2, 12.5) + "key Ctrl+Z\nkey Ctrl+Y\n"));
    assert_eq!(numbers(&redone["knots"])[8], 9.0);
}

#[test]
fn equal_knots_move_together_or_apart() {
    let double = opened("A") + &dragged(8.2, 12.5);
    // The lowest triangle of the stack at 9 takes both copies.
    let both = numbers(&model(&format!("{double}{}", dragged(9.0, 9.6)))["knots"]);
    assert!(both[8] == both[9] && (both[8] - 9.6).abs() < 0.03, "{both:?}");
    // The higher one goes alone.
    let (from, to) = (column(9.0), column(9.6));
    let apart = numbers(&model(&format!("{double}drag {from} 442 {to} 442\n"))["knots"]);
    assert!(apart[8] == 9.0 && (apart[9] - 9.6).abs() < 0.03, "{apart:?}");
    let back = numbers(&model(&format!("{double}drag {from} 442 {} 442\n", column(8.4)))["knots"]);
    assert!(back[9] == 9.0 && (back[8] - 8.4).abs() < 0.03, "{back:?}");
}

#[test]
fn with_shift_the_picture_goes_on_but_the_knot_stays() {
    let from = column(8.2);
    let script = format!("{}key P\npress shift\nmove {from} 450\npress left\nmove 420 450\n", opened("A"));
    let held = run(&format!("lang en\n{script}"));
    pictures::assert_golden("csomo_beyond_en", &held.pictures["end.png"]);
    let released = numbers(&model(&format!("{script}release left\nrelease shift\n"))["knots"]);
    assert_eq!(released[8], 9.0);
    same(&model(&format!("{script}key Esc\nrelease left\n"))["knots"], &KNOTS, 0.0);
}

#[test]
fn the_wheel_moves_a_knot_a_little() {
    let over = format!("{}move {} 450\n", opened("A"), column(8.2));
    let step = 16.2 / 16.0 / 100.0;
    let turned = numbers(&model(&format!("{over}wheel 3\n"))["knots"]);
    assert!((turned[8] - 8.2 - 3.0 * step).abs() < 1e-9, "{turned:?}");
    let fine = numbers(&model(&format!("{over}press ctrl\nwheel -2\nrelease ctrl\nwheel 1\n"))["knots"]);
    assert!((fine[8] - 8.2 - 0.8 * step).abs() < 1e-9, "{fine:?}");
}

#[test]
fn u_is_set_in_the_strip_and_on_the_curve() {
    let in_strip = model(&format!("{}click {} 380\n", opened("A"), column(6.6)));
    assert!((in_strip["u"].as_f64().unwrap() - 6.6).abs() < 0.02, "{}", in_strip["u"]);
    let outside = model(&format!("{}click {} 380\n", opened("A"), column(0.5)));
    assert_eq!(outside["u"], 3.0);
    let dragged = model(&format!("{}drag {} 380 {} 400\n", opened("A"), column(6.6), column(9.5)));
    assert!((dragged["u"].as_f64().unwrap() - 9.5).abs() < 0.02, "{}", dragged["u"]);
    // Between points 3 and 4, where the curve is.
    let on_curve = model(&format!("{}drag 262 283 140 176\n", opened("A")));
    let u = on_curve["u"].as_f64().unwrap();
    assert!((3.0..5.0).contains(&u), "{u}");
    same(&on_curve["knots"], &KNOTS, 0.0);
}

#[test]
fn points_are_dragged_added_and_deleted_with_their_knots() {
    let moved = model(&format!("{}drag 61 270 71 260\n", opened("A")));
    assert_eq!(moved["points"][0], json!([30.0, 70.0]));
    let added = model(&format!("{}drag 618 90 561 180\n", opened("A")));
    assert_eq!(added["points"][13], json!([520.0, 150.0]));
    assert_eq!(numbers(&added["knots"]).len(), 18);
    let clicked = model(&format!("manner today\n{}click 311 100\n", opened("A.CSM")));
    assert_eq!(clicked["points"][13], json!([270.0, 230.0]));
    let deleted = model(&format!("{}drag 61 270 61 30\n", opened("A")));
    assert_eq!(deleted["points"].as_array().map(Vec::len), Some(12));
    assert_eq!(numbers(&deleted["knots"]).len(), 16);
    let here = model(&format!("{}move 61 270\nkey Delete\n", opened("A")));
    assert_eq!(here["points"], deleted["points"]);
}

#[test]
fn a_new_curve_begins_with_its_order() {
    let three = "manner today\nkey U\nclick 100 300\nclick 200 200\nclick 300 300\n";
    let kept = run(&format!("lang en\n{three}"));
    assert_eq!(kept.models["end.json"]["curve"], false);
    assert_eq!(numbers(&kept.models["end.json"]["knots"]).len(), 7);
    pictures::assert_golden("csomo_three_points_en", &kept.pictures["end.png"]);
    let four = model(&format!("{three}click 400 180\n"));
    assert_eq!(four["curve"], true);
    same(&four["knots"], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0], 0.0);
    let back = model(&format!("{three}click 400 180\nkey Ctrl+Z\n"));
    assert_eq!(back["curve"], false);
    // Nothing that needs a curve does harm before there is one.
    let idle =
        model(&format!("{three}key A\nkey F\nkey P\nkey U\nkey L\nkey F6\nkey F7\nkey F8\nkey E\nkey Tab\n"));
    assert_eq!(idle["points"].as_array().map(Vec::len), Some(3));
}

#[test]
fn numbers_change_points_knots_and_weights() {
    let point =
        model(&format!("{}type vp1\nkey Enter\ntype h50\nkey Enter\ntype 90\nkey Enter\n", opened("A")));
    assert_eq!(point["points"][0], json!([50.0, 90.0]));
    let renumbered = model(&format!("{}type vp1\nkey Enter\ntype s3\nkey Enter\n", opened("A")));
    assert_eq!(renumbered["points"][2], json!([20.0, 60.0]));
    let knot = model(&format!("{}type vc8\nkey Enter\ntype 8.5\nkey Enter\n", opened("A")));
    assert_eq!(numbers(&knot["knots"])[8], 8.5);
    let too_far = model(&format!("{}type vc8\nkey Enter\ntype 88\nkey Enter\n", opened("A")));
    assert_eq!(numbers(&too_far["knots"])[8], 9.0);
    let weight = model(&format!("{}type vs2\nkey Enter\ntype 3\nkey Enter\n", opened("A")));
    assert_eq!(numbers(&weight["weights"])[1], 3.0);
}

#[test]
fn knots_and_points_are_inserted_and_deleted() {
    let point =
        model(&format!("{}type bp2\nkey Enter\ntype 30\nkey Enter\ntype 99\nkey Enter\n", opened("A")));
    assert_eq!(point["points"][1], json!([30.0, 99.0]));
    let knot = model(&format!("{}type bc6.5\nkey Enter\n", opened("A")));
    let knots = numbers(&knot["knots"]);
    assert!(knots.len() == 18 && knots.contains(&6.5), "{knots:?}");
    let again = model(&format!("{}type bc6.5\nkey Enter\ntype tc7\nkey Enter\ntype i\n", opened("A")));
    same(&again["knots"], &KNOTS, 1e-12);
    let kept = run(&format!("lang en\n{}type tc8\nkey Enter\n", opened("A")));
    pictures::assert_golden("csomo_delete_knot_en", &kept.pictures["end.png"]);
    let no = model(&format!("{}type tc8\nkey Enter\ntype n\n", opened("A")));
    same(&no["knots"], &KNOTS, 0.0);
    let removed = model(&format!("{}type tp13\nkey Enter\n", opened("A")));
    assert_eq!(removed["points"].as_array().map(Vec::len), Some(12));
    // The first knot is no knot inside the domain.
    let refused = model(&format!("{}type tc0\nkey Enter\n", opened("A")));
    same(&refused["knots"], &KNOTS, 0.0);
}

#[test]
fn order_and_ends_are_chosen() {
    let clamped = model(&format!("{}type g4\nkey Enter\ntype r\n", opened("A")));
    assert_eq!(clamped["ends"], "clamped");
    assert_eq!(numbers(&clamped["knots"])[..4], [3.0; 4]);
    let closed = model(&format!("{}type g3\nkey Enter\ntype z\n", opened("A")));
    assert_eq!((&closed["ends"], &closed["order"]), (&json!("closed"), &json!(3)));
    let high = model(&format!("{}type g8\nkey Enter\ntype n\n", opened("A")));
    assert_eq!(numbers(&high["knots"]).len(), 21);
    let none = model(&format!("{}type g9\nkey Enter\ntype n\n", opened("A")));
    assert_eq!(none["order"], 8, "it is moved into the range");
    let raised = model(&format!("{}key F\n", opened("D")));
    assert_eq!(raised["order"], 7);
    let twice = model(&format!("{}type fff\n", opened("D")));
    assert_eq!(twice["order"], 8);
}

#[test]
fn tab_goes_through_the_knots_that_matter() {
    let next = model(&format!("{}key Tab\n", opened("A")));
    assert_eq!(next["knot"], 9);
    let around = model(&format!("{}{}", opened("A"), "key Tab\n".repeat(15)));
    assert_eq!(around["knot"], 8, "{}", around["knot"]);
    let straight = model(&format!("{}key P\nkey Tab\nkey Tab\n", opened("A")));
    assert_eq!((&straight["straight"], &straight["path_order"]), (&json!(true), &json!(1)));
}

#[test]
fn two_knots_move_against_each_other() {
    let script = format!("{}key L\n", opened("B"));
    let on = model(&script);
    assert_eq!(on["opposed"], true);
    let first = on["knot"].as_u64().unwrap() as usize;
    let x = |knot: f64| 41 + (8.0 + knot / 10.0 * 544.0).round() as i32;
    let moved = model(&format!("{script}drag {} 452 {} 452\n", x(first as f64), x(first as f64 + 0.4)));
    let knots = numbers(&moved["knots"]);
    let by = knots[first] - first as f64;
    assert!(
        (by - 0.4).abs() < 0.02 && (knots[first + 5] - (first as f64 + 5.0) + by).abs() < 1e-12,
        "{knots:?}"
    );
    assert_eq!(model(&format!("{script}key L\n"))["opposed"], false);
    assert_eq!(model(&format!("{}type g4\nkey Enter\ntype z\nkey L\n", opened("B")))["opposed"], false);
}

#[test]
fn the_curve_goes_through_a_target() {
    let asked = format!("{}key A\nclick 321 105\n", opened("B"));
    let found = model(&asked);
    let solutions = found["search"]["solutions"].as_u64().unwrap();
    assert!(solutions > 1, "{found}");
    let taken = model(&format!("{asked}key Enter\n"));
    assert_eq!(taken["knots"], found["search"]["knots"]);
    assert_eq!(taken.get("search"), None);
    let other = model(&format!("{asked}key Right\n"));
    assert_ne!(other["search"]["knots"], found["search"]["knots"]);
    let last = model(&format!("{asked}key Left\n"));
    let ends = model(&format!("{asked}{}", "key Right\n".repeat(solutions as usize - 1)));
    assert_eq!(last["search"]["knots"], ends["search"]["knots"]);
    let given_up = model(&format!("{asked}key Esc\n"));
    assert_eq!(given_up["unsaved"], false);
    // The target on the curve that was taken.
    let (knots, u) = (numbers(&taken["knots"]), taken["u"].as_f64().unwrap());
    let points: Vec<[f64; 2]> = taken["points"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| [p[0].as_f64().unwrap(), p[1].as_f64().unwrap()])
        .collect();
    let vector = grafika::geometry::knots::KnotVector::new(4, knots).unwrap();
    let curve = grafika::geometry::knots::KnotCurve::new(vector, points).unwrap();
    let [x, y] = curve.point_at(u).unwrap();
    assert!((x - 280.0).hypot(y - 225.0) < 1e-6, "{x} {y}");
}

#[test]
fn what_is_not_reached_is_said_with_the_nearest_place() {
    let asked = format!("lang en\n{}key A\nclick 321 320\n", opened("B"));
    let kept = run(&asked);
    assert_eq!(kept.models["end.json"]["search"]["solutions"], 0);
    pictures::assert_golden("csomo_not_reached_en", &kept.pictures["end.png"]);
    let nearest = model(&format!("{asked}key O\n"));
    assert!(nearest["search"]["solutions"].as_u64().unwrap() > 0, "{nearest}");
    let closed = run(&format!("lang en\n{}type g4\nkey Enter\ntype z\nkey A\nclick 321 105\n", opened("B")));
    assert_eq!(closed.models["end.json"]["search"]["solutions"], 0);
}

#[test]
fn documents_are_saved_and_read_again() {
    let disk = SharedDisk::default();
    let script =
        format!("{}{}key Ctrl+S\ntype TWO\nkey Enter\ndump end.json", opened("A"), dragged(8.2, 12.5));
    let mut kept = Kept::default();
    let script = Script::parse(&script).expect("the test's script is right");
    play(&mut session(PROGRAM, disk.clone(), Settings::default()), &script, &mut kept).expect("all is taken");
    let text = String::from_utf8(disk.file("TWO.CSM")).expect("it is text");
    let Document::Knots(knots) = Document::from_json(&text).expect("it is a document") else {
        panic!("{text}")
    };
    assert_eq!(knots.knots[8..10], [9.0, 9.0]);
}

fn of_document(text: &str) -> Result<Value, String> {
    let document = Document::from_json(text).map_err(|error| error.to_string())?;
    let start = (PROGRAM.start)(Some(document.clone()));
    drop(start.map_err(|problem| problem.of(grafika::machine::Language::English).to_owned())?);
    let machine = Machine::new(Box::new(Memory::default()), Settings::default());
    let mut kept = Kept::default();
    let script = Script::parse("dump end.json").expect("it is right");
    play(&mut session_on(PROGRAM, machine, Some(document)), &script, &mut kept).expect("all is taken");
    Ok(kept.models["end.json"].clone())
}

#[test]
fn points_become_cubic_and_what_cannot_be_is_told() {
    let points = of_document("{\"format\":\"IP2\",\"points\":[[0,0],[100,380],[200,0],[560,190]]}").unwrap();
    assert_eq!((&points["order"], &points["curve"]), (&json!(4), &json!(true)));
    assert_eq!(points["points"][1], json!([68.0, 260.0]));
    let flat =
        "{\"format\":\"CSM\",\"order\":3,\"points\":[[0,0,0],[9,9,0],[99,0,0]],\"knots\":[0,0,0,1,1,1]}";
    assert_eq!(of_document(flat).unwrap()["points"][2], json!([99.0, 0.0]));
    for (text, told) in [
        (flat.replace("[9,9,0]", "[9,9,1]"), "in space"),
        ("{\"format\":\"KOR\",\"circles\":[[0,0,1]],\"closed\":false}".to_owned(), "by its knots"),
        (format!("{{\"format\":\"IP2\",\"points\":[{}]}}", vec!["[1,1]"; 100].join(",")), "99"),
    ] {
        let refused = of_document(&text).unwrap_err();
        assert!(refused.contains(told), "{refused}");
    }
}

/// The hill on the page of surfaces.
fn hill(script: &str) -> Kept {
    let machine = Machine::new(Box::new(Memory::default()), Settings::default());
    let mut kept = Kept::default();
    let script = Script::parse(&format!("{script}\nshot end.png\ndump end.json")).expect("it is right");
    let text = std::fs::read_to_string(common::path("../data/A.CSF")).expect("the sample is there");
    let document = Document::from_json(&text).expect("it is a document");
    play(&mut session_on(PROGRAM, machine, Some(document)), &script, &mut kept).expect("all is taken");
    kept
}

fn of_hill(script: &str) -> Value {
    hill(script).models["end.json"].clone()
}

/// The column of a knot of u, 0 to 10, and the row of one of v.
fn on_rails(knot: f64) -> [i32; 2] {
    [60 + (8.0 + knot / 10.0 * 544.0).round() as i32, 432 - (8.0 + knot / 10.0 * 350.0).round() as i32]
}

#[test]
fn knots_of_both_directions_shape_a_surface() {
    let [from, to] = [on_rails(5.0), on_rails(5.4)];
    let along_u = of_hill(&format!("drag {} 454 {} 454", from[0], to[0]));
    let knots = numbers(&along_u["knots"][0]);
    assert!((knots[5] - 5.4).abs() < 0.03, "{knots:?}");
    assert_eq!((&along_u["direction"], &along_u["knot"]), (&json!(0), &json!(5)));
    let along_v = of_hill(&format!("drag 37 {} 37 {}", from[1], on_rails(7.5)[1]));
    assert_eq!(numbers(&along_v["knots"][1])[5], 6.0, "it stops at its neighbour");
    assert_eq!(along_v["direction"], 1);
    let undone = of_hill(&format!("drag {} 454 {} 454\nkey Ctrl+Z", from[0], to[0]));
    assert_eq!(numbers(&undone["knots"][0])[5], 5.0);
    let turned = of_hill(&format!("move {} 454\nwheel 2", from[0]));
    assert!((numbers(&turned["knots"][0])[5] - 5.02).abs() < 1e-9 && turned["zoom"] == of_hill("")["zoom"]);
    assert_ne!(of_hill("move 320 240\nwheel 2")["zoom"], of_hill("")["zoom"]);
}

#[test]
fn points_marks_and_numbers_of_a_surface_change() {
    let marked = of_hill(&format!("click {} 440\nclick 50 {}", on_rails(4.5)[0], on_rails(3.5)[1]));
    let at = numbers(&marked["at"]);
    assert!((at[0] - 4.5).abs() < 0.02 && (at[1] - 3.5).abs() < 0.03, "{at:?}");
    let point = of_hill(
        "type vp0\nkey Enter\ntype 0\nkey Enter\ntype 10\nkey Enter\ntype 20\nkey Enter\ntype 30\nkey Enter",
    );
    assert_eq!(point["points"][0][0], json!([10.0, 20.0, 30.0]));
    let knot = of_hill("type vcv6\nkey Enter\ntype 6.25\nkey Enter");
    assert_eq!(numbers(&knot["knots"][1])[6], 6.25);
    let next = of_hill("key Tab");
    assert_eq!((&next["direction"], &next["knot"]), (&json!(0), &json!(6)));
    let through = of_hill("key A\ntype 0\nkey Enter\ntype 0\nkey Enter\ntype 90\nkey Enter");
    let far = of_hill("key A\ntype 0\nkey Enter\ntype 0\nkey Enter\ntype 900\nkey Enter");
    assert_eq!(far["unsaved"], false);
    assert_eq!(through["points"], far["points"]);
}

#[test]
fn pages_of_curves_and_surfaces_change_places() {
    let there = "key U\nkey F5\nkey U\n";
    let net = model(&format!("{}{}", "manner today\n", there));
    assert_eq!(net["order"], json!([4, 4]));
    let back = model(&format!("manner today\n{there}key F5\nkey U\n"));
    assert_eq!(back["order"], 4);
    let asked = run(&format!("lang en\n{}{}key F5", opened("A"), dragged(8.2, 8.6)));
    pictures::assert_golden("csomo_leave_en", &asked.pictures["end.png"]);
}

#[test]
fn the_page_of_surfaces_looks_as_it_did() {
    for language in ["hu", "en"] {
        let [from, to] = [on_rails(5.0), on_rails(5.7)];
        for (name, script) in [
            ("net", "manner today".to_owned()),
            ("net_knot", format!("move {} 454\npress left\nmove {} 454", from[0], to[0])),
            ("net_result", "key E".to_owned()),
            ("net_change", "type vc".to_owned()),
            ("net_help", "key F1".to_owned()),
        ] {
            let kept = hill(&format!("lang {language}\n{script}"));
            pictures::assert_golden(&format!("csomo_{name}_{language}"), &kept.pictures["end.png"]);
        }
    }
}

#[test]
fn live_or_not() {
    let from = column(8.2);
    let held = format!("{}key F3\nmove {from} 450\npress left\nmove {} 450\n", opened("A"), column(8.9));
    assert_eq!(model(&held)["live"], false);
    let kept = run(&format!("lang en\n{held}wait 3000"));
    pictures::assert_golden("csomo_not_live_en", &kept.pictures["end.png"]);
}

#[test]
fn pages_look_as_they_did() {
    for language in ["hu", "en"] {
        for (name, script) in [
            ("paths", format!("{}type pu\nkey Tab\n", opened("A"))),
            ("double", format!("{}type pu", opened("D"))),
            ("circle", format!("{}key F7\nkey P", opened("K"))),
            ("comb", format!("{}key U\nkey F6\nkey F4\n{}", opened("A"), dragged(8.2, 8.9))),
            ("opposed", format!("{}key L", opened("B"))),
            ("region", format!("{}key F8\nmove 320 150", opened("B"))),
            ("through", format!("{}key A\nclick 321 105", opened("B"))),
            ("change", format!("{}key V", opened("A"))),
            ("knot", format!("{}type vc", opened("A"))),
            ("insert", format!("{}key B", opened("A"))),
            ("order", format!("{}key G", opened("A"))),
            ("ends", format!("{}type g4\nkey Enter", opened("A"))),
            ("result", format!("{}type en", opened("A"))),
            ("closed", format!("{}type g5\nkey Enter\ntype z\ntype p", opened("A"))),
            ("help", "key F1".to_owned()),
            ("today", format!("manner today\n{}", opened("A.CSM"))),
        ] {
            let kept = run(&format!("lang {language}\n{script}"));
            pictures::assert_golden(&format!("csomo_{name}_{language}"), &kept.pictures["end.png"]);
        }
    }
}

#[test]
fn recordings_replay() {
    random::assert_replays(PROGRAM, &random::script(11, random::part(1500)));
}

#[test]
fn random_events_do_no_harm() {
    let program: Program = PROGRAM;
    random::storm(program, random::SOME);
}
