//! ALAKPAR as its user sees it: families, parameters, targets, interpolation, files, pictures, random input.

mod common;

use common::{Kept, SharedDisk, pictures, play_script, random, session, session_on};
use grafika::file::{Document, FileKind};
use grafika::geometry::shaped::{Family, Parameter, ShapedCurve};
use grafika::geometry::{ParamCurve, Point};
use grafika::machine::{Machine, Memory, SAMPLES, Script, Settings, play};
use grafika::programs::alakpar::PROGRAM;
use serde_json::Value;

/// Opens a built-in sample in the manner of 1997, in which the program always asks for `.ALP`.
fn opened(name: &str) -> String {
    format!("key T\ntype {name}\nkey Enter\n")
}

fn run(script: &str) -> Kept {
    play_script(PROGRAM, Memory::default(), &format!("{script}\nshot end.png\ndump end.json\n"))
}

fn model(script: &str) -> Value {
    run(script).models["end.json"].clone()
}

/// Plays a script on a sample that is named at the start.
fn on(sample: &str, script: &str) -> Kept {
    let (_, bytes) = SAMPLES.iter().find(|(name, _)| *name == sample).expect("it is a sample");
    let kind = FileKind::from_name(sample).expect("samples have a kind");
    let document = Document::decode(kind, bytes).expect("samples are right");
    let machine = Machine::new(Box::new(Memory::default()), Settings::default());
    let script = Script::parse(&format!("{script}\nshot end.png\ndump end.json\n")).expect("it is right");
    let mut kept = Kept::default();
    play(&mut session_on(PROGRAM, machine, Some(document)), &script, &mut kept).expect("all is taken");
    kept
}

