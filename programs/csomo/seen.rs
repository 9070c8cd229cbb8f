//! The visible items of the field: polygon, curves, paths, envelope, comb, marks and control points.

use super::bench::{Bench, Curve, Handle, index};
use super::facts::Facts;
use super::rail::Stack;
use super::sheet::{self, STORE, Sheet, in_field};
use super::texts::PathKind;
use crate::editor::Editor;
use crate::editor::lens::Lens;
use crate::editor::seen::{Item, Own};
use crate::editor::stage::Stage;
use crate::figure::Figure;
use crate::file::{KnotPoints, MAX_POINTS};
use crate::geometry::knots::{KnotPath, KnotVector};
use crate::geometry::{BoundingBox, Closure, ParamCurve, Point};
use crate::screen::{Color, Screen, Stroke};

/// Values of a knot along a path.
const STEPS: usize = 64;
/// Segments of all spans together, and of one at least.
const SEGMENTS: usize = 240;
const FEWEST: usize = 12;
/// Teeth of a comb in a span, and the length of the longest in pixels.
const TEETH: u32 = 16;
const LONGEST: f64 = 60.0;
/// How many times its room a knot is followed beyond it.
const FARTHEST: f64 = 60.0;
/// Pixels between two places of a line that has gone through infinity.
const LEAP: f64 = 700.0;

/// A path as it is drawn.
pub(super) struct Path {
    pub(super) points: Vec<Point<2>>,
    pub(super) kind: PathKind,
    /// The control points of the side that it is parallel to.
    pub(super) side: Option<[usize; 2]>,
    /// Whether it is that of the marked parameter.
    pub(super) own: bool,
}

/// The target of a search.
struct Cross((i32, i32));

impl Own<2> for Cross {
    fn paint(&self, screen: &mut Screen) {
        let (x, y) = self.0;
        screen.line(x - 6, y, x + 6, y, Stroke::thick(Color::LightRed));
        screen.line(x, y - 6, x, y + 6, Stroke::thick(Color::LightRed));
    }

    fn plot(&self, _: &mut Figure) -> bool {
        true
    }

    fn bounds(&self) -> Option<BoundingBox<2>> {
        None
    }
}

/// The polygon, dashed in figures.
struct Polygon {
    points: Vec<Point<2>>,
    closed: bool,
}

impl Own<2> for Polygon {
    fn paint(&self, screen: &mut Screen) {
        let again = self.points.first().filter(|_| self.closed);
        let pixels: Vec<(i32, i32)> =
            self.points.iter().chain(again).map(|&point| Sheet.pixel(point)).collect();
        screen.polyline(&pixels, Stroke::thin(Color::Cyan));
    }

    fn plot(&self, figure: &mut Figure) -> bool {
        figure.plot_polygon(self.points.clone(), if self.closed { Closure::Closed } else { Closure::Open });
        true
    }

    fn bounds(&self) -> Option<BoundingBox<2>> {
        None
    }
}

/// A curve as an item.
fn curve_item(curve: Curve, stroke: Stroke) -> Item<2> {
    let steps = (SEGMENTS / curve.spans().max(1)).max(FEWEST);
    Item::Curve { curve: Box::new(curve), steps, stroke, name: None }
}

/// A line through points, which is a curve of order 2.
fn line_item(points: Vec<Point<2>>, stroke: Stroke) -> Option<Item<2>> {
    let curve = Curve::new(KnotVector::clamped(2, points.len()).ok()?, points).ok()?;
    Some(Item::Curve { curve: Box::new(curve), steps: 1, stroke, name: None })
}

impl Editor<Bench, 2> {
    /// All items, topmost last.
    pub(super) fn items(&self) -> Vec<Item<2>> {
        let mut items = Vec::new();
        if !self.stage.begun() {
            return items;
        }
        let drawn = self.drawn();
        let bare = self.stage == Stage::Result { points: false };
        if !bare {
            let points = sheet::points(&self.preview()).to_vec();
            items.push(Item::Own(Box::new(Polygon { points, closed: drawn.closed && drawn.is_curve() })));
        }
        if let Some(facts) = self.facts(&drawn) {
            self.add_curves(&drawn, &facts, &mut items);
        }
        if !bare {
            self.add_points(&mut items);
        }
        if let Some(target) = self.craft.search.as_ref().and_then(|search| search.target) {
            items.push(Item::Own(Box::new(Cross(Sheet.pixel(target)))));
        }
        items
    }

