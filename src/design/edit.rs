//! The allowed range of control points, and the named edits of a list of them.

use super::{DesignError, Sketch, ph};
use crate::file::{FIELD, MAX_POINTS, Method};
use crate::geometry::{COORDINATE_LIMIT, ParamCurve, Point};

/// A kind of control point: its allowed range, and what is different in the plane and in space.
pub trait Place<const D: usize>: Copy + PartialEq {
    /// Whether it may lie where it is.
    fn fits(self) -> bool;

    /// The nearest place where it may lie.
    #[must_use]
    fn nearest(self) -> Self;

    /// The curve of a sketch by a method of PH curves.
    ///
    /// # Errors
    /// Those of [`Sketch::ph_curve`] or [`Sketch::space_ph_curve`].
    fn ph(sketch: &Sketch<D>, method: Method) -> Result<Box<dyn ParamCurve<D>>, DesignError>;
}

impl Place<2> for Point<2> {
    /// In the plane, within the field.
    fn fits(self) -> bool {
        self.iter().zip(FIELD).all(|(value, largest)| (0.0..=largest).contains(value))
    }

    fn nearest(self) -> Self {
        [self[0].clamp(0.0, FIELD[0]), self[1].clamp(0.0, FIELD[1])]
    }

    fn ph(sketch: &Sketch<2>, method: Method) -> Result<Box<dyn ParamCurve<2>>, DesignError> {
        Ok(Box::new(ph::plane(sketch, method)?))
    }
}

impl Place<3> for Point<3> {
    /// In space, wherever curves can be computed.
    fn fits(self) -> bool {
        self.iter().all(|value| value.abs() <= COORDINATE_LIMIT)
    }

    fn nearest(self) -> Self {
        self.map(|value| value.clamp(-COORDINATE_LIMIT, COORDINATE_LIMIT))
    }

    fn ph(sketch: &Sketch<3>, method: Method) -> Result<Box<dyn ParamCurve<3>>, DesignError> {
        Ok(Box::new(ph::space(sketch, method)?))
    }
}

/// A named change of the control points. Indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edit<P> {
    /// A new point before the one at an index; after the last one if there is none.
    Insert(usize, P),
    /// A point moves.
    Move(usize, P),
    /// A point goes; the later ones shift down.
    Delete(usize),
    /// Moves a point to another index; those between shift by one.
    Renumber(usize, usize),
}

/// Whether a list has the maximum number of control points.
pub(super) fn full<P>(points: &[P]) -> bool {
    points.len() >= MAX_POINTS
}

impl<const D: usize> Edit<Point<D>>
where
    Point<D>: Place<D>,
{
    /// Carries the edit out. If there is no such point, or no room, nothing changes. New places are moved to the
    /// nearest one that fits.
    pub(super) fn carry_out(self, points: &mut Vec<Point<D>>) {
        match self {
            Edit::Insert(index, point) if !full(points) => {
                points.insert(index.min(points.len()), point.nearest());
            }
            Edit::Move(index, point) => {
                if let Some(old) = points.get_mut(index) {
                    *old = point.nearest();
                }
            }
            Edit::Delete(index) if index < points.len() => {
                points.remove(index);
            }
            Edit::Renumber(from, to) if from.max(to) < points.len() => {
                let point = points.remove(from);
                points.insert(to, point);
            }
            _ => {}
        }
    }
}
