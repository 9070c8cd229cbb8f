//! The editor of circles with a skin.

use super::commands::{Action, PLANE};
use super::dressed::{Dressed, Memory, Style};
use super::value::{self, Row};
use super::{discs, layers, model, obey, texts};
use crate::design::Place;
use crate::editor::lens::{Field, Held, Lens};
use crate::editor::passage::Passage;
use crate::editor::picture::{Layer, Page};
use crate::editor::seen::Item;
use crate::editor::{Craft, Editor};
use crate::file::{Circles, Document, Format};
use crate::geometry::Point;
use crate::geometry::skin::{Clearing, MAX_BALLS};
use crate::machine::{Asked, Event, Tick};
use crate::ui::words::Phrase;
use crate::ui::{Commands, Desk, Hint, Stay};
use crate::work::Next;
use serde::Serialize;
use std::rc::Rc;

/// What is shown, and how. It belongs to the view, not to the file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Options {
    pub(super) style: Style,
    pub(super) clearing: Clearing,
    pub(super) apollonius: bool,
    pub(super) radical: bool,
}

/// The craft.
pub(super) struct Skinner {
    pub(super) options: Options,
    /// The circle being changed or picked.
    pub(super) pointed_out: Option<usize>,
    pub(super) passage: Rc<Passage>,
    memory: Memory<Circles, Dressed>,
}

/// What the mouse can hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Handle {
    /// The middle of a circle.
    Middle(usize),
    /// The rim of a circle; its place has the radius for x.
    Rim(usize),
    /// A new circle, out of the store.
    Stored,
    /// A new circle, where the mouse was pressed.
    New,
}

/// The editor of this program.
pub(super) type Bench = Editor<Skinner, 2>;

/// Where new circles are taken from, and their radius.
pub(super) const STORE: Point<2> = [577.0, 360.0];
pub(super) const NEW_RADIUS: f64 = 26.0;
/// The radii that can be typed or dragged.
pub(super) const RADII: [f64; 2] = [1.0, 999.0];
/// The place of a held middle.
const REACH: [[f64; 2]; 2] = [[0.0, 579.0], [0.0, 440.0]];

impl Skinner {
    pub(super) fn new(passage: Rc<Passage>) -> Skinner {
        Skinner { options: Options::default(), pointed_out: None, passage, memory: Memory::default() }
    }
}

impl Craft<2> for Skinner {
    type Value = Circles;
    type Handle = Handle;
    type Lens = Field;
    type Action = Action;

    fn format(&self) -> Format {
        Format::Kor
    }

    fn formats(&self, _: &Circles) -> Vec<Format> {
        vec![Format::Kor, Format::Gom]
    }

    fn commands(&self) -> Commands<Action> {
        PLANE
    }

    fn lens(&self) -> Field {
        Field
    }

    fn fresh(&self, _: Option<&Circles>) -> Circles {
        Circles::default()
    }

    fn of_document(&self, document: &Document, _: &Circles) -> Result<(Circles, Option<Phrase>), Phrase> {
        let circles = match document {
            Document::Circles(circles) => circles,
            Document::Spheres(_) => {
                self.passage.lead(Some(document.clone()));
                return Ok((Circles::default(), None));
            }
            _ => return Err(texts::NO_DOCUMENT.into()),
        };
        if circles.circles.len() > MAX_BALLS {
            return Err(texts::full());
        }
        if !circles.circles.is_empty() {
            crate::design::skin::circles(circles).map_err(|error| Phrase::plain(&error))?;
        }
        let outside = circles.circles.iter().filter(|[x, y, _]| ![*x, *y].fits()).count();
        Ok((Circles::clone(circles), (outside > 0).then(|| texts::outside(outside))))
    }

    fn document(&self, circles: &Circles) -> Document {
        Document::Circles(Box::new(circles.clone()))
    }

    fn names_shape(&self, circles: &Circles) -> bool {
        circles.circles.len() > 1
    }

    fn has_shape(editor: &Bench) -> bool {
        editor.history.now().circles.len() > 1
    }

    fn hint(editor: &Bench) -> Option<Hint> {
        layers::hint(editor)
    }

