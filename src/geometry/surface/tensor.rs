//! Surfaces by two bases, one a direction.

use super::{Derivatives, Grid, ParamSurface};
use crate::geometry::basis::{blended, summed};
use crate::geometry::point::check_points;
use crate::geometry::{Basis, GeometryError, Point};

/// A surface: a net of control points blended by one basis along `u` and another along `v`, "weights along `u` times
/// the net times weights along `v`".
///
/// Every place is computed from the weights. Nets of the book's methods become patches, with poles, borders and an
/// exact form, in [`Surface`](super::Surface); this is for bases that are not cubic.
///
/// ```
/// use grafika::geometry::{Closure, Method, ParamSurface, Weave, Weights};
///
/// let along = Weights::new(Method::BSpline3, Closure::Open, 4)?;
/// let net = (0..4).map(|k| (0..4).map(|l| [f64::from(k), f64::from(l), f64::from(k * l)]).collect()).collect();
/// let surface = Weave::new(&along, &along, net)?;
/// assert_eq!(surface.spans(), [5, 5]);
/// assert_eq!(surface.eval([4, 4], [1.0, 1.0]), Some([3.0, 3.0, 9.0]));
/// # Ok::<(), grafika::geometry::GeometryError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Weave<U, V> {
    u: U,
    v: V,
    /// Row `k` is the points of constant `u`, point `l` of it counts in `v`.
    net: Vec<Vec<Point<3>>>,
}

/// Weights with their derivatives, and the number of the first point that they are for.
type Seen = (usize, Vec<[f64; 3]>);

impl<U: Basis, V: Basis> Weave<U, V> {
    /// The surface of a net: as many rows as the basis along `u` has points, and as many points in each as that
    /// along `v`. Closed directions do not repeat a row.
    ///
    /// # Errors
    /// [`GeometryError::WrongCount`] for another number of rows, [`GeometryError::Ragged`] for a row of another
    /// number of points, or a bad coordinate.
    pub fn new(u: U, v: V, net: Vec<Vec<Point<3>>>) -> Result<Self, GeometryError> {
        if net.len() != u.points() {
            return Err(GeometryError::WrongCount { given: net.len(), needed: u.points() });
        }
        let needed = v.points();
        if let Some(row) = net.iter().position(|points| points.len() != needed) {
            return Err(GeometryError::Ragged { row, given: net[row].len(), needed });
        }
        net.iter().try_for_each(|row| check_points(row))?;
        Ok(Self { u, v, net })
    }

    /// What the points are blended by along u and along v.
    #[must_use]
    pub fn bases(&self) -> [&dyn Basis; 2] {
        [&self.u, &self.v]
    }

    /// The control points.
    #[must_use]
    pub fn net(&self) -> &[Vec<Point<3>>] {
        &self.net
    }

    fn seen(basis: &impl Basis, span: usize, u: f64) -> Option<Seen> {
        let mut weights = Vec::new();
        basis.weights(span, u, &mut weights).map(|first| (first, weights))
    }

    /// The column of the net at `l`, blended along `u`: the point and its derivatives.
    fn column(&self, (first, weights): &Seen, l: usize) -> [Point<3>; 3] {
        let points = self.net.iter().cycle().skip(*first).filter_map(|row| row.get(l));
        blended(weights, points.copied())
    }
}

impl<U: Basis, V: Basis> ParamSurface for Weave<U, V> {
    fn spans(&self) -> [usize; 2] {
        [self.u.spans(), self.v.spans()]
    }

    fn closed(&self) -> [bool; 2] {
        [self.u.closed(), self.v.closed()]
    }

    fn at(&self, [i, j]: [usize; 2], [u, v]: [f64; 2]) -> Option<Derivatives> {
        let (along_u, (first, along_v)) = (Self::seen(&self.u, i, u)?, Self::seen(&self.v, j, v)?);
        let count = self.v.points();
        let columns: Vec<[Point<3>; 3]> =
            (0..along_v.len()).map(|l| self.column(&along_u, (first + l) % count)).collect();
        let derived = |order: usize| blended(&along_v, columns.iter().map(|column| column[order]));
        let ([point, v, vv], [u, uv, _], [uu, ..]) = (derived(0), derived(1), derived(2));
        Some(Derivatives { point, u, v, uu, uv, vv })
    }

