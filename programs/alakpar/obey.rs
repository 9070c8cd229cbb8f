//! The commands.

use super::commands::Action;
use super::craft::{Bench, Handle};
use super::dial;
use super::form::{Form, is_local};
use super::kinds::Knob;
use super::room::{Here, Room};
use super::{aim, choose, points, texts};
use crate::design::{Edit, Place};
use crate::editor::Craft;
use crate::editor::curve::ask::{ask_existing, ask_index};
use crate::editor::stage::Stage;
use crate::file::{MAX_POINTS, Places};
use crate::geometry::Point;
use crate::geometry::shaped::Parameter;
use crate::machine::{Asked, Stop};
use crate::ui::{Answer, Desk, Picture, Question, Stay, TOP, words};
use crate::work::{Next, quit};
use serde::Serialize;

/// The scale of a comb that nobody has changed yet.
const COMB: f64 = 2000.0;

/// Carries out a command.
pub(super) async fn carry_out<const D: usize>(
    editor: &mut Bench<D>,
    desk: &mut Desk<'_>,
    action: Action,
) -> Asked<Next>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now().clone();
    match action {
        Action::Insert => {
            if points::full(&form) {
                desk.tell(words::FULL, Stay::Briefly);
                return Ok(Next::Work);
            }
            let index = ask_index(desk, editor).await?;
            let place = <Here as Room<D>>::ask_place(desk, editor).await?;
            editor.change(form.edited(Edit::Insert(index, place)));
        }
        Action::Change => {
            let index = ask_existing(desk, editor, form.points.len()).await?;
            editor.craft.pointed_out = Some(index);
            let edit = ask_edit(editor, desk, index).await;
            editor.craft.pointed_out = None;
            editor.change(form.edited(edit?));
        }
        Action::Delete => {
            let index = ask_existing(desk, editor, form.points.len()).await?;
            editor.change(form.edited(Edit::Delete(index)));
        }
        Action::DeleteHere => {
            let mouse = desk.machine.mouse();
            match points::at(editor, (mouse.x, mouse.y)) {
                Some(Handle::Point(index)) if index < form.points.len() => {
                    editor.change(form.edited(Edit::Delete(index)));
                    desk.tell(words::deleted(index + 1), Stay::Briefly);
                }
                _ => desk.tell(words::NOTHING_HERE, Stay::Briefly),
            }
        }
        Action::Family => choose::run(editor, desk).await?,
        Action::Result => editor.show_result(desk).await?,
        Action::Number(number) => change_number(editor, desk, number).await?,
        Action::Paths => toggle(editor, desk, |options| &mut options.paths),
        Action::Series => toggle(editor, desk, |options| &mut options.series),
        Action::Cubic => editor.craft.options.cubic ^= true,
        Action::Basis => editor.craft.options.basis ^= true,
        Action::Comb => {
            let options = &mut editor.craft.options;
            match options.comb.take() {
                Some(scale) => options.last_comb = Some(scale),
                None => options.comb = Some(options.last_comb.unwrap_or(COMB)),
            }
        }
        Action::Through => aim::run(editor, desk).await?,
        Action::Data => {
            if form.can_interpolate() {
                let told = if form.through { texts::IS_CONTROL } else { texts::IS_DATA };
                editor.change(form.through(!form.through));
                desk.tell(told, Stay::Briefly);
            } else {
                desk.tell(texts::NO_DATA, Stay::UntilRead);
            }
        }
        Action::Joint => change_joint(editor, desk).await?,
        Action::Alike => make_alike(editor, desk),
        Action::Elevate => elevate(editor, desk),
        Action::Elsewhere => {
            if editor.history.unsaved() {
                crate::work::offer_to_save(editor, desk).await?;
            }
            editor.craft.passage.lead(None);
            return Ok(Next::End);
        }
        Action::Quit => return quit(editor, desk).await,
    }
    Ok(Next::Work)
}

/// Turns something on or off that shows what a parameter does.
fn toggle<const D: usize>(
    editor: &mut Bench<D>,
    desk: &mut Desk<'_>,
    option: impl Fn(&mut super::craft::Options) -> &mut bool,
) where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let on = option(&mut editor.craft.options);
    *on = !*on;
    if *on && editor.knob().is_none() {
        *option(&mut editor.craft.options) = false;
        desk.tell(texts::no_parameter(editor.history.now().family()), Stay::UntilRead);
    }
}

async fn ask_edit<const D: usize>(
    editor: &Bench<D>,
    desk: &mut Desk<'_>,
    index: usize,
) -> Asked<Edit<Point<D>>>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let what = Question::new(TOP, words::ASK_CHANGE, [words::NUMBER, words::PLACE]);
    let count = editor.history.now().points.len();
    Ok(match desk.ask(editor, &what).await? {
        Answer::First => Edit::Renumber(index, ask_existing(desk, editor, count).await?),
        Answer::Second => Edit::Move(index, <Here as Room<D>>::ask_place(desk, editor).await?),
    })
}

