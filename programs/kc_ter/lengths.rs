//! Critical lengths of the scene's spaces, which are searched for while nothing else is done.

use super::space;
use crate::file::ec::{Item, Scene};
use crate::geometry::ec::{CriticalLength, Space};

/// Critical lengths that are known, and the search for the next.
#[derive(Default)]
pub(super) struct Lengths {
    pub(super) known: Vec<(Space, f64)>,
    pub(super) search: Option<(Space, CriticalLength)>,
}

impl Lengths {
    pub(super) fn of(&self, space: &Space) -> Option<f64> {
        self.known.iter().find(|(known, _)| known == space).map(|(_, length)| *length)
    }

    /// Advances the search for the spaces of a scene by some steps.
    pub(super) fn advance(&mut self, scene: &Scene) {
        if self.search.is_none() {
            let spaces = scene.items.iter().flat_map(|item| match item {
                Item::Curve(curve) => vec![&curve.space],
                Item::Patch(patch) => vec![&patch.space_u, &patch.space_v],
            });
            let unknown = spaces.into_iter().find(|space| self.of(space).is_none());
            self.search = unknown.map(|space| (space.clone(), CriticalLength::new(space)));
        }
        if let Some((unknown, search)) = &mut self.search
            && let Some(length) = (0..space::budget(unknown.dimension())).find_map(|_| search.advance())
        {
            self.known.push((unknown.clone(), length));
            self.search = None;
            // Enough for every scene, and no more than a session needs.
            if self.known.len() > KEPT {
                self.known.remove(0);
            }
        }
    }

    pub(super) fn busy(&self, scene: &Scene) -> bool {
        self.search.is_some()
            || scene.items.iter().any(|item| match item {
                Item::Curve(curve) => self.of(&curve.space).is_none(),
                Item::Patch(patch) => [&patch.space_u, &patch.space_v].iter().any(|it| self.of(it).is_none()),
            })
    }
}

/// Spaces whose lengths are kept.
pub(super) const KEPT: usize = 200;
