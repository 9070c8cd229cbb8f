//! What the program shows, and its life: the loop of events, saving and rescue.

use super::commands::COMMANDS;
use super::run::Run;
use super::state::{Rescued, State};
use super::trainer::Trainer;
use super::{gauges, model, paint, texts};
use crate::design::knots;
use crate::figure::Figure;
use crate::file::{Document, Format, KnotNet};
use crate::geometry::ParamSurface;
use crate::geometry::fit::Fitted;
use crate::machine::{Asked, Asking, Button, Key, Language, Manner};
use crate::screen::{Color, Screen};
use crate::ui::{Desk, Hint, Phrase, Picture, Stay, Words};
use crate::work::{self, History, Next, Work, common_key};
use serde::Serialize;
use std::time::Duration;

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
        *self = self.anew(State::fresh());
    }

    fn open(&mut self, document: &Document) -> Result<(), Phrase> {
        let state = State::opened(document, &self.file)?;
        *self = self.anew(state);
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
        *self = self.anew(state);
        self.pending = file;
        Ok(())
    }
}
