//! F10 as a user sees it: its questions, the figures of every family of programs, what can go wrong.

mod common;

use grafika::programs::{
    csav_gy, f_p_herm, f_p_spln, gb_2d_bt, gb_2d_ch, gb_2d_ip, gb_3d_ip, gb_p_2d, gr_kz_x,
};

use common::{Kept, Refusing, SharedDisk, pictures};
use grafika::figure::screen_png;
use grafika::geometry::{Closure, Curve, Method, ParamCurve, Point};
use grafika::machine::{Machine, Script, Settings, Storage, play};
use grafika::ui::Program;

const PLANE: Program = gb_2d_ip::PROGRAM;

/// Plays a script on a disk with the samples at hand.
fn play_on(program: Program, disk: impl Storage + 'static, script: &str) -> Kept {
    let mut kept = Kept::default();
    let script = Script::parse(script).expect("the test's script is right");
    let mut session = common::session(program, disk, Settings::default());
    play(&mut session, &script, &mut kept).expect("the outlet takes all");
    kept
}

/// What a script leaves on an empty disk.
fn disk_after(program: Program, script: &str) -> SharedDisk {
    let disk = SharedDisk::default();
    play_on(program, disk.clone(), script);
    disk
}

fn text(disk: &SharedDisk, name: &str) -> String {
    String::from_utf8(disk.file(name)).expect("SVG is text")
}

/// A sample with its closed spline in the picture.
const SPLINE: &str = "type ta\nkey Enter\ntype gz3\n";

fn sample_points() -> Vec<Point<2>> {
    let content = grafika::machine::sample("A.IP2").unwrap();
    match grafika::file::Document::read(grafika::file::Format::Ip2, content).unwrap() {
        grafika::file::Document::PlanePoints(plane) => plane.points,
        _ => panic!("A.IP2 holds points of the plane"),
    }
}

/// The numbers of the paths of curves, which begin with M and go on with C.
fn arcs_in(svg: &str) -> Vec<Vec<f64>> {
    let paths = svg.split(" d=\"").skip(1).filter_map(|rest| rest.split('"').next());
    let curves = paths.filter(|data| data.contains('C'));
    let numbers = |data: &str| {
        let words = data.split([' ', 'M', 'C', 'Z']).filter(|word| !word.is_empty());
        words.map(|word| word.parse().expect("a number")).collect()
    };
    curves.map(numbers).collect()
}

#[test]
fn golden_pictures_of_the_questions() {
    let script = format!(
        "{SPLINE}key F10\nshot saving_kind.png\nkey P\nshot saving_width.png\nkey Enter\nshot saving_title.png\n\
         type Zárt spline\nkey Enter\ntype Ez egy hosszú aláírás, őű\nshot saving_caption.png\nkey Enter\n\
         shot saving_axes.png\nkey Enter\nkey F2\nshot saving_name.png\nkey Enter\nshot saving_done.png"
    );
    let kept = play_on(PLANE, SharedDisk::default(), &script);
    for (name, screen) in &kept.pictures {
        pictures::assert_golden(name.trim_end_matches(".png"), screen);
    }
}

#[test]
fn enter_takes_what_is_proposed() {
    let disk = SharedDisk::default();
    let enters = "key F10\nkey Enter\nkey Enter\nkey Enter\nkey Enter\nkey Enter\n";
    play_on(PLANE, disk.clone(), &format!("{SPLINE}{enters}{enters}"));
    assert_eq!(disk.names(), ["gb_2d_ip-1.svg", "gb_2d_ip-2.svg"]);
    let svg = text(&disk, "gb_2d_ip-1.svg");
    assert_eq!(svg, text(&disk, "gb_2d_ip-2.svg"));
    // The title is the name of the file; there are axes and all points with their numbers.
    assert!(svg.contains("<title>A</title>") && svg.contains("class=\"axes\""), "{svg}");
    assert_eq!(svg.matches("<circle").count(), sample_points().len());
}

#[test]
fn curves_are_written_by_their_very_control_points() {
    let disk =
        disk_after(PLANE, &format!("{SPLINE}key F10\ntype s\nkey Enter\nkey Enter\ntype n\nkey Enter"));
    let svg = text(&disk, "gb_2d_ip-1.svg");
    let curve = Curve::through(Method::Spline, Closure::Closed, &sample_points()).unwrap();
    let arcs = curve.to_cubics(1e-6).unwrap();
    let mut wanted: Vec<f64> = arcs[0].p[0].to_vec();
    wanted.extend(arcs.iter().flat_map(|arc| arc.p[1..].iter().flatten()));
    assert_eq!(arcs_in(&svg), [wanted]);
    assert!(!svg.contains("class=\"axes\""));
}

#[test]
fn the_result_is_written_without_its_points() {
    let script = format!(
        "{SPLINE}type en\nkey F10\nkey Enter\nkey Delete\nkey Enter\nkey Enter\nkey Enter\nkey Enter"
    );
    let svg = text(&disk_after(PLANE, &script), "gb_2d_ip-1.svg");
    assert_eq!((svg.matches("<circle").count(), svg.matches("<title").count()), (0, 0));
    assert_eq!(arcs_in(&svg).len(), 1);
}

