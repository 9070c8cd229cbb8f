//! Undo and redo, and whether there are unsaved changes.

/// A value with its undo and redo stacks.
///
/// Values are stored whole: a drawing of 99 points takes 1.6 kilobytes, an hour of changes a few megabytes.
#[derive(Clone, Debug)]
pub struct History<T> {
    past: Vec<T>,
    now: T,
    future: Vec<T>,
    /// The value that needs no saving, if there is one.
    saved: Option<T>,
    /// Whether the present or the saved value may have changed since the last [`History::take_touched`].
    touched: bool,
}

impl<T: Clone + PartialEq> History<T> {
    /// A history that starts with a value that needs no saving.
    pub fn new(value: T) -> History<T> {
        History {
            past: Vec::new(),
            saved: Some(value.clone()),
            now: value,
            future: Vec::new(),
            touched: true,
        }
    }

    /// The present value.
    pub fn now(&self) -> &T {
        &self.now
    }

    /// Commits a value; an equal value is not a change.
    pub fn change(&mut self, value: T) {
        if value != self.now {
            self.past.push(std::mem::replace(&mut self.now, value));
            self.future.clear();
            self.touched = true;
        }
    }

    /// Replaces the present value by one that belongs to the same change, so that one undo takes both back.
    pub fn amend(&mut self, value: T) {
        self.now = value;
        self.future.clear();
        self.touched = true;
    }

    /// Undoes one change; returns whether there was one.
    pub fn undo(&mut self) -> bool {
        self.touched = true;
        step(&mut self.past, &mut self.now, &mut self.future)
    }

    /// Redoes one change; returns whether there was one.
    pub fn redo(&mut self) -> bool {
        self.touched = true;
        step(&mut self.future, &mut self.now, &mut self.past)
    }

    /// Notes that the present value has been saved.
    pub fn mark_saved(&mut self) {
        self.saved = Some(self.now.clone());
        self.touched = true;
    }

    /// Notes that no value has been saved.
    pub fn mark_unsaved(&mut self) {
        self.saved = None;
        self.touched = true;
    }

    /// Whether the present value differs from the one saved last.
    pub fn unsaved(&self) -> bool {
        self.differs(&self.now)
    }

    /// Whether a value differs from the one saved last.
    pub fn differs(&self, value: &T) -> bool {
        self.saved.as_ref() != Some(value)
    }

    /// Whether anything may have changed since the last call, so that callers need not compare values after every
    /// event.
    pub fn take_touched(&mut self) -> bool {
        std::mem::take(&mut self.touched)
    }

    /// Makes the next [`History::take_touched`] return true, for copies that hold more than the value.
    pub fn touch(&mut self) {
        self.touched = true;
    }
}

fn step<T>(from: &mut Vec<T>, now: &mut T, to: &mut Vec<T>) -> bool {
    let Some(value) = from.pop() else { return false };
    to.push(std::mem::replace(now, value));
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn undo_and_redo_walk_through_the_changes() {
        let mut history = History::new(0);
        (1..=3).for_each(|value| history.change(value));
        history.change(3);
        assert!(history.undo() && history.undo());
        assert_eq!(*history.now(), 1);
        assert!(history.redo());
        history.change(7);
        assert!(!history.redo());
        assert_eq!(*history.now(), 7);
        assert!(history.undo() && history.undo() && history.undo() && !history.undo());
        assert!(!history.unsaved());
    }

    #[test]
    fn every_change_touches_and_nothing_else() {
        let mut history = History::new(0);
        assert!(history.take_touched() && !history.take_touched());
        history.change(0);
        assert!(!history.take_touched());
        let changes: [fn(&mut History<i32>); 5] = [
            |history| history.change(1),
            |history| history.mark_saved(),
            |history| history.mark_unsaved(),
            |history| assert!(history.undo()),
            |history| assert!(history.redo()),
        ];
        for change in changes {
            change(&mut history);
            assert!(history.take_touched() && !history.take_touched());
        }
        assert!(history.unsaved());
    }

    proptest! {
        #[test]
        fn everything_undone_and_redone_is_as_before(values in prop::collection::vec(0u8..4, 0..40)) {
            let mut history = History::new(0u8);
            values.iter().for_each(|&value| history.change(value));
            let last = *history.now();
            let mut undone = 0;
            while history.undo() { undone += 1; }
            prop_assert_eq!(*history.now(), 0);
            for _ in 0..undone { prop_assert!(history.redo()); }
            prop_assert_eq!(*history.now(), last);
        }
    }
}
