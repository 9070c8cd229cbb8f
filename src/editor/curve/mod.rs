//! The editors of curves, in the plane and in space: control points, dragged, numbered, inserted and deleted, and
//! the curves through them or near them (chapters 2.3.1 to 2.3.8).
//!
//! Five programs are this editor with [`Tools`] of their own. In the plane new points are dragged out of a store.

mod aids;
mod ambient;
mod arcs;
pub(crate) mod ask;
pub(super) mod beta;
mod commands;
mod compare;
mod degree;
mod dump;
mod joints;
pub mod layer;
pub(crate) mod points;
mod readout;
mod series;
mod tables;
mod tangents;
mod workshop;

pub use tables::{BETA_KEYS, METHOD_KEYS, SPACE_BETA_KEYS, SPACE_METHOD_KEYS, TANGENT_KEYS};

use super::field::{on_disc, within};
use super::lens::{Held, Lens};
use super::picture::{Layer as Part, Page};
use super::refusal;
use super::seen::{Item, TIP_RADIUS};
use super::stage::Stage;
use super::{Craft, Dial, Editor};
use crate::design::{Edit, Place, Sketch};
use crate::file::{Document, Format, Method};
use crate::geometry::Point;
use crate::machine::{Asked, Manner, Tick};
use crate::screen::Color;
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Commands, Desk, Hint, Manual, Question, Start, Stay};
use crate::work::Next;
use ambient::Ambient;
use compare::Kind;
use dump::Model;
use layer::Layer;
use serde::Serialize;
use tables::Action;

/// The kinds of curve that a program offers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tools {
    /// Coons-Hermite, Bézier, spline, quadratic and cubic B-spline.
    Methods,
    /// Coons-Hermite curves with tangents set by the user.
    Tangents,
    /// The beta-spline with bias and tension.
    Beta,
    /// What a program's own layer has.
    Own,
}

impl Tools {
    /// The method of a program that has only one.
    fn implied(self) -> Option<Method> {
        match self {
            Tools::Methods | Tools::Own => None,
            Tools::Tangents => Some(Method::Hermite),
            Tools::Beta => Some(Method::Beta),
        }
    }
}

/// Prepares the editor of plane curves, with or without a document to open.
///
/// # Errors
/// The reason why it cannot open the document.
pub fn plane(manual: Manual, tools: Tools, document: Option<Document>) -> Result<Start, Phrase> {
    super::start(Curves::<2>::new(tools), manual, document)
}

/// Prepares the editor of curves in space, with or without a document to open.
///
/// # Errors
/// The reason why it cannot open the document.
pub fn space(manual: Manual, tools: Tools, document: Option<Document>) -> Result<Start, Phrase> {
    super::start(Curves::<3>::new(tools), manual, document)
}

/// Prepares the editor of plane curves with a program's own layer.
///
/// # Errors
/// The reason why it cannot open the document.
pub fn plane_with(
    manual: Manual,
    layer: Box<dyn Layer<2>>,
    document: Option<Document>,
) -> Result<Start, Phrase> {
    super::start(Curves { layer: Some(layer), ..Curves::<2>::new(Tools::Own) }, manual, document)
}

/// Prepares the editor of curves in space with a program's own layer.
///
/// # Errors
/// The reason why it cannot open the document.
pub fn space_with(
    manual: Manual,
    layer: Box<dyn Layer<3>>,
    document: Option<Document>,
) -> Result<Start, Phrase> {
    super::start(Curves { layer: Some(layer), ..Curves::<3>::new(Tools::Own) }, manual, document)
}

/// The [`Craft`] of curves.
struct Curves<const D: usize> {
    tools: Tools,
    /// What the program adds.
    layer: Option<Box<dyn Layer<D>>>,
    /// The method of documents that name none, in the manner of today.
    usual: Option<Method>,
    /// Curves that are shown besides the chosen one.
    compared: Vec<Kind>,
    /// Values of a parameter whose curves are shown besides.
    series: Option<series::Series>,
    /// Whether the points are shown as measured ones: open, without the chosen curve.
    measured: bool,
    /// What shows how the curve comes from its points.
    aids: aids::Aids,
    /// The point being changed.
    pointed_out: Option<usize>,
    /// The remark about the last choice, shown until the next question.
    note: Option<String>,
    /// The stage in which automatic tangents are offered. As in the original, that is at the start and after every
    /// action with an empty store.
    offer: Option<Stage>,
}

