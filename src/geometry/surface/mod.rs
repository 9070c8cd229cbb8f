//! Surfaces by a net of control points (chapter 3): interpolation, B-splines and beta-splines as nets of
//! bicubic Bézier patches, and the Bézier patch by all points.
//!
//! A surface is weights along `u` times the net times weights along `v`; sphere and torus topology, doubled
//! borders and auxiliary pole points only change the weights ([`weave`](self::weave)). Sampling and
//! derivatives are written once for patches.

mod bspline;
mod grid;
mod inspect;
mod patch;
mod refine;
mod section;
mod weave;

pub use bspline::{BSplineSurface, Rim};
pub use grid::Grid;
pub use patch::{Derivatives, Patch};
pub use refine::{RefineDirection, refine};
pub use section::{Plane, section};

use super::point::{check_count, check_points, within_limit};
use super::{Bezier, BoundingBox, Closure, GeometryError, MAX_SAMPLES, Method, Point};

/// What a surface is joined to itself by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Topology {
    /// Four borders.
    Open,
    /// Closed in `u`; the borders v = first and v = last are one point each, the poles.
    Sphere,
    /// Closed in `u` and `v`.
    Torus,
}

impl Topology {
    /// What it is like: `plane`, `sphere`, `torus`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Open => "plane",
            Self::Sphere => "sphere",
            Self::Torus => "torus",
        }
    }

    /// Whether it is joined in the directions of `u` and `v`.
    #[must_use]
    pub fn closed(self) -> [bool; 2] {
        match self {
            Self::Open => [false, false],
            Self::Sphere => [true, false],
            Self::Torus => [true, true],
        }
    }
}

/// Where a cubic B-spline surface ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Border {
    /// As the book's programs draw it: border points count twice (3.36), so that the surface stops a sixth of
    /// an edge inside, with a hole around a pole.
    #[default]
    Doubled,
    /// Auxiliary points beyond the border lead the surface to it and close it over the poles (3.41-3.46,
    /// 3.51-3.56 with bias 1 and tension 0).
    Reached,
}

/// How a surface follows its net.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme {
    /// The method along `u`.
    pub u: Method,
    /// The method along `v`; of the same kind, perhaps with other parameters.
    pub v: Method,
    /// What is joined.
    pub topology: Topology,
    /// Where a cubic B-spline ends.
    pub border: Border,
}

impl Scheme {
    /// The same method in both directions, with the borders of the book.
    #[must_use]
    pub fn new(method: Method, topology: Topology) -> Self {
        Self { u: method, v: method, topology, border: Border::Doubled }
    }
}

/// The spans of one direction of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Direction {
    spans: usize,
    /// How many cells of the net a span covers: 1, but all of them for the Bézier patch.
    cells: usize,
    /// The first and the last span are half as long as the others.
    half_ends: bool,
    closed: bool,
    /// How many derivatives are continuous from span to span, 0 to 2.
    smoothness: usize,
}

impl Direction {
    /// Steps that a span is drawn in, where a cell of the net has `per_cell`.
    fn steps(&self, span: usize, per_cell: usize) -> usize {
        let end = span == 0 || span + 1 == self.spans;
        if self.half_ends && end { per_cell.div_ceil(2) } else { per_cell.saturating_mul(self.cells) }
    }
}

/// A surface: a grid of patches.
///
/// ```
/// use grafika::geometry::{Method, Scheme, Surface, Topology};
///
/// let net: Vec<Vec<[f64; 3]>> =
///     (0..5).map(|k| (0..4).map(|l| [f64::from(k), f64::from(l), f64::from(k * l)]).collect()).collect();
/// let surface = Surface::new(Scheme::new(Method::Spline, Topology::Open), &net)?;
/// assert_eq!(surface.spans(), [4, 3]);
/// assert_eq!(surface.eval(2, 1, 0.0, 0.0), Some(net[2][1]));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    body: Body,
    directions: [Direction; 2],
    topology: Topology,
}

#[derive(Clone, Debug, PartialEq)]
enum Body {
    /// Patch (i, j) at `i * spans_v + j`.
    Patches(Vec<Patch>),
    /// The rows of a Bézier net, which is not 4 x 4.
    Bezier(Vec<Vec<Point<3>>>),
}

