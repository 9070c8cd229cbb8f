//! Maps between places and pixels: the flat field, or a view of space that the user turns.

use super::field;
use crate::figure::{Axes, Figure};
use crate::file::FIELD;
use crate::geometry::{BoundingBox, ParamCurve, Point};
use crate::machine::{Button, Language, Tick};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::axes::{draw_axes, draw_legend};
use crate::ui::look::{Look, Viewer, pixel};
use crate::ui::{Area, words};

/// A handle held by the mouse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Held<H, const D: usize> {
    pub(crate) handle: H,
    /// The pixel where it was pressed.
    pub(crate) pressed: (i32, i32),
    /// Its place before.
    pub(crate) from: Point<D>,
    /// Its place now.
    pub(crate) at: Point<D>,
}

/// Shows places as pixels, and moves them with the mouse.
pub(crate) trait Lens<const D: usize> {
    /// The pixel of a place.
    fn pixel(&self, place: Point<D>) -> (i32, i32);
    /// The place of a held handle when the mouse is at a pixel; `None` for a mere click.
    fn dragged<H>(&self, held: &Held<H, D>, mouse: (i32, i32)) -> Option<Point<D>>;
    /// The same along an axis of space; `None` where there is none, or where it points at the viewer.
    fn dragged_along<H>(&self, _: &Held<H, D>, _mouse: (i32, i32), _axis: usize) -> Option<Point<D>> {
        None
    }
    /// A place moved by pixels to the right and up, or by as many units along an axis of space.
    fn nudged(&self, place: Point<D>, _by: (i32, i32), _axis: Option<usize>) -> Point<D> {
        place
    }
    /// The point of a place in a figure.
    fn flat(&self, place: Point<D>) -> Point<2>;
    /// Adds a curve to a figure. A curve that arcs cannot approximate is left out, as on the screen.
    fn plot(&self, figure: &mut Figure, curve: &dyn ParamCurve<D>, ink: [u8; 3]);
    /// The axes of a figure with these bounds.
    fn axes(&self, bounds: BoundingBox<D>) -> Option<Axes>;
    /// Indices of points in drawing order, farthest first.
    fn order(&self, points: &[Point<D>]) -> Vec<usize>;
    /// Turns and zooms; returns whether the event was for that.
    fn look_around(&mut self, _: &Tick) -> bool {
        false
    }
    /// Takes up the ground with the left button, to turn it.
    fn grab(&mut self, _: (i32, i32)) {}
    /// Ends a turn by the mouse that has been interrupted.
    fn stop(&mut self) {}
    /// Draws what lies under the picture: grid or axes.
    fn draw_ground(&self, screen: &mut Screen);
    /// Draws what stands on the frame.
    fn draw_rim(&self, _: &mut Screen) {}
    /// Draws the keys that leave a result and turn it.
    fn draw_legend(&self, screen: &mut Screen, language: Language);
}

/// The field of plane curves: x from 0 to 560 to the right, y from 0 to 380 up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Field;

/// The pixel of the field's origin.
const ORIGIN: (i32, i32) = (41, 450);
/// The area in which the mouse can drag a point.
const REACH: Area = Area::new(41, 10, 620, 450);

impl Field {
    /// The place of a pixel.
    pub(crate) fn place(self, (x, y): (i32, i32)) -> Point<2> {
        [f64::from(x - ORIGIN.0), f64::from(ORIGIN.1 - y)]
    }
}

impl Lens<2> for Field {
    fn pixel(&self, [x, y]: Point<2>) -> (i32, i32) {
        (ORIGIN.0 + pixel(x), ORIGIN.1 - pixel(y))
    }

    fn dragged<H>(&self, held: &Held<H, 2>, (x, y): (i32, i32)) -> Option<Point<2>> {
        let at = self.pixel(held.at);
        is_drag(at, (x, y)).then(|| self.place(into((x, y), REACH)))
    }

    fn nudged(&self, [x, y]: Point<2>, (right, up): (i32, i32), _: Option<usize>) -> Point<2> {
        // What is in the field stays in it; the tip of a tangent may be outside.
        let within =
            |value: f64, by: i32, most: f64| (value + f64::from(by)).clamp(value.min(0.0), value.max(most));
        [within(x, right, FIELD[0]), within(y, up, FIELD[1])]
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
        draw_grid(screen, ORIGIN, 380);
    }

    /// The scales.
    fn draw_rim(&self, screen: &mut Screen) {
        let tick = Stroke::thin(Color::Black);
        for hundred in 0..6 {
            let x = ORIGIN.0 + 100 * hundred;
            screen.line(x, 462, x, 470, tick);
            let label_x = if hundred == 0 { 27 } else { x - 25 };
            screen.text(label_x, 472, &(100 * hundred).to_string(), Color::Black);
        }
        draw_heights(screen, ORIGIN.1, 380);
    }

