//! The kinds of curves with shape parameters, and which numbers of each may be moved.

use super::super::GeometryError;
use super::lambda::{LambdaKind, Lambdas};
use super::trig::Trig;
use super::waves::OMEGA;
use std::f64::consts::PI;

/// A kind of curve with its shape parameters.
#[derive(Clone, Debug, PartialEq)]
pub enum Family {
    /// C- and F-Bézier curves of four points, by `omega` within [`OMEGA`]; see [`Family::c_bezier`].
    FBezier {
        /// `alpha^2` for waves, 0 for the cubic curve, negative for hyperbolic functions.
        omega: f64,
    },
    /// Uniform C- and F-B-splines, twice continuously differentiable.
    FBSpline {
        /// As for [`Family::FBezier`].
        omega: f64,
    },
    /// Generalized trigonometric Bézier curves.
    Trig(Trig),
    /// Uniform cubic B-splines with a lambda.
    Lambda {
        /// What lambda does.
        kind: LambdaKind,
        /// How much.
        lambda: Lambdas,
    },
    /// Han's quadratic trigonometric spline, arcs of three points, once continuously differentiable (Han 2002).
    HanQuadratic {
        /// -1 to 1.
        lambda: f64,
    },
    /// The cyclic curve of an odd number of points; always closed, no parameter.
    Cyclic,
}

/// A number of a family that may be moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// `alpha` of C-curves in (0, pi], or of trigonometric Bézier curves.
    Alpha,
    /// `beta` of trigonometric Bézier curves.
    Beta,
    /// `omega` of F-curves.
    Omega,
    /// The lambda of the whole curve; single ones become equal.
    Lambda,
    /// The lambda of one control point, from 0 (Han and GB).
    LambdaOf(usize),
}

impl Parameter {
    /// Its name, as errors give it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Alpha => "alpha",
            Self::Beta => "beta",
            Self::Omega => "omega",
            Self::Lambda | Self::LambdaOf(_) => "lambda",
        }
    }
}

/// The square of an angle in (0, pi].
fn squared(alpha: f64) -> Result<f64, GeometryError> {
    if alpha > 0.0 && alpha <= PI {
        return Ok(alpha * alpha);
    }
    Err(GeometryError::Parameter { name: "alpha", value: alpha, wanted: "larger than 0 and at most pi" })
}

impl Family {
    /// The C-Bézier curve on [0, alpha] (definition 2.11).
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for an `alpha` outside (0, pi].
    pub fn c_bezier(alpha: f64) -> Result<Self, GeometryError> {
        Ok(Self::FBezier { omega: squared(alpha)? })
    }

    /// The uniform C-B-spline with spans of `alpha`.
    ///
    /// # Errors
    /// As [`Family::c_bezier`].
    pub fn c_b_spline(alpha: f64) -> Result<Self, GeometryError> {
        Ok(Self::FBSpline { omega: squared(alpha)? })
    }

    /// The check of the parameters that are fields, for a number of control points.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for a value out of range, or lambdas of another number than points.
    pub fn check(&self, points: usize) -> Result<(), GeometryError> {
        let bad = |name, value, wanted| Err(GeometryError::Parameter { name, value, wanted });
        match self {
            Self::FBezier { omega } | Self::FBSpline { omega } if !(OMEGA[0]..=OMEGA[1]).contains(omega) => {
                bad("omega", *omega, "a number from -900 to pi^2")
            }
            Self::HanQuadratic { lambda } if !(-1.0..=1.0).contains(lambda) => {
                bad("lambda", *lambda, "a number from -1 to 1")
            }
            Self::Lambda { kind, lambda } => lambda.check(*kind, points),
            _ => Ok(()),
        }
    }

