//! Drives the window display on an X server without a screen, as a user and a window manager would.
//!
//! Needs Xvfb; where it is missing the test says so and passes, unless GRAFIKA_CI=1.
#![cfg(all(target_os = "linux", feature = "window"))]

mod common;

use common::desktop::{Desktop, server, wait};
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};
use x11rb::protocol::xproto::{self, ConnectionExt, InputFocus, Window};

/// What is started and what it shows: the only part that knows the program. Places are pixels of the
/// picture, colours are 0RRGGBB.
mod program {
    pub(super) const NAME: &str = "display_probe";
    pub(super) const ARGUMENTS: [&str; 1] = ["window"];
    /// Pixels and their colours at the start.
    pub(super) const PICTURE: [((i32, i32), u32); 4] =
        [((100, 300), 0x55_FFFF), ((0, 0), 0xAA_0000), ((639, 479), 0xAA_0000), ((30, 75), 0)];
    /// A click here makes this pixel this colour.
    pub(super) const CLICK: ((i32, i32), (i32, i32), u32) = ((150, 250), (145, 250), 0xFF_FF55);
    /// A pixel of the question before closing, its colour, and the keys for no and yes.
    pub(super) const QUESTION: ((i32, i32), u32) = ((210, 210), 0xAA_AAAA);
    pub(super) const NO: char = 'n';
    pub(super) const YES: char = 'y';
}

fn path() -> PathBuf {
    let test = std::env::current_exe().expect("a test knows where it is");
    let folder = test.ancestors().nth(2).expect("tests lie in a folder of the target folder");
    let path = folder.join("examples").join(program::NAME);
    assert!(
        path.exists(),
        "{} is missing; build it: cargo build --example {}",
        path.display(),
        program::NAME
    );
    path
}

fn probe(display: &str, arguments: &[&str]) -> Desktop {
    let arguments = [&program::ARGUMENTS, arguments].concat();
    Desktop::start_program(display, Command::new(path()).args(arguments), program::NAME)
}

/// A whole visit: picture, click, other window sizes, closing with a question.
#[test]
fn a_window_from_start_to_end() {
    let Some((_server, display)) = server() else { return };
    let mut desktop = probe(&display, &[]);
    assert_eq!(desktop.size(), (1280, 960), "the screen has room for twice the picture");
    for (pixel, color) in program::PICTURE {
        desktop.wait_for(pixel, color);
    }

    let (place, pixel, color) = program::CLICK;
    assert!(!desktop.shows(pixel, color));
    desktop.click(place);
    desktop.wait_for(pixel, color);

    for (width, height, scale, corner) in
        [(1403, 1000, 2, (61, 20)), (1279, 1100, 1, (319, 310)), (640, 480, 1, (0, 0))]
    {
        desktop.resize(width, height, scale, corner);
        desktop.wait_for(program::PICTURE[1].0, program::PICTURE[1].1);
        desktop.wait_for(pixel, color);
        if corner != (0, 0) {
            assert_eq!(desktop.color(corner.0 - 1, corner.1 + 5), 0, "the margin is black");
        }
    }
    desktop.resize(400, 350, 1, (0, 0));
    // The middle of a pixel whose neighbours have its colour: (100, 300).
    let reduced = || (desktop.color(62, 212) == program::PICTURE[0].1).then_some(());
    wait("the reduced picture", || (desktop.color(0, 24) == 0).then(reduced).flatten());
    desktop.resize(1280, 960, 2, (0, 0));

    let (question, color) = program::QUESTION;
    desktop.close();
    desktop.wait_for(question, color);
    desktop.press_key(program::NO);
    wait("the end of the question", || (!desktop.shows(question, color)).then_some(()));
    desktop.close();
    desktop.wait_for(question, color);
    desktop.close();
    std::thread::sleep(Duration::from_millis(100));
    assert!(desktop.ended().is_none() && desktop.shows(question, color));
    desktop.press_key(program::YES);
    assert!(wait("the end of the program", || desktop.ended()).success());
}

