//! The place of the picture in a window, and its conversion to the window's pixel format.
//!
//! The picture is magnified by the largest integer factor that fits and centred between black margins. A window
//! smaller than the picture shows it reduced, so that all of it can be reached.

use crate::screen::{Color, HEIGHT, Palette, Screen, WIDTH};

/// Width and height of the picture as unsigned numbers.
const PICTURE: (usize, usize) = (WIDTH as usize, HEIGHT as usize);

/// A window's size and the place of the picture in it, in the window's pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) window: (usize, usize),
    /// Width and height of the picture as it is shown.
    shown: (usize, usize),
    /// Left and upper edge of the picture.
    corner: (usize, usize),
}

impl Layout {
    /// The layout of a window of this size.
    pub(super) fn of(window: (usize, usize)) -> Layout {
        let window = (window.0.max(1), window.1.max(1));
        let factor = (window.0 / PICTURE.0).min(window.1 / PICTURE.1);
        let shown = match factor {
            0 => reduced(window),
            _ => (PICTURE.0 * factor, PICTURE.1 * factor),
        };
        Layout { window, shown, corner: ((window.0 - shown.0) / 2, (window.1 - shown.1) / 2) }
    }

    /// The pixel of the picture under a point of the window; outside the picture, the nearest one.
    pub(super) fn pixel_at(&self, x: f64, y: f64) -> (i32, i32) {
        let along = |place: f64, corner: usize, shown: usize, size: usize| {
            let pixel = (place - corner as f64) * size as f64 / shown as f64;
            // The conversion saturates and turns a NaN into 0.
            (pixel.floor() as i32).clamp(0, size as i32 - 1)
        };
        (along(x, self.corner.0, self.shown.0, PICTURE.0), along(y, self.corner.1, self.shown.1, PICTURE.1))
    }

    /// Whether a point lies in the window.
    pub(super) fn holds(&self, x: f64, y: f64) -> bool {
        x >= 0.0 && y >= 0.0 && x < self.window.0 as f64 && y < self.window.1 as f64
    }

    /// Paints the window into `pixels`, row by row as 0x00RRGGBB. A buffer of another size is left alone.
    pub(super) fn paint(&self, picture: &Screen, palette: Palette, pixels: &mut [u32]) {
        if pixels.len() != self.window.0 * self.window.1 {
            return;
        }
        let shades = Color::ALL.map(|color| {
            let [red, green, blue] = palette.rgb(color);
            u32::from_be_bytes([0, red, green, blue])
        });
        let sources: Vec<usize> = (0..self.shown.0).map(|x| x * PICTURE.0 / self.shown.0).collect();
        pixels.fill(0);
        let mut painted: Option<(usize, usize)> = None;
        for row in 0..self.shown.1 {
            let source = row * PICTURE.1 / self.shown.1;
            let start = (self.corner.1 + row) * self.window.0 + self.corner.0;
            match painted {
                // All rows of a magnified pixel are equal.
                Some((same, from)) if same == source => {
                    pixels.copy_within(from..from + self.shown.0, start);
                }
                _ => {
                    let line = picture.pixels().chunks_exact(PICTURE.0).nth(source).unwrap_or(&[]);
                    let target = pixels.get_mut(start..).unwrap_or(&mut []);
                    for (pixel, &x) in target.iter_mut().zip(&sources) {
                        let index = line.get(x).map_or(0, |&index| usize::from(index & 15));
                        *pixel = shades[index];
                    }
                    painted = Some((source, start));
                }
            }
        }
    }
}

/// The largest size with the picture's aspect ratio that fits into a window smaller than the picture.
fn reduced(window: (usize, usize)) -> (usize, usize) {
    if window.0 * PICTURE.1 <= window.1 * PICTURE.0 {
        (window.0, (window.0 * PICTURE.1 / PICTURE.0).max(1))
    } else {
        ((window.1 * PICTURE.0 / PICTURE.1).max(1), window.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn whole_factors_in_the_middle() {
        let layout = Layout::of((1400, 1000));
        assert_eq!((layout.shown, layout.corner), ((1280, 960), (60, 20)));
        assert_eq!(layout.pixel_at(60.0, 20.0), (0, 0));
        assert_eq!(layout.pixel_at(61.9, 21.9), (0, 0));
        assert_eq!(layout.pixel_at(62.0, 22.0), (1, 1));
        assert_eq!(layout.pixel_at(1339.0, 979.0), (639, 479));
        assert_eq!(layout.pixel_at(-5.0, 5000.0), (0, 479));
    }

    #[test]
    fn painted_pixels_are_those_of_the_picture() {
        let mut picture = Screen::new();
        picture.set(0, 0, Color::Yellow);
        picture.set(639, 479, Color::Brown);
        let layout = Layout::of((1283, 965));
        let mut pixels = vec![7; 1283 * 965];
        layout.paint(&picture, Palette::Vga, &mut pixels);
        let at = |x: usize, y: usize| pixels[y * 1283 + x];
        assert_eq!([at(1, 2), at(2, 3), at(3, 3), at(0, 2), at(1, 1)], [0xFF_FF55, 0xFF_FF55, 0, 0, 0]);
        assert_eq!([at(1280, 961), at(1279, 960), at(1281, 961)], [0xAA_5500, 0xAA_5500, 0]);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn any_window_shows_and_maps_the_whole_picture(
            width in 0usize..1500, height in 0usize..1100, x in -10.0f64..1600.0, y in -10.0f64..1200.0,
        ) {
            let layout = Layout::of((width, height));
            let mut pixels = vec![7; layout.window.0 * layout.window.1];
            let mut picture = Screen::new();
            picture.clear(Color::White);
            layout.paint(&picture, Palette::Vga, &mut pixels);
            let white = pixels.iter().filter(|&&pixel| pixel == 0xFF_FFFF).count();
            prop_assert_eq!(white, layout.shown.0 * layout.shown.1);
            prop_assert!(layout.corner.0 + layout.shown.0 <= layout.window.0);
            let (px, py) = layout.pixel_at(x, y);
            prop_assert!((0..WIDTH).contains(&px) && (0..HEIGHT).contains(&py));
        }
    }
}