/// A number within a range; `pi` and a decimal comma are understood.
async fn ask_number(
    desk: &mut Desk<'_>,
    picture: &dyn Picture,
    name: &str,
    range: [f64; 2],
    proposal: &str,
) -> Asked<f64> {
    let read = |text: &str| {
        let text = text.trim().replace(',', ".");
        let value =
            if text.eq_ignore_ascii_case("pi") { Some(std::f64::consts::PI) } else { text.parse().ok() };
        value
            .filter(|value| (range[0]..=range[1]).contains(value))
            .ok_or_else(|| texts::bad_number(name, range))
    };
    desk.meaning(picture, texts::ask_value(name, range), proposal, read).await
}

async fn ask_value<const D: usize>(
    editor: &Bench<D>,
    desk: &mut Desk<'_>,
    form: &Form<D>,
    knob: &Knob,
) -> Asked<f64>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let proposal = form.value(knob.parameter).map(|value| value.to_string()).unwrap_or_default();
    ask_number(desk, editor, &dial::name(knob), knob.allowed, &proposal).await
}

/// The commands A and C.
async fn change_number<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>, number: usize) -> Asked<()>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now().clone();
    let Some(knob) = editor.knobs().get(number).copied() else {
        desk.tell(texts::no_parameter(form.family()), Stay::UntilRead);
        return Ok(());
    };
    editor.craft.active = number;
    let value = ask_value(editor, desk, &form, &knob).await?;
    turned(editor, desk, &form, knob.parameter, value);
    Ok(())
}

fn turned<const D: usize>(
    editor: &mut Bench<D>,
    desk: &mut Desk<'_>,
    form: &Form<D>,
    parameter: Parameter,
    value: f64,
) where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    match form.with(parameter, value) {
        Ok(form) => editor.change(form),
        Err(error) => desk.tell(words::no_curve(&error), Stay::UntilRead),
    }
}

/// The key F5: the lambda of one point.
async fn change_joint<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>) -> Asked<()>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now().clone();
    if !form.parameters().is_ok_and(|family| is_local(&family)) {
        desk.tell(texts::NOT_LOCAL, Stay::UntilRead);
        return Ok(());
    }
    let count = form.points.len();
    if count == 0 {
        desk.tell(words::NO_POINTS, Stay::Briefly);
        return Ok(());
    }
    let proposal = editor.craft.joint.map(|joint| (joint + 1).to_string()).unwrap_or_default();
    let read = |text: &str| match text.trim().parse::<usize>() {
        Ok(number) if (1..=count).contains(&number) => Ok(number - 1),
        _ => Err(words::no_such_point(count)),
    };
    let joint = desk.meaning(editor, texts::POINT_NUMBER, &proposal, read).await?;
    let before = editor.craft.joint.replace(joint);
    let knob = editor.knobs().first().copied();
    let Some(knob) = knob else { return Ok(()) };
    match ask_value(editor, desk, &form, &knob).await {
        Ok(value) => turned(editor, desk, &form, knob.parameter, value),
        Err(Stop::Cancelled) => {
            editor.craft.joint = before;
            return Err(Stop::Cancelled);
        }
        Err(stop) => return Err(stop),
    }
    Ok(())
}

/// The key F6: the lambda of the chosen point, else of the first, for all.
fn make_alike<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>)
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now().clone();
    if !form.parameters().is_ok_and(|family| is_local(&family)) {
        desk.tell(texts::NOT_LOCAL, Stay::UntilRead);
        return;
    }
    let chosen = editor.craft.joint.take().unwrap_or(0);
    let lambda = form.lambdas().and_then(|all| all.get(chosen).copied());
    if let Some(lambda) = lambda {
        turned(editor, desk, &form, Parameter::Lambda, lambda);
    }
    desk.tell(texts::ALL_ALIKE, Stay::Briefly);
}

/// The key F8: a degree more for a cyclic curve.
fn elevate<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>)
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now().clone();
    if form.family() != crate::file::FamilyName::Cyclic {
        desk.tell(texts::NOT_CYCLIC, Stay::UntilRead);
        return;
    }
    if form.points.len() + 2 > MAX_POINTS {
        desk.tell(texts::no_elevation(MAX_POINTS), Stay::UntilRead);
        return;
    }
    match (texts::problem(&form), form.elevated()) {
        (None, Ok(raised)) if !form.points.is_empty() => {
            desk.tell(texts::elevated(raised.points.len()), Stay::Briefly);
            editor.change(raised);
        }
        (Some(problem), _) => desk.tell(problem, Stay::UntilRead),
        (_, Err(error)) => desk.tell(words::no_curve(&error), Stay::UntilRead),
        _ => desk.tell(words::NO_POINTS, Stay::Briefly),
    }
}

/// Whether there is a curve to show alone; asks whether with the points.
pub(super) async fn begin_result<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>) -> Asked<bool>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    if editor.history.now().points.is_empty() {
        desk.tell(words::NO_POINTS, Stay::Briefly);
        return Ok(false);
    }
    if let Some(problem) = <super::craft::Shaper<D> as Craft<D>>::problem(editor) {
        desk.tell(problem, Stay::UntilRead);
        return Ok(false);
    }
    let answer = desk.ask(editor, &Question::yes_no(words::ASK_POINTS)).await?;
    editor.stage = Stage::Result { points: answer == Answer::First };
    Ok(true)
}
