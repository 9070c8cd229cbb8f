//! The sample files in `data/` are those that `examples/make_samples.rs` makes.

#[allow(dead_code)] // its main function
#[path = "../examples/make_samples.rs"]
mod make_samples;

use grafika::file::{Document, FileKind};
use std::path::Path;

#[test]
fn the_samples_are_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let samples = make_samples::samples().unwrap();
    assert_eq!(samples.len(), 14);
    for (name, bytes) in samples {
        let found = std::fs::read(folder.join(name)).unwrap();
        assert!(found == bytes, "{name}: run `cargo run --example make_samples`");
        let format = match FileKind::from_name(name) {
            Some(FileKind::Dos(format)) => format,
            other => panic!("{name}: {other:?}"),
        };
        let document = Document::read(format, &bytes).unwrap();
        assert_eq!(document.write(format), Ok(bytes));
    }
}
