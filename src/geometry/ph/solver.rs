//! The equations of a PH spline and their solution by Newton's method.

use super::banded::{Row, solve};
use super::complex::Complex;

/// How a span's end coefficients `w_0` and `w_2` follow from the unknowns `z`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    step: f64,
    /// `w_0` and `w_2` as factors of the unknowns before, at and after the span, and a constant.
    ends: [([f64; 3], Complex); 2],
}

impl Span {
    /// From the factors of the neighbour's and the own unknown at both ends. Where there is no neighbour, the curve
    /// ends: with this coefficient, or as a PH cubic, whose `w` is linear: `w_0 = 2 w_1 - w_2`.
    pub(super) fn new(step: f64, shared: [Option<(f64, f64)>; 2], fixed: [Option<Complex>; 2]) -> Self {
        let zero = Complex::default();
        let linear = |([a, b, c], constant): ([f64; 3], Complex)| ([-a, 2.0 - b, -c], -constant);
        let [before, after] = shared;
        let known_before = before.map(|(other, own)| ([other, own, 0.0], zero));
        let known_after = after.map(|(other, own)| ([0.0, own, other], zero));
        let start = known_before.or(fixed[0].map(|value| ([0.0; 3], value)));
        let end = known_after.or(fixed[1].map(|value| ([0.0; 3], value)));
        let ends = match (start, end) {
            (Some(start), Some(end)) => [start, end],
            (Some(start), None) => [start, linear(start)],
            (None, Some(end)) => [linear(end), end],
            // The only span, between two cubic ends: w is constant.
            (None, None) => [([0.0, 1.0, 0.0], zero); 2],
        };
        Self { step, ends }
    }

    fn coefficients(&self, z: [Complex; 3]) -> [Complex; 3] {
        let end = |(factors, constant): ([f64; 3], Complex)| {
            z.iter().zip(factors).fold(constant, |sum, (&value, factor)| sum + value * factor)
        };
        [end(self.ends[0]), z[1], end(self.ends[1])]
    }
}

/// One equation a span: the integral of `h w^2` is the chord.
#[derive(Clone, Debug)]
pub(super) struct Equations<'a> {
    pub(super) chords: &'a [Complex],
    pub(super) spans: Vec<Span>,
    pub(super) cyclic: bool,
}

/// The remainder that is left by rounding, as a share of the longest chord.
const ROUNDING: f64 = 4e-14;
/// What is good enough where Newton's method does not get further.
const ACCEPTED: f64 = 1e-11;
/// Steps of Newton's method at most. It needs three to eight.
const STEPS: u32 = 60;
/// The shortest step of the homotopy.
const SHORTEST: f64 = 1e-4;

