//! The rooms of the house stand on floors, and a room imports only from floors below. Which rooms there are
//! and where they stand is read from the table in `ARCHITECTURE.md`, so that the drawing and the imports
//! hold each other.

#[path = "rooms/imports.rs"]
mod imports;

use imports::imports;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// A row of the table.
#[derive(Debug)]
struct Room {
    floor: u32,
    /// The folder with a slash at its end: `src/screen/`.
    folder: String,
    /// What imports call it: `screen`.
    name: String,
}

/// The drawing of the house.
#[derive(Debug)]
struct House {
    rooms: Vec<Room>,
    /// Who may use whom on the same floor.
    exceptions: BTreeSet<(String, String)>,
}

/// The names in backticks of a line.
fn quoted(line: &str) -> impl Iterator<Item = &str> {
    line.split('`').skip(1).step_by(2)
}

impl House {
    /// Reads rows such as "| 2 | `src/figure/`, `src/file/` | pictures |", and the line of exceptions:
    /// "Exceptions: `puzzle` may use `geometry`."
    fn read(document: &str) -> House {
        let mut rooms = Vec::new();
        for line in document.lines() {
            let Some((floor, row)) = line.strip_prefix('|').and_then(|line| line.split_once('|')) else {
                continue;
            };
            let Ok(floor) = floor.trim().parse() else { continue };
            let cell = row.split('|').next().unwrap_or_default();
            for folder in quoted(cell).filter(|name| name.ends_with('/')) {
                let name = folder.strip_prefix("src/").unwrap_or(folder).trim_end_matches('/').to_string();
                rooms.push(Room { floor, folder: folder.to_string(), name });
            }
        }
        let lines = document.lines().filter_map(|line| line.strip_prefix("Exceptions:"));
        let pairs = lines.flat_map(|line| line.split([',', ';', '.'])).filter_map(|pair| {
            let (user, used) = pair.split_once(" may use ")?;
            Some((quoted(user).next()?.to_string(), quoted(used).next()?.to_string()))
        });
        House { exceptions: pairs.collect(), rooms }
    }

    fn room(&self, name: &str) -> Option<&Room> {
        self.rooms.iter().find(|room| room.name == name)
    }

    /// The room a file lies in: the innermost one.
    fn room_of(&self, file: &str) -> Option<&Room> {
        let around = self.rooms.iter().filter(|room| file.starts_with(&room.folder));
        around.max_by_key(|room| room.folder.len())
    }

    /// What is wrong with the drawing itself, or with what it says beside the folders that are there.
    fn problems_of_the_drawing(&self, folders: &BTreeSet<String>) -> Vec<String> {
        let mut problems = Vec::new();
        for (index, room) in self.rooms.iter().enumerate() {
            if self.rooms[..index].iter().any(|other| other.folder == room.folder) {
                problems.push(format!("{} stands twice in the table", room.folder));
            }
            if !folders.contains(&room.folder) {
                problems.push(format!("{} stands in the table, but there is no such folder", room.folder));
            }
        }
        for folder in folders.iter().filter(|folder| folder.starts_with("src/")) {
            if !self.rooms.iter().any(|room| room.folder == *folder) {
                problems.push(format!("{folder} does not stand in the table"));
            }
        }
        for (user, used) in &self.exceptions {
            let floors = [user, used].map(|name| self.room(name).map(|room| room.floor));
            if floors[0].is_none() || floors[0] != floors[1] {
                problems.push(format!("{user} and {used}: an exception is for two rooms of the same floor"));
            }
        }
        problems
    }

