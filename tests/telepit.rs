//! TELEPIT and the menu of the terminal, started for real: as plain commands and in a pseudo-terminal.
#![cfg(all(unix, feature = "terminal"))]

#[path = "common/pty.rs"]
#[allow(dead_code, reason = "every test file uses its own part of this")]
mod pty;

use portable_pty::CommandBuilder;
use pty::Terminal;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

const GRAFIKA: &str = env!("CARGO_BIN_EXE_grafika");
const TELEPIT: &str = env!("CARGO_BIN_EXE_telepit");

/// An empty folder for a test.
fn scratch(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("telepit-run-{name}-{}", std::process::id()));
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

fn run(program: &str, arguments: &[&str]) -> Output {
    Command::new(program).args(arguments).stdin(Stdio::null()).env("LC_ALL", "C").output().unwrap()
}

#[test]
fn a_plain_command_installs_what_starts() {
    let root = scratch("plain");
    let folder = root.to_str().unwrap();
    let done = run(GRAFIKA, &["install", folder, "--groups", "gb_2d,TELEPIT"]);
    let told = String::from_utf8(done.stdout).unwrap();
    assert_eq!(done.status.code(), Some(0));
    assert!(told.contains("GB_2D/A.IP2: written\n"), "{told}");
    assert!(done.stderr.is_empty(), "no bar where there is no terminal");
    assert!(!root.join("JATEK").exists());
    assert!(fs::read_to_string(root.join("SAMPLES.md")).unwrap().contains("`22A.GBP`"));
    // What is linked runs, as itself or under the name of the program.
    for name in ["GB_2D/gb_2d_ip", "TELEPIT/telepit", "grafika"] {
        let help = run(root.join(name).to_str().unwrap(), &["--help"]);
        let text = String::from_utf8(help.stdout).unwrap();
        let program = Path::new(name).file_name().unwrap().to_str().unwrap();
        assert!(text.contains(&format!("Usage: {program}")), "{name}: {text}");
    }
    let again = String::from_utf8(run(TELEPIT, &[folder, "--groups", "gb_2d"]).stdout).unwrap();
    assert!(again.contains("0 files into") && again.contains("were already there"), "{again}");
    fs::remove_dir_all(root).unwrap();
}

#[test]
fn without_yes_nothing_is_overwritten() {
    let root = scratch("yes");
    let folder = root.to_str().unwrap();
    let mine = root.join("GB_2D/B.IP2");
    fs::create_dir(root.join("GB_2D")).unwrap();
    fs::write(&mine, b"mine").unwrap();
    let refused = run(GRAFIKA, &["install", folder, "--groups", "gb_2d"]);
    let message = String::from_utf8(refused.stderr).unwrap();
    assert_eq!(refused.status.code(), Some(1));
    assert!(message.contains("B.IP2 is there already; --yes overwrites it"), "{message}");
    assert_eq!(fs::read_dir(&root).unwrap().count(), 1);
    assert_eq!(fs::read_dir(root.join("GB_2D")).unwrap().count(), 1);
    assert_eq!(fs::read(&mine).unwrap(), b"mine");
    assert_eq!(run(GRAFIKA, &["install", folder, "--groups", "gb_2d", "--yes"]).status.code(), Some(0));
    assert_ne!(fs::read(&mine).unwrap(), b"mine");
    fs::remove_dir_all(root).unwrap();
}

#[test]
fn without_a_terminal_groups_are_needed() {
    for (program, arguments) in [(TELEPIT, vec![]), (GRAFIKA, vec!["install"])] {
        let refused = run(program, &arguments);
        let message = String::from_utf8(refused.stderr).unwrap();
        assert_eq!(refused.status.code(), Some(2));
        assert!(message.contains("--groups all --yes"), "{message}");
    }
    assert_eq!(run(TELEPIT, &["--groups", "nothing"]).status.code(), Some(2));
}

#[test]
fn a_failed_installation_is_undone() {
    let root = scratch("failed");
    fs::write(root.join("FT_GOMB"), b"a file of that name").unwrap();
    let failed = run(GRAFIKA, &["install", root.to_str().unwrap(), "--groups", "all", "--yes"]);
    let message = String::from_utf8(failed.stderr).unwrap();
    assert_eq!(failed.status.code(), Some(1));
    assert!(message.ends_with("everything is as it was before\n"), "{message}");
    assert_eq!(fs::read_dir(&root).unwrap().count(), 1);
    fs::remove_dir_all(root).unwrap();
}

