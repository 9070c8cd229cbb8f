//! The editor of curves in space: control points on three axes, seen from a direction that the user
//! turns, and the curves through them or near them (chapters 2.3.3 to 2.3.7 in three dimensions). Which
//! curves are offered is the program's choice of [`Tools`].

mod commands;
mod picture;

use super::beta::BUTTONS;
use super::choice::{COMMANDS, METHODS, Shown};
use super::drawing::{self, Edit};
use super::keys::{CHANGE, DELETE, FOLLOW, FORM, INSERT, METHOD, QUIT, RESULT, SAVE, SHAPE, UNDO};
use super::look::{Grip, Held, Look, Poles, Viewer};
use super::stage::Stage;
use crate::file::{Document, Format, SPACE_VIEW, SpacePoints};
use crate::geometry::{Closure, Point, Shape};
use crate::machine::{Asked, Asking, Key, Machine, Tick};
use crate::ui::words::{self, Phrase};
use crate::ui::{self, Desk, KeyHelp, Manual, Start, Words};
use crate::work::{self, Configuration, History, Next, common_key, event};
use serde::Serialize;

/// The control points of a curve in space.
pub type Drawing = drawing::Drawing<Point<3>>;

/// The curves that a program offers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tools {
    /// Coons-Hermite, Bézier, spline, quadratic and cubic B-spline.
    Methods,
    /// The beta-spline with bias and tension.
    Beta,
}

impl Tools {
    /// The buttons beside the page, below the commands.
    fn buttons(self) -> &'static [ui::Button] {
        match self {
            Tools::Methods => &METHODS,
            Tools::Beta => &BUTTONS,
        }
    }
}

/// The editor's whole state.
struct Editor {
    tools: Tools,
    history: History<Drawing>,
    viewer: Viewer,
    shown: Shown,
    /// The shape of the beta-spline; it outlives a configuration.
    shape: Shape,
    held: Option<Held<usize>>,
    stage: Stage,
    /// The point that is about to be changed.
    pointed_out: Option<usize>,
    /// What the communication page says between two questions.
    note: Option<String>,
}

/// The model as `dump` writes it. Angles are in degrees.
#[derive(Serialize)]
struct Model {
    points: Vec<Point<3>>,
    method: Option<&'static str>,
    closed: Option<bool>,
    bias: f64,
    tension: f64,
    visible: bool,
    azimuth: f64,
    elevation: f64,
    zoom: f64,
    unsaved: bool,
}

const DRAG: KeyHelp = (Words("egér", "mouse"), words::HELP_DRAG_3D);
const TURN_DRAG: KeyHelp = (Words("jobb gomb", "right button"), words::HELP_TURN_DRAG);
const TURN_KEYS: KeyHelp = (Words("nyilak", "arrows"), words::HELP_TURN_KEYS);
const ZOOM: KeyHelp = (Words("kerék", "wheel"), words::HELP_ZOOM);
const HOME: KeyHelp = (Words("Home", "Home"), words::HELP_HOME);

/// The keys of the editor with [`Tools::Methods`] for its help page.
pub const METHOD_KEYS: &[KeyHelp] = &[
    INSERT, CHANGE, DELETE, METHOD, RESULT, QUIT, DRAG, TURN_DRAG, TURN_KEYS, ZOOM, HOME, FOLLOW, SAVE, UNDO,
];

/// The keys of the editor with [`Tools::Beta`] for its help page.
pub const BETA_KEYS: &[KeyHelp] = &[
    INSERT, CHANGE, DELETE, SHAPE, FORM, RESULT, QUIT, DRAG, TURN_DRAG, TURN_KEYS, ZOOM, HOME, FOLLOW, SAVE,
    UNDO,
];

/// Makes the editor ready as a program, with a document that was named at the start or none.
///
/// # Errors
/// Why it cannot work with the document.
pub fn start(manual: Manual, tools: Tools, document: Option<Document>) -> Result<Start, Phrase> {
    document.as_ref().map_or(Ok(()), check)?;
    Ok(Box::new(move |machine| Box::pin(run(machine, manual, tools, document))))
}

/// Runs the editor as a program, with a document that was named at the start or none.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed and nothing is left to save.
pub async fn run(
    machine: &mut Machine,
    manual: Manual,
    tools: Tools,
    document: Option<Document>,
) -> Asked<()> {
    work::run(Editor::new(tools), &mut Desk::new(machine, manual), document).await
}

