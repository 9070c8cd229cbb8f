//! The way between the page of the plane and that of space.

use crate::file::Document;
use std::cell::{Cell, RefCell};

/// What one page leaves for the other.
#[derive(Debug, Default)]
pub(super) struct Passage {
    /// The other page is wanted, with or without a document to open there.
    wanted: RefCell<Option<Option<Document>>>,
    /// Whether that document is work that was never saved.
    unsaved: Cell<bool>,
}

impl Passage {
    /// Asks for the other page.
    pub(super) fn lead(&self, document: Option<Document>) {
        self.wanted.replace(Some(document));
    }

    /// Whether the present page is to be left.
    pub(super) fn leads_away(&self) -> bool {
        self.wanted.borrow().is_some()
    }

    /// Takes the wish for the other page, and the document.
    pub(super) fn take(&self) -> Option<Option<Document>> {
        self.wanted.take()
    }

    /// Notes whether the document is unsaved work.
    pub(super) fn note_unsaved(&self, unsaved: bool) {
        self.unsaved.set(unsaved);
    }

    /// Whether the document that has come here is unsaved work; tells it once.
    pub(super) fn take_unsaved(&self) -> bool {
        self.unsaved.take()
    }
}
