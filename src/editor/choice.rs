//! What several editors ask and draw alike: a point's number, a number of its own, the curve's form and
//! method, and the curve that was chosen.

use crate::geometry::{Closure, Curve, GeometryError, Method, ParamCurve, Point};
use crate::machine::{Asked, Key, Stop};
use crate::ui::words::{self, Words};
use crate::ui::{
    Answer, Area, Button, Caption, Desk, Field, Form, MIDDLE, Number, Picture, Question, Stay, TOP,
};
use std::ops::RangeInclusive;

/// The curve that the user chose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Choice {
    pub(super) closure: Closure,
    pub(super) method: Method,
}

/// Steps that a span is drawn in.
const STEPS: usize = 50;
/// Steps that the Bézier curve of all points is drawn in.
const BEZIER_STEPS: usize = 100;
/// Steps that a span of a beta-spline is drawn in.
pub(super) const BETA_STEPS: usize = 500;

impl Choice {
    /// The curve through or near control points.
    pub(super) fn curve<const D: usize>(self, points: &[Point<D>]) -> Result<Curve<D>, GeometryError> {
        Curve::through(self.method, self.closure, points)
    }

    /// The points that the curve is drawn through, in steps as fine as the original's.
    pub(super) fn polyline<const D: usize>(
        self,
        points: &[Point<D>],
    ) -> Result<Vec<Point<D>>, GeometryError> {
        self.curve(points)?.polyline(self.steps())
    }

    /// Steps that a span is drawn in.
    pub(super) fn steps(self) -> usize {
        match self.method {
            Method::Bezier => BEZIER_STEPS,
            Method::Beta { .. } => BETA_STEPS,
            _ => STEPS,
        }
    }
}

/// The curve in the picture, and when it goes out of it.
#[derive(Clone, Debug, Default)]
pub(super) struct Shown {
    /// The curve of the last "G"; `None` after a change by number, as in the original.
    pub(super) choice: Option<Choice>,
    /// Whether it is in the picture.
    pub(super) visible: bool,
    /// Whether it stays in the picture after a change and follows it.
    pub(super) follow: bool,
}

impl Shown {
    /// Shows another curve, or none.
    pub(super) fn take(&mut self, choice: Option<Choice>) {
        self.choice = choice;
        self.visible = choice.is_some();
    }

    /// After a change the curve goes out of the picture, unless it shall follow.
    pub(super) fn after_change(&mut self) {
        self.visible &= self.follow;
    }

    /// After a change by number there is no curve any more, unless it shall follow.
    pub(super) fn after_edit(&mut self) {
        if !self.follow {
            self.take(None);
        }
    }

    /// The key F3: lets the curve follow changes or not, and says so.
    pub(super) fn toggle_follow(&mut self, desk: &mut Desk<'_>) {
        self.follow = !self.follow;
        self.visible = self.follow && self.choice.is_some();
        desk.tell(if self.follow { words::FOLLOWS } else { words::FOLLOWS_NOT }, Stay::Briefly);
    }
}

/// The largest coefficient of the tangents.
const LARGEST_K0: f64 = 10.0;

/// The fewest points that have a curve.
pub(super) const FEWEST: usize = 3;

/// The command buttons of the curve editors, in the order in which they are looked through.
pub(super) const COMMANDS: [Button; 6] = [
    Button::new(460, 4, words::CHANGE),
    Button::new(550, 38, words::QUIT),
    Button::new(460, 38, words::RESULT),
    Button::new(460, 21, words::INSERT),
    Button::new(550, 21, words::DELETE),
    Button::new(550, 4, words::CURVE),
];

/// The method buttons.
pub(super) const METHODS: [Button; 4] = [
    Button::new(30, 21, words::COONS),
    Button::new(30, 38, words::BEZIER),
    Button::new(120, 21, words::SPLINE),
    Button::new(120, 38, words::B_SPLINE),
];

/// Asks for a point's number and gives its index; zero and less are as good as Esc.
pub(super) async fn ask_index(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<usize> {
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

/// As [`ask_index`], but only for one of `count` points that there are. If there is none, it says so, and the
/// command is over.
pub(super) async fn ask_existing(desk: &mut Desk<'_>, picture: &dyn Picture, count: usize) -> Asked<usize> {
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

/// Asks for one number with a fraction on the page at the top, with its caption at a place.
pub(super) async fn ask_real(
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
pub(super) async fn ask_coefficient(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<f64> {
    ask_real(desk, picture, (words::COEFFICIENT, (222, 23)), -LARGEST_K0..=LARGEST_K0).await
}

/// Asks whether the curve is open or closed.
pub(super) async fn ask_closure(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Closure> {
    let question = Question::new(TOP, words::ASK_SHAPE, [words::OPEN, words::CLOSED]);
    Ok(match desk.ask(picture, &question).await? {
        Answer::First => Closure::Open,
        Answer::Second => Closure::Closed,
    })
}

/// Waits for a method button and asks for what the method needs.
pub(super) async fn ask_method(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Method> {
    loop {
        let tick = desk.event(picture).await?;
        let clicked = tick.click().and_then(|(x, y)| METHODS.iter().find(|button| button.hit(x, y)));
        match clicked.map(|button| button.text.letter).or(tick.letter()) {
            Some('1') => {
                let k0 = ask_coefficient(desk, picture).await?;
                return Ok(Method::Coons { k0 });
            }
            Some('2') => return Ok(Method::Bezier),
            Some('3') => return Ok(Method::Spline),
            Some('4') => return ask_degree(desk, picture).await,
            _ if tick.pressed(Key::Esc) => return Err(Stop::Cancelled),
            _ => {}
        }
    }
}

async fn ask_degree(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Method> {
    let question = Question::new(MIDDLE, words::ASK_DEGREE, [words::TWO, words::THREE]);
    Ok(match desk.ask(picture, &question).await? {
        Answer::First => Method::BSpline2,
        Answer::Second => Method::BSpline3,
    })
}
