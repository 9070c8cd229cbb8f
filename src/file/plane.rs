//! Control points in the plane and their tangents: `.IP2`, `.IC2`, `.EC2`.
//!
//! 100 records of 13 bytes: xp, yp (integers), a dead pointer of 4 bytes, a flag, and the place on the
//! screen xr, yr. Record 0 holds the number of points in xp. In an `.EC2` file xp, yp are the full tangent
//! vector, xr, yr the place of its tip, and record 0 means nothing.

use super::check::{self, Bounds, MAX_POINTS};
use super::{CurveSettings, FileError, Format, settings};
use crate::geometry::Shape;
use crate::pascal::{Reader, Writer};
use serde::{Deserialize, Serialize};

/// Width and height of the drawing field in pixels; points of DOS files are whole numbers from 0 to these.
pub const FIELD: [f64; 2] = [560.0, 380.0];

const RECORD: usize = 13;
/// Where the origin of the field is on the screen.
const ORIGIN: [f64; 2] = [41.0, 450.0];

/// Control points of a plane curve, in field pixels, y upwards.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanePoints {
    /// The points in order.
    pub points: Vec<[f64; 2]>,
    /// The full tangent vector at each point, if the curve has its own (GB_2D_CH).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tangents: Option<Vec<[f64; 2]>>,
    /// The shape of the joint at each point, where they vary along the curve (2.68); only JSON holds this.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joints: Option<Vec<Shape>>,
    /// How the curve is drawn; only JSON holds this.
    #[serde(default, skip_serializing_if = "CurveSettings::is_empty")]
    pub settings: CurveSettings,
}

/// An `.EC2` file read without its `.IC2` twin. The file does not hold their number: records with a zero
/// vector at the end are left out.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tangents {
    /// The tangents of points 1, 2, ...
    pub tangents: Vec<Tangent>,
}

/// One record of an `.EC2` file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tangent {
    /// The full tangent vector in pixels, y upwards.
    pub vector: [i16; 2],
    /// The screen place of its tip, half the vector away from the point, y downwards.
    pub tip: [i16; 2],
}

impl PlanePoints {
    /// Points without tangents and settings.
    #[must_use]
    pub fn new(points: Vec<[f64; 2]>) -> Self {
        Self { points, ..Self::default() }
    }

    /// These points with the tangents of their `.EC2` twin. Records past the last point are stale and
    /// left out; missing ones are zero.
    #[must_use]
    pub fn with_tangents(self, twin: &Tangents) -> Self {
        let vectors = twin.tangents.iter().map(|t| t.vector.map(f64::from));
        let tangents = vectors.chain(std::iter::repeat([0.0; 2])).take(self.points.len()).collect();
        Self { tangents: Some(tangents), ..self }
    }

    /// # Errors
    /// [`FileError::Invalid`] when a number is not finite or the tangents are not as many as the points.
    pub(super) fn check(&self) -> Result<(), FileError> {
        check::finite("point", &self.points)?;
        self.settings.check(2, self.points.len())?;
        if let Some(tangents) = &self.tangents {
            check::finite("tangent", tangents)?;
            check::one_each("tangents", tangents.len(), self.points.len())?;
        }
        if let Some(joints) = &self.joints {
            let values: Vec<_> = joints.iter().map(|shape| [shape.bias, shape.tension]).collect();
            check::finite("joint", &values)?;
            check::one_each("joints", joints.len(), self.points.len())?;
        }
        Ok(())
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let mut lines = vec![check::counted(self.points.len(), "control point in the plane")];
        lines.extend(Bounds::of(self.points.iter()).map(|bounds| bounds.describe()));
        lines.extend(check::table("point", &self.points));
        lines.extend(self.tangents.iter().flat_map(|t| check::table("tangent", t)));
        lines.extend(settings::describe(&self.settings));
        lines
    }

    /// The bytes of an `.IP2` or `.IC2` file.
    pub(super) fn read(bytes: &[u8]) -> Result<Self, FileError> {
        let mut reader = Reader::new(bytes);
        let count = check::count(reader.i16()?, 0)?;
        let yp = reader.i16()?;
        if yp != 0 {
            return Err(FileError::value("record 0, yp", 2, format!("{yp}; it must be 0")));
        }
        reader.skip(RECORD - 4)?;
        let mut points = Vec::with_capacity(count);
        for number in 1..=count {
            let mut point = [0.0; 2];
            for ((value, axis), limit) in point.iter_mut().zip(["x", "y"]).zip(FIELD) {
                let offset = reader.offset();
                *value = f64::from(reader.i16()?);
                if !(0.0..=limit).contains(value) {
                    let problem = format!("{axis} = {value}; the field is 0 to {limit}");
                    return Err(FileError::value(format!("point {number}"), offset, problem));
                }
            }
            points.push(point);
            reader.skip(RECORD - 4)?;
        }
        Ok(Self::new(points))
    }

