//! Binary STL, which holds single precision.
//!
//! Far from the origin, or for very small surfaces, singles cannot tell neighbouring points apart. Points that become
//! one are one vertex then, and triangles that lose their area are taken out so that what was closed stays closed.

use super::FigureError;
use super::mesh::{Mesh, Triangles, is_flat};
use super::mesh_rows::MeshRows;
use super::narrow::{is_narrow, take_out};
use crate::geometry::{GeometryError, Point, cross, dot};
use std::borrow::Cow;
use std::io;

/// A mesh as binary STL.
#[derive(Clone, Debug, PartialEq)]
pub struct Stl {
    /// The file.
    pub bytes: Vec<u8>,
    /// How many vertices of the mesh have become one with others.
    pub confused: usize,
    /// How many vertices the mesh has.
    pub vertices: usize,
}

impl Stl {
    /// What the user is told when points were lost.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let Stl { confused, vertices, .. } = self;
        (self.confused > 0).then(|| {
            format!(
                ".stl holds single precision, which cannot tell {confused} of these {vertices} points apart; \
                 .ply and .obj can, or move the surface nearer to the origin"
            )
        })
    }
}

impl Mesh {
    /// The mesh as binary STL, in single precision. Vertices that are the same there are one; triangles that have
    /// no area are left out, and a closed mesh stays closed. Normals follow the order of the corners.
    ///
    /// # Errors
    /// [`FigureError::Single`] for a coordinate that is too large for a single, [`FigureError::Confused`] when singles
    /// leave nothing of the surface, [`FigureError::TooManyVertices`] for more triangles than 32 bits count.
    pub fn to_stl(&self) -> Result<Stl, FigureError> {
        let singles = Singles::new(self.vertices())?;
        let triangles = take_out(&singles.points, singles.triangles(self.triangles()));
        // A closed surface that has become flat encloses nothing; an open one may have been flat before.
        if triangles.is_empty() || (self.closed_characteristic().is_some() && is_flat(&singles.points)) {
            return Err(FigureError::Confused);
        }
        let bytes = written(&singles.points, &triangles)?;
        Ok(Stl { bytes, confused: singles.confused, vertices: self.vertices().len() })
    }
}

/// The bytes of a mesh whose coordinates are singles.
fn written(points: &[Point<3>], triangles: &[[usize; 3]]) -> Result<Vec<u8>, FigureError> {
    let count = u32::try_from(triangles.len()).map_err(|_| FigureError::TooManyVertices)?;
    let mut bytes = Vec::with_capacity(84 + 50 * triangles.len());
    bytes.extend(header(count));
    for triangle in triangles {
        bytes.extend(facet(triangle.map(|n| points.get(n).copied().unwrap_or([0.0; 3]))));
    }
    Ok(bytes)
}

/// What stands before so many triangles.
fn header(count: u32) -> [u8; 84] {
    let mut bytes = [0; 84];
    // The header is free, but must not begin with "solid", which means the textual form.
    bytes[..7].copy_from_slice(b"grafika");
    bytes[80..].copy_from_slice(&count.to_le_bytes());
    bytes
}

/// A triangle between points that are singles.
fn facet(corners: [Point<3>; 3]) -> [u8; 50] {
    let mut facet = [0; 50];
    let normal = single_normal(corners);
    let [a, b, c] = corners.map(|corner| corner.map(|x| x as f32));
    let (numbers, _) = facet.as_chunks_mut::<4>();
    for (to, x) in numbers.iter_mut().zip([normal, a, b, c].as_flattened()) {
        *to = x.to_le_bytes();
    }
    facet
}

/// A mesh that is written as STL row by row: one whose vertices stay apart as singles, and whose triangles all have an area
/// then, so that the file is that of [`Mesh::to_stl`].
pub(super) struct StlRows<'a> {
    mesh: MeshRows<'a>,
    count: u32,
}

