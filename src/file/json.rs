//! Documents as JSON, for people and tools.
//!
//! An object with the `"format"`, named after the extension of the DOS file, and the named fields of the value
//! type. Fields that may be missing are left out; unknown ones are an error. A plain list is read as points.

use super::ec::EcDocument;
use super::{Document, FileError, Format, Net, NetKind, Places, TableOptions, json_points, json_text};
use serde::de::{self, DeserializeOwned, IntoDeserializer, MapAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::marker::PhantomData;

/// The name of the field that tells what the document is.
const FORMAT: &str = "format";

impl Document {
    /// The document in a JSON text.
    ///
    /// # Errors
    /// [`FileError::Text`] with the line and the field, for a text that is no JSON, an unknown format, and
    /// missing, unknown or wrong fields; [`FileError::Invalid`] for values that do not belong together.
    pub fn from_json(text: &str) -> Result<Self, FileError> {
        Self::from_json_table(text, &TableOptions::default())
    }

    /// The document in a JSON text, in which points may be a plain list: `[[1, 2], [3, 4]]`, or objects whose
    /// fields are found like the columns of a table.
    ///
    /// # Errors
    /// Those of [`Document::from_json`], and [`FileError::NoTable`] for columns and no list.
    pub fn from_json_table(text: &str, options: &TableOptions) -> Result<Self, FileError> {
        let text = text.trim_start_matches('\u{feff}');
        let list = text.trim_start().starts_with('[');
        // The numbers of JSON have one form, and the fields of a document have their names.
        let unused = match list {
            true => TableOptions { columns: None, ..options.clone() }.given(),
            false => options.given(),
        };
        if let Some(option) = unused {
            return Err(FileError::NoTable { option });
        }
        if list {
            return json_points::read(text, options.columns.as_ref());
        }
        let other = !text.trim_start().starts_with('{') && !text.trim().is_empty();
        let Head { format, balls } = if other { Head::default() } else { parse(text)? };
        let Some(format) = format.or_else(|| balls.map(|_| Format::Bil.extension().to_owned())) else {
            if let Ok(Bare { points }) = parse::<Bare>(text)
                && !points.is_empty()
            {
                let document = Self::of_places(points);
                document.check()?;
                return Ok(document);
            }
            return Err(FileError::Text {
                line: 1,
                place: String::new(),
                problem: json_points::WANTED.to_owned(),
            });
        };
        let Some(format) = Format::from_extension(&format) else {
            let known: Vec<_> = Format::ALL.iter().map(|f| f.extension()).collect();
            let problem = format!("\"{format}\" is none of {}", known.join(", "));
            return Err(FileError::Text { line: 1, place: FORMAT.to_owned(), problem });
        };
        let document = match format {
            Format::Ip2 | Format::Ic2 => fields(text).map(Self::PlanePoints),
            Format::Ec2 => fields(text).map(Self::Tangents),
            Format::Gbp => fields(text).map(Box::new).map(Self::Fourier),
            Format::Ip3 => fields(text).map(Self::SpacePoints),
            Format::Gyk => fields(text).map(Self::BeadWheel),
            Format::Csk => fields(text).map(Self::CsangoCube),
            Format::Bil => fields(text).map(Box::new).map(Self::Billiards),
            Format::Kct => fields(text).map(EcDocument::Space).map(Self::from),
            Format::Kcg => fields(text).map(EcDocument::Curve).map(Self::from),
            Format::Kcf => fields(text).map(EcDocument::Patch).map(Self::from),
            Format::Kce => fields(text).map(EcDocument::Coefficients).map(Self::from),
            Format::Kcj => fields(text).map(EcDocument::Scene).map(Self::from),
            Format::Rbc => fields(text).map(Box::new).map(Self::Rational),
            Format::Rbs => fields(text).map(Box::new).map(Self::Patches),
            Format::Csm => fields(text).map(Box::new).map(Self::Knots),
            Format::Csf => fields(text).map(Box::new).map(Self::KnotNet),
            Format::Alp => fields(text).map(Box::new).map(Self::Shaped),
            Format::Som => fields(text).map(Box::new).map(Self::Som),
            Format::Kor => fields(text).map(Box::new).map(Self::Circles),
            Format::Gom => fields(text).map(Box::new).map(Self::Spheres),
            Format::Xyz | Format::Ply | Format::Obj | Format::Stl => fields(text).map(Self::Cloud),
            _ => fields(text).map(|net: Net| {
                // Every format that is left has a kind of net.
                Self::Net(Net { kind: NetKind::of(format).unwrap_or(net.kind), ..net })
            }),
        }?;
        document.check()?;
        Ok(document)
    }

    /// The document as JSON text; reading it back gives the same document.
    ///
    /// # Errors
    /// [`FileError::Invalid`] when a number is not finite or the values do not belong together.
    pub fn to_json(&self) -> Result<String, FileError> {
        self.check()?;
        let format = self.format().extension();
        let compact = match self {
            Self::PlanePoints(value) => tagged(format, value),
            Self::Tangents(value) => tagged(format, value),
            Self::Fourier(value) => tagged(format, value.as_ref()),
            Self::SpacePoints(value) => tagged(format, value),
            Self::Net(value) => tagged(format, value),
            Self::BeadWheel(value) => tagged(format, value),
            Self::CsangoCube(value) => tagged(format, value),
            Self::Billiards(value) => tagged(format, value.as_ref()),
            Self::Ec(value) => value.written(),
            Self::Rational(value) => tagged(format, value.as_ref()),
            Self::Patches(value) => tagged(format, value.as_ref()),
            Self::Knots(value) => tagged(format, value.as_ref()),
            Self::KnotNet(value) => tagged(format, value.as_ref()),
            Self::Shaped(value) => tagged(format, value.as_ref()),
            Self::Som(value) => tagged(format, value.as_ref()),
            Self::Circles(value) => tagged(format, value.as_ref()),
            Self::Spheres(value) => tagged(format, value.as_ref()),
            Self::Cloud(value) => tagged(format, value),
        };
        compact.map(|text| json_text::laid_out(&text)).map_err(|e| FileError::Invalid(e.to_string()))
    }
}

/// All that is read at first.
#[derive(Default, Deserialize)]
struct Head {
    format: Option<String>,
    /// Games of billiards were saved without their format once.
    balls: Option<de::IgnoredAny>,
}

/// Points under their name, and nothing else.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Bare {
    points: Places,
}