impl<const D: usize> Curves<D> {
    fn new(tools: Tools) -> Curves<D> {
        Curves {
            tools,
            layer: None,
            usual: None,
            compared: Vec::new(),
            series: None,
            measured: false,
            aids: aids::Aids::default(),
            pointed_out: None,
            note: None,
            offer: None,
        }
    }
}

/// What the mouse can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Handle {
    /// A control point; the index after the last is the store's.
    Point(usize),
    /// The tip of the tangent at a point.
    Tip(usize),
    /// A new point, which will have this index.
    New(usize),
    /// What is the program's own.
    Own,
}

/// Segments per span, as many as in the original.
fn steps(method: Method) -> usize {
    match method {
        Method::Bezier => 100,
        Method::Beta => 500,
        Method::Hermite => 20,
        _ => 50,
    }
}

impl<const D: usize> Craft<D> for Curves<D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    type Value = Sketch<D>;
    type Handle = Handle;
    type Lens = <Curves<D> as Ambient<D>>::Lens;
    type Action = Action;

    fn format(&self) -> Format {
        <Self as Ambient<D>>::format(self.tools)
    }

    fn formats(&self, sketch: &Sketch<D>) -> Vec<Format> {
        match &self.layer {
            Some(layer) => layer.formats(sketch),
            None => vec![self.format()],
        }
    }

    fn commands(&self) -> Commands<Action> {
        match &self.layer {
            Some(layer) => layer.commands(),
            None => <Self as Ambient<D>>::commands(self.tools),
        }
    }

    fn lens(&self) -> Self::Lens {
        <Self as Ambient<D>>::lens()
    }

    /// Without points; the parameters are kept, as in the original.
    fn fresh(&self, before: Option<&Sketch<D>>) -> Sketch<D> {
        let tangents = (self.tools == Tools::Tangents).then(Vec::new);
        let mut sketch = Sketch { tangents, ..Sketch::default() };
        if let Some(before) = before {
            let settings = &before.settings;
            sketch.settings.k0 = settings.k0;
            (sketch.settings.bias, sketch.settings.tension) = (settings.bias, settings.tension);
        }
        sketch
    }

    fn of_document(
        &self,
        document: &Document,
        before: &Sketch<D>,
    ) -> Result<(Sketch<D>, Option<Phrase>), Phrase> {
        let sketch = <Self as Ambient<D>>::sketch(document)?;
        let mut sketch = sketch.fitting().map_err(|error| refusal::of_curve(&error))?;
        sketch.settings.bias = sketch.settings.bias.or(before.settings.bias);
        sketch.settings.tension = sketch.settings.tension.or(before.settings.tension);
        if let Some(layer) = &self.layer {
            let completed = layer.completed(sketch.clone());
            let remark = (completed != sketch).then(|| words::NO_TANGENTS.into());
            return Ok((completed, remark));
        }
        if self.tools != Tools::Tangents || sketch.tangents.is_some() {
            return Ok((sketch, None));
        }
        let none = Sketch { tangents: Some(vec![[0.0; D]; sketch.points.len()]), ..sketch.clone() };
        let sketch = sketch.with_automatic_tangents(sketch.closure()).unwrap_or(none);
        Ok((sketch, Some(words::NO_TANGENTS.into())))
    }

    fn document(&self, sketch: &Sketch<D>) -> Document {
        <Self as Ambient<D>>::document(sketch.clone())
    }

    fn implied(&self) -> Option<Method> {
        self.tools.implied().or(self.usual)
    }

    /// Handles of smooth joints lie between whole numbers, also once another method is chosen; the files of the plane
    /// hold whole numbers only.
    fn fits_format(&self, sketch: &Sketch<D>) -> bool {
        let whole = || sketch.points.iter().flatten().all(|value| value.fract() == 0.0);
        self.format() == Format::Ip3 || whole()
    }

    fn behave(&mut self, manner: Manner) {
        self.usual = (manner == Manner::Today).then_some(Method::Spline);
    }

    fn has_shape(editor: &Editor<Self, D>) -> bool {
        editor.count() >= editor.fewest() && editor.drawn().curve().is_ok()
    }

    fn hint(editor: &Editor<Self, D>) -> Option<Hint> {
        editor.hint()
    }

    fn names_shape(&self, sketch: &Sketch<D>) -> bool {
        let named = sketch.settings.method.is_some() || sketch.settings.closed.is_some();
        named && self.curve(sketch).is_some()
    }

    fn model(editor: &Editor<Self, D>) -> impl Serialize + 'static {
        Model::of(editor)
    }

    fn place(sketch: &Sketch<D>, handle: Handle) -> Option<Point<D>> {
        match handle {
            Handle::Point(index) => sketch.points.get(index).copied().or(Self::STORE),
            Handle::Tip(index) => sketch.tip(index),
            Handle::New(_) => None,
            Handle::Own => Some([0.0; D]),
        }
    }

    /// A point dropped outside the field is deleted.
    fn moved(sketch: &Sketch<D>, handle: Handle, at: Point<D>) -> Sketch<D> {
        let count = sketch.points.len();
        match (handle, at.fits()) {
            (Handle::Point(index), true) if index < count => sketch.dragged(index, at),
            (Handle::Point(index), false) if index < count && Self::STORE.is_some() => sketch.removed(index),
            (Handle::Point(index), false) if index < count => sketch.dragged(index, at),
            (Handle::Point(index), true) => sketch.edited(Edit::Insert(index, at)),
            (Handle::New(index), true) => sketch.with_new(index, at),
            (Handle::Point(_) | Handle::New(_), false) => sketch.clone(),
            (Handle::Tip(index), _) => sketch.with_tip(index, at),
            (Handle::Own, _) => sketch.clone(),
        }
    }

    /// Points come before tips; the point in the store comes after the last one.
    fn handle_at(editor: &Editor<Self, D>, at: (i32, i32)) -> Option<Handle> {
        if editor.weights_cover(at) {
            return None;
        }
        let (sketch, lens) = (editor.history.now(), &editor.lens);
        if Self::STORE.is_some_and(|store| on_disc(lens.pixel(store), at)) && !sketch.full() {
            return Some(Handle::Point(sketch.points.len()));
        }
        let under = |&index: &usize| sketch.points.get(index).is_some_and(|&it| on_disc(lens.pixel(it), at));
        let order = lens.order(&sketch.points);
        let on_tip =
            |&index: &usize| editor.tip(index).is_some_and(|tip| within(TIP_RADIUS, lens.pixel(tip), at));
        let point = order.iter().rev().copied().find(under);
        let tip = || order.iter().rev().copied().find(on_tip).map(Handle::Tip);
        point.map(Handle::Point).or_else(tip).or_else(|| editor.layer_grips(at).then_some(Handle::Own))
    }

    fn seen(editor: &Editor<Self, D>) -> Vec<Item<D>> {
        let mut items = editor.layer_traces();
        editor.add_aids(&mut items);
        items.extend(editor.curves_seen());
        items.extend(editor.handles_seen());
        editor.add_points(&mut items);
        items
    }

    fn forget(editor: &mut Editor<Self, D>) {
        let ready = editor.count() >= editor.fewest();
        let craft = &mut editor.craft;
        (craft.pointed_out, craft.note) = (None, None);
        craft.offer = (craft.tools == Tools::Tangents && ready).then_some(Stage::Working);
    }

    async fn before_event(editor: &mut Editor<Self, D>, desk: &mut Desk<'_>) -> Asked<()> {
        if let Some(stage) = editor.craft.offer.take() {
            crate::work::keep(editor, desk);
            editor.stage = stage;
            editor.offer_automatic_tangents(desk).await?;
        }
        Ok(())
    }

    fn taken_up(editor: &Editor<Self, D>, at: (i32, i32)) -> Option<Held<Handle, D>> {
        editor.new_point(at)
    }

    fn dials(editor: &Editor<Self, D>) -> Vec<Dial> {
        editor.value_dials()
    }

    fn dialled(editor: &Editor<Self, D>, dial: usize, to: f64) -> Sketch<D> {
        editor.with_dial(dial, to)
    }

    /// The points, each followed by the tip of its tangent.
    fn handles(editor: &Editor<Self, D>) -> Vec<Handle> {
        let of_point = |index| {
            let tip = editor.tip(index).map(|_| Handle::Tip(index));
            std::iter::once(Handle::Point(index)).chain(tip)
        };
        (0..editor.count()).flat_map(of_point).collect()
    }

    fn value_at(editor: &Editor<Self, D>, at: (i32, i32)) -> Option<Action> {
        editor.value_shown_at(at)
    }

    fn looked(editor: &mut Editor<Self, D>, _: &mut Desk<'_>, tick: &Tick) -> bool {
        editor.layer_watches(tick)
    }

    async fn obey(editor: &mut Editor<Self, D>, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        editor.carry_out(desk, action).await
    }

    async fn dropped(
        editor: &mut Editor<Self, D>,
        desk: &mut Desk<'_>,
        held: Held<Handle, D>,
        moved: Sketch<D>,
    ) -> Asked<()> {
        if held.handle == Handle::Own {
            let scene = editor.scene();
            if let Some(layer) = editor.craft.layer.as_mut().filter(|_| held.at != held.from) {
                layer.let_go(&scene, held.at);
            }
            return Ok(());
        }
        if editor.history.now().full() && held.handle == Handle::Point(editor.count()) {
            desk.tell(words::FULL, Stay::Briefly);
        }
        editor.history.change(editor.completed(moved));
        editor.shown.after_change();
        editor.forget_note();
        editor.craft.offer = Some(Stage::Offering);
        Ok(())
    }

    fn problem(editor: &Editor<Self, D>) -> Option<Phrase> {
        let sketch = editor.drawn();
        let checked = match editor.shown.known {
            true => sketch.curve().map(|_| ()),
            false => sketch.check_parameters().map_err(Into::into),
        };
        checked.err().map(|error| refusal::of_curve(&error))
    }

    fn reshaped(editor: &mut Editor<Self, D>, _: &mut Desk<'_>) {
        editor.shown.after_change();
    }

    async fn begin_result(editor: &mut Editor<Self, D>, desk: &mut Desk<'_>) -> Asked<bool> {
        if !editor.shown.known || editor.method().is_none() {
            desk.tell(words::NO_CURVE, Stay::Briefly);
            return Ok(false);
        }
        if editor.count() < editor.fewest() {
            let missing = if Self::STORE.is_some() { words::NO_CURVE } else { words::TOO_FEW };
            desk.tell(missing, Stay::Briefly);
            return Ok(false);
        }
        if let Err(error) = editor.drawn().curve() {
            desk.tell(refusal::of_curve(&error), Stay::UntilRead);
            return Ok(false);
        }
        let answer = desk.ask(editor, &Question::yes_no(words::ASK_POINTS)).await?;
        editor.stage = Stage::Result { points: answer == Answer::First };
        Ok(true)
    }

    /// As in the original, the curve then disappears from the picture.
    async fn end_result(editor: &mut Editor<Self, D>, _: &mut Desk<'_>) -> Asked<()> {
        editor.shown.after_change();
        editor.forget_note();
        Ok(())
    }

    fn draw(editor: &Editor<Self, D>, layer: Part, page: &mut Page<'_>) {
        match layer {
            Part::Over if editor.craft.layer.is_some() => {
                editor.paint_layer(layer, page);
                editor.draw_multiples(page);
                editor.draw_weights(page);
            }
            Part::Over => {
                editor.draw_joint_shapes(page);
                editor.draw_multiples(page);
                editor.draw_weights(page);
            }
            Part::Titles => editor.draw_titles(page),
            Part::Legend if editor.craft.layer.is_some() => editor.paint_layer(layer, page),
            Part::Legend => editor.draw_names(page, (400, 5), Color::LightGray),
            _ => {
                if layer == Part::Frame {
                    editor.draw_readout(page);
                }
                <Self as Ambient<D>>::draw(editor, layer, page);
                editor.paint_layer(layer, page);
            }
        }
    }
}

impl<const D: usize> Curves<D>
where
    Point<D>: Place<D>,
{
    /// The method that a sketch is drawn by.
    fn method_of(&self, sketch: &Sketch<D>) -> Option<Method> {
        match &self.layer {
            Some(layer) => layer.method(sketch, self.usual.is_some()),
            None => sketch.method().or(self.tools.implied()).or(self.usual),
        }
    }

    /// The sketch as the program draws it, if there is a curve.
    fn curve(&self, sketch: &Sketch<D>) -> Option<Sketch<D>> {
        let method = self.method_of(sketch)?;
        Some(sketch.by(method)).filter(|sketch| sketch.curve().is_ok())
    }
}
