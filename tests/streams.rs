//! Every command with every kind of stream it may be given: outputs that are closed, full, broken, no files at all.
//! Nothing panics, nothing that is there is damaged, and whoever can still be told is told in one line.
#![cfg(all(unix, feature = "native"))]

use std::fs::{self, File};
use std::io::{Read, Write};
use std::os::unix::fs::FileTypeExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;
use tempfile::TempDir;

const GRAFIKA: &str = env!("CARGO_BIN_EXE_grafika");

/// Commands that write to standard output. `DIR` is a fresh folder.
const TO_STDOUT: [&[&str]; 35] = [
    &["--help"],
    &["--version"],
    &["help"],
    &["render", "--help"],
    &["gb_2d_ip", "--help"],
    &["gb_2d_ip", "--version"],
    &["telepit", "--help"],
    &["list"],
    &["info", "A.IP2"],
    &["info", "A.CSK"],
    &["sample", "A.IP2", "--method", "spline", "--per-span", "5000"],
    &["sample", "A.ZMS", "--to", "json"],
    &["render", "A.IP2", "--method", "spline", "--to", "svg", "-o", "-"],
    &["render", "A.IP2", "--method", "spline", "--to", "png", "-o", "-"],
    &["render", "A.ZMS", "--to", "stl", "-o", "-"],
    &["convert", "A.IP2", "-", "--to", "json"],
    &["smooth", "Y.IP2", "-o", "-"],
    &["smooth", "Y.IP2", "-o", "DIR/y.csv"],
    &["solve", "abcd"],
    &["sample", "A.IP2", "--method", "phspline", "--closed", "--uniform", "5000", "--quantities"],
    &["measure", "A.IP2", "--method", "phspline", "--closed"],
    &["offset", "A.IP2", "--method", "phspline", "--closed", "--distance", "2", "--to", "json"],
    &["poly", "(x + y)^3 - x^3"],
    &["basis", "AT2", "--interval", "0,1", "--per-span", "5000"],
    &["basis", "T1", "--interval", "0,1", "--to", "json"],
    &["critical", "AT2"],
    &["elevate", "HELIX.KCG", "--root", "0"],
    &["split", "HELIX.KCG", "--parts", "3"],
    &["exact", "SNAIL.KCE", "--parts-u", "4", "--parts-v", "3"],
    &["config"],
    &["config", "palette"],
    &["config", "--path"],
    &["completions", "bash"],
    &["man"],
    &["install", "DIR/there", "--groups", "gb_2d", "--yes"],
];

/// Commands that write to the file `OUT`.
const TO_FILE: [&[&str]; 25] = [
    &["sample", "A.IP2", "--method", "spline", "--to", "csv", "-o", "OUT"],
    &["sample", "A.ZMS", "--to", "json", "-o", "OUT"],
    &["render", "A.IP2", "--method", "spline", "--to", "svg", "-o", "OUT"],
    &["render", "A.IP2", "--method", "spline", "--to", "png", "-o", "OUT"],
    &["render", "A.IP2", "--method", "spline", "--to", "pdf", "-o", "OUT"],
    &["render", "A.ZMS", "--to", "obj", "-o", "OUT"],
    &["render", "A.ZMS", "--to", "stl", "-o", "OUT"],
    &["render", "A.ZMS", "--to", "ply", "-o", "OUT"],
    &["render", "A.ZMS", "--to", "step", "-o", "OUT"],
    &["convert", "A.IP2", "OUT", "--to", "json"],
    &["measure", "A.IP2", "--method", "phspline", "--to", "json", "-o", "OUT"],
    &["offset", "A.IP2", "--method", "phspline", "--distance", "2", "--trim", "--to", "step", "-o", "OUT"],
    &["offset", "A.IP2", "--method", "phspline", "--distance", "2", "--to", "svg", "-o", "OUT"],
    &["offset", "A.IP2", "--method", "phspline", "--distance", "2", "--nc", "OUT"],
    &["render", "A.IP2", "--method", "phspline", "--distance", "2", "--comb", "--to", "png", "-o", "OUT"],
    &["poly", "x^2 - y", "--to", "json", "-o", "OUT"],
    &["basis", "T1", "--interval", "0,1", "--to", "csv", "-o", "OUT"],
    &["elevate", "HELIX.KCG", "--root", "0", "--to", "kcg", "-o", "OUT"],
    &["split", "HELIX.KCG", "--at", "pi/3", "--to", "json", "-o", "OUT"],
    &["exact", "SNAIL.KCE", "--parts", "auto", "--to", "kcj", "-o", "OUT"],
    &["convert", "A.IP2", "OUT", "--to", "ip2"],
    &["smooth", "Y.IP2", "--to", "csv", "-o", "OUT"],
    &["gb_2d_ip", "A.IP2", "--script", "shot.txt"],
    &["gb_2d_ip", "A.IP2", "--script", "dump.txt"],
    &["gb_2d_ip", "A.IP2", "--script", "wait.txt", "--record", "OUT"],
];