impl EcDocument {
    fn written(&self) -> serde_json::Result<String> {
        // Their own format spells itself in small letters, here and in the items of a scene.
        let format = self.format().extension().to_lowercase();
        match self {
            Self::Space(value) => tagged(&format, value),
            Self::Curve(value) => tagged(&format, value),
            Self::Patch(value) => tagged(&format, value),
            Self::Coefficients(value) => tagged(&format, value),
            Self::Scene(value) => tagged(&format, value),
        }
    }
}

fn tagged(format: &str, value: &impl Serialize) -> serde_json::Result<String> {
    #[derive(Serialize)]
    struct Tagged<'a, T> {
        format: &'a str,
        #[serde(flatten)]
        value: &'a T,
    }
    serde_json::to_string(&Tagged { format, value })
}

fn fields<T: DeserializeOwned>(text: &str) -> Result<T, FileError> {
    parse(text).map(|Untagged(value)| value)
}

fn parse<T: DeserializeOwned>(text: &str) -> Result<T, FileError> {
    serde_json::from_str(text).map_err(|error| wrong(text, &error))
}

/// What is wrong with a text, at its line and field.
pub(super) fn wrong(text: &str, error: &serde_json::Error) -> FileError {
    let (line, column) = (error.line().max(1), error.column());
    let message = error.to_string();
    let problem = message.split_once(" at line ").map_or(message.as_str(), |(problem, _)| problem);
    let problem = match error.is_eof() {
        true if text.trim().is_empty() => "the text is empty".to_owned(),
        true => "the text ends too early".to_owned(),
        false => in_words(problem),
    };
    FileError::Text { line, place: json_text::place(text, line, column), problem }
}

/// What serde says, in the user's terms; what we say ourselves stays.
fn in_words(problem: &str) -> String {
    let told = match problem {
        "expected value" => "a value is needed here",
        "expected ident" => "true, false or null is needed here",
        "expected `:`" => "a colon is needed here",
        "expected `,` or `]`" => "a comma or ] is needed here",
        "expected `,` or `}`" => "a comma or } is needed here",
        "key must be a string" => "the name of a field is needed here, in quotes",
        "trailing characters" => "there is more than belongs here",
        "trailing comma" => "there is a comma too many",
        "number out of range" => "the number is too large",
        "invalid number" => "this is not a number",
        "invalid escape" => "\\ is followed by a character that it cannot escape",
        "recursion limit exceeded" => "too many brackets are open",
        other if other.starts_with("control character") => "there is a control character in a text",
        other => return of_types(other).or_else(|| of_names(other)).unwrap_or_else(|| other.to_owned()),
    };
    told.to_owned()
}

