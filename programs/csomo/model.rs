//! The model as `dump` writes it.

use super::bench::{Bench, Options};
use super::texts::PathKind;
use crate::design::knots::edit::{self, Ends};
use crate::editor::Editor;
use crate::geometry::Point;
use serde::Serialize;

#[derive(Serialize)]
struct Model {
    order: usize,
    ends: Ends,
    points: Vec<Point<2>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    weights: Option<Vec<f64>>,
    knots: Vec<f64>,
    /// Whether there is a curve.
    curve: bool,
    u: Option<f64>,
    /// The chosen knot, and how many equal ones go with it.
    knot: Option<usize>,
    copies: Option<usize>,
    #[serde(flatten)]
    options: Options,
    /// Of the curvatures of envelope and curve.
    ratio: Option<f64>,
    straight: Option<bool>,
    path_order: Option<usize>,
    inflections: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    search: Option<Found>,
    unsaved: bool,
}

/// A search that goes on.
#[derive(Serialize)]
struct Found {
    target: Option<Point<2>>,
    solutions: usize,
    /// The knots and the parameter of the solution in the picture.
    knots: Option<Vec<f64>>,
}

/// The model of the editor as it is.
pub(super) fn of(editor: &Editor<Bench, 2>) -> impl Serialize + use<> {
    let now = editor.history.now();
    let status = editor.status(now);
    let path = status.as_ref().map(|status| status.path);
    let knot = status.as_ref().and_then(|status| status.knot);
    Model {
        order: now.order,
        ends: edit::ends(now),
        points: edit::places(now).to_vec(),
        weights: now.weights.clone(),
        knots: now.knots.clone(),
        curve: status.is_some(),
        u: status.as_ref().map(|status| status.u),
        knot: knot.map(|(first, ..)| first),
        copies: knot.map(|(.., copies)| copies),
        options: editor.craft.options,
        ratio: status.as_ref().and_then(|status| status.ratio),
        straight: path.map(|path| path == PathKind::Straight),
        path_order: path.and_then(|path| match path {
            PathKind::Straight => Some(1),
            PathKind::Order(order) => Some(order),
            PathKind::None => None,
        }),
        inflections: status.as_ref().map(|status| status.inflections),
        search: editor.craft.search.as_ref().map(|search| Found {
            target: search.target,
            solutions: search.count(),
            knots: search.chosen().map(|(_, through)| through.curve.vector().knots().to_vec()),
        }),
        unsaved: editor.history.unsaved(),
    }
}
