//! Axes with ticks at round numbers. The step is 1, 2 or 5 times a power of ten; all axes share step and scale.
//!
//! Axes of the plane run along the lower and the left edge of the range, which is extended to whole steps. Axes of
//! space begin at the origin and are projected by a view.

use super::letters::{Letters, length};
use crate::geometry::{BoundingBox, Point, View};

/// The axes of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axes {
    /// x along the lower edge, y along the left edge.
    Plane,
    /// x, y and z of space, projected by a view.
    Space {
        /// The view of the picture.
        view: View,
        /// The range of the axes, in space.
        bounds: BoundingBox<3>,
    },
}

/// Font size of the numbers.
const AXIS_SIZE: f64 = 13.0;
/// Number of steps along the longer side.
const STEPS: f64 = 8.0;
/// Length of a tick.
const TICK: f64 = 6.0;
/// Gap between a tick and its number, and between an axis and the picture.
const GAP: f64 = 4.0;
/// The smallest gap between two numbers.
const APART: f64 = 10.0;
/// Ticks are drawn if a step is at least this long.
const SHORTEST_STEP: f64 = 6.0;
/// Numbers of more steps than this have too many digits to be legible.
const MOST_STEPS: f64 = 1e7;

/// The step between two ticks: 1, 2 or 5 times a power of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Step {
    digit: i64,
    exponent: i32,
}

impl Step {
    /// The smallest step not below a positive size.
    fn at_least(size: f64) -> Step {
        let exponent = size.log10().floor() as i32;
        let steps = [1, 2, 5].map(|digit| Step { digit, exponent });
        let found = steps.into_iter().find(|step| step.value(1) >= size * (1.0 - 1e-9));
        found.unwrap_or(Step { digit: 1, exponent: exponent.saturating_add(1) })
    }

    fn next(self) -> Step {
        match self.digit {
            1 => Step { digit: 2, ..self },
            2 => Step { digit: 5, ..self },
            _ => Step { digit: 1, exponent: self.exponent.saturating_add(1) },
        }
    }

    /// The number at a tick. It is computed by one division, so that it is the double nearest to its decimal form.
    fn value(self, tick: i64) -> f64 {
        let count = tick.saturating_mul(self.digit) as f64;
        let power = 10_f64.powi(self.exponent.saturating_abs());
        if self.exponent < 0 { count / power } else { count * power }
    }

    /// The number at a tick as text.
    fn text(self, tick: i64) -> String {
        let count = tick.saturating_mul(self.digit);
        let sign = if count < 0 { "\u{2212}" } else { "" };
        let digits = count.unsigned_abs().to_string();
        match self.exponent {
            _ if count == 0 => "0".to_string(),
            zeros @ 0..=4 => format!("{sign}{digits}{}", "0".repeat(zeros as usize)),
            places @ -6..=-1 => {
                let places = places.unsigned_abs() as usize;
                let digits = format!("{digits:0>width$}", width = places + 1);
                let (whole, part) = digits.split_at(digits.len() - places);
                let part = part.trim_end_matches('0');
                if part.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") }
            }
            exponent => format!("{sign}{digits}·10{}", raised(exponent)),
        }
    }

    /// The first and the last tick of the whole steps around a range, ignoring rounding errors.
    fn around(self, [low, high]: [f64; 2]) -> [i64; 2] {
        let step = self.value(1);
        [(low / step + 1e-9).floor() as i64, (high / step - 1e-9).ceil() as i64]
    }
}

/// An integer in superscript digits.
fn raised(number: i32) -> String {
    let digit = |ch: char| match ch {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        // The other superscript digits have consecutive code points.
        ch => ch.to_digit(10).and_then(|digit| char::from_u32(0x2070 + digit)).unwrap_or(ch),
    };
    number.to_string().chars().map(digit).collect()
}

/// Lines and numbers in nominal pixels.
#[derive(Debug, Default)]
pub(super) struct Rules {
    pub(super) lines: Vec<[Point<2>; 2]>,
    pub(super) letters: Vec<Letters>,
}

/// The axes of the plane around a window.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlaneAxes {
    step: Step,
    /// First and last tick of x and of y.
    ticks: [[i64; 2]; 2],
    /// How far items extend beyond their points.
    overhang: f64,
}

impl PlaneAxes {
    /// The axes of a window of the given size in pixels; `None` if the numbers have too many digits.
    pub(super) fn new(window: BoundingBox<2>, room: f64, overhang: f64) -> Option<PlaneAxes> {
        let [across, up] = window.size();
        let mut step = Step::at_least(across.max(up) / STEPS);
        let mut axes = PlaneAxes { step, ticks: ticks(step, window)?, overhang };
        // A larger step needs no more digits and has more room, so a few attempts are enough.
        for _ in 0..6 {
            let box_ = axes.window().size();
            let scale = room / box_[0].max(box_[1]);
            if axes.widest(0) + APART <= step.value(1) * scale {
                break;
            }
            step = step.next();
            axes = PlaneAxes { step, ticks: ticks(step, window)?, overhang };
        }
        Some(axes)
    }