impl<'a> StlRows<'a> {
    /// `None` if the mesh is none of those.
    ///
    /// # Errors
    /// Those of the surface.
    pub(super) fn new(mesh: MeshRows<'a>) -> Result<Option<StlRows<'a>>, GeometryError> {
        let [vertices, triangles] = mesh.counts();
        let Ok(count) = u32::try_from(triangles) else { return Ok(None) };
        if !Self::are_apart(&mesh, vertices)? {
            return Ok(None);
        }
        let mut narrow = false;
        mesh.each_triangle(&mut |corners| {
            narrow = narrow || is_narrow(corners.map(|corner| single(corner.point)));
        })?;
        if narrow || mesh.is_closed() && mesh.is_flat(single)? {
            return Ok(None);
        }
        Ok(Some(StlRows { mesh, count }))
    }

    /// Whether all vertices are numbers as singles, and no two of them the same ones.
    fn are_apart(mesh: &MeshRows<'_>, vertices: usize) -> Result<bool, GeometryError> {
        let (mut singles, mut finite) = (Vec::with_capacity(vertices), true);
        mesh.each_vertex(&mut |point| {
            let point = point.map(|x| x as f32 + 0.0);
            finite = finite && point.iter().all(|x| x.is_finite());
            singles.push(point.map(f32::to_bits));
        })?;
        singles.sort_unstable();
        Ok(finite && singles.windows(2).all(|pair| pair[0] != pair[1]))
    }

    /// The bytes of the file.
    pub(super) fn size(&self) -> usize {
        84 + 50 * self.count as usize
    }

    /// Writes the file.
    ///
    /// # Errors
    /// Those of the writer.
    pub(super) fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        out.write_all(&header(self.count))?;
        let mut written = Ok(());
        let done = self.mesh.each_triangle(&mut |corners| {
            let facet = facet(corners.map(|corner| single(corner.point)));
            written = std::mem::replace(&mut written, Ok(())).and_then(|()| out.write_all(&facet));
        });
        done.map_err(io::Error::other).and(written)
    }
}

/// A point in single precision; zero has one sign.
fn single(point: Point<3>) -> Point<3> {
    point.map(|x| f64::from(x as f32) + 0.0)
}

/// The vertices of a mesh in single precision.
struct Singles {
    /// Every different one once.
    points: Vec<Point<3>>,
    /// The number of that point for every vertex.
    numbers: Vec<usize>,
    /// How many different vertices have become one with others.
    confused: usize,
}

impl Singles {
    fn new(vertices: &[Point<3>]) -> Result<Self, FigureError> {
        // Points that are the same stand beside each other once sorted by their bits, the first one first. Numbers of
        // vertices beyond 32 bits are too many for any file.
        u32::try_from(vertices.len()).map_err(|_| FigureError::TooManyVertices)?;
        let mut sorted = Vec::with_capacity(vertices.len());
        for (index, vertex) in (0_u32..).zip(vertices) {
            let mut key = 0;
            for &value in vertex {
                // Zero has one sign, so that it is one number.
                let single = value as f32 + 0.0;
                if !single.is_finite() {
                    return Err(FigureError::Single { value });
                }
                key = key << 32 | u128::from(single.to_bits());
            }
            sorted.push(key << 32 | u128::from(index));
        }
        sorted.sort_unstable();
        let mut numbers = vec![0; vertices.len()];
        let mut confused = 0;
        for same in sorted.chunk_by(|one, other| one >> 32 == other >> 32) {
            // The lower bits are the number of the vertex.
            let indices = || same.iter().map(|key| (key & 0xFFFF_FFFF) as usize);
            let first = indices().next().unwrap_or(0);
            for index in indices() {
                numbers[index] = first;
            }
            let differ = indices().any(|index| vertices.get(index) != vertices.get(first));
            confused += if differ { same.len() } else { 0 };
        }
        drop(sorted);
        // From the first vertex there to the number of the point, in the order of the vertices.
        let mut points = Vec::with_capacity(vertices.len());
        for index in 0..numbers.len() {
            let first = numbers[index];
            numbers[index] = if first == index {
                points.push(single(vertices[index]));
                points.len() - 1
            } else {
                // An earlier one, so it is a number already.
                numbers[first]
            };
        }
        Ok(Self { points, numbers, confused })
    }

    /// Triangles between these points; those without three different corners are left out, and what was closed
    /// stays closed. The same triangles if no points have become one.
    fn triangles<'a>(&self, triangles: &'a [[usize; 3]]) -> Cow<'a, [[usize; 3]]> {
        let different = |[a, b, c]: &[usize; 3]| a != b && b != c && c != a;
        if self.points.len() == self.numbers.len() && triangles.iter().all(different) {
            return Cow::Borrowed(triangles);
        }
        let number = |corner: usize| self.numbers.get(corner).copied().unwrap_or(0);
        triangles.iter().map(|corners| corners.map(number)).filter(different).collect()
    }
}

