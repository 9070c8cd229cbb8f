//! The pixels of a thin line inside of a picture, clipped before they are stepped through.
//!
//! A line is stepped along its longer (major) direction from its first end, and the other coordinate is
//! rounded to the nearest pixel, halves away from the first end: the very pixels that the screen draws a
//! thin line with. Nothing is drawn here.

use std::ops::Range;

/// One of the two directions of a line in a picture.
#[derive(Clone, Copy)]
struct Axis {
    /// Coordinate of the first end.
    start: i64,
    /// Length of the line, not negative, and the sign of its direction.
    length: i64,
    sign: i64,
    /// Size of the picture, and the distance of neighbouring pixels in memory.
    size: i64,
    pitch: i64,
}

impl Axis {
    #[inline]
    fn new(from: i32, to: i32, size: i64, pitch: i64) -> Axis {
        let length = i64::from(to) - i64::from(from);
        let sign = if length < 0 { -1 } else { 1 };
        Axis { start: i64::from(from), length: length.abs(), sign, size, pitch }
    }

    #[inline]
    fn inside(&self) -> bool {
        let end = self.start + self.sign * self.length;
        (0..self.size).contains(&self.start) && (0..self.size).contains(&end)
    }

    /// The numbers of unit moves that lead from the first end into the picture.
    fn moves(&self) -> Range<i64> {
        if self.sign > 0 {
            -self.start..self.size - self.start
        } else {
            self.start - self.size + 1..self.start + 1
        }
    }
}

/// The pixels between a line's ends, inside of a picture that is stored row after row. The ends'
/// coordinates are to be within ±2²⁸, so that products of two lengths fit.
pub(super) struct Walk {
    /// The line's lengths in its two directions.
    major: i64,
    minor: i64,
    /// The steps from the first end whose pixels lie inside, both ends left out.
    steps: Range<i64>,
    /// The place in memory one step before them, and what a step in either direction adds.
    at: i64,
    ahead: i64,
    aside: i64,
    /// What the next steps go on from: the minor coordinate's remainder, in `0..2 * major`.
    rest: i64,
}

impl Walk {
    /// The line from one pixel to another in a picture of some width and height.
    #[inline]
    pub(super) fn new(from: [i32; 2], to: [i32; 2], [width, height]: [i64; 2]) -> Walk {
        let across = Axis::new(from[0], to[0], width, 1);
        let down = Axis::new(from[1], to[1], height, width);
        let (major, minor) = if across.length >= down.length { (across, down) } else { (down, across) };
        let inside = across.inside() && down.inside();
        let whole = Walk {
            major: major.length,
            minor: minor.length,
            steps: 1..major.length,
            at: across.start + down.start * width,
            ahead: major.sign * major.pitch,
            aside: minor.sign * minor.pitch,
            rest: major.length,
        };
        if inside { whole } else { whole.clipped(&major, &minor) }
    }

    /// The walk without the steps whose pixels lie outside of the picture.
    #[cold]
    fn clipped(mut self, major: &Axis, minor: &Axis) -> Walk {
        self.steps = visible(major, minor);
        let before = self.steps.start - 1;
        if before > 0 {
            // There are steps, so the line is longer than a point.
            let (value, whole) = (2 * self.minor * before + self.major, (2 * self.major).max(1));
            self.at += self.ahead * before + self.aside * (value / whole);
            self.rest = value % whole;
        }
        self
    }

    /// The number of steps from the first end to the last, clipped ones included.
    #[inline]
    pub(super) fn length(&self) -> i64 {
        self.major
    }

    /// Calls `plot` for every one of the pixels with its step and its place in memory.
    #[inline]
    pub(super) fn visit(self, mut plot: impl FnMut(i64, usize)) {
        let (mut at, mut rest) = (self.at, self.rest);
        for step in self.steps {
            rest += 2 * self.minor;
            let aside = rest >= 2 * self.major;
            rest -= if aside { 2 * self.major } else { 0 };
            at += self.ahead + if aside { self.aside } else { 0 };
            // Inside of the picture, so not negative.
            plot(step, at as usize);
        }
    }
}

/// The steps between both ends whose pixels lie inside of the picture.
fn visible(major: &Axis, minor: &Axis) -> Range<i64> {
    let (majors, minors) = (major.moves(), minor.moves());
    let (mut first, mut last) = (majors.start.max(1), majors.end.min(major.length));
    if minor.length > 0 {
        first = first.max(step_of_shift(major, minor, minors.start));
        last = last.min(step_of_shift(major, minor, minors.end));
    } else if !minors.contains(&0) {
        last = first;
    }
    first..last
}

/// The first step at which the line has moved by `shift` in the minor direction, where its length is
/// above 0: solved from `(2 * minor * step + major) / (2 * major) >= shift`.
fn step_of_shift(major: &Axis, minor: &Axis, shift: i64) -> i64 {
    let (value, whole) = ((2 * shift - 1) * major.length, 2 * minor.length);
    let step = value.div_euclid(whole) + i64::from(value.rem_euclid(whole) != 0);
    step.clamp(0, major.length + 1)
}