    /// What is wrong with the imports of some sources: arrows up and sideways, rooms that are not there,
    /// circles.
    fn problems_of_the_imports(&self, sources: &[Source]) -> Vec<String> {
        let mut problems = BTreeSet::new();
        let mut arrows: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for source in sources {
            let file = &source.file;
            let Some(room) = self.room_of(file) else {
                // The root of the library only says which rooms there are.
                if file != "src/lib.rs" {
                    problems.insert(format!("{file} lies in no room"));
                }
                continue;
            };
            // Unit tests count too: a room that is taken out of the house takes them along.
            for import in imports(&source.text, &source.module(), &[]) {
                let Some(first) = import.path.first() else { continue };
                let Some(used) = self.room(first) else {
                    // As long as a program is a crate of its own, `crate::x` is a module of the program.
                    if room.folder.starts_with("src/") || import.by_name {
                        problems
                            .insert(format!("{file} imports {}, which is no room", import.path.join("::")));
                    }
                    continue;
                };
                if used.name == room.name {
                    continue;
                }
                arrows.entry(room.name.clone()).or_default().insert(used.name.clone());
                let excepted = self.exceptions.contains(&(room.name.clone(), used.name.clone()));
                if used.floor >= room.floor && !excepted {
                    problems.insert(format!(
                        "{file} imports {}: {} stands on floor {}, {} on floor {}",
                        import.path.join("::"),
                        room.name,
                        room.floor,
                        used.name,
                        used.floor
                    ));
                }
            }
        }
        let circles =
            circles(&arrows).into_iter().map(|circle| format!("a circle of rooms: {}", circle.join(", ")));
        problems.into_iter().chain(circles).collect()
    }
}

/// A file with its path from the root of the package.
struct Source {
    file: String,
    text: String,
}

impl Source {
    /// The module's path from the root of the library; that of `programs/` begins with its name.
    fn module(&self) -> Vec<String> {
        let path = self.file.strip_prefix("src/").unwrap_or(&self.file);
        let path = path.trim_end_matches(".rs").trim_end_matches("/mod");
        path.split('/').map(str::to_string).collect()
    }
}

/// The groups of those that reach each other, directly or through others.
fn circles(arrows: &BTreeMap<String, BTreeSet<String>>) -> Vec<Vec<String>> {
    let reached = |from: &String| {
        let mut seen: BTreeSet<&String> = BTreeSet::new();
        let mut next: Vec<&String> = arrows.get(from).into_iter().flatten().collect();
        while let Some(one) = next.pop() {
            if seen.insert(one) {
                next.extend(arrows.get(one).into_iter().flatten());
            }
        }
        seen
    };
    let reach: BTreeMap<&String, BTreeSet<&String>> =
        arrows.keys().map(|name| (name, reached(name))).collect();
    let group = |name: &String| -> Vec<String> {
        let back = |other: &&&String| reach.get(**other).is_some_and(|reach| reach.contains(name));
        reach[name].iter().filter(back).map(|&other| other.clone()).collect()
    };
    let groups: BTreeSet<Vec<String>> = arrows.keys().map(group).collect();
    groups.into_iter().filter(|group| !group.is_empty()).collect()
}

/// Which modules of a room use which. A name that the room gives to the outside counts as an import of
/// the module that it comes from. Unit tests are left out: they may use the whole room.
fn arrows_inside(room: &str, sources: &[Source]) -> BTreeMap<String, BTreeSet<String>> {
    let inside = |source: &&Source| source.module().first().is_some_and(|first| first == room);
    let sources: Vec<&Source> = sources.iter().filter(inside).collect();
    let modules: BTreeSet<String> =
        sources.iter().filter_map(|source| source.module().get(1).cloned()).collect();
    let children: Vec<String> = modules.iter().cloned().collect();
    let mut given = BTreeMap::new();
    for root in sources.iter().filter(|source| source.module().len() == 1) {
        for import in imports(&root.text, &root.module(), &children) {
            if let [_, module, ..] = import.path.as_slice() {
                given.insert(import.name, module.clone());
            }
        }
    }
    let mut arrows: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for source in &sources {
        let path = source.module();
        let Some(module) = path.get(1) else { continue };
        for import in imports(&source.text, &path, &[]).iter().filter(|import| !import.in_tests) {
            let [first, second, ..] = import.path.as_slice() else { continue };
            let used = if modules.contains(second) { Some(second) } else { given.get(second) };
            if let Some(used) = used.filter(|used| first == room && *used != module) {
                arrows.entry(module.clone()).or_default().insert(used.clone());
            }
        }
    }
    arrows
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn house() -> House {
    House::read(&std::fs::read_to_string(root().join("ARCHITECTURE.md")).expect("the document is there"))
}

/// All sources below a folder, and all folders with a slash at their end.
fn walk(folder: &str, sources: &mut Vec<Source>, folders: &mut BTreeSet<String>) {
    folders.insert(format!("{folder}/"));
    for entry in std::fs::read_dir(root().join(folder)).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        let name = path.file_name().expect("files have names").to_string_lossy();
        let file = format!("{folder}/{name}");
        if path.is_dir() {
            walk(&file, sources, folders);
        } else if file.ends_with(".rs") {
            sources.push(Source { text: std::fs::read_to_string(&path).expect("sources are text"), file });
        }
    }
}

