//! Surfaces by two bases, one a direction.

use super::{Derivatives, ParamSurface};
use crate::geometry::basis::blended;
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

    /// The columns of the net are blended once for the whole line.
    fn row(&self, i: usize, u: f64, per_cell: usize, row: &mut [Point<3>]) {
        let Some(along_u) = Self::seen(&self.u, i, u) else { return };
        let line: Vec<Point<3>> = (0..self.v.points()).map(|l| self.column(&along_u, l)[0]).collect();
        let mut weights = Vec::new();
        for j in 0..self.v.spans() {
            let places = row.iter_mut().skip(j * per_cell).take(per_cell + 1);
            for (step, point) in places.enumerate() {
                if let Some(first) = self.v.weights(j, step as f64 / per_cell as f64, &mut weights) {
                    let [here, ..] = blended(&weights, line.iter().cycle().skip(first).copied());
                    *point = here;
                }
            }
        }
    }
}
