//! Straight lines: one or three pixels wide, solid or dotted.
//!
//! A line is stepped along its longer direction from its first end, and the other coordinate is
//! rounded to the nearest pixel, halves away from the first end. The step at which the line enters
//! the screen is computed, so that a clipped line has exactly the pixels of the whole one, and a line
//! across the whole range of integers costs no more than one across the screen.

use super::{Color, HEIGHT, Screen, WIDTH};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// How wide a line is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Width {
    /// One pixel.
    #[default]
    Thin,
    /// Three pixels, measured across the line's longer direction.
    Thick,
}

/// Which pixels along a line are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Pattern {
    /// All.
    #[default]
    Solid,
    /// Two drawn, two left out, and so on: counted from the first end of an oblique line, from the
    /// edge of the screen on horizontal and vertical ones.
    Dotted,
}

/// What a line is drawn with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Stroke {
    /// Colour of the drawn pixels; the gaps of a dotted line are left as they are.
    pub color: Color,
    /// One pixel or three.
    pub width: Width,
    /// Solid or dotted.
    pub pattern: Pattern,
}

impl Stroke {
    /// A solid stroke, one pixel wide.
    #[must_use]
    pub const fn thin(color: Color) -> Stroke {
        Stroke { color, width: Width::Thin, pattern: Pattern::Solid }
    }

    /// A solid stroke, three pixels wide.
    #[must_use]
    pub const fn thick(color: Color) -> Stroke {
        Stroke { color, width: Width::Thick, pattern: Pattern::Solid }
    }

    /// The same stroke, dotted.
    #[must_use]
    pub const fn dotted(self) -> Stroke {
        Stroke { pattern: Pattern::Dotted, ..self }
    }
}

/// A line as steps along its longer (major) direction.
struct Walk {
    /// First end, as (major, minor).
    start: (i64, i64),
    /// Lengths of the line in the two directions, not negative, `major >= minor`.
    major: i64,
    minor: i64,
    /// +1 or -1 for the two directions.
    sign: (i64, i64),
}

impl Walk {
    fn new(start: (i64, i64), end: (i64, i64)) -> Walk {
        let (major, minor) = (end.0 - start.0, end.1 - start.1);
        let sign = |length: i64| if length < 0 { -1 } else { 1 };
        Walk { start, major: major.abs(), minor: minor.abs(), sign: (sign(major), sign(minor)) }
    }

    /// How far the line has moved in the minor direction after `step` steps, and the remainder that
    /// the next steps go on from: `2 * minor * step + major` divided by `2 * major`.
    fn shift(&self, step: i64) -> (i64, i64) {
        let whole = 2 * i128::from(self.major.max(1));
        let value = 2 * i128::from(self.minor) * i128::from(step) + i128::from(self.major);
        // Quotients are at most `minor`, remainders less than `whole`: both fit.
        ((value / whole) as i64, (value % whole) as i64)
    }

    /// Whether all pixels lie on the screen, those at most `margin` away in the minor direction too.
    fn is_inside(&self, sizes: (i64, i64), margin: i64) -> bool {
        let majors = moves(self.start.0, self.sign.0, 0, sizes.0 - 1);
        let minors = moves(self.start.1, self.sign.1, margin, sizes.1 - 1 - margin);
        [(majors, self.major), (minors, self.minor)]
            .iter()
            .all(|(moves, length)| moves.contains(&0) && moves.contains(length))
    }

    /// The steps whose pixels may lie on the screen: the major coordinate in `0..sizes.0` and the
    /// minor one at most `margin` outside of `0..sizes.1`.
    fn visible(&self, sizes: (i64, i64), margin: i64) -> Range<i64> {
        let majors = moves(self.start.0, self.sign.0, 0, sizes.0 - 1);
        let minors = moves(self.start.1, self.sign.1, -margin, sizes.1 - 1 + margin);
        let (mut first, mut last) = (majors.start.max(0), majors.end.min(self.major + 1));
        if self.minor > 0 {
            first = first.max(self.step_of_shift(minors.start));
            last = last.min(self.step_of_shift(minors.end));
        } else if !minors.contains(&0) {
            last = first;
        }
        first..last
    }

    /// The first step at which the line has moved by `shift` in the minor direction; only for lines
    /// with `minor > 0`. Solved from `(2 * minor * step + major) / (2 * major) >= shift`.
    fn step_of_shift(&self, shift: i64) -> i64 {
        let value = (2 * i128::from(shift) - 1) * i128::from(self.major);
        let step = value.div_euclid(2 * i128::from(self.minor))
            + i128::from(value.rem_euclid(2 * i128::from(self.minor)) != 0);
        step.clamp(0, i128::from(self.major) + 1) as i64
    }

