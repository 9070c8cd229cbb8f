//! The program while it runs: the state with its history, what goes on by itself, and the view.

use super::commands::COMMANDS;
use super::reading::Found;
use super::run::{self, FRAME, Run};
use super::state::{Fit, Named, Rescued, Source, State, Surface};
use super::{gauges, model, paint, texts};
use crate::design::knots;
use crate::editor::net::{Display, Drawn, Inspection, Section};
use crate::figure::Figure;
use crate::file::{Document, Format, KnotNet, SPACE_VIEW};
use crate::geometry::fit::{self, Fitted, Stage};
use crate::geometry::kohonen::{Learning, Net};
use crate::geometry::{BoundingBox, ParamSurface, Point};
use crate::machine::{Asked, Asking, Button, Key, Language, Machine, Manner};
use crate::screen::{Color, Screen};
use crate::ui::look::{Look, Poles, Viewer};
use crate::ui::{Desk, Hint, Manual, Phrase, Picture, Stay, Words};
use crate::work::{self, History, Next, Work, common_key};
use serde::Serialize;
use std::rc::Rc;
use std::time::Duration;

/// From where a plane cloud is seen: x to the right, y up.
const FROM_ABOVE: Point<3> = [0.0, -1e-12, 1.0];
/// Grid cells that a surface is drawn with along its longer direction.
const CELLS: usize = 48;
const MOST_STEPS: usize = 6;

/// What of cloud and net is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Shown {
    Both,
    Points,
    Net,
}

/// What the user chooses to see.
#[derive(Clone, Copy, Debug)]
pub(super) struct Options {
    pub(super) shown: Shown,
    pub(super) errors: bool,
    pub(super) inspection: Inspection,
    pub(super) section: Option<Section>,
    pub(super) display: Display,
    /// The picture alone.
    pub(super) alone: bool,
}

/// The program's state.
pub(super) struct Trainer {
    pub(super) history: History<State>,
    /// The state while a panel is open.
    pub(super) trial: Option<State>,
    pub(super) run: Run,
    /// When the next picture of it is due.
    pub(super) due: Duration,
    pub(super) now: Duration,
    pub(super) viewer: Viewer,
    pub(super) options: Options,
    /// The surface of a fit that goes on.
    live: Option<Rc<Surface>>,
    /// The surface that is drawn, with what it is drawn from.
    drawn: Option<(Rc<Surface>, Rc<Drawn>)>,
    /// What is to be said at the next opportunity.
    said: Option<(Phrase, Stay)>,
    /// The name of the file that was opened at the start, and of a cloud that is to be read.
    file: String,
    pub(super) pending: Option<String>,
    pub(super) manner: Manner,
}

/// Whether the program opens a document.
///
/// # Errors
/// Why it does not.
pub(super) fn check(document: &Document) -> Result<(), Phrase> {
    match document {
        // Its points have been checked when they were read.
        Document::Cloud(_) => Ok(()),
        other => State::opened(other, "").map(|_| ()),
    }
}

/// Works until the end.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub(super) async fn run(machine: &mut Machine, manual: Manual, document: Option<Document>) -> Asked<()> {
    let mut trainer = Trainer::new(State::fresh());
    trainer.file = machine.file().unwrap_or_default().to_owned();
    trainer.manner = machine.manner();
    work::run(trainer, &mut Desk::new(machine, manual), document).await
}

impl Trainer {
    fn new(state: State) -> Trainer {
        let mut trainer = Trainer {
            history: History::new(state),
            trial: None,
            run: Run::Nothing,
            due: Duration::ZERO,
            now: Duration::ZERO,
            viewer: Viewer::new(Look::new(SPACE_VIEW, Poles::Cross)),
            options: Options {
                shown: Shown::Both,
                errors: true,
                inspection: Inspection::Off,
                section: None,
                display: Display::Wire,
                alone: false,
            },
            live: None,
            drawn: None,
            said: None,
            file: String::new(),
            pending: None,
            manner: Manner::default(),
        };
        trainer.look_at_cloud();
        trainer
    }

    /// The state that is shown.
    pub(super) fn state(&self) -> &State {
        self.trial.as_ref().unwrap_or_else(|| self.history.now())
    }