fn model_on(sample: &str, script: &str) -> Value {
    on(sample, script).models["end.json"].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn near(value: &Value, wanted: f64, within: f64) {
    assert!((number(value) - wanted).abs() <= within, "{value} is not {wanted}");
}

fn points(value: &Value) -> Vec<Point<2>> {
    serde_json::from_value(value.clone()).expect("they are points of the plane")
}

/// Types a number into an entry.
fn typed(key: &str, value: &str) -> String {
    format!("key {key}\ntype {value}\nkey Enter\n")
}

/// Five points in the manner of today, which are an F-B-spline at first.
const FIVE: &str =
    "manner today\nkey U\nclick 100 300\nclick 200 120\nclick 330 330\nclick 430 150\nclick 520 300\n";
/// Four of them.
const FOUR: &str = "manner today\nkey U\nclick 100 300\nclick 200 120\nclick 330 330\nclick 430 150\n";

#[test]
fn points_put_down_are_a_spline_that_follows_at_once() {
    for manner in ["manner today\n", "manner 1997\n"] {
        // Dragged out of the store, which both manners have.
        let drags = "drag 618 90 100 300\ndrag 618 90 200 120\ndrag 618 90 330 330\ndrag 618 90 430 150\n";
        let model = model(&format!("{manner}key U\n{drags}"));
        assert_eq!(model["family"], "f-bspline");
        assert_eq!((&model["spans"], &model["problem"]), (&Value::from(1), &Value::Null), "{model}");
        assert_eq!(points(&model["points"])[0], [59.0, 150.0]);
    }
}

#[test]
fn parameters_are_typed_and_wrong_ones_told() {
    assert_eq!(model_on("LANC.ALP", &typed("A", "-12.5"))["parameters"]["omega"], -12.5);
    assert_eq!(model_on("FELKOR.ALP", &typed("A", "2,5"))["parameters"]["alpha"], 2.5);
    assert_eq!(model_on("FELKOR.ALP", &typed("A", "pi"))["parameters"]["alpha"], std::f64::consts::PI);
    assert_eq!(model_on("TRIG.ALP", &typed("C", "7"))["parameters"]["beta"], 7.0);
    // A number that is out of range stays in the entry, and nothing has changed after Esc.
    let refused = on("TRIG.ALP", &format!("lang en\n{}", typed("A", "1")));
    pictures::assert_golden("alakpar_out_of_range_en", &refused.pictures["end.png"]);
    assert_eq!(
        model_on("TRIG.ALP", &format!("{}key Enter\nkey Esc", typed("A", "1")))["parameters"]["alpha"],
        3.0
    );
    // A curve without a second parameter, and one without any.
    assert_eq!(model_on("LANC.ALP", "key C")["parameters"]["omega"], -4.0);
    assert_eq!(model_on("KOR.ALP", "key A\nkey P\nkey S\nkey H")["paths"], false);
}

#[test]
fn the_wheel_and_keys_turn_the_parameter_and_every_step_is_undone() {
    let turned = model_on("LANC.ALP", "move 50 20\nwheel 3\nkey PageDown\nkey .");
    near(&turned["parameters"]["omega"], -2.95, 1e-12);
    assert_eq!(model_on("LANC.ALP", "move 50 20\nwheel 3\nkey Ctrl+Z")["parameters"]["omega"], -4.0);
    // Elsewhere the wheel does nothing in the plane; over the second window it turns the second parameter.
    assert_eq!(model_on("LANC.ALP", "move 300 300\nwheel 3")["parameters"]["omega"], -4.0);
    let second = model_on("TRIG.ALP", "move 150 20\nwheel 5");
    near(&second["parameters"]["beta"], 3.0, 1e-12);
    assert_eq!(second["turned"]["name"], "beta");
    // It stops where the family ends.
    near(
        &model_on("LANC.ALP", "move 50 20\nwheel 90")["parameters"]["omega"],
        std::f64::consts::PI.powi(2),
        0.0,
    );
}

#[test]
fn the_slider_is_dragged_and_clicked() {
    assert_eq!(model_on("LANC.ALP", "drag 113 34 20 34")["parameters"]["omega"], -25.0);
    let whole = model_on("LANC.ALP", "drag 113 34 400 300");
    near(&whole["parameters"]["omega"], std::f64::consts::PI.powi(2), 0.0);
    let clicked = model_on("LANC.ALP", "click 103 34");
    near(&clicked["parameters"]["omega"], -7.57, 0.2);
    // One drag is one step back.
    assert_eq!(model_on("LANC.ALP", "drag 113 34 20 34\nkey Ctrl+Z")["parameters"]["omega"], -4.0);
    // Esc lets go of it.
    let given_up = "move 113 34\npress left\nmove 60 34\nkey Esc\nrelease left";
    assert_eq!(model_on("LANC.ALP", given_up)["parameters"]["omega"], -4.0);
}

/// The curve of a model by the library, where its points are control points.
fn curve_of(model: &Value) -> ShapedCurve<2> {
    let parameter = |name: &str| number(&model["parameters"][name]);
    let family = match model["family"].as_str().expect("it has a name") {
        "c-bezier" => Family::c_bezier(parameter("alpha")).expect("it is in range"),
        "f-bezier" => Family::FBezier { omega: parameter("omega") },
        "f-bspline" => Family::FBSpline { omega: parameter("omega") },
        other => panic!("{other}"),
    };
    ShapedCurve::new(family, points(&model["points"]), model["closed"] == true).expect("it is a curve")
}

#[test]
fn the_curve_goes_through_a_target_and_says_where() {
    // The pixel of (280, 245), between the half circle and the cubic curve of its points.
    let hit = model_on("FELKOR.ALP", "key H\nclick 321 205\nwait 400");
    assert_eq!(hit["admissible"], true, "{hit}");
    let curve = curve_of(&hit);
    let at = curve.eval(0, number(&hit["at"])).expect("it is on the curve");
    assert!((at[0] - 280.0).hypot(at[1] - 245.0) < 1e-6, "{at:?}");
    assert_eq!(hit["chosen"], hit["parameters"]["alpha"]);
    // The value is there at once; the picture follows within 300 ms.
    assert_eq!(model_on("FELKOR.ALP", "key H\nclick 321 205")["moving"], true);
    assert_eq!(hit["moving"], false);
    assert_eq!(
        model_on("FELKOR.ALP", "key H\nclick 321 205\nkey Ctrl+Z")["parameters"]["alpha"],
        std::f64::consts::PI
    );
}

#[test]
fn what_cannot_be_reached_is_told_with_the_nearest_point() {
    let miss = model_on("FELKOR.ALP", "key H\nclick 321 250\nwait 400");
    assert_eq!(
        (&miss["admissible"], &miss["parameters"]["alpha"]),
        (&false.into(), &std::f64::consts::PI.into())
    );
    near(&miss["distance"], 30.0, 1e-6);
    near(&miss["nearest"][1], 230.0, 1e-6);
    // Typed, and given up.
    let typed =
        model_on("FELKOR.ALP", "key H\nkey Enter\ntype 280\nkey Enter\ntype 250\nkey Enter\nwait 400");
    assert_eq!(typed["admissible"], true);
    assert_eq!(model_on("FELKOR.ALP", "key H\nkey Esc")["admissible"], Value::Null);
    assert_eq!(model_on("FELKOR.ALP", "key H\nclick 600 480")["admissible"], Value::Null);
}

#[test]
fn a_lambda_of_one_point_reaches_its_targets() {
    // Lambda 4 passes point 5 of the sample, at (280, 300).
    let script = "key F5\ntype 5\nkey Enter\ntype 0\nkey Enter\nkey H\nclick 321 150\nwait 400";
    let hit = model_on("HAN.ALP", script);
    assert_eq!(hit["admissible"], true, "{hit}");
    near(&hit["parameters"]["lambda"][4], 4.0, 1e-9);
    assert_eq!(hit["turned"]["name"], "lambda 5");
}

#[test]
fn lambdas_of_points_follow_their_points() {
    let lambdas = |script: &str| model_on("HAN.ALP", script)["parameters"]["lambda"].clone();
    assert_eq!(lambdas(""), serde_json::json!([0.0, -2.0, 1.0, 0.0, 4.0, -1.0, 2.0, 1.0, 0.0]));
    assert_eq!(
        lambdas("key T\nkey 2\nkey Enter"),
        serde_json::json!([0.0, 1.0, 0.0, 4.0, -1.0, 2.0, 1.0, 0.0])
    );
    let inserted = lambdas("key B\nkey 3\nkey Enter\ntype 100\nkey Enter\ntype 100\nkey Enter");
    assert_eq!(inserted[2], -0.5, "{inserted}");
    let renumbered = lambdas("key V\nkey 5\nkey Enter\nkey S\nkey 1\nkey Enter");
    assert_eq!(renumbered[0], 4.0, "{renumbered}");
    // All alike: the lambda of the chosen point.
    assert_eq!(lambdas("key F5\ntype 5\nkey Enter\nkey Enter\nkey F6"), 4.0);
    assert_eq!(lambdas("key F6"), 0.0);
    // Without a chosen point the wheel says what to do, and nothing is lost.
    assert_eq!(lambdas("move 50 20\nwheel 1"), lambdas(""));
    assert_eq!(model_on("LANC.ALP", "key F5\nkey F6")["problem"], Value::Null);
    // A number that is no point's.
    assert_eq!(lambdas("key F5\ntype 10\nkey Enter\nkey Esc"), lambdas(""));
}

#[test]
fn every_family_takes_the_points_over() {
    // Five points; the Bézier kinds need four and ask.
    let of = |keys: &str| model(&format!("{FIVE}key G\n{keys}"));
    for (keys, family, spans) in [
        ("key 2\nkey N", "c-bspline", 2),
        ("key 4\nkey Z", "f-bspline", 5),
        ("key 5\nkey Enter\nkey Enter\nkey T", "trig-bezier", 1),
        ("key 6\nkey N", "han", 2),
        ("key 7\nkey N", "alpha", 2),
        ("key 8\nkey Z", "gb", 5),
        ("key 9\nkey N", "spb", 2),
        ("key 0\nkey N", "han-quadratic", 3),
        ("key K", "cyclic", 5),
    ] {
        let model = of(keys);
        assert_eq!((&model["family"], &model["spans"]), (&family.into(), &spans.into()), "{keys}: {model}");
        assert_eq!(points(&model["points"]).len(), 5, "{keys}");
    }
    for (key, family) in [("1", "c-bezier"), ("3", "f-bezier")] {
        let kept = of(&format!("key {key}\nkey I"));
        assert_eq!((&kept["family"], points(&kept["points"]).len()), (&family.into(), 4));
        // Nothing is lost for good, and no means no.
        assert_eq!(points(&of(&format!("key {key}\nkey I\nkey Ctrl+Z"))["points"]).len(), 5);
        assert_eq!(of(&format!("key {key}\nkey N"))["family"], "f-bspline");
    }
    assert_eq!(of("key Esc")["family"], "f-bspline");
}

#[test]
fn numbers_of_points_that_do_not_fit_are_told_and_nothing_vanishes() {
    // An even number of points of a cyclic curve: one comes between the last and the first.
    let odd = model(&format!("{FOUR}key G\nkey K"));
    let all = points(&odd["points"]);
    assert_eq!((all.len(), all[4]), (5, [0.5 * (all[0][0] + all[3][0]), 0.5 * (all[0][1] + all[3][1])]));
    // A point more for a Bézier curve: there is no curve, and the page says why; the points stay.
    let more = model_on("LANC.ALP", "manner today\nclick 300 100");
    assert_eq!(points(&more["points"]).len(), 5);
    assert_eq!(more["problem"], "F-Bézier: exactly 4 points, now 5");
    assert_eq!(
        model_on("KOR.ALP", "key T\nkey 1\nkey Enter")["problem"],
        "cyclic: an odd number of points (3, 5, ...), now 2"
    );
    // The trigonometric curve asks for its numbers; more points are said to be missing.
    let trig = model(&format!("{FOUR}key G\nkey 5\nkey 3\nkey Enter\nkey 2\nkey Enter\nkey P"));
    assert_eq!((&trig["parameters"]["n1"], &trig["parameters"]["phi"]), (&3.into(), &"power".into()));
    assert_eq!(trig["problem"], "trig. Bézier: exactly 6 points, now 4");
    // The rational parametrization is refused for other numbers than 2 and 2, and asked again.
    let rational =
        "key G\nkey 5\nkey 1\nkey Enter\nkey 2\nkey Enter\nkey R\nkey 2\nkey Enter\nkey 2\nkey Enter\nkey R";
    assert_eq!(model(&format!("{FIVE}{rational}"))["parameters"]["phi"], "rational");
}

#[test]
fn the_middle_point_is_dead_at_the_least_exponents() {
    let least = format!("{}{}", typed("A", "2"), typed("C", "2"));
    assert_eq!(model_on("TRIG.ALP", &least)["dead"], 2);
    assert_eq!(model_on("TRIG.ALP", "")["dead"], Value::Null);
}

#[test]
fn the_curve_passes_data_in_every_family_that_can() {
    for (keys, family) in [
        ("key 2\nkey N", "c-bspline"),
        ("key 2\nkey Z", "c-bspline"),
        ("key 4\nkey N", "f-bspline"),
        ("key 6\nkey N", "han"),
        ("key 6\nkey Z", "han"),
        ("key 7\nkey N", "alpha"),
        ("key 8\nkey Z", "gb"),
        ("key 9\nkey N", "spb"),
    ] {
        // A datum is dragged afterwards; the curve passes the others still.
        let disk = SharedDisk::default();
        let script = format!(
            "{FIVE}key G\n{keys}\nkey I\ndrag 330 330 300 350\nkey Ctrl+S\ntype D\nkey Enter\ndump end.json\n"
        );
        let mut kept = Kept::default();
        let script = Script::parse(&script).expect("it is right");
        play(&mut session(PROGRAM, disk.clone(), Settings::default()), &script, &mut kept)
            .expect("all is taken");
        let model = &kept.models["end.json"];
        assert_eq!((&model["family"], &model["through"]), (&family.into(), &true.into()), "{keys}");
        let data = points(&model["points"]);
        assert_eq!(data[2], [259.0, 100.0]);
        let saved =
            Document::decode(FileKind::from_name("D.ALP").unwrap(), &disk.file("D.ALP")).expect("it is read");
        let Document::Shaped(shaped) = saved else { panic!("it is shaped") };
        assert!(shaped.through);
        let grafika::design::shaped::Curve::Plane(curve) = grafika::design::shaped::curve(&shaped).unwrap()
        else {
            panic!("it is of the plane")
        };
        let mut joints = curve.joints();
        if curve.closed() {
            joints.rotate_right(1);
        }
        for (datum, joint) in data.iter().zip(&joints) {
            assert!((datum[0] - joint[0]).hypot(datum[1] - joint[1]) < 1e-9, "{keys}: {datum:?} {joint:?}");
        }
        // Read again, the same points are data.
        let mut again = Kept::default();
        let script = Script::parse("dump end.json\n").expect("it is right");
        let machine = Machine::new(Box::new(Memory::default()), Settings::default());
        play(&mut session_on(PROGRAM, machine, Some(Document::Shaped(shaped))), &script, &mut again)
            .expect("all is taken");
        let read = &again.models["end.json"];
        assert_eq!((&read["through"], &read["unsaved"]), (&true.into(), &false.into()));
        assert_eq!(points(&read["points"]), data, "{keys}");
    }
}

#[test]
fn interpolation_that_is_impossible_is_told() {
    let told = |keys: &str| model(&format!("{FIVE}key G\n{keys}"))["problem"].clone();
    assert_eq!(
        told(&format!("key 6\nkey N\nkey I\n{}", typed("A", "-3"))),
        "Han's curve through points needs a lambda above -2 (A)"
    );
    assert_eq!(
        told(&format!("key 7\nkey N\nkey I\n{}", typed("A", "0"))),
        "With lambda 0 it does not pass the points: another lambda (A)"
    );
    assert_eq!(
        told(&format!("key 2\nkey N\nkey I\n{}", typed("A", "pi"))),
        "With alpha = pi it does not pass the points: a smaller one (A)"
    );
    assert_eq!(
        told("key 6\nkey N\nkey I\nkey F5\nkey 2\nkey Enter\nkey 3\nkey Enter"),
        "Han's curve through points has one lambda: F6"
    );
    assert_eq!(model_on("LANC.ALP", "key I")["through"], false);
    // Through points there is no search; twice I is as before.
    let twice = model(&format!("{FIVE}key I\nkey H\nkey I"));
    assert_eq!((&twice["through"], &twice["admissible"]), (&false.into(), &Value::Null));
}

#[test]
fn a_cyclic_curve_is_elevated_without_a_change() {
    let raised = model_on("KOR.ALP", "key F8\nkey F8");
    let all = points(&raised["points"]);
    assert_eq!(all.len(), 7);
    // A regular polygon of radius r gives a circle of radius r n / (n + 1): here 160 / 2 before, so r = 80 * 4 / 3.
    for [x, y] in all {
        assert!(((x - 280.0).hypot(y - 190.0) - 80.0 * 4.0 / 3.0).abs() < 0.5, "{x} {y}");
    }
    assert_eq!(points(&model_on("LANC.ALP", "key F8")["points"]).len(), 4);
    let most = "key F8\n".repeat(60);
    assert_eq!(points(&model_on("KOR.ALP", &most)["points"]).len(), 99);
}

#[test]
fn fewer_harmonics_are_offered_where_points_fly_out() {
    assert_eq!(points(&model_on("A.ALP", "key N")["points"]).len(), 17);
    assert_eq!(points(&model_on("A.ALP", "key Esc")["points"]).len(), 17);
    assert_eq!(points(&model_on("A.ALP", "key I\nkey Backspace\nkey 3\nkey Enter")["points"]).len(), 7);
    let few = model_on("A.ALP", "key I\nkey Enter");
    assert!(points(&few["points"]).len() < 17);
    assert_eq!(few["unsaved"], true);
    // Files of GB_P_2D, whose origin is the middle.
    let fourier = model_on("A.GBP", "key N");
    assert_eq!((&fourier["family"], points(&fourier["points"]).len()), (&"cyclic".into(), 41));
}

#[test]
fn other_programs_points_are_opened() {
    let plane = model_on("K.IP2", "");
    assert_eq!((&plane["family"], points(&plane["points"]).len()), (&"f-bspline".into(), 8));
    let space = model_on("A.IP3", "");
    assert!(space["angles"].is_array(), "{space}");
    // Chosen in the list, on the page of the plane: the page of space opens with it.
    let chosen = model("manner today\nkey T\ntype CSAVAR\nkey Enter");
    assert_eq!((&chosen["family"], &chosen["unsaved"]), (&"c-bezier".into(), &false.into()));
    assert!(chosen["angles"].is_array());
    let back = model("manner today\nkey T\ntype CSAVAR\nkey Enter\nkey F3\nkey T\ntype LANC\nkey Enter");
    assert_eq!((&back["family"], &back["angles"]), (&"f-bezier".into(), &Value::Null));
    let (_, bytes) = SAMPLES.iter().find(|(name, _)| *name == "A.FPB").expect("it is a sample");
    let net = Document::decode(FileKind::from_name("A.FPB").unwrap(), bytes).expect("it is right");
    assert!((PROGRAM.start)(Some(net)).is_err());
}

#[test]
fn in_space_the_curve_goes_under_the_mouse() {
    // A pixel beside the helix, which turning the parameter sweeps.
    let kept = on("CSAVAR.ALP", "key P\nmove 50 20\nwheel -8\nkey H\nclick 377 271\nwait 400");
    let hit = &kept.models["end.json"];
    assert_eq!(hit["admissible"], true, "{hit}");
    assert_eq!(hit["chosen"], hit["parameters"]["alpha"]);
    // The wheel elsewhere zooms, over the window it turns the parameter.
    let zoomed = model_on("CSAVAR.ALP", "move 300 300\nwheel 4");
    assert_eq!((&zoomed["angles"][2], &zoomed["parameters"]["alpha"]), (&2.0.into(), &2.0.into()));
    // Typed places are taken to as near as the curve comes.
    let typed = "key H\nkey Enter\ntype 100\nkey Enter\ntype 0\nkey Enter\ntype 50\nkey Enter";
    let far = model_on("CSAVAR.ALP", typed);
    assert_eq!(far["admissible"], false);
    assert!(number(&far["distance"]) > 1.0);
    // Points are changed by number.
    let moved = model_on(
        "CSAVAR.ALP",
        "key T\nkey 4\nkey Enter\nkey B\nkey 4\nkey Enter\ntype 10\nkey Enter\ntype 20\nkey Enter\ntype 30\nkey Enter",
    );
    assert_eq!(moved["points"][3], serde_json::json!([10.0, 20.0, 30.0]));
}

#[test]
fn the_pages_are_left_with_a_question_about_unsaved_work() {
    let stays = model_on("LANC.ALP", &format!("{}key F3\nkey Esc", typed("A", "1")));
    assert_eq!((&stays["family"], &stays["unsaved"]), (&"f-bezier".into(), &true.into()));
    let goes = model_on("LANC.ALP", &format!("{}key F3\nkey N\nkey U", typed("A", "1")));
    assert!(goes["angles"].is_array(), "{goes}");
}

#[test]
fn the_comb_has_its_scale() {
    let scale = |script: &str| model_on("LANC.ALP", script)["comb"].clone();
    assert_eq!(scale("key K"), 2000.0);
    assert_eq!(scale("key K\nkey +\nkey K"), Value::Null);
    near(&scale("key K\nkey +\nkey K\nkey K\nkey -"), 2000.0, 1e-9);
}

#[test]
fn the_paths_of_a_lambda_are_those_of_the_library() {
    // The path of a point at 1/2 of the catenary's parameter: the values of a dump agree with the library's path.
    let curve = curve_of(&model_on("LANC.ALP", ""));
    let path = curve.path(Parameter::Omega, 0, 0.5, &[-25.0, 0.0]).expect("they are in range");
    for (point, omega) in path.iter().zip(["-25", "0"]) {
        let other = curve_of(&model_on("LANC.ALP", &typed("A", omega)));
        let at = other.eval(0, 0.5).expect("it is on it");
        assert!((at[0] - point[0]).hypot(at[1] - point[1]) < 1e-9);
    }
}

#[test]
fn pages_look_as_they_did() {
    for language in ["hu", "en"] {
        for (name, sample, script) in [
            ("lanc", "LANC.ALP", "key P\nkey F4".to_owned()),
            ("series", "FELKOR.ALP", "key S\nkey F7".to_owned()),
            ("hit", "FELKOR.ALP", "key H\nclick 321 205\nwait 400\nmove 330 300".to_owned()),
            ("miss", "FELKOR.ALP", "key H\nclick 321 250\nwait 400".to_owned()),
            ("aiming", "FELKOR.ALP", "key H".to_owned()),
            ("han", "HAN.ALP", "key F5\ntype 5\nkey Enter\nkey Enter\nkey P\nkey F7".to_owned()),
            ("dead", "TRIG.ALP", format!("{}{}key F7", typed("A", "2"), typed("C", "2"))),
            ("families", "CIKLOIS.ALP", "key G".to_owned()),
            ("phi", "TRIG.ALP", "key G\nkey 5\nkey Enter\nkey Enter".to_owned()),
            ("sides", "TRIG.ALP", "key G\nkey 5".to_owned()),
            ("too_many", "HAN.ALP", "key G\nkey 1".to_owned()),
            ("harmonics", "A.ALP", String::new()),
            ("fewer", "A.ALP", "key I".to_owned()),
            ("cyclic", "KOR.ALP", "key F8\nkey K\nkey F7\nmove 300 300".to_owned()),
            ("data", "HAN.ALP", "key F6\nkey I\nmove 300 300\nclick 300 470".to_owned()),
            ("problem", "KOR.ALP", "key T\nkey 1\nkey Enter".to_owned()),
            ("result", "LANC.ALP", "key S\nkey E\nkey N".to_owned()),
            ("space", "CSAVAR.ALP", "key P\nkey K".to_owned()),
            ("space_result", "CSAVAR.ALP", "key E\nkey I".to_owned()),
            ("help", "LANC.ALP", "key F1".to_owned()),
            ("help_space", "CSAVAR.ALP", "key F1".to_owned()),
            ("today", "HAN.ALP", "manner today".to_owned()),
        ] {
            let kept = on(sample, &format!("lang {language}\n{script}"));
            pictures::assert_golden(&format!("alakpar_{name}_{language}"), &kept.pictures["end.png"]);
        }
    }
}

#[test]
fn samples_open_by_name() {
    for name in ["CIKLOIS", "FELKOR", "LANC", "TRIG", "HAN", "KOR"] {
        let model = model(&opened(name));
        assert_eq!((&model["problem"], &model["unsaved"]), (&Value::Null, &false.into()), "{name}");
        assert!(model["spans"].as_u64().is_some_and(|spans| spans > 0), "{name}: {model}");
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

#[test]
fn random_events_do_no_harm_in_space() {
    random::storm_after(PROGRAM, "key U\nkey F3\nkey U\n", 60, random::SOME);
}
