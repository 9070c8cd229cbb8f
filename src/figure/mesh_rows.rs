//! The mesh of one surface, row by row: its points are computed as often as they are needed instead of standing in memory.
//!
//! What [`Mesh`](super::Mesh) finds out by looking at all triangles follows here from how a grid is joined to itself, as long
//! as that is simple: at least three cells in either direction, poles at the ends of one direction at most. Then two
//! triangles never have the same corners, and the mesh encloses something exactly if it has no border: a torus, or a
//! direction that is closed between two poles. Other surfaces are none of these rows.

use super::mesh::{Borders, Corner, Triangles, Welding, is_flat_by, is_other_diagonal};
use crate::geometry::{BoundingBox, GeometryError, Grid, ParamSurface, Point, cross, dot};

/// The mesh of a surface.
pub(super) struct MeshRows<'a> {
    surface: &'a dyn ParamSurface,
    per_cell: usize,
    welding: Welding,
    /// Whether it encloses something.
    closed: bool,
    /// Whether the corners of its triangles change places, so that it is seen from outside.
    turned: bool,
    /// Where the points stand that others are one with, but for poles at the end.
    first_row: Vec<Point<3>>,
    triangles: usize,
}

impl<'a> MeshRows<'a> {
    /// The mesh of a surface in so many steps a cell. `None` if it is not simple, encloses something flat, or has no area.
    ///
    /// # Errors
    /// Those of [`ParamSurface::grid`].
    pub(super) fn new(
        surface: &'a dyn ParamSurface,
        per_cell: usize,
    ) -> Result<Option<MeshRows<'a>>, GeometryError> {
        let size = surface.grid_size(per_cell)?;
        if size.iter().any(|&lines| lines < 4) || surface.spans().contains(&0) {
            return Ok(None);
        }
        let (borders, bounds) = Self::bordered(surface, per_cell, size)?;
        let Some(bounds) = bounds.filter(|bounds| bounds.extent() > bounds.last_bits()) else {
            return Ok(None);
        };
        let closed = surface.closed();
        let welding = Welding::new(size, closed, &borders, bounds.rounding());
        let [along_u, along_v] = [welding.row_poles, welding.column_poles];
        if along_u.contains(&true) && along_v.contains(&true) {
            return Ok(None);
        }
        let encloses =
            closed == [true; 2] || closed[0] && along_v == [true; 2] || closed[1] && along_u == [true; 2];
        let Borders { rows: [first_row, _], .. } = borders;
        let mut mesh =
            MeshRows { surface, per_cell, welding, closed: encloses, turned: false, first_row, triangles: 0 };
        mesh.triangles = mesh.count(&bounds)?;
        if mesh.triangles == 0 || encloses && mesh.is_flat(|point| point)? {
            return Ok(None);
        }
        mesh.turned = encloses && mesh.encloses_less_than_nothing()?;
        Ok(Some(mesh))
    }

    /// The borders of the grid, and the box round it.
    fn bordered(
        surface: &dyn ParamSurface,
        per_cell: usize,
        [rows, columns]: [usize; 2],
    ) -> Result<(Borders, Option<BoundingBox<3>>), GeometryError> {
        let mut borders = Borders { rows: [Vec::new(), Vec::new()], columns: [Vec::new(), Vec::new()] };
        let (mut k, mut bounds) = (0, None);
        surface.each_row(per_cell, &mut |row| {
            let of_row = BoundingBox::of_points(row);
            bounds = bounds.map_or(of_row, |all: BoundingBox<3>| of_row.map(|row| all.union(row)));
            borders.columns[0].extend(row.first());
            borders.columns[1].extend(row.get(columns - 1));
            if k == 0 {
                borders.rows[0] = row.to_vec();
            }
            if k + 1 == rows {
                borders.rows[1] = row.to_vec();
            }
            k += 1;
        })?;
        Ok((borders, bounds))
    }

    /// Whether it encloses something.
    pub(super) fn is_closed(&self) -> bool {
        self.closed
    }

    /// The number of the vertex at a place: vertices are counted row by row.
    fn number(&self, [k, l]: [usize; 2]) -> usize {
        let welding = &self.welding;
        let [k, l] = welding.target(k, l);
        let [rows, columns] = welding.size;
        // How many vertices a row has: between poles one less at either end, and all of the first row have numbers.
        let whole = columns - usize::from(welding.closed[1]);
        let [first, last] = welding.column_poles.map(usize::from);
        match (k, welding.row_poles) {
            (0, [true, _]) => 0,
            (0, [false, _]) => l,
            (k, [true, _]) if k + 1 < rows || !welding.row_poles[1] => 1 + (k - 1) * whole + l,
            (k, [true, _]) => 1 + (k - 1) * whole,
            (k, [false, true]) if k + 1 == rows => k * whole,
            // The vertices of the poles stand in the first row.
            (k, _) => whole + (k - 1) * (whole - first - last) + l - first,
        }
    }

    /// Calls `each` with the corners of every cell as they are, and welded: (k, l), (k, l - 1), (k - 1, l - 1), (k - 1, l).
    fn each_cell(&self, each: &mut dyn FnMut([Point<3>; 4], [Corner; 4])) -> Result<(), GeometryError> {
        let (mut before, mut welded_before): (Vec<Point<3>>, Vec<Corner>) = (Vec::new(), Vec::new());
        let mut welded = Vec::new();
        let mut k = 0;
        self.surface.each_row(self.per_cell, &mut |row| {
            welded.clear();
            welded.extend((0..row.len()).map(|l| self.corner(row, k, l)));
            for l in 1..row.len().min(before.len()) {
                let cell = [row[l], row[l - 1], before[l - 1], before[l]];
                each(cell, [welded[l], welded[l - 1], welded_before[l - 1], welded_before[l]]);
            }
            before.clear();
            before.extend_from_slice(row);
            std::mem::swap(&mut welded_before, &mut welded);
            k += 1;
        })
    }

    /// The vertex at a place, whose row is known.
    fn corner(&self, row: &[Point<3>], k: usize, l: usize) -> Corner {
        let [to, across] = self.welding.target(k, l);
        // Others than those of this row stand in the first one.
        let from = if to == k { row } else { &self.first_row };
        Corner { number: self.number([k, l]), point: from.get(across).copied().unwrap_or([0.0; 3]) }
    }

    /// How many triangles there are; none without area.
    fn count(&self, bounds: &BoundingBox<3>) -> Result<usize, GeometryError> {
        let (mut area, mut count) = (false, 0);
        self.each_cell(&mut |cell, corners| {
            area = area || Grid::is_wide(cell, bounds);
            for half in halves(cell) {
                count += usize::from(are_different(half.map(|corner| corners[corner])));
            }
        })?;
        Ok(if area { count } else { 0 })
    }

    /// Whether all vertices lie in one plane but for rounding, as they are written.
    pub(super) fn is_flat(&self, written: impl Fn(Point<3>) -> Point<3>) -> Result<bool, GeometryError> {
        is_flat_by(&mut |each| self.each_vertex(&mut |point| each(written(point))))
    }

    /// Whether the volume that it encloses is negative: the same sum in the same order as
    /// [`Mesh::volume`](super::Mesh::volume).
    fn encloses_less_than_nothing(&self) -> Result<bool, GeometryError> {
        let origin = self.first_row.first().copied().unwrap_or([0.0; 3]);
        let away = |p: Point<3>| -> Point<3> { std::array::from_fn(|d| p[d] - origin[d]) };
        let mut size = 0.0_f64;
        self.each_vertex(&mut |p| size = away(p).iter().fold(size, |m, x| m.max(x.abs())))?;
        if size == 0.0 {
            return Ok(false);
        }
        let at = |corner: Corner| away(corner.point).map(|x| x / size);
        let mut sum = 0.0;
        self.each_triangle(&mut |[a, b, c]| sum += dot(at(a), cross(at(b), at(c))) / 6.0)?;
        Ok(sum < 0.0)
    }
}

