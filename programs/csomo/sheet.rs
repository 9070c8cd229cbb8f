//! What lies where in the picture: the field of control points, the strip of basis functions, the line of knots.

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

/// From values of knots to pixels of strip and line. The whole list of knots goes in, with a margin for its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    from: f64,
    /// Values in a pixel.
    step: f64,
}

/// Pixels beside the first and the last knot.
const MARGIN: f64 = 8.0;

impl Scale {
    pub(super) fn of(curve: &KnotPoints) -> Scale {
        let [first, last] =
            [curve.knots.first(), curve.knots.last()].map(|knot| knot.copied().unwrap_or(0.0));
        let length = if last > first { last - first } else { 1.0 };
        let step = length / (FIELD[0] - 2.0 * MARGIN);
        Scale { from: first - MARGIN * step, step }
    }

    /// The distance of a value from the left edge.
    pub(super) fn across(&self, value: f64) -> f64 {
        (value - self.from) / self.step
    }

    /// The column of a value.
    pub(super) fn column(&self, value: f64) -> i32 {
        ORIGIN.0 + pixel(self.across(value))
    }

    /// The value at a distance from the left edge.
    pub(super) fn value(&self, across: f64) -> f64 {
        self.from + self.step * across
    }

    /// The value at a column.
    pub(super) fn at(&self, column: i32) -> f64 {
        self.value(f64::from(column - ORIGIN.0))
    }
}

/// Equal knots, drawn one above the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stack {
    /// The first of them.
    pub(super) first: usize,
    /// How many.
    pub(super) copies: usize,
    /// Their value.
    pub(super) value: f64,
}

/// All stacks of a document, in order.
pub(super) fn stacks(curve: &KnotPoints) -> Vec<Stack> {
    let mut all: Vec<Stack> = Vec::new();
    for (index, &value) in curve.knots.iter().enumerate() {
        match all.last_mut() {
            Some(last) if last.value == value => last.copies += 1,
            _ => all.push(Stack { first: index, copies: 1, value }),
        }
    }
    all
}

/// Width of a triangle to either side of its tip, and its height.
const HALF: i32 = 4;
const TALL: i32 = 7;
/// The row of the lowest tip.
const TIP: i32 = LINE.y2 - 1;

impl Stack {
    /// How far triangles stand above each other.
    fn rise(&self) -> i32 {
        let gaps = i32::try_from(self.copies).unwrap_or(i32::MAX).saturating_sub(1);
        if gaps == 0 { TALL } else { (14 / gaps).clamp(1, TALL) }
    }

    /// The corners of a triangle, the lowest is 0.
    pub(super) fn triangle(&self, level: usize, scale: &Scale) -> [(i32, i32); 3] {
        let x = scale.column(self.value);
        let tip = TIP - self.rise() * i32::try_from(level).unwrap_or(0);
        [(x - HALF, tip - TALL), (x + HALF, tip - TALL), (x, tip)]
    }

    /// The level at a pixel.
    fn level(&self, (x, y): (i32, i32), scale: &Scale) -> Option<usize> {
        let levels = i32::try_from(self.copies).unwrap_or(1);
        let (rise, near) = (self.rise(), (x - scale.column(self.value)).abs() <= HALF);
        let level = if y > TIP - TALL { 0 } else { (TIP - TALL - y).max(0) / rise + i32::from(levels > 1) };
        let above = level >= levels && y < TIP - TALL - rise * (levels - 1);
        (near && !above && y <= LINE.y2).then(|| usize::try_from(level.min(levels - 1)).unwrap_or(0))
    }
}

/// The stack at a pixel of the line, and the level of the triangle there; the nearest where they overlap.
pub(super) fn stack_at(curve: &KnotPoints, at: (i32, i32)) -> Option<(Stack, usize)> {
    if !on(Area { y1: LINE.y1 - 1, x1: LINE.x1 - HALF, x2: LINE.x2 + HALF, ..LINE }, at) {
        return None;
    }
    let scale = Scale::of(curve);
    let under = stacks(curve).into_iter().filter_map(|stack| Some((stack, stack.level(at, &scale)?)));
    under.min_by_key(|(stack, _)| (scale.column(stack.value) - at.0).abs())
}

/// The control points of a document.
pub(super) fn points(curve: &KnotPoints) -> &[Point<2>] {
    edit::places(curve)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_come_back_from_their_pixels() {
        let curve = KnotPoints::of_points(vec![[0.0, 0.0]; 7]);
        let scale = Scale::of(&curve);
        for value in [0.0, 3.3, 10.0] {
            assert!((scale.value(scale.across(value)) - value).abs() < 1e-12);
            assert!(on(LINE, (scale.column(value), LINE.y1)));
        }
    }

    #[test]
    fn every_triangle_of_a_stack_can_be_taken() {
        for copies in 1..=8 {
            let mut curve = KnotPoints::of_points(vec![[0.0, 0.0]; 30]);
            curve.knots[10..10 + copies].fill(10.0);
            let x = Scale::of(&curve).column(10.0);
            let levels: Vec<usize> = (LINE.y1 - 1..=LINE.y2)
                .filter_map(|y| stack_at(&curve, (x, y)))
                .map(|(_, level)| level)
                .collect();
            for level in 0..copies {
                assert!(levels.contains(&level), "{copies}: {levels:?}");
            }
            let stack = stack_at(&curve, (x, LINE.y2)).map(|(stack, _)| stack);
            assert_eq!(stack.map(|stack| (stack.first, stack.copies)), Some((10, copies)));
        }
    }
}
