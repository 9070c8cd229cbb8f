//! What `dump` writes of a curve.

use super::ambient::Ambient;
use super::compare::Kind;
use super::{Curves, aids, readout, series};
use crate::design::Place;
use crate::editor::Editor;
use crate::file::Method;
use crate::geometry::{Closure, Point};
use serde::Serialize;

/// The model as `dump` writes it. Angles are in degrees.
#[derive(Serialize)]
pub(super) struct Model<P> {
    points: Vec<P>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tangents: Option<Vec<P>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    joints: Option<Vec<crate::geometry::Shape>>,
    bias: f64,
    tension: f64,
    method: Option<&'static str>,
    closed: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    degree: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    smooth: Option<Vec<usize>>,
    k0: f64,
    visible: bool,
    compared: Vec<Kind>,
    #[serde(skip_serializing_if = "Option::is_none")]
    series: Option<series::Series>,
    #[serde(skip_serializing_if = "aids::Aids::none")]
    aids: aids::Aids,
    #[serde(skip_serializing_if = "Option::is_none")]
    chosen: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    own: Option<serde_json::Value>,
    unsaved: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    azimuth: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    elevation: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    zoom: Option<f64>,
}

impl<const D: usize> Model<Point<D>> {
    pub(super) fn of(editor: &Editor<Curves<D>, D>) -> Model<Point<D>>
    where
        Curves<D>: Ambient<D>,
        Point<D>: Place<D> + Serialize,
    {
        let sketch = editor.history.now();
        let [azimuth, elevation, zoom] = match <Curves<D> as Ambient<D>>::angles(&editor.lens) {
            Some(angles) => angles.map(Some),
            None => [None; 3],
        };
        let known = |method: Method| if method == Method::Hermite { "coons" } else { method.name() };
        Model {
            points: sketch.points.clone(),
            tangents: sketch.tangents.clone(),
            joints: sketch.joints.clone(),
            bias: sketch.shape().bias,
            tension: sketch.shape().tension,
            method: editor.method().filter(|_| editor.shown.known).map(known),
            closed: editor.shown.known.then(|| sketch.closure() == Closure::Closed),
            degree: sketch.settings.degree,
            smooth: sketch.settings.smooth.clone(),
            k0: sketch.k0(),
            visible: editor.shown.visible,
            compared: editor.craft.compared.clone(),
            series: editor.craft.series.clone(),
            aids: editor.craft.aids,
            chosen: editor.picked.and_then(readout::name),
            own: editor.craft.layer.as_ref().map(|layer| layer.model(&editor.scene())),
            unsaved: editor.history.unsaved(),
            azimuth,
            elevation,
            zoom,
        }
    }
}