    fn add_curves(&self, drawn: &KnotPoints, facts: &Facts, items: &mut Vec<Item<2>>) {
        let grey = |curve: &KnotPoints| {
            self.facts(curve).map(|facts| curve_item(facts.curve.clone(), Stroke::thick(Color::DarkGray)))
        };
        let now = self.history.now();
        let options = self.craft.options;
        items.extend(self.craft.start.as_ref().filter(|_| options.compared).and_then(grey));
        // With a moved knot the curve as it was.
        if now.knots != drawn.knots && now.points == drawn.points {
            items.extend(grey(now));
        }
        let chosen = self.chosen(drawn);
        if options.comb {
            items.extend(comb(&facts.curve, scale(&facts.curve), [Color::Green, Color::LightGreen]));
        }
        items.push(curve_item(facts.curve.clone(), Stroke::thick(Color::White)));
        if self.stage.is_result() && !options.paths && !options.envelope {
            return;
        }
        if let Some(stack) = chosen {
            self.add_family(drawn, facts, stack, items);
        }
        if !self.stage.is_result()
            && let Some(at) = facts.curve.point_at(self.u(facts))
        {
            items.push(Item::Knot { at, fill: Color::LightCyan });
        }
    }

    /// Paths, envelope and what is beyond the neighbours of the chosen knot.
    fn add_family(&self, drawn: &KnotPoints, facts: &Facts, stack: Stack, items: &mut Vec<Item<2>>) {
        let (options, knot, u) = (self.craft.options, index(drawn, stack.first), self.u(facts));
        let envelope = facts.curve.envelope(knot, stack.copies).ok().filter(|_| options.envelope);
        if let Some(envelope) = &envelope {
            if options.comb {
                items.extend(comb(
                    &envelope.curve,
                    scale(&facts.curve),
                    [Color::Magenta, Color::LightMagenta],
                ));
            }
            items.push(curve_item(envelope.curve.clone(), Stroke::thick(Color::LightMagenta)));
        }
        if let Some(value) = self.beyond() {
            items.extend(beyond(&facts.curve, (knot, stack), value));
        }
        if options.opposed {
            items.extend(self.opposed_lines(drawn, facts, stack));
        }
        if options.paths {
            let mut paths = self.paths(drawn, facts, stack, u);
            paths.sort_by_key(|path| path.own);
            for path in paths {
                if let Some(side) = path.side {
                    let points = sheet::points(drawn);
                    let ends = side.map(|at| points.get(at).copied().unwrap_or([0.0; 2]));
                    items.extend(line_item(ends.to_vec(), Stroke::thick(Color::Brown)));
                }
                let stroke = match path.kind {
                    PathKind::Straight => Stroke::thick(Color::Yellow),
                    _ if path.own => Stroke::thick(Color::LightGreen),
                    _ => Stroke::thin(Color::LightGreen),
                };
                items.extend(line_item(path.points, stroke));
            }
        }
        if let Some(at) = envelope.and_then(|envelope| envelope.touching()) {
            items.push(Item::Knot { at, fill: Color::LightMagenta });
        }
    }

