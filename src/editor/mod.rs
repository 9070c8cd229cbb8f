//! The editor of control points that the programs share: points are dragged or changed by number, and the curve or
//! surface follows them.
//!
//! `Editor` holds everything common to plane curves, space curves and surfaces: the work loop, dragging, stages,
//! picture and figure. A `Craft` adds what one kind has of its own. Fourier curves are a table of coefficients and
//! have their own editor.
//!
//! Crafts live here where several programs share one, else with their program.

pub(crate) mod comb;
pub mod curve;
pub(crate) mod field;
pub mod fourier;
mod hand;
pub mod keys;
pub(crate) mod lens;
pub mod net;
pub(crate) mod passage;
pub(crate) mod picture;
pub(crate) mod place;
pub(crate) mod refusal;
pub(crate) mod seen;
pub(crate) mod stage;
pub(crate) mod values;

use crate::file::{Document, Format, Method};
use crate::geometry::{ParamSurface, Point};
use crate::machine::{Asked, Asking, Button, Event, Key, Manner, Tick};
use crate::ui::words::Phrase;
use crate::ui::{Commands, Desk, DoubleClick, Hint, Manual, Start, Stay};
use crate::work::{self, History, Next, Work, common_key, event};
use field::PICTURE;
pub(crate) use hand::Dial;
use hand::Turning;
use lens::{Held, Lens};
use seen::Item;
use serde::Serialize;
use stage::{Shown, Stage};
use std::time::Duration;

