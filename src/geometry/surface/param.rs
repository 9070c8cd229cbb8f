//! What every surface can do, whatever it is made of.
//!
//! A kind of surface says how many spans it has and what it is like at a place; grids, samples, box, normals and
//! curvature are written here once, sections in [`section`](super::section()). A kind that knows a quicker or an
//! exact way overrides them. Pictures, models and editors take a `&dyn ParamSurface` and know no kinds.

use super::{BSplineSurface, Derivatives, Grid, fit, inspect};
use crate::geometry::point::norm;
use crate::geometry::{BoundingBox, GeometryError, MAX_SAMPLES, Point, dot};
use std::fmt;

/// A surface of spans along `u` (direction 0) and `v` (1), with parameters in [0, 1] in each patch of two spans.
///
/// ```
/// use grafika::geometry::{Method, ParamSurface, Scheme, Surface, Topology};
///
/// let net: Vec<Vec<[f64; 3]>> =
///     (0..5).map(|k| (0..4).map(|l| [f64::from(k), f64::from(l), f64::from(k * l)]).collect()).collect();
/// let surface: Box<dyn ParamSurface> = Box::new(Surface::new(Scheme::new(Method::Spline, Topology::Open), &net)?);
/// assert_eq!((surface.spans(), surface.closed()), ([4, 3], [false, false]));
/// assert_eq!(surface.eval([2, 1], [0.0, 0.0]), Some(net[2][1]));
/// assert_eq!(surface.grid(10)?.points().len(), 41 * 31);
/// // A saddle z = x y.
/// assert!(surface.gaussian_curvature([1, 1], [0.5, 0.5]).is_some_and(|curvature| curvature < 0.0));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
pub trait ParamSurface: fmt::Debug {
    /// The number of spans along `u` and `v`.
    fn spans(&self) -> [usize; 2];

    /// Whether the borders of `u` and of `v` are joined with each other.
    fn closed(&self) -> [bool; 2];

