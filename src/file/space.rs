//! Control points in space: `.IP3`.
//!
//! 100 records of 30 bytes: x, y, z (6-byte reals), the place on the screen xr, yr (integers), the depth zr
//! (real) and the drawing order ns (integer). Record 0 holds the number of points in ns.

use super::check::{self, Bounds};
use super::view::View;
use super::{CurveSettings, FileError, Format, settings};
use crate::pascal::{Reader, Writer, real48};
use serde::{Deserialize, Serialize};

const RECORD: usize = 30;
/// Where ns stands in a record.
const NS: usize = 28;
/// The view of every new configuration in GB_3D_IP and GB_3D_BT.
const VIEW: View = View([0.7, 0.2, 0.3]);

/// Control points of a curve in space.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpacePoints {
    /// The points in order.
    pub points: Vec<[f64; 3]>,
    /// How the curve is drawn; only JSON holds this.
    #[serde(default, skip_serializing_if = "CurveSettings::is_empty")]
    pub settings: CurveSettings,
}

impl SpacePoints {
    /// Points without settings.
    #[must_use]
    pub fn new(points: Vec<[f64; 3]>) -> Self {
        Self { points, ..Self::default() }
    }

    /// # Errors
    /// [`FileError::Invalid`] when a number is not finite.
    pub(super) fn check(&self) -> Result<(), FileError> {
        check::finite("point", &self.points)
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let mut lines = vec![check::counted(self.points.len(), "control point in space")];
        lines.extend(Bounds::of(self.points.iter()).map(|bounds| bounds.describe()));
        lines.extend(check::table("point", &self.points));
        lines.extend(settings::describe(&self.settings));
        lines
    }

    pub(super) fn read(bytes: &[u8]) -> Result<Self, FileError> {
        let mut reader = Reader::new(bytes);
        reader.skip(NS)?;
        let count = check::count(reader.i16()?, NS)?;
        let mut points = Vec::with_capacity(count);
        for _ in 0..count {
            points.push([reader.real()?, reader.real()?, reader.real()?]);
            reader.skip(RECORD - 18)?;
        }
        Ok(Self::new(points))
    }

    /// Coordinates become the nearest 6-byte reals (40 significant bits); screen places, depths and
    /// drawing order are those of the first view.
    pub(super) fn write(&self) -> Result<Vec<u8>, FileError> {
        let format = Format::Ip3;
        check::no_settings(format, &self.settings)?;
        check::at_most(format, self.points.len())?;
        let order = drawing_order(&self.points);
        let mut writer = Writer::default();
        writer.zeros_to(NS);
        writer.i16(self.points.len() as i16); // at most 99
        for (index, (point, rank)) in self.points.iter().zip(order).enumerate() {
            for (&value, axis) in point.iter().zip(["x", "y", "z"]) {
                writer
                    .real(value)
                    .map_err(|e| FileError::misfit(format, format!("point {}: {axis} = {e}", index + 1)))?;
            }
            VIEW.screen(*point).into_iter().for_each(|v| writer.i16(v));
            // Only a cache: a depth that no 6-byte real holds is cut rather than refused.
            let depth = VIEW.depth(*point).clamp(-real48::MAX, real48::MAX);
            writer.real(depth).map_err(|e| FileError::misfit(format, e.to_string()))?;
            writer.i16(rank);
        }
        writer.zeros_to(format.size());
        Ok(writer.into_bytes())
    }
}

/// The rank of every point, from 1, farthest first; equal depths keep the order of the points.
fn drawing_order(points: &[[f64; 3]]) -> Vec<i16> {
    let mut indices: Vec<usize> = (0..points.len()).collect();
    let depths: Vec<f64> = points.iter().map(|&p| VIEW.depth(p)).collect();
    indices.sort_by(|&i, &j| depths[i].total_cmp(&depths[j])); // indices of the same list
    let mut ranks = vec![0; points.len()];
    for (rank, &index) in (1..).zip(&indices) {
        ranks[index] = rank;
    }
    ranks
}
