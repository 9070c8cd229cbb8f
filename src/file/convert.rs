//! From one kind of file to another.

use super::ec::EcCurve;
use super::table::{decoded, decoded_table};
use super::{
    Cloud, CloudFormat, Document, FileError, Format, KnotPoints, Net, NetKind, Places, PlanePoints,
    ShapedPoints, SpacePoints, TableOptions,
};
use crate::geometry::Topology;

/// Extensions of tables of text that are read; they are written as CSV.
pub const TABLES: [&str; 4] = ["tsv", "tab", "txt", "dat"];

/// A kind of file that holds a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FileKind {
    /// A data file of the DOS programs.
    Dos(Format),
    /// JSON, which holds every document.
    Json,
    /// CSV and other tables of text, which hold points.
    Csv,
}

impl FileKind {
    /// The kind of a file by its name; the case does not matter.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        name.rsplit_once('.').and_then(|(_, extension)| Self::from_extension(extension))
    }

    /// The kind of files with this extension, given without the dot; the case does not matter.
    #[must_use]
    pub fn from_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "json" => Some(Self::Json),
            "csv" => Some(Self::Csv),
            _ => Format::from_extension(extension).map(Self::Dos),
        }
    }

    /// The kind of files with this extension that are read: besides those that are written, other tables of text.
    #[must_use]
    pub fn from_input_extension(extension: &str) -> Option<Self> {
        let is_table = TABLES.iter().any(|table| table.eq_ignore_ascii_case(extension));
        if is_table { Some(Self::Csv) } else { Self::from_extension(extension) }
    }
}

impl Document {
    /// The document in the bytes of a file.
    ///
    /// # Errors
    /// Those of [`Document::read`], [`Document::from_json`] and [`Document::from_csv`], and
    /// [`FileError::Text`] for JSON that is not UTF-8.
    pub fn decode(kind: FileKind, bytes: &[u8]) -> Result<Self, FileError> {
        Self::decode_table(kind, bytes, &TableOptions::default())
    }

    /// The document in the bytes of a file, in which points may be a table: CSV, or a plain list in JSON.
    ///
    /// # Errors
    /// Those of [`Document::decode`], and [`FileError::NoTable`] for options and a file that is none.
    pub fn decode_table(kind: FileKind, bytes: &[u8], options: &TableOptions) -> Result<Self, FileError> {
        match kind {
            FileKind::Dos(format) => match options.given() {
                Some(option) => Err(FileError::NoTable { option }),
                None => Self::read(format, bytes),
            },
            FileKind::Json => decoded(bytes).and_then(|text| Self::from_json_table(&text, options)),
            FileKind::Csv => Self::from_table(&decoded_table(bytes), options),
        }
    }

    /// The bytes of a file with this document.
    ///
    /// # Errors
    /// Those of [`Document::write`], [`Document::to_json`] and [`Document::to_csv`].
    pub fn encode(&self, kind: FileKind) -> Result<Vec<u8>, FileError> {
        match kind {
            FileKind::Dos(format) => self.write(format),
            FileKind::Json => self.to_json().map(String::into_bytes),
            FileKind::Csv => self.to_csv().map(String::into_bytes),
        }
    }

