//! GB_P_2D as its user sees it: the originals' screens, our own golden pictures, random input.

mod common;

use common::{Kept, pictures, play_script, storage};
use grafika::file::{Document, Format, Fourier};
use grafika::machine::{Memory, Storage, sample};
use grafika::programs::gb_p_2d::PROGRAM;

#[test]
fn every_reference_script_gives_the_originals_screen() {
    common::reference::assert_screens(PROGRAM, "reference/curves", "GB_P_2D_thin_", 12);
}

#[test]
fn curves_have_the_originals_pixels() {
    // The field without its edge, where the original leaves what went over.
    let inside = |index: usize| (126..512).contains(&(index % 640)) && (72..468).contains(&(index / 640));
    let folder = common::path("reference/curves");
    for name in ["V_done", "f_shifted", "fig22b", "fig22c", "fig22e", "loaded_figa"] {
        let name = format!("GB_P_2D_thin_{name}");
        let script = std::fs::read_to_string(folder.join(format!("{name}.script"))).unwrap();
        let kept = play_script(PROGRAM, Memory::default(), &script);
        let picture = format!("{name}.png");
        let theirs = pictures::read(&folder.join(&picture));
        let pairs = kept.pictures[&picture].pixels().iter().zip(&theirs).enumerate();
        let differing = pairs.filter(|(index, (a, b))| inside(*index) && a != b).count();
        assert_eq!(differing, 0, "{name}");
    }
}

/// Plays a script in a new configuration, with the samples at hand.
fn play(script: &str) -> Kept {
    let mut disk = Memory::default();
    disk.write("A.IP2", sample("A.IP2").unwrap()).unwrap();
    play_script(PROGRAM, disk, &format!("key U\n{script}\ndump end.json\nshot end.png\n"))
}

fn coefficients(kept: &Kept) -> Fourier {
    let model = &kept.models["end.json"];
    let row = |name: &str| serde_json::from_value(model[name].clone()).unwrap();
    Fourier { a: row("a"), p: row("p"), b: row("b"), q: row("q") }
}

fn circle() -> Fourier {
    coefficients(&play(""))
}

/// Fits 8 harmonics to the polygon of A.IP2.
const FIT: &str = "key F5\ntype a\nkey Enter\ntype 8\nkey Enter\nkey P\n";

#[test]
fn golden_pictures() {
    let cases = [
        ("p2d_typing", "click 40 132\ntype -5"),
        ("p2d_choosing", "key V"),
        ("p2d_choosing_number", "type vq1"),
        ("p2d_choosing_english", "type vb\nkey F2"),
        ("p2d_no_such_number", "type vp0\nkey Enter"),
        ("p2d_clipped", "type va1\nkey Enter\ntype 999\nkey Enter\ntype vb3\nkey Enter\ntype 250\nkey Enter"),
        ("p2d_stepped", "move 610 132\nwheel 7\nkey Left\nkey PageUp\nkey Up"),
        ("p2d_fit_harmonics", "key F5\ntype a\nkey Enter\ntype 2"),
        ("p2d_fit_shape", "key F5\ntype a\nkey Enter\ntype 20\nkey Enter"),
        ("p2d_fit_polygon", FIT),
        ("p2d_fit_spline", "key F5\ntype a\nkey Enter\ntype 20\nkey Enter\nkey S"),
        ("p2d_fit_changed", &format!("{FIT}move 40 96\nwheel 20")),
        ("p2d_help", "key F1"),
        ("p2d_help_english", "key F1\nkey F2"),
    ];
    for (name, script) in cases {
        pictures::assert_golden(name, &play(script).pictures["end.png"]);
    }
}

#[test]
fn the_letters_work_without_a_click_before() {
    let kept = play("type va5\nkey Enter\ntype 33\nkey Enter\ntype vq2\nkey Enter\ntype -.25\nkey Enter");
    let mut expected = circle();
    (expected.a[5], expected.q[2]) = (33.0, -0.25);
    assert_eq!(coefficients(&kept), expected);
}

#[test]
fn what_is_typed_is_moved_into_the_range() {
    let typed =
        |window: &str, text: &str| coefficients(&play(&format!("click {window}\ntype {text}\nkey Enter")));
    assert_eq!(typed("40 132", "9E9").a[2], 999.0);
    assert_eq!(typed("40 132", "-999").a[2], -99.0);
    assert_eq!(typed("560 96", "2.5").b[0], 2.5);
    assert_eq!(typed("90 132", "9E99").p[2], 9.99);
    assert_eq!(typed("610 456", "-9E9").q[20], -9.9);
    for junk in ["E", "-", ".", "--1", "1E"] {
        let kept = play(&format!("click 40 132\ntype {junk}\nkey Enter\ntype 7\nkey Enter"));
        assert_eq!(coefficients(&kept).a[2], 7.0, "{junk:?} is asked for again");
    }
}

