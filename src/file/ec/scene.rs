//! Scenes of KC_TER: items of the two kinds, how they are joined, and how they are seen.

use super::{EcCurve, EcPatch, Light};
use crate::file::FileError;
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// A curve or a patch.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "format", rename_all = "lowercase")]
pub enum Item {
    /// A curve.
    #[serde(rename = "kcg")]
    Curve(EcCurve),
    /// A patch.
    #[serde(rename = "kcf")]
    Patch(EcPatch),
}

/// The format is the first field, as it is written: then errors have their line. serde's own tagged enums read
/// through a buffer and lose it.
impl<'de> Deserialize<'de> for Item {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Object;

        impl<'de> Visitor<'de> for Object {
            type Value = Item;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an item, which begins with its format, as in {\"format\": \"kcg\", …}")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Item, A::Error> {
                if map.next_key::<String>()?.as_deref() != Some("format") {
                    return Err(de::Error::custom("an item begins with its format, \"kcg\" or \"kcf\""));
                }
                let format: String = map.next_value()?;
                let rest = de::value::MapAccessDeserializer::new(map);
                match format.to_ascii_lowercase().as_str() {
                    "kcg" => EcCurve::deserialize(rest).map(Item::Curve),
                    "kcf" => EcPatch::deserialize(rest).map(Item::Patch),
                    other => Err(de::Error::custom(format!("\"{other}\" is none of kcg, kcf"))),
                }
            }
        }

        deserializer.deserialize_map(Object)
    }
}

/// A border of an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Border {
    /// The start of a curve, or the border of a patch where u starts.
    Start,
    /// The end of a curve, or the border of a patch where u ends.
    End,
    /// The border of a patch where v starts.
    VStart,
    /// The border of a patch where v ends.
    VEnd,
}

impl Border {
    /// The direction that it crosses: 0 for u, 1 for v.
    #[must_use]
    pub fn direction(self) -> usize {
        usize::from(matches!(self, Self::VStart | Self::VEnd))
    }

    /// Whether it is at the end of its direction.
    #[must_use]
    pub fn is_end(self) -> bool {
        matches!(self, Self::End | Self::VEnd)
    }
}

/// An item's border: the number of the item, from 0, and which border.
pub type Corner = (usize, Border);

/// Two borders that are one line, with equal derivatives across it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Join {
    /// One border.
    pub a: Corner,
    /// The other.
    pub b: Corner,
    /// The number of equal derivatives.
    pub order: usize,
    /// Whether the tangents are equal in direction only (G1).
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub geometric: bool,
}

/// How a scene is seen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SceneView {
    /// The angle round the z axis in degrees.
    pub azimuth: f64,
    /// The height of the eye in degrees.
    pub elevation: f64,
    /// Pixels a unit.
    pub zoom: f64,
    /// Where the origin is, in pixels from the middle of the field.
    pub shift: [f64; 2],
}

impl Default for SceneView {
    fn default() -> Self {
        Self { azimuth: 20.0, elevation: 25.0, zoom: 1.0, shift: [0.0; 2] }
    }
}

/// How all items of a scene are drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SceneSettings {
    /// The width of lines, 1 to 5.
    pub line: u8,
    /// The width of the selected item's lines, 1 to 7.
    pub selected: u8,
    /// Steps of a curve, 10 to 1000.
    pub points: usize,
    /// Steps of a patch along u and v, 2 to 80.
    pub mesh: [usize; 2],
    /// The colour of control polygons.
    pub polygon: u8,
    /// The colour of the ground.
    pub ground: u8,
    /// Whether the axes are seen.
    pub axes: bool,
    /// Where the light comes from.
    pub light: Light,
}

impl Default for SceneSettings {
    fn default() -> Self {
        Self {
            line: 1,
            selected: 3,
            points: 50,
            mesh: [20; 2],
            polygon: 10,
            ground: 0,
            axes: true,
            light: Light::Eye,
        }
    }
}

/// Curves and patches that are seen together.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// The items, in the order in which they were made.
    pub items: Vec<Item>,
    /// How they are joined.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joins: Vec<Join>,
    /// How they are seen; the program finds a good view if this is missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub view: Option<SceneView>,
    /// How they are drawn.
    #[serde(default, skip_serializing_if = "SceneSettings::is_usual")]
    pub settings: SceneSettings,
}

/// The most items of a scene.
const MOST_ITEMS: usize = 1000;

/// A colour of the screen.
pub(super) fn colour(colour: u8) -> Result<(), FileError> {
    match colour {
        0..16 => Ok(()),
        _ => Err(FileError::Invalid(format!("there is no colour {colour}; colours are 0 to 15"))),
    }
}

impl SceneSettings {
    fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    fn check(&self) -> Result<(), FileError> {
        let ranges = [
            ("line", usize::from(self.line), 1..=5),
            ("selected", usize::from(self.selected), 1..=7),
            ("points", self.points, 10..=1000),
            ("mesh", self.mesh[0], 2..=80),
            ("mesh", self.mesh[1], 2..=80),
        ];
        for (name, value, range) in ranges {
            if !range.contains(&value) {
                let [low, high] = [range.start(), range.end()];
                return Err(FileError::Invalid(format!(
                    "settings: {name} {value}; it must be {low} to {high}"
                )));
            }
        }
        colour(self.polygon)?;
        colour(self.ground)
    }
}

impl Scene {
    pub(super) fn check(&self) -> Result<(), FileError> {
        let count = self.items.len();
        if count > MOST_ITEMS {
            return Err(FileError::Invalid(format!("{count} items; a scene has {MOST_ITEMS} at most")));
        }
        for (number, item) in (1..).zip(&self.items) {
            let number: usize = number;
            let checked = match item {
                Item::Curve(curve) => curve.check(),
                Item::Patch(patch) => patch.check(),
            };
            checked.map_err(|error| FileError::Invalid(format!("item {number}: {error}")))?;
        }
        self.joins.iter().try_for_each(|join| self.check_join(join))?;
        if let Some(view) = &self.view {
            let numbers = [view.azimuth, view.elevation, view.zoom, view.shift[0], view.shift[1]];
            if !numbers.iter().all(|number| number.is_finite()) || view.zoom <= 0.0 {
                return Err(FileError::Invalid(
                    "view: its numbers must be finite, and zoom positive".to_owned(),
                ));
            }
        }
        self.settings.check()
    }

    fn check_join(&self, join: &Join) -> Result<(), FileError> {
        let wrong = |text: String| Err(FileError::Invalid(format!("joins: {text}")));
        for (number, border) in [join.a, join.b] {
            match self.items.get(number) {
                None => return wrong(format!("there is no item {number}; they are numbered from 0")),
                Some(Item::Curve(_)) if border.direction() == 1 => {
                    return wrong(format!("item {number} is a curve, which has a start and an end only"));
                }
                Some(_) => {}
            }
        }
        if join.a.0 == join.b.0 {
            return wrong(format!("item {} cannot be joined with itself", join.a.0));
        }
        let kinds = [join.a, join.b].map(|(number, _)| matches!(self.items[number], Item::Curve(_)));
        if kinds[0] != kinds[1] {
            return wrong("a curve cannot be joined with a patch".to_owned());
        }
        if join.order > 3 {
            return wrong(format!("order {}; it must be 0 to 3", join.order));
        }
        Ok(())
    }
}

/// One item is a scene.
impl From<Item> for Scene {
    fn from(item: Item) -> Self {
        Self { items: vec![item], ..Self::default() }
    }
}
