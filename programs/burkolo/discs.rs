//! Circles under the mouse, and how they are drawn.

use super::craft::{Bench, Handle, STORE};
use super::value::{self, Row};
use crate::editor::field::on_disc;
use crate::editor::lens::{Field, Lens};
use crate::editor::seen::Own;
use crate::figure::{CURVE_INK, Figure, print_ink};
use crate::geometry::skin::{Circle, Outline};
use crate::geometry::{BoundingBox, ParamCurve, Point};
use crate::screen::{Color, Screen, Stroke};
use crate::ui::look::pixel;

/// How far from a rim the mouse takes it up, in pixels.
const RIM: f64 = 3.0;
/// Circles up to this radius have no rim inside.
const SMALL: f64 = 12.0;
/// The least radius of a middle for the mouse.
const MIDDLE: f64 = 6.0;
/// Steps of a piece of an outline on the screen.
const STEPS: usize = 24;

/// What is at a pixel: the store, the topmost rim, or the middle of the circle around it that is nearest.
pub(super) fn at(editor: &Bench, at: (i32, i32)) -> Option<Handle> {
    let circles = editor.history.now();
    if on_disc(editor.pixel(STORE), at) && !value::is_full(circles) {
        return Some(Handle::Stored);
    }
    let [x, y] = Field.place(at);
    let far = |&[a, b, _]: &Row| (x - a).hypot(y - b);
    let on_rim = |(_, row): &(usize, &Row)| {
        let off = far(row) - row[2];
        off <= RIM && off >= if row[2] > SMALL { -RIM } else { -1.0 } && far(row) > MIDDLE / 2.0
    };
    let rim = circles.circles.iter().enumerate().rfind(on_rim).map(|(index, _)| Handle::Rim(index));
    rim.or_else(|| {
        let inside = circles.circles.iter().enumerate().filter(|(_, row)| far(row) <= row[2].max(MIDDLE));
        let nearest = inside.min_by(|(_, a), (_, b)| far(a).total_cmp(&far(b)));
        nearest.map(|(index, _)| Handle::Middle(index))
    })
}

/// The circle at a pixel.
pub(super) fn number_at(editor: &Bench, pixel: (i32, i32)) -> Option<usize> {
    match at(editor, pixel)? {
        Handle::Middle(index) | Handle::Rim(index) => Some(index),
        Handle::Stored | Handle::New => None,
    }
}

/// A disc without its rim; a figure has the rim alone.
pub(super) struct Disc {
    pub(super) row: Row,
    pub(super) fill: Color,
}

/// The rim of a disc, with its number from 1 and the number of the rule that it breaks.
pub(super) struct Rim {
    pub(super) row: Row,
    pub(super) number: usize,
    pub(super) rule: Option<u8>,
    /// Whether there is room for the number.
    pub(super) named: bool,
}

fn on_screen([x, y, r]: Row) -> ((i32, i32), i32) {
    (Field.pixel([x, y]), pixel(r))
}

fn bounds([x, y, r]: Row) -> Option<BoundingBox<2>> {
    BoundingBox::around([[x - r, y - r], [x + r, y + r]])
}

impl Own<2> for Disc {
    fn paint(&self, screen: &mut Screen) {
        let ((x, y), r) = on_screen(self.row);
        screen.disc(x, y, r, self.fill, self.fill);
    }

    fn plot(&self, _: &mut Figure) -> bool {
        true
    }

    fn bounds(&self) -> Option<BoundingBox<2>> {
        None
    }
}

impl Own<2> for Rim {
    fn paint(&self, screen: &mut Screen) {
        let ((x, y), r) = on_screen(self.row);
        let ink = if self.rule.is_some() { Color::LightRed } else { Color::LightGray };
        screen.circle(x, y, r, Stroke::thin(ink));
        if !self.named && self.rule.is_none() {
            return;
        }
        let text = self.number.to_string();
        let half = 4 * i32::try_from(text.len()).unwrap_or(0);
        screen.text(x - half + 1, y - 3, &text, Color::White);
        if let Some(rule) = self.rule {
            screen.text(x - 11, y + 7, &format!("({rule})"), Color::Yellow);
        }
    }

    fn plot(&self, figure: &mut Figure) -> bool {
        let [x, y, r] = self.row;
        // A rim that arcs cannot approximate is left out.
        let _ = figure.plot_disc(&Circle::new([x, y], r), self.number);
        true
    }

    fn bounds(&self) -> Option<BoundingBox<2>> {
        bounds(self.row)
    }
}

/// An outline of the skin.
pub(super) struct Line {
    pub(super) outline: Outline,
    pub(super) ink: Color,
}

/// What an outline encloses.
pub(super) struct Filling {
    pub(super) outline: Outline,
    pub(super) fill: Color,
}

fn pixels(outline: &Outline) -> Vec<(i32, i32)> {
    let line = outline.polyline(STEPS).unwrap_or_default();
    let mut pixels: Vec<(i32, i32)> = line.into_iter().map(|point| Field.pixel(point)).collect();
    pixels.dedup();
    pixels
}

impl Own<2> for Line {
    fn paint(&self, screen: &mut Screen) {
        screen.polyline(&pixels(&self.outline), Stroke::thick(self.ink));
    }

    fn plot(&self, figure: &mut Figure) -> bool {
        let ink = if self.ink == Color::White { CURVE_INK } else { print_ink(self.ink) };
        let _ = figure.plot_outline(&self.outline, ink, false);
        true
    }

    fn bounds(&self) -> Option<BoundingBox<2>> {
        self.outline.bounding_box()
    }
}

impl Own<2> for Filling {
    fn paint(&self, screen: &mut Screen) {
        screen.polygon(&pixels(&self.outline), self.fill, Stroke::thin(self.fill));
    }

    fn plot(&self, figure: &mut Figure) -> bool {
        let _ = figure.plot_outline(&self.outline, CURVE_INK, true);
        true
    }

    fn bounds(&self) -> Option<BoundingBox<2>> {
        None
    }
}

/// A touching point.
pub(super) struct Dot(pub(super) Point<2>, pub(super) Color);

impl Own<2> for Dot {
    fn paint(&self, screen: &mut Screen) {
        let (x, y) = Field.pixel(self.0);
        screen.disc(x, y, 2, self.1, self.1);
    }

    fn plot(&self, figure: &mut Figure) -> bool {
        figure.plot_joint(self.0);
        true
    }

    fn bounds(&self) -> Option<BoundingBox<2>> {
        None
    }
}