/// A folder to run in, with a home of its own and the scripts of [`TO_FILE`].
fn scratch() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, line) in [("shot.txt", "shot OUT"), ("dump.txt", "dump OUT"), ("wait.txt", "wait 10")] {
        fs::write(folder.path().join(name), format!("{line}\n")).unwrap();
    }
    folder
}

fn command(arguments: &[&str], folder: &Path) -> Command {
    let here = folder.to_str().unwrap();
    let mut command = Command::new(GRAFIKA);
    command.args(arguments.iter().map(|argument| argument.replace("DIR", here)));
    at_home(&mut command, folder);
    command.stdin(Stdio::null());
    command
}

fn at_home(command: &mut Command, folder: &Path) {
    command.current_dir(folder).env("HOME", folder).env("LANG", "C");
    command.env_remove("XDG_CONFIG_HOME").env_remove("XDG_STATE_HOME");
}

/// The same through a shell, whose redirections can do what a pipe cannot.
fn shell(before: &str, arguments: &[&str], redirection: &str, folder: &Path) -> Command {
    let here = folder.to_str().unwrap();
    let quoted: Vec<String> = [GRAFIKA].iter().chain(arguments).map(|it| format!("'{it}'")).collect();
    let line = format!("{before} exec {} {redirection}", quoted.join(" ").replace("DIR", here));
    let mut command = Command::new("sh");
    command.args(["-c", &line]).stdin(Stdio::null());
    at_home(&mut command, folder);
    command
}

/// Whether a message is at most one line and no panic.
#[track_caller]
fn assert_one_line(stderr: &[u8], what: &dyn std::fmt::Debug) {
    let text = String::from_utf8_lossy(stderr);
    assert!(text.lines().count() <= 1 && !text.contains("panicked"), "{what:?}: {text}");
}

#[track_caller]
fn assert_ends(output: &Output, status: i32, what: &dyn std::fmt::Debug) {
    let text = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(status), "{what:?}: {text}");
    assert_one_line(&output.stderr, what);
    // What `smooth` tells of its result goes there, too.
    assert_eq!(text.is_empty() || text.contains("RMS"), status == 0, "{what:?}: {text}");
}

/// A device that takes nothing: one of our own where nodes can be made, because a fault could destroy the system's.
fn full_device(folder: &Path) -> PathBuf {
    let own = folder.join("full");
    let made = Command::new("mknod").arg(&own).args(["c", "1", "7"]).stderr(Stdio::null()).status();
    let works = made.is_ok_and(|status| status.success())
        && File::options()
            .write(true)
            .open(&own)
            .and_then(|mut device| device.write_all(b"x"))
            .is_err_and(|error| error.kind() == std::io::ErrorKind::StorageFull);
    if works { own } else { PathBuf::from("/dev/full") }
}

fn pipe(folder: &Path) -> PathBuf {
    let path = folder.join("pipe");
    if !path.exists() {
        assert!(Command::new("mkfifo").arg(&path).status().unwrap().success());
    }
    path
}

