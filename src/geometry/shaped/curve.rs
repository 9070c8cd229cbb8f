//! Curves of a family and control points.

use super::super::basis::blended;
use super::super::param::ParamCurve;
use super::super::point::check_points;
use super::super::{Basis, GeometryError, Point};
use super::basis::ShapedBasis;
use super::family::{Family, Parameter};
use super::lambda::LambdaKind;

/// A curve with shape parameters.
///
/// An alpha-, GB- or SPB-spline may have a polygon of its own that is blended in; interpolating ones have it
/// ([`interpolate`](super::interpolate)).
#[derive(Clone, Debug, PartialEq)]
pub struct ShapedCurve<const D: usize> {
    basis: ShapedBasis,
    points: Vec<Point<D>>,
    blend: Option<Vec<Point<D>>>,
}

impl<const D: usize> ShapedCurve<D> {
    /// The curve of a family and control points.
    ///
    /// # Errors
    /// As [`ShapedBasis::new`], or a bad coordinate.
    pub fn new(family: Family, points: Vec<Point<D>>, closed: bool) -> Result<Self, GeometryError> {
        let basis = ShapedBasis::new(family, points.len(), closed)?;
        check_points(&points)?;
        Ok(Self { basis, points, blend: None })
    }

    /// The curve that blends in the polygon of other points than its own, as many as it has.
    ///
    /// # Errors
    /// [`GeometryError::WrongCount`] for another number, a bad coordinate, and [`GeometryError::Parameter`] for a family
    /// without a polygon: only alpha-, GB- and SPB-splines have one.
    pub fn with_blend(self, blend: Vec<Point<D>>) -> Result<Self, GeometryError> {
        let kind = match self.basis.family() {
            Family::Lambda { kind, .. } => Some(*kind),
            _ => None,
        };
        if kind.is_none_or(|kind| kind == LambdaKind::Han) {
            let (name, value) = ("the number of points of `blend`", blend.len() as f64);
            return Err(GeometryError::Parameter { name, value, wanted: "0 in this family" });
        }
        if blend.len() != self.points.len() {
            return Err(GeometryError::WrongCount { given: blend.len(), needed: self.points.len() });
        }
        check_points(&blend)?;
        Ok(Self { blend: Some(blend), ..self })
    }

    /// The blending functions.
    #[must_use]
    pub fn basis(&self) -> &ShapedBasis {
        &self.basis
    }

    /// The control points.
    #[must_use]
    pub fn points(&self) -> &[Point<D>] {
        &self.points
    }

    /// The polygon that is blended in, where it is not that of the control points.
    #[must_use]
    pub fn blend(&self) -> Option<&[Point<D>]> {
        self.blend.as_deref()
    }

    /// The same points with another value of a parameter.
    ///
    /// # Errors
    /// As [`Family::with`].
    pub fn with(&self, parameter: Parameter, value: f64) -> Result<Self, GeometryError> {
        let family = self.basis.family().with(parameter, value, self.points.len())?;
        let basis = ShapedBasis::new(family, self.points.len(), self.basis.closed())?;
        Ok(Self { basis, points: self.points.clone(), blend: self.blend.clone() })
    }

    /// Control points from the first that a span sees, round and round.
    fn seen<'a>(points: &'a [Point<D>], first: usize) -> impl Iterator<Item = Point<D>> + 'a {
        points.iter().cycle().skip(first).copied()
    }

    /// Point and derivatives where a basis of as many points takes the place of the curve's own.
    pub(super) fn at_by(&self, basis: &ShapedBasis, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        if let Some(blend) = &self.blend {
            let parts = basis.parts(span, u)?;
            let spline = blended(&parts.spline.map(|jet| jet.0), Self::seen(&self.points, span));
            let line = blended(&parts.line.map(|jet| jet.0), Self::seen(blend, span));
            return Some(std::array::from_fn(|order| {
                std::array::from_fn(|d| spline[order][d] + line[order][d])
            }));
        }
        let mut weights = Vec::new();
        let first = basis.weights(span, u, &mut weights)?;
        Some(blended(&weights, Self::seen(&self.points, first)))
    }
}

impl<const D: usize> ParamCurve<D> for ShapedCurve<D> {
    fn spans(&self) -> usize {
        self.basis.spans()
    }

    fn closed(&self) -> bool {
        self.basis.closed()
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        self.at_by(&self.basis, span, u)
    }
}
