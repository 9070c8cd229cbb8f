//! Where a point is while the mouse is on it or moves it (1.5.1), and the values that potentiometers turn (1.5.2).

use super::commands::{NOTE_AT, TANGENTS_NOTE_AT};
use super::{Ambient, Curves, Handle, Tools, beta};
use crate::design::{Place, Sketch};
use crate::editor::picture::Page;
use crate::editor::values::{BIAS, K0, TENSION};
use crate::editor::{Craft, Dial, Editor};
use crate::file::Method;
use crate::geometry::{Point, Shape};
use crate::machine::Manner;
use crate::screen::{Color, WIDTH};
use crate::ui::words;
use serde::Serialize;

/// Under the picture: the line of places in space, and where that of a field ends.
const SPACE_LINE: (i32, i32) = (130, 470);
const FIELD_LINE_END: (i32, i32) = (WIDTH - 3, 472);
/// Letters of the value of k0.
const K0_LETTERS: i32 = 10;

/// What `dump` calls a chosen handle.
pub(super) fn name(handle: Handle) -> Option<String> {
    match handle {
        Handle::Point(index) => Some(format!("point {}", index + 1)),
        Handle::Tip(index) => Some(format!("tangent {}", index + 1)),
        Handle::New(_) | Handle::Own => None,
    }
}

impl<const D: usize> Editor<Curves<D>, D>
where
    Curves<D>: Ambient<D>,
    Point<D>: Place<D> + Serialize,
{
    /// Writes the place of the point that is held, changed, chosen, or under the mouse.
    pub(super) fn draw_readout(&self, page: &mut Page<'_>) {
        let today = self.manner == Manner::Today;
        let space = Curves::<D>::STORE.is_none();
        if self.stage.is_result() || self.craft.tools == Tools::Own || !(today || space) {
            return;
        }
        let held = self.held.map(|held| held.handle);
        let pointed = self.craft.pointed_out.map(Handle::Point);
        let under = || Curves::handle_at(self, self.mouse);
        let seen = held.or(pointed).or_else(|| self.picked.or_else(under).filter(|_| today));
        let sketch = self.preview();
        let (index, place) = match seen {
            Some(Handle::Point(index)) => match sketch.points.get(index) {
                Some(&place) => (index, place),
                None => return,
            },
            Some(Handle::New(index)) => (index, self.held.map_or([0.0; D], |held| held.at)),
            Some(Handle::Tip(index)) => match sketch.tangent(index) {
                Some(tangent) => return self.write_in_field(page, &format!("t{}", index + 1), tangent),
                None => return,
            },
            Some(Handle::Own) | None => return,
        };
        match place[..] {
            [x, y, z] => {
                let line = words::place_of(index + 1, [x, y, z]);
                page.screen.text(SPACE_LINE.0, SPACE_LINE.1, line.of(page.language), Color::Black);
            }
            _ => self.write_in_field(page, &(index + 1).to_string(), place),
        }
    }

    fn write_in_field(&self, page: &mut Page<'_>, name: &str, place: Point<D>) {
        let numbers: Vec<String> = place.iter().map(|x| format!("{x:.0}")).collect();
        let text = format!("{name}: {}", numbers.join(" "));
        let width = 8 * i32::try_from(text.chars().count()).unwrap_or(0);
        page.screen.text(FIELD_LINE_END.0 - width, FIELD_LINE_END.1, &text, Color::Black);
    }

    /// The values with their tracks.
    pub(super) fn value_dials(&self) -> Vec<Dial> {
        if self.manner != Manner::Today || !self.stage.begun() || self.stage.is_result() {
            return Vec::new();
        }
        let dial = |at, letters, value, values| Dial::new(at, letters, 11, value, values);
        let sketch = self.preview();
        match self.craft.tools {
            Tools::Methods if self.shows_k0() => vec![dial(NOTE_AT, K0_LETTERS, sketch.k0(), K0)],
            Tools::Tangents if self.has_automatic_tangents() => {
                vec![dial(TANGENTS_NOTE_AT, K0_LETTERS, sketch.k0(), K0)]
            }
            Tools::Beta => {
                let Shape { bias, tension } = self.shape_turned(&sketch);
                vec![
                    dial(beta::BIAS_AT, beta::ROOM, bias, BIAS),
                    dial(beta::TENSION_AT, beta::ROOM, tension, TENSION),
                ]
            }
            _ => Vec::new(),
        }
    }

    /// The sketch with the value of a potentiometer changed.
    pub(super) fn with_dial(&self, dial: usize, to: f64) -> Sketch<D> {
        let now = self.history.now();
        let set = |shape: Shape| match dial {
            0 => Shape { bias: to, ..shape },
            _ => Shape { tension: to, ..shape },
        };
        match (self.craft.tools, self.joint_turned()) {
            (Tools::Beta, Some(joint)) => {
                let shape = now.shapes().get(joint).copied().unwrap_or_default();
                now.with_joint(joint, set(shape))
            }
            (Tools::Beta, None) => now.with_shape(|shape| *shape = set(*shape)),
            (tools, _) => {
                let mut sketch = now.clone();
                sketch.settings.k0 = Some(to);
                match tools {
                    Tools::Tangents => sketch.with_automatic_tangents(sketch.closure()).unwrap_or(sketch),
                    _ => sketch,
                }
            }
        }
    }

    /// Whether k0 stands on the page: while the curve is a Coons curve, in the manner of today.
    pub(super) fn shows_k0(&self) -> bool {
        let coons = self.craft.tools == Tools::Methods && self.method() == Some(Method::Coons);
        coons && self.manner == Manner::Today && self.craft.compared.is_empty()
    }

    /// Whether the tangents are those that k0 gives; tangents of the user's own are not turned away.
    pub(super) fn has_automatic_tangents(&self) -> bool {
        let sketch = self.preview();
        let automatic = || sketch.with_automatic_tangents(sketch.closure()).ok();
        self.manner == Manner::Today
            && sketch.settings.k0.is_some()
            && automatic().is_some_and(|automatic| automatic.tangents == sketch.tangents)
    }

    /// The joint whose shape is turned, if not all: that of the chosen point.
    fn joint_turned(&self) -> Option<usize> {
        match self.picked {
            Some(Handle::Point(index)) if Curves::<D>::STORE.is_some() && index < self.count() => Some(index),
            _ => None,
        }
    }

    /// Bias and tension that the potentiometers show.
    pub(super) fn shape_turned(&self, sketch: &Sketch<D>) -> Shape {
        let of_joint = self.joint_turned().and_then(|joint| sketch.shapes().get(joint).copied());
        of_joint.unwrap_or(sketch.shape())
    }

    /// Draws the tracks.
    pub(super) fn draw_dials(&self, page: &mut Page<'_>) {
        self.value_dials().iter().for_each(|dial| dial.draw(page.screen));
    }
}
