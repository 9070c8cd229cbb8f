//! A picture as PNG: lines and discs by tiny-skia, letters by fontdue.
//!
//! The picture is drawn in bands of rows that are encoded one after the other, so that even the largest one needs
//! only a few megabytes.

use super::FigureError;
use super::layout::{Layout, RULE};
use super::letters::Letters;
use super::picture::{Figure, Item, NOMINAL_WIDTH, Style, begins, check_width};
use super::raster_letters::Glyphs;
use crate::geometry::{Closure, CubicBezier, Point};
use std::io::Write;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, PremultipliedColorU8, Stroke,
    StrokeDash, Transform,
};

/// DejaVu Sans Mono; see `fonts/README.md`.
pub(super) static FONT: &[u8] = include_bytes!("fonts/DejaVuSansMono.ttf");

/// Pixels of a band.
const BAND: u32 = 1 << 22;

/// More discs than this are drawn to a quarter of a pixel.
const MANY_DISCS: usize = 10_000;

/// Arcs and straight lines that are drawn at once.
const LONG: usize = 4000;

impl Figure {
    /// The picture as a PNG of that many pixels' width, 8-bit red, green, blue, with smoothed edges on
    /// white. Everything is enlarged or reduced with the width. The same figure gives the same bytes.
    ///
    /// # Errors
    /// [`FigureError`] for a width outside of [`SMALLEST_WIDTH`] to [`LARGEST_WIDTH`], a coordinate that
    /// is not finite or too large, and sizes out of range.
    ///
    /// [`SMALLEST_WIDTH`]: super::SMALLEST_WIDTH
    /// [`LARGEST_WIDTH`]: super::LARGEST_WIDTH
    pub fn to_png(&self, width: u32) -> Result<Vec<u8>, FigureError> {
        check_width(width)?;
        self.check()?;
        let layout = Layout::new(self);
        let enlarged = f64::from(width) / f64::from(NOMINAL_WIDTH);
        // At most about ten thousand, so the cast keeps it.
        let height = (layout.height * enlarged).round().max(1.0) as u32;
        let mut glyphs = if layout.letters.is_empty() { None } else { Some(Glyphs::new()?) };
        let discs = self.items.iter().filter(|item| matches!(item, Item::Disc { .. })).count();
        let mut stamps = (discs > MANY_DISCS).then(Stamps::default);
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, width, height);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header()?;
        let mut stream = writer.stream_writer()?;
        let rows = (BAND / width).max(1);
        for top in (0..height).step_by(rows as usize) {
            let mut band = Band::new(&layout, enlarged, [width, rows.min(height - top)], top)?;
            band.draw_rules();
            self.items.iter().for_each(|item| band.draw(item, stamps.as_mut()));
            if let Some(glyphs) = &mut glyphs {
                layout.letters.iter().for_each(|line| band.write(line, glyphs));
            }
            let rgb: Vec<u8> =
                band.pixmap.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect();
            stream.write_all(&rgb).map_err(|error| FigureError::Encoding(error.to_string()))?;
        }
        stream.finish()?;
        writer.finish()?;
        Ok(file)
    }
}

/// Some rows of the picture.
struct Band<'a> {
    pixmap: Pixmap,
    layout: &'a Layout,
    enlarged: f64,
    top: u32,
}

