//! The skin of spheres as a mesh of triangles.

use super::end_cap::EndCap;
use super::tube::Tube;
use crate::geometry::{CubicBezier, ParamSurface, Point};

/// Triangles between numbered vertices that go round counterclockwise as seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SkinMesh {
    /// The vertices.
    pub vertices: Vec<Point<3>>,
    /// The numbers of three vertices a triangle, from 0.
    pub triangles: Vec<[usize; 3]>,
}

/// A line of vertices round the skin.
#[derive(Clone, Copy)]
enum Ring {
    /// As many vertices as steps from this one.
    Round(usize),
    /// One vertex: a pole.
    Point(usize),
}

impl SkinMesh {
    /// Adds a tube and what closes its ends, in steps round and along.
    pub(super) fn add(
        &mut self,
        tube: &Tube,
        [first, last]: [Option<&EndCap>; 2],
        [round, along]: [usize; 2],
    ) {
        let mut before = None;
        if let Some(cap) = first {
            self.pole(&mut before, cap, round);
            self.rings(&mut before, cap, [round, along]);
        }
        let mut begin = None;
        let [_, count] = tube.spans();
        for span in 0..count {
            let lines: Vec<CubicBezier<3>> =
                (0..round).filter_map(|k| tube.line(span, 4.0 * k as f64 / round as f64)).collect();
            // The line between two spans ends the first of them.
            for step in usize::from(span > 0)..=along {
                let closing = tube.closed()[1] && (span + 1, step) == (count, along);
                let next = begin.filter(|_| closing).unwrap_or_else(|| {
                    self.ring(lines.iter().map(|line| line.eval(step as f64 / along as f64)))
                });
                begin = begin.or(Some(next));
                self.reach(&mut before, next, round);
            }
        }
        if let Some(cap) = last {
            self.rings(&mut before, cap, [round, along]);
            self.pole(&mut before, cap, round);
        }
    }

    /// Goes on to the pole of a cap.
    fn pole(&mut self, before: &mut Option<Ring>, cap: &EndCap, round: usize) {
        self.vertices.push(cap.pole());
        self.reach(before, Ring::Point(self.vertices.len() - 1), round);
    }

    /// Goes on over a cap, without its pole and its circle.
    fn rings(&mut self, before: &mut Option<Ring>, cap: &EndCap, [round, along]: [usize; 2]) {
        for step in 1..along {
            let place = |k: usize| {
                let quarters = 4 * k;
                let uv = [(quarters % round) as f64 / round as f64, step as f64 / along as f64];
                cap.eval([quarters / round, 0], uv)
            };
            let next = self.ring((0..round).filter_map(place));
            self.reach(before, next, round);
        }
    }

    /// Vertices round the skin.
    fn ring(&mut self, points: impl Iterator<Item = Point<3>>) -> Ring {
        let first = self.vertices.len();
        self.vertices.extend(points);
        Ring::Round(first)
    }

    /// Goes on to a line further along the chain, with triangles between.
    fn reach(&mut self, before: &mut Option<Ring>, next: Ring, round: usize) {
        let Some(from) = before.replace(next) else { return };
        for k in 0..round {
            let turn = (k + 1) % round;
            match (from, next) {
                (Ring::Point(pole), Ring::Round(first)) => {
                    self.triangles.push([pole, first + turn, first + k]);
                }
                (Ring::Round(first), Ring::Point(pole)) => {
                    self.triangles.push([pole, first + k, first + turn]);
                }
                (Ring::Round(a), Ring::Round(b)) => {
                    self.triangles.extend(self.split([a + k, a + turn, b + turn, b + k]));
                }
                (Ring::Point(_), Ring::Point(_)) => {}
            }
        }
    }

    /// Two triangles for a quadrilateral, along its shorter diagonal.
    fn split(&self, [a, b, c, d]: [usize; 4]) -> [[usize; 3]; 2] {
        let distance = |from: usize, to: usize| {
            let (from, to) = (self.vertices[from], self.vertices[to]);
            (0..3).fold(0.0_f64, |sum, d| sum.hypot(from[d] - to[d]))
        };
        if distance(b, d) < distance(a, c) { [[a, b, d], [b, c, d]] } else { [[a, b, c], [a, c, d]] }
    }
}
