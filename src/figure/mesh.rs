//! Surfaces as meshes of triangles for printers and modellers: Wavefront OBJ and PLY here, STL in [`super::stl`].
//!
//! The points of a grid are welded where the surface is joined to itself, so that a sphere or a torus is a
//! closed solid without seams. The mesh is an approximation; the exact surface is written by
//! [`surface_step`](super::surface_step).

use super::FigureError;
use super::closed;
use super::number::Number;
use crate::geometry::{BoundingBox, GeometryError, Grid, Point, cross, dot};
use std::collections::HashMap;
use std::convert::Infallible;
use std::io;

/// Vertices that leave a plane by no more than this part of the extent lie in it.
pub(super) const FLATTEST: f64 = 1e-9;
/// How much shorter the other diagonal of a cell has to be to be taken; equal ones give an even pattern.
const SHORTER: f64 = 1.0 - 1e-9;

/// Triangles between numbered vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    vertices: Vec<Point<3>>,
    triangles: Vec<[usize; 3]>,
}

impl Mesh {
    /// The mesh of a grid, two triangles a cell, split along the shorter diagonal. Seams of closed directions
    /// share their vertices; a border whose points are all equal, as a pole, is one vertex; triangles without
    /// three different vertices are left out. Seen from the side of r_u x r_v the vertices go round
    /// counterclockwise, but in a closed mesh always as seen from outside (its volume is positive).
    ///
    /// # Errors
    /// [`FigureError::NoArea`] for a surface that is no more than a line or a point, [`FigureError::Flat`] for a closed one
    /// that lies in a plane.
    pub fn from_grid(grid: &Grid) -> Result<Mesh, FigureError> {
        let mut mesh = Self::welded(grid)?;
        if mesh.is_inside_out() {
            mesh.triangles.iter_mut().for_each(|corners| corners.swap(1, 2));
        }
        Ok(mesh)
    }

    /// The mesh of several grids, each as [`Mesh::from_grid`] makes it. Where vertices of different grids lie within a
    /// billionth of the extent they are one, so that patches that touch hang together.
    ///
    /// # Errors
    /// Those of [`Mesh::from_grid`]; of several grids, those without area are left out if others have some.
    pub fn from_grids(grids: &[Grid]) -> Result<Mesh, FigureError> {
        if let [grid] = grids {
            return Self::from_grid(grid);
        }
        let mut whole = Mesh { vertices: Vec::new(), triangles: Vec::new() };
        for grid in grids.iter().filter(|grid| grid.has_area()) {
            let part = Self::welded(grid)?;
            let first = whole.vertices.len();
            whole.vertices.extend(part.vertices);
            whole.triangles.extend(part.triangles.iter().map(|corners| corners.map(|n| n + first)));
        }
        if whole.triangles.is_empty() {
            return Err(FigureError::NoArea);
        }
        whole.weld();
        if whole.is_inside_out() {
            whole.triangles.iter_mut().for_each(|corners| corners.swap(1, 2));
        }
        Ok(whole)
    }

    /// Makes vertices one that lie within a billionth of the extent.
    fn weld(&mut self) {
        let extent = BoundingBox::of_points(&self.vertices).map_or(0.0, |bounds| bounds.extent());
        let near = FLATTEST * extent;
        if near <= 0.0 || !near.is_finite() {
            return;
        }
        // In cells twice as wide, what is near lies in a neighbouring cell.
        let cell = |p: &Point<3>, step: [f64; 3]| -> [i64; 3] {
            std::array::from_fn(|d| (p[d] / (2.0 * near) + step[d]).floor() as i64)
        };
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::with_capacity(self.vertices.len());
        let mut vertices: Vec<Point<3>> = Vec::with_capacity(self.vertices.len());
        let numbers: Vec<usize> = self
            .vertices
            .iter()
            .map(|p| {
                let halves = [-0.5, 0.5];
                let around = halves.into_iter().flat_map(|x| {
                    halves.into_iter().flat_map(move |y| halves.into_iter().map(move |z| [x, y, z]))
                });
                let same =
                    around.filter_map(|step| cells.get(&cell(p, step))).flatten().copied().find(|&n| {
                        vertices.get(n).is_some_and(|q| p.iter().zip(q).all(|(a, b)| (a - b).abs() <= near))
                    });
                same.unwrap_or_else(|| {
                    vertices.push(*p);
                    cells.entry(cell(p, [0.0; 3])).or_default().push(vertices.len() - 1);
                    vertices.len() - 1
                })
            })
            .collect();
        self.vertices = vertices;
        for corner in self.triangles.iter_mut().flatten() {
            *corner = numbers.get(*corner).copied().unwrap_or(*corner);
        }
        self.triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    }

