//! The model as `dump` writes it.

use super::craft::Bench;
use super::dressed::Style;
use crate::geometry::skin::{Clearing, Violation};
use serde::Serialize;

/// All numbers of circles count from 0.
#[derive(Serialize)]
struct Model {
    circles: Vec<[f64; 3]>,
    closed: bool,
    edges: Option<Vec<[usize; 2]>>,
    admissible: bool,
    violations: Vec<Broken>,
    /// The arcs that enter a disc.
    unclear: Vec<[usize; 2]>,
    /// The circles at which the outline breaks off.
    missing: Vec<usize>,
    /// Its pieces, outline by outline.
    pieces: Vec<usize>,
    style: &'static str,
    plain: bool,
    apollonius: bool,
    radical: bool,
    unsaved: bool,
}

#[derive(Serialize)]
pub(super) struct Broken {
    rule: u8,
    /// Circles or spheres.
    numbers: Vec<usize>,
    sentence: String,
}

/// Broken rules, said about a `circle` or a `sphere`.
pub(super) fn broken(violations: &[Violation], noun: &str) -> Vec<Broken> {
    let row = |it: &Violation| Broken { rule: it.rule(), numbers: it.numbers(), sentence: it.sentence(noun) };
    violations.iter().map(row).collect()
}

/// The model of an editor.
pub(super) fn of(editor: &Bench) -> impl Serialize + 'static {
    let (circles, options) = (editor.history.now().clone(), editor.craft.options);
    let dressed = editor.dressed();
    let violations = dressed.as_ref().map_or(&[][..], |dressed| &dressed.violations[..]);
    let skin = dressed.as_ref().map(|dressed| &dressed.skin);
    Model {
        circles: circles.circles,
        closed: circles.closed,
        edges: circles.edges,
        admissible: violations.is_empty(),
        violations: broken(violations, "circle"),
        unclear: skin.map(|skin| skin.unclear()).unwrap_or_default(),
        missing: skin.map(|skin| skin.missing.clone()).unwrap_or_default(),
        pieces: dressed.iter().flat_map(|it| it.outlines(options.style)).map(|it| it.pieces.len()).collect(),
        style: match options.style {
            Style::Open => "open",
            Style::Caps => "caps",
            Style::Filled => "filled",
        },
        plain: options.clearing == Clearing::Plain,
        apollonius: options.apollonius,
        radical: options.radical,
        unsaved: editor.history.unsaved(),
    }
}
