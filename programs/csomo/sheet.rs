//! What lies where in the picture: the field of control points, the strip of basis functions, the line of knots.

use super::rail::{Rail, Scale};
use crate::design::knots::edit;
use crate::editor::lens::{Held, Lens, draw_grid, draw_heights, into, is_drag};
use crate::figure::{Axes, Figure};
use crate::file::KnotPoints;
use crate::geometry::{BoundingBox, ParamCurve, Point};
use crate::machine::Language;
use crate::screen::Screen;
use crate::ui::look::pixel;
use crate::ui::{Area, words};

/// Width and height of the field.
pub(super) const FIELD: [f64; 2] = [560.0, 260.0];
/// The pixel of its origin.
pub(super) const ORIGIN: (i32, i32) = (41, 330);
/// The strip of 560 x 90 pixels.
pub(super) const STRIP: Area = Area::new(41, 340, 600, 429);
/// The line of knots, 560 x 22 pixels.
pub(super) const LINE: Area = Area::new(41, 434, 600, 455);
/// The area in which the mouse can drag.
const REACH: Area = Area::new(30, 10, 631, 460);
/// Where new points are taken from, as in the other editors of the plane.
pub(super) const STORE: Point<2> = [577.0, 240.0];

/// Whether a place lies in the field.
pub(super) fn in_field([x, y]: Point<2>) -> bool {
    (0.0..=FIELD[0]).contains(&x) && (0.0..=FIELD[1]).contains(&y)
}

/// Whether a pixel belongs to an area, its edge included.
pub(super) fn on(area: Area, (x, y): (i32, i32)) -> bool {
    (area.x1..=area.x2).contains(&x) && (area.y1..=area.y2).contains(&y)
}

/// Places of the field as pixels: x to the right, y up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet;

impl Sheet {
    /// The place of a pixel.
    pub(super) fn place((x, y): (i32, i32)) -> Point<2> {
        [f64::from(x - ORIGIN.0), f64::from(ORIGIN.1 - y)]
    }
}

impl Lens<2> for Sheet {
    fn pixel(&self, [x, y]: Point<2>) -> (i32, i32) {
        (ORIGIN.0 + pixel(x), ORIGIN.1 - pixel(y))
    }

    fn dragged<H>(&self, held: &Held<H, 2>, mouse: (i32, i32)) -> Option<Point<2>> {
        is_drag(self.pixel(held.at), mouse).then(|| Sheet::place(into(mouse, REACH)))
    }

    fn flat(&self, place: Point<2>) -> Point<2> {
        place
    }

    fn plot(&self, figure: &mut Figure, curve: &dyn ParamCurve<2>, ink: [u8; 3]) {
        let _ = figure.plot_curve(curve, ink);
    }

    fn axes(&self, _: BoundingBox<2>) -> Option<Axes> {
        None
    }

    fn order(&self, points: &[Point<2>]) -> Vec<usize> {
        (0..points.len()).collect()
    }

    fn draw_ground(&self, screen: &mut Screen) {
        draw_grid(screen, ORIGIN, 260);
    }

    fn draw_rim(&self, screen: &mut Screen) {
        draw_heights(screen, ORIGIN.1, 260);
    }

    fn draw_legend(&self, screen: &mut Screen, language: Language) {
        screen.text(5, 5, words::BACK.of(language), crate::screen::Color::LightGray);
    }
}

/// The line of knots; the strip has the same columns.
pub(super) const RAIL: Rail = Rail { start: (LINE.x1, LINE.y2), length: FIELD[0], upright: false };

/// The scale of a document's knots.
pub(super) fn scale(curve: &KnotPoints) -> Scale {
    RAIL.scale(&curve.knots)
}

/// The column of a value.
pub(super) fn column(scale: &Scale, value: f64) -> i32 {
    ORIGIN.0 + pixel(scale.along(value))
}

/// The control points of a document.
pub(super) fn points(curve: &KnotPoints) -> &[Point<2>] {
    edit::places(curve)
}
