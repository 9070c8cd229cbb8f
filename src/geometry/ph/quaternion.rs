//! Quaternions: what turns and scales vectors of space.

use crate::geometry::{Point, cross, norm};
use std::ops::{Add, Mul, Sub};

/// The quaternion `a + b i + c j + e k` as `[a, b, c, e]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Quaternion(pub(super) [f64; 4]);

impl Quaternion {
    /// `A q A*` for the unit `q` that lies along axis 0, 1 or 2: the images of i, j and k, of length `|A|^2`.
    pub(super) fn axis(self, axis: usize) -> Point<3> {
        let [a, b, c, e] = self.0;
        match axis {
            0 => [a * a + b * b - c * c - e * e, 2.0 * (a * e + b * c), 2.0 * (b * e - a * c)],
            1 => [2.0 * (b * c - a * e), a * a - b * b + c * c - e * e, 2.0 * (a * b + c * e)],
            _ => [2.0 * (a * c + b * e), 2.0 * (c * e - a * b), a * a - b * b - c * c + e * e],
        }
    }

    /// `(A i B* + B i A*) / 2`, the polar form of `A i A*`.
    pub(super) fn mixed(self, other: Self) -> Point<3> {
        let ([a, b, c, e], [p, q, r, s]) = (self.0, other.0);
        [a * p + b * q - c * r - e * s, a * s + p * e + b * r + q * c, b * s + q * e - a * r - p * c]
    }

    /// The scalar product of two quaternions.
    pub(super) fn dot(self, other: Self) -> f64 {
        self.0.iter().zip(other.0).map(|(x, y)| x * y).sum()
    }

    /// The square root of a vector: the quaternion with `A i A* = v`, of all these the one that is a pure quaternion
    /// (in the plane of i and v, halfway between them). Zero for zero, along j for a vector opposite to i.
    pub(super) fn root(v: Point<3>) -> Self {
        let length = norm(v);
        if length == 0.0 {
            return Self::default();
        }
        let [x, y, z] = v.map(|value| value / length);
        let middle = [x + 1.0, y, z];
        let size = norm(middle);
        let [x, y, z] = if size < 1e-12 { [0.0, 1.0, 0.0] } else { middle.map(|value| value / size) };
        Self([0.0, x, y, z]) * length.sqrt()
    }
}

impl Add for Quaternion {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for Quaternion {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl Mul<f64> for Quaternion {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self(self.0.map(|value| value * factor))
    }
}

/// Three orthonormal vectors as axes of a standard position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Basis(pub(super) [Point<3>; 3]);

impl Basis {
    pub(super) const STANDARD: Self = Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);

    /// The basis with this first axis, a unit vector. The second one is the y axis made orthogonal to it, or the z
    /// axis where that is too near.
    pub(super) fn along(first: Point<3>) -> Self {
        let help = if first[1].abs() >= 0.9 { [0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0] };
        let along = crate::geometry::dot(help, first);
        let second: Point<3> = std::array::from_fn(|d| help[d] - along * first[d]);
        let size = norm(second);
        let second = second.map(|x| x / size);
        Self([first, second, cross(first, second)])
    }

    /// The coordinates of a vector by these axes.
    pub(super) fn coordinates(&self, v: Point<3>) -> Point<3> {
        self.0.map(|axis| crate::geometry::dot(axis, v))
    }

    /// The vector with these coordinates.
    pub(super) fn vector(&self, coordinates: Point<3>) -> Point<3> {
        std::array::from_fn(|d| (0..3).map(|axis| coordinates[axis] * self.0[axis][d]).sum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn product(a: Quaternion, b: Quaternion) -> Quaternion {
        let ([a, b, c, e], [p, q, r, s]) = (a.0, b.0);
        Quaternion([
            a * p - b * q - c * r - e * s,
            a * q + b * p + c * s - e * r,
            a * r - b * s + c * p + e * q,
            a * s + b * r - c * q + e * p,
        ])
    }

    fn conj(a: Quaternion) -> Quaternion {
        let [a, b, c, e] = a.0;
        Quaternion([a, -b, -c, -e])
    }

    fn unit(axis: usize) -> Quaternion {
        let mut unit = [0.0; 4];
        unit[axis + 1] = 1.0;
        Quaternion(unit)
    }

    fn vector(q: Quaternion) -> Point<3> {
        let [_, x, y, z] = q.0;
        [x, y, z]
    }

    fn close(a: Point<3>, b: Point<3>, tolerance: f64) -> bool {
        a.iter().zip(b).all(|(x, y)| (x - y).abs() <= tolerance)
    }

    proptest! {
        #[test]
        fn images_agree_with_products(a in proptest::array::uniform4(-3.0..3.0), b in proptest::array::uniform4(-3.0..3.0)) {
            let (a, b) = (Quaternion(a), Quaternion(b));
            for axis in 0..3 {
                prop_assert!(close(a.axis(axis), vector(product(product(a, unit(axis)), conj(a))), 1e-13));
            }
            let half = |a, b| vector(product(product(a, unit(0)), conj(b)) * 0.5);
            let (one, other) = (half(a, b), half(b, a));
            prop_assert!(close(a.mixed(b), std::array::from_fn(|d| one[d] + other[d]), 1e-13));
        }

        #[test]
        fn roots_have_the_vector_as_image(v in proptest::array::uniform3(-5.0..5.0)) {
            let root = Quaternion::root(v);
            prop_assert!(close(root.axis(0), v, 1e-13));
        }
    }

    #[test]
    fn special_roots() {
        assert_eq!(Quaternion::root([0.0; 3]), Quaternion::default());
        assert_eq!(Quaternion::root([-4.0, 0.0, 0.0]).axis(0), [-4.0, 0.0, 0.0]);
        let basis = Basis::along([0.0, 1.0, 0.0]);
        assert_eq!(basis.vector(basis.coordinates([1.0, 2.0, 3.0])), [1.0, 2.0, 3.0]);
    }
}
