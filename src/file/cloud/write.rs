//! Clouds as files: the fewest digits that read back as the same double, or the double itself.

use super::super::check::write_number;
use super::super::{FileError, FileKind, Format};
use super::{Cloud, CloudFormat};
use serde_json::Value;
use std::fmt::Write as _;
use std::io::{self, Write};

impl Cloud {
    /// The file with this cloud: XYZ, CSV with a header, PLY in little-endian doubles, OBJ. A plane cloud has two
    /// columns in XYZ and CSV.
    ///
    /// # Errors
    /// [`FileError::Misfit`] for STL, which holds triangles; those of [`Cloud::check`].
    pub fn write(&self, format: CloudFormat) -> Result<Vec<u8>, FileError> {
        self.check()?;
        let mut writer = CloudWriter::of(Body::of(format)?, self.points.len(), self.is_plane());
        let mut bytes = Vec::with_capacity(200 + self.points.len() * writer.most());
        let all = writer.begin(&mut bytes).and_then(|()| writer.points(&mut bytes, &self.points));
        all.and_then(|()| writer.end(&mut bytes)).map_err(|error| FileError::Invalid(error.to_string()))?;
        Ok(bytes)
    }
}

/// Writes a cloud of which only the number of points needs to be known before, point by point: the file of
/// [`Document::encode`](super::super::Document::encode).
///
/// ```
/// use grafika::file::{CloudWriter, FileKind, Format};
///
/// let mut file = Vec::new();
/// let mut writer = CloudWriter::new(FileKind::Dos(Format::Obj), 3, false)?;
/// writer.begin(&mut file)?;
/// writer.points(&mut file, &[[1.0, 2.0, 3.0], [4.0, 5.0, 6.5]])?;
/// writer.points(&mut file, &[[0.0; 3]])?;
/// writer.end(&mut file)?;
/// assert_eq!(file, b"v 1 2 3\nv 4 5 6.5\nv 0 0 0\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct CloudWriter {
    body: Body,
    count: usize,
    columns: usize,
    /// Whether there is a point already.
    begun: bool,
    line: String,
}

/// How points are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Body {
    Xyz,
    Csv,
    Ply,
    Obj,
    Json,
}

impl Body {
    fn of(format: CloudFormat) -> Result<Body, FileError> {
        match format {
            CloudFormat::Xyz => Ok(Body::Xyz),
            CloudFormat::Csv => Ok(Body::Csv),
            CloudFormat::Ply => Ok(Body::Ply),
            CloudFormat::Obj => Ok(Body::Obj),
            CloudFormat::Stl => {
                let problem = "the points of a cloud; it holds triangles".to_owned();
                Err(FileError::Misfit { format: "STL", problem })
            }
        }
    }
}

impl CloudWriter {
    /// A writer of so many points, which may all lie in the plane z = 0.
    ///
    /// # Errors
    /// [`FileError::Misfit`] for files that hold something else than points.
    pub fn new(kind: FileKind, count: usize, plane: bool) -> Result<CloudWriter, FileError> {
        let body = match kind {
            FileKind::Json => Body::Json,
            FileKind::Csv => Body::Csv,
            FileKind::Dos(format) => match CloudFormat::of(format) {
                Some(format) => Body::of(format)?,
                None => return Err(FileError::misfit(format, "the points of a cloud".to_owned())),
            },
        };
        Ok(Self::of(body, count, plane))
    }

    fn of(body: Body, count: usize, plane: bool) -> CloudWriter {
        let columns = if plane && matches!(body, Body::Xyz | Body::Csv) { 2 } else { 3 };
        CloudWriter { body, count, columns, begun: false, line: String::new() }
    }

    /// The bytes that most points need: numbers have up to 17 digits, a sign, a point and what separates them.
    fn most(&self) -> usize {
        if self.body == Body::Ply { 24 } else { 2 + 20 * self.columns }
    }