/// Commands in a row, with standard input and output between them.
fn pipe(input: &[u8], arguments: &[&str]) -> Output {
    let mut command = Command::new(GRAFIKA);
    let command = command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(input).unwrap();
    child.wait_with_output().unwrap()
}

#[test]
fn every_command_reads_and_writes_streams() {
    let points = fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/data/Y.IP2")).unwrap();
    let cube = fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/data/A.CSK")).unwrap();
    let ip2 = ["--from", "ip2"];
    let done = |input: &[u8], arguments: &[&str]| {
        let output = pipe(input, arguments);
        let problem = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {problem}");
        output.stdout
    };
    let with = |head: &[&'static str], tail: &[&'static str]| [head, &ip2[..], tail].concat();
    assert!(done(&points, &with(&["info", "-"], &[])).starts_with(b"41 control points in the plane\n"));
    let json = done(&points, &with(&["convert", "-", "-"], &["--to", "json"]));
    assert_eq!(done(&json, &["convert", "-", "-", "--from", "json", "--to", "IP2"]), points);
    let csv = done(&points, &with(&["sample", "-"], &["--method", "spline"]));
    assert!(csv.starts_with(b"span,u,x,y\n"));
    let json = done(&points, &with(&["sample", "-"], &["--method", "spline", "-o", "-", "--to", "json"]));
    assert!(json.starts_with(b"{") || json.starts_with(b"["));
    let png = done(&points, &with(&["render", "-"], &["--method", "bezier", "-o", "-", "--to", "png"]));
    assert!(png.starts_with(b"\x89PNG"));
    assert!(done(&points, &with(&["smooth", "-"], &["-o", "-"])).starts_with(b"x,y\n"));
    assert_eq!(done(&cube, &["solve", "-", "--from", "csk"]), b"the cube is finished\n");
    assert!(done(b"MC\n", &["solve", "-"]).ends_with(b"2 moves, proven shortest\n"));
}

#[test]
fn a_stream_without_a_format_is_a_wrong_command_line() {
    for arguments in [
        &["info", "-"][..],
        &["sample", "-"],
        &["render", "A.IP2", "--method", "spline", "-o", "-"],
        &["convert", "A.IP2", "-"],
        &["smooth", "-", "-o", "-"],
        &["info", "-", "--from", "doc"],
    ] {
        let output = pipe(b"", arguments);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!((output.status.code(), message.lines().count()), (Some(2), 1), "{arguments:?}: {message}");
    }
    assert_eq!(pipe(b"short", &["info", "-", "--from", "ip2"]).status.code(), Some(1));
}

/// The page as a picture, which a window would show.
#[test]
fn the_page_is_shown_as_a_picture_too() {
    let root = scratch("picture");
    let (script, picture) = (root.join("script.txt"), root.join("telepit.png"));
    fs::write(&script, format!("key Space\nclick 40 56\nkey Space\nshot {}\n", picture.display())).unwrap();
    let arguments = ["--script", script.to_str().unwrap()];
    let played = Command::new(TELEPIT).args(arguments).env("HOME", "/home/janos").output().unwrap();
    assert_eq!(String::from_utf8_lossy(&played.stderr), "");
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/telepit.png");
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        fs::copy(&picture, &golden).unwrap();
    }
    assert!(fs::read(&picture).unwrap() == fs::read(&golden).unwrap_or_default(), "{}", golden.display());
    fs::remove_dir_all(root).unwrap();
}

/// A terminal with a program in it.
fn started(columns: u16, rows: u16, program: &str, arguments: &[&str]) -> Terminal {
    let mut command = CommandBuilder::new(program);
    command.args(arguments);
    Terminal::start(columns, rows, command)
}

/// Waits for the end, with the terminal in order, and gives the exit status.
#[track_caller]
fn ended(terminal: &mut Terminal) -> u32 {
    terminal.wait_for_end();
    terminal.wait("the ordinary screen", |terminal| {
        let parser = terminal.screen.lock().unwrap();
        !parser.screen().alternate_screen() && !parser.screen().hide_cursor()
    });
    terminal.child.wait().unwrap().exit_code()
}

const DOWN: &str = "\x1b[B";
const F2: &str = "\x1bOQ";

