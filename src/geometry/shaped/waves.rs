//! C- and F-Bézier curves and the uniform B-splines beside them: curves of `1, t, sin t, cos t`, of cubic polynomials
//! and of `1, t, sinh t, cosh t`, in one formula.
//!
//! `omega` is `alpha^2` for waves on [0, alpha] (C-curves, definition 2.11 of Hoffmann's booklet, after Zhang 1996), 0
//! for polynomials and `-alpha^2` for hyperbolic functions; the parameter here is `x = t / alpha`.

use super::super::Point;
use super::super::jet::Jet;
use super::super::point::add_scaled;
use super::stumpff::{c0, c1, c2, c3, c23};
use std::f64::consts::PI;

/// The smallest and the largest `omega`.
pub const OMEGA: [f64; 2] = [-900.0, PI * PI];

/// Below it the differences of the general formula lose digits.
const PRODUCTS_BELOW: f64 = -25.0;

/// `x^3 c3(omega x^2)` and its derivatives.
fn third(omega: f64, x: f64) -> Jet {
    let z = omega * x * x;
    Jet([x * x * x * c3(z), x * x * c2(z), x * c1(z)])
}

/// `x^2 c2(omega x^2)` and its derivatives.
fn second(omega: f64, x: f64) -> Jet {
    let z = omega * x * x;
    Jet([x * x * c2(z), x * c1(z), c0(z)])
}

/// A jet times a number.
fn scaled(factor: f64, jet: Jet) -> Jet {
    Jet(jet.0.map(|value| factor * value))
}

/// The blending functions of the F-Bézier curve at `x`.
pub(super) fn bezier(omega: f64, x: f64) -> [Jet; 4] {
    let y = 1.0 - x;
    let last = |x| scaled(1.0 / c3(omega), third(omega, x));
    let (z0, z3) = (last(y).reversed(), last(x));
    if omega < PRODUCTS_BELOW {
        return [z0, product(omega, y).reversed(), product(omega, x), z3];
    }
    let m = 2.0 * c2(omega) * c1(omega / 4.0) / c23(omega / 4.0);
    let inner = |x, last| scaled(m, scaled(1.0 / c2(omega), second(omega, x)) - last);
    [z0, inner(y, z0.reversed()).reversed(), inner(x, z3), z3]
}

/// The third function of the F-Bézier curve as a sum without cancellation to speak of, for large hyperbolic `omega`.
fn product(omega: f64, x: f64) -> Jet {
    let s = (-omega).sqrt();
    let (t, r, half) = (x * s, (1.0 - x) * s, s / 2.0);
    let (sinh, cosh) = (half.sinh(), half.cosh());
    let k = sinh / (2.0 * (half * cosh - sinh) * (s.sinh() - s));
    let root = (t / 2.0).sinh();
    let value = 2.0 * t * sinh * sinh - 2.0 * s * root * root - 4.0 * root * (r / 2.0).sinh() * sinh;
    let slope = 2.0 * sinh * sinh - s * t.sinh() - 2.0 * sinh * ((r - t) / 2.0).sinh();
    let bend = 2.0 * sinh * ((r - t) / 2.0).cosh() - s * t.cosh();
    Jet([k * value, k * s * slope, k * s * s * bend])
}

/// The blending functions of the uniform F-B-spline, which is twice continuously differentiable, at `x` of a span.
pub(super) fn b_spline(omega: f64, x: f64) -> [Jet; 4] {
    let y = 1.0 - x;
    let outer = |x| scaled(0.5 / c2(omega), third(omega, x));
    let (b0, b3) = (outer(y).reversed(), outer(x));
    let (near, far) = (Jet::parameter(y).reversed(), Jet::parameter(x));
    let two = Jet::from(2.0);
    [b0, b3 - two * b0 + near, b0 - two * b3 + far, b3]
}

/// The control points of the F-Bézier curve that is a given curve `f` of its space: `f` and its derivative by `x` at
/// `x = 0`, the same at `x = 1`. Circles, helices, cycloids (positive `omega`) and catenaries (negative) are exact.
///
/// ```
/// use grafika::geometry::shaped::bezier_points;
/// use std::f64::consts::PI;
///
/// // Half a circle: (cos pi x, sin pi x).
/// let points = bezier_points(PI * PI, [[1.0, 0.0], [0.0, PI]], [[-1.0, 0.0], [0.0, -PI]]);
/// assert!((points[1][1] - PI / 2.0).abs() < 1e-15 && (points[2][0] + 1.0).abs() < 1e-15);
/// ```
#[must_use]
pub fn bezier_points<const D: usize>(omega: f64, start: [Point<D>; 2], end: [Point<D>; 2]) -> [Point<D>; 4] {
    let leg = c3(omega) / c2(omega);
    [start[0], add_scaled(start[0], leg, start[1]), add_scaled(end[0], -leg, end[1]), end[0]]
}
