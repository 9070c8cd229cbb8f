//! Outlines: arcs and caps one behind the other.

use super::Circle;
use crate::geometry::{CubicBezier, ParamCurve, Point};
use std::f64::consts::TAU;

/// A part of the skin's outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// An arc from one circle to the next.
    Arc(SkinArc),
    /// A part of an end circle.
    Cap(Cap),
}

/// An arc of the skin between the touching points of two circles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkinArc {
    /// The circles where it begins and ends.
    pub circles: [usize; 2],
    /// The arc.
    pub bezier: CubicBezier<2>,
    /// The factors of its tangents beside the plain ones: 1 where nothing was in the way.
    pub scale: [f64; 2],
    /// Whether it keeps out of all discs.
    pub clear: bool,
}

impl SkinArc {
    /// The same run through backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let ([i, j], [f, g]) = (self.circles, self.scale);
        Self { circles: [j, i], bezier: self.bezier.reversed(), scale: [g, f], clear: self.clear }
    }
}

/// A part of an end circle, counterclockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cap {
    /// The number of the circle.
    pub circle: usize,
    /// The circle itself.
    pub disc: Circle,
    /// Where the cap begins.
    pub start: Point<2>,
    /// Where it ends.
    pub end: Point<2>,
    /// The directions from the centre to `start` and, counterclockwise from there, to `end`, in radians.
    pub angles: [f64; 2],
}

impl Cap {
    /// The cap between two unit normals of a circle.
    pub(super) fn new(circle: usize, disc: Circle, normals: [Point<2>; 2]) -> Self {
        let [from, to] = normals.map(|[x, y]| y.atan2(x));
        let angles = [from, if to > from { to } else { to + TAU }];
        Self { circle, disc, start: disc.point(normals[0]), end: disc.point(normals[1]), angles }
    }

    /// The angle that the cap covers, in radians: more than 0, at most 2 pi.
    #[must_use]
    pub fn sweep(&self) -> f64 {
        self.angles[1] - self.angles[0]
    }

    /// The point at `u` with its derivatives.
    fn at(&self, u: f64) -> [Point<2>; 3] {
        let sweep = self.sweep();
        let (sine, cosine) = (self.angles[0] + u * sweep).sin_cos();
        let radius = self.disc.radius;
        let point = match u {
            0.0 => self.start,
            1.0 => self.end,
            _ => self.disc.point([cosine, sine]),
        };
        let (speed, square) = (radius * sweep, radius * sweep * sweep);
        [point, [-speed * sine, speed * cosine], [-square * cosine, -square * sine]]
    }
}

/// Pieces each of which begins where the one before ends. As a curve it has a span a piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// The pieces in the order of the way, which has the discs to its left.
    pub pieces: Vec<Piece>,
    /// Whether the last piece ends where the first begins. Only where a touching point does not exist the outline is
    /// open.
    pub closed: bool,
}

impl Outline {
    /// The arcs without the caps.
    pub fn arcs(&self) -> impl Iterator<Item = &SkinArc> {
        self.pieces.iter().filter_map(|piece| match piece {
            Piece::Arc(arc) => Some(arc),
            Piece::Cap(_) => None,
        })
    }
}

impl ParamCurve<2> for Outline {
    fn spans(&self) -> usize {
        self.pieces.len()
    }

    fn closed(&self) -> bool {
        self.closed
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<2>; 3]> {
        let u = crate::geometry::param::clipped(u);
        Some(match self.pieces.get(span)? {
            Piece::Arc(SkinArc { bezier, .. }) => {
                [bezier.eval(u), bezier.derivative(u), bezier.second_derivative(u)]
            }
            Piece::Cap(cap) => cap.at(u),
        })
    }
}
