//! The picture area that the curve editors draw in, its frame, and the discs of control points.

use crate::screen::{Color, Screen};
use crate::ui::{Area, sunken};

/// The black area of the picture.
pub(crate) const PICTURE: Area = Area::new(29, 58, 633, 462);
/// Its frame.
const FRAME: Area = Area::new(25, 54, 637, 466);
/// Radius of a control point's disc in pixels.
const RADIUS: i32 = 10;

/// The black background of the picture.
pub(crate) fn ground(screen: &mut Screen) {
    screen.bar(PICTURE.x1, PICTURE.y1, PICTURE.x2, PICTURE.y2, Color::Black);
}

/// Everything around the picture. It is drawn later, so that it covers a curve that leaves the field.
pub(crate) fn surroundings(screen: &mut Screen) {
    let Area { x1, y1, x2, y2 } = FRAME;
    screen.bar(0, 0, 639, y1, Color::LightCyan);
    screen.bar(0, y2, 639, 479, Color::LightCyan);
    screen.bar(0, y1, x1, y2, Color::LightCyan);
    screen.bar(x2, y1, 639, y2, Color::LightCyan);
    sunken(screen, FRAME, 4);
}

/// The disc of a control point with its number, counted from 1.
pub(crate) fn numbered_disc(screen: &mut Screen, (x, y): (i32, i32), number: usize, fill: Color) {
    screen.disc(x, y, RADIUS, fill, Color::White);
    let text_x = if number <= 9 { x - 2 } else { x - 7 };
    screen.text(text_x, y - 3, &number.to_string(), Color::White);
}

/// Whether a pixel lies on the disc around another.
pub(crate) fn on_disc(center: (i32, i32), at: (i32, i32)) -> bool {
    within(RADIUS, center, at)
}

/// Whether two pixels are no farther apart than so many.
pub(crate) fn within(reach: i32, one: (i32, i32), other: (i32, i32)) -> bool {
    apart(one, other) <= i64::from(reach).pow(2)
}

/// The square of the distance of two pixels.
pub(crate) fn apart((x1, y1): (i32, i32), (x2, y2): (i32, i32)) -> i64 {
    let square = |a: i32, b: i32| (i64::from(a) - i64::from(b)).saturating_pow(2);
    square(x1, x2).saturating_add(square(y1, y2))
}
