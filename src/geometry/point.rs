//! Points of the plane and of space as plain arrays, and the checks every list of them passes.

use super::GeometryError;
use super::limits::{COORDINATE_LIMIT, MAX_POINTS};

/// A point or vector with `D` coordinates (2 in the plane, 3 in space), in the caller's units.
pub type Point<const D: usize> = [f64; D];

/// `a` at `u = 0`, `b` at `u = 1`, both exactly.
pub(super) fn lerp<const D: usize>(a: Point<D>, b: Point<D>, u: f64) -> Point<D> {
    std::array::from_fn(|d| (1.0 - u) * a[d] + u * b[d])
}

/// `a + k * b`.
pub(super) fn add_scaled<const D: usize>(a: Point<D>, k: f64, b: Point<D>) -> Point<D> {
    std::array::from_fn(|d| a[d] + k * b[d])
}

/// `k * (b - a)`.
pub(super) fn scaled_difference<const D: usize>(k: f64, a: Point<D>, b: Point<D>) -> Point<D> {
    std::array::from_fn(|d| k * (b[d] - a[d]))
}

/// The scalar product of two vectors.
#[must_use]
pub fn dot<const D: usize>(a: Point<D>, b: Point<D>) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The vector product of two vectors in space.
#[must_use]
pub fn cross(a: Point<3>, b: Point<3>) -> Point<3> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Euclidean length of a vector, without premature overflow or underflow.
#[must_use]
pub fn norm<const D: usize>(v: Point<D>) -> f64 {
    let largest = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    largest * v.iter().map(|x| (x / largest).powi(2)).sum::<f64>().sqrt()
}

/// The curvature vector of a curve by its first and second derivative: towards the centre of the circle of curvature, as
/// long as the curvature. Not a number where the curve stands still.
#[must_use]
pub fn curvature_vector<const D: usize>(slope: Point<D>, bend: Point<D>) -> Point<D> {
    let square = dot(slope, slope);
    let along = dot(bend, slope) / square;
    std::array::from_fn(|d| (bend[d] - along * slope[d]) / square)
}

/// Whether every coordinate is a number within [`COORDINATE_LIMIT`] (NaN is not).
pub(super) fn within_limit<const D: usize>(p: &Point<D>) -> bool {
    p.iter().all(|x| x.abs() <= COORDINATE_LIMIT)
}

/// The checks on every list of control points.
///
/// # Errors
/// [`GeometryError::NotFinite`] and [`GeometryError::TooLarge`] name the first bad point.
pub(super) fn check_points<const D: usize>(points: &[Point<D>]) -> Result<(), GeometryError> {
    let Some(index) = points.iter().position(|p| !within_limit(p)) else {
        return Ok(());
    };
    let number = index + 1;
    let bad = points[index].iter().copied().find(|x| x.abs() > COORDINATE_LIMIT);
    Err(match bad {
        Some(value) if value.is_finite() => GeometryError::TooLarge { number, value },
        _ => GeometryError::NotFinite { number },
    })
}

/// The check on the number of control points.
///
/// # Errors
/// [`GeometryError::TooFewPoints`] or [`GeometryError::TooManyPoints`].
pub(super) fn check_count(given: usize, needed: usize) -> Result<(), GeometryError> {
    if given < needed {
        return Err(GeometryError::TooFewPoints { given, needed });
    }
    if given > MAX_POINTS {
        return Err(GeometryError::TooManyPoints { given, most: MAX_POINTS });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_points_are_named_from_one() {
        let good = [1.0, 2.0];
        assert_eq!(check_points(&[good, good]), Ok(()));
        assert_eq!(check_points(&[good, [f64::NAN, 0.0]]), Err(GeometryError::NotFinite { number: 2 }));
        assert_eq!(check_points(&[[0.0, f64::INFINITY]]), Err(GeometryError::NotFinite { number: 1 }));
        assert_eq!(
            check_points(&[good, [-1e200, 0.0]]),
            Err(GeometryError::TooLarge { number: 2, value: -1e200 })
        );
    }

    #[test]
    fn lerp_is_exact_at_both_ends_and_norm_does_not_overflow() {
        let (a, b) = ([0.1, 1e17], [0.7, -3.0]);
        assert_eq!(lerp(a, b, 0.0), a);
        assert_eq!(lerp(a, b, 1.0), b);
        assert!((norm([3e200, 4e200]) / 5e200 - 1.0).abs() < 1e-15);
        assert!((norm([3e-200, 4e-200]) / 5e-200 - 1.0).abs() < 1e-15);
        assert_eq!(norm([0.0, 0.0, 0.0]), 0.0);
    }
}
