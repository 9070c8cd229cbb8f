//! The pictures of the documentation: each is made by the script beside it, so that none is out of date.

mod common;

use common::pictures;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// Runs a script of the documentation; its first line is the command line as a comment.
fn run(script: &str, picture: &Path) {
    let (command, script) = script.split_once('\n').unwrap_or((script, ""));
    let command = command.trim_start_matches("# ").trim_start_matches("grafika");
    let mut child = Command::new(env!("CARGO_BIN_EXE_grafika"))
        .args(command.split_whitespace())
        .args(["--script", "-"])
        .stdin(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let script = format!("{script}\nshot {}\n", picture.display());
    child.stdin.take().expect("it is piped").write_all(script.as_bytes()).expect("the program reads");
    assert!(child.wait().expect("the program ends").success(), "{command}");
}

#[test]
fn the_pictures_show_the_programs_of_today() {
    assert_made_by_scripts("docs/pictures");
}

#[test]
fn the_first_steps_lead_where_they_say() {
    assert_made_by_scripts("docs/first_steps");
}

/// Every program has its first steps, which are few, and the page says what the script says.
#[test]
fn first_steps_are_few() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/first_steps");
    let page = std::fs::read_to_string(folder.with_extension("md")).expect("the page is there");
    for program in grafika::programs::ALL.iter().filter(|program| program.manual.name != "telepit") {
        let name = program.manual.name;
        let script = std::fs::read_to_string(folder.join(name).with_extension("script")).expect(name);
        let apart = ["#", "lang", "manner", "wait"];
        let steps = script.lines().filter(|line| !apart.iter().any(|word| line.starts_with(word))).count();
        assert!((1..=10).contains(&steps), "{name}: {steps} steps");
        let picture = format!("first_steps/{name}.png");
        let section = page.split("\n## ").find(|section| section.contains(&picture));
        let section = section.unwrap_or_else(|| panic!("{name} is not on the page"));
        for step in script.lines().skip(1).filter_map(|line| line.strip_prefix("# ")) {
            let step = step.trim_end_matches('.');
            assert!(section.contains(&format!(". {step}")), "{name}: the page does not say \"{step}\"");
        }
    }
}

/// The film is made by the program itself.
#[test]
fn the_film_is_made_by_its_script() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/first_steps");
    let made = Path::new(env!("CARGO_TARGET_TMPDIR")).join("film");
    let _ = std::fs::remove_dir_all(&made);
    std::fs::create_dir_all(&made).expect("a folder of the build");
    let ran = Command::new(env!("CARGO_BIN_EXE_gb_2d_ip"))
        .arg("--script")
        .arg(folder.join("film.txt"))
        .current_dir(&made)
        .status();
    assert!(ran.expect("the program starts").success());
    let film = std::fs::read(made.join("gb_2d_ip-1.gif")).expect("the film is there");
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        std::fs::write(folder.join("film.gif"), &film).expect("the film can be written");
    }
    let expected = std::fs::read(folder.join("film.gif")).expect("the film is in the documentation");
    assert!(film == expected, "docs/first_steps/film.gif is out of date; UPDATE_PICTURES=1 renews it");
}

/// Asserts that every picture of a folder is what the script beside it makes.
fn assert_made_by_scripts(folder: &str) {
    let made = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    std::fs::create_dir_all(&made).expect("a folder of the build");
    let mut wrong = Vec::new();
    for entry in std::fs::read_dir(&folder).expect("the folder is there") {
        let path = entry.expect("it can be read").path();
        let script = match path.extension().and_then(|it| it.to_str()) {
            Some("script") => std::fs::read_to_string(&path).expect("scripts are text"),
            Some("png") => {
                assert!(path.with_extension("script").exists(), "{}: no script makes it", path.display());
                continue;
            }
            _ => continue,
        };
        let expected = path.with_extension("png");
        let picture = made.join(expected.file_name().expect("it has a name"));
        run(&script, &picture);
        if std::env::var_os("UPDATE_PICTURES").is_some() {
            std::fs::copy(&picture, &expected).expect("the picture can be written");
        }
        if !expected.exists() || pictures::read(&picture) != pictures::read(&expected) {
            wrong.push(format!(
                "{} is out of date: {} shows it as it is now",
                expected.display(),
                picture.display()
            ));
        }
    }
    assert!(wrong.is_empty(), "{}\nUPDATE_PICTURES=1 renews them", wrong.join("\n"));
}

/// Every picture and page that a page names is there.
#[test]
fn links_lead_somewhere() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let pages = std::fs::read_dir(root.join("docs")).expect("the folder is there");
    let pages = pages.map(|entry| entry.expect("it can be read").path());
    let own = ["README.md", "README.hu.md", "ARCHITECTURE.md", "CHANGELOG.md", "data/README.md"];
    let own = own.map(|name| root.join(name));
    for page in pages.chain(own).filter(|path| path.extension().is_some_and(|it| it == "md")) {
        let text = std::fs::read_to_string(&page).expect("pages are text");
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let file = link.split('#').next().unwrap_or_default();
            if !file.is_empty() && !file.contains("://") {
                let folder = page.parent().expect("pages are in folders");
                assert!(folder.join(file).exists(), "{}: there is no {link}", page.display());
            }
        }
    }
}

/// The guide's program is the compiled example.
#[test]
fn the_guide_quotes_its_example() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |name: &str| std::fs::read_to_string(root.join(name)).expect("it is text");
    let example = read("examples/own_program.rs");
    let guide = read("docs/own_program.md");
    let mut quoted = 0;
    for code in guide.split("```rust\n").skip(1).filter_map(|rest| rest.split("```").next()) {
        assert!(example.contains(code.trim_end()), "not in the example:\n{code}");
        quoted += 1;
    }
    assert!(quoted > 3);
}