impl Triangles for MeshRows<'_> {
    fn counts(&self) -> [usize; 2] {
        let [rows, columns] = self.welding.size;
        let last = if self.welding.closed[0] { rows - 2 } else { rows - 1 };
        let vertices = (0..columns).map(|l| self.number([last, l]) + 1).max().unwrap_or(0);
        [vertices, self.triangles]
    }

    fn each_vertex(&self, each: &mut dyn FnMut(Point<3>)) -> Result<(), GeometryError> {
        let mut k = 0;
        self.surface.each_row(self.per_cell, &mut |row| {
            for (l, &point) in row.iter().enumerate() {
                if self.welding.target(k, l) == [k, l] {
                    each(point);
                }
            }
            k += 1;
        })
    }

    fn each_triangle(&self, each: &mut dyn FnMut([Corner; 3])) -> Result<(), GeometryError> {
        self.each_cell(&mut |cell, corners| {
            for half in halves(cell) {
                let [a, b, c] = half.map(|corner| corners[corner]);
                if are_different([a, b, c]) {
                    each(if self.turned { [a, c, b] } else { [a, b, c] });
                }
            }
        })
    }
}

fn are_different([a, b, c]: [Corner; 3]) -> bool {
    a.number != b.number && b.number != c.number && c.number != a.number
}

/// The corners of the two triangles of a cell.
fn halves(cell: [Point<3>; 4]) -> [[usize; 3]; 2] {
    if is_other_diagonal(cell) { [[2, 1, 3], [1, 0, 3]] } else { [[2, 1, 0], [2, 0, 3]] }
}
