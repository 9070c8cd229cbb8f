//! Where the search for a PH spline starts: the ordinary C2 cubic spline over the same knots.

use super::banded::{Row, solve};
use super::complex::Complex;

/// What is known of a cubic spline at its ends.
#[derive(Clone, Copy, Debug)]
pub(super) enum Slopes {
    /// The derivative where given, else a second derivative of zero.
    Ends([Option<Complex>; 2]),
    /// The curve is closed.
    Periodic,
}

/// The derivatives at the knots of the C2 cubic spline with these chords and knot steps; the first once more at the
/// end of a closed one. `None` where numbers overflow.
pub(super) fn cubic_slopes(chords: &[Complex], steps: &[f64], ends: Slopes) -> Option<Vec<Complex>> {
    let n = chords.len();
    let real = |value: f64| Complex::new(value, 0.0);
    let secant = |i: usize| chords[i] * (1.0 / steps[i]);
    // h_i D_(i-1) + 2 (h_(i-1) + h_i) D_i + h_(i-1) D_(i+1) = 3 (h_i s_(i-1) + h_(i-1) s_i), divided by the sum.
    let inner = |before: usize, i: usize| {
        let share = steps[i] / (steps[before] + steps[i]);
        let row = [real(share), real(2.0), real(1.0 - share)];
        (row, (secant(before) * share + secant(i) * (1.0 - share)) * 3.0)
    };
    let (rows, rhs): (Vec<Row>, Vec<Complex>) = match ends {
        Slopes::Periodic => (0..n).map(|i| inner((i + n - 1) % n, i)).unzip(),
        Slopes::Ends([start, end]) => {
            let row = |slope: Option<Complex>, span: usize, factors: [f64; 3]| match slope {
                Some(slope) => ([0.0, 1.0, 0.0].map(real), slope),
                None => (factors.map(real), secant(span) * 3.0),
            };
            let first = row(start, 0, [0.0, 2.0, 1.0]);
            let last = row(end, n - 1, [1.0, 2.0, 0.0]);
            std::iter::once(first).chain((1..n).map(|i| inner(i - 1, i))).chain(std::iter::once(last)).unzip()
        }
    };
    let mut slopes = solve(&rows, &rhs, matches!(ends, Slopes::Periodic))?;
    if matches!(ends, Slopes::Periodic) {
        slopes.extend(slopes.first().copied());
    }
    Some(slopes)
}

/// The square roots of the cubic spline's derivatives at the middle of every span, with signs that follow each other.
pub(super) fn start_values(chords: &[Complex], steps: &[f64], slopes: &[Complex]) -> Vec<Complex> {
    let middle = |i: usize| chords[i] * (1.5 / steps[i]) - (slopes[i] + slopes[i + 1]) * 0.25;
    let mut values: Vec<Complex> = Vec::with_capacity(chords.len());
    let mut stops = Vec::new();
    for (i, chord) in chords.iter().enumerate() {
        let slope = middle(i);
        let mut value = slope.sqrt();
        let before = values.last().copied().unwrap_or(value);
        if slope.norm() <= 1e-12 * chord.norm() / steps[i] {
            stops.push(i);
            value = before;
        }
        values.push(if value.dot(before) < 0.0 { -value } else { value });
    }
    // A middle that stands still has the mean of its neighbours, or the chord's root where they stand still too.
    for i in stops {
        let next = values.get(i + 1).copied().unwrap_or_default();
        let before = if i > 0 { values[i - 1] } else { next };
        let next = if i + 1 < values.len() { next } else { before };
        let mean = (before + next) * 0.5;
        values[i] = if mean.norm() > 0.0 { mean } else { (chords[i] * (1.0 / steps[i])).sqrt() };
    }
    values
}
