//! What is edited: the control points, and the named edits that change them.

use crate::file::{FIELD, MAX_POINTS};
use crate::geometry::Point;
use serde::Serialize;

/// The control points, in coordinates of the field: x from 0 to 560 to the right, y from 0 to 380 up.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Drawing {
    points: Vec<Point<2>>,
}

/// A named change of the control points. Indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edit {
    /// A new point before the one of an index; behind the last one if there is none.
    Insert(usize, Point<2>),
    /// A point moves.
    Move(usize, Point<2>),
    /// A point goes; the later ones shift down.
    Delete(usize),
    /// A point gets another index; those between shift by one.
    Renumber(usize, usize),
}

impl Drawing {
    /// A drawing of points, which must lie in the field.
    pub fn new(points: Vec<Point<2>>) -> Option<Drawing> {
        let fits = points.len() <= MAX_POINTS && points.iter().all(|&point| in_field(point));
        fits.then_some(Drawing { points })
    }

    /// The control points.
    pub fn points(&self) -> &[Point<2>] {
        &self.points
    }

    /// Whether no more points can be added.
    pub fn full(&self) -> bool {
        self.points.len() >= MAX_POINTS
    }

    /// The drawing after an edit; an edit that names a point that is not there changes nothing.
    pub fn edited(&self, edit: Edit) -> Drawing {
        let mut points = self.points.clone();
        match edit {
            Edit::Insert(index, point) if !self.full() => {
                points.insert(index.min(points.len()), clamped(point))
            }
            Edit::Move(index, point) if index < points.len() => points[index] = clamped(point),
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

/// Whether a point lies in the field.
pub(super) fn in_field([x, y]: Point<2>) -> bool {
    (0.0..=FIELD[0]).contains(&x) && (0.0..=FIELD[1]).contains(&y)
}

/// The nearest point of the field.
pub(super) fn clamped([x, y]: Point<2>) -> Point<2> {
    [x.clamp(0.0, FIELD[0]), y.clamp(0.0, FIELD[1])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn row(count: u8) -> Drawing {
        Drawing::new((0..count).map(|x| [f64::from(x), 0.0]).collect()).unwrap()
    }

    fn order(drawing: &Drawing) -> Vec<f64> {
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
