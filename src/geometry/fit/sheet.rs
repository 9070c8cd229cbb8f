//! Control points laid out for fast evaluation, and the foot of a point on their surface.

use super::axis::{Axis, ORDER};
use super::step::Tangents;
use crate::geometry::{Point, cross, dot};

/// Steps of Gauss and Newton of one correction.
const STEPS: usize = 2;
/// How often a step that leads away is halved.
const HALVINGS: usize = 3;
/// Corrections until a foot is settled, and the part of the distance that one more must take off.
const MOST_CORRECTIONS: usize = 20;
const SETTLED: f64 = 1e-9;

/// The control points of a surface, going on over its seams, with one number of room so that a point is two vectors.
#[derive(Clone, Debug)]
pub(super) struct Sheet {
    axes: [Axis; 2],
    stride: usize,
    points: Vec<[f64; 4]>,
}

/// A place of a surface with its tangents.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) point: Point<3>,
    pub(super) u: Point<3>,
    pub(super) v: Point<3>,
}

/// What is nearest to a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    pub(super) parameters: [f64; 2],
    /// The distance, negative on the side from which `s_u x s_v` points away; for a curve to the right of it, seen from
    /// above.
    pub(super) distance: f64,
}

impl Sheet {
    /// The surface of control points in rows.
    pub(super) fn new(axes: &[Axis; 2], nodes: &[Point<3>]) -> Self {
        let stride = axes[1].spans() + ORDER - 1;
        let rows = axes[0].spans() + ORDER - 1;
        let places = (0..rows).flat_map(|e| (0..stride).map(move |f| (e, f)));
        let node = |(e, f): (usize, usize)| {
            let index = axes[0].node(e) * axes[1].count() + axes[1].node(f);
            let [x, y, z] = nodes.get(index).copied().unwrap_or([0.0; 3]);
            [x, y, z, 0.0]
        };
        Self { stride, points: places.map(node).collect(), axes: axes.clone() }
    }

    /// The place at parameters from 0 to 1.
    #[inline]
    pub(super) fn at(&self, [u, v]: [f64; 2]) -> Place {
        let ((i, s), (j, t)) = (self.axes[0].place(u), self.axes[1].place(v));
        let ([nu, du], [nv, dv]) = (self.axes[0].slopes(i, s), self.axes[1].slopes(j, t));
        let [mut point, mut along, mut across] = [[0.0; 4]; 3];
        for a in 0..ORDER {
            let first = (i + a) * self.stride + j;
            let Some(row) = self.points.get(first..first + ORDER) else { continue };
            let [mut line, mut slope] = [[0.0; 4]; 2];
            for b in 0..ORDER {
                for d in 0..4 {
                    line[d] += nv[b] * row[b][d];
                    slope[d] += dv[b] * row[b][d];
                }
            }
            for d in 0..4 {
                point[d] += nu[a] * line[d];
                along[d] += du[a] * line[d];
                across[d] += nu[a] * slope[d];
            }
        }
        let space = |[x, y, z, _]: [f64; 4]| [x, y, z];
        Place { point: space(point), u: space(along), v: space(across) }
    }

    /// The foot of a point from parameters near it, as exactly as it can be told.
    pub(super) fn settled(&self, point: Point<3>, parameters: [f64; 2]) -> Foot {
        let mut foot = self.foot(point, parameters);
        for _ in 0..MOST_CORRECTIONS {
            let next = self.foot(point, foot.parameters);
            let shorter = foot.distance.abs() - next.distance.abs();
            let settled = shorter <= SETTLED * foot.distance.abs();
            foot = next;
            if settled {
                break;
            }
        }
        foot
    }

    /// Corrects the parameters of a point: two steps, each halved until the distance falls.
    pub(super) fn foot(&self, point: Point<3>, parameters: [f64; 2]) -> Foot {
        let closed = [self.axes[0].closed(), self.axes[1].closed()];
        let rest = |place: &Place| -> Point<3> { std::array::from_fn(|d| point[d] - place.point[d]) };
        let mut at = parameters;
        let mut place = self.at(at);
        let mut way = rest(&place);
        let mut square = dot(way, way);
        'steps: for _ in 0..STEPS {
            let metric = [dot(place.u, place.u), dot(place.u, place.v), dot(place.v, place.v)];
            let tangents = Tangents { metric, way: [dot(way, place.u), dot(way, place.v)] };
            let target = tangents.target(at, closed);
            let mut share = 1.0;
            for _ in 0..=HALVINGS {
                let next = [0, 1].map(|d| self.axes[d].inside(at[d] + share * (target[d] - at[d])));
                let there = self.at(next);
                let way_there = rest(&there);
                let square_there = dot(way_there, way_there);
                if square_there < square {
                    (at, place, way, square) = (next, there, way_there, square_there);
                    continue 'steps;
                }
                share *= 0.5;
            }
            break;
        }
        let side = if self.axes[1].is_point() {
            cross(place.u, way)[2]
        } else if self.axes[0].is_point() {
            cross(place.v, way)[2]
        } else {
            dot(cross(place.u, place.v), way)
        };
        Foot { parameters: at, distance: square.sqrt().copysign(if side < 0.0 { -1.0 } else { 1.0 }) }
    }
}
