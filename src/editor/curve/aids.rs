//! What shows how a curve comes from its points: the characteristic polygon and its convex hull (2.3), the weights of
//! the points, the joints with their continuity (2.1), and the comb of curvature.

use super::{Ambient, Curves, Handle, steps};
use crate::design::{Place, Sketch};
use crate::editor::comb;
use crate::editor::field::apart;
use crate::editor::lens::Lens;
use crate::editor::picture::Page;
use crate::editor::seen::Item;
use crate::editor::{Craft, Editor};
use crate::geometry::{Closure, ParamCurve, Point, contact, convex_hull, curvature_vector, norm};
use crate::screen::{Color, Stroke};
use crate::ui::{Area, Desk, Stay};
use crate::ui::{tint, words};
use serde::Serialize;

/// The aids that are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(super) struct Aids {
    polygon: Polygon,
    weights: bool,
    joints: Joints,
}

impl Aids {
    /// Whether none is shown.
    pub(super) fn none(&self) -> bool {
        *self == Aids::default()
    }
}

/// What is shown of the characteristic polygon.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
enum Polygon {
    #[default]
    Off,
    Sides,
    Hull,
}

/// What is shown of the joints and the bend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
enum Joints {
    #[default]
    Off,
    Contact,
    Comb,
}

/// Where the blending functions are drawn.
const STRIP: Area = Area::new(41, 368, 601, 450);
/// Pixels from its edges to the functions.
const MARGIN: i32 = 6;
/// Pixels between two places where a function is computed.
const PIXELS: i32 = 4;
/// Functions that are numbered, and spans that are told one by one, at most.
const NUMBERED: usize = 24;
/// The length of the hair of a whole weight, and of the longest tooth of the comb.
const HAIR: f64 = 60.0;
/// Hairs along the curve, about.
const HAIRS: usize = 240;

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// The key K: the polygon, its hull, nothing.
    pub(super) fn switch_polygon(&mut self, desk: &mut Desk<'_>) {
        let aids = &mut self.craft.aids;
        let said;
        (aids.polygon, said) = match aids.polygon {
            Polygon::Off => (Polygon::Sides, words::POLYGON_SHOWN),
            Polygon::Sides => (Polygon::Hull, words::HULL_SHOWN),
            Polygon::Hull => (Polygon::Off, words::POLYGON_HIDDEN),
        };
        desk.tell(said, Stay::Briefly);
    }

    /// The key W: the weights of the points.
    pub(super) fn switch_weights(&mut self, desk: &mut Desk<'_>) {
        let aids = &mut self.craft.aids;
        aids.weights = !aids.weights;
        let some = self.present().is_some_and(|(sketch, _)| sketch.weight(0).is_some());
        let said = match (self.craft.aids.weights, some) {
            (false, _) => words::WEIGHTS_HIDDEN,
            (true, true) => words::WEIGHTS_SHOWN,
            (true, false) => words::NO_WEIGHTS,
        };
        desk.tell(said, Stay::Briefly);
    }

    /// The key J: the joints with their continuity, the comb, nothing.
    pub(super) fn switch_joints(&mut self, desk: &mut Desk<'_>) {
        let aids = &mut self.craft.aids;
        let said;
        (aids.joints, said) = match aids.joints {
            Joints::Off => (Joints::Contact, words::JOINTS_SHOWN),
            Joints::Contact => (Joints::Comb, words::COMB_SHOWN),
            Joints::Comb => (Joints::Off, words::JOINTS_HIDDEN),
        };
        desk.tell(said, Stay::Briefly);
    }

    /// The curve in the picture.
    fn present(&self) -> Option<(Sketch<D>, Box<dyn ParamCurve<D>>)> {
        let shown = (self.shown.visible || self.stage.is_result()) && !self.craft.measured;
        let sketch = Some(self.drawn()).filter(|_| shown)?;
        let curve = sketch.curve().ok()?;
        Some((sketch, curve))
    }

    /// The point that is held, chosen, or under the mouse.
    pub(super) fn looked_at(&self) -> Option<usize> {
        let under = || Curves::handle_at(self, self.mouse);
        match self.held.map(|held| held.handle).or(self.picked).or_else(under)? {
            Handle::Point(index) if index < self.count() => Some(index),
            _ => None,
        }
    }

    /// The aids that are lines and marks; they lie under the points.
    pub(super) fn add_aids(&self, items: &mut Vec<Item<D>>) {
        let aids = self.craft.aids;
        if aids.none() {
            return;
        }
        let sketch = self.preview();
        if aids.polygon != Polygon::Off {
            self.add_polygon(&sketch, items);
        }
        let Some((sketch, curve)) = self.present() else { return };
        match aids.joints {
            Joints::Off => {}
            Joints::Contact => self.add_contacts(&*curve, items),
            Joints::Comb => {
                let scale = comb_scale(&*curve);
                comb::add_comb(&*curve, scale, items);
            }
        }
        if aids.weights
            && let Some(weight) = self.looked_at().and_then(|index| sketch.weight(index))
        {
            add_hairs(&*curve, &*weight, items);
        }
    }

    fn add_polygon(&self, sketch: &Sketch<D>, items: &mut Vec<Item<D>>) {
        let mut side = |ends: [Point<D>; 2], ink| items.push(Item::Line { ends, ink });
        for pair in sketch.points.windows(2) {
            side([pair[0], pair[1]], Color::LightCyan);
        }
        if let ([first, .., last], Closure::Closed) = (sketch.points.as_slice(), self.drawn().closure()) {
            side([*last, *first], Color::LightCyan);
        }
        if self.craft.aids.polygon == Polygon::Hull {
            // What is seen of a hull in space is the hull of what is seen of its points.
            let flat = |&point: &Point<D>| {
                let [x, y] = self.lens.flat(point);
                [x, y, 0.0]
            };
            let hull = convex_hull(&sketch.points.iter().map(flat).collect::<Vec<_>>());
            for ends in hull.edges {
                if let [Some(&from), Some(&to)] = ends.map(|index| sketch.points.get(index)) {
                    side([from, to], Color::LightMagenta);
                }
            }
        }
    }

    /// Marks every joint with its continuity, and numbers the spans; of many, those next to the mouse only.
    fn add_contacts(&self, curve: &dyn ParamCurve<D>, items: &mut Vec<Item<D>>) {
        let joints = curve.joints();
        let distance =
            |joint: &usize| joints.get(*joint).map_or(i64::MAX, |&at| apart(self.lens.pixel(at), self.mouse));
        let nearest = (0..joints.len()).min_by_key(distance);
        let told = |joint: usize| curve.spans() <= NUMBERED || nearest == Some(joint);
        for (joint, &at) in joints.iter().enumerate() {
            items.push(Item::Joint(at));
            if let Some(contact) =
                Some(joint).filter(|joint| told(*joint)).and_then(|joint| contact(curve, joint))
            {
                items.push(Item::Note { at, text: contact.to_string(), ink: Color::Yellow });
            }
        }
        for span in (0..curve.spans()).filter(|span| told(*span)) {
            if let Some(at) = curve.eval(span, 0.5) {
                items.push(Item::Note { at, text: (span + 1).to_string(), ink: Color::LightGreen });
            }
        }
    }

    /// Whether the picture of the weights covers a pixel.
    pub(super) fn weights_cover(&self, (x, y): (i32, i32)) -> bool {
        let some = || self.present().is_some_and(|(sketch, _)| sketch.weight(0).is_some());
        self.craft.aids.weights && STRIP.holds(x, y) && some()
    }

    /// Draws the blending functions of all points.
    pub(super) fn draw_weights(&self, page: &mut Page<'_>) {
        if !self.craft.aids.weights {
            return;
        }
        let Some((sketch, curve)) = self.present() else { return };
        let weights: Vec<_> = (0..sketch.points.len()).filter_map(|index| sketch.weight(index)).collect();
        if weights.is_empty() {
            return;
        }
        let spans = curve.spans();
        let columns = (STRIP.x2 - STRIP.x1 - 2 * MARGIN) / PIXELS;
        let values = |weight: &dyn ParamCurve<D>| -> Vec<f64> {
            let value = |column: i32| {
                let along = f64::from(column) / f64::from(columns) * spans as f64;
                let span = (along as usize).min(spans.saturating_sub(1));
                weight.eval(span, along - span as f64).map_or(0.0, |point| point[0])
            };
            (0..=columns).map(value).collect()
        };
        let rows: Vec<Vec<f64>> = weights.iter().map(|weight| values(&**weight)).collect();
        let all = || rows.iter().flatten().copied();
        let [low, high] = [all().fold(0.0, f64::min), all().fold(1.0, f64::max)];
        let screen = &mut *page.screen;
        screen.bar(STRIP.x1, STRIP.y1, STRIP.x2, STRIP.y2, Color::Black);
        screen.rectangle(STRIP.x1, STRIP.y1, STRIP.x2, STRIP.y2, Stroke::thin(Color::LightGray));
        let height = f64::from(STRIP.y2 - STRIP.y1 - 2 * MARGIN);
        let y_of = |value: f64| STRIP.y2 - MARGIN - ((value - low) / (high - low) * height).round() as i32;
        let x_of = |column: usize| STRIP.x1 + MARGIN + PIXELS * column as i32;
        let grid = Stroke::thin(Color::DarkGray);
        for level in [0.0, 1.0] {
            screen.line(STRIP.x1 + 1, y_of(level), STRIP.x2 - 1, y_of(level), grid);
        }
        for joint in 0..=spans.min(columns as usize) {
            let x = STRIP.x1 + MARGIN + (f64::from(PIXELS * columns) * joint as f64 / spans as f64) as i32;
            screen.line(x, STRIP.y1 + 1, x, STRIP.y2 - 1, grid);
        }
        let chosen = self.looked_at();
        let order = (0..rows.len()).filter(|&index| Some(index) != chosen).chain(chosen);
        for (index, row) in order.filter_map(|index| Some((index, rows.get(index)?))) {
            let ink =
                if Some(index) == chosen { Color::White } else { tint::LINES[index % tint::LINES.len()] };
            let line: Vec<(i32, i32)> =
                row.iter().enumerate().map(|(column, &value)| (x_of(column), y_of(value))).collect();
            let stroke = if Some(index) == chosen { Stroke::thick(ink) } else { Stroke::thin(ink) };
            screen.polyline(&line, stroke);
            let highest = (0..row.len()).max_by(|&a, &b| row[a].total_cmp(&row[b]));
            if let Some(column) = highest.filter(|_| rows.len() <= NUMBERED || Some(index) == chosen) {
                let text = (index + 1).to_string();
                let width = 8 * i32::try_from(text.len()).unwrap_or(1);
                let x = (x_of(column) - width / 2).clamp(STRIP.x1 + 2, STRIP.x2 - width - 1);
                screen.text(x, (y_of(row[column]) - 10).max(STRIP.y1 + 2), &text, ink);
            }
        }
    }
}