impl<'a> Band<'a> {
    fn new(
        layout: &'a Layout,
        enlarged: f64,
        [width, rows]: [u32; 2],
        top: u32,
    ) -> Result<Band<'a>, FigureError> {
        let none = || FigureError::Encoding(format!("no memory for {width}x{rows} pixels"));
        let mut pixmap = Pixmap::new(width, rows).ok_or_else(none)?;
        pixmap.fill(Color::WHITE);
        Ok(Band { pixmap, layout, enlarged, top })
    }

    fn draw(&mut self, item: &Item, stamps: Option<&mut Stamps>) {
        match item {
            // Finding what is inside of a line takes the longer the more of it there is: long ones are drawn in pieces.
            Item::Curve { arcs, style, .. } if arcs.len() > LONG && style.fill.is_none() => {
                for arcs in arcs.chunks(LONG) {
                    self.paint(self.curve(arcs, Closure::Open), style);
                }
            }
            Item::Polyline { points, closure, style } if points.len() > LONG && style.fill.is_none() => {
                for start in (0..points.len()).step_by(LONG) {
                    let piece = points.get(start..=(start + LONG).min(points.len() - 1)).unwrap_or_default();
                    self.paint(self.polyline(piece, Closure::Open), style);
                }
                if let (Closure::Closed, [first, .., last]) = (closure, points.as_slice()) {
                    self.paint(self.polyline(&[*last, *first], Closure::Open), style);
                }
            }
            Item::Curve { arcs, closure, style } => self.paint(self.curve(arcs, *closure), style),
            Item::Polyline { points, closure, style } => self.paint(self.polyline(points, *closure), style),
            Item::Disc { at, radius, style, .. } => {
                let center = self.pixel(*at);
                match stamps {
                    Some(stamps) => stamps.put(&mut self.pixmap, center, *radius, style, self.enlarged),
                    None => paint_disc(&mut self.pixmap, center, *radius, style, self.enlarged),
                }
            }
            Item::Name { .. } | Item::Text { .. } => {}
        }
    }

    /// The lines of axes.
    fn draw_rules(&mut self) {
        let mut path = PathBuilder::new();
        for [from, to] in &self.layout.rules {
            let ([x, y], [end_x, end_y]) = (self.in_band(*from), self.in_band(*to));
            path.move_to(x, y);
            path.line_to(end_x, end_y);
        }
        self.paint(path.finish(), &RULE);
    }

    /// The place of a world point in the band, computed in doubles so that a small window far from the origin keeps
    /// its shape.
    fn pixel(&self, point: Point<2>) -> [f32; 2] {
        self.in_band(self.layout.place(point))
    }

    /// The place of a nominal pixel in the band.
    fn in_band(&self, nominal: Point<2>) -> [f32; 2] {
        let [x, y] = nominal.map(|value| value * self.enlarged);
        [x as f32, (y - f64::from(self.top)) as f32]
    }

    fn curve(&self, arcs: &[CubicBezier<2>], closure: Closure) -> Option<Path> {
        let mut path = PathBuilder::new();
        for (begin, arc) in begins(arcs) {
            let [[ax, ay], [bx, by], [cx, cy], [dx, dy]] = arc.p.map(|point| self.pixel(point));
            if begin {
                path.move_to(ax, ay);
            }
            path.cubic_to(bx, by, cx, cy, dx, dy);
        }
        close(path, closure)
    }

    fn polyline(&self, points: &[Point<2>], closure: Closure) -> Option<Path> {
        let mut path = PathBuilder::new();
        for (index, &point) in points.iter().enumerate() {
            let [x, y] = self.pixel(point);
            if index == 0 {
                path.move_to(x, y);
            } else {
                path.line_to(x, y);
            }
        }
        close(path, closure)
    }

    /// Fills and strokes a path; there is none for nothing.
    fn paint(&mut self, path: Option<Path>, style: &Style) {
        if let Some(path) = path {
            paint_path(&mut self.pixmap, &path, style, self.enlarged);
        }
    }

    /// Draws a line of text with a white halo, so that lines do not run through it.
    fn write(&mut self, line: &Letters, glyphs: &mut Glyphs) {
        let [_, y] = line.at.map(|value| value * self.enlarged);
        // No letter rises or descends by twice the font size.
        let reach = 2.0 * line.size * self.enlarged;
        let (top, bottom) = (f64::from(self.top), f64::from(self.top) + f64::from(self.pixmap.height()));
        if y + reach < top || y - reach > bottom {
            return;
        }
        glyphs.write(&mut self.pixmap, self.top, line, self.enlarged);
    }
}

/// Blends a channel of one colour over another.
pub(super) fn mix(below: u8, above: u8, coverage: u8) -> u8 {
    // The largest sum is 255 * 255 + 127; in sixteen bits many are computed at once.
    let (below, above, coverage) = (u16::from(below), u16::from(above), u16::from(coverage));
    // An average of two bytes fits into a byte.
    ((below * (255 - coverage) + above * coverage + 127) / 255) as u8
}

fn close(mut path: PathBuilder, closure: Closure) -> Option<Path> {
    if closure == Closure::Closed && !path.is_empty() {
        path.close();
    }
    path.finish()
}