    fn model(editor: &Bench) -> impl Serialize + 'static {
        model::of(editor)
    }

    fn place(circles: &Circles, handle: Handle) -> Option<Point<2>> {
        match handle {
            Handle::Middle(index) => circles.circles.get(index).map(|&[x, y, _]| [x, y]),
            Handle::Rim(index) => circles.circles.get(index).map(|&[_, _, r]| [r, 0.0]),
            Handle::Stored => Some(STORE),
            Handle::New => None,
        }
    }

    /// A circle whose middle is dropped outside the field is deleted.
    fn moved(circles: &Circles, handle: Handle, at: Point<2>) -> Circles {
        let [x, y] = at;
        let new = || if at.fits() { value::appended(circles, [x, y, NEW_RADIUS]) } else { circles.clone() };
        match handle {
            Handle::Middle(index) => match circles.circles.get(index) {
                // One that a file put outside may stay.
                Some(&[a, b, r]) if at.fits() || [a, b] == at => {
                    value::with_circle(circles, index, [x, y, r])
                }
                _ => value::deleted(circles, index),
            },
            Handle::Rim(index) => match circles.circles.get(index) {
                Some(&[a, b, _]) => value::with_circle(circles, index, [a, b, x]),
                None => circles.clone(),
            },
            Handle::Stored | Handle::New => new(),
        }
    }

    fn handle_at(editor: &Bench, at: (i32, i32)) -> Option<Handle> {
        discs::at(editor, at)
    }

    fn seen(editor: &Bench) -> Vec<Item<2>> {
        layers::items(editor)
    }

    fn forget(editor: &mut Bench) {
        editor.craft.pointed_out = None;
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

    fn leaves(&self) -> bool {
        self.passage.leads_away()
    }

    /// The wheel over a circle changes its radius.
    fn attended(editor: &mut Bench, _: &mut Desk<'_>, tick: &Tick) -> bool {
        let Some(Event::Wheel(steps)) = tick.event else { return false };
        let under = discs::at(editor, (tick.mouse.x, tick.mouse.y));
        let Some(Handle::Middle(index) | Handle::Rim(index)) = under else { return false };
        let circles = editor.history.now();
        if let Some(&[x, y, r]) = circles.circles.get(index) {
            let row = [x, y, radius(r + f64::from(steps))];
            let changed = value::with_circle(circles, index, row);
            editor.history.change(changed);
        }
        true
    }

    fn dragged(editor: &Bench, held: &Held<Handle, 2>, at: (i32, i32)) -> Option<Point<2>> {
        let by = [at.0 - held.pressed.0, held.pressed.1 - at.1];
        if held.at == held.from && by[0].pow(2) + by[1].pow(2) <= 2 {
            return None;
        }
        let clamped = |[x, y]: Point<2>| -> Point<2> {
            [x.clamp(REACH[0][0], REACH[0][1]), y.clamp(REACH[1][0], REACH[1][1])]
        };
        match held.handle {
            Handle::Rim(index) => {
                let center = Self::place(editor.history.now(), Handle::Middle(index))?;
                let far = |[x, y]: Point<2>| (x - center[0]).hypot(y - center[1]);
                let [now, then] = [at, held.pressed].map(|at| far(Field.place(at)));
                Some([radius((held.from[0] + now - then).round()), 0.0])
            }
            _ => Some(clamped(std::array::from_fn(|d| held.from[d] + f64::from(by[d])))),
        }
    }

    fn taken_up(editor: &Bench, at: (i32, i32)) -> Option<Held<Handle, 2>> {
        let place = Field.place(at);
        let free = place.fits() && !value::is_full(editor.history.now());
        free.then_some(Held { handle: Handle::New, pressed: at, from: place, at: place })
    }

    async fn obey(editor: &mut Bench, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        obey::carry_out(editor, desk, action).await
    }

    fn changed(_: &mut Bench) {}

    async fn dropped(
        editor: &mut Bench,
        desk: &mut Desk<'_>,
        held: Held<Handle, 2>,
        moved: Circles,
    ) -> Asked<()> {
        if moved.circles.len() < editor.history.now().circles.len()
            && let Handle::Middle(index) = held.handle
        {
            desk.tell(texts::deleted(index + 1), Stay::Briefly);
        }
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

/// A radius within what can be dragged or typed; larger ones of files shrink only.
pub(super) fn radius(r: f64) -> f64 {
    r.clamp(RADII[0], RADII[1])
}

impl Bench {
    /// What follows from the circles as they are drawn: with the held one at the mouse.
    pub(super) fn dressed(&self) -> Option<Rc<Dressed>> {
        self.craft.memory.of(&self.preview(), self.craft.options.clearing, Dressed::new)
    }

    /// A held circle that is not among the circles: new ones that are not dropped yet, and those outside the field.
    pub(super) fn loose(&self) -> Option<Row> {
        let held = self.held?;
        let [x, y] = held.at;
        match held.handle {
            Handle::Middle(index) if !held.at.fits() => {
                let [_, _, r] = *self.history.now().circles.get(index)?;
                (held.at != held.from).then_some([x, y, r])
            }
            Handle::Stored if !held.at.fits() && held.at != held.from => Some([x, y, NEW_RADIUS]),
            _ => None,
        }
    }

    /// The pixel of a place.
    pub(super) fn pixel(&self, place: Point<2>) -> (i32, i32) {
        self.lens.pixel(place)
    }
}
