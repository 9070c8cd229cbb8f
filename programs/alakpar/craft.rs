//! The editor of curves with shape parameters, in the plane and in space.

use super::commands::Action;
use super::dial;
use super::form::Form;
use super::kinds::{self, Knob};
use super::room::{Here, Room};
use super::{aim, files, layers, model, obey, points, texts};
use crate::design::Place;
use crate::editor::lens::{Held, Lens};
use crate::editor::passage::Passage;
use crate::editor::picture::{Layer, Page};
use crate::editor::seen::Item;
use crate::editor::{Craft, Editor};
use crate::file::{Document, Format, Places};
use crate::geometry::Point;
use crate::geometry::shaped::{Parameter, ShapedCurve};
use crate::machine::{Asked, Tick};
use crate::ui::words::Phrase;
use crate::ui::{Commands, Desk, Hint};
use crate::work::Next;
use serde::Serialize;
use std::rc::Rc;
use std::time::Duration;

/// What is shown besides the curve. It belongs to the view, not to the file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Options {
    pub(super) paths: bool,
    pub(super) series: bool,
    pub(super) cubic: bool,
    pub(super) basis: bool,
    /// The scale of the comb of curvature, in square pixels, if it is shown.
    pub(super) comb: Option<f64>,
    /// The scale that it had last.
    pub(super) last_comb: Option<f64>,
}

/// The craft.
pub(super) struct Shaper<const D: usize> {
    pub(super) options: Options,
    /// The parameter that slider, paths, series and the search work on: the first or the second.
    pub(super) active: usize,
    /// The point whose own lambda that is.
    pub(super) joint: Option<usize>,
    /// The point being changed.
    pub(super) pointed_out: Option<usize>,
    /// The last target, and what came of it.
    pub(super) aim: Option<aim::Aim<D>>,
    /// The parameter on its way to a target.
    pub(super) glide: Option<aim::Glide<D>>,
    pub(super) now: Duration,
    /// Where the mouse is.
    pub(super) mouse: (i32, i32),
    /// Whether fewer harmonics are to be offered.
    pub(super) offer: bool,
    pub(super) passage: Rc<Passage>,
}

/// What the mouse can hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Handle {
    /// A point; the index after the last is the store's.
    Point(usize),
    /// A new point, which will have this index.
    New(usize),
    /// The slider of a parameter.
    Slider(Parameter),
}

/// The editor of this program.
pub(super) type Bench<const D: usize> = Editor<Shaper<D>, D>;

impl<const D: usize> Shaper<D> {
    pub(super) fn new(passage: Rc<Passage>) -> Shaper<D> {
        Shaper {
            options: Options::default(),
            active: 0,
            joint: None,
            pointed_out: None,
            aim: None,
            glide: None,
            now: Duration::ZERO,
            mouse: (0, 0),
            offer: false,
            passage,
        }
    }
}

