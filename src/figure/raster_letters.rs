//! Letters in a PNG: every one of a size drawn once, with its seam, and laid down wherever it stands.

use super::FigureError;
use super::letters::{LETTER_WIDTH, Letters};
use super::picture::NOMINAL_WIDTH;
use super::raster::{FONT, mix};
use fontdue::{Font, FontSettings};
use std::collections::HashMap;
use tiny_skia::Pixmap;

/// Width of the white seam around letters in nominal pixels.
const SEAM: f64 = 1.5;

/// Channels of letters that are kept; beyond, they are drawn anew.
const KEPT: usize = 1 << 26;

/// The letters of a font, drawn when they are met first.
pub(super) struct Glyphs {
    font: Font,
    /// By number in the font and the bits of the size in pixels: letter and seam.
    known: HashMap<(u16, u64), [Stamp; 2]>,
    kept: usize,
}

/// A letter's coverage with its place from the start of the baseline.
struct Glyph {
    left: i64,
    top: i64,
    width: usize,
    coverage: Vec<u8>,
}

/// A letter as it is laid down: the coverage of every channel of its pixels.
struct Stamp {
    left: i64,
    top: i64,
    width: usize,
    /// Four to a pixel. The last is 0, so that the opacity stays what it is.
    channels: Vec<u8>,
}

/// Channels that are blended at once.
const LANES: usize = 16;

impl Glyphs {
    pub(super) fn new() -> Result<Glyphs, FigureError> {
        let font = Font::from_bytes(FONT, FontSettings::default())
            .map_err(|message| FigureError::Encoding(message.to_string()))?;
        Ok(Glyphs { font, known: HashMap::new(), kept: 0 })
    }

    /// Writes a line of letters with their seams into rows of the picture from `top` on.
    pub(super) fn write(&mut self, pixmap: &mut Pixmap, top: u32, line: &Letters, enlarged: f64) {
        let size = line.size * enlarged;
        let advance = LETTER_WIDTH * size;
        let [x, y] = line.at.map(|value| value * enlarged);
        let rightmost = f64::from(NOMINAL_WIDTH) * enlarged;
        let pens = line.text.chars().enumerate().map(|(index, ch)| (x + index as f64 * advance, ch));
        let shown = pens.skip_while(|(pen, _)| pen + size < 0.0).take_while(|(pen, _)| *pen < rightmost);
        let row = (y.round() as i64).saturating_sub(i64::from(top));
        let seam = (SEAM * enlarged).round() as usize;
        let glyphs: Vec<(u16, i64)> =
            shown.map(|(pen, ch)| (self.font.lookup_glyph_index(ch), pen.round() as i64)).collect();
        if self.kept > KEPT {
            self.known.clear();
            self.kept = 0;
        }
        for &(number, _) in &glyphs {
            self.known.entry((number, size.to_bits())).or_insert_with(|| {
                let glyph = Glyph::new(&self.font, number, size);
                let both = [&glyph.seam(seam), &glyph].map(Stamp::new);
                self.kept += both.iter().map(|stamp| stamp.channels.len()).sum::<usize>();
                both
            });
        }
        // All seams come first: none may cover the letter before it.
        for (part, ink) in [[255; 3], line.ink].into_iter().enumerate() {
            for (number, pen) in &glyphs {
                if let Some(both) = self.known.get(&(*number, size.to_bits())) {
                    both[part].put(pixmap, [*pen, row], ink);
                }
            }
        }
    }
}

impl Glyph {
    fn new(font: &Font, number: u16, size: f64) -> Glyph {
        let (metrics, coverage) = font.rasterize_indexed(number, size as f32);
        let top = -i64::from(metrics.ymin) - metrics.height as i64;
        Glyph { left: i64::from(metrics.xmin), top, width: metrics.width, coverage }
    }

    /// The glyph dilated by `reach` pixels.
    fn seam(&self, reach: usize) -> Glyph {
        let rows: Vec<&[u8]> = self.coverage.chunks_exact(self.width.max(1)).collect();
        let widened: Vec<Vec<u8>> = rows.iter().map(|row| grown(row, reach)).collect();
        let width = self.width + 2 * reach;
        let columns: Vec<Vec<u8>> = (0..width)
            .map(|x| {
                let column: Vec<u8> = widened.iter().filter_map(|row| row.get(x).copied()).collect();
                grown(&column, reach)
            })
            .collect();
        let height = rows.len() + 2 * reach;
        let coverage =
            (0..height).flat_map(|y| columns.iter().filter_map(move |column| column.get(y).copied()));
        let reached = i64::try_from(reach).unwrap_or(i64::MAX);
        Glyph {
            left: self.left.saturating_sub(reached),
            top: self.top.saturating_sub(reached),
            width,
            coverage: coverage.collect(),
        }
    }
}

impl Stamp {
    fn new(glyph: &Glyph) -> Stamp {
        let channels = glyph.coverage.iter().flat_map(|&it| [it, it, it, 0]).collect();
        Stamp { left: glyph.left, top: glyph.top, width: glyph.width, channels }
    }

