//! What is computed of circles: the rules that they break, and their skin. The picture asks for it several times; it is
//! computed once.

use crate::design::skin::{circles, outlines};
use crate::file;
use crate::geometry::skin::{Circles, Clearing, Outline, Skin, Violation};
use std::cell::RefCell;
use std::rc::Rc;

/// How the outline is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Style {
    /// Open at the end circles.
    #[default]
    Open,
    /// Closed by their caps.
    Caps,
    /// The same, filled.
    Filled,
}

/// Circles with what follows from them.
#[derive(Debug)]
pub(super) struct Dressed {
    pub(super) circles: Circles,
    pub(super) violations: Vec<Violation>,
    pub(super) skin: Skin,
}

impl Dressed {
    /// What follows from circles; `None` where there are none.
    pub(super) fn new(value: &file::Circles, clearing: Clearing) -> Option<Dressed> {
        let circles = circles(value).ok()?;
        let (violations, skin) = (circles.violations(), circles.skin(clearing));
        Some(Dressed { circles, violations, skin })
    }

    /// The outlines as they are drawn.
    pub(super) fn outlines(&self, style: Style) -> Vec<Outline> {
        outlines(&self.skin, style != Style::Open)
    }

    /// The first rule that makes a circle an offending one.
    pub(super) fn rule(&self, circle: usize) -> Option<u8> {
        let offends = |violation: &&Violation| violation.numbers().contains(&circle);
        self.violations.iter().find(offends).map(Violation::rule)
    }
}

/// What was computed last, and of what.
#[derive(Debug)]
pub(super) struct Memory<K, T>(RefCell<Option<Kept<K, T>>>);

type Kept<K, T> = (K, Clearing, Option<Rc<T>>);

impl<K, T> Default for Memory<K, T> {
    fn default() -> Memory<K, T> {
        Memory(RefCell::new(None))
    }
}

impl<K: Clone + PartialEq, T> Memory<K, T> {
    /// What follows from a value, if anything does.
    pub(super) fn of(
        &self,
        value: &K,
        clearing: Clearing,
        make: impl FnOnce(&K, Clearing) -> Option<T>,
    ) -> Option<Rc<T>> {
        let mut kept = self.0.borrow_mut();
        match &*kept {
            Some((of, by, made)) if of == value && *by == clearing => made.clone(),
            _ => {
                let made = make(value, clearing).map(Rc::new);
                *kept = Some((value.clone(), clearing, made.clone()));
                made
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Instant;

    #[test]
    fn a_hundred_circles_are_quick() {
        let circles = (0..100).map(|k| {
            let k = f64::from(k);
            [6.0 * k, 40.0 * (0.3 * k).sin(), 5.0 + (k % 3.0)]
        });
        let value = file::Circles { circles: circles.collect(), ..file::Circles::default() };
        let memory = Memory::default();
        let since = Instant::now();
        let first = memory.of(&value, Clearing::Scaled, Dressed::new).unwrap();
        let again = memory.of(&value, Clearing::Scaled, |_, _| panic!("it is kept")).unwrap();
        assert!(Rc::ptr_eq(&first, &again));
        // Far above what it takes, for slow machines without optimization.
        assert!(since.elapsed().as_millis() < 400, "{:?}", since.elapsed());
        assert_eq!(first.skin.side_arcs(crate::geometry::skin::Side::Left).len(), 99);
    }
}
