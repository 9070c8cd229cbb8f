//! What a program tells its display beside the picture, for displays that offer keys to touch, say what stands on the
//! screen, or pass on what is being made: its keys, what it asks for, its document.

use super::Key;

/// A line of the help page: keys, and what they do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeyLine {
    /// The keys; alternatives and keys that belong together alike.
    pub keys: Vec<Key>,
    /// What they do, in Hungarian and in English.
    pub about: [&'static str; 2],
}

/// What a question takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Request {
    /// One of these keys.
    Keys(Vec<Key>),
    /// A number.
    Number,
    /// A name or a line of text.
    Text,
}

/// What has been told.
#[derive(Default)]
pub(super) struct Prompt {
    pub(super) keys: Vec<KeyLine>,
    pub(super) request: Option<Request>,
    /// Whether the display asks for documents; otherwise none are told.
    pub(super) wanted: bool,
    pub(super) document: Option<Box<dyn Fn() -> Option<String>>>,
}
