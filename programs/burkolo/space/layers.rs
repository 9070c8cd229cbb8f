//! What is written beside the spheres.

use super::super::layers::{HINT, LETTERS, say_status};
use super::super::texts;
use super::craft::Bench;
use crate::editor::lens::Lens;
use crate::editor::picture::{Layer, Page};
use crate::screen::{Color, Stroke};
use crate::ui::look::pixel;
use crate::ui::words::{self, Words};
use crate::ui::{Hint, Phrase};

/// Draws a layer.
pub(super) fn draw(editor: &Bench, layer: Layer, page: &mut Page<'_>) {
    match layer {
        Layer::Over => draw_pointed(editor, page),
        Layer::Titles => draw_titles(editor, page),
        Layer::Frame => draw_place(editor, page),
        _ => {}
    }
}

/// The sphere that a question is about.
fn draw_pointed(editor: &Bench, page: &mut Page<'_>) {
    let pointed = editor.craft.pointed_out.and_then(|index| editor.history.now().spheres.get(index));
    if let Some(&[x, y, z, r]) = pointed {
        let (x, y) = editor.lens.pixel([x, y, z]);
        let r = pixel(r * editor.lens.look.scale());
        page.screen.circle(x, y, r, Stroke::thick(Color::LightGreen));
    }
}

/// Under the picture, the place of the sphere that is held.
fn draw_place(editor: &Bench, page: &mut Page<'_>) {
    use super::craft::Handle;
    let Some(Handle::Middle(index) | Handle::Rim(index)) = editor.held.map(|held| held.handle) else {
        return;
    };
    if let Some(&[x, y, z, r]) = editor.preview().spheres.get(index) {
        let text = words::place_of(index + 1, [x, y, z]);
        let text = format!("{}   r = {r}", text.of(page.language));
        page.screen.text(100, 470, &text, Color::Black);
    }
}

/// Whether the spheres are admissible, and what the page says.
fn draw_titles(editor: &Bench, page: &mut Page<'_>) {
    let Some(covered) = editor.covered() else { return };
    let spheres = &covered.spheres;
    let kind = match (spheres.closed(), spheres.chains().len()) {
        (true, _) => texts::RING,
        (false, 1) => texts::CHAIN,
        (false, _) => texts::TREE,
    };
    let tubes = covered.skin.arms.iter().flat_map(|arm| &arm.tubes);
    let spans = tubes.map(|tube| tube.tube_spans().len()).sum();
    let facts = texts::space_facts(spheres.spheres().len(), spans, kind);
    let unclear = covered.skin.unclear();
    let missing = covered.skin.arms.iter().flat_map(|arm| &arm.missing).next();
    let note: Option<Phrase> = match (unclear.first(), missing) {
        (Some(&pair), _) => Some(texts::unclear(pair, unclear.len() - 1)),
        (None, Some(&sphere)) => Some(texts::missing_sphere(sphere)),
        (None, None) => None,
    };
    say_status(page, texts::sphere_rule(&covered.violations), &facts, note);
}

/// What can be done now.
pub(super) fn hint(editor: &Bench) -> Hint {
    let text: Words = match () {
        () if editor.held.is_some() => texts::HINT_HELD,
        () if editor.history.now().spheres.is_empty() => texts::HINT_EMPTY_SPACE,
        () => texts::HINT_SPACE,
    };
    Hint::at(HINT, LETTERS, text)
}
