//! Which PH curve a sketch is drawn as, and the command G that chooses it.

use super::texts;
use crate::design::{DesignError, Place, Sketch};
use crate::file::Method;
use crate::geometry::{GeometryError, Point};
use crate::machine::Asked;
use crate::ui::words;
use crate::ui::{Answer, Area, Caption, Choices, Desk, Picture, Question, TOP};

/// The method that a sketch is drawn by: the chosen one, else that of its tangents.
pub(super) fn method<const D: usize>(sketch: &Sketch<D>, usual: bool) -> Option<Method> {
    match sketch.settings.method {
        Some(own @ (Method::PhSpline | Method::PhHermite | Method::PhCubic)) => Some(own),
        Some(_) => Some(by_tangents(sketch)),
        None => usual.then(|| by_tangents(sketch)),
    }
}

fn by_tangents<const D: usize>(sketch: &Sketch<D>) -> Method {
    if D == 3 || sketch.tangents.is_some() { Method::PhHermite } else { Method::PhSpline }
}

/// The sketch with tangents where its method needs them: a point without one gets that of the cubic spline, rounded
/// as files hold it.
pub(super) fn completed<const D: usize>(sketch: Sketch<D>) -> Sketch<D>
where
    Point<D>: Place<D>,
{
    let needed = D == 3 || matches!(sketch.settings.method, Some(Method::PhHermite | Method::PhCubic));
    let missing = match &sketch.tangents {
        Some(tangents) => tangents.iter().any(|tangent| *tangent == [0.0; D]),
        None => needed,
    };
    if !missing || sketch.points.len() < 2 {
        return sketch;
    }
    let Ok(usual) = (Sketch { tangents: None, ..sketch.clone() }).ph_tangents() else { return sketch };
    let usual = usual.into_iter().map(|tangent| tangent.map(f64::round_ties_even));
    let own = sketch.tangents.clone().unwrap_or_default();
    let tangents = usual.enumerate().map(|(at, usual)| match own.get(at) {
        Some(tangent) if *tangent != [0.0; D] => *tangent,
        _ => usual,
    });
    Sketch { tangents: Some(tangents.collect()), ..sketch }
}

/// The command G: form and method; `None` where there is no such curve, which has been said.
pub(super) async fn choose(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    sketch: &Sketch<2>,
) -> Asked<Option<Sketch<2>>> {
    let closed = ask_closed(desk, picture).await?;
    let mut chosen = sketch.clone();
    chosen.settings.closed = Some(closed);
    let method = ask_method(desk, picture).await?;
    let chosen = completed(chosen.by(method));
    match chosen.ph_curve() {
        Ok(_) => Ok(Some(chosen)),
        Err(DesignError::Geometry(GeometryError::NoPhCubic { .. })) => {
            let question = Question::new(TOP, texts::NO_CUBIC, [words::YES, words::NO]);
            let quintic = desk.ask(picture, &question).await? == Answer::First;
            Ok(quintic.then(|| chosen.by(Method::PhHermite)))
        }
        Err(error) => {
            texts::tell_refusal(desk, &error);
            Ok(None)
        }
    }
}

/// Asks whether the curve is closed.
pub(super) async fn ask_closed(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<bool> {
    let question = Question::new(TOP, words::ASK_SHAPE, [words::OPEN, words::CLOSED]);
    Ok(desk.ask(picture, &question).await? == Answer::Second)
}

async fn ask_method(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Method> {
    let (x, y) = TOP;
    let window = |from: i32, to: i32| Area::new(x + from, y + 21, x + to, y + 34);
    let answers = vec![
        (window(6, 80), texts::SPLINE, Method::PhSpline),
        (window(84, 166), texts::HERMITE, Method::PhHermite),
        (window(170, 236), texts::CUBIC, Method::PhCubic),
    ];
    let captions = vec![Caption::new((x + 7, y + 8), texts::ASK_METHOD)];
    desk.choose(picture, &Choices { place: TOP, captions, answers }).await
}
