//! Where a plane cuts a surface: marching squares over the places of a grid, whose crossings are then found on
//! the surface itself.
//!
//! A place counts as on one of two sides and never on the plane itself: on it is above it. So every cell has
//! an even number of crossed edges, every edge joins two cells at most, and the pieces always make chains,
//! however the plane touches the surface. What is smaller than a cell of the grid may be missed, and a part of
//! the surface that lies in the plane has no section but its border towards what is below.

use super::{Grid, ParamSurface};
use crate::geometry::point::{check_points, lerp, norm, scaled_difference};
use crate::geometry::{GeometryError, Point, dot};
use std::collections::{BTreeMap, BTreeSet};

/// The plane of the points whose product with `normal` is `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A vector at right angles to the plane, of any length but 0.
    pub normal: Point<3>,
    /// The product of the normal with every point of the plane.
    pub offset: f64,
}

impl Plane {
    /// The plane through a point.
    #[must_use]
    pub fn through(point: Point<3>, normal: Point<3>) -> Self {
        Self { normal, offset: dot(normal, point) }
    }

    /// The same plane with a normal of length 1.
    fn unit(self) -> Result<Self, GeometryError> {
        check_points(&[self.normal])?;
        let length = norm(self.normal);
        let offset = self.offset / length;
        if length > 0.0 && offset.is_finite() {
            return Ok(Self { normal: self.normal.map(|x| x / length), offset });
        }
        let (name, value, wanted) = match length > 0.0 {
            true => ("offset", self.offset, "a finite number, also divided by the length of the normal"),
            false => ("the normal's length", length, "larger than 0"),
        };
        Err(GeometryError::Parameter { name, value, wanted })
    }

    fn height(&self, point: Point<3>) -> f64 {
        dot(self.normal, point) - self.offset
    }
}

/// How near to the plane a place is on it, by the extent of the surface.
const ON_PLANE: f64 = 1e-13;

/// Rounds of the search for a crossing; halving alone is at the last bit by then.
const ROUNDS: usize = 80;

/// The lines in which a plane cuts a surface, as polylines on both; `per_cell` steps for every cell of the net
/// decide how fine they are and what is missed. A closed line ends with its first point. The points lie on
/// the surface, and on the plane to 1e-12 of the extent of the surface and the last bits of the coordinates.
///
/// A line ends at the borders of the surface. One that goes through a pole goes on behind it. Where the plane
/// only touches the surface from below there is nothing; a touch from above may leave a tiny ring.
///
/// ```
/// use grafika::geometry::{Method, Plane, Scheme, Surface, Topology, section};
///
/// // A paraboloid, cut at the height 1.
/// let z = |k: usize, l: usize| [1.0, -1.0, 1.0][k] + [1.0, -1.0, 1.0][l];
/// let net: Vec<Vec<[f64; 3]>> =
///     (0..3).map(|k| (0..3).map(|l| [k as f64 - 1.0, l as f64 - 1.0, z(k, l)]).collect()).collect();
/// let surface = Surface::new(Scheme::new(Method::Bezier, Topology::Open), &net)?;
/// let lines = section(&surface, Plane { normal: [0.0, 0.0, 1.0], offset: 1.0 }, 10)?;
/// assert_eq!(lines.len(), 1);
/// assert_eq!(lines[0].first(), lines[0].last());
/// assert!(lines[0].iter().all(|[x, y, z]| (x * x + y * y - 1.0).abs() < 1e-12 && (z - 1.0).abs() < 1e-12));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
///
/// # Errors
/// [`GeometryError::Samples`] for no steps at all or too many places; a normal without length, coordinates that
/// are not finite.
pub fn section(
    surface: &dyn ParamSurface,
    plane: Plane,
    per_cell: usize,
) -> Result<Vec<Vec<Point<3>>>, GeometryError> {
    let mesh = Mesh::new(surface, plane.unit()?, per_cell)?;
    let links = mesh.links();
    Ok(chains(&links).iter().filter_map(|chain| mesh.polyline(chain)).collect())
}

/// A place on a surface.
#[derive(Clone, Copy, Debug)]
struct Place {
    span: [usize; 2],
    at: [f64; 2],
}

/// The lines of a direction as spans and parameters in them.
#[derive(Debug)]
struct Lines {
    places: Vec<(usize, f64)>,
    closed: bool,
}

impl Lines {
    fn new(surface: &dyn ParamSurface, direction: usize, per_cell: usize) -> Self {
        let closed = surface.closed().get(direction).copied().unwrap_or(false);
        Self { places: surface.lines(direction, per_cell), closed }
    }

    fn cells(&self) -> usize {
        self.places.len().saturating_sub(usize::from(!self.closed))
    }

    fn next(&self, line: usize) -> usize {
        if line + 1 < self.places.len() { line + 1 } else { 0 }
    }

