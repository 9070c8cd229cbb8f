//! Saves that are killed at any moment, or find no room: the file is whole, as it was before or as it was to be, and
//! nothing is left beside it.
#![cfg(all(unix, feature = "native"))]

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// GB_2D_IP saves four points, one of them at `x`, over the file X.IP2.
fn save(folder: &Path, x: usize, before: &str) -> Child {
    let program = env!("CARGO_BIN_EXE_gb_2d_ip");
    let mut child = Command::new("sh")
        .args(["-c", &format!("{before} exec '{program}' --script -")])
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let script = format!(
        "key U\ndrag 618 90 {x} 150\ndrag 618 90 261 110\ndrag 618 90 361 330\nkey Ctrl+S\ntype X\nkey Enter\nkey I\nwait 10\n"
    );
    // A program that is killed does not read it.
    let _ = child.stdin.take().unwrap().write_all(script.as_bytes());
    child
}

/// What such a save writes.
fn expected(x: usize) -> Vec<u8> {
    let folder = TempDir::new().unwrap();
    assert!(save(folder.path(), x, "").wait().unwrap().success());
    fs::read(folder.path().join("X.IP2")).unwrap()
}

fn left_over(folder: &Path) -> usize {
    fs::read_dir(folder).unwrap().flatten().filter(|entry| entry.file_name() != "X.IP2").count()
}

/// Saves so many times, by turns to the end, killed, and without room; gives how many temporary files were there at
/// most.
fn rounds(count: usize) -> usize {
    let versions = [161, 162, 163].map(|x| (x, expected(x)));
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("X.IP2");
    let begun = Instant::now();
    assert!(save(folder.path(), versions[0].0, "").wait().unwrap().success());
    let usual = begun.elapsed();
    let (mut now, mut most, mut killed_after) = (versions[0].1.clone(), 0, 0);
    for round in 0..count {
        let (x, new) = &versions[round % versions.len()];
        let mut child = match round % 4 {
            0 => save(folder.path(), *x, ""),
            1 => save(folder.path(), *x, "trap '' XFSZ; ulimit -f 0;"),
            _ => {
                let mut child = save(folder.path(), *x, "");
                // All over the time that a save takes, most of them near its end.
                sleep(usual.mul_f64(0.5 + 0.7 * (round % 97) as f64 / 97.0));
                child.kill().unwrap();
                child
            }
        };
        child.wait().unwrap();
        let found = fs::read(&file).unwrap();
        assert!(found == *new || found == now, "round {round}: {} bytes", found.len());
        match round % 4 {
            0 => assert!(found == *new, "round {round} saved"),
            1 => assert!(found == now, "round {round} had no room"),
            _ if found == now && *new != now => killed_after += 1,
            _ => {}
        }
        now = found;
        most = most.max(left_over(folder.path()));
    }
    println!("{count} rounds, {killed_after} kills before the rename, at most {most} temporary files");
    // A second later they are known to be nobody's.
    sleep(Duration::from_millis(1100));
    assert!(save(folder.path(), versions[0].0, "").wait().unwrap().success());
    assert_eq!(left_over(folder.path()), 0);
    most
}

#[test]
fn a_save_that_breaks_off_costs_nothing() {
    rounds(200);
}

#[test]
#[ignore = "takes minutes; run it in release"]
fn three_thousand_saves_that_break_off_cost_nothing() {
    rounds(3000);
}
