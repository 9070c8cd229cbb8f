//! GB_3D_IP and GB_3D_BT as their user sees them: the originals' screens, our own golden pictures,
//! random input.

mod common;

use grafika::programs::{gb_3d_bt, gb_3d_ip};

use common::reference::Allowance;
use common::{Kept, pictures, play_script, random, reference};
use grafika::machine::{Memory, Storage};
use grafika::ui::Program;

const IP: Program = gb_3d_ip::PROGRAM;
const BT: Program = gb_3d_bt::PROGRAM;

#[test]
fn every_reference_script_gives_the_originals_screen() {
    reference::assert_screens_within(IP, "reference/curves", "GB_3D_IP_", 17, Allowance::Curve);
    reference::assert_screens_within(BT, "reference/curves", "GB_3D_BT_", 8, Allowance::Curve);
}

/// Plays a script on the corners of the sample cube; the end is kept as `end`.
fn play_cube(program: Program, rest: &str) -> Kept {
    let mut disk = Memory::default();
    disk.write("A.IP3", grafika::machine::sample("A.IP3").unwrap()).unwrap();
    play_script(program, disk, &format!("type ta\nkey Enter\n{rest}\ndump end.json\nshot end.png\n"))
}

fn points(kept: &Kept) -> Vec<[f64; 3]> {
    serde_json::from_value(kept.models["end.json"]["points"].clone()).unwrap()
}

fn number(kept: &Kept, name: &str) -> f64 {
    kept.models["end.json"][name].as_f64().unwrap()
}

/// Where the sample cube's second corner is on the screen at the start.
const CORNER: (i32, i32) = (207, 379);

#[test]
fn golden_pictures() {
    let cases = [
        (IP, "space_cube", ""),
        (IP, "space_spline_closed", "type gz3"),
        (IP, "space_dragged", "type gz3\nmove 207 379\npress left\nmove 200 300"),
        (IP, "space_followed", "key F3\ntype gz3\ndrag 207 379 200 300\nwait 2500"),
        (IP, "space_turned", "type gz5\ntype gz44\ntype 3\nmove 300 300\npress right\nmove 380 340"),
        (IP, "space_upside_down", "type gz3\nmove 300 100\npress right\nmove 300 460\nrelease right"),
        (IP, "space_larger", "type gz3\nwheel 3"),
        (IP, "space_clipped", "type gn1-9\nkey Enter"),
        (IP, "space_result", "type gz2\ntype ei\nkey Left\nkey Up\nwheel 2"),
        (IP, "space_place_english", "key F2\ntype v2\nkey Enter\ntype h"),
        (IP, "space_help", "key F1"),
        (BT, "space_beta_open", "type a2\nkey Enter\ntype c5\nkey Enter\ntype gn"),
        (BT, "space_beta_result", "type gz\ntype en\nkey Right"),
        (BT, "space_beta_help", "key F1\nkey F2"),
        (BT, "space_critical", "type c-6\nkey Enter"),
    ];
    for (program, name, script) in cases {
        pictures::assert_golden(name, &play_cube(program, script).pictures["end.png"]);
    }
}

#[test]
fn a_dragged_point_keeps_its_depth_and_is_undone() {
    let before = points(&play_cube(IP, ""));
    let (x, y) = CORNER;
    let drag = format!("drag {x} {y} {} {}", x + 60, y - 45);
    let after = points(&play_cube(IP, &drag));
    let view = grafika::geometry::View::from_direction(grafika::file::SPACE_VIEW);
    assert!((view.depth(after[1]) - view.depth(before[1])).abs() < 1e-9);
    let (from, to) = (view.place(before[1]), view.place(after[1]));
    assert!((to[0] - from[0] - 60.0).abs() < 1e-9 && (to[1] - from[1] - 45.0).abs() < 1e-9);
    assert_eq!([&after[..1], &after[2..]], [&before[..1], &before[2..]]);
    assert_eq!(points(&play_cube(IP, &format!("{drag}\nkey Ctrl+Z"))), before);
    assert_eq!(points(&play_cube(IP, &format!("{drag}\nkey Ctrl+Z\nkey Ctrl+Y"))), after);
    let cancelled = format!("move {x} {y}\npress left\nmove 100 100\nkey Esc\nrelease left");
    assert_eq!(points(&play_cube(IP, &cancelled)), before);
}

