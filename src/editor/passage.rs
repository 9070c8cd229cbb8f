//! The way between the two pages of a program, such as that of the plane and that of space.

use crate::file::Document;
use crate::machine::{Asked, Machine};
use crate::ui::Start;
use crate::ui::words::Phrase;
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// Prepares the first page of a program, or the second, with or without a document.
pub(crate) type Page = fn(second: bool, &Rc<Passage>, Option<Document>) -> Result<Start, Phrase>;

/// Prepares a program of two pages, which begins with the one that the document belongs to.
///
/// # Errors
/// Why that page cannot open the document.
pub(crate) fn start(second: bool, document: Option<Document>, page: Page) -> Result<Start, Phrase> {
    let passage = Rc::new(Passage::default());
    let first = page(second, &passage, document)?;
    Ok(Box::new(move |machine| Box::pin(run(machine, first, second, passage, page))))
}

async fn run(
    machine: &mut Machine,
    first: Start,
    mut second: bool,
    passage: Rc<Passage>,
    page: Page,
) -> Asked<()> {
    let mut next = first;
    loop {
        next(machine).await?;
        let Some(document) = passage.take() else { return Ok(()) };
        second = !second;
        // A document that a page leads to has been read before, or made of one that was.
        let Ok(page) = page(second, &passage, document) else { return Ok(()) };
        next = page;
    }
}

/// What one page leaves for the other.
#[derive(Debug, Default)]
pub(crate) struct Passage {
    /// The other page is wanted, with or without a document to open there.
    wanted: RefCell<Option<Option<Document>>>,
    /// Whether that document is work that was never saved.
    unsaved: Cell<bool>,
}

impl Passage {
    /// Asks for the other page.
    pub(crate) fn lead(&self, document: Option<Document>) {
        self.wanted.replace(Some(document));
    }

    /// Whether the present page is to be left.
    pub(crate) fn leads_away(&self) -> bool {
        self.wanted.borrow().is_some()
    }

    /// Takes the wish for the other page, and the document.
    pub(crate) fn take(&self) -> Option<Option<Document>> {
        self.wanted.take()
    }

    /// Notes whether the document is unsaved work.
    pub(crate) fn note_unsaved(&self, unsaved: bool) {
        self.unsaved.set(unsaved);
    }

    /// Whether the document that has come here is unsaved work; tells it once.
    pub(crate) fn take_unsaved(&self) -> bool {
        self.unsaved.take()
    }
}