    fn draw_legend(&self, screen: &mut Screen, language: Language) {
        screen.text(5, 5, words::BACK.of(language), Color::LightGray);
    }
}

impl Lens<3> for Viewer {
    fn pixel(&self, place: Point<3>) -> (i32, i32) {
        self.look.to_screen(place)
    }

    /// Moves parallel to the plane of the picture.
    fn dragged<H>(&self, held: &Held<H, 3>, (x, y): (i32, i32)) -> Option<Point<3>> {
        let area = field::PICTURE;
        let (x, y) = (x.clamp(area.x1, area.x2), y.clamp(area.y1, area.y2));
        let by = (x - held.pressed.0, y - held.pressed.1);
        is_drag((0, 0), by).then(|| self.look.dragged(held.from, by))
    }

    /// As far along the axis as its picture goes with the mouse.
    fn dragged_along<H>(&self, held: &Held<H, 3>, (x, y): (i32, i32), axis: usize) -> Option<Point<3>> {
        let area = field::PICTURE;
        let (x, y) = (x.clamp(area.x1, area.x2), y.clamp(area.y1, area.y2));
        let by =
            [x - held.pressed.0, held.pressed.1 - y].map(|pixels| self.look.length_now(f64::from(pixels)));
        let unit: Point<3> = std::array::from_fn(|d| if d == axis { 1.0 } else { 0.0 });
        let [right, up] = self.look.view.place(unit);
        let square = right * right + up * up;
        // An axis that points at the viewer has no length in the picture.
        if square < 0.01 {
            return None;
        }
        let along = (by[0] * right + by[1] * up) / square;
        Some(std::array::from_fn(|d| if d == axis { (held.from[d] + along).round() } else { held.from[d] }))
    }

    fn nudged(&self, place: Point<3>, (right, up): (i32, i32), axis: Option<usize>) -> Point<3> {
        match axis {
            Some(axis) => {
                std::array::from_fn(|d| place[d] + if d == axis { f64::from(right + up) } else { 0.0 })
            }
            None => self.look.dragged(place, (right, -up)),
        }
    }

    fn flat(&self, place: Point<3>) -> Point<2> {
        self.look.seen().place(place)
    }

    fn plot(&self, figure: &mut Figure, curve: &dyn ParamCurve<3>, ink: [u8; 3]) {
        let _ = figure.plot_space_curve(curve, &self.look.seen(), ink);
    }

    fn axes(&self, bounds: BoundingBox<3>) -> Option<Axes> {
        Some(Axes::Space { view: self.look.seen(), bounds })
    }

    fn order(&self, points: &[Point<3>]) -> Vec<usize> {
        self.look.seen().far_to_near(points)
    }

    fn look_around(&mut self, tick: &Tick) -> bool {
        Viewer::look_around(self, tick)
    }

    fn grab(&mut self, at: (i32, i32)) {
        self.turn(at, Button::Left);
    }

    fn stop(&mut self) {
        Viewer::stop(self);
    }

    fn draw_ground(&self, screen: &mut Screen) {
        draw_axes(screen, self.look);
    }

    fn draw_legend(&self, screen: &mut Screen, language: Language) {
        draw_legend(screen, words::LEAVE, language);
    }
}

/// The grid of ten pixels of a field 560 pixels wide, from the pixel of its origin.
pub(crate) fn draw_grid(screen: &mut Screen, (left, bottom): (i32, i32), height: i32) {
    let stroke = Stroke::thin(Color::LightGray);
    for column in 0..57 {
        let x = left + 10 * column;
        screen.line(x, bottom, x, bottom - height, stroke);
    }
    for row in 0..=height / 10 {
        let y = bottom - 10 * row;
        screen.line(left, y, left + 560, y, stroke);
    }
}

/// The scale at the left of a field, in hundreds of pixels from its origin up.
pub(crate) fn draw_heights(screen: &mut Screen, bottom: i32, height: i32) {
    for hundred in 0..=height / 100 {
        let y = bottom - 100 * hundred;
        screen.line(11, y, 29, y, Stroke::thin(Color::Black));
        let label_x = if hundred == 0 { 11 } else { 1 };
        screen.text(label_x, y - 10, &(100 * hundred).to_string(), Color::Black);
    }
}

/// The pixel of an area that is nearest to another pixel.
pub(crate) fn into((x, y): (i32, i32), area: Area) -> (i32, i32) {
    (x.clamp(area.x1, area.x2), y.clamp(area.y1, area.y2))
}

/// Whether a movement from one pixel to another is a drag, not a mere click.
pub(crate) fn is_drag(from: (i32, i32), to: (i32, i32)) -> bool {
    field::apart(from, to) > 2
}

impl Look {
    /// The angles and the zoom as `dump` writes them: azimuth and elevation in degrees.
    pub(crate) fn angles(self) -> [f64; 3] {
        [self.view.azimuth().to_degrees(), self.view.elevation().to_degrees(), self.scale()]
    }
}