    /// The window extended to whole steps.
    pub(super) fn window(&self) -> BoundingBox<2> {
        let value = |d: usize, end: usize| self.step.value(self.ticks[d][end]);
        BoundingBox { min: [value(0, 0), value(1, 0)], max: [value(0, 1), value(1, 1)] }
    }

    /// The width of the widest number along an axis.
    fn widest(&self, d: usize) -> f64 {
        let [first, last] = self.ticks[d];
        (first..=last).map(|tick| length(&self.step.text(tick), AXIS_SIZE)).fold(0.0, f64::max)
    }

    /// The distance from the window to its axes.
    fn offset(&self) -> f64 {
        self.overhang + GAP
    }

    /// The margins that the axes need, left of the window and below it.
    pub(super) fn bands(&self) -> [f64; 2] {
        let out = self.offset() + TICK + GAP;
        [out + self.widest(1), out + AXIS_SIZE]
    }

    /// Lines and numbers of the axes; `place` maps a point of the window to its pixel.
    pub(super) fn rules(&self, place: impl Fn(Point<2>) -> Point<2>) -> Rules {
        let window = self.window();
        let ([left, bottom], [right, top]) = (place(window.min), place(window.max));
        let (left, bottom) = (left - self.offset(), bottom + self.offset());
        let mut rules = Rules::default();
        rules.lines.push([[left + self.offset(), bottom], [right, bottom]]);
        rules.lines.push([[left, bottom - self.offset()], [left, top]]);
        for tick in self.ticks[0][0]..=self.ticks[0][1] {
            let [x, _] = place([self.step.value(tick), window.min[1]]);
            rules.lines.push([[x, bottom], [x, bottom + TICK]]);
            let text = self.step.text(tick);
            let at = [x - length(&text, AXIS_SIZE) / 2.0, bottom + TICK + GAP + 0.75 * AXIS_SIZE];
            rules.letters.push(Letters::black(text, at, AXIS_SIZE));
        }
        for tick in self.ticks[1][0]..=self.ticks[1][1] {
            let [_, y] = place([window.min[0], self.step.value(tick)]);
            rules.lines.push([[left - TICK, y], [left, y]]);
            let text = self.step.text(tick);
            let at = [left - TICK - GAP - length(&text, AXIS_SIZE), y + 0.36 * AXIS_SIZE];
            rules.letters.push(Letters::black(text, at, AXIS_SIZE));
        }
        rules.letters.push(letter("x", [right + 16.0, bottom]));
        rules.letters.push(letter("y", [left, top - 16.0]));
        rules
    }
}

/// The name of an axis, centred at a place.
fn letter(name: &str, [x, y]: Point<2>) -> Letters {
    let size = AXIS_SIZE + 2.0;
    Letters::black(name.to_string(), [x - length(name, size) / 2.0, y + 0.36 * size], size)
}

/// The ticks of a window with a step; `None` if their numbers have too many digits.
fn ticks(step: Step, window: BoundingBox<2>) -> Option<[[i64; 2]; 2]> {
    let few = window.largest_coordinate() / step.value(1) <= MOST_STEPS;
    few.then(|| [0, 1].map(|d| at_least_one(step.around([window.min[d], window.max[d]]))))
}

fn at_least_one([first, last]: [i64; 2]) -> [i64; 2] {
    [first, last.max(first.saturating_add(1))]
}

/// The axes of space, projected by a view.
#[derive(Clone, Copy, Debug)]
pub(super) struct SpaceAxes {
    view: View,
    step: Step,
    ticks: [[i64; 2]; 3],
}

impl SpaceAxes {
    /// The axes from the origin along their range; `None` if the numbers have too many digits.
    pub(super) fn new(view: View, bounds: BoundingBox<3>) -> Option<SpaceAxes> {
        let bounds = bounds.union(BoundingBox::of_point([0.0; 3]));
        let extent = bounds.size().into_iter().fold(0.0, f64::max);
        if !(1e-150..1e150).contains(&extent) {
            return None;
        }
        let step = Step::at_least(extent / STEPS);
        let ticks = std::array::from_fn(|d| at_least_one(step.around([bounds.min[d], bounds.max[d]])));
        Some(SpaceAxes { view, step, ticks })
    }

    /// A point of an axis in the plane of the view.
    fn point(&self, axis: usize, tick: i64) -> Point<2> {
        let mut point = [0.0; 3];
        if let Some(value) = point.get_mut(axis) {
            *value = self.step.value(tick);
        }
        self.view.place(point)
    }

    /// The bounding box of the axes in the plane of the view.
    pub(super) fn window(&self) -> BoundingBox<2> {
        let ends = (0..3).zip(self.ticks).flat_map(|(axis, ends)| ends.map(|tick| self.point(axis, tick)));
        ends.map(BoundingBox::of_point).fold(BoundingBox::of_point([0.0; 2]), BoundingBox::union)
    }

