//! What is seen: circles, skin, what explains it, and what is written beside them.

use super::craft::{Bench, NEW_RADIUS, STORE};
use super::discs::{Disc, Dot, Filling, Line, Rim};
use super::dressed::{Dressed, Style};
use super::{texts, value};
use crate::editor::field::numbered_disc;
use crate::editor::picture::{Layer, Page};
use crate::editor::seen::{Item, Own};
use crate::editor::stage::Stage;
use crate::figure::{is_hole, wrap};
use crate::file::Circles;
use crate::geometry::skin::{Cap, Links, Outline, Piece, TouchingShape};
use crate::geometry::{Point, norm};
use crate::screen::{Color, Stroke};
use crate::ui::words::Words;
use crate::ui::{Hint, Phrase, TOP};
use std::f64::consts::PI;

/// Letters in a line of the page, the left edge of its text, and its lines.
pub(super) const LETTERS: usize = 28;
const LEFT: i32 = TOP.0 + 8;
const LINES: [i32; 3] = [TOP.1 + 4, TOP.1 + 13, TOP.1 + 22];
pub(super) const HINT: (i32, i32) = (TOP.0 + 8, TOP.1 + 32);
/// Where it stands whether the circles are admissible.
const STATUS: (i32, i32) = (7, 5);
/// How much of a touching circle is drawn: as far as any pixel of the field is from another.
const FAR: f64 = 700.0;
/// How far radical lines are drawn to a power point.
const NEAR: f64 = 420.0;
/// Half the size of a power point's cross.
const CROSS: f64 = 4.0;
/// So many circles are numbered, of more those with this radius at least.
const FEW: usize = 30;
const ROOM: f64 = 9.0;
/// Steps of a touching circle.
const STEPS: usize = 160;

fn own(item: impl Own<2> + 'static) -> Item<2> {
    Item::Own(Box::new(item))
}

/// The visible items, topmost last.
pub(super) fn items(editor: &Bench) -> Vec<Item<2>> {
    let (value, options) = (editor.preview(), editor.craft.options);
    let dressed = editor.dressed();
    let rule = |index: usize| dressed.as_ref().and_then(|dressed| dressed.rule(index));
    let discs = editor.stage != (Stage::Result { points: false });
    let filled = options.style == Style::Filled;
    let mut items = Vec::new();
    if let Some(dressed) = dressed.as_ref().filter(|_| filled) {
        let sound = dressed.violations.is_empty();
        add_filling(dressed, if sound { Color::Blue } else { Color::DarkGray }, &mut items);
    }
    if discs {
        for (index, &row) in value.circles.iter().enumerate() {
            if rule(index).is_some() {
                items.push(own(Disc { row, fill: Color::Red }));
            } else if !filled {
                items.push(own(Disc { row, fill: Color::DarkGray }));
            }
        }
        if value.edges.is_some() {
            add_links(&value, &mut items);
        }
    }
    if let Some(dressed) = &dressed {
        if options.apollonius {
            add_touching_circles(dressed, &mut items);
        }
        if options.radical {
            add_radical(dressed, &mut items);
        }
    }
    if discs {
        let few = value.circles.len() <= FEW;
        for (index, &row) in value.circles.iter().enumerate() {
            let (rule, named) = (rule(index), few || row[2] >= ROOM);
            items.push(own(Rim { row, number: index + 1, rule, named }));
        }
    }
    if let Some(dressed) = &dressed {
        let ink = if dressed.violations.is_empty() { Color::White } else { Color::LightGray };
        let outlines = dressed.outlines(options.style).into_iter();
        items.extend(outlines.map(|outline| own(Line { outline, ink })));
        if discs {
            items.extend(dressed.skin.touches.iter().map(|touch| own(Dot(touch.point, Color::LightGreen))));
        }
    }
    items
}

/// What the outlines enclose, and on it what the inner ones leave free.
fn add_filling(dressed: &Dressed, fill: Color, items: &mut Vec<Item<2>>) {
    let closed = dressed.outlines(Style::Filled).into_iter().filter(|outline| outline.closed);
    let (holes, bodies): (Vec<Outline>, Vec<Outline>) = closed.partition(is_hole);
    items.extend(bodies.into_iter().map(|outline| own(Filling { outline, fill })));
    items.extend(holes.into_iter().map(|outline| own(Filling { outline, fill: Color::Black })));
}

/// The links of a tree.
fn add_links(circles: &Circles, items: &mut Vec<Item<2>>) {
    let center = |index: usize| circles.circles.get(index).map(|&[x, y, _]| [x, y]);
    let ends = value::edges(circles).into_iter().filter_map(|[a, b]| Some([center(a)?, center(b)?]));
    items.extend(ends.map(|ends| Item::Line { ends, ink: Color::LightCyan }));
}

fn add_touching_circles(dressed: &Dressed, items: &mut Vec<Item<2>>) {
    for touching in dressed.circles.apollonius() {
        match touching.shape {
            TouchingShape::Circle(disc) => {
                let [x, y]: Point<2> = std::array::from_fn(|d| touching.touch[d] - disc.center[d]);
                let (middle, half) = (y.atan2(x), PI.min(FAR / disc.radius));
                let angles = [middle - half, middle + half];
                let [start, end] = angles.map(|angle| disc.point([angle.cos(), angle.sin()]));
                let cap = Cap { circle: touching.circles[1], disc, start, end, angles };
                let curve = Outline { pieces: vec![Piece::Cap(cap)], closed: false };
                let stroke = Stroke::thin(Color::Yellow);
                items.push(Item::Curve { curve: Box::new(curve), steps: STEPS, stroke, name: None });
            }
            TouchingShape::Line(direction) => {
                items.push(segment(touching.touch, direction, FAR, Color::Yellow));
            }
        }
    }
}

