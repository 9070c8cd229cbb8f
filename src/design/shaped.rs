//! Curves with shape parameters as documents, and back.

use super::DesignError;
use crate::file::{Places, ShapedPoints};
use crate::geometry::shaped::ShapedCurve;
use crate::geometry::{GeometryError, Point};

/// A curve of the plane or in space.
#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// Of the plane.
    Plane(ShapedCurve<2>),
    /// In space.
    Space(ShapedCurve<3>),
}

/// The curve of a document.
///
/// # Errors
/// Those of [`ShapedCurve::new`] and [`ShapedCurve::with_blend`].
pub fn curve(document: &ShapedPoints) -> Result<Curve, DesignError> {
    Ok(match &document.points {
        Places::Plane(points) => {
            Curve::Plane(of_points(document, points, document.blend.as_ref().and_then(Places::plane))?)
        }
        Places::Space(points) => {
            Curve::Space(of_points(document, points, document.blend.as_ref().and_then(Places::space))?)
        }
    })
}

fn of_points<const D: usize>(
    document: &ShapedPoints,
    points: &[Point<D>],
    blend: Option<&[Point<D>]>,
) -> Result<ShapedCurve<D>, GeometryError> {
    let curve = ShapedCurve::new(document.parameters()?, points.to_vec(), document.closed)?;
    match blend {
        Some(blend) => curve.with_blend(blend.to_vec()),
        None => Ok(curve),
    }
}
