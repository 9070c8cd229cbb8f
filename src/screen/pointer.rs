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
    /// The arrow of the mouse driver: white with a black edge; the hot spot lies diagonally
    /// before its tip, so that the arrow does not hide it.
    pub const ARROW: Masks = Masks {
        screen: [
            0x3FFF, 0x1FFF, 0x0FFF, 0x07FF, 0x03FF, 0x01FF, 0x00FF, 0x007F, 0x003F, 0x001F, 0x01FF, 0x10FF,
            0x30FF, 0xF87F, 0xF87F, 0xFC7F,
        ],
        cursor: [
            0x0000, 0x4000, 0x6000, 0x7000, 0x7800, 0x7C00, 0x7E00, 0x7F00, 0x7F80, 0x7C00, 0x6C00, 0x4600,
            0x0600, 0x0300, 0x0300, 0x0000,
        ],
        hot: (-1, -1),
    };

    /// What a pair of mask bits makes of a colour on the screen.
    #[must_use]
    pub const fn apply(color: Color, screen_bit: bool, cursor_bit: bool) -> Color {
        const fn mask(bit: bool) -> Color {
            if bit { Color::White } else { Color::Black }
        }
        Put::Xor.apply(Put::And.apply(color, mask(screen_bit)), mask(cursor_bit))
    }
}

impl Screen {
    /// Draws a mouse pointer for the mouse at (x, y).
    pub fn pointer(&mut self, x: i32, y: i32, masks: &Masks) {
        let (left, top) = (x.saturating_sub(masks.hot.0), y.saturating_sub(masks.hot.1));
        for (row, (kept, inverted)) in (0..).zip(masks.screen.into_iter().zip(masks.cursor)) {
            for column in 0..16 {
                let bit = |bits: u16| bits << column & 0x8000 != 0;
                let (x, y) = (left.saturating_add(column), top.saturating_add(row));
                if let Some(color) = self.pixel(x, y) {
                    self.set(x, y, Masks::apply(color, bit(kept), bit(inverted)));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{assert_art, region};
    use super::*;

    #[test]
    fn arrow_on_cyan() {
        let mut screen = Screen::new();
        screen.clear(Color::Cyan);
        screen.pointer(0, 0, &Masks::ARROW);
        assert_art(&screen, ARROW);
    }

    const ARROW: &str = "
        33333333333333
        3..33333333333
        3.F.3333333333
        3.FF.333333333
        3.FFF.33333333
        3.FFFF.3333333
        3.FFFFF.333333
        3.FFFFFF.33333
        3.FFFFFFF.3333
        3.FFFFFFFF.333
        3.FFFFF.....33
        3.FF.FF.333333
        3.F.3.FF.33333
        3..33.FF.33333
        333333.FF.3333
        333333.FF.3333
        3333333...3333
        33333333333333";

    #[test]
    fn four_combinations_of_mask_bits() {
        // The quarters of the book's first cursor, narrowed to four pixels.
        let masks = Masks { screen: [0x3333; 16], cursor: [0x5555; 16], hot: (0, 0) };
        let mut screen = Screen::new();
        screen.clear(Color::Green);
        screen.pointer(0, 0, &masks);
        assert_eq!(region(&screen, 0, 0, 3, 0), ".F2D");
    }

    #[test]
    fn pointer_is_placed_by_its_hot_spot_and_clipped() {
        let masks = Masks { screen: [0; 16], cursor: [0xFFFF; 16], hot: (8, 8) };
        let mut screen = Screen::new();
        screen.pointer(0, 0, &masks);
        assert_eq!(screen.pixels().iter().filter(|&&pixel| pixel == 15).count(), 64);
        for (x, y) in [(i32::MIN, i32::MIN), (i32::MAX, i32::MAX), (i32::MIN, 9)] {
            screen.pointer(x, y, &masks);
        }
    }
}
