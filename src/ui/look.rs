//! The view of space and its scale, and how the user changes them. They are not part of the edited value, so they are
//! neither saved nor undone.

use super::words::{Phrase, Words};
use crate::geometry::{BoundingBox, Point, Projection, Turn, Vertex, View};
use crate::machine::{Button, Event, Key, Tick};
use serde::Serialize;

/// Steps of the wheel that double the scale.
const DOUBLING: i32 = 4;
/// The largest number of steps away from the scale of 1: eight times as large or as small.
const MOST: i32 = 3 * DOUBLING;
/// Extents, from corner to corner, between which a box is shown at the scale of 1, and pixels that others are given.
const SMALL: f64 = 150.0;
const LARGE: f64 = 500.0;
const FRAMED: f64 = 330.0;
/// Pixels of mouse movement per radian: the front of a ball of this radius follows the mouse.
const RADIAN: f64 = 200.0;

/// A pixel's coordinate. Rounds halves to even, as the original does; what is far outside stays far
/// outside.
pub(crate) fn pixel(value: f64) -> i32 {
    value.round_ties_even().clamp(-30_000.0, 30_000.0) as i32
}

/// From how far the viewer looks (chapter 4.4.1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Sight {
    /// From infinitely far, by parallel rays.
    #[default]
    Parallel,
    /// From the distance of the book's cube.
    Central,
    /// From so near that the difference is plain.
    Near,
}

/// The key that changes it.
pub(crate) const SIGHT_KEY: Key = Key::Char('L');

impl Sight {
    /// The one after it.
    pub(crate) fn next(self) -> Sight {
        match self {
            Sight::Parallel => Sight::Central,
            Sight::Central => Sight::Near,
            Sight::Near => Sight::Parallel,
        }
    }

    /// The distance of the eye from the middle, in pixels before zooming.
    fn distance(self) -> Option<f64> {
        match self {
            Sight::Parallel => None,
            Sight::Central => Some(1500.0),
            Sight::Near => Some(600.0),
        }
    }

    /// The projection at so many pixels per unit, of what reaches so many units from the middle: the eye keeps twice
    /// that distance.
    pub(crate) fn projection(self, unit: f64, reach: f64) -> Projection {
        let distance = self.distance().map(|pixels| (pixels / unit).max(2.0 * reach));
        distance.map_or(Projection::Parallel, Projection::central)
    }

    /// What a message says when it has been chosen.
    pub(crate) fn told(self) -> Phrase {
        match self {
            Sight::Parallel => Words("Párhuzamos vetítés", "Parallel projection"),
            Sight::Central => Words("Középpontos vetítés", "Central projection"),
            Sight::Near => Words("Középpontos, közeli szem", "Central, nearer eye"),
        }
        .into()
    }
}

/// A view at a scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Look {
    pub(crate) view: View,
    /// The initial view, which Home restores.
    home: View,
    poles: Poles,
    /// Wheel steps from the scale of `unit`.
    zoom: i32,
    /// Pixels per unit of length before zooming.
    unit: f64,
    /// The place in the middle of the picture.
    middle: Point<3>,
    /// Where that is, in pixels from the middle of the originals' picture.
    shift: (i32, i32),
    sight: Sight,
    /// What that was when it was chosen, in units of length.
    projection: Projection,
}

/// The places of points on the screen.
pub(crate) struct Places {
    /// The view with its projection, of the middle at the origin.
    view: View,
    /// The same of places in space.
    seen: View,
    middle: Point<3>,
    scale: f64,
    shift: (i32, i32),
}

impl Places {
    /// The pixel that a point falls on.
    pub(crate) fn to_screen(&self, point: Point<3>) -> (i32, i32) {
        let point = std::array::from_fn(|d| point[d] - self.middle[d]);
        let [x, y] = self.view.pixel(point, self.scale);
        (pixel(x) + self.shift.0, pixel(y) + self.shift.1)
    }

    /// The same with its depth.
    pub(crate) fn vertex(&self, point: Point<3>) -> Vertex {
        let (x, y) = self.to_screen(point);
        Vertex { x, y, depth: self.seen.depth(point) as f32 }
    }
}

/// What an arrow key does when the view is along the z axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Poles {
    /// It stops, as in the original.
    Stop,
    /// It continues to the other side.
    Cross,
}

impl Look {
    /// The look at a new configuration from a direction.
    pub(crate) fn new(direction: Point<3>, poles: Poles) -> Look {
        let home = View::from_direction(direction);
        Look {
            view: home,
            home,
            poles,
            zoom: 0,
            unit: 1.0,
            middle: [0.0; 3],
            shift: (0, 0),
            sight: Sight::Parallel,
            projection: Projection::Parallel,
        }
    }

    /// From how far it is.
    pub(crate) fn sight(self) -> Sight {
        self.sight
    }