    /// A closed mesh whose triangles go round clockwise as seen from outside.
    pub(super) fn is_inside_out(&self) -> bool {
        self.scaled_volume()[0] < 0.0 && self.closed_characteristic().is_some()
    }

    /// The mesh with the orientation of the grid.
    pub(super) fn welded(grid: &Grid) -> Result<Mesh, FigureError> {
        if !grid.has_area() {
            return Err(FigureError::NoArea);
        }
        let merged = merged(grid);
        let cells = grid.rows().saturating_sub(1) * grid.columns().saturating_sub(1);
        let mut triangles = Vec::with_capacity(2 * cells);
        for triangle in grid.cells().flat_map(|cell| split(cell, grid.points())) {
            let [a, b, c] = triangle.map(|corner| merged.get(corner).copied().unwrap_or(corner));
            if a != b && b != c && c != a {
                triangles.push([a, b, c]);
            }
        }
        // First whether a point is a corner, then which vertex it is.
        let mut numbers = merged;
        numbers.fill(0);
        for &corner in triangles.iter().flatten() {
            if let Some(number) = numbers.get_mut(corner) {
                *number = 1;
            }
        }
        let mut vertices = Vec::with_capacity(numbers.iter().sum());
        for (number, &point) in numbers.iter_mut().zip(grid.points()) {
            if std::mem::replace(number, vertices.len()) > 0 {
                vertices.push(point);
            }
        }
        for corner in triangles.iter_mut().flatten() {
            *corner = numbers.get(*corner).copied().unwrap_or(0);
        }
        let mesh = Mesh { vertices, triangles };
        if mesh.is_flat_and_closed() {
            return Err(FigureError::Flat);
        }
        Ok(mesh)
    }

    /// Whether it is a closed mesh in a plane. What takes the least time is asked first.
    fn is_flat_and_closed(&self) -> bool {
        closed::may_be_closed(self.vertices.len(), &self.triangles)
            && is_flat(&self.vertices)
            && self.closed_characteristic().is_some()
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> &[Point<3>] {
        &self.vertices
    }

    /// The numbers of three vertices a triangle, from 0.
    #[must_use]
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }

    /// The Euler characteristic (vertices - edges + triangles: 2 for a sphere, 0 for a torus) if the mesh is
    /// a closed surface: every edge lies between two triangles that run through it in opposite directions,
    /// and the triangles of every vertex are one fan. `None` if it has a border or is no surface.
    #[must_use]
    pub fn closed_characteristic(&self) -> Option<i64> {
        closed::characteristic(self.vertices.len(), &self.triangles)
    }