    /// The paths of the place of `u` in its span, and of the same places in all others that the knot changes.
    pub(super) fn paths(&self, drawn: &KnotPoints, facts: &Facts, stack: Stack, u: f64) -> Vec<Path> {
        let (curve, vector) = (&facts.curve, facts.curve.vector());
        let (knots, first) = (vector.knots(), index(drawn, stack.first));
        let Some(home) = vector.span_of(u) else { return Vec::new() };
        let share = (u - knots[home]) / (knots[home + 1] - knots[home]);
        let (last, wide) = (first + stack.copies - 1, knots[knots.len() - 1] - knots[0]);
        let low = first.checked_sub(1).map_or(stack.value - 0.25 * wide, |before| knots[before]);
        let high = knots.get(last + 1).copied().unwrap_or(stack.value + 0.25 * wide);
        let mut paths = Vec::new();
        for &span in vector.filled_spans() {
            let at = if span == home { u } else { (1.0 - share) * knots[span] + share * knots[span + 1] };
            // Beside the knot it is another arc's formula on either side of the place.
            let parts = match () {
                () if span + 1 == first => vec![(span, [at, high]), (last, [low, at])],
                () if span == last => vec![(span, [low, at]), (first.wrapping_sub(1), [at, high])],
                () => vec![(span, [low, high])],
            };
            for (span, range) in parts {
                let Ok(path) = curve.path_of_copies(first, stack.copies, span, at) else { continue };
                paths.push(part(&path, range, stack.copies, at == u));
            }
        }
        paths
    }

    /// Lines of the arc in the middle of two knots that move against each other.
    fn opposed_lines(&self, drawn: &KnotPoints, facts: &Facts, stack: Stack) -> Vec<Item<2>> {
        let (curve, knots) = (&facts.curve, facts.curve.vector().knots());
        let span = stack.first + drawn.order - 2;
        let Some((&from, &to)) = knots.get(span).zip(knots.get(span + 1)) else { return Vec::new() };
        let places = (1..=7).map(|k| from + (to - from) * f64::from(k) / 8.0);
        let lines = places.filter_map(|u| {
            let opposed = curve.opposed(stack.first, u).ok()?;
            let [low, high] = opposed.range();
            let value = |k: usize| low + (high - low) * k as f64 / STEPS as f64;
            let points: Vec<Point<2>> = (0..=STEPS).filter_map(|k| opposed.at(value(k))).collect();
            let stroke = match opposed.straight() {
                true => Stroke::thick(Color::Yellow),
                false => Stroke::thin(Color::LightGreen),
            };
            line_item(points, stroke)
        });
        lines.collect()
    }

    /// The control points that the arcs beside the knot shrink to while it is beyond its neighbours.
    fn limits(&self, curve: &KnotPoints) -> Vec<Point<2>> {
        let limits = || {
            let (facts, stack) = (self.facts(curve)?, self.chosen(curve)?);
            let limits = facts.curve.limits(index(curve, stack.first), stack.copies).ok()?;
            Some(limits.after.into_iter().chain(limits.before).collect())
        };
        self.beyond().and_then(|_| limits()).unwrap_or_default()
    }

    /// The control points with their numbers, and the next one in the store.
    fn add_points(&self, items: &mut Vec<Item<2>>) {
        let (fill, preview) = (Color::DarkGray, self.preview());
        let limits = self.limits(&preview);
        for (number, &at) in (1..).zip(sheet::points(&preview)) {
            let fill = if limits.contains(&at) { Color::Green } else { fill };
            items.push(Item::Disc { at, number, fill });
        }
        let count = self.history.now().points.len();
        if self.stage.is_result() || count >= MAX_POINTS {
            return;
        }
        let held = self.held.filter(|held| held.handle == Handle::Point(count)).map(|held| held.at);
        if held.is_none_or(|at| !in_field(at)) {
            items.push(Item::Stored { at: held.unwrap_or(STORE), number: count + 1, fill });
        }
    }
}

/// A part of a path.
fn part(path: &KnotPath<'_, 2>, range: [f64; 2], copies: usize, own: bool) -> Path {
    let straight = path.straight();
    let steps = if straight.is_some() { 1 } else { STEPS };
    let points = path.points(range, steps).into_iter().map(|(_, point)| point).collect();
    let kind = match straight {
        Some(_) => PathKind::Straight,
        None if copies == 1 => PathKind::Order(path.order()),
        None => PathKind::None,
    };
    Path { points, kind, side: straight.map(|straight| straight.side), own }
}

