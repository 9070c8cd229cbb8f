//! What is seen: the curves and points, and what is written beside them.

use super::aim::Aim;
use super::craft::{Bench, Handle};
use super::points::{full, steps};
use super::room::{Here, Room};
use super::{basis, dial, texts, traces};
use crate::design::Place;
use crate::editor::comb;
use crate::editor::lens::Lens;
use crate::editor::picture::{Layer, Page};
use crate::editor::seen::Item;
use crate::editor::stage::Stage;
use crate::figure::wrap;
use crate::file::Places;
use crate::geometry::shaped::{Family, ShapedCurve};
use crate::geometry::{Closure, ParamCurve, Point};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::words::{self, Words};
use crate::ui::{Hint, Phrase, TOP};
use serde::Serialize;

/// Letters in a line of the page, the left edge of its text, and its lines.
const LETTERS: usize = 28;
const LEFT: i32 = TOP.0 + 8;
const LINES: [i32; 3] = [TOP.1 + 4, TOP.1 + 13, TOP.1 + 22];
const HINT: (i32, i32) = (TOP.0 + 8, TOP.1 + 32);
/// Pixels of sides that are drawn.
const FAR: i32 = 20_000;
/// Half the size of the cross at a target.
const CROSS: i32 = 5;

/// The index of the middle point of a trigonometric curve, if it has no influence.
pub(super) fn dead<const D: usize>(editor: &Bench<D>) -> Option<usize>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    match editor.drawn().parameters() {
        Ok(Family::Trig(trig)) if trig.middle_is_dead() => Some(trig.sides()[0]),
        _ => None,
    }
}

/// The visible items, topmost last.
pub(super) fn items<const D: usize>(editor: &Bench<D>) -> Vec<Item<D>>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let (mut items, form, options) = (Vec::new(), editor.drawn(), editor.craft.options);
    let curve = editor.curve();
    if options.cubic
        && let Some(cubic) = form.cubic()
    {
        let (steps, stroke) = (steps(cubic.spans()), Stroke::thick(Color::DarkGray));
        items.push(Item::Curve { curve: cubic, steps, stroke, name: None });
    }
    if let (Some(curve), Some(scale)) = (&curve, options.comb) {
        comb::add_comb(curve, scale, &mut items);
    }
    if let Some(knob) = editor.knob() {
        if options.series {
            traces::add_series(&form, &knob, &mut items);
        }
        if options.paths {
            traces::add_paths(&traces::paths(&form, &knob), &mut items);
        }
    }
    let points = editor.stage != (Stage::Result { points: false });
    if points {
        let polygon = curve.as_ref().map_or(&form.points[..], |curve| curve.points());
        let sides = polygon.windows(2).map(|pair| [pair[0], pair[1]]);
        let closing = match (form.closure(), polygon) {
            (Closure::Closed, [first, .., last]) => Some([*last, *first]),
            _ => None,
        };
        // A side that ends far outside would be drawn in a wrong direction.
        let near = |ends: &[Point<D>; 2]| {
            ends.iter().all(|end| {
                let (x, y) = editor.lens.pixel(*end);
                x.abs().max(y.abs()) < FAR
            })
        };
        let shown = sides.chain(closing).filter(near);
        items.extend(shown.map(|ends| Item::Line { ends, ink: Color::LightGray }));
    }
    if let Some(curve) = curve {
        let (steps, stroke) = (steps(curve.spans()), Stroke::thick(Color::White));
        items.push(Item::Curve { curve: Box::new(curve), steps, stroke, name: None });
    }
    if points {
        add_points(editor, &mut items);
    }
    items
}

