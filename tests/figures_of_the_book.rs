//! The page of the book's figures: what a row says makes the very picture beside it, and no figure is missing.
#![cfg(feature = "native")]

mod common;

use common::{pictures, shared_out};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The figures of the book, by chapters: the first and the last number. Chapters 1 and 5 have none.
const FIGURES: [(u32, u32, u32); 3] = [(2, 1, 43), (3, 1, 65), (4, 1, 15)];

/// What all pictures may take together.
const MOST_BYTES: u64 = 3_000_000;

/// By how much a number of an SVG may be off, as a part of it: processors round differently.
const ROUNDING: f64 = 1e-6;

/// A row of the page that makes a picture.
struct Row {
    /// The first cell, such as `3.31 to 3.35: 10, 0`.
    label: String,
    /// The name of the picture, such as `3_33.svg`.
    picture: String,
    /// A command with its words, or the script that the row names.
    made_by: MadeBy,
}

enum MadeBy {
    Command(String),
    Script(PathBuf),
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn page() -> String {
    fs::read_to_string(root().join("docs/figures_of_the_book.md")).expect("the page is there")
}

/// The part of a text between two others.
fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    let (_, rest) = text.split_once(start)?;
    Some(rest.split_once(end)?.0)
}

/// The rows of the page's tables that show a picture.
fn rows() -> Vec<Row> {
    let page = page();
    let row = |line: &str| {
        let mut cells = line.strip_prefix("| ")?.splitn(3, " | ");
        let label = cells.next()?.to_owned();
        let picture = between(cells.next()?, "<img src=\"figures_of_the_book/pictures/", "\"")?.to_owned();
        let text = cells.next()?;
        let made_by = match between(text, "`grafika ", "`") {
            Some(command) => MadeBy::Command(command.to_owned()),
            None => {
                let script = between(text, "](", ")").unwrap_or_else(|| panic!("{label}: nothing makes it"));
                MadeBy::Script(root().join("docs").join(script))
            }
        };
        Some(Row { label, picture, made_by })
    };
    page.lines().filter_map(row).collect()
}

/// Makes the picture of a row in a folder, as a reader in the root of the repository would.
fn make(row: &Row, folder: &Path) -> Result<Vec<u8>, String> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_grafika"));
    // The language is that of the machine, the settings are nobody's.
    command.current_dir(folder).env("LC_ALL", "C").env("HOME", folder).env("XDG_CONFIG_HOME", folder);
    let words = |line: &str| -> Vec<PathBuf> {
        let here =
            |word: &str| if word.starts_with("docs/") { root().join(word) } else { PathBuf::from(word) };
        line.split_whitespace().map(here).collect()
    };
    match &row.made_by {
        MadeBy::Command(line) => command.args(words(line)),
        MadeBy::Script(script) => {
            let text =
                fs::read_to_string(script).map_err(|error| format!("{}: {error}", script.display()))?;
            let head = text.lines().next().unwrap_or_default().trim_start_matches("# ");
            command.args(words(head)).arg("--script").arg(script)
        }
    };
    let output = command.output().map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    fs::read(folder.join(&row.picture)).map_err(|_| "it makes another picture".to_owned())
}

/// Whether two pictures are the same: the pixels of a PNG; the text of an SVG, whose numbers may be rounded differently.
fn same(name: &str, one: &[u8], other: &[u8]) -> bool {
    if one == other {
        return true;
    }
    if name.ends_with(".png") {
        let [one, other] = [one, other].map(pictures::decode);
        return (one.width, one.height) == (other.width, other.height) && one.rgb == other.rgb;
    }
    let words = |svg: &[u8]| -> Vec<String> {
        let text = String::from_utf8_lossy(svg).into_owned();
        text.split(|sign: char| !(sign.is_ascii_alphanumeric() || "+-.".contains(sign)))
            .map(str::to_owned)
            .collect()
    };
    let [one, other] = [one, other].map(words);
    let close = |(one, other): (&String, &String)| {
        // A number may follow the letter of a command of a path.
        let number =
            |word: &str| word.trim_start_matches(|sign: char| sign.is_ascii_alphabetic()).parse::<f64>();
        let letters = |word: &str| word.chars().next().filter(char::is_ascii_alphabetic);
        one == other
            || letters(one) == letters(other)
                && matches!((number(one), number(other)), (Ok(a), Ok(b)) if (a - b).abs() <= ROUNDING * (1.0 + a.abs()))
    };
    one.len() == other.len() && one.iter().zip(&other).all(close)
}

