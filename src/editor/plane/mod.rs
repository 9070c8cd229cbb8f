//! The editor of plane curves: control points on a grid, taken out of the store, dragged, numbered,
//! inserted and deleted, and the curves through them (chapters 2.3.1 to 2.3.3 and 2.3.5 to 2.3.8).
//!
//! Three programs are this editor with [`Tools`] of their own.

mod commands;
mod compare;
mod curves;
mod figure;
mod files;
mod joints;
mod layout;
mod picture;
mod sketch;
mod tangents;
mod tools;
mod workshop;

use files::is_beta;
pub use files::{check, with_twin};
pub use sketch::Sketch;
pub use tools::Tools;

use super::History;
use super::choice::{COMMANDS, FEWEST, Shown};
use super::configuration::{self, Configuration, Next, common_key, event};
use super::drawing::{self, Edit, Place};
use super::stage::Stage;
use crate::file::{Document, Format};
use crate::geometry::{Closure, Point};
use crate::machine::{Button, Event, Key, Machine, Quit, Storage, Tick};
use crate::ui::words::{self, Phrase};
use crate::ui::{Desk, Manual, Stay, Words};
use curves::Kind;
use layout::{STORE_AT, to_field, to_screen};
use serde::Serialize;

/// The control points of a plane curve.
pub type Drawing = drawing::Drawing<Point<2>>;

/// What the mouse can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Handle {
    /// A control point; the one behind the last is the store's.
    Point(usize),
    /// The tip of the tangent at a point.
    Tip(usize),
}

/// Something under the mouse.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Held {
    handle: Handle,
    /// Where it is held, in field coordinates.
    at: Point<2>,
}

/// The editor's whole state.
struct Editor {
    tools: Tools,
    history: History<Sketch>,
    shown: Shown,
    /// Curves that are shown besides the chosen one.
    compared: Vec<Kind>,
    /// The coefficient of the automatic tangents.
    k0: f64,
    held: Option<Held>,
    stage: Stage,
    /// What the screen says about the last choice until the next question.
    note: Option<String>,
    /// Whether something happened after which the original offers automatic tangents.
    offer_tangents: bool,
    /// Whether a JSON file with what the DOS format cannot hold belongs to the configuration.
    has_json: bool,
    /// What reading a file had to say although it could be read.
    remark: Option<Words>,
}

/// The model as `dump` writes it.
#[derive(Serialize)]
struct Model {
    points: Vec<Point<2>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tangents: Option<Vec<Point<2>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    joints: Option<Vec<crate::geometry::Shape>>,
    bias: f64,
    tension: f64,
    method: Option<&'static str>,
    closed: Option<bool>,
    k0: f64,
    visible: bool,
    compared: Vec<Kind>,
    unsaved: bool,
}

/// Runs the editor as a program, with a document that was named at the start or none.
///
/// # Errors
/// [`Quit`] when the display is being closed and nothing is left to save.
pub async fn run(
    machine: &mut Machine,
    manual: Manual,
    tools: Tools,
    document: Option<Document>,
) -> Result<(), Quit> {
    configuration::run(Editor::new(tools), &mut Desk::new(machine, manual), document).await
}

impl Configuration for Editor {
    type Value = Sketch;

    fn format(&self) -> Format {
        self.tools.format()
    }

    fn history(&mut self) -> &mut History<Sketch> {
        &mut self.history
    }

    fn reset(&mut self) {
        self.stage = self.stage.restarted();
        self.load(self.empty());
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        self.open_document(document)
    }

    fn document(&self) -> Document {
        self.as_document()
    }

    fn read(&mut self, storage: &mut dyn Storage, name: &str) -> Result<(), Phrase> {
        self.read_files(storage, name)
    }

    fn files(&self, name: &str) -> Result<Vec<(String, Vec<u8>)>, Phrase> {
        self.as_files(name)
    }

    fn unsaved_work(&self) -> Result<String, Phrase> {
        Document::PlanePoints(self.whole()).to_json().map_err(|error| words::plain(&error))
    }

    fn take_up(&mut self, work: &str) -> Result<(), Phrase> {
        let document = Document::from_json(work).map_err(|error| words::plain(&error))?;
        self.open_document(&document)?;
        self.has_json = self.tools == Tools::Beta && is_beta(&document);
        Ok(())
    }

    fn model(&self) -> impl Serialize + 'static {
        let sketch = self.history.now();
        Model {
            points: sketch.points().to_vec(),
            tangents: sketch.tangents.clone(),
            joints: sketch.joints.clone(),
            bias: sketch.shape.bias,
            tension: sketch.shape.tension,
            method: self.shown.choice.map(|choice| choice.method.name()),
            closed: self.shown.choice.map(|choice| choice.closure == Closure::Closed),
            k0: self.k0,
            visible: self.shown.visible,
            compared: self.compared.clone(),
            unsaved: self.history.unsaved(),
        }
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Result<Next, Quit> {
        self.held = None;
        if let Some(remark) = self.remark.take() {
            desk.tell(remark, Stay::UntilRead);
        }
        // As in the original the store is empty while this is asked after an action, but not at the start.
        let mut offering = Stage::Working;
        loop {
            self.stage = std::mem::replace(&mut offering, Stage::Offering);
            if std::mem::take(&mut self.offer_tangents) {
                configuration::keep(self, desk);
                self.offer_automatic_tangents(desk).await?;
            }
            self.stage = Stage::Working;
            let tick = event(self, desk).await?;
            if self.held.is_some() {
                self.drag(desk, &tick);
            } else if common_key(self, desk, tick.key()).await? {
                self.shown.after_change();
            } else if let Some(letter) = self.command(&tick) {
                let next = self.obey(desk, letter).await?;
                if next != Next::Work {
                    return Ok(next);
                }
            } else if let Some(Key::F(number)) = tick.key() {
                self.function_key(desk, number).await?;
            }
        }
    }
}

