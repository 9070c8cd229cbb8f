//! The editor of surfaces: a net of control points in space, seen from a direction that the user turns, and
//! the surface through it or near it (chapter 3). Which net and which methods is the program's [`Plan`].

mod ask;
mod commands;
mod figure;
mod inspect;
mod map;
mod model;
mod nets;
mod picture;
mod plan;
mod show;
mod surface;

pub use plan::{Family, Plan, Start};
pub use show::{SHOW_KEYS, Show, show, shows_nothing_else};

use super::keys::{QUIT, SAVE, UNDO};
use super::look::{Grip, Held, Look, Poles, Viewer};
use crate::file::{Document, FileKind, Format};
use crate::geometry::Point;
use crate::machine::{Asked, Asking, Machine, Tick};
use crate::ui::words::{self, Phrase};
use crate::ui::{self, Desk, KeyHelp, Stay, Words};
use crate::work::{self, Configuration, History, Next, common_key, event};
use inspect::{Inspection, Section};
use map::Map;
use model::{Index, Model, Part};
use plan::{Degree, Form};
use serde::Serialize;
use surface::{Display, Drawn};

/// Where the editor is between the first question and the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// Before there is a configuration; before the first one there are no buttons either.
    Starting { buttons: bool },
    /// Editing.
    Working,
    /// The surface without its surroundings.
    Result,
    /// On the way back from there.
    Returning,
}

/// The editor's whole state.
struct Editor {
    plan: Plan,
    history: History<Model>,
    viewer: Viewer,
    held: Option<Held<Index>>,
    /// The surface of the last "F", if it stands in the picture instead of the net.
    drawn: Option<Drawn>,
    /// Whether there has been an "F" since the last change of the net: only then there is a result.
    shown: bool,
    display: Display,
    degree: Degree,
    /// Whether the surface is always in the picture, and follows every change.
    follow: bool,
    inspection: Inspection,
    section: Option<Section>,
    /// The control point that is about to be changed, and what of it.
    chosen: Option<(Index, Part)>,
    stage: Stage,
}

/// The model as `dump` writes it. Angles are in degrees.
#[derive(Serialize)]
struct Dump {
    points: Vec<Vec<Point<3>>>,
    bias: [f64; 2],
    tension: [f64; 2],
    k0: [f64; 2],
    degree: u8,
    extended: bool,
    surface: bool,
    filled: bool,
    azimuth: f64,
    elevation: f64,
    zoom: f64,
    unsaved: bool,
}

const CHANGE: KeyHelp = (Words("V", "V"), words::HELP_NET_CHANGE);
const SURFACE: KeyHelp = (Words("F", "F"), words::HELP_SURFACE);
const RESULT: KeyHelp = (Words("E", "E"), words::HELP_SURFACE_RESULT);
const DRAG: KeyHelp = (Words("egér", "mouse"), words::HELP_NET_DRAG);
const TURN_DRAG: KeyHelp = (Words("jobb gomb", "right button"), words::HELP_TURN_DRAG);
const TURN_KEYS: KeyHelp = (Words("nyilak", "arrows"), words::HELP_TURN_KEYS);
const ZOOM: KeyHelp = (Words("kerék", "wheel"), words::HELP_ZOOM);
const HOME: KeyHelp = (Words("Home", "Home"), words::HELP_HOME);
const FOLLOW: KeyHelp = (Words("F3", "F3"), words::HELP_NET_FOLLOW);
const BORDER: KeyHelp = (Words("F4", "F4"), words::HELP_BORDER);
const INSPECT: KeyHelp = (Words("F5", "F5"), words::HELP_INSPECT);
const SECTION: KeyHelp = (Words("F6", "F6"), words::HELP_SECTION);
const MIRROR: KeyHelp = (Words("F7", "F7"), words::HELP_MIRROR);
const REFINE: KeyHelp = (Words("F8", "F8"), words::HELP_REFINE);
const SHAPES: KeyHelp = (Words("A C", "A C"), words::HELP_SHAPES);
const COEFFICIENTS: KeyHelp = (Words("C", "C"), words::HELP_K0);

