//! The page of surfaces: the net in space, a line of knots for either direction, the envelope of the chosen knot as wires.

mod actions;
mod picture;
mod table;
mod view;

pub(super) use table::KEYS;

use super::rail::{Stack, stacks};
use super::texts;
use crate::design::knots::edit;
use crate::design::nets;
use crate::editor::lens::Held;
use crate::editor::passage::Passage;
use crate::editor::picture::{Layer, Page};
use crate::editor::seen::Item;
use crate::editor::stage::Stage;
use crate::editor::{Craft, Editor};
use crate::file::{Document, Format, KnotNet, NetKind};
use crate::geometry::knots::{KnotSurface, KnotVector};
use crate::geometry::{BoundingBox, ParamSurface, Point};
use crate::machine::{Asked, Event, Modifier, Tick};
use crate::ui::look::{Look, Poles, Viewer};
use crate::ui::words::Phrase;
use crate::ui::{Commands, Desk, Hint};
use crate::work::Next;
use serde::Serialize;
use std::rc::Rc;
use table::{Action, COMMANDS};
use view::{Beside, RAILS};

/// The most points in a row that the picture has room for.
const MOST: usize = 40;
/// Rows and columns of a new net, the distance of its points, and its height.
const NEW: ([usize; 2], f64, f64) = ([7, 7], 50.0, 120.0);
/// Largest distance of a click from a control point, in pixels.
const REACH: i32 = 6;

/// The craft of surfaces by their knots.
pub(super) struct Nets {
    envelope: bool,
    /// The marked parameters; `None` for the usual ones.
    at: [Option<f64>; 2],
    /// The chosen knot: its direction and index.
    knot: Option<(usize, usize)>,
    /// Set where the page of curves is wanted.
    passage: Rc<Passage>,
}

/// What the mouse can hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Handle {
    Point([usize; 2]),
    /// Copies of a knot of a direction from one of them.
    Knots {
        direction: usize,
        first: usize,
        copies: usize,
        level: usize,
    },
    /// The parameter of a direction.
    Mark(usize),
}

impl Handle {
    /// The knots that move up or down.
    fn group(self, up: bool) -> Option<(usize, usize, usize)> {
        let Handle::Knots { direction, first, copies, level } = self else { return None };
        Some((direction, if up { first + level } else { first }, copies - level))
    }
}

impl Nets {
    pub(super) fn new(passage: Rc<Passage>) -> Nets {
        Nets { envelope: true, at: [None; 2], knot: None, passage }
    }
}

/// The net with copies of a knot at a value, or as near to it as there is room.
fn knot_moved(net: &KnotNet, direction: usize, (first, copies): (usize, usize), value: f64) -> KnotNet {
    let order = net.order[direction];
    let right = |knots: &[f64]| KnotVector::new(order, knots.to_vec()).is_ok();
    let mut new = net.clone();
    if let Some(knots) = edit::list_moved(&net.knots[direction], (first, copies), value, right) {
        new.knots[direction] = knots;
    }
    new
}

/// A control point.
fn point(net: &KnotNet, [k, l]: [usize; 2]) -> Option<Point<3>> {
    net.points.get(k)?.get(l).copied()
}

impl Craft<3> for Nets {
    type Value = KnotNet;
    type Handle = Handle;
    type Lens = Beside;
    type Action = Action;

    fn format(&self) -> Format {
        Format::Csf
    }

    fn commands(&self) -> Commands<Action> {
        COMMANDS
    }

    fn lens(&self) -> Beside {
        Beside(Viewer::new(Look::new(NetKind::VIEW, Poles::Cross)))
    }

    fn fresh(&self, _: Option<&KnotNet>) -> KnotNet {
        let (shape, spacing, height) = NEW;
        let knots = shape.map(|count| (0..count + 4).map(|knot| knot as f64).collect());
        KnotNet {
            order: [4; 2],
            closed: [false; 2],
            points: nets::vault(shape, spacing, height),
            weights: None,
            knots,
        }
    }

    fn of_document(&self, document: &Document, _: &KnotNet) -> Result<(KnotNet, Option<Phrase>), Phrase> {
        let Document::KnotNet(net) = document else { return Err(texts::WRONG_NET.into()) };
        net.surface().map_err(|error| texts::refusal(&error))?;
        let most = net.points.iter().map(Vec::len).chain([net.points.len()]).max().unwrap_or(0);
        if most > MOST {
            return Err(texts::net_too_large(most, MOST));
        }
        Ok((KnotNet::clone(net), None))
    }

