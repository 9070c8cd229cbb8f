//! The safety of unsaved work as a user sees it: what a session that broke off has lost is offered and taken
//! up, and a file that something else has written is not overwritten unnoticed.

mod common;

use common::random::{self, Dice};
use common::shelf::{Item, Shelf};
use common::{Kept, pictures, shared_out};
use grafika::file::{Document, Format};
use grafika::machine::{Language, Machine, Memory, Script, Session, Settings, Storage, Work, play, sample};
use grafika::programs::{
    biliard, csango_k, f_em_spl, f_p_spln, gb_2d_bt, gb_2d_ch, gb_2d_ip, gb_3d_ip, gb_p_2d, gyongy_k,
    zm_bspl, zm_hspl, zy_betsp,
};
use grafika::ui::Program;
use serde_json::Value;
use std::cell::RefCell;
use std::rc::Rc;
use std::time::Duration;

/// A disk that several sessions work on.
type Disk = Rc<RefCell<Memory>>;

/// A running program with what it has written on a script's command.
struct Window {
    session: Session,
    kept: Kept,
}

impl Window {
    fn open(program: Program, disk: &Disk, shelf: &Shelf) -> Window {
        Window::open_with(program, disk, shelf, None)
    }

    fn open_with(program: Program, disk: &Disk, shelf: &Shelf, file: Option<Document>) -> Window {
        let machine = Machine::new(Box::new(disk.clone()), Settings::default()).with_recovery(shelf.slot());
        let session = common::session_on(program, machine, file);
        Window { session, kept: Kept::default() }
    }

    fn play(&mut self, script: &str) -> &mut Window {
        let script = Script::parse(script).expect("the test's script is right");
        play(&mut self.session, &script, &mut self.kept).expect("the outlet takes all");
        self
    }

    fn model(&mut self) -> Value {
        self.play("dump end.json");
        self.kept.models["end.json"].clone()
    }

    fn assert_picture(&mut self, name: &str) {
        self.play("shot end.png");
        pictures::assert_golden(name, &self.kept.pictures["end.png"]);
    }

    fn x(&mut self, script: &str) -> f64 {
        self.play(script);
        self.model()["points"][0][0].as_f64().expect("there is a point")
    }
}

const IP: Program = gb_2d_ip::PROGRAM;
/// Points of GB_2D_IP in a new configuration.
const POINTS: &str = "key U\ndrag 618 90 161 150\ndrag 618 90 261 110\ndrag 618 90 361 330\n";
/// What its picture says of the last question is not part of the value.
const VIEW: &[&str] = &[
    "method",
    "closed",
    "visible",
    "compared",
    "surface",
    "filled",
    "azimuth",
    "elevation",
    "zoom",
    "target",
    "rms",
    "largest",
    "piece",
    "eye",
    "seconds",
    "hint",
    "rolling",
    "k0",
    "degree",
];

/// Every kind of program with something unsaved that its own format could not hold, where there is such a thing.
const CASES: &[(Program, &str)] = &[
    (IP, POINTS),
    (
        gb_2d_ch::PROGRAM,
        "key U\ndrag 618 90 141 350\ndrag 618 90 291 150\ndrag 618 90 441 350\ntype in.5\nkey Enter\n\
         drag 366 150 391 100\nkey N\n",
    ),
    (
        gb_2d_bt::PROGRAM,
        "key U\ndrag 618 90 101 350\ndrag 618 90 241 150\ndrag 618 90 381 350\ntype a5\nkey Enter\ntype c.125\n\
         key Enter\nkey F5\ntype 2\nkey Enter\ntype 3\nkey Enter\ntype 20\nkey Enter\n",
    ),
    (gb_p_2d::PROGRAM, "key U\nclick 40 132\ntype -5.75\nkey Enter\nmove 610 132\nwheel 3\n"),
    (gb_3d_ip::PROGRAM, "type ta\nkey Enter\ndrag 207 379 200 300\n"),
    (f_p_spln::PROGRAM, "key U\nkey F8\nkey U\ndrag 331 260 331 160\n"),
    (f_em_spl::PROGRAM, "key U\nkey V\nkey 3\nkey 2\ntype 160\nkey Enter\n"),
    (zm_bspl::PROGRAM, "key U\nkey F4\n"),
    (zm_hspl::PROGRAM, "key U\nkey C\nkey U\ntype .3\nkey Enter\n"),
    (zy_betsp::PROGRAM, "key U\nkey A\nkey V\ntype 2.5\nkey Enter\nkey C\nkey U\ntype 7\nkey Enter\n"),
    (gyongy_k::PROGRAM, "key J\nkey U\nkey U\nkey V\ntype 42\nkey Enter\nkey A\nkey I\nkey J\nkey K\n"),
    (csango_k::PROGRAM, "key U\nkey Z\nkey Z\n"),
    (biliard::PROGRAM, "key S\nkey P\ndrag 60 240 560 246\nkey Enter\n"),
];

