//! A picture as a PDF of one page. Curves are cubic Bézier curves. Text is drawn as outlines, so that the page looks
//! the same everywhere and needs no font. Numbers have single precision, as usual in PDF.
//!
//! What is there many times, a letter or a disc, is written once, as a form, and placed where it belongs.

use super::FigureError;
use super::layout::{Layout, RULE};
use super::letters::{LETTER_WIDTH, Letters};
use super::pdf_forms::{Forms, OFTEN};
use super::picture::{Figure, Item, NOMINAL_WIDTH, Style, begins, check_width};
use super::raster::FONT;
use crate::geometry::{Closure, CubicBezier, Point};
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, TextStr};
use std::collections::HashMap;
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Points per pixel: 96 pixels are an inch, as in SVG.
const POINTS: f64 = 0.75;
/// Effort of the compression, 0 to 10.
const LEVEL: u8 = 6;
/// The distance of a quarter circle's inner control points from its ends, relative to the radius.
const KAPPA: f64 = 0.552_284_749_830_793_4;
/// Stroke width of the white halo around letters in nominal pixels; half of it lies outside the outline.
const SEAM: f32 = 3.0;

impl Figure {
    /// The picture as a PDF of one page, [`NOMINAL_WIDTH`] pixels of 0.75 points wide. The same figure gives the
    /// same bytes.
    ///
    /// # Errors
    /// [`FigureError`] for a coordinate that is not finite or too large, and for sizes out of range.
    pub fn to_pdf(&self) -> Result<Vec<u8>, FigureError> {
        self.to_pdf_of_width(NOMINAL_WIDTH)
    }

    /// The picture as a PDF whose page has another width: [`SMALLEST_WIDTH`] to [`LARGEST_WIDTH`] pixels of 0.75
    /// points. Everything is scaled with it.
    ///
    /// [`SMALLEST_WIDTH`]: super::SMALLEST_WIDTH
    /// [`LARGEST_WIDTH`]: super::LARGEST_WIDTH
    ///
    /// # Errors
    /// Those of [`Figure::to_pdf`], and a width out of range.
    pub fn to_pdf_of_width(&self, width: u32) -> Result<Vec<u8>, FigureError> {
        check_width(width)?;
        self.check()?;
        let layout = Layout::new(self);
        let enlarged = f64::from(width) / f64::from(NOMINAL_WIDTH);
        let mut page = Page::new([f64::from(NOMINAL_WIDTH), layout.height], POINTS * enlarged);
        page.content.set_line_cap(LineCapStyle::RoundCap).set_line_join(LineJoinStyle::RoundJoin);
        page.rules(&layout.rules);
        let mut discs = Discs::of(&self.items);
        self.items.iter().for_each(|item| page.draw(item, &layout, &mut discs));
        page.letters(&layout.letters)?;
        Ok(page.finish(self.title.as_deref()))
    }
}

/// A page being drawn, in pixels from its upper left corner.
pub(super) struct Page {
    pub(super) content: Content,
    /// Width and height in points.
    size: [f32; 2],
    forms: Forms,
}

/// A style as numbers that tell whether another one is the same.
type Look = (u64, Option<[u8; 3]>, Option<[u8; 3]>, u64, Option<[u64; 2]>);

/// How often discs of each look are there, and the numbers of the forms of those that are there often.
struct Discs(HashMap<Look, (usize, Option<usize>)>);

impl Discs {
    fn look(radius: f64, style: &Style) -> Look {
        let dash = style.dash.map(|dash| dash.map(f64::to_bits));
        (radius.to_bits(), style.fill, style.stroke, style.width.to_bits(), dash)
    }

    fn of(items: &[Item]) -> Discs {
        let mut discs: HashMap<Look, (usize, Option<usize>)> = HashMap::new();
        for item in items {
            if let Item::Disc { radius, style, .. } = item {
                discs.entry(Self::look(*radius, style)).or_default().0 += 1;
            }
        }
        Discs(discs)
    }
}