/// The arcs beside the knot while it is beyond its neighbours: the paths of their places, dotted, their limits, and the
/// arcs themselves at the present value.
fn beyond(curve: &Curve, (knot, stack): (usize, Stack), value: f64) -> Vec<Item<2>> {
    let (knots, last) = (curve.vector().knots(), knot + stack.copies - 1);
    let mut items = Vec::new();
    let room = [knot.checked_sub(1).and_then(|before| knots.get(before)), knots.get(last + 1)];
    let [Some(&low), Some(&high)] = room else { return items };
    for span in [knot - 1, last] {
        let Some((&from, &to)) = knots.get(span).zip(knots.get(span + 1)) else { continue };
        let mut arc = Vec::new();
        for share in (0..=16).map(|k| f64::from(k) / 16.0) {
            let u = (1.0 - share) * from + share * to;
            let Ok(path) = curve.path_of_copies(knot, stack.copies, span, u) else { continue };
            if !(low..=high).contains(&value) {
                arc.extend(path.at(value));
            }
            if ![0.25, 0.5, 0.75].contains(&share) {
                continue;
            }
            for (end, sign) in [(high, 1.0), (low, -1.0)] {
                // Steps that grow with the distance, to come near to the limit.
                let far = |k: usize| {
                    let t = k as f64 / STEPS as f64;
                    end + sign * FARTHEST * (high - low) * t.powi(4)
                };
                let points: Vec<Point<2>> = (0..=STEPS).filter_map(|k| path.at(far(k))).collect();
                for piece in unbroken(points) {
                    items.extend(line_item(piece, Stroke::thin(Color::LightGreen).dotted()));
                }
            }
        }
        items.extend(line_item(arc, Stroke::thick(Color::White).dotted()));
    }
    items
}

/// The pieces of a line that goes through infinity.
fn unbroken(points: Vec<Point<2>>) -> Vec<Vec<Point<2>>> {
    let mut pieces: Vec<Vec<Point<2>>> = vec![Vec::new()];
    for point in points {
        let before = pieces.last().and_then(|piece| piece.last()).copied();
        if before.is_some_and(|before| (before[0] - point[0]).hypot(before[1] - point[1]) > LEAP) {
            pieces.push(Vec::new());
        }
        pieces.last_mut().into_iter().for_each(|piece| piece.push(point));
    }
    pieces
}

/// Pixels of a tooth for a curvature of 1.
fn scale(curve: &Curve) -> f64 {
    let most = teeth(curve).into_iter().map(|(.., bend)| bend.abs()).fold(0.0, f64::max);
    // A corner's curvature would leave nothing of the others.
    if most > 0.0 { (LONGEST / most).max(300.0) } else { 0.0 }
}

/// Places of a curve with their normals and curvatures.
fn teeth(curve: &Curve) -> Vec<(Point<2>, Point<2>, f64)> {
    let knots = curve.vector().knots();
    let places = curve
        .vector()
        .filled_spans()
        .iter()
        .flat_map(|&span| (0..=TEETH).map(move |k| (span, f64::from(k) / f64::from(TEETH))));
    let tooth = |(span, t): (usize, f64)| {
        let u = (1.0 - t) * knots[span] + t * knots[span + 1];
        let all = curve.derivatives(u, 1)?;
        let [x, y] = all[1];
        let speed = x.hypot(y);
        Some((all[0], [-y / speed, x / speed], curve.curvature(u)?))
    };
    places.filter_map(tooth).collect()
}

/// The comb of curvature on the outer side of the bend.
fn comb(curve: &Curve, scale: f64, [tooth, tips]: [Color; 2]) -> Vec<Item<2>> {
    let ends: Vec<[Point<2>; 2]> = teeth(curve)
        .into_iter()
        .map(|(at, normal, bend)| {
            let long = (-scale * bend).clamp(-4.0 * LONGEST, 4.0 * LONGEST);
            [at, [at[0] + long * normal[0], at[1] + long * normal[1]]]
        })
        .collect();
    let mut items: Vec<Item<2>> = ends.iter().map(|&ends| Item::Line { ends, ink: tooth }).collect();
    items.extend(line_item(ends.iter().map(|[_, tip]| *tip).collect(), Stroke::thin(tips)));
    items
}
