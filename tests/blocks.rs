//! The picture in characters, as terminals without graphics show it: golden cells of ten programs in four sizes, and
//! what must hold of each of them.
#![cfg(feature = "terminal")]

mod common;

use grafika::display::terminal::blocks::{Blocks, Picture};
use grafika::file::{Document, Format};
use grafika::machine::{Glyphs, Machine, Memory, Script, Settings, play, sample};
use grafika::programs;
use grafika::screen::{HEIGHT, Screen, WIDTH};
use std::fmt::Write;

/// Columns and rows: the size most terminals start with, the letters of the screen, and two larger ones.
const SIZES: [(u16, u16); 4] = [(80, 24), (80, 30), (120, 50), (200, 60)];

/// What is shown: a name, the program, its sample, and the script that leads there.
const SCENES: [(&str, &str, &str, &str); 10] = [
    ("spline", "gb_2d_ip", "A.IP2", "key G\nkey Z\nkey 3\n"),
    ("beta", "gb_2d_bt", "K.IP2", "key G\nkey N\n"),
    ("space", "gb_3d_ip", "A.IP3", "key G\nkey N\nkey 3\n"),
    ("fourier", "gb_p_2d", "A.GBP", "wait 100\n"),
    ("surface", "zm_hspl", "A.ZMS", "key F\nkey D\nwait 500\n"),
    ("table", "biliard", "", "wait 100\n"),
    ("wheel", "gyongy_k", "", "key T\nwait 100\n"),
    ("cube", "csango_k", "", "key U\nwait 100\n"),
    ("knots", "csomo", "A.CSM", "wait 100\n"),
    ("menu", "telepit", "", "wait 100\n"),
];

/// The screen of a program after a script, as a user of a terminal sees it.
fn screen(program: &str, file: &str, script: &str) -> Screen {
    screen_in("today", program, file, script)
}

fn screen_in(manner: &str, program: &str, file: &str, script: &str) -> Screen {
    let program = *programs::by_name(program).expect("there is such a program");
    let document = (!file.is_empty()).then(|| {
        let format = Format::from_name(file).expect("samples have their format's extension");
        Document::read(format, sample(file).expect("there is such a sample")).expect("samples are right")
    });
    let script = format!("lang en\nmanner {manner}\npointing keys\n{script}shot a.png\n");
    let script = Script::parse(&script).expect("the test's script is right");
    let machine = Machine::new(Box::new(Memory::default()), Settings::default());
    let mut kept = common::Kept::default();
    play(&mut common::session_on(program, machine, document), &script, &mut kept).expect("all is taken");
    kept.pictures["a.png"].clone()
}

fn picture(screen: &Screen, (columns, rows): (u16, u16), glyphs: Glyphs) -> Picture {
    Blocks::new(columns, rows, glyphs).expect("the terminal is large enough").picture(screen, None)
}

/// The cells as text: for every row its characters, then its colours in runs, ink and paper in hexadecimal.
fn written(picture: &Picture) -> String {
    let mut out = String::new();
    for (row, line) in picture.cells.chunks(picture.width).zip(picture.lines()) {
        let _ = writeln!(out, "|{line}|");
        let runs = row.chunk_by(|a, b| (a.ink, a.paper) == (b.ink, b.paper));
        for run in runs {
            let _ = write!(out, " {}:{:x}{:x}", run.len(), run[0].ink, run[0].paper);
        }
        out.push('\n');
    }
    out
}

/// Compares with `tests/golden/cells/NAME.txt`, which `UPDATE_PICTURES=1` renews.
fn assert_golden(name: &str, cells: &str) {
    let path = common::path("golden/cells").join(format!("{name}.txt"));
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        std::fs::create_dir_all(path.parent().expect("it lies in a folder")).expect("the folder can be made");
        std::fs::write(&path, cells).expect("the golden cells can be written");
    }
    let golden = std::fs::read_to_string(&path).expect("there are golden cells");
    let differing = cells.lines().zip(golden.lines()).enumerate().find(|(_, (ours, theirs))| ours != theirs);
    if let Some((line, (ours, theirs))) = differing {
        panic!("{name}: line {} is\n{ours}\ninstead of\n{theirs}", line + 1);
    }
    assert_eq!(cells.lines().count(), golden.lines().count(), "{name}: number of lines");
}

