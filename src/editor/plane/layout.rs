//! Where everything stands on the screen of the plane editor, and the way between field and screen.

use crate::editor::field::{self, pixel};
use crate::geometry::Point;
use crate::screen::{Color, Screen, Stroke};
use crate::ui::Area;

/// Where the field's origin lies on the screen.
const ORIGIN: (i32, i32) = (41, 450);
/// Where the mouse can drag a point to.
const REACH: Area = Area::new(41, 10, 620, 450);
/// The place of the store, from where new points are taken, in field coordinates.
pub(super) const STORE_AT: Point<2> = [577.0, 360.0];

/// The pixel of a point of the field.
pub(super) fn to_screen([x, y]: Point<2>) -> (i32, i32) {
    (ORIGIN.0 + pixel(x), ORIGIN.1 - pixel(y))
}

/// The point of the field under a pixel, as far as the mouse can drag one.
pub(super) fn to_field(x: i32, y: i32) -> Point<2> {
    let (x, y) = (x.clamp(REACH.x1, REACH.x2), y.clamp(REACH.y1, REACH.y2));
    [f64::from(x - ORIGIN.0), f64::from(ORIGIN.1 - y)]
}

/// The grid of ten pixels.
pub(super) fn grid(screen: &mut Screen) {
    let stroke = Stroke::thin(Color::LightGray);
    for column in 0..57 {
        let x = ORIGIN.0 + 10 * column;
        screen.line(x, 450, x, 70, stroke);
    }
    for row in 0..39 {
        let y = ORIGIN.1 - 10 * row;
        screen.line(41, y, 601, y, stroke);
    }
}

/// Everything around the picture, with the scales.
pub(super) fn surroundings(screen: &mut Screen) {
    field::surroundings(screen);
    let tick = Stroke::thin(Color::Black);
    for hundred in 0..6 {
        let x = ORIGIN.0 + 100 * hundred;
        screen.line(x, 462, x, 470, tick);
        let label_x = if hundred == 0 { 27 } else { x - 25 };
        screen.text(label_x, 472, &(100 * hundred).to_string(), Color::Black);
    }
    for hundred in 0..4 {
        let y = ORIGIN.1 - 100 * hundred;
        screen.line(11, y, 29, y, tick);
        let label_x = if hundred == 0 { 11 } else { 1 };
        screen.text(label_x, y - 10, &(100 * hundred).to_string(), Color::Black);
    }
}

/// A control point with its number, counted from 1.
pub(super) fn control_point(screen: &mut Screen, point: Point<2>, number: usize) {
    field::numbered_disc(screen, to_screen(point), number, Color::DarkGray);
}

/// Whether a pixel lies on the disc of a control point.
pub(super) fn on_disc(point: Point<2>, at: (i32, i32)) -> bool {
    field::on_disc(to_screen(point), at)
}
