//! Which circles or spheres are neighbours.

use super::{Ball, MAX_BALLS, MAX_EDGES, SkinError};
use crate::geometry::COORDINATE_LIMIT;
use std::collections::HashSet;

/// How circles hang together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Links {
    /// In the order of their numbers.
    Chain,
    /// The same, and the last with the first.
    Ring,
    /// By pairs of numbers, from 0: a tree. Several trees, and cycles, have skins too.
    Edges(Vec<[usize; 2]>),
}

impl Links {
    /// The pairs of neighbours among so many circles.
    #[must_use]
    pub fn edges(&self, count: usize) -> Vec<[usize; 2]> {
        let along = (1..count).map(|i| [i - 1, i]);
        match self {
            Self::Chain => along.collect(),
            Self::Ring => along.chain(count.checked_sub(1).map(|last| [last, 0])).collect(),
            Self::Edges(edges) => edges.clone(),
        }
    }

    /// The neighbours of every circle, in the order of the edges.
    pub(super) fn neighbours(&self, count: usize) -> Vec<Vec<usize>> {
        let mut neighbours = vec![Vec::new(); count];
        for [a, b] in self.edges(count) {
            for [from, to] in [[a, b], [b, a]] {
                if let Some(list) = neighbours.get_mut(from) {
                    list.push(to);
                }
            }
        }
        neighbours
    }

    /// The circles before, at and behind every inner place of a chain or ring; none of a ring of three, where all are
    /// neighbours.
    pub(super) fn triples(&self, count: usize) -> Vec<[usize; 3]> {
        match self {
            Self::Ring if count > 3 => {
                (0..count).map(|i| [(i + count - 1) % count, i, (i + 1) % count]).collect()
            }
            Self::Chain => (2..count).map(|i| [i - 2, i - 1, i]).collect(),
            Self::Ring | Self::Edges(_) => Vec::new(),
        }
    }

    /// Whether the links fit so many circles.
    pub(super) fn check(&self, count: usize) -> Result<(), SkinError> {
        match self {
            Self::Chain => Ok(()),
            Self::Ring if count < 3 => Err(SkinError::TooFew { shape: "ring", given: count, needed: 3 }),
            Self::Ring => Ok(()),
            Self::Edges(edges) => check_edges(edges, count),
        }
    }

    /// Whether the links make a tree of so many circles; a chain is one, a ring is none.
    pub(super) fn check_tree(&self, count: usize) -> Result<(), SkinError> {
        let mut root: Vec<usize> = (0..count).collect();
        let top = |root: &[usize], mut at: usize| {
            while let Some(&above) = root.get(at).filter(|above| **above != at) {
                at = above;
            }
            at
        };
        for (edge, circles) in self.edges(count).into_iter().enumerate() {
            let [a, b] = circles.map(|circle| top(&root, circle));
            if a == b {
                return Err(SkinError::Cycle { edge, circles });
            }
            if let Some(slot) = root.get_mut(a.max(b)) {
                *slot = a.min(b);
            }
        }
        match (0..count).find(|&circle| top(&root, circle) != 0) {
            Some(circle) => Err(SkinError::NotConnected { circle }),
            None => Ok(()),
        }
    }
}

/// Whether edges join different circles that exist, each pair once.
fn check_edges(edges: &[[usize; 2]], count: usize) -> Result<(), SkinError> {
    if edges.len() > MAX_EDGES {
        return Err(SkinError::TooManyEdges { given: edges.len() });
    }
    let mut seen = HashSet::with_capacity(edges.len());
    for (edge, &circles) in edges.iter().enumerate() {
        let [a, b] = circles;
        if let Some(named) = circles.into_iter().find(|circle| *circle >= count) {
            return Err(SkinError::NoSuch { what: "edge", index: edge, named, count });
        }
        if a == b {
            return Err(SkinError::ToItself { edge, circle: a });
        }
        if !seen.insert([a.min(b), a.max(b)]) {
            return Err(SkinError::Doubled { edge, circles });
        }
    }
    Ok(())
}

/// The checks on every list of circles or spheres.
pub(super) fn check_balls<const D: usize>(balls: &[Ball<D>]) -> Result<(), SkinError> {
    if balls.is_empty() {
        return Err(SkinError::TooFew { shape: "skin", given: 0, needed: 1 });
    }
    if balls.len() > MAX_BALLS {
        return Err(SkinError::TooMany { given: balls.len() });
    }
    for (index, ball) in balls.iter().enumerate() {
        let number = index + 1;
        let is_good = |x: &f64| x.abs() <= COORDINATE_LIMIT;
        if let Some(value) = ball.center.into_iter().find(|x| !is_good(x)) {
            return Err(SkinError::Center { number, value });
        }
        if !(ball.radius > 0.0 && ball.radius <= COORDINATE_LIMIT) {
            return Err(SkinError::Radius { number, value: ball.radius });
        }
    }
    Ok(())
}
