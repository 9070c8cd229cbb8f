//! The commands of the space editor that ask for something.

use super::{Drawing, Editor, Stage, Tools};
use crate::editor::beta::{ask_bias, ask_tension};
use crate::editor::choice::{Choice, FEWEST, ask_closure, ask_method};
use crate::editor::drawing::Edit;
use crate::editor::place::ask_place;
use crate::editor::points::{PointEditor, change, delete, insert};
use crate::geometry::{Method, Point, Shape};
use crate::machine::{Asked, Key};
use crate::ui::words::{self, Phrase};
use crate::ui::{Answer, Desk, Question, Stay};
use crate::work::{Next, event, quit};

impl PointEditor for Editor {
    type Place = Point<3>;

    fn drawing(&self) -> &Drawing {
        self.history.now()
    }

    /// Carries out an edit by number. As in the original the curve goes, unless it shall follow.
    fn edit(&mut self, edit: Edit<Point<3>>) {
        self.history.change(self.history.now().edited(edit));
        self.shown.after_edit();
        self.note = None;
    }

    async fn ask_place(&self, desk: &mut Desk<'_>) -> Asked<Point<3>> {
        ask_place(desk, self, words::PLACE_3D).await
    }

    fn point_out(&mut self, index: Option<usize>) {
        self.pointed_out = index;
    }
}

impl Editor {
    /// Carries out the command of a letter; other letters do nothing.
    pub(super) async fn obey(&mut self, desk: &mut Desk<'_>, letter: char) -> Asked<Next> {
        match (letter, self.tools) {
            ('B', _) => insert(self, desk).await?,
            ('V', _) => change(self, desk).await?,
            ('T', _) => delete(self, desk).await?,
            ('G', _) => self.choose_curve(desk).await?,
            ('E', _) => self.show_result(desk).await?,
            ('A', Tools::Beta) => {
                let bias = ask_bias(desk, self).await?;
                self.reshape(desk, Shape { bias, ..self.shape });
            }
            ('C', Tools::Beta) => {
                let tension = ask_tension(desk, self).await?;
                self.reshape(desk, Shape { tension, ..self.shape });
            }
            ('Q', _) => {
                let next = quit(self, desk).await?;
                self.shown.after_change();
                return Ok(next);
            }
            _ => {}
        }
        Ok(Next::Work)
    }

    /// Takes another shape of the beta-spline. The curve of the old one goes, unless it shall follow; a
    /// shape that has no curve is told about, and kept as the user gave it.
    fn reshape(&mut self, desk: &mut Desk<'_>, shape: Shape) {
        self.shape = shape;
        if let Some(choice) = &mut self.shown.choice {
            choice.method = shape.method();
        }
        self.shown.after_change();
        if let Err(error) = shape.method().check() {
            desk.tell(words::no_curve(&error), Stay::UntilRead);
        }
    }

    /// Why a curve cannot be drawn.
    fn problem(&self, choice: Choice) -> Option<Phrase> {
        let points = self.history.now().points();
        if points.len() < FEWEST {
            return Some(words::TOO_FEW.into());
        }
        choice.curve(points).err().map(|error| words::no_curve(&error))
    }

    async fn choose_curve(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.history.now().points().len() < FEWEST {
            desk.tell(words::TOO_FEW, Stay::Briefly);
            return Ok(());
        }
        self.stage = Stage::Choosing;
        self.note = None;
        let closure = ask_closure(desk, self).await?;
        let method = match self.tools {
            Tools::Methods => ask_method(desk, self).await?,
            Tools::Beta => self.shape.method(),
        };
        let choice = Choice { closure, method };
        if let Some(problem) = self.problem(choice) {
            self.shown.take(None);
            desk.tell(problem, Stay::UntilRead);
            return Ok(());
        }
        self.shown.take(Some(choice));
        if let Method::Coons { k0 } = method {
            self.note = Some(format!("k0 = {k0:.2}"));
        }
        Ok(())
    }

    /// Shows the curve without its surroundings, to be looked at from all sides, until Esc.
    async fn show_result(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        let Some(choice) = self.shown.choice else {
            desk.tell(words::NO_CURVE, Stay::Briefly);
            return Ok(());
        };
        if let Some(problem) = self.problem(choice) {
            desk.tell(problem, Stay::UntilRead);
            return Ok(());
        }
        let question = Question::yes_no(words::ASK_POINTS);
        let answer = desk.ask(self, &question).await?;
        self.stage = Stage::Result { points: answer == Answer::First };
        loop {
            let tick = event(self, desk).await?;
            if !self.viewer.look_around(&tick) && tick.pressed(Key::Esc) {
                break;
            }
        }
        self.shown.after_change();
        self.note = None;
        Ok(())
    }
}