#[test]
fn a_closed_pipe_ends_every_command_quietly() {
    for arguments in TO_STDOUT {
        let folder = scratch();
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output =
            command(arguments, folder.path()).stdout(writer).stderr(Stdio::piped()).output().unwrap();
        assert_ends(&output, 0, &arguments);
        if arguments[0] == "install" {
            assert!(
                folder.path().join("there/GB_2D/A.IP2").exists(),
                "progress that nobody reads stops nothing"
            );
        }
    }
}

#[test]
fn a_reader_that_goes_away_ends_every_command_quietly() {
    for arguments in TO_STDOUT {
        let folder = scratch();
        let mut child =
            command(arguments, folder.path()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut first = [0; 1];
        child.stdout.take().unwrap().read_exact(&mut first).unwrap();
        assert_ends(&child.wait_with_output().unwrap(), 0, &arguments);
    }
}

#[test]
fn a_full_device_is_told_in_one_line() {
    let device = scratch();
    let full = full_device(device.path());
    for arguments in TO_STDOUT {
        let folder = scratch();
        let output = File::options().write(true).open(&full).unwrap();
        let output =
            command(arguments, folder.path()).stdout(output).stderr(Stdio::piped()).output().unwrap();
        assert_ends(&output, 1, &arguments);
    }
}

#[test]
fn closed_streams_cost_nobody_a_panic() {
    for arguments in TO_STDOUT {
        for redirection in [">&-", "2>&-", ">&- 2>&-", "<&-", "<&- >&- 2>&-"] {
            let folder = scratch();
            let output = shell("", arguments, redirection, folder.path()).output().unwrap();
            assert_ends(&output, 0, &(arguments, redirection));
        }
    }
    // What cannot be told still has its status.
    for redirection in ["2>&-", "2>/dev/full"] {
        for (arguments, status) in [(&["info", "nothing.ip2"][..], 1), (&["--nothing"], 2), (&["render"], 2)]
        {
            let folder = scratch();
            let output = shell("", arguments, redirection, folder.path()).output().unwrap();
            assert_eq!(output.status.code(), Some(status), "{arguments:?}");
            assert_one_line(&output.stderr, &arguments);
        }
    }
}

/// What a command writes into `OUT`.
fn written(arguments: &[&str]) -> Vec<u8> {
    let folder = scratch();
    let output = command(arguments, folder.path()).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    fs::read(folder.path().join("OUT")).unwrap()
}

#[test]
fn what_is_no_regular_file_is_written_and_stays() {
    for arguments in TO_FILE {
        let expected = written(arguments);
        // A pipe with a reader.
        let folder = scratch();
        let path = folder.path().join("OUT");
        fs::rename(pipe(folder.path()), &path).unwrap();
        let reader = thread::spawn({
            let path = path.clone();
            move || fs::read(path).unwrap()
        });
        let output = command(arguments, folder.path()).output().unwrap();
        assert_eq!(
            output.status.code(),
            Some(0),
            "{arguments:?}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
        assert!(fs::symlink_metadata(&path).unwrap().file_type().is_fifo(), "{arguments:?}");
        assert!(reader.join().unwrap() == expected, "{arguments:?}");
        // A reader that goes away.
        let reader = thread::spawn({
            let path = path.clone();
            move || drop(File::open(path).unwrap())
        });
        let output = command(arguments, folder.path()).output().unwrap();
        reader.join().unwrap();
        assert_one_line(&output.stderr, &arguments);
        assert!(output.status.code().is_some_and(|status| status <= 1), "{arguments:?}");
        assert!(fs::symlink_metadata(&path).unwrap().file_type().is_fifo(), "{arguments:?}");
        // A full device behind a link.
        fs::remove_file(&path).unwrap();
        let full = full_device(folder.path());
        std::os::unix::fs::symlink(&full, &path).unwrap();
        let output = command(arguments, folder.path()).output().unwrap();
        assert_ends(&output, 1, &arguments);
        assert!(fs::metadata(&full).unwrap().file_type().is_char_device(), "{arguments:?}");
        // A device that takes everything, by the name that the system has for this stream.
        let output = shell("", &via_stdout(arguments), "", folder.path()).output().unwrap();
        assert_eq!(
            output.status.code(),
            Some(0),
            "{arguments:?}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
}

/// The command with `/dev/stdout` as its file, unless a script names the file.
fn via_stdout<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    let replaced = |argument| match argument {
        "OUT" => "/dev/stdout",
        "shot.txt" | "dump.txt" => "wait.txt",
        other => other,
    };
    arguments.iter().copied().map(replaced).collect()
}

#[test]
fn a_file_that_cannot_be_written_stays_whole() {
    for arguments in TO_FILE {
        // A recording is written as it comes, so that it is there whatever happens: the old one is gone.
        let streams = arguments.contains(&"--record");
        let folder = scratch();
        let path = folder.path().join("OUT");
        // A folder of that name, a folder that is not there.
        fs::create_dir(&path).unwrap();
        assert_ends(&command(arguments, folder.path()).output().unwrap(), 1, &arguments);
        fs::remove_dir(&path).unwrap();
        std::os::unix::fs::symlink("missing/file", &path).unwrap();
        assert_ends(&command(arguments, folder.path()).output().unwrap(), 1, &arguments);
        fs::remove_file(&path).unwrap();
        // A disk without room: no process may write a byte.
        fs::write(&path, b"old").unwrap();
        let output = shell("trap '' XFSZ; ulimit -f 0;", arguments, "", folder.path()).output().unwrap();
        assert_ends(&output, 1, &arguments);
        assert!(streams || fs::read(&path).unwrap() == b"old", "{arguments:?}");
        let entries = fs::read_dir(folder.path()).unwrap().flatten();
        let left: Vec<_> = entries
            .map(|entry| entry.file_name().into_string().unwrap())
            .filter(|name| name.starts_with('.'))
            .collect();
        assert!(left.is_empty(), "{arguments:?} leaves {left:?}");
        // The same signal without a trap is a kill in the middle of writing.
        let output = shell("ulimit -f 0;", arguments, "", folder.path()).output().unwrap();
        assert!(streams || fs::read(&path).unwrap() == b"old", "{arguments:?}: {output:?}");
    }
}

#[test]
fn inputs_that_are_no_regular_files_are_read_and_have_a_limit() {
    let folder = scratch();
    let points = include_bytes!("../data/A.IP2");
    let path = pipe(folder.path());
    let feed = |path: &Path| {
        let path = path.to_path_buf();
        thread::spawn(move || fs::write(path, points))
    };
    let info = |arguments: &[&str]| command(arguments, folder.path()).output().unwrap();
    let expected = info(&["info", "A.IP2"]).stdout;
    let writer = feed(&path);
    let output = info(&["info", "--from", "ip2", "pipe"]);
    assert_eq!(output.stdout, expected, "{}", String::from_utf8_lossy(&output.stderr));
    writer.join().unwrap().unwrap();
    // What a shell makes of <(command), and the system's name of the stream.
    let line = format!(
        "cat A.IP2 | '{GRAFIKA}' info --from ip2 /dev/stdin; '{GRAFIKA}' info --from ip2 <(cat A.IP2)"
    );
    fs::write(folder.path().join("A.IP2"), points).unwrap();
    let output = Command::new("bash").args(["-c", &line]).current_dir(folder.path()).output().unwrap();
    assert_eq!(output.stdout, [expected.as_slice(), &expected].concat(), "{output:?}");
    // A program opens them, too.
    fs::rename(&path, folder.path().join("pipe.ip2")).unwrap();
    let path = folder.path().join("pipe.ip2");
    let writer = feed(&path);
    assert_ends(&info(&["gb_2d_ip", "pipe.ip2", "--script", "wait.txt"]), 0, &"pipe.ip2");
    writer.join().unwrap().unwrap();
    for (arguments, status, part) in [
        (&["info", "--from", "ip2", "/dev/zero"][..], 1, "64 MB"),
        (&["info", "--from", "json", "/dev/zero"], 1, "64 MB"),
        (&["gb_2d_ip", "--script", "/dev/zero"], 2, "64 MB"),
        (&["gb_2d_ip", "--script", "."], 2, "folder"),
        (&["info", "--from", "ip2", "."], 1, "folder"),
        (&["info", "/"], 1, "folder"),
        (&["smooth", "--from", "csv", "/dev/zero", "-o", "x.csv"], 1, "64 MB"),
        (&["info", "/dev/stdin"], 1, "--from"),
    ] {
        let output = info(arguments);
        assert_ends(&output, status, &arguments);
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(text.contains(part), "{arguments:?}: {text}");
    }
    // Settings are looked for, not named: whatever lies there is never waited for.
    let settings = folder.path().join(".config/grafika");
    fs::create_dir_all(&settings).unwrap();
    for target in ["/dev/zero", "pipe"] {
        let file = settings.join("config.toml");
        let _ = fs::remove_file(&file);
        if target == "pipe" {
            fs::rename(&path, &file).unwrap();
        } else {
            std::os::unix::fs::symlink(target, &file).unwrap();
        }
        let output = info(&["config", "palette"]);
        assert_eq!(output.status.code(), Some(0), "{target}");
        assert_one_line(&output.stderr, &target);
        assert!(String::from_utf8_lossy(&output.stderr).contains("not a regular file"));
        assert_eq!(info(&["config", "palette", "amber"]).status.code(), Some(1), "{target}");
    }
}

#[test]
fn control_characters_never_reach_a_terminal() {
    let folder = scratch();
    let file = |name: &str, content: &str| fs::write(folder.path().join(name), content).unwrap();
    file("format.json", r#"{"format":"\u001b]0;x\u0007"}"#);
    file("key.json", r#"{"format":"points2d","points":[[1,2]],"\u001b[31mkey":1}"#);
    file("method.json", r#"{"format":"points2d","points":[[1,2]],"settings":{"method":"\u009b31m"}}"#);
    file("table.csv", "x,y\n1,\u{1b}[31m\n");
    file("script.txt", "key \u{1b}[31m\n");
    file("name\u{1b}[31m.ip2", "short");
    fs::create_dir_all(folder.path().join(".config/grafika")).unwrap();
    file(".config/grafika/config.toml", "\"\\u001b[31m\" = 3\nfolder = \"\\u001b[31m\"\n");
    for arguments in [
        &["info", "format.json"][..],
        &["info", "key.json"],
        &["info", "method.json"],
        &["render", "method.json", "-o", "x.svg"],
        &["info", "table.csv"],
        &["info", "name\u{1b}[31m.ip2"],
        &["info", "no\u{1b}[31m.ip2"],
        &["info", "A.IP2", "--\u{1b}[31m"],
        &["convert", "A.IP2", "\u{1b}[31m.doc"],
        &["convert", "A.IP2", "none/\u{1b}[31m.json"],
        &["gb_2d_ip", "--script", "script.txt"],
        &["gb_2d_ip", "\u{1b}[31m.ip2"],
        &["solve", "\u{1b}[31m"],
        &["open", "\u{1b}[31m.ip2"],
        &["\u{1b}[31m"],
        &["config"],
        &["config", "folder"],
        &["config", "\u{1b}[31m"],
        &["install", "DIR/\u{1b}[31m", "--groups", "kurzor", "--yes"],
    ] {
        let output = command(arguments, folder.path()).output().unwrap();
        for stream in [&output.stdout, &output.stderr] {
            let text = String::from_utf8_lossy(stream);
            assert!(!text.contains(['\u{1b}', '\u{7}', '\u{9b}']), "{arguments:?}: {text:?}");
        }
    }
}
