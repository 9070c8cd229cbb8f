//! Closed curves as trigonometric polynomials (equation 2.8): evaluation, derivative, box, cubic
//! arcs; and in the room behind, the coefficients that come nearest to a given closed path.
//!
//! A coordinate is `offset + sum of amplitude_k sin(k t + pi phase_k)`, `k = 1, 2, …`. The parameter
//! here is `u = t / 2 pi`, one turn, as the spans of every other curve have it.

mod bound;
mod fit;
mod turn;

pub use fit::{ClosedPath, Deviation};

use super::limits::COORDINATE_LIMIT;
use super::param::{ParamCurve, check_tolerance, clipped};
use super::point::within_limit;
use super::{BoundingBox, CubicBezier, GeometryError, Point};
use std::f64::consts::{PI, TAU};
use turn::turn;

/// The largest number of harmonics of one curve.
pub const MAX_HARMONICS: usize = 1 << 12;

/// The largest number of cubic arcs.
const MAX_ARCS: f64 = 1048576.0;

/// Smallest tolerance of the cubic arcs, by the sum of the amplitudes.
const LEAST_TOLERANCE: f64 = 1e-12;

/// How many samples are computed side by side, so that the compiler can use vector registers.
const LANES: usize = 8;

/// One harmonic of one coordinate: `amplitude sin(k t + pi phase)`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wave {
    /// The amplitude in the units of the coordinate; a negative one is a shift by half a period.
    pub amplitude: f64,
    /// The phase in units of pi: 2 is a whole period.
    pub phase: f64,
}

/// A harmonic in all coordinates, as `sin * sin(k t) + cos * cos(k t)`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Harmonic<const D: usize> {
    sin: Point<D>,
    cos: Point<D>,
}

/// A closed curve (2.8) with checked coefficients, so that everything computed from it is finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Fourier<const D: usize> {
    offset: Point<D>,
    /// Harmonic `k` stands at `k - 1`.
    harmonics: Vec<Harmonic<D>>,
}

impl<const D: usize> Fourier<D> {
    /// The curve of an offset and the waves `k = 1, 2, …` of every coordinate.
    ///
    /// # Errors
    /// [`GeometryError::Coefficient`] for one that is not finite or larger than
    /// [`COORDINATE_LIMIT`](super::COORDINATE_LIMIT) (phases may have any size),
    /// [`GeometryError::TooManyHarmonics`], and [`GeometryError::Overflow`] when the sum of the amplitudes leaves
    /// the limit.
    pub fn new(offset: Point<D>, waves: &[[Wave; D]]) -> Result<Self, GeometryError> {
        let bad = |name, harmonic, value| Err(GeometryError::Coefficient { name, harmonic, value });
        if let Some(&value) = offset.iter().find(|value| !within_limit(&[**value])) {
            return bad("offset", 0, value);
        }
        for (index, wave) in waves.iter().enumerate().flat_map(|(k, row)| row.iter().map(move |w| (k, w))) {
            if !within_limit(&[wave.amplitude]) {
                return bad("amplitude", index + 1, wave.amplitude);
            }
            if !wave.phase.is_finite() {
                return bad("phase", index + 1, wave.phase);
            }
        }
        let harmonic = |row: &[Wave; D]| {
            let turns = row.map(|wave| turn(0.5 * wave.phase));
            Harmonic {
                sin: std::array::from_fn(|d| row[d].amplitude * turns[d][1]),
                cos: std::array::from_fn(|d| row[d].amplitude * turns[d][0]),
            }
        };
        Self::checked(offset, waves.iter().map(harmonic).collect())
    }

    /// The curve of coefficients that are numbers, if it stays within the limit.
    fn checked(offset: Point<D>, harmonics: Vec<Harmonic<D>>) -> Result<Self, GeometryError> {
        if harmonics.len() > MAX_HARMONICS {
            return Err(GeometryError::TooManyHarmonics { given: harmonics.len(), most: MAX_HARMONICS });
        }
        let curve = Self { offset, harmonics };
        let reach = curve.sums(|_| 1.0);
        match (0..D).all(|d| offset[d].abs() + reach[d] <= COORDINATE_LIMIT) {
            true => Ok(curve),
            false => Err(GeometryError::Overflow { span: 0 }),
        }
    }

