//! Surfaces that clouds are made of.

use crate::geometry::portable::exp;
use crate::geometry::{Dice, Point};

/// A known surface, about 2 wide, round the origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CloudShape {
    /// `z = (x^2 - y^2) / 2` over the square from -1 to 1.
    Saddle,
    /// The upper half of the unit sphere.
    Hemisphere,
    /// The unit sphere.
    Sphere,
    /// The torus round the z axis with the radii 1 and 0.4.
    Torus,
    /// Hills and a hollow over the square from -1 to 1.
    Terrain,
    /// The part of a cylinder of radius 1 round the z axis from -0.4 to 0.4.
    Ring,
    /// A letter S in the plane: two arcs of radius 0.5, each three quarters of a circle.
    Letter,
}

/// The radius of a torus' tube.
const TUBE: f64 = 0.4;
/// Half the height of a ring.
const HALF_HEIGHT: f64 = 0.4;
/// The radius of the arcs of a letter; their centres are as far above and below the origin.
const ARC: f64 = 0.5;
/// Hills of a terrain: middle, height, and the square of the width.
const HILLS: [([f64; 2], f64, f64); 4] = [
    ([-0.5, 0.4], 0.45, 0.12),
    ([0.45, 0.5], 0.25, 0.06),
    ([0.3, -0.5], 0.35, 0.2),
    ([-0.4, -0.45], -0.3, 0.08),
];

impl CloudShape {
    /// All of them.
    pub const ALL: [Self; 7] =
        [Self::Saddle, Self::Hemisphere, Self::Sphere, Self::Torus, Self::Terrain, Self::Ring, Self::Letter];

    /// What it is called: `saddle`, `hemisphere`, `sphere`, `torus`, `terrain`, `ring`, `letter`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Saddle => "saddle",
            Self::Hemisphere => "hemisphere",
            Self::Sphere => "sphere",
            Self::Torus => "torus",
            Self::Terrain => "terrain",
            Self::Ring => "ring",
            Self::Letter => "letter",
        }
    }

    /// Points of the surface, each moved by noise of this deviation. They depend on nothing but the arguments, to the
    /// last bit.
    pub(super) fn points(self, count: usize, noise: f64, seed: u64) -> Vec<Point<3>> {
        let mut dice = Dice::new(seed);
        let point = |_| {
            let point = self.point(&mut dice);
            let ([a, b], [c, _]) = (dice.normal(), dice.normal());
            let across = if self == Self::Letter { 0.0 } else { c };
            let moves = [a, b, across];
            std::array::from_fn(|d| point[d] + noise * moves[d])
        };
        (0..count).map(point).collect()
    }

    /// A point of the surface: even by area, for the torus by its angles and for graphs by their base.
    fn point(self, dice: &mut Dice) -> Point<3> {
        match self {
            Self::Saddle | Self::Terrain => {
                let (x, y) = (dice.signed(), dice.signed());
                [x, y, self.height([x, y])[0]]
            }
            Self::Sphere | Self::Hemisphere => {
                // Every zone is as large as high (Archimedes).
                let (z, [x, y]) = (dice.signed(), dice.direction());
                let r = (1.0 - z * z).sqrt();
                [r * x, r * y, if self == Self::Sphere { z } else { z.abs() }]
            }
            Self::Torus => {
                let ([a, b], [x, y]) = (dice.direction(), dice.direction());
                let r = 1.0 + TUBE * a;
                [r * x, r * y, TUBE * b]
            }
            Self::Ring => {
                let [x, y] = dice.direction();
                [x, y, HALF_HEIGHT * dice.signed()]
            }
            Self::Letter => {
                let half = if dice.signed() < 0.0 { -1.0 } else { 1.0 };
                loop {
                    let [x, y] = dice.direction();
                    // The quarter that the upper arc leaves out.
                    if x < 0.0 || y > 0.0 {
                        return [half * ARC * x, half * ARC * (y + 1.0), 0.0];
                    }
                }
            }
        }
    }

    /// The height of a graph over a place with its derivatives.
    fn height(self, [x, y]: [f64; 2]) -> [f64; 3] {
        if self == Self::Saddle {
            return [(x * x - y * y) / 2.0, x, -y];
        }
        HILLS.iter().fold([0.0; 3], |[z, zx, zy], &([a, b], height, width)| {
            let (x, y) = (x - a, y - b);
            let hill = height * exp(-(x * x + y * y) / width);
            [z + hill, zx - 2.0 * x / width * hill, zy - 2.0 * y / width * hill]
        })
    }

    /// The distance of a point from the surface, which goes on beyond its borders (from the letter it is in the plane and
    /// in space to its very ends). Of saddle and terrain to first order: the height above them, over the slope.
    #[must_use]
    pub fn distance(self, [x, y, z]: Point<3>) -> f64 {
        match self {
            Self::Saddle | Self::Terrain => {
                let [height, zx, zy] = self.height([x, y]);
                (z - height).abs() / (1.0 + zx * zx + zy * zy).sqrt()
            }
            Self::Sphere | Self::Hemisphere => (x.hypot(y).hypot(z) - 1.0).abs(),
            Self::Torus => ((x.hypot(y) - 1.0).hypot(z) - TUBE).abs(),
            Self::Ring => (x.hypot(y) - 1.0).abs(),
            Self::Letter => {
                let arc = |half: f64| {
                    let (x, y) = (half * x, half * y - ARC);
                    if x < 0.0 || y > 0.0 {
                        return (x.hypot(y) - ARC).abs();
                    }
                    (x - ARC).hypot(y).min(x.hypot(y + ARC))
                };
                arc(1.0).min(arc(-1.0)).hypot(z)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::cloud::Cloud;

    #[test]
    fn points_without_noise_are_on_the_surface() {
        for shape in CloudShape::ALL {
            let cloud = Cloud::of_shape(shape, 500, 0.0, 3).unwrap();
            let furthest = cloud.points().iter().map(|point| shape.distance(*point)).fold(0.0, f64::max);
            assert!(furthest < 1e-15, "{}: {furthest:e}", shape.name());
            let size = cloud.bounds().size();
            assert!(size[0] > 0.9 && size[1] > 1.8, "{}: {size:?}", shape.name());
        }
    }

    #[test]
    fn noise_has_its_deviation_across_the_surface() {
        for shape in CloudShape::ALL {
            let cloud = Cloud::of_shape(shape, 4000, 0.02, 3).unwrap();
            let sum: f64 = cloud.points().iter().map(|point| shape.distance(*point).powi(2)).sum();
            let rms = (sum / 4000.0).sqrt();
            assert!((rms / 0.02 - 1.0).abs() < 0.05, "{}: {rms}", shape.name());
            assert_eq!(cloud.bounds().size()[2] == 0.0, shape == CloudShape::Letter);
        }
    }

    #[test]
    fn a_seed_makes_the_same_cloud_again() {
        let of = |seed| CloudShape::Terrain.points(100, 0.02, seed);
        assert_eq!(of(1), of(1));
        assert_ne!(of(1), of(2));
    }
}