impl Surface {
    /// The surface of a net: row `k` is the points of constant `u`, point `l` of it counts in `v`. Closed
    /// directions do not repeat a row. The first and last points of a sphere's rows are its poles; those of row
    /// 0 count.
    ///
    /// # Errors
    /// Too few or too many points, rows of different lengths, a bad coordinate or parameter, a topology that
    /// the method does not have, an odd number of meridians where opposite ones are joined.
    pub fn new(scheme: Scheme, net: &[Vec<Point<3>>]) -> Result<Self, GeometryError> {
        check_net(net)?;
        if matches!((scheme.u, scheme.v), (Method::Bezier, _) | (_, Method::Bezier)) {
            return Self::bezier(scheme, net);
        }
        let (patches, directions) = weave::patches(scheme, net)?;
        Self::of_patches(patches, directions, scheme.topology)
    }

    /// The surface of one Hermite matrix (3.17)-(3.18), as [`Patch::from_hermite`].
    ///
    /// # Errors
    /// A bad coordinate.
    pub fn hermite(matrix: &[[Point<3>; 4]; 4]) -> Result<Self, GeometryError> {
        for row in matrix {
            check_points(row)?;
        }
        let one = Direction { spans: 1, cells: 1, half_ends: false, closed: false, smoothness: 2 };
        Self::of_patches(vec![Patch::from_hermite(matrix)], [one; 2], Topology::Open)
    }

    fn bezier(scheme: Scheme, net: &[Vec<Point<3>>]) -> Result<Self, GeometryError> {
        if scheme.topology != Topology::Open || scheme.u != scheme.v {
            let (method, topology) = (Method::Bezier.name(), scheme.topology.name());
            return Err(GeometryError::TopologyNotOffered { method, topology });
        }
        let columns = net.first().map_or(0, Vec::len);
        for count in [net.len(), columns] {
            check_count(count, 2)?;
        }
        let direction = |count: usize| Direction {
            spans: 1,
            cells: count - 1,
            half_ends: false,
            closed: false,
            smoothness: 2,
        };
        let directions = [direction(net.len()), direction(columns)];
        let body = match four_by_four(net) {
            Some(p) => Body::Patches(vec![Patch { p }]),
            None => Body::Bezier(net.to_vec()),
        };
        Ok(Self { body, directions, topology: Topology::Open })
    }

    fn of_patches(
        patches: Vec<Patch>,
        directions: [Direction; 2],
        topology: Topology,
    ) -> Result<Self, GeometryError> {
        match patches.iter().position(|patch| !patch.p.iter().flatten().all(within_limit)) {
            None => Ok(Self { body: Body::Patches(patches), directions, topology }),
            Some(span) => Err(GeometryError::Overflow { span }),
        }
    }

    /// The number of spans along `u` and `v`.
    #[must_use]
    pub fn spans(&self) -> [usize; 2] {
        self.directions.map(|direction| direction.spans)
    }

    /// How long the spans of a direction are in the parameter: 1, but one half for the end spans of a
    /// quadratic B-spline between borders. Direction 0 is `u`, 1 is `v`.
    #[must_use]
    pub fn lengths(&self, direction: usize) -> Vec<f64> {
        let Some(direction) = self.directions.get(direction) else { return Vec::new() };
        let end = |span: usize| span == 0 || span + 1 == direction.spans;
        (0..direction.spans).map(|span| if direction.half_ends && end(span) { 0.5 } else { 1.0 }).collect()
    }

    /// What the surface is joined by.
    #[must_use]
    pub fn topology(&self) -> Topology {
        self.topology
    }

    /// Whether the borders of `u` and of `v` are joined with each other.
    #[must_use]
    pub fn closed(&self) -> [bool; 2] {
        self.directions.map(|direction| direction.closed)
    }

    /// The patch of spans (i, j). `None` outside, and for a Bézier net that is not 4 x 4: see
    /// [`Surface::bezier_net`].
    #[must_use]
    pub fn patch(&self, i: usize, j: usize) -> Option<&Patch> {
        let [rows, columns] = self.spans();
        match &self.body {
            Body::Patches(patches) if i < rows && j < columns => patches.get(i * columns + j),
            _ => None,
        }
    }

    /// The net of a Bézier patch of other degrees than 3 and 3.
    #[must_use]
    pub fn bezier_net(&self) -> Option<&[Vec<Point<3>>]> {
        match &self.body {
            Body::Patches(_) => None,
            Body::Bezier(net) => Some(net),
        }
    }

