//! Generalized trigonometric Bézier curves: definition 2.13 of Hoffmann's booklet; `n1 = n2 = 2` is Han's curve of five
//! control points (2.12).

use super::super::GeometryError;
use super::super::jet::Jet;
use std::f64::consts::{FRAC_PI_2, PI};

/// The largest `n1` and `n2`.
pub const MAX_SIDE_POINTS: usize = 32;
/// The largest `alpha` and `beta`.
pub const MAX_EXPONENT: f64 = 1e4;

/// Derivatives nearer to an end than this are those here: some parametrizations start with infinite speed.
const NEAREST: f64 = 1e-9;

/// How `phi` and `psi`, with `phi^n1 + psi^n2 = 1`, run from 0 to 1 and back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phi {
    /// `phi = sin(pi x / 2)^(2 / n1)`, `psi = cos(pi x / 2)^(2 / n2)`.
    Trig,
    /// `phi = x`, `psi = (1 - x^n1)^(1 / n2)`.
    Power,
    /// `phi = 2 x / (1 + x^2)`, `psi = (1 - x^2) / (1 + x^2)`; for `n1 = n2 = 2` only.
    Rational,
}

/// The blending functions of `n1 + n2 + 1` control points with the exponents `alpha` and `beta`.
///
/// They are not negative and sum to 1. Larger exponents pull the curve towards the middle point; at `alpha = n1`,
/// `beta = n2` that point has no influence ([`Trig::middle_is_dead`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trig {
    n1: usize,
    n2: usize,
    pub(super) alpha: f64,
    pub(super) beta: f64,
    phi: Phi,
}

impl Trig {
    /// Checked parameters: `n1`, `n2` in 1 to [`MAX_SIDE_POINTS`], `alpha` in `n1` to [`MAX_EXPONENT`], `beta`
    /// in `n2` to the same.
    ///
    /// # Errors
    /// [`GeometryError::Parameter`].
    pub fn new(n1: usize, n2: usize, alpha: f64, beta: f64, phi: Phi) -> Result<Self, GeometryError> {
        let bad = |name, value, wanted| Err(GeometryError::Parameter { name, value, wanted });
        for (name, n) in [("n1", n1), ("n2", n2)] {
            if !(1..=MAX_SIDE_POINTS).contains(&n) {
                return bad(name, n as f64, "a whole number from 1 to 32");
            }
        }
        if !(n1 as f64..=MAX_EXPONENT).contains(&alpha) {
            return bad("alpha", alpha, "a number from n1 to 10000");
        }
        if !(n2 as f64..=MAX_EXPONENT).contains(&beta) {
            return bad("beta", beta, "a number from n2 to 10000");
        }
        if phi == Phi::Rational && (n1, n2) != (2, 2) {
            let (name, n) = if n1 == 2 { ("n2", n2) } else { ("n1", n1) };
            return bad(name, n as f64, "2 for the rational parametrization");
        }
        Ok(Self { n1, n2, alpha, beta, phi })
    }

    /// How many control points stand before and behind the middle one.
    #[must_use]
    pub fn sides(&self) -> [usize; 2] {
        [self.n1, self.n2]
    }

    /// The exponents `alpha` and `beta`.
    #[must_use]
    pub fn exponents(&self) -> [f64; 2] {
        [self.alpha, self.beta]
    }

    /// The parametrization.
    #[must_use]
    pub fn phi(&self) -> Phi {
        self.phi
    }

    /// Whether the middle control point has no influence at all.
    #[must_use]
    pub fn middle_is_dead(&self) -> bool {
        self.alpha == self.n1 as f64 && self.beta == self.n2 as f64
    }

    /// The blending functions at `x`. Where the speed is infinite at an end, derivatives are those a billionth before.
    pub(super) fn weights(&self, x: f64) -> Vec<Jet> {
        let mut weights = self.exact(x);
        let inside = x.clamp(NEAREST, 1.0 - NEAREST);
        if inside != x {
            for (weight, near) in weights.iter_mut().zip(self.exact(inside)) {
                weight.0 = [weight.0[0], near.0[1], near.0[2]];
            }
        }
        weights
    }

