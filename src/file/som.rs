//! Nets of neurons that learnt a cloud of points, `.SOM`, which are JSON only.

use super::check;
use super::{FileError, MAX_CONTROLS};
use crate::geometry::Point;
use serde::{Deserialize, Serialize};

/// How the net is joined, by the names in documents and commands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SomTopology {
    /// Like a sheet.
    #[default]
    Open,
    /// The last column beside the first.
    Cylinder,
    /// Rows and columns go round.
    Torus,
    /// Columns go round, the first and the last row are one neuron each.
    Sphere,
}

impl SomTopology {
    /// Every topology with its name.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::Open, "open"),
        (Self::Cylinder, "cylinder"),
        (Self::Torus, "torus"),
        (Self::Sphere, "sphere"),
    ];

    /// The name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(topology, _)| *topology == self).map_or("", |(_, name)| name)
    }
}

/// The neurons of a net in space.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SomNet {
    /// How the net is joined.
    #[serde(default)]
    pub topology: SomTopology,
    /// The neurons in rows of equal length.
    pub points: Vec<Vec<Point<3>>>,
}

impl SomNet {
    /// # Errors
    /// [`FileError::Invalid`] for rows of different length, or a number that is not finite.
    pub(super) fn check(&self) -> Result<(), FileError> {
        let columns = self.points.first().map_or(0, Vec::len);
        let count: usize = self.points.iter().map(Vec::len).sum();
        if count > MAX_CONTROLS {
            return Err(FileError::Invalid(format!("{count} neurons; there may be {MAX_CONTROLS} at most")));
        }
        for (row, points) in self.points.iter().enumerate() {
            if points.len() != columns {
                return Err(FileError::Invalid(format!(
                    "row {row} has {} neurons; it must have {columns}, as row 0 has",
                    points.len()
                )));
            }
            check::finite(&format!("row {row}, neuron"), points)?;
        }
        Ok(())
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let columns = self.points.first().map_or(0, Vec::len);
        let mut lines =
            vec![format!("net of {} x {columns} neurons, {}", self.points.len(), self.topology.name())];
        lines.extend(check::Bounds::of(self.points.iter().flatten()).map(|bounds| bounds.describe()));
        for (row, points) in self.points.iter().enumerate() {
            lines.extend(check::table(&format!("row {row}, neuron"), points));
        }
        lines
    }
}
