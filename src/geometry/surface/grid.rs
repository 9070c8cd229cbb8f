//! A surface as a grid of points.

use crate::geometry::Point;

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
        let points = (0..rows).flat_map(|k| (0..columns).map(move |l| (k, l)));
        Self::new(rows, columns, points.map(|(k, l)| point(k, l)).collect(), closed)
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