    /// The bytes of an `.IP2` or `.IC2` file. In the latter tangents are allowed: they are in the twin.
    pub(super) fn write(&self, format: Format) -> Result<Vec<u8>, FileError> {
        if self.tangents.is_some() && format != Format::Ic2 {
            return Err(FileError::misfit(format, "the tangents have no place there"));
        }
        if self.joints.is_some() {
            return Err(FileError::misfit(format, "the shapes of the joints have no place there"));
        }
        self.check_fits(format)?;
        let mut writer = Writer::default();
        writer.i16(self.points.len() as i16); // at most 99
        writer.zeros_to(RECORD);
        for (index, &point) in self.points.iter().enumerate() {
            let whole = check::whole(format, "point", index, point, [[0.0, FIELD[0]], [0.0, FIELD[1]]])?;
            // Both lie in the field, so the screen place is below 700.
            let screen = [ORIGIN[0] + point[0], ORIGIN[1] - point[1]].map(|v| v as i16);
            record(&mut writer, whole, screen);
        }
        writer.zeros_to(format.bytes());
        Ok(writer.into_bytes())
    }

    /// The bytes of the `.EC2` file that belongs to these points.
    pub(super) fn write_tangents(&self) -> Result<Vec<u8>, FileError> {
        let format = Format::Ec2;
        let Some(tangents) = &self.tangents else {
            return Err(FileError::misfit(format, "the points have no tangents"));
        };
        self.check_fits(format)?;
        let word = [f64::from(i16::MIN), f64::from(i16::MAX)];
        let mut twin = Tangents::default();
        for (index, (&point, &tangent)) in self.points.iter().zip(tangents).enumerate() {
            check::whole(format, "point", index, point, [[0.0, FIELD[0]], [0.0, FIELD[1]]])?;
            let vector = check::whole(format, "tangent", index, tangent, [word; 2])?;
            let [u, v] = tangent.map(|t| (t / 2.0).round_ties_even());
            // Half a 16-bit integer and a screen place: below 17 000.
            let tip = [ORIGIN[0] + point[0] + u, ORIGIN[1] - point[1] - v].map(|v| v as i16);
            twin.tangents.push(Tangent { vector, tip });
        }
        twin.write()
    }

    fn check_fits(&self, format: Format) -> Result<(), FileError> {
        check::no_settings(format, &self.settings)?;
        check::at_most(format, self.points.len())
    }
}

impl Tangents {
    pub(super) fn describe(&self) -> Vec<String> {
        let vectors: Vec<_> = self.tangents.iter().map(|t| t.vector.map(f64::from)).collect();
        let mut lines = vec![check::counted(vectors.len(), "tangent in the plane")];
        lines.extend(check::table("tangent", &vectors));
        lines
    }

    /// The bytes of an `.EC2` file.
    pub(super) fn read(bytes: &[u8]) -> Result<Self, FileError> {
        let mut reader = Reader::new(bytes);
        reader.skip(RECORD)?;
        let mut tangents = Vec::with_capacity(MAX_POINTS);
        for _ in 0..MAX_POINTS {
            let vector = [reader.i16()?, reader.i16()?];
            reader.skip(5)?;
            tangents.push(Tangent { vector, tip: [reader.i16()?, reader.i16()?] });
        }
        let last = tangents.iter().rposition(|t| t.vector != [0; 2]);
        tangents.truncate(last.map_or(0, |index| index + 1));
        Ok(Self { tangents })
    }

    /// The bytes of an `.EC2` file.
    pub(super) fn write(&self) -> Result<Vec<u8>, FileError> {
        check::at_most(Format::Ec2, self.tangents.len())?;
        let mut writer = Writer::default();
        writer.zeros_to(RECORD);
        for tangent in &self.tangents {
            record(&mut writer, tangent.vector, tangent.tip);
        }
        writer.zeros_to(Format::Ec2.bytes());
        Ok(writer.into_bytes())
    }
}

/// One record; pointer and flag are zero.
fn record(writer: &mut Writer, value: [i16; 2], screen: [i16; 2]) {
    value.into_iter().for_each(|v| writer.i16(v));
    writer.zeros_to(writer.offset() + 5);
    screen.into_iter().for_each(|v| writer.i16(v));
}