    /// The volume that a closed mesh encloses: the sum of the signed tetrahedra over its triangles.
    /// Infinite where no double holds it.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let [volume, size] = self.scaled_volume();
        volume * size * size * size
    }

    /// The volume of the mesh made smaller or larger to the size of 1, and its own size.
    fn scaled_volume(&self) -> [f64; 2] {
        let origin = self.vertices.first().copied().unwrap_or([0.0; 3]);
        let away = |p: &Point<3>| -> Point<3> { std::array::from_fn(|d| p[d] - origin[d]) };
        let size = self.vertices.iter().flat_map(away).fold(0.0_f64, |m, x| m.max(x.abs()));
        if size == 0.0 {
            return [0.0; 2];
        }
        let at = |n: usize| self.vertices.get(n).map_or([0.0; 3], |p| away(p).map(|x| x / size));
        let tetrahedron = |&[a, b, c]: &[usize; 3]| dot(at(a), cross(at(b), at(c))) / 6.0;
        [self.triangles.iter().map(tetrahedron).sum(), size]
    }

    /// The mesh as Wavefront OBJ. Numbers read back as the same double.
    #[must_use]
    pub fn to_obj(&self) -> String {
        let mut bytes = Vec::new();
        // Writing to a row of bytes cannot fail, and numbers are text.
        let _ = write_obj(self, &mut bytes);
        String::from_utf8(bytes).unwrap_or_default()
    }

    /// The mesh as PLY 1.0, binary little-endian, coordinates in double precision.
    ///
    /// # Errors
    /// [`FigureError::TooManyVertices`] when they cannot be numbered in 32 bits.
    pub fn to_ply(&self) -> Result<Vec<u8>, FigureError> {
        i32::try_from(self.vertices.len()).map_err(|_| FigureError::TooManyVertices)?;
        let mut bytes = Vec::new();
        // Writing to a row of bytes cannot fail.
        let _ = write_ply(self, &mut bytes);
        Ok(bytes)
    }
}

/// A corner of a triangle: the number of its vertex and where it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) number: usize,
    pub(super) point: Point<3>,
}

/// What models of triangles are written from.
pub(super) trait Triangles {
    /// How many vertices and triangles there are.
    fn counts(&self) -> [usize; 2];

    /// Calls `each` with every vertex in the order of their numbers.
    fn each_vertex(&self, each: &mut dyn FnMut(Point<3>)) -> Result<(), GeometryError>;

    /// Calls `each` with the corners of every triangle.
    fn each_triangle(&self, each: &mut dyn FnMut([Corner; 3])) -> Result<(), GeometryError>;
}

impl Triangles for Mesh {
    fn counts(&self) -> [usize; 2] {
        [self.vertices.len(), self.triangles.len()]
    }

    fn each_vertex(&self, each: &mut dyn FnMut(Point<3>)) -> Result<(), GeometryError> {
        self.vertices.iter().for_each(|&point| each(point));
        Ok(())
    }

    fn each_triangle(&self, each: &mut dyn FnMut([Corner; 3])) -> Result<(), GeometryError> {
        let corner =
            |number: usize| Corner { number, point: self.vertices.get(number).copied().unwrap_or([0.0; 3]) };
        self.triangles.iter().for_each(|corners| each(corners.map(corner)));
        Ok(())
    }
}

/// Writes as [`Mesh::to_obj`] has it.
pub(super) fn write_obj(mesh: &dyn Triangles, out: &mut dyn io::Write) -> io::Result<()> {
    let mut written = Ok(());
    mesh.each_vertex(&mut |[x, y, z]| {
        written = std::mem::replace(&mut written, Ok(()))
            .and_then(|()| writeln!(out, "v {} {} {}", Number(x), Number(y), Number(z)));
    })
    .map_err(io::Error::other)?;
    mesh.each_triangle(&mut |corners| {
        let [a, b, c] = corners.map(|corner| corner.number + 1);
        written = std::mem::replace(&mut written, Ok(())).and_then(|()| writeln!(out, "f {a} {b} {c}"));
    })
    .map_err(io::Error::other)?;
    written
}

/// Writes as [`Mesh::to_ply`] has it, where vertices can be numbered in 32 bits.
pub(super) fn write_ply(mesh: &dyn Triangles, out: &mut dyn io::Write) -> io::Result<()> {
    let [vertices, triangles] = mesh.counts();
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment grafika\nelement vertex {vertices}\nproperty double x\n\
         property double y\nproperty double z\nelement face {triangles}\nproperty list uchar int vertex_indices\n\
         end_header\n"
    )?;
    let mut written = Ok(());
    mesh.each_vertex(&mut |point| {
        let bytes = point.map(f64::to_le_bytes);
        written = std::mem::replace(&mut written, Ok(())).and_then(|()| out.write_all(bytes.as_flattened()));
    })
    .map_err(io::Error::other)?;
    mesh.each_triangle(&mut |corners| {
        let mut face = [3; 13];
        let (_, numbers) = face.split_at_mut(1);
        let (numbers, _) = numbers.as_chunks_mut::<4>();
        for (to, corner) in numbers.iter_mut().zip(corners) {
            // Their number is known to fit.
            *to = (corner.number as i32).to_le_bytes();
        }
        written = std::mem::replace(&mut written, Ok(())).and_then(|()| out.write_all(&face));
    })
    .map_err(io::Error::other)?;
    written
}

