//! The menu and the settings of `grafika` as their user sees them: starting and coming back, searching, the
//! settings page, `grafika config`.

mod common;

use common::pictures::{self, Pixels};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A folder of the build for one test.
fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("menu").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder of the build");
    folder
}

/// Runs `grafika` with a script; every line `shot` in it becomes a picture.
fn shots(test: &str, arguments: &[&str], script: &str) -> Vec<Pixels> {
    let folder = scratch(test);
    let mut written = String::new();
    let mut paths = Vec::new();
    for line in script.lines() {
        if line == "shot" {
            let path = folder.join(format!("{}.png", paths.len()));
            written += &format!("shot {}\n", path.display());
            paths.push(path);
        } else {
            written += &format!("{line}\n");
        }
    }
    let mut child = Command::new(env!("CARGO_BIN_EXE_grafika"))
        .args(arguments)
        .args(["--script", "-"])
        .stdin(Stdio::piped())
        .spawn()
        .expect("it starts");
    child.stdin.take().expect("it is piped").write_all(written.as_bytes()).expect("it reads");
    assert!(child.wait().expect("it ends").success());
    paths.iter().map(|path| pictures::read(path)).collect()
}

#[test]
fn esc_in_a_program_comes_back_and_loses_nothing() {
    let script = "type 2d_ip\nwait 500\nshot\nkey Enter\nkey U\nkey Esc\nwait 500\nshot\n\
        key Enter\nkey U\ndrag 610 92 180 120\nshot\nkey Esc\nshot\nkey Esc\nshot\nkey Esc\nkey N\nwait 500\nshot";
    let shots = shots("esc", &[], script);
    let [menu, back, point, asked, stayed, left] = shots.as_slice() else { panic!("six pictures") };
    assert!(menu == back && menu == left);
    assert!(asked != point && stayed == point);
}

#[test]
fn a_found_program_is_the_program_itself() {
    let from_menu = shots("found", &[], "type telj\nkey Backspace\nkey Esc\ntype CSANGO\nkey Enter\nshot");
    assert!(from_menu == shots("itself", &["csango_k"], "shot"));
    let from_menu = shots("ring", &[], "type csavart\nkey Enter\nkey Left\nshot\nkey Esc\nkey Esc\nkey Esc");
    assert!(from_menu == shots("ring_itself", &["csav_gy"], "key Left\nshot"));
}

#[test]
fn typing_never_ends_the_menu_and_esc_asks_first() {
    let script = "wait 500\nshot\ntype QIQI qxq!\nwait 3000\nkey Esc\nkey Home\nwait 500\nshot\nkey Esc\nshot\nkey N\nwait 500\nshot\n\
        key Esc\nkey Esc\nwait 500\nshot";
    let shots = shots("typing", &[], script);
    let [start, cleared, asked, stayed, again] = shots.as_slice() else { panic!("five pictures") };
    assert!(start == cleared && start == stayed && start == again && start != asked);
}

#[test]
fn the_mouse_chooses_by_pointing_starts_by_clicking_and_the_wheel_scrolls() {
    // The second tile of the first row, and the first of the second.
    let script = "wait 500\nkey Right\nwait 3000\nshot\nkey Home\nmove 400 100\nwait 3000\nshot\nmove 60 220\nwait 3000\nshot\n\
        wheel -1\nwait 500\nshot\nwheel 1\nmove 400 100\nclick 60 220\nshot";
    let itself = shots("itself_by_mouse", &["gb_2d_ip"], "move 60 220\nshot");
    let shots = shots("mouse", &[], script);
    let [keys, pointed, other, scrolled, started] = shots.as_slice() else { panic!("five pictures") };
    assert!(keys == pointed && other != pointed && scrolled != other);
    assert!(*started == itself[0]);
}

#[test]
fn the_settings_lie_over_the_picture_and_go_again() {
    let script = "key U\nshot\nkey F9\nshot\nkey Down\nkey Down\nkey Down\nkey Right\nshot\nkey Left\nkey Esc\nshot\n\
        key F9\nkey Right\nkey Right\nkey Esc\nkey F9\nkey Esc\nshot";
    let shots = shots("settings", &["gb_2d_ip"], script);
    let [before, page, amber, after, english] = shots.as_slice() else { panic!("five pictures") };
    assert!(before == after && page != before && amber != page);
    // The language counts at once.
    assert!(english != before);
}

#[test]
fn a_key_that_changes_a_preference_shows_in_its_row_at_once() {
    let script = "key U\nkey F9\nkey F2\nkey Ctrl+F11\nshot\nkey Esc\nkey F9\nshot";
    let shots = shots("settings_keys", &["gb_2d_ip"], script);
    assert!(shots[0] == shots[1]);
}

/// Runs `grafika config` with settings in a folder.
fn config(folder: &Path, arguments: &[&str]) -> (bool, String, String) {
    let Output { status, stdout, stderr } = Command::new(env!("CARGO_BIN_EXE_grafika"))
        .arg("config")
        .args(arguments)
        .env("XDG_CONFIG_HOME", folder)
        .output()
        .expect("it runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("it is text");
    (status.success(), text(stdout), text(stderr))
}

#[test]
#[cfg(all(unix, not(target_os = "macos")))]
fn settings_lie_where_the_standard_says() {
    let path = |home: &str, config: Option<&str>| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_grafika"));
        command.args(["config", "--path"]).env("HOME", home).env_remove("XDG_CONFIG_HOME");
        command.envs(config.map(|config| ("XDG_CONFIG_HOME", config)));
        let shown = command.output().expect("it runs");
        String::from_utf8(shown.stdout).expect("it is text").trim_end().to_string()
    };
    // What is empty or relative counts as not set.
    for unset in [None, Some(""), Some("relative")] {
        assert_eq!(path("/home/me", unset), "/home/me/.config/grafika/config.toml");
    }
    assert_eq!(path("/home/me", Some("/x")), "/x/grafika/config.toml");
    assert_eq!(path("relative", None), "");
}

#[test]
#[cfg(all(unix, not(target_os = "macos")))]
fn settings_are_kept_and_wrong_ones_told() {
    let folder = scratch("config");
    assert_eq!(config(&folder, &["palette"]), (true, "vga\n".to_string(), String::new()));
    assert!(config(&folder, &["palette", "amber"]).0 && config(&folder, &["scale", "3"]).0);
    assert_eq!(config(&folder, &["palette"]).1, "amber\n");
    assert!(config(&folder, &[]).1.contains("scale = \"3\""));
    let file = folder.join("grafika/config.toml");
    assert_eq!(config(&folder, &["--path"]).1, format!("{}\n", file.display()));
    for (wrong, why) in [(["palette", "pink"], "colorblind"), (["color", "1"], "pointer_speed")] {
        let (done, _, told) = config(&folder, &wrong);
        assert!(!done && told.contains(why), "{told}");
    }
    // What is wrong in the file is told and stops nothing.
    std::fs::write(&file, "palette = \"green\"\nfuture = 1\n").expect("a file of the build");
    let (done, shown, told) = config(&folder, &["palette"]);
    assert!(done && shown == "green\n" && told.contains("\"future\""), "{told}");
    // A file that cannot be understood is not written over.
    std::fs::write(&file, "palette = green").expect("a file of the build");
    assert!(!config(&folder, &["palette", "amber"]).0);
    assert_eq!(std::fs::read_to_string(&file).expect("it is there"), "palette = green");
}
