//! The editor of spheres with a skin.

use super::super::dressed::Memory;
use super::super::texts;
use super::commands::{Action, SPACE};
use super::strings::{self, Row};
use super::{items, layers, model, obey};
use crate::design::Place;
use crate::design::skin::spheres;
use crate::editor::lens::{Held, Lens};
use crate::editor::passage::Passage;
use crate::editor::picture::{Layer, Page};
use crate::editor::seen::Item;
use crate::editor::{Craft, Editor};
use crate::file::{Circles, Document, FIELD, Format, SPACE_VIEW, Spheres};
use crate::geometry::skin::{self, Clearing, MAX_BALLS, SphereSkin, Violation};
use crate::geometry::{BoundingBox, ParamSurface, Point};
use crate::machine::{Asked, Event, Tick};
use crate::ui::look::{Look, Poles, Viewer};
use crate::ui::words::Phrase;
use crate::ui::{Commands, Desk, Hint};
use crate::work::Next;
use serde::Serialize;
use std::rc::Rc;

/// Spheres with what follows from them.
#[derive(Debug)]
pub(super) struct Covered {
    pub(super) spheres: skin::Spheres,
    pub(super) violations: Vec<Violation>,
    pub(super) skin: SphereSkin,
}

/// What is shown, and how.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Options {
    pub(super) clearing: Clearing,
    pub(super) touching: bool,
    pub(super) filled: bool,
}

/// The craft.
pub(crate) struct Strings {
    pub(super) options: Options,
    /// The sphere being changed.
    pub(super) pointed_out: Option<usize>,
    pub(super) passage: Rc<Passage>,
    memory: Memory<Spheres, Covered>,
}

/// What the mouse can hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Handle {
    /// The middle of a sphere.
    Middle(usize),
    /// The rim of a sphere as it is seen; its place has the radius for x.
    Rim(usize),
}

/// The editor of this page.
pub(super) type Bench = Editor<Strings, 3>;

/// How far from a rim the mouse takes it up, and the least radius of a middle, in pixels.
const RIM: f64 = 3.0;
const MIDDLE: f64 = 6.0;
/// Circles up to this radius have no rim inside.
const SMALL: f64 = 12.0;
/// By what a step of the wheel changes a radius.
const STEP: f64 = 1.05;
/// The radii that can be typed or dragged.
pub(super) const RADII: [f64; 2] = [1e-3, 1e4];

impl Strings {
    pub(crate) fn new(passage: Rc<Passage>) -> Strings {
        let options = Options::default();
        Strings { options, pointed_out: None, passage, memory: Memory::default() }
    }

    fn covered(value: &Spheres, clearing: Clearing) -> Option<Covered> {
        let spheres = spheres(value).ok()?;
        let (violations, skin) = (spheres.violations(), spheres.skin(clearing));
        Some(Covered { spheres, violations, skin })
    }
}

/// The circles of a document as spheres in the plane z = 0, the middle of the field at the origin. A tree is strung on a
/// chain for every edge; circles without a link are left out.
pub(crate) fn of_circles(circles: &Circles) -> Spheres {
    let row = |&[x, y, r]: &[f64; 3]| [x - 0.5 * FIELD[0], y - 0.5 * FIELD[1], 0.0, r];
    let Some(edges) = &circles.edges else {
        let spheres = circles.circles.iter().map(row).collect();
        return Spheres { spheres, closed: circles.closed, chains: None };
    };
    let linked: Vec<usize> =
        (0..circles.circles.len()).filter(|index| edges.iter().flatten().any(|it| it == index)).collect();
    let spheres = linked.iter().filter_map(|&index| circles.circles.get(index)).map(row).collect();
    let place = |index: usize| linked.iter().position(|it| *it == index);
    let chains = edges.iter().filter_map(|&[a, b]| Some(vec![place(a)?, place(b)?])).collect();
    Spheres { spheres, closed: false, chains: Some(chains).filter(|chains: &Vec<_>| !chains.is_empty()) }
}

/// The spheres of a document as circles of the field, without their heights.
pub(crate) fn as_circles(spheres: &Spheres) -> Circles {
    let row = |&[x, y, _, r]: &Row| [x + 0.5 * FIELD[0], y + 0.5 * FIELD[1], r];
    let edges = spheres.chains.as_ref().map(|chains| {
        let mut edges: Vec<[usize; 2]> = Vec::new();
        for pair in chains.iter().flat_map(|chain| chain.windows(2)) {
            let [a, b] = [pair[0].min(pair[1]), pair[0].max(pair[1])];
            if !edges.contains(&[a, b]) {
                edges.push([a, b]);
            }
        }
        edges
    });
    Circles { circles: spheres.spheres.iter().map(row).collect(), closed: spheres.closed, edges }
}