    /// Calls `plot` for every visible step with the number that dots are counted by, the minor
    /// coordinate, and the place of the pixel in memory.
    #[inline]
    fn visit(&self, steps: Range<i64>, pitch: (i64, i64), mut plot: impl FnMut(i64, i64, i64)) {
        if steps.is_empty() {
            return;
        }
        let (shift, mut rest) = if steps.start == 0 { (0, self.major) } else { self.shift(steps.start) };
        let mut minor = self.start.1 + self.sign.1 * shift;
        let mut at = (self.start.0 + self.sign.0 * steps.start) * pitch.0 + minor * pitch.1;
        // Dots are counted by a coordinate of the screen on upright and level lines.
        let (first, turn) = if self.minor == 0 { (self.start.0, self.sign.0) } else { (0, 1) };
        let (ahead, aside) = (self.sign.0 * pitch.0, self.sign.1 * pitch.1);
        for step in steps {
            plot(first + turn * step, minor, at);
            at += ahead;
            rest += 2 * self.minor;
            if rest >= 2 * self.major {
                rest -= 2 * self.major;
                minor += self.sign.1;
                at += aside;
            }
        }
    }
}

/// The numbers of unit moves in direction `sign` that take `start` into `low..=high`.
fn moves(start: i64, sign: i64, low: i64, high: i64) -> Range<i64> {
    if sign > 0 { low - start..high - start + 1 } else { start - high..start - low + 1 }
}

impl Screen {
    /// Draws a line; both ends belong to it.
    pub fn line(&mut self, x1: i32, y1: i32, x2: i32, y2: i32, stroke: Stroke) {
        let (x1, y1) = (i64::from(x1), i64::from(y1));
        let (x2, y2) = (i64::from(x2), i64::from(y2));
        let screen = (i64::from(WIDTH), i64::from(HEIGHT));
        if (x2 - x1).abs() >= (y2 - y1).abs() {
            let walk = Walk::new((x1, y1), (x2, y2));
            self.walk(&walk, screen, (1, screen.0), stroke);
        } else {
            let walk = Walk::new((y1, x1), (y2, x2));
            self.walk(&walk, (screen.1, screen.0), (screen.0, 1), stroke);
        }
    }

    /// Draws the visible steps of a line. `sizes` are the screen's and `pitch` the distances of
    /// neighbouring pixels in memory, both as (major, minor).
    fn walk(&mut self, walk: &Walk, sizes: (i64, i64), pitch: (i64, i64), stroke: Stroke) {
        match stroke.width {
            Width::Thin => self.walk_wide::<0>(walk, sizes, pitch, stroke),
            Width::Thick if stroke.pattern == Pattern::Solid && walk.is_inside(sizes, 1) => {
                self.walk_thick(walk, pitch, stroke.color.index());
            }
            Width::Thick => self.walk_wide::<1>(walk, sizes, pitch, stroke),
        }
    }

    /// Draws a solid line with three pixels across, all on the screen, as nearly always: they are taken in one piece.
    fn walk_thick(&mut self, walk: &Walk, pitch: (i64, i64), color: u8) {
        const ROW: usize = WIDTH as usize;
        let pixels = &mut *self.pixels;
        let steps = 0..walk.major + 1;
        let first = |at: i64| usize::try_from(at - pitch.1).ok();
        if pitch.1 == 1 {
            walk.visit(steps, pitch, |_, _, at| {
                if let Some(row) = first(at).and_then(|first| pixels.get_mut(first..)?.get_mut(..=2)) {
                    row.fill(color);
                }
            });
        } else {
            walk.visit(steps, pitch, |_, _, at| {
                if let Some(rows) = first(at).and_then(|first| pixels.get_mut(first..)?.get_mut(..=2 * ROW)) {
                    rows.iter_mut().step_by(ROW).for_each(|pixel| *pixel = color);
                }
            });
        }
    }

    /// Draws a line with `HALF` pixels, 0 or 1, on both sides of its middle.
    fn walk_wide<const HALF: i64>(
        &mut self,
        walk: &Walk,
        sizes: (i64, i64),
        pitch: (i64, i64),
        stroke: Stroke,
    ) {
        let color = stroke.color.index();
        let solid = stroke.pattern == Pattern::Solid;
        // Most lines are short and lie on the screen: nothing has to be divided for them.
        let steps = if walk.is_inside(sizes, HALF) { 0..walk.major + 1 } else { walk.visible(sizes, HALF) };
        walk.visit(steps, pitch, |count, minor, at| {
            if solid || count & 2 == 0 {
                for side in [-1, 0, 1] {
                    if i64::abs(side) <= HALF && (0..sizes.1).contains(&(minor + side)) {
                        self.paint(at + side * pitch.1, color);
                    }
                }
            }
        });
    }

    /// Sets the pixel at a place in memory.
    #[inline]
    fn paint(&mut self, at: i64, color: u8) {
        if let Some(pixel) = usize::try_from(at).ok().and_then(|at| self.pixels.get_mut(at)) {
            *pixel = color;
        }
    }

    /// Draws the lines from each point to the next.
    pub fn polyline(&mut self, points: &[(i32, i32)], stroke: Stroke) {
        for pair in points.windows(2) {
            if let [(x1, y1), (x2, y2)] = *pair {
                self.line(x1, y1, x2, y2, stroke);
            }
        }
    }