/// What serde says of a value of another type.
fn of_types(problem: &str) -> Option<String> {
    let (what, wanted) = problem.rsplit_once(", expected ")?;
    let wanted = type_wanted(wanted);
    if let Some(length) = what.strip_prefix("invalid length ") {
        return Some(format!("there must be {wanted} here, not one of length {length}"));
    }
    let found = what.strip_prefix("invalid type: ").or_else(|| what.strip_prefix("invalid value: "))?;
    Some(format!("there must be {wanted} here, not {}", value_found(found)))
}

/// A type as serde names it, or as one of our own readers does.
fn type_wanted(wanted: &str) -> String {
    let length =
        wanted.strip_prefix("an array of length ").or_else(|| wanted.strip_prefix("a tuple of size "));
    if let Some(length) = length {
        return format!("a list of length {length}");
    }
    let told = match wanted {
        "f64" | "f32" => "a number",
        "u8" => "a whole number from 0 to 255",
        "u16" => "a whole number from 0 to 65535",
        "i16" => "a whole number from -32768 to 32767",
        "u32" | "u64" | "usize" => "a whole number of at least 0",
        "i32" | "i64" => "a whole number",
        "a string" => "a text",
        "a sequence" => "a list",
        "a boolean" => "true or false",
        "a map" => "an object",
        other if other.starts_with("struct ") => "an object",
        other => other,
    };
    told.to_owned()
}

/// A value as serde tells it.
fn value_found(found: &str) -> String {
    let bare = |prefix: &str| found.strip_prefix(prefix)?.strip_suffix('`');
    if let Some(number) = bare("integer `").or_else(|| bare("floating point `")) {
        return format!("the number {number}");
    }
    match (found, found.strip_prefix("string ")) {
        ("map", _) => "an object".to_owned(),
        ("sequence", _) => "a list".to_owned(),
        (_, Some(text)) => format!("the text {text}"),
        _ => bare("boolean `").unwrap_or(found).to_owned(),
    }
}

/// What serde says of names that it does not know, or misses.
fn of_names(problem: &str) -> Option<String> {
    let quoted = |text: &str| text.replace('`', "\"");
    if let Some(name) = problem.strip_prefix("missing field ") {
        return Some(format!("the field {} is missing", quoted(name)));
    }
    if let Some(name) = problem.strip_prefix("duplicate field ") {
        return Some(format!("the field {} is there twice", quoted(name)));
    }
    let (what, known) = problem.rsplit_once(", expected ")?;
    let known = quoted(known.strip_prefix("one of ").unwrap_or(known)).replace("\" or \"", "\", \"");
    if let Some(name) = what.strip_prefix("unknown field ") {
        return Some(format!("there is no field {} here, only {known}", quoted(name)));
    }
    let name = what.strip_prefix("unknown variant ")?;
    Some(format!("there is no {} here, only {known}", quoted(name)))
}

/// A value read from an object whose `"format"` has been taken out. (serde's own tagged enums read through
/// a buffer and lose the line of an error.)
struct Untagged<T>(T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Untagged<T> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(ObjectVisitor(PhantomData))
    }
}

struct ObjectVisitor<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for ObjectVisitor<T> {
    type Value = Untagged<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
        T::deserialize(de::value::MapAccessDeserializer::new(WithoutFormat(map))).map(Untagged)
    }
}

struct WithoutFormat<A>(A);

impl<'de, A: MapAccess<'de>> MapAccess<'de> for WithoutFormat<A> {
    type Error = A::Error;

    fn next_key_seed<K: de::DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, A::Error> {
        while let Some(key) = self.0.next_key::<String>()? {
            if key != FORMAT {
                return seed.deserialize(key.into_deserializer()).map(Some);
            }
            self.0.next_value::<de::IgnoredAny>()?;
        }
        Ok(None)
    }

    fn next_value_seed<V: de::DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        self.0.next_value_seed(seed)
    }
}
