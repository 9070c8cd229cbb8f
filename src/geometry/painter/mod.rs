//! The painter's algorithm of the book (chapters 3.1, 4.4.2 and 4.4.3): which face hides which is settled by the order in
//! which they are painted, each over those before.
//!
//! Faces that turn away are left out by the sign of (4.25). The others are sorted by their mean depth. Then, as in the
//! book's listing, every face is compared with those before it: where the boxes around both overlap, sides that cross
//! (4.29) or a corner inside the other face (4.38) tell which one is nearer there, and a face that should have come
//! earlier is put there, once.
//!
//! This is no right order where faces overlap in a circle, and may be none elsewhere, since a face is moved only once.
//! [`Painting`] tells both, and counts the pixels that come out wrong by the depth of every pixel.

mod face;
mod field;

use super::Point;
use face::Face;
use field::Field;
use std::cmp::Ordering;
use std::collections::HashMap;

/// What becomes of faces that turn away from the viewer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backs {
    /// They are left out, as of solids.
    LeftOut,
    /// They are painted too, as of sheets.
    Painted,
}

/// What told that a face is nearer than another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Test {
    /// Two sides cross in the picture (4.29), and differ in depth there.
    Sides,
    /// A corner lies inside the other face (4.38).
    Corner,
}

/// A face in the order of painting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The number of the face.
    pub face: usize,
    /// The mean depth of its corners.
    pub mean: f64,
    /// The face that it was put before, and why, if it has not its place by depth.
    pub moved: Option<(usize, Test)>,
    /// Pixels where it is painted over something nearer.
    pub spoils: usize,
    /// Pixels that are wrong when it is painted, among the faces so far.
    pub wrong: usize,
}

/// An order of painting, and what is wrong with it.
///
/// ```
/// use grafika::geometry::painter::{Backs, Painting};
///
/// let square = |x: f64, depth: f64| vec![[x, 0.0, depth], [x, 9.0, depth], [x + 9.0, 9.0, depth], [x + 9.0, 0.0, depth]];
/// let painting = Painting::new(&[square(4.0, 2.0), square(0.0, 1.0)], Backs::LeftOut, [20, 20]);
/// assert_eq!(painting.steps.iter().map(|step| step.face).collect::<Vec<_>>(), [1, 0]);
/// assert!(painting.wrong.is_empty() && painting.possible);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Painting {
    /// The faces from the first to the last that is painted.
    pub steps: Vec<Step>,
    /// The numbers of faces that turn away.
    pub left_out: Vec<usize>,
    /// Pairs of faces whose boxes overlap.
    pub boxes: usize,
    /// Pairs of them where a test told which one is nearer.
    pub decided: usize,
    /// Whether some order suits all of these pairs. If none does, what is wrong may still be covered in the end.
    pub possible: bool,
    /// The pixels that are wrong in the end: column and row.
    pub wrong: Vec<[i32; 2]>,
    /// The faces in the order of the steps, and the picture that they are in.
    faces: Vec<Face>,
    size: [usize; 2],
    slack: f64,
}

impl Painting {
    /// The order of flat faces in a picture of some width and height in pixels. Corners are in their order around a
    /// face, anticlockwise from outside: pixels to the right and down, and how near they are, a number that grows
    /// linearly along straight lines of the picture. Faces of fewer than three corners, and such with a number that is
    /// not finite, are left out.
    #[must_use]
    pub fn new(faces: &[Vec<Point<3>>], backs: Backs, size: [usize; 2]) -> Painting {
        let mut left_out = Vec::new();
        let mut seen: Vec<Face> = Vec::new();
        for (number, corners) in faces.iter().enumerate() {
            match Face::new(number, corners) {
                Some(face) if backs == Backs::Painted || face.turns_to_viewer() => seen.push(face),
                _ => left_out.push(number),
            }
        }
        // Stable: faces of equal depth keep their order.
        seen.sort_by(|one, other| one.mean.total_cmp(&other.mean));
        let slack = slack(&seen);
        let pairs = Pairs::new(&seen, slack);
        let order = pairs.book_order(seen.len());
        let mut field = Field::new(size, slack);
        let mut steps = Vec::with_capacity(seen.len());
        for (at, moved) in &order {
            let Some(face) = seen.get(*at) else { continue };
            let spoils = field.paint(face);
            let moved = moved.and_then(|(other, test)| Some((seen.get(other)?.number, test)));
            steps.push(Step { face: face.number, mean: face.mean, moved, spoils, wrong: field.wrong() });
        }
        let mut seen: Vec<Option<Face>> = seen.into_iter().map(Some).collect();
        let faces = order.iter().filter_map(|(at, _)| seen.get_mut(*at)?.take()).collect();
        Painting {
            faces,
            size,
            slack,
            steps,
            left_out,
            boxes: pairs.boxes,
            decided: pairs.nearer.len(),
            possible: pairs.possible(seen.len()),
            wrong: field.wrong_pixels(),
        }
    }