    /// The look from another distance at what lies in a box.
    pub(crate) fn seen_from(self, sight: Sight, bounds: Option<BoundingBox<3>>) -> Look {
        let reach = bounds.map_or(0.0, |bounds| {
            let far =
                |d: usize| (bounds.min[d] - self.middle[d]).abs().max((bounds.max[d] - self.middle[d]).abs());
            far(0).hypot(far(1)).hypot(far(2))
        });
        Look { sight, projection: sight.projection(self.unit, reach), ..self }
    }

    /// The view with its projection, for places in space.
    pub(crate) fn seen(self) -> View {
        self.view.projected(self.projection, self.middle)
    }

    /// The look in a picture whose middle is elsewhere on the screen.
    pub(crate) fn shifted(self, shift: (i32, i32)) -> Look {
        Look { shift, ..self }
    }

    /// The look that shows all of a box, if at the scale of 1 it would be far too small, too large or beside the
    /// picture.
    pub(crate) fn framing(self, bounds: &BoundingBox<3>) -> Look {
        let middle: Point<3> = std::array::from_fn(|d| 0.5 * (bounds.min[d] + bounds.max[d]));
        let extent = bounds.extent();
        let fits = (SMALL..=LARGE).contains(&extent) && middle.iter().all(|x| x.abs() < 0.25 * LARGE);
        let unit = FRAMED / extent;
        let look =
            if fits || !unit.is_finite() || unit <= 0.0 { self } else { Look { unit, middle, ..self } };
        look.seen_from(look.sight, Some(*bounds))
    }

    /// The coordinate of the middle of the picture along an axis.
    pub(crate) fn middle(self, axis: usize) -> f64 {
        self.middle.get(axis).copied().unwrap_or(0.0)
    }

    /// Units of length per pixel before zooming.
    pub(crate) fn length(self, pixels: f64) -> f64 {
        pixels / self.unit
    }

    /// Pixels per unit of length.
    pub(crate) fn scale(self) -> f64 {
        self.unit * (f64::from(self.zoom) / f64::from(DOUBLING)).exp2()
    }

    /// Units of length per pixel as it is zoomed.
    pub(crate) fn length_now(self, pixels: f64) -> f64 {
        pixels / self.scale()
    }

    /// The pixel of a point.
    pub(crate) fn to_screen(self, point: Point<3>) -> (i32, i32) {
        self.places().to_screen(point)
    }

    /// What places many points on the screen: all that does not depend on the point is computed once.
    pub(crate) fn places(self) -> Places {
        let view = self.view.projected(self.projection, [0.0; 3]);
        Places { view, seen: self.seen(), middle: self.middle, scale: self.scale(), shift: self.shift }
    }

    /// A point dragged by pixels to the right and down; its depth stays.
    pub(crate) fn dragged(self, point: Point<3>, (right, down): (i32, i32)) -> Point<3> {
        self.seen().moved(point, [right, -down].map(|pixels| f64::from(pixels) / self.scale()))
    }

    /// Turned by a drag by pixels to the right and down, across the poles as well: what is in front follows the
    /// mouse.
    pub(crate) fn turned_by(self, (right, down): (i32, i32)) -> Look {
        // The side is that at the start of the drag, so that nothing reverses when a pole is crossed.
        let side = if self.view.upside_down() { 1.0 } else { -1.0 };
        let view = self.view.turned(side * f64::from(right) / RADIAN, f64::from(down) / RADIAN);
        Look { view, ..self }
    }

    /// Magnified by steps of the wheel; negative steps reduce.
    pub(crate) fn zoomed(self, steps: i32) -> Look {
        Look { zoom: self.zoom.saturating_add(steps).clamp(-MOST, MOST), ..self }
    }

    /// The look after a key that changes it.
    pub(crate) fn after(self, key: Key) -> Option<Look> {
        let turn = match key {
            Key::Up => Turn::Up,
            Key::Down => Turn::Down,
            Key::Left => Turn::Left,
            Key::Right => Turn::Right,
            Key::Home => return Some(Look { view: self.home, zoom: 0, ..self }),
            _ => return None,
        };
        let view = match self.poles {
            Poles::Stop => self.view.stepped(turn),
            Poles::Cross => self.view.stepped_across(turn),
        };
        Some(Look { view, ..self })
    }
}

/// A look that the user changes by arrow keys, the right button and the wheel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Viewer {
    pub(crate) look: Look,
    /// Where a turn by the mouse began: the look, the pixel, and the button.
    turning: Option<(Look, (i32, i32), Button)>,
}

impl Viewer {
    pub(crate) fn new(look: Look) -> Viewer {
        Viewer { look, turning: None }
    }

    /// Begins a turn by the mouse, which lasts as long as a button is held.
    pub(crate) fn turn(&mut self, at: (i32, i32), button: Button) {
        self.turning = Some((self.look, at, button));
    }

    /// Ends a turn by the mouse that has been interrupted.
    pub(crate) fn stop(&mut self) {
        self.turning = None;
    }

