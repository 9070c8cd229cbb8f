//! Rational Bézier patches, `.RBS`: the exact form of an offset.

use super::FileError;
use super::check::number;
use serde::{Deserialize, Serialize};

/// Rational Bézier patches in a net.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Patches {
    /// How far they lie from the surface that they are an offset of.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub distance: Option<f64>,
    /// The patches in any order.
    pub patches: Vec<PatchItem>,
}

/// A patch with its place in the net.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PatchItem {
    /// The place in the direction of u, from 0.
    pub i: usize,
    /// The place in the direction of v, from 0.
    pub j: usize,
    /// The degrees in u and v.
    pub degree: [usize; 2],
    /// The homogeneous points (xw, yw, zw, w): rows count in the direction of u, points of them in that of v.
    pub homogeneous: Vec<Vec<[f64; 4]>>,
}

impl Patches {
    /// # Errors
    /// [`FileError::Invalid`] when a number is not finite, or points do not belong to the degrees.
    pub(super) fn check(&self) -> Result<(), FileError> {
        if let Some(distance) = self.distance.filter(|distance| !distance.is_finite()) {
            return Err(FileError::Invalid(format!("the distance {distance} is not a finite number")));
        }
        for PatchItem { i, j, degree: [m, n], homogeneous } in &self.patches {
            let rows = homogeneous.len();
            let fits = rows.checked_sub(1) == Some(*m)
                && homogeneous.iter().all(|row| row.len().checked_sub(1) == Some(*n));
            if !fits {
                let columns = homogeneous.first().map_or(0, Vec::len);
                return Err(FileError::Invalid(format!(
                    "patch ({i}, {j}) of the degree ({m}, {n}) has {rows} x {columns} points; a row and a point of it \
                     more than the degree are needed"
                )));
            }
            if homogeneous.iter().flatten().flatten().any(|x| !x.is_finite()) {
                return Err(FileError::Invalid(format!(
                    "patch ({i}, {j}) has a coordinate that is not a finite number"
                )));
            }
        }
        Ok(())
    }

    pub(super) fn describe(&self) -> Vec<String> {
        let mut lines = vec![format!("rational Bézier patches, {}", self.patches.len())];
        lines.extend(self.distance.map(|distance| format!("distance: {}", number(distance))));
        for PatchItem { i, j, degree: [m, n], homogeneous } in &self.patches {
            let weights = homogeneous.iter().flatten().map(|point| point[3]);
            let (low, high) =
                weights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), w| (low.min(w), high.max(w)));
            lines.push(format!(
                "patch {i}, {j}: degree {m}, {n}, weights {} .. {}",
                number(low),
                number(high)
            ));
        }
        lines
    }
}
