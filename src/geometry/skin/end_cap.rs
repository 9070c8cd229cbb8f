//! End caps: what is left of an end sphere beyond its touching circle.

use super::Sphere;
use super::frame::Framed;
use super::tube::{Turn, clamped, quarters};
use crate::geometry::param::clipped;
use crate::geometry::{BSplineSurface, Derivatives, ParamSurface, Point, cross};
use std::f64::consts::{FRAC_PI_2, PI};

/// The part of an end sphere beyond its touching circle: direction 0 goes round in four quarter turns as in the tube,
/// direction 1 in the direction of the chain, from a pole to the circle or from the circle to a pole. Normals point
/// outwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndCap {
    framed: Framed,
    last: bool,
}

impl EndCap {
    pub(super) fn new(framed: Framed, last: bool) -> Self {
        Self { framed, last }
    }

    /// The number of the sphere.
    #[must_use]
    pub fn sphere_number(&self) -> usize {
        self.framed.circle.sphere
    }

    /// The sphere.
    #[must_use]
    pub fn sphere(&self) -> &Sphere {
        &self.framed.sphere
    }

    /// Whether it is behind the last circle of a chain, else before the first.
    #[must_use]
    pub fn is_last(&self) -> bool {
        self.last
    }

    /// The point of the sphere in the middle of the cap.
    #[must_use]
    pub fn pole(&self) -> Point<3> {
        let axis = self.framed.circle.axis;
        self.framed.sphere.point(if self.last { axis } else { axis.map(|x| -x) })
    }

    /// The angles from the axis at the beginning and end of direction 1.
    fn angles(&self) -> [f64; 2] {
        let sine = self.framed.circle.radius / self.framed.sphere.radius;
        let circle = sine.atan2(self.framed.height());
        if self.last { [circle, 0.0] } else { [PI, circle] }
    }
}

impl ParamSurface for EndCap {
    fn spans(&self) -> [usize; 2] {
        [4, 1]
    }

    fn closed(&self) -> [bool; 2] {
        [true, false]
    }

    fn at(&self, [quarter, span]: [usize; 2], [u, v]: [f64; 2]) -> Option<Derivatives> {
        if quarter > 3 || span > 0 {
            return None;
        }
        let (u, v) = (clipped(u), clipped(v));
        let (sine, cosine) = (quarters(quarter, u) * FRAC_PI_2).sin_cos();
        let ([x, y], axis) = (self.framed.across, self.framed.circle.axis);
        let outwards: Point<3> = std::array::from_fn(|d| cosine * x[d] + sine * y[d]);
        let round = cross(axis, outwards);
        let [from, to] = self.angles();
        let (angle, step) = (from + v * (to - from), to - from);
        let pole = if self.last { v == 1.0 } else { v == 0.0 };
        let (across, along) = if pole { (0.0, angle.cos().signum()) } else { angle.sin_cos() };
        let radius = self.framed.sphere.radius;
        let scaled = |k: f64, vector: Point<3>| vector.map(|c| k * radius * c);
        let mixed = |a: f64, b: f64| std::array::from_fn(|d| radius * (a * axis[d] + b * outwards[d]));
        let way: Point<3> = mixed(along, across);
        Some(Derivatives {
            point: std::array::from_fn(|d| self.framed.sphere.center[d] + way[d]),
            u: scaled(FRAC_PI_2 * across, round),
            v: mixed(-step * across, step * along),
            uu: scaled(-FRAC_PI_2 * FRAC_PI_2 * across, outwards),
            uv: scaled(FRAC_PI_2 * step * along, round),
            vv: mixed(-step * step * along, -step * step * across),
        })
    }

    /// The part of the sphere exactly: quadratic in both directions, in two pieces from the pole.
    fn to_bspline(&self) -> Option<BSplineSurface> {
        let [from, to] = self.angles();
        let meridian = [[from, 0.5 * (from + to)], [0.5 * (from + to), to]].map(Turn::new);
        let Framed { sphere, circle, across: [x, y] } = self.framed;
        let mut net = vec![vec![[0.0; 4]; 5]; 9];
        for quarter in 0..4 {
            let round = Turn::new([quarter, quarter + 1].map(|k| f64::from(k) * FRAC_PI_2));
            // Weight, and the vector outwards times weight.
            let round = round.wave(&[[0.0, 0.0, 0.0, 1.0], [x[0], x[1], x[2], 0.0], [y[0], y[1], y[2], 0.0]]);
            for (half, turn) in meridian.iter().enumerate() {
                let turn = turn.wave(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
                for (k, [a, b, c, weight]) in round.into_iter().enumerate() {
                    for (l, [other, along, across]) in turn.into_iter().enumerate() {
                        let w = weight * other;
                        let point = |d: usize, outwards: f64| {
                            let way = along * weight * circle.axis[d] + across * outwards;
                            sphere.center[d] * w + sphere.radius * way
                        };
                        net[2 * quarter as usize + k][2 * half + l] =
                            [point(0, a), point(1, b), point(2, c), w];
                    }
                }
            }
        }
        let knots = [(0..=4).map(f64::from).collect(), vec![0.0, 1.0, 2.0]];
        let mut surface = BSplineSurface::rational([2, 2], knots, [clamped(2, 4), clamped(2, 2)], &net);
        let pole = self.pole();
        for row in &mut surface.net {
            row[if self.last { 4 } else { 0 }] = pole;
        }
        if let [first, .., last] = surface.net.as_mut_slice() {
            last.clone_from(first);
        }
        Some(surface)
    }
}
