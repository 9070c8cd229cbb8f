//! Somebody without a mouse, in tmux, in a terminal of 80x24: a curve is made and saved, a puzzle solved.
#![cfg(all(unix, feature = "terminal"))]

#[path = "common/needs.rs"]
mod needs;

use grafika::file::{Document, Format};
use grafika::puzzle::wheel::{Search, Solver, Wheel, moves_to_text};
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// A tmux of its own, with a shell in its only window.
struct Tmux {
    folder: TempDir,
}

impl Tmux {
    /// Starts a program in the shell.
    fn running(program: &str) -> Option<Tmux> {
        let tmux = Tmux::start()?;
        tmux.wait_for("bash-");
        tmux.type_line(&format!("{program} --display terminal --lang en"));
        Some(tmux)
    }

    /// `None` where there is no tmux; a machine that promises all tests must have one.
    fn start() -> Option<Tmux> {
        let folder = TempDir::new().unwrap();
        let tmux = Tmux { folder };
        let mut command = tmux.command();
        command.args(["new-session", "-d", "-x", "80", "-y", "24", "bash --norc --noprofile -i"]);
        command.args([";", "set", "status", "off", ";", "resize-window", "-x", "80", "-y", "24"]);
        match command.output() {
            Ok(output) => {
                assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
                Some(tmux)
            }
            Err(error) => {
                needs::left_out(&format!("tmux cannot be started ({error})"));
                None
            }
        }
    }

    fn path(&self) -> &Path {
        self.folder.path()
    }

    fn command(&self) -> Command {
        let mut command = Command::new("tmux");
        command.arg("-S").arg(self.path().join("socket")).args(["-f", "/dev/null"]);
        command
            .current_dir(self.path())
            .env("XDG_STATE_HOME", self.path())
            .env("XDG_CONFIG_HOME", self.path());
        command.env("LC_ALL", "C.UTF-8").env_remove("TMUX");
        command
    }

    fn run(&self, arguments: &[&str]) -> Output {
        self.command().args(arguments).output().unwrap()
    }

    /// What the window shows.
    fn shown(&self) -> String {
        String::from_utf8_lossy(&self.run(&["capture-pane", "-p"]).stdout).into_owned()
    }

    #[track_caller]
    fn wait(&self, what: &str, come: impl Fn(&str) -> bool) {
        let end = Instant::now() + Duration::from_secs(30);
        while !come(&self.shown()) {
            assert!(Instant::now() < end, "{what} did not come; tmux shows\n{}", self.shown());
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    #[track_caller]
    fn wait_for(&self, text: &str) {
        self.wait(text, |shown| shown.contains(text));
    }

    /// Sends keys by tmux's names.
    fn keys(&self, keys: &[&str]) {
        self.run(&[&["send-keys"], keys].concat());
        std::thread::sleep(Duration::from_millis(30));
    }

    fn many(&self, key: &str, times: usize) {
        self.keys(&vec![key; times]);
    }

    fn type_line(&self, line: &str) {
        self.run(&["send-keys", "-l", line]);
        self.keys(&["Enter"]);
    }
}

impl Drop for Tmux {
    fn drop(&mut self) {
        let _ = self.command().arg("kill-server").output();
    }
}

#[test]
fn a_spline_without_a_mouse() {
    let Some(tmux) = Tmux::running(env!("CARGO_BIN_EXE_gb_2d_ip")) else { return };
    tmux.wait_for("U-new");
    tmux.keys(&["u"]);
    tmux.wait_for("B-insert");
    // The pointer goes into the field, to five places; the key of the button is pressed and released at each.
    tmux.many("C-Up", 60);
    tmux.many("C-Left", 80);
    tmux.many("C-Down", 45);
    tmux.many("C-Right", 12);
    for (times, key) in [(10, "C-Up"), (12, "C-Up"), (0, "C-Down"), (14, "C-Down"), (10, "C-Up")] {
        tmux.many(key, times);
        tmux.many("C-Right", 10);
        tmux.keys(&["C-Space", "C-Space"]);
    }
    tmux.wait("five points", |shown| ["1", "2", "3", "4", "5"].iter().all(|number| shown.contains(number)));
    tmux.keys(&["g"]);
    tmux.wait_for("N-open");
    tmux.keys(&["n"]);
    tmux.keys(&["3"]);
    tmux.wait("the curve", |shown| shown.chars().filter(|ch| ('⠁'..='⣿').contains(ch)).count() > 20);

    // A pause: the shell has the terminal, and `fg` brings back the picture.
    tmux.keys(&["C-M-z"]);
    tmux.wait("the shell", |shown| shown.contains("Stopped") && !shown.contains("B-insert"));
    tmux.type_line("fg");
    tmux.wait("the picture", |shown| {
        shown.contains("B-insert") && shown.chars().filter(|ch| ('⠁'..='⣿').contains(ch)).count() > 20
    });

    tmux.keys(&["C-s"]);
    tmux.wait_for("name");
    tmux.type_line("SPLINE");
    let saved = tmux.path().join("SPLINE.IP2");
    tmux.wait("the file", |_| saved.exists());
    let document = Document::read(Format::Ip2, &std::fs::read(&saved).unwrap()).unwrap();
    assert!(document.describe().iter().any(|line| line.contains('5')), "{:?}", document.describe());
    tmux.keys(&["C-c"]);
    tmux.wait("the end", |shown| !shown.contains("B-insert"));
}

#[test]
fn a_wheel_of_four_moves_without_a_mouse() {
    let Some(tmux) = Tmux::running(env!("CARGO_BIN_EXE_gyongy_k")) else { return };
    tmux.wait_for("Enter");
    // The proposal is a game of four moves.
    tmux.keys(&["Enter"]);
    tmux.wait_for("Moves: 0");
    let shown = tmux.shown();
    let position = |word: &&str| word.len() == 31 && word.matches('-').count() == 6;
    let position =
        shown.split_whitespace().find(position).unwrap_or_else(|| panic!("no position in\n{shown}"));
    let wheel: Wheel = position.parse().unwrap();
    let mut solver = Solver::new(wheel);
    while solver.step(100_000).search == Search::Working {}
    let moves = moves_to_text(&solver.solution().unwrap().moves);
    assert_eq!(moves.len(), 4, "{moves}");
    for letter in moves.chars() {
        tmux.keys(&[&letter.to_string()]);
        std::thread::sleep(Duration::from_millis(700));
    }
    tmux.wait_for("0-1111-2222-3333-4444-5555-6666");
    tmux.wait_for("Moves: 4");
}
