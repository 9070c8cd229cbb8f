//! Any bytes as a file: refused with a reason, or a document that is written and read again without a change. The
//! target is named after the kind of file; `dos` takes the kind from the first byte.
#![no_main]

use grafika::file::{Document, FileKind, Format};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let (kind, bytes) = match FileKind::from_extension(env!("CARGO_BIN_NAME")) {
        Some(kind) => (kind, bytes),
        None => {
            let Some((&first, rest)) = bytes.split_first() else { return };
            let formats: Vec<Format> = Format::dos().collect();
            (FileKind::Dos(formats[usize::from(first) % formats.len()]), rest)
        }
    };
    match Document::decode(kind, bytes) {
        Ok(document) => {
            let written = document.encode(kind).expect("what was read can be written");
            assert_eq!(Document::decode(kind, &written).as_ref(), Ok(&document));
            assert!(!document.describe().is_empty());
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});