/// Whether all points lie in one plane but for rounding.
pub(super) fn is_flat(vertices: &[Point<3>]) -> bool {
    let flat = is_flat_by(&mut |each| {
        vertices.iter().for_each(|&point| each(point));
        Ok::<(), Infallible>(())
    });
    flat.unwrap_or_else(|never| match never {})
}

/// Calls a function with every point.
pub(super) type Each<'a, E> = &'a mut dyn FnMut(&mut dyn FnMut(Point<3>)) -> Result<(), E>;

/// The same of points that are given several times, one by one.
pub(super) fn is_flat_by<E>(each: Each<'_, E>) -> Result<bool, E> {
    let (mut origin, mut bounds) = (None, None);
    each(&mut |p| {
        origin.get_or_insert(p);
        let of_point = BoundingBox::of_point(p);
        bounds = Some(bounds.map_or(of_point, |all: BoundingBox<3>| all.union(of_point)));
    })?;
    let (Some(origin), Some(bounds)) = (origin, bounds) else { return Ok(true) };
    let extent = bounds.extent();
    if extent <= 0.0 {
        return Ok(true);
    }
    let away = |p: Point<3>| -> Point<3> { std::array::from_fn(|d| (p[d] - origin[d]) / extent) };
    let longest = |a: Point<3>, b: Point<3>| if dot(b, b) > dot(a, a) { b } else { a };
    let (mut leg, mut normal) = ([0.0; 3], [0.0; 3]);
    each(&mut |p| leg = longest(leg, away(p)))?;
    each(&mut |p| normal = longest(normal, cross(leg, away(p))))?;
    let length = dot(normal, normal).sqrt();
    // Points on one line have no normal.
    let least = bounds.rounding().max(FLATTEST * extent) / extent;
    if length <= least {
        return Ok(true);
    }
    let mut flat = true;
    each(&mut |p| flat = flat && (dot(normal, away(p)) / length).abs() <= least)?;
    Ok(flat)
}

/// The borders of a grid.
pub(super) struct Borders {
    /// The first and the last row.
    pub(super) rows: [Vec<Point<3>>; 2],
    /// The first and the last column.
    pub(super) columns: [Vec<Point<3>>; 2],
}

/// Which points of a grid are one.
pub(super) struct Welding {
    /// The numbers of rows and columns.
    pub(super) size: [usize; 2],
    /// Whether the last row repeats the first, and the last column.
    pub(super) closed: [bool; 2],
    /// Whether all points of the first and of the last row are one.
    pub(super) row_poles: [bool; 2],
    /// The same of columns.
    pub(super) column_poles: [bool; 2],
    /// Corners that poles make the same: corner 2 k + l is that of the first or last row and column.
    corners: [usize; 4],
}

