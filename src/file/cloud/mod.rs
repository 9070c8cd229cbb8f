//! Clouds of points, as scanners and other programs write them: XYZ, CSV, PLY, OBJ and STL to points, and points to
//! files that they read.
//!
//! A file is read in pieces by a [`CloudReader`], so that a program can show how far it has come and be stopped, and
//! that ten million points need little more memory than they have themselves. What is read:
//!
//! | format | points |
//! |---|---|
//! | XYZ | rows of two or three numbers and anything behind them, with blanks, tabs, commas or semicolons between them |
//! | CSV | the same, with the columns x, y and z of a header if there is one |
//! | PLY | the properties x, y and z of the element `vertex`, in text or in binary of either order |
//! | OBJ | the lines `v` |
//! | STL | the corners of the triangles, equal ones once, in text or in binary |
//!
//! Numbers that are not finite and lines that are too short are left out, counted and told ([`Skipped`]); whatever else
//! is wrong is an error with its line or its byte.

mod gathered;
mod layout;
mod lines;
mod obj;
mod ply;
mod ply_binary;
mod ply_header;
mod reader;
mod rows;
mod stl;
#[cfg(test)]
mod tests;
mod wide;
mod write;

pub use gathered::{LeftOut, MAX_CLOUD_POINTS, Skipped, Spot};
pub use reader::CloudReader;
pub use write::CloudWriter;

use super::check::{Bounds, counted};
use super::{FileError, Format, TABLES, TableOptions};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Points without any order or connection.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cloud {
    /// The points, in the order of the file.
    pub points: Vec<[f64; 3]>,
    /// What was left out when it was read.
    #[serde(skip)]
    pub skipped: Skipped,
    /// How the file was written that it was read from.
    #[serde(skip)]
    pub encoding: Option<Encoding>,
}

/// A format of clouds, by the extension of its files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CloudFormat {
    /// Coordinates with blanks between them.
    Xyz,
    /// Tables of text.
    Csv,
    /// The polygon file format of Stanford.
    Ply,
    /// Wavefront OBJ.
    Obj,
    /// Triangles for printers, which are only read.
    Stl,
}

/// How a file of a cloud is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// Rows with blanks or tabs.
    Xyz,
    /// Rows with commas or semicolons.
    Csv,
    /// PLY as text.
    PlyText,
    /// PLY in binary, the least byte first.
    PlyLittleEndian,
    /// PLY in binary, the greatest byte first.
    PlyBigEndian,
    /// Wavefront OBJ.
    Obj,
    /// STL as text.
    StlText,
    /// STL in binary.
    StlBinary,
}

impl fmt::Display for Encoding {
    /// `PLY, binary, big-endian`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Xyz => "XYZ",
            Self::Csv => "CSV",
            Self::PlyText => "PLY, text",
            Self::PlyLittleEndian => "PLY, binary, little-endian",
            Self::PlyBigEndian => "PLY, binary, big-endian",
            Self::Obj => "OBJ",
            Self::StlText => "STL, text",
            Self::StlBinary => "STL, binary",
        })
    }
}

impl CloudFormat {
    /// The format of files with this extension, given without the dot; the case does not matter.
    #[must_use]
    pub fn from_extension(extension: &str) -> Option<Self> {
        let is = |other: &str| extension.eq_ignore_ascii_case(other);
        Format::from_extension(extension).and_then(Self::of).or_else(|| {
            let table = is("csv") || TABLES.into_iter().any(is);
            table.then_some(Self::Csv)
        })
    }

    /// The format of clouds that a format of data files is.
    #[must_use]
    pub fn of(format: Format) -> Option<Self> {
        match format {
            Format::Xyz => Some(Self::Xyz),
            Format::Ply => Some(Self::Ply),
            Format::Obj => Some(Self::Obj),
            Format::Stl => Some(Self::Stl),
            _ => None,
        }
    }
}

impl Cloud {
    /// A cloud of these points.
    #[must_use]
    pub fn new(points: Vec<[f64; 3]>) -> Self {
        Self { points, ..Self::default() }
    }

    /// The cloud in the bytes of a file; [`CloudReader`] reads it in pieces.
    ///
    /// # Errors
    /// Those of [`CloudReader`].
    pub fn read(format: CloudFormat, bytes: &[u8]) -> Result<Self, FileError> {
        let mut reader = CloudReader::new(format, &TableOptions::default())?;
        reader.feed(bytes)?;
        reader.finish()
    }

    /// Whether all points lie in the plane z = 0, where the points of two columns are.
    #[must_use]
    pub fn is_plane(&self) -> bool {
        self.points.iter().all(|&[_, _, z]| z == 0.0)
    }

    /// There are points, not too many, and every coordinate is a number that can be computed with.
    ///
    /// # Errors
    /// [`FileError::Invalid`] with what is wrong and where.
    pub fn check(&self) -> Result<(), FileError> {
        let count = self.points.len();
        if count == 0 {
            return Err(FileError::Invalid("there are no points".to_owned()));
        }
        if count > MAX_CLOUD_POINTS {
            let problem = format!("{count} points are too many; there are at most {MAX_CLOUD_POINTS}");
            return Err(FileError::Invalid(problem));
        }
        match self.points.iter().position(|point| !gathered::is_usable(point)) {
            None => Ok(()),
            Some(at) => {
                let problem = format!("point {}: its coordinates are not all finite and below 1e150", at + 1);
                Err(FileError::Invalid(problem))
            }
        }
    }

    /// Facts about the cloud, one a line: how many points, how the file is written, the box around them, what was left
    /// out.
    #[must_use]
    pub fn describe(&self) -> Vec<String> {
        let place = if self.is_plane() { "the plane" } else { "space" };
        let mut facts = vec![counted(self.points.len(), &format!("point of a cloud in {place}"))];
        facts.extend(self.encoding.map(|encoding| encoding.to_string()));
        facts.extend(Bounds::of(self.points.iter()).map(|bounds| bounds.describe()));
        facts.extend(self.skipped.told().into_iter().map(|told| format!("left out: {told}")));
        facts
    }
}
