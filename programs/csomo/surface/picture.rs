//! What is seen of a surface by its knots: wires, net, envelope, lines of knots, and its model.

use super::super::rail::Stack;
use super::super::texts;
use super::view::RAILS;
use super::{Handle, Nets, REACH, point};
use crate::editor::Editor;
use crate::editor::field::PICTURE;
use crate::editor::lens::Lens;
use crate::editor::picture::{Layer, Page};
use crate::editor::seen::Item;
use crate::file::KnotNet;
use crate::geometry::Point;
use crate::geometry::knots::KnotSurface;
use crate::screen::{Color, Stroke};
use crate::ui::{Area, words};
use serde::Serialize;

/// Segments of a wire in a span.
const STEPS: usize = 8;
/// Where the title and the line of status stand.
const TITLE: (i32, i32) = (28, 7);
const STATUS: (i32, i32) = (28, 470);

/// The model as `dump` writes it. Angles are in degrees.
#[derive(Serialize)]
struct Dump {
    order: [usize; 2],
    points: Vec<Vec<Point<3>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    weights: Option<Vec<Vec<f64>>>,
    knots: [Vec<f64>; 2],
    at: Option<[f64; 2]>,
    /// 0 for u, 1 for v.
    direction: Option<usize>,
    knot: Option<usize>,
    copies: Option<usize>,
    envelope: bool,
    azimuth: f64,
    elevation: f64,
    zoom: f64,
    unsaved: bool,
}

/// Wires of a surface: at the knots of either direction and in the middle between them.
fn wires(surface: &KnotSurface, stroke: Stroke) -> Vec<Item<3>> {
    let mut items = Vec::new();
    for along in 0..2 {
        let across = &surface.vectors()[1 - along];
        let (knots, [_, to]) = (across.knots(), across.domain());
        let spans = across.filled_spans().iter();
        let places = spans.flat_map(|&span| [knots[span], 0.5 * (knots[span] + knots[span + 1])]).chain([to]);
        items.extend(places.filter_map(|at| {
            let curve = Box::new(surface.line(along, at).ok()?);
            Some(Item::Curve { curve, steps: STEPS, stroke, name: None })
        }));
    }
    items
}

impl Editor<Nets, 3> {
    /// All items, topmost last.
    pub(super) fn items(&self) -> Vec<Item<3>> {
        if !self.stage.begun() {
            return Vec::new();
        }
        let net = self.preview();
        let Ok(surface) = net.surface() else { return Vec::new() };
        if self.stage.is_result() {
            return wires(&surface, Stroke::thin(Color::White));
        }
        let mut items = Vec::new();
        let before = self.history.now();
        if before.knots != net.knots
            && let Ok(before) = before.surface()
        {
            items.extend(wires(&before, Stroke::thin(Color::DarkGray)));
        }
        items.extend(wires(&surface, Stroke::thin(Color::Cyan)));
        if let Some((direction, stack)) = self.chosen(&net, &surface).filter(|_| self.craft.envelope) {
            if let Ok(envelope) = surface.envelope(direction, stack.first, stack.copies) {
                items.extend(wires(&envelope, Stroke::thin(Color::LightMagenta)));
            }
            // There the surface touches its envelope.
            if let Ok(line) = surface.line(1 - direction, stack.value) {
                let stroke = Stroke::thick(Color::LightMagenta);
                items.push(Item::Curve { curve: Box::new(line), steps: 2 * STEPS, stroke, name: None });
            }
        }
        items.extend(net_lines(&net).map(|ends| Item::Line { ends, ink: Color::LightGray }));
        let held = self.held.map(|held| held.handle);
        for index in indices(&net) {
            let fill = if held == Some(Handle::Point(index)) { Color::LightRed } else { Color::Black };
            items.extend(point(&net, index).map(|at| Item::Knot { at, fill }));
        }
        if let Some(at) = surface.point_at(self.uv(&surface)) {
            items.push(Item::Knot { at, fill: Color::LightCyan });
        }
        items
    }

