//! Any bytes as a file of the kind that the target is named after: refused with a reason, or a document that
//! is written and read again without a change.
#![no_main]

use grafika::file::{Document, FileKind};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let kind = FileKind::from_name(concat!("x.", env!("CARGO_BIN_NAME"))).expect("targets are named after kinds");
    match Document::decode(kind, bytes) {
        Ok(document) => {
            let written = document.encode(kind).expect("what was read can be written");
            assert_eq!(Document::decode(kind, &written).as_ref(), Ok(&document));
            assert!(!document.describe().is_empty());
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});