impl Welding {
    /// Of a grid of rows and columns with these borders, where points within `rounding` are one.
    pub(super) fn new(size: [usize; 2], closed: [bool; 2], borders: &Borders, rounding: f64) -> Welding {
        let near = |a: Point<3>, b: Point<3>| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= rounding);
        let is_pole = |border: &Vec<Point<3>>| match border.split_first() {
            Some((&first, others)) => others.iter().all(|&point| near(first, point)),
            None => true,
        };
        let row_poles = borders.rows.each_ref().map(|row| !closed[0] && is_pole(row));
        let column_poles = borders.columns.each_ref().map(|column| !closed[1] && is_pole(column));
        let mut corners = [0, 1, 2, 3];
        let mut unite = |a: usize, b: usize| {
            let [a, b] = [corners[a], corners[b]];
            corners.iter_mut().filter(|corner| **corner == a.max(b)).for_each(|corner| *corner = a.min(b));
        };
        for end in 0..2 {
            if row_poles[end] {
                unite(2 * end, 2 * end + 1);
            }
            if column_poles[end] {
                unite(end, 2 + end);
            }
        }
        Welding { size, closed, row_poles, column_poles, corners }
    }

    /// The place of the point that stands for another one.
    pub(super) fn target(&self, k: usize, l: usize) -> [usize; 2] {
        let [last_row, last_column] = self.size.map(|lines| lines.saturating_sub(1));
        let k = if self.closed[0] && k == last_row { 0 } else { k };
        let l = if self.closed[1] && l == last_column { 0 } else { l };
        // A grid of one line has its first border only.
        let border = |at: usize, last: usize| if at == 0 { Some(0) } else { (at == last).then_some(1) };
        let corner = match (border(k, last_row), border(l, last_column)) {
            (Some(end), _) if self.row_poles[end] => self.corners[2 * end],
            (_, Some(end)) if self.column_poles[end] => self.corners[end],
            _ => return [k, l],
        };
        [last_row * (corner / 2), last_column * (corner % 2)]
    }
}

/// For every point of a grid the one that stands for it.
fn merged(grid: &Grid) -> Vec<usize> {
    let size @ [rows, columns] = [grid.rows(), grid.columns()];
    let rounding = BoundingBox::of_points(grid.points()).map_or(0.0, |it| it.rounding());
    let row = |k: usize| (0..columns).filter_map(|l| grid.point(k, l)).collect();
    let column = |l: usize| (0..rows).filter_map(|k| grid.point(k, l)).collect();
    let borders = Borders {
        rows: [0, rows.saturating_sub(1)].map(row),
        columns: [0, columns.saturating_sub(1)].map(column),
    };
    let welding = Welding::new(size, grid.closed(), &borders, rounding);
    let target = |[k, l]: [usize; 2]| {
        let [k, l] = welding.target(k, l);
        k * columns + l
    };
    grid.indices().map(target).collect()
}

/// The two triangles of a cell with the corners (k, l), (k, l - 1), (k - 1, l - 1), (k - 1, l).
pub(super) fn split(cell: [usize; 4], points: &[Point<3>]) -> [[usize; 3]; 2] {
    let [a, b, c, d] = cell;
    let corners = cell.map(|index| points.get(index).copied().unwrap_or([0.0; 3]));
    if is_other_diagonal(corners) { [[c, b, d], [b, a, d]] } else { [[c, b, a], [c, a, d]] }
}