    /// The learning that is shown.
    pub(super) fn learning(&self) -> Option<&Learning> {
        match &self.run {
            Run::Learning(learning) => Some(learning),
            Run::Slow(slow) => Some(&slow.learning),
            _ => self.state().learning.as_deref(),
        }
    }

    /// The net that is shown.
    pub(super) fn net(&self) -> Option<&Net> {
        match &self.run {
            Run::Learning(learning) => Some(learning.net()),
            Run::Slow(slow) => Some(slow.learning.net()),
            _ => self.state().net.as_deref(),
        }
    }

    /// The surface that is shown; there is none of a net that is learning.
    pub(super) fn surface(&self) -> Option<&Rc<Surface>> {
        match &self.run {
            Run::Learning(_) | Run::Slow(_) => None,
            Run::Fitting(_) => self.live.as_ref().or(self.state().surface.as_ref()),
            Run::Nothing | Run::Reading(_) => self.state().surface.as_ref(),
        }
    }

    /// What it is drawn from.
    pub(super) fn drawn(&self) -> Option<&Rc<Drawn>> {
        let surface = self.surface()?;
        self.drawn.as_ref().filter(|(of, _)| Rc::ptr_eq(of, surface)).map(|(_, drawn)| drawn)
    }

    /// Looks at all of a new cloud, or of a net without one.
    pub(super) fn look_at_cloud(&mut self) {
        let state = self.state();
        let bounds = match (&state.cloud, &state.net) {
            (Some(named), _) => Some(named.cloud.bounds()),
            (None, Some(net)) => BoundingBox::around(net.rows().into_iter().flatten()),
            (None, None) => None,
        };
        let above = state.cloud.as_ref().is_some_and(|named| named.is_plane());
        let look = Look::new(if above { FROM_ABOVE } else { SPACE_VIEW }, Poles::Cross);
        self.viewer = Viewer::new(bounds.map_or(look, |bounds| look.framing(&bounds)));
    }

    /// Begins something that goes on by itself.
    pub(super) fn begin(&mut self, run: Run) {
        self.live = None;
        self.run = run;
        self.due = self.now + FRAME;
    }

    /// Says something when there is a desk to say it at.
    pub(super) fn say(&mut self, text: impl Into<Phrase>, stay: Stay) {
        self.said = Some((text.into(), stay));
    }

    /// Ends what goes on and keeps what there is; whether anything went on, and what is to be said about it.
    pub(super) fn stop(&mut self) -> Option<Words> {
        match std::mem::take(&mut self.run) {
            Run::Nothing => None,
            Run::Learning(learning) => {
                self.keep_learnt(*learning);
                Some(texts::STOPPED)
            }
            Run::Slow(slow) => {
                self.keep_learnt(slow.learning);
                Some(texts::STOPPED)
            }
            Run::Fitting(_) => {
                if let Some(surface) = self.live.take() {
                    self.history.change(self.history.now().with_surface(surface));
                }
                Some(texts::FIT_STOPPED)
            }
            Run::Reading(_) => Some(texts::READING_STOPPED),
        }
    }

    fn keep_learnt(&mut self, learning: Learning) {
        if learning.total() > 0 {
            self.history.change(self.history.now().with_learning(learning));
        }
    }

    /// Advances what goes on if a picture is due.
    fn advance(&mut self) {
        if matches!(self.run, Run::Nothing) || self.now < self.due {
            return;
        }
        self.due = self.now + FRAME;
        match std::mem::take(&mut self.run) {
            Run::Nothing => {}
            Run::Learning(mut learning) => match run::learn(&mut learning) {
                None => self.run = Run::Learning(learning),
                Some(end) => {
                    let told = texts::learnt(end, learning.total());
                    self.keep_learnt(*learning);
                    self.say(told, Stay::Briefly);
                }
            },
            Run::Slow(slow) if slow.part(self.now) < run::PARTS => self.run = Run::Slow(slow),
            Run::Slow(slow) => self.keep_learnt(slow.learning),
            Run::Fitting(fit) => self.advance_fit(fit),
            Run::Reading(mut reading) => match reading.advance() {
                Ok(false) => self.run = Run::Reading(reading),
                Ok(true) => {
                    let name = reading.name.clone();
                    match reading.finish() {
                        Ok(found) => self.take_cloud(found, name),
                        Err(problem) => self.say(problem, Stay::UntilRead),
                    }
                }
                Err(problem) => self.say(problem, Stay::UntilRead),
            },
        }
    }