#[test]
fn compared_curves_tangents_and_joints_are_written() {
    let compared =
        format!("{SPLINE}key F4\ntype 14\nkey F10\nkey Enter\nkey Enter\nkey Enter\nkey N\nkey Enter");
    let svg = text(&disk_after(PLANE, &compared), "gb_2d_ip-1.svg");
    assert_eq!(arcs_in(&svg).len(), 3);
    assert!(svg.contains(">Coons<") && svg.contains(">B-spl. 2<"));
    let save = "key F10\nkey Enter\nkey Enter\nkey Enter\nkey N\nkey Enter";
    let tangents = format!("type ta\nkey Enter\nkey N\ntype gz\n{save}");
    let svg = text(&disk_after(gb_2d_ch::PROGRAM, &tangents), "gb_2d_ch-1.svg");
    assert!(svg.contains("stroke-dasharray") && svg.matches("<circle").count() > 4, "{svg}");
    let beta = format!("type ta\nkey Enter\ntype gz\n{save}");
    let svg = text(&disk_after(gb_2d_bt::PROGRAM, &beta), "gb_2d_bt-1.svg");
    assert_eq!(svg.matches("<circle").count(), 2 * sample_points().len());
    let points = format!("type ta\nkey Enter\nkey F5\n{save}");
    let svg = text(&disk_after(PLANE, &points), "gb_2d_ip-1.svg");
    assert_eq!(svg.matches("<circle").count(), 2 * sample_points().len());
}

#[test]
fn golden_figures_of_every_family() {
    let png = "key F10\nkey P\ntype 400\nkey Enter\nkey Enter\ntype 2.1. ábra\nkey Enter\nkey Enter\ntype kep\nkey Enter\n";
    let plain = "key F10\nkey P\ntype 400\nkey Enter\nkey Enter\nkey Enter\nkey N\ntype kep\nkey Enter\n";
    let cube = "type ta\nkey Enter\ntype gz3\nkey Left\n";
    let bump = "key U\nkey V\nkey 2\nkey 2\nkey 0\nkey Enter\nkey 0\nkey Enter\ntype 150\nkey Enter\n";
    let cases: [(Program, &str, &str, &str); 8] = [
        (PLANE, "saved_plane", SPLINE, png),
        (
            gb_p_2d::PROGRAM,
            "saved_fourier",
            "key U\nkey F5\ntype a\nkey Enter\ntype 4\nkey Enter\nkey S\n",
            png,
        ),
        (gb_3d_ip::PROGRAM, "saved_space", cube, png),
        (f_p_spln::PROGRAM, "saved_net", bump, png),
        (f_p_spln::PROGRAM, "saved_surface", &format!("{bump}key F\nkey T\nkey F6\nkey E\n"), png),
        (f_p_herm::PROGRAM, "saved_hermite", "key U\n", plain),
        (csav_gy::PROGRAM, "saved_wires", "", plain),
        (csav_gy::PROGRAM, "saved_ring", "key T\nkey Down\n", plain),
    ];
    for (program, name, before, save) in cases {
        let disk = disk_after(program, &format!("{before}{save}"));
        pictures::assert_golden_png(name, &disk.file("KEP.png"));
    }
}

#[test]
fn a_program_without_geometry_gives_its_screen() {
    let disk = SharedDisk::default();
    let script = "key F2\nshot screen.png\nkey F10\nkey S\nkey Enter\nkey F10\nkey P\ntype 1300\nkey Enter\nkey Enter\n\
                  key F10\nkey P\ntype 640\nkey Enter\ntype one\nkey Enter\nkey F10\nkey D\nkey Enter\n";
    let kept = play_on(gr_kz_x::PROGRAM, disk.clone(), script);
    assert_eq!(disk.names(), ["ONE.png", "gr_kz_x-1.pdf", "gr_kz_x-1.png", "gr_kz_x-1.svg"]);
    let screen = &kept.pictures["screen.png"];
    assert!(disk.file("ONE.png") == screen_png(screen).unwrap());
    assert_eq!(pictures::decode(&disk.file("gr_kz_x-1.png")).width, 1280);
    pictures::assert_golden_png("saved_screen", &disk.file("ONE.png"));
    assert_eq!(text(&disk, "gr_kz_x-1.svg"), grafika::figure::screen_svg(screen));
    assert!(disk.file("gr_kz_x-1.pdf") == grafika::figure::screen_pdf(screen));
}

#[test]
fn colours_that_tell_something_are_kept_as_a_screen() {
    let script = "key U\nkey F\nkey T\nkey F5\nwait 3000\nkey F10\nkey Enter\nkey Enter";
    let svg = text(&disk_after(f_p_spln::PROGRAM, script), "f_p_spln-1.svg");
    assert!(svg.contains("crispEdges"));
}

