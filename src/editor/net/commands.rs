//! The commands of the surface editor.

use super::ask::ask_display;
use super::model::{Index, Model, Part};
use super::plan::{Family, Form};
use super::surface::Display;
use super::{Editor, Stage};
use crate::editor::beta::{BIAS, TENSION};
use crate::editor::choice::ask_real;
use crate::editor::place::{ask_height, ask_place};
use crate::geometry::{Border, RefineDirection, refine};
use crate::machine::{Asked, Asking, Key, Stop};
use crate::ui::words::{self, Phrase, Words};
use crate::ui::{Desk, Stay};
use crate::work::{Next, event, quit};
use std::ops::RangeInclusive;

/// What the coefficient of the tangents may be.
const K0: RangeInclusive<f64> = 0.0..=1.0;

impl Editor {
    /// Carries out the command of a letter; other letters do nothing.
    pub(super) async fn obey(&mut self, desk: &mut Desk<'_>, letter: char) -> Asked<Next> {
        match (letter, self.plan.family) {
            ('V', _) => self.change(desk, None).await?,
            ('F', _) => self.show_surface(desk).await?,
            ('E', _) => self.show_result(desk).await?,
            ('A', Family::Beta) => {
                let entry = (words::BIAS_ENTRY, (232, 26));
                self.reshape(desk, entry, BIAS, |form| &mut form.bias).await?;
            }
            ('C', Family::Beta) => {
                let entry = (words::TENSION_ENTRY, (232, 26));
                self.reshape(desk, entry, TENSION, |form| &mut form.tension).await?;
            }
            ('C', Family::Local) => {
                let entry = (words::COEFFICIENT_ENTRY, (232, 26));
                self.reshape(desk, entry, K0, |form| &mut form.k0).await?;
            }
            ('Q', _) => {
                let next = quit(self, desk).await?;
                self.drawn = None;
                self.shown &= self.follow;
                return Ok(next);
            }
            _ => {}
        }
        Ok(Next::Work)
    }

    /// Carries out the command of a key beyond the original's; other keys do nothing.
    pub(super) async fn obey_key(&mut self, desk: &mut Desk<'_>, key: Key) -> Asked<Next> {
        match (key, self.plan.family) {
            (Key::F(3), _) => {
                self.follow = !self.follow;
                self.drawn = None;
                self.shown |= self.follow;
                let said = if self.follow { words::SURFACE_FOLLOWS } else { words::SURFACE_FOLLOWS_NOT };
                self.say(desk, said);
            }
            (Key::F(4), Family::BSpline) => {
                let border = match self.history.now().border {
                    Border::Doubled => Border::Reached,
                    Border::Reached => Border::Doubled,
                };
                self.change_surface(desk, Model { border, ..self.history.now().clone() });
                let reached = border == Border::Reached;
                self.say(desk, if reached { words::BORDER_REACHED } else { words::BORDER_DOUBLED });
            }
            (Key::F(7), family) if family != Family::Heights => {
                let axis = self.ask_axis(desk).await?;
                self.change_surface(desk, self.history.now().mirrored(axis));
            }
            (Key::F(7), _) => self.change_surface(desk, self.history.now().mirrored(2)),
            (Key::F(8), Family::BSpline | Family::Bezier | Family::Spline | Family::Heights) => {
                let direction = self.ask_direction(desk).await?;
                match self.refined(direction) {
                    Ok(model) => self.change_surface(desk, model),
                    Err(problem) => desk.tell(problem, Stay::UntilRead),
                }
            }
            _ => {}
        }
        Ok(Next::Work)
    }

    /// Takes another model; a surface that is in the picture stays there and follows.
    fn change_surface(&mut self, desk: &mut Desk<'_>, model: Model) {
        self.history.change(model);
        if self.drawn.is_some() {
            self.refresh(desk);
        }
    }

    fn refined(&self, direction: usize) -> Result<Model, Phrase> {
        let now = self.history.now();
        let Some(scheme) = self.plan.scheme(&now.form, self.degree, now.border) else {
            return Ok(now.clone());
        };
        let direction = if direction == 0 { RefineDirection::U } else { RefineDirection::V };
        let net = refine(scheme, &now.net, direction).map_err(|error| words::plain(&error))?;
        let model = Model { net, ..now.clone() };
        // The file is checked as if it were read: there is a largest size.
        Model::of_file(&self.plan, &model.to_file(&self.plan, self.degree, false), model.form)
            .map(|checked| Model { border: model.border, ..checked })
    }