    fn advance_fit(&mut self, mut fit: Box<fit::Fit>) {
        let Some(named) = self.history.now().cloud.clone() else { return };
        let before = fit.stage();
        if let Some(report) = run::fit(&mut fit, &named.cloud) {
            match fit.fitted() {
                Ok(fitted) => {
                    let told = texts::fitted(&report);
                    let distances = fit.distances().to_vec();
                    let surface =
                        Rc::new(Surface { fitted, base: false, fit: Some(Fit { report, distances }) });
                    self.history.change(self.history.now().with_surface(surface));
                    self.options.shown = Shown::Points;
                    self.say(told, Stay::UntilRead);
                }
                Err(error) => self.say(texts::fit_problem(&error), Stay::UntilRead),
            }
            self.live = None;
            return;
        }
        if fit.stage() == Stage::Correction && before != Stage::Correction {
            self.live = fit.fitted().ok().map(|fitted| Rc::new(Surface { fitted, base: false, fit: None }));
        }
        self.run = Run::Fitting(fit);
    }

    /// Takes up the cloud of a file.
    fn take_cloud(&mut self, found: Found, name: String) {
        let named = Named { cloud: found.cloud, source: Source::File(name) };
        self.history.change(self.history.now().with_cloud(named));
        self.options.shown = Shown::Both;
        self.look_at_cloud();
        self.say(found.told, Stay::Briefly);
    }

    /// Reads a piece at once, so that small files are there without waiting.
    pub(super) fn read_on(&mut self) {
        for _ in 0..2 {
            self.due = self.now;
            self.advance();
        }
    }

    /// Makes what the shown surface is drawn from.
    pub(super) fn refresh(&mut self) {
        let Some(surface) = self.surface().cloned() else {
            self.drawn = None;
            return;
        };
        if self.drawn.as_ref().is_some_and(|(of, _)| Rc::ptr_eq(of, &surface)) {
            return;
        }
        let drawn = surface.fitted.surface().and_then(|knots| {
            let [u, v] = knots.spans();
            let steps = (CELLS / u.max(v).max(1)).clamp(1, MOST_STEPS);
            Drawn::of(Box::new(knots.clone()), steps).ok()
        });
        self.drawn = drawn.map(|drawn| (surface, Rc::new(drawn)));
    }
}

impl Picture for Trainer {
    fn draw(&self, screen: &mut Screen, language: Language) {
        if self.options.alone {
            screen.clear(Color::Black);
            paint::paint(self, screen, language);
            paint::draw_alone(self, screen, language);
            return;
        }
        paint::ground(screen);
        paint::paint(self, screen, language);
        paint::surroundings(screen);
        gauges::draw(self, screen, language);
        COMMANDS.draw(screen, language);
    }

    fn figure(&self) -> Option<Figure> {
        paint::figure(self)
    }

    fn surfaces(&self) -> Vec<Box<dyn ParamSurface>> {
        let surface = self.surface().and_then(|surface| surface.fitted.surface());
        surface.map(|surface| Box::new(surface.clone()) as Box<dyn ParamSurface>).into_iter().collect()
    }

    /// The surface or the curve.
    fn exported(&self) -> Option<Document> {
        Some(match &self.surface()?.fitted {
            Fitted::Surface(surface) => Document::KnotNet(Box::new(KnotNet::of(surface))),
            Fitted::Curve(curve) => knots::document(curve).into(),
        })
    }

    fn hint(&self) -> Option<Hint> {
        if self.options.alone || !matches!(self.run, Run::Nothing) || self.net().is_some() {
            return None;
        }
        Some(Hint::new(if self.state().cloud.is_some() { texts::HINT_CLOUD } else { texts::HINT_EMPTY }))
    }
}

impl Work for Trainer {
    type Value = State;

