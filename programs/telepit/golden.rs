//! Pages as their tests keep them.

use crate::textmode::Page;
use std::path::Path;

/// Compares a page of 80x25 with the text that is kept of it; `UPDATE_PICTURES=1` makes it anew.
#[track_caller]
pub(crate) fn assert_golden(page: &Page, name: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
    let text = page.to_text(80, 25) + "\n";
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    let golden = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(text == golden, "{name}: expected\n{golden}\nfound\n{text}");
}
