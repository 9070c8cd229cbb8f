//! The screen of the programs as a PNG with its palette of 16 colours.

use super::FigureError;
use crate::screen::{Color, HEIGHT, Screen, WIDTH};

/// Compression level, 1 to 9; higher ones take longer and gain little.
const LEVEL: u8 = 3;

/// The screen as a PNG of 640x480 pixels with 4 bits per pixel, the colour numbers of the VGA, and the palette of
/// its 16 colours. The same screen gives the same bytes.
///
/// # Errors
/// [`FigureError::Encoding`] if the encoder fails; no screen is known to make it fail.
pub fn screen_png(screen: &Screen) -> Result<Vec<u8>, FigureError> {
    screen_png_of_scale(screen, 1)
}

/// The largest scale of [`screen_png_of_scale`].
pub const LARGEST_SCALE: u32 = 16;

/// The screen as a PNG in which each pixel is a square of `scale` times `scale` pixels. The scale is clamped to 1 to
/// [`LARGEST_SCALE`].
///
/// # Errors
/// [`FigureError::Encoding`] if the encoder fails; no screen is known to make it fail.
pub fn screen_png_of_scale(screen: &Screen, scale: u32) -> Result<Vec<u8>, FigureError> {
    let scale = scale.clamp(1, LARGEST_SCALE);
    let (width, height) = (WIDTH.unsigned_abs(), HEIGHT.unsigned_abs());
    let palette: Vec<u8> = Color::ALL.iter().flat_map(|color| color.rgb()).collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width * scale, height * scale);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Four);
    encoder.set_palette(palette);
    // Differences of colour numbers mean nothing, so filters do not help: without them the file is half as large and
    // sooner written.
    encoder.set_filter(png::Filter::NoFilter);
    encoder.set_deflate_compression(png::DeflateCompression::Level(LEVEL));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&packed(screen, scale as usize))?;
    writer.finish()?;
    Ok(file)
}

/// The enlarged pixels, two per byte; rows have an even number of pixels.
fn packed(screen: &Screen, scale: usize) -> Vec<u8> {
    let mut packed = Vec::with_capacity(screen.pixels().len() * scale * scale / 2);
    for row in screen.pixels().chunks_exact(WIDTH.unsigned_abs() as usize) {
        let wide: Vec<u8> = row.iter().flat_map(|&pixel| std::iter::repeat_n(pixel, scale)).collect();
        let (pairs, _) = wide.as_chunks::<2>();
        let bytes: Vec<u8> = pairs.iter().map(|[left, right]| left << 4 | right).collect();
        (0..scale).for_each(|_| packed.extend_from_slice(&bytes));
    }
    packed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_colour_numbers_with_the_palette() {
        let mut screen = Screen::new();
        for color in Color::ALL {
            let number = i32::from(color.index());
            screen.bar(number * 3, number, 600, 479 - number, color);
        }
        let file = screen_png(&screen).unwrap();
        let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
        decoder.set_transformations(png::Transformations::IDENTITY);
        let mut reader = decoder.read_info().unwrap();
        let palette = reader.info().palette.clone().unwrap();
        assert_eq!(palette.as_ref(), Color::ALL.map(Color::rgb).concat());
        let mut rows = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut rows).unwrap();
        assert_eq!((info.width, info.height, info.bit_depth), (640, 480, png::BitDepth::Four));
        let pixels: Vec<u8> = rows.iter().flat_map(|pair| [pair >> 4, pair & 15]).collect();
        assert_eq!(pixels, screen.pixels());
    }

    #[test]
    fn larger_pixels_are_squares_of_the_same_colour() {
        let mut screen = Screen::new();
        screen.text(3, 5, "Ő", Color::Yellow);
        screen.bar(639, 479, 639, 479, Color::Red);
        let wide = packed(&screen, 3);
        for (index, byte) in wide.iter().enumerate() {
            for (half, pixel) in [byte >> 4, byte & 15].into_iter().enumerate() {
                let (x, y) = ((2 * index + half) % 1920, (2 * index + half) / 1920);
                assert_eq!(pixel, screen.pixels()[y / 3 * 640 + x / 3]);
            }
        }
        assert_eq!(screen_png_of_scale(&screen, 0), screen_png(&screen));
    }
}