    /// Draws the four sides of a rectangle, given by two opposite corners in any order.
    pub fn rectangle(&mut self, x1: i32, y1: i32, x2: i32, y2: i32, stroke: Stroke) {
        self.polyline(&[(x1, y1), (x2, y1), (x2, y2), (x1, y2), (x1, y1)], stroke);
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::assert_art;
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn thin_lines() {
        let mut screen = Screen::new();
        screen.line(0, 0, 7, 3, Stroke::thin(Color::White));
        screen.line(9, 4, 9, 0, Stroke::thin(Color::Green));
        screen.line(0, 4, 3, 4, Stroke::thin(Color::Red));
        assert_art(
            &screen,
            "FF.......2
             ..FF.....2
             ....FF...2
             ......FF.2
             4444.....2",
        );
    }

    #[test]
    fn thick_lines_are_three_pixels_across() {
        let mut screen = Screen::new();
        screen.line(1, 1, 4, 1, Stroke::thick(Color::White));
        screen.line(7, 1, 7, 4, Stroke::thick(Color::Green));
        screen.line(1, 5, 4, 6, Stroke::thick(Color::Red));
        assert_art(
            &screen,
            ".FFFF.....
             .FFFF.222.
             .FFFF.222.
             ......222.
             .44...222.
             .4444.....
             .4444.....
             ...44.....",
        );
    }

    #[test]
    fn dots_come_in_pairs() {
        let mut screen = Screen::new();
        screen.line(10, 0, 1, 0, Stroke::thin(Color::White).dotted());
        screen.line(1, 1, 9, 5, Stroke::thin(Color::Red).dotted());
        assert_art(
            &screen,
            ".F..FF..FF.
             .4.........
             ..4........
             .....4.....
             ......4....
             .........4.",
        );
    }

    #[test]
    fn rectangle_is_its_four_sides() {
        let mut screen = Screen::new();
        screen.rectangle(5, 3, 1, 1, Stroke::thin(Color::White));
        assert_art(&screen, ".......\n.FFFFF.\n.F...F.\n.FFFFF.\n.......");
    }

    /// Bresenham's algorithm pixel by pixel over the whole line.
    fn slow_line(screen: &mut Screen, from: (i32, i32), to: (i32, i32), stroke: Stroke) {
        let (dx, dy) = ((to.0 - from.0).abs(), (to.1 - from.1).abs());
        let (sx, sy) = ((to.0 - from.0).signum(), (to.1 - from.1).signum());
        let level = dx >= dy;
        let (long, short) = if level { (dx, dy) } else { (dy, dx) };
        let (mut x, mut y, mut error) = (from.0, from.1, 2 * short - long);
        for step in 0..=long {
            let count = match (dx, dy) {
                (_, 0) => x,
                (0, _) => y,
                _ => step,
            };
            if stroke.pattern == Pattern::Solid || count.rem_euclid(4) < 2 {
                let half = i32::from(stroke.width == Width::Thick);
                for side in -half..=half {
                    let (px, py) = if level { (x, y + side) } else { (x + side, y) };
                    screen.set(px, py, stroke.color);
                }
            }
            if error >= 0 && short > 0 {
                (x, y, error) = (x + sx, y + sy, error + 2 * (short - long));
            } else {
                (x, y) = if level { (x + sx, y) } else { (x, y + sy) };
                error += 2 * short;
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(256))]
        #[test]
        fn clipped_lines_have_the_pixels_of_whole_ones(
            from in (-900..1500, -800..1300), to in (-900..1500, -800..1300),
            close: bool, thick: bool, dotted: bool,
        ) {
            let to = if close { (from.0 + to.0 % 9, from.1 + to.1 % 9) } else { to };
            let stroke = if thick { Stroke::thick(Color::White) } else { Stroke::thin(Color::White) };
            let stroke = if dotted { stroke.dotted() } else { stroke };
            let (mut slow, mut fast) = (Screen::new(), Screen::new());
            slow_line(&mut slow, from, to, stroke);
            fast.line(from.0, from.1, to.0, to.1, stroke);
            prop_assert!(slow == fast, "from {from:?} to {to:?}");
        }

        /// The pixel of a level line in a column is the nearest one, in exact arithmetic.
        #[test]
        fn endless_lines_pass_through_the_nearest_pixels(x1: i32, y1: i32, x2: i32, y2: i32) {
            let mut screen = Screen::new();
            screen.line(x1, y1, x2, y2, Stroke::thin(Color::White));
            let (dx, dy) = (i128::from(x2) - i128::from(x1), i128::from(y2) - i128::from(y1));
            let columns = i128::from(x1.min(x2))..=i128::from(x1.max(x2));
            for x in 0..WIDTH {
                if dx.abs() < dy.abs() || !columns.contains(&x.into()) {
                    continue;
                }
                for y in 0..HEIGHT {
                    let off = (i128::from(y) - i128::from(y1)) * dx - (i128::from(x) - i128::from(x1)) * dy;
                    let drawn = screen.pixel(x, y) == Some(Color::White);
                    prop_assert!(!drawn || 2 * off.abs() <= dx.abs());
                    prop_assert!(drawn || 2 * off.abs() >= dx.abs());
                }
            }
        }
    }
}