#[test]
fn a_window_of_the_wanted_scale_needs_no_time_while_nothing_happens() {
    let Some((_server, display)) = server() else { return };
    let desktop = probe(&display, &["1"]);
    assert_eq!(desktop.size(), (640, 480));
    for (pixel, color) in program::PICTURE {
        desktop.wait_for(pixel, color);
    }
    std::thread::sleep(Duration::from_millis(500));
    let before = desktop.used();
    std::thread::sleep(Duration::from_secs(2));
    let ticks = desktop.used() - before;
    assert!(ticks <= 4, "{ticks} hundredths of a second of two seconds at rest");
}

/// Another window may get the release of a button; the program must not go on dragging.
#[test]
fn a_window_without_the_keyboard_holds_no_button() {
    let Some((_server, display)) = server() else { return };
    let folder = tempfile::tempdir().unwrap();
    let record = folder.path().join("session.txt");
    let mut command = Command::new(env!("CARGO_BIN_EXE_gb_2d_ip"));
    command.args(["--display", "window", "--scale", "1", "--record"]).arg(&record);
    command.env("XDG_STATE_HOME", folder.path()).env("XDG_CONFIG_HOME", folder.path());
    let desktop = Desktop::start_program(&display, command.current_dir(folder.path()), "GB_2D_IP");
    let recorded = |line: &str| {
        wait(line, || {
            let text = std::fs::read_to_string(&record).unwrap_or_default();
            text.lines()
                .any(|known| known == line)
                .then(|| text.lines().filter(|&known| known == line).count())
        })
    };
    let focus = |window: Window| {
        desktop
            .connection
            .set_input_focus(InputFocus::NONE, window, x11rb::CURRENT_TIME)
            .unwrap()
            .check()
            .unwrap();
    };
    desktop.fake(xproto::MOTION_NOTIFY_EVENT, 0, 100, 100);
    desktop.fake(xproto::BUTTON_PRESS_EVENT, 1, 0, 0);
    recorded("press left");
    focus(desktop.root);
    assert_eq!(recorded("release left"), 1);
    // The real release comes too late to be another one; the next click counts.
    desktop.fake(xproto::BUTTON_RELEASE_EVENT, 1, 0, 0);
    focus(desktop.window);
    desktop.fake(xproto::BUTTON_PRESS_EVENT, 1, 0, 0);
    desktop.fake(xproto::BUTTON_RELEASE_EVENT, 1, 0, 0);
    wait("the second click", || (recorded("release left") == 2).then_some(()));
    assert_eq!(recorded("press left"), 2);
}

/// Key symbols of F9, F11, Control and Down.
const F9: u32 = 0xFFC6;
const F11: u32 = 0xFFC8;
const CONTROL: u32 = 0xFFE3;
const DOWN: u32 = 0xFF54;

/// A program in a window of the picture's size, with settings in a folder.
fn in_window(display: &str, executable: &str, folder: &std::path::Path, title: &str) -> Desktop {
    let mut command = Command::new(executable);
    command.args(["--display", "window", "--scale", "1"]).current_dir(folder);
    command.env("XDG_STATE_HOME", folder).env("XDG_CONFIG_HOME", folder).env("LC_ALL", "en_US.UTF-8");
    Desktop::start_program(display, &mut command, title)
}

#[test]
fn the_language_is_changed_in_the_settings_by_mouse_and_kept() {
    let Some((_server, display)) = server() else { return };
    let folder = tempfile::tempdir().unwrap();
    let desktop = in_window(&display, env!("CARGO_BIN_EXE_gb_2d_ip"), folder.path(), "GB_2D_IP");
    let names = || desktop.image((100, 100), (190, 200));
    wait("the first picture", || names().iter().any(|&byte| byte != 0).then_some(()));
    let before = names();
    desktop.press_symbol(F9);
    wait("the settings", || (names() != before).then_some(()));
    std::thread::sleep(Duration::from_millis(200));
    let english = names();
    let kept = || std::fs::read_to_string(folder.path().join("grafika/config.toml")).unwrap_or_default();
    // The first row is the language: a click on the value turns it forward, left of it back.
    desktop.click((400, 114));
    wait("Hungarian", || kept().contains("language = \"hu\"").then_some(()));
    wait("Hungarian names", || (names() != english).then_some(()));
    desktop.click((308, 114));
    wait("the language of the locale", || (!kept().contains("language") && names() == english).then_some(()));
    // The last row closes the page.
    desktop.click((130, 354));
    wait("the end of the settings", || (names() == before).then_some(()));
}

