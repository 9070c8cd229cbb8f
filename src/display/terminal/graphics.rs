//! The picture as a terminal's own graphics: Kitty's protocol (a PNG of 16 colours in base 64) and Sixel.
//!
//! Sixel is written here because the picture has 16 known colours: an encoder for photographs would
//! first have to guess them again.

use super::place::Place;
use crate::screen::{Color, HEIGHT, Palette, Screen, WIDTH};
use base64::{Engine, engine::general_purpose::STANDARD};

/// The number of the picture among the terminal's images.
const IMAGE: u32 = 1997;

/// Most base 64 characters that Kitty's protocol takes at once.
const CHUNK: usize = 4096;

/// Deletes the picture from the terminal.
pub(super) fn kitty_delete() -> String {
    format!("\x1b_Ga=d,d=I,i={IMAGE},q=2\x1b\\")
}

/// Shows the picture at the cursor, in the place of the one shown before. The terminal gets 640x480 pixels and scales
/// them, more smoothly than picking pixels would.
///
/// # Errors
/// The message of the PNG encoder.
pub(super) fn kitty(picture: &Screen, palette: Palette, place: Place) -> Result<Vec<u8>, png::EncodingError> {
    let text = STANDARD.encode(png_of(picture.pixels(), palette)?);
    let columns = place.width / usize::from(place.cell.0.max(1));
    let rows = place.height / usize::from(place.cell.1.max(1));
    let mut control = format!("a=T,f=100,i={IMAGE},p=1,q=2,C=1,c={},r={}", columns.max(1), rows.max(1));
    let mut out = Vec::with_capacity(text.len() + 256);
    let mut chunks = text.as_bytes().chunks(CHUNK).peekable();
    while let Some(chunk) = chunks.next() {
        let more = u8::from(chunks.peek().is_some());
        out.extend_from_slice(format!("\x1b_G{control},m={more};").as_bytes());
        out.extend_from_slice(chunk);
        out.extend_from_slice(b"\x1b\\");
        control = "q=2".to_string();
    }
    Ok(out)
}

/// The colour numbers of the picture in another size.
pub(super) fn scaled(picture: &Screen, (width, height): (usize, usize)) -> Vec<u8> {
    let columns: Vec<usize> = (0..width).map(|x| x * WIDTH as usize / width.max(1)).collect();
    let mut pixels = Vec::with_capacity(width.saturating_mul(height));
    for y in 0..height {
        let source = y * HEIGHT as usize / height;
        let row = picture.pixels().chunks_exact(WIDTH as usize).nth(source).unwrap_or(&[]);
        pixels.extend(columns.iter().map(|&x| row.get(x).copied().unwrap_or_default()));
    }
    pixels
}

/// The picture as a PNG, as small as the encoder makes it: lines may be slow.
fn png_of(pixels: &[u8], palette: Palette) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Four);
    encoder.set_palette(Color::ALL.iter().flat_map(|color| palette.rgb(*color)).collect::<Vec<u8>>());
    encoder.set_compression(png::Compression::High);
    encoder.set_filter(png::Filter::NoFilter);
    // A row has an even number of pixels.
    let packed: Vec<u8> = pixels.chunks_exact(2).map(|pair| (pair[0] << 4) | pair[1]).collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&packed)?;
    writer.finish()?;
    Ok(bytes)
}

/// A rectangle of a scaled picture as a Sixel image, to be shown at the cursor.
pub(super) fn sixel(pixels: &[u8], palette: Palette, stride: usize, part: Part) -> Vec<u8> {
    let (width, height) = (part.right - part.left, part.bottom - part.top);
    let mut out = format!("\x1bP0;1;0q\"1;1;{width};{height}").into_bytes();
    for color in Color::ALL {
        let [red, green, blue] = palette.rgb(color).map(|level| (u32::from(level) * 100 + 127) / 255);
        out.extend_from_slice(format!("#{};2;{red};{green};{blue}", color.index()).as_bytes());
    }
    for top in (part.top..part.bottom).step_by(6) {
        if top > part.top {
            out.push(b'-');
        }
        let rows = (top..part.bottom.min(top + 6))
            .filter_map(|y| pixels.get(y * stride + part.left..y * stride + part.right));
        band(&rows.collect::<Vec<_>>(), width, &mut out);
    }
    out.extend_from_slice(b"\x1b\\");
    out
}