#[test]
fn every_window_is_reached_by_mouse_and_by_name() {
    for (x, name) in [(40, 'a'), (90, 'p'), (560, 'b'), (610, 'q')] {
        for k in usize::from("pq".contains(name))..=20 {
            let clicked = play(&format!("click {x} {}\ntype 3\nkey Enter", 96 + 18 * k));
            let named = play(&format!("type v{name}{k}\nkey Enter\ntype 3\nkey Enter"));
            assert_ne!(coefficients(&clicked), circle(), "{name}{k}");
            assert_eq!(coefficients(&clicked), coefficients(&named), "{name}{k}");
        }
    }
}

#[test]
fn a_click_elsewhere_ends_typing_with_what_is_a_number() {
    let kept =
        play("click 40 132\ntype 55\nclick 40 150\ntype -\nclick 320 300\nclick 40 168\ntype 6\nkey Esc");
    let mut expected = circle();
    expected.a[2] = 55.0;
    assert_eq!(coefficients(&kept), expected);
}

#[test]
fn steps_of_one_value_are_one_change() {
    let steps = "move 40 114\nwheel 3\nwheel -1\nkey Up\nmove 90 114\nwheel -1\nkey PageUp";
    let kept = play(steps);
    let mut expected = circle();
    (expected.a[1], expected.p[1]) = (103.0, 0.09);
    assert_eq!(coefficients(&kept), expected);
    expected.p[1] = 0.0;
    assert_eq!(coefficients(&play(&format!("{steps}\nkey Ctrl+Z"))), expected);
    assert_eq!(coefficients(&play(&format!("{steps}\nkey Ctrl+Z\nkey Ctrl+Z"))), circle());
    assert_eq!(coefficients(&play(&format!("{steps}\nkey Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z"))), circle());
    let redone = play(&format!("{steps}\nkey Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Y\nkey Ctrl+Y"));
    assert_eq!(coefficients(&redone), coefficients(&kept));
    // Steps after an undo, or after the value was there and back, are changes of their own.
    let again = play("move 40 114\nwheel 3\nkey Ctrl+Z\nwheel 5\nkey Ctrl+Z");
    assert_eq!(coefficients(&again), circle());
    let typed = "click 40 114\ntype 50\nkey Enter\nkey Up\nkey Down\nkey Up\nkey Ctrl+Z";
    assert_eq!(coefficients(&play(typed)).a[1], 50.0);
}

#[test]
fn escape_cancels_every_question_and_entry() {
    for question in [
        "key V",
        "type va",
        "type va5",
        "click 40 132\ntype 5",
        "key F5\ntype a",
        "key F5\ntype a\nkey Enter\ntype 3",
        "key F5\ntype a\nkey Enter\ntype 3\nkey Enter",
        "key Q",
        "type qi",
    ] {
        let kept =
            play(&format!("{question}\nkey Esc\nkey Esc\nkey Esc\ntype vb2\nkey Enter\ntype 4\nkey Enter"));
        let mut expected = circle();
        expected.b[2] = 4.0;
        assert_eq!(coefficients(&kept), expected, "{question:?}");
    }
}

#[test]
fn a_fit_tells_its_error_and_is_one_change() {
    let errors = |harmonics: usize, shape: char| {
        let kept = play(&format!("key F5\ntype a\nkey Enter\ntype {harmonics}\nkey Enter\nkey {shape}"));
        let model = &kept.models["end.json"];
        assert!(coefficients(&kept).a.iter().skip(harmonics + 1).all(|&a| a == 0.0));
        [model["rms"].as_f64().unwrap(), model["largest"].as_f64().unwrap()]
    };
    for shape in ['P', 'S'] {
        let mut last = f64::INFINITY;
        for harmonics in [1, 4, 9, 20] {
            let [rms, largest] = errors(harmonics, shape);
            assert!(rms < largest && rms < last, "{shape} {harmonics}: {rms} {largest}");
            last = rms;
        }
        assert!(last < 4.0, "{last}");
    }
    assert_eq!(coefficients(&play(&format!("{FIT}key Ctrl+Z"))), circle());
    // Esc takes the outline off the picture and leaves the coefficients.
    let kept = play(&format!("{FIT}key Esc"));
    assert!(kept.models["end.json"]["rms"].is_null());
    assert_eq!(coefficients(&kept), coefficients(&play(FIT)));
}

