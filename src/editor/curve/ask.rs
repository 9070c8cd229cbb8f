//! Questions of the curve editors: the number of a point, other numbers, the form and method of the curve.

use super::degree::{Chosen, ask_b_spline};
use crate::editor::values::K0;
use crate::file::Method;
use crate::machine::{Asked, Key, Language, Manner, Request, Stop};
use crate::screen::Screen;
use crate::ui::words::{self, Words};
use crate::ui::{
    Answer, Area, Button, Caption, Desk, Field, Form, MIDDLE, Number, Over, Picture, Question, Stay, TOP,
    page,
};
use std::ops::RangeInclusive;

/// The fewest points that have a curve.
pub(in crate::editor) const FEWEST: usize = 3;

/// The method buttons.
pub(in crate::editor) const METHODS: [Button; 4] = [
    Button::new(30, 21, words::COONS),
    Button::new(30, 38, words::BEZIER),
    Button::new(120, 21, words::SPLINE),
    Button::new(120, 38, words::B_SPLINE),
];

/// The button of Bézier arcs, on the communication page.
const ARCS: Button = Button::new(292, 19, words::ARCS);

/// Asks for the number of a point and returns its index. Zero or less cancels, like Esc.
pub(crate) async fn ask_index(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<usize> {
    let field = Field {
        area: Area::new(330, 19, 361, 32),
        at: (338, 22),
        longest: 2,
        kind: Number::Whole(0..=i32::MAX),
    };
    let form = Form::new(vec![Caption::new((262, 26), words::NUMBER_ENTRY)], [field]);
    let [number] = desk.numbers(picture, &form).await?;
    (number as usize).checked_sub(1).ok_or(Stop::Cancelled)
}

/// Like [`ask_index`], but for one of the `count` existing points. If there is no such point, it says so and cancels
/// the command.
pub(crate) async fn ask_existing(desk: &mut Desk<'_>, picture: &dyn Picture, count: usize) -> Asked<usize> {
    if count == 0 {
        desk.tell(words::NO_POINTS, Stay::Briefly);
        return Err(Stop::Cancelled);
    }
    let index = ask_index(desk, picture).await?;
    if index >= count {
        desk.tell(words::no_such_point(count), Stay::Briefly);
        return Err(Stop::Cancelled);
    }
    Ok(index)
}

/// Asks for a decimal number on the page at the top, with a caption at a given place.
pub(crate) async fn ask_real(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    (caption, at): (Words, (i32, i32)),
    range: RangeInclusive<f64>,
) -> Asked<f64> {
    let field =
        Field { area: Area::new(330, 19, 375, 32), at: (338, 22), longest: 4, kind: Number::Real(range) };
    let form = Form::new(vec![Caption::new(at, caption)], [field]);
    let [number] = desk.numbers(picture, &form).await?;
    Ok(number)
}

/// Asks for the coefficient of the automatic tangents.
pub(in crate::editor) async fn ask_coefficient(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<f64> {
    ask_real(desk, picture, (words::COEFFICIENT, (222, 23)), K0.range()).await
}

/// Asks whether the curve is closed.
pub(crate) async fn ask_closure(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<bool> {
    let question = Question::new(TOP, words::ASK_SHAPE, [words::OPEN, words::CLOSED]);
    Ok(match desk.ask(picture, &question).await? {
        Answer::First => false,
        Answer::Second => true,
    })
}

/// Waits for a method button, then asks for the coefficient of the tangents if the method has one. The manner of today
/// has Bézier arcs too.
pub(super) async fn ask_method(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Chosen> {
    let today = desk.machine.manner() == Manner::Today;
    let over = Over::new(picture, |screen: &mut Screen, language: Language| {
        if today {
            page(screen, TOP);
            ARCS.draw(screen, language);
        }
    });
    let last = if today { '5' } else { '4' };
    loop {
        let keys = Request::Keys(('1'..=last).map(Key::Char).collect());
        let tick = desk.event_asked(&over, keys).await?;
        let buttons = METHODS.iter().chain(today.then_some(&ARCS));
        let clicked = tick.click().and_then(|(x, y)| buttons.clone().find(|button| button.hit(x, y)));
        match clicked.map(|button| button.text.letter).or(tick.letter()) {
            Some('1') => {
                let k0 = Some(ask_coefficient(desk, picture).await?);
                return Ok(Chosen { k0, ..Chosen::of(Method::Coons) });
            }
            Some('2') => return Ok(Chosen::of(Method::Bezier)),
            Some('3') => return Ok(Chosen::of(Method::Spline)),
            Some('4') => return ask_b_spline(desk, picture).await,
            Some('5') if today => return Ok(Chosen::of(Method::Arcs)),
            _ if tick.pressed(Key::Esc) => return Err(Stop::Cancelled),
            _ => {}
        }
    }
}

pub(in crate::editor) async fn ask_degree(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Method> {
    let question = Question::new(MIDDLE, words::ASK_DEGREE, [words::TWO, words::THREE]);
    Ok(match desk.ask(picture, &question).await? {
        Answer::First => Method::BSpline2,
        Answer::Second => Method::BSpline3,
    })
}