    const SAVED: Option<Words> = Some(texts::SAVED);

    fn format(&self) -> Format {
        Format::Som
    }

    fn saved_as(&self) -> Option<Format> {
        Some(Format::Som)
    }

    fn extensions(&self) -> Vec<&'static str> {
        let clouds = [Format::Xyz, Format::Ply, Format::Obj, Format::Stl].map(Format::extension);
        [Format::Som.extension()].into_iter().chain(clouds).chain(["CSV"]).collect()
    }

    fn history(&mut self) -> &mut History<State> {
        &mut self.history
    }

    /// Only nets are saved.
    fn unsaved(&mut self) -> bool {
        let learns = matches!(self.run, Run::Learning(_) | Run::Slow(_));
        learns || (self.history.unsaved() && self.history.now().net.is_some())
    }

    fn reset(&mut self) {
        *self = Trainer { manner: self.manner, now: self.now, ..Trainer::new(State::fresh()) };
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        let state = State::opened(document, &self.file)?;
        *self = Trainer { manner: self.manner, now: self.now, ..Trainer::new(state) };
        if let Document::Cloud(cloud) = document {
            let name = self.file.clone();
            self.say(texts::file_told(&name, cloud), Stay::Briefly);
        }
        Ok(())
    }

    fn document(&self) -> Result<Document, Phrase> {
        let net = self.history.now().som().ok_or(Phrase::from(texts::NO_NET))?;
        Ok(Document::Som(Box::new(net)))
    }

    fn model(&self) -> impl Serialize + 'static {
        model::of(self)
    }

    fn settle(&mut self) {
        self.trial = None;
        self.stop();
    }

    async fn ask_first(&mut self, _: &mut Desk<'_>) -> Asked<bool> {
        Ok(true)
    }

    fn look(&mut self, desk: &Desk<'_>) {
        (self.now, self.manner) = (desk.clock(), desk.machine.manner());
        self.advance();
        self.refresh();
    }

    fn due(&self) -> Option<Duration> {
        (!matches!(self.run, Run::Nothing)).then(|| self.due.saturating_sub(self.now))
    }

    async fn work(&mut self, desk: &mut Desk<'_>) -> Asked<Next> {
        if let Some(name) = self.pending.take() {
            self.read_file(desk, &name);
        }
        self.viewer.stop();
        loop {
            if let Some((text, stay)) = self.said.take() {
                desk.tell(text, stay);
            }
            let tick = work::event(self, desk).await?;
            if self.viewer.look_around(&tick) {
                continue;
            }
            if tick.pressed(Key::Esc) {
                if let Some(said) = self.stop() {
                    desk.tell(said, Stay::Briefly);
                    continue;
                }
                if self.options.alone {
                    self.options.alone = false;
                    continue;
                }
            }
            if matches!(tick.key(), Some(Key::Ctrl('Z' | 'Y' | 'S'))) {
                self.stop();
            }
            if common_key(self, desk, tick.key()).await? {
                continue;
            }
            let action = match self.options.alone {
                true => self.alone(&tick),
                false => COMMANDS.find(&tick),
            };
            match action {
                Some(action) => {
                    let next = self.obey(desk, action).await.unless_cancelled()?.unwrap_or(Next::Work);
                    self.trial = None;
                    if next != Next::Work {
                        return Ok(next);
                    }
                }
                // The ground is turned, as in the surface editor.
                None => {
                    let at = tick.click().filter(|at| self.manner == Manner::Today && self.on_picture(*at));
                    if let Some(at) = at {
                        self.viewer.turn(at, Button::Left);
                    }
                }
            }
        }
    }

    fn unsaved_work(&self) -> Result<String, Phrase> {
        serde_json::to_string(&Rescued::of(self.history.now())).map_err(|error| Phrase::plain(&error))
    }

    fn take_up(&mut self, work: &str) -> Result<(), Phrase> {
        let rescued: Rescued = serde_json::from_str(work).map_err(|error| Phrase::plain(&error))?;
        let (state, file) = rescued.state()?;
        *self = Trainer { manner: self.manner, now: self.now, ..Trainer::new(state) };
        self.pending = file;
        Ok(())
    }
}
