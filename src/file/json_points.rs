//! Points as a plain list in JSON, as other programs write them: `[[1, 2], [3, 4]]`, `[{"x": 1, "y": 2}]`, and
//! what `grafika sample` writes.

use super::json::wrong;
use super::table::{Columns, Unchosen, by_axes, by_numbers, by_option};
use super::{Document, FileError};
use serde::de::{self, DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// What a JSON text has to look like.
pub(super) const WANTED: &str = "a document has a format, as in {\"format\": \"IP2\", \"points\": [[1, 2], [3, 4]]}; \
                                 points alone are a list, [[1, 2], [3, 4]] or [{\"x\": 1, \"y\": 2}]";

/// The points in a text that is a list.
///
/// # Errors
/// [`FileError::Text`] for what is no list of points, or has fields of which it is not known which count.
pub(super) fn read(text: &str, columns: Option<&Columns>) -> Result<Document, FileError> {
    let mut deserializer = serde_json::Deserializer::from_str(text);
    let points = deserializer.deserialize_seq(List(columns)).and_then(|points| {
        deserializer.end()?;
        Ok(points)
    });
    let (points, coordinates) = points.map_err(|error| {
        if !error.to_string().starts_with("invalid type") {
            return wrong(text, &error);
        }
        // What is no JSON at all, or only its beginning, is told first.
        if let Err(broken) = serde_json::from_str::<IgnoredAny>(text) {
            return wrong(text, &broken);
        }
        // The parser names a type of ours, the user needs an example.
        match wrong(text, &error) {
            FileError::Text { line, place, .. } => {
                FileError::Text { line, place, problem: format!("this is no point; {WANTED}") }
            }
            other => other,
        }
    })?;
    match points.is_empty() {
        true => Err(FileError::Text {
            line: 1,
            place: String::new(),
            problem: format!("the list is empty; {WANTED}"),
        }),
        false => Ok(Document::of_points(points, coordinates)),
    }
}

/// Which items of a row are the coordinates.
struct Picked {
    columns: Vec<usize>,
    /// The names of the fields, where rows are objects.
    names: Vec<String>,
    /// How many items a list has.
    width: usize,
}

impl Picked {
    /// What the first row tells.
    fn by_first(
        first: &[(String, Option<f64>)],
        named: bool,
        columns: Option<&Columns>,
    ) -> Result<Self, String> {
        let names: Vec<String> = match named {
            true => first.iter().map(|(name, _)| name.clone()).collect(),
            false => Vec::new(),
        };
        let numeric = || (0..first.len()).filter(|&column| first[column].1.is_some()).collect::<Vec<_>>();
        let chosen = match columns {
            Some(columns) => by_option(columns, &names),
            None => match by_axes(&names) {
                Err(Unchosen::Unknown) => by_numbers(numeric(), &names),
                chosen => chosen,
            },
        };
        let columns = chosen.map_err(|doubt| doubt.problem(&names, first.len()))?.0;
        match columns.iter().find(|&&column| column >= first.len()) {
            Some(column) => Err(format!("there is no column {}; a row has {}", column + 1, first.len())),
            None => Ok(Self { columns, names, width: first.len() }),
        }
    }

    /// The point in a row.
    fn point(&self, row: &[(String, Option<f64>)], named: bool) -> Result<[f64; 3], String> {
        if named == self.names.is_empty() {
            return Err("lists and objects are mixed".to_owned());
        }
        if !named && row.len() != self.width {
            return Err(format!("a list of {}; the first has {}", row.len(), self.width));
        }
        let mut point = [0.0; 3];
        for (value, &column) in point.iter_mut().zip(&self.columns) {
            let name = self.names.get(column);
            // Fields mostly stand in the same order.
            let field = row.get(column).filter(|(found, _)| name.is_none_or(|name| name == found));
            let field = field.or_else(|| row.iter().find(|(found, _)| Some(found) == name));
            let place = || name.map_or_else(|| format!("item {}", column + 1), |name| format!("\"{name}\""));
            *value = match field {
                Some((_, Some(number))) => *number,
                Some((_, None)) => return Err(format!("{} is not a number", place())),
                None => return Err(format!("there is no {}", place())),
            };
        }
        Ok(point)
    }
}

/// The list of all points.
struct List<'c>(Option<&'c Columns>);

impl<'de> Visitor<'de> for List<'_> {
    type Value = (Vec<[f64; 3]>, usize);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of points")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut rows: A) -> Result<Self::Value, A::Error> {
        let mut points = Vec::new();
        let mut picked: Option<Picked> = None;
        let mut row = Row::default();
        while rows.next_element_seed(&mut row)?.is_some() {
            let Row { items, named } = &row;
            let picked = match &picked {
                Some(picked) => picked,
                None => picked.insert(Picked::by_first(items, *named, self.0).map_err(de::Error::custom)?),
            };
            let number = points.len() + 1;
            let wrong = |problem| de::Error::custom(format!("point {number}: {problem}"));
            points.push(picked.point(items, *named).map_err(wrong)?);
        }
        Ok((points, picked.map_or(0, |picked| picked.columns.len())))
    }
}

/// A row: its items, with their names if it is an object; what is no number is nothing.
#[derive(Default)]
struct Row {
    items: Vec<(String, Option<f64>)>,
    named: bool,
}

impl<'de> DeserializeSeed<'de> for &mut Row {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        self.items.clear();
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for &mut Row {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a point, [1, 2] or {\"x\": 1, \"y\": 2}")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<(), A::Error> {
        self.named = false;
        while let Some(Item(number)) = items.next_element()? {
            self.items.push((String::new(), number));
        }
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<(), A::Error> {
        self.named = true;
        while let Some((name, Item(number))) = fields.next_entry()? {
            self.items.push((name, number));
        }
        Ok(())
    }
}

/// A number, or anything else.
struct Item(Option<f64>);

impl<'de> de::Deserialize<'de> for Item {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ItemVisitor).map(Item)
    }
}

struct ItemVisitor;

impl<'de> Visitor<'de> for ItemVisitor {
    type Value = Option<f64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number")
    }

    fn visit_f64<E>(self, number: f64) -> Result<Self::Value, E> {
        Ok(Some(number))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Self::Value, E> {
        Ok(Some(number as f64))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Self::Value, E> {
        Ok(Some(number as f64))
    }

    fn visit_bool<E>(self, _: bool) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_str<E>(self, _: &str) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_unit<E>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Self::Value, A::Error> {
        while items.next_element::<IgnoredAny>()?.is_some() {}
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<Self::Value, A::Error> {
        while fields.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(None)
    }
}