    /// The same content for another data format: points of the plane into space with z = 0 and back where
    /// z is 0 everywhere, points with tangents without them, nets of one family under each other's
    /// names, control points as those of polynomials on [0, 1] (`.KCG`), of uniform cubic B-splines (`.CSM`, `.ALP`), and
    /// the control points of these alone; control points as a cloud and back; Fourier curves as cyclic ones and back.
    /// What cannot become such a document stays as it is; [`Document::write`] will say so.
    #[must_use]
    pub fn adapted(self, format: Format) -> Self {
        match (self, format) {
            (Self::Cloud(Cloud { points, .. }), Format::Ip2 | Format::Ic2 | Format::Ip3 | Format::Kcg) => {
                Self::SpacePoints(SpacePoints::new(points)).adapted(format)
            }
            (Self::PlanePoints(PlanePoints { points, .. }), _) if CloudFormat::of(format).is_some() => {
                Self::Cloud(Cloud::new(points.into_iter().map(|[x, y]| [x, y, 0.0]).collect()))
            }
            (Self::SpacePoints(SpacePoints { points, .. }), _) if CloudFormat::of(format).is_some() => {
                Self::Cloud(Cloud::new(points))
            }
            (Self::PlanePoints(PlanePoints { points, settings, .. }), Format::Ip3) => {
                let points = points.into_iter().map(|[x, y]| [x, y, 0.0]).collect();
                Self::SpacePoints(SpacePoints { settings, ..SpacePoints::new(points) })
            }
            (Self::SpacePoints(SpacePoints { points, settings, .. }), Format::Ip2 | Format::Ic2)
                if points.iter().all(|&[_, _, z]| z == 0.0) =>
            {
                let points = points.into_iter().map(|[x, y, _]| [x, y]).collect();
                Self::PlanePoints(PlanePoints { points, settings, ..PlanePoints::default() })
            }
            (Self::PlanePoints(points), Format::Ip2) => {
                Self::PlanePoints(PlanePoints { tangents: None, ..points })
            }
            (Self::PlanePoints(PlanePoints { points, .. }), Format::Kcg) if EcCurve::holds(points.len()) => {
                EcCurve::of_points(points.into_iter().map(|[x, y]| [x, y, 0.0]).collect()).into()
            }
            (Self::SpacePoints(SpacePoints { points, .. }), Format::Kcg) if EcCurve::holds(points.len()) => {
                EcCurve::of_points(points).into()
            }
            (Self::PlanePoints(PlanePoints { points, .. }), Format::Csm) => {
                KnotPoints::of_points(points).into()
            }
            (Self::SpacePoints(SpacePoints { points, .. }), Format::Csm) => {
                KnotPoints::of_points(points).into()
            }
            (Self::PlanePoints(PlanePoints { points, .. }), Format::Alp) => {
                ShapedPoints::of_points(points).into()
            }
            (Self::SpacePoints(SpacePoints { points, .. }), Format::Alp) => {
                ShapedPoints::of_points(points).into()
            }
            (Self::Fourier(fourier), Format::Alp) => match ShapedPoints::of_fourier(&fourier) {
                Some(cyclic) => cyclic.into(),
                None => Self::Fourier(fourier),
            },
            (Self::Shaped(shaped), Format::Gbp) => match shaped.to_fourier() {
                Some(fourier) => Self::Fourier(Box::new(fourier)),
                None => Self::Shaped(shaped),
            },
            (Self::Knots(knots), Format::Ip2 | Format::Ic2 | Format::Ip3 | Format::Alp) => {
                Self::of_places(knots.points).adapted(format)
            }
            (Self::Shaped(shaped), Format::Ip2 | Format::Ic2 | Format::Ip3 | Format::Csm) => {
                Self::of_places(shaped.points).adapted(format)
            }
            (Self::Net(net), _) => Self::Net(match NetKind::of(format) {
                Some(kind) if net.kind.goes_into(kind) => Net { kind, ..net },
                // Any net can be that of points whose normals follow from them.
                Some(kind @ NetKind::Pn)
                    if net.kind.topology() == Topology::Open && net.kind != NetKind::Fhc =>
                {
                    Net { kind, ..net }
                }
                _ => net,
            }),
            (document, _) => document,
        }
    }
}

impl Document {
    /// Control points of the plane or in space.
    pub(super) fn of_places(points: Places) -> Self {
        match points {
            Places::Plane(points) => Self::PlanePoints(PlanePoints::new(points)),
            Places::Space(points) => Self::SpacePoints(SpacePoints::new(points)),
        }
    }
}

impl From<KnotPoints> for Document {
    fn from(knots: KnotPoints) -> Self {
        Self::Knots(Box::new(knots))
    }
}

impl From<ShapedPoints> for Document {
    fn from(shaped: ShapedPoints) -> Self {
        Self::Shaped(Box::new(shaped))
    }
}

/// The bytes of one kind of file turned into those of another.
///
/// Into a DOS format the document is [`Document::adapted`] first. A JSON document with tangents goes into
/// `.IC2` and `.EC2` by two conversions.
///
/// # Errors
/// [`FileError`] when the bytes are no such file or the other kind cannot hold the document.
pub fn convert(bytes: &[u8], from: FileKind, to: FileKind) -> Result<Vec<u8>, FileError> {
    let document = Document::decode(from, bytes)?;
    match to {
        FileKind::Dos(format) => document.adapted(format).encode(to),
        FileKind::Json | FileKind::Csv => document.encode(to),
    }
}