#[test]
fn a_question_does_not_stand_in_the_figure() {
    let script = format!(
        "{SPLINE}key E\nkey F10\nkey Enter\nkey Enter\nkey Enter\nkey Enter\nkey Enter\nkey N\nkey Esc\ndump end.json"
    );
    let disk = SharedDisk::default();
    let kept = play_on(PLANE, disk.clone(), &script);
    assert_eq!(arcs_in(&text(&disk, "gb_2d_ip-1.svg")).len(), 1);
    // The question went on afterwards.
    assert!(kept.models.contains_key("end.json"));
}

#[test]
fn esc_in_any_question_saves_nothing() {
    let steps = ["key P", "key Enter", "key Enter", "key Enter", "key N"];
    for count in 0..=steps.len() {
        let asked = steps[..count].join("\n");
        let script = format!("{SPLINE}key F10\n{asked}\nkey Esc\nshot end.png\ndump end.json");
        let disk = SharedDisk::default();
        let kept = play_on(PLANE, disk.clone(), &script);
        assert_eq!(disk.names(), [""; 0], "after {count} answers");
        let before = play_on(PLANE, SharedDisk::default(), &format!("{SPLINE}shot end.png"));
        assert!(kept.pictures["end.png"] == before.pictures["end.png"], "after {count} answers");
    }
}

#[test]
fn a_name_that_exists_is_asked_about() {
    let save = |last: &str| {
        let disk = SharedDisk::default();
        disk.clone().write("old.svg", b"old").unwrap();
        let script = format!(
            "{SPLINE}key F10\nkey Enter\nkey Enter\nkey Enter\nkey Enter\ntype old\nkey Enter\n{last}"
        );
        play_on(PLANE, disk.clone(), &script);
        disk
    };
    assert!(text(&save("key I"), "old.svg").starts_with("<svg"));
    assert_eq!(text(&save("key Esc"), "old.svg"), "old");
    let other = save("key N\nkey Backspace\ntype x\nkey Enter");
    assert_eq!((text(&other, "old.svg"), other.names().len()), ("old".to_string(), 2));
    assert!(text(&other, "OLX.svg").starts_with("<svg"));
}

#[test]
fn a_disk_that_takes_nothing_is_told() {
    let script =
        format!("{SPLINE}key F10\nkey Enter\nkey Enter\nkey Enter\nkey Enter\nkey Enter\nshot end.png");
    let kept = play_on(PLANE, Refusing::default(), &script);
    pictures::assert_golden("saving_refused", &kept.pictures["end.png"]);
}

#[test]
fn a_width_that_is_no_number_is_asked_for_again_and_one_out_of_range_moved() {
    let script = format!(
        "{SPLINE}key F10\nkey P\ntype --\nkey Enter\ntype 1\nkey Enter\nkey Enter\nkey Enter\nkey N\nkey Enter"
    );
    let disk = disk_after(PLANE, &script);
    assert_eq!(pictures::decode(&disk.file("gb_2d_ip-1.png")).width, 16);
}

#[test]
fn a_figure_is_not_asked_about_twice_and_the_close_button_works() {
    let mut session = common::session(PLANE, SharedDisk::default(), Settings::default());
    let script = Script::parse("key U\nkey F10\nkey F10\nkey P\nkey F10\nclose").unwrap();
    play(&mut session, &script, &mut Kept::default()).unwrap();
    assert!(session.ended());
}

#[test]
fn the_same_keys_give_the_same_bytes() {
    let script = format!("{SPLINE}key F10\nkey D\nkey Enter\ntype x\nkey Enter\nkey Enter\nkey Enter");
    let files = || disk_after(PLANE, &script).file("gb_2d_ip-1.pdf");
    assert!(files().starts_with(b"%PDF-") && files() == files());
}

#[test]
fn a_surface_without_area_is_no_figure() {
    use grafika::file::{Document, Net, NetKind};
    let enters = "key Enter\n".repeat(5);
    let script = format!("key F\nkey T\nwait 9000\nshot before.png\nkey F10\nshot told.png\n{enters}");
    // Every row is a point, so that the surface is a line; or it is a plate.
    for (across, saved) in [(0.0, false), (80.0, true)] {
        let row = |k: i32| (0..5).map(|l| [80.0 * f64::from(k), across * f64::from(l), 0.0]).collect();
        let net = Document::Net(Net::new(NetKind::Fps, (0..5).map(row).collect()));
        let disk = SharedDisk::default();
        let machine = Machine::new(Box::new(disk.clone()), Settings::default());
        let mut session = common::session_on(f_p_spln::PROGRAM, machine, Some(net));
        let mut kept = Kept::default();
        play(&mut session, &Script::parse(&script).unwrap(), &mut kept).unwrap();
        assert_eq!(!disk.names().is_empty(), saved, "{:?}", disk.names());
        assert!(kept.pictures["told.png"] != kept.pictures["before.png"]);
        if !saved {
            pictures::assert_golden("saved_without_area", &kept.pictures["told.png"]);
        }
    }
}
