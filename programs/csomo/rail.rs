//! A line of knots: triangles over their values, equal ones one above the other.

use crate::screen::{Color, Screen, Stroke};
use crate::ui::look::pixel;

/// Where a line of knots lies: along it values grow, up from it triangles stand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rail {
    /// The pixel at its beginning.
    pub(super) start: (i32, i32),
    /// Its length in pixels.
    pub(super) length: f64,
    /// Whether values grow upwards and triangles stand to the right, not to the right and up.
    pub(super) upright: bool,
}

/// From values of knots to pixels along a line. The whole list goes in, with a margin for its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    from: f64,
    /// Values in a pixel.
    step: f64,
}

/// Equal knots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stack {
    /// The first of them.
    pub(super) first: usize,
    /// How many.
    pub(super) copies: usize,
    /// Their value.
    pub(super) value: f64,
}

/// Pixels beside the first and the last knot.
const MARGIN: f64 = 8.0;
/// Width of a triangle to either side of its tip, and its height.
const HALF: i32 = 4;
const TALL: i32 = 7;
/// How high the tip of the lowest stands, and the highest triangle's back.
const TIP: i32 = 1;
const DEPTH: i32 = 22;

impl Scale {
    /// The scale for a list of knots on so many pixels.
    fn of(knots: &[f64], pixels: f64) -> Scale {
        let [first, last] = [knots.first(), knots.last()].map(|knot| knot.copied().unwrap_or(0.0));
        let length = if last > first { last - first } else { 1.0 };
        let step = length / (pixels - 2.0 * MARGIN);
        Scale { from: first - MARGIN * step, step }
    }

    /// The distance of a value from the beginning.
    pub(super) fn along(&self, value: f64) -> f64 {
        (value - self.from) / self.step
    }

    /// The value at a distance from the beginning.
    pub(super) fn value(&self, along: f64) -> f64 {
        self.from + self.step * along
    }
}

/// The stacks of a list of knots, in order.
pub(super) fn stacks(knots: &[f64]) -> Vec<Stack> {
    let mut all: Vec<Stack> = Vec::new();
    for (index, &value) in knots.iter().enumerate() {
        match all.last_mut() {
            Some(last) if last.value == value => last.copies += 1,
            _ => all.push(Stack { first: index, copies: 1, value }),
        }
    }
    all
}

impl Stack {
    /// Whether a knot is one of them.
    pub(super) fn holds(&self, knot: usize) -> bool {
        (self.first..self.first + self.copies).contains(&knot)
    }

    /// How far triangles stand above each other.
    fn rise(&self) -> i32 {
        let gaps = i32::try_from(self.copies).unwrap_or(i32::MAX).saturating_sub(1);
        if gaps == 0 { TALL } else { (14 / gaps).clamp(1, TALL) }
    }

    /// The level at a height above the line; the lowest is 0.
    fn level(&self, up: i32) -> Option<usize> {
        let levels = i32::try_from(self.copies).unwrap_or(1);
        let (rise, over) = (self.rise(), up - TIP - TALL);
        let level = if over < 0 { 0 } else { over / rise + i32::from(levels > 1) };
        let above = level >= levels && over > rise * (levels - 1);
        (!above).then(|| usize::try_from(level.min(levels - 1)).unwrap_or(0))
    }
}

impl Rail {
    /// The pixel of a place along the line and up from it.
    pub(super) fn pixel(&self, along: i32, up: i32) -> (i32, i32) {
        let (x, y) = self.start;
        if self.upright { (x + up, y - along) } else { (x + along, y - up) }
    }

    /// The place of a pixel along the line and up from it, if it is near.
    pub(super) fn place(&self, (x, y): (i32, i32)) -> Option<(i32, i32)> {
        let (left, bottom) = self.start;
        let (along, up) = if self.upright { (bottom - y, x - left) } else { (x - left, bottom - y) };
        let near = (-HALF..=self.length as i32 + HALF).contains(&along) && (-1..=DEPTH).contains(&up);
        near.then_some((along, up))
    }

