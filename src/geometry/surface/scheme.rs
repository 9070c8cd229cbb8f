//! What a surface is woven by: methods, topology and borders; and what becomes of its directions.

use crate::geometry::Method;

/// What a surface is joined to itself by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Topology {
    /// Four borders.
    Open,
    /// Closed in `u`; the borders v = first and v = last are one point each, the poles.
    Sphere,
    /// Closed in `u` and `v`.
    Torus,
}

impl Topology {
    /// What it is like: `plane`, `sphere`, `torus`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Open => "plane",
            Self::Sphere => "sphere",
            Self::Torus => "torus",
        }
    }

    /// Whether it is joined in the directions of `u` and `v`.
    #[must_use]
    pub fn closed(self) -> [bool; 2] {
        match self {
            Self::Open => [false, false],
            Self::Sphere => [true, false],
            Self::Torus => [true, true],
        }
    }
}

/// Where a cubic B-spline surface ends, and what becomes of poles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Border {
    /// As the book's programs draw it: border points count twice (3.36), so that the surface stops a sixth of
    /// an edge inside, with a hole around a pole.
    #[default]
    Doubled,
    /// Auxiliary points beyond the border lead the surface to it and close it over the poles (3.41-3.46,
    /// 3.51-3.56 with bias 1 and tension 0).
    Reached,
    /// The poles of a sphere are ordinary ends of every meridian, which know nothing of the opposite one: natural ends of
    /// splines (figure 3.8a), triple points of cubic B-splines (3.40), the borders (3.41) of beta-splines. The poles are
    /// singular. Other topologies have [`Border::Doubled`].
    Free,
    /// The border points of an open net of B-splines or beta-splines are auxiliary points: the patches between the
    /// inner points alone (figures 3.20a, 3.21a). Other topologies and methods have [`Border::Doubled`].
    Inner,
}

/// How a surface follows its net.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme {
    /// The method along `u`.
    pub u: Method,
    /// The method along `v`; of the same kind, perhaps with other parameters.
    pub v: Method,
    /// What is joined.
    pub topology: Topology,
    /// Where a cubic B-spline ends.
    pub border: Border,
}

impl Scheme {
    /// The same method in both directions, with the borders of the book.
    #[must_use]
    pub fn new(method: Method, topology: Topology) -> Self {
        Self { u: method, v: method, topology, border: Border::Doubled }
    }
}

/// The spans of one direction of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Direction {
    pub(super) spans: usize,
    /// How many cells of the net a span covers: 1, but all of them for the Bézier patch.
    pub(super) cells: usize,
    /// The first and the last span are half as long as the others.
    pub(super) half_ends: bool,
    pub(super) closed: bool,
    /// How many derivatives are continuous from span to span, 0 to 2.
    pub(super) smoothness: usize,
}

impl Direction {
    /// Steps that a span is drawn in, where a cell of the net has `per_cell`.
    pub(super) fn steps(&self, span: usize, per_cell: usize) -> usize {
        let end = span == 0 || span + 1 == self.spans;
        if self.half_ends && end { per_cell.div_ceil(2) } else { per_cell.saturating_mul(self.cells) }
    }

    /// How long its spans are in the parameter.
    pub(super) fn lengths(&self) -> Vec<f64> {
        let end = |span: usize| span == 0 || span + 1 == self.spans;
        (0..self.spans).map(|span| if self.half_ends && end(span) { 0.5 } else { 1.0 }).collect()
    }
}