#[test]
fn the_nearest_disc_is_taken() {
    // Seen along z, the upper corners hide the lower ones.
    let kept = play_cube(IP, "key Right\nmove 331 260\npress right\nmove 331 511\nrelease right");
    let view = grafika::geometry::View::from_angles(
        number(&kept, "azimuth").to_radians(),
        number(&kept, "elevation").to_radians(),
    );
    let all = points(&kept);
    let [x, y] = view.pixel(all[6], 1.0);
    let script = format!(
        "key Right\nmove 331 260\npress right\nmove 331 511\nrelease right\ndrag {x} {y} {} {y}",
        x - 40.0
    );
    let moved = points(&play_cube(IP, &script));
    let changed: Vec<usize> = (0..8).filter(|&index| moved[index] != all[index]).collect();
    let top = view.far_to_near(&all).into_iter().rev().find(|&index| {
        let [px, py] = view.pixel(all[index], 1.0);
        (px - x).hypot(py - y) <= 10.0
    });
    assert_eq!(changed, [top.unwrap()]);
}

#[test]
fn turning_and_zooming_change_no_point_and_home_is_the_start() {
    let start = play_cube(IP, "");
    let look = "key Up\nkey Left\nwheel 3\nmove 300 300\npress right\nmove 500 20\nrelease right";
    let turned = play_cube(IP, look);
    assert_eq!(points(&turned), points(&start));
    assert_eq!(turned.models["end.json"]["unsaved"], false);
    assert_ne!(number(&turned, "elevation"), number(&start, "elevation"));
    let back = play_cube(IP, &format!("{look}\nkey Home"));
    assert!(back.pictures["end.png"] == start.pictures["end.png"]);
    let escaped = play_cube(IP, "move 300 300\npress right\nmove 500 20\nkey Esc\nmove 20 20\nrelease right");
    assert!(escaped.pictures["end.png"] == start.pictures["end.png"]);
    let there_and_back = play_cube(IP, &"key Left\nkey Up\nkey Right\nkey Down\n".repeat(20));
    for angle in ["azimuth", "elevation"] {
        assert!((number(&there_and_back, angle) - number(&start, angle)).abs() < 1e-10, "{angle}");
    }
}

#[test]
fn arrows_stop_before_the_pole_and_the_mouse_goes_over_it() {
    let arrows = play_cube(IP, &"key Down\n".repeat(60));
    assert!((87.0..90.0).contains(&number(&arrows, "elevation")));
    let mouse = play_cube(IP, "move 331 60\npress right\nmove 331 460\nrelease right");
    assert!(number(&mouse, "elevation") > 120.0);
}

#[test]
fn places_are_whole_numbers_of_four_characters_and_escape_cancels() {
    let kept = play_cube(
        IP,
        "type v1\nkey Enter\ntype h-99999\nkey Enter\ntype 12.5\nkey Enter\ntype 99999\nkey Enter\ntype abc0\nkey Enter",
    );
    assert_eq!(points(&kept)[0], [-999.0, 9999.0, 0.0]);
    let before = points(&play_cube(IP, ""));
    for question in [
        "b",
        "b2\nkey Enter\ntype 12",
        "v",
        "v3\nkey Enter\ntype h1",
        "v3\nkey Enter\ntype s",
        "g",
        "gz1",
        "q",
    ] {
        let kept = play_cube(IP, &format!("type {question}\nkey Esc\nkey Esc\nkey Esc\ntype t8\nkey Enter"));
        assert_eq!(points(&kept), before[..7], "{question:?}");
    }
}

#[test]
fn the_curve_goes_with_a_change_unless_it_follows() {
    let visible = |program, script: &str| play_cube(program, script).models["end.json"]["visible"] == true;
    let drag = format!("drag {} {} 200 300", CORNER.0, CORNER.1);
    assert!(visible(IP, "type gz3"));
    assert!(visible(IP, "type gz3\nkey Up\nwheel 1"));
    assert!(!visible(IP, &format!("type gz3\n{drag}")));
    assert!(visible(IP, &format!("key F3\ntype gz3\n{drag}")));
    assert!(!visible(IP, "type gz3\ntype t8\nkey Enter"));
    assert!(visible(IP, "key F3\ntype gz3\ntype t8\nkey Enter"));
    assert!(!visible(BT, "type gz\ntype a2\nkey Enter"));
    assert!(visible(BT, "key F3\ntype gz\ntype a2\nkey Enter"));
    assert!(!visible(IP, "type gz3\ntype ei\nkey Esc"));
    assert!(!visible(IP, "type gz3\nkey Q\nkey Esc"));
}

#[test]
fn bias_is_limited_and_the_shape_outlives_a_configuration() {
    let kept = play_cube(BT, "type a0\nkey Enter\ntype c9e9\nkey Enter");
    assert_eq!((number(&kept, "bias"), number(&kept, "tension")), (0.05, 9e9));
    let kept = play_cube(BT, "type a99\nkey Enter\ntype c-3.5\nkey Enter\ntype qnniu");
    assert_eq!((number(&kept, "bias"), number(&kept, "tension")), (20.0, -3.5));
    assert!(points(&kept).is_empty());
    let kept = play_cube(IP, "type a2\nkey Enter");
    assert_eq!(number(&kept, "bias"), 1.0);
}