/// The unit normal of a triangle; zero where it has none.
pub(super) fn normal([a, b, c]: [Point<3>; 3]) -> Point<3> {
    let leg = |p: Point<3>| std::array::from_fn(|d| p[d] - a[d]);
    let unit = |v: Point<3>| {
        let length = v.iter().fold(0.0_f64, |sum, x| sum.hypot(*x));
        if length > 0.0 { v.map(|x| x / length) } else { [0.0; 3] }
    };
    // Scaled first: the product of tiny legs would vanish.
    unit(cross(unit(leg(b)), unit(leg(c))))
}

/// The same in single precision.
fn single_normal([a, b, c]: [Point<3>; 3]) -> [f32; 3] {
    let leg = |p: Point<3>| -> Point<3> { std::array::from_fn(|d| p[d] - a[d]) };
    let (u, v) = (leg(b), leg(c));
    let product = cross(u, v);
    let (long, area) = (dot(u, u) * dot(v, v), dot(product, product));
    // Where nothing overflows or vanishes, the product's own rounding is some last bits by the sine of the angle. If
    // neither that nor the other way's can change the single, it is the one that the careful way gives.
    if long < 1e200 && area > 1e-200 {
        let (length, slack) = (area.sqrt(), 1e-14 * (long / area).sqrt());
        let unit = product.map(|x| x / length);
        if unit.iter().all(|x| (x - slack) as f32 == (x + slack) as f32 && x.abs() > slack) {
            return unit.map(|x| x as f32);
        }
    }
    normal([a, b, c]).map(|x| x as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::HashMap;

    /// Numbers of points by a map of their bits, and how many vertices have become one with others.
    fn by_bits(vertices: &[Point<3>]) -> (Vec<Point<3>>, Vec<usize>, usize) {
        let (mut points, mut all): (Vec<Point<3>>, Vec<Vec<Point<3>>>) = (Vec::new(), Vec::new());
        let mut known = HashMap::new();
        let mut number = |vertex: &Point<3>| {
            let point = vertex.map(|x| f64::from(x as f32) + 0.0);
            let number = *known.entry(point.map(f64::to_bits)).or_insert(points.len());
            if number == points.len() {
                points.push(point);
                all.push(Vec::new());
            }
            all[number].push(*vertex);
            number
        };
        let numbers = vertices.iter().map(&mut number).collect();
        let confused = all.iter().filter(|same| same.iter().any(|it| *it != same[0])).map(Vec::len).sum();
        (points, numbers, confused)
    }

    proptest! {
        #[test]
        fn singles_are_numbered_in_the_order_of_the_vertices(
            vertices in prop::collection::vec(prop::array::uniform3(prop::sample::select(vec![0.0, -0.0, 1.0, 1.0 + 1e-12, -1.0, 0.1])), 0..40),
        ) {
            let singles = Singles::new(&vertices).unwrap();
            prop_assert_eq!((singles.points, singles.numbers, singles.confused), by_bits(&vertices));
        }

        /// Also of triangles that are nearly lines, flat in a coordinate, tiny or huge.
        #[test]
        fn normals_are_those_of_the_careful_way(
            corners in prop::array::uniform3(prop::array::uniform3(-9.0_f32..9.0)),
            flat in 0_usize..4, near in prop::sample::select(vec![1.0_f32, 1e-3, 1e-6]), size in prop::sample::select(vec![1.0, 1e-40, 1e30]),
        ) {
            let mut corners = corners.map(|corner| corner.map(|x| f64::from(x) * size));
            let [_, b, c] = corners;
            corners[2] = std::array::from_fn(|d| b[d] + f64::from(near) * (c[d] - b[d]));
            if flat < 3 {
                corners.iter_mut().for_each(|corner| corner[flat] = 0.0);
            }
            let bits = |normal: [f32; 3]| normal.map(f32::to_bits);
            prop_assert_eq!(bits(single_normal(corners)), bits(normal(corners).map(|x| x as f32)));
        }
    }
}
