//! Circles with their links: what a skin is put over.

use super::links::check_balls;
use super::{Circle, Links, SkinError};

/// Circles of the plane that hang together as a chain, a ring or a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Circles {
    circles: Vec<Circle>,
    links: Links,
}

impl Circles {
    /// Circles with their links.
    ///
    /// # Errors
    /// [`SkinError`] for no circles or too many, coordinates and radii out of range, a ring of less than three, and
    /// edges that lead nowhere, join a circle with itself or are there twice. A tree that has cycles or falls into
    /// parts is taken; see [`Circles::check_tree`].
    pub fn new(circles: Vec<Circle>, links: Links) -> Result<Self, SkinError> {
        check_balls(&circles)?;
        links.check(circles.len())?;
        Ok(Self { circles, links })
    }

    /// A chain: every circle is a neighbour of the next.
    ///
    /// # Errors
    /// As [`Circles::new`].
    pub fn chain(circles: Vec<Circle>) -> Result<Self, SkinError> {
        Self::new(circles, Links::Chain)
    }

    /// The same circles, one of which has another place or radius; unchanged where there is no such circle.
    ///
    /// # Errors
    /// As [`Circles::new`].
    pub fn with_circle(&self, index: usize, circle: Circle) -> Result<Self, SkinError> {
        let mut circles = self.circles.clone();
        if let Some(place) = circles.get_mut(index) {
            *place = circle;
        }
        Self::new(circles, self.links.clone())
    }

    /// Whether this is one tree (a chain is one): it has no cycle, and hangs together. Only then the outline is one
    /// loop.
    ///
    /// # Errors
    /// [`SkinError::Cycle`], [`SkinError::NotConnected`].
    pub fn check_tree(&self) -> Result<(), SkinError> {
        self.links.check_tree(self.circles.len())
    }

    /// The circles.
    #[must_use]
    pub fn circles(&self) -> &[Circle] {
        &self.circles
    }

    /// How they hang together.
    #[must_use]
    pub fn links(&self) -> &Links {
        &self.links
    }

    /// The pairs of neighbours.
    #[must_use]
    pub fn edges(&self) -> Vec<[usize; 2]> {
        self.links.edges(self.circles.len())
    }
}
