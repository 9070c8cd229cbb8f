//! A surface as a grid of points.

use crate::geometry::point::{norm, scaled_difference};
use crate::geometry::{BoundingBox, Point, cross};

/// A surface that is nowhere wider than this part of its extent is a line.
const NARROWEST: f64 = 1e-9;

/// Points of a surface in rows of constant `u`; its cells are the quadrilaterals between neighbours.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    rows: usize,
    columns: usize,
    points: Vec<Point<3>>,
    closed: [bool; 2],
}

impl Grid {
    pub(super) fn new(rows: usize, columns: usize, points: Vec<Point<3>>, closed: [bool; 2]) -> Self {
        Self { rows, columns, points, closed }
    }

    /// A grid of points given by row and column. The last row of a direction that is closed repeats the first.
    #[must_use]
    pub fn from_fn(
        [rows, columns]: [usize; 2],
        closed: [bool; 2],
        point: impl Fn(usize, usize) -> Point<3>,
    ) -> Self {
        let points = indices([rows, columns]).map(|[k, l]| point(k, l)).collect();
        Self::new(rows, columns, points, closed)
    }

    /// Row and column of every point, in the order of [`Grid::points`].
    pub fn indices(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        indices([self.rows, self.columns])
    }

    /// The number of lines of constant `u`; a closing line counts.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The number of points in a row; a closing point counts.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// All points, row by row.
    #[must_use]
    pub fn points(&self) -> &[Point<3>] {
        &self.points
    }

    /// Whether the last row repeats the first, and the last point of every row its first.
    #[must_use]
    pub fn closed(&self) -> [bool; 2] {
        self.closed
    }

    /// The point of a row and column.
    #[must_use]
    pub fn point(&self, row: usize, column: usize) -> Option<Point<3>> {
        if column < self.columns { self.points.get(row * self.columns + column).copied() } else { None }
    }

    /// Whether the surface is more than a line or a point: whether some cell has an area. In a surface that has
    /// shrunk to a curve, as a torus of equal circles, no cell has.
    #[must_use]
    pub fn has_area(&self) -> bool {
        let Some(bounds) = BoundingBox::of_points(&self.points).filter(|it| it.extent() > it.last_bits())
        else {
            return false;
        };
        let at = |index: usize| self.points.get(index).copied().unwrap_or([0.0; 3]);
        self.cells().any(|cell| Self::is_wide(cell.map(at), &bounds))
    }

    /// Whether a cell with these corners, in the order of [`Grid::cells`], has an area in a surface with this box.
    #[must_use]
    pub fn is_wide([a, b, c, d]: [Point<3>; 4], bounds: &BoundingBox<3>) -> bool {
        let narrowest = bounds.rounding().max(NARROWEST * bounds.extent());
        [[a, b, c], [a, c, d]].into_iter().any(|corners| triangle_width(corners) > narrowest)
    }

    /// The indices in [`Grid::points`] of the corners of every cell: (k, l), (k, l - 1), (k - 1, l - 1),
    /// (k - 1, l), row by row.
    pub fn cells(&self) -> impl Iterator<Item = [usize; 4]> + '_ {
        (1..self.rows).flat_map(move |k| {
            (1..self.columns).map(move |l| {
                let (here, before) = (k * self.columns + l, (k - 1) * self.columns + l);
                [here, here - 1, before - 1, before]
            })
        })
    }
}

/// The indices of a grid of rows and columns, row by row.
pub(in crate::geometry) fn indices([rows, columns]: [usize; 2]) -> impl Iterator<Item = [usize; 2]> {
    (0..rows).flat_map(move |k| (0..columns).map(move |l| [k, l]))
}

/// The least width of a triangle: the height over its longest side.
#[must_use]
pub fn triangle_width([a, b, c]: [Point<3>; 3]) -> f64 {
    let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| scaled_difference(1.0, from, to));
    let longest = sides.map(norm).into_iter().fold(0.0, f64::max);
    if longest == 0.0 {
        return 0.0;
    }
    // Scaled first: the product of tiny sides would vanish.
    let [u, v, _] = sides.map(|side| side.map(|x| x / longest));
    norm(cross(u, v)) * longest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_are_in_the_order_of_the_points() {
        let grid = Grid::from_fn([3, 2], [false, false], |k, l| [k as f64, l as f64, 0.0]);
        assert_eq!(grid.indices().count(), 6);
        for ([k, l], point) in grid.indices().zip(grid.points()) {
            assert_eq!((*point, grid.point(k, l)), ([k as f64, l as f64, 0.0], Some(*point)));
        }
    }
}