/// Whether a cell with these corners is split between the second and the last of them.
pub(super) fn is_other_diagonal([a, b, c, d]: [Point<3>; 4]) -> bool {
    let distance = |a: Point<3>, b: Point<3>| (0..3).fold(0.0_f64, |sum, d| sum.hypot(a[d] - b[d]));
    let square =
        |a: Point<3>, b: Point<3>| (0..3).fold(0.0_f64, |sum, d| sum + (a[d] - b[d]) * (a[d] - b[d]));
    let (one, other) = (square(b, d), SHORTER * SHORTER * square(a, c));
    // Squares tell in a fraction of the time, unless they are nearly equal, overflow or vanish.
    let sure = one.min(other) > 1e-200 && one.max(other) < 1e200 && (one - other).abs() > 1e-12 * other;
    if sure { one < other } else { distance(b, d) < SHORTER * distance(a, c) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(size: [usize; 2], closed: [bool; 2], point: impl Fn(f64, f64) -> Point<3>) -> Grid {
        let at = |index: usize, count: usize| index as f64 / (count - 1) as f64;
        Grid::from_fn(size, closed, |k, l| point(at(k, size[0]), at(l, size[1])))
    }

    fn ball(size: [usize; 2], turn: f64) -> Grid {
        grid(size, [true, false], |u, v| {
            let (psi, fi) = (turn * u * std::f64::consts::TAU, v * std::f64::consts::PI);
            [fi.sin() * psi.cos(), fi.sin() * psi.sin(), fi.cos()]
        })
    }

    #[test]
    fn balls_are_closed_and_look_outwards() {
        for turn in [1.0, -1.0] {
            let mesh = Mesh::from_grid(&ball([41, 21], turn)).unwrap();
            assert_eq!(mesh.closed_characteristic(), Some(2));
            assert_eq!((mesh.vertices().len(), mesh.triangles().len()), (40 * 19 + 2, 40 * 38));
            let ball = 4.0 / 3.0 * std::f64::consts::PI;
            assert!((mesh.volume() / ball - 1.0).abs() < 0.02 && mesh.volume() < ball);
        }
    }

    #[test]
    fn a_hole_an_edge_too_many_and_a_pinch_are_no_closed_surface() {
        let mesh = Mesh::from_grid(&ball([9, 5], 1.0)).unwrap();
        let mut open = mesh.clone();
        open.triangles.pop();
        assert_eq!(open.closed_characteristic(), None);
        let mut turned = mesh.clone();
        turned.triangles[3].swap(0, 1);
        assert_eq!(turned.closed_characteristic(), None);
        // Two balls that touch in a vertex.
        let mut pinched = mesh.clone();
        let count = mesh.vertices.len();
        pinched.vertices.extend(mesh.vertices.iter().skip(1));
        let other =
            mesh.triangles.iter().map(|corners| corners.map(|n| if n == 0 { 0 } else { n + count - 1 }));
        pinched.triangles.extend(other);
        assert_eq!(pinched.closed_characteristic(), None);
    }

    #[test]
    fn patches_of_a_torus_hang_together() {
        // Sixteen of them, whose borders differ by rounding, also where a coordinate is 0.
        let quarter = |a: usize, b: usize| {
            grid([9, 9], [false; 2], |u, v| {
                let [fi, psi] = [(a, u), (b, v)].map(|(k, t)| (k as f64 + t) * 0.25 * std::f64::consts::TAU);
                let r = 2.0 + psi.cos();
                [r * fi.cos(), r * fi.sin(), -psi.sin()]
            })
        };
        let patches: Vec<Grid> = (0..16).map(|k| quarter(k / 4, k % 4)).collect();
        let mesh = Mesh::from_grids(&patches).unwrap();
        assert_eq!((mesh.vertices().len(), mesh.closed_characteristic()), (32 * 32, Some(0)));
        let torus = 4.0 * std::f64::consts::PI.powi(2);
        assert!((mesh.volume() / torus - 1.0).abs() < 0.05, "{}", mesh.volume());
    }

    #[test]
    fn normals_go_round_the_given_way() {
        let flat = Mesh::from_grid(&grid([2, 3], [false; 2], |u, v| [u, v, 0.0])).unwrap();
        assert_eq!((flat.triangles().len(), flat.closed_characteristic()), (4, None));
        for corners in flat.triangles() {
            assert_eq!(super::super::stl::normal(corners.map(|n| flat.vertices()[n])), [0.0, 0.0, 1.0]);
        }
        let point = Mesh::from_grid(&grid([3, 3], [false; 2], |_, _| [1.0; 3]));
        assert_eq!(point, Err(FigureError::NoArea));
    }

    #[test]
    fn files_have_the_sizes_that_they_announce() {
        let mesh = Mesh::from_grid(&ball([9, 5], 1.0)).unwrap();
        let (vertices, triangles) = (mesh.vertices().len(), mesh.triangles().len());
        assert_eq!(mesh.to_stl().unwrap().bytes.len(), 84 + 50 * triangles);
        let ply = mesh.to_ply().unwrap();
        let end = ply.windows(11).position(|text| text == b"end_header\n").unwrap() + 11;
        assert_eq!(ply.len() - end, 24 * vertices + 13 * triangles);
        let obj = mesh.to_obj();
        assert_eq!(obj.lines().filter(|line| line.starts_with("v ")).count(), vertices);
        let huge = Mesh::from_grid(&grid([2, 2], [false; 2], |u, v| [1e99 * u, 1e99 * v, 0.0])).unwrap();
        assert_eq!(huge.to_stl(), Err(FigureError::Single { value: 1e99 }));
        assert!(huge.to_ply().is_ok() && huge.to_obj().contains("1e99"));
    }
}