#[test]
fn points_that_cannot_be_fitted_are_told() {
    let all_the_same = |count: usize| {
        let points = grafika::file::PlanePoints::new(vec![[100.0, 100.0]; count]);
        Document::PlanePoints(points).write(Format::Ip2).unwrap()
    };
    for (content, shape) in [
        (all_the_same(0), 'P'),
        (all_the_same(2), 'S'),
        (all_the_same(5), 'P'),
        (vec![1; 1300], 'P'),
        (Vec::new(), 'S'),
    ] {
        let mut disk = Memory::default();
        disk.write("P.IP2", &content).unwrap();
        let script = format!(
            "key U\nkey F5\ntype p\nkey Enter\nshot told.png\ntype 5\nkey Enter\nkey {shape}\nkey Esc\nkey Esc\ndump end.json"
        );
        let kept = play_script(PROGRAM, disk, &script);
        assert_eq!(coefficients(&kept), circle());
    }
    // Five points in one place make a spline without extent, which is a curve all the same.
    let mut disk = Memory::default();
    disk.write("P.IP2", &all_the_same(5)).unwrap();
    let kept = play_script(
        PROGRAM,
        disk,
        "key U\nkey F5\ntype p\nkey Enter\ntype 5\nkey Enter\nkey S\ndump end.json",
    );
    assert_eq!(coefficients(&kept), Fourier::default());
}

#[test]
fn what_is_saved_is_what_the_original_saved() {
    let ours = play(
        "click 40 132\ntype 50\nkey Enter\nclick 90 132\nkey 1\nkey Enter\nclick 560 132\ntype 50\nkey Enter\nclick 610 132\ntype .5\nkey Enter",
    );
    let figa = storage("reference/curves", &["FIGA.GBP"]).read("FIGA.GBP").unwrap();
    let expected = Document::read(Format::Gbp, &figa).unwrap();
    assert_eq!(Document::Fourier(Box::new(coefficients(&ours))), expected);
    assert_eq!(expected.write(Format::Gbp).unwrap(), figa);
}

#[test]
fn loaded_values_keep_their_precision() {
    let mut fourier = circle();
    (fourier.a[3], fourier.p[3], fourier.b[0]) = (12.34375, 0.123_046_875, 1e30);
    let mut disk = Memory::default();
    disk.write("F.GBP", &Document::Fourier(Box::new(fourier.clone())).write(Format::Gbp).unwrap()).unwrap();
    let script = "key T\ntype f\nkey Enter\ndump end.json\nkey Q\nkey I\ntype g\nkey Enter\ntype ni\nkey T\ntype g\nkey Enter\ndump again.json\nshot end.png";
    let kept = play_script(PROGRAM, disk, script);
    assert!((coefficients(&kept).b[0] / 1e30 - 1.0).abs() < 1e-11);
    fourier.b[0] = coefficients(&kept).b[0];
    assert_eq!(coefficients(&kept), fourier);
    assert_eq!(kept.models["again.json"], kept.models["end.json"]);
}

#[test]
fn a_wrong_file_is_refused() {
    let mut disk = Memory::default();
    disk.write("SHORT.GBP", &[0; 503]).unwrap();
    let kept = play_script(PROGRAM, disk, "type tshort\nkey Enter\nshot end.png\nkey U\ndump end.json");
    assert_eq!(coefficients(&kept), circle());
    pictures::assert_golden("p2d_wrong_file", &kept.pictures["end.png"]);
    let points = Document::PlanePoints(Default::default());
    assert!((PROGRAM.start)(Some(points.clone())).is_err());
    let mut huge = circle();
    huge.a[7] = 1e300;
    assert!((PROGRAM.start)(Some(Document::Fourier(Box::new(huge)))).is_err());
}

#[test]
fn the_sample_is_a_letter_a() {
    let mut disk = Memory::default();
    disk.write("A.GBP", sample("A.GBP").unwrap()).unwrap();
    let kept = play_script(PROGRAM, disk, "type ta\nkey Enter\nshot end.png");
    pictures::assert_golden("p2d_sample", &kept.pictures["end.png"]);
}

#[test]
fn the_command_line_samples_coefficients() {
    let grafika = |arguments: &[&str]| {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_grafika")).args(arguments).output();
        let output = output.unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let file = common::path("reference/curves/FIGA.GBP");
    let file = file.to_str().unwrap();
    let (status, text) = grafika(&["sample", file, "--method", "fourier", "--per-span", "4"]);
    assert_eq!(status, Some(0));
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|row| row.split(',').map(|n| n.parse().unwrap()).collect()).collect();
    let expected = [
        [0.0, 0.0, 150.0],
        [0.25, 100.0, -50.0],
        [0.5, 0.0, -50.0],
        [0.75, -100.0, -50.0],
        [1.0, 0.0, 150.0],
    ];
    for (row, [u, x, y]) in rows.iter().zip(expected) {
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(row[0] == 0.0 && row[1] == u && close(row[2], x) && close(row[3], y), "{row:?}");
    }
    assert_eq!(rows.len(), 5);
    assert_eq!(grafika(&["sample", "A.GBP"]).1.lines().count(), 52);
    assert_eq!(grafika(&["sample", "A.GBP", "--method", "spline"]).0, Some(2));
    assert_eq!(grafika(&["sample", "A.IP2", "--method", "fourier"]).0, Some(2));
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