#[test]
fn a_visit_to_the_installer() {
    let root = scratch("visit");
    let folder = root.join("new");
    let mut terminal = started(80, 25, TELEPIT, &["--lang", "hu", folder.to_str().unwrap()]);
    terminal.wait_for("Szóköz jelöl");
    terminal.wait_for("GR_KZ_X GR_KZ_O");
    terminal.send(F2);
    terminal.wait_for("Space select");
    terminal.send(&format!("{DOWN} "));
    terminal.wait_for("V GB_2D");
    // A click chooses, a second one marks: JATEK is the eleventh line.
    terminal.send("\x1b[<0;6;13M\x1b[<0;6;13m");
    terminal.wait_for("BILIARD GYONGY_K CSANGO_K");
    terminal.send("\x1b[<0;6;13M\x1b[<0;6;13m");
    terminal.wait_for("V JATEK");
    terminal.resize(40, 10);
    terminal.wait_for("at least 48x12");
    terminal.resize(100, 30);
    terminal.send("\r");
    terminal.wait_for("Where should the programs");
    terminal.wait_for("new");
    terminal.send("\r");
    terminal.wait_for("files into");
    terminal.send("\r");
    assert_eq!(ended(&mut terminal), 0);
    assert!(folder.join("GB_2D/A.IP2").is_file() && folder.join("JATEK/csango_k").exists());
    assert!(!folder.join("KURZOR").exists());
    fs::remove_dir_all(root).unwrap();
}

#[test]
fn cancelling_at_a_question_undoes_everything() {
    let root = scratch("question");
    fs::create_dir(root.join("GB_2D")).unwrap();
    fs::write(root.join("GB_2D/C.IP2"), b"mine").unwrap();
    let mut terminal = started(80, 25, GRAFIKA, &["install", "--lang", "en", root.to_str().unwrap()]);
    terminal.wait_for("Space select");
    terminal.send("*\r");
    terminal.wait_for("Where should the");
    terminal.send("\r");
    terminal.wait_for("Overwrite it?");
    assert!(root.join("GB_2D/B.IP2").exists());
    terminal.send("\x1b");
    terminal.wait_for("Everything is as it was before.");
    terminal.send("\r");
    assert_eq!(ended(&mut terminal), 1);
    assert_eq!(fs::read_dir(&root).unwrap().count(), 1);
    assert_eq!(fs::read(root.join("GB_2D/C.IP2")).unwrap(), b"mine");
    fs::remove_dir_all(root).unwrap();
}

#[test]
fn a_signal_undoes_everything() {
    let root = scratch("signal");
    fs::create_dir(root.join("JATEK")).unwrap();
    fs::write(root.join("JATEK/B.CSK"), b"mine").unwrap();
    let mut terminal = started(80, 25, TELEPIT, &["--lang", "en", root.to_str().unwrap()]);
    terminal.wait_for("Space select");
    terminal.send("*\r\r");
    terminal.wait_for("Overwrite it?");
    let process = terminal.child.process_id().unwrap().to_string();
    assert!(Command::new("kill").args(["-TERM", &process]).status().unwrap().success());
    assert_eq!(ended(&mut terminal), 128 + 15);
    assert_eq!(fs::read_dir(&root).unwrap().count(), 1);
    fs::remove_dir_all(root).unwrap();
}

/// From the menu into a program and back.
#[test]
fn the_menu_starts_programs_and_is_there_again() {
    let mut terminal = started(80, 30, GRAFIKA, &["--display", "terminal", "--lang", "en"]);
    terminal.wait_for("A-Z search");
    terminal.send("vjs");
    terminal.wait_for("Programs: vjs");
    terminal.wait_for("joystick");
    terminal.send("\r");
    terminal.wait("the program", |terminal| !terminal.contents().contains("A-Z search"));
    // Its questions to the terminal: one without graphics.
    std::thread::sleep(Duration::from_millis(50));
    terminal.send("\x1b[?62;c");
    terminal.wait("a picture", |terminal| terminal.contents().lines().count() > 20);
    terminal.send("\x03");
    terminal.wait_for("A-Z search");
    terminal.send("\x1b");
    terminal.wait("the search given up", |terminal| !terminal.contents().contains("Programs: vjs"));
    terminal.send("\x1b");
    // Esc alone is a key only once nothing has followed it.
    terminal.wait_for("Quit?");
    terminal.send("y");
    assert_eq!(ended(&mut terminal), 0);
}
