//! Lines of letters in a picture: how much room they take. Sizes are nominal pixels, y downwards.

use crate::geometry::Point;

/// The advance of every letter by the size of the font: 1233 of 2048 units.
pub(super) const LETTER_WIDTH: f64 = 1233.0 / 2048.0;
/// Heights above and below the base line that letters take up, by the size of the font.
pub(super) const ASCENT: f64 = 0.78;
pub(super) const DESCENT: f64 = 0.22;

/// A rectangle: left, upper, right and lower edge.
pub(super) type Area = [f64; 4];

/// A line of letters with its place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Letters {
    pub(super) text: String,
    /// Where the base line begins.
    pub(super) at: Point<2>,
    /// Size of the font.
    pub(super) size: f64,
}

impl Letters {
    /// The rectangle that the letters take up.
    pub(super) fn area(&self) -> Area {
        let [x, y] = self.at;
        [x, y - ASCENT * self.size, x + length(&self.text, self.size), y + DESCENT * self.size]
    }
}

/// The length of a line of letters.
pub(super) fn length(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * LETTER_WIDTH * size
}