    /// The number of harmonics.
    #[must_use]
    pub fn harmonics(&self) -> usize {
        self.harmonics.len()
    }

    /// The constant part: the mean of the curve over a turn.
    #[must_use]
    pub fn offset(&self) -> Point<D> {
        self.offset
    }

    /// The waves `k = 1, 2, …` with amplitudes that are not negative and phases in [0, 2).
    #[must_use]
    pub fn waves(&self) -> Vec<[Wave; D]> {
        let wave = |sin: f64, cos: f64| {
            let phase = cos.atan2(sin) / PI;
            let phase = if phase < 0.0 { phase + 2.0 } else { phase };
            // What lies below 0 by less than rounding would become 2; -0 becomes 0.
            Wave { amplitude: sin.hypot(cos), phase: if phase < 2.0 { phase + 0.0 } else { 0.0 } }
        };
        self.harmonics.iter().map(|h| std::array::from_fn(|d| wave(h.sin[d], h.cos[d]))).collect()
    }

    /// The point at `u`; one turn is 1, and any finite `u` will do. The error is below 1e-14 of the
    /// sum of the amplitudes for 20 harmonics, and grows with their number.
    #[must_use]
    pub fn eval(&self, u: f64) -> Point<D> {
        let [point] = self.sum([turn(u)]);
        point
    }

    /// The derivative by `u` at any finite `u`.
    #[must_use]
    pub fn derivative(&self, u: f64) -> Point<D> {
        let [_, derivative, _] = self.derivatives(turn(u));
        derivative
    }

    /// The derivative by `u` as a curve of its own. Its coefficients may pass the coordinate limit by
    /// the factor `2 pi k`, which is far from overflow.
    #[must_use]
    pub fn hodograph(&self) -> Self {
        let harmonic = |(k, h): (usize, &Harmonic<D>)| {
            let speed = TAU * (k + 1) as f64;
            Harmonic { sin: h.cos.map(|c| -speed * c), cos: h.sin.map(|s| speed * s) }
        };
        Self { offset: [0.0; D], harmonics: self.harmonics.iter().enumerate().map(harmonic).collect() }
    }

    /// The points at `N` places given by sine and cosine of `t`. Sine and cosine of `k t` come by
    /// turning on from `k - 1`, which loses no more than a rounding error a step.
    fn sum<const N: usize>(&self, turns: [[f64; 2]; N]) -> [Point<D>; N] {
        let (sin, cos) = (turns.map(|[sin, _]| sin), turns.map(|[_, cos]| cos));
        let (mut sin_k, mut cos_k) = (sin, cos);
        let mut sums = self.offset.map(|offset| [offset; N]);
        for harmonic in &self.harmonics {
            for (d, sum) in sums.iter_mut().enumerate() {
                for lane in 0..N {
                    sum[lane] += harmonic.sin[d] * sin_k[lane] + harmonic.cos[d] * cos_k[lane];
                }
            }
            for lane in 0..N {
                let (s, c) = (sin_k[lane], cos_k[lane]);
                sin_k[lane] = s * cos[lane] + c * sin[lane];
                cos_k[lane] = c * cos[lane] - s * sin[lane];
            }
        }
        std::array::from_fn(|lane| std::array::from_fn(|d| sums[d][lane]))
    }

    /// The sum over all harmonics of amplitude times a factor of `k`, in every coordinate.
    fn sums(&self, factor: impl Fn(f64) -> f64) -> Point<D> {
        let mut sums = [0.0; D];
        for (k, harmonic) in self.harmonics.iter().enumerate() {
            let factor = factor((k + 1) as f64);
            for (d, sum) in sums.iter_mut().enumerate() {
                *sum += factor * harmonic.sin[d].hypot(harmonic.cos[d]);
            }
        }
        sums
    }

    /// One coordinate times a sign: the offset, then sine and cosine coefficient of every harmonic.
    fn terms(&self, d: usize, sign: f64) -> bound::Terms {
        let pairs = self.harmonics.iter().map(|h| [sign * h.sin[d], sign * h.cos[d]]).collect();
        bound::Terms { offset: sign * self.offset[d], pairs }
    }