fn segment(at: Point<2>, direction: Point<2>, half: f64, ink: Color) -> Item<2> {
    let end = |by: f64| -> Point<2> { std::array::from_fn(|d| at[d] + by * direction[d]) };
    Item::Line { ends: [end(-half), end(half)], ink }
}

/// Radical lines as far as the power points on them, and these.
fn add_radical(dressed: &Dressed, items: &mut Vec<Item<2>>) {
    let points = dressed.circles.power_points();
    for line in dressed.circles.radical_lines() {
        let radius = |index: &usize| dressed.circles.circles().get(*index).map_or(0.0, |it| it.radius);
        let least = 1.5 * line.circles.iter().map(radius).fold(10.0, f64::max);
        let of_it = points.iter().filter(|point| line.circles.iter().all(|it| point.circles.contains(it)));
        let far = |point: Point<2>| norm(std::array::from_fn::<f64, 2, _>(|d| point[d] - line.point[d]));
        let half = of_it.map(|it| far(it.point) + 20.0).filter(|far| *far < NEAR).fold(least, f64::max);
        items.push(segment(line.point, line.direction, half, Color::LightMagenta));
    }
    for point in points {
        for direction in [[1.0, 0.0], [0.0, 1.0]] {
            items.push(segment(point.point, direction, CROSS, Color::LightCyan));
        }
    }
}

/// Draws a layer.
pub(super) fn draw(editor: &Bench, layer: Layer, page: &mut Page<'_>) {
    match layer {
        Layer::Under if !editor.stage.is_result() => {
            let store = Words("Tár", "New").of(page.language);
            let width = 8 * i32::try_from(store.chars().count()).unwrap_or(0);
            page.screen.text(631 - width, 67, store, Color::White);
        }
        Layer::Over => draw_over(editor, page),
        Layer::Titles => draw_titles(editor, page),
        _ => {}
    }
}

/// The next circle in the store, what is held outside the field, and the circle that a question is about.
fn draw_over(editor: &Bench, page: &mut Page<'_>) {
    let circles = editor.history.now();
    if editor.stage.begun() && !editor.stage.is_result() && !value::is_full(circles) {
        numbered_disc(page.screen, editor.pixel(STORE), circles.circles.len() + 1, Color::DarkGray);
    }
    if let Some([x, y, r]) = editor.loose() {
        let (x, y) = editor.pixel([x, y]);
        page.screen.circle(x, y, r.clamp(1.0, NEW_RADIUS) as i32, Stroke::thin(Color::LightRed).dotted());
    }
    let pointed = editor.craft.pointed_out.and_then(|index| circles.circles.get(index));
    if let Some(&[x, y, r]) = pointed {
        let (x, y) = editor.pixel([x, y]);
        page.screen.circle(x, y, crate::ui::look::pixel(r), Stroke::thick(Color::LightGreen));
    }
}

/// Whether the circles are admissible, and what the page says.
fn draw_titles(editor: &Bench, page: &mut Page<'_>) {
    let Some(dressed) = editor.dressed() else { return };
    let count = dressed.circles.circles().len();
    let kind = match dressed.circles.links() {
        Links::Chain => texts::CHAIN,
        Links::Ring => texts::RING,
        Links::Edges(_) => texts::TREE,
    };
    let arcs = dressed.skin.loops.iter().map(|outline| outline.arcs().count()).sum();
    let unclear = dressed.skin.unclear();
    let note: Option<Phrase> = match (unclear.first(), dressed.skin.missing.first()) {
        (Some(&arc), _) => Some(texts::unclear(arc, unclear.len() - 1)),
        (None, Some(&circle)) => Some(texts::missing(circle)),
        (None, None) => None,
    };
    say_status(page, texts::rule(&dressed.violations), &texts::facts(count, arcs, kind), note);
}

/// Says whether circles or spheres are admissible, and the broken rule or what there is, with a remark.
pub(super) fn say_status(page: &mut Page<'_>, broken: Option<Phrase>, facts: &Phrase, note: Option<Phrase>) {
    let (language, screen) = (page.language, &mut *page.screen);
    let (status, ink) = match &broken {
        Some(_) => (texts::NOT_ADMISSIBLE, Color::Red),
        None => (texts::ADMISSIBLE, Color::Blue),
    };
    screen.text(STATUS.0, STATUS.1, status.of(language), ink);
    if let Some(broken) = broken {
        for (line, y) in wrap(broken.of(language), LETTERS).iter().zip(LINES) {
            screen.text(LEFT, y, line, Color::Red);
        }
        return;
    }
    screen.text(LEFT, LINES[0], facts.of(language), Color::Black);
    if let Some(note) = note {
        screen.text(LEFT, LINES[1], note.of(language), Color::Red);
    }
}

/// What can be done now.
pub(super) fn hint(editor: &Bench) -> Option<Hint> {
    let text: Words = match () {
        () if editor.held.is_some() => texts::HINT_HELD,
        () if editor.history.now().circles.is_empty() => texts::HINT_EMPTY,
        () => texts::HINT_EDIT,
    };
    Some(Hint::at(HINT, LETTERS, text))
}
