//! The errors of writing pictures and models.

use crate::geometry::{COORDINATE_LIMIT, GeometryError};
use std::fmt;

/// Why a picture or model cannot be written. Items of a kind are counted from 1 in the order of adding.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureError {
    /// A coordinate is NaN, infinite or beyond [`COORDINATE_LIMIT`].
    Coordinate {
        /// The item and its part, as in "curve 1, arc 3".
        item: String,
        /// The coordinate.
        value: f64,
    },
    /// A width, radius or dash is out of range.
    Style {
        /// The item, as in "polyline 2".
        item: String,
        /// Which size it is: width, radius or dash.
        name: &'static str,
        /// The value given.
        value: f64,
        /// The allowed range, as the end of a sentence.
        wanted: &'static str,
    },
    /// The width of the picture is out of range.
    Width {
        /// The width asked for, in pixels.
        given: u32,
        /// The smallest width in pixels.
        least: u32,
        /// The largest width in pixels.
        most: u32,
    },
    /// The caption is too long.
    Caption {
        /// Its length in characters.
        given: usize,
        /// The greatest length in characters.
        most: usize,
    },
    /// The mathematics has no answer.
    Geometry(GeometryError),
    /// A surface that is no more than a line or a point.
    NoArea,
    /// A closed surface that lies in a plane.
    Flat,
    /// A surface of which single precision leaves nothing.
    Confused,
    /// A coordinate does not fit into the single precision of STL.
    Single {
        /// The coordinate.
        value: f64,
    },
    /// More vertices or triangles than the format can count.
    TooManyVertices,
    /// The degree of a surface is higher than CAD programs read.
    Degree {
        /// The degree.
        given: usize,
        /// The highest that is written.
        most: usize,
    },
    /// The surface is not a B-spline surface, so it has no exact form in a file.
    NoExactForm,
    /// Nothing is left that could be written.
    NoCurve,
    /// The font or the PNG encoder failed, with its message.
    Encoding(String),
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FigureError::Geometry(error) => error.fmt(f),
            Self::Coordinate { item, value } if value.is_finite() => {
                write!(f, "{item}: coordinate {value:e} is too large; at most {COORDINATE_LIMIT:e}")
            }
            Self::Coordinate { item, value } => {
                write!(f, "{item}: coordinate {value} is not a finite number")
            }
            Self::Style { item, name, value, wanted } => {
                write!(f, "{item}: {name} is {value}, must be {wanted}")
            }
            Self::Width { given, least, most } => {
                write!(f, "a picture {given} pixels wide; must be {least} to {most}")
            }
            Self::Caption { given, most } => {
                write!(f, "a caption of {given} letters is too long; at most {most}")
            }
            Self::NoArea => f.write_str(
                "the surface has no area: it is no more than a line or a point; its control points must not all lie on one",
            ),
            Self::Flat => f.write_str(
                "the surface has no area that encloses anything: it is closed, but lies in a plane; move control points out of it",
            ),
            Self::Confused => f.write_str(
                ".stl holds single precision, which leaves nothing of this surface; .ply and .obj hold it, or move it nearer to \
                 the origin",
            ),
            Self::Single { value } => {
                write!(
                    f,
                    "coordinate {value:e} is too large for .stl, which holds single precision; .ply and .obj hold it"
                )
            }
            Self::TooManyVertices => {
                f.write_str("the mesh has more vertices than the format can count; take fewer steps")
            }
            Self::Degree { given, most } => write!(
                f,
                "the surface has the degree {given}, but CAD programs read at most {most}; a net of at most {} points a side, \
                 or another method than bezier, can be written",
                most + 1
            ),
            Self::NoExactForm => f.write_str(
                "the surface is no B-spline surface, so .step cannot hold it exactly; .obj, .stl and .ply hold a mesh of it",
            ),
            Self::NoCurve => f.write_str("no part of the curve is left to be written; take a smaller distance"),
            Self::Encoding(message) => write!(f, "the picture cannot be encoded: {message}"),
        }
    }
}

impl std::error::Error for FigureError {}

impl From<png::EncodingError> for FigureError {
    fn from(error: png::EncodingError) -> FigureError {
        FigureError::Encoding(error.to_string())
    }
}

impl From<GeometryError> for FigureError {
    fn from(error: GeometryError) -> FigureError {
        FigureError::Geometry(error)
    }
}
