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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The tables of chapter 1.2: a row for every colour on the screen, a column for every colour in
    /// the bitmap. Or, Xor and And are printed (And with a 5 for 5 and 14, where 4 is right); the other
    /// two follow from the text.
    const TABLES: [(Put, &str); 5] =
        [(Put::Copy, COPY), (Put::Not, NOT), (Put::Or, OR), (Put::Xor, XOR), (Put::And, AND)];
    const COPY: &str = "
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF
        0123456789ABCDEF";
    const NOT: &str = "
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210
        FEDCBA9876543210";
    const OR: &str = "
        0123456789ABCDEF
        1133557799BBDDFF
        23236767ABABEFEF
        33337777BBBBFFFF
        45674567CDEFCDEF
        55775577DDFFDDFF
        67676767EFEFEFEF
        77777777FFFFFFFF
        89ABCDEF89ABCDEF
        99BBDDFF99BBDDFF
        ABABEFEFABABEFEF
        BBBBFFFFBBBBFFFF
        CDEFCDEFCDEFCDEF
        DDFFDDFFDDFFDDFF
        EFEFEFEFEFEFEFEF
        FFFFFFFFFFFFFFFF";
    const XOR: &str = "
        0123456789ABCDEF
        1032547698BADCFE
        23016745AB89EFCD
        32107654BA98FEDC
        45670123CDEF89AB
        54761032DCFE98BA
        67452301EFCDAB89
        76543210FEDCBA98
        89ABCDEF01234567
        98BADCFE10325476
        AB89EFCD23016745
        BA98FEDC32107654
        CDEF89AB45670123
        DCFE98BA54761032
        EFCDAB8967452301
        FEDCBA9876543210";
    const AND: &str = "
        0000000000000000
        0101010101010101
        0022002200220022
        0123012301230123
        0000444400004444
        0101454501014545
        0022446600224466
        0123456701234567
        0000000088888888
        0101010189898989
        0022002288AA88AA
        0123012389AB89AB
        000044448888CCCC
        010145458989CDCD
        0022446688AACCEE
        0123456789ABCDEF";

    #[test]
    fn operations_follow_the_tables_of_the_book() {
        for (put, table) in TABLES {
            for (screen, row) in Color::ALL.into_iter().zip(table.split_whitespace()) {
                for (source, expected) in Color::ALL.into_iter().zip(row.chars()) {
                    let found = u32::from(put.apply(screen, source).index());
                    assert_eq!(Some(found), expected.to_digit(16), "{put:?} {screen:?} {source:?}");
                    assert_eq!(drawn(screen, source, put), put.apply(screen, source));
                }
            }
        }
    }

    /// The colour on the screen after one pixel has been put over another.
    fn drawn(screen: Color, source: Color, put: Put) -> Color {
        let mut picture = Screen::new();
        picture.set(1, 1, source);
        let bitmap = picture.take(1, 1, 1, 1);
        picture.set(2, 1, screen);
        picture.put(2, 1, &bitmap, put);
        picture.pixel(2, 1).unwrap()
    }

    /// A screen with something on it.
    fn patchwork() -> Screen {
        let mut screen = Screen::new();
        for (x, y) in (0..64).flat_map(|x| (0..48).map(move |y| (x, y))) {
            let color = Color::from_index((x * y % 71 % 16) as u8);
            screen.bar(10 * x, 10 * y, 10 * x + 9, 10 * y + 9, color);
        }
        screen
    }

    #[test]
    fn rectangles_partly_outside_are_cut() {
        let bitmap = patchwork().take(650, -5, 630, 4);
        assert_eq!((bitmap.width(), bitmap.height()), (10, 10));
        let bitmap = patchwork().take(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
        assert_eq!((bitmap.width(), bitmap.height()), (640, 480));
        let bitmap = patchwork().take(700, 0, 710, 5);
        assert_eq!((bitmap.width(), bitmap.height()), (0, 6));
        let mut screen = patchwork();
        screen.put(0, 0, &bitmap, Put::Copy);
        assert_eq!(screen, patchwork());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn xor_done_twice_restores(x in -100..700, y in -100..500, r in 0..60) {
            let mut screen = patchwork();
            let bitmap = screen.take(100, 100, 100 + r, 110 + r);
            screen.put(x, y, &bitmap, Put::Xor);
            screen.put(x, y, &bitmap, Put::Xor);
            prop_assert!(screen == patchwork());
        }

        #[test]
        fn what_was_taken_can_be_put_back(x in -60..700, y in -60..500, w in 0..99, h in 0..99) {
            let mut screen = patchwork();
            let saved = screen.take(x, y, x + w, y + h);
            screen.bar(x, y, x + w, y + h, Color::White);
            screen.put(x, y, &saved, Put::Copy);
            prop_assert!(screen == patchwork());
        }

        #[test]
        fn any_place_is_clipped(x: i32, y: i32, x2: i32, y2: i32) {
            let mut screen = patchwork();
            let bitmap = screen.take(x, y, x2, y2);
            screen.put(x2, y, &bitmap, Put::Xor);
            screen.put(x % 700, y % 500, &bitmap, Put::Or);
        }
    }
}
