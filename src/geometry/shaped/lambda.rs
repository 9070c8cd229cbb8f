//! Uniform cubic B-splines with a parameter `lambda` that moves every point of the curve on a straight line: from the
//! spline along second differences of the points (Han), or towards the polygon (alpha-B-splines, GB- and SPB-splines).
//!
//! Han's functions have the properties told of his quartic (Han 2006; the booklet's "quadratic" is this one): for one
//! lambda the extended cubic B-spline of the literature. The alpha-B-spline is the singularly blended one
//! (Loe 1996, Tai and Loe 1999); GB- and SPB-splines follow the booklet's frame `(1 - q) s + q l`.

use super::super::GeometryError;
use super::super::jet::Jet;
use std::f64::consts::TAU;

/// The largest size of a `lambda`.
pub const MAX_LAMBDA: f64 = 1e6;

/// What lambda does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LambdaKind {
    /// Han: the fourth degree, lambdas of single points; [-8, 1] keeps the convex hull, 4 goes through the points.
    Han,
    /// Towards the polygon, blended by a polynomial of degree 5; 1 is the polygon.
    Alpha,
    /// The same with lambdas of single points.
    Gb,
    /// Towards the polygon, blended by `x - sin(2 pi x) / 2 pi`.
    Spb,
}

/// One lambda for the curve, or one for every control point (Han and GB).
#[derive(Clone, Debug, PartialEq)]
pub enum Lambdas {
    /// The same everywhere.
    One(f64),
    /// One for every control point.
    Each(Vec<f64>),
}

impl Lambdas {
    /// The lambda of control point `index`, counted round.
    pub(super) fn of(&self, index: usize) -> f64 {
        match self {
            Self::One(lambda) => *lambda,
            Self::Each(all) => all.get(index % all.len().max(1)).copied().unwrap_or(0.0),
        }
    }

    /// The check of all of them.
    pub(super) fn check(&self, kind: LambdaKind, points: usize) -> Result<(), GeometryError> {
        let all = match self {
            Self::One(lambda) => std::slice::from_ref(lambda),
            Self::Each(all) => {
                if matches!(kind, LambdaKind::Alpha | LambdaKind::Spb) {
                    let (value, wanted) = (all.len() as f64, "one number for the curve in this family");
                    return Err(GeometryError::Parameter { name: "the number of lambdas", value, wanted });
                }
                if all.len() != points {
                    let (value, wanted) = (all.len() as f64, "1 or that of the control points");
                    return Err(GeometryError::Parameter { name: "the number of lambdas", value, wanted });
                }
                all
            }
        };
        match all.iter().find(|lambda| lambda.abs() > MAX_LAMBDA || lambda.is_nan()) {
            Some(&value) => {
                let wanted = "a number from -1000000 to 1000000";
                Err(GeometryError::Parameter { name: "lambda", value, wanted })
            }
            None => Ok(()),
        }
    }
}

/// The weights of a place in two parts: those on the control points, and those on the points of the polygon that is
/// blended in. They are the same points unless an interpolating curve has a polygon of its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parts {
    pub(super) spline: [Jet; 4],
    pub(super) line: [Jet; 4],
}

/// The uniform cubic B-spline.
pub(super) fn spline(x: f64) -> [Jet; 4] {
    let (x, y) = (Jet::parameter(x), Jet::parameter(1.0 - x).reversed());
    let number = Jet::from;
    let outer = |x: Jet| x * x * x / number(6.0);
    let inner = |x: Jet| (number(4.0) - number(6.0) * x * x + number(3.0) * x * x * x) / number(6.0);
    [outer(y), inner(x), inner(y), outer(x)]
}

/// The weights on an arc with `lambda[0]` at its beginning and `lambda[1]` at its end.
pub(super) fn parts(kind: LambdaKind, lambda: [f64; 2], x: f64) -> Parts {
    let zero = Jet::from(0.0);
    let (u, v) = (Jet::parameter(x), Jet::parameter(1.0 - x).reversed());
    let number = Jet::from;
    let spline = spline(x);
    if kind == LambdaKind::Han {
        let hump = |u: Jet, v: Jet| v * v * v * (number(1.0) + number(3.0) * u) / number(24.0);
        let (first, second) = (number(lambda[0]) * hump(u, v), number(lambda[1]) * hump(v, u));
        let two = number(2.0);
        let [s0, s1, s2, s3] = spline;
        let moved = [s0 - first, s1 + two * first - second, s2 + two * second - first, s3 - second];
        return Parts { spline: moved, line: [zero; 4] };
    }
    let quintic = u * u * u * (number(10.0) - number(15.0) * u + number(6.0) * u * u);
    let g = match kind {
        LambdaKind::Spb => {
            let (sin, cos) = (TAU * x).sin_cos();
            Jet([x - sin / TAU, 1.0 - cos, TAU * sin])
        }
        _ => quintic,
    };
    let q = number(lambda[0]) + number(lambda[1] - lambda[0]) * quintic;
    let rest = number(1.0) - q;
    Parts { spline: spline.map(|s| rest * s), line: [zero, q * (number(1.0) - g), q * g, zero] }
}
