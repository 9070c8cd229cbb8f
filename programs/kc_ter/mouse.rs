//! The mouse in the picture: view, items and points are dragged.

use super::edit::{self, Affine, Index};
use super::eye::Eye;
use super::paint;
use super::pointers;
use super::shape::Shape;
use super::studio::{Page, Studio};
use crate::file::ec::{Item, Scene};
use crate::geometry::{ParamCurve, Point};
use crate::machine::{Button, Event, Key, Tick};
use crate::ui::Desk;

/// What the mouse holds.
#[derive(Clone, Debug)]
pub(super) struct Grip {
    pub(super) button: Button,
    pub(super) from: (i32, i32),
    pub(super) what: Held,
    /// Whether the mouse has moved so far that it is no click.
    pub(super) moved: bool,
}

#[derive(Clone, Debug)]
pub(super) enum Held {
    View(Eye),
    Item(Box<Item>),
    Point(Index, Point<3>),
}

/// What lies under the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Under {
    Nothing,
    Item(usize),
    Selected,
    Point(Index),
}

/// How far a drag has to go.
pub(super) const DRAG: i32 = 2;

/// How near the mouse has to be to a control point.
pub(super) const NEAR: i32 = 8;

impl Studio {
    /// What the mouse points at: a control point of the selected item, the selected item, another one, or nothing.
    pub(super) fn under(&self, at: (i32, i32)) -> Under {
        let radius = paint::radius(self.scene(), self.show()).max(NEAR);
        if let Some(item) = self.item() {
            let points = edit::control_points(item).into_iter();
            let near = points.filter_map(|(index, point)| {
                let (x, y) = self.eye.pixel(point);
                let away = (x - at.0).pow(2) + (y - at.1).pow(2);
                (away <= radius.pow(2)).then_some((index, away))
            });
            if let Some((index, _)) = near.min_by_key(|(_, away)| *away) {
                return Under::Point(index);
            }
        }
        let items = self.scene().items.iter().enumerate().filter(|(_, item)| !paint::is_hidden(item));
        let hits = items.filter_map(|(number, _)| {
            let depth = paint::hit(self.shapes.of(number)?, self.eye, at)?;
            Some((number, depth))
        });
        match hits.max_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((number, _)) if self.selected == Some(number) => Under::Selected,
            Some((number, _)) => Under::Item(number),
            None => Under::Nothing,
        }
    }

    /// Takes up an event of the mouse in the picture, and turns and zooms by keys; whether it was for that.
    pub(super) fn look_around(&mut self, tick: &Tick) -> bool {
        let at = (tick.mouse.x, tick.mouse.y);
        if let Some(grip) = self.grip.take() {
            return self.drag(grip, tick);
        }
        let in_picture = self.result.is_some() || paint::in_field(at);
        match tick.event {
            Some(Event::Press(button @ (Button::Left | Button::Right))) if in_picture => {
                let what = self.taken(button, at);
                self.grip = Some(Grip { button, from: at, what, moved: false });
                true
            }
            Some(Event::Wheel(steps)) if in_picture => {
                self.eye = self.eye.zoomed(steps, at);
                true
            }
            Some(Event::Key(Key::Char(sign @ ('+' | '-')))) => {
                let forward = sign == '+';
                match &mut self.section {
                    Some((axis, offset)) => {
                        let extent = self.shapes.bounds(None).map_or(1.0, |it| it.extent());
                        let step = extent / 50.0 * if forward { 1.0 } else { -1.0 };
                        let (axis, moved) = (*axis, (*offset + step).clamp(-edit::FARTHEST, edit::FARTHEST));
                        self.section = Some((axis, moved));
                    }
                    None => self.eye = self.eye.zoomed(if forward { 1 } else { -1 }, (252, 261)),
                }
                true
            }
            Some(Event::Key(key)) => {
                let eye = self.eye.after(key);
                self.eye = eye.unwrap_or(self.eye);
                eye.is_some()
            }
            _ => false,
        }
    }

    /// What a press of a button takes up. A press on an item selects it.
    pub(super) fn taken(&mut self, button: Button, at: (i32, i32)) -> Held {
        if self.result.is_some() {
            return Held::View(self.eye);
        }
        match (self.under(at), button) {
            (Under::Point(index), Button::Left) => {
                let place = self.item().and_then(|item| edit::control_point(item, index));
                self.point = Some(index);
                self.page = Page::Point;
                Held::Point(index, place.unwrap_or_default())
            }
            (Under::Selected | Under::Point(_), _) => {
                self.item().map_or(Held::View(self.eye), |item| Held::Item(Box::new(item.clone())))
            }
            (Under::Item(number), Button::Left) => {
                self.select(Some(number));
                Held::View(self.eye)
            }
            _ => Held::View(self.eye),
        }
    }

    /// Goes on with what the mouse holds.
    pub(super) fn drag(&mut self, mut grip: Grip, tick: &Tick) -> bool {
        let at = (tick.mouse.x, tick.mouse.y);
        let by = (at.0 - grip.from.0, at.1 - grip.from.1);
        if tick.pressed(Key::Esc) {
            if let Held::View(eye) = grip.what {
                self.eye = eye;
            }
            self.preview = None;
            return true;
        }
        grip.moved |= by.0.abs() > DRAG || by.1.abs() > DRAG;
        if grip.moved {
            self.preview = self.dragged(&grip, by);
        }
        let released = tick.event == Some(Event::Release(grip.button)) || !tick.mouse.holds(grip.button);
        if !released {
            self.grip = Some(grip);
            return true;
        }
        match (self.preview.take(), &grip.what) {
            (Some(scene), _) => self.change(scene),
            // A click on nothing selects nothing.
            (None, Held::View(_)) if !grip.moved && grip.button == Button::Left && self.result.is_none() => {
                if matches!(self.under(at), Under::Nothing) {
                    self.select(None);
                }
            }
            _ => {}
        }
        true
    }

    /// The scene with what is held moved or turned; a view has none.
    pub(super) fn dragged(&mut self, grip: &Grip, by: (i32, i32)) -> Option<Scene> {
        let at = self.selected;
        let movement = self.eye.movement(by);
        match &grip.what {
            Held::View(eye) => {
                self.eye = match grip.button {
                    Button::Left if self.result.is_none() => eye.moved_by(by),
                    _ => eye.turned_by(by),
                };
                None
            }
            Held::Item(item) => {
                let map = match grip.button {
                    Button::Left => Affine::moved(movement),
                    _ => Affine::about(self.eye.rotation(by), edit::middle(item)),
                };
                Some(self.with_item(at?, edit::mapped(item, &map)))
            }
            Held::Point(index, place) => {
                let item = self.history.now().items.get(at?)?.clone();
                let moved =
                    std::array::from_fn(|d| (place[d] + movement[d]).clamp(-edit::FARTHEST, edit::FARTHEST));
                Some(self.with_item(at?, edit::with_point(item, *index, moved)))
            }
        }
    }

    pub(super) fn place_under(&self, at: (i32, i32)) -> Option<f64> {
        match self.shapes.of(self.selected?)? {
            Shape::Curve { line, .. } if paint::in_field(at) => paint::nearest_parameter(line, self.eye, at),
            _ => None,
        }
    }

    pub(super) fn point_at(&self, s: f64) -> Option<Point<3>> {
        match self.shapes.of(self.selected?)? {
            Shape::Curve { arc, .. } => arc.eval(0, s),
            _ => None,
        }
    }

    pub(super) fn point_pointer(&self, desk: &mut Desk<'_>, tick: &Tick) {
        let at = (tick.mouse.x, tick.mouse.y);
        let outside = self.result.is_some() || !paint::in_field(at);
        let under = if outside { Under::Nothing } else { self.under(at) };
        desk.machine.set_pointer(pointers::of(match (&self.grip, under) {
            (Some(Grip { what: Held::Item(_), .. }), _) => pointers::Shape::Move,
            (_, Under::Nothing) => pointers::Shape::Arrow,
            (_, Under::Item(_)) => pointers::Shape::Hand,
            (_, Under::Point(_)) => pointers::Shape::Point,
            (_, Under::Selected) => pointers::Shape::Move,
        }));
    }
}