    /// The point of spans (i, j) at (u, v), both clipped to [0, 1]; `None` outside the spans.
    #[must_use]
    pub fn eval(&self, i: usize, j: usize, u: f64, v: f64) -> Option<Point<3>> {
        let (u, v) = (u.clamp(0.0, 1.0), v.clamp(0.0, 1.0));
        match &self.body {
            Body::Patches(_) => self.patch(i, j).map(|patch| patch.eval(u, v)),
            Body::Bezier(net) if (i, j) == (0, 0) => {
                let across = columns_at(net, |column| column.eval(u))?;
                Some(Bezier::new(Closure::Open, &across).ok()?.eval(v))
            }
            Body::Bezier(_) => None,
        }
    }

    /// The derivatives at a place as in [`Surface::eval`], by the parameters of the spans.
    #[must_use]
    pub fn derivatives(&self, i: usize, j: usize, u: f64, v: f64) -> Option<Derivatives> {
        let (u, v) = (u.clamp(0.0, 1.0), v.clamp(0.0, 1.0));
        match &self.body {
            Body::Patches(_) => self.patch(i, j).map(|patch| patch.derivatives(u, v)),
            Body::Bezier(net) if (i, j) == (0, 0) => bezier_derivatives(net, u, v),
            Body::Bezier(_) => None,
        }
    }

    /// Points of the whole surface in equal steps, `per_cell` for every cell of the net; where the end spans
    /// are half as long, they have half as many. Lines between spans are there once, the closing line of a
    /// closed direction is repeated at the end.
    ///
    /// # Errors
    /// [`GeometryError::Samples`] for no steps at all or too many points.
    pub fn grid(&self, per_cell: usize) -> Result<Grid, GeometryError> {
        let lines = |direction: &Direction| -> usize {
            (0..direction.spans).map(|span| direction.steps(span, per_cell)).fold(1, usize::saturating_add)
        };
        let [rows, columns] = [lines(&self.directions[0]), lines(&self.directions[1])];
        if per_cell == 0 || rows.saturating_mul(columns) > MAX_SAMPLES {
            let [u, v] = self.directions.map(|direction| direction.spans * direction.cells);
            let most = ((MAX_SAMPLES / (u * v).max(1)) as f64).sqrt() as usize;
            return Err(GeometryError::Samples { per_span: per_cell, most: most.saturating_sub(1) });
        }
        let mut points = vec![[0.0; 3]; rows * columns];
        let mut rest = points.as_mut_slice();
        for i in 0..self.directions[0].spans {
            let steps = self.directions[0].steps(i, per_cell);
            let last = i + 1 == self.directions[0].spans;
            for step in 0..steps + usize::from(last) {
                let (row, below) = rest.split_at_mut(columns.min(rest.len()));
                self.line(i, step as f64 / steps as f64, per_cell, row);
                rest = below;
            }
        }
        Ok(Grid::new(rows, columns, points, self.closed()))
    }

    /// The middles between the lines of [`Surface::grid`] in a direction (0 is `u`, 1 is `v`): span and
    /// parameter, one less than there are lines.
    #[must_use]
    pub fn line_places(&self, direction: usize, per_cell: usize) -> Vec<(usize, f64)> {
        let Some(direction) = self.directions.get(direction) else { return Vec::new() };
        (0..direction.spans)
            .flat_map(|span| {
                let steps = direction.steps(span, per_cell);
                (0..steps).map(move |step| (span, (step as f64 + 0.5) / steps as f64))
            })
            .collect()
    }

    /// The points of one line of constant `u`.
    fn line(&self, i: usize, u: f64, per_cell: usize, row: &mut [Point<3>]) {
        let direction = &self.directions[1];
        match &self.body {
            Body::Patches(_) => {
                let mut first = 0;
                for j in 0..direction.spans {
                    let steps = direction.steps(j, per_cell);
                    // The joint is written by both spans; they agree.
                    if let (Some(patch), Some(out)) = (self.patch(i, j), row.get_mut(first..=first + steps)) {
                        patch.across(u).sample_into(out);
                    }
                    first += steps;
                }
            }
            Body::Bezier(net) => {
                let across = columns_at(net, |column| column.eval(u));
                if let Some(Ok(arc)) = across.map(|points| Bezier::new(Closure::Open, &points)) {
                    let steps = row.len().saturating_sub(1).max(1) as f64;
                    for (step, point) in row.iter_mut().enumerate() {
                        *point = arc.eval(step as f64 / steps);
                    }
                }
            }
        }
    }

