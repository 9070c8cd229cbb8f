//! The program while it runs: the state with its history, what goes on by itself, and the view.

use super::reading::Found;
use super::run::{self, FRAME, Run};
use super::state::{Fit, Named, Source, State, Surface};
use super::texts;
use crate::editor::net::{Display, Drawn, Inspection, Section};
use crate::file::{Document, SPACE_VIEW};
use crate::geometry::fit::{self, Stage};
use crate::geometry::kohonen::{Learning, Net};
use crate::geometry::{BoundingBox, ParamSurface, Point};
use crate::machine::{Asked, Machine, Manner};
use crate::ui::look::{Look, Poles, Viewer};
use crate::ui::{Desk, Manual, Phrase, Stay, Words};
use crate::work::{self, History};
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
    pub(super) said: Option<(Phrase, Stay)>,
    /// The name of the file that was opened at the start, and of a cloud that is to be read.
    pub(super) file: String,
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

    /// The program with another state that needs no saving.
    pub(super) fn anew(&self, state: State) -> Trainer {
        Trainer { manner: self.manner, now: self.now, file: self.file.clone(), ..Trainer::new(state) }
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
    pub(super) fn advance(&mut self) {
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
                Err(error) => self.say(Phrase::plain(&error), Stay::UntilRead),
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
