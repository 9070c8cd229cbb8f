//! The screen as rectangles of one colour, in SVG and PDF, which stay sharp at any scale.

use super::pdf::{Page, shares};
use crate::screen::{Color, HEIGHT, Screen, WIDTH};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Points per pixel of the screen.
const POINTS: f64 = 0.75;

/// A rectangle: left, top, width, height.
type Rectangle = [usize; 4];

/// The screen as an SVG document of 640x480 pixels: a background of the most frequent colour, and for each other
/// colour a path of disjoint rectangles. The same screen gives the same text.
#[must_use]
pub fn screen_svg(screen: &Screen) -> String {
    let (ground, shapes) = shapes(screen);
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" shape-rendering=\"crispEdges\">"
    );
    let _ = writeln!(out, "<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"{}\"/>", hex(ground));
    for (color, rectangles) in shapes {
        let _ = write!(out, "<path fill=\"{}\" d=\"", hex(color));
        for [x, y, width, height] in rectangles {
            let _ = write!(out, "M{x} {y}h{width}v{height}h-{width}z");
        }
        let _ = writeln!(out, "\"/>");
    }
    let _ = writeln!(out, "</svg>");
    out
}

/// The screen as a PDF of one page of 480x360 points, with the same rectangles.
#[must_use]
pub fn screen_pdf(screen: &Screen) -> Vec<u8> {
    let (ground, shapes) = shapes(screen);
    let [width, height] = [WIDTH, HEIGHT].map(f64::from);
    let mut page = Page::new([width, height], POINTS);
    let whole = [0, 0, WIDTH.unsigned_abs() as usize, HEIGHT.unsigned_abs() as usize];
    let shapes = std::iter::once((ground, vec![whole])).chain(shapes);
    for (color, rectangles) in shapes {
        let [red, green, blue] = shares(Color::from_index(color).rgb());
        page.content.set_fill_rgb(red, green, blue);
        for rectangle in rectangles {
            let [x, y, width, height] = rectangle.map(|value| value as f32);
            page.content.rect(x, y, width, height);
        }
        page.content.fill_nonzero();
    }
    page.finish(None)
}

/// The most frequent colour, and the rectangles of each other colour by its number. A rectangle is a run of pixels
/// that repeats in the rows below.
fn shapes(screen: &Screen) -> (u8, BTreeMap<u8, Vec<Rectangle>>) {
    let mut counts = [0_usize; 16];
    for &pixel in screen.pixels() {
        if let Some(count) = counts.get_mut(usize::from(pixel)) {
            *count += 1;
        }
    }
    let ground = (0..16_u8).max_by_key(|&color| counts.get(usize::from(color)).copied()).unwrap_or(0);
    let mut shapes: BTreeMap<u8, Vec<Rectangle>> = BTreeMap::new();
    // Rectangles that the next row may continue: their index by left edge, width and colour.
    let mut open: BTreeMap<(usize, usize, u8), usize> = BTreeMap::new();
    for (y, row) in screen.pixels().chunks_exact(WIDTH.unsigned_abs() as usize).enumerate() {
        let mut going_on = BTreeMap::new();
        let mut x = 0;
        for run in row.chunk_by(|a, b| a == b) {
            let (width, color) = (run.len(), run.first().copied().unwrap_or(ground));
            if color != ground {
                let list = shapes.entry(color).or_default();
                let key = (x, width, color);
                let number = *open.get(&key).unwrap_or(&list.len());
                match list.get_mut(number) {
                    Some(rectangle) => rectangle[3] += 1,
                    None => list.push([x, y, width, 1]),
                }
                going_on.insert(key, number);
            }
            x += width;
        }
        open = going_on;
    }
    (ground, shapes)
}

fn hex(color: u8) -> String {
    let [red, green, blue] = Color::from_index(color).rgb();
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn screen() -> Screen {
        let mut screen = Screen::new();
        screen.clear(Color::LightCyan);
        for color in Color::ALL {
            let number = i32::from(color.index());
            screen.bar(number * 30, number * 20, number * 30 + 60, number * 20 + 90, color);
            screen.text(10, 20 * number, "Ő", color);
        }
        screen
    }

    #[test]
    fn rectangles_paint_the_screen_once() {
        let screen = screen();
        let (ground, shapes) = shapes(&screen);
        let mut painted: Vec<Option<u8>> = vec![None; screen.pixels().len()];
        for (color, [x, y, width, height]) in
            shapes.iter().flat_map(|(&color, list)| list.iter().map(move |&shape| (color, shape)))
        {
            for at in (y..y + height).flat_map(|row| (x..x + width).map(move |column| row * 640 + column)) {
                assert_eq!(painted[at].replace(color), None);
            }
        }
        let painted: Vec<u8> = painted.into_iter().map(|color| color.unwrap_or(ground)).collect();
        assert!(painted == screen.pixels());
        assert_eq!(ground, Color::LightCyan.index());
    }

    #[test]
    fn a_bar_is_one_rectangle() {
        let mut screen = Screen::new();
        screen.bar(10, 20, 109, 59, Color::Yellow);
        let svg = screen_svg(&screen);
        assert!(svg.contains("<path fill=\"#ffff55\" d=\"M10 20h100v40h-100z\"/>"), "{svg}");
        assert_eq!(svg.matches("<path").count(), 1);
        assert!(screen_pdf(&screen).starts_with(b"%PDF-"));
    }
}
