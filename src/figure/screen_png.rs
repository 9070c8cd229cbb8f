//! The screen of the programs as a PNG with its palette of 16 colours.

use super::FigureError;
use crate::screen::{Color, HEIGHT, Screen, WIDTH};

/// The screen as a PNG of 640x480 pixels: 4 bits a pixel, which are the colour numbers of the VGA,
/// and the palette of its 16 colours. The same screen gives the same bytes.
///
/// # Errors
/// [`FigureError::Encoding`] if the encoder refuses, which it does for no screen.
pub fn screen_png(screen: &Screen) -> Result<Vec<u8>, FigureError> {
    let palette: Vec<u8> = Color::ALL.iter().flat_map(|color| color.rgb()).collect();
    let (pairs, _) = screen.pixels().as_chunks::<2>();
    let packed: Vec<u8> = pairs.iter().map(|[left, right]| left << 4 | right).collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, WIDTH.unsigned_abs(), HEIGHT.unsigned_abs());
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Four);
    encoder.set_palette(palette);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&packed)?;
    writer.finish()?;
    Ok(file)
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
}
