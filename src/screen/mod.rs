//! The picture of the programs: 640x480 pixels of 16 colours, with the shapes, letters, bitmaps and
//! pointer masks that Borland's graphics library drew in the mode VGAHi.
//!
//! A [`Screen`] is a plain value. Drawing takes coordinates of any size: what lies outside of the
//! picture is clipped, and what lies inside has exactly the pixels of the unclipped shape. Nothing here
//! knows of windows, files, mice or time, and nothing keeps a current colour or line style: every
//! call says what it draws with.
//!
//! ```
//! use grafika::screen::{Color, Screen, Stroke};
//!
//! let mut screen = Screen::new();
//! screen.clear(Color::LightCyan);
//! screen.line(10, 10, 100, 40, Stroke::thick(Color::Black));
//! screen.text(20, 60, "Görbe", Color::LightRed);
//! assert_eq!(screen.pixel(10, 10), Some(Color::Black));
//! ```

mod bitmap;
mod color;
mod ellipse;
mod letters;
mod line;
mod palette;
mod pointer;
mod polygon;
mod texts;
mod title;
mod visible;

pub use bitmap::{Bitmap, Put};
pub use color::Color;
pub use letters::glyph;
pub use line::{Pattern, Stroke, Width};
pub use palette::Palette;
pub use pointer::Masks;
pub use texts::Text;
pub use title::{Direction, base_letter, title_size};
pub use visible::visible;

use std::fmt;

/// Width of the screen in pixels.
pub const WIDTH: i32 = 640;
/// Height of the screen in pixels.
pub const HEIGHT: i32 = 480;

const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// A picture of 640x480 pixels of 16 colours; x grows to the right from 0 to 639, y downwards from 0
/// to 479.
///
/// Two screens are equal when their pixels are.
#[derive(Clone)]
pub struct Screen {
    pixels: Box<[u8]>,
    journal: texts::Journal,
    ellipses: ellipse::Kept,
}

impl Screen {
    /// A black screen.
    #[must_use]
    pub fn new() -> Screen {
        Screen {
            pixels: vec![Color::Black.index(); PIXELS].into_boxed_slice(),
            journal: texts::Journal::default(),
            ellipses: ellipse::Kept::default(),
        }
    }

    /// The colour numbers 0 to 15 of all pixels, row by row from the top left: `WIDTH * HEIGHT` bytes.
    #[must_use]
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// The colour of a pixel, `None` outside of the screen.
    #[must_use]
    pub fn pixel(&self, x: i32, y: i32) -> Option<Color> {
        let index = *self.pixels.get(offset(x, y)?)?;
        Some(Color::from_index(index))
    }

    /// Gives one pixel a colour.
    pub fn set(&mut self, x: i32, y: i32, color: Color) {
        if let Some(pixel) = offset(x, y).and_then(|at| self.pixels.get_mut(at)) {
            *pixel = color.index();
        }
    }

    /// Gives pixels of a row their colours, from one to the right; where there is none it stays.
    pub fn row(&mut self, x: i32, y: i32, colors: impl Iterator<Item = Option<Color>>) {
        let Some(end) = offset(WIDTH - 1, y) else { return };
        let colors = colors.skip(usize::try_from(-i64::from(x)).unwrap_or(0));
        let start = (end + 1 - WIDTH as usize) + usize::try_from(x).unwrap_or(0);
        let row = self.pixels.get_mut(start..=end).unwrap_or_default();
        for (pixel, color) in row.iter_mut().zip(colors) {
            *pixel = color.map_or(*pixel, Color::index);
        }
    }

    /// Paints the whole screen in one colour.
    pub fn clear(&mut self, color: Color) {
        self.pixels.fill(color.index());
        self.journal.clear();
    }

    /// Fills a rectangle; both corners, given in any order, belong to it.
    pub fn bar(&mut self, x1: i32, y1: i32, x2: i32, y2: i32, color: Color) {
        let (top, bottom) = (y1.min(y2).max(0), y1.max(y2).min(HEIGHT - 1));
        for y in top..=bottom {
            self.span(x1.min(x2), x1.max(x2), y, color);
        }
    }

    /// Colours the pixels from `left` to `right`, both included, of one row.
    fn span(&mut self, left: i32, right: i32, y: i32, color: Color) {
        let (left, right) = (left.max(0), right.min(WIDTH - 1));
        let ends = (offset(left, y), offset(right, y));
        if let (Some(first), Some(last)) = ends
            && let Some(row) = self.pixels.get_mut(first..=last)
        {
            row.fill(color.index());
        }
    }
}

/// The place of a pixel in [`Screen::pixels`].
fn offset(x: i32, y: i32) -> Option<usize> {
    if !(0..WIDTH).contains(&x) || !(0..HEIGHT).contains(&y) {
        return None;
    }
    usize::try_from(y * WIDTH + x).ok()
}

