//! Rectangles of pixels that are taken from the screen and put back with one of five operations
//! (chapter 1.2).

use super::{Color, HEIGHT, Screen, WIDTH};
use serde::{Deserialize, Serialize};

/// How the pixels of a bitmap meet those of the screen (chapter 1.2). The operations work on the four
/// bits of the colour numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Put {
    /// The bitmap takes the screen's place (normalput).
    #[default]
    Copy,
    /// The inverse of the bitmap, `15 - c`, takes the screen's place (notput).
    Not,
    /// Screen or bitmap (orput).
    Or,
    /// Screen exclusive-or bitmap (xorput); done twice it restores the screen.
    Xor,
    /// Screen and bitmap (andput).
    And,
}

impl Put {
    /// The colour that `source` from the bitmap makes of `screen`.
    #[must_use]
    pub const fn apply(self, screen: Color, source: Color) -> Color {
        Color::from_index(self.bits(screen.index(), source.index()))
    }

    const fn bits(self, screen: u8, source: u8) -> u8 {
        match self {
            Put::Copy => source,
            Put::Not => !source & 15,
            Put::Or => screen | source,
            Put::Xor => screen ^ source,
            Put::And => screen & source,
        }
    }
}

/// A rectangle of pixels taken from a screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bitmap {
    width: i32,
    height: i32,
    pixels: Vec<u8>,
}

impl Bitmap {
    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> i32 {
        self.width
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> i32 {
        self.height
    }
}

impl Screen {
    /// Copies a rectangle, both corners included and given in any order. The part of it that lies
    /// outside of the screen is cut off at the right and below, and is black at the left and above,
    /// so that putting the bitmap back at the top left corner restores the screen; a rectangle is
    /// never larger than the screen.
    #[must_use]
    pub fn take(&self, x1: i32, y1: i32, x2: i32, y2: i32) -> Bitmap {
        let (left, top) = (x1.min(x2), y1.min(y2));
        let width = length(left, x1.max(x2), WIDTH);
        let height = length(top, y1.max(y2), HEIGHT);
        let mut pixels = Vec::with_capacity((width * height) as usize);
        for y in 0..height {
            for x in 0..width {
                let color = self.pixel(left.saturating_add(x), top.saturating_add(y));
                pixels.push(color.unwrap_or_default().index());
            }
        }
        Bitmap { width, height, pixels }
    }

    /// Puts a bitmap with its top left corner at (x, y).
    pub fn put(&mut self, x: i32, y: i32, bitmap: &Bitmap, put: Put) {
        let rows = bitmap.pixels.chunks_exact(bitmap.width.max(1) as usize);
        for (row, sources) in (0..).zip(rows) {
            self.put_row(x, y.saturating_add(row), sources, put);
        }
    }

    fn put_row(&mut self, x: i32, y: i32, sources: &[u8], put: Put) {
        let hidden = 0.max(x.saturating_neg()) as usize;
        let Some(start) = super::offset(x.max(0), y) else { return };
        let room = (WIDTH - x.max(0)) as usize;
        let Some(targets) = self.pixels.get_mut(start..start + room) else { return };
        for (target, &source) in targets.iter_mut().zip(sources.iter().skip(hidden)) {
            *target = put.bits(*target, source);
        }
    }
}

/// How many pixels from `low` to `high`, both included, are kept: those up to the edge of the screen
/// and at most the size of the screen.
fn length(low: i32, high: i32, size: i32) -> i32 {
    let end = i64::from(high.min(size - 1));
    (end - i64::from(low) + 1).clamp(0, i64::from(size)) as i32
}
