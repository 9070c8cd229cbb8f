//! Reasons why a document describes no curve or surface.

use crate::file::{Format, MAX_POINTS, Method};
use crate::geometry::GeometryError;
use crate::geometry::ec::EcError;
use crate::geometry::knots::KnotError;
use crate::geometry::skin::SkinError;
use std::fmt;

/// Why a document describes no curve or surface, or none that an editor can edit.
#[derive(Clone, Debug, PartialEq)]
pub enum DesignError {
    /// It holds neither a curve nor a surface.
    NoShape,
    /// Neither the document nor the user names a method.
    NoMethod,
    /// The method needs something that the document does not have.
    Needs(Method),
    /// The method takes a rule for its knots, and not the knots themselves.
    OnlyRules(Method),
    /// The derivative at an end has another number of coordinates than the points.
    EndCoordinates {
        /// How many it has.
        given: usize,
        /// How many the points have.
        needed: usize,
    },
    /// A Hermite patch needs a matrix of points, tangents and twists.
    NeedsTwists,
    /// An `.FHC` file has no other method than hermite.
    OnlyHermite,
    /// The method is one of curves only.
    ForCurves(Method),
    /// The method has curves of the plane only.
    ForPlane(Method),
    /// The method's curves have no exact lengths and offsets; those of PH curves do.
    NoPh(Method),
    /// The method is one of open nets only.
    OpenOnly(Method),
    /// A gap in a net of rational patches, by its place.
    PatchMissing([usize; 2]),
    /// Two patches at one place of a net.
    PatchTwice([usize; 2]),
    /// A Hermite matrix of another size than 4 x 4.
    NoMatrix,
    /// A control point, counted from 1, lies outside of the field or of space.
    Outside(usize, Vec<f64>),
    /// More control points than an editor holds.
    TooMany(usize),
    /// A net of another topology.
    OtherNet {
        /// What is wanted.
        wanted: Format,
        /// What it is.
        found: Format,
    },
    /// A net that is too small, too large, ragged, or too far away.
    NetSize {
        /// Its numbers of rows and columns.
        found: [usize; 2],
        /// The fewest.
        least: [usize; 2],
        /// The most in either direction.
        most: usize,
    },
    /// The mathematics has no answer.
    Geometry(GeometryError),
    /// Knots, weights or points of a curve by its knots are wrong.
    Knots(KnotError),
    /// Circles, or how they hang together, are wrong.
    Skin(SkinError),
    /// Fewer control points than the order of a curve by its knots.
    Unfinished {
        /// How many there are.
        points: usize,
        /// How many are needed.
        order: usize,
    },
    /// An item over extended Chebyshev spaces has no curve or surface.
    Ec {
        /// The item's number, from 1; `None` where there is one only.
        item: Option<usize>,
        /// Why.
        error: EcError,
    },
}

impl From<GeometryError> for DesignError {
    fn from(error: GeometryError) -> DesignError {
        DesignError::Geometry(error)
    }
}

impl From<KnotError> for DesignError {
    fn from(error: KnotError) -> DesignError {
        DesignError::Knots(error)
    }
}

impl From<SkinError> for DesignError {
    fn from(error: SkinError) -> DesignError {
        DesignError::Skin(error)
    }
}

impl fmt::Display for DesignError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DesignError::NoShape => f.write_str(
                "this file holds no curve and no surface; .IP2, .IC2, .IP3, .GBP, the nets .FHC to .ZYP and .PN, .KCG to .KCJ, .RBC, .RBS, .CSM, .CSF, .ALP and .KOR do",
            ),
            DesignError::NoMethod => f.write_str("which method? Give --method, as in --method spline"),
            DesignError::Needs(Method::Fourier) => {
                f.write_str("fourier needs coefficients, as a .GBP file has them")
            }
            DesignError::Needs(Method::Hermite) => {
                f.write_str("hermite needs tangents, as an .IC2 file with its .EC2 has them")
            }
            DesignError::Needs(method) => write!(f, "{} needs more than this file has", method.name()),
            DesignError::OnlyRules(method) => write!(
                f,
                "{} takes a rule for its knots (uniform, chord or centripetal); knots themselves are for bspline",
                method.name()
            ),
            DesignError::EndCoordinates { given, needed } => {
                write!(f, "the derivative at an end has {given} coordinates; the points have {needed}")
            }
            DesignError::NeedsTwists => {
                f.write_str("hermite needs tangents and twists, as an .FHC file has them")
            }
            DesignError::OnlyHermite => f.write_str(
                "an .FHC file holds points, tangents and twists; it has no other method than hermite",
            ),
            DesignError::ForCurves(Method::Coons) => {
                f.write_str("coons is for curves; of surfaces it is called local")
            }
            DesignError::ForCurves(method) => write!(
                f,
                "{} is for curves; surfaces have spline, local, bezier, bspline2, bspline3 and beta",
                method.name()
            ),
            DesignError::ForPlane(method) => {
                write!(f, "{} is for curves of the plane; in space there is phhermite", method.name())
            }
            DesignError::NoPh(method) => write!(
                f,
                "{} has no exact lengths and offsets; PH curves do: phspline, phhermite, and in the plane phcubic",
                method.name()
            ),
            DesignError::OpenOnly(method) => write!(
                f,
                "{} needs an open net of points, as .PN and .FPS files have it; surfaces that are closed like a sphere or \
                 a ring do not fit into one chart of normals",
                method.name()
            ),
            DesignError::PatchMissing([i, j]) => {
                write!(f, "patch ({i}, {j}) is missing; patches form a net without gaps from (0, 0)")
            }
            DesignError::PatchTwice([i, j]) => write!(f, "patch ({i}, {j}) is there twice"),
            DesignError::NoMatrix => f.write_str("a Hermite matrix has 4 rows of 4"),
            DesignError::Outside(number, place) => {
                write!(f, "point {number} at {place:?} lies outside of what the editor shows")
            }
            DesignError::TooMany(count) => {
                write!(f, "{count} control points; there may be {MAX_POINTS} at most")
            }
            DesignError::OtherNet { wanted, found } => {
                write!(f, "this is the net of {found} files; this program takes nets of {wanted} files")
            }
            DesignError::NetSize { found: [rows, columns], least: [k, l], most } => write!(
                f,
                "a net of {rows} x {columns} points; there must be {k} x {l} to {most} x {most}, of coordinates up to a million"
            ),
            DesignError::Geometry(error) => error.fmt(f),
            DesignError::Knots(error) => error.fmt(f),
            DesignError::Skin(error) => error.fmt(f),
            DesignError::Unfinished { points, order } => write!(
                f,
                "{points} control points are no curve of order {order} yet; {order} are needed"
            ),
            DesignError::Ec { item: None, error } => error.fmt(f),
            DesignError::Ec { item: Some(number), error } => write!(f, "item {number}: {error}"),
        }
    }
}

impl std::error::Error for DesignError {}