    /// The span and the two parameters of the step that begins at a line.
    fn step(&self, line: usize) -> Option<(usize, [f64; 2])> {
        let (span, from) = *self.places.get(line)?;
        let (next, to) = *self.places.get(self.next(line))?;
        // Where another span begins, this one ends.
        Some((span, [from, if next == span && to > from { to } else { 1.0 }]))
    }
}

/// The edge from vertex (k, l) along `u` (`along` 0) or along `v` (1); numbered `2 (k columns + l) + along`.
type Edge = usize;

/// Heights over the plane of the places of a grid.
struct Mesh<'a> {
    surface: &'a dyn ParamSurface,
    plane: Plane,
    lines: [Lines; 2],
    /// Of every place, row by row: whether it is on the plane or above it.
    above: Vec<bool>,
    /// How near to the plane a place is on it.
    on_plane: f64,
    /// How near to each other points are one.
    one_point: f64,
}

impl<'a> Mesh<'a> {
    fn new(surface: &'a dyn ParamSurface, plane: Plane, per_cell: usize) -> Result<Self, GeometryError> {
        let grid = surface.grid(per_cell)?;
        let lines = [0, 1].map(|direction| Lines::new(surface, direction, per_cell));
        let bounds = surface.bounding_box();
        // Heights are differences of numbers as large as these.
        let last_bits = bounds.map_or(0.0, |it| it.last_bits() / 4.0).max(f64::EPSILON * plane.offset.abs());
        let on_plane = bounds.map_or(0.0, |it| ON_PLANE * it.extent()).max(last_bits);
        let one_point = bounds.map_or(0.0, |it| it.rounding());
        let mut mesh = Self { surface, plane, lines, above: Vec::new(), on_plane, one_point };
        mesh.above = mesh.sides(&grid);
        Ok(mesh)
    }

    /// The side of every place. A border that is one point is on one side, or lines would end in it.
    fn sides(&self, grid: &Grid) -> Vec<bool> {
        let [rows, columns] = self.lines.each_ref().map(|lines| lines.places.len());
        let is_above = |point: Option<Point<3>>| point.is_none_or(|point| self.height(point) >= 0.0);
        let place = |k: usize, l: usize| is_above(grid.point(k, l));
        let mut above: Vec<bool> =
            (0..rows).flat_map(|k| (0..columns).map(move |l| (k, l))).map(|(k, l)| place(k, l)).collect();
        let (last_row, last_column) = (rows.saturating_sub(1), columns.saturating_sub(1));
        let along_u = [0, last_column].map(|l| (0..rows).map(|k| [k, l]).collect::<Vec<_>>());
        let along_v = [0, last_row].map(|k| (0..columns).map(|l| [k, l]).collect::<Vec<_>>());
        for border in along_u.into_iter().chain(along_v) {
            let mut points = border.iter().filter_map(|&[k, l]| grid.point(k, l));
            let Some(pole) = points.next() else { continue };
            if points.all(|point| self.same(pole, point)) {
                for &[k, l] in &border {
                    if let Some(side) = above.get_mut(k * columns + l) {
                        *side = is_above(Some(pole));
                    }
                }
            }
        }
        above
    }

    /// Whether two points are one but for rounding.
    fn same(&self, a: Point<3>, b: Point<3>) -> bool {
        norm(scaled_difference(1.0, a, b)) <= self.one_point
    }

    /// The height over the plane; what is on it but for rounding is at 0.
    fn height(&self, point: Point<3>) -> f64 {
        let height = self.plane.height(point);
        if height.abs() <= self.on_plane { 0.0 } else { height }
    }

    fn vertex(&self, k: usize, l: usize) -> usize {
        k * self.lines[1].places.len() + l
    }

    fn is_above(&self, vertex: usize) -> bool {
        self.above.get(vertex).copied().unwrap_or(true)
    }

    /// The two neighbours of every crossed edge, at most one for each cell beside it.
    fn links(&self) -> Links {
        let mut links = Links::default();
        let [rows, columns] = &self.lines;
        for k in 0..rows.cells() {
            for l in 0..columns.cells() {
                self.link_cell([k, l], &mut links);
            }
        }
        links
    }

    fn link_cell(&self, [k, l]: [usize; 2], links: &mut Links) {
        let (next_k, next_l) = (self.lines[0].next(k), self.lines[1].next(l));
        // Round the cell; edge n leads from corner n to the next.
        let corners =
            [self.vertex(k, l), self.vertex(next_k, l), self.vertex(next_k, next_l), self.vertex(k, next_l)];
        let edges = [2 * corners[0], 2 * corners[1] + 1, 2 * corners[3], 2 * corners[0] + 1];
        let sides = corners.map(|corner| self.is_above(corner));
        let crossed: Vec<Edge> =
            (0..4).filter(|&n| sides[n] != sides[(n + 1) % 4]).map(|n| edges[n]).collect();
        match *crossed {
            [a, b] => links.join(a, b),
            // Opposite corners are on the same side. The middle tells which of them are joined; the edges
            // that meet in a corner of the other side are then one line.
            [a, b, c, d] if self.middle_is_above([k, l]) == sides[0] => {
                links.join(a, b);
                links.join(c, d);
            }
            [a, b, c, d] => {
                links.join(d, a);
                links.join(b, c);
            }
            _ => {}
        }
    }

