//! A family with a number of control points: the blending functions.

use super::super::jet::Jet;
use super::super::param::clipped;
use super::super::point::check_count;
use super::super::{Basis, GeometryError};
use super::family::Family;
use super::lambda::{self, Parts};
use super::{cyclic, trig, waves};
use std::f64::consts::TAU;

/// The blending functions of a family for a number of control points.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapedBasis {
    family: Family,
    points: usize,
    closed: bool,
}

impl ShapedBasis {
    /// The functions of a family for `points` control points. Cyclic curves are closed whatever `closed` says.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for a parameter out of range, a closed Bézier curve, or a cyclic curve with
    /// another number of points than an odd one; [`GeometryError::WrongCount`] for other numbers of a
    /// Bézier curve; too few or too many points.
    pub fn new(family: Family, points: usize, closed: bool) -> Result<Self, GeometryError> {
        family.check(points)?;
        let exactly = match &family {
            Family::FBezier { .. } => Some(4),
            Family::Trig(trig) => Some(trig.sides().iter().sum::<usize>() + 1),
            _ => None,
        };
        match (exactly, &family) {
            (Some(needed), _) if points != needed => {
                return Err(GeometryError::WrongCount { given: points, needed });
            }
            (Some(_), _) if closed => {
                let (name, wanted) = ("closed", "0: a Bézier curve is open");
                return Err(GeometryError::Parameter { name, value: 1.0, wanted });
            }
            (None, Family::Cyclic) => {
                cyclic::check(points)?;
            }
            (None, Family::HanQuadratic { .. }) => check_count(points, 3)?,
            (None, _) => check_count(points, if closed { 3 } else { 4 })?,
            (Some(_), _) => {}
        }
        let closed = closed || family == Family::Cyclic;
        Ok(Self { family, points, closed })
    }

    /// The family.
    #[must_use]
    pub fn family(&self) -> &Family {
        &self.family
    }

    /// Span and parameter of a position as files and commands have it: 0 to 1 on Bézier curves, span + parameter on
    /// splines, the angle 0 to 2 pi on cyclic curves. Positions beyond the ends are the ends.
    #[must_use]
    pub fn place(&self, position: f64) -> (usize, f64) {
        let spans = self.spans();
        let scaled = if self.family == Family::Cyclic { position / TAU * spans as f64 } else { position };
        let inside = if scaled > 0.0 { scaled.min(spans as f64) } else { 0.0 };
        let span = (inside as usize).min(spans.saturating_sub(1));
        (span, inside - span as f64)
    }

    /// The position of a place, the inverse of [`ShapedBasis::place`].
    #[must_use]
    pub fn position(&self, span: usize, x: f64) -> f64 {
        let place = span as f64 + x;
        if self.family == Family::Cyclic { place * TAU / self.spans() as f64 } else { place }
    }

    /// The weights of a lambda spline in two parts; `None` for others.
    pub(super) fn parts(&self, span: usize, x: f64) -> Option<Parts> {
        let Family::Lambda { kind, lambda } = &self.family else { return None };
        let at = |index: usize| lambda.of(index % self.points);
        (span < self.spans()).then(|| lambda::parts(*kind, [at(span + 1), at(span + 2)], clipped(x)))
    }
}

impl Basis for ShapedBasis {
    fn points(&self) -> usize {
        self.points
    }

    fn spans(&self) -> usize {
        match self.family {
            Family::FBezier { .. } | Family::Trig(_) => 1,
            _ if self.closed => self.points,
            Family::HanQuadratic { .. } => self.points - 2,
            _ => self.points - 3,
        }
    }

    fn closed(&self) -> bool {
        self.closed
    }

    fn weights(&self, span: usize, u: f64, out: &mut Vec<[f64; 3]>) -> Option<usize> {
        if span >= self.spans() {
            return None;
        }
        let x = clipped(u);
        out.clear();
        let mut add = |jets: &[Jet]| out.extend(jets.iter().map(|jet| jet.0));
        match &self.family {
            Family::FBezier { omega } => add(&waves::bezier(*omega, x)),
            Family::FBSpline { omega } => add(&waves::b_spline(*omega, x)),
            Family::Trig(trig) => add(&trig.weights(x)),
            Family::HanQuadratic { lambda } => add(&trig::han_quadratic(*lambda, x)),
            Family::Lambda { .. } => {
                let Parts { spline, line } = self.parts(span, x)?;
                add(&std::array::from_fn::<_, 4, _>(|i| spline[i] + line[i]));
            }
            Family::Cyclic => {
                out.extend(cyclic::weights(self.points / 2, span, x).map(|jet| jet.0));
                return Some(0);
            }
        }
        Some(span)
    }
}
