//! A patch of (p, q, r) and what it is in space, still in the chart.

use super::bernstein::Tensor;
use super::jet::Jet2;
use crate::geometry::jet::Number;
use crate::geometry::param::clipped;
use crate::geometry::{Patch, Point};

/// What a place is like: values, or jets of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Local<T> {
    /// The point.
    pub(super) point: [T; 3],
    /// The unit normal.
    pub(super) normal: [T; 3],
    /// The Jacobian of (p, q) by (u, v).
    pub(super) jacobian: T,
    /// (p, q): where the normal is in the plane that the sphere is projected to.
    pub(super) gauss: [T; 2],
    /// The derivatives of r as a function f of (p, q).
    slopes: [T; 2],
    /// Half the factor 1 + p² + q².
    half: T,
    /// The derivatives of p and q by u and v: p_u, p_v, q_u, q_v.
    by: [T; 4],
}

/// The surface that a function f of (p, q) stands for, from y = (p, q, f) and its derivatives.
fn local<T: Number>(y: [T; 3], by_u: [T; 3], by_v: [T; 3]) -> Local<T> {
    let (one, two) = (T::from(1.0), T::from(2.0));
    let ([p, q, r], [p_u, q_u, r_u], [p_v, q_v, r_v]) = (y, by_u, by_v);
    let jacobian = p_u * q_v - p_v * q_u;
    let f_p = (r_u * q_v - r_v * q_u) / jacobian;
    let f_q = (p_u * r_v - p_v * r_u) / jacobian;
    let rho = p * p + q * q;
    let z = two * (p * f_p + q * f_q - r) / (one + rho);
    Local {
        point: [f_p - p * z, f_q - q * z, z],
        normal: [two * p / (one + rho), two * q / (one + rho), (rho - one) / (one + rho)],
        jacobian,
        gauss: [p, q],
        slopes: [f_p, f_q],
        half: (one + rho) / two,
        by: [p_u, p_v, q_u, q_v],
    }
}

/// The cubic Bernstein polynomials with their first three derivatives.
fn basis(t: f64) -> [[f64; 4]; 4] {
    let s = 1.0 - t;
    [
        [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t],
        [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t],
        [6.0 * s, 6.0 * (t - 2.0 * s), 6.0 * (s - 2.0 * t), 6.0 * t],
        [-6.0, 18.0, -18.0, 6.0],
    ]
}

/// A place of the patch, parameters clipped to [0, 1].
pub(super) fn at(y: &Patch, [u, v]: [f64; 2]) -> Local<f64> {
    let by = derivatives(y, [u, v]);
    local(by(0, 0), by(1, 0), by(0, 1))
}

/// A place with its first and second derivatives.
pub(super) fn jet_at(y: &Patch, [u, v]: [f64; 2]) -> Local<Jet2> {
    let by = derivatives(y, [u, v]);
    let jet = |m: usize, n: usize| -> [Jet2; 3] {
        let parts = [by(m, n), by(m + 1, n), by(m, n + 1), by(m + 2, n), by(m + 1, n + 1), by(m, n + 2)];
        std::array::from_fn(|d| Jet2(parts.map(|part| part[d])))
    };
    local(jet(0, 0), jet(1, 0), jet(0, 1))
}

/// The derivatives of (p, q, r) at a place, by u and v so many times.
fn derivatives(y: &Patch, [u, v]: [f64; 2]) -> impl Fn(usize, usize) -> Point<3> {
    let (by_u, by_v) = (basis(clipped(u)), basis(clipped(v)));
    move |m, n| {
        let row = |row: &[Point<3>; 4], d: usize| -> f64 {
            row.iter().zip(by_v[n]).map(|(point, weight)| weight * point[d]).sum()
        };
        std::array::from_fn(|d| y.p.iter().zip(by_u[m]).map(|(points, weight)| weight * row(points, d)).sum())
    }
}

impl Local<Jet2> {
    /// The radii of curvature r1 <= r2: dx = r dn in the principal directions, the eigenvalues of
    /// (1 + p² + q²)/2 (Hess f - Z).
    pub(super) fn radii(&self) -> [f64; 2] {
        let [p_u, p_v, q_u, q_v] = self.by.map(|it| it.0[0]);
        let (jacobian, half, z) = (self.jacobian.0[0], self.half.0[0], self.point[2].0[0]);
        let by_p = |f: Jet2| (f.0[1] * q_v - f.0[2] * q_u) / jacobian;
        let by_q = |f: Jet2| (p_u * f.0[2] - p_v * f.0[1]) / jacobian;
        let [f_p, f_q] = self.slopes;
        let (a, c) = (half * (by_p(f_p) - z), half * (by_q(f_q) - z));
        // Equal but for rounding.
        let b = half * 0.5 * (by_q(f_p) + by_p(f_q));
        let (middle, distance) = (0.5 * (a + c), (0.5 * (a - c)).hypot(b));
        [middle - distance, middle + distance]
    }
}

/// The Bernstein coefficients of p, q and r.
pub(super) fn tensors(y: &Patch) -> [Tensor; 3] {
    [0, 1, 2].map(|d| Tensor::from_fn([3, 3], |k, l| y.p[k][l][d]))
}

/// The Bernstein coefficients of a_u b_v - a_v b_u, of degrees (5, 5).
pub(super) fn wedge(a: &Tensor, b: &Tensor) -> Tensor {
    let product = |i: usize, j: usize| a.derivative(i).times(&b.derivative(j));
    product(0, 1).minus(&product(1, 0))
}
