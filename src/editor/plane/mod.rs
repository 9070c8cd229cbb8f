//! The editor of plane curves: control points on a grid, taken out of the store, dragged, numbered,
//! inserted and deleted, and the curves through them (chapters 2.3.1 to 2.3.3 and 2.3.5 to 2.3.7).

mod commands;
mod curves;
mod drawing;
mod files;
mod layout;
mod picture;

pub use drawing::{Drawing, Edit};
pub use files::check;

use crate::file::Document;
use crate::geometry::{Closure, Method, Point};
use crate::machine::{Button, Event, Key, Machine, Quit, Tick};
use crate::ui::{Desk, KeyHelp, Manual, Stay, Words, words};
use curves::{Choice, Kind};
use layout::{to_field, to_screen};
use picture::COMMANDS;
use serde::Serialize;

use super::History;

/// What the screen shows besides the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// Before there is a configuration: no buttons yet.
    Starting,
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

/// What the next step of the program is after a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Next {
    /// The same configuration goes on.
    Work,
    /// A new configuration.
    Restart,
    /// The end.
    End,
}

/// The editor's whole state.
struct Editor {
    history: History<Drawing>,
    /// The curve of the last "G"; `None` after a change by number, as in the original.
    choice: Option<Choice>,
    /// Whether the chosen curve is in the picture.
    visible: bool,
    /// Whether the curve stays in the picture after a change and follows it.
    follow: bool,
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

/// Runs the editor as a program, with a file that was named at the start or none.
///
/// # Errors
/// [`Quit`] when the display is being closed and nothing is left to save.
pub async fn run(machine: &mut Machine, manual: Manual, file: Option<Document>) -> Result<(), Quit> {
    let mut desk = Desk::new(machine, manual);
    let mut editor = Editor::new();
    let mut next = match file.map(|document| editor.open(&document)) {
        Some(Ok(())) => Next::Work,
        Some(Err(problem)) => {
            desk.tell(problem, Stay::UntilRead);
            Next::Restart
        }
        None => Next::Restart,
    };
    loop {
        let step = match next {
            Next::Restart => editor.start(&mut desk).await.map(|()| Next::Work),
            Next::Work => editor.work(&mut desk).await,
            Next::End => return Ok(()),
        };
        next = match step {
            Ok(next) => next,
            Err(Quit) if editor.may_close(&mut desk).await => return Err(Quit),
            Err(Quit) => Next::Work,
        };
    }
}

impl Editor {
    fn new() -> Editor {
        Editor {
            history: History::new(Drawing::default()),
            choice: None,
            visible: false,
            follow: false,
            compared: Vec::new(),
            k0: 0.5,
            held: None,
            stage: Stage::Starting,
            note: None,
        }
    }

    /// The form of the curves: that of the chosen one, else open.
    fn closure(&self) -> Closure {
        self.choice.map_or(Closure::Open, |choice| choice.closure)
    }

    /// Takes up a drawing that needs no saving.
    fn load(&mut self, drawing: Drawing) {
        self.history = History::new(drawing);
        self.choice = None;
        self.visible = false;
        self.held = None;
        self.note = None;
    }

    /// Carries out an edit by number. As in the original the curve goes, unless it shall follow.
    fn edit(&mut self, edit: Edit) {
        self.history.change(self.history.now().edited(edit));
        if !self.follow {
            self.choice = None;
            self.visible = false;
        }
        self.note = None;
    }

    /// Works on a configuration until a command leads out of it.
    async fn work(&mut self, desk: &mut Desk<'_>) -> Result<Next, Quit> {
        self.stage = Stage::Working;
        self.held = None;
        loop {
            desk.machine.publish(self.model());
            let tick = desk.event(self).await?;
            if self.held.is_some() {
                self.drag(desk, &tick);
                continue;
            }
            let next = match tick.key() {
                Some(Key::Ctrl('Z')) => self.travel(desk, History::undo),
                Some(Key::Ctrl('Y')) => self.travel(desk, History::redo),
                Some(Key::Ctrl('S')) => {
                    self.save(desk).await?;
                    Next::Work
                }
                Some(Key::F(3)) => self.toggle_follow(desk),
                Some(Key::F(4)) => self.compare(desk).await?,
                _ => match self.command(&tick) {
                    Some(letter) => self.obey(desk, letter).await?,
                    None => Next::Work,
                },
            };
            self.stage = Stage::Working;
            if next != Next::Work {
                return Ok(next);
            }
        }
    }

    /// The command letter of a key or of a click on a button; a click on a disc takes it up.
    fn command(&mut self, tick: &Tick) -> Option<char> {
        if let Some((x, y)) = tick.click() {
            if let Some(index) = self.point_at(x, y) {
                let points = self.history.now().points();
                let at = points.get(index).copied().unwrap_or(layout::STORE_AT);
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
                self.visible &= self.follow;
            }
            Some(Event::Key(Key::Esc)) => self.held = None,
            _ => {}
        }
    }

    /// The drawing as it would be if the held point were dropped now: outside the field it goes.
    fn preview(&self) -> Drawing {
        let now = self.history.now();
        let Some(held) = self.held else { return now.clone() };
        match (held.index < now.points().len(), drawing::in_field(held.at)) {
            (true, true) => now.edited(Edit::Move(held.index, held.at)),
            (true, false) => now.edited(Edit::Delete(held.index)),
            (false, true) => now.edited(Edit::Insert(held.index, held.at)),
            (false, false) => now.clone(),
        }
    }

    /// Undoes or redoes; says when there is nothing to do.
    fn travel(&mut self, desk: &mut Desk<'_>, step: fn(&mut History<Drawing>) -> bool) -> Next {
        if !step(&mut self.history) {
            desk.tell(words::NO_MORE, Stay::Briefly);
        }
        self.visible &= self.follow;
        Next::Work
    }

    fn toggle_follow(&mut self, desk: &mut Desk<'_>) -> Next {
        self.follow = !self.follow;
        self.visible = self.follow && self.choice.is_some();
        desk.tell(if self.follow { words::FOLLOWS } else { words::FOLLOWS_NOT }, Stay::Briefly);
        Next::Work
    }

    fn model(&self) -> Model {
        Model {
            points: self.history.now().points().to_vec(),
            method: self.choice.map(|choice| Method::name(choice.method)),
            closed: self.choice.map(|choice| choice.closure == Closure::Closed),
            k0: self.k0,
            visible: self.visible,
            compared: self.compared.clone(),
            unsaved: self.history.unsaved(),
        }
    }
}