/// The scale of the comb whose longest tooth has the length of a hair.
fn comb_scale<const D: usize>(curve: &dyn ParamCurve<D>) -> f64 {
    let bend = |(span, k): (usize, u32)| {
        let [_, slope, bend] = curve.at(span, f64::from(k) / 8.0)?;
        Some(norm(curvature_vector(slope, bend))).filter(|bend| bend.is_finite())
    };
    let places = (0..curve.spans()).flat_map(|span| (0..=8).map(move |k| (span, k)));
    let mut bends: Vec<f64> = places.filter_map(bend).collect();
    bends.sort_by(f64::total_cmp);
    // A few sharp places do not make the comb vanish everywhere else.
    let sharp = bends.get(bends.len() * 49 / 50).or(bends.last()).copied().unwrap_or(0.0);
    if sharp > 0.0 { (HAIR / sharp).min(1e9) } else { 0.0 }
}

/// Hairs along a curve, as long as a weight there: on one side the positive, on the other the negative ones.
fn add_hairs<const D: usize>(
    curve: &dyn ParamCurve<D>,
    weight: &dyn ParamCurve<D>,
    items: &mut Vec<Item<D>>,
) {
    let per_span = (HAIRS / curve.spans().max(1)).clamp(6, steps(crate::file::Method::Bezier));
    for span in 0..curve.spans() {
        for k in 0..=per_span {
            let u = k as f64 / per_span as f64;
            let (Some([at, slope, bend]), Some(value)) = (curve.at(span, u), weight.eval(span, u)) else {
                continue;
            };
            let Some(across) = across(slope, bend).filter(|_| value[0].abs() > 0.002) else { continue };
            let tip = std::array::from_fn(|d| at[d] + HAIR * value[0] * across[d]);
            let ink = if value[0] > 0.0 { Color::Yellow } else { Color::LightRed };
            items.push(Item::Line { ends: [at, tip], ink });
        }
    }
}

/// A unit vector across a curve: in the plane to the left, in space away from the bend.
fn across<const D: usize>(slope: Point<D>, bend: Point<D>) -> Option<Point<D>> {
    let speed = norm(slope);
    let mut across = [0.0; D];
    if let ([x, y], 2) = ([*slope.first()?, *slope.get(1)?], D) {
        (across[0], across[1]) = (-y, x);
    } else {
        across = curvature_vector(slope, bend).map(|x| -x);
        if norm(across) * speed <= 1e-9 {
            // A straight piece: any direction across will do.
            (across[0], across[1]) =
                if slope[0] == 0.0 && slope[1] == 0.0 { (1.0, 0.0) } else { (-slope[1], slope[0]) };
        }
    }
    let size = norm(across);
    Some(across.map(|x| x / size)).filter(|unit| unit.iter().all(|x| x.is_finite()))
}