    /// Lines and numbers of the axes; `place` maps a point in the plane of the view to its pixel.
    pub(super) fn rules(&self, place: impl Fn(Point<2>) -> Point<2>) -> Rules {
        let mut rules = Rules::default();
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let [first, last] = self.ticks[axis];
            let at = |tick: i64| place(self.point(axis, tick));
            let (from, to, next) = (at(first), at(last), at(last + 1));
            let step = [next[0] - to[0], next[1] - to[1]];
            let size = step[0].hypot(step[1]);
            if size < 1e-6 {
                // An axis parallel to the direction of view is a point.
                continue;
            }
            let along = step.map(|x| x / size);
            rules.lines.push([from, to]);
            rules.letters.push(letter(name, [to[0] + 14.0 * along[0], to[1] + 14.0 * along[1]]));
            if size >= SHORTEST_STEP {
                self.add_ticks(&mut rules, axis, (along, size), at);
            }
        }
        rules
    }

    /// The ticks perpendicular to an axis, with numbers where they fit.
    fn add_ticks(
        &self,
        rules: &mut Rules,
        axis: usize,
        (along, size): (Point<2>, f64),
        at: impl Fn(i64) -> Point<2>,
    ) {
        // Below the axis, or left of a steep one.
        let across = if along[0].abs() > 1e-9 { [-along[1], along[0]] } else { [-1.0, 0.0] };
        let across = if across[1] < 0.0 { across.map(|x| -x) } else { across };
        let [first, last] = self.ticks[axis];
        for tick in (first..=last).filter(|&tick| tick != 0) {
            let [x, y] = at(tick);
            rules.lines.push([[x, y], [x + TICK * across[0], y + TICK * across[1]]]);
            let text = self.step.text(tick);
            let [half, up] = [length(&text, AXIS_SIZE) / 2.0, AXIS_SIZE / 2.0];
            let needed = (2.0 * half * along[0]).abs().max((2.0 * up * along[1]).abs()) + APART;
            if size < needed && tick != last {
                continue;
            }
            let out = TICK + GAP + half * across[0].abs() + up * across[1].abs();
            let middle = [x + out * across[0], y + out * across[1]];
            let at = [middle[0] - half, middle[1] + 0.36 * AXIS_SIZE];
            rules.letters.push(Letters::black(text, at, AXIS_SIZE));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn texts(digit: i64, exponent: i32) -> [String; 4] {
        [0, 1, -3, 10].map(|tick| Step { digit, exponent }.text(tick))
    }

    #[test]
    fn numbers_are_printed_as_in_a_book() {
        assert_eq!(texts(1, 2), ["0", "100", "−300", "1000"]);
        assert_eq!(texts(5, -1), ["0", "0.5", "−1.5", "5"]);
        assert_eq!(texts(2, -3), ["0", "0.002", "−0.006", "0.02"]);
        assert_eq!(texts(2, 9), ["0", "2·10⁹", "−6·10⁹", "20·10⁹"]);
        assert_eq!(texts(5, -12), ["0", "5·10⁻¹²", "−15·10⁻¹²", "50·10⁻¹²"]);
    }

    #[test]
    fn steps_are_the_next_round_numbers() {
        for (size, digit, exponent) in
            [(70.0, 1, 2), (1.0, 1, 0), (1.01, 2, 0), (0.3, 5, -1), (5.0, 5, 0), (5.1, 1, 1), (2e-9, 2, -9)]
        {
            assert_eq!(Step::at_least(size), Step { digit, exponent }, "{size}");
        }
        assert_eq!(Step { digit: 5, exponent: -1 }.next(), Step { digit: 1, exponent: 0 });
    }

    proptest! {
        #[test]
        fn ticks_are_what_is_written(tick in -1000_i64..1000, digit in prop::sample::select(vec![1_i64, 2, 5]), exponent in -6..5) {
            let step = Step { digit, exponent };
            let read: f64 = step.text(tick).replace('−', "-").parse().unwrap();
            prop_assert_eq!(read, step.value(tick) + 0.0);
        }

        #[test]
        fn axes_go_round_their_window(
            middle in prop::array::uniform2(-1e6..1e6), size in prop::array::uniform2(0.0..1e3), power in -100..100,
        ) {
            let unit = 10_f64.powi(power);
            let corner = |sign: f64| std::array::from_fn(|d| (middle[d] + sign * (size[d] + 0.1)) * unit);
            let window = BoundingBox { min: corner(-1.0), max: corner(1.0) };
            let axes = PlaneAxes::new(window, 600.0, 2.0).unwrap();
            let (grown, slack) = (axes.window(), 1e-8 * axes.step.value(1));
            for d in 0..2 {
                prop_assert!(grown.min[d] <= window.min[d] + slack && grown.max[d] >= window.max[d] - slack);
            }
            let count = (0..2).map(|d| axes.ticks[d][1] - axes.ticks[d][0]).max().unwrap();
            prop_assert!((1..=10).contains(&count), "{count} steps");
        }
    }
}
