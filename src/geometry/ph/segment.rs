//! A planar Pythagorean-hodograph segment: its hodograph is the square of a complex polynomial.

use super::bernstein::{derivative, eval, product, size};
use super::complex::Complex;
use super::roots::roots;
use crate::geometry::param::clipped;
use crate::geometry::point::within_limit;
use crate::geometry::{GeometryError, Point};

/// A planar PH curve of degree 3 or 5 on [0, 1] (Farouki and Sakkalis 1990).
///
/// With the complex polynomial `w` of degree `m` (1 for cubics, 2 for quintics) and the step `h`, the derivative is
/// `r' = h w^2` and the speed `sigma = h |w|^2`, both polynomials of degree `2 m`. So length, normal and offsets need
/// no square root. Speed and derivatives are by the segment's own parameter `u` in [0, 1].
#[derive(Clone, Debug, PartialEq)]
pub struct PhSegment {
    step: f64,
    w: Vec<Complex>,
    control: Vec<Complex>,
    hodograph: Vec<Complex>,
    second: Vec<Complex>,
    speed: Vec<f64>,
    bend: Vec<f64>,
}

impl PhSegment {
    /// The segment of these coefficients from `start` to `end`; `end` is what integration gives but for rounding.
    /// `span` is the number that an error names.
    ///
    /// # Errors
    /// [`GeometryError::Overflow`] for control points or a hodograph beyond the coordinate limit, or not finite.
    pub(super) fn new(
        span: usize,
        step: f64,
        w: &[Complex],
        [start, end]: [Point<2>; 2],
    ) -> Result<Self, GeometryError> {
        let hodograph: Vec<Complex> = product(w, w).iter().map(|&value| value * step).collect();
        let degree = hodograph.len() as f64;
        let mut control = vec![Complex::from(start)];
        for &leg in &hodograph {
            let before = control.last().copied().unwrap_or_default();
            control.push(before + leg * (1.0 / degree));
        }
        if let Some(last) = control.last_mut() {
            *last = end.into();
        }
        let conj: Vec<Complex> = w.iter().map(|value| value.conj()).collect();
        let speed = product(w, &conj).iter().map(|value| value.re * step).collect();
        if !control.iter().chain(&hodograph).all(|value| value.is_finite() && within_limit(&value.point())) {
            return Err(GeometryError::Overflow { span });
        }
        let second = derivative(&hodograph);
        Ok(Self { step, bend: bend(w), w: w.to_vec(), control, second, hodograph, speed })
    }

