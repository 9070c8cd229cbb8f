//! Curves by their knots as documents, and back, and their named edits.

pub mod edit;

use super::DesignError;
use crate::file::{KnotPoints, Places};
use crate::geometry::Point;
use crate::geometry::knots::{KnotCurve, KnotError};

/// A curve of the plane or in space.
#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// Of the plane.
    Plane(KnotCurve<2>),
    /// In space.
    Space(KnotCurve<3>),
}

/// The curve of a document.
///
/// # Errors
/// [`DesignError::Unfinished`] for fewer points than the order, and those of the geometry.
pub fn curve(document: &KnotPoints) -> Result<Curve, DesignError> {
    if !document.is_curve() {
        return Err(DesignError::Unfinished { points: document.points.len(), order: document.order });
    }
    Ok(match &document.points {
        Places::Plane(points) => Curve::Plane(of_points(document, points)?),
        Places::Space(points) => Curve::Space(of_points(document, points)?),
    })
}

fn of_points<const D: usize>(document: &KnotPoints, points: &[Point<D>]) -> Result<KnotCurve<D>, KnotError> {
    let vector = document.vector()?;
    match &document.weights {
        Some(weights) => KnotCurve::rational(vector, points.to_vec(), weights.clone()),
        None => KnotCurve::new(vector, points.to_vec()),
    }
}

/// The document of a curve.
#[must_use]
pub fn document<const D: usize>(curve: &KnotCurve<D>) -> KnotPoints
where
    Places: From<Vec<Point<D>>>,
{
    let vector = curve.vector();
    KnotPoints {
        order: vector.order(),
        closed: vector.breaks().is_some(),
        points: curve.points().to_vec().into(),
        weights: curve.weights().map(<[f64]>::to_vec),
        knots: vector.breaks().unwrap_or(vector.knots()).to_vec(),
    }
}
