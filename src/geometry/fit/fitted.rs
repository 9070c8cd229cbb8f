//! A net as the control points of a surface or a curve.

use super::FitError;
use super::axis::Axis;
use crate::geometry::Point;
use crate::geometry::knots::{KnotCurve, KnotSurface};
use crate::geometry::kohonen::{Net, Topology};

/// What a net becomes: a bicubic surface, or a cubic curve if it is a polygon.
///
/// Rows of neurons run along `u`, columns along `v`, both from 0 to 1. Open directions are clamped with uniform knots,
/// closed ones periodic. A net of the topology of a sphere becomes a surface that is clamped along `u`, from pole to pole,
/// and periodic along `v`: its first and its last row of control points are one point each. The surface passes through
/// the poles, where its tangent plane is as good as the points say.
#[derive(Clone, Debug, PartialEq)]
pub enum Fitted {
    /// Of a net of one row or one column.
    Curve(KnotCurve<3>),
    /// Of any other net.
    Surface(KnotSurface),
}

/// The directions of a net; errors where it is too small.
pub(super) fn axes(topology: Topology, size: [usize; 2]) -> Result<[Axis; 2], FitError> {
    let [closed_u, closed_v] = topology.closed();
    let [u, v] = [Axis::new(size[0], closed_u)?, Axis::new(size[1], closed_v)?];
    match (u, v) {
        (Some(u), Some(v)) if !(u.is_point() && v.is_point()) => Ok([u, v]),
        _ => Err(FitError::Net { given: size }),
    }
}

impl Fitted {
    /// The base surface of a net: its neurons are the control points.
    ///
    /// # Errors
    /// [`FitError::Net`] for a net with fewer than 4 rows or columns that is no polygon.
    pub fn of_net(net: &Net) -> Result<Self, FitError> {
        Self::of(&axes(net.topology(), net.size())?, &net.rows().concat())
    }

    /// The surface of control points in the order of the net.
    pub(super) fn of(axes: &[Axis; 2], nodes: &[Point<3>]) -> Result<Self, FitError> {
        let [m, n] = [axes[0].count(), axes[1].count()];
        // A knot vector counts control points by where their functions begin.
        let order = |axis: &Axis| -> Vec<usize> { (0..axis.count()).map(|e| axis.node(e)).collect() };
        let (rows, columns) = (order(&axes[0]), order(&axes[1]));
        let point = |i: usize, j: usize| nodes.get(i * n + j).copied().unwrap_or([0.0; 3]);
        if m == 1 || n == 1 {
            let vector = axes[usize::from(m == 1)].knots()?;
            let points = rows.iter().flat_map(|i| columns.iter().map(|j| point(*i, *j))).collect();
            return Ok(Self::Curve(KnotCurve::new(vector, points)?));
        }
        let net = rows.iter().map(|i| columns.iter().map(|j| point(*i, *j)).collect()).collect();
        Ok(Self::Surface(KnotSurface::new([axes[0].knots()?, axes[1].knots()?], net, None)?))
    }

    /// The surface, if it is one.
    #[must_use]
    pub fn surface(&self) -> Option<&KnotSurface> {
        match self {
            Self::Surface(surface) => Some(surface),
            Self::Curve(_) => None,
        }
    }

    /// The curve, if it is one.
    #[must_use]
    pub fn curve(&self) -> Option<&KnotCurve<3>> {
        match self {
            Self::Curve(curve) => Some(curve),
            Self::Surface(_) => None,
        }
    }
}
