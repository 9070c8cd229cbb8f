//! What the key W shows: how much a control point counts at every place of the surface.
//!
//! All methods of nets are linear in the points, so that the weight of a point is the surface of the net in which this
//! point is 1 and all others are 0.

use super::inspect::draw_tinted;
use super::surface::Drawn;
use super::{Frame, Nets};
use crate::design::{Index, NetDesign};
use crate::editor::Editor;
use crate::editor::field::apart;
use crate::editor::lens::Lens;
use crate::editor::seen::{Item, Own};
use crate::figure::Figure;
use crate::geometry::{BoundingBox, ParamSurface};
use crate::machine::{Event, Tick};
use crate::screen::{Color, Screen};
use crate::ui::look::Look;
use crate::ui::{Desk, Stay, Words, tint};
use std::rc::Rc;

const SHOWN: Words =
    Words("a pont súlya; vigye az egeret más pontra", "weight of the point; move to another point");
const HIDDEN: Words = Words("súlyok nélkül", "no weights");
/// Where the largest weight is written.
const CAPTION: (i32, i32) = (36, 66);
/// Steps of a cell in which extreme weights are sought.
const FINE: usize = 16;

/// A surface in the colours of a weight.
struct Weighted {
    drawn: Rc<Drawn>,
    weight: Box<dyn ParamSurface>,
    index: Index,
    look: Look,
}

impl Own<3> for Weighted {
    fn paint(&self, screen: &mut Screen) {
        let weight = |_: &dyn ParamSurface, spans, parameters| {
            tint::weight(self.weight.eval(spans, parameters).map(|[weight, ..]| weight))
        };
        let colors = self.drawn.fine().values(&self.drawn, weight);
        draw_tinted(screen, &self.drawn, self.look, &colors);
        let [least, most] = extremes(&*self.weight);
        let [k, l] = self.index;
        screen.text(CAPTION.0, CAPTION.1, &format!("w[{k}, {l}] = {least:.3} ... {most:.3}"), Color::Yellow);
    }

    /// Lines cannot tell what colours tell.
    fn plot(&self, _: &mut Figure) -> bool {
        false
    }

    fn bounds(&self) -> Option<BoundingBox<3>> {
        self.drawn.bounds()
    }
}

/// The smallest and the largest weight.
pub(super) fn extremes(weight: &dyn ParamSurface) -> [f64; 2] {
    let [rows, columns] = weight.spans();
    let steps = (FINE * 8 / rows.max(columns).max(1)).clamp(2, FINE);
    let Ok(grid) = weight.grid(steps) else { return [0.0; 2] };
    let weights = grid.points().iter().map(|[weight, ..]| *weight);
    let [least, most] = weights.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], w| [a.min(w), b.max(w)]);
    // Adding zero makes a negative zero positive; what rounds to it is it.
    [least, most].map(|weight| (weight * 1e3).round() / 1e3 + 0.0)
}

impl Editor<Nets, 3> {
    /// Switches the weights on for the point under the mouse, or off.
    pub(super) fn switch_weights(&mut self, desk: &mut Desk<'_>, tick: &Tick) {
        let at = (tick.mouse.x, tick.mouse.y);
        let chosen = self.point_under(at).or(self.craft.last).or(self.nearest_to(at));
        self.craft.weight = match self.craft.weight {
            Some(_) => None,
            None => chosen,
        };
        let shown = self.craft.weight.is_some();
        desk.tell(if shown { SHOWN } else { HIDDEN }, Stay::Briefly);
    }

    /// The weights are those of the point that the mouse comes to.
    pub(super) fn follow_weights(&mut self, tick: &Tick) {
        if let (Some(Event::Move(..)), Some(_)) = (tick.event, self.craft.weight) {
            let under = self.point_under((tick.mouse.x, tick.mouse.y));
            self.craft.weight = under.or(self.craft.weight);
        }
    }

    fn point_under(&self, at: (i32, i32)) -> Option<Index> {
        self.map().hit(at).or_else(|| self.nearest_of(self.history.now(), at, NetDesign::point))
    }

    fn nearest_to(&self, at: (i32, i32)) -> Option<Index> {
        let net = self.history.now();
        let distance =
            |index: &Index| net.point(*index).map_or(i64::MAX, |point| apart(self.lens.pixel(point), at));
        net.indices().min_by_key(distance)
    }

    /// The surface in colours, the net and its points.
    pub(super) fn weight_items(&self) -> Option<Vec<Item<3>>> {
        let net = self.preview();
        let index = self.craft.weight.filter(|&index| net.point(index).is_some())?;
        let drawn = Rc::new(self.craft.draw_up(&net).ok()?);
        let weight = net.influence(index).ok()?;
        let mut items: Vec<Item<3>> =
            vec![Item::Own(Box::new(Weighted { drawn, weight, index, look: self.lens.look }))];
        items.extend(Frame::Net.items(&net));
        items.extend(self.craft.frame.items(&net));
        let knot = |it: Index| {
            let fill = if it == index { Color::LightRed } else { Color::Black };
            net.point(it).map(|at| Item::Knot { at, fill })
        };
        items.extend(net.indices().filter_map(knot));
        Some(items)
    }
}
