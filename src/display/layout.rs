//! The place of the picture in a window, and its conversion to the window's pixel format.
//!
//! By its sharp look the picture is magnified by the largest whole factor that fits and stands in the middle of black
//! margins. By the other looks it is as large as it fits, and so it is by any look in a window smaller than the picture,
//! so that nothing is out of reach. A pixel of the window has the mean colour of the part of the picture that it covers:
//! at whole factors these are the sharp pixels themselves, between them only the edges are mixed, and a reduced picture
//! loses no thin line.

use crate::machine::Look;
use crate::screen::{Color, HEIGHT, Palette, Screen, WIDTH};

/// Width and height of the picture as unsigned numbers.
const PICTURE: (usize, usize) = (WIDTH as usize, HEIGHT as usize);

/// A window's size and the place of the picture in it, in the window's pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) window: (usize, usize),
    look: Look,
    /// Width and height of the picture as it is shown.
    pub(super) shown: (usize, usize),
    /// Left and upper edge of the picture.
    pub(super) corner: (usize, usize),
}

impl Layout {
    /// The layout of a window of this size.
    pub(super) fn of(window: (usize, usize), look: Look) -> Layout {
        let window = (window.0.clamp(1, LARGEST), window.1.clamp(1, LARGEST));
        let factor = (window.0 / PICTURE.0).min(window.1 / PICTURE.1);
        let shown = match (look, factor) {
            (Look::Sharp, 1..) => (PICTURE.0 * factor, PICTURE.1 * factor),
            _ => fitting(window),
        };
        Layout { window, look, shown, corner: ((window.0 - shown.0) / 2, (window.1 - shown.1) / 2) }
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
    #[cfg(any(feature = "window", feature = "minifb"))]
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
        let blur = if self.look == Look::Crt { BLUR } else { 0 };
        let columns = Cover::of(PICTURE.0, self.shown.0, blur);
        let rows = Cover::of(PICTURE.1, self.shown.1, 0);
        pixels.fill(0);
        let mut line = Line::new(self.shown.0);
        let mut painted: Option<(usize, usize)> = None;
        for row in 0..self.shown.1 {
            let start = (self.corner.1 + row) * self.window.0 + self.corner.0;
            let light = self.light(row);
            match painted {
                // Most rows of a magnified pixel are alike.
                Some((same, from)) if rows.alike(same, row) && self.light(same) == light => {
                    pixels.copy_within(from..from + self.shown.0, start);
                }
                _ => {
                    line.clear();
                    for (source, weight) in rows.parts(row) {
                        let source = picture.pixels().chunks_exact(PICTURE.0).nth(source).unwrap_or(&[]);
                        line.add(source, &columns, &shades, weight);
                    }
                    let target = pixels.get_mut(start..start + self.shown.0).unwrap_or(&mut []);
                    line.paint(light, target);
                }
            }
            painted = Some((row, start));
        }
    }

    /// How bright a row of the window is, of [`WHOLE`]: the gaps between the lines of a picture tube are dark. Lines of
    /// less than two rows have no room for gaps.
    fn light(&self, row: usize) -> u32 {
        if self.look != Look::Crt || self.shown.1 < 2 * PICTURE.1 {
            return WHOLE;
        }
        // In parts of which a row of the window has as many as the picture has rows.
        let line = self.shown.1;
        let top = row * PICTURE.1;
        let gap = |place: usize| place / line * (line - line / 2) + (place % line).saturating_sub(line / 2);
        let dark = gap(top + PICTURE.1) - gap(top);
        WHOLE - (dark * GAP as usize / PICTURE.1) as u32
    }
}

/// Larger windows than this, in pixels along a side, show a picture of this size in their corner. There are none.
const LARGEST: usize = 1 << 16;
/// The sum of the weights of the parts that a pixel is mixed from.
const WHOLE: u32 = 256;
/// How much of [`WHOLE`] the gaps between the lines of a picture tube are darker.
const GAP: u32 = 120;
/// How far a pixel of a picture tube reaches into its neighbours, in percent of its width.
const BLUR: usize = 30;

/// Which pixels of the picture, along one side, the pixels of the window cover, and how much of each.
struct Cover {
    /// For every pixel of the window: the first pixel of the picture, and where its weights begin.
    firsts: Vec<(usize, usize)>,
    weights: Vec<u32>,
}

