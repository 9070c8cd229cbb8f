//! Control points in space: `.IP3`.
//!
//! 100 records of 30 bytes: x, y, z (6-byte reals), the place on the screen xr, yr (integers), the depth zr
//! (real) and the drawing order ns (integer). Record 0 holds the number of points in ns.

use super::check::{self, Bounds};
use super::{CurveSettings, FileError, Format, settings};
use crate::geometry::View;
use crate::pascal::{Reader, Writer, real48};
use serde::{Deserialize, Serialize};

const RECORD: usize = 30;
/// Where ns stands in a record.
const NS: usize = 28;
/// Where the viewer stands in every new configuration of GB_3D_IP and GB_3D_BT: the direction from the
/// origin towards him.
pub const SPACE_VIEW: [f64; 3] = [0.7, 0.2, 0.3];

/// Control points of a curve in space.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpacePoints {
    /// The points in order.
    pub points: Vec<[f64; 3]>,
    /// The full tangent vector at each point, if the curve has its own; only JSON holds this.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tangents: Option<Vec<[f64; 3]>>,
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
    /// [`FileError::Invalid`] when a number is not finite or the tangents are not as many as the points.
    pub(super) fn check(&self) -> Result<(), FileError> {
        check::finite("point", &self.points)?;
        self.settings.check(3, self.points.len())?;
        if let Some(tangents) = &self.tangents {
            check::finite("tangent", tangents)?;
            check::one_each("tangents", tangents.len(), self.points.len())?;
        }
        Ok(())
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let mut lines = vec![check::counted(self.points.len(), "control point in space")];
        lines.extend(Bounds::of(self.points.iter()).map(|bounds| bounds.describe()));
        lines.extend(check::table("point", &self.points));
        lines.extend(self.tangents.iter().flat_map(|tangents| check::table("tangent", tangents)));
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
        if self.tangents.is_some() {
            return Err(FileError::misfit(format, "the tangents have no place there"));
        }
        check::no_settings(format, &self.settings)?;
        check::at_most(format, self.points.len())?;
        let view = View::from_direction(SPACE_VIEW);
        // The originals' depths are in units of the view vector's part along the ground.
        let flat = SPACE_VIEW[0].hypot(SPACE_VIEW[1]);
        let order = drawing_order(view, &self.points);
        let mut writer = Writer::default();
        writer.zeros_to(NS);
        writer.i16(self.points.len() as i16); // at most 99
        for (index, (point, rank)) in self.points.iter().zip(order).enumerate() {
            for (&value, axis) in point.iter().zip(["x", "y", "z"]) {
                writer
                    .real(value)
                    .map_err(|e| FileError::misfit(format, format!("point {}: {axis} = {e}", index + 1)))?;
            }
            place_on_screen(view, *point).into_iter().for_each(|v| writer.i16(v));
            // Only a cache: a depth that no 6-byte real holds is cut rather than refused.
            let depth = (view.depth(*point) / flat).clamp(-real48::MAX, real48::MAX);
            writer.real(depth).map_err(|e| FileError::misfit(format, e.to_string()))?;
            writer.i16(rank);
        }
        writer.zeros_to(format.bytes());
        Ok(writer.into_bytes())
    }
}

/// The rank of every point, from 1, farthest first; equal depths keep the order of the points.
fn drawing_order(view: View, points: &[[f64; 3]]) -> Vec<i16> {
    let mut ranks = vec![0; points.len()];
    for (rank, index) in (1..).zip(view.far_to_near(points)) {
        ranks[index] = rank; // an index of the same list
    }
    ranks
}

/// The place on the screen that the originals store for a point, cut to 16 bits.
pub(super) fn place_on_screen(view: View, point: [f64; 3]) -> [i16; 2] {
    // A conversion to i16 cuts to its range.
    view.pixel(point, 1.0).map(|value| value as i16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Turn;

    /// A view after steps to the left (or, below zero, to the right) and up.
    fn turned(direction: [f64; 3], left: i32, up: u8) -> View {
        let side = if left < 0 { Turn::Right } else { Turn::Left };
        let sideways = (0..left.abs()).fold(View::from_direction(direction), |view, _| view.stepped(side));
        (0..up).fold(sideways, |view, _| view.stepped(Turn::Up))
    }

    #[test]
    fn places_that_the_dos_programs_saved() {
        let heights = include_bytes!("../../tests/files/TESZT.FEM");
        let sphere = include_bytes!("../../tests/files/TESZT.ZMS");
        let hermite = include_bytes!("../../tests/files/TESZT.FHC");
        for (bytes, view, drawn) in [
            (heights, turned([0.3, -0.7, 0.2], -55, 8), 40),
            (sphere, turned([0.3, -0.7, 0.2], 1, 2), 40),
            (hermite, turned([0.4, -0.7, 0.2], 5, 34), 4),
        ] {
            let mut reader = Reader::new(bytes);
            let mut found = 0;
            for record in 0..40 {
                let mut coordinate = || f64::from(reader.single().unwrap());
                let point = [coordinate(), coordinate(), coordinate()];
                let place = [reader.i16().unwrap(), reader.i16().unwrap()];
                if place != [0; 2] {
                    assert_eq!(place_on_screen(view, point), place, "record {record}");
                    found += 1;
                }
            }
            assert_eq!(found, drawn);
        }
    }

    #[test]
    fn far_places_are_cut() {
        let view = View::from_direction([1.0, 0.0, 0.0]);
        assert_eq!(place_on_screen(view, [0.0, 1e300, -1e300]), [i16::MAX, i16::MAX]);
    }
}