fn value(mut model: Value) -> Value {
    if let Some(fields) = model.as_object_mut() {
        fields.retain(|name, _| !VIEW.contains(&name.as_str()));
    }
    model
}

/// Takes lost work up. The tangents' program asks something at once.
fn go_on(program: Program) -> &'static str {
    if program.manual.name == "gb_2d_ch" { "key I\nkey N" } else { "key I" }
}

/// Poles are made one point when they are read, which takes the sign from zeros.
fn same(work: Work) -> Work {
    Work { content: work.content.replace("-0.0", "0"), ..work }
}

/// Something is done in a session that breaks off then.
fn break_off(program: Program, disk: &Disk, shelf: &Shelf, script: &str) {
    Window::open(program, disk, shelf).play(script);
}

#[test]
fn what_a_crash_interrupts_is_taken_up_whole_and_unsaved() {
    for &(program, script) in CASES {
        let (name, disk, shelf) = (program.manual.name, Disk::default(), Shelf::default());
        let mut window = Window::open(program, &disk, &shelf);
        let before = window.play(script).model();
        assert_eq!(before["unsaved"], true, "{name}");
        assert!(shelf.items()[0].held, "{name}");
        drop(window);
        let lost = shelf.only();
        assert_eq!(lost.program, name);

        let mut window = Window::open(program, &disk, &shelf);
        let after = window.play(go_on(program)).model();
        assert_eq!(value(after), value(before), "{name}");
        assert_eq!(same(shelf.only()), same(lost.clone()), "{name}: the same work is kept on");
        window.play("close");
        assert!(!window.session.ended(), "{name}: it is asked for at the end");
        drop(window);
        assert_eq!(same(shelf.only()), same(lost), "{name}: a second crash loses nothing");

        let mut window = Window::open(program, &disk, &shelf);
        window.play(go_on(program)).play("key Ctrl+S\ntype safe\nkey Enter\n");
        assert_eq!(shelf.items(), [], "{name}: saved");
        assert_eq!(window.model()["unsaved"], false, "{name}");
        window.play("close");
        assert!(window.session.ended(), "{name}");
    }
}

/// A shelf with the points of a session that broke off.
fn crashed(disk: &Disk) -> Shelf {
    let shelf = Shelf::default();
    break_off(IP, disk, &shelf, POINTS);
    shelf
}

#[test]
fn the_question_looks_like_this() {
    let disk = Disk::default();
    let shelf = crashed(&disk);
    Window::open(IP, &disk, &shelf).assert_picture("safety_lost");
    Window::open(IP, &disk, &shelf).play("key F2").assert_picture("safety_lost_english");
    Window::open(IP, &disk, &shelf).play("key N").assert_picture("safety_give_up");
    Window::open(IP, &disk, &shelf).play("key N\nkey F2").assert_picture("safety_give_up_english");
    let wheel = Shelf::default();
    break_off(gyongy_k::PROGRAM, &disk, &wheel, "key T\nkey A\nkey J");
    Window::open(gyongy_k::PROGRAM, &disk, &wheel).assert_picture("safety_lost_wheel");
}

