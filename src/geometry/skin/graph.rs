//! The ways round circles that hang together: at every circle the neighbours counterclockwise.

use super::contact::{Contact, contacts, tangents};
use super::{Circle, Circles};

/// Circles with their neighbours in order.
pub(super) struct Graph<'a> {
    circles: &'a [Circle],
    /// The neighbours of every circle counterclockwise.
    neighbours: Vec<Vec<usize>>,
    /// What lies inside another disc by more is inside.
    tolerance: f64,
}

/// A touching point on the way round, or the place of one that does not exist.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// The circle.
    pub(super) circle: usize,
    /// The circle from which the way comes.
    pub(super) from: usize,
    pub(super) contact: Option<Contact>,
    pub(super) place: Place,
}

/// What comes at a touching point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// The way passes between two neighbours.
    Gap,
    /// The way comes to an end circle and goes round it.
    Cap,
    /// The way leaves the end circle.
    AfterCap,
}

/// The gap between two neighbours of a circle: neighbour, circle, next neighbour counterclockwise.
pub(super) type Gap = [usize; 3];

/// A way round, and the gaps on it that are left out.
#[derive(Clone, Debug, Default)]
pub(super) struct Walk {
    pub(super) nodes: Vec<Node>,
    pub(super) skipped: Vec<Gap>,
}

impl<'a> Graph<'a> {
    pub(super) fn new(circles: &'a Circles) -> Self {
        let mut neighbours = circles.links().neighbours(circles.circles().len());
        let balls = circles.circles();
        for (circle, list) in neighbours.iter_mut().enumerate().filter(|(_, list)| list.len() > 2) {
            let Some(here) = balls.get(circle) else { continue };
            let direction = |other: &usize| {
                let [x, y] = balls.get(*other).map_or([0.0; 2], |ball| ball.center);
                (y - here.center[1]).atan2(x - here.center[0])
            };
            list.sort_by(|a, b| direction(a).total_cmp(&direction(b)));
        }
        Self { circles: balls, neighbours, tolerance: super::tolerance(balls) }
    }

    /// Every way round, each half edge once. Those of a chain or ring begin at the first circle, to the right of
    /// the way to the second.
    pub(super) fn walks(&self) -> Vec<Walk> {
        let mut passed: Vec<Vec<bool>> = self.neighbours.iter().map(|list| vec![false; list.len()]).collect();
        let mut walks = Vec::new();
        for circle in 0..self.neighbours.len() {
            // Backwards: a ring comes to its first circle from the last one first.
            for k in (0..self.neighbours[circle].len()).rev() {
                if !passed[circle][k] {
                    walks.push(self.walk([circle, k], &mut passed));
                }
            }
        }
        walks
    }

    /// The way round that comes to a circle from a neighbour of it, given by its place in the list.
    fn walk(&self, [mut here, mut k]: [usize; 2], passed: &mut [Vec<bool>]) -> Walk {
        let mut walk = Walk::default();
        while !std::mem::replace(&mut passed[here][k], true) {
            let list = &self.neighbours[here];
            let (from, next) = (list[k], list[(k + 1) % list.len()]);
            if list.len() == 1 {
                let [first, last] = self.end(here, from);
                walk.nodes.push(Node { circle: here, from, contact: first, place: Place::Cap });
                walk.nodes.push(Node { circle: here, from, contact: last, place: Place::AfterCap });
            } else {
                let contact = self.gap([from, here, next]);
                let left_out =
                    list.len() > 2 && contact.is_none_or(|contact| self.is_covered(here, &contact));
                if left_out {
                    walk.skipped.push([from, here, next]);
                } else {
                    walk.nodes.push(Node { circle: here, from, contact, place: Place::Gap });
                }
            }
            // Edges lead both ways.
            k = self.neighbours[next].iter().position(|circle| *circle == here).unwrap_or(0);
            here = next;
        }
        walk
    }

    /// The touching point of a gap: to the right of the way through it.
    fn gap(&self, [from, here, next]: Gap) -> Option<Contact> {
        contacts(&self.circles[from], &self.circles[here], &self.circles[next])[1]
    }

    /// The touching points of an end circle, where the way comes and where it goes: those of the touching circles of
    /// its neighbour, or of common tangents.
    fn end(&self, here: usize, neighbour: usize) -> [Option<Contact>; 2] {
        let (own, other) = (&self.circles[here], &self.circles[neighbour]);
        let straight =
            || tangents(other, own).map_or([None, None], |[left, right]| [Some(right), Some(left)]);
        let list = &self.neighbours[neighbour];
        if list.len() < 2 {
            return straight();
        }
        let k = list.iter().position(|circle| *circle == here).unwrap_or(0);
        let (before, behind) = (list[(k + list.len() - 1) % list.len()], list[(k + 1) % list.len()]);
        let found = [[before, neighbour, here], [here, neighbour, behind]].map(|gap| {
            let moved = self.gap(gap)?.moved(other, own);
            moved.normal.iter().all(|x| x.is_finite()).then_some(moved)
        });
        if list.len() == 2 {
            return found;
        }
        // A branch is left out, not its end.
        let straight = straight();
        [found[0].or(straight[0]), found[1].or(straight[1])]
    }

    /// Whether a touching point lies in another disc.
    fn is_covered(&self, circle: usize, contact: &Contact) -> bool {
        let point = self.circles[circle].point(contact.normal);
        let others = self.circles.iter().enumerate().filter(|(index, _)| *index != circle);
        others.map(|(_, other)| other).any(|other| other.contains(point, -self.tolerance))
    }

    /// The gaps of inner circles that have a touching point, with it.
    pub(super) fn gaps(&self) -> Vec<(Gap, Contact)> {
        self.neighbouring().filter_map(|gap| Some((gap, self.gap(gap)?))).collect()
    }

    /// Every circle with two successive neighbours, once.
    pub(super) fn triples(&self) -> Vec<Gap> {
        self.neighbouring().filter(|[a, here, b]| self.neighbours[*here].len() > 2 || a < b).collect()
    }

    /// The gaps of inner circles.
    fn neighbouring(&self) -> impl Iterator<Item = Gap> + '_ {
        let inner = self.neighbours.iter().enumerate().filter(|(_, list)| list.len() > 1);
        inner.flat_map(|(here, list)| {
            (0..list.len()).map(move |k| [list[k], here, list[(k + 1) % list.len()]])
        })
    }
}
