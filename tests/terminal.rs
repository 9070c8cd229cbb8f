//! Drives the terminal display through a pseudo-terminal, as a user and a terminal would.
#![cfg(all(unix, feature = "terminal"))]

#[path = "common/pty.rs"]
#[allow(dead_code, reason = "every test file uses its own part of this")]
mod pty;

use portable_pty::{CommandBuilder, PtySize, native_pty_system};
use pty::{PLAIN, Terminal};
use std::path::PathBuf;
use std::time::Duration;

/// What is started and what it shows: the only part that knows the program.
mod program {
    pub(super) const NAME: &str = "display_probe";
    pub(super) const ARGUMENTS: [&str; 2] = ["terminal", "en"];
    pub(super) const TITLE: &str = "DISPLAY PROBE őű ÁRVÍZTŰRŐ";
    /// A key, and what the screen says after it.
    pub(super) const KEY: (&str, &str) = ("é", "Key(Char('é'))");
    /// A click at a cell (from 0) makes the cell this colour.
    pub(super) const CLICK: ((u16, u16), vt100::Color) = ((40, 20), vt100::Color::Rgb(255, 255, 85));
    pub(super) const QUESTION: &str = "Close? y/n";
    pub(super) const YES: &str = "y";
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

/// A terminal with the program in it.
fn started(columns: u16, rows: u16, answers: &str) -> Terminal {
    let mut command = CommandBuilder::new(path());
    command.args(program::ARGUMENTS);
    command.env("COLORTERM", "truecolor");
    let mut terminal = Terminal::start(columns, rows, command);
    terminal.answer(answers);
    terminal
}

/// Whether the program ended well.
#[track_caller]
fn ended_well(terminal: &mut Terminal) -> bool {
    terminal.wait_for_end();
    terminal.child.wait().unwrap().success()
}

#[track_caller]
fn assert_restored(terminal: &mut Terminal) {
    terminal
        .wait("the ordinary screen", |terminal| !terminal.screen.lock().unwrap().screen().alternate_screen());
    let parser = terminal.screen.lock().unwrap();
    assert!(!parser.screen().hide_cursor(), "the cursor is hidden");
    assert_eq!(parser.screen().mouse_protocol_mode(), vt100::MouseProtocolMode::None);
}

/// A whole visit: texts, a key, a click, a small terminal, closing.
#[test]
fn block_characters_from_start_to_end() {
    let mut terminal = started(80, 30, PLAIN);
    terminal.wait_for(program::TITLE);
    terminal.send(program::KEY.0);
    terminal.wait_for(program::KEY.1);

    let ((column, row), color) = program::CLICK;
    terminal.send(&format!("\x1b[<0;{x};{y}M\x1b[<0;{x};{y}m", x = column + 1, y = row + 1));
    // The pointer stands on the clicked cell itself.
    terminal.send("\x1b[<35;1;1M");
    terminal.wait("the mark of the click", |terminal| {
        let parser = terminal.screen.lock().unwrap();
        parser.screen().cell(row, column).is_some_and(|cell| cell.bgcolor() == color)
    });

    terminal.resize(59, 20);
    terminal.wait("the message on the size", |terminal| terminal.shows("59x20") && terminal.shows("60x20"));
    assert!(!terminal.shows(program::TITLE));
    // Esc goes back, but the program asks first.
    terminal.send("\x1b");
    terminal.wait_for("question before the end");
    terminal.resize(60, 20);
    terminal.wait_for(program::QUESTION);
    terminal.send("n");
    terminal.resize(120, 45);
    terminal.wait_for(program::TITLE);
    terminal.resize(80, 30);
    terminal.wait_for(program::TITLE);

    terminal.send("\x03");
    terminal.wait_for(program::QUESTION);
    terminal.send("\x03");
    std::thread::sleep(Duration::from_millis(100));
    assert!(terminal.running() && terminal.shows(program::QUESTION));
    terminal.send(program::YES);
    assert!(ended_well(&mut terminal));
    assert_restored(&mut terminal);
}

#[test]
fn line_discipline_is_restored() {
    let mut terminal = started(80, 30, PLAIN);
    terminal.wait_for(program::TITLE);
    let raw = terminal.master.get_termios().unwrap();
    terminal.send("\x03");
    terminal.wait_for(program::QUESTION);
    terminal.send(program::YES);
    assert!(ended_well(&mut terminal));
    let fresh = native_pty_system().openpty(PtySize::default()).unwrap();
    let ordinary = fresh.master.get_termios().unwrap();
    assert_ne!(raw.local_flags, ordinary.local_flags);
    assert_eq!(terminal.master.get_termios().unwrap().local_flags, ordinary.local_flags);
}

#[test]
fn a_signal_leaves_the_terminal_in_order() {
    let mut terminal = started(80, 30, PLAIN);
    terminal.wait_for(program::TITLE);
    // Sends the signal of a closed terminal.
    terminal.child.kill().unwrap();
    assert!(!ended_well(&mut terminal));
    assert_restored(&mut terminal);
}

#[test]
fn a_terminal_that_answers_nothing_is_served_too() {
    let mut terminal = started(80, 30, "");
    terminal.wait_for(program::TITLE);
}

#[test]
fn the_keyboard_moves_and_presses_the_mouse() {
    let mut terminal = started(80, 30, PLAIN);
    terminal.wait_for(program::TITLE);
    let pointer = |terminal: &Terminal| {
        let contents = terminal.contents();
        contents.lines().position(|line| line.contains('↖'))
    };
    terminal.wait_for("↖");
    let before = pointer(&terminal).unwrap();
    // Ctrl and arrow up, twice: one row.
    terminal.send("\x1b[1;5A\x1b[1;5A");
    terminal.wait("the pointer one row higher", |terminal| pointer(terminal) == Some(before - 1));
}

/// What Kitty answers, with cells of 10x20 pixels.
const KITTY: &str = "\x1b_Gi=31;OK\x1b\\\x1b[?0u\x1b[?1016;2$y\x1b[4;600;1000t\x1b[6;20;10t\x1b[?62;c";

#[test]
fn kitty_gets_its_graphics() {
    let mut terminal = started(100, 30, KITTY);
    terminal.wait("a picture", |terminal| terminal.wrote(b"\x1b_Ga=T,f=100,"));
    assert!(terminal.wrote(b"\x1b[?1016h") && !terminal.shows(program::TITLE));
    terminal.send("\x03");
    terminal.send(program::YES);
    assert!(ended_well(&mut terminal));
    terminal.wait("the picture's deletion", |terminal| terminal.wrote(b"\x1b_Ga=d,"));
    assert!(terminal.wrote(b"\x1b[?1016l"));
    assert_restored(&mut terminal);
}

#[test]
fn sixel_terminals_get_sixel() {
    let mut terminal = started(80, 30, "\x1b[6;20;10t\x1b[?62;4;22c");
    terminal.wait("a picture", |terminal| terminal.wrote(b"\x1bP0;1;0q\"1;1;640;480"));
    terminal.send(program::KEY.0);
    // Only the changed part is sent again.
    terminal.wait("a part of the picture", |terminal| {
        let output = terminal.output.lock().unwrap();
        output.windows(8).filter(|window| window == b"\x1bP0;1;0q").count() > 1
    });
    assert!(!terminal.wrote(b"\x1b_Ga=T"));
}

/// On a line of 115 200 baud the last picture is there within a second after the last key.
#[test]
fn a_slow_line_shows_the_last_picture_soon() {
    let folder = tempfile::TempDir::new().unwrap();
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_gb_2d_ip"));
    command.args(["A.IP2", "--display", "terminal", "--lang", "en"]);
    command.env("COLORTERM", "truecolor");
    command.env("LC_ALL", "C.UTF-8");
    command.env("XDG_STATE_HOME", folder.path());
    command.env("XDG_CONFIG_HOME", folder.path());
    let mut terminal = Terminal::start_on(80, 24, command, Some(115_200 / 10));
    terminal.answer(PLAIN);
    terminal.wait_for("-change");
    std::thread::sleep(Duration::from_secs(2));
    // Somebody drags point 37 about, faster than the line can show it.
    terminal.send("\x1b[<0;38;13M");
    for turn in 0..200 {
        let (column, row) = (36 + turn % 9, 12 + turn % 5);
        terminal.send(&format!("\x1b[<32;{column};{row}M"));
        std::thread::sleep(Duration::from_millis(10));
    }
    terminal.send("\x1b[<0;30;21m\x1b[<35;30;21M");
    std::thread::sleep(Duration::from_secs(1));
    let pointer = |terminal: &Terminal| {
        let parser = terminal.screen.lock().unwrap();
        parser.screen().cell(20, 29).map(|cell| cell.bgcolor())
    };
    assert_eq!(pointer(&terminal), Some(vt100::Color::Rgb(170, 0, 0)), "{}", terminal.contents());
}

/// While something turns, at most 200 KiB a second are sent, with graphics too.
#[test]
fn what_moves_does_not_flood_the_line() {
    let kitty = "\x1b_Gi=31;OK\x1b\\\x1b[6;20;10t\x1b[?62;c";
    let sixel = "\x1b[6;20;10t\x1b[?62;4c";
    // At the same time: nearly all of it is waiting.
    std::thread::scope(|scope| {
        for answers in [kitty, sixel, PLAIN] {
            scope.spawn(|| assert_no_flood(answers));
        }
    });
}

#[track_caller]
fn assert_no_flood(answers: &str) {
    let folder = tempfile::TempDir::new().unwrap();
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_gyongy_k"));
    command.args(["--display", "terminal", "--lang", "en"]);
    command.env("COLORTERM", "truecolor");
    command.env("LC_ALL", "C.UTF-8");
    command.env("XDG_STATE_HOME", folder.path());
    command.env("XDG_CONFIG_HOME", folder.path());
    let mut terminal = Terminal::start(120, 40, command);
    terminal.answer(answers);
    std::thread::sleep(Duration::from_millis(700));
    terminal.send("\x1b");
    std::thread::sleep(Duration::from_millis(300));
    // The demonstration.
    terminal.send("x");
    std::thread::sleep(Duration::from_secs(5));
    let sent = || terminal.output.lock().unwrap().len();
    let before = sent();
    std::thread::sleep(Duration::from_secs(3));
    let sent = sent() - before;
    assert!(sent > 2000, "nothing moves: {sent} bytes");
    // The last picture of the time before is among them.
    assert!(sent < 200 * 1024 * 3 + 100_000, "{sent} bytes in three seconds");
}