#[test]
fn only_a_second_yes_deletes() {
    let disk = Disk::default();
    for kept in
        ["key Esc", "key N\nkey N", "key N\nkey Esc", "close", "key N\nclose", "key F1\nkey Esc\nkey Esc"]
    {
        let shelf = crashed(&disk);
        let lost = shelf.items();
        let mut window = Window::open(IP, &disk, &shelf);
        window.play(kept);
        if window.session.ended() {
            assert!(kept.ends_with("close"));
        } else {
            // Not asked again in this session: this is a new configuration.
            window.play("key U\nclose");
            assert!(window.session.ended(), "{kept}");
        }
        drop(window);
        assert_eq!(shelf.items(), lost, "{kept}");
    }
    let shelf = crashed(&disk);
    let mut window = Window::open(IP, &disk, &shelf);
    window.play("key N\nkey I");
    assert_eq!(shelf.items(), []);
    // The start is as it would have been.
    let mut fresh = Window::open(IP, &disk, &Shelf::default());
    for window in [&mut window, &mut fresh] {
        window.play("shot start.png\nkey U\nshot new.png");
    }
    for picture in ["start.png", "new.png"] {
        assert_eq!(window.kept.png(picture), fresh.kept.png(picture));
    }
}

#[test]
fn what_is_saved_or_given_up_is_not_kept() {
    let disk = Disk::default();
    for (rest, left) in [
        ("", 1),
        ("key Ctrl+S\ntype p\nkey Enter\n", 0),
        ("key Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z\n", 0),
        ("key Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Y\n", 1),
        ("key Ctrl+S\ntype p\nkey Enter\nkey I\nkey Ctrl+Z\n", 1),
        ("close\n", 1),
        ("close\nkey Esc\n", 1),
        ("close\nkey N\n", 0),
        ("type qnnn", 1),
        ("type qni", 0),
        ("type qnni", 0),
        ("type qnni\nkey U\ndrag 618 90 161 150\n", 1),
        ("type qiq\nkey Enter\nkey I\nkey I\n", 0),
    ] {
        let shelf = Shelf::default();
        break_off(IP, &disk, &shelf, &format!("{POINTS}{rest}"));
        assert_eq!(shelf.items().len(), left, "{rest:?}");
    }
}

#[test]
fn a_change_is_kept_while_the_next_question_already_stands() {
    // The tangents' program asks after every change.
    let shelf = Shelf::default();
    let mut window = Window::open(gb_2d_ch::PROGRAM, &Disk::default(), &shelf);
    window.play("key U\ndrag 618 90 141 350\ndrag 618 90 291 150\ndrag 618 90 441 350\n");
    let Document::PlanePoints(plane) = Document::from_json(&shelf.only().content).unwrap() else { panic!() };
    assert_eq!(plane.points.len(), 3);
}

#[test]
fn a_rolling_shot_is_kept_as_it_will_end() {
    let (disk, shelf) = (Disk::default(), Shelf::default());
    let shot = "key S\nkey P\ndrag 60 240 560 246\n";
    let mut window = Window::open(biliard::PROGRAM, &disk, &shelf);
    window.play(shot);
    let while_rolling = shelf.only();
    window.play("wait 200000");
    assert_eq!(shelf.only(), while_rolling);
    assert_eq!(window.model()["rolling"], false);
    window.play("key Ctrl+Z");
    assert_ne!(shelf.only(), while_rolling);
    // Nobody is asked to save a game without points, so that none is kept.
    let shelf = Shelf::default();
    Window::open(biliard::PROGRAM, &disk, &shelf).play("drag 60 240 560 246\nwait 60000");
    assert_eq!(shelf.items(), []);
}