impl Page {
    /// A white page of a size in pixels; one of them measures so many points.
    pub(super) fn new([width, height]: [f64; 2], pixel: f64) -> Page {
        let mut content = Content::new();
        let (scale, up) = (pixel as f32, (height * pixel) as f32);
        content.transform([scale, 0.0, 0.0, -scale, 0.0, up]);
        Page { content, size: [(width * pixel) as f32, up], forms: Forms::default() }
    }

    /// The page as a document.
    pub(super) fn finish(self, title: Option<&str>) -> Vec<u8> {
        let [catalog, pages, page, content, info] = [1, 2, 3, 4, 5].map(Ref::new);
        // There are two for a letter of the font at most, and a few for discs.
        let first = if title.is_some() { 6_i32 } else { 5 };
        let form = |number: usize| Ref::new(first.saturating_add_unsigned(number as u32));
        let packed = miniz_oxide::deflate::compress_to_vec_zlib(&self.content.finish().into_vec(), LEVEL);
        let mut pdf = Pdf::new();
        pdf.catalog(catalog).pages(pages);
        pdf.pages(pages).kids([page]).count(1);
        let mut sheet = pdf.page(page);
        sheet.parent(pages).media_box(Rect::new(0.0, 0.0, self.size[0], self.size[1])).contents(content);
        let mut resources = sheet.resources();
        if !self.forms.is_empty() {
            let mut objects = resources.x_objects();
            for (name, number) in self.forms.names() {
                objects.pair(Name(name.as_bytes()), form(number));
            }
        }
        resources.finish();
        sheet.finish();
        pdf.stream(content, &packed).filter(Filter::FlateDecode);
        self.forms.write(&mut pdf, LEVEL, form);
        if let Some(title) = title {
            pdf.document_info(info).title(TextStr(&super::layout::printable(title)));
        }
        pdf.finish()
    }

    fn draw(&mut self, item: &Item, layout: &Layout, discs: &mut Discs) {
        let (any, style) = match item {
            Item::Curve { arcs, closure, style } => (self.curve(arcs, *closure, layout), style),
            Item::Polyline { points, closure, style } => (self.polyline(points, *closure, layout), style),
            Item::Disc { at, radius, style, .. } => {
                let place = layout.place(*at);
                match discs.0.get_mut(&Discs::look(*radius, style)) {
                    Some((count, known)) if *count >= OFTEN => {
                        let number = *known.get_or_insert_with(|| self.disc_form(*radius, style));
                        return self.put(&[(number, place)]);
                    }
                    _ => (self.circle(place, *radius), style),
                }
            }
            Item::Name { .. } | Item::Text { .. } => return,
        };
        if any {
            self.paint(style);
        }
    }

    /// Makes a form of what is drawn around the origin, no farther than `reach` from it.
    fn form(&mut self, reach: f64, draw: impl FnOnce(&mut Page)) -> usize {
        let outer = std::mem::replace(&mut self.content, Content::new());
        draw(self);
        let drawn = std::mem::replace(&mut self.content, outer);
        self.forms.add(reach as f32, drawn.finish().into_vec())
    }

    fn disc_form(&mut self, radius: f64, style: &Style) -> usize {
        self.form(radius + style.width + 1.0, |page| {
            page.circle([0.0; 2], radius);
            page.paint(style);
        })
    }

    /// Draws forms with their origins at these places.
    fn put(&mut self, forms: &[(usize, Point<2>)]) {
        if forms.is_empty() {
            return;
        }
        self.content.save_state();
        let mut last = [0.0; 2];
        for &(number, place) in forms {
            // From the last one on: steps from letter to letter are short numbers, and always the same.
            let here = place.map(thousandths);
            let step: Point<2> = std::array::from_fn(|d| thousandths(here[d] - last[d]));
            last = here;
            self.content.transform([1.0, 0.0, 0.0, 1.0, step[0] as f32, step[1] as f32]);
            self.content.x_object(Name(self.forms.name(number).as_bytes()));
        }
        self.content.restore_state();
    }

    /// The lines of axes.
    fn rules(&mut self, rules: &[[Point<2>; 2]]) {
        for &[from, to] in rules {
            self.move_to(from);
            self.line_to(to);
        }
        if !rules.is_empty() {
            self.paint(&RULE);
        }
    }