/// Whether the editor can work with a document; else why not.
///
/// # Errors
/// The reason, in both languages.
pub fn check(document: &Document) -> Result<(), Phrase> {
    drawing_of(document).map(|_| ())
}

fn drawing_of(document: &Document) -> Result<Drawing, Phrase> {
    let Document::SpacePoints(SpacePoints { points, .. }) = document else {
        return Err(words::NOT_IN_SPACE.into());
    };
    Drawing::new(points.clone()).ok_or(words::OUTSIDE_SPACE.into())
}

impl Configuration for Editor {
    type Value = Drawing;

    fn format(&self) -> Format {
        Format::Ip3
    }

    fn history(&mut self) -> &mut History<Drawing> {
        &mut self.history
    }

    fn reset(&mut self) {
        self.stage = self.stage.restarted();
        self.load(Drawing::default());
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        self.load(drawing_of(document)?);
        Ok(())
    }

    fn document(&self) -> Document {
        Document::SpacePoints(SpacePoints::new(self.history.now().points().to_vec()))
    }

    fn model(&self) -> impl Serialize + 'static {
        Model {
            points: self.history.now().points().to_vec(),
            method: self.shown.choice.map(|choice| choice.method.name()),
            closed: self.shown.choice.map(|choice| choice.closure == Closure::Closed),
            bias: self.shape.bias,
            tension: self.shape.tension,
            visible: self.shown.visible,
            azimuth: self.viewer.look.view.azimuth().to_degrees(),
            elevation: self.viewer.look.view.elevation().to_degrees(),
            zoom: self.viewer.look.scale(),
            unsaved: self.history.unsaved(),
        }
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        self.held = None;
        self.viewer.stop();
        self.pointed_out = None;
        loop {
            self.stage = Stage::Working;
            let tick = event(self, desk).await?;
            if self.held.is_some() {
                self.drag(&tick);
            } else if self.viewer.look_around(&tick) {
                // Only the picture changes.
            } else if common_key(self, desk, tick.key()).await? {
                self.shown.after_change();
            } else if let Some(letter) = self.command(&tick) {
                let next = self.obey(desk, letter).await.unless_cancelled()?.unwrap_or(Next::Work);
                if next != Next::Work {
                    return Ok(next);
                }
            } else if tick.pressed(Key::F(3)) {
                self.shown.toggle_follow(desk);
            }
        }
    }
}

impl Editor {
    fn new(tools: Tools) -> Editor {
        Editor {
            tools,
            history: History::new(Drawing::default()),
            viewer: Viewer::new(first_look()),
            shown: Shown::default(),
            shape: Shape::default(),
            held: None,
            stage: Stage::FIRST,
            pointed_out: None,
            note: None,
        }
    }

    /// Takes up a drawing that needs no saving, and looks at it as at the start.
    fn load(&mut self, drawing: Drawing) {
        self.history = History::new(drawing);
        self.viewer = Viewer::new(first_look());
        self.shown.take(None);
        self.held = None;
        self.pointed_out = None;
        self.note = None;
    }

    /// The command letter of a key or of a click on a button; a click on a disc takes it up.
    fn command(&mut self, tick: &Tick) -> Option<char> {
        let Some((x, y)) = tick.click() else { return tick.letter() };
        if let Some(index) = self.point_at(x, y) {
            let at = self.history.now().points().get(index).copied()?;
            self.held = Some(Held::new(index, (x, y), at));
            return None;
        }
        let own = match self.tools {
            Tools::Methods => &[],
            Tools::Beta => self.tools.buttons(),
        };
        let button = COMMANDS.iter().chain(own).find(|button| button.hit(x, y));
        button.map(|button| button.text.letter)
    }

    /// Follows the mouse with the point that it holds, in the plane of the picture, and drops it.
    fn drag(&mut self, tick: &Tick) {
        let Some(held) = &mut self.held else { return };
        match held.follow(tick, self.viewer.look) {
            Grip::Holding => {}
            Grip::Dropped => {
                self.history.change(self.preview());
                self.held = None;
                self.shown.after_change();
            }
            Grip::LetGo => self.held = None,
        }
    }

    /// The drawing as it would be if the held point were dropped now.
    fn preview(&self) -> Drawing {
        let now = self.history.now();
        match self.held {
            Some(held) => now.edited(Edit::Move(held.index, held.at)),
            None => now.clone(),
        }
    }
}

/// The look at every new configuration.
fn first_look() -> Look {
    Look::new(SPACE_VIEW, Poles::Stop)
}
