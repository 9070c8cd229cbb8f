//! The layout of the Fourier editor's screen.

use crate::design::fourier::{Coefficient, Column, Quantity};
use crate::geometry::Point;
use crate::screen::{Color, Put, Screen};
use crate::ui::{Area, raised, sunken, window};

/// The pixel of the curve's origin.
const ORIGIN: (i32, i32) = (320, 270);
/// The field of the curve.
const FIELD: Area = Area::new(124, 70, 514, 470);
/// The largest extent of a fitted curve from the origin in x and y, in pixels.
pub(super) const REACH: Point<2> = [180.0, 185.0];
/// Upper and lower edge of the columns.
const EDGES: (i32, i32) = (70, 470);
/// Distance of two windows of a column.
const LINE: i32 = 18;

/// The pixel of a point of the curve, rounded half to even as in the original.
pub(super) fn to_screen([x, y]: Point<2>) -> (i32, i32) {
    // Keeps the number in range; the point is off the screen anyway.
    let pixel = |value: f64| value.round_ties_even().clamp(-30_000.0, 30_000.0) as i32;
    (ORIGIN.0 + pixel(x), ORIGIN.1 - pixel(y))
}

/// The black background of the curve.
pub(super) fn field(screen: &mut Screen) {
    screen.bar(FIELD.x1, FIELD.y1, FIELD.x2, FIELD.y2, Color::Black);
}

/// Everything around the field. It is drawn after the curve, so that it covers what leaves the field.
pub(super) fn surroundings(screen: &mut Screen) {
    let Area { x1, y1, x2, y2 } = Area::new(120, 66, 519, 475);
    screen.bar(0, 0, 639, y1, Color::LightCyan);
    screen.bar(0, y2, 639, 479, Color::LightCyan);
    screen.bar(0, y1, x1, y2, Color::LightCyan);
    screen.bar(x2, y1, 639, y2, Color::LightCyan);
    sunken(screen, Area::new(x1, y1, x2, y2), 4);
    for k in Column::A.numbers() {
        let (left, right) = if k < 10 { (8, 529) } else { (1, 522) };
        for x in [left, right] {
            screen.text(x, line(k) + 24, &k.to_string(), Color::Black);
        }
    }
    for (y, function, offset, phase) in [(10, 'x', 'a', 'p'), (45, 'y', 'b', 'q')] {
        screen.text(74, y - 10, "n", Color::Black);
        screen.text(10, y, &format!("{function}(t)={offset} +Σ{offset} sin(kt+{phase} π)"), Color::Black);
        screen.text(58, y + 10, "0 1 k        k", Color::Black);
    }
}

/// The raised panel of a column with its name and empty windows. The many windows look alike, so the first one is
/// copied.
pub(super) fn column(screen: &mut Screen, column: Column) {
    let (x1, x2) = edges(column);
    raised(screen, Area::new(x1, EDGES.0, x2, EDGES.1), 2);
    screen.text(x1 + 20, EDGES.0 + 2, column.name(), Color::Black);
    let mut areas = column.numbers().map(|k| area(Coefficient { column, k }));
    let Some(first) = areas.next() else { return };
    window(screen, first);
    // The window's frame reaches one pixel above its area.
    let copy = screen.take(first.x1, first.y1, first.x2, first.y2 + 1);
    areas.for_each(|area| screen.put(area.x1, area.y1, &copy, Put::Copy));
}

/// The window of a coefficient.
pub(super) fn area(place: Coefficient) -> Area {
    let (x, y) = (edges(place.column).0 + 6, line(place.k) + 20);
    let width = match place.column.quantity() {
        Quantity::Amplitude => 31,
        Quantity::Phase => 39,
    };
    Area::new(x, y, x + width, y + 12)
}

/// The place of the first character in a coefficient's window.
pub(super) fn text_at(place: Coefficient) -> (i32, i32) {
    (edges(place.column).0 + 11, line(place.k) + 23)
}

/// The coefficient whose window contains a pixel.
pub(super) fn coefficient_at(x: i32, y: i32) -> Option<Coefficient> {
    Coefficient::all().find(|&place| area(place).holds(x, y))
}

/// Left and right edge of a column.
fn edges(column: Column) -> (i32, i32) {
    match column {
        Column::A => (19, 60),
        Column::P => (66, 115),
        Column::B => (540, 581),
        Column::Q => (587, 636),
    }
}

/// Upper edge of a line of the columns.
fn line(k: usize) -> i32 {
    // There are 21 lines.
    EDGES.0 + LINE * i32::try_from(k).unwrap_or(0)
}
