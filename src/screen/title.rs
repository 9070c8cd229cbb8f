//! Titles in the stroked Triplex face, in ten sizes, across or upwards.

use super::{Color, Screen};
use serde::{Deserialize, Serialize};

/// The direction in which a title runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Direction {
    /// From left to right.
    #[default]
    Horizontal,
    /// From below upwards, the letters lying on their backs.
    Vertical,
}

/// Width and height in pixels of a title, running horizontally.
#[must_use]
pub fn title_size(_text: &str, _size: u8) -> (i32, i32) {
    (0, 0)
}

impl Screen {
    /// Draws a title whose box has its top left corner at (x, y).
    pub fn title(&mut self, _x: i32, _y: i32, _text: &str, _color: Color, _size: u8, _direction: Direction) {}
}