    /// The scale for a list of knots.
    pub(super) fn scale(&self, knots: &[f64]) -> Scale {
        Scale::of(knots, self.length)
    }

    /// The stack at a pixel, and the level of the triangle there; the nearest where they overlap.
    pub(super) fn stack_at(&self, knots: &[f64], at: (i32, i32)) -> Option<(Stack, usize)> {
        let ((along, up), scale) = (self.place(at)?, self.scale(knots));
        let off = |stack: &Stack| (pixel(scale.along(stack.value)) - along).abs();
        let near = stacks(knots).into_iter().filter(|stack| off(stack) <= HALF);
        let under = near.filter_map(|stack| Some((stack, stack.level(up)?)));
        under.min_by_key(|(stack, _)| off(stack))
    }

    /// Draws the line, its domain white, and the triangles in the colours of their knots.
    pub(super) fn draw(
        &self,
        screen: &mut Screen,
        scale: &Scale,
        knots: &[f64],
        domain: Option<[f64; 2]>,
        fill: impl Fn(usize) -> Color,
    ) {
        let mut line = |from: i32, to: i32, ink: Color| {
            let ((x1, y1), (x2, y2)) = (self.pixel(from, 0), self.pixel(to, 0));
            screen.line(x1, y1, x2, y2, Stroke::thin(ink));
        };
        line(0, self.length as i32 - 1, Color::DarkGray);
        if let Some([from, to]) = domain.map(|domain| domain.map(|u| pixel(scale.along(u)))) {
            line(from, to, Color::White);
        }
        for stack in stacks(knots) {
            let along = pixel(scale.along(stack.value));
            // The lowest comes last, over the others.
            for level in (0..stack.copies).rev() {
                let tip = TIP + stack.rise() * i32::try_from(level).unwrap_or(0);
                let corners = [(along - HALF, tip + TALL), (along + HALF, tip + TALL), (along, tip)];
                let corners = corners.map(|(along, up)| self.pixel(along, up));
                screen.polygon(&corners, fill(stack.first + level), Stroke::thin(Color::White));
            }
        }
    }

    /// Draws a line across at a value.
    pub(super) fn mark(&self, screen: &mut Screen, along: f64, stroke: Stroke) {
        let ((x1, y1), (x2, y2)) = (self.pixel(pixel(along), 0), self.pixel(pixel(along), DEPTH - 1));
        screen.line(x1, y1, x2, y2, stroke);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAILS: [Rail; 2] = [
        Rail { start: (41, 455), length: 560.0, upright: false },
        Rail { start: (33, 440), length: 370.0, upright: true },
    ];

    #[test]
    fn values_come_back_from_their_pixels() {
        let knots: Vec<f64> = (0..11).map(f64::from).collect();
        for rail in RAILS {
            let scale = rail.scale(&knots);
            for value in [0.0, 3.3, 10.0] {
                assert!((scale.value(scale.along(value)) - value).abs() < 1e-12);
                let at = rail.pixel(pixel(scale.along(value)), 3);
                assert_eq!(rail.place(at), Some((pixel(scale.along(value)), 3)));
            }
        }
    }

    #[test]
    fn every_triangle_of_a_stack_can_be_taken() {
        for (copies, rail) in (1..=8).flat_map(|copies| RAILS.map(|rail| (copies, rail))) {
            let mut knots: Vec<f64> = (0..30).map(f64::from).collect();
            knots[10..10 + copies].fill(10.0);
            let along = pixel(rail.scale(&knots).along(10.0));
            let found = |up: i32| rail.stack_at(&knots, rail.pixel(along, up));
            let levels: Vec<usize> = (0..=DEPTH).filter_map(|up| found(up).map(|(_, level)| level)).collect();
            assert!((0..copies).all(|level| levels.contains(&level)), "{copies}: {levels:?}");
            let stack = found(2).map(|(stack, _)| (stack.first, stack.copies));
            assert_eq!(stack, Some((10, copies)));
        }
    }
}