    fn move_to(&mut self, [x, y]: Point<2>) {
        self.content.move_to(x as f32, y as f32);
    }

    fn line_to(&mut self, [x, y]: Point<2>) {
        self.content.line_to(x as f32, y as f32);
    }

    fn cubic_to(&mut self, points: [Point<2>; 3]) {
        let [[ax, ay], [bx, by], [cx, cy]] = points.map(|point| point.map(|value| value as f32));
        self.content.cubic_to(ax, ay, bx, by, cx, cy);
    }

    /// Adds a curve to the path; returns whether it has any points.
    fn curve(&mut self, arcs: &[CubicBezier<2>], closure: Closure, layout: &Layout) -> bool {
        for (begin, arc) in begins(arcs) {
            let [a, b, c, d] = arc.p.map(|point| layout.place(point));
            if begin {
                self.move_to(a);
            }
            self.cubic_to([b, c, d]);
        }
        self.close(closure, !arcs.is_empty())
    }

    fn polyline(&mut self, points: &[Point<2>], closure: Closure, layout: &Layout) -> bool {
        for (index, &point) in points.iter().enumerate() {
            match index {
                0 => self.move_to(layout.place(point)),
                _ => self.line_to(layout.place(point)),
            }
        }
        self.close(closure, !points.is_empty())
    }

    fn close(&mut self, closure: Closure, any: bool) -> bool {
        if any && closure == Closure::Closed {
            self.content.close_path();
        }
        any
    }

    /// A circle of four arcs.
    fn circle(&mut self, [x, y]: Point<2>, radius: f64) -> bool {
        let on = |[c, s]: [f64; 2]| [x + radius * c, y + radius * s];
        let mut way = [1.0, 0.0];
        self.move_to(on(way));
        for _ in 0..4 {
            let next = [-way[1], way[0]];
            let inner = |a: [f64; 2], b: [f64; 2]| on([a[0] + KAPPA * b[0], a[1] + KAPPA * b[1]]);
            self.cubic_to([inner(way, next), inner(next, way), on(next)]);
            way = next;
        }
        self.content.close_path();
        true
    }

    /// Fills and strokes the path.
    fn paint(&mut self, style: &Style) {
        // In PDF, a line of width 0 is the thinnest line of the device.
        let stroke = style.stroke.filter(|_| style.width > 0.0);
        if let Some([red, green, blue]) = style.fill.map(shares) {
            self.content.set_fill_rgb(red, green, blue);
        }
        if let Some([red, green, blue]) = stroke.map(shares) {
            self.content.set_stroke_rgb(red, green, blue).set_line_width(style.width as f32);
            let dash = style.dash.map(|dash| dash.map(|length| length as f32));
            self.content.set_dash_pattern(dash.iter().flatten().copied(), 0.0);
        }
        match (style.fill, stroke) {
            (Some(_), Some(_)) => self.content.fill_nonzero_and_stroke(),
            (Some(_), None) => self.content.fill_nonzero(),
            (None, Some(_)) => self.content.stroke(),
            (None, None) => self.content.end_path(),
        };
    }

