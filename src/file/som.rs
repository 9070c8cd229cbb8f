//! Nets of neurons that learnt a cloud of points, `.SOM`, which are JSON only.

use super::check;
use super::{FileError, MAX_CONTROLS};
use crate::geometry::Point;
use crate::geometry::kohonen::Topology;
use serde::{Deserialize, Serialize};

/// A topology by its name.
mod topology {
    use crate::geometry::kohonen::Topology;
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer>(topology: &Topology, serializer: S) -> Result<S::Ok, S::Error> {
        topology.name().serialize(serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Topology, D::Error> {
        let name = String::deserialize(deserializer)?;
        Topology::of_name(&name).ok_or_else(|| {
            let known = Topology::ALL.map(Topology::name).join(", ");
            D::Error::custom(format!("{name:?} is none of {known}"))
        })
    }
}

/// The neurons of a net in space.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SomNet {
    /// How the net is joined.
    #[serde(default = "open", with = "topology")]
    pub topology: Topology,
    /// The neurons in rows of equal length.
    pub points: Vec<Vec<Point<3>>>,
}

fn open() -> Topology {
    Topology::Open
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
                    "row {} of the net has {} neurons and row 1 has {columns}; all must have the same",
                    row + 1,
                    points.len()
                )));
            }
            check::finite(&format!("row {}, neuron", row + 1), points)?;
        }
        Ok(())
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let columns = self.points.first().map_or(0, Vec::len);
        let mut lines =
            vec![format!("net of {} x {columns} neurons, {}", self.points.len(), self.topology.name())];
        lines.extend(check::Bounds::of(self.points.iter().flatten()).map(|bounds| bounds.describe()));
        for (row, points) in self.points.iter().enumerate() {
            lines.extend(check::table(&format!("row {}, neuron", row + 1), points));
        }
        lines
    }
}
