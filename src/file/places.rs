//! Control points of documents that are of the plane or in space: all of them have two coordinates, or all three.

use super::check::{self, Bounds};
use super::{FileError, MAX_CONTROLS};
use crate::geometry::Point;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Points of the plane, or points in space.
#[derive(Clone, Debug, PartialEq)]
pub enum Places {
    /// Two coordinates each.
    Plane(Vec<Point<2>>),
    /// Three coordinates each.
    Space(Vec<Point<3>>),
}

impl Default for Places {
    fn default() -> Self {
        Self::Plane(Vec::new())
    }
}

impl From<Vec<Point<2>>> for Places {
    fn from(points: Vec<Point<2>>) -> Self {
        Self::Plane(points)
    }
}

impl From<Vec<Point<3>>> for Places {
    fn from(points: Vec<Point<3>>) -> Self {
        Self::Space(points)
    }
}

impl Serialize for Places {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Plane(points) => points.serialize(serializer),
            Self::Space(points) => points.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Places {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let points = Vec::<Vec<f64>>::deserialize(deserializer)?;
        let wrong = |index: usize, found: usize, wanted: &str| {
            D::Error::custom(format!("the number of coordinates of point {index} is {found}; {wanted}"))
        };
        let of_plane = points.first().is_none_or(|point| point.len() == 2);
        if of_plane {
            let place = |(index, point): (usize, Vec<f64>)| {
                <Point<2>>::try_from(point).map_err(|point| wrong(index, point.len(), "the first has 2"))
            };
            return points.into_iter().enumerate().map(place).collect::<Result<_, _>>().map(Self::Plane);
        }
        let place = |(index, point): (usize, Vec<f64>)| {
            let wanted = if index == 0 { "2 or 3 are possible" } else { "the first has 3" };
            <Point<3>>::try_from(point).map_err(|point| wrong(index, point.len(), wanted))
        };
        points.into_iter().enumerate().map(place).collect::<Result<_, _>>().map(Self::Space)
    }
}

impl Places {
    /// How many points there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Plane(points) => points.len(),
            Self::Space(points) => points.len(),
        }
    }

    /// Whether there is no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The points, if they are of the plane.
    #[must_use]
    pub fn plane(&self) -> Option<&[Point<2>]> {
        match self {
            Self::Plane(points) => Some(points),
            Self::Space(_) => None,
        }
    }

    /// The points, if they are in space.
    #[must_use]
    pub fn space(&self) -> Option<&[Point<3>]> {
        match self {
            Self::Plane(_) => None,
            Self::Space(points) => Some(points),
        }
    }

    /// # Errors
    /// [`FileError::Invalid`] when a coordinate is not finite, or there are more than [`MAX_CONTROLS`] points.
    pub(super) fn check(&self) -> Result<(), FileError> {
        if self.len() > MAX_CONTROLS {
            let problem = format!("{} control points; there may be {MAX_CONTROLS} at most", self.len());
            return Err(FileError::Invalid(problem));
        }
        match self {
            Self::Plane(points) => check::finite("point", points),
            Self::Space(points) => check::finite("point", points),
        }
    }

    /// The box around the points, as a line.
    pub(super) fn bounds(&self) -> Option<String> {
        match self {
            Self::Plane(points) => Bounds::of(points.iter()).map(|bounds| bounds.describe()),
            Self::Space(points) => Bounds::of(points.iter()).map(|bounds| bounds.describe()),
        }
    }

    /// A line for every point, counted from 0 as the documents and commands of these curves count.
    pub(super) fn table(&self, more: impl Fn(usize) -> String) -> Vec<String> {
        let row = |(index, point): (usize, &[f64])| {
            let place: Vec<String> = point.iter().copied().map(check::number).collect();
            format!("point {index}: {}{}", place.join(", "), more(index))
        };
        match self {
            Self::Plane(points) => points.iter().map(|it| it.as_slice()).enumerate().map(row).collect(),
            Self::Space(points) => points.iter().map(|it| it.as_slice()).enumerate().map(row).collect(),
        }
    }
}