/// The points with their numbers, and the next one in the store.
fn add_points<const D: usize>(editor: &Bench<D>, items: &mut Vec<Item<D>>)
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let form = editor.history.now();
    let fill = |index: usize| match () {
        () if dead(editor) == Some(index) => Color::LightGray,
        () if form.through => Color::Blue,
        () => <Here as Room<D>>::FILL,
    };
    let held_at = |handle| editor.held.filter(|held| held.handle == handle).map(|held| held.at);
    let points: Vec<Point<D>> = (0..)
        .zip(&form.points)
        .map(|(index, &point)| held_at(Handle::Point(index)).unwrap_or(point))
        .collect();
    let dots = editor.stage.is_result() && D == 3;
    for index in editor.lens.order(&points) {
        // The indices come from these points.
        let Some(&at) = points.get(index) else { continue };
        let disc = Item::Disc { at, number: index + 1, fill: fill(index) };
        items.push(if dots { Item::Dot(at) } else { disc });
    }
    if let Some((Handle::New(index), at)) = editor.held.map(|held| (held.handle, held.at)) {
        items.push(Item::Disc { at, number: index + 1, fill: <Here as Room<D>>::FILL });
    }
    let empty = !editor.stage.begun() || editor.stage.is_result();
    if let Some(store) = <Here as Room<D>>::STORE.filter(|_| !empty && !full(form)) {
        let number = form.points.len() + 1;
        let (at, fill) = (held_at(Handle::Point(form.points.len())), <Here as Room<D>>::FILL);
        items.push(match at {
            Some(at) if at.fits() => Item::Disc { at, number, fill },
            at => Item::Stored { at: at.unwrap_or(store), number, fill },
        });
    }
}

/// Draws a layer.
pub(super) fn draw<const D: usize>(editor: &Bench<D>, layer: Layer, page: &mut Page<'_>)
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    match layer {
        Layer::Under if D == 2 && !editor.stage.is_result() => {
            let store = words::STORE.of(page.language);
            let width = 8 * i32::try_from(store.chars().count()).unwrap_or(0);
            page.screen.text(631 - width, 67, store, Color::White);
        }
        Layer::Over => draw_over(editor, page),
        Layer::Titles => draw_titles(editor, page),
        Layer::Frame => draw_place(editor, page),
        _ => {}
    }
}

/// In space, the line under the picture: the place of the point being dragged or changed.
fn draw_place<const D: usize>(editor: &Bench<D>, page: &mut Page<'_>)
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let held = editor.held.map(|held| held.handle);
    let Some(Handle::Point(index)) = held.or(editor.craft.pointed_out.map(Handle::Point)) else { return };
    if let Some([x, y, z]) = editor.preview().points.get(index).map(|point| point.as_slice()) {
        let text = words::place_of(index + 1, [*x, *y, *z]);
        page.screen.text(130, 470, text.of(page.language), Color::Black);
    }
}

/// Ticks of paths, lambdas of points, the target, the window of the functions.
fn draw_over<const D: usize>(editor: &Bench<D>, page: &mut Page<'_>)
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let (form, lens, options) = (editor.drawn(), &editor.lens, editor.craft.options);
    let screen = &mut *page.screen;
    if let Some(knob) = editor.knob().filter(|_| options.paths) {
        for tick in traces::paths(&form, &knob).ticks {
            let (x, y) = lens.pixel(tick);
            screen.bar(x - 1, y - 1, x + 1, y + 1, Color::Yellow);
        }
    }
    if editor.stage != (Stage::Result { points: false }) {
        let own = form.lambdas().unwrap_or(&[]).iter().zip(&form.points).enumerate();
        for (index, (lambda, point)) in own {
            let ink = if editor.craft.joint == Some(index) { Color::LightGreen } else { Color::Yellow };
            beside(screen, lens.pixel(*point), &texts::short(*lambda), ink);
        }
    }
    if let Some(aim) = aim_shown(editor).filter(|_| editor.held.is_none()) {
        draw_aim(aim, lens, screen);
    }
    if let Some(curve) = editor.curve().filter(|_| options.basis && !editor.stage.is_result()) {
        basis::draw(&form, &curve, span_at_mouse(editor, &curve), screen, page.language);
    }
}

/// A text on black to the upper right of a point.
fn beside(screen: &mut Screen, (x, y): (i32, i32), text: &str, ink: Color) {
    let width = 8 * i32::try_from(text.len()).unwrap_or(0);
    screen.bar(x + 8, y - 19, x + 8 + width, y - 9, Color::Black);
    screen.text(x + 9, y - 18, text, ink);
}

