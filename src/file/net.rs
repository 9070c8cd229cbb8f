//! Control nets of the surfaces: `.FHC` to `.ZYP`, and `.PN` with normals.
//!
//! 8 x 5 records of 16 bytes, record 5 k + l: x, y, z (singles) and the place on the screen xr, yr (integers),
//! whatever the size of the net itself; the records outside it are free.

use super::check::{self, Bounds};
use super::format::a_file;
use super::space::place_on_screen;
use super::{FileError, Format, NetSettings, settings};
use crate::geometry::{Topology, View};
use crate::pascal::{Reader, Writer};
use serde::{Deserialize, Serialize};

/// Rows and columns of every file.
const STORED: [usize; 2] = [8, 5];
const RECORD: usize = 16;
/// The ratios of derivatives across a joint that keeps the tangent plane.
pub const RATIOS: std::ops::RangeInclusive<f64> = 0.05..=20.0;

/// What a net means: the kind of surface, after the file's extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum NetKind {
    /// The matrix of a Hermite patch (3.17): 4 x 4, points and vectors.
    Fhc,
    /// Open spline surface: 5 x 5.
    Fps,
    /// Heights of a spline surface over a fixed grid: 8 x 5.
    Fem,
    /// Bézier patch: 4 x 4.
    Fpb,
    /// Open B-spline surface: 5 x 5.
    Fbs,
    /// Spline surface with the topology of a sphere: 8 meridians of 5 points, closed in u.
    Zms,
    /// B-spline surface with the topology of a sphere.
    Zmb,
    /// Spline surface with the topology of a torus: 8 x 5, closed in u and v.
    Zys,
    /// B-spline surface with the topology of a torus.
    Zyb,
    /// Beta-spline surface with the topology of a torus, as ZY_BETSP saves it.
    Zyp,
    /// Points with unit normals, in JSON only.
    Pn,
}

/// Nets of one family may be saved under each other's extensions.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Family {
    Hermite,
    Open,
    Heights,
    Bezier,
    Sphere,
    Torus,
    Normals,
}

/// A control net of a surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Net {
    /// What the net means. In JSON this is the `"format"`.
    #[serde(skip, default = "NetKind::any")]
    pub kind: NetKind,
    /// Point (k, l) is `points[k][l]`; k counts in the direction of u, l in that of v.
    pub points: Vec<Vec<[f64; 3]>>,
    /// The unit normals in the points of a net of [`NetKind::Pn`]; without them they follow from the points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normals: Option<Vec<Vec<[f64; 3]>>>,
    /// How the surface is drawn; only JSON holds this.
    #[serde(default, skip_serializing_if = "NetSettings::is_empty")]
    pub settings: NetSettings,
}

impl NetKind {
    /// The direction from which most surface programs see their net at first.
    pub const VIEW: [f64; 3] = [0.3, -0.7, 0.2];
    /// That of the Hermite patch.
    pub const HERMITE_VIEW: [f64; 3] = [0.4, -0.7, 0.2];
    /// That of the larger tori, from higher above.
    pub const TORUS_VIEW: [f64; 3] = [0.3, -0.7, 0.4];

    /// Every kind.
    pub const ALL: [Self; 11] = [
        Self::Fhc,
        Self::Fps,
        Self::Fem,
        Self::Fpb,
        Self::Fbs,
        Self::Zms,
        Self::Zmb,
        Self::Zys,
        Self::Zyb,
        Self::Zyp,
        Self::Pn,
    ];

    /// The format of its DOS files.
    #[must_use]
    pub fn format(self) -> Format {
        match self {
            Self::Fhc => Format::Fhc,
            Self::Fps => Format::Fps,
            Self::Fem => Format::Fem,
            Self::Fpb => Format::Fpb,
            Self::Fbs => Format::Fbs,
            Self::Zms => Format::Zms,
            Self::Zmb => Format::Zmb,
            Self::Zys => Format::Zys,
            Self::Zyb => Format::Zyb,
            Self::Zyp => Format::Zyp,
            Self::Pn => Format::Pn,
        }
    }

