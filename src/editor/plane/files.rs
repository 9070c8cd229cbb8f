//! The editor's sketch as documents and files: `.IP2`, `.IC2` with its twin `.EC2`, and JSON for what the
//! DOS formats cannot hold.

use super::{Drawing, Editor, Sketch, Tools};
use crate::editor::drawing::Place;
use crate::file::{CurveSettings, Document, FileKind, Format, Method, PlanePoints};
use crate::geometry::Closure;
use crate::machine::Storage;
use crate::ui::words::{self, Phrase};
use crate::work::read_document;

/// Whether the editor can work with a document; else why not.
///
/// # Errors
/// The reason, in both languages.
pub fn check(document: &Document) -> Result<(), Phrase> {
    drawing_of(document).map(|_| ())
}

/// Whether a document is drawn as a beta-spline.
pub(super) fn is_beta(document: &Document) -> bool {
    matches!(document, Document::PlanePoints(plane) if plane.settings.method == Some(Method::Beta))
}

fn drawing_of(document: &Document) -> Result<(&PlanePoints, Drawing), Phrase> {
    let Document::PlanePoints(plane) = document else { return Err(words::WRONG_CONTENT.into()) };
    let outside = plane.points.iter().position(|point| !point.fits());
    let drawing = Drawing::new(plane.points.clone()).ok_or_else(|| match outside {
        Some(index) => words::outside_field(index + 1, plane.points[index]),
        None => words::too_many_points(plane.points.len()),
    })?;
    Ok((plane, drawing))
}

/// The same name with another extension.
fn twin(name: &str, extension: &str) -> String {
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    format!("{stem}.{extension}")
}

/// The document of an `.IC2` file with the tangents of its twin, where there is one; others as they are.
pub fn with_twin(document: Document, storage: &dyn Storage, name: &str) -> Document {
    let is_ic2 = Format::from_name(name) == Some(Format::Ic2);
    match (document, is_ic2) {
        (Document::PlanePoints(plane), true) if plane.tangents.is_none() => {
            match read_document(storage, &twin(name, Format::Ec2.extension()), Format::Ec2) {
                Ok(Document::Tangents(tangents)) => Document::PlanePoints(plane.with_tangents(&tangents)),
                _ => Document::PlanePoints(plane),
            }
        }
        (document, _) => document,
    }
}

impl Editor {
    /// Takes up the points of a document and what this program knows to do with the rest.
    pub(super) fn open_document(&mut self, document: &Document) -> Result<(), Phrase> {
        let (plane, drawing) = drawing_of(document)?;
        let mut sketch = Sketch { drawing, ..self.empty() };
        let settings = &plane.settings;
        sketch.shape.bias = settings.bias.unwrap_or(sketch.shape.bias);
        sketch.shape.tension = settings.tension.unwrap_or(sketch.shape.tension);
        sketch.joints = plane.joints.clone().filter(|_| self.tools == Tools::Beta);
        self.k0 = settings.k0.unwrap_or(0.5);
        let mut remark = None;
        if self.tools == Tools::Tangents {
            sketch.tangents = plane.tangents.clone();
            if sketch.tangents.is_none() {
                let closed = settings.closed == Some(true);
                let closure = if closed { Closure::Closed } else { Closure::Open };
                let none = Sketch { tangents: Some(vec![[0.0; 2]; plane.points.len()]), ..sketch.clone() };
                sketch = self.with_automatic_tangents(&sketch, closure).unwrap_or(none);
                remark = Some(words::NO_TANGENTS);
            }
        }
        self.load(sketch);
        self.remark = remark;
        Ok(())
    }

    /// The sketch as a document.
    pub(super) fn as_document(&self) -> Document {
        let sketch = self.history.now();
        let mut plane = PlanePoints::new(sketch.points().to_vec());
        plane.tangents = sketch.tangents.clone();
        Document::PlanePoints(plane)
    }

    /// Everything that is edited, also what the files of this program have no place for. The method stands for
    /// the JSON file that belongs to the configuration.
    pub(super) fn whole(&self) -> PlanePoints {
        let sketch = self.history.now();
        let mut plane = PlanePoints::new(sketch.points().to_vec());
        plane.tangents = sketch.tangents.clone();
        plane.joints = sketch.joints.clone();
        plane.settings = CurveSettings {
            method: self.writes_json().then_some(Method::Beta),
            k0: Some(self.k0),
            bias: Some(sketch.shape.bias),
            tension: Some(sketch.shape.tension),
            ..CurveSettings::default()
        };
        plane
    }

    /// Whether a JSON file belongs to the configuration.
    fn writes_json(&self) -> bool {
        self.tools == Tools::Beta && (self.has_json || self.history.now().joints.is_some())
    }

    /// Reads a stored configuration with its twin.
    pub(super) fn read_files(&mut self, storage: &mut dyn Storage, name: &str) -> Result<(), Phrase> {
        let document = with_twin(read_document(storage, name, self.tools.format())?, storage, name);
        let json = self.json_twin(storage, name, &document);
        let has_json = json.is_some();
        self.open_document(&json.unwrap_or(document))?;
        self.has_json = has_json;
        Ok(())
    }

    /// The JSON file beside an `.IP2` file, if it holds shapes for the very same points.
    fn json_twin(&self, storage: &dyn Storage, name: &str, document: &Document) -> Option<Document> {
        let (Tools::Beta, Document::PlanePoints(plane)) = (self.tools, document) else { return None };
        let content = storage.read(&twin(name, "JSON")).ok()?;
        match Document::decode(FileKind::Json, &content).ok()? {
            Document::PlanePoints(json) if json.points == plane.points => Some(Document::PlanePoints(json)),
            _ => None,
        }
    }

    /// The files of the configuration, the first one under its name.
    pub(super) fn as_files(&self, name: &str) -> Result<Vec<(String, Vec<u8>)>, Phrase> {
        let document = self.as_document();
        let dos = |format: Format, name: String| {
            let content = document.write(format).map_err(|error| words::in_file(&name, &error))?;
            Ok::<_, Phrase>((name, content))
        };
        let plain = match (self.tools, &document) {
            (Tools::Tangents, _) => vec![
                dos(Format::Ic2, name.to_string())?,
                dos(Format::Ec2, twin(name, Format::Ec2.extension()))?,
            ],
            _ => vec![dos(Format::Ip2, name.to_string())?],
        };
        let json = self.writes_json().then(|| self.json(&twin(name, "JSON"))).transpose()?;
        Ok(plain.into_iter().chain(json).collect())
    }

    /// The beta-spline with its shapes as JSON.
    fn json(&self, name: &str) -> Result<(String, Vec<u8>), Phrase> {
        let sketch = self.history.now();
        let mut plane = PlanePoints::new(sketch.points().to_vec());
        plane.joints = sketch.joints.clone();
        plane.settings = CurveSettings {
            method: Some(Method::Beta),
            closed: self.shown.choice.map(|choice| choice.closure == Closure::Closed),
            bias: Some(sketch.shape.bias),
            tension: Some(sketch.shape.tension),
            ..CurveSettings::default()
        };
        let text = Document::PlanePoints(plane).to_json().map_err(|error| words::in_file(name, &error))?;
        Ok((name.to_string(), text.into_bytes()))
    }
}