    /// Blends the letter in a colour into a picture, with the start of its baseline in a pixel.
    fn put(&self, pixmap: &mut Pixmap, [x, y]: [i64; 2], [red, green, blue]: [u8; 3]) {
        let width = pixmap.width() as usize;
        let (left, top) = (x.saturating_add(self.left), y.saturating_add(self.top));
        // What lies left of the picture is skipped.
        let (hidden, left) =
            (usize::try_from(left.saturating_neg()).unwrap_or(0), usize::try_from(left).unwrap_or(0));
        let shown = self.width.saturating_sub(hidden).min(width.saturating_sub(left));
        if shown == 0 {
            return;
        }
        let inks: [u8; LANES] = std::array::from_fn(|lane| [red, green, blue, 0][lane % 4]);
        let data = pixmap.data_mut();
        for (row, values) in (0_i64..).zip(self.channels.chunks_exact(4 * self.width.max(1))) {
            let Ok(row) = usize::try_from(top.saturating_add(row)) else { continue };
            let start = row.saturating_mul(width).saturating_add(left).saturating_mul(4);
            let Some(pixels) = data.get_mut(start..start.saturating_add(4 * shown)) else { return };
            // No test whether a pixel is covered: without branches the compiler blends many channels at once.
            let (pixels, last) = pixels.as_chunks_mut::<LANES>();
            let values = values.get(4 * hidden..4 * (hidden + shown)).unwrap_or_default();
            let (values, others) = values.as_chunks::<LANES>();
            for (pixels, values) in pixels.iter_mut().zip(values) {
                for lane in 0..LANES {
                    pixels[lane] = mix(pixels[lane], inks[lane], values[lane]);
                }
            }
            for ((pixel, ink), &value) in last.iter_mut().zip(inks).zip(others) {
                *pixel = mix(*pixel, ink, value);
            }
        }
    }
}

/// The running maximum within a reach; the result is longer by the reach on both sides.
fn grown(values: &[u8], reach: usize) -> Vec<u8> {
    let largest = |at: usize| {
        let near = values.get(at.saturating_sub(2 * reach)..values.len().min(at + 1));
        near.and_then(|near| near.iter().max()).copied().unwrap_or(0)
    };
    (0..values.len() + 2 * reach).map(largest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::TestRunner;

    /// Every letter drawn anew, pixel by pixel.
    fn slow(font: &Font, pixmap: &mut Pixmap, top: u32, line: &Letters, enlarged: f64) {
        let (size, seam) = (line.size * enlarged, (SEAM * enlarged).round() as usize);
        let (width, height) = (i64::from(pixmap.width()), i64::from(pixmap.height()));
        for (part, ink) in [[255; 3], line.ink].into_iter().enumerate() {
            for (index, ch) in line.text.chars().enumerate() {
                let glyph = Glyph::new(font, font.lookup_glyph_index(ch), size);
                let glyph = if part == 0 { glyph.seam(seam) } else { glyph };
                let pen = (line.at[0] * enlarged + index as f64 * LETTER_WIDTH * size).round() as i64;
                let base = (line.at[1] * enlarged).round() as i64 - i64::from(top);
                for (at, &coverage) in glyph.coverage.iter().enumerate() {
                    let x = pen + glyph.left + (at % glyph.width) as i64;
                    let y = base + glyph.top + (at / glyph.width) as i64;
                    if (0..width).contains(&x) && (0..height).contains(&y) {
                        let from = (4 * (y * width + x)) as usize;
                        for (channel, ink) in pixmap.data_mut()[from..from + 3].iter_mut().zip(ink) {
                            *channel = mix(*channel, ink, coverage);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn letters_have_the_pixels_of_those_drawn_anew() {
        // One font for all cases: reading it takes longer than drawing.
        let font = Glyphs::new().unwrap().font;
        let glyphs = std::cell::RefCell::new(Glyphs::new().unwrap());
        let text = ("[0-9a-zÁ-ű ]{0,6}", -20.0..90.0, -9.0..50.0, prop::sample::select(vec![9.0, 15.0]));
        let lines = prop::collection::vec(text, 1..4);
        let strategy = (lines, 0_u32..20, prop::sample::select(vec![0.7, 1.0, 2.0]));
        let compared = TestRunner::default().run(&strategy, |(lines, top, enlarged)| {
            let (mut ours, mut theirs) = (Pixmap::new(80, 40).unwrap(), Pixmap::new(80, 40).unwrap());
            ours.fill(tiny_skia::Color::from_rgba8(90, 200, 10, 255));
            theirs.fill(tiny_skia::Color::from_rgba8(90, 200, 10, 255));
            for (text, x, y, size) in lines {
                let line = Letters { text, at: [x, y], size, ink: [0, 30, 200] };
                glyphs.borrow_mut().write(&mut ours, top, &line, enlarged);
                slow(&font, &mut theirs, top, &line, enlarged);
            }
            prop_assert_eq!(ours.data(), theirs.data());
            Ok(())
        });
        compared.unwrap();
    }
}
