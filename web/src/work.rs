//! Unsaved work, which the page keeps; and what lost pages have left.

use crate::host::Host;
use grafika::machine::{Lost, Recovery, Verdict, Work};
use serde::Deserialize;
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;
use std::time::Duration;

/// Work that a page has left, as the page that found it tells it; newest first.
#[derive(Deserialize)]
pub(crate) struct Left {
    id: String,
    /// How long ago it was kept, in milliseconds.
    age: f64,
    program: String,
    file: Option<String>,
    content: String,
}

/// Why work could not be kept, as the page tells it later.
pub(crate) type Trouble = Rc<RefCell<Option<String>>>;

/// The place of unsaved work.
pub(crate) struct Keeping {
    host: Rc<Host>,
    left: VecDeque<Left>,
    /// The work that is being asked about.
    asked: Option<String>,
    trouble: Trouble,
}

impl Keeping {
    pub(crate) fn new(host: Rc<Host>, left: Vec<Left>, trouble: Trouble) -> Keeping {
        Keeping { host, left: left.into(), asked: None, trouble }
    }
}

impl Recovery for Keeping {
    fn keep(&mut self, work: Work) {
        self.host.keep_work(&work.program, work.file, &work.content);
    }

    fn forget(&mut self) {
        self.host.forget_work();
    }

    fn lost(&mut self, program: &str) -> Option<Lost> {
        let at = self.left.iter().position(|left| left.program.eq_ignore_ascii_case(program))?;
        let Left { id, age, program, file, content } = self.left.remove(at)?;
        self.asked = Some(id);
        Some(Lost {
            name: file.clone().unwrap_or_else(|| program.clone()),
            // The conversion saturates and turns a NaN into 0.
            age: Some(Duration::from_millis(age as u64)),
            work: Ok(Work { program, file, content }),
        })
    }

    fn settle(&mut self, verdict: Verdict) {
        let Some(id) = self.asked.take() else { return };
        let verdict = match verdict {
            Verdict::TakenUp => "taken",
            Verdict::Deleted => "deleted",
            Verdict::Later => "later",
            Verdict::Broken => "broken",
        };
        self.host.settle_work(&id, verdict);
    }

    fn problem(&mut self) -> Option<String> {
        self.trouble.borrow_mut().take()
    }
}
