//! Commands of the curve editors that ask questions, and what is shown beside the communication page.

use super::ask::{METHODS, ask_closure, ask_coefficient, ask_method};
use super::tables::Action;
use super::{Ambient, Curves, Tools, beta};
use crate::design::{Place, Sketch};
use crate::editor::picture::{Layer as Part, Page};
use crate::editor::stage::Stage;
use crate::editor::{Editor, refusal};
use crate::geometry::Point;
use crate::machine::{Asked, Manner};
use crate::screen::Color;
use crate::ui::words;
use crate::ui::{Area, Desk, Stay};
use crate::work::{Next, quit};
use serde::Serialize;
use std::borrow::Cow;

/// Where the coefficient of the tangents is shown: on the page, and left of it where tangents can be set.
pub(super) const NOTE_AT: (i32, i32) = (262, 23);
pub(super) const TANGENTS_NOTE_AT: (i32, i32) = (65, 43);

/// The coefficient of the tangents as it is shown.
pub(super) fn k0_note(k0: f64) -> String {
    format!("k0 = {k0:.2}")
}

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// Carries out a command. After some of them the original offers automatic tangents.
    pub(super) async fn carry_out(&mut self, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        use Action::{Change, Choose, Delete, Insert, Result as Show};
        let offers = matches!(action, Insert | Change | Delete | Choose | Show);
        self.craft.offer = offers.then_some(Stage::Offering);
        match action {
            Action::Insert => self.insert(desk).await?,
            Action::Change => self.change_point(desk).await?,
            Action::Delete => self.delete(desk).await?,
            Action::DeleteHere => self.delete_at(desk),
            Action::Choose => self.choose_curve(desk).await?,
            Action::Result => self.show_result(desk).await?,
            Action::Bias => {
                let bias = beta::ask_bias(desk, self).await?;
                self.reshape(desk, self.history.now().with_shape(|shape| shape.bias = bias));
            }
            Action::Tension => {
                let tension = beta::ask_tension(desk, self).await?;
                self.reshape(desk, self.history.now().with_shape(|shape| shape.tension = tension));
            }
            Action::K0 => self.change_k0(desk).await?,
            Action::Follow => self.toggle_follow(desk),
            Action::Compare => self.compare(desk).await?,
            Action::Series => self.ask_series(desk).await?,
            Action::Workshop => self.open_workshop(desk).await?,
            Action::ShapeJoint => self.change_joint(desk).await?,
            Action::JointsAlike => self.make_joints_alike(desk),
            Action::Polygon => self.switch_polygon(desk),
            Action::Weights => self.switch_weights(desk),
            Action::Contacts => self.switch_joints(desk),
            Action::Smooth => self.toggle_smooth(desk),
            Action::Own(command) => return self.obey_layer(desk, command).await,
            Action::Quit => {
                let next = quit(self, desk).await?;
                if Curves::<D>::STORE.is_none() {
                    self.shown.after_change();
                }
                return Ok(next);
            }
        }
        Ok(Next::Work)
    }

    /// The command G: the curve's form and method.
    async fn choose_curve(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.count() < self.fewest() {
            desk.tell(words::TOO_FEW, Stay::Briefly);
            return Ok(());
        }
        self.stage = Stage::Choosing;
        self.forget_note();
        let mut sketch = self.history.now().clone();
        sketch.settings.closed = Some(ask_closure(desk, self).await?);
        let mut note = None;
        match self.craft.tools.implied() {
            // The program's method replaces the one that the document names.
            Some(method) => sketch.settings.method = sketch.settings.method.map(|_| method),
            None => {
                let chosen = ask_method(desk, self).await?;
                chosen.put_into(&mut sketch);
                note = chosen.k0.map(k0_note);
            }
        }
        let method = sketch.method().or(self.craft.tools.implied()).or(self.craft.usual);
        if let Some(Err(error)) = method.map(|method| sketch.by(method).curve()) {
            if Curves::<D>::STORE.is_none() {
                self.shown.take(false);
            }
            desk.tell(refusal::of_curve(&error), Stay::UntilRead);
            return Ok(());
        }
        self.history.change(sketch);
        self.shown.take(true);
        self.craft.note = note.or(self.craft.note.take());
        Ok(())
    }

    /// Another coefficient of the automatic tangents; where tangents can be set, it is part of the offer.
    async fn change_k0(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.craft.tools == Tools::Tangents {
            self.stage = Stage::Offering;
            return self.offer_automatic_tangents(desk).await;
        }
        let k0 = ask_coefficient(desk, self).await?;
        let mut sketch = self.history.now().clone();
        sketch.settings.k0 = Some(k0);
        self.reshape(desk, sketch);
        self.craft.note = Some(k0_note(k0));
        Ok(())
    }

    /// The value that is shown at a pixel, as the command that changes it.
    pub(super) fn value_shown_at(&self, at: (i32, i32)) -> Option<Action> {
        let note = match self.craft.tools {
            Tools::Methods => NOTE_AT,
            Tools::Tangents => TANGENTS_NOTE_AT,
            Tools::Own => return None,
            Tools::Beta => return beta::value_at(at, [Action::Bias, Action::Tension]),
        };
        let letters = i32::try_from(self.note(self.history.now())?.chars().count()).ok()?;
        Area::of_line(note, letters).holds(at.0, at.1).then_some(Action::K0)
    }

    /// The key F3: switches whether the curve follows changes, and says so.
    fn toggle_follow(&mut self, desk: &mut Desk<'_>) {
        let shown = &mut self.shown;
        shown.follow = !shown.follow;
        shown.visible = shown.follow && shown.known;
        desk.tell(if shown.follow { words::FOLLOWS } else { words::FOLLOWS_NOT }, Stay::Briefly);
    }

    /// What is said of the curve beside the page. In the manner of today k0 is the value that the sketch has now: one that
    /// was answered earlier may have been undone.
    fn note(&self, sketch: &Sketch<D>) -> Option<Cow<'_, str>> {
        if self.manner != Manner::Today {
            return self.craft.note.as_deref().map(Cow::from);
        }
        let has = self.shows_k0() || (self.craft.tools == Tools::Tangents && self.has_automatic_tangents());
        has.then(|| k0_note(sketch.k0()).into())
    }

    /// Draws what is shown on the communication page and to its left.
    pub(super) fn draw_titles(&self, page: &mut Page<'_>) {
        let preview = self.preview();
        let note = self.note(&preview).unwrap_or_default();
        let note = note.as_ref();
        let language = page.language;
        match self.craft.tools {
            Tools::Methods => {
                let chosen = self.stage == Stage::Choosing;
                let color = if chosen { Color::LightMagenta } else { Color::Black };
                page.screen.text(28, 5, words::METHOD_TITLE.of(language), color);
                page.screen.text(NOTE_AT.0, NOTE_AT.1, note, Color::Black);
                METHODS.iter().for_each(|button| button.draw(page.screen, language));
            }
            Tools::Tangents => {
                page.screen.text(20, 20, words::COONS_TITLE.of(language), Color::Black);
                page.screen.text(134, 10, words::COONS_ACCENTS.of(language), Color::Black);
                page.screen.text(TANGENTS_NOTE_AT.0, TANGENTS_NOTE_AT.1, note, Color::Black);
            }
            Tools::Own => self.paint_layer(Part::Titles, page),
            Tools::Beta => beta::draw_values(page.screen, self.shape_turned(&self.preview()), language),
        }
        if self.craft.tools != Tools::Methods || note.is_empty() {
            self.draw_names(page, (216, 10), Color::Black);
        }
        self.draw_dials(page);
    }
}
