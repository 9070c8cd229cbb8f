//! Cyclic curves: the waves up to the n-th by 2n + 1 control points (Róth, Juhász, Schicho, Hoffmann 2009), their
//! elevation, and the way to Fourier coefficients and back.
//!
//! Point `i` weighs most at `u_i = 2 pi i / (2n + 1)`. The k-th harmonic of the curve is that of the polygon times
//! [`harmonic_factor`], from which everything here follows.

use super::super::jet::Jet;
use super::super::{Fourier, GeometryError, Point, Wave};
use std::f64::consts::{PI, TAU};

/// The least number of control points.
pub(super) const FEWEST: usize = 3;

/// The largest number of control points: above, the factors of the highest harmonics come near the smallest doubles.
pub(super) const MOST: usize = 1001;

/// The check on a number of control points.
///
/// # Errors
/// [`GeometryError::Parameter`] for an even number, less than 3 or more than 1001.
pub(super) fn check(points: usize) -> Result<usize, GeometryError> {
    if points % 2 == 1 && (FEWEST..=MOST).contains(&points) {
        return Ok(points / 2);
    }
    let wanted = "an odd number from 3 to 1001";
    Err(GeometryError::Parameter {
        name: "the number of points of a cyclic curve",
        value: points as f64,
        wanted,
    })
}

/// The blending functions of `2n + 1` points at `x` of the span from point `span` to the next, by `x`.
pub(super) fn weights(n: usize, span: usize, x: f64) -> impl Iterator<Item = Jet> {
    let (points, degree) = (2 * n + 1, n as f64);
    // 4^n / ((2n + 1) binom(2n, n))
    let scale = (1..=n).fold(1.0 / points as f64, |scale, k| scale * (2 * k) as f64 / (2 * k - 1) as f64);
    let speed = TAU / points as f64;
    (0..points).map(move |i| {
        // The nearer way round.
        let far = span as f64 - i as f64;
        let way = (far + x + degree + 0.5).rem_euclid(points as f64) - degree - 0.5;
        let (sin, cos) = (0.5 * speed * way).sin_cos();
        let power = cos.powi(2 * n as i32 - 2);
        let slope = -degree * power * cos * sin;
        let bend = power * (degree * (degree - 0.5) * sin * sin - 0.5 * degree * cos * cos);
        Jet([scale * power * cos * cos, scale * speed * slope, scale * speed * speed * bend])
    })
}

/// What the k-th harmonic of the polygon is multiplied by in the cyclic curve of degree `n`:
/// `binom(2n, n + k) / binom(2n, n)`; 0 for `k` above `n`.
#[must_use]
pub fn harmonic_factor(n: usize, k: usize) -> f64 {
    (1..=k).fold(1.0, |product, m| if m > n { 0.0 } else { product * (n - m + 1) as f64 / (n + m) as f64 })
}

/// The harmonics of the polygon, each times a factor, as a curve.
fn harmonics<const D: usize>(
    points: &[Point<D>],
    factor: impl Fn(usize) -> f64,
) -> Result<Fourier<D>, GeometryError> {
    let n = check(points.len())?;
    super::super::point::check_points(points)?;
    let (count, mut offset) = (points.len() as f64, [0.0; D]);
    for point in points {
        offset = super::super::point::add_scaled(offset, 1.0 / count, *point);
    }
    let wave = |k: usize, d: usize| {
        let (mut sine, mut cosine) = (0.0, 0.0);
        for (i, point) in points.iter().enumerate() {
            let (sin, cos) = (TAU * ((k * i) % points.len()) as f64 / count).sin_cos();
            (sine, cosine) = (sine + sin * (point[d] - offset[d]), cosine + cos * (point[d] - offset[d]));
        }
        let amplitude = 2.0 / count * factor(k) * sine.hypot(cosine);
        Wave { amplitude, phase: cosine.atan2(sine) / PI }
    };
    let waves: Vec<[Wave; D]> = (1..=n).map(|k| std::array::from_fn(|d| wave(k, d))).collect();
    Fourier::new(offset, &waves)
}

/// The cyclic curve of these control points as a Fourier series; `u = 0` is where the first point weighs most.
///
/// # Errors
/// [`GeometryError::Parameter`] for an even number of points, less than 3 or more than 1001, or a bad coordinate.
pub fn cyclic_to_fourier<const D: usize>(points: &[Point<D>]) -> Result<Fourier<D>, GeometryError> {
    let n = points.len() / 2;
    harmonics(points, |k| harmonic_factor(n, k))
}

/// The control points of a Fourier curve as a cyclic one, `harmonics` of its waves kept (at most all), so that there are
/// `2 harmonics + 1` points.
///
/// The highest wave is multiplied by `binom(2n, n)`, 1.4e11 for 20 of them: the control points of rough curves fly far
/// out, and as many digits of the curve are lost. Fewer harmonics help.
///
/// # Errors
/// [`GeometryError::Parameter`] for no harmonics, more than 500 or more than the curve has; a coefficient or a curve that
/// leaves the coordinate limit.
pub fn cyclic_from_fourier<const D: usize>(
    curve: &Fourier<D>,
    harmonics: usize,
) -> Result<Vec<Point<D>>, GeometryError> {
    let n = check(2 * harmonics.min(MOST) + 1)?;
    if n > curve.harmonics() {
        let (name, value) = ("the number of harmonics", n as f64);
        return Err(GeometryError::Parameter { name, value, wanted: "at most that of the curve" });
    }
    let mut waves = curve.waves();
    waves.truncate(n);
    for (k, row) in (1..).zip(&mut waves) {
        let factor = harmonic_factor(n, k);
        for wave in row {
            // A wave that is not there may not become 0 / 0.
            wave.amplitude = if wave.amplitude == 0.0 { 0.0 } else { wave.amplitude / factor };
        }
    }
    Ok(polygon(&Fourier::new(curve.offset(), &waves)?, 2 * n + 1))
}

/// The points of a curve at equal steps.
fn polygon<const D: usize>(curve: &Fourier<D>, count: usize) -> Vec<Point<D>> {
    (0..count).map(|i| curve.eval(i as f64 / count as f64)).collect()
}

/// The control points of the same cyclic curve with its degree raised by `by`: `2 by` points more.
///
/// # Errors
/// As [`cyclic_to_fourier`]; [`GeometryError::Parameter`] for more than 1001 points afterwards.
pub fn elevate_cyclic<const D: usize>(
    points: &[Point<D>],
    by: usize,
) -> Result<Vec<Point<D>>, GeometryError> {
    let n = check(points.len())?;
    let raised = check(points.len() + 2 * by.min(MOST))?;
    let ratio = |k| harmonic_factor(n, k) / harmonic_factor(raised, k);
    Ok(polygon(&harmonics(points, ratio)?, 2 * raised + 1))
}
