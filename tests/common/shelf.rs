//! A place of recovery in memory, which outlives its sessions as the folder on disk outlives a crash.

use grafika::machine::{Lost, Recovery, Verdict, Work};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::rc::Rc;
use std::time::Duration;

/// What lies on the shelf, the oldest first.
#[derive(Clone, Default)]
pub(crate) struct Shelf(Rc<RefCell<Vec<Item>>>);

/// Work on the shelf.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Item {
    pub(crate) work: Result<Work, String>,
    /// Whether its session still runs.
    pub(crate) held: bool,
    pub(crate) broken: bool,
    number: usize,
}

impl Shelf {
    /// A place for one session.
    pub(crate) fn slot(&self) -> Slot {
        Slot { shelf: self.clone(), own: None, offered: None, told_of: BTreeSet::new() }
    }

    pub(crate) fn items(&self) -> Vec<Item> {
        self.0.borrow().clone()
    }

    /// The only work on the shelf.
    #[track_caller]
    pub(crate) fn only(&self) -> Work {
        match self.items().as_slice() {
            [Item { work: Ok(work), broken: false, .. }] => work.clone(),
            other => panic!("there should be one work: {other:?}"),
        }
    }

    /// Lays down what a session has left behind.
    pub(crate) fn put(&self, work: Result<Work, String>) -> usize {
        let mut items = self.0.borrow_mut();
        let number = items.iter().map(|item| item.number + 1).max().unwrap_or(0);
        items.push(Item { work, held: false, broken: false, number });
        number
    }

    fn change(&self, number: usize, change: impl FnOnce(&mut Item)) {
        if let Some(item) = self.0.borrow_mut().iter_mut().find(|item| item.number == number) {
            change(item);
        }
    }

    fn remove(&self, number: usize) {
        self.0.borrow_mut().retain(|item| item.number != number);
    }
}

/// The shelf as one session sees it.
pub(crate) struct Slot {
    shelf: Shelf,
    own: Option<usize>,
    offered: Option<usize>,
    told_of: BTreeSet<usize>,
}

impl Recovery for Slot {
    fn keep(&mut self, work: Work) {
        let own = *self.own.get_or_insert_with(|| self.shelf.put(Err(String::new())));
        self.shelf.change(own, |item| (item.work, item.held) = (Ok(work), true));
    }

    fn forget(&mut self) {
        if let Some(own) = self.own.take() {
            self.shelf.remove(own);
        }
    }

    fn lost(&mut self, program: &str) -> Option<Lost> {
        self.settle(Verdict::Later);
        let found = self.shelf.items().into_iter().rev().find(|item| {
            let own = item.work.as_ref().map_or(true, |work| work.program == program);
            own && !item.held && !item.broken && !self.told_of.contains(&item.number)
        })?;
        self.shelf.change(found.number, |item| item.held = true);
        self.offered = Some(found.number);
        let minutes = 5 + 60 * found.number as u64;
        let name = format!("/home/me/{program}-{}.unsaved", found.number);
        Some(Lost { name, age: Some(Duration::from_secs(60 * minutes)), work: found.work })
    }

    fn settle(&mut self, verdict: Verdict) {
        let Some(number) = self.offered.take() else { return };
        self.told_of.insert(number);
        match verdict {
            Verdict::TakenUp => self.own = Some(number),
            Verdict::Deleted => self.shelf.remove(number),
            Verdict::Later => self.shelf.change(number, |item| item.held = false),
            Verdict::Broken => self.shelf.change(number, |item| (item.held, item.broken) = (false, true)),
        }
    }

    fn problem(&mut self) -> Option<String> {
        None
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        for number in self.own.into_iter().chain(self.offered) {
            self.shelf.change(number, |item| item.held = false);
        }
    }
}
