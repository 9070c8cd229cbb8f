//! The command G: the family, and what it needs.

use super::craft::Bench;
use super::form::Form;
use super::kinds::{KINDS, Kind, Needs, beginning};
use super::room::{Here, Room};
use super::texts;
use crate::design::{Edit, Place};
use crate::editor::curve::ask::ask_closure;
use crate::file::{FamilyName, Places};
use crate::geometry::Point;
use crate::geometry::shaped::{Family, MAX_SIDE_POINTS, Phi, Trig};
use crate::machine::{Asked, Key, Language, Request, Stop};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::words;
use crate::ui::{
    Answer, Area, Caption, Choices, Desk, Field, Form as Entries, Number, Over, Picture, Question, Stay, TOP,
    panel,
};
use serde::Serialize;

/// The list.
const PAGE: Area = Area::new(120, 110, 520, 300);
const ROW: i32 = 14;

/// The row of a kind.
fn row(index: i32) -> Area {
    let y = PAGE.y1 + 20 + ROW * index;
    Area::new(PAGE.x1 + 8, y - 3, PAGE.x2 - 8, y + 11)
}

/// Asks for a family and takes the points over into it.
pub(super) async fn run<const D: usize>(editor: &mut Bench<D>, desk: &mut Desk<'_>) -> Asked<()>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let before = editor.history.now().clone();
    let kind = ask_kind(editor, desk, before.family()).await?;
    let family = match kind.name {
        FamilyName::TrigBezier => Family::Trig(ask_trig(editor, desk, &before).await?),
        name => beginning(name, &before),
    };
    let bezier = matches!(family, Family::FBezier { .. } | Family::Trig(_));
    let closed = !bezier && kind.name != FamilyName::Cyclic && ask_closure(desk, editor).await?;
    let form = before.by(kind.name, &family, closed);
    let count = form.points.len();
    let form = match Needs::of(&form) {
        Needs::Exactly(needed) if count > needed => {
            let facts = texts::too_many(kind.name, needed, count);
            let question = Question::yes_no(texts::keep_first(needed));
            if desk.ask_about(editor, &facts, question).await? == Answer::Second {
                return Ok(());
            }
            form.shortened(needed)
        }
        Needs::Odd if count > 1 && count.is_multiple_of(2) => {
            desk.tell(texts::made_odd(count + 1), Stay::UntilRead);
            with_one_more(&form)
        }
        _ => form,
    };
    (editor.craft.active, editor.craft.joint) = (0, None);
    if before.through && !form.through {
        desk.tell(texts::NO_DATA, Stay::UntilRead);
    }
    editor.change(form);
    if let Some(problem) = texts::problem(editor.history.now()) {
        desk.tell(problem, Stay::UntilRead);
    }
    Ok(())
}

/// One point more, between the last and the first.
fn with_one_more<const D: usize>(form: &Form<D>) -> Form<D>
where
    Point<D>: Place<D>,
{
    let (Some(first), Some(last)) = (form.points.first(), form.points.last()) else { return form.clone() };
    let middle = std::array::from_fn(|axis| 0.5 * (first[axis] + last[axis]));
    form.edited(Edit::Insert(form.points.len(), middle))
}