impl Equations<'_> {
    /// The coefficients of every span.
    pub(super) fn coefficients(&self, z: &[Complex]) -> Vec<[Complex; 3]> {
        self.spans.iter().enumerate().map(|(i, span)| span.coefficients(self.around(z, i))).collect()
    }

    /// The unknowns before, at and after span `i`; those that do not exist have the factor zero.
    fn around(&self, z: &[Complex], i: usize) -> [Complex; 3] {
        let n = z.len();
        [(i + n - 1) % n, i, (i + 1) % n].map(|k| z[k])
    }

    /// The unknowns for which `w` has these values at the middle of the spans: `(w_0 + 2 w_1 + w_2) / 4`.
    pub(super) fn fit_middles(&self, values: &[Complex]) -> Option<Vec<Complex>> {
        let middle = |span: &Span| -> (Row, Complex) {
            let [(start, first), (end, last)] = span.ends;
            let own = [0.0, 2.0, 0.0];
            let row = std::array::from_fn(|k| Complex::new(0.25 * (start[k] + own[k] + end[k]), 0.0));
            (row, (first + last) * 0.25)
        };
        let (rows, constants): (Vec<Row>, Vec<Complex>) = self.spans.iter().map(middle).unzip();
        let rhs: Vec<Complex> =
            values.iter().zip(constants).map(|(&value, constant)| value - constant).collect();
        solve(&rows, &rhs, self.cyclic)
    }

    /// The solution near `start`, by Newton's method, or if that fails by following the solution of
    /// `F(z) = (1 - tau) F(start)` from `tau = 0` to 1.
    ///
    /// # Errors
    /// The remainder, as a share of the longest chord, where neither ends.
    pub(super) fn solve(&self, start: Vec<Complex>) -> Result<Vec<Complex>, f64> {
        let goal = vec![Complex::default(); start.len()];
        let remainder = match self.newton(&start, &goal) {
            Ok(solution) => return Ok(solution),
            Err(remainder) => remainder,
        };
        let first = self.remainders(&start);
        let (mut z, mut done, mut step) = (start, 0.0_f64, 0.25_f64);
        while done < 1.0 {
            let next = (done + step).min(1.0);
            let goal: Vec<Complex> = first.iter().map(|&value| value * (1.0 - next)).collect();
            if let Ok(solution) = self.newton(&z, &goal) {
                (z, done, step) = (solution, next, 2.0 * step);
            } else {
                step *= 0.5;
                if step < SHORTEST {
                    return Err(remainder);
                }
            }
        }
        Ok(z)
    }

    /// Damped Newton iteration for `F(z) = goal`: a step is halved until the remainder falls.
    fn newton(&self, start: &[Complex], goal: &[Complex]) -> Result<Vec<Complex>, f64> {
        let scale = self.chords.iter().fold(0.0_f64, |most, chord| most.max(chord.norm()));
        let off = |z: &[Complex]| -> (Vec<Complex>, f64) {
            let rest: Vec<Complex> =
                self.remainders(z).iter().zip(goal).map(|(&value, &goal)| value - goal).collect();
            let largest = rest.iter().fold(0.0_f64, |most, value| most.max(value.norm()));
            (rest, largest / scale)
        };
        let mut z = start.to_vec();
        let (mut rest, mut size) = off(&z);
        for _ in 0..STEPS {
            if size <= ROUNDING {
                return Ok(z);
            }
            let Some(step) = solve(&self.jacobian(&z), &rest, self.cyclic) else { break };
            let mut share = 1.0;
            let mut better = None;
            while share > 1e-6 && better.is_none() {
                let trial: Vec<Complex> = z.iter().zip(&step).map(|(&z, &step)| z - step * share).collect();
                let (trial_rest, trial_size) = off(&trial);
                if trial_size <= size * (1.0 - 0.25 * share) {
                    better = Some((trial, trial_rest, trial_size));
                }
                share *= 0.5;
            }
            let Some(found) = better else { break };
            (z, rest, size) = found;
        }
        if size <= ACCEPTED { Ok(z) } else { Err(size) }
    }

    /// `f_i = h / 15 (3 w_0^2 + 3 w_0 w_1 + 2 w_1^2 + w_0 w_2 + 3 w_1 w_2 + 3 w_2^2) - chord`.
    fn remainders(&self, z: &[Complex]) -> Vec<Complex> {
        let spans = self.spans.iter().zip(self.chords).enumerate();
        spans
            .map(|(i, (span, &chord))| {
                let [a, b, c] = span.coefficients(self.around(z, i));
                let sum = a * (a + b) * 3.0 + b * b * 2.0 + a * c + c * (b + c) * 3.0;
                sum * (span.step / 15.0) - chord
            })
            .collect()
    }

    /// The derivatives of the equations by the unknowns.
    fn jacobian(&self, z: &[Complex]) -> Vec<Row> {
        let row = |(i, span): (usize, &Span)| -> Row {
            let [a, b, c] = span.coefficients(self.around(z, i));
            let by = [a * 6.0 + b * 3.0 + c, a * 3.0 + b * 4.0 + c * 3.0, a + b * 3.0 + c * 6.0];
            let [(start, _), (end, _)] = span.ends;
            let own = [0.0, 1.0, 0.0];
            std::array::from_fn(|k| (by[0] * start[k] + by[1] * own[k] + by[2] * end[k]) * (span.step / 15.0))
        };
        self.spans.iter().enumerate().map(row).collect()
    }
}
