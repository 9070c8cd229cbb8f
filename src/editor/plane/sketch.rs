//! The edited whole: control points and what belongs to each of them, a tangent or the shape of its joint.

use super::Drawing;
use crate::editor::drawing::Edit;
use crate::geometry::{Point, Shape};

/// Control points with what a program keeps besides them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sketch {
    /// The control points.
    pub drawing: Drawing,
    /// The full tangent vector at each point, in a program that has tangents.
    pub tangents: Option<Vec<Point<2>>>,
    /// The shape of the beta-spline.
    pub shape: Shape,
    /// The shape of the joint at each point, where the joints are not all of `shape`.
    pub joints: Option<Vec<Shape>>,
}

impl Sketch {
    /// The control points.
    pub fn points(&self) -> &[Point<2>] {
        self.drawing.points()
    }

    /// The tangent at a point; none where the program has no tangents.
    pub fn tangent(&self, index: usize) -> Option<Point<2>> {
        self.tangents.as_ref()?.get(index).copied()
    }

    /// The shape of every joint.
    pub fn shapes(&self) -> Vec<Shape> {
        self.joints.clone().unwrap_or_else(|| vec![self.shape; self.points().len()])
    }

    /// The sketch after an edit of its points: what belongs to them goes with them. A new point has no
    /// tangent, and the common shape.
    pub(super) fn edited(&self, edit: Edit<Point<2>>) -> Sketch {
        let mut sketch = Sketch { drawing: self.drawing.edited(edit), ..self.clone() };
        let counts = [self.points().len(), sketch.points().len()];
        if let Some(tangents) = &mut sketch.tangents {
            follow(tangents, edit, counts, [0.0; 2]);
        }
        if let Some(joints) = &mut sketch.joints {
            follow(joints, edit, counts, self.shape);
        }
        sketch
    }

    /// The sketch with another tangent at a point.
    pub(super) fn with_tangent(&self, index: usize, tangent: Point<2>) -> Sketch {
        let mut sketch = self.clone();
        if let Some(old) = sketch.tangents.as_mut().and_then(|tangents| tangents.get_mut(index)) {
            *old = tangent;
        }
        sketch
    }

    /// The sketch with another shape of one joint.
    pub(super) fn with_joint(&self, index: usize, shape: Shape) -> Sketch {
        let mut joints = self.shapes();
        if let Some(old) = joints.get_mut(index) {
            *old = shape;
        }
        Sketch { joints: Some(joints), ..self.clone() }
    }
}

/// Lets a list that belongs to the points follow an edit that made so many of so many.
fn follow<T>(list: &mut Vec<T>, edit: Edit<Point<2>>, [before, after]: [usize; 2], new: T) {
    match edit {
        Edit::Insert(index, _) if after > before => list.insert(index.min(before), new),
        Edit::Delete(index) if after < before => {
            list.remove(index);
        }
        Edit::Renumber(from, to) if from.max(to) < before => {
            let value = list.remove(from);
            list.insert(to, value);
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_belongs_to_a_point_goes_with_it(
            edits in prop::collection::vec((0u8..4, 0usize..12, 0usize..12), 0..60),
        ) {
            // Every point carries its mark as place, tangent and joint.
            let mut sketch = Sketch { tangents: Some(Vec::new()), joints: Some(Vec::new()), ..Sketch::default() };
            let mut mark = 0.0;
            for (kind, index, other) in edits {
                let count = sketch.points().len();
                match kind {
                    0 | 1 if count < 20 => {
                        mark += 1.0;
                        sketch = sketch.edited(Edit::Insert(index, [mark, 0.0]));
                        let at = index.min(count);
                        sketch = sketch.with_tangent(at, [mark, 0.0]).with_joint(at, Shape { bias: mark, tension: 0.0 });
                    }
                    2 => sketch = sketch.edited(Edit::Delete(index)),
                    _ => sketch = sketch.edited(Edit::Renumber(index, other)),
                }
                let marks: Vec<f64> = sketch.points().iter().map(|point| point[0]).collect();
                let tangents: Vec<f64> = sketch.tangents.iter().flatten().map(|tangent| tangent[0]).collect();
                let joints: Vec<f64> = sketch.joints.iter().flatten().map(|shape| shape.bias).collect();
                prop_assert_eq!(&marks, &tangents);
                prop_assert_eq!(&marks, &joints);
            }
        }
    }
}