    /// The degree of the curve, `2 m + 1`: 3 or 5.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.hodograph.len()
    }

    /// The Bézier control points, one more than the degree.
    #[must_use]
    pub fn control(&self) -> Vec<Point<2>> {
        self.control.iter().map(|value| value.point()).collect()
    }

    /// The step `h` of `r' = h w^2`: the knot step of a spline's span, else 1.
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The Bernstein coefficients of `w = m + i n` as `[m, n]`, two or three.
    #[must_use]
    pub fn preimage(&self) -> Vec<Point<2>> {
        self.w.iter().map(|value| value.point()).collect()
    }

    /// The Bernstein coefficients of the hodograph `r'`, of degree `2 m`.
    #[must_use]
    pub fn hodograph(&self) -> Vec<Point<2>> {
        self.hodograph.iter().map(|value| value.point()).collect()
    }

    /// The Bernstein coefficients of the speed `sigma = |r'|`, of degree `2 m`.
    #[must_use]
    pub fn speed_coefficients(&self) -> &[f64] {
        &self.speed
    }

    /// The point, the first and the second derivative at `u`, which is clipped to [0, 1].
    #[must_use]
    pub fn at(&self, u: f64) -> [Point<2>; 3] {
        let u = clipped(u);
        [eval(&self.control, u), eval(&self.hodograph, u), eval(&self.second, u)].map(Complex::point)
    }

    /// The speed `|r'|` at `u` in [0, 1], never negative.
    #[must_use]
    pub fn speed(&self, u: f64) -> f64 {
        self.step * eval(&self.w, clipped(u)).norm_squared()
    }

    /// The signed curvature at `u`, positive where the curve turns left: `2 g / (h |w|^4)` with
    /// `g = Im(conj(w) w')`. `None` where the speed is zero.
    #[must_use]
    pub fn curvature(&self, u: f64) -> Option<f64> {
        let u = clipped(u);
        let square = eval(&self.w, u).norm_squared();
        let curvature = 2.0 * eval(&self.bend, u) / (self.step * square * square);
        (square > 0.0 && curvature.is_finite()).then_some(curvature)
    }

    /// The unit normal to the left of the direction of travel, `i w / conj(w)`. `None` where the speed is zero.
    #[must_use]
    pub fn normal(&self, u: f64) -> Option<Point<2>> {
        let w = eval(&self.w, clipped(u));
        normal_of(w).map(Complex::point)
    }

    /// The normal, also where the speed is zero: there the limit, from the first derivative of `w` that is not zero.
    pub(super) fn limit_normal(&self, u: f64) -> Complex {
        let mut w = self.w.clone();
        while !w.is_empty() {
            if let Some(normal) = normal_of(eval(&w, u)) {
                return normal;
            }
            w = derivative(&w);
        }
        Complex::new(0.0, 1.0)
    }

    /// Control points, hodograph, speed and `g` as coefficients.
    pub(super) fn parts(&self) -> Parts<'_> {
        Parts {
            step: self.step,
            control: &self.control,
            hodograph: &self.hodograph,
            speed: &self.speed,
            bend: &self.bend,
        }
    }

    /// Whether the segment is straight: `g` is zero everywhere.
    pub(super) fn is_straight(&self) -> bool {
        size(&self.bend) == 0.0
    }

    /// The coefficients of `w`.
    pub(super) fn w(&self) -> &[Complex] {
        &self.w
    }

    /// The parameters in [0, 1] of the inflections, in ascending order: the roots of `g`, at most two for a quintic
    /// and none for a cubic. None on a straight segment.
    #[must_use]
    pub fn inflections(&self) -> Vec<f64> {
        if self.bend.len() < 2 { Vec::new() } else { roots(&self.bend, size(&self.bend)) }
    }

    /// The parameters in [0, 1] where the curvature has an extremum inside the segment, in ascending order: the
    /// roots of `g' sigma - 2 g sigma'`. None on a straight segment.
    #[must_use]
    pub fn curvature_extrema(&self) -> Vec<f64> {
        let numerator = self.slope_numerator();
        roots(&numerator, size(&self.bend) * size(&self.speed))
    }

    /// The derivative of the curvature by `u`: `2 h (g' sigma - 2 g sigma') / sigma^3`. `None` at zero speed.
    pub(super) fn curvature_slope(&self, u: f64) -> Option<f64> {
        let u = clipped(u);
        let speed = self.speed(u);
        let slope = 2.0 * self.step * (eval(&self.slope_numerator(), u) / speed) / speed / speed;
        slope.is_finite().then_some(slope)
    }

    /// The coefficients of `g' sigma - 2 g sigma'`.
    fn slope_numerator(&self) -> Vec<f64> {
        let falling = product(&self.bend, &derivative(&self.speed));
        // `g'` is one degree lower than `sigma'` is with respect to `sigma`, so both products have the same degree.
        let rising = product(&derivative(&self.bend), &self.speed);
        if rising.is_empty() {
            falling.iter().map(|value| -2.0 * value).collect()
        } else {
            rising.iter().zip(&falling).map(|(a, b)| a - 2.0 * b).collect()
        }
    }
}

/// The parts of a segment that offsets are made of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parts<'a> {
    pub(super) step: f64,
    pub(super) control: &'a [Complex],
    pub(super) hodograph: &'a [Complex],
    pub(super) speed: &'a [f64],
    pub(super) bend: &'a [f64],
}

/// `i w / conj(w)`, a unit vector; `None` for zero.
fn normal_of(w: Complex) -> Option<Complex> {
    let length = w.norm();
    let unit = w * (1.0 / length);
    (length > 0.0 && unit.is_finite()).then(|| (unit * unit).left())
}

/// The coefficients of `g = Im(conj(w) w')`, of degree `2 m - 2`; all zero where they are rounding errors.
fn bend(w: &[Complex]) -> Vec<f64> {
    let bend = match *w {
        [a, b] => vec![a.cross(b)],
        [a, b, c] => vec![2.0 * a.cross(b), a.cross(c), 2.0 * b.cross(c)],
        _ => Vec::new(),
    };
    let largest = w.iter().fold(0.0_f64, |most, value| most.max(value.norm()));
    if size(&bend) <= 1e-14 * largest * largest { vec![0.0; bend.len()] } else { bend }
}
