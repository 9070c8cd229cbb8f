//! Where the lines of knots lie beside the view of space, and how the mouse moves what is on them.

use crate::editor::field::PICTURE;
use crate::editor::lens::{Held, Lens, is_drag};
use crate::figure::{Axes, Figure};
use crate::geometry::{BoundingBox, ParamCurve, Point};
use crate::machine::{Event, Language, Tick};
use crate::screen::Screen;
use crate::ui::look::Viewer;

use super::super::rail::Rail;

/// The line of knots of u below, that of v at the left.
pub(super) const RAILS: [Rail; 2] = [
    Rail { start: (60, 458), length: 560.0, upright: false },
    Rail { start: (33, 432), length: 366.0, upright: true },
];

/// The third coordinate of what is on a line of knots and not in space.
const ON_RAIL: f64 = f64::INFINITY;

/// The place of what is on the line of a direction, so far along it.
pub(super) fn on_rail(direction: usize, along: f64) -> Point<3> {
    [along, direction as f64, ON_RAIL]
}

/// The view of space, with the lines of knots beside it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beside(pub(crate) Viewer);

impl Lens<3> for Beside {
    fn pixel(&self, place: Point<3>) -> (i32, i32) {
        Lens::pixel(&self.0, place)
    }

    fn dragged<H>(&self, held: &Held<H, 3>, (x, y): (i32, i32)) -> Option<Point<3>> {
        if held.from[2] != ON_RAIL {
            return self.0.dragged(held, (x, y));
        }
        let (x, y) = (x.clamp(PICTURE.x1, PICTURE.x2), y.clamp(PICTURE.y1, PICTURE.y2));
        let (right, up) = (x - held.pressed.0, held.pressed.1 - y);
        let by = if held.from[1] == 0.0 { right } else { up };
        let moved = held.at != held.from || is_drag((0, 0), (right, up));
        moved.then(|| [held.from[0] + f64::from(by), held.from[1], ON_RAIL])
    }

    fn flat(&self, place: Point<3>) -> Point<2> {
        self.0.flat(place)
    }

    fn plot(&self, figure: &mut Figure, curve: &dyn ParamCurve<3>, ink: [u8; 3]) {
        self.0.plot(figure, curve, ink);
    }

    fn axes(&self, bounds: BoundingBox<3>) -> Option<Axes> {
        self.0.axes(bounds)
    }

    fn order(&self, points: &[Point<3>]) -> Vec<usize> {
        self.0.order(points)
    }

    /// Over a line of knots the wheel does not zoom.
    fn look_around(&mut self, tick: &Tick) -> bool {
        let over = RAILS.iter().any(|rail| rail.place((tick.mouse.x, tick.mouse.y)).is_some());
        !(over && matches!(tick.event, Some(Event::Wheel(_)))) && self.0.look_around(tick)
    }

    fn grab(&mut self, at: (i32, i32)) {
        self.0.grab(at);
    }

    fn stop(&mut self) {
        self.0.stop();
    }

    fn draw_ground(&self, screen: &mut Screen) {
        self.0.draw_ground(screen);
    }

    fn draw_legend(&self, screen: &mut Screen, language: Language) {
        self.0.draw_legend(screen, language);
    }
}