    /// Takes the surface of the net as it is now into the picture; says why if there is none.
    fn refresh(&mut self, desk: &mut Desk<'_>) -> bool {
        match self.draw_up(self.history.now()) {
            Ok(drawn) => {
                if drawn.collapsed() {
                    self.say(desk, words::COLLAPSED);
                }
                self.drawn = Some(drawn);
                self.shown = true;
                true
            }
            Err(problem) => {
                self.drawn = None;
                self.shown = false;
                desk.tell(problem, Stay::UntilRead);
                false
            }
        }
    }

    /// The command V: another place for a control point, chosen by number or already.
    pub(super) async fn change(&mut self, desk: &mut Desk<'_>, index: Option<Index>) -> Asked<()> {
        self.changed();
        let index = match index {
            Some(index) => index,
            None => self.ask_index(desk).await?,
        };
        self.chosen = Some((index, Part::Place));
        let changed = self.ask_change(desk, index).await;
        self.chosen = None;
        self.history.change(changed?);
        Ok(())
    }

    /// Asks for another value of a control point.
    async fn ask_change(&mut self, desk: &mut Desk<'_>, index: Index) -> Asked<Model> {
        let part = match self.plan.family {
            Family::Hermite => self.ask_part(desk).await?,
            _ => Part::Place,
        };
        self.chosen = Some((index, part));
        let now = self.history.now();
        if self.plan.family == Family::Heights {
            let height = ask_height(desk, self, words::HEIGHT_TITLE).await?;
            // The index was chosen among those that the net has.
            let [x, y, _] = now.point(index).ok_or(Stop::Cancelled)?;
            return Ok(now.moved(&self.plan, index, [x, y, height]));
        }
        let value = ask_place(desk, self, part.title()).await?;
        Ok(now.with_part(&self.plan, index, part, value))
    }

    /// The command F: the surface instead of the net.
    async fn show_surface(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        match self.plan.family {
            Family::Heights => {}
            Family::BSpline => (self.degree, self.display) = self.ask_degree_and_display(desk).await?,
            _ => self.display = ask_display(desk, self).await?,
        }
        self.refresh(desk);
        Ok(())
    }

    /// The command E: the surface without its surroundings, to be looked at from all sides, until Esc.
    async fn show_result(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if !self.shown {
            desk.tell(words::NO_SURFACE, Stay::Briefly);
            return Ok(());
        }
        let asks = self.plan.family != Family::Heights;
        if asks {
            self.display = ask_display(desk, self).await?;
        }
        if !self.refresh(desk) {
            return Ok(());
        }
        self.stage = Stage::Result;
        loop {
            let tick = event(self, desk).await?;
            if self.viewer.look_around(&tick) || self.inspect(desk, &tick) {
                continue;
            }
            match tick.letter() {
                Some('D') if asks => self.display = Display::Wire,
                Some('T') if asks => self.display = Display::Filled,
                _ if tick.pressed(Key::Esc) => break,
                _ => {}
            }
        }
        self.viewer.stop();
        if asks {
            self.stage = Stage::Returning;
            if let Some(display) = ask_display(desk, self).await.unless_cancelled()? {
                self.display = display;
            }
        }
        self.stage = Stage::Working;
        Ok(())
    }

    /// Asks for a direction and a parameter there. The surface in the picture stays that of the last F, as
    /// in the original, unless it shall follow; a shape that has no surface is told about, and kept as the
    /// user gave it.
    async fn reshape(
        &mut self,
        desk: &mut Desk<'_>,
        entry: (Words, (i32, i32)),
        range: RangeInclusive<f64>,
        parameter: fn(&mut Form) -> &mut [f64; 2],
    ) -> Asked<()> {
        let direction = self.ask_direction(desk).await?;
        let typed = ask_real(desk, self, entry, TENSION).await?;
        let value = typed.clamp(*range.start(), *range.end());
        let mut model = self.history.now().clone();
        if let Some(place) = parameter(&mut model.form).get_mut(direction) {
            *place = value;
        }
        self.history.change(model);
        if value != typed {
            self.say(desk, words::taken_into(&range));
        }
        if let Err(problem) = self.draw_up(self.history.now()) {
            desk.tell(problem, Stay::UntilRead);
        } else if self.follow && self.drawn.is_some() {
            self.refresh(desk);
        }
        Ok(())
    }
}
