//! What the commands of SOM_FEL do.

use super::commands::Action;
use super::panels;
use super::reading::Reading;
use super::run::{Run, Slow};
use super::state::{State, Surface};
use super::texts;
use super::trainer::{Shown, Trainer};
use crate::editor::net::{Display, Section};
use crate::file::Format;
use crate::geometry::fit::{Fit, Fitted};
use crate::geometry::kohonen::{Learning, MAX_NEURONS, Net};
use crate::machine::{Asked, Key, Manner, Tick};
use crate::ui::{Desk, Phrase, Stay};
use crate::work::{self, Next, quit, read_document};
use std::rc::Rc;

/// The proposed limit of a growing net.
const LIMIT: u64 = 400;
/// The most corrections of a fit.
const MOST_CORRECTIONS: u64 = 1000;

impl Trainer {
    /// What a key means in the picture alone.
    pub(super) fn alone(&mut self, tick: &Tick) -> Option<Action> {
        match tick.letter() {
            Some('D') => self.options.display = Display::Wire,
            Some('T') => self.options.display = Display::Filled,
            _ => {}
        }
        match tick.key()? {
            Key::F(3) => Some(Action::Shown),
            Key::F(4) => Some(Action::Errors),
            Key::F(5) => Some(Action::Colours),
            Key::F(6) => Some(Action::Section),
            Key::Char('+') => Some(Action::Up),
            Key::Char('-') => Some(Action::Down),
            _ => None,
        }
    }

    /// Carries out a command. What changes cloud, net or surface first ends what goes on.
    pub(super) async fn obey(&mut self, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        let learning = matches!(self.run, Run::Learning(_));
        match action {
            Action::Shown | Action::Errors | Action::Colours | Action::Section => {
                self.look_otherwise(desk, action);
            }
            Action::Up | Action::Down => {
                let look = self.viewer.look;
                self.options.section =
                    self.options.section.map(|section| section.moved(action == Action::Up, look));
            }
            Action::Display => {
                self.options.display = match self.options.display {
                    Display::Wire => Display::Filled,
                    Display::Filled => Display::Wire,
                };
            }
            Action::Mirror => desk.tell(texts::NO_MIRROR, Stay::Briefly),
            Action::Result => self.options.alone = true,
            Action::Learn => {
                self.stop();
                if !learning {
                    self.begin_to_learn(desk);
                }
            }
            Action::Step => {
                self.stop();
                self.step_slowly(desk);
            }
            Action::Grow => {
                self.stop();
                self.grow(desk).await?;
            }
            Action::Surface => {
                self.stop();
                self.switch_surface(desk);
            }
            Action::Fit => {
                self.stop();
                self.fit(desk).await?;
            }
            Action::File => {
                self.stop();
                let name = self.ask_file(desk).await?;
                self.read_file(desk, &name);
            }
            Action::Cloud => {
                self.stop();
                panels::ask_cloud(self, desk).await?;
            }
            Action::Net => {
                self.stop();
                panels::ask_net(self, desk).await?;
            }
            Action::Quit => {
                self.stop();
                return quit(self, desk).await;
            }
        }
        Ok(Next::Work)
    }

    /// The commands that only change what is seen.
    fn look_otherwise(&mut self, desk: &mut Desk<'_>, action: Action) {
        match action {
            Action::Shown => {
                let (next, at) = match self.options.shown {
                    Shown::Both => (Shown::Points, 1),
                    Shown::Points => (Shown::Net, 2),
                    Shown::Net => (Shown::Both, 0),
                };
                self.options.shown = next;
                desk.tell(texts::SHOWN[at], Stay::Briefly);
            }
            Action::Errors => {
                if self.surface().is_none_or(|surface| surface.fit.is_none()) {
                    desk.tell(texts::NO_ERRORS, Stay::UntilRead);
                } else {
                    self.options.errors = !self.options.errors;
                }
            }
            _ => {
                let Some(surface) = self.surface() else {
                    return desk.tell(texts::NO_SURFACE, Stay::UntilRead);
                };
                if surface.fitted.surface().is_none() {
                    return desk.tell(texts::A_CURVE, Stay::UntilRead);
                }
                if action == Action::Section {
                    self.options.section = Section::next(self.options.section, self.viewer.look);
                    return;
                }
                self.options.inspection = self.options.inspection.next(false);
                if let Some(name) = self.options.inspection.name() {
                    desk.tell(name, Stay::Briefly);
                }
            }
        }
    }

    /// The learning that goes on, or a new one.
    fn to_learn(&self) -> Result<Learning, Phrase> {
        let state = self.history.now();
        if let Some(problem) = state.unlearnable() {
            return Err(problem);
        }
        let going = state.learning.as_deref().filter(|learning| learning.end().is_none());
        if let Some(learning) = going {
            return Ok(learning.clone());
        }
        let cloud = state.cloud().ok_or(Phrase::from(texts::NO_CLOUD))?;
        let start = state.settings.start(cloud).map_err(|error| Phrase::plain(&error))?;
        Learning::new(cloud, start, state.settings.rule()).map_err(|error| Phrase::plain(&error))
    }

    fn begin_to_learn(&mut self, desk: &mut Desk<'_>) {
        match self.to_learn() {
            Ok(learning) => {
                self.options.shown = Shown::Both;
                self.begin(Run::Learning(Box::new(learning)));
            }
            Err(problem) => desk.tell(problem, Stay::UntilRead),
        }
    }

