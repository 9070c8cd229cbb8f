//! Through a point by one knot and two weights: the knot is chosen, the weights follow.

use super::local::functions;
use super::through::solved;
use super::{KnotCurve, KnotError, Through, Unreached};
use crate::geometry::Point;
use crate::geometry::point::check_points;

impl KnotCurve<2> {
    /// The curve with a knot at `value` that runs through a point at `u`, by the weights of two control points.
    ///
    /// # Errors
    /// [`KnotError::Unreached`] for weights that would not be positive and for a point on the line through both;
    /// [`KnotError::Index`] for control points that have no influence at `u`, or what makes the knots wrong.
    pub fn through_weights(
        &self,
        point: Point<2>,
        (knot, value): (usize, f64),
        u: f64,
        pair: [usize; 2],
    ) -> Result<Through<2>, KnotError> {
        check_points(&[point])?;
        let curve = self.with_knot(knot, value)?;
        let (vector, order) = (curve.vector(), curve.vector().order());
        let outside = KnotError::Outside { name: "u", value: u, range: vector.domain() };
        let span = vector.span_of(u).ok_or(outside)?;
        let first = span + 1 - order;
        let local: Vec<usize> = (first..=span).map(|i| vector.point_index(i)).collect();
        for &given in &pair {
            if !local.contains(&given) || pair[0] == pair[1] {
                return Err(KnotError::Index { name: "point", given, first, last: span });
            }
        }
        let values = functions(vector.knots(), order, span, u).ok_or(KnotError::Coincide { value })?;
        let mut weights = curve.weights().map_or_else(|| vec![1.0; curve.points().len()], <[f64]>::to_vec);
        // Of every control point: its function times its distance from the point; of the others with their weight.
        let (mut columns, mut rest) = ([[0.0; 2]; 2], [0.0; 2]);
        for (&i, share) in local.iter().zip(values) {
            let vector: Point<2> = std::array::from_fn(|d| share * (curve.points()[i][d] - point[d]));
            match pair.iter().position(|given| *given == i) {
                Some(column) => (0..2).for_each(|d| columns[column][d] += vector[d]),
                None => (0..2).for_each(|d| rest[d] -= weights[i] * vector[d]),
            }
        }
        let found = solved(columns[0], columns[1], rest).ok_or(Unreached::Parallel)?;
        for (&point, value) in pair.iter().zip(found) {
            if value <= 0.0 {
                return Err(Unreached::Weight { point, value }.into());
            }
            weights[point] = value;
        }
        let curve = Self::rational(curve.vector().clone(), curve.points().to_vec(), weights)?;
        Ok(Through { curve, u })
    }
}