#[test]
fn several_sessions_are_offered_newest_first_and_running_ones_never() {
    let (disk, shelf) = (Disk::default(), Shelf::default());
    let session = |x: i32| {
        let esc = "key Esc\n".repeat(shelf.items().iter().filter(|item| !item.held).count());
        let mut window = Window::open(IP, &disk, &shelf);
        window.play(&format!("{esc}key U\ndrag 618 90 {x} 150\n"));
        window
    };
    let running = session(91);
    [141, 241, 341].into_iter().for_each(|x| drop(session(x)));
    break_off(gb_p_2d::PROGRAM, &disk, &shelf, "key U\nclick 40 132\ntype 5\nkey Enter");
    assert_eq!(shelf.items().len(), 5);

    let mut window = Window::open(IP, &disk, &shelf);
    assert_eq!(window.x("key I"), 300.0);
    // Another start meanwhile is offered the next one, and after it the last.
    assert_eq!(Window::open(IP, &disk, &shelf).x("key Esc\nkey I"), 100.0);
    // A new configuration is a place to ask for the rest.
    assert_eq!(window.x("type qnni\nkey N\nkey I\nkey I"), 100.0);
    drop(window);
    drop(running);
    let left: Vec<_> = shelf.items().into_iter().filter_map(|item| item.work.ok()).collect();
    assert_eq!(left.len(), 3, "{left:?}");
}

#[test]
fn a_named_file_waits_for_the_question() {
    let disk = Disk::default();
    let shelf = crashed(&disk);
    let letter = || Some(Document::read(Format::Ip2, sample("A.IP2").unwrap()).unwrap());
    let mut window = Window::open_with(IP, &disk, &shelf, letter());
    assert_eq!(window.x("key I"), 120.0);
    drop(window);
    let mut window = Window::open_with(IP, &disk, &shelf, letter());
    let points = window.play("key Esc").model()["points"].as_array().map(Vec::len);
    assert_eq!(points, Some(54));
    assert_eq!(window.model()["unsaved"], false);
}

#[test]
fn the_file_that_the_work_is_of_is_named() {
    let (mut disk, shelf) = (Disk::default(), Shelf::default());
    disk.write("A.IP2", sample("A.IP2").unwrap()).unwrap();
    let mut window = Window::open(IP, &disk, &shelf);
    window.play("type ta\nkey Enter\ndrag 618 90 161 150\n");
    assert_eq!(shelf.only().file.as_deref(), Some("A.IP2"));
    drop(window);
    let mut window = Window::open(IP, &disk, &shelf);
    window.assert_picture("safety_lost_file");
    window.play("key I\nkey Ctrl+S\ntype b\nkey Enter\nkey Ctrl+Z\ndrag 618 90 161 150\n");
    assert_eq!(shelf.only().file.as_deref(), Some("B.IP2"));
    window.play("type qnni\nkey U\ndrag 618 90 161 150\n");
    assert_eq!(shelf.only().file, None);
}

#[test]
fn broken_work_is_told_once_and_set_aside() {
    let work =
        |content: &str| Work { program: "gb_2d_ip".to_string(), file: None, content: content.to_string() };
    let whole = crashed(&Disk::default()).only().content;
    let half = whole.get(..whole.len() / 2).unwrap();
    let other = r#"{"format": "GBP", "a": [], "p": [], "b": [], "q": []}"#;
    let outside = r#"{"format": "IP2", "points": [[1e9, 0]]}"#;
    let infinite = r#"{"format": "IP2", "points": [[1e999, 0]]}"#;
    let contents = ["", "{}", "[", "null", half, other, outside, infinite, "{\"format\": \"IP2\"}", "\u{0}"];
    for content in contents {
        let (disk, shelf) = (Disk::default(), Shelf::default());
        shelf.put(Ok(work(content)));
        let mut window = Window::open(IP, &disk, &shelf);
        assert!(shelf.items()[0].broken, "{content:?}");
        window.play("key U\ndrag 618 90 161 150\n");
        assert_eq!(window.model()["points"], serde_json::json!([[120.0, 300.0]]), "{content:?}");
    }
    // Others do not keep whole work from being offered; all are told in one message.
    let (disk, shelf) = (Disk::default(), Shelf::default());
    shelf.put(Ok(work("{}")));
    shelf.put(Ok(work(&whole)));
    shelf.put(Err("it is no text".to_string()));
    let mut window = Window::open(IP, &disk, &shelf);
    assert_eq!(window.x("key I"), 120.0);
    window.assert_picture("safety_broken");
    // The older one is told of when it comes to it.
    window.play("key Ctrl+S\ntype p\nkey Enter\ntype qnni").assert_picture("safety_broken_later");
    let broken: Vec<Item> = shelf.items().into_iter().filter(|item| item.broken).collect();
    assert_eq!((broken.len(), shelf.items().len()), (2, 2));
}

