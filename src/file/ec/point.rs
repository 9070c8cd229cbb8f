//! Points in JSON: two or three numbers or expressions.

use crate::geometry::Point;
use crate::geometry::ec::Real;
use serde::de::{self, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// Two or three numbers; the third is 0 if it is missing.
struct Coordinates([Real; 3]);

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct List;

        impl<'de> Visitor<'de> for List {
            type Value = Coordinates;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a point of two or three numbers")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Coordinates, A::Error> {
                let mut point: [Real; 3] = Default::default();
                let mut count = 0;
                while let Some(number) = list.next_element()? {
                    *point.get_mut(count).ok_or_else(|| de::Error::invalid_length(4, &self))? = number;
                    count += 1;
                }
                if count < 2 { Err(de::Error::invalid_length(count, &self)) } else { Ok(Coordinates(point)) }
            }
        }

        deserializer.deserialize_seq(List)
    }
}

impl Coordinates {
    fn values(self) -> Point<3> {
        self.0.map(|number| number.value())
    }
}

/// Three numbers, kept as written.
pub(super) mod reals {
    use super::*;

    pub(in super::super) fn serialize<S: Serializer>(
        value: &[Real; 3],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        value.serialize(serializer)
    }

    pub(in super::super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<[Real; 3], D::Error> {
        Coordinates::deserialize(deserializer).map(|point| point.0)
    }
}

/// A list of points.
pub(super) mod list {
    use super::*;

    pub(in super::super) fn serialize<S: Serializer>(
        points: &[Point<3>],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        points.serialize(serializer)
    }

    pub(in super::super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec<Point<3>>, D::Error> {
        let points = Vec::<Coordinates>::deserialize(deserializer)?;
        Ok(points.into_iter().map(Coordinates::values).collect())
    }
}

/// Rows of points.
pub(super) mod net {
    use super::*;

    pub(in super::super) fn serialize<S: Serializer>(
        net: &[Vec<Point<3>>],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        net.serialize(serializer)
    }

    pub(in super::super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec<Vec<Point<3>>>, D::Error> {
        let rows = Vec::<Vec<Coordinates>>::deserialize(deserializer)?;
        Ok(rows.into_iter().map(|row| row.into_iter().map(Coordinates::values).collect()).collect())
    }
}