    /// As [`Trig::weights`], but derivatives at the ends may be no numbers.
    fn exact(&self, x: f64) -> Vec<Jet> {
        let [phi, phi_rest, psi, psi_rest] = self.parameters(x);
        let mut weights = vec![Jet::from(0.0); self.n1 + self.n2 + 1];
        let mut rest = Jet::from(1.0);
        for (i, weight) in weights.iter_mut().enumerate().take(self.n1) {
            *weight = term(self.alpha, i, phi, phi_rest);
            rest = rest - *weight;
        }
        for j in 0..self.n2 {
            let weight = term(self.beta, j, psi, psi_rest);
            weights[self.n1 + self.n2 - j] = weight;
            rest = rest - weight;
        }
        weights[self.n1] = rest;
        weights
    }

    /// `phi`, `1 - phi`, `psi` and `1 - psi`, all without cancellation.
    fn parameters(&self, x: f64) -> [Jet; 4] {
        let y = 1.0 - x;
        match self.phi {
            Phi::Trig => {
                let [phi, phi_rest] = sine_power(x, self.n1);
                let [psi, psi_rest] = sine_power(y, self.n2).map(Jet::reversed);
                [phi, phi_rest, psi, psi_rest]
            }
            Phi::Power => {
                let (n1, root) = (self.n1 as f64, 1.0 / self.n2 as f64);
                let slope = -n1 * x.powi(self.n1 as i32 - 1);
                let bend = if self.n1 < 2 { 0.0 } else { -n1 * (n1 - 1.0) * x.powi(self.n1 as i32 - 2) };
                let rest = Jet([-(n1 * (-y).ln_1p()).exp_m1(), slope, bend]);
                let psi = rest.powf(root);
                let psi_rest = Jet::from(1.0) - psi;
                let near = -(root * (-x.powi(self.n1 as i32)).ln_1p()).exp_m1();
                [
                    Jet::parameter(x),
                    Jet::parameter(y).reversed(),
                    psi,
                    Jet([near, psi_rest.0[1], psi_rest.0[2]]),
                ]
            }
            Phi::Rational => {
                let (x, y) = (Jet::parameter(x), Jet::parameter(y).reversed());
                let (one, two) = (Jet::from(1.0), Jet::from(2.0));
                let below = one + x * x;
                [two * x / below, y * y / below, y * (one + x) / below, two * x * x / below]
            }
        }
    }
}

/// `sin(pi x / 2)^(2 / n)` and what is left of 1.
fn sine_power(x: f64, n: usize) -> [Jet; 2] {
    let n = n as f64;
    // The cosine from the other end: it vanishes at x = 1 exactly.
    let (sin, cos) = ((FRAC_PI_2 * x).sin(), (FRAC_PI_2 * (1.0 - x)).sin());
    let value = sin.powf(2.0 / n);
    // By the logarithm's derivative (pi / n) cot; for n = 2 the cotangents cancel here, not in the doubles.
    let cot = cos / sin;
    let slope = value * (PI / n) * cot;
    let bend = value * (PI * PI / n) * ((1.0 / n - 0.5) * cot * cot - 0.5);
    let rest = -((-cos * cos).ln_1p() / n).exp_m1();
    [Jet([value, slope, bend]), Jet([rest, -slope, -bend])]
}

/// `binom(a, i) u^i (1 - u)^(a - i)`.
fn term(a: f64, i: usize, u: Jet, rest: Jet) -> Jet {
    let binomial = (0..i).fold(1.0, |product, m| product * (a - m as f64) / (m as f64 + 1.0));
    Jet::from(binomial) * u.powf(i as f64) * rest.powf(a - i as f64)
}

/// Han's quadratic trigonometric spline (Han 2002) at `x` of a span, once continuously differentiable.
pub(super) fn han_quadratic(lambda: f64, x: f64) -> [Jet; 3] {
    // (1 - S)(1 - lambda S) / 2 of S = sin(pi x / 2), 1 - S = 2 sin^2(pi y / 4).
    let side = |x: f64| {
        let quarter = (FRAC_PI_2 * (1.0 - x) / 2.0).sin();
        let (s, c) = ((FRAC_PI_2 * x).sin(), (FRAC_PI_2 * (1.0 - x)).sin());
        let (s1, s2) = (FRAC_PI_2 * c, -FRAC_PI_2 * FRAC_PI_2 * s);
        let factor = Jet([2.0 * quarter * quarter, -s1, -s2]);
        let other = Jet([1.0 - lambda * s, -lambda * s1, -lambda * s2]);
        Jet::from(0.5) * factor * other
    };
    let (b0, b2) = (side(x), side(1.0 - x).reversed());
    [b0, Jet::from(1.0) - b0 - b2, b2]
}