/// The sources of `src` and `programs`, and the folders that are rooms or may be.
fn tree() -> (Vec<Source>, BTreeSet<String>) {
    let (mut sources, mut folders) = (Vec::new(), BTreeSet::new());
    walk("src", &mut sources, &mut folders);
    walk("programs", &mut sources, &mut folders);
    let is_room = |folder: &String| match folder.strip_prefix("src/") {
        Some(name) => name.matches('/').count() == 1,
        None => true,
    };
    folders.retain(is_room);
    // A room may be a single file.
    let single = sources.iter().filter_map(|source| source.file.strip_prefix("src/"));
    let single = single.filter(|name| !name.contains('/') && *name != "lib.rs");
    folders.extend(single.map(|name| format!("src/{}/", name.trim_end_matches(".rs"))));
    (sources, folders)
}

#[test]
fn rooms_import_only_from_floors_below() {
    let (house, (sources, folders)) = (house(), tree());
    assert!(
        house.rooms.len() > 5 && sources.len() > 50,
        "the table or the sources were not found: {house:?}"
    );
    let mut problems = house.problems_of_the_drawing(&folders);
    problems.extend(house.problems_of_the_imports(&sources));
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn modules_of_the_geometry_form_no_circle() {
    let arrows = arrows_inside("geometry", &tree().0);
    assert!(arrows.values().flatten().count() > 20, "the modules were not found: {arrows:?}");
    assert_eq!(circles(&arrows), Vec::<Vec<&str>>::new(), "circles inside geometry");
}

const DRAWING: &str = "\
| floor | room | what lives there |
|---|---|---|
| 3 | `programs/` = `grafika::programs` | programs |
| 2 | `src/desk/` | asks |
| 1 | `src/ink/`, `src/curve/` | colours and `src/no_room/` |
| 1 | `src/puzzle/` | puzzles |

Exceptions: `puzzle` may use `curve`.
";

/// The problems of one made-up file.
fn problems(file: &str, text: &str) -> Vec<String> {
    let source = Source { file: file.to_string(), text: text.to_string() };
    House::read(DRAWING).problems_of_the_imports(&[source])
}

#[test]
fn the_drawing_is_read() {
    let house = House::read(DRAWING);
    let rooms: Vec<(u32, &str)> = house.rooms.iter().map(|room| (room.floor, room.name.as_str())).collect();
    assert_eq!(rooms, [(3, "programs"), (2, "desk"), (1, "ink"), (1, "curve"), (1, "puzzle")]);
    let folders = |names: &[&str]| names.iter().map(|name| name.to_string()).collect();
    let there = ["programs/", "src/desk/", "src/ink/", "src/curve/", "src/puzzle/"];
    assert_eq!(house.problems_of_the_drawing(&folders(&there)), [""; 0]);
    let problems = house.problems_of_the_drawing(&folders(&[&there[1..], &["src/cellar/"]].concat()));
    assert_eq!(
        problems,
        [
            "programs/ stands in the table, but there is no such folder",
            "src/cellar/ does not stand in the table"
        ]
    );
    let upwards = House::read(&DRAWING.replace("`puzzle` may use `curve`", "`puzzle` may use `desk`"));
    assert_eq!(
        upwards.problems_of_the_drawing(&folders(&there)),
        ["puzzle and desk: an exception is for two rooms of the same floor"]
    );
}

#[test]
fn an_arrow_up_or_sideways_is_found_wherever_it_stands() {
    let up = |problem: &String| {
        problem.starts_with("src/ink/pen.rs imports desk::Desk")
            && problem.ends_with(": ink stands on floor 1, desk on floor 2")
    };
    for text in [
        "use crate::desk::Desk;",
        "use crate::{curve_of as x, desk::Desk};",
        "use crate::desk::{Desk};",
        "use crate::{ink::Color, desk::{Desk as Table}};",
        "pub(crate) use super::super::desk::Desk;",
        "use {std::fmt, super::super::desk::Desk};",
        "fn f(desk: &crate::desk::Desk<'_>) {}",
        "fn f() { g(\"'\", '\"', crate::desk::Desk::new(r#\"\"\"#)) }",
        "/* /* */ */ mod inner { fn f() { super::super::super::desk::Desk } }",
        "#[cfg(test)] mod tests { use crate::desk::Desk; }",
        "use grafika::desk::Desk;",
        "macro_rules! m { () => { $crate::desk::Desk } }",
    ] {
        assert!(problems("src/ink/pen.rs", text).iter().any(up), "{text}");
    }
    let sideways = problems("src/ink/mod.rs", "use crate::curve::Curve;\nuse super::curve::*;");
    assert_eq!(sideways.len(), 2, "{sideways:?}");
    assert_eq!(sideways[0], "src/ink/mod.rs imports curve::*: ink stands on floor 1, curve on floor 1");
    assert_eq!(problems("src/curve/mod.rs", "use crate::puzzle::Cube;").len(), 1, "the other way round");
    assert_eq!(problems("src/desk/mod.rs", "use crate::programs::ALL;").len(), 1);
    assert_eq!(
        problems("src/desk/mod.rs", "use crate::cellar::Wine;"),
        ["src/desk/mod.rs imports cellar::Wine, which is no room"]
    );
    assert_eq!(problems("src/desk/mod.rs", "use crate::*;"), ["src/desk/mod.rs imports *, which is no room"]);
    assert_eq!(problems("src/cellar/mod.rs", ""), ["src/cellar/mod.rs lies in no room"]);
    assert_eq!(problems("programs/x.rs", "use grafika::cellar::Wine;").len(), 1);
}

#[test]
fn what_is_allowed_is_no_problem() {
    for (file, text) in [
        ("src/desk/mod.rs", "use crate::ink::Color; use super::curve::Curve;"),
        ("src/puzzle/mod.rs", "use crate::curve::Curve;"),
        ("src/ink/pen/tip.rs", "use super::super::desk; use crate::ink::{desk, pen::*};"),
        (
            "src/ink/pen.rs",
            "// use crate::desk::Desk;\n/* crate::desk::Desk */ const X: &str = \"crate::desk::Desk\";",
        ),
        ("src/ink/pen.rs", "pub(in crate::ink) fn f<'a>(x: &'a str) -> char { 'x' } pub(crate) mod desk;"),
        ("programs/x/y.rs", "use grafika::desk::Desk; use crate::helper::Help; use crate::ink::Color;"),
        ("src/lib.rs", "pub mod desk;"),
    ] {
        assert_eq!(problems(file, text), [""; 0], "{text}");
    }
}

#[test]
fn circles_are_found() {
    let source = |file: &str, text: &str| Source { file: file.to_string(), text: text.to_string() };
    let sources = [
        source("src/curve/mod.rs", "use crate::puzzle::Cube;"),
        source("src/puzzle/mod.rs", "use crate::curve::Curve;"),
        source("src/desk/mod.rs", "use crate::curve::Curve;"),
    ];
    let problems = House::read(DRAWING).problems_of_the_imports(&sources);
    assert_eq!(problems.last().map(String::as_str), Some("a circle of rooms: curve, puzzle"), "{problems:?}");

    let sources = [
        source(
            "src/curve/mod.rs",
            "mod arc; mod joint; mod weights; pub use weights::{self, Weights as W}; pub use joint::Joint as Knee;",
        ),
        source("src/curve/arc.rs", "use super::{Knee, Other};"),
        source("src/curve/joint.rs", "use super::weights::check;"),
        source("src/curve/weights/mod.rs", "mod row;"),
        source("src/curve/weights/row.rs", "use super::super::arc::Arc; use super::super::{arc};"),
        source("src/curve/point.rs", "#[cfg(test)] mod tests { use super::super::last::Last; }"),
        source("src/curve/last.rs", "use super::point::Point;"),
    ];
    assert_eq!(circles(&arrows_inside("curve", &sources)), [["arc", "joint", "weights"]]);
    assert_eq!(circles(&arrows_inside("curve", &sources[..4])), [[""; 0]; 0]);
}
