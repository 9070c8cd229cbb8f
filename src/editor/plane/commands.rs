//! The commands of the plane editor that ask for something: numbers, the curve's form and method.

use super::{Drawing, Editor, Stage, Tools, curves};
use crate::editor::choice::{Choice, FEWEST, ask_closure, ask_existing, ask_method};
use crate::editor::drawing::Edit;
use crate::editor::points::{PointEditor, change, change_at, delete, insert};
use crate::file::FIELD;
use crate::geometry::{Method, Point};
use crate::machine::{Asked, Asking, Key};
use crate::screen::Color;
use crate::ui::words::{self, Words};
use crate::ui::{Answer, Area, Caption, Desk, Field, Form, Number, Question, Stay, TOP};
use crate::work::{Next, quit};

impl PointEditor for Editor {
    type Place = Point<2>;

    fn drawing(&self) -> &Drawing {
        &self.history.now().drawing
    }

    async fn ask_place(&self, desk: &mut Desk<'_>) -> Asked<Point<2>> {
        let field = |y: i32, largest: f64| Field {
            area: Area::new(340, y - 2, 378, y + 10),
            at: (348, y + 1),
            longest: 3,
            kind: Number::Whole(0..=largest as i32),
        };
        let captions = vec![
            Caption::new((255, 23), words::PLACE_ENTRY),
            Caption::new((315, 15), Words("x = ", "x = ")).colored(Color::LightMagenta),
            Caption::new((315, 30), Words("y = ", "y = ")).colored(Color::LightMagenta),
        ];
        let form = Form::new(captions, [field(14, FIELD[0]), field(29, FIELD[1])]);
        desk.numbers(self, &form).await
    }

    fn edit(&mut self, edit: Edit<Point<2>>) {
        self.change(self.history.now().edited(edit));
    }
}

impl Editor {
    /// Carries out the command of a letter; other letters do nothing.
    pub(super) async fn obey(&mut self, desk: &mut Desk<'_>, letter: char) -> Asked<Next> {
        let carried_out = match letter {
            'B' => insert(self, desk).await,
            'V' => self.change_point(desk).await,
            'T' => delete(self, desk).await,
            'G' => self.choose_curve(desk).await,
            'E' => self.show_result(desk).await,
            'A' | 'C' if self.tools == Tools::Beta => {
                return self.change_shape(desk, letter).await.map(|()| Next::Work);
            }
            'Q' => return quit(self, desk).await,
            _ => return Ok(Next::Work),
        };
        // As in the original, the offer comes after a cancelled command too.
        carried_out.unless_cancelled()?;
        self.offer_tangents = true;
        Ok(Next::Work)
    }

    async fn choose_curve(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.count() < FEWEST {
            desk.tell(words::TOO_FEW, Stay::Briefly);
            return Ok(());
        }
        self.stage = Stage::Choosing;
        self.forget_note();
        let closure = ask_closure(desk, self).await?;
        let method = match self.tools {
            Tools::Methods => ask_method(desk, self).await?,
            Tools::Tangents => Method::Coons { k0: self.k0 },
            Tools::Beta => self.history.now().shape.method(),
        };
        let choice = Choice { closure, method };
        if let Err(error) = curves::pixels(self.tools, choice, self.history.now()) {
            desk.tell(words::no_curve(&error), Stay::UntilRead);
            return Ok(());
        }
        self.shown.take(Some(choice));
        if let (Tools::Methods, Method::Coons { k0 }) = (self.tools, method) {
            self.k0 = k0;
            self.note = Some(format!("k0 = {k0:.2}"));
        }
        Ok(())
    }

    /// The command V; where there are tangents, it asks first what of the point changes.
    async fn change_point(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.tools != Tools::Tangents {
            return change(self, desk).await;
        }
        let index = ask_existing(desk, self, self.count()).await?;
        let what = Question::new(TOP, words::ASK_CHANGE, [words::POINT, words::TANGENT]);
        match desk.ask(self, &what).await? {
            Answer::First => change_at(self, desk, index).await,
            Answer::Second => self.change_tangent(desk, index).await,
        }
    }

    /// Shows the curve without its surroundings until Esc.
    async fn show_result(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.shown.choice.is_none() || self.count() < FEWEST {
            desk.tell(words::NO_CURVE, Stay::Briefly);
            return Ok(());
        }
        let question = Question::yes_no(words::ASK_POINTS);
        let answer = desk.ask(self, &question).await?;
        self.stage = Stage::Result { points: answer == Answer::First };
        while !desk.event(self).await?.pressed(Key::Esc) {}
        // As in the original, the curve is gone from the editor's picture after this.
        self.shown.after_change();
        self.forget_note();
        Ok(())
    }
}