    fn step_slowly(&mut self, desk: &mut Desk<'_>) {
        match self.to_learn() {
            Ok(mut learning) => {
                let before = learning.net().clone();
                learning.advance(1);
                self.options.shown = Shown::Both;
                self.begin(Run::Slow(Box::new(Slow { learning, before, begun: self.now })));
            }
            Err(problem) => desk.tell(problem, Stay::UntilRead),
        }
    }

    async fn grow(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let state = self.history.now().clone();
        if let Some(problem) = state.unlearnable() {
            desk.tell(problem, Stay::UntilRead);
            return Ok(());
        }
        let Some(named) = &state.cloud else { return Ok(()) };
        if state.settings.size.contains(&1) {
            desk.tell(texts::NO_GROWTH, Stay::UntilRead);
            return Ok(());
        }
        let (topology, seed) = (state.settings.topology(), state.settings.seed.into());
        let seedling = match Net::seedling(&named.cloud, topology, seed) {
            Ok(seedling) => seedling,
            Err(error) => {
                desk.tell(Phrase::plain(&error), Stay::UntilRead);
                return Ok(());
            }
        };
        let learning = desk
            .meaning(&*self, texts::LIMIT, &LIMIT.to_string(), |text| {
                let limit = whole(text, [1, MAX_NEURONS as u64])?;
                Learning::growing(&named.cloud, seedling.clone(), limit as usize, seed)
                    .map_err(|error| Phrase::plain(&error))
            })
            .await?;
        self.options.shown = Shown::Both;
        self.begin(Run::Learning(Box::new(learning)));
        Ok(())
    }

    /// The command S: the surface that has the neurons as control points, or none again.
    fn switch_surface(&mut self, desk: &mut Desk<'_>) {
        let state = self.history.now();
        let Some(net) = &state.net else { return desk.tell(texts::NO_NET, Stay::UntilRead) };
        let base = state.surface.as_ref().is_some_and(|surface| surface.base);
        if base {
            return self.history.change(State { surface: None, ..state.clone() });
        }
        match Fitted::of_net(net) {
            Ok(fitted) => {
                let surface = Rc::new(Surface { fitted, base: true, fit: None });
                self.history.change(state.with_surface(surface));
                self.warn_of_no_area(desk);
            }
            Err(error) => desk.tell(Phrase::plain(&error), Stay::UntilRead),
        }
    }

    fn warn_of_no_area(&mut self, desk: &mut Desk<'_>) {
        self.refresh();
        if self.drawn().is_some_and(|drawn| !drawn.has_area()) {
            desk.tell(texts::COLLAPSED, Stay::UntilRead);
        }
    }

    async fn fit(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let state = self.history.now().clone();
        let (cloud, net) = match (state.cloud(), &state.net) {
            (Some(cloud), Some(net)) => (cloud, net),
            (None, _) => {
                desk.tell(texts::NO_CLOUD, Stay::UntilRead);
                return Ok(());
            }
            (_, None) => {
                desk.tell(texts::NO_NET, Stay::UntilRead);
                return Ok(());
            }
        };
        // What cannot be fitted is said before the question.
        if let Err(error) = Fit::new(cloud, net, 0) {
            desk.tell(Phrase::plain(&error), Stay::UntilRead);
            return Ok(());
        }
        let proposal = Fit::CORRECTIONS.to_string();
        let corrections = desk
            .meaning(&*self, texts::CORRECTIONS, &proposal, |text| whole(text, [0, MOST_CORRECTIONS]))
            .await?;
        match Fit::new(cloud, net, corrections as usize) {
            Ok(fit) => self.begin(Run::Fitting(Box::new(fit))),
            Err(error) => desk.tell(Phrase::plain(&error), Stay::UntilRead),
        }
        Ok(())
    }

    async fn ask_file(&self, desk: &mut Desk<'_>) -> Asked<String> {
        if desk.machine.manner() == Manner::Today {
            return work::choose_file(self, desk).await;
        }
        let name = desk.text(self, texts::FILE_NAME, "").await?.trim().to_uppercase();
        Ok(if name.contains('.') { name } else { format!("{name}.XYZ") })
    }

    /// Opens a net, or begins to read a cloud.
    pub(super) fn read_file(&mut self, desk: &mut Desk<'_>, name: &str) {
        if Format::from_name(name) == Some(Format::Som) {
            let read = read_document(desk.machine.storage(), name, Format::Som)
                .and_then(|document| State::opened(&document, name));
            match read {
                Ok(opened) => {
                    // The cloud stays, so that a surface of this net can be fitted to it.
                    let cloud = self.history.now().cloud.clone();
                    self.history.change(State { cloud, ..opened });
                    self.options.shown = Shown::Both;
                    desk.machine.set_file(Some(name.to_owned()));
                }
                Err(problem) => desk.tell(problem, Stay::UntilRead),
            }
            return;
        }
        match Reading::begin(desk.machine.storage(), name) {
            Ok(reading) => {
                self.begin(Run::Reading(Box::new(reading)));
                self.read_on();
            }
            Err(problem) => desk.tell(problem, Stay::UntilRead),
        }
    }
}

/// A whole number in a range.
fn whole(text: &str, [low, high]: [u64; 2]) -> Result<u64, Phrase> {
    let number: u64 = text.trim().parse().map_err(|_| Phrase::from(texts::NO_WHOLE))?;
    if (low..=high).contains(&number) { Ok(number) } else { Err(texts::between(low, high)) }
}
