//! Nothing below the displays and the disk knows a window, a thread, a file, a clock or the environment: these rooms
//! run in a browser as they are.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::path::{Path, PathBuf};

const ROOMS: [&str; 10] =
    ["machine", "ui", "editor", "screen", "geometry", "puzzle", "table", "pascal", "file", "figure"];

/// What only a system has. A path that begins with one of these is one too many.
const SYSTEM: [&str; 20] = [
    "std::env",
    "std::fs",
    "std::io::stderr",
    "std::io::stdin",
    "std::io::stdout",
    "std::net",
    "std::os",
    "std::process",
    "std::thread",
    "std::time::Instant",
    "std::time::SystemTime",
    "crossterm",
    "etcetera",
    "indicatif",
    "ratatui",
    "rustix",
    "signal_hook",
    "softbuffer",
    "tempfile",
    "winit",
];

/// Every path in the tokens but those of unit tests. What stands in the braces of a `use` begins with what stands
/// before them.
fn paths(tokens: TokenStream, before: &str) -> Vec<String> {
    let (mut paths, mut path) = (Vec::new(), before.to_string());
    let mut colons = if before.is_empty() { 0 } else { 2 };
    // Whether the item that begins is compiled for unit tests only.
    let mut test = false;
    for token in tokens {
        match token {
            TokenTree::Punct(sign) if sign.as_char() == ':' => {
                colons += 1;
                continue;
            }
            TokenTree::Ident(word) if colons == 2 && !path.is_empty() => path += &format!("::{word}"),
            TokenTree::Ident(word) => paths.push(std::mem::replace(&mut path, word.to_string())),
            TokenTree::Group(group) => {
                let inside = if colons == 2 { path.as_str() } else { "" };
                if !test {
                    paths.extend(self::paths(group.stream(), inside));
                }
                paths.push(std::mem::take(&mut path));
                test &= group.delimiter() != Delimiter::Brace;
                test |= group.stream().to_string().replace(' ', "") == "cfg(test)";
            }
            TokenTree::Punct(sign) => {
                paths.push(std::mem::take(&mut path));
                test &= sign.as_char() != ';';
                if sign.as_char() == ',' && !before.is_empty() {
                    path = before.to_string();
                    colons = 2;
                    continue;
                }
            }
            TokenTree::Literal(_) => {}
        }
        colons = 0;
    }
    paths.push(path);
    paths
}

/// The paths of a source that lead to the system.
fn wrong(source: &str) -> Vec<String> {
    let leads = |path: &String| {
        let behind = |system| path.strip_prefix(system);
        SYSTEM.iter().filter_map(behind).any(|rest| rest.is_empty() || rest.starts_with("::"))
    };
    paths(source.parse().expect("it is Rust"), "").into_iter().filter(leads).collect()
}

/// The sources of a room; a file `tests.rs` is compiled for unit tests only.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut found = Vec::new();
    for path in entries.map(|entry| entry.expect("it can be read").path()) {
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|it| it == "rs") && !path.ends_with("tests.rs") {
            found.push(path);
        }
    }
    found
}

#[test]
fn nothing_below_the_displays_knows_a_window_a_thread_or_a_file() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut told = Vec::new();
    for room in ROOMS {
        let sources = sources(&source.join(room));
        assert!(!sources.is_empty(), "{room} is no room");
        for path in sources {
            let text = std::fs::read_to_string(&path).expect("sources are text");
            told.extend(wrong(&text).iter().map(|wrong| format!("{}: {wrong}", path.display())));
        }
    }
    assert!(told.is_empty(), "this belongs into display, disk or launch:\n{}", told.join("\n"));
}

#[test]
fn the_check_sees_every_way_to_the_system() {
    for (source, found) in [
        ("use std::fs;", "std::fs"),
        ("use std::fs::{self, File};", "std::fs::self"),
        ("use std::{fmt, fs::File as F, rc::Rc};", "std::fs::File"),
        ("use std::time::{Duration, Instant};", "std::time::Instant"),
        ("use std::{time::{Duration, SystemTime}};", "std::time::SystemTime"),
        ("fn f<'a>() { let n = std::env::var(\"X\"); }", "std::env::var"),
        ("fn f() { println!(\"{:?}\", std::thread::current()) }", "std::thread::current"),
        ("fn f() { ::std::thread::sleep(x) }", "std::thread::sleep"),
        ("struct A(std::time::Instant);", "std::time::Instant"),
        ("fn f() -> char { '\"' } use winit::window::Window;", "winit::window::Window"),
        ("#[cfg(test)] mod tests { use std::fs; } use std::net::TcpStream;", "std::net::TcpStream"),
        ("#[cfg(test)] mod tests; use std::process::exit;", "std::process::exit"),
    ] {
        assert!(wrong(source).iter().any(|path| path == found), "{source}: {:?}", wrong(source));
    }
    for source in [
        "//! std::fs\nuse std::time::Duration; /* std::thread */ const A: &str = \"std::env\";",
        "use std::fmt; use crate::fs::File; const B: &str = r#\"use \"std::fs\"\"#; const C: char = '\\'';",
        "#[cfg(test)] mod tests { use std::fs; fn f() { std::thread::yield_now() } } struct Instant;",
        "use std::io::{self, Write}; fn f() { match a { A { b, fs } => {} } }",
    ] {
        assert_eq!(wrong(source), [""; 0], "{source}");
    }
}