    /// Turns and zooms; returns whether the event was for that.
    pub(crate) fn look_around(&mut self, tick: &Tick) -> bool {
        if let Some((from, (x, y), button)) = self.turning {
            match tick.event {
                Some(Event::Key(Key::Esc)) => (self.look, self.turning) = (from, None),
                _ if !tick.mouse.holds(button) => self.turning = None,
                event => {
                    // Two fingers turn and zoom in one.
                    let steps = if let Some(Event::Wheel(steps)) = event { steps } else { 0 };
                    let from = from.zoomed(steps);
                    self.turning = Some((from, (x, y), button));
                    self.look = from.turned_by((tick.mouse.x - x, tick.mouse.y - y));
                }
            }
            return true;
        }
        match tick.event {
            Some(Event::Press(Button::Right)) => {
                self.turn((tick.mouse.x, tick.mouse.y), Button::Right);
                true
            }
            Some(Event::Wheel(steps)) => {
                self.look = self.look.zoomed(steps);
                true
            }
            Some(Event::Key(key)) => {
                let look = self.look.after(key);
                self.look = look.unwrap_or(self.look);
                look.is_some()
            }
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::SPACE_VIEW;

    fn start() -> Look {
        Look::new(SPACE_VIEW, Poles::Stop)
    }
    use proptest::prelude::*;

    #[test]
    fn the_scale_has_its_limits_and_home_is_the_start() {
        let look = start().zoomed(i32::MAX);
        assert_eq!((look.scale(), look.zoomed(i32::MIN).scale()), (8.0, 0.125));
        assert_eq!(look.zoomed(-12).scale(), 1.0);
        assert_eq!(look.turned_by((77, -300)).after(Key::Home), Some(start()));
    }

    /// A framed look at what lies far away has its middle in the middle from every distance, and all in front.
    #[test]
    fn the_middle_stays_and_nothing_is_beside_the_eye() {
        let bounds = BoundingBox { min: [5000.0, 0.0, 0.0], max: [9000.0, 3000.0, 100.0] };
        for sight in [Sight::Parallel, Sight::Central, Sight::Near] {
            for look in [start().framing(&bounds), start()].map(|look| look.seen_from(sight, Some(bounds))) {
                let middle = std::array::from_fn(|d| look.middle(d));
                assert_eq!(look.to_screen(middle), (331, 260));
                for corner in [bounds.min, bounds.max] {
                    assert!(look.seen().magnification(corner) <= 2.0);
                }
            }
        }
    }

    #[test]
    fn a_drag_goes_over_the_pole_without_a_jump() {
        let beginning = start();
        let places = |down| beginning.turned_by((0, down)).to_screen([40.0, -90.0, 120.0]);
        assert!(beginning.turned_by((0, 300)).view.upside_down());
        for down in 0..700 {
            let ((x1, y1), (x2, y2)) = (places(down), places(down + 1));
            assert!((x1 - x2).abs() <= 1 && (y1 - y2).abs() <= 2, "{down}");
        }
    }

    proptest! {
        #[test]
        fn a_dragged_point_is_under_the_mouse(
            point in prop::array::uniform3(-300.0..300.0f64),
            drag in prop::array::uniform2(-300..300),
            turn in prop::array::uniform2(-900..900),
            zoom in -14..14,
            sight in prop::sample::select(vec![Sight::Parallel, Sight::Central, Sight::Near]),
        ) {
            let bounds = BoundingBox { min: [-300.0; 3], max: [300.0; 3] };
            let look = start().seen_from(sight, Some(bounds)).turned_by((turn[0], turn[1])).zoomed(zoom);
            let dragged = look.dragged(point, (drag[0], drag[1]));
            let (x, y) = look.to_screen(point);
            let (to_x, to_y) = look.to_screen(dragged);
            prop_assert!((to_x - x - drag[0]).abs() <= 1 && (to_y - y - drag[1]).abs() <= 1);
            prop_assert!((look.view.depth(dragged) - look.view.depth(point)).abs() < 1e-9);
            let [right, up] = look.seen().place(point).map(|x| x * look.scale());
            prop_assert!((f64::from(x) - 331.0 - right).abs() <= 0.5 && (f64::from(y) - 260.0 + up).abs() <= 0.5);
        }

        #[test]
        // Less than four pixels may round to no pixel at all.
        fn the_front_follows_the_mouse(turn in prop::array::uniform2(-900..900), by in 4..40) {
            let look = start().turned_by((turn[0], turn[1]));
            prop_assume!(look.view.elevation().cos().abs() > 0.3);
            // The point of a ball that looks straight to the viewer, in the middle of the picture.
            let (a, e) = (look.view.azimuth(), look.view.elevation());
            let front = [e.cos() * a.cos(), e.cos() * a.sin(), e.sin()].map(|value| 200.0 * value);
            let (x, y) = look.turned_by((by, 0)).to_screen(front);
            prop_assert!(x > 331 && x <= 331 + by + 1 && (y - 260).abs() <= by, "{x} {y}");
            let (x, y) = look.turned_by((0, by)).to_screen(front);
            prop_assert!(x == 331 && y > 260 - 1 && y <= 260 + by + 1, "{x} {y}");
        }
    }
}