    /// Writes what stands before the points.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn begin(&mut self, out: &mut dyn Write) -> io::Result<()> {
        match self.body {
            Body::Xyz | Body::Obj => Ok(()),
            Body::Csv => out.write_all(if self.columns == 2 { b"x,y\n" } else { b"x,y,z\n" }),
            Body::Ply => write!(
                out,
                "ply\nformat binary_little_endian 1.0\ncomment grafika\nelement vertex {}\nproperty double x\n\
                 property double y\nproperty double z\nend_header\n",
                self.count
            ),
            Body::Json => {
                write!(out, "{{\n  \"format\": \"{}\",\n  \"points\": [", Format::Xyz.extension())
            }
        }
    }

    /// Writes the next points.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn points(&mut self, out: &mut dyn Write, points: &[[f64; 3]]) -> io::Result<()> {
        let (begin, delimiter, end) = match self.body {
            Body::Xyz => ("", " ", "\n"),
            Body::Csv => ("", ",", "\n"),
            Body::Obj => ("v ", " ", "\n"),
            Body::Json => ("\n    [", ", ", "]"),
            Body::Ply => {
                return points.iter().flatten().try_for_each(|value| out.write_all(&value.to_le_bytes()));
            }
        };
        for point in points {
            self.line.clear();
            if self.body == Body::Json && std::mem::replace(&mut self.begun, true) {
                self.line.push(',');
            }
            self.line.push_str(begin);
            for (at, &value) in point.iter().take(self.columns).enumerate() {
                if at > 0 {
                    self.line.push_str(delimiter);
                }
                match self.body {
                    Body::Json => json_number(&mut self.line, value),
                    _ => write_number(&mut self.line, value),
                }
            }
            self.line.push_str(end);
            out.write_all(self.line.as_bytes())?;
        }
        Ok(())
    }

    /// Writes what stands behind the points.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn end(&mut self, out: &mut dyn Write) -> io::Result<()> {
        match self.body {
            Body::Json => out.write_all(b"\n  ]\n}\n"),
            Body::Xyz | Body::Csv | Body::Ply | Body::Obj => Ok(()),
        }
    }
}

/// A number as JSON has it; whole ones without their `.0`.
fn json_number(text: &mut String, value: f64) {
    let start = text.len();
    // Writing to a string cannot fail.
    let _ = write!(text, "{}", Value::from(value));
    let whole = text.get(start..).and_then(|digits| digits.strip_suffix(".0"));
    if let Some(length) = whole.filter(|&whole| whole != "-0").map(str::len) {
        text.truncate(start + length);
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::Document;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Piece by piece as in one.
        #[test]
        fn pieces_are_the_whole(
            mut points in prop::collection::vec(
                prop::array::uniform3(prop_oneof![-9e5..9e5, Just(-0.0), Just(1e17), Just(123456789012345680.0), Just(1e-7), Just(3.0)]),
                1..20,
            ),
            plane: bool, part in 1_usize..7,
        ) {
            if plane {
                points.iter_mut().for_each(|point| point[2] = 0.0);
            }
            let cloud = Cloud::new(points.clone());
            let (count, plane) = (points.len(), cloud.is_plane());
            let document = Document::Cloud(cloud);
            let kinds = [Format::Xyz, Format::Ply, Format::Obj].map(FileKind::Dos);
            for kind in kinds.into_iter().chain([FileKind::Csv, FileKind::Json]) {
                let mut file = Vec::new();
                let mut writer = CloudWriter::new(kind, count, plane).unwrap();
                writer.begin(&mut file).unwrap();
                points.chunks(part).for_each(|points| writer.points(&mut file, points).unwrap());
                writer.end(&mut file).unwrap();
                let whole = document.encode(kind).unwrap();
                prop_assert_eq!(String::from_utf8_lossy(&file), String::from_utf8_lossy(&whole));
            }
        }
    }

    #[test]
    fn other_files_hold_no_points_of_a_cloud() {
        for format in [Format::Stl, Format::Zms] {
            assert!(matches!(
                CloudWriter::new(FileKind::Dos(format), 1, true),
                Err(FileError::Misfit { .. })
            ));
        }
    }
}
