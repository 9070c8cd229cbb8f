//! How a scene is seen: turned, moved and zoomed, for scenes are of any size.

use crate::file::ec::SceneView;
use crate::geometry::{BoundingBox, Point, Turn, Vertex, View};
use crate::machine::Key;
use crate::ui::Area;
use crate::ui::look::pixel;

/// The picture.
pub(super) const FIELD: Area = Area::new(28, 57, 476, 465);
/// Its middle.
const CENTRE: (i32, i32) = (252, 261);
/// The smallest and the largest number of pixels a unit.
const ZOOM: [f64; 2] = [0.01, 1000.0];
/// Pixels of mouse movement per radian.
const RADIAN: f64 = 200.0;
/// Steps of the wheel that double the zoom.
const DOUBLING: f64 = 4.0;
/// The part of the field that a scene fills when it is fitted in.
const FILLED: f64 = 0.8;

/// A view with its zoom and the place of the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Eye {
    pub(super) view: View,
    /// Pixels a unit.
    pub(super) zoom: f64,
    /// Where the origin is, in pixels to the right and down from the middle of the field.
    pub(super) shift: [f64; 2],
}

impl Default for Eye {
    fn default() -> Eye {
        Eye::of(&SceneView::default())
    }
}

impl Eye {
    pub(super) fn of(view: &SceneView) -> Eye {
        Eye {
            view: View::from_angles(view.azimuth.to_radians(), view.elevation.to_radians()),
            zoom: view.zoom.clamp(ZOOM[0], ZOOM[1]),
            shift: view.shift,
        }
    }

    pub(super) fn to_file(self) -> SceneView {
        let [azimuth, elevation] = [self.view.azimuth(), self.view.elevation()].map(f64::to_degrees);
        SceneView { azimuth, elevation, zoom: self.zoom, shift: self.shift }
    }

    /// The place of a point on the screen, with its depth in pixels.
    pub(super) fn vertex(&self, point: Point<3>) -> Vertex {
        let [x, y] = self.view.place(point);
        Vertex {
            x: CENTRE.0 + pixel(self.shift[0] + self.zoom * x),
            y: CENTRE.1 + pixel(self.shift[1] - self.zoom * y),
            depth: (self.zoom * self.view.depth(point)) as f32,
        }
    }

    pub(super) fn pixel(&self, point: Point<3>) -> (i32, i32) {
        let Vertex { x, y, .. } = self.vertex(point);
        (x, y)
    }

    /// A vector in space that is seen as a movement by pixels to the right and down, and has no depth.
    pub(super) fn movement(&self, (right, down): (i32, i32)) -> Point<3> {
        self.view.moved([0.0; 3], [right, -down].map(|pixels| f64::from(pixels) / self.zoom))
    }

    /// Turned by a drag, across the poles as well: what is in front follows the mouse.
    pub(super) fn turned_by(self, (right, down): (i32, i32)) -> Eye {
        let side = if self.view.upside_down() { 1.0 } else { -1.0 };
        Eye { view: self.view.turned(side * f64::from(right) / RADIAN, f64::from(down) / RADIAN), ..self }
    }

