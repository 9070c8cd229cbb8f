//! The command line where people use it: in a terminal that asks, in shells that complete, and as manual pages. Shells and
//! programs that are not there are left out, which is told.
#![cfg(all(unix, feature = "terminal"))]

#[path = "common/needs.rs"]
mod needs;
#[path = "common/pty.rs"]
#[allow(dead_code, reason = "every test file uses its own part of this")]
mod pty;

use portable_pty::CommandBuilder;
use pty::Terminal;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

const GRAFIKA: &str = env!("CARGO_BIN_EXE_grafika");

/// Starts a command with the words of a line in a terminal.
fn started(program: &str, line: &str, folder: &Path) -> Terminal {
    let mut command = CommandBuilder::new(program);
    command.args(line.split_whitespace());
    command.cwd(folder);
    let path = std::env::var("PATH").unwrap_or_default();
    command.env("PATH", format!("{}:{path}", folder.join("bin").display()));
    command.env("LC_ALL", "C.UTF-8");
    command.env("HOME", folder);
    Terminal::start(100, 30, command)
}

fn ended(terminal: &mut Terminal) -> u32 {
    terminal.wait_for_end();
    terminal.child.wait().unwrap().exit_code()
}

#[test]
fn a_terminal_is_asked_before_a_file_is_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.json");
    let lines =
        ["convert A.IP2 a.json", "render A.IP2 --method spline -o a.json --to svg", "poly x+1 -o a.json"];
    for line in lines {
        for (answer, status) in [("n\r", 1), ("\r", 1), ("\u{4}", 1), ("y\r", 0), ("Igen\r", 0)] {
            fs::write(&file, "mine").unwrap();
            let mut terminal = started(GRAFIKA, line, folder.path());
            terminal.wait_for("a.json is there already. Overwrite it? [y/N]");
            terminal.send(answer);
            assert_eq!(ended(&mut terminal), status, "{line} {answer:?}");
            assert_eq!(fs::read(&file).unwrap() == b"mine", status == 1, "{line} {answer:?}");
        }
        // Whoever has said it is not asked.
        for (option, status) in [("--force", 0), ("--no-clobber", 1)] {
            fs::write(&file, "mine").unwrap();
            let mut terminal = started(GRAFIKA, &format!("{line} {option}"), folder.path());
            assert_eq!(ended(&mut terminal), status, "{line} {option}");
            assert!(!terminal.shows("Overwrite it?"));
            assert_eq!(fs::read(&file).unwrap() == b"mine", status == 1, "{line} {option}");
        }
    }
}

#[test]
fn a_terminal_is_not_filled_with_what_is_no_text() {
    let folder = tempfile::tempdir().unwrap();
    for line in ["convert A.IP2 - --to ip2", "render A.IP2 --method spline -o - --to png"] {
        let mut terminal = started(GRAFIKA, line, folder.path());
        terminal.wait_for("this is not text, and standard output is a terminal");
        assert_eq!(ended(&mut terminal), 2, "{line}");
    }
    let mut terminal = started(GRAFIKA, "convert A.IP2 - --to json", folder.path());
    assert_eq!(ended(&mut terminal), 0);
}

/// Whether a program is here; that it is not is told, and wrong on a machine that promises all tests.
fn is_here(program: &str) -> bool {
    let here = Command::new("sh").args(["-c", &format!("command -v {program}")]).output();
    let here = here.is_ok_and(|output| output.status.success());
    if !here {
        needs::left_out(&format!("there is no {program} here"));
    }
    here
}

/// A folder with the programs and some files.
fn shelf() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("bin")).unwrap();
    for name in ["grafika", "gb_2d_ip"] {
        symlink(GRAFIKA, folder.path().join("bin").join(name)).unwrap();
    }
    fs::write(folder.path().join("measured.csv"), "1,2\n").unwrap();
    fs::create_dir(folder.path().join("drawings")).unwrap();
    folder
}