/// The keys for the help page of a program without parameters.
pub const KEYS: &[KeyHelp] = &[
    CHANGE, SURFACE, RESULT, QUIT, DRAG, TURN_DRAG, TURN_KEYS, ZOOM, HOME, FOLLOW, INSPECT, SECTION, MIRROR,
    SAVE, UNDO,
];
/// The keys with a coefficient in each direction.
pub const LOCAL_KEYS: &[KeyHelp] = &[
    CHANGE,
    SURFACE,
    RESULT,
    COEFFICIENTS,
    QUIT,
    DRAG,
    TURN_DRAG,
    TURN_KEYS,
    ZOOM,
    HOME,
    FOLLOW,
    INSPECT,
    SECTION,
    MIRROR,
    SAVE,
    UNDO,
];
/// The keys with bias and tension in each direction.
pub const BETA_KEYS: &[KeyHelp] = &[
    CHANGE, SURFACE, RESULT, SHAPES, QUIT, DRAG, TURN_DRAG, TURN_KEYS, ZOOM, HOME, FOLLOW, INSPECT, SECTION,
    MIRROR, SAVE, UNDO,
];
/// The keys for B-splines.
pub const B_SPLINE_KEYS: &[KeyHelp] = &[
    CHANGE, SURFACE, RESULT, QUIT, DRAG, TURN_DRAG, TURN_KEYS, ZOOM, HOME, FOLLOW, BORDER, INSPECT, SECTION,
    MIRROR, REFINE, SAVE, UNDO,
];
/// The keys for splines and the Bézier patch.
pub const FINER_KEYS: &[KeyHelp] = &[
    CHANGE, SURFACE, RESULT, QUIT, DRAG, TURN_DRAG, TURN_KEYS, ZOOM, HOME, FOLLOW, INSPECT, SECTION, MIRROR,
    REFINE, SAVE, UNDO,
];

/// Makes the editor ready as a program, with a document that was named at the start or none.
///
/// # Errors
/// Why it cannot work with the document.
pub fn start(plan: &'static Plan, document: Option<Document>) -> Result<ui::Start, Phrase> {
    document.as_ref().map_or(Ok(()), |document| check(plan, document))?;
    Ok(Box::new(move |machine| Box::pin(run(machine, *plan, document))))
}

/// Runs the editor as a program, with a document that was named at the start or none.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed and nothing is left to save.
pub async fn run(machine: &mut Machine, plan: Plan, document: Option<Document>) -> Asked<()> {
    let manual = plan.manual;
    work::run(Editor::new(plan), &mut Desk::new(machine, manual), document).await
}

/// Whether a program with a plan can work with a document; else why not.
///
/// # Errors
/// The reason, in both languages.
pub fn check(plan: &Plan, document: &Document) -> Result<(), Phrase> {
    model_of(plan, document, Form::default()).map(|_| ())
}

fn model_of(plan: &Plan, document: &Document, form: Form) -> Result<Model, Phrase> {
    match document {
        Document::Net(net) => Model::of_file(plan, net, form),
        _ => Err(words::NOT_A_NET.into()),
    }
}

impl Configuration for Editor {
    type Value = Model;

    fn format(&self) -> Format {
        self.plan.kind.format()
    }

    fn extension(&self) -> &'static str {
        if self.fits_its_format() { self.format().extension() } else { "JSON" }
    }

    fn history(&mut self) -> &mut History<Model> {
        &mut self.history
    }

    fn reset(&mut self) {
        self.stage = Stage::Starting { buttons: self.stage != FIRST };
        let form = self.history.now().form;
        self.load(Model { form, ..Model::new(&self.plan) });
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        let model = model_of(&self.plan, document, self.history.now().form)?;
        if let Document::Net(net) = document
            && net.settings.method == Some(crate::file::Method::BSpline2)
        {
            self.degree = Degree::Two;
        }
        self.load(model);
        Ok(())
    }

    fn document(&self) -> Document {
        let settings = !self.fits_its_format();
        Document::Net(self.history.now().to_file(&self.plan, self.degree, settings))
    }

    fn files(&self, name: &str) -> Result<Vec<(String, Vec<u8>)>, Phrase> {
        let kind = if self.fits_its_format() { FileKind::Dos(self.format()) } else { FileKind::Json };
        let content = self.document().encode(kind).map_err(|error| words::in_file(name, &error))?;
        Ok(vec![(name.to_string(), content)])
    }

    fn unsaved_work(&self) -> Result<String, Phrase> {
        let net = self.history.now().to_file(&self.plan, self.degree, true);
        Document::Net(net).to_json().map_err(|error| words::plain(&error))
    }

    fn model(&self) -> impl Serialize + 'static {
        let now = self.history.now();
        let view = self.viewer.look.view;
        Dump {
            points: now.net.clone(),
            bias: now.form.bias,
            tension: now.form.tension,
            k0: now.form.k0,
            degree: if self.degree == Degree::Two { 2 } else { 3 },
            extended: now.border == crate::geometry::Border::Reached,
            surface: self.drawn.is_some(),
            filled: self.display == Display::Filled,
            azimuth: view.azimuth().to_degrees(),
            elevation: view.elevation().to_degrees(),
            zoom: self.viewer.look.scale(),
            unsaved: self.history.unsaved(),
        }
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        self.held = None;
        self.viewer.stop();
        self.chosen = None;
        loop {
            self.stage = Stage::Working;
            let tick = event(self, desk).await?;
            if self.held.is_some() {
                self.drag(desk, &tick).await.unless_cancelled()?;
            } else if self.viewer.look_around(&tick) || self.inspect(desk, &tick) {
                // Only the picture changes.
            } else if common_key(self, desk, tick.key()).await? {
                self.changed();
            } else {
                let next = match (self.command(&tick), tick.key()) {
                    (Some(letter), _) => self.obey(desk, letter).await,
                    (None, Some(key)) => self.obey_key(desk, key).await,
                    (None, None) => self.choose_by_click(desk, &tick).await,
                };
                match next.unless_cancelled()? {
                    None | Some(Next::Work) => {}
                    Some(next) => return Ok(next),
                }
            }
        }
    }
}

