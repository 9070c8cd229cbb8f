//! The Fourier coefficients of a closed path, and how far a curve is from it.
//!
//! The coefficients are the integrals of the path times sines and cosines. The partial sum is then
//! the curve of so many harmonics with the least mean square distance at equal parameters.

use super::turn::turn;
use super::{Fourier, Harmonic, MAX_HARMONICS};
use crate::geometry::arclen::GAUSS;
use crate::geometry::point::{add_scaled, check_count, check_points, lerp, norm, scaled_difference};
use crate::geometry::{Closure, CubicBezier, Curve, GeometryError, Method, ParamCurve, Point};
use std::f64::consts::TAU;

/// The fewest points of a closed path.
const FEWEST: usize = 3;

/// The longest piece for the 16-point rule, in radians of the highest harmonic: the error of a cubic
/// times a sine is then below rounding.
const PIECE: f64 = 6.0;

/// A closed curve of cubic arcs with its parameter, which runs from 0 to 1 once round.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedPath<const D: usize> {
    arcs: Vec<CubicBezier<D>>,
    /// The parameters of the joints: that of the start, 0, and then that of every arc's end.
    joints: Vec<f64>,
}

/// How far a curve is from a path, measured at equal parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Root of the mean square distance.
    pub rms: f64,
    /// The largest distance.
    pub largest: f64,
    /// The parameter of the largest distance.
    pub at: f64,
}

impl<const D: usize> ClosedPath<D> {
    /// The closed polygon of these corners, run through with constant speed.
    ///
    /// # Errors
    /// Fewer than 3 points, too many, a bad coordinate, or all points the same
    /// ([`GeometryError::NoLength`]).
    pub fn polygon(points: &[Point<D>]) -> Result<Self, GeometryError> {
        check_count(points.len(), FEWEST)?;
        check_points(points)?;
        let ends = points.iter().cycle().skip(1);
        let sides: Vec<_> = points.iter().zip(ends).map(|(&a, &b)| (a, b)).collect();
        let lengths: Vec<f64> = sides.iter().map(|&(a, b)| norm(scaled_difference(1.0, a, b))).collect();
        let total: f64 = lengths.iter().sum();
        if total <= 0.0 {
            return Err(GeometryError::NoLength);
        }
        let side = |&(a, b)| CubicBezier { p: [a, lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b] };
        let mut joints = vec![0.0];
        let mut length = 0.0;
        joints.extend(lengths.iter().map(|side| {
            length += side;
            length / total
        }));
        Ok(Self { arcs: sides.iter().map(side).collect(), joints })
    }

    /// The closed spline through these points (2.38)-(2.46), every arc in the same time, which makes
    /// it smooth to the second derivative also as a function of the parameter.
    ///
    /// # Errors
    /// As [`Curve::through`].
    pub fn spline(points: &[Point<D>]) -> Result<Self, GeometryError> {
        let arcs = Curve::through(Method::Spline, Closure::Closed, points)?.to_cubics(1.0)?;
        let count = arcs.len() as f64;
        let joints = (0..=arcs.len()).map(|joint| joint as f64 / count).collect();
        Ok(Self { arcs, joints })
    }

    /// The arcs, in the order in which they are run through.
    #[must_use]
    pub fn arcs(&self) -> &[CubicBezier<D>] {
        &self.arcs
    }

    /// The parameters of the joints, one more than arcs: from 0, never falling, to 1.
    #[must_use]
    pub fn joints(&self) -> &[f64] {
        &self.joints
    }

    /// The point at `u`, of which whole turns are taken off.
    #[must_use]
    pub fn eval(&self, u: f64) -> Point<D> {
        let u = u - u.floor();
        let index = self.joints.partition_point(|&joint| joint <= u).clamp(1, self.arcs.len()) - 1;
        // Both lists hold an arc, and there is one joint more than arcs.
        let (from, to) = (self.joints[index], self.joints[index + 1]);
        let part = if to > from { (u - from) / (to - from) } else { 0.0 };
        self.arcs[index].eval(part.clamp(0.0, 1.0))
    }

    /// Quadrature points: parameter, weight and point of the path. The weights add up to 1.
    fn quadrature(&self, harmonics: usize) -> impl Iterator<Item = (f64, f64, Point<D>)> {
        let arcs = self.arcs.iter().zip(self.joints.windows(2));
        arcs.flat_map(move |(arc, joints)| {
            let (from, duration) = (joints[0], joints[1] - joints[0]);
            let pieces = (duration * TAU * harmonics as f64 / PIECE).ceil().max(1.0);
            let half = 0.5 / pieces;
            (0..pieces as usize).flat_map(move |piece| {
                let middle = (2 * piece + 1) as f64 * half;
                let nodes = GAUSS.iter().flat_map(|&(node, weight)| [(-node, weight), (node, weight)]);
                nodes.map(move |(node, weight)| {
                    let part = middle + half * node;
                    (from + duration * part, duration * half * weight, arc.eval(part))
                })
            })
        })
    }
}

impl<const D: usize> Fourier<D> {
    /// The curve of so many harmonics that comes nearest to a path: no other has a smaller mean
    /// square distance at equal parameters. The integrals are exact but for rounding, some 1e-14 of
    /// the path's size (for polygons these are the elliptic Fourier descriptors of Kuhl and Giardina,
    /// 1982).
    ///
    /// # Errors
    /// [`GeometryError::TooManyHarmonics`], and [`GeometryError::Overflow`] at the coordinate limit.
    pub fn fit(path: &ClosedPath<D>, harmonics: usize) -> Result<Self, GeometryError> {
        if harmonics > MAX_HARMONICS {
            return Err(GeometryError::TooManyHarmonics { given: harmonics, most: MAX_HARMONICS });
        }
        let zero = [0.0; D];
        let mut offset = zero;
        let mut sums = vec![Harmonic { sin: zero, cos: zero }; harmonics];
        for (u, weight, point) in path.quadrature(harmonics) {
            let [sin, cos] = turn(u);
            let (mut sin_k, mut cos_k) = (sin, cos);
            let share = point.map(|x| weight * x);
            offset = add_scaled(offset, 1.0, share);
            for sum in &mut sums {
                sum.sin = add_scaled(sum.sin, 2.0 * sin_k, share);
                sum.cos = add_scaled(sum.cos, 2.0 * cos_k, share);
                (sin_k, cos_k) = (sin_k * cos + cos_k * sin, cos_k * cos - sin_k * sin);
            }
        }
        Self::checked(offset, sums)
    }

    /// How far the curve is from a path, measured at `steps` equal steps of the parameter.
    ///
    /// # Errors
    /// [`GeometryError::Samples`] for no steps or too many.
    pub fn deviation(&self, path: &ClosedPath<D>, steps: usize) -> Result<Deviation, GeometryError> {
        let mut worst = Deviation { rms: 0.0, largest: 0.0, at: 0.0 };
        // The last sample is the first one again.
        for sample in self.sample(steps)?.iter().take(steps) {
            let distance = norm(scaled_difference(1.0, path.eval(sample.u), sample.point));
            if distance > worst.largest {
                (worst.largest, worst.at) = (distance, sample.u);
            }
            worst.rms += distance * distance / steps as f64;
        }
        worst.rms = worst.rms.sqrt();
        Ok(worst)
    }
}