impl Craft<3> for Strings {
    type Value = Spheres;
    type Handle = Handle;
    type Lens = Viewer;
    type Action = Action;

    fn format(&self) -> Format {
        Format::Gom
    }

    fn formats(&self, _: &Spheres) -> Vec<Format> {
        vec![Format::Gom, Format::Kor]
    }

    fn commands(&self) -> Commands<Action> {
        SPACE
    }

    fn lens(&self) -> Viewer {
        Viewer::new(Look::new(SPACE_VIEW, Poles::Stop))
    }

    fn fresh(&self, _: Option<&Spheres>) -> Spheres {
        Spheres::default()
    }

    fn of_document(&self, document: &Document, _: &Spheres) -> Result<(Spheres, Option<Phrase>), Phrase> {
        let spheres = match document {
            Document::Spheres(spheres) => spheres,
            Document::Circles(_) => {
                self.passage.lead(Some(document.clone()));
                return Ok((Spheres::default(), None));
            }
            _ => return Err(texts::NO_DOCUMENT.into()),
        };
        if spheres.spheres.len() > MAX_BALLS {
            return Err(texts::full());
        }
        if !spheres.spheres.is_empty() {
            crate::design::skin::spheres(spheres).map_err(|error| Phrase::plain(&error))?;
        }
        Ok((Spheres::clone(spheres), None))
    }

    fn document(&self, spheres: &Spheres) -> Document {
        Document::Spheres(Box::new(spheres.clone()))
    }

    fn names_shape(&self, spheres: &Spheres) -> bool {
        spheres.spheres.len() > 1
    }

    fn has_shape(editor: &Bench) -> bool {
        editor.history.now().spheres.len() > 1
    }

    fn surfaces(editor: &Bench) -> Vec<Box<dyn ParamSurface>> {
        let Some(covered) = editor.covered() else { return Vec::new() };
        let mut surfaces: Vec<Box<dyn ParamSurface>> = Vec::new();
        for arm in &covered.skin.arms {
            surfaces.extend(arm.tubes.iter().map(|tube| Box::new(tube.clone()) as Box<dyn ParamSurface>));
            surfaces.extend(arm.caps.iter().flatten().map(|cap| Box::new(*cap) as Box<dyn ParamSurface>));
        }
        surfaces
    }

    fn hint(editor: &Bench) -> Option<Hint> {
        Some(layers::hint(editor))
    }

