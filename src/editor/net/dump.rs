//! What `dump` writes of a surface.

use super::frame::Frame;
use super::joint::JointDump;
use super::normals::{self, Beside};
use super::surface::Display;
use super::weights::extremes;
use super::{Family, Nets};
use crate::design::Index;
use crate::editor::Editor;
use crate::file::Method;
use crate::geometry::{Border, Point};
use crate::ui::look::Sight;
use serde::Serialize;

/// The model as `dump` writes it. Angles are in degrees.
#[derive(Serialize)]
pub(super) struct Dump {
    points: Vec<Vec<Point<3>>>,
    bias: [f64; 2],
    tension: [f64; 2],
    k0: [f64; 2],
    degree: u8,
    extended: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    border: Option<&'static str>,
    surface: bool,
    filled: bool,
    azimuth: f64,
    elevation: f64,
    zoom: f64,
    projection: Sight,
    unsaved: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    joint: Option<JointDump>,
    #[serde(skip_serializing_if = "Option::is_none")]
    frame: Option<Frame>,
    #[serde(skip_serializing_if = "Option::is_none")]
    weight: Option<WeightDump>,
    #[serde(skip_serializing_if = "Option::is_none")]
    normals: Option<NormalsDump>,
}

/// The point whose weight is shown, and the smallest and largest weight.
#[derive(Serialize)]
struct WeightDump {
    point: Index,
    range: [f64; 2],
}

/// What `dump` writes of surfaces with normals besides.
#[derive(Serialize)]
struct NormalsDump {
    normals: Option<Vec<Vec<Point<3>>>>,
    method: &'static str,
    distance: f64,
    beside: Beside,
    facts: Option<normals::Told>,
}

impl Dump {
    pub(super) fn of(editor: &Editor<Nets, 3>) -> Dump {
        let (now, craft) = (editor.history.now(), &editor.craft);
        let [azimuth, elevation, zoom] = editor.lens.look.angles();
        let weight = |point: Index| Some(WeightDump { point, range: extremes(&*now.influence(point).ok()?) });
        Dump {
            points: now.net.points.clone(),
            bias: now.bias(),
            tension: now.tension(),
            k0: now.k0(),
            degree: if now.method() == Method::BSpline2 { 2 } else { 3 },
            extended: now.border() == Border::Reached,
            border: match now.border() {
                Border::Free => Some("free"),
                Border::Inner => Some("inner"),
                Border::Doubled | Border::Reached => None,
            },
            surface: craft.drawn.is_some(),
            filled: craft.display == Display::Filled,
            azimuth,
            elevation,
            zoom,
            projection: editor.lens.look.sight(),
            unsaved: editor.history.unsaved(),
            joint: JointDump::of(now),
            frame: Some(craft.frame).filter(|frame| *frame != Frame::Off),
            weight: craft.weight.and_then(weight),
            normals: (craft.plan.family == Family::Normals).then(|| NormalsDump {
                normals: now.net.normals.clone(),
                method: now.method().name(),
                distance: now.distance(),
                beside: craft.beside,
                facts: craft.facts.as_ref().map(|facts| facts.told().clone()),
            }),
        }
    }
}