    /// Point, first and second derivative by `u` at a place given by sine and cosine of `t`; the point is the very
    /// one of [`Fourier::sum`].
    fn derivatives(&self, [sin, cos]: [f64; 2]) -> [Point<D>; 3] {
        let (mut sin_k, mut cos_k) = (sin, cos);
        let [mut point, mut first, mut second] = [self.offset, [0.0; D], [0.0; D]];
        for (k, harmonic) in self.harmonics.iter().enumerate() {
            let speed = TAU * (k + 1) as f64;
            for d in 0..D {
                let value = harmonic.sin[d] * sin_k + harmonic.cos[d] * cos_k;
                point[d] += value;
                first[d] += speed * (harmonic.sin[d] * cos_k - harmonic.cos[d] * sin_k);
                second[d] -= speed * speed * value;
            }
            (sin_k, cos_k) = (sin_k * cos + cos_k * sin, cos_k * cos - sin_k * sin);
        }
        [point, first, second]
    }
}

/// One span, once round. The last sample is the first one again, exactly.
impl<const D: usize> ParamCurve<D> for Fourier<D> {
    fn spans(&self) -> usize {
        1
    }

    fn closed(&self) -> bool {
        true
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        (span == 0).then(|| self.derivatives(turn(clipped(u))))
    }

    fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        (span == 0).then(|| self.eval(clipped(u)))
    }

    fn sample_span(&self, span: usize, out: &mut [Point<D>]) {
        if span > 0 {
            return;
        }
        let steps = out.len().saturating_sub(1).max(1) as f64;
        let at = |j: usize| turn(j as f64 / steps);
        let (blocks, rest) = out.as_chunks_mut::<LANES>();
        let done = blocks.len() * LANES;
        for (block, points) in blocks.iter_mut().enumerate() {
            *points = self.sum(std::array::from_fn(|lane| at(block * LANES + lane)));
        }
        for (j, point) in rest.iter_mut().enumerate() {
            [*point] = self.sum([at(done + j)]);
        }
    }

    /// A box round the curve: never too small but for rounding, and too large by no more than 1e-12
    /// of the sum of the amplitudes.
    fn bounding_box(&self) -> Option<BoundingBox<D>> {
        Some(BoundingBox {
            min: std::array::from_fn(|d| -bound::largest_value(&self.terms(d, -1.0))),
            max: std::array::from_fn(|d| bound::largest_value(&self.terms(d, 1.0))),
        })
    }

    /// Cubic arcs of equal steps of `u` that follow the curve at every parameter within `tolerance`,
    /// with its points and tangents at the joints. The bound holds for sure: a cubic with the ends
    /// and end derivatives of a function differs by no more than its fourth derivative times
    /// `h^4 / 384`.
    ///
    /// # Errors
    /// `tolerance` not positive or NaN; [`GeometryError::ToleranceTooSmall`] below 1e-12 of the sum
    /// of the amplitudes, or when more than a million arcs were needed.
    fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        check_tolerance(tolerance)?;
        let fourth = super::point::norm(self.sums(|k| (TAU * k).powi(4)));
        let for_arcs = fourth / 384.0 / MAX_ARCS.powi(4);
        let least = for_arcs.max(LEAST_TOLERANCE * super::point::norm(self.sums(|_| 1.0)));
        if tolerance < least {
            return Err(GeometryError::ToleranceTooSmall { value: tolerance, least });
        }
        // Between 1 and a million by the check above.
        let steps = (fourth / 384.0 / tolerance).sqrt().sqrt().ceil().clamp(1.0, MAX_ARCS);
        let points = self.polyline(steps as usize)?;
        let tangents = self.hodograph().polyline(steps as usize)?;
        let scaled = |v: &Point<D>| v.map(|x| x / steps);
        let arc = |(p, v): (&[Point<D>], &[Point<D>])| {
            CubicBezier::from_hermite(p[0], p[1], scaled(&v[0]), scaled(&v[1]))
        };
        Ok(points.windows(2).zip(tangents.windows(2)).map(arc).collect())
    }
}

#[cfg(test)]
mod tests;