/// The aim, as long as nothing else has been done.
pub(super) fn aim_shown<const D: usize>(editor: &Bench<D>) -> Option<&Aim<D>>
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    editor.craft.aim.as_ref().filter(|aim| aim.form == *editor.history.now())
}

fn draw_aim<const D: usize>(aim: &Aim<D>, lens: &impl Lens<D>, screen: &mut Screen) {
    let (x, y) = lens.pixel(aim.target);
    let stroke = Stroke::thick(if aim.admissible { Color::LightCyan } else { Color::LightRed });
    screen.line(x - CROSS, y, x + CROSS, y, stroke);
    screen.line(x, y - CROSS, x, y + CROSS, stroke);
    if !aim.admissible {
        let (to_x, to_y) = lens.pixel(aim.nearest);
        screen.line(x, y, to_x, to_y, Stroke::thin(Color::LightRed).dotted());
        screen.circle(to_x, to_y, 4, Stroke::thick(Color::LightRed));
    }
}

/// The arc of a spline that is nearest to the mouse.
fn span_at_mouse<const D: usize>(editor: &Bench<D>, curve: &ShapedCurve<D>) -> usize
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let (at_x, at_y) = editor.craft.mouse;
    let far = |span: &usize| {
        let pixels = (0..=8).filter_map(|k| curve.eval(*span, f64::from(k) / 8.0));
        let far = |(x, y): (i32, i32)| i64::from(x - at_x).pow(2) + i64::from(y - at_y).pow(2);
        pixels.map(|point| far(editor.lens.pixel(point))).min().unwrap_or(i64::MAX)
    };
    if basis::holds(editor.craft.mouse) { 0 } else { (0..curve.spans()).min_by_key(far).unwrap_or(0) }
}

/// Family, parameters, and what the page says.
fn draw_titles<const D: usize>(editor: &Bench<D>, page: &mut Page<'_>)
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    dial::draw(editor, page);
    let (language, form) = (page.language, editor.drawn());
    let screen = &mut *page.screen;
    if let Some(problem) = texts::problem(&form) {
        for (line, y) in wrap(problem.of(language), LETTERS).iter().zip(LINES) {
            screen.text(LEFT, y, line, Color::Red);
        }
        return;
    }
    let Some(curve) = form.curve().ok() else { return };
    let facts = texts::facts(form.points.len(), curve.spans(), comb::length(&curve), form.through);
    screen.text(LEFT, LINES[0], facts.of(language), Color::Black);
    let mut lines: Vec<(Phrase, Color)> = Vec::new();
    if let Some(aim) = aim_shown(editor).filter(|_| editor.held.is_none()) {
        let name = dial::name(&aim.knob);
        lines.push(match aim.admissible {
            true => (texts::reached(&name, aim.value, aim.position), Color::Blue),
            false => (texts::not_reached(aim.distance), Color::Red),
        });
    }
    if let Some(index) = dead(editor) {
        lines.push((texts::dead(index + 1), Color::Red));
    }
    if let Some(knob) = editor.knob().filter(|_| editor.craft.options.series) {
        lines.push((texts::series(knob.range), Color::Black));
    }
    for ((line, ink), y) in lines.iter().zip(&LINES[1..]) {
        screen.text(LEFT, *y, line.of(language), *ink);
    }
}

/// What can be done now.
pub(super) fn hint<const D: usize>(editor: &Bench<D>) -> Hint
where
    Here: Room<D>,
    Point<D>: Place<D> + Serialize,
    Vec<Point<D>>: Into<Places>,
{
    let text: Words = match () {
        () if editor.held.is_some() => texts::HINT_HELD,
        () if editor.history.now().points.is_empty() && D == 2 => texts::HINT_EMPTY,
        () if editor.history.now().points.is_empty() => texts::HINT_EMPTY_SPACE,
        () if editor.craft.options.comb.is_some() => texts::HINT_COMB,
        () => texts::HINT_EDIT,
    };
    Hint::at(HINT, LETTERS, text)
}
