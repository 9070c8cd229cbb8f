//! What the page says: distance, length, limits, cusps and loops, or why there is no curve.

use super::analysis::Analysis;
use super::plane::Options;
use super::texts;
use crate::design::DesignError;
use crate::editor::curve::layer::{Canvas, Scene};
use crate::figure::wrap;
use crate::geometry::ph::{Crossing, PhSegment, Place};
use crate::screen::Color;
use crate::ui::{Hint, TOP, Words};
use serde_json::{Value, json};
use std::rc::Rc;

/// Letters in a line of the page.
const LETTERS: usize = 28;
/// The left edge of its text, and its lines.
const LEFT: i32 = TOP.0 + 8;
const LINES: [i32; 3] = [TOP.1 + 4, TOP.1 + 13, TOP.1 + 22];
/// Where the hint stands: the last line of the page.
const HINT: (i32, i32) = (TOP.0 + 8, TOP.1 + 32);

/// Draws title and page.
pub(super) fn draw(
    scene: &Scene<2>,
    analysis: &Result<Rc<Analysis>, DesignError>,
    options: &Options,
    canvas: &mut Canvas<'_>,
) {
    let Canvas { screen, language } = canvas;
    screen.text(28, 5, texts::TITLE.of(*language), Color::Black);
    let analysis = match analysis {
        Ok(analysis) => analysis,
        Err(_) if scene.sketch.points.len() < 2 => return,
        Err(DesignError::NoMethod) => return,
        Err(error) => {
            let lines = wrap(texts::refusal(error).of(*language), LETTERS);
            for (line, y) in lines.iter().zip(LINES) {
                screen.text(LEFT, y, line, Color::Red);
            }
            return;
        }
    };
    if !scene.shown {
        return;
    }
    let first = texts::distance_and_length(options, analysis.curve.total_length());
    screen.text(LEFT, LINES[0], first.of(*language), Color::Black);
    let (low, high) = (analysis.limits[0], analysis.limits[1]);
    let beyond = analysis.sides.iter().any(|side| {
        let d = side.offset.distance();
        low.is_some_and(|low| d <= low) || high.is_some_and(|high| d >= high)
    });
    let ink = if beyond { Color::Red } else { Color::Black };
    screen.text(LEFT, LINES[1], texts::limits(analysis.limits).of(*language), ink);
    let third = match &analysis.refused {
        Some(_) => texts::TOO_FAR.into(),
        None if analysis.sides.is_empty() => texts::NO_OFFSET.into(),
        None if analysis.sides.iter().all(|side| side.vanished()) => texts::VANISHED.into(),
        None => texts::counts(analysis.counts()),
    };
    screen.text(LEFT, LINES[2], third.of(*language), ink);
}

/// What can be done now.
pub(super) fn hint(scene: &Scene<2>, options: &Options) -> Hint {
    let text: Words = match () {
        () if !scene.shown => texts::HINT_CURVE,
        () if scene.grip.is_some() => texts::HINT_GRIP,
        () if scene.held => texts::HINT_HELD,
        () if options.comb.is_some() => texts::HINT_COMB,
        () if options.speed => texts::HINT_SPEED,
        () => texts::HINT_EDIT,
    };
    Hint::at(HINT, LETTERS, text)
}

/// The analysis for `dump`.
pub(super) fn model(analysis: &Analysis) -> Value {
    let place = |place: &Place| json!({ "span": place.span, "u": place.u });
    let crossing = |it: &Crossing| json!(it.places.map(|it| json!([it.span, it.u])));
    let curve = &analysis.curve;
    let offset = |side: &super::analysis::Side| {
        let kept = side.kept.iter().map(|[from, to]| json!([from.span, from.u, to.span, to.u]));
        json!({
            "distance": side.offset.distance(),
            "length": side.offset.length(),
            "cusps": side.offset.cusps().iter().map(place).collect::<Vec<_>>(),
            "crossings": side.crossings.as_ref().map(|all| all.iter().map(crossing).collect::<Vec<_>>()),
            "kept": kept.collect::<Vec<_>>(),
        })
    };
    // All in the Bernstein form: r' = h w^2 and the speed h |w|^2 by the span's own t.
    let span = |it: &PhSegment| {
        json!({
            "h": it.step(),
            "w": it.preimage(),
            "hodograph": it.hodograph(),
            "speed": it.speed_coefficients(),
        })
    };
    json!({
        "spans": curve.segments().iter().map(span).collect::<Vec<_>>(),
        "length": curve.total_length(),
        "energy": curve.energy(),
        "rotation": curve.absolute_rotation(),
        "offset_limits": analysis.limits,
        "offsets": analysis.sides.iter().map(offset).collect::<Vec<_>>(),
    })
}
