//! Drives the display by minifb on an X server without a screen: a program starts, is drawn in, saves and is closed.
//!
//! Needs Xvfb; where it is missing the test says so and passes, unless GRAFIKA_CI=1.
#![cfg(all(target_os = "linux", feature = "minifb"))]

mod common;

use common::desktop::{Desktop, server, wait};
use common::{SharedDisk, session};
use grafika::machine::{Script, Settings, play};
use grafika::programs::gb_2d_ip;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;
use x11rb::protocol::xproto;

/// Longer than the display's time from one question to the next, which it has to see the button held at.
const HAND: Duration = Duration::from_millis(60);

/// The key symbols of Control and Enter.
const CONTROL: u32 = 0xFFE3;
const ENTER: u32 = 0xFF0D;

/// GB_2D_IP in a window of the picture's size, with its files and settings in a folder and what it says in a file there.
fn start(display: &str, folder: &Path) -> Desktop {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gb_2d_ip"));
    command.args(["--display", "minifb", "--lang", "en"]).current_dir(folder);
    command.env("XDG_STATE_HOME", folder).env("XDG_CONFIG_HOME", folder);
    command.stderr(fs::File::create(folder.join("said")).unwrap());
    let desktop = Desktop::start_program(display, &mut command, "GB_2D_IP");
    assert_eq!(desktop.size(), (640, 480));
    wait("the first picture", || picture(&desktop).iter().any(|&byte| byte != 0).then_some(()));
    desktop
}

fn picture(desktop: &Desktop) -> Vec<u8> {
    desktop.image((0, 0), (640, 480))
}

fn click(desktop: &Desktop, place: (i32, i32)) {
    desktop.point(place);
    std::thread::sleep(HAND);
    for kind in [xproto::BUTTON_PRESS_EVENT, xproto::BUTTON_RELEASE_EVENT] {
        desktop.fake(kind, 1, 0, 0);
        std::thread::sleep(HAND);
    }
}

/// Three points, and their file as a script saves it.
const POINTS: [(i32, i32); 3] = [(141, 350), (241, 150), (341, 350)];

fn file_of_the_script() -> Vec<u8> {
    let clicks: String = POINTS.iter().map(|(x, y)| format!("click {x} {y}\n")).collect();
    let script = format!("lang en\nmanner today\nkey U\n{clicks}key Ctrl+S\ntype ARC\nkey Enter\nwait 10\n");
    let (script, disk) = (Script::parse(&script).unwrap(), SharedDisk::default());
    let mut session = session(gb_2d_ip::PROGRAM, disk.clone(), script.begun_with(Settings::default()));
    play(&mut session, &script, &mut ()).unwrap();
    disk.file("ARC.IP2")
}

#[test]
fn a_curve_is_drawn_saved_and_rescued() {
    let Some((_server, display)) = server() else { return };
    let folder = tempfile::tempdir().unwrap();
    let kept = || fs::read_dir(folder.path().join("grafika/recovery")).map_or(0, |found| found.count());
    let said = || fs::read_to_string(folder.path().join("said")).unwrap();

    let mut desktop = start(&display, folder.path());
    desktop.press_key('u');
    std::thread::sleep(HAND);
    for place in POINTS {
        let before = picture(&desktop);
        click(&desktop, place);
        wait("the point", || (picture(&desktop) != before).then_some(()));
    }
    let control = desktop.key_code(CONTROL);
    desktop.fake(xproto::KEY_PRESS_EVENT, control, 0, 0);
    desktop.press_key('s');
    desktop.fake(xproto::KEY_RELEASE_EVENT, control, 0, 0);
    "arc".chars().for_each(|letter| desktop.press_key(letter));
    desktop.press_symbol(ENTER);
    let saved = wait("the file", || fs::read(folder.path().join("ARC.IP2")).ok());
    assert_eq!(saved, file_of_the_script());

    // Nothing is unsaved: the program ends without a word.
    desktop.close();
    assert!(wait("the end", || desktop.ended()).success());
    assert_eq!((said().as_str(), kept()), ("", 0));

    // A new point would be asked about; the closed window can show no question, so that the work is kept.
    let mut desktop = start(&display, folder.path());
    desktop.press_key('u');
    std::thread::sleep(HAND);
    let before = picture(&desktop);
    click(&desktop, POINTS[1]);
    wait("the point", || (picture(&desktop) != before).then_some(()));
    desktop.close();
    assert!(wait("the end", || desktop.ended()).success());
    assert!(said().contains("the window was closed; what was not saved is kept"), "{}", said());
    assert!(kept() > 0);
}