/// What one kind of editor adds to the common part.
pub(crate) trait Craft<const D: usize>: Sized + 'static {
    /// What is edited, undone and saved: control points and recipe.
    type Value: Clone + PartialEq + 'static;
    /// What the mouse can hold.
    type Handle: Copy + PartialEq + 'static;
    /// The mapping between places and pixels.
    type Lens: Lens<D> + 'static;
    /// What a command does.
    type Action: Copy + 'static;

    /// The format of its files.
    fn format(&self) -> Format;
    /// The formats that its files may have; the first is that of this value.
    fn formats(&self, _: &Self::Value) -> Vec<Format> {
        vec![self.format()]
    }
    /// The commands.
    fn commands(&self) -> Commands<Self::Action>;
    /// The lens of a new configuration.
    fn lens(&self) -> Self::Lens;
    /// A new configuration; it keeps from the previous one what the original kept.
    fn fresh(&self, before: Option<&Self::Value>) -> Self::Value;
    /// The value of a document that is opened after another configuration, and a remark about it.
    fn of_document(
        &self,
        document: &Document,
        before: &Self::Value,
    ) -> Result<(Self::Value, Option<Phrase>), Phrase>;
    /// The value as a document, with its whole recipe.
    fn document(&self, value: &Self::Value) -> Document;
    /// The program's method, for a value that names none.
    fn implied(&self) -> Option<Method> {
        None
    }
    /// Whether a file of the format can hold the value, apart from its recipe.
    fn fits_format(&self, _: &Self::Value) -> bool {
        true
    }
    /// Whether the value names a curve or surface that is shown at once.
    fn names_shape(&self, value: &Self::Value) -> bool;
    /// Takes up how the program behaves; in the manner of today there is always a usual curve or surface.
    fn behave(&mut self, _: Manner) {}
    /// Whether the value has a curve or surface.
    fn has_shape(editor: &Editor<Self, D>) -> bool;
    /// The surfaces as a model for other programs.
    fn surfaces(_: &Editor<Self, D>) -> Vec<Box<dyn ParamSurface>> {
        Vec::new()
    }
    /// What can be done now.
    fn hint(editor: &Editor<Self, D>) -> Option<Hint>;
    /// The model as `dump` writes it.
    fn model(editor: &Editor<Self, D>) -> impl Serialize + 'static;

    /// The place of a handle.
    fn place(value: &Self::Value, handle: Self::Handle) -> Option<Point<D>>;
    /// The value with a handle dropped at a place.
    fn moved(value: &Self::Value, handle: Self::Handle, at: Point<D>) -> Self::Value;
    /// The topmost handle at a pixel.
    fn handle_at(editor: &Editor<Self, D>, at: (i32, i32)) -> Option<Self::Handle>;
    /// The visible items, topmost last.
    fn seen(editor: &Editor<Self, D>) -> Vec<Item<D>>;

    /// Forgets what belongs to the previous configuration.
    fn forget(editor: &mut Editor<Self, D>);
    /// Called before the editor waits for the user.
    async fn before_event(_: &mut Editor<Self, D>, _: &mut Desk<'_>) -> Asked<()> {
        Ok(())
    }
    /// Takes up an event before the lens does; returns whether it did.
    fn attended(_: &mut Editor<Self, D>, _: &mut Desk<'_>, _: &Tick) -> bool {
        false
    }
    /// Advances what moves by itself to the present time.
    fn advance(&mut self, _: Duration) {}
    /// How long after that time the next picture is due; `None` if nothing moves.
    fn due(&self) -> Option<Duration> {
        None
    }
    /// Whether the editor is to be left for another page of its program.
    fn leaves(&self) -> bool {
        false
    }
    /// The place of a held handle when the mouse is at a pixel; `None` for a mere click.
    fn dragged(editor: &Editor<Self, D>, held: &Held<Self::Handle, D>, at: (i32, i32)) -> Option<Point<D>> {
        editor.lens.dragged(held, at)
    }
    /// Handles an event that only changes the view; returns whether it did.
    fn looked(_: &mut Editor<Self, D>, _: &mut Desk<'_>, _: &Tick) -> bool {
        false
    }
    /// Something new that the mouse takes up where there was nothing, in the manner of today.
    fn taken_up(_: &Editor<Self, D>, _: (i32, i32)) -> Option<Held<Self::Handle, D>> {
        None
    }
    /// What a click means that is on no button and no handle.
    fn clicked(_: &Editor<Self, D>, _: (i32, i32)) -> Option<Self::Action> {
        None
    }
    /// What a double click means on a value that is shown, in the manner of today.
    fn value_at(_: &Editor<Self, D>, _: (i32, i32)) -> Option<Self::Action> {
        None
    }
    /// The potentiometers of its parameters, in the manner of today.
    fn dials(_: &Editor<Self, D>) -> Vec<Dial> {
        Vec::new()
    }
    /// The value with the parameter of a potentiometer changed.
    fn dialled(editor: &Editor<Self, D>, _dial: usize, _to: f64) -> Self::Value {
        editor.history.now().clone()
    }
    /// The handles that Tab goes through, in the manner of today.
    fn handles(_: &Editor<Self, D>) -> Vec<Self::Handle> {
        Vec::new()
    }

    /// Carries out a command.
    async fn obey(editor: &mut Editor<Self, D>, desk: &mut Desk<'_>, action: Self::Action) -> Asked<Next>;
    /// Called after undo and redo, and when a change outdates what is shown.
    fn changed(editor: &mut Editor<Self, D>) {
        editor.shown.after_change();
    }
    /// Called when a handle has been dropped; `moved` is the value that results.
    async fn dropped(
        editor: &mut Editor<Self, D>,
        desk: &mut Desk<'_>,
        held: Held<Self::Handle, D>,
        moved: Self::Value,
    ) -> Asked<()>;
    /// The reason why there is no curve or surface.
    fn problem(_: &Editor<Self, D>) -> Option<Phrase> {
        None
    }
    /// Called after a change to parameters that have a curve or surface.
    fn reshaped(_: &mut Editor<Self, D>, _: &mut Desk<'_>) {}

    /// Whether there is a result to show; if not, says why.
    async fn begin_result(editor: &mut Editor<Self, D>, desk: &mut Desk<'_>) -> Asked<bool>;
    /// Called on return from the result.
    async fn end_result(_: &mut Editor<Self, D>, _: &mut Desk<'_>) -> Asked<()> {
        Ok(())
    }

    /// Whether the items replace the background.
    fn covers_ground(_: &Editor<Self, D>) -> bool {
        false
    }
    /// Draws what is its own in a part of the screen.
    fn draw(editor: &Editor<Self, D>, layer: picture::Layer, page: &mut picture::Page<'_>);
}

/// The editor's whole state.
pub(crate) struct Editor<C: Craft<D>, const D: usize> {
    pub(crate) craft: C,
    pub(crate) history: History<C::Value>,
    pub(crate) lens: C::Lens,
    pub(crate) held: Option<Held<C::Handle, D>>,
    pub(crate) shown: Shown,
    pub(crate) stage: Stage,
    /// The remark about a file that was read.
    pub(crate) remark: Option<Phrase>,
    pub(crate) manner: Manner,
    pub(crate) clicks: DoubleClick,
    /// Where the mouse is.
    pub(crate) mouse: (i32, i32),
    /// The handle that Tab has chosen, which the arrows move.
    pub(crate) picked: Option<C::Handle>,
    /// The axis of space that a handle keeps to.
    pub(crate) axis: Option<usize>,
    pub(crate) turning: Turning,
}

/// Prepares an editor, with or without a document to open.
pub(crate) fn start<C: Craft<D>, const D: usize>(
    craft: C,
    manual: Manual,
    document: Option<Document>,
) -> Result<Start, Phrase> {
    let editor = Editor::new(craft);
    if let Some(document) = &document {
        editor.craft.of_document(document, editor.history.now())?;
    }
    Ok(Box::new(move |machine| {
        Box::pin(async move { work::run(editor, &mut Desk::new(machine, manual), document).await })
    }))
}

impl<C: Craft<D>, const D: usize> Work for Editor<C, D> {
    type Value = C::Value;

    fn format(&self) -> Format {
        self.craft.formats(self.history.now()).first().copied().unwrap_or(self.craft.format())
    }

    fn extensions(&self) -> Vec<&'static str> {
        self.craft.formats(self.history.now()).into_iter().map(Format::extension).collect()
    }

    fn format_of(&self, name: &str) -> Format {
        let named = Format::from_name(name);
        let known = |format: &Format| self.craft.formats(self.history.now()).contains(format);
        named.filter(known).unwrap_or(self.format())
    }

    fn history(&mut self) -> &mut History<C::Value> {
        &mut self.history
    }

    fn reset(&mut self) {
        self.stage = self.stage.restarted();
        self.load(self.craft.fresh(Some(self.history.now())));
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        let (value, remark) = self.craft.of_document(document, self.history.now())?;
        self.load(value);
        self.remark = remark;
        Ok(())
    }

    fn document(&self) -> Result<Document, Phrase> {
        Ok(self.craft.document(self.history.now()))
    }

    fn implied(&self) -> Option<Method> {
        self.craft.implied()
    }

    fn saved_as(&self) -> Option<Format> {
        Some(self.format()).filter(|_| self.craft.fits_format(self.history.now()))
    }

    fn model(&self) -> impl Serialize + 'static {
        C::model(self)
    }

    fn look(&mut self, desk: &Desk<'_>) {
        self.behave(desk.machine.manner());
        self.craft.advance(desk.clock());
    }

    fn due(&self) -> Option<Duration> {
        self.craft.due()
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        self.behave(desk.machine.manner());
        self.held = None;
        self.let_hand_go();
        self.lens.stop();
        if let Some(remark) = self.remark.take() {
            desk.tell(remark, Stay::UntilRead);
        }
        loop {
            self.stage = Stage::Working;
            C::before_event(self, desk).await.unless_cancelled()?;
            self.stage = Stage::Working;
            if self.craft.leaves() {
                return Ok(Next::End);
            }
            let tick = event(self, desk).await?;
            self.mouse = (tick.mouse.x, tick.mouse.y);
            if self.held.is_none() && self.turns_by_hand(desk, &tick) {
                continue;
            }
            if self.held.is_some() {
                self.drag(desk, &tick).await.unless_cancelled()?;
            } else if C::attended(self, desk, &tick)
                || self.lens.look_around(&tick)
                || C::looked(self, desk, &tick)
            {
                // Only the picture changes.
            } else if common_key(self, desk, tick.key()).await? {
                self.picked = self.picked.filter(|picked| C::handles(self).contains(picked));
                C::changed(self);
            } else if let Some(action) = self.command(&tick) {
                let before = self.history.now().clone();
                let next = C::obey(self, desk, action).await.unless_cancelled()?.unwrap_or(Next::Work);
                self.forget_changed(&before);
                if next != Next::Work {
                    return Ok(next);
                }
            }
        }
    }
}

impl<C: Craft<D>, const D: usize> Editor<C, D> {
    fn new(craft: C) -> Editor<C, D> {
        let (lens, value) = (craft.lens(), craft.fresh(None));
        let history = History::new(value);
        Editor {
            craft,
            history,
            lens,
            held: None,
            shown: Shown::default(),
            stage: Stage::FIRST,
            remark: None,
            manner: Manner::default(),
            clicks: DoubleClick::default(),
            mouse: (-1, -1),
            picked: None,
            axis: None,
            turning: Turning::default(),
        }
    }

    /// Takes up how the program behaves. In the manner of today the curve or surface stays in the picture.
    fn behave(&mut self, manner: Manner) {
        if manner != self.manner {
            self.manner = manner;
            self.shown.follow = manner == Manner::Today;
            self.craft.behave(manner);
        }
        if manner == Manner::Today && self.shown.follow && !self.stage.is_result() {
            self.shown.take(C::has_shape(self));
        }
    }

    /// Replaces the value by one that needs no saving, and resets the view.
    fn load(&mut self, value: C::Value) {
        self.history = History::new(value);
        self.lens = self.craft.lens();
        self.held = None;
        self.remark = None;
        self.let_hand_go();
        C::forget(self);
        self.shown.take(self.craft.names_shape(self.history.now()));
    }

    /// The command of a key or click; a click on a handle starts to hold it.
    fn command(&mut self, tick: &Tick) -> Option<C::Action> {
        let twice = self.clicks.of(tick).filter(|_| self.manner == Manner::Today);
        let given = self.craft.commands().find(tick);
        let Some(at) = tick.click().filter(|_| given.is_none()) else { return given };
        if let Some(handle) = C::handle_at(self, at) {
            let from = C::place(self.history.now(), handle)?;
            self.held = Some(Held { handle, pressed: at, from, at: from });
            return None;
        }
        let clicked = C::clicked(self, at).or_else(|| C::value_at(self, twice?));
        if clicked.is_none() && self.manner == Manner::Today && PICTURE.holds(at.0, at.1) {
            self.held = C::taken_up(self, at);
            if self.held.is_none() {
                self.lens.grab(at);
            }
        }
        clicked
    }

    /// Moves the held handle with the mouse, and drops it on release.
    async fn drag(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> Asked<()> {
        let Some(mut held) = self.held else { return Ok(()) };
        match tick.event {
            Some(Event::Move(..)) => {
                held.at = self.dragged_to(&held).unwrap_or(held.at);
                self.held = Some(held);
            }
            Some(Event::Key(key)) if self.keeps_axis(key) => {
                held.at = self.dragged_to(&held).unwrap_or(held.at);
                self.held = Some(held);
            }
            Some(Event::Release(Button::Left)) => {
                let moved = self.preview();
                (self.held, self.axis) = (None, None);
                return C::dropped(self, desk, held, moved).await;
            }
            Some(Event::Key(Key::Esc)) => (self.held, self.axis) = (None, None),
            _ => {}
        }
        Ok(())
    }

    /// The value with the held handle dropped at the mouse.
    pub(crate) fn preview(&self) -> C::Value {
        let now = self.history.now();
        match (self.held, self.turning.held) {
            (Some(held), _) => C::moved(now, held.handle, held.at),
            (None, Some((dial, to))) => C::dialled(self, dial, to),
            (None, None) => now.clone(),
        }
    }

    /// Sets parameters. If they have no curve or surface, it says so and keeps them nevertheless.
    pub(crate) fn reshape(&mut self, desk: &mut Desk<'_>, value: C::Value) {
        self.history.change(value);
        match C::problem(self) {
            Some(problem) => desk.tell(problem, Stay::UntilRead),
            None => C::reshaped(self, desk),
        }
    }

    /// Shows the result, without frame and buttons, until Esc.
    pub(crate) async fn show_result(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if !C::begin_result(self, desk).await? {
            return Ok(());
        }
        loop {
            let tick = event(self, desk).await?;
            if !self.lens.look_around(&tick) && !C::looked(self, desk, &tick) && tick.pressed(Key::Esc) {
                break;
            }
        }
        self.lens.stop();
        C::end_result(self, desk).await
    }
}
