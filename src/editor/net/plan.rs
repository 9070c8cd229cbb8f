//! Plans: what distinguishes one surface program from another.

use crate::design::nets;
use crate::file::{Method, NetKind};
use crate::geometry::Point;
use crate::ui::Manual;

/// A surface program.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// Its manual.
    pub manual: Manual,
    /// The kind of net that it saves, which determines the topology.
    pub kind: NetKind,
    /// Other kinds of net that it reads.
    pub reads: &'static [NetKind],
    /// The methods that make a surface from the net.
    pub family: Family,
    /// The net of a new configuration.
    pub start: Start,
    /// Steps that a cell of the net is drawn in.
    pub steps: usize,
    /// The initial direction of view.
    pub view: Point<3>,
}

/// The methods of a program with their parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// The Hermite patch (3.17): corners, tangents and twists.
    Hermite,
    /// Cubic splines (3.20)-(3.22).
    Spline,
    /// Cubic splines over a fixed grid; only heights change.
    Heights,
    /// Local splines with a coefficient in each direction (3.61).
    Local,
    /// The Bézier patch (3.24).
    Bezier,
    /// Quadratic or cubic B-splines (3.25), (3.36).
    BSpline,
    /// Beta-splines with bias and tension in each direction (3.41).
    Beta,
    /// Surfaces through points with normals, whose offsets are exact (Pythagorean normals).
    Normals,
}

/// The net of a new configuration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// The matrix of a flat square of the given side, with zero vectors.
    Square(f64),
    /// A flat grid in the xy plane with the given spacing.
    Plane(f64),
    /// A sphere of the given radius.
    Sphere(f64),
    /// A torus: major and minor radius.
    Torus(f64, f64),
    /// A vault over a grid in the xy plane: the spacing, and the height of its middle.
    Vault(f64, f64),
}

impl Plan {
    /// The net of a new configuration, row by row.
    pub(super) fn net(&self) -> Vec<Vec<Point<3>>> {
        let shape = self.kind.shape();
        match self.start {
            Start::Square(side) => nets::square(side),
            Start::Plane(spacing) => nets::plane(shape, spacing),
            Start::Sphere(radius) => nets::sphere(shape, radius),
            Start::Torus(ring, tube) => nets::torus(shape, ring, tube),
            Start::Vault(spacing, height) => nets::vault(shape, spacing, height),
        }
    }
}

impl Family {
    /// The method of a net that names none.
    pub(super) fn method(self) -> Method {
        match self {
            Family::Hermite => Method::Hermite,
            Family::Spline | Family::Heights => Method::Spline,
            Family::Local => Method::Local,
            Family::Bezier => Method::Bezier,
            Family::BSpline => Method::BSpline3,
            Family::Beta => Method::Beta,
            Family::Normals => Method::Pn,
        }
    }
}
