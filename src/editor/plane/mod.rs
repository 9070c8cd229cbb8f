//! The editor of plane curves: control points on a grid, taken out of the store, dragged, numbered,
//! inserted and deleted, and the curves through them (chapters 2.3.1 to 2.3.3 and 2.3.5 to 2.3.7).

mod commands;
mod curves;
mod layout;
mod picture;

use super::History;
use super::choice::{COMMANDS, Shown};
use super::configuration::{self, Configuration, Next, common_key, event};
use super::drawing::{self, Edit, Place};
use crate::file::{Document, Format, PlanePoints};
use crate::geometry::{Closure, Point};
use crate::machine::{Button, Event, Key, Machine, Quit, Tick};
use crate::ui::words::{self, Phrase};
use crate::ui::{Desk, KeyHelp, Manual, Stay, Words};
use curves::Kind;
use layout::{STORE_AT, to_field, to_screen};
use serde::Serialize;

/// The control points of a plane curve.
pub type Drawing = drawing::Drawing<Point<2>>;

/// What the screen shows besides the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// Before there is a configuration; before the first one there are no buttons either.
    Starting { buttons: bool },
    /// Editing.
    Working,
    /// Editing, while the method is being chosen.
    Choosing,
    /// The curve without its surroundings, with or without the control points.
    Result { points: bool },
}

/// A point under the mouse.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Held {
    /// Which one; the store's counts as the one behind the last.
    index: usize,
    /// Where it is held, in field coordinates.
    at: Point<2>,
}

/// The editor's whole state.
struct Editor {
    history: History<Drawing>,
    shown: Shown,
    /// Curves that are shown besides the chosen one.
    compared: Vec<Kind>,
    /// The coefficient of the Coons-Hermite tangents.
    k0: f64,
    held: Option<Held>,
    stage: Stage,
    /// What the communication page says between two questions.
    note: Option<String>,
}

/// The model as `dump` writes it.
#[derive(Serialize)]
struct Model {
    points: Vec<Point<2>>,
    method: Option<&'static str>,
    closed: Option<bool>,
    k0: f64,
    visible: bool,
    compared: Vec<Kind>,
    unsaved: bool,
}

/// The keys of the editor for its help page; a program adds none.
pub const KEYS: &[KeyHelp] = &[
    (Words("egér", "mouse"), words::HELP_DRAG),
    (Words("B", "B"), words::HELP_INSERT),
    (Words("V", "V"), words::HELP_CHANGE),
    (Words("T", "T"), words::HELP_DELETE),
    (Words("G 1-4", "G 1-4"), words::HELP_CURVE),
    (Words("E", "E"), words::HELP_RESULT),
    (Words("Q", "Q"), words::HELP_QUIT),
    (Words("F3", "F3"), words::HELP_FOLLOW),
    (Words("F4 1-5", "F4 1-5"), words::HELP_COMPARE),
    (Words("Ctrl+S", "Ctrl+S"), words::HELP_SAVE),
];

/// Runs the editor as a program, with a document that was named at the start or none.
///
/// # Errors
/// [`Quit`] when the display is being closed and nothing is left to save.
pub async fn run(machine: &mut Machine, manual: Manual, document: Option<Document>) -> Result<(), Quit> {
    configuration::run(Editor::new(), &mut Desk::new(machine, manual), document).await
}

/// Whether the editor can work with a document; else why not.
///
/// # Errors
/// The reason, in both languages.
pub fn check(document: &Document) -> Result<(), Phrase> {
    drawing_of(document).map(|_| ())
}

fn drawing_of(document: &Document) -> Result<Drawing, Phrase> {
    let Document::PlanePoints(PlanePoints { points, .. }) = document else {
        return Err(words::WRONG_CONTENT.into());
    };
    Drawing::new(points.clone()).ok_or(words::OUTSIDE_FIELD.into())
}

impl Configuration for Editor {
    const FORMAT: Format = Format::Ip2;
    type Value = Drawing;

    fn history(&mut self) -> &mut History<Drawing> {
        &mut self.history
    }

    fn reset(&mut self) {
        let first = self.stage == Stage::Starting { buttons: false };
        self.stage = Stage::Starting { buttons: !first };
        self.load(Drawing::default());
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        self.load(drawing_of(document)?);
        Ok(())
    }

    fn document(&self) -> Document {
        Document::PlanePoints(PlanePoints::new(self.history.now().points().to_vec()))
    }

    fn model(&self) -> impl Serialize + 'static {
        Model {
            points: self.history.now().points().to_vec(),
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
        loop {
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
            } else if tick.pressed(Key::F(3)) {
                self.shown.toggle_follow(desk);
            } else if tick.pressed(Key::F(4)) {
                self.compare(desk).await?;
            }
        }
    }
}

impl Editor {
    fn new() -> Editor {
        Editor {
            history: History::new(Drawing::default()),
            shown: Shown::default(),
            compared: Vec::new(),
            k0: 0.5,
            held: None,
            stage: Stage::Starting { buttons: false },
            note: None,
        }
    }

    /// The form of the curves: that of the chosen one, else open.
    fn closure(&self) -> Closure {
        self.shown.choice.map_or(Closure::Open, |choice| choice.closure)
    }

    /// Takes up a drawing that needs no saving.
    fn load(&mut self, drawing: Drawing) {
        self.history = History::new(drawing);
        self.shown.take(None);
        self.held = None;
        self.note = None;
    }

    /// The command letter of a key or of a click on a button; a click on a disc takes it up.
    fn command(&mut self, tick: &Tick) -> Option<char> {
        if let Some((x, y)) = tick.click() {
            if let Some(index) = self.point_at(x, y) {
                let points = self.history.now().points();
                let at = points.get(index).copied().unwrap_or(STORE_AT);
                self.held = Some(Held { index, at });
                return None;
            }
            return COMMANDS.iter().find(|button| button.hit(x, y)).map(|button| button.text.letter);
        }
        tick.letter()
    }

    /// Follows the mouse with the point that it holds, and drops it.
    fn drag(&mut self, desk: &mut Desk<'_>, tick: &Tick) {
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
                if held.index == self.history.now().points().len() && self.history.now().full() {
                    desk.tell(words::FULL, Stay::Briefly);
                }
                self.history.change(self.preview());
                self.held = None;
                self.shown.after_change();
            }
            Some(Event::Key(Key::Esc)) => self.held = None,
            _ => {}
        }
    }

    /// The drawing as it would be if the held point were dropped now: outside the field it goes.
    fn preview(&self) -> Drawing {
        let now = self.history.now();
        let Some(held) = self.held else { return now.clone() };
        match (held.index < now.points().len(), held.at.fits()) {
            (true, true) => now.edited(Edit::Move(held.index, held.at)),
            (true, false) => now.edited(Edit::Delete(held.index)),
            (false, true) => now.edited(Edit::Insert(held.index, held.at)),
            (false, false) => now.clone(),
        }
    }
}
