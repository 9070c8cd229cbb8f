//! Undo and redo of every change, and whether there is anything unsaved.

/// A value with its past and its undone future.
///
/// Values are kept whole: a drawing of 99 points is 1.6 kilobytes, so that an hour of changes is a few
/// megabytes.
#[derive(Clone, Debug)]
pub struct History<T> {
    past: Vec<T>,
    now: T,
    future: Vec<T>,
    saved: T,
}

impl<T: Clone + PartialEq> History<T> {
    /// A history that starts with a value that needs no saving.
    pub fn new(value: T) -> History<T> {
        History { past: Vec::new(), saved: value.clone(), now: value, future: Vec::new() }
    }

    /// The value as it is now.
    pub fn now(&self) -> &T {
        &self.now
    }

    /// Makes a new value the present one; the same value again is no change.
    pub fn change(&mut self, value: T) {
        if value != self.now {
            self.past.push(std::mem::replace(&mut self.now, value));
            self.future.clear();
        }
    }

    /// Goes one change back; whether there was one.
    pub fn undo(&mut self) -> bool {
        step(&mut self.past, &mut self.now, &mut self.future)
    }

    /// Takes one undone change up again; whether there was one.
    pub fn redo(&mut self) -> bool {
        step(&mut self.future, &mut self.now, &mut self.past)
    }

    /// Notes that the present value has been saved.
    pub fn mark_saved(&mut self) {
        self.saved = self.now.clone();
    }

    /// Whether the present value differs from the one saved last.
    pub fn unsaved(&self) -> bool {
        self.now != self.saved
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
