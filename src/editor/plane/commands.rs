//! The commands of the plane editor that ask for something: numbers, the curve's form and method.

use super::curves::{self, Choice, Kind};
use super::picture::METHODS;
use super::{Edit, Editor, Next, Stage};
use crate::file::{FIELD, MAX_POINTS};
use crate::geometry::{Closure, Method, Point};
use crate::machine::{Key, Language, Quit};
use crate::screen::{Color, Screen};
use crate::ui::words::{self, Words};
use crate::ui::{Answer, Area, Caption, Desk, Field, Form, MIDDLE, Number, Picture, Question, Stay, TOP};

/// The fewest points that have a curve.
const FEWEST: usize = 3;

/// The largest coefficient of the tangents.
const LARGEST_K0: f64 = 10.0;

impl Editor {
    /// Carries out the command of a letter; other letters do nothing.
    pub(super) async fn obey(&mut self, desk: &mut Desk<'_>, letter: char) -> Result<Next, Quit> {
        match letter {
            'B' => self.insert(desk).await?,
            'V' => self.change(desk).await?,
            'T' => self.delete(desk).await?,
            'G' => self.choose_curve(desk).await?,
            'E' => self.show_result(desk).await?,
            'Q' => return self.quit(desk).await,
            _ => {}
        }
        Ok(Next::Work)
    }

    async fn insert(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        if self.history.now().full() {
            desk.tell(words::FULL, Stay::Briefly);
            return Ok(());
        }
        let Some(index) = self.ask_index(desk).await? else { return Ok(()) };
        let Some(place) = self.ask_place(desk).await? else { return Ok(()) };
        self.edit(Edit::Insert(index, place));
        Ok(())
    }

    async fn change(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        let Some(index) = self.ask_existing(desk).await? else { return Ok(()) };
        let what = Question::new(TOP, words::ASK_CHANGE, [words::NUMBER, words::PLACE]);
        match desk.ask(self, &what).await? {
            Some(Answer::First) => {
                if let Some(to) = self.ask_existing(desk).await? {
                    self.edit(Edit::Renumber(index, to));
                }
            }
            Some(Answer::Second) => {
                if let Some(place) = self.ask_place(desk).await? {
                    self.edit(Edit::Move(index, place));
                }
            }
            None => {}
        }
        Ok(())
    }

    async fn delete(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        if let Some(index) = self.ask_existing(desk).await? {
            self.edit(Edit::Delete(index));
        }
        Ok(())
    }

    /// Asks for a point's number and gives its index; nothing for Esc, zero and less.
    async fn ask_index(&self, desk: &mut Desk<'_>) -> Result<Option<usize>, Quit> {
        let form = Form {
            captions: vec![Caption { at: (262, 26), text: words::NUMBER_ENTRY, color: Color::Black }],
            fields: vec![Field {
                area: Area::new(330, 19, 361, 32),
                at: (338, 22),
                longest: 2,
                kind: Number::Whole(0..=i32::MAX),
            }],
        };
        let numbers = desk.numbers(self, &form).await?;
        Ok(numbers.and_then(|numbers| (numbers[0] as usize).checked_sub(1)))
    }