    /// The kind that a format holds, if it holds nets.
    #[must_use]
    pub fn of(format: Format) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.format() == format)
    }

    /// Number of points in the directions of u and v; nets that are JSON only begin with it.
    #[must_use]
    pub fn shape(self) -> [usize; 2] {
        match self.family() {
            Family::Hermite | Family::Bezier | Family::Normals => [4, 4],
            Family::Open => [5, 5],
            Family::Heights | Family::Sphere | Family::Torus => [8, 5],
        }
    }

    /// Whether a net of this kind may be saved as a file of the other.
    #[must_use]
    pub fn goes_into(self, other: Self) -> bool {
        self.family() == other.family()
    }

    fn family(self) -> Family {
        match self {
            Self::Fhc => Family::Hermite,
            Self::Fpb => Family::Bezier,
            Self::Fem => Family::Heights,
            Self::Fps | Self::Fbs => Family::Open,
            Self::Zms | Self::Zmb => Family::Sphere,
            Self::Zys | Self::Zyb | Self::Zyp => Family::Torus,
            Self::Pn => Family::Normals,
        }
    }

    /// The screen place that the originals store for a point: in the first view, and zero for what they
    /// never draw as a point.
    fn screen(self, k: usize, l: usize, point: [f64; 3]) -> [i16; 2] {
        match self {
            Self::Fhc if k >= 2 || l >= 2 => [0; 2],
            _ => place_on_screen(View::from_direction(self.view()), point),
        }
    }

    /// What the surface of such a net is joined to itself by.
    #[must_use]
    pub fn topology(self) -> Topology {
        match self.family() {
            Family::Hermite | Family::Open | Family::Heights | Family::Bezier | Family::Normals => {
                Topology::Open
            }
            Family::Sphere => Topology::Sphere,
            Family::Torus => Topology::Torus,
        }
    }

    /// The direction from the origin to the viewer at the start of the program that saves this kind.
    #[must_use]
    pub fn view(self) -> [f64; 3] {
        match self {
            Self::Fhc => Self::HERMITE_VIEW,
            Self::Zyp => Self::TORUS_VIEW,
            _ => Self::VIEW,
        }
    }

    /// A kind to be replaced while JSON is being read.
    fn any() -> Self {
        Self::Fps
    }
}

impl Net {
    /// A net without settings.
    #[must_use]
    pub fn new(kind: NetKind, points: Vec<Vec<[f64; 3]>>) -> Self {
        Self { kind, points, normals: None, settings: NetSettings::default() }
    }

    /// What the net of two patches has to be.
    fn check_joint(&self) -> Result<(), FileError> {
        let NetSettings { joint, ratio, .. } = self.settings;
        if let Some(ratio) = ratio.filter(|ratio| !RATIOS.contains(ratio)) {
            let [least, most] = [RATIOS.start(), RATIOS.end()];
            let problem = format!("the ratio of a joint is {ratio}, but must be {least} to {most}");
            return Err(FileError::Invalid(problem));
        }
        let Some(_) = joint else { return Ok(()) };
        let (rows, columns) = (self.points.len(), self.points.first().map_or(0, Vec::len));
        match self.kind {
            NetKind::Fpb if rows >= 5 && !rows.is_multiple_of(2) && columns >= 2 => Ok(()),
            NetKind::Fhc if [rows, columns] == [7, 4] => Ok(()),
            NetKind::Fpb => Err(FileError::Invalid(format!(
                "two joined Bézier patches with {rows} x {columns} points; they have an odd number of rows, 5 or more, \
                 of which the middle one is the common border"
            ))),
            NetKind::Fhc => Err(FileError::Invalid(format!(
                "two joined Hermite patches with {rows} x {columns} vectors; they have 7 rows of 4"
            ))),
            other => Err(FileError::Invalid(format!(
                "a joint belongs to two patches of the format FPB or FHC, not {}",
                other.format()
            ))),
        }
    }

