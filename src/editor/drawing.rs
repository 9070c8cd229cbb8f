//! What the editors edit: a list of control points, and the named edits that change it.

use crate::file::{FIELD, MAX_POINTS};
use crate::geometry::{COORDINATE_LIMIT, Point};
use serde::Serialize;

/// A kind of control point, with the places where it may lie.
pub trait Place: Copy + PartialEq {
    /// Whether it may lie where it is.
    fn fits(self) -> bool;

    /// The nearest place where it may lie.
    #[must_use]
    fn nearest(self) -> Self;
}

impl Place for Point<2> {
    /// In the plane, within the field.
    fn fits(self) -> bool {
        self.iter().zip(FIELD).all(|(value, largest)| (0.0..=largest).contains(value))
    }

    fn nearest(self) -> Self {
        [self[0].clamp(0.0, FIELD[0]), self[1].clamp(0.0, FIELD[1])]
    }
}

impl Place for Point<3> {
    /// In space, wherever curves can be computed.
    fn fits(self) -> bool {
        self.iter().all(|value| value.abs() <= COORDINATE_LIMIT)
    }

    fn nearest(self) -> Self {
        self.map(|value| value.clamp(-COORDINATE_LIMIT, COORDINATE_LIMIT))
    }
}

/// Control points: in coordinates of the field for a plane curve, x from 0 to 560 to the right, y from 0
/// to 380 up; in those of the three axes for a curve in space.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Drawing<P> {
    points: Vec<P>,
}

impl<P> Default for Drawing<P> {
    fn default() -> Self {
        Drawing { points: Vec::new() }
    }
}

/// A named change of the control points. Indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edit<P> {
    /// A new point before the one of an index; behind the last one if there is none.
    Insert(usize, P),
    /// A point moves.
    Move(usize, P),
    /// A point goes; the later ones shift down.
    Delete(usize),
    /// A point gets another index; those between shift by one.
    Renumber(usize, usize),
}

impl<P: Place> Drawing<P> {
    /// A drawing of at most 99 points, all of which must lie where they may.
    pub fn new(points: Vec<P>) -> Option<Drawing<P>> {
        let fits = points.len() <= MAX_POINTS && points.iter().all(|&point| point.fits());
        fits.then_some(Drawing { points })
    }

    /// The control points.
    pub fn points(&self) -> &[P] {
        &self.points
    }

    /// Whether no more points can be added.
    pub fn full(&self) -> bool {
        self.points.len() >= MAX_POINTS
    }

    /// The drawing after an edit; an edit that names a point that is not there changes nothing.
    #[must_use]
    pub fn edited(&self, edit: Edit<P>) -> Drawing<P> {
        let mut points = self.points.clone();
        match edit {
            Edit::Insert(index, point) if !self.full() => {
                points.insert(index.min(points.len()), point.nearest());
            }
            Edit::Move(index, point) if index < points.len() => points[index] = point.nearest(),
            Edit::Delete(index) if index < points.len() => {
                points.remove(index);
            }
            Edit::Renumber(from, to) if from.max(to) < points.len() => {
                let point = points.remove(from);
                points.insert(to, point);
            }
            _ => {}
        }
        Drawing { points }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn row(count: u8) -> Drawing<Point<2>> {
        Drawing::new((0..count).map(|x| [f64::from(x), 0.0]).collect()).unwrap()
    }

    fn order(drawing: &Drawing<Point<2>>) -> Vec<f64> {
        drawing.points().iter().map(|point| point[0]).collect()
    }

    #[test]
    fn edits_do_what_their_names_say() {
        let drawing = row(4);
        assert_eq!(order(&drawing.edited(Edit::Insert(1, [9.0, 0.0]))), [0.0, 9.0, 1.0, 2.0, 3.0]);
        assert_eq!(order(&drawing.edited(Edit::Insert(99, [9.0, 0.0]))), [0.0, 1.0, 2.0, 3.0, 9.0]);
        assert_eq!(order(&drawing.edited(Edit::Move(2, [999.0, -5.0]))), [0.0, 1.0, 560.0, 3.0]);
        assert_eq!(order(&drawing.edited(Edit::Delete(0))), [1.0, 2.0, 3.0]);
        assert_eq!(order(&drawing.edited(Edit::Renumber(0, 2))), [1.0, 2.0, 0.0, 3.0]);
        assert_eq!(order(&drawing.edited(Edit::Renumber(3, 1))), [0.0, 3.0, 1.0, 2.0]);
        for nothing in [Edit::Delete(4), Edit::Renumber(1, 4), Edit::Renumber(9, 0), Edit::Move(4, [0.0; 2])]
        {
            assert_eq!(drawing.edited(nothing), drawing);
        }
    }

    #[test]
    fn there_is_room_for_99_points_of_the_field() {
        assert!(row(99).full() && row(99).edited(Edit::Insert(0, [0.0; 2])) == row(99));
        assert!(Drawing::new(vec![[0.0; 2]; 100]).is_none());
        assert!(Drawing::new(vec![[560.5, 0.0]]).is_none());
        assert!(Drawing::new(vec![[f64::NAN, 0.0]]).is_none());
        assert!(Drawing::new(vec![[f64::NAN, 0.0, 0.0]]).is_none());
        assert!(Drawing::new(vec![[-1e9, 0.0, 1e100]]).is_some());
    }

    proptest! {
        #[test]
        fn every_edit_leaves_a_drawing(count in 0u8..100, index in 0usize..120, other in 0usize..120, x: i16, y: i16) {
            let point = [f64::from(x), f64::from(y)];
            for edit in [Edit::Insert(index, point), Edit::Move(index, point), Edit::Delete(index), Edit::Renumber(index, other)] {
                let edited = row(count).edited(edit);
                prop_assert!(Drawing::new(edited.points().to_vec()).is_some());
            }
        }
    }
}
