//! Questions of the surface editor: a control point, a part of a Hermite patch, a direction, an axis, wires or
//! filled cells.

use super::Nets;
use super::surface::Display;
use crate::design::{Index, Part};
use crate::editor::Editor;
use crate::editor::curve::ask::ask_degree;
use crate::file::Method;
use crate::machine::{Asked, Key, Language, Request, Stop};
use crate::screen::{Color, Screen};
use crate::ui::words::{self, Words};
use crate::ui::{
    Answer, Area, Caption, Choices, Desk, Field, Form, MIDDLE, Number, Picture, Question, TOP, page, window,
};

/// The windows of the two digits.
const DIGITS: [Area; 2] = [Area::new(360, 10, 383, 23), Area::new(360, 28, 383, 41)];

impl Part {
    /// Its name on the page and under the picture.
    pub(super) fn title(self) -> Words {
        match self {
            Part::Place => words::PLACE_3D,
            Part::TangentU => words::TANGENT_U_TITLE,
            Part::TangentV => words::TANGENT_V_TITLE,
            Part::Twist => words::TWIST_TITLE,
        }
    }
}

impl Editor<Nets, 3> {
    /// Asks for a control point by its two indices, which are single digits for small nets.
    pub(super) async fn ask_index(&self, desk: &mut Desk<'_>) -> Asked<Index> {
        let counts = self.history.now().choices();
        if counts.iter().any(|&count| count > 10) {
            return self.ask_large_index(desk, counts).await;
        }
        let mut digits: Vec<usize> = Vec::new();
        loop {
            if let &[k, l] = digits.as_slice() {
                return Ok([k, l]);
            }
            let active = digits.len();
            let typing = |screen: &mut Screen, language: Language| {
                self.draw(screen, language);
                draw_digits(screen, &digits, language);
            };
            let tick = desk.event_asked(&typing, Request::Number).await?;
            if tick.pressed(Key::Esc) {
                return Err(Stop::Cancelled);
            }
            if let Some(index) = tick.click().and_then(|place| self.map().hit(place)) {
                return Ok(index);
            }
            let digit = tick.letter().and_then(|letter| letter.to_digit(10)).map(|digit| digit as usize);
            digits.extend(digit.filter(|digit| counts.get(active).is_some_and(|count| digit < count)));
        }
    }

    async fn ask_large_index(&self, desk: &mut Desk<'_>, counts: [usize; 2]) -> Asked<Index> {
        let last = |direction: usize| i32::try_from(counts[direction].saturating_sub(1)).unwrap_or(i32::MAX);
        let field = |direction: usize| Field {
            area: DIGITS[direction],
            at: (DIGITS[direction].x1 + 4, DIGITS[direction].y1 + 3),
            longest: 2,
            kind: Number::Whole(0..=last(direction)),
        };
        let captions = vec![
            Caption::new((262, 26), words::NUMBER_ENTRY),
            Caption::new((350, 12), Words("k", "k")),
            Caption::new((350, 30), Words("l", "l")),
        ];
        let numbers = desk.numbers(self, &Form::new(captions, [field(0), field(1)])).await?;
        Ok(numbers.map(|number| number as usize))
    }

    /// Asks what to change at a corner of a Hermite patch.
    pub(super) async fn ask_part(&self, desk: &mut Desk<'_>) -> Asked<Part> {
        let choices = Choices {
            place: TOP,
            captions: vec![
                Caption::new((290, 6), words::WHAT_CHANGES),
                Caption::new((310, 18), words::TANGENT_TITLE),
            ],
            answers: vec![
                (Area::new(220, 15, 280, 28), words::PLACE, Part::Place),
                (Area::new(375, 15, 435, 28), words::TWIST, Part::Twist),
                (Area::new(270, 31, 330, 44), words::TANGENT_U, Part::TangentU),
                (Area::new(335, 31, 395, 44), words::TANGENT_V, Part::TangentV),
            ],
        };
        desk.choose(self, &choices).await
    }

    /// Asks for the direction u (0) or v (1).
    pub(super) async fn ask_direction(&self, desk: &mut Desk<'_>) -> Asked<usize> {
        let question = Question::new(TOP, words::ASK_DIRECTION, [words::ALONG_U, words::ALONG_V]);
        Ok(match desk.ask(self, &question).await? {
            Answer::First => 0,
            Answer::Second => 1,
        })
    }

    /// Asks for an axis: x (0), y (1) or z (2).
    pub(super) async fn ask_axis(&self, desk: &mut Desk<'_>) -> Asked<usize> {
        let windows = [250, 310, 370].map(|x| Area::new(x, 26, x + 40, 39));
        let answers = windows.into_iter().zip(words::AXES).zip(0..);
        let choices = Choices {
            place: TOP,
            captions: vec![Caption::new((224, 13), words::ASK_AXIS)],
            answers: answers.map(|((area, text), axis)| (area, text, axis)).collect(),
        };
        desk.choose(self, &choices).await
    }

    /// Asks for the degree, then for wires or filled cells. The first page stays visible under the second.
    pub(super) async fn ask_degree_and_display(&self, desk: &mut Desk<'_>) -> Asked<(Method, Display)> {
        let degree = ask_degree(desk, self).await?;
        let page = Question::new(MIDDLE, words::ASK_DEGREE, [words::TWO, words::THREE]).choices();
        let under = |screen: &mut Screen, language: Language| {
            self.draw(screen, language);
            page.draw(screen, language);
        };
        Ok((degree, ask_display(desk, &under).await?))
    }
}

/// Asks for wires or filled cells.
pub(super) async fn ask_display(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Display> {
    let question = Question::new(TOP, words::ASK_DISPLAY, [words::WIRE, words::FILLED]);
    Ok(match desk.ask(picture, &question).await? {
        Answer::First => Display::Wire,
        Answer::Second => Display::Filled,
    })
}

fn draw_digits(screen: &mut Screen, digits: &[usize], language: Language) {
    page(screen, TOP);
    screen.text(262, 26, words::NUMBER_ENTRY.of(language), Color::Black);
    for (index, (area, name)) in DIGITS.into_iter().zip(["k", "l"]).enumerate() {
        let ink = if index == digits.len() { Color::LightRed } else { Color::Black };
        screen.text(350, area.y1 + 2, name, ink);
        window(screen, area);
        if let Some(digit) = digits.get(index) {
            screen.text(area.x1 + 8, area.y1 + 3, &digit.to_string(), Color::White);
        }
    }
}