    /// The point of spans `[i, j]` at `[u, v]` with its derivatives by the parameters of the patch. Both are clipped
    /// to [0, 1]; `None` outside the spans. All numbers are finite.
    fn at(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<Derivatives>;

    /// The point alone.
    fn eval(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<Point<3>> {
        self.at(spans, uv).map(|at| at.point)
    }

    /// In how many steps a span of a direction is drawn where a cell of the net has `per_cell`. Here as many;
    /// another number where a span is shorter, or covers several cells of the net.
    fn steps(&self, direction: usize, span: usize, per_cell: usize) -> usize {
        let _ = (direction, span);
        per_cell
    }

    /// A box round what a patch is made of, which rounding is measured by; `None` outside the spans. Here that
    /// of nine of its points.
    fn patch_bounds(&self, spans: [usize; 2]) -> Option<BoundingBox<3>> {
        let places = [0.0, 0.5, 1.0].into_iter().flat_map(|u| [0.0, 0.5, 1.0].map(|v| [u, v]));
        let points: Option<Vec<Point<3>>> = places.map(|uv| self.eval(spans, uv)).collect();
        BoundingBox::of_points(&points?)
    }

    /// Fills `row` with the points of the line of constant `u` in span `i`, every span of `v` in
    /// [`ParamSurface::steps`]. What grids go through: a surface with a fast way to many points has it here.
    fn row(&self, i: usize, u: f64, per_cell: usize, row: &mut [Point<3>]) {
        let mut first = 0;
        for j in 0..self.spans()[1] {
            let steps = self.steps(1, j, per_cell);
            for (step, point) in row.iter_mut().skip(first).take(steps + 1).enumerate() {
                *point = self.eval([i, j], [u, step as f64 / steps as f64]).unwrap_or(*point);
            }
            first += steps;
        }
    }

    /// Points of the whole surface in equal steps, `per_cell` for every cell of the net, which is a span for most
    /// surfaces ([`ParamSurface::steps`]). Lines between spans are there once, the closing line of a closed
    /// direction is repeated at the end.
    ///
    /// # Errors
    /// [`GeometryError::Samples`] for no steps at all or too many points.
    fn grid(&self, per_cell: usize) -> Result<Grid, GeometryError> {
        let [rows, columns] = self.grid_size(per_cell)?;
        let mut points = vec![[0.0; 3]; rows * columns];
        for ((i, u), row) in rows_of(self, per_cell).zip(points.chunks_mut(columns.max(1))) {
            self.row(i, u, per_cell, row);
        }
        Ok(Grid::new(rows, columns, points, self.closed()))
    }

    /// The rows of [`ParamSurface::grid`] one after the other, in memory of one of them.
    ///
    /// # Errors
    /// As [`ParamSurface::grid`].
    fn each_row(&self, per_cell: usize, each: &mut dyn FnMut(&[Point<3>])) -> Result<(), GeometryError> {
        let [_, columns] = self.grid_size(per_cell)?;
        let mut row = vec![[0.0; 3]; columns];
        for (i, u) in rows_of(self, per_cell) {
            row.fill([0.0; 3]);
            self.row(i, u, per_cell, &mut row);
            each(&row);
        }
        Ok(())
    }

    /// The numbers of rows and columns of [`ParamSurface::grid`].
    ///
    /// # Errors
    /// As [`ParamSurface::grid`].
    fn grid_size(&self, per_cell: usize) -> Result<[usize; 2], GeometryError> {
        let spans = self.spans();
        let steps = |d: usize, per_cell: usize| {
            (0..spans[d]).map(move |span| self.steps(d, span, per_cell)).fold(0, usize::saturating_add)
        };
        let [rows, columns] = [0, 1].map(|d| steps(d, per_cell).saturating_add(1));
        if per_cell == 0 || rows.saturating_mul(columns) > MAX_SAMPLES {
            let cells = steps(0, 1).saturating_mul(steps(1, 1));
            let most = ((MAX_SAMPLES / cells.max(1)) as f64).sqrt() as usize;
            return Err(GeometryError::Samples { per_span: per_cell, most: most.saturating_sub(1) });
        }
        Ok([rows, columns])
    }

    /// The places of the lines of [`ParamSurface::grid`] in a direction: span and parameter. The line that repeats
    /// the first of a closed direction is not among them.
    fn lines(&self, direction: usize, per_cell: usize) -> Vec<(usize, f64)> {
        let (Some(&spans), Some(&closed)) = (self.spans().get(direction), self.closed().get(direction))
        else {
            return Vec::new();
        };
        let last = (!closed).then_some((spans.saturating_sub(1), 1.0));
        step_places(spans, |span| self.steps(direction, span, per_cell), 0.0).chain(last).collect()
    }

    /// The middles between the lines of [`ParamSurface::grid`] in a direction: span and parameter, one less than
    /// there are lines.
    fn line_places(&self, direction: usize, per_cell: usize) -> Vec<(usize, f64)> {
        let Some(&spans) = self.spans().get(direction) else { return Vec::new() };
        step_places(spans, |span| self.steps(direction, span, per_cell), 0.5).collect()
    }

    /// Rows of samples for tables: spans (i, j), parameters in them, the point; every span in `per_span`
    /// equal steps, u = 0, 1/n, ... 1, spans in the order of `i`, then `j`, then `u`, then `v`.
    ///
    /// # Errors
    /// [`GeometryError::Samples`] for no steps at all or too many points.
    fn sample(&self, per_span: usize) -> Result<Vec<SurfaceSample>, GeometryError> {
        surface_samples(self, per_span).map(Iterator::collect)
    }

    /// A box round the surface; `None` without spans. Here round the points of a grid, beyond which the surface
    /// may rise between them; surfaces of patches have a box that is never too small.
    fn bounding_box(&self) -> Option<BoundingBox<3>> {
        let grid = [16, 4, 1].into_iter().find_map(|steps| self.grid(steps).ok())?;
        BoundingBox::of_points(grid.points()).filter(|_| !self.spans().contains(&0))
    }

    /// The unit normal at a place as in [`ParamSurface::at`], in the direction of r_u x r_v. Where these two span
    /// no plane, as at a pole, it is the limit along a way into the patch, to about 1e-8.
    ///
    /// `None` outside the spans, and where the patch is no more than a line or a point.
    fn normal(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<Point<3>> {
        inspect::normal(&|uv| self.at(spans, uv), self.patch_bounds(spans)?, uv)
    }

    /// The Gaussian curvature at a place as in [`ParamSurface::at`], as [`Derivatives::gaussian_curvature`]; at a
    /// pole its limit along a way into the patch, to about 1e-5 of itself. Limits along other ways are the same
    /// only where the surface is smooth enough.
    ///
    /// `None` where [`ParamSurface::normal`] is, and where the curvature grows without limit.
    fn gaussian_curvature(&self, spans: [usize; 2], uv: [f64; 2]) -> Option<f64> {
        inspect::gaussian_curvature(&|uv| self.at(spans, uv), self.patch_bounds(spans)?, uv)
    }

    /// The brightness of a place in parallel light: the cosine of the angle between the normal and the
    /// direction to the light, -1 to 1. Lines of equal brightness are isophotes; they have a corner where
    /// the tangent plane is continuous, but the curvature is not.
    ///
    /// `None` where [`ParamSurface::normal`] is, and when the direction has no length.
    fn brightness(&self, spans: [usize; 2], uv: [f64; 2], light: Point<3>) -> Option<f64> {
        let length = norm(light);
        let normal = self.normal(spans, uv)?;
        let cosine = dot(normal, light.map(|x| x / length));
        cosine.is_finite().then(|| cosine.clamp(-1.0, 1.0))
    }

    /// The surface as one B-spline surface, exactly; `None` where it is none, as here.
    fn to_bspline(&self) -> Option<BSplineSurface> {
        None
    }

    /// The surface as one bicubic B-spline surface that is nowhere further from it than `tolerance`, in the unit of
    /// the points, compared at many places, which is no proof. Exact where [`ParamSurface::to_bspline`] is.
    ///
    /// # Errors
    /// A tolerance that is not positive, [`GeometryError::ToleranceTooSmall`] where many patches do not suffice.
    fn fitted_bspline(&self, tolerance: f64) -> Result<BSplineSurface, GeometryError> {
        self.to_bspline().map_or_else(|| fit::fitted(self, tolerance), Ok)
    }
}

/// The places of the rows of a grid, the closing one too.
fn rows_of(surface: &(impl ParamSurface + ?Sized), per_cell: usize) -> impl Iterator<Item = (usize, f64)> {
    let spans = surface.spans()[0];
    let end = spans.checked_sub(1).map(|last| (last, 1.0));
    step_places(spans, move |span| surface.steps(0, span, per_cell), 0.0).chain(end)
}

/// The places at a part of every step of every span.
fn step_places(
    spans: usize,
    steps: impl Fn(usize) -> usize,
    part: f64,
) -> impl Iterator<Item = (usize, f64)> {
    (0..spans).flat_map(move |span| {
        let steps = steps(span);
        (0..steps).map(move |step| (span, (step as f64 + part) / steps as f64))
    })
}

/// The samples of [`ParamSurface::sample`] one by one.
///
/// # Errors
/// As [`ParamSurface::sample`].
pub fn surface_samples(
    surface: &(impl ParamSurface + ?Sized),
    per_span: usize,
) -> Result<impl Iterator<Item = SurfaceSample>, GeometryError> {
    let [rows, columns] = surface.spans();
    let most = ((MAX_SAMPLES / (rows * columns).max(1)) as f64).sqrt() as usize;
    if per_span == 0 || per_span >= most {
        return Err(GeometryError::Samples { per_span, most: most.saturating_sub(1) });
    }
    let at = move |step: usize| step as f64 / per_span as f64;
    let patches = (0..rows).flat_map(move |i| (0..columns).map(move |j| [i, j]));
    let places = patches.flat_map(move |spans| {
        (0..=per_span).flat_map(move |a| (0..=per_span).map(move |b| (spans, [at(a), at(b)])))
    });
    Ok(places.filter_map(move |(spans, parameters)| {
        let point = surface.eval(spans, parameters)?;
        Some(SurfaceSample { spans, parameters, point })
    }))
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
