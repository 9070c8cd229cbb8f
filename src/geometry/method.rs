//! The methods that make a curve from control points, their names, parameters and ends.

use super::GeometryError;

/// Whether a curve has two ends or returns to its beginning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Closure {
    /// From the first control point (or near it) to the last.
    Open,
    /// The first control point follows the last; smooth at the seam too.
    Closed,
}

/// What the windows of a method see beyond the first and the last control point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ends {
    /// The method's own rule for open curves: always from the first to the last control point
    /// exactly (2.15, 2.24, 2.65; end points doubled for quadratic, tripled for cubic B-splines).
    Open,
    /// Cyclic: the first control point follows the last (2.37, 2.55, 2.66).
    Closed,
    /// End points taken twice, as the surfaces of chapter 3 do (3.36, 3.61). Not for the spline. The end
    /// spans of the quadratic B-spline are half as long as the others (3.32, 3.35).
    Doubled,
    /// The first and the last point given are auxiliary ones: they shape the end spans, and
    /// no span is added for them. For pole points and ghost rows of surfaces. Not for the spline.
    Auxiliary,
}

impl From<Closure> for Ends {
    fn from(closure: Closure) -> Self {
        match closure {
            Closure::Open => Self::Open,
            Closure::Closed => Self::Closed,
        }
    }
}

/// How a curve follows its control points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Coons-Hermite interpolation (2.13)-(2.15): the tangent in a control point is `k0` times
    /// the difference of its neighbours. Tangent continuous; `k0 = 0.5` is Overhauser's (2.17).
    Coons {
        /// Factor of the automatic tangents, any finite number.
        k0: f64,
    },
    /// The Bézier curve by all control points (2.47)-(2.48), degree `n - 1`; closed: the first
    /// point is repeated at the end, degree `n`.
    Bezier,
    /// A row of cubic Bézier arcs (2.49): every third control point is a joint, the two between are handles. Open curves
    /// have 3m + 1 points, closed ones 3m.
    Arcs,
    /// The uniform interpolating cubic spline (2.28)-(2.46), natural ends when open, periodic
    /// when closed. Second derivatives are continuous.
    Spline,
    /// The uniform quadratic B-spline (2.56)-(2.57).
    BSpline2,
    /// The uniform cubic B-spline (2.58).
    BSpline3,
    /// The cubic beta-spline (2.63)-(2.66): unit tangent and curvature vector are continuous.
    Beta {
        /// Bias (beta 1), finite and positive; 1 is neutral.
        bias: f64,
        /// Tension (beta 2, half of Barsky's), finite; 0 is neutral.
        tension: f64,
    },
    /// The local spline of the surfaces (3.60)-(3.61): four cardinal weights, end points doubled.
    /// For curves the same arcs as [`Method::Coons`], since doubled ends give the tangents of 2.15.
    Local {
        /// Factor of the automatic tangents, any finite number.
        k0: f64,
    },
}

impl Method {
    /// The stable lower-case name: `coons`, `bezier`, `arcs`, `spline`, `bspline2`, `bspline3`, `beta`,
    /// `local`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Coons { .. } => "coons",
            Self::Bezier => "bezier",
            Self::Arcs => "arcs",
            Self::Spline => "spline",
            Self::BSpline2 => "bspline2",
            Self::BSpline3 => "bspline3",
            Self::Beta { .. } => "beta",
            Self::Local { .. } => "local",
        }
    }

    /// Whether the curve passes through every control point.
    #[must_use]
    pub fn interpolates(self) -> bool {
        matches!(self, Self::Coons { .. } | Self::Spline | Self::Local { .. })
    }

    /// The smallest number of control points. Closed curves need 3; open ones 2, the quadratic
    /// B-spline 3, Bézier arcs 4; with auxiliary points at the ends 4, the quadratic B-spline 3.
    #[must_use]
    pub fn fewest_points(self, ends: Ends) -> usize {
        match (ends, self) {
            (Ends::Closed, _) | (Ends::Open | Ends::Auxiliary, Self::BSpline2) => 3,
            (Ends::Open, Self::Arcs) => 4,
            (Ends::Open | Ends::Doubled, _) => 2,
            (Ends::Auxiliary, _) => 4,
        }
    }

    /// The beta-spline's critical tension for a bias, where its delta vanishes (2.67 with the
    /// missing 1): `-(bias^3 + 2 bias^2 + 2 bias + 1)`.
    #[must_use]
    pub fn critical_tension(bias: f64) -> f64 {
        -(((bias + 2.0) * bias + 2.0) * bias + 1.0)
    }

    /// Checks the parameters.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`] when one is not finite or out of range,
    /// [`GeometryError::CriticalTension`] when delta is below 1e-9 of its terms.
    pub fn check(self) -> Result<(), GeometryError> {
        match self {
            Self::Coons { k0 } | Self::Local { k0 } => finite("k0", k0),
            Self::Beta { bias, tension } => check_beta(bias, tension),
            Self::Bezier | Self::Arcs | Self::Spline | Self::BSpline2 | Self::BSpline3 => Ok(()),
        }
    }
}

fn finite(name: &'static str, value: f64) -> Result<(), GeometryError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(GeometryError::Parameter { name, value, wanted: "a finite number" })
    }
}

fn check_beta(bias: f64, tension: f64) -> Result<(), GeometryError> {
    let critical = Method::critical_tension(bias);
    if bias.is_nan() || bias <= 0.0 || !critical.is_finite() {
        let wanted = "positive, and its cube a finite number";
        return Err(GeometryError::Parameter { name: "bias", value: bias, wanted });
    }
    finite("tension", tension)?;
    let delta = tension - critical;
    if delta.abs() <= 1e-9 * critical.abs() {
        return Err(GeometryError::CriticalTension { bias, tension, critical });
    }
    if !delta.is_finite() {
        let wanted = "small enough that its sum with the cube of the bias is finite";
        return Err(GeometryError::Parameter { name: "tension", value: tension, wanted });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn critical_tension_agrees_with_the_programs() {
        assert_eq!(Method::critical_tension(1.0), -6.0);
        assert_eq!(Method::critical_tension(2.0), -21.0);
        let at = |tension| Method::Beta { bias: 2.0, tension }.check();
        assert!(matches!(at(-21.0), Err(GeometryError::CriticalTension { critical: -21.0, .. })));
        assert!(matches!(at(-21.0 + 1e-9), Err(GeometryError::CriticalTension { .. })));
        assert_eq!(at(-20.9), Ok(()));
        assert_eq!(at(-21.1), Ok(()));
    }

    #[test]
    fn bad_parameters_are_named() {
        for bias in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e200] {
            let error = Method::Beta { bias, tension: 0.0 }.check();
            assert!(matches!(error, Err(GeometryError::Parameter { name: "bias", .. })), "{bias}");
        }
        let error = Method::Beta { bias: 1.0, tension: f64::NAN }.check();
        assert!(matches!(error, Err(GeometryError::Parameter { name: "tension", .. })));
        let error = Method::Coons { k0: f64::NEG_INFINITY }.check();
        assert!(matches!(error, Err(GeometryError::Parameter { name: "k0", .. })));
    }
}