    /// The value of a parameter; `None` where the family does not have it, or has several lambdas.
    #[must_use]
    pub fn value(&self, parameter: Parameter) -> Option<f64> {
        match (self, parameter) {
            (Self::FBezier { omega } | Self::FBSpline { omega }, Parameter::Omega) => Some(*omega),
            (Self::FBezier { omega } | Self::FBSpline { omega }, Parameter::Alpha) => {
                (*omega >= 0.0).then(|| omega.sqrt())
            }
            (Self::Trig(trig), Parameter::Alpha) => Some(trig.alpha),
            (Self::Trig(trig), Parameter::Beta) => Some(trig.beta),
            (
                Self::Lambda { lambda: Lambdas::One(lambda), .. } | Self::HanQuadratic { lambda },
                Parameter::Lambda,
            ) => Some(*lambda),
            (Self::Lambda { lambda: Lambdas::Each(all), .. }, Parameter::LambdaOf(index)) => {
                all.get(index).copied()
            }
            (Self::Lambda { lambda: Lambdas::One(lambda), kind }, Parameter::LambdaOf(_)) => {
                matches!(kind, LambdaKind::Han | LambdaKind::Gb).then_some(*lambda)
            }
            _ => None,
        }
    }

    /// Whether points of the curve move on straight lines while its parameter moves.
    #[must_use]
    pub fn paths_are_straight(&self) -> bool {
        matches!(self, Self::Lambda { .. } | Self::HanQuadratic { .. })
    }

    /// That the family does not have a parameter, and which it has.
    pub(super) fn lacks(&self, parameter: Parameter) -> GeometryError {
        let name = match parameter {
            Parameter::LambdaOf(_) => "lambda:K",
            other => other.name(),
        };
        let known = match self {
            Self::FBezier { .. } | Self::FBSpline { .. } => "alpha and omega",
            Self::Trig(_) => "alpha and beta",
            Self::Lambda { kind: LambdaKind::Han | LambdaKind::Gb, .. } => "lambda and lambda:K",
            Self::Lambda { .. } | Self::HanQuadratic { .. } => "lambda",
            Self::Cyclic => "",
        };
        GeometryError::NoParameter { name, known }
    }

    /// The family with another value of a parameter, for curves of `points` control points.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] for a value out of range, [`GeometryError::NoParameter`] for a parameter that the
    /// family does not have, [`GeometryError::NoControlPoint`] for the lambda of a point that is not there.
    pub fn with(&self, parameter: Parameter, value: f64, points: usize) -> Result<Self, GeometryError> {
        let family = match (self, parameter) {
            (Self::FBezier { .. }, Parameter::Alpha) => Self::c_bezier(value)?,
            (Self::FBSpline { .. }, Parameter::Alpha) => Self::c_b_spline(value)?,
            (Self::FBezier { .. }, Parameter::Omega) => Self::FBezier { omega: value },
            (Self::FBSpline { .. }, Parameter::Omega) => Self::FBSpline { omega: value },
            (Self::Trig(trig), Parameter::Alpha | Parameter::Beta) => {
                let ([n1, n2], [alpha, beta]) = (trig.sides(), trig.exponents());
                let [alpha, beta] =
                    if parameter == Parameter::Alpha { [value, beta] } else { [alpha, value] };
                Self::Trig(Trig::new(n1, n2, alpha, beta, trig.phi())?)
            }
            (Self::HanQuadratic { .. }, Parameter::Lambda) => Self::HanQuadratic { lambda: value },
            (Self::Lambda { kind, .. }, Parameter::Lambda) => {
                Self::Lambda { kind: *kind, lambda: Lambdas::One(value) }
            }
            (
                Self::Lambda { kind: kind @ (LambdaKind::Han | LambdaKind::Gb), lambda },
                Parameter::LambdaOf(i),
            ) if i < points => {
                let mut all: Vec<f64> = (0..points).map(|index| lambda.of(index)).collect();
                all[i] = value;
                Self::Lambda { kind: *kind, lambda: Lambdas::Each(all) }
            }
            (Self::Lambda { kind: LambdaKind::Han | LambdaKind::Gb, .. }, Parameter::LambdaOf(index)) => {
                return Err(GeometryError::NoControlPoint { index, count: points });
            }
            _ => return Err(self.lacks(parameter)),
        };
        family.check(points)?;
        Ok(family)
    }
}
