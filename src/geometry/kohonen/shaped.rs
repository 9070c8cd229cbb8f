//! Starts that have the shape of the topology already, by the principal axes of the cloud.

use super::{KohonenError, Net, Topology};
use crate::geometry::Point;
use crate::geometry::cloud::Cloud;
use std::f64::consts::{PI, TAU};

impl Net {
    /// The net from which one grows ([`Learning::growing`](super::Learning::growing)): 2 x 2 at random where it is
    /// open. What is closed begins in its shape and large enough not to lose it: a cylinder with 2 x 8, a torus with 4 x 8, a
    /// sphere with 3 x 6. Of sixteen cylinders grown from 2 x 3 at random ten crossed the ring of points that they were to
    /// learn, and of sixteen tori from 3 x 3 and 3 x 6 all but one had a pinch.
    ///
    /// # Errors
    /// None; sizes and places are possible.
    pub fn seedling(cloud: &Cloud, topology: Topology, seed: u64) -> Result<Self, KohonenError> {
        match topology {
            Topology::Open => Self::random(cloud, [2, 2], topology, seed),
            Topology::Cylinder => Self::shaped(cloud, [2, 8], topology),
            Topology::Torus => Self::shaped(cloud, [4, 8], topology),
            Topology::Sphere => Self::shaped(cloud, [3, 6], topology),
        }
    }

    /// A start shaped like the topology and about as large as the cloud: a rectangle in the plane of the two longer
    /// principal axes, a cylinder, torus or sphere round the axis whose deviation differs most from the other two. The
    /// longer direction of a torus goes round the axis, the other round the tube.
    ///
    /// With [`Rule::radius`](super::Rule::radius) 1 the net keeps its shape while it learns. Nets of a torus need this:
    /// a larger radius, or a random start, draws them together first, and most of them unfold again with a pinch, where a
    /// ring of the net crosses the tube. It does not show in the distances of the points, but the surface is wrong there.
    ///
    /// # Errors
    /// A wrong size.
    pub fn shaped(cloud: &Cloud, size: [usize; 2], topology: Topology) -> Result<Self, KohonenError> {
        // What is too large is not made first.
        let checked = Self::random(cloud, size, topology, 0)?;
        let [m, n] = size;
        let axes = cloud.principal_axes();
        let [a, b, c] = axes;
        // The odd one last.
        let odd_first = a.1 - b.1 > b.1 - c.1;
        let [(x, dx), (y, dy), (z, dz)] =
            if odd_first && topology != Topology::Open { [b, c, a] } else { [a, b, c] };
        let centre = cloud.centre();
        let at = |p: f64, q: f64, r: f64| -> Point<3> {
            std::array::from_fn(|d| centre[d] + p * x[d] + q * y[d] + r * z[d])
        };
        let even = 3.0_f64.sqrt();
        // From -1 to 1, or round a circle.
        let along =
            |k: usize, count: usize| if count > 1 { 2.0 * k as f64 / (count - 1) as f64 - 1.0 } else { 0.0 };
        let round = |k: usize, count: usize| {
            let angle = TAU * k as f64 / count as f64;
            [angle.cos(), angle.sin()]
        };
        let place = |i: usize, j: usize| match topology {
            Topology::Open if n > m => at(even * dx * along(j, n), even * dy * along(i, m), 0.0),
            Topology::Open => at(even * dx * along(i, m), even * dy * along(j, n), 0.0),
            Topology::Cylinder => {
                let ([p, q], wide) = (round(j, n), 2.0_f64.sqrt());
                at(wide * dx * p, wide * dy * q, even * dz * along(i, m))
            }
            Topology::Sphere => {
                let ([p, q], latitude) = (round(j, n), PI * i as f64 / (m - 1) as f64);
                let (wide, high) = (even * latitude.sin(), even * latitude.cos());
                at(wide * dx * p, wide * dy * q, dz * high)
            }
            Topology::Torus => {
                // A ring of radius R with a tube of radius r has the variances R^2/2 + r^2/4, the same and r^2/2.
                let ring = (dx * dx + dy * dy - dz * dz).max(0.0).sqrt();
                let tube = (2.0_f64.sqrt() * dz).min(0.8 * ring);
                let ((k, count), (l, others)) = if n >= m { ((j, n), (i, m)) } else { ((i, m), (j, n)) };
                let ([p, q], [s, t]) =
                    (round(k, count), if others > 1 { round(l, others) } else { [0.0; 2] });
                let out = ring + tube * s;
                at(out * p, out * q, tube * t)
            }
        };
        let rows: Vec<Vec<Point<3>>> = (0..m).map(|i| (0..n).map(|j| place(i, j)).collect()).collect();
        // Only a cloud at the very limit of coordinates has a start beyond it.
        Ok(Self::new(topology, &rows).unwrap_or(checked))
    }
}