impl Cover {
    /// `size` pixels shown as `shown`; a pixel of the window reaches by `blur` percent of a pixel of the picture into what is
    /// left and right of it.
    fn of(size: usize, shown: usize, blur: usize) -> Cover {
        let mut cover = Cover { firsts: Vec::with_capacity(shown + 1), weights: Vec::new() };
        // Lengths in parts of which a pixel of the window has `size` and one of the picture `shown`.
        let reach = shown * blur / 100;
        for pixel in 0..shown {
            let begin = (pixel * size).saturating_sub(reach);
            let end = ((pixel + 1) * size + reach).min(size * shown);
            let (first, length) = (begin / shown, (end - begin) as u64);
            cover.firsts.push((first, cover.weights.len()));
            // Shares are rounded so that their sum is whole.
            let share = |place: usize| (place.clamp(begin, end) - begin) as u64 * u64::from(WHOLE) / length;
            let parts = first..end.div_ceil(shown);
            cover.weights.extend(parts.map(|part| (share((part + 1) * shown) - share(part * shown)) as u32));
        }
        cover.firsts.push((size, cover.weights.len()));
        cover
    }

    fn weights(&self, pixel: usize) -> (usize, &[u32]) {
        match self.firsts.get(pixel..).unwrap_or_default() {
            [(first, begin), (_, end), ..] => (*first, self.weights.get(*begin..*end).unwrap_or_default()),
            _ => (0, &[]),
        }
    }

    /// The pixels of the picture under one of the window, with their weights.
    fn parts(&self, pixel: usize) -> impl Iterator<Item = (usize, u32)> {
        let (first, weights) = self.weights(pixel);
        (first..).zip(weights.iter().copied())
    }

    fn alike(&self, one: usize, other: usize) -> bool {
        self.weights(one) == self.weights(other)
    }
}

/// A row of the window while it is mixed: red and blue in one number, green in the other, in 256ths.
struct Line(Vec<[u32; 2]>);

/// A colour 0RGB as [red and blue, green].
fn split(shade: u32) -> [u32; 2] {
    [shade & 0xFF_00FF, (shade >> 8) & 0xFF]
}

/// What [`split`] has taken apart, from 256ths, rounded.
fn joined([red_blue, green]: [u32; 2]) -> u32 {
    ((red_blue + 0x80_0080) >> 8) & 0xFF_00FF | (green + 0x80) & 0xFF00
}

impl Line {
    fn new(length: usize) -> Line {
        Line(vec![[0; 2]; length])
    }

    fn clear(&mut self) {
        self.0.fill([0; 2]);
    }

    /// Adds a row of the picture with a weight.
    fn add(&mut self, source: &[u8], columns: &Cover, shades: &[u32; 16], weight: u32) {
        let shade = |index: usize| source.get(index).map_or(0, |&index| shades[usize::from(index & 15)]);
        for (pixel, sum) in self.0.iter_mut().enumerate() {
            let shade = match columns.weights(pixel) {
                (first, [_]) => shade(first),
                (first, weights) => {
                    let parts = (first..)
                        .zip(weights)
                        .map(|(index, weight)| split(shade(index)).map(|it| it * weight));
                    joined(parts.fold([0; 2], |sum, part| [sum[0] + part[0], sum[1] + part[1]]))
                }
            };
            let [red_blue, green] = split(shade);
            *sum = [sum[0] + red_blue * weight, sum[1] + green * weight];
        }
    }

    /// Paints what has been added, with some part of its brightness.
    fn paint(&self, light: u32, target: &mut [u32]) {
        for (pixel, sum) in target.iter_mut().zip(&self.0) {
            *pixel = match light {
                WHOLE => joined(*sum),
                _ => joined(split(joined(*sum)).map(|it| it * light)),
            };
        }
    }
}