    /// As [`Editor::ask_index`], but only for a point that there is; says so if there is none.
    async fn ask_existing(&self, desk: &mut Desk<'_>) -> Result<Option<usize>, Quit> {
        let count = self.history.now().points().len();
        if count == 0 {
            desk.tell(words::NO_POINTS, Stay::Briefly);
            return Ok(None);
        }
        let index = self.ask_index(desk).await?;
        if index.is_some_and(|index| index >= count) {
            desk.tell(words::no_such_point(count), Stay::Briefly);
        }
        Ok(index.filter(|&index| index < count))
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

    async fn choose_curve(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        if self.history.now().points().len() < FEWEST {
            desk.tell(words::TOO_FEW, Stay::Briefly);
            return Ok(());
        }
        self.stage = Stage::Choosing;
        self.note = None;
        let Some(closure) = self.ask_closure(desk).await? else { return Ok(()) };
        let Some(method) = self.ask_method(desk).await? else { return Ok(()) };
        let choice = Choice { closure, method };
        match curves::pixels(choice, self.history.now().points()) {
            Ok(_) => {
                self.choice = Some(choice);
                self.visible = true;
                self.note = match method {
                    Method::Coons { k0 } => Some(format!("k0 = {k0:.2}")),
                    _ => None,
                };
            }
            Err(error) => desk.tell(words::plain(&error), Stay::UntilRead),
        }
        Ok(())
    }

    async fn ask_closure(&self, desk: &mut Desk<'_>) -> Result<Option<Closure>, Quit> {
        let question = Question::new(TOP, words::ASK_SHAPE, [words::OPEN, words::CLOSED]);
        let answer = desk.ask(self, &question).await?;
        Ok(answer.map(|answer| match answer {
            Answer::First => Closure::Open,
            Answer::Second => Closure::Closed,
        }))
    }

    async fn ask_method(&mut self, desk: &mut Desk<'_>) -> Result<Option<Method>, Quit> {
        loop {
            let tick = desk.event(self).await?;
            let clicked = tick.click().and_then(|(x, y)| METHODS.iter().find(|button| button.hit(x, y)));
            match clicked.map(|button| button.text.letter).or(tick.letter()) {
                Some('1') => {
                    let Some(k0) = self.ask_coefficient(desk).await? else { return Ok(None) };
                    self.k0 = k0;
                    return Ok(Some(Method::Coons { k0 }));
                }
                Some('2') => return Ok(Some(Method::Bezier)),
                Some('3') => return Ok(Some(Method::Spline)),
                Some('4') => return self.ask_degree(desk).await,
                _ if tick.pressed(Key::Esc) => return Ok(None),
                _ => {}
            }
        }
    }

    async fn ask_coefficient(&self, desk: &mut Desk<'_>) -> Result<Option<f64>, Quit> {
        let form = Form {
            captions: vec![Caption { at: (222, 23), text: words::COEFFICIENT, color: Color::Black }],
            fields: vec![Field {
                area: Area::new(330, 19, 375, 32),
                at: (338, 22),
                longest: 4,
                kind: Number::Real(-LARGEST_K0..=LARGEST_K0),
            }],
        };
        let numbers = desk.numbers(self, &form).await?;
        Ok(numbers.map(|numbers| numbers[0]))
    }

    async fn ask_degree(&self, desk: &mut Desk<'_>) -> Result<Option<Method>, Quit> {
        let question = Question::new(MIDDLE, words::ASK_DEGREE, [words::TWO, words::THREE]);
        let answer = desk.ask(self, &question).await?;
        Ok(answer.map(|answer| match answer {
            Answer::First => Method::BSpline2,
            Answer::Second => Method::BSpline3,
        }))
    }

    /// Shows the curve without its surroundings until Esc.
    async fn show_result(&mut self, desk: &mut Desk<'_>) -> Result<(), Quit> {
        if self.choice.is_none() || self.history.now().points().len() < FEWEST {
            desk.tell(words::NO_CURVE, Stay::Briefly);
            return Ok(());
        }
        let question = Question::yes_no(words::ASK_POINTS);
        let answer = desk.ask(self, &question).await?;
        let Some(answer) = answer else { return Ok(()) };
        self.stage = Stage::Result { points: answer == Answer::First };
        while !desk.event(self).await?.pressed(Key::Esc) {}
        self.visible = true;
        self.note = None;
        Ok(())
    }

    /// Chooses which curves are shown together, each in its colour.
    pub(super) async fn compare(&mut self, desk: &mut Desk<'_>) -> Result<Next, Quit> {
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
                    return Ok(Next::Work);
                }
                None => {}
            }
        }
    }
}

// The prompt for a point's number has room for two digits.
const _: () = assert!(MAX_POINTS <= 99);