    /// The rotation of space by which a body follows a drag of the mouse: rows of a matrix.
    pub(super) fn rotation(&self, (right, down): (i32, i32)) -> [Point<3>; 3] {
        let [x, y] = [right, down].map(|by| f64::from(by) / RADIAN);
        let angle = x.hypot(y);
        if angle == 0.0 {
            return [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        }
        // About the axis in the picture that is perpendicular to the drag (Rodrigues).
        let axis = self.view.moved([0.0; 3], [y / angle, x / angle]);
        let (sin, cos) = angle.sin_cos();
        let cross = [[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]];
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let unit = if i == j { cos } else { 0.0 };
                unit + (1.0 - cos) * axis[i] * axis[j] + sin * cross[i][j]
            })
        })
    }

    /// Moved by pixels to the right and down.
    pub(super) fn moved_by(self, (right, down): (i32, i32)) -> Eye {
        let [x, y] = self.shift;
        let within = |shift: f64| shift.clamp(-1e6, 1e6);
        Eye { shift: [within(x + f64::from(right)), within(y + f64::from(down))], ..self }
    }

    /// Magnified by steps of the wheel; what is under the mouse stays there.
    pub(super) fn zoomed(self, steps: i32, (x, y): (i32, i32)) -> Eye {
        let zoom = (self.zoom * (f64::from(steps) / DOUBLING).exp2()).clamp(ZOOM[0], ZOOM[1]);
        let at = [f64::from(x - CENTRE.0), f64::from(y - CENTRE.1)];
        let shift = std::array::from_fn(|d| at[d] + (self.shift[d] - at[d]) * zoom / self.zoom);
        Eye { zoom, ..self }.shifted(shift)
    }

    fn shifted(self, shift: [f64; 2]) -> Eye {
        Eye { shift: shift.map(|x| x.clamp(-1e6, 1e6)), ..self }
    }

    /// The same view with a point in the middle.
    pub(super) fn centred(self, point: Point<3>) -> Eye {
        let [x, y] = self.view.place(point);
        self.shifted([-self.zoom * x, self.zoom * y])
    }

    /// The same direction with all of a box in the field.
    pub(super) fn fitted(self, bounds: BoundingBox<3>) -> Eye {
        self.fitted_in(bounds, FIELD)
    }

    /// The same direction with all of a box in an area of the screen.
    pub(super) fn fitted_in(self, bounds: BoundingBox<3>, area: Area) -> Eye {
        let corners = (0..8).map(|k| -> Point<3> {
            std::array::from_fn(|d| if k >> d & 1 == 0 { bounds.min[d] } else { bounds.max[d] })
        });
        let places: Vec<Point<2>> = corners.map(|corner| self.view.place(corner)).collect();
        let Some(flat) = BoundingBox::of_points(&places) else { return self };
        let [width, height] = flat.size();
        let (across, down) = (f64::from(area.x2 - area.x1), f64::from(area.y2 - area.y1));
        let zoom = FILLED * (across / width.max(1e-9)).min(down / height.max(1e-9));
        let middle: Point<3> = std::array::from_fn(|d| bounds.min[d] / 2.0 + bounds.max[d] / 2.0);
        let centred = Eye { zoom: zoom.clamp(ZOOM[0], ZOOM[1]), ..self }.centred(middle);
        centred.moved_by(((area.x1 + area.x2) / 2 - CENTRE.0, (area.y1 + area.y2) / 2 - CENTRE.1))
    }

    /// The eye after an arrow key.
    pub(super) fn after(self, key: Key) -> Option<Eye> {
        let turn = match key {
            Key::Up => Turn::Up,
            Key::Down => Turn::Down,
            Key::Left => Turn::Left,
            Key::Right => Turn::Right,
            _ => return None,
        };
        Some(Eye { view: self.view.stepped_across(turn), ..self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn eye(turn: [i32; 2], zoom: i32) -> Eye {
        Eye::default().turned_by((turn[0], turn[1])).zoomed(zoom, (100, 100))
    }

    proptest! {
        #[test]
        fn what_is_moved_follows_the_mouse(
            point in prop::array::uniform3(-100.0..100.0f64),
            by in prop::array::uniform2(-100..100),
            turn in prop::array::uniform2(-600..600),
            zoom in -8..8,
        ) {
            let eye = eye(turn, zoom);
            let movement = eye.movement((by[0], by[1]));
            let moved = std::array::from_fn(|d| point[d] + movement[d]);
            let ((x, y), (to_x, to_y)) = (eye.pixel(point), eye.pixel(moved));
            prop_assert!((to_x - x - by[0]).abs() <= 1 && (to_y - y - by[1]).abs() <= 1);
        }

        #[test]
        fn a_fitted_box_lies_in_the_field(
            a in prop::array::uniform3(-100.0..100.0f64),
            b in prop::array::uniform3(-100.0..100.0f64),
            turn in prop::array::uniform2(-600..600),
        ) {
            let bounds = BoundingBox::of_points(&[a, b]).unwrap();
            let eye = eye(turn, 0).fitted(bounds);
            for corner in [a, b] {
                let (x, y) = eye.pixel(corner);
                prop_assert!(FIELD.holds(x, y), "{x} {y}");
            }
        }

        #[test]
        fn a_rotation_keeps_lengths(by in prop::array::uniform2(-400..400)) {
            let rows = Eye::default().rotation((by[0], by[1]));
            for (i, a) in rows.iter().enumerate() {
                for (j, b) in rows.iter().enumerate() {
                    let wanted = if i == j { 1.0 } else { 0.0 };
                    prop_assert!((crate::geometry::dot(*a, *b) - wanted).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn zooming_keeps_what_is_under_the_mouse() {
        let eye = Eye::default().zoomed(4, (300, 200));
        assert_eq!(eye.zoom, 2.0);
        let under = Eye::default().movement((300 - CENTRE.0, 200 - CENTRE.1));
        assert_eq!(eye.pixel(under), (300, 200));
        assert_eq!(Eye::of(&eye.to_file()).pixel(under), (300, 200));
    }
}