#[test]
fn broken_work_is_told_in_one_message() {
    let shelf = Shelf::default();
    for _ in 0..3 {
        shelf.put(Err("it is no text".to_string()));
    }
    let settings = Settings { language: Language::English, ..Settings::default() };
    let machine = Machine::new(Box::new(Memory::default()), settings).with_recovery(shelf.slot());
    let session = common::session_on(IP, machine, None);
    Window { session, kept: Kept::default() }.assert_picture("safety_broken_english");
}

#[test]
fn random_crashes_lose_nothing_and_break_nothing() {
    shared_out(CASES, |&(program, script)| {
        let (disk, shelf, mut dice) = (Disk::default(), Shelf::default(), Dice::new(1956));
        let mut window = Window::open(program, &disk, &shelf);
        let mut offered = 0;
        for index in 0..300 {
            let now = Duration::from_millis(40 * index);
            window.session.send(random::event(&mut dice), now);
            let crash = dice.below(40) == 0;
            if !crash && !window.session.ended() {
                continue;
            }
            let unsaved =
                window.session.model().is_some_and(|model| model.unwrap().contains("\"unsaved\": true"));
            let held = shelf.items().iter().filter(|item| item.held).count();
            if window.session.ended() {
                assert_eq!(held, 0, "{}: an end in order at {index}", program.manual.name);
            } else if unsaved {
                assert!(held > 0, "{}: unsaved work at {index}", program.manual.name);
            }
            window = Window::open(program, &disk, &shelf);
            let offer = shelf.items().iter().any(|item| item.held);
            offered += usize::from(offer);
            if !offer {
                window.play(script);
            }
        }
        assert!(offered > 0, "{}", program.manual.name);
        assert!(
            shelf.items().iter().all(|item| !item.broken && item.work.is_ok()),
            "{}",
            program.manual.name
        );
    });
}

#[test]
fn every_programs_own_work_is_checked() {
    for &(program, script) in CASES {
        let (disk, shelf) = (Disk::default(), Shelf::default());
        break_off(program, &disk, &shelf, script);
        let work = shelf.only();
        for cut in [1, work.content.len() / 3, work.content.len() - 2] {
            let shelf = Shelf::default();
            let content = work.content.get(..cut).unwrap_or_default().to_string();
            shelf.put(Ok(Work { content, ..work.clone() }));
            let mut window = Window::open(program, &disk, &shelf);
            assert!(shelf.items()[0].broken, "{}: {cut}", program.manual.name);
            window.play(script);
            assert_eq!(shelf.items().len(), 2, "{}", program.manual.name);
        }
    }
}

/// Two windows on the same stored configuration of one point.
fn two_windows() -> (Disk, [Window; 2]) {
    let disk = Disk::default();
    Window::open(IP, &disk, &Shelf::default())
        .play("key U\ndrag 618 90 161 150\nkey Ctrl+S\ntype p\nkey Enter");
    let windows = [0, 1].map(|_| {
        let mut window = Window::open(IP, &disk, &Shelf::default());
        window.play("type tp\nkey Enter\n");
        window
    });
    (disk, windows)
}

/// Drags the first point to an x and saves.
fn saving(x: i32) -> String {
    format!("drag 161 150 {x} 150\nkey Ctrl+S\ntype p\nkey Enter\n")
}

