//! Binary STL, which holds single precision.
//!
//! Far from the origin, or for very small surfaces, singles cannot tell neighbouring points apart. Points that become
//! one are one vertex then, and triangles that lose their area are taken out so that what was closed stays closed.

use super::FigureError;
use super::mesh::Mesh;
use crate::geometry::{Point, cross, norm, triangle_width};
use std::collections::{BTreeMap, BinaryHeap, HashMap};

/// A triangle narrower than this part of its longest side has no area.
const NARROWEST: f64 = 1e-12;
/// Steps of taking triangles out, for each triangle; far more than are ever needed.
const PATIENCE: usize = 64;

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
        let mut net = Net::new(&singles.points, singles.triangles(self.triangles()));
        net.take_out_narrow();
        net.take_out_opposite();
        let triangles: Vec<[usize; 3]> = net.triangles.into_iter().flatten().collect();
        let left = Mesh::new(singles.points.clone(), triangles);
        // A closed surface that has become flat encloses nothing; an open one may have been flat before.
        if left.triangles().is_empty() || (self.closed_characteristic().is_some() && left.is_flat()) {
            return Err(FigureError::Confused);
        }
        Ok(Stl { bytes: left.written()?, confused: singles.confused, vertices: self.vertices().len() })
    }

    /// The bytes of a mesh whose coordinates are singles.
    fn written(&self) -> Result<Vec<u8>, FigureError> {
        let count = u32::try_from(self.triangles().len()).map_err(|_| FigureError::TooManyVertices)?;
        let mut bytes = vec![0; 80];
        // The header is free, but must not begin with "solid", which means the textual form.
        bytes.iter_mut().zip(*b"grafika").for_each(|(to, from)| *to = from);
        bytes.extend(count.to_le_bytes());
        for triangle in self.triangles() {
            let corners = triangle.map(|n| self.vertices().get(n).copied().unwrap_or([0.0; 3]));
            let numbers = [normal(corners)].into_iter().chain(corners).flatten();
            bytes.extend(numbers.flat_map(|x| (x as f32).to_le_bytes()));
            bytes.extend([0; 2]);
        }
        Ok(bytes)
    }
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
        let mut known: HashMap<[u64; 3], usize> = HashMap::with_capacity(vertices.len());
        let mut singles =
            Self { points: Vec::new(), numbers: Vec::with_capacity(vertices.len()), confused: 0 };
        // Of every point: the first vertex there, how many there are, and whether they differ.
        let mut fallen: Vec<(Point<3>, usize, bool)> = Vec::new();
        for &vertex in vertices {
            let mut point = [0.0; 3];
            for (to, value) in point.iter_mut().zip(vertex) {
                // Zero has one sign, so that it is one number.
                *to = f64::from(value as f32) + 0.0;
                if !to.is_finite() {
                    return Err(FigureError::Single { value });
                }
            }
            let number = *known.entry(point.map(f64::to_bits)).or_insert(fallen.len());
            match fallen.get_mut(number) {
                Some((first, count, differ)) => {
                    *count += 1;
                    *differ |= *first != vertex;
                }
                None => {
                    singles.points.push(point);
                    fallen.push((vertex, 1, false));
                }
            }
            singles.numbers.push(number);
        }
        singles.confused = fallen.iter().filter(|(.., differ)| *differ).map(|(_, count, _)| count).sum();
        Ok(singles)
    }

    /// Triangles between these points; those without three different corners are left out, and what was closed
    /// stays closed.
    fn triangles(&self, triangles: &[[usize; 3]]) -> Vec<[usize; 3]> {
        let number = |corner: usize| self.numbers.get(corner).copied().unwrap_or(0);
        let mut triangles: Vec<[usize; 3]> = triangles.iter().map(|corners| corners.map(number)).collect();
        triangles.retain(|[a, b, c]| a != b && b != c && c != a);
        triangles
    }
}

/// Triangles with what lies beside them.
struct Net<'a> {
    points: &'a [Point<3>],
    triangles: Vec<Option<[usize; 3]>>,
    /// The triangles that run from one point to another.
    along: HashMap<[usize; 2], Vec<usize>>,
}

/// A triangle without area that waits to be taken out; that with the longest side comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Narrow {
    /// The bits of the length: positive doubles and their bits have the same order.
    longest: u64,
    triangle: usize,
}

