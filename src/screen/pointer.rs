//! The mouse pointer as the mouse driver draws it: two masks of 16x16 bits (chapter 1.4).

use super::{Color, Put, Screen};
use serde::{Deserialize, Serialize};

/// The masks of a mouse pointer. Every pixel of the screen becomes
/// `(pixel AND screen mask) XOR cursor mask`, where a bit stands for all four bits of a pixel:
/// screen 0 and cursor 0 give black, 0 and 1 white, 1 and 0 leave the pixel, 1 and 1 invert it.
/// (The heading of the book's table has the two masks the other way round.)
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Masks {
    /// The screen mask, which is ANDed: 16 rows from the top, the leftmost pixel in the highest bit.
    pub screen: [u16; 16],
    /// The cursor mask, which is XORed.
    pub cursor: [u16; 16],
    /// The pixel of the masks, from their top left, that lies on the mouse's position.
    pub hot: (i32, i32),
}

impl Masks {
    /// The arrow of the mouse driver: white with a black edge, hot at its tip.
    pub const ARROW: Masks = Masks {
        screen: [
            0x3FFF, 0x1FFF, 0x0FFF, 0x07FF, 0x03FF, 0x01FF, 0x00FF, 0x007F, 0x003F, 0x001F, 0x01FF, 0x10FF,
            0x30FF, 0xF87F, 0xF87F, 0xFC3F,
        ],
        cursor: [
            0x0000, 0x4000, 0x6000, 0x7000, 0x7800, 0x7C00, 0x7E00, 0x7F00, 0x7F80, 0x7C00, 0x6C00, 0x4600,
            0x0600, 0x0300, 0x0300, 0x0000,
        ],
        hot: (0, 0),
    };
}

impl Screen {
    /// Draws a mouse pointer for the mouse at (x, y).
    pub fn pointer(&mut self, x: i32, y: i32, masks: &Masks) {
        let (left, top) = (x.saturating_sub(masks.hot.0), y.saturating_sub(masks.hot.1));
        for (row, (kept, inverted)) in (0..).zip(masks.screen.into_iter().zip(masks.cursor)) {
            for column in 0..16 {
                let mask = |bits: u16| if bits << column & 0x8000 == 0 { 0 } else { 15 };
                let (x, y) = (left.saturating_add(column), top.saturating_add(row));
                if let Some(color) = self.pixel(x, y) {
                    let color = Put::And.apply(color, Color::from_index(mask(kept)));
                    self.set(x, y, Put::Xor.apply(color, Color::from_index(mask(inverted))));
                }
            }
        }
    }
}
