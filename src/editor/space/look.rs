//! How the user looks at space: the view and the scale, and the ways to change them. Nothing of this is
//! saved or undone: it is no part of the configuration.

use crate::editor::field::pixel;
use crate::file::SPACE_VIEW;
use crate::geometry::{Point, Turn, View};
use crate::machine::Key;

/// Steps of the wheel that double the scale.
const DOUBLING: i32 = 4;
/// The largest number of steps away from the scale of 1: eight times as large or as small.
const MOST: i32 = 3 * DOUBLING;
/// Pixels that the mouse moves for a turn by a radian: the front of a ball of this radius follows it.
const RADIAN: f64 = 200.0;

/// A view at a scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look {
    pub(super) view: View,
    /// Wheel steps away from a pixel for a unit of length.
    zoom: i32,
}

impl Default for Look {
    /// The look at every new configuration.
    fn default() -> Look {
        Look { view: View::from_direction(SPACE_VIEW), zoom: 0 }
    }
}

impl Look {
    /// Pixels for a unit of length.
    pub(super) fn scale(self) -> f64 {
        (f64::from(self.zoom) / f64::from(DOUBLING)).exp2()
    }

    /// The pixel of a point.
    pub(super) fn to_screen(self, point: Point<3>) -> (i32, i32) {
        let [x, y] = self.view.pixel(point, self.scale());
        (pixel(x), pixel(y))
    }

    /// A point dragged over so many pixels to the right and down: its depth stays.
    pub(super) fn dragged(self, point: Point<3>, (right, down): (i32, i32)) -> Point<3> {
        self.view.moved(point, [right, -down].map(|pixels| f64::from(pixels) / self.scale()))
    }

    /// Turned by a drag over so many pixels to the right and down, freely over the poles: what is in
    /// front follows the mouse.
    pub(super) fn turned_by(self, (right, down): (i32, i32)) -> Look {
        // The side is that of the drag's beginning, so that crossing a pole turns nothing round.
        let side = if self.view.upside_down() { 1.0 } else { -1.0 };
        let view = self.view.turned(side * f64::from(right) / RADIAN, f64::from(down) / RADIAN);
        Look { view, ..self }
    }

    /// Larger by so many steps of the wheel, or smaller.
    pub(super) fn zoomed(self, steps: i32) -> Look {
        Look { zoom: self.zoom.saturating_add(steps).clamp(-MOST, MOST), ..self }
    }

    /// The look after a key that changes it.
    pub(super) fn after(self, key: Key) -> Option<Look> {
        let turn = match key {
            Key::Up => Turn::Up,
            Key::Down => Turn::Down,
            Key::Left => Turn::Left,
            Key::Right => Turn::Right,
            Key::Home => return Some(Look::default()),
            _ => return None,
        };
        Some(Look { view: self.view.stepped(turn), ..self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_scale_has_its_limits_and_home_is_the_start() {
        let look = Look::default().zoomed(i32::MAX);
        assert_eq!((look.scale(), look.zoomed(i32::MIN).scale()), (8.0, 0.125));
        assert_eq!(look.zoomed(-12).scale(), 1.0);
        assert_eq!(look.turned_by((77, -300)).after(Key::Home), Some(Look::default()));
    }

    #[test]
    fn a_drag_goes_over_the_pole_without_a_jump() {
        let start = Look::default();
        let places = |down| start.turned_by((0, down)).to_screen([40.0, -90.0, 120.0]);
        assert!(start.turned_by((0, 300)).view.upside_down());
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
        ) {
            let look = Look::default().turned_by((turn[0], turn[1])).zoomed(zoom);
            let dragged = look.dragged(point, (drag[0], drag[1]));
            let (x, y) = look.to_screen(point);
            let (to_x, to_y) = look.to_screen(dragged);
            prop_assert!((to_x - x - drag[0]).abs() <= 1 && (to_y - y - drag[1]).abs() <= 1);
            prop_assert!((look.view.depth(dragged) - look.view.depth(point)).abs() < 1e-9);
        }

        #[test]
        // Less than four pixels may round to no pixel at all.
        fn the_front_follows_the_mouse(turn in prop::array::uniform2(-900..900), by in 4..40) {
            let look = Look::default().turned_by((turn[0], turn[1]));
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
