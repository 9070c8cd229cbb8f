//! The examples that the help of the commands shows do what they say, in a folder with the samples and with the files that
//! they take for the user's own.
#![cfg(all(unix, feature = "native"))]

use std::path::Path;
use std::process::{Command, Output};
use std::{env, fs};

/// Commands that ask, or change what lies outside the folder.
const LEFT_OUT: [&str; 4] = ["open", "install", "uninstall", "config"];
/// Lasts a minute.
const LONG: &str = "grafika solve --count";
/// Tells by its exit status that the sample is wrong, as it is meant to.
const WRONG: &str = "grafika skin ROSSZ.KOR --check";

/// Runs a line as a shell does.
fn run(folder: &Path, line: &str) -> Output {
    let programs = Path::new(env!("CARGO_BIN_EXE_grafika")).parent().expect("it is in a folder");
    let path = format!("{}:{}", programs.display(), env::var("PATH").unwrap_or_default());
    let input = fs::File::open(folder.join("A.IP2")).expect("the samples are there");
    let mut command = Command::new("sh");
    command
        .args(["-c", line])
        .current_dir(folder)
        .env("PATH", path)
        .env("HOME", folder)
        .env("LC_ALL", "C.UTF-8");
    command.stdin(input).output().expect("there is a shell")
}

fn help(folder: &Path, command: &str) -> String {
    let output = run(folder, &format!("grafika {command} --help"));
    String::from_utf8(output.stdout).expect("help is text")
}

/// The subcommands that a help lists.
fn listed(help: &str) -> Vec<String> {
    let lines =
        help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    lines
        .filter_map(|line| line.split_whitespace().next())
        .filter(|name| *name != "help")
        .map(str::to_owned)
        .collect()
}

#[test]
fn examples_of_the_help_do_what_they_say() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for sample in fs::read_dir("data").unwrap().map(Result::unwrap) {
        if sample.file_type().unwrap().is_file() {
            fs::copy(sample.path(), folder.join(sample.file_name())).unwrap();
        }
    }
    for (own, sample) in [("arc.kcg", "HELIX.KCG"), ("FILE.CSK", "A.CSK")] {
        fs::copy(folder.join(sample), folder.join(own)).unwrap();
    }
    for own in ["measured.csv", "scope.csv"] {
        fs::write(folder.join(own), "time,volts\n0,1\n1,2.5\n2,2\n3,4\n4,3.5\n5,6\n6,5\n7,5.5\n").unwrap();
    }
    for made in [
        "grafika convert TEREP.XYZ scan.ply",
        "grafika exact SNAIL.KCE --interval-u 0,1 --interval-v 0,1 -o patch.kcf",
    ] {
        assert!(run(folder, made).status.success(), "{made}");
    }
    let commands = listed(&help(folder, ""));
    let mut lines = Vec::new();
    for command in commands.iter().filter(|name| !LEFT_OUT.contains(&name.as_str())) {
        let page = help(folder, command);
        let below = listed(&page).into_iter().map(|name| help(folder, &format!("{command} {name}")));
        for page in below.chain([page.clone()]) {
            let examples = page.lines().skip_while(|line| *line != "Examples:").map(str::trim);
            lines.extend(examples.filter(|line| line.starts_with("grafika ")).map(str::to_owned));
        }
    }
    lines.sort();
    lines.dedup();
    assert!(lines.len() > 60, "{lines:#?}");
    let fails = |line: &String| -> Option<String> {
        let output = run(folder, line);
        let right = output.status.success() != (line == WRONG);
        (!right).then(|| format!("{line}\n    {}", String::from_utf8_lossy(&output.stderr).trim()))
    };
    let failures: Vec<String> = lines.iter().filter(|line| *line != LONG).filter_map(fails).collect();
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}
