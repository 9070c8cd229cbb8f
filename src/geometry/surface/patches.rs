//! Surfaces of bicubic patches, and the Bézier surface by all points.

use super::scheme::{Direction, Scheme, Topology};
use super::{BSplineSurface, Derivatives, ParamSurface, Patch, exact, weave};
use crate::geometry::param::{ParamCurve, clipped};
use crate::geometry::point::{check_count, check_points, within_limit};
use crate::geometry::{Bezier, BoundingBox, Closure, GeometryError, Method, Point};

/// A surface: a grid of patches.
///
/// ```
/// use grafika::geometry::{Method, ParamSurface, Scheme, Surface, Topology};
///
/// let net: Vec<Vec<[f64; 3]>> =
///     (0..5).map(|k| (0..4).map(|l| [f64::from(k), f64::from(l), f64::from(k * l)]).collect()).collect();
/// let surface = Surface::new(Scheme::new(Method::Spline, Topology::Open), &net)?;
/// assert_eq!(surface.spans(), [4, 3]);
/// assert_eq!(surface.eval([2, 1], [0.0, 0.0]), Some(net[2][1]));
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

    /// How long the spans of a direction are in the parameter: 1, but one half for the end spans of a
    /// quadratic B-spline between borders. Direction 0 is `u`, 1 is `v`.
    #[must_use]
    pub fn lengths(&self, direction: usize) -> Vec<f64> {
        self.directions.get(direction).map_or_else(Vec::new, Direction::lengths)
    }

    /// What the surface is joined by.
    #[must_use]
    pub fn topology(&self) -> Topology {
        self.topology
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
}

impl ParamSurface for Surface {
    fn spans(&self) -> [usize; 2] {
        self.directions.map(|direction| direction.spans)
    }

    fn closed(&self) -> [bool; 2] {
        self.directions.map(|direction| direction.closed)
    }

    fn at(&self, [i, j]: [usize; 2], uv: [f64; 2]) -> Option<Derivatives> {
        let [u, v] = uv.map(clipped);
        match &self.body {
            Body::Patches(_) => self.patch(i, j).map(|patch| patch.derivatives(u, v)),
            Body::Bezier(net) if (i, j) == (0, 0) => bezier_derivatives(net, u, v),
            Body::Bezier(_) => None,
        }
    }

    fn eval(&self, [i, j]: [usize; 2], uv: [f64; 2]) -> Option<Point<3>> {
        let [u, v] = uv.map(clipped);
        match &self.body {
            Body::Patches(_) => self.patch(i, j).map(|patch| patch.eval(u, v)),
            Body::Bezier(net) if (i, j) == (0, 0) => {
                let across = columns_at(net, |column| column.eval(u))?;
                Some(Bezier::new(Closure::Open, &across).ok()?.eval(v))
            }
            Body::Bezier(_) => None,
        }
    }

    /// Half as many where the end spans are half as long; a Bézier net has one span for all of its cells.
    fn steps(&self, direction: usize, span: usize, per_cell: usize) -> usize {
        self.directions.get(direction).map_or(per_cell, |direction| direction.steps(span, per_cell))
    }

    /// That of the control points.
    fn patch_bounds(&self, [i, j]: [usize; 2]) -> Option<BoundingBox<3>> {
        match &self.body {
            Body::Patches(_) => BoundingBox::around(self.patch(i, j)?.p.into_iter().flatten()),
            Body::Bezier(net) => BoundingBox::around(net.iter().flatten().copied()),
        }
    }

    fn row(&self, i: usize, u: f64, per_cell: usize, row: &mut [Point<3>]) {
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
                    arc.sample_span(0, row);
                }
            }
        }
    }

    /// The box of the Bézier points.
    fn bounding_box(&self) -> Option<BoundingBox<3>> {
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

    /// The whole surface. A span is as long in its parameters as [`Surface::lengths`] says; seams and poles are
    /// closed exactly, where they are closed but for rounding.
    fn to_bspline(&self) -> Option<BSplineSurface> {
        Some(match &self.body {
            Body::Patches(patches) => exact::of_patches(patches, self.directions),
            Body::Bezier(net) => exact::of_bezier(net),
        })
    }
}

/// The checks on every net of control points.
///
/// # Errors
/// [`GeometryError::Ragged`] and those of [`check_points`].
pub(in crate::geometry) fn check_net(net: &[Vec<Point<3>>]) -> Result<(), GeometryError> {
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
