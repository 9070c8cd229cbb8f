//! The model as `dump` writes it.

use super::craft::Bench;
use super::room::{Here, Room};
use super::{dial, layers, texts};
use crate::design::Place;
use crate::file::Places;
use crate::geometry::{Closure, ParamCurve, Point};
use crate::machine::Language;
use serde::Serialize;
use serde_json::{Map, Value, json};

/// Angles are in degrees.
#[derive(Serialize)]
struct Model<P> {
    family: &'static str,
    /// The parameters of the family by their names.
    parameters: Map<String, Value>,
    /// Control points, or the points that the curve passes.
    points: Vec<P>,
    closed: bool,
    through: bool,
    /// The control points where the curve passes `points`.
    #[serde(skip_serializing_if = "Option::is_none")]
    controls: Option<Vec<P>>,
    spans: Option<usize>,
    /// Why there is no curve.
    problem: Option<String>,
    /// The parameter that is turned, its value and range.
    turned: Option<Turned>,
    paths: bool,
    series: bool,
    cubic: bool,
    basis: bool,
    comb: Option<f64>,
    /// The index of a point without influence.
    dead: Option<usize>,
    /// The value that came of the last target.
    chosen: Option<f64>,
    /// Its position on the curve.
    at: Option<f64>,
    admissible: Option<bool>,
    nearest: Option<P>,
    distance: Option<f64>,
    moving: bool,
    unsaved: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    angles: Option<[f64; 3]>,
}

#[derive(Serialize)]
struct Turned {
    name: String,
    value: Option<f64>,
    range: [f64; 2],
}

/// The model of an editor.
pub(super) fn of<const D: usize>(editor: &Bench<D>) -> impl Serialize + 'static
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now();
    let curve = form.curve().ok();
    let aim = layers::aim_shown(editor);
    let turned = editor.knob().map(|knob| Turned {
        name: dial::name(&knob),
        value: form.value(knob.parameter),
        range: knob.range,
    });
    Model {
        family: form.family().name(),
        parameters: form.numbers().into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect(),
        points: form.points.clone(),
        closed: form.closure() == Closure::Closed,
        through: form.through,
        controls: curve.as_ref().filter(|_| form.through).map(|curve| curve.points().to_vec()),
        spans: curve.as_ref().map(|curve| curve.spans()),
        problem: texts::problem(form).map(|problem| problem.of(Language::English).to_owned()),
        turned,
        paths: editor.craft.options.paths,
        series: editor.craft.options.series,
        cubic: editor.craft.options.cubic,
        basis: editor.craft.options.basis,
        comb: editor.craft.options.comb,
        dead: layers::dead(editor),
        chosen: aim.map(|aim| aim.value),
        at: aim.map(|aim| aim.position),
        admissible: aim.map(|aim| aim.admissible),
        nearest: aim.map(|aim| aim.nearest),
        distance: aim.map(|aim| aim.distance),
        moving: editor.craft.glide.is_some(),
        unsaved: editor.history.unsaved(),
        angles: <Here as Room<D>>::angles(&editor.lens),
    }
}