impl<const D: usize> Craft<D> for Shaper<D>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    type Value = Form<D>;
    type Handle = Handle;
    type Lens = <Here as Room<D>>::Lens;
    type Action = Action;

    fn format(&self) -> Format {
        Format::Alp
    }

    fn formats(&self, _: &Form<D>) -> Vec<Format> {
        vec![Format::Alp, Format::Ip2, Format::Ip3, Format::Gbp]
    }

    fn commands(&self) -> Commands<Action> {
        <Here as Room<D>>::commands()
    }

    fn lens(&self) -> Self::Lens {
        <Here as Room<D>>::lens()
    }

    /// Without points; the family and its parameters are kept.
    fn fresh(&self, before: Option<&Form<D>>) -> Form<D> {
        before.map_or_else(Form::empty, |before| before.shortened(0).through(false))
    }

    fn of_document(&self, document: &Document, _: &Form<D>) -> Result<(Form<D>, Option<Phrase>), Phrase> {
        files::read(self, document)
    }

    fn document(&self, form: &Form<D>) -> Document {
        form.document().into()
    }

    fn names_shape(&self, form: &Form<D>) -> bool {
        form.curve().is_ok()
    }

    fn has_shape(editor: &Bench<D>) -> bool {
        editor.history.now().curve().is_ok()
    }

    fn hint(editor: &Bench<D>) -> Option<Hint> {
        Some(layers::hint(editor))
    }

    fn model(editor: &Bench<D>) -> impl Serialize + 'static {
        model::of(editor)
    }

    fn place(form: &Form<D>, handle: Handle) -> Option<Point<D>> {
        match handle {
            Handle::Point(index) => form.points.get(index).copied().or(<Here as Room<D>>::STORE),
            Handle::New(_) => None,
            Handle::Slider(parameter) => form.value(parameter).map(dial::as_place),
        }
    }

    fn moved(form: &Form<D>, handle: Handle, at: Point<D>) -> Form<D> {
        match handle {
            Handle::Slider(parameter) => {
                form.with(parameter, dial::of_place(at)).unwrap_or_else(|_| form.clone())
            }
            Handle::Point(index) => points::dropped(form, index, false, at),
            Handle::New(index) => points::dropped(form, index, true, at),
        }
    }

    fn handle_at(editor: &Bench<D>, at: (i32, i32)) -> Option<Handle> {
        let slider = dial::on_slider(at).then(|| editor.knob()).flatten();
        let turned = slider.filter(|knob| editor.history.now().value(knob.parameter).is_some());
        turned.map(|knob| Handle::Slider(knob.parameter)).or_else(|| points::at(editor, at))
    }

    fn seen(editor: &Bench<D>) -> Vec<Item<D>> {
        layers::items(editor)
    }

    fn forget(editor: &mut Bench<D>) {
        let form = editor.history.now();
        let far = files::flies_out(form);
        let craft = &mut editor.craft;
        (craft.active, craft.joint, craft.pointed_out) = (0, None, None);
        (craft.aim, craft.glide, craft.offer) = (None, None, far);
    }

    async fn before_event(editor: &mut Bench<D>, desk: &mut Desk<'_>) -> Asked<()> {
        let passage = Rc::clone(&editor.craft.passage);
        if passage.leads_away() {
            passage.note_unsaved(editor.history.unsaved());
        } else if passage.take_unsaved() {
            editor.history.mark_unsaved();
        }
        if std::mem::take(&mut editor.craft.offer) {
            crate::work::keep(editor, desk);
            files::offer_fewer(editor, desk).await?;
        }
        Ok(())
    }

    fn attended(editor: &mut Bench<D>, desk: &mut Desk<'_>, tick: &Tick) -> bool {
        dial::attended(editor, desk, tick)
    }

    fn advance(&mut self, now: Duration) {
        self.now = now;
        if self.glide.as_ref().is_some_and(|glide| glide.is_over(now)) {
            self.glide = None;
        }
    }

    fn due(&self) -> Option<Duration> {
        self.glide.as_ref().map(|_| aim::FRAME)
    }

    fn leaves(&self) -> bool {
        self.passage.leads_away()
    }

    fn dragged(editor: &Bench<D>, held: &Held<Handle, D>, at: (i32, i32)) -> Option<Point<D>> {
        match held.handle {
            Handle::Slider(_) => editor.knob().map(|knob| dial::as_place(dial::slider(&knob).value_at(at.0))),
            _ => editor.lens.dragged(held, at),
        }
    }

    fn taken_up(editor: &Bench<D>, at: (i32, i32)) -> Option<Held<Handle, D>> {
        points::new_at(editor, at)
    }

    fn clicked(_: &Bench<D>, at: (i32, i32)) -> Option<Action> {
        dial::window_at(at).map(Action::Number)
    }

    async fn obey(editor: &mut Bench<D>, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        editor.craft.glide = None;
        obey::carry_out(editor, desk, action).await
    }

    fn changed(editor: &mut Bench<D>) {
        editor.craft.glide = None;
    }

    async fn dropped(
        editor: &mut Bench<D>,
        desk: &mut Desk<'_>,
        held: Held<Handle, D>,
        moved: Form<D>,
    ) -> Asked<()> {
        let moved = match (held.handle, editor.knob()) {
            // A click beside the knob takes it there.
            (Handle::Slider(parameter), Some(knob)) if held.at == held.from => {
                let value = dial::slider(&knob).value_at(held.pressed.0);
                editor.history.now().with(parameter, value).unwrap_or(moved)
            }
            _ => moved,
        };
        if points::full(editor.history.now())
            && held.handle == Handle::Point(editor.history.now().points.len())
        {
            desk.tell(crate::ui::words::FULL, crate::ui::Stay::Briefly);
        }
        editor.change(moved);
        Ok(())
    }

    fn problem(editor: &Bench<D>) -> Option<Phrase> {
        texts::problem(editor.history.now())
    }

    async fn begin_result(editor: &mut Bench<D>, desk: &mut Desk<'_>) -> Asked<bool> {
        obey::begin_result(editor, desk).await
    }

    fn draw(editor: &Bench<D>, layer: Layer, page: &mut Page<'_>) {
        layers::draw(editor, layer, page);
    }
}

impl<const D: usize> Bench<D>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    /// Makes a form the present one. A point that is no more has no lambda of its own to turn.
    pub(super) fn change(&mut self, form: Form<D>) {
        self.craft.glide = None;
        self.history.change(form);
        self.craft.joint = self.craft.joint.filter(|joint| *joint < self.history.now().points.len());
    }

    /// What is drawn: on the way to a target, with the held handle at the mouse, or the present form.
    pub(super) fn drawn(&self) -> Form<D> {
        match &self.craft.glide {
            Some(glide) => glide.at(self.craft.now).unwrap_or_else(|| self.preview()),
            None => self.preview(),
        }
    }

    /// The curve that is drawn, if there is one.
    pub(super) fn curve(&self) -> Option<ShapedCurve<D>> {
        self.drawn().curve().ok()
    }

    /// The parameters of the present family.
    pub(super) fn knobs(&self) -> Vec<Knob> {
        kinds::knobs(self.history.now(), self.craft.joint)
    }

    /// The parameter that is turned.
    pub(super) fn knob(&self) -> Option<Knob> {
        let knobs = self.knobs();
        knobs.get(self.craft.active).or(knobs.first()).copied()
    }
}
