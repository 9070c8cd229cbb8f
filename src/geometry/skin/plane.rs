//! The skin of circles.

use super::clear::{choose, near};
use super::graph::{Graph, Node, Place, Walk};
use super::hermite::Hermite;
use super::outline::{Cap, Outline, Piece, SkinArc};
use super::{Circle, Circles, Clearing, Links};
use crate::geometry::Point;

/// What is put over circles: outlines of arcs and caps, and what is known of them. Circles that are not admissible have
/// what exists of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin {
    /// The outlines with their discs to the left: that of a chain or tree is one loop counterclockwise, a ring has an
    /// outer and an inner one.
    pub loops: Vec<Outline>,
    /// The touching points, in the order of the outlines.
    pub touches: Vec<Touch>,
    /// The gaps between two neighbours of a branching circle that the outline passes without touching it: neighbour,
    /// circle, next neighbour.
    pub skipped: Vec<[usize; 3]>,
    /// The circles that have no touching point where the outline should have one, or an arc that cannot be drawn
    /// behind it. The outline is open there.
    pub missing: Vec<usize>,
    /// Of a chain or ring: how many circles, and whether it is a ring.
    order: Option<(usize, bool)>,
}

/// A point where the skin touches a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// The circle.
    pub circle: usize,
    /// On which side of a chain or ring, walked in the order of its numbers; of a tree it is always the right one.
    pub side: Side,
    /// The point.
    pub point: Point<2>,
    /// The unit normal of the circle there, and of the skin.
    pub normal: Point<2>,
}

/// A side of a chain or ring as walked in the order of its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

impl Circles {
    /// The skin of the circles. Where they are not admissible it is what exists of it: outlines may be open or cut
    /// through discs, and say so.
    #[must_use]
    pub fn skin(&self, clearing: Clearing) -> Skin {
        let count = self.circles().len();
        let mut skin = Skin {
            loops: Vec::new(),
            touches: Vec::new(),
            skipped: Vec::new(),
            missing: Vec::new(),
            order: match self.links() {
                Links::Chain => Some((count, false)),
                Links::Ring => Some((count, true)),
                Links::Edges(_) => None,
            },
        };
        for walk in Graph::new(self).walks() {
            skin.add(self.circles(), walk, clearing);
        }
        skin
    }
}

impl Skin {
    /// Adds what lies along a way round.
    fn add(&mut self, circles: &[Circle], walk: Walk, clearing: Clearing) {
        let Walk { nodes, skipped } = walk;
        self.skipped.extend(skipped);
        for node in &nodes {
            match (node.contact, circles.get(node.circle)) {
                (Some(contact), Some(disc)) => self.touches.push(Touch {
                    circle: node.circle,
                    side: self.side(node),
                    point: disc.point(contact.normal),
                    normal: contact.normal,
                }),
                _ => self.missing.push(node.circle),
            }
        }
        let next = nodes.iter().cycle().skip(1);
        let pieces: Vec<Option<Piece>> = nodes
            .iter()
            .zip(next)
            .map(|(from, to)| {
                let piece = piece(circles, from, to, clearing);
                if piece.is_none() && from.contact.is_some() && to.contact.is_some() {
                    self.missing.push(from.circle);
                }
                piece
            })
            .collect();
        if nodes.len() > 1 && pieces.iter().all(Option::is_some) {
            self.loops.push(Outline { pieces: pieces.into_iter().flatten().collect(), closed: true });
            return;
        }
        // From behind a break round to it.
        let start = pieces.iter().position(Option::is_none).map_or(0, |at| at + 1);
        let (head, tail) = pieces.split_at(start);
        let turned: Vec<Option<Piece>> = tail.iter().chain(head).copied().collect();
        let runs = turned.split(Option::is_none).filter(|run| !run.is_empty());
        let outline = |run: &[Option<Piece>]| Outline {
            pieces: run.iter().copied().flatten().collect(),
            closed: false,
        };
        self.loops.extend(runs.map(outline));
    }

    /// The side that a touching point lies on.
    fn side(&self, node: &Node) -> Side {
        let Some((count, ring)) = self.order else { return Side::Right };
        let before = if node.circle > 0 || !ring { node.circle.checked_sub(1) } else { count.checked_sub(1) };
        // The outline goes along the right side with the numbers, and round the cap to the other.
        let right = (before == Some(node.from)) != (node.place == Place::AfterCap);
        if right { Side::Right } else { Side::Left }
    }

    /// The arcs of a side of a chain or ring in the order of its numbers; none of a tree.
    #[must_use]
    pub fn side_arcs(&self, side: Side) -> Vec<SkinArc> {
        let Some((count, _)) = self.order else { return Vec::new() };
        let forward = |[i, j]: [usize; 2]| {
            if i + 1 == j || (j == 0 && i + 1 == count && count > 2) { Some(i) } else { None }
        };
        let mut arcs: Vec<Option<SkinArc>> = vec![None; count];
        for arc in self.loops.iter().flat_map(Outline::arcs) {
            let arc = if side == Side::Right { *arc } else { arc.reversed() };
            if let Some(slot) = forward(arc.circles).and_then(|i| arcs.get_mut(i)) {
                *slot = Some(arc);
            }
        }
        arcs.into_iter().flatten().collect()
    }

    /// The touching points of every circle of a chain or ring, on its left and its right side; none of a tree.
    #[must_use]
    pub fn sides(&self) -> Vec<[Option<Point<2>>; 2]> {
        let Some((count, _)) = self.order else { return Vec::new() };
        let mut sides = vec![[None; 2]; count];
        for touch in &self.touches {
            if let Some([left, right]) = sides.get_mut(touch.circle) {
                *(if touch.side == Side::Left { left } else { right }) = Some(touch.point);
            }
        }
        sides
    }

    /// The circles of the arcs that enter a disc, in the direction of the outline.
    #[must_use]
    pub fn unclear(&self) -> Vec<[usize; 2]> {
        let arcs = self.loops.iter().flat_map(Outline::arcs);
        arcs.filter(|arc| !arc.clear).map(|arc| arc.circles).collect()
    }

    /// Whether nothing is missing, so that all outlines are closed.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.missing.is_empty() && self.loops.iter().all(|outline| outline.closed)
    }
}

/// What lies between two touching points.
fn piece(circles: &[Circle], from: &Node, to: &Node, clearing: Clearing) -> Option<Piece> {
    let numbers = [from.circle, to.circle];
    let (own, contacts) =
        ([circles.get(numbers[0])?, circles.get(numbers[1])?], [from.contact?, to.contact?]);
    let normals = contacts.map(|contact| contact.normal);
    if from.place == Place::Cap {
        return Some(Piece::Cap(Cap::new(from.circle, *own[0], normals)));
    }
    if numbers[0] == numbers[1] {
        return None;
    }
    let ends = [0, 1].map(|k| (own[k].point(normals[k]), contacts[k].forward()));
    let arc = Hermite::between(own, ends);
    if !arc.is_drawn() {
        return None;
    }
    let others = near(&[arc], circles, numbers);
    let (scale, clear) = choose(clearing, &[arc], own, &others);
    Some(Piece::Arc(SkinArc { circles: numbers, bezier: arc.scaled(scale), scale, clear }))
}
