//! The size of lines of text in a picture. Sizes are in nominal pixels, y points downwards.

use crate::geometry::Point;

/// The advance of every letter, relative to the font size: 1233 of 2048 units.
pub(super) const LETTER_WIDTH: f64 = 1233.0 / 2048.0;
/// Ascent and descent of letters, relative to the font size.
pub(super) const ASCENT: f64 = 0.78;
pub(super) const DESCENT: f64 = 0.22;

/// A rectangle: left, upper, right and lower edge.
pub(super) type Area = [f64; 4];

/// A line of text with its place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Letters {
    pub(super) text: String,
    /// Start of the baseline.
    pub(super) at: Point<2>,
    /// Font size.
    pub(super) size: f64,
    /// Colour: red, green, blue.
    pub(super) ink: [u8; 3],
}

impl Letters {
    /// A line of black text.
    pub(super) fn black(text: String, at: Point<2>, size: f64) -> Letters {
        Letters { text, at, size, ink: [0; 3] }
    }

    /// The bounding box of the letters.
    pub(super) fn area(&self) -> Area {
        let [x, y] = self.at;
        [x, y - ASCENT * self.size, x + length(&self.text, self.size), y + DESCENT * self.size]
    }
}

/// The length of a line of text.
pub(super) fn length(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * LETTER_WIDTH * size
}