/// The stage of a program that has just been started.
const FIRST: Stage = Stage::Starting { buttons: false };

impl Editor {
    fn new(plan: Plan) -> Editor {
        Editor {
            plan,
            history: History::new(Model::new(&plan)),
            viewer: Viewer::new(Look::new(plan.view, Poles::Cross)),
            held: None,
            drawn: None,
            shown: false,
            display: Display::Wire,
            degree: Degree::Three,
            follow: false,
            inspection: Inspection::Off,
            section: None,
            chosen: None,
            stage: FIRST,
        }
    }

    /// Takes up a model that needs no saving, and looks at it as at the start.
    fn load(&mut self, model: Model) {
        self.history = History::new(model);
        self.viewer = Viewer::new(Look::new(self.plan.view, Poles::Cross));
        self.drawn = None;
        self.shown = false;
        self.held = None;
        self.chosen = None;
        self.section = None;
    }

    fn fits_its_format(&self) -> bool {
        self.history.now().shape() == self.plan.kind.shape()
    }

    /// After a change the net is in the picture.
    fn changed(&mut self) {
        self.drawn = None;
        self.shown = self.follow;
    }

    fn map(&self) -> Map {
        Map::new(self.history.now().choices(&self.plan))
    }

    /// The command letter of a key or of a click on a button.
    fn command(&self, tick: &Tick) -> Option<char> {
        let Some((x, y)) = tick.click() else { return tick.letter() };
        let button = picture::buttons(self.plan.family).find(|button| button.hit(x, y));
        button.map(|button| button.text.letter)
    }

    /// A click on the map chooses its point; one on a control point in the picture takes it up.
    async fn choose_by_click(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> Asked<Next> {
        let Some(place) = tick.click() else { return Ok(Next::Work) };
        if let Some(index) = self.map().hit(place) {
            self.change(desk, Some(index)).await?;
        } else if let Some(index) = self.point_at(place) {
            self.held = self.history.now().point(index).map(|at| Held::new(index, place, at));
        }
        Ok(Next::Work)
    }

    /// Follows the mouse with the point that it holds, in the plane of the picture, and drops it. A point
    /// that has not been moved was only chosen.
    async fn drag(&mut self, desk: &mut Desk<'_>, tick: &Tick) -> Asked<()> {
        let Some(held) = &mut self.held else { return Ok(()) };
        match held.follow(tick, self.viewer.look) {
            Grip::Holding => {}
            Grip::LetGo => self.held = None,
            Grip::Dropped => {
                let (unmoved, index) = (held.unmoved(), held.index);
                let moved = self.preview();
                self.held = None;
                if unmoved {
                    return self.change(desk, Some(index)).await;
                }
                self.history.change(moved);
                self.changed();
            }
        }
        Ok(())
    }

    /// The model as it would be if the held point were dropped now.
    fn preview(&self) -> Model {
        let now = self.history.now();
        match self.held {
            Some(held) => now.moved(&self.plan, held.index, held.at),
            None => now.clone(),
        }
    }

    /// Says what a key has switched.
    fn say(&self, desk: &mut Desk<'_>, text: impl Into<Phrase>) {
        desk.tell(text, Stay::Briefly);
    }
}