    /// Rows of samples for tables: spans (i, j), parameters in them, the point; every span in `per_span`
    /// equal steps, u = 0, 1/n, ... 1, spans in the order of `i`, then `j`, then `u`, then `v`.
    ///
    /// # Errors
    /// [`GeometryError::Samples`] for no steps at all or too many points.
    pub fn sample(&self, per_span: usize) -> Result<Vec<SurfaceSample>, GeometryError> {
        let [rows, columns] = self.spans();
        let most = ((MAX_SAMPLES / (rows * columns).max(1)) as f64).sqrt() as usize;
        if per_span == 0 || per_span >= most {
            return Err(GeometryError::Samples { per_span, most: most.saturating_sub(1) });
        }
        let mut samples = Vec::with_capacity(rows * columns * (per_span + 1) * (per_span + 1));
        let at = |step: usize| step as f64 / per_span as f64;
        for i in 0..rows {
            for j in 0..columns {
                for (a, b) in (0..=per_span).flat_map(|a| (0..=per_span).map(move |b| (a, b))) {
                    let (u, v) = (at(a), at(b));
                    if let Some(point) = self.eval(i, j, u, v) {
                        samples.push(SurfaceSample { spans: [i, j], parameters: [u, v], point });
                    }
                }
            }
        }
        Ok(samples)
    }

    /// A box that holds the surface: that of its Bézier points.
    #[must_use]
    pub fn bounding_box(&self) -> Option<BoundingBox<3>> {
        let boxes = |points: &mut dyn Iterator<Item = Point<3>>| {
            points.map(BoundingBox::of_point).reduce(BoundingBox::union)
        };
        match &self.body {
            Body::Patches(patches) => {
                boxes(&mut patches.iter().flat_map(|patch| patch.p.into_iter().flatten()))
            }
            Body::Bezier(net) => boxes(&mut net.iter().flatten().copied()),
        }
    }
}

/// A sampled point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceSample {
    /// The spans along u and v, from 0.
    pub spans: [usize; 2],
    /// The parameters u and v in them, 0 to 1.
    pub parameters: [f64; 2],
    /// The point.
    pub point: Point<3>,
}

fn check_net(net: &[Vec<Point<3>>]) -> Result<(), GeometryError> {
    let needed = net.first().map_or(0, Vec::len);
    for (row, points) in net.iter().enumerate() {
        if points.len() != needed {
            return Err(GeometryError::Ragged { row, given: points.len(), needed });
        }
    }
    check_points(&net.concat())
}

fn four_by_four(net: &[Vec<Point<3>>]) -> Option<[[Point<3>; 4]; 4]> {
    let rows: [&Vec<Point<3>>; 4] = net.iter().collect::<Vec<_>>().try_into().ok()?;
    let mut p = [[[0.0; 3]; 4]; 4];
    for (to, from) in p.iter_mut().zip(rows) {
        *to = from.as_slice().try_into().ok()?;
    }
    Some(p)
}

/// A value of the curve that every column of a Bézier net is.
fn columns_at(net: &[Vec<Point<3>>], value: impl Fn(&Bezier<3>) -> Point<3>) -> Option<Vec<Point<3>>> {
    let columns = net.first().map_or(0, Vec::len);
    (0..columns)
        .map(|l| {
            let column: Option<Vec<_>> = net.iter().map(|row| row.get(l).copied()).collect();
            Some(value(&Bezier::new(Closure::Open, &column?).ok()?))
        })
        .collect()
}

fn bezier_derivatives(net: &[Vec<Point<3>>], u: f64, v: f64) -> Option<Derivatives> {
    let row =
        |value: &dyn Fn(&Bezier<3>) -> Point<3>| Bezier::new(Closure::Open, &columns_at(net, value)?).ok();
    let (at, by_u, by_uu) =
        (row(&|c| c.eval(u))?, row(&|c| c.derivative(u))?, row(&|c| c.second_derivative(u))?);
    Some(Derivatives {
        point: at.eval(v),
        u: by_u.eval(v),
        v: at.derivative(v),
        uu: by_uu.eval(v),
        uv: by_u.derivative(v),
        vv: at.second_derivative(v),
    })
}
