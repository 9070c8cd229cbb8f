//! Bézier arcs in the curve editors: their handles, smooth joints and corners.

use super::{Ambient, Curves, Handle};
use crate::design::DesignError;
use crate::design::Place;
use crate::editor::Editor;
use crate::editor::field::apart;
use crate::editor::lens::Lens;
use crate::editor::seen::Item;
use crate::editor::stage::Stage;
use crate::file::Method;
use crate::geometry::{ArcPoint, GeometryError, Point};
use crate::machine::Manner;
use crate::screen::Color;
use crate::ui::words;
use crate::ui::{Desk, Hint, Stay};
use serde::Serialize;

/// The fill of joints, in which arcs meet smoothly or in a corner.
const SMOOTH: Color = Color::Blue;
const CORNER: Color = Color::Red;

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// The lines from joints to their handles.
    pub(super) fn handles_seen(&self) -> Vec<Item<D>> {
        if self.stage == (Stage::Result { points: false }) || self.craft.measured {
            return Vec::new();
        }
        let line = |ends| Item::Line { ends, ink: Color::LightGray };
        self.drawn().handles().into_iter().map(line).collect()
    }

    /// The fill of a point's disc: red for the one that the arrows move; joints of arcs tell what they are.
    pub(super) fn fill_of(&self, index: usize) -> Color {
        let sketch = self.history.now();
        if self.picked == Some(Handle::Point(index)) {
            // The corners of arcs are red themselves.
            let arcs = sketch.arc_point(index).is_some();
            return if arcs { Color::Magenta } else { Color::Red };
        }
        match sketch.arc_point(index) {
            Some(ArcPoint::Joint([Some(_), Some(_)])) if sketch.is_smooth(index) => SMOOTH,
            Some(ArcPoint::Joint(_)) => CORNER,
            _ => Curves::<D>::FILL,
        }
    }

    /// Where the points are while one of them is dragged: that of arcs takes others along.
    pub(super) fn points_carried(&self) -> Option<Vec<Point<D>>> {
        let moved = self.held.and(self.history.now().arc_point(0)).map(|_| self.preview().points);
        moved.filter(|points| points.len() == self.count())
    }

    /// The key S: the joint nearest to the mouse becomes smooth, or a corner again.
    pub(super) fn toggle_smooth(&mut self, desk: &mut Desk<'_>) {
        let sketch = self.history.now();
        if self.method() != Some(Method::Arcs) {
            // The original does not know this key.
            if self.manner == Manner::Today {
                desk.tell(words::ONLY_ARCS, Stay::Briefly);
            }
            return;
        }
        let mouse = desk.machine.mouse();
        let inner =
            |index: &usize| matches!(sketch.arc_point(*index), Some(ArcPoint::Joint([Some(_), Some(_)])));
        let distance = |index: &usize| {
            let point = sketch.points.get(*index);
            point.map_or(i64::MAX, |&point| apart(self.lens.pixel(point), (mouse.x, mouse.y)))
        };
        let Some(joint) = (0..self.count()).filter(inner).min_by_key(distance) else {
            desk.tell(words::NO_JOINT, Stay::Briefly);
            return;
        };
        let smooth = !sketch.is_smooth(joint);
        self.change(sketch.with_smooth(joint, smooth));
        desk.tell(words::joint_is(joint + 1, smooth), Stay::Briefly);
    }

    /// What can be done with arcs; `None` for other methods.
    pub(super) fn hint_of_arcs(&self) -> Option<Hint> {
        if self.held.is_some() || self.method() != Some(Method::Arcs) {
            return None;
        }
        match self.drawn().curve() {
            Ok(_) if self.shown.visible => Some(Hint::new(words::HINT_ARCS)),
            Err(DesignError::Geometry(GeometryError::ArcCount { given, needed, .. })) => {
                Some(Hint::new(words::arcs_lack(needed.saturating_sub(given))))
            }
            _ => None,
        }
    }
}