impl Editor {
    fn new(tools: Tools) -> Editor {
        let mut editor = Editor {
            tools,
            history: History::new(Sketch::default()),
            shown: Shown::default(),
            compared: Vec::new(),
            k0: 0.5,
            held: None,
            stage: Stage::FIRST,
            note: None,
            offer_tangents: false,
            has_json: false,
            remark: None,
        };
        editor.load(editor.empty());
        editor
    }

    /// A sketch without points; the common shape survives, as in the original.
    fn empty(&self) -> Sketch {
        let tangents = (self.tools == Tools::Tangents).then(Vec::new);
        Sketch { tangents, shape: self.history.now().shape, ..Sketch::default() }
    }

    /// How many points there are.
    fn count(&self) -> usize {
        self.history.now().points().len()
    }

    /// The form of the curves: that of the chosen one, else open.
    fn closure(&self) -> Closure {
        self.shown.choice.map_or(Closure::Open, |choice| choice.closure)
    }

    /// Takes up a sketch that needs no saving.
    fn load(&mut self, sketch: Sketch) {
        self.history = History::new(sketch);
        self.shown.take(None);
        self.held = None;
        self.note = None;
        self.has_json = false;
        self.remark = None;
        self.offer_tangents = self.tools == Tools::Tangents && self.count() >= FEWEST;
    }

    /// Makes a changed sketch the present one. As in the original the curve goes, unless it shall follow.
    fn change(&mut self, sketch: Sketch) {
        self.history.change(sketch);
        self.shown.after_edit();
        self.forget_note();
    }

    /// Takes away what the communication page says; beside it, the coefficient of tangents stays.
    fn forget_note(&mut self) {
        if self.tools != Tools::Tangents {
            self.note = None;
        }
    }

    async fn function_key(&mut self, desk: &mut Desk<'_>, number: u8) -> Result<(), Quit> {
        match (number, self.tools) {
            (3, _) => self.shown.toggle_follow(desk),
            (4, Tools::Methods) => self.compare(desk).await?,
            (5, Tools::Methods) => self.open_workshop(desk).await?,
            (5, Tools::Beta) => self.change_joint(desk).await?,
            (6, Tools::Beta) => self.make_joints_alike(desk),
            _ => {}
        }
        Ok(())
    }

    /// The command letter of a key or of a click on a button; a click on a disc takes it up.
    fn command(&mut self, tick: &Tick) -> Option<char> {
        let Some((x, y)) = tick.click() else { return tick.letter() };
        if let Some(handle) = self.handle_at(x, y) {
            self.held = Some(Held { handle, at: self.place(handle) });
            return None;
        }
        let mut buttons = COMMANDS.iter().chain(self.tools.buttons());
        buttons.find(|button| button.hit(x, y)).map(|button| button.text.letter)
    }

    /// Where a handle is, in field coordinates.
    fn place(&self, handle: Handle) -> Point<2> {
        let sketch = self.history.now();
        match handle {
            Handle::Point(index) => sketch.points().get(index).copied().unwrap_or(STORE_AT),
            Handle::Tip(index) => sketch.tip(index).unwrap_or(STORE_AT),
        }
    }

    /// Follows the mouse with what it holds, and drops it.
    fn drag(&mut self, desk: &mut Desk<'_>, tick: &Tick) {
        let count = self.count();
        let Some(held) = &mut self.held else { return };
        match tick.event {
            Some(Event::Move(..)) => {
                let (x, y) = to_screen(held.at);
                let (dx, dy) = (tick.mouse.x - x, tick.mouse.y - y);
                // A hand that only clicks does not move the point.
                if dx * dx + dy * dy > 2 {
                    held.at = to_field(tick.mouse.x, tick.mouse.y);
                }
            }
            Some(Event::Release(Button::Left)) => {
                if self.history.now().drawing.full() && held.handle == Handle::Point(count) {
                    desk.tell(words::FULL, Stay::Briefly);
                }
                self.history.change(self.preview());
                self.held = None;
                self.shown.after_change();
                self.forget_note();
                self.offer_tangents = true;
            }
            Some(Event::Key(Key::Esc)) => self.held = None,
            _ => {}
        }
    }

    /// The sketch as it would be if what is held were dropped now: a point outside the field goes.
    fn preview(&self) -> Sketch {
        let now = self.history.now();
        let Some(Held { handle, at }) = self.held else { return now.clone() };
        match (handle, at.fits()) {
            (Handle::Point(index), true) if index < self.count() => now.edited(Edit::Move(index, at)),
            (Handle::Point(index), false) if index < self.count() => now.edited(Edit::Delete(index)),
            (Handle::Point(index), true) => now.edited(Edit::Insert(index, at)),
            (Handle::Point(_), false) => now.clone(),
            (Handle::Tip(index), _) => now.with_tip(index, at),
        }
    }
}
