//! What a desktop and a package are told: the files in `data/desktop/` are those that `examples/make_desktop.rs`
//! makes, and the manifest names every program.

#[allow(dead_code, reason = "its main function")]
#[path = "../examples/make_desktop.rs"]
mod make_desktop;

use std::path::Path;

fn read(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

#[test]
fn the_desktop_files_are_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/desktop");
    for (name, content) in make_desktop::files().unwrap() {
        let found = std::fs::read(folder.join(name)).unwrap_or_default();
        assert!(found == content, "{name}: run `cargo run --example make_desktop`");
    }
}

#[test]
fn every_data_file_has_a_type_that_opens() {
    let (types, desktop) = (read("data/desktop/grafika.xml"), read("data/desktop/grafika.desktop"));
    for format in make_desktop::own_formats() {
        let extension = format.extension().to_lowercase();
        assert!(types.contains(&format!("\"*.{extension}\"")), "{format}");
        assert!(desktop.contains(&format!("application/x-grafika-{extension};")), "{format}");
    }
}

/// The names of the programs in the manifest.
fn programs() -> Vec<String> {
    let manifest = read("Cargo.toml");
    let bins = manifest.lines().filter(|line| line.contains("path = \"programs/bin/"));
    bins.filter_map(|line| line.split('"').nth(1)).map(str::to_owned).collect()
}

#[test]
fn an_installation_has_every_program() {
    let manifest = read("Cargo.toml");
    let programs = programs();
    assert_eq!(programs.len(), 1 + grafika::programs::ALL.len());
    for name in programs.iter().filter(|name| *name != "grafika") {
        let page = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("docs/{name}.md"));
        assert!(page.is_file(), "{}", page.display());
    }
    for line in manifest.lines().filter(|line| line.contains("path = \"programs/bin/")) {
        assert!(line.contains("required-features = [\"native\"]"), "{line}");
    }
    assert!(manifest.contains("default = [\"window\", \"terminal\"]"));
}

#[test]
fn the_package_takes_files_that_are_there() {
    let manifest = read("Cargo.toml");
    let (_, package) = manifest.split_once("[package.metadata.deb]").unwrap();
    let assets = package.lines().filter_map(|line| line.trim().strip_prefix("[\"")?.split('"').next());
    let mut seen = 0;
    for asset in assets {
        seen += 1;
        if let Some(made) = asset.strip_prefix("target/release/deb/") {
            let folder = made.rsplit_once('/').map_or(made, |(folder, _)| folder);
            let makes = read("scripts/deb").contains(&format!("\"$made/{folder}"));
            assert!(makes, "scripts/deb does not make {asset}");
        } else if asset == "target/release/grafika" {
            assert!(read("scripts/deb").contains("cargo build --release --bin grafika"));
        } else if !asset.contains('*') {
            assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join(asset).is_file(), "{asset}");
        }
    }
    assert!(seen > 10);
}
