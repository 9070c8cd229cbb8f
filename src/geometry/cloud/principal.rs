//! The principal axes of a cloud.

use super::Cloud;
use crate::geometry::{Point, norm};

/// Sweeps over the three pairs of axes; the remainder is squared by every one.
const SWEEPS: usize = 12;

impl Cloud {
    /// The principal axes of the points round their mean, orthogonal unit vectors in a right-handed system, with the
    /// standard deviation along each, the largest first (Jacobi's rotations of the covariances).
    #[must_use]
    pub fn principal_axes(&self) -> [(Point<3>, f64); 3] {
        let size = norm(self.deviation());
        let unit = if size > 0.0 { size } else { 1.0 };
        let mut a = [[0.0; 3]; 3];
        let share = 1.0 / self.points().len() as f64;
        for point in self.points() {
            let x: Point<3> = std::array::from_fn(|d| (point[d] - self.centre()[d]) / unit);
            for (i, row) in a.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    *entry += share * x[i] * x[j];
                }
            }
        }
        let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for _ in 0..SWEEPS {
            for (p, q) in [(0, 1), (0, 2), (1, 2)] {
                if a[p][q] == 0.0 {
                    continue;
                }
                let theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
                let tangent = theta.signum() / (theta.abs() + theta.hypot(1.0));
                let cosine = 1.0 / tangent.hypot(1.0);
                let sine = tangent * cosine;
                for row in &mut a {
                    (row[p], row[q]) = (cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]);
                }
                let (one, other) = (a[p], a[q]);
                a[p] = std::array::from_fn(|k| cosine * one[k] - sine * other[k]);
                a[q] = std::array::from_fn(|k| sine * one[k] + cosine * other[k]);
                // The axes are rows.
                let (one, other) = (axes[p], axes[q]);
                axes[p] = std::array::from_fn(|k| cosine * one[k] - sine * other[k]);
                axes[q] = std::array::from_fn(|k| sine * one[k] + cosine * other[k]);
            }
        }
        let mut found = [0, 1, 2].map(|k| (axes[k], size * a[k][k].max(0.0).sqrt()));
        found.sort_by(|a, b| b.1.total_cmp(&a.1));
        let [(x, _), (y, _), (z, _)] = &mut found;
        *z = crate::geometry::cross(*x, *y);
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::dot;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn covariances_vanish_between_principal_axes(
            points in proptest::collection::vec(proptest::array::uniform3(-1.0..1.0), 1..20),
            scale in proptest::array::uniform3(prop_oneof![Just(0.0), Just(1.0), Just(1e-3), Just(1e140)]),
        ) {
            let points: Vec<Point<3>> = points.iter().map(|p| std::array::from_fn(|d| p[d] * scale[d])).collect();
            let cloud = Cloud::new(points).unwrap();
            let axes = cloud.principal_axes();
            let size = norm(cloud.deviation()).max(1e-300);
            for i in 0..3 {
                for j in 0..3 {
                    let expected = if i == j { 1.0 } else { 0.0 };
                    prop_assert!((dot(axes[i].0, axes[j].0) - expected).abs() < 1e-14);
                    let sum: f64 = cloud.points().iter().map(|point| {
                        let x: Point<3> = std::array::from_fn(|d| (point[d] - cloud.centre()[d]) / size);
                        dot(x, axes[i].0) * dot(x, axes[j].0)
                    }).sum();
                    let covariance = sum / cloud.points().len() as f64;
                    let expected = if i == j { (axes[i].1 / size).powi(2) } else { 0.0 };
                    prop_assert!((covariance - expected).abs() < 1e-13);
                }
            }
            prop_assert!(axes[0].1 >= axes[1].1 && axes[1].1 >= axes[2].1);
        }
    }
}