/// The largest size of the picture's proportions in a window.
fn fitting(window: (usize, usize)) -> (usize, usize) {
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

    const LOOKS: [Look; 3] = [Look::Sharp, Look::Fill, Look::Crt];

    /// The window's pixels and the layout they were painted with.
    fn painted(picture: &Screen, window: (usize, usize), look: Look) -> (Layout, Vec<u32>) {
        let layout = Layout::of(window, look);
        let mut pixels = vec![7; layout.window.0 * layout.window.1];
        layout.paint(picture, Palette::Vga, &mut pixels);
        (layout, pixels)
    }

    /// Lines, letters and areas.
    fn busy() -> Screen {
        let mut picture = Screen::new();
        picture.bar(100, 100, 400, 300, Color::Blue);
        picture.text(101, 107, "abcdefgh", Color::White);
        for x in (0..WIDTH).step_by(7) {
            picture.set(x, x % HEIGHT, Color::LightRed);
        }
        picture
    }

    #[test]
    fn whole_factors_in_the_middle() {
        let layout = Layout::of((1400, 1000), Look::Sharp);
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
        let (_, pixels) = painted(&picture, (1283, 965), Look::Sharp);
        let at = |x: usize, y: usize| pixels[y * 1283 + x];
        assert_eq!([at(1, 2), at(2, 3), at(3, 3), at(0, 2), at(1, 1)], [0xFF_FF55, 0xFF_FF55, 0, 0, 0]);
        assert_eq!([at(1280, 961), at(1279, 960), at(1281, 961)], [0xAA_5500, 0xAA_5500, 0]);
    }

    #[test]
    fn a_filling_picture_at_whole_factors_is_the_sharp_one() {
        for window in [(640, 480), (1280, 960), (1920, 1440), (1400, 960)] {
            let [sharp, fill] = [Look::Sharp, Look::Fill].map(|look| painted(&busy(), window, look).1);
            assert!(sharp == fill, "{window:?}");
        }
    }

    #[test]
    fn between_whole_factors_only_edges_are_mixed() {
        let mut picture = Screen::new();
        picture.bar(0, 0, 319, 479, Color::White);
        let (layout, pixels) = painted(&picture, (900, 600), Look::Fill);
        assert_eq!((layout.shown, layout.corner), ((800, 600), (50, 0)));
        let row = &pixels[300 * 900..301 * 900];
        let mixed = row.iter().filter(|&&pixel| pixel != 0 && pixel != 0xFF_FFFF).count();
        assert!(
            row[50..450].iter().all(|&pixel| pixel == 0xFF_FFFF) && mixed == 0,
            "an edge between pixels is sharp"
        );
        picture.bar(320, 0, 320, 479, Color::White);
        let (_, pixels) = painted(&picture, (900, 600), Look::Fill);
        // Pixel 320 ends at 321 * 1.25 = 401.25: a quarter of the window's pixel 401 is white.
        assert_eq!(pixels[300 * 900 + 450..][..3], [0xFF_FFFF, 0x40_4040, 0]);
    }

    #[test]
    fn a_picture_tube_has_dark_gaps_and_the_same_colours() {
        let mut picture = Screen::new();
        picture.clear(Color::Yellow);
        for scale in 2..=4 {
            let (_, pixels) = painted(&picture, (640 * scale, 480 * scale), Look::Crt);
            let column: Vec<u32> = pixels.iter().step_by(640 * scale).copied().collect();
            let (lit, gap) = (column[0], column[scale - 1]);
            assert!(
                lit == 0xFF_FF55 && gap >> 16 < 0xB0 && gap >> 16 == (gap >> 8) & 0xFF,
                "{lit:06X} {gap:06X}"
            );
            assert!(column.chunks(scale).all(|line| line == &column[..scale]), "all lines are alike");
        }
        // Where there is no room for gaps there are none.
        assert!(
            painted(&picture, (900, 600), Look::Crt).1.iter().all(|&pixel| pixel == 0 || pixel == 0xFF_FF55)
        );
    }

    #[test]
    fn a_reduced_picture_loses_no_line() {
        let mut picture = Screen::new();
        for y in [100, 101, 102, 103] {
            picture.clear(Color::Black);
            picture.bar(0, y, 639, y, Color::White);
            let (_, pixels) = painted(&picture, (200, 150), Look::Sharp);
            let light: u32 = pixels.iter().step_by(200).map(|pixel| pixel & 0xFF).sum();
            assert!((70..=90).contains(&light), "{light}");
        }
    }

    #[test]
    fn odd_sizes_do_no_harm() {
        for look in LOOKS {
            for window in [(0, 0), (1, 1), (1, 1000), (1000, 1), (3, 2), (641, 481), (639, 481), (5000, 7)] {
                painted(&busy(), window, look);
            }
            let layout = Layout::of((usize::MAX, usize::MAX), look);
            layout.paint(&busy(), Palette::Vga, &mut []);
            assert_eq!(layout.pixel_at(f64::NAN, f64::INFINITY), (0, 479));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn any_window_shows_and_maps_the_whole_picture(
            width in 0usize..1500, height in 0usize..1100, x in -10.0f64..1600.0, y in -10.0f64..1200.0,
            look in prop::sample::select(&LOOKS[..2]),
        ) {
            let mut picture = Screen::new();
            picture.clear(Color::White);
            let (layout, pixels) = painted(&picture, (width, height), look);
            let white = pixels.iter().filter(|&&pixel| pixel == 0xFF_FFFF).count();
            prop_assert_eq!(white, layout.shown.0 * layout.shown.1);
            prop_assert!(layout.corner.0 + layout.shown.0 <= layout.window.0);
            let (px, py) = layout.pixel_at(x, y);
            prop_assert!((0..WIDTH).contains(&px) && (0..HEIGHT).contains(&py));
        }
    }
}
