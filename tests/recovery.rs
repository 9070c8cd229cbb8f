//! Programs that are killed for real: a Fourier editor in a pseudo-terminal, whose unsaved work must outlive
//! SIGKILL at any moment.
#![cfg(all(unix, feature = "terminal"))]

#[path = "common/pty.rs"]
#[allow(dead_code, reason = "every test file uses its own part of this")]
mod pty;

use portable_pty::CommandBuilder;
use pty::{PLAIN, Terminal};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

const UP: &str = "\x1b[A";

/// GB_P_2D in a terminal of its own, with a folder for its state, in which it runs, too.
fn started(state: &Path, arguments: &[&str]) -> Terminal {
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_gb_p_2d"));
    command.args(["--display", "terminal", "--lang", "en"]);
    command.args(arguments);
    command.env("XDG_STATE_HOME", state);
    command.cwd(state);
    let mut terminal = Terminal::start(80, 30, command);
    terminal.answer(PLAIN);
    terminal
}

/// Ends the process as nothing can that it could prepare for.
fn kill(mut terminal: Terminal) {
    let process = terminal.child.process_id().expect("it runs").to_string();
    let killed = std::process::Command::new("kill").args(["-9", &process]).status().unwrap();
    assert!(killed.success());
    terminal.child.wait().unwrap();
}

/// A scratch folder, gone at the end.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Scratch {
        let path = std::env::temp_dir().join(format!("grafika-killed-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        Scratch(path)
    }

    /// The files of unsaved work.
    fn kept(&self) -> Vec<PathBuf> {
        let entries = std::fs::read_dir(self.0.join("grafika/recovery"));
        let paths = entries.into_iter().flatten().flatten().map(|entry| entry.path());
        paths.filter(|path| path.extension().is_some_and(|ending| ending == "unsaved")).collect()
    }

    /// The radius of the circle in the only unsaved work; 100 is that of the start.
    fn radius(&self) -> f64 {
        let kept = self.kept();
        let Some(path) = kept.first() else { return 100.0 };
        assert_eq!(kept.len(), 1);
        let text = std::fs::read_to_string(path).unwrap();
        let (_, work) = text.split_once('\n').unwrap();
        let work: serde_json::Value = serde_json::from_str(work).expect("the file is whole");
        work["a"][1].as_f64().expect("it holds coefficients")
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// The time after which no change may be missing.
const SAFE: Duration = Duration::from_secs(1);

/// Changes the first radius by 1 every so often until the time has come, kills the program, and gives the age
/// of the oldest change that is missing.
fn kill_after(number: u64) -> Duration {
    let scratch = Scratch::new(&number.to_string());
    let mut terminal = started(&scratch.0, &[]);
    terminal.wait_for("-new");
    terminal.send("u");
    terminal.wait_for("-change");
    // The first arrow chooses the coefficient, the others change it.
    terminal.send(UP);
    let life = Duration::from_millis(150 + 131 * number);
    let begun = Instant::now();
    let mut sent = Vec::new();
    while begun.elapsed() < life {
        terminal.send(UP);
        sent.push(Instant::now());
        std::thread::sleep(Duration::from_millis(7 + number % 5));
    }
    let killed = Instant::now();
    kill(terminal);
    let found = scratch.radius() - 100.0;
    assert!(found.fract() == 0.0 && found >= 0.0 && found <= sent.len() as f64, "{found} of {}", sent.len());
    let missing = sent.get(found as usize).map_or(Duration::ZERO, |&oldest| killed.duration_since(oldest));
    println!("killed after {life:?}: {} changes, {found} kept, the oldest missing {missing:?}", sent.len());
    assert!(missing < SAFE, "{missing:?}");
    // The next start offers it and takes it up.
    let mut terminal = started(&scratch.0, &[]);
    if found > 0.0 {
        terminal.wait_for("unexpectedly");
        terminal.send("i");
        terminal.wait_for("-change");
        (0..2).for_each(|_| terminal.send(UP));
        terminal.wait("the kept change", |_| scratch.radius() == 101.0 + found);
    } else {
        terminal.wait_for("-new");
    }
    kill(terminal);
    missing
}

#[test]
fn a_kill_at_any_moment_costs_less_than_a_second() {
    let worst = std::thread::scope(|scope| {
        let lanes: Vec<_> = (0..2)
            .map(|lane| scope.spawn(move || (0..6).map(|turn| kill_after(2 * turn + lane)).max()))
            .collect();
        lanes.into_iter().filter_map(|lane| lane.join().expect("every kill costs less")).max()
    });
    println!("the worst: {worst:?}");
}

#[test]
fn a_closed_terminal_loses_nothing_and_a_running_session_is_not_offered() {
    let scratch = Scratch::new("closed");
    let mut terminal = started(&scratch.0, &[]);
    terminal.wait_for("-new");
    terminal.send("u");
    terminal.wait_for("-change");
    // The first chooses the coefficient.
    (0..6).for_each(|_| terminal.send(UP));
    terminal.wait("the fifth change", |_| scratch.radius() == 105.0);

    let mut other = started(&scratch.0, &[]);
    other.wait_for("-new");
    other.send("u");
    other.wait_for("-change");
    // In order: nothing is left of it.
    other.send("\x03");
    other.wait_for_end();

    (0..3).for_each(|_| terminal.send(UP));
    terminal.wait_for("108");
    // The signal of a closed terminal.
    terminal.child.kill().unwrap();
    terminal.wait_for_end();
    assert_eq!(scratch.radius(), 108.0, "the last changes were written at the end");

    // Saved, it is not kept any more.
    let mut terminal = started(&scratch.0, &[]);
    terminal.wait_for("unexpectedly");
    terminal.send("i");
    terminal.wait_for("-change");
    terminal.send("\x13");
    terminal.wait_for("File");
    terminal.send("safe\r");
    terminal.wait("the end of the unsaved work", |_| scratch.kept().is_empty());
    assert!(scratch.0.join("SAFE.GBP").exists());
    kill(terminal);
    let mut terminal = started(&scratch.0, &["SAFE.GBP"]);
    terminal.wait_for("-change");
    // The program knows the file that the command line named.
    let file = scratch.0.join("SAFE.GBP");
    std::fs::write(&file, "another program's").unwrap();
    terminal.send("\x13");
    terminal.wait_for("File");
    terminal.send("safe\r");
    terminal.wait_for("changed");
    terminal.send("n");
    kill(terminal);
    assert_eq!(std::fs::read_to_string(file).unwrap(), "another program's");
}