/// A rectangle of pixels; right and bottom do not belong to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Part {
    pub(super) left: usize,
    pub(super) top: usize,
    pub(super) right: usize,
    pub(super) bottom: usize,
}

/// Writes up to six rows of pixels: for every colour in them, the columns of its pixels.
fn band(rows: &[&[u8]], width: usize, out: &mut Vec<u8>) {
    let mut columns = vec![[0u8; 16]; width];
    let mut used = [false; 16];
    for (bit, row) in rows.iter().enumerate() {
        for (column, &index) in columns.iter_mut().zip(row.iter()) {
            let index = usize::from(index & 15);
            column[index] |= 1 << bit;
            used[index] = true;
        }
    }
    for (color, _) in used.iter().enumerate().filter(|(_, used)| **used) {
        out.extend_from_slice(format!("#{color}").as_bytes());
        let last = columns.iter().rposition(|column| column[color] != 0).map_or(0, |last| last + 1);
        for run in columns[..last].chunk_by(|a, b| a[color] == b[color]) {
            repeat(b'?' + run[0][color], run.len(), out);
        }
        out.push(b'$');
    }
}

fn repeat(sixel: u8, count: usize, out: &mut Vec<u8>) {
    if count > 3 {
        out.extend_from_slice(format!("!{count}").as_bytes());
        out.push(sixel);
    } else {
        out.extend(std::iter::repeat_n(sixel, count));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture() -> Screen {
        let mut picture = Screen::new();
        for (number, color) in (0..).zip(Color::ALL) {
            picture.bar(number * 40, 10, number * 40 + 39, 300, color);
        }
        picture.line(0, 479, 639, 0, crate::screen::Stroke::thin(Color::White));
        picture.text(100, 400, "Sixel", Color::Yellow);
        picture
    }

    #[test]
    fn sixel_decodes_to_the_same_pixels() {
        for (size, part) in [
            ((640, 480), Part { left: 0, top: 0, right: 640, bottom: 480 }),
            ((1280, 960), Part { left: 200, top: 32, right: 500, bottom: 128 }),
            ((490, 368), Part { left: 0, top: 0, right: 490, bottom: 368 }),
        ] {
            let pixels = scaled(&picture(), size);
            let decoded = icy_sixel::SixelImage::decode(&sixel(&pixels, Palette::Vga, size.0, part)).unwrap();
            // The decoder counts whole bands.
            let bands = (part.bottom - part.top).next_multiple_of(6);
            assert_eq!((decoded.width, decoded.height), (part.right - part.left, bands));
            for y in part.top..part.bottom {
                for x in part.left..part.right {
                    let expected = Color::from_index(pixels[y * size.0 + x]).rgb();
                    let at = ((y - part.top) * decoded.width + x - part.left) * 4;
                    let close = (0..3).all(|i| expected[i].abs_diff(decoded.pixels[at + i]) <= 2);
                    assert!(close, "{x} {y}: {expected:?} {:?}", &decoded.pixels[at..at + 4]);
                }
            }
        }
    }

    #[test]
    fn kitty_sends_a_png_of_the_same_pixels_in_chunks() {
        let place = Place { column: 0, row: 0, width: 1280, height: 960, cell: (10, 20) };
        let sent = String::from_utf8(kitty(&picture(), Palette::Vga, place).unwrap()).unwrap();
        let mut text = String::new();
        for message in sent.split("\x1b_G").skip(1) {
            let (_, data) = message.strip_suffix("\x1b\\").unwrap().split_once(';').unwrap();
            assert!(data.len() <= CHUNK);
            text.push_str(data);
        }
        let bytes = STANDARD.decode(text).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut packed = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut packed).unwrap();
        let unpacked: Vec<u8> = packed.iter().flat_map(|&pair| [pair >> 4, pair & 15]).collect();
        assert!(unpacked == picture().pixels());
        assert!(sent.contains(",c=128,r=48"), "{}", &sent[..80]);
    }
}
