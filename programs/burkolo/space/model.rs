//! The model as `dump` writes it.

use super::super::model::{Broken, broken};
use super::craft::Bench;
use crate::geometry::skin::Clearing;
use serde::Serialize;

/// All numbers of spheres count from 0; angles are in degrees.
#[derive(Serialize)]
struct Model {
    spheres: Vec<[f64; 4]>,
    closed: bool,
    chains: Option<Vec<Vec<usize>>>,
    admissible: bool,
    violations: Vec<Broken>,
    /// The spheres between which the surface enters one.
    unclear: Vec<[usize; 2]>,
    missing: Vec<usize>,
    /// Centre, axis and radius of the touching circles.
    circles: Vec<([f64; 3], [f64; 3], f64)>,
    plain: bool,
    touching: bool,
    filled: bool,
    unsaved: bool,
    angles: [f64; 3],
}

/// The model of an editor.
pub(super) fn of(editor: &Bench) -> impl Serialize + 'static {
    let (spheres, options) = (editor.history.now().clone(), editor.craft.options);
    let covered = editor.covered();
    let violations = covered.as_ref().map_or(&[][..], |covered| &covered.violations[..]);
    let skin = covered.as_ref().map(|covered| &covered.skin);
    let arms = skin.iter().flat_map(|skin| &skin.arms);
    let circles = skin.map(|skin| skin.circles()).unwrap_or_default();
    Model {
        spheres: spheres.spheres,
        closed: spheres.closed,
        chains: spheres.chains,
        admissible: violations.is_empty(),
        violations: broken(violations, "sphere"),
        unclear: skin.map(|skin| skin.unclear()).unwrap_or_default(),
        missing: arms.flat_map(|arm| arm.missing.iter().copied()).collect(),
        circles: circles.into_iter().map(|circle| (circle.center, circle.axis, circle.radius)).collect(),
        plain: options.clearing == Clearing::Plain,
        touching: options.touching,
        filled: options.filled,
        unsaved: editor.history.unsaved(),
        angles: editor.lens.look.angles(),
    }
}