    fn document(&self, net: &KnotNet) -> Document {
        Document::KnotNet(Box::new(net.clone()))
    }

    fn names_shape(&self, _: &KnotNet) -> bool {
        true
    }

    fn has_shape(_: &Editor<Nets, 3>) -> bool {
        true
    }

    fn surfaces(editor: &Editor<Nets, 3>) -> Vec<Box<dyn ParamSurface>> {
        let surface = editor.history.now().surface().ok();
        surface.into_iter().map(|surface| Box::new(surface) as Box<dyn ParamSurface>).collect()
    }

    fn hint(editor: &Editor<Nets, 3>) -> Option<Hint> {
        Some(Hint::new(match editor.held.map(|held| held.handle) {
            Some(Handle::Knots { .. }) => texts::HINT_NET_KNOT,
            Some(Handle::Mark(_)) => texts::HINT_MARK,
            Some(Handle::Point(_)) => crate::ui::words::HINT_HELD_3D,
            None => texts::HINT_NET,
        }))
    }

    fn model(editor: &Editor<Nets, 3>) -> impl Serialize + 'static {
        editor.dumped()
    }

    fn place(net: &KnotNet, handle: Handle) -> Option<Point<3>> {
        match handle {
            Handle::Point(index) => point(net, index),
            Handle::Knots { direction, first, .. } => {
                let knots = net.knots.get(direction)?;
                Some(view::on_rail(direction, RAILS[direction].scale(knots).along(*knots.get(first)?)))
            }
            Handle::Mark(direction) => Some(view::on_rail(direction, 0.0)),
        }
    }

    fn moved(net: &KnotNet, handle: Handle, at: Point<3>) -> KnotNet {
        if Nets::place(net, handle) == Some(at) {
            return net.clone();
        }
        match handle {
            Handle::Point([k, l]) => {
                let mut new = net.clone();
                if let Some(point) = new.points.get_mut(k).and_then(|row| row.get_mut(l)) {
                    *point = at.map(f64::round);
                }
                new
            }
            Handle::Knots { direction, first, .. } => {
                let knots = &net.knots[direction];
                let value = RAILS[direction].scale(knots).value(at[0]);
                let up = knots.get(first).is_some_and(|before| value > *before);
                let group = handle.group(up);
                group.map_or(net.clone(), |(_, first, copies)| {
                    knot_moved(net, direction, (first, copies), value)
                })
            }
            Handle::Mark(_) => net.clone(),
        }
    }

    fn handle_at(editor: &Editor<Nets, 3>, at: (i32, i32)) -> Option<Handle> {
        let net = editor.history.now();
        for (direction, rail) in RAILS.iter().enumerate() {
            if let Some((Stack { first, copies, .. }, level)) = rail.stack_at(&net.knots[direction], at) {
                return Some(Handle::Knots { direction, first, copies, level });
            }
            if rail.place(at).is_some() {
                return Some(Handle::Mark(direction));
            }
        }
        editor.point_at(at).map(Handle::Point)
    }

    fn seen(editor: &Editor<Nets, 3>) -> Vec<Item<3>> {
        editor.items()
    }

    fn forget(editor: &mut Editor<Nets, 3>) {
        (editor.craft.at, editor.craft.knot) = ([None; 2], None);
        let points = editor.history.now().points.iter().flatten().copied();
        if let Some(bounds) = BoundingBox::around(points) {
            editor.lens.0.look = editor.lens.0.look.framing(&bounds);
        }
    }

    /// The wheel over a knot moves it, as on the page of curves.
    fn looked(editor: &mut Editor<Nets, 3>, _: &mut Desk<'_>, tick: &Tick) -> bool {
        let Some(Event::Wheel(steps)) = tick.event else { return false };
        let net = editor.history.now();
        for (direction, rail) in RAILS.iter().enumerate() {
            let knots = &net.knots[direction];
            let Some((stack, level)) = rail.stack_at(knots, (tick.mouse.x, tick.mouse.y)) else { continue };
            let Stack { first, copies, value } = stack;
            let part = if tick.mouse.with(Modifier::Ctrl) { 1e-3 } else { 1e-2 };
            let by = f64::from(steps) * part * edit::mean_of(knots);
            let handle = Handle::Knots { direction, first, copies, level };
            if let Some((_, first, copies)) = handle.group(by > 0.0).filter(|_| !editor.stage.is_result()) {
                let moved = knot_moved(net, direction, (first, copies), value + by);
                editor.craft.knot = Some((direction, first));
                editor.history.change(moved);
            }
            return true;
        }
        false
    }

    async fn obey(editor: &mut Editor<Nets, 3>, desk: &mut Desk<'_>, action: Action) -> Asked<Next> {
        editor.carry_out(desk, action).await
    }

    async fn dropped(
        editor: &mut Editor<Nets, 3>,
        desk: &mut Desk<'_>,
        held: Held<Handle, 3>,
        moved: KnotNet,
    ) -> Asked<()> {
        match held.handle {
            Handle::Mark(direction) => editor.craft.at[direction] = editor.marked(&held),
            Handle::Knots { direction, first, .. } => {
                let now = editor.history.now();
                let up = moved.knots[direction].get(first) == now.knots[direction].get(first);
                editor.craft.knot = held.handle.group(up).map(|(direction, first, _)| (direction, first));
                editor.history.change(moved);
            }
            Handle::Point(index) if held.at == held.from => return editor.change_point(desk, index).await,
            Handle::Point(_) => editor.history.change(moved),
        }
        Ok(())
    }

    async fn begin_result(editor: &mut Editor<Nets, 3>, _: &mut Desk<'_>) -> Asked<bool> {
        editor.stage = Stage::Result { points: false };
        Ok(true)
    }

    fn covers_ground(editor: &Editor<Nets, 3>) -> bool {
        editor.stage.is_result()
    }

    fn draw(editor: &Editor<Nets, 3>, layer: Layer, page: &mut Page<'_>) {
        editor.draw_layer(layer, page);
    }
}