#[test]
fn a_key_changes_the_look_of_the_window_and_it_is_kept() {
    let Some((_server, display)) = server() else { return };
    let folder = tempfile::tempdir().unwrap();
    let mut desktop = in_window(&display, env!("CARGO_BIN_EXE_biliard"), folder.path(), "BILIARD");
    desktop.resize(900, 600, 1, (130, 60));
    let margin = |desktop: &Desktop| desktop.color(60, 300);
    desktop.wait_for((5, 5), 0x55_FFFF);
    assert_eq!(margin(&desktop), 0);
    let control = desktop.key_code(CONTROL);
    desktop.fake(xproto::KEY_PRESS_EVENT, control, 0, 0);
    desktop.press_symbol(F11);
    desktop.fake(xproto::KEY_RELEASE_EVENT, control, 0, 0);
    wait("the filling picture", || (margin(&desktop) == 0x55_FFFF).then_some(()));
    let kept = std::fs::read_to_string(folder.path().join("grafika/config.toml")).unwrap();
    assert!(kept.contains("look = \"fill\""), "{kept}");
}

/// What the menu takes of a core, row by row of its grid.
#[test]
#[ignore = "measures for a minute; for a release build on an idle machine"]
fn the_menu_takes_little_power_wherever_it_stands() {
    let Some((_server, display)) = server() else { return };
    let folder = tempfile::tempdir().unwrap();
    let desktop = in_window(&display, env!("CARGO_BIN_EXE_grafika"), folder.path(), "GRAFIKA");
    for row in 0..18 {
        std::thread::sleep(Duration::from_secs(2));
        let before = desktop.used();
        std::thread::sleep(Duration::from_secs(3));
        println!("row {row}: {:.1} %", (desktop.used() - before) as f64 / 3.0);
        desktop.press_symbol(DOWN);
    }
}