#[test]
fn the_critical_tension_is_told_and_kept() {
    let kept = play_cube(BT, "type gz\ntype a2\nkey Enter\ntype c-21\nkey Enter\nkey Esc\ntype gz");
    assert_eq!((number(&kept, "bias"), number(&kept, "tension")), (2.0, -21.0));
    assert_eq!(kept.models["end.json"]["visible"], false);
    let kept = play_cube(BT, "key F3\ntype gz\ntype c-6\nkey Enter\nkey E\nkey Esc\ntype c-5\nkey Enter");
    assert_eq!(number(&kept, "tension"), -5.0);
    assert_eq!(kept.models["end.json"]["visible"], true);
}

#[test]
fn a_saved_configuration_is_loaded_again() {
    let drag = format!("drag {} {} 200 300", CORNER.0, CORNER.1);
    let before = points(&play_cube(IP, &drag));
    let kept = play_cube(IP, &format!("{drag}\ntype qib\nkey Enter\ntype ni\ntype tb\nkey Enter"));
    assert_eq!(kept.models["end.json"]["unsaved"], false);
    for (one, other) in points(&kept).iter().flatten().zip(before.iter().flatten()) {
        // Six-byte reals have 40 significant bits.
        assert!((one - other).abs() <= other.abs() * 1e-11, "{one} {other}");
    }
}

/// Runs `grafika sample` on the sample cube.
fn sample(options: &str) -> std::process::Output {
    std::process::Command::new(env!("CARGO_BIN_EXE_grafika"))
        .current_dir(common::path("golden"))
        .args(["sample", "A.IP3", "--closed", "--per-span", "4"])
        .args(options.split(' '))
        .output()
        .unwrap()
}

#[test]
fn a_sampled_beta_spline_has_its_joints_where_the_book_says() {
    let corners = points(&play_cube(BT, ""));
    for (bias, tension) in [(1.0, 0.0), (2.0, 5.0), (0.5, -1.5), (2.0, -31.0)] {
        let output = sample(&format!("--method beta --bias {bias} --tension {tension}"));
        let text = String::from_utf8(output.stdout).unwrap();
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some("span,u,x,y,z"));
        let rows: Vec<Vec<f64>> =
            lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
        assert_eq!(rows.len(), 8 * 5);
        // (2.64) at u = 0.
        let weights = [bias * bias * bias, 2.0 * bias * (bias + 1.0) + tension, 1.0];
        let delta: f64 = weights.iter().sum();
        for (span, row) in rows.iter().step_by(5).enumerate() {
            assert_eq!(row[..2], [span as f64, 0.0]);
            for axis in 0..3 {
                let expected: f64 =
                    (0..3).map(|k| weights[k] / delta * corners[(span + 7 + k) % 8][axis]).sum();
                assert!((row[2 + axis] - expected).abs() < 1e-10, "{bias} {tension} {row:?}");
            }
        }
    }
}

#[test]
fn sampling_at_the_critical_tension_fails_with_a_sentence() {
    let output = sample("--method beta --bias 2 --tension -21");
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("tension -21 is the critical one for bias 2"), "{message}");
    assert!(output.stdout.is_empty());
}

#[test]
fn files_of_another_kind_are_refused() {
    use grafika::file::{Document, Format, SpacePoints};
    let plane = Document::read(Format::Ip2, grafika::machine::sample("A.IP2").unwrap()).unwrap();
    let space = |count| Document::SpacePoints(SpacePoints::new(vec![[1e9, -3.5, 0.0]; count]));
    assert!((IP.start)(Some(plane.clone())).is_err() && (BT.start)(Some(plane.clone())).is_err());
    assert!((IP.start)(Some(space(99))).is_ok() && (IP.start)(Some(space(100))).is_err());
}

#[test]
fn a_recorded_session_replays_to_the_same_picture() {
    for program in [IP, BT] {
        random::assert_replays(program, &random::script(7, random::part(3000)));
    }
}

#[test]
fn random_events_do_no_harm_to_the_methods() {
    random::storm(IP, random::MANY);
}

#[test]
fn random_events_do_no_harm_to_the_beta_spline() {
    random::storm(BT, random::MANY);
}

/// F4 compares methods and F5 opens the workshop in space too; neither is silent.
#[test]
fn comparison_and_workshop_answer_in_space() {
    let picture = |keys: &str| play_cube(IP, &format!("type gz3\n{keys}")).pictures["end.png"].clone();
    assert!(picture("key F4\ntype 1") != picture(""), "a second curve is in the picture");
    assert!(picture("key F5\nwait 100") != picture(""), "the workshop is open, or says why not");
}