#[test]
fn every_row_makes_the_picture_beside_it() {
    let rows = rows();
    let renew = std::env::var_os("UPDATE_PICTURES").is_some();
    let pictures = root().join("docs/figures_of_the_book/pictures");
    let made = Path::new(env!("CARGO_TARGET_TMPDIR")).join("figures_of_the_book");
    fs::create_dir_all(&made).expect("a folder of the build");
    let check = |row: &Row| {
        let folder = tempfile::tempdir().expect("a folder");
        let picture = match make(row, folder.path()) {
            Ok(picture) => picture,
            Err(reason) => return Some(format!("{}, {}: {reason}", row.label, row.picture)),
        };
        let expected = pictures.join(&row.picture);
        if fs::read(&expected).is_ok_and(|expected| same(&row.picture, &picture, &expected)) {
            return None;
        }
        if renew {
            fs::write(&expected, picture).expect("the picture can be written");
            return None;
        }
        let shown = made.join(&row.picture);
        fs::write(&shown, picture).expect("a folder of the build");
        Some(format!(
            "{}, {}: is out of date; {} shows it as it is now",
            row.label,
            row.picture,
            shown.display()
        ))
    };
    let wrong: Vec<String> = shared_out(&rows, check).into_iter().flatten().collect();
    assert!(wrong.is_empty(), "{}\nUPDATE_PICTURES=1 renews them", wrong.join("\n"));
}

/// A cell such as `2.5`, `3.8 b` or `3.31 to 3.35: 10, 0` names figures.
fn named(label: &str) -> Vec<(u32, u32)> {
    let label = label.split([':', ',']).next().unwrap_or_default();
    let number = |text: &str| {
        let (chapter, number) = text.split(' ').next()?.split_once('.')?;
        Some((chapter.parse::<u32>().ok()?, number.parse::<u32>().ok()?))
    };
    let ends: Vec<_> = label.split(" to ").filter_map(number).collect();
    match (ends.first(), ends.last()) {
        (Some(&(chapter, first)), Some(&(_, last))) => {
            (first..=last).map(|number| (chapter, number)).collect()
        }
        _ => Vec::new(),
    }
}

#[test]
fn every_figure_of_the_book_is_on_the_page() {
    let labels = page();
    let labels = labels.lines().filter_map(|line| line.strip_prefix("| ")?.split(" | ").next());
    let there: BTreeSet<_> = labels.flat_map(named).collect();
    let numbers =
        |&(chapter, first, last): &(u32, u32, u32)| (first..=last).map(move |number| (chapter, number));
    let all: BTreeSet<_> = FIGURES.iter().flat_map(numbers).collect();
    assert_eq!(all.difference(&there).collect::<Vec<_>>(), Vec::<&(u32, u32)>::new(), "not on the page");
    assert_eq!(there.difference(&all).collect::<Vec<_>>(), Vec::<&(u32, u32)>::new(), "not in the book");
}

#[test]
fn every_picture_and_every_source_is_used() {
    let page = page();
    let rows = rows();
    let names: BTreeSet<_> = rows.iter().map(|row| row.picture.as_str()).collect();
    assert_eq!(names.len(), rows.len(), "a picture has two rows");
    let folder = root().join("docs/figures_of_the_book");
    let mut size = 0;
    for entry in fs::read_dir(folder.join("pictures")).expect("the folder is there") {
        let entry = entry.expect("it can be read");
        let name = entry.file_name().into_string().expect("a plain name");
        assert!(names.contains(name.as_str()), "{name} is in no row");
        size += entry.metadata().expect("it has a size").len();
    }
    assert!(size <= MOST_BYTES, "{size} bytes of pictures");
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let name = entry.expect("it can be read").file_name().into_string().expect("a plain name");
        assert!(
            name == "pictures" || page.contains(&format!("figures_of_the_book/{name}")),
            "{name} is in no row"
        );
    }
}