/// Lines before the Tab key, and what they become.
const TYPED: [(&str, &str); 9] = [
    ("grafika rende", "grafika render"),
    ("grafika info TERE", "grafika info TEREP.XYZ"),
    ("grafika info meas", "grafika info measured.csv"),
    ("grafika convert A.IP2 x --to js", "--to json"),
    ("grafika config pale", "grafika config palette"),
    ("grafika config palette am", "grafika config palette amber"),
    ("grafika config folder draw", "grafika config folder drawings/"),
    ("grafika render A.IP2 --method phs", "--method phspline"),
    ("gb_2d_ip --displ", "gb_2d_ip --display"),
];

/// Types lines into a shell that has read the completions.
fn types(shell: &str, options: &str, reads: &str, after: &str) {
    if !is_here(shell) {
        return;
    }
    let folder = shelf();
    let mut terminal = started(shell, options, folder.path());
    for name in ["grafika", "gb_2d_ip"] {
        terminal.send(&reads.replace("NAME", name));
    }
    terminal.send(after);
    // Put together here, so that the line itself is not taken for the answer.
    terminal.send("printf '%s%s\\n' rea dy\r");
    terminal.wait_for("ready");
    for (typed, becomes) in TYPED {
        terminal.send("\u{c}");
        terminal.send(typed);
        terminal.wait_for(typed);
        terminal.send("\t");
        terminal.wait(becomes, |terminal| {
            let lines = terminal.contents();
            lines.lines().any(|line| line.contains(becomes))
        });
        // Away with the line.
        terminal.send("\u{15}");
    }
}

#[test]
fn bash_completes() {
    let reads = "source <(grafika completions bash NAME)\r";
    types("bash", "--norc --noprofile -i", reads, "bind 'set enable-bracketed-paste off'\r");
}

#[test]
fn zsh_completes() {
    let compinit = "autoload -U compinit; compinit -u -D; unsetopt zle_bracketed_paste\r";
    // Read at the start, and from a folder of functions.
    let reads = "(($+functions[compdef])) || { autoload -U compinit; compinit -u -D }; source <(grafika completions zsh NAME)\r";
    types("zsh", "-f -i", reads, "unsetopt zle_bracketed_paste\r");
    let reads = "mkdir -p fn; fpath=($PWD/fn $fpath); grafika completions zsh NAME > fn/_NAME\r";
    types("zsh", "-f -i", reads, compinit);
}

#[test]
fn fish_completes() {
    if !is_here("fish") {
        return;
    }
    let folder = shelf();
    for (typed, becomes) in TYPED {
        let asks = format!(
            "grafika completions fish | source; grafika completions fish gb_2d_ip | source; complete -C '{typed}'"
        );
        let path = std::env::var("PATH").unwrap_or_default();
        let output = Command::new("fish")
            .args(["--no-config", "-c", &asks])
            .current_dir(folder.path())
            .env("PATH", format!("{}:{path}", folder.path().join("bin").display()))
            .env("HOME", folder.path())
            .output()
            .unwrap();
        let told = String::from_utf8_lossy(&output.stdout).into_owned();
        let word = becomes.rsplit(' ').next().unwrap();
        let found = told.lines().any(|line| line.split('\t').next() == Some(word));
        assert!(found, "{typed}: {told}{}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn manual_pages_are_clean() {
    if !is_here("mandoc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let made = Command::new(GRAFIKA).arg("man").arg(folder.path()).status().unwrap();
    assert!(made.success());
    let pages: Vec<_> = fs::read_dir(folder.path()).unwrap().flatten().map(|entry| entry.path()).collect();
    assert!(pages.len() > 60);
    for page in pages {
        let lint = Command::new("mandoc").args(["-T", "lint"]).arg(&page).output().unwrap();
        let told =
            String::from_utf8_lossy(&lint.stdout).into_owned() + &String::from_utf8_lossy(&lint.stderr);
        assert_eq!(told, "", "{}", page.display());
    }
}