    /// # Errors
    /// [`FileError::Invalid`] when a number is not finite, the rows are not equally long, there are normals that do
    /// not belong to the points, or the points are not those of two patches that are said to be joined.
    pub(super) fn check(&self) -> Result<(), FileError> {
        self.check_joint()?;
        if let Some(normals) = &self.normals {
            if self.kind != NetKind::Pn {
                let problem = format!("normals belong to a net of the format PN, not {}", self.kind.format());
                return Err(FileError::Invalid(problem));
            }
            for (k, row) in normals.iter().enumerate() {
                check::finite(&format!("row {}, normal", k + 1), row)?;
            }
            let lengths = |rows: &[Vec<[f64; 3]>]| rows.iter().map(Vec::len).collect::<Vec<_>>();
            if lengths(normals) != lengths(&self.points) {
                let size =
                    |rows: &[Vec<[f64; 3]>]| format!("{} x {}", rows.len(), rows.first().map_or(0, Vec::len));
                return Err(FileError::Invalid(format!(
                    "{} normals and {} points; every point has one normal",
                    size(normals),
                    size(&self.points)
                )));
            }
        }
        let columns = self.points.first().map_or(0, Vec::len);
        for (k, row) in self.points.iter().enumerate() {
            check::finite(&format!("row {}, point", k + 1), row)?;
            if row.len() != columns {
                return Err(FileError::Invalid(format!(
                    "row {} of the net has {} points and row 1 has {columns}; all must have the same",
                    k + 1,
                    row.len()
                )));
            }
        }
        Ok(())
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let columns = self.points.first().map_or(0, Vec::len);
        let size = format!("{} x {columns} points", self.points.len());
        let mut lines = vec![format!("{}, {size}", self.kind.format().english())];
        lines.extend(Bounds::of(self.points.iter().flatten()).map(|bounds| bounds.describe()));
        for (k, row) in self.points.iter().enumerate() {
            for (l, point) in row.iter().enumerate() {
                let place = point.map(check::number).join(", ");
                lines.push(format!("point {}, {}: {place}", k + 1, l + 1));
            }
        }
        for (k, row) in self.normals.iter().flatten().enumerate() {
            for (l, normal) in row.iter().enumerate() {
                let place = normal.map(check::number).join(", ");
                lines.push(format!("normal {}, {}: {place}", k + 1, l + 1));
            }
        }
        lines.extend(settings::describe(&self.settings));
        lines
    }

    pub(super) fn read(kind: NetKind, bytes: &[u8]) -> Result<Self, FileError> {
        let mut reader = Reader::new(bytes);
        let [rows, columns] = kind.shape();
        let mut points = Vec::with_capacity(rows);
        for k in 0..rows {
            let mut row = Vec::with_capacity(columns);
            for l in 0..STORED[1] {
                if l < columns {
                    row.push(read_point(&mut reader, k, l)?);
                    reader.skip(4)?;
                } else {
                    reader.skip(RECORD)?;
                }
            }
            points.push(row);
        }
        Ok(Self::new(kind, points))
    }

    /// Coordinates become the nearest singles.
    pub(super) fn write(&self, kind: NetKind) -> Result<Vec<u8>, FileError> {
        let format = kind.format();
        if !self.kind.goes_into(kind) {
            let problem = format!("the net is that of {}", a_file(self.kind.format()));
            return Err(FileError::misfit(format, problem));
        }
        if self.settings.joint.is_some() {
            let problem = "two joined patches; only JSON holds both".to_owned();
            return Err(FileError::misfit(format, problem));
        }
        check::no_settings(format, &self.settings)?;
        let [rows, columns] = kind.shape();
        let found = [self.points.len(), self.points.first().map_or(0, Vec::len)];
        if found != [rows, columns] {
            let problem = format!("{} x {} points; it holds {rows} x {columns}", found[0], found[1]);
            return Err(FileError::misfit(format, problem));
        }
        let mut writer = Writer::default();
        for (k, row) in self.points.iter().enumerate() {
            for (l, &point) in row.iter().enumerate() {
                for (value, axis) in point.into_iter().zip(["x", "y", "z"]) {
                    writer.single(single(value).ok_or_else(|| {
                        let (row, column) = (k + 1, l + 1);
                        let problem =
                            format!("point {row}, {column}: {axis} = {value} is too large for a single");
                        FileError::misfit(format, problem)
                    })?);
                }
                kind.screen(k, l, point).into_iter().for_each(|v| writer.i16(v));
            }
            writer.zeros_to(RECORD * STORED[1] * (k + 1));
        }
        writer.zeros_to(format.bytes());
        Ok(writer.into_bytes())
    }
}

fn read_point(reader: &mut Reader, k: usize, l: usize) -> Result<[f64; 3], FileError> {
    let mut point = [0.0; 3];
    for (value, axis) in point.iter_mut().zip(["x", "y", "z"]) {
        let offset = reader.offset();
        *value = f64::from(reader.single()?);
        if !value.is_finite() {
            let problem = format!("{axis} is {value}; it must be a finite number");
            return Err(FileError::value(format!("point {}, {}", k + 1, l + 1), offset, problem));
        }
    }
    Ok(point)
}

/// The nearest single, if it is finite.
fn single(value: f64) -> Option<f32> {
    let nearest = value as f32;
    nearest.is_finite().then_some(nearest)
}