/// Fills and strokes a path as a style says.
fn paint_path(pixmap: &mut Pixmap, path: &Path, style: &Style, enlarged: f64) {
    if let Some(fill) = style.fill {
        pixmap.fill_path(path, &paint(fill), FillRule::Winding, Transform::identity(), None);
    }
    let width = (style.width * enlarged) as f32;
    // A width of nothing would be a hair line.
    if let Some(stroke) = style.stroke.filter(|_| width > 0.0) {
        let dash = style.dash.map(|dash| dash.map(|length| (length * enlarged) as f32).to_vec());
        let stroke_of = Stroke {
            width,
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            dash: dash.and_then(|lengths| StrokeDash::new(lengths, 0.0)),
            ..Stroke::default()
        };
        pixmap.stroke_path(path, &paint(stroke), &stroke_of, Transform::identity(), None);
    }
}

fn paint_disc(pixmap: &mut Pixmap, [x, y]: [f32; 2], radius: f64, style: &Style, enlarged: f64) {
    if let Some(path) = PathBuilder::from_circle(x, y, (radius * enlarged) as f32) {
        paint_path(pixmap, &path, style, enlarged);
    }
}

/// Discs of very many points, each look of them drawn once for every place within a pixel, to a quarter of it.
#[derive(Default)]
struct Stamps(Vec<Stamp>);

/// A disc on nothing.
struct Stamp {
    radius: f64,
    style: Style,
    /// The part of a pixel, in quarters, by which the centre is off the middle.
    part: [i64; 2],
    /// From the upper left corner to the centre, in whole pixels.
    reach: i64,
    pixmap: Option<Pixmap>,
}

impl Stamps {
    /// Draws a disc.
    fn put(&mut self, pixmap: &mut Pixmap, center: [f32; 2], radius: f64, style: &Style, enlarged: f64) {
        let quarters = center.map(|value| (4.0 * value).round() as i64);
        let part = quarters.map(|value| value.rem_euclid(4));
        let is_it = |stamp: &Stamp| stamp.part == part && stamp.radius == radius && stamp.style == *style;
        let index = self.0.iter().position(is_it).unwrap_or_else(|| {
            self.0.push(Stamp::new(radius, *style, part, enlarged));
            self.0.len() - 1
        });
        if let Some(stamp) = self.0.get(index) {
            stamp.put(pixmap, quarters.map(|value| value.div_euclid(4)));
        }
    }
}

impl Stamp {
    fn new(radius: f64, style: Style, part: [i64; 2], enlarged: f64) -> Stamp {
        // Sizes are a hundred pixels at most, enlarged twenty times.
        let reach = ((radius + style.width) * enlarged).ceil() as i64 + 2;
        let side = u32::try_from(2 * reach + 1).unwrap_or(1);
        let mut pixmap = Pixmap::new(side, side);
        if let Some(pixmap) = &mut pixmap {
            let center = part.map(|part| reach as f32 + part as f32 / 4.0);
            paint_disc(pixmap, center, radius, &style, enlarged);
        }
        Stamp { radius, style, part, reach, pixmap }
    }

    /// Lays the disc over an opaque picture, with its centre in this pixel.
    fn put(&self, below: &mut Pixmap, [x, y]: [i64; 2]) {
        let Some(stamp) = &self.pixmap else { return };
        let (width, side) = (below.width() as usize, stamp.width() as usize);
        let [left, top] = [x, y].map(|value| value.saturating_sub(self.reach));
        let pixels = below.pixels_mut();
        for (row, colors) in stamp.pixels().chunks_exact(side).enumerate() {
            let Ok(row) = usize::try_from(top.saturating_add(row as i64)) else { continue };
            for (column, above) in colors.iter().enumerate().filter(|(_, color)| color.alpha() > 0) {
                let Ok(column) = usize::try_from(left.saturating_add(column as i64)) else { continue };
                let at = row.saturating_mul(width).saturating_add(column);
                let Some(pixel) = pixels.get_mut(at).filter(|_| column < width) else { continue };
                *pixel = laid_over(*pixel, *above);
            }
        }
    }
}

/// A colour over an opaque one.
fn laid_over(below: PremultipliedColorU8, above: PremultipliedColorU8) -> PremultipliedColorU8 {
    // What alpha leaves of the colour below; the one above already is its share.
    let channel = |below: u8, own: u8| own.saturating_add(mix(below, 0, above.alpha()));
    let [red, green, blue] = [
        channel(below.red(), above.red()),
        channel(below.green(), above.green()),
        channel(below.blue(), above.blue()),
    ];
    PremultipliedColorU8::from_rgba(red, green, blue, 255).unwrap_or(below)
}

fn paint([red, green, blue]: [u8; 3]) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(red, green, blue, 255);
    paint
}