    fn model(editor: &Bench) -> impl Serialize + 'static {
        model::of(editor)
    }

    fn place(spheres: &Spheres, handle: Handle) -> Option<Point<3>> {
        match handle {
            Handle::Middle(index) => spheres.spheres.get(index).map(|&[x, y, z, _]| [x, y, z]),
            Handle::Rim(index) => spheres.spheres.get(index).map(|&[.., r]| [r, 0.0, 0.0]),
        }
    }

    fn moved(spheres: &Spheres, handle: Handle, at: Point<3>) -> Spheres {
        let (Handle::Middle(index) | Handle::Rim(index)) = handle;
        let Some(&[a, b, c, r]) = spheres.spheres.get(index) else { return spheres.clone() };
        let [x, y, z] = at.nearest();
        let row = if handle == Handle::Middle(index) { [x, y, z, r] } else { [a, b, c, x] };
        strings::with_sphere(spheres, index, row)
    }

    /// The topmost rim, or the middle of the nearest sphere around.
    fn handle_at(editor: &Bench, (at_x, at_y): (i32, i32)) -> Option<Handle> {
        let look = editor.lens.look;
        let spheres = &editor.history.now().spheres;
        let centers: Vec<Point<3>> = spheres.iter().map(|&[x, y, z, _]| [x, y, z]).collect();
        let far = |index: usize| {
            let (x, y) = look.to_screen(centers[index]);
            (f64::from(x - at_x).hypot(f64::from(y - at_y)), spheres[index][3] * look.scale())
        };
        let order = editor.lens.order(&centers);
        let on_rim = |index: &usize| {
            let (far, r) = far(*index);
            far - r <= RIM && far - r >= if r > SMALL { -RIM } else { -1.0 } && far > MIDDLE / 2.0
        };
        let rim = order.iter().rev().copied().find(on_rim).map(Handle::Rim);
        rim.or_else(|| {
            let inside = order.iter().rev().copied().filter(|index| {
                let (far, r) = far(*index);
                far <= r.max(MIDDLE)
            });
            inside.min_by(|a, b| far(*a).0.total_cmp(&far(*b).0)).map(Handle::Middle)
        })
    }

    fn seen(editor: &Bench) -> Vec<Item<3>> {
        items::items(editor)
    }

    fn forget(editor: &mut Bench) {
        editor.craft.pointed_out = None;
        let rows = editor.history.now().spheres.iter();
        let corners = rows.flat_map(|&[x, y, z, r]| [[x - r, y - r, z - r], [x + r, y + r, z + r]]);
        if let Some(bounds) = BoundingBox::around(corners) {
            editor.lens.look = editor.lens.look.framing(&bounds);
        }
    }

    async fn before_event(editor: &mut Bench, _: &mut Desk<'_>) -> Asked<()> {
        let passage = Rc::clone(&editor.craft.passage);
        if passage.leads_away() {
            passage.note_unsaved(editor.history.unsaved());
        } else if passage.take_unsaved() {
            editor.history.mark_unsaved();
        }
        Ok(())
    }

    /// The wheel over a sphere changes its radius.
    fn attended(editor: &mut Bench, _: &mut Desk<'_>, tick: &Tick) -> bool {
        let Some(Event::Wheel(steps)) = tick.event else { return false };
        let under = Self::handle_at(editor, (tick.mouse.x, tick.mouse.y));
        let Some(Handle::Middle(index) | Handle::Rim(index)) = under else { return false };
        let spheres = editor.history.now();
        if let Some(&[x, y, z, r]) = spheres.spheres.get(index) {
            let grown = rounded(r * STEP.powi(steps.clamp(-100, 100)));
            let changed = strings::with_sphere(spheres, index, [x, y, z, grown]);
            editor.history.change(changed);
        }
        true
    }

    fn leaves(&self) -> bool {
        self.passage.leads_away()
    }

    fn dragged(editor: &Bench, held: &Held<Handle, 3>, at: (i32, i32)) -> Option<Point<3>> {
        let Handle::Rim(index) = held.handle else { return editor.lens.dragged(held, at) };
        let center = Self::place(editor.history.now(), Handle::Middle(index))?;
        let (x, y) = editor.lens.look.to_screen(center);
        let far = |at: (i32, i32)| f64::from(x - at.0).hypot(f64::from(y - at.1));
        let by = (far(at) - far(held.pressed)) / editor.lens.look.scale();
        Some([rounded(held.from[0] + by), 0.0, 0.0])
    }

    async fn obey(editor: &mut Bench, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        obey::carry_out(editor, desk, action).await
    }

    fn changed(_: &mut Bench) {}

    async fn dropped(editor: &mut Bench, _: &mut Desk<'_>, _: Held<Handle, 3>, moved: Spheres) -> Asked<()> {
        editor.history.change(moved);
        Ok(())
    }

    async fn begin_result(editor: &mut Bench, desk: &mut Desk<'_>) -> Asked<bool> {
        obey::begin_result(editor, desk).await
    }

    fn draw(editor: &Bench, layer: Layer, page: &mut Page<'_>) {
        layers::draw(editor, layer, page);
    }
}

/// A radius within what can be dragged or typed, to four digits.
pub(super) fn rounded(r: f64) -> f64 {
    let r = r.clamp(RADII[0], RADII[1]);
    let grain = 10_f64.powi(3 - r.log10().floor() as i32);
    (r * grain).round() / grain
}

impl Bench {
    /// What follows from the spheres as they are drawn: with the held one at the mouse.
    pub(super) fn covered(&self) -> Option<Rc<Covered>> {
        self.craft.memory.of(&self.preview(), self.craft.options.clearing, Strings::covered)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_goes_to_space_and_back() {
        let circles = vec![[280.0, 190.0, 20.0], [330.0, 190.0, 30.0], [380.0, 200.0, 20.0]];
        let chain = Circles { circles, ..Circles::default() };
        assert_eq!(of_circles(&chain).spheres[0], [0.0, 0.0, 0.0, 20.0]);
        let ring = Circles { closed: true, ..chain.clone() };
        let tree = Circles { edges: Some(vec![[0, 1], [0, 2]]), ..chain.clone() };
        for given in [chain.clone(), ring, tree] {
            assert_eq!(as_circles(&of_circles(&given)), given);
        }
        // What hangs on nothing has no chain.
        let loose = Circles { edges: Some(vec![[0, 2]]), ..chain };
        assert_eq!(of_circles(&loose).chains, Some(vec![vec![0, 1]]));
    }

    #[test]
    fn radii_have_four_digits() {
        assert_eq!(rounded(0.123_456), 0.1235);
        assert_eq!(rounded(12.3456), 12.35);
        assert_eq!(rounded(f64::MAX), RADII[1]);
        assert_eq!(rounded(-5.0), RADII[0]);
    }
}