    /// The control point at a pixel, the one nearest to the viewer.
    pub(super) fn point_at(&self, (x, y): (i32, i32)) -> Option<[usize; 2]> {
        let net = self.history.now();
        let under = indices(net).filter_map(|index| {
            let place = point(net, index)?;
            let (px, py) = self.lens.pixel(place);
            let near = (px - x).pow(2) + (py - y).pow(2) <= REACH * REACH;
            near.then(|| (index, self.lens.0.look.view.depth(place)))
        });
        under.max_by(|(_, one), (_, other)| one.total_cmp(other)).map(|(index, _)| index)
    }

    /// Draws one layer.
    pub(super) fn draw_layer(&self, layer: Layer, page: &mut Page<'_>) {
        let net = self.preview();
        let Ok(surface) = net.surface() else { return };
        match layer {
            Layer::Over if !self.stage.is_result() && self.stage.begun() => {
                self.draw_rails(&net, &surface, page);
            }
            Layer::Titles => {
                let title = texts::net_title(net.order, [net.points.len(), surface.vectors()[1].controls()]);
                page.screen.text(TITLE.0, TITLE.1, title.of(page.language), Color::Black);
                let chosen = self.chosen(&net, &surface);
                let text = match self.held.map(|held| held.handle) {
                    Some(Handle::Point(index)) => {
                        let place = point(&net, index).unwrap_or_default();
                        words::part_of(index, words::PLACE_3D, place)
                    }
                    _ => texts::net_status(chosen, self.uv(&surface)),
                };
                page.screen.text(STATUS.0, STATUS.1, text.of(page.language), Color::Black);
            }
            _ => {}
        }
    }

    fn draw_rails(&self, net: &KnotNet, surface: &KnotSurface, page: &mut Page<'_>) {
        let Area { x1, y1, x2, y2 } = PICTURE;
        page.screen.bar(x1, y2 - 30, x2, y2, Color::Black);
        page.screen.bar(x1, y1, x1 + 29, y2, Color::Black);
        let (chosen, uv) = (self.chosen(net, surface), self.uv(surface));
        for (direction, rail) in RAILS.iter().enumerate() {
            let scale = rail.scale(&self.history.now().knots[direction]);
            let fill = |knot: usize| match chosen {
                Some((other, stack)) if other == direction && stack.holds(knot) => Color::Yellow,
                _ => Color::LightGray,
            };
            let vector = &surface.vectors()[direction];
            rail.mark(page.screen, scale.along(uv[direction]), Stroke::thin(Color::White).dotted());
            rail.draw(page.screen, &scale, vector.knots(), Some(vector.domain()), fill);
            let (x, y) = rail.start;
            let at = if direction == 0 { (x - 16, y - 7) } else { (x, y + 4) };
            page.screen.text(at.0, at.1, ["u", "v"][direction], Color::White);
        }
    }

    /// The model as it is.
    pub(super) fn dumped(&self) -> impl Serialize + use<> {
        let net = self.history.now();
        let surface = net.surface().ok();
        let chosen = surface.as_ref().and_then(|surface| self.chosen(net, surface));
        let [azimuth, elevation, zoom] = self.lens.0.look.angles();
        let stack = chosen.map(|(_, stack): (usize, Stack)| stack);
        Dump {
            order: net.order,
            points: net.points.clone(),
            weights: net.weights.clone(),
            knots: net.knots.clone(),
            at: surface.as_ref().map(|surface| self.uv(surface)),
            direction: chosen.map(|(direction, _)| direction),
            knot: stack.map(|stack| stack.first),
            copies: stack.map(|stack| stack.copies),
            envelope: self.craft.envelope,
            azimuth,
            elevation,
            zoom,
            unsaved: self.history.unsaved(),
        }
    }
}

/// The indices of all control points.
fn indices(net: &KnotNet) -> impl Iterator<Item = [usize; 2]> + '_ {
    net.points.iter().enumerate().flat_map(|(k, row)| (0..row.len()).map(move |l| [k, l]))
}

/// The lines between neighbouring points.
fn net_lines(net: &KnotNet) -> impl Iterator<Item = [Point<3>; 2]> + '_ {
    indices(net).flat_map(move |[k, l]| {
        let next = [point(net, [k + 1, l]), point(net, [k, l + 1])];
        let here = point(net, [k, l]);
        next.into_iter().filter_map(move |next| Some([here?, next?])).collect::<Vec<_>>()
    })
}