    /// Letters with a white halo, so that lines do not run through them.
    fn letters(&mut self, letters: &[Letters]) -> Result<(), FigureError> {
        if letters.is_empty() {
            return Ok(());
        }
        let face = Face::parse(FONT, 0).map_err(|error| FigureError::Encoding(error.to_string()))?;
        self.content.set_stroke_gray(1.0).set_line_width(SEAM);
        self.content.set_dash_pattern([], 0.0);
        let mut counts: HashMap<Written, usize> = HashMap::new();
        for written in letters.iter().flat_map(|line| placed(line, &face)) {
            *counts.entry(written.0).or_default() += 1;
        }
        // The forms of the halo and of the letter.
        let mut known: HashMap<Written, [usize; 2]> = HashMap::new();
        for line in letters {
            let (mut forms, mut others) = ([Vec::new(), Vec::new()], Vec::new());
            for (written, at) in placed(line, &face) {
                if counts.get(&written).is_none_or(|&count| count < OFTEN) {
                    others.push((written, at));
                    continue;
                }
                let both = *known.entry(written).or_insert_with(|| {
                    // No letter rises or descends by twice the font size.
                    [false, true].map(|filled| {
                        self.form(2.0 * line.size + f64::from(SEAM), |page| {
                            page.outlines(&[(written, [0.0; 2])], line.size, &face);
                            if filled {
                                page.content.fill_nonzero()
                            } else {
                                page.content.stroke()
                            };
                        })
                    })
                });
                forms.iter_mut().zip(both).for_each(|(forms, number)| forms.push((number, at)));
            }
            // All halos come first: none may cover the letter before it.
            let [halos, inks] = forms;
            self.put(&halos);
            if !others.is_empty() {
                self.outlines(&others, line.size, &face);
                self.content.stroke();
                self.outlines(&others, line.size, &face);
            }
            let [red, green, blue] = shares(line.ink);
            // A colour cannot be set within a path.
            match others.is_empty() {
                true => {
                    self.content.set_fill_rgb(red, green, blue);
                }
                false => {
                    self.content.set_fill_rgb(red, green, blue).fill_nonzero();
                }
            }
            self.put(&inks);
        }
        Ok(())
    }

    fn outlines(&mut self, letters: &[(Written, Point<2>)], size: f64, face: &Face<'_>) {
        let scale = size / f64::from(face.units_per_em());
        for &((glyph, _), origin) in letters {
            // A blank has no outline.
            face.outline_glyph(GlyphId(glyph), &mut Pen { page: self, origin, scale, at: origin });
        }
    }
}

/// A letter by its number in the font, and the bits of its size.
type Written = (u16, u64);

/// The letters of a line that have outlines, with the starts of their baselines.
fn placed<'a>(line: &'a Letters, face: &'a Face<'_>) -> impl Iterator<Item = (Written, Point<2>)> + 'a {
    let advance = LETTER_WIDTH * line.size;
    let letters = line.text.chars().enumerate();
    letters.filter(|(_, ch)| *ch != ' ').map(move |(index, ch)| {
        let glyph = face.glyph_index(ch).unwrap_or(GlyphId(0));
        ((glyph.0, line.size.to_bits()), [line.at[0] + index as f64 * advance, line.at[1]])
    })
}

/// A thousandth of a pixel is precise enough for letters, and halves the file.
fn thousandths(value: f64) -> f64 {
    (1000.0 * value).round() / 1000.0
}

/// A colour in components from 0 to 1.
pub(super) fn shares(color: [u8; 3]) -> [f32; 3] {
    color.map(|channel| f32::from(channel) / 255.0)
}

/// Draws the outline of a letter.
struct Pen<'p> {
    page: &'p mut Page,
    /// Start of the letter's baseline.
    origin: Point<2>,
    scale: f64,
    at: Point<2>,
}

impl Pen<'_> {
    fn place(&self, x: f32, y: f32) -> Point<2> {
        let place = [self.origin[0] + self.scale * f64::from(x), self.origin[1] - self.scale * f64::from(y)];
        place.map(thousandths)
    }
}

impl OutlineBuilder for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.at = self.place(x, y);
        self.page.move_to(self.at);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.at = self.place(x, y);
        self.page.line_to(self.at);
    }

    fn quad_to(&mut self, bx: f32, by: f32, x: f32, y: f32) {
        let (from, middle, to) = (self.at, self.place(bx, by), self.place(x, y));
        // Raises the degree: the inner points lie two thirds of the way to the quadratic's control point.
        let inner = |end: Point<2>| std::array::from_fn(|d| end[d] + 2.0 / 3.0 * (middle[d] - end[d]));
        self.page.cubic_to([inner(from), inner(to), to]);
        self.at = to;
    }

    fn curve_to(&mut self, bx: f32, by: f32, cx: f32, cy: f32, x: f32, y: f32) {
        self.at = self.place(x, y);
        self.page.cubic_to([self.place(bx, by), self.place(cx, cy), self.at]);
    }

    fn close(&mut self) {
        self.page.content.close_path();
    }
}