/// Does by keyboard and mouse what a script says, in a window and without, and waits until both show the same. The
/// clock of a game, below `top`, is left out, and so is the pointer.
#[track_caller]
fn assert_like_script(
    executable: &str,
    program: grafika::ui::Program,
    script: &str,
    clock: Option<[i32; 4]>,
) {
    use grafika::machine::{Machine, Memory, Script, Session, Settings, play};
    let Some((_server, display)) = server() else { return };
    let parsed = Script::parse(&format!("lang en\nmanner today\n{script}move 638 478\nwait 9000\n")).unwrap();
    let machine = Machine::new(Box::new(Memory::default()), parsed.begun_with(Settings::default()));
    let start = (program.start)(None).unwrap_or_else(|_| panic!("it needs no document"));
    let mut session = Session::start(machine, move |mut machine| async move { start(&mut machine).await });
    play(&mut session, &parsed, &mut ()).unwrap();

    let folder = tempfile::tempdir().unwrap();
    let title = program.manual.name.to_uppercase();
    let mut command = Command::new(executable);
    command
        .args(["--display", "window", "--scale", "1", "--lang", "en", "--seed", "1"])
        .current_dir(folder.path());
    command.env("XDG_STATE_HOME", folder.path()).env("XDG_CONFIG_HOME", folder.path());
    let desktop = Desktop::start_program(&display, &mut command, &title);
    wait("the first picture", || {
        desktop.image((0, 0), (640, 480)).iter().any(|&byte| byte != 0).then_some(())
    });
    std::thread::sleep(Duration::from_millis(300));
    for line in script.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let at = |index: usize| words[index].parse::<i32>().unwrap();
        match words[0] {
            "key" if words[1] == "Enter" => desktop.press_symbol(0xFF0D),
            "key" if words[1] == "Ctrl+Z" => {
                let control = desktop.key_code(CONTROL);
                desktop.fake(xproto::KEY_PRESS_EVENT, control, 0, 0);
                desktop.press_key('z');
                desktop.fake(xproto::KEY_RELEASE_EVENT, control, 0, 0);
            }
            "key" => desktop.press_key(words[1].to_lowercase().chars().next().unwrap()),
            "click" => desktop.click((at(1), at(2))),
            "drag" => {
                desktop.point((at(1), at(2)));
                desktop.fake(xproto::BUTTON_PRESS_EVENT, 1, 0, 0);
                std::thread::sleep(Duration::from_millis(60));
                desktop.point((at(3), at(4)));
                std::thread::sleep(Duration::from_millis(60));
                desktop.fake(xproto::BUTTON_RELEASE_EVENT, 1, 0, 0);
            }
            "wait" => std::thread::sleep(Duration::from_millis(words[1].parse().unwrap())),
            other => panic!("no {other} in a window"),
        }
        std::thread::sleep(Duration::from_millis(60));
    }
    // Out of the way, so that only a corner is covered.
    desktop.point((638, 478));
    let left_out = |x: i32, y: i32| {
        (x > 620 && y > 460)
            || clock.is_some_and(|[x1, y1, x2, y2]| (x1..=x2).contains(&x) && (y1..=y2).contains(&y))
    };
    let screen = session.screen();
    let end = Instant::now() + Duration::from_secs(10);
    loop {
        let shown = desktop.image((0, 0), (640, 480));
        let differs = |index: usize| {
            let (x, y) = ((index % 640) as i32, (index / 640) as i32);
            let [red, green, blue] = screen.pixel(x, y).map_or([0; 3], |color| color.rgb());
            !left_out(x, y) && shown[4 * index..4 * index + 3] != [blue, green, red]
        };
        let count = (0..640 * 480).filter(|&index| differs(index)).count();
        if count == 0 {
            return;
        }
        assert!(Instant::now() < end, "{count} pixels differ from what the script shows");
        std::thread::sleep(Duration::from_millis(50));
    }
}

#[test]
fn a_sample_is_chosen_by_mouse() {
    let script = "key T\nclick 320 120\n";
    assert_like_script(env!("CARGO_BIN_EXE_gb_2d_ip"), grafika::programs::gb_2d_ip::PROGRAM, script, None);
}

#[test]
fn three_clicks_are_three_points() {
    let script = "key U\nclick 141 350\nclick 241 150\nclick 341 350\n";
    assert_like_script(env!("CARGO_BIN_EXE_gb_2d_ip"), grafika::programs::gb_2d_ip::PROGRAM, script, None);
}

#[test]
fn a_surface_is_turned_by_a_left_drag() {
    let script = "key T\nkey Enter\ndrag 560 420 500 380\n";
    assert_like_script(env!("CARGO_BIN_EXE_zm_hspl"), grafika::programs::zm_hspl::PROGRAM, script, None);
}

/// Where the wheel shows moves and time, and what it says of the last move.
const CLOCK: [i32; 4] = [400, 0, 639, 170];

#[test]
fn a_ring_of_the_wheel_is_dragged() {
    let script = "key Enter\ndrag 330 260 300 311\nwait 500\n";
    let program = grafika::programs::gyongy_k::PROGRAM;
    assert_like_script(env!("CARGO_BIN_EXE_gyongy_k"), program, script, Some(CLOCK));
}

#[test]
fn a_wheel_of_four_moves_is_played_to_its_end() {
    // The first move by a hint, one of them taken back and made again.
    let script = "key Enter\nkey H\nwait 3000\nkey C\nkey J\nkey Ctrl+Z\nkey J\nkey L\nkey M\nwait 3000\n";
    let program = grafika::programs::gyongy_k::PROGRAM;
    assert_like_script(env!("CARGO_BIN_EXE_gyongy_k"), program, script, Some(CLOCK));
}
