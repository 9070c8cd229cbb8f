//! The command H: a target, the value of the parameter that brings the curve there, and the way of the parameter.

use super::craft::Bench;
use super::dial;
use super::form::Form;
use super::kinds::Knob;
use super::room::{Here, Room};
use super::texts;
use crate::design::Place;
use crate::editor::field::PICTURE;
use crate::editor::lens::Lens;
use crate::file::Places;
use crate::geometry::shaped::{Parameter, Reach, ShapedCurve};
use crate::geometry::{GeometryError, ParamCurve, Point};
use crate::machine::{Asked, Key, Language, Request, Stop};
use crate::screen::{Color, Screen};
use crate::ui::{Desk, Over, Stay, TOP, page, words};
use serde::Serialize;
use std::time::Duration;

/// How long the parameter is on its way, and between two pictures of it.
const WAY: Duration = Duration::from_millis(300);
pub(super) const FRAME: Duration = Duration::from_millis(16);

/// A target and what came of it.
#[derive(Clone, Debug)]
pub(super) struct Aim<const D: usize> {
    /// The form that came of it: only with this one the aim is shown.
    pub(super) form: Form<D>,
    /// Where the target is; in space, for a target by the mouse, the point of the curve under it.
    pub(super) target: Point<D>,
    pub(super) knob: Knob,
    pub(super) admissible: bool,
    pub(super) value: f64,
    /// The position on the curve, as `sample` counts.
    pub(super) position: f64,
    /// The nearest point that can be reached.
    pub(super) nearest: Point<D>,
    /// How far that is from the target.
    pub(super) distance: f64,
}

/// A parameter on its way.
#[derive(Clone, Debug)]
pub(super) struct Glide<const D: usize> {
    form: Form<D>,
    parameter: Parameter,
    ends: [f64; 2],
    since: Duration,
}

impl<const D: usize> Glide<D> {
    /// Whether it has arrived.
    pub(super) fn is_over(&self, now: Duration) -> bool {
        now.saturating_sub(self.since) >= WAY
    }

    /// The form on the way.
    pub(super) fn at(&self, now: Duration) -> Option<Form<D>> {
        let part = (now.saturating_sub(self.since).as_secs_f64() / WAY.as_secs_f64()).clamp(0.0, 1.0);
        let part = part * part * (3.0 - 2.0 * part);
        self.form.with(self.parameter, self.ends[0] + part * (self.ends[1] - self.ends[0])).ok()
    }
}

/// Where the user wants the curve to go.
enum Target<const D: usize> {
    Pixel((i32, i32)),
    Place(Point<D>),
}

/// Asks for a target and brings the curve there.
pub(super) async fn run<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>) -> Asked<()>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now().clone();
    let Some(knob) = editor.knob() else {
        desk.tell(texts::no_parameter(form.family()), Stay::UntilRead);
        return Ok(());
    };
    if form.through {
        desk.tell(texts::ALREADY_THROUGH, Stay::UntilRead);
        return Ok(());
    }
    let Ok(curve) = form.curve() else {
        desk.tell(texts::problem(&form).unwrap_or(words::NO_POINTS.into()), Stay::UntilRead);
        return Ok(());
    };
    let target = ask(editor, desk, &knob).await?;
    let found = match target {
        Target::Place(place) => {
            curve.through(knob.parameter, place).map(|reach| aimed(&curve, place, &reach))
        }
        Target::Pixel(at) => {
            let flat = <Here as Room<D>>::flat(&editor.lens, at);
            let place = <Here as Room<D>>::open_place(at);
            flattened(&curve, &editor.lens).and_then(|picture| picture.through(knob.parameter, flat)).map(
                |reach| {
                    let point = reach_point(&curve, knob.parameter, &reach).unwrap_or([0.0; D]);
                    let reach = Reach {
                        admissible: reach.admissible,
                        value: reach.value,
                        span: reach.span,
                        x: reach.x,
                        point,
                        distance: reach.distance,
                    };
                    aimed(&curve, place.unwrap_or(point), &reach)
                },
            )
        }
    };
    match found {
        Ok((target, position, reach)) => arrive(editor, desk, (form, knob), (target, position, reach)),
        Err(error) => desk.tell(words::no_curve(&error), Stay::UntilRead),
    }
    Ok(())
}

type Found<const D: usize> = (Point<D>, f64, Reach<D>);

fn aimed<const D: usize>(curve: &ShapedCurve<D>, target: Point<D>, reach: &Reach<D>) -> Found<D> {
    (target, curve.basis().position(reach.span, reach.x), *reach)
}

/// The curve as the picture has it.
fn flattened<const D: usize>(
    curve: &ShapedCurve<D>,
    lens: &impl Lens<D>,
) -> Result<ShapedCurve<2>, GeometryError> {
    let flat = |points: &[Point<D>]| points.iter().map(|&point| lens.flat(point)).collect();
    let picture = ShapedCurve::new(curve.basis().family().clone(), flat(curve.points()), curve.closed())?;
    match curve.blend() {
        Some(blend) => picture.with_blend(flat(blend)),
        None => Ok(picture),
    }
}

/// The point of the curve itself that the picture's search found.
fn reach_point<const D: usize>(
    curve: &ShapedCurve<D>,
    parameter: Parameter,
    reach: &Reach<2>,
) -> Option<Point<D>> {
    curve.path(parameter, reach.span, reach.x, &[reach.value]).ok()?.first().copied()
}

/// Waits for a click on the picture, or for the coordinates after Enter.
async fn ask<const D: usize>(editor: &Bench<D>, desk: &mut Desk<'_>, knob: &Knob) -> Asked<Target<D>>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    loop {
        let over = Over::new(editor, |screen: &mut Screen, language: Language| {
            page(screen, TOP);
            let moved = texts::aiming(&dial::name(knob));
            screen.text(TOP.0 + 8, TOP.1 + 7, moved.of(language), Color::Black);
            screen.text(TOP.0 + 8, TOP.1 + 18, texts::CLICK_TARGET.of(language), Color::Black);
            screen.text(TOP.0 + 8, TOP.1 + 29, texts::TARGET_KEYS.of(language), Color::Black);
        });
        let tick = desk.event_asked(&over, Request::Keys(Vec::new())).await?;
        if tick.pressed(Key::Esc) {
            return Err(Stop::Cancelled);
        }
        if tick.pressed(Key::Enter) {
            return Ok(Target::Place(<Here as Room<D>>::ask_place(desk, editor).await?));
        }
        match tick.click() {
            Some((x, y)) if PICTURE.holds(x, y) => return Ok(Target::Pixel((x, y))),
            Some(_) => return Err(Stop::Cancelled),
            None => {}
        }
    }
}

/// Shows the answer; the parameter goes where the curve reaches the target.
fn arrive<const D: usize>(
    editor: &mut Bench<D>,
    desk: &mut Desk<'_>,
    (form, knob): (Form<D>, Knob),
    (target, position, reach): Found<D>,
) where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let moved = form.with(knob.parameter, reach.value).ok().filter(|_| reach.admissible);
    let aim = Aim {
        form: moved.clone().unwrap_or_else(|| form.clone()),
        target,
        knob,
        admissible: moved.is_some(),
        value: reach.value,
        position,
        nearest: reach.point,
        distance: reach.distance,
    };
    if let Some(moved) = moved {
        editor.change(moved);
        if let Some(from) = form.value(knob.parameter) {
            let (parameter, ends) = (knob.parameter, [from, reach.value]);
            editor.craft.glide = Some(Glide { form, parameter, ends, since: desk.clock() });
        }
    }
    editor.craft.aim = Some(aim);
}
