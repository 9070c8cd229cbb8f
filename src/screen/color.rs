//! The 16 colours of the VGA in its 16-colour modes, numbered as Turbo Pascal numbers them.

use serde::{Deserialize, Serialize};

/// One of the 16 colours of the screen; its number is the value of a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[repr(u8)]
pub enum Color {
    /// 0, the colour of an empty screen.
    #[default]
    Black,
    /// 1
    Blue,
    /// 2
    Green,
    /// 3
    Cyan,
    /// 4
    Red,
    /// 5
    Magenta,
    /// 6
    Brown,
    /// 7
    LightGray,
    /// 8
    DarkGray,
    /// 9
    LightBlue,
    /// 10
    LightGreen,
    /// 11, the background of the programs.
    LightCyan,
    /// 12, the hot letters of the buttons.
    LightRed,
    /// 13
    LightMagenta,
    /// 14
    Yellow,
    /// 15
    White,
}

impl Color {
    /// All colours in the order of their numbers.
    pub const ALL: [Color; 16] = [
        Color::Black,
        Color::Blue,
        Color::Green,
        Color::Cyan,
        Color::Red,
        Color::Magenta,
        Color::Brown,
        Color::LightGray,
        Color::DarkGray,
        Color::LightBlue,
        Color::LightGreen,
        Color::LightCyan,
        Color::LightRed,
        Color::LightMagenta,
        Color::Yellow,
        Color::White,
    ];

    /// The colour with the number of the low four bits of `index`, as the screen memory holds four
    /// bits a pixel.
    #[must_use]
    pub const fn from_index(index: u8) -> Color {
        // The mask keeps the index below the length of the table.
        Self::ALL[(index & 15) as usize]
    }

    /// The number of the colour, 0 to 15.
    #[must_use]
    pub const fn index(self) -> u8 {
        self as u8
    }

    /// Red, green and blue as the VGA shows the colour: 0, 85, 170 or 255 each. Brown is the one
    /// that does not follow from the bits of its number (its green is halved).
    #[must_use]
    pub const fn rgb(self) -> [u8; 3] {
        const LOW: [u8; 2] = [0, 170];
        const HIGH: [u8; 2] = [85, 255];
        if matches!(self, Color::Brown) {
            return [170, 85, 0];
        }
        let bits = self as usize;
        let level = if bits & 8 == 0 { LOW } else { HIGH };
        [level[bits >> 2 & 1], level[bits >> 1 & 1], level[bits & 1]]
    }

    /// The colour with the number `15 - c`, which the put operation `Not` and the XOR with white
    /// give (chapter 1.2).
    #[must_use]
    pub const fn inverse(self) -> Color {
        Self::from_index(15 - self as u8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_colors_are_the_same_thing() {
        for (number, color) in (0u8..).zip(Color::ALL) {
            assert_eq!(color.index(), number);
            assert_eq!(Color::from_index(number | 0xF0), color);
            assert_eq!(color.inverse().index(), 15 - number);
        }
    }

    #[test]
    fn palette_is_that_of_the_vga() {
        let hex: Vec<String> = Color::ALL
            .iter()
            .map(|color| color.rgb().iter().map(|part| format!("{part:02X}")).collect())
            .collect();
        assert_eq!(
            hex.join(" "),
            "000000 0000AA 00AA00 00AAAA AA0000 AA00AA AA5500 AAAAAA \
             555555 5555FF 55FF55 55FFFF FF5555 FF55FF FFFF55 FFFFFF"
        );
    }
}