impl<'a> Net<'a> {
    fn new(points: &'a [Point<3>], triangles: Vec<[usize; 3]>) -> Self {
        let mut net =
            Net { points, triangles: Vec::new(), along: HashMap::with_capacity(3 * triangles.len()) };
        for (number, corners) in triangles.into_iter().enumerate() {
            net.triangles.push(None);
            net.put(number, Some(corners));
        }
        net
    }

    fn point(&self, number: usize) -> Point<3> {
        self.points.get(number).copied().unwrap_or([0.0; 3])
    }

    fn side(&self, [from, to]: [usize; 2]) -> f64 {
        let (from, to) = (self.point(from), self.point(to));
        norm::<3>(std::array::from_fn(|d| to[d] - from[d]))
    }

    /// Puts another triangle, or none, in the place of one.
    fn put(&mut self, number: usize, corners: Option<[usize; 3]>) {
        let Some(slot) = self.triangles.get_mut(number) else { return };
        for side in std::mem::replace(slot, corners).into_iter().flat_map(sides) {
            if let Some(beside) = self.along.get_mut(&side) {
                beside.retain(|&other| other != number);
            }
        }
        for side in corners.into_iter().flat_map(sides) {
            self.along.entry(side).or_default().push(number);
        }
    }

    /// A triangle without area, turned so that its longest side runs from its last corner to its first.
    fn narrow(&self, number: usize) -> Option<([usize; 3], f64)> {
        let corners = self.triangles.get(number).copied().flatten()?;
        let turned = |[a, b, c]: [usize; 3]| ([a, b, c], self.side([c, a]));
        let [a, b, c] = corners;
        let all = [[a, b, c], [b, c, a], [c, a, b]].map(turned);
        let (corners, longest) = all.into_iter().max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        let width = triangle_width(corners.map(|corner| self.point(corner)));
        (width <= NARROWEST * longest).then_some((corners, longest))
    }

    /// Takes out the triangles whose corners lie on a line. One beside a border goes; else the side between it
    /// and its neighbour over the longest side is turned: the neighbour is cut where the third corner lies on
    /// its border, and nothing opens. The longest first, so that sides only become shorter.
    fn take_out_narrow(&mut self) {
        let waiting = |net: &Self, triangle: usize| {
            net.narrow(triangle).map(|(_, longest)| Narrow { longest: longest.to_bits(), triangle })
        };
        let mut heap: BinaryHeap<Narrow> =
            (0..self.triangles.len()).filter_map(|number| waiting(self, number)).collect();
        let mut patience = PATIENCE.saturating_mul(self.triangles.len());
        while let (Some(Narrow { triangle, .. }), true) = (heap.pop(), patience > 0) {
            patience -= 1;
            let Some(([a, b, c], _)) = self.narrow(triangle) else { continue };
            let Some((neighbour, d)) = self.beside([a, c], b) else {
                self.put(triangle, None);
                continue;
            };
            if b == d {
                // Two triangles back to back.
                self.put(triangle, None);
                self.put(neighbour, None);
                continue;
            }
            self.put(triangle, Some([b, c, d]));
            self.put(neighbour, Some([a, b, d]));
            heap.extend([triangle, neighbour].into_iter().filter_map(|number| waiting(self, number)));
        }
    }

    /// A triangle that runs along a side, with its third corner: the one back to back, if there is one.
    fn beside(&self, side: [usize; 2], back: usize) -> Option<(usize, usize)> {
        let third = |&number: &usize| {
            let corners = self.triangles.get(number).copied().flatten()?;
            Some((number, corners.into_iter().find(|corner| !side.contains(corner))?))
        };
        let all = || self.along.get(&side).into_iter().flatten().filter_map(third);
        all().find(|&(_, corner)| corner == back).or_else(|| all().next())
    }

    /// Takes out pairs of triangles that lie back to back.
    fn take_out_opposite(&mut self) {
        let mut facing: BTreeMap<[usize; 3], Vec<usize>> = BTreeMap::new();
        for number in 0..self.triangles.len() {
            let Some([a, b, c]) = self.triangles.get(number).copied().flatten() else { continue };
            let first = |[a, b, c]: [usize; 3]| {
                if a < b && a < c {
                    [a, b, c]
                } else if b < c {
                    [b, c, a]
                } else {
                    [c, a, b]
                }
            };
            if let Some(other) = facing.get_mut(&first([a, c, b])).and_then(Vec::pop) {
                self.put(number, None);
                self.put(other, None);
            } else {
                facing.entry(first([a, b, c])).or_default().push(number);
            }
        }
    }
}

fn sides([a, b, c]: [usize; 3]) -> [[usize; 2]; 3] {
    [[a, b], [b, c], [c, a]]
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
