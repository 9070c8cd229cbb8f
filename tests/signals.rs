//! Signals to a program in a terminal: the terminal is given back and taken again, the exit status is 128 + n, and
//! unsaved work is kept.
#![cfg(all(unix, feature = "terminal"))]

#[path = "common/pty.rs"]
#[allow(dead_code, reason = "every test file uses its own part of this")]
mod pty;

use portable_pty::CommandBuilder;
use pty::{PLAIN, Terminal};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};
use tempfile::TempDir;

const PROGRAM: &str = env!("CARGO_BIN_EXE_gb_p_2d");
const UP: &str = "\x1b[A";

fn command(name: &str, arguments: &[&str], folder: &Path) -> CommandBuilder {
    let mut command = CommandBuilder::new(name);
    command.args(arguments);
    command.env("XDG_STATE_HOME", folder);
    command.cwd(folder);
    command
}

/// The program in a terminal, with one change made.
fn started(folder: &Path) -> Terminal {
    let command = command(PROGRAM, &["A.GBP", "--display", "terminal", "--lang", "en"], folder);
    let mut terminal = Terminal::start(80, 30, command);
    terminal.answer(PLAIN);
    terminal.wait_for("-change");
    terminal
}

fn signal(name: &str, process: i32) {
    let sent = Command::new("kill").args([&format!("-{name}"), "--", &process.to_string()]).status();
    assert!(sent.unwrap().success());
}

#[track_caller]
fn wait_until_given_back(terminal: &mut Terminal) {
    terminal.wait("the terminal as it was", |terminal| {
        let parser = terminal.screen.lock().unwrap();
        let screen = parser.screen();
        !screen.alternate_screen()
            && !screen.hide_cursor()
            && screen.mouse_protocol_mode() == vt100::MouseProtocolMode::None
    });
}

#[track_caller]
fn wait_until_taken(terminal: &mut Terminal) {
    terminal.wait("the program's screen", |terminal| {
        let parser = terminal.screen.lock().unwrap();
        let screen = parser.screen();
        screen.alternate_screen()
            && screen.hide_cursor()
            && screen.mouse_protocol_mode() != vt100::MouseProtocolMode::None
    });
    terminal.wait_for("-change");
}

#[test]
fn a_signal_is_the_exit_status_and_the_terminal_is_given_back() {
    for (name, number) in [("HUP", 1), ("INT", 2), ("QUIT", 3), ("TERM", 15)] {
        let folder = TempDir::new().unwrap();
        let mut terminal = started(folder.path());
        terminal.send(UP);
        signal(name, terminal.child.process_id().unwrap() as i32);
        terminal.wait_for_end();
        assert_eq!(terminal.child.wait().unwrap().exit_code(), 128 + number, "{name}");
        wait_until_given_back(&mut terminal);
        terminal.wait_for(&format!("signal {number}"));
    }
}

/// An interactive shell with the program in the foreground, and the program's process group.
fn in_a_shell(folder: &Path) -> (Terminal, i32) {
    let mut shell = command("bash", &["--norc", "--noprofile", "-i"], folder);
    shell.env("PS1", "ready> ");
    let mut terminal = Terminal::start(80, 30, shell);
    terminal.wait_for("ready>");
    let shell = terminal.master.process_group_leader().unwrap();
    terminal.send(&format!("'{PROGRAM}' A.GBP --display terminal --lang en\r"));
    terminal.answer(PLAIN);
    terminal.wait_for("-change");
    let program = terminal.master.process_group_leader().unwrap();
    assert_ne!(program, shell);
    (terminal, program)
}

#[test]
fn a_pause_gives_the_terminal_to_the_shell_and_fg_takes_it_again() {
    // The last one cannot be noticed by a program before it happens.
    for (name, prepared) in [("TSTP", true), ("STOP", false)] {
        let folder = TempDir::new().unwrap();
        let (mut terminal, program) = in_a_shell(folder.path());
        let raw = terminal.master.get_termios().unwrap().local_flags;
        for _ in 0..2 {
            signal(name, -program);
            terminal.wait("the shell", |terminal| terminal.master.process_group_leader() != Some(program));
            if prepared {
                wait_until_given_back(&mut terminal);
                terminal.wait_for("ready>");
            }
            terminal.send("fg\r");
            terminal.wait("the program", |terminal| terminal.master.process_group_leader() == Some(program));
            wait_until_taken(&mut terminal);
            terminal.wait("raw input", |terminal| {
                terminal.master.get_termios().is_some_and(|now| now.local_flags == raw)
            });
        }
        // Keys reach it, and it ends well.
        terminal.send("u");
        // The first arrow chooses the coefficient, the second changes it.
        (0..2).for_each(|_| terminal.send(UP));
        terminal.send("\x03");
        terminal.wait_for("N-no");
        terminal.send("n");
        terminal.wait("the shell", |terminal| terminal.master.process_group_leader() != Some(program));
        wait_until_given_back(&mut terminal);
    }
}

#[test]
fn a_terminal_that_goes_away_leaves_the_work_kept_and_nothing_spinning() {
    let folder = TempDir::new().unwrap();
    let inner = format!("trap : HUP; '{PROGRAM}' A.GBP --display terminal --lang en; echo $? > status");
    // Another program owns the inner terminal, which goes with it.
    let mut terminal =
        Terminal::start(80, 30, command("script", &["-qc", &inner, "/dev/null"], folder.path()));
    terminal.answer(PLAIN);
    terminal.wait_for("-change");
    terminal.send("u");
    (0..2).for_each(|_| terminal.send(UP));
    let kept = || {
        let entries = std::fs::read_dir(folder.path().join("grafika/recovery"));
        let mut paths = entries.into_iter().flatten().flatten().map(|entry| entry.path());
        paths.find(|path| path.extension().is_some_and(|ending| ending == "unsaved"))
    };
    terminal.wait("the kept work", |_| kept().is_some());
    signal("KILL", terminal.child.process_id().unwrap() as i32);
    let status = folder.path().join("status");
    let end = Instant::now() + Duration::from_secs(20);
    while !std::fs::read_to_string(&status).is_ok_and(|text| text.ends_with('\n')) {
        assert!(Instant::now() < end, "the program goes on without a terminal");
        std::thread::sleep(Duration::from_millis(10));
    }
    assert_eq!(std::fs::read_to_string(status).unwrap(), "1\n");
    let kept = kept().expect("the work is still there");
    use std::os::unix::fs::PermissionsExt;
    assert_eq!(std::fs::metadata(kept).unwrap().permissions().mode() & 0o777, 0o600);
}
