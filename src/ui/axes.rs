//! The axes in the picture of space, and the legend of a result that is turned.

use super::look::Look;
use super::words::Words;
use crate::geometry::Point;
use crate::machine::Language;
use crate::screen::{Color, Screen, Stroke};

/// The axes with their names, and the offset of each name from the axis's end.
const AXES: [(&str, Point<3>, (i32, i32)); 3] =
    [("x", [200.0, 0.0, 0.0], (2, 2)), ("y", [0.0, 200.0, 0.0], (2, 2)), ("z", [0.0, 0.0, 200.0], (5, 2))];

/// The arrows in the corner of the result.
const ARROWS: [[(i32, i32); 2]; 12] = [
    [(50, 10), (50, 35)],
    [(50, 10), (48, 14)],
    [(50, 10), (52, 14)],
    [(50, 70), (50, 45)],
    [(50, 70), (48, 66)],
    [(50, 70), (52, 66)],
    [(20, 40), (45, 40)],
    [(20, 40), (24, 38)],
    [(20, 40), (24, 42)],
    [(80, 40), (55, 40)],
    [(80, 40), (76, 38)],
    [(80, 40), (76, 42)],
];

/// Draws the three axes.
pub(crate) fn draw_axes(screen: &mut Screen, look: Look) {
    let (x0, y0) = look.to_screen([0.0; 3]);
    for (name, end, (dx, dy)) in AXES {
        let (x, y) = look.to_screen(end.map(|x| look.length(x)));
        screen.line(x0, y0, x, y, Stroke::thin(Color::White));
        screen.text(x + dx, y + dy, name, Color::White);
    }
}

/// Draws the arrows and what Esc does.
pub(crate) fn draw_legend(screen: &mut Screen, leave: Words, language: Language) {
    for [(x1, y1), (x2, y2)] in ARROWS {
        screen.line(x1, y1, x2, y2, Stroke::thin(Color::LightGray));
    }
    screen.text(15, 85, leave.of(language), Color::LightGray);
}