    fn middle_is_above(&self, [k, l]: [usize; 2]) -> bool {
        let middle = || {
            let (i, [u0, u1]) = self.lines[0].step(k)?;
            let (j, [v0, v1]) = self.lines[1].step(l)?;
            self.surface.eval([i, j], [0.5 * (u0 + u1), 0.5 * (v0 + v1)])
        };
        middle().is_none_or(|point| self.height(point) >= 0.0)
    }

    /// The points of a chain of edges; `None` when they are all the same.
    fn polyline(&self, chain: &[Edge]) -> Option<Vec<Point<3>>> {
        let mut line: Vec<Point<3>> = Vec::with_capacity(chain.len());
        for point in chain.iter().filter_map(|&edge| self.crossing(edge)) {
            if !line.last().is_some_and(|&last| self.same(last, point)) {
                line.push(point);
            }
        }
        let closed = chain.len() > 2 && chain.first() == chain.last();
        if let ([first, _, .., last], true) = (line.as_slice(), closed) {
            // The last point is the first one, or was left out because the one before it is the same.
            let (first, last) = (*first, *last);
            if self.same(last, first) {
                line.pop();
            }
            line.push(first);
        }
        (line.len() > 1).then_some(line)
    }

    /// The place on an edge where the surface crosses the plane.
    fn crossing(&self, edge: Edge) -> Option<Point<3>> {
        let width = self.lines[1].places.len();
        let (k, l) = (edge / 2 / width, edge / 2 % width);
        let ((i, u), (j, v)) = (*self.lines[0].places.get(k)?, *self.lines[1].places.get(l)?);
        let (from, to) = if edge.is_multiple_of(2) {
            let (_, [from, to]) = self.lines[0].step(k)?;
            ([from, v], [to, v])
        } else {
            let (_, [from, to]) = self.lines[1].step(l)?;
            ([u, from], [u, to])
        };
        self.search(Place { span: [i, j], at: from }, to)
    }

    /// A point of the plane on the way from a place to another of the same patch, by the method of false
    /// position, whose older end counts half when it stays (Illinois).
    fn search(&self, from: Place, to: [f64; 2]) -> Option<Point<3>> {
        let at = |way: f64| self.surface.eval(from.span, lerp(from.at, to, way));
        let (mut near, mut far) = ((0.0, at(0.0)?), (1.0, at(1.0)?));
        let mut heights = [self.height(near.1), self.height(far.1)];
        for round in 0..ROUNDS {
            if heights[0] == 0.0 {
                return Some(near.1);
            }
            // Also where a border that is one point was put on one side with its first place.
            if heights[1] == 0.0 || heights[0].signum() == heights[1].signum() {
                return Some(far.1);
            }
            let share = heights[0] / (heights[0] - heights[1]);
            // Halving now and then bounds the number of rounds.
            let share = if round % 4 == 3 || !(share > 0.0 && share < 1.0) { 0.5 } else { share };
            let way = near.0 + share * (far.0 - near.0);
            let point = at(way)?;
            let height = self.height(point);
            if height.signum() == heights[1].signum() && height != 0.0 {
                heights = [0.5 * heights[0], height];
                far = (way, point);
            } else {
                heights = [height, 0.5 * heights[1]];
                near = (way, point);
            }
        }
        Some(near.1)
    }
}

/// Which edges follow each other.
#[derive(Debug, Default)]
struct Links(BTreeMap<Edge, [Option<Edge>; 2]>);

impl Links {
    fn join(&mut self, a: Edge, b: Edge) {
        for (edge, other) in [(a, b), (b, a)] {
            let slots = self.0.entry(edge).or_default();
            // An edge has two cells at most, so there is room.
            if let Some(free) = slots.iter_mut().find(|slot| slot.is_none()) {
                *free = Some(other);
            }
        }
    }
}

/// The edges in the order of the lines; those of a closed line end with the first again.
fn chains(links: &Links) -> Vec<Vec<Edge>> {
    let mut done = BTreeSet::new();
    let mut chains = Vec::new();
    let ends = links.0.iter().filter(|(_, slots)| slots.contains(&None));
    // Open lines from their ends; what is left then is closed.
    for (&start, _) in ends.chain(&links.0) {
        if !done.insert(start) {
            continue;
        }
        let mut chain = vec![start];
        let mut edge = start;
        loop {
            let next =
                links.0.get(&edge).and_then(|slots| slots.iter().flatten().find(|e| !done.contains(e)));
            let Some(&next) = next else { break };
            done.insert(next);
            chain.push(next);
            edge = next;
        }
        let closed = links.0.get(&start).is_some_and(|slots| !slots.contains(&None));
        if closed {
            chain.push(start);
        }
        chains.push(chain);
    }
    chains
}
