//! The commands of the plane editor that ask for something: numbers, the curve's form and method.

use super::curves::{self, Kind};
use super::{Editor, Stage};
use crate::editor::choice::{Choice, FEWEST, ask_closure, ask_method};
use crate::editor::configuration::{Next, quit};
use crate::editor::drawing::Edit;
use crate::editor::points::{PointEditor, change, delete, insert};
use crate::file::FIELD;
use crate::geometry::{Method, Point};
use crate::machine::{Key, Language, Quit};
use crate::screen::{Color, Screen};
use crate::ui::words::{self, Words};
use crate::ui::{Answer, Area, Caption, Desk, Field, Form, Number, Picture, Question, Stay, TOP};

impl PointEditor for Editor {
    type Place = Point<2>;

    /// Carries out an edit by number. As in the original the curve goes, unless it shall follow.
    fn edit(&mut self, edit: Edit<Point<2>>) {
        self.history.change(self.history.now().edited(edit));
        self.shown.after_edit();
        self.note = None;
    }

    async fn ask_place(&self, desk: &mut Desk<'_>) -> Result<Option<Point<2>>, Quit> {
        let field = |y: i32, largest: f64| Field {
            area: Area::new(340, y - 2, 378, y + 10),
            at: (348, y + 1),
            longest: 3,
            kind: Number::Whole(0..=largest as i32),
        };
        let form = Form {
            captions: vec![
                Caption { at: (255, 23), text: words::PLACE_ENTRY, color: Color::Black },
                Caption { at: (315, 15), text: Words("x = ", "x = "), color: Color::LightMagenta },
                Caption { at: (315, 30), text: Words("y = ", "y = "), color: Color::LightMagenta },
            ],
            fields: vec![field(14, FIELD[0]), field(29, FIELD[1])],
        };
        let numbers = desk.numbers(self, &form).await?;
        Ok(numbers.map(|numbers| [numbers[0], numbers[1]]))
    }
}

impl Editor {
    /// Carries out the command of a letter; other letters do nothing.
    pub(super) async fn obey(&mut self, desk: &mut Desk<'_>, letter: char) -> Result<Next, Quit> {
        match letter {
            'B' => insert(self, desk).await?,
            'V' => change(self, desk).await?,
            'T' => delete(self, desk).await?,
            'G' => self.choose_curve(desk).await?,
            'E' => self.show_result(desk).await?,
            'Q' => return quit(self, desk).await,
            _ => {}
        }
        Ok(Next::Work)
    }

    /// How many points there are.
    fn count(&self) -> usize {
        self.history.now().points().len()
    }

    async fn choose_curve(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        if self.count() < FEWEST {
            desk.tell(words::TOO_FEW, Stay::Briefly);
            return Ok(());
        }
        self.stage = Stage::Choosing;
        self.note = None;
        let Some(closure) = ask_closure(desk, self).await? else { return Ok(()) };
        let Some(method) = ask_method(desk, self).await? else { return Ok(()) };
        let choice = Choice { closure, method };
        match curves::pixels(choice, self.history.now().points()) {
            Ok(_) => {
                self.shown.take(Some(choice));
                if let Method::Coons { k0 } = method {
                    self.k0 = k0;
                    self.note = Some(format!("k0 = {k0:.2}"));
                }
            }
            Err(error) => desk.tell(words::plain(&error), Stay::UntilRead),
        }
        Ok(())
    }

    /// Shows the curve without its surroundings until Esc.
    async fn show_result(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        if self.shown.choice.is_none() || self.count() < FEWEST {
            desk.tell(words::NO_CURVE, Stay::Briefly);
            return Ok(());
        }
        let question = Question::yes_no(words::ASK_POINTS);
        let answer = desk.ask(self, &question).await?;
        let Some(answer) = answer else { return Ok(()) };
        self.stage = Stage::Result { points: answer == Answer::First };
        while !desk.event(self).await?.pressed(Key::Esc) {}
        self.shown.visible = true;
        self.note = None;
        Ok(())
    }

    /// Chooses which curves are shown together, each in its colour.
    pub(super) async fn compare(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        let place = |index: i32| (216 + 116 * (index % 2), 9 + 13 * (index / 2));
        loop {
            let compared = self.compared.clone();
            let draw = |screen: &mut Screen, language: Language| {
                self.draw(screen, language);
                crate::ui::page(screen, TOP);
                for (index, (kind, name, color)) in (0..).zip(Kind::ALL) {
                    let (x, y) = place(index);
                    if compared.contains(&kind) {
                        screen.bar(x + 16, y, x + 28, y + 7, color);
                    }
                    screen.text(x, y, &(index + 1).to_string(), Color::Red);
                    screen.text(x + 34, y, name, Color::Black);
                }
                screen.text(332, 35, words::ENTER_BACK.of(language), Color::Black);
            };
            let tick = desk.event(&draw).await?;
            let clicked = tick.click().and_then(|(x, y)| {
                (0..).zip(Kind::ALL).position(|(index, _)| {
                    let (left, top) = place(index);
                    Area::new(left - 2, top - 3, left + 112, top + 10).holds(x, y)
                })
            });
            let typed = tick
                .letter()
                .and_then(|letter| letter.to_digit(10))
                .and_then(|digit| (digit as usize).checked_sub(1));
            match clicked.or(typed).and_then(|index| Kind::ALL.get(index)) {
                Some(&(kind, ..)) if self.compared.contains(&kind) => {
                    self.compared.retain(|&other| other != kind)
                }
                Some(&(kind, ..)) => self.compared.push(kind),
                None if matches!(tick.key(), Some(Key::Enter | Key::Esc | Key::F(4))) => {
                    return Ok(());
                }
                None => {}
            }
        }
    }
}