/// The list of the families.
async fn ask_kind(picture: &dyn Picture, desk: &mut Desk<'_>, present: FamilyName) -> Asked<&'static Kind> {
    loop {
        let over = Over::new(picture, |screen: &mut Screen, language: Language| {
            draw_list(screen, language, present);
        });
        let tick = desk
            .event_asked(&over, Request::Keys(KINDS.iter().map(|kind| Key::Char(kind.key)).collect()))
            .await?;
        if tick.pressed(Key::Esc) {
            return Err(Stop::Cancelled);
        }
        if let Some((x, y)) = tick.click() {
            let hit = (0..).zip(&KINDS).find(|(at, _)| row(*at).holds(x, y));
            return hit.map(|(_, kind)| kind).ok_or(Stop::Cancelled);
        }
        let pressed = if tick.pressed(Key::Enter) {
            KINDS.iter().find(|kind| kind.name == present)
        } else {
            KINDS.iter().find(|kind| tick.letter() == Some(kind.key))
        };
        if let Some(kind) = pressed {
            return Ok(kind);
        }
    }
}

fn draw_list(screen: &mut Screen, language: Language, present: FamilyName) {
    let Area { x1, y1, x2, y2 } = PAGE;
    panel(screen, x1, y1, x2 - x1, y2 - y1);
    screen.text(x1 + 12, y1 + 6, texts::ASK_FAMILY.of(language), Color::Black);
    for (at, kind) in (0..).zip(&KINDS) {
        let y = row(at).y1 + 3;
        if kind.name == present {
            let Area { x1, y1, x2, y2 } = row(at);
            screen.rectangle(x1, y1, x2, y2, Stroke::thin(Color::Blue));
        }
        screen.text(x1 + 14, y, &kind.key.to_string(), Color::Red);
        screen.text(x1 + 30, y, kind.title.of(language), Color::Black);
        screen.text(x1 + 148, y, kind.about.of(language), Color::Blue);
    }
    screen.text(x1 + 12, y2 - 11, texts::FAMILY_KEYS.of(language), Color::Black);
}

/// The numbers of a trigonometric Bézier curve. Proposed are those that take all points.
async fn ask_trig<const D: usize>(picture: &Bench<D>, desk: &mut Desk<'_>, before: &Form<D>) -> Asked<Trig>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let old = match before.parameters() {
        Ok(Family::Trig(trig)) => Some(trig),
        _ => None,
    };
    let count = before.points.len();
    let most = 2 * MAX_SIDE_POINTS + 1;
    let n1 = (count.clamp(3, most) - 1) / 2;
    let fitting = if count < 3 { [2, 2] } else { [n1, count.clamp(3, most) - 1 - n1] };
    let sides = old.map_or(fitting, |old| old.sides());
    loop {
        let field = |x: i32| Field {
            area: Area::new(x, TOP.1 + 19, x + 28, TOP.1 + 32),
            at: (x + 6, TOP.1 + 22),
            longest: 2,
            kind: Number::Whole(1..=MAX_SIDE_POINTS as i32),
        };
        let caption = |x: i32, text| Caption::new((TOP.0 + x, TOP.1 + 22), text).colored(Color::LightMagenta);
        let captions = vec![
            Caption::new((TOP.0 + 12, TOP.1 + 7), texts::SIDES),
            caption(20, words::Words("n1 =", "n1 =")),
            caption(116, words::Words("n2 =", "n2 =")),
        ];
        let form = Entries::new(captions, [field(TOP.0 + 60), field(TOP.0 + 156)]);
        let [n1, n2] = desk.numbers_or(picture, &form, sides.map(|n| n.to_string())).await?;
        // The fields take no other numbers.
        let [n1, n2] = [n1, n2].map(|n| n as usize);
        let phi = ask_phi(desk, picture, old.map(|old| old.phi())).await?;
        let kept = old.filter(|old| old.sides() == [n1, n2]).map(|old| old.exponents());
        let [alpha, beta] = kept.unwrap_or([n1 as f64 + 1.0, n2 as f64 + 1.0]);
        match Trig::new(n1, n2, alpha, beta, phi) {
            Ok(trig) => return Ok(trig),
            Err(_) => desk.tell(texts::ONLY_RATIONAL, Stay::UntilRead),
        }
    }
}

async fn ask_phi(desk: &mut Desk<'_>, picture: &dyn Picture, present: Option<Phi>) -> Asked<Phi> {
    let (x, y) = TOP;
    let window = |from: i32, to: i32| Area::new(x + from, y + 21, x + to, y + 34);
    let answers = vec![
        (window(6, 66), texts::TRIG, Phi::Trig),
        (window(72, 156), texts::POWER, Phi::Power),
        (window(162, 232), texts::RATIONAL, Phi::Rational),
    ];
    let captions = vec![Caption::new((x + 7, y + 8), texts::ASK_PHI)];
    let default = desk.machine.manner() == crate::machine::Manner::Today;
    let choices = Choices { place: TOP, captions, answers };
    desk.choose_or(picture, &choices, present.or(Some(Phi::Trig)).filter(|_| default)).await
}