    /// The pixels that are wrong when so many faces have been painted, among these faces.
    #[must_use]
    pub fn wrong_after(&self, count: usize) -> Vec<[i32; 2]> {
        let mut field = Field::new(self.size, self.slack);
        for face in self.faces.iter().take(count) {
            field.paint(face);
        }
        field.wrong_pixels()
    }
}

/// The difference in depth that counts: more than rounding, and more than faces are bent.
fn slack(faces: &[Face]) -> f64 {
    let (mut low, mut high, mut bent) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
    for face in faces {
        (low, high) = (low.min(face.depths[0]), high.max(face.depths[1]));
        bent = bent.max(face.bent);
    }
    if low < high { 1e-6 * (high - low) + 2.0 * bent } else { 2.0 * bent }
}

/// Which of two faces must be painted first, for all pairs where a test told.
struct Pairs {
    boxes: usize,
    /// By the places of both, the smaller first: what the one at the smaller place is to the other, `Less` if it is
    /// farther.
    nearer: HashMap<[usize; 2], (Ordering, Test)>,
}

impl Pairs {
    fn new(faces: &[Face], slack: f64) -> Pairs {
        let mut pairs = Pairs { boxes: 0, nearer: HashMap::new() };
        // From the left to the right, so that most pairs need not be looked at.
        let mut across: Vec<usize> = (0..faces.len()).collect();
        let left = |at: &usize| faces.get(*at).map_or(0.0, |face| face.low[0]);
        across.sort_by(|one, other| left(one).total_cmp(&left(other)));
        for (from, &one) in across.iter().enumerate() {
            for &other in across.iter().skip(from + 1) {
                let places = [one.min(other), one.max(other)];
                let [Some(a), Some(b)] = places.map(|at| faces.get(at)) else { continue };
                if left(&other) >= faces.get(one).map_or(0.0, |face| face.high[0]) {
                    break;
                }
                if a.boxes_overlap(b) {
                    pairs.boxes += 1;
                    if let Some(told) = a.compared(b, slack) {
                        pairs.nearer.insert(places, told);
                    }
                }
            }
        }
        pairs
    }

    /// For every face those that must be painted after it, and why.
    fn behind(&self, count: usize) -> Vec<Vec<(usize, Test)>> {
        let mut behind: Vec<Vec<(usize, Test)>> = vec![Vec::new(); count];
        for (&[one, other], &(order, test)) in &self.nearer {
            let (before, after) = if order == Ordering::Less { (one, other) } else { (other, one) };
            if let Some(list) = behind.get_mut(before) {
                list.push((after, test));
            }
        }
        behind
    }

    /// The book's order: one pass over the places by depth, in which a face goes before the first that it must.
    fn book_order(&self, count: usize) -> Vec<(usize, Option<(usize, Test)>)> {
        let mut order: Vec<(usize, Option<(usize, Test)>)> = Vec::with_capacity(count);
        // Why the present face goes before another one, for those that it must go before.
        let mut why: Vec<Option<Test>> = vec![None; count];
        for (one, behind) in self.behind(count).iter().enumerate() {
            let earlier = || behind.iter().filter(|(other, _)| *other < one);
            for &(other, test) in earlier() {
                why[other] = Some(test);
            }
            let first = |(at, &(other, _)): (usize, &(usize, _))| Some((at, other, why[other]?));
            // Most faces go before none, and need not be placed.
            let goal = earlier().next().and_then(|_| order.iter().enumerate().find_map(first));
            for &(other, _) in earlier() {
                why[other] = None;
            }
            match goal {
                Some((at, other, test)) => order.insert(at, (one, Some((other, test)))),
                None => order.push((one, None)),
            }
        }
        order
    }

    /// Whether the pairs are without a circle: faces that nothing must be painted before are taken away until none is
    /// left.
    fn possible(&self, count: usize) -> bool {
        let mut first = vec![0_usize; count];
        let after = self.behind(count);
        for &(behind, _) in after.iter().flatten() {
            if let Some(number) = first.get_mut(behind) {
                *number += 1;
            }
        }
        let mut free: Vec<usize> = (0..count).filter(|&at| first.get(at) == Some(&0)).collect();
        let mut taken = 0;
        while let Some(at) = free.pop() {
            taken += 1;
            for &(behind, _) in after.get(at).map_or(&[][..], |list| list) {
                if let Some(number) = first.get_mut(behind) {
                    *number -= 1;
                    free.extend((*number == 0).then_some(behind));
                }
            }
        }
        taken == count
    }
}

#[cfg(test)]
mod tests;