/// Golden cells, and every text of the screen whole in one row of them.
#[test]
fn ten_programs_in_four_sizes() {
    for (name, program, file, script) in SCENES {
        let screen = screen(program, file, script);
        for size in SIZES {
            let name = format!("{name}_{}x{}", size.0, size.1);
            let picture = picture(&screen, size, Glyphs::Blocks);
            let lines = picture.lines();
            for text in screen.texts().iter().filter(|text| !text.covered) {
                let text = text.string();
                assert!(lines.iter().any(|line| line.contains(&text)), "{name}: {text:?} is not there");
            }
            assert_eq!(picture.missing, [""; 0], "{name}");
            assert_golden(&name, &written(&picture));
        }
    }
}

/// The pages that have more lines than a small terminal has rows are given in parts.
#[test]
fn every_help_page_is_whole_at_80x24() {
    for program in programs::ALL {
        for page in ["", "key Space\n", "key Space\nkey Space\n"] {
            let screen = screen(program.manual.name, "", &format!("key F1\n{page}"));
            for size in [(80, 24), (80, 30)] {
                let missing = picture(&screen, size, Glyphs::Blocks).missing;
                assert_eq!(missing, [""; 0], "{} {page:?}", program.manual.name);
            }
        }
    }
}

/// No size and no set of characters makes an end of it, and none cuts a number.
#[test]
fn every_size_and_every_set() {
    for (_, program, file, script) in [SCENES[0], SCENES[3], SCENES[6]] {
        let screen = screen(program, file, script);
        for glyphs in [Glyphs::Ascii, Glyphs::Blocks, Glyphs::Unicode13, Glyphs::Unicode16] {
            for size in [(60, 20), (61, 23), (79, 24), (80, 25), (132, 43), (255, 90)] {
                let picture = picture(&screen, size, glyphs);
                assert_eq!(picture.cells.len() % picture.width, 0);
                assert!(glyphs != Glyphs::Ascii || picture.cells.iter().all(|cell| cell.ch.is_ascii()));
            }
        }
    }
}

/// The cells of the curve of `gb_2d_ip A.IP2` stand out; those of the grid do not outweigh them.
#[test]
fn the_curve_can_be_traced() {
    let [bare, drawn] =
        [("", false), (SCENES[0].3, true)].map(|(script, _)| screen("gb_2d_ip", "A.IP2", script));
    let changed: Vec<(i32, i32)> = (60..460)
        .flat_map(|y| (32..600).map(move |x| (x, y)))
        .filter(|&(x, y)| bare.pixel(x, y) != drawn.pixel(x, y))
        .collect();
    assert!(changed.len() > 500, "the script draws a curve");
    for size in SIZES {
        let (before, after) = (picture(&bare, size, Glyphs::Blocks), picture(&drawn, size, Glyphs::Blocks));
        let rows = after.cells.len() / after.width;
        // Cells of which the curve takes a good part.
        let mut counts = vec![0usize; after.cells.len()];
        for &(x, y) in &changed {
            let inside = |spot: &grafika::display::terminal::blocks::Spot| {
                (spot.x..spot.x + spot.width).contains(&x) && (spot.y..spot.y + spot.height).contains(&y)
            };
            if let Some(at) = after.spots.iter().position(inside) {
                counts[at] += 1;
            }
        }
        let least = (WIDTH as usize / after.width).min(HEIGHT as usize / rows).max(2);
        let curve: Vec<usize> = (0..counts.len()).filter(|&at| counts[at] >= least).collect();
        let field = before.cells[12 * after.width + after.width / 20];
        let blank =
            |cell: &grafika::display::terminal::blocks::Cell| cell.ch == ' ' && cell.paper == field.paper;
        let seen = curve.iter().filter(|&&at| !blank(&after.cells[at])).count();
        assert!(100 * seen >= 95 * curve.len(), "{size:?}: {seen} of {} cells of the curve", curve.len());
        let grid = after.cells.iter().filter(|cell| cell.ch == '·').count();
        assert!(grid < curve.len(), "{size:?}: {grid} cells of the grid, {} of the curve", curve.len());
    }
}