impl Editor<Nets, 3> {
    /// The parameter that a held mark would have.
    fn marked(&self, held: &Held<Handle, 3>) -> Option<f64> {
        let Handle::Mark(direction) = held.handle else { return None };
        let pressed = || RAILS[direction].place(held.pressed).map(|(along, _)| f64::from(along));
        let along = if held.at == held.from { pressed()? } else { pressed()? + held.at[0] };
        Some(RAILS[direction].scale(&self.history.now().knots[direction]).value(along))
    }

    /// The marked parameters, in the domain.
    fn uv(&self, surface: &KnotSurface) -> [f64; 2] {
        let held = self.held.as_ref().and_then(|held| Some((held.handle, self.marked(held)?)));
        [0, 1].map(|direction| {
            let [from, to] = surface.vectors()[direction].domain();
            let dragged =
                held.filter(|(handle, _)| *handle == Handle::Mark(direction)).map(|(_, value)| value);
            let value = dragged.or(self.craft.at[direction]);
            value.map_or(from + 0.46 * (to - from), |value| value.clamp(from, to))
        })
    }

    /// The knots that can be chosen, along u and then along v.
    fn movable(&self, surface: &KnotSurface) -> Vec<(usize, Stack)> {
        let of = |direction: usize| {
            let vector = &surface.vectors()[direction];
            let [from, to] = vector.domain();
            let inside = move |stack: &Stack| stack.value >= from && stack.value <= to;
            stacks(vector.knots()).into_iter().filter(inside).map(move |stack| (direction, stack))
        };
        of(0).chain(of(1)).collect()
    }

    /// The copies of a knot that are chosen or dragged, and their direction.
    fn chosen(&self, net: &KnotNet, surface: &KnotSurface) -> Option<(usize, Stack)> {
        if let Some(held) = self.held.filter(|held| matches!(held.handle, Handle::Knots { .. })) {
            let now = self.history.now();
            let Handle::Knots { direction, first, .. } = held.handle else { return None };
            let up = net.knots[direction].get(first) == now.knots[direction].get(first);
            let (direction, first, copies) = held.handle.group(up)?;
            let value = *net.knots[direction].get(first)?;
            return Some((direction, Stack { first, copies, value }));
        }
        let all = self.movable(surface);
        let named = |(direction, stack): &&(usize, Stack)| {
            self.craft.knot.is_some_and(|(other, knot)| other == *direction && stack.holds(knot))
        };
        let usual =
            || all.iter().find(|(direction, stack)| *direction == 0 && stack.value > self.uv(surface)[0]);
        all.iter().find(named).or_else(usual).or(all.first()).copied()
    }
}