impl Default for Screen {
    fn default() -> Screen {
        Screen::new()
    }
}

impl PartialEq for Screen {
    /// The journal of letters says how the pixels came about, not what they are.
    fn eq(&self, other: &Screen) -> bool {
        self.pixels == other.pixels
    }
}

impl Eq for Screen {}

impl fmt::Debug for Screen {
    /// Prints the size and the number of pixels of each colour, rather than 307200 numbers.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut counts = [0u32; 16];
        for &pixel in &self.pixels {
            if let Some(count) = counts.get_mut(usize::from(pixel)) {
                *count += 1;
            }
        }
        f.debug_struct("Screen").field("pixels by color", &counts).finish()
    }
}

#[cfg(test)]
mod testing {
    use super::Screen;

    /// A part of the screen as text, one line a row: `.` for black, else the colour number in
    /// hexadecimal, `~` outside of the screen.
    pub(super) fn region(screen: &Screen, x1: i32, y1: i32, x2: i32, y2: i32) -> String {
        let letter = |x, y| match screen.pixel(x, y).map(|color| u32::from(color.index())) {
            None => '~',
            Some(0) => '.',
            Some(number) => char::from_digit(number, 16).unwrap_or('?').to_ascii_uppercase(),
        };
        let rows = (y1..=y2).map(|y| (x1..=x2).map(|x| letter(x, y)).collect::<String>());
        rows.collect::<Vec<_>>().join("\n")
    }

    /// Compares a part of the screen whose top left is (0, 0) with a drawing made of lines of equal
    /// length, in the letters of [`region`].
    #[track_caller]
    pub(super) fn assert_art(screen: &Screen, art: &str) {
        let rows: Vec<&str> = art.split_whitespace().collect();
        let width = rows.first().map_or(0, |row| row.len()) as i32;
        let found = region(screen, 0, 0, width - 1, rows.len() as i32 - 1);
        assert_eq!(found, rows.join("\n"), "found\n{found}\nexpected\n{}", rows.join("\n"));
    }
}

#[cfg(test)]
mod tests {
    use super::testing::assert_art;
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn bars_take_corners_in_any_order() {
        let mut screen = Screen::new();
        screen.bar(4, 2, 1, 1, Color::Yellow);
        screen.bar(6, 0, 6, 0, Color::Red);
        assert_art(
            &screen,
            "......4.
             .EEEE...
             .EEEE...
             ........",
        );
    }

    #[test]
    fn screens_are_equal_by_pixels_only() {
        let mut written = Screen::new();
        written.text(10, 10, "A", Color::White);
        written.bar(0, 0, 30, 30, Color::Black);
        assert_eq!(written, Screen::new());
        written.set(0, 0, Color::Blue);
        assert_ne!(written, Screen::new());
    }

    #[test]
    fn rows_of_pixels_are_clipped_and_leave_what_has_no_colour() {
        let mut screen = Screen::new();
        screen.bar(0, 0, 7, 3, Color::Blue);
        let colors = || [Some(Color::Red), None, Some(Color::White)].into_iter();
        screen.row(2, 1, colors());
        screen.row(-1, 2, colors());
        for (x, y) in [(0, -1), (0, HEIGHT), (WIDTH, 0), (i32::MIN, 0), (i32::MAX, 0)] {
            screen.row(x, y, colors());
        }
        assert_art(
            &screen,
            "11111111
             1141F111
             1F111111
             11111111",
        );
        screen.row(WIDTH - 1, 0, colors());
        assert_eq!(screen.pixel(WIDTH - 1, 0), Some(Color::Red));
    }

    #[test]
    fn pixels_outside_do_not_exist() {
        let mut screen = Screen::new();
        for (x, y) in [(-1, 0), (0, -1), (WIDTH, 0), (0, HEIGHT), (i32::MIN, i32::MAX)] {
            screen.set(x, y, Color::White);
            assert_eq!(screen.pixel(x, y), None);
        }
        assert_eq!(screen, Screen::new());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn bars_are_clipped(x1: i32, y1: i32, x2 in -20..700, y2 in -20..500) {
            let mut screen = Screen::new();
            screen.bar(x1, y1, x2, y2, Color::White);
            for (x, y) in [(0, 0), (x2, y2), (x2 - 1, y2 - 1), (x2 + 1, y2 + 1), (320, 240)] {
                let inside = (x1.min(x2)..=x1.max(x2)).contains(&x)
                    && (y1.min(y2)..=y1.max(y2)).contains(&y);
                if let Some(color) = screen.pixel(x, y) {
                    prop_assert_eq!(color == Color::White, inside);
                }
            }
        }
    }
}