/// The x of the first stored point.
fn stored(disk: &Disk) -> f64 {
    match Document::read(Format::Ip2, &disk.read("P.IP2").unwrap()) {
        Ok(Document::PlanePoints(plane)) => plane.points[0][0],
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_file_that_another_window_has_saved_is_not_overwritten_unnoticed() {
    let (disk, [mut one, mut other]) = two_windows();
    one.play(&saving(241)).play("key I");
    assert_eq!(stored(&disk), 200.0);
    other.play(&saving(341));
    other.assert_picture("safety_changed");
    other.play("key F2").assert_picture("safety_changed_english");
    for no in ["key N", "key Esc"] {
        other.play(no);
        assert_eq!((stored(&disk), &other.model()["unsaved"]), (200.0, &Value::Bool(true)));
        other.play("key Ctrl+S\ntype p\nkey Enter");
    }
    other.play("key I");
    assert_eq!((stored(&disk), &other.model()["unsaved"]), (300.0, &Value::Bool(false)));
    // Now the first window is the one that does not know the file.
    one.play("drag 241 150 441 150\nkey Ctrl+S\ntype p\nkey Enter\nkey N");
    assert_eq!(stored(&disk), 300.0);
    one.play("key Ctrl+S\ntype p\nkey Enter");
    one.play("key F2").assert_picture("safety_changed_back");
    one.play("key I");
    assert_eq!(stored(&disk), 400.0);
    // What it has written itself is only asked for as ever.
    one.play("key F2\nkey Ctrl+Z\nkey Ctrl+S\ntype p\nkey Enter").assert_picture("safety_exists");
    one.play("key I");
    assert_eq!(stored(&disk), 200.0);
}

#[test]
fn an_answer_holds_only_for_what_was_asked_about() {
    let (mut disk, [mut one, mut other]) = two_windows();
    one.play(&saving(241));
    other.play(&saving(341)).play("key I");
    // The first window's question was whether its own file may be overwritten; it is asked again.
    one.play("key I");
    assert_eq!(stored(&disk), 300.0);
    disk.write("P.IP2", sample("B.IP2").unwrap()).unwrap();
    one.play("key I");
    assert_eq!(disk.read("P.IP2").unwrap(), sample("B.IP2").unwrap());
    one.play("key I");
    assert_eq!(stored(&disk), 200.0);
}

#[test]
fn the_second_file_of_a_configuration_is_looked_at_too() {
    let disk = Disk::default();
    let three =
        "key U\ndrag 618 90 141 350\ndrag 618 90 291 150\ndrag 618 90 441 350\ntype in.5\nkey Enter\n";
    let mut one = Window::open(gb_2d_ch::PROGRAM, &disk, &Shelf::default());
    one.play(three).play("key Ctrl+S\ntype t\nkey Enter");
    let first = disk.read("T.EC2").unwrap();
    let mut other = disk.clone();
    let changed: Vec<u8> = first.iter().map(|byte| byte.wrapping_add(1)).collect();
    other.write("T.EC2", &changed).unwrap();
    one.play("key N\nkey Ctrl+S\ntype t\nkey Enter\nkey N");
    assert_eq!(disk.read("T.EC2").unwrap(), changed);
    one.play("key N\nkey Ctrl+S\ntype t\nkey Enter\nkey I");
    assert_eq!(disk.read("T.EC2").unwrap(), first);
}

#[test]
fn billiards_ask_too() {
    let disk = Disk::default();
    let game = "key P\ndrag 60 240 560 246\nkey Enter\nkey Ctrl+S\ntype g\nkey Enter\n";
    let [mut one, mut other] = [0, 1].map(|_| Window::open(biliard::PROGRAM, &disk, &Shelf::default()));
    one.play(game);
    other.play("key Ctrl+O\ntype g\nkey Enter\n");
    one.play("key R\nkey Esc\nkey S\nkey Ctrl+S\ntype g\nkey Enter\nkey I");
    let saved = disk.read("G.JSON").unwrap();
    other.play("key P\nkey Ctrl+S\ntype g\nkey Enter\nkey N");
    assert_eq!(disk.read("G.JSON").unwrap(), saved);
    other.play("key Ctrl+S\ntype g\nkey Enter\nkey I");
    assert_ne!(disk.read("G.JSON").unwrap(), saved);
}