    fn eval(&self, [i, j]: [usize; 2], [u, v]: [f64; 2]) -> Option<Point<3>> {
        let [along_u, along_v] = [Values::of(&self.u, i, u)?, Values::of(&self.v, j, v)?];
        let count = self.v.points();
        let line =
            (0..along_v.values.len()).map(|l| self.blended_column(&along_u, (along_v.first + l) % count));
        Some(summed(&along_v.values, line))
    }

    /// The columns of the net are blended once for the whole line.
    fn row(&self, i: usize, u: f64, per_cell: usize, row: &mut [Point<3>]) {
        let Some(along_u) = Values::of(&self.u, i, u) else { return };
        self.blend_row(&along_u, &Values::table(&self.v, per_cell), row);
    }

    /// The values along `v` are computed once for all lines.
    fn grid(&self, per_cell: usize) -> Result<Grid, GeometryError> {
        self.grid_size(per_cell)?;
        Ok(self.mesh([per_cell; 2]))
    }

    fn each_row(&self, per_cell: usize, each: &mut dyn FnMut(&[Point<3>])) -> Result<(), GeometryError> {
        let [_, columns] = self.grid_size(per_cell)?;
        let [u, v] = [Values::table(&self.u, per_cell.max(1)), Values::table(&self.v, per_cell.max(1))];
        let mut row = vec![[0.0; 3]; columns];
        for along_u in &u {
            self.blend_row(along_u, &v, &mut row);
            each(&row);
        }
        Ok(())
    }
}

/// The values of the functions at a place, and the number of the first point that they are for.
struct Values {
    first: usize,
    values: Vec<f64>,
}

impl Values {
    fn of(basis: &impl Basis, span: usize, u: f64) -> Option<Self> {
        let mut values = Vec::new();
        let first = basis.values(span, u, &mut values)?;
        Some(Self { first, values })
    }

    /// Those of equal steps through all spans; where spans meet, those of the span that begins there.
    fn table(basis: &impl Basis, per_span: usize) -> Vec<Self> {
        let steps = per_span.max(1) as f64;
        let spans = basis.spans();
        let end = (spans > 0).then(|| (spans - 1, 1.0));
        let places = (0..spans).flat_map(|span| (0..per_span).map(move |step| (span, step as f64 / steps)));
        places.chain(end).filter_map(|(span, u)| Self::of(basis, span, u)).collect()
    }
}

impl<U: Basis, V: Basis> Weave<U, V> {
    /// The points in equal steps of every span along u and along v, at least one step in either direction.
    #[must_use]
    pub fn mesh(&self, steps: [usize; 2]) -> Grid {
        let [u, v] = [Values::table(&self.u, steps[0].max(1)), Values::table(&self.v, steps[1].max(1))];
        let mut points = vec![[0.0; 3]; u.len() * v.len()];
        for (along_u, row) in u.iter().zip(points.chunks_mut(v.len().max(1))) {
            self.blend_row(along_u, &v, row);
        }
        Grid::new(u.len(), v.len(), points, self.closed())
    }

    fn blend_row(&self, along_u: &Values, table: &[Values], row: &mut [Point<3>]) {
        let line: Vec<Point<3>> = (0..self.v.points()).map(|l| self.blended_column(along_u, l)).collect();
        for (point, along_v) in row.iter_mut().zip(table) {
            *point = summed(&along_v.values, line.iter().cycle().skip(along_v.first).copied());
        }
    }

    /// The column of the net at `l`, blended along `u`.
    fn blended_column(&self, along_u: &Values, l: usize) -> Point<3> {
        let points = self.net.iter().cycle().skip(along_u.first).filter_map(|row| row.get(l));
        summed(&along_u.values, points.copied())
    }
}
