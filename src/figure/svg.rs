//! A picture as SVG. Curves keep the numbers of their control points, in a group whose transform maps world
//! coordinates to the picture. Discs and text are outside that group, in nominal pixels.

use super::FigureError;
use super::layout::{Layout, RULE};
use super::letters::Letters;
use super::number::Number;
use super::picture::{Figure, Item, NOMINAL_WIDTH, Style, begins, check_width};
use crate::geometry::{Closure, CubicBezier, Point};
use std::fmt::{self, Write};

impl Figure {
    /// The picture as an SVG document, [`NOMINAL_WIDTH`] pixels wide.
    ///
    /// Every curve is one `path` of absolute `M` and `C` commands in world coordinates. Its numbers read back as the
    /// doubles of the control points. A closed curve ends with `Z`.
    ///
    /// # Errors
    /// [`FigureError`] for a coordinate that is not finite or too large, and for sizes out of range.
    pub fn to_svg(&self) -> Result<String, FigureError> {
        self.to_svg_of_width(NOMINAL_WIDTH)
    }

    /// The picture as an SVG document with another `width`, [`SMALLEST_WIDTH`] to [`LARGEST_WIDTH`] pixels.
    /// Everything is scaled with it.
    ///
    /// [`SMALLEST_WIDTH`]: super::SMALLEST_WIDTH
    /// [`LARGEST_WIDTH`]: super::LARGEST_WIDTH
    ///
    /// # Errors
    /// Those of [`Figure::to_svg`], and a width out of range.
    pub fn to_svg_of_width(&self, width: u32) -> Result<String, FigureError> {
        check_width(width)?;
        self.check()?;
        let layout = Layout::new(self);
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = self.write_svg(&mut text, &layout, width);
        Ok(text)
    }

    fn write_svg(&self, out: &mut String, layout: &Layout, width: u32) -> fmt::Result {
        let enlarged = f64::from(width) / f64::from(NOMINAL_WIDTH);
        let (height, scale, [x, y]) = (layout.height, Number(layout.scale), layout.origin);
        writeln!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{}\" viewBox=\"0 0 {NOMINAL_WIDTH} {height}\">",
            Number((height * enlarged).round())
        )?;
        if let Some(title) = &self.title {
            writeln!(out, "<title>{}</title>", Escaped(&super::layout::printable(title)))?;
        }
        writeln!(out, "<rect width=\"{NOMINAL_WIDTH}\" height=\"{height}\" fill=\"#ffffff\"/>")?;
        write_rules(out, &layout.rules)?;
        let world = format!("<g transform=\"matrix({scale} 0 0 -{scale} {} {})\">", Number(x), Number(y));
        let mut in_world = false;
        for item in &self.items {
            let belongs = matches!(item, Item::Curve { .. } | Item::Polyline { .. });
            if belongs != in_world {
                writeln!(out, "{}", if belongs { &world } else { "</g>" })?;
                in_world = belongs;
            }
            write_item(out, item, layout)?;
        }
        if in_world {
            writeln!(out, "</g>")?;
        }
        write_letters(out, &layout.letters)?;
        writeln!(out, "</svg>")
    }
}

/// The lines of axes, in one path.
fn write_rules(out: &mut String, rules: &[[Point<2>; 2]]) -> fmt::Result {
    if rules.is_empty() {
        return Ok(());
    }
    let mut data = String::new();
    for &[from, to] in rules {
        command(&mut data, "M", &[from]);
        command(&mut data, "L", &[to]);
    }
    write!(out, "<path class=\"axes\" d=\"{data}\"")?;
    write_style(out, &RULE, 1.0)?;
    writeln!(out, "/>")
}

fn write_item(out: &mut String, item: &Item, layout: &Layout) -> fmt::Result {
    match item {
        Item::Curve { arcs, closure, style } => {
            write_path(out, &curve_data(arcs, *closure), style, layout.scale)
        }
        Item::Polyline { points, closure, style } => {
            write_path(out, &polyline_data(points, *closure), style, layout.scale)
        }
        Item::Disc { at, radius, style, .. } => {
            let [x, y] = layout.place(*at);
            write!(out, "<circle cx=\"{}\" cy=\"{}\" r=\"{}\"", Number(x), Number(y), Number(*radius))?;
            write_style(out, style, 1.0)?;
            writeln!(out, "/>")
        }
        Item::Name { .. } | Item::Text { .. } => Ok(()),
    }
}

/// A path in world coordinates; omitted if it has no points.
fn write_path(out: &mut String, data: &str, style: &Style, scale: f64) -> fmt::Result {
    if data.is_empty() {
        return Ok(());
    }
    write!(out, "<path d=\"{data}\"")?;
    // The transform of the group scales line widths too. The attribute vector-effect would prevent that, but
    // several readers do not support it.
    write_style(out, style, 1.0 / scale)?;
    writeln!(out, "/>")
}

fn curve_data(arcs: &[CubicBezier<2>], closure: Closure) -> String {
    let mut data = String::new();
    for (begin, CubicBezier { p: [a, b, c, d] }) in begins(arcs) {
        if begin {
            command(&mut data, "M", &[*a]);
        }
        command(&mut data, "C", &[*b, *c, *d]);
    }
    close(data, closure)
}

fn polyline_data(points: &[Point<2>], closure: Closure) -> String {
    let mut data = String::new();
    for (index, point) in points.iter().enumerate() {
        command(&mut data, if index == 0 { "M" } else { "L" }, &[*point]);
    }
    close(data, closure)
}

fn close(mut data: String, closure: Closure) -> String {
    if closure == Closure::Closed && !data.is_empty() {
        data.push_str(" Z");
    }
    data
}

/// Appends a command with its points.
fn command(data: &mut String, letter: &str, points: &[Point<2>]) {
    if !data.is_empty() {
        data.push(' ');
    }
    data.push_str(letter);
    for (index, [x, y]) in points.iter().enumerate() {
        let gap = if index == 0 { "" } else { " " };
        let _ = write!(data, "{gap}{} {}", Number(*x), Number(*y));
    }
}

/// The attributes of a style; `pixel` is the size of a nominal pixel in the units of the path.
fn write_style(out: &mut String, style: &Style, pixel: f64) -> fmt::Result {
    write!(out, " fill=\"{}\"", Paint(style.fill))?;
    let Some(stroke) = style.stroke else { return Ok(()) };
    write!(out, " stroke=\"{}\" stroke-width=\"{}\"", Paint(Some(stroke)), Number(style.width * pixel))?;
    write!(out, " stroke-linejoin=\"round\" stroke-linecap=\"round\"")?;
    if let Some([dash, gap]) = style.dash {
        write!(out, " stroke-dasharray=\"{} {}\"", Number(dash * pixel), Number(gap * pixel))?;
    }
    Ok(())
}

/// Text with a white halo, so that lines do not run through it.
fn write_letters(out: &mut String, letters: &[Letters]) -> fmt::Result {
    if letters.is_empty() {
        return Ok(());
    }
    writeln!(
        out,
        "<g font-family=\"'DejaVu Sans Mono', Menlo, Consolas, monospace\" fill=\"#000000\" stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\">"
    )?;
    for Letters { text, at: [x, y], size, ink } in letters {
        let (x, y, size) = (Number(*x), Number(*y), Number(*size));
        let text = Escaped(text);
        write!(out, "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\"")?;
        if *ink != [0; 3] {
            write!(out, " fill=\"{}\"", Paint(Some(*ink)))?;
        }
        writeln!(out, " xml:space=\"preserve\">{text}</text>")?;
    }
    writeln!(out, "</g>")
}

/// A colour or `none`.
struct Paint(Option<[u8; 3]>);

impl fmt::Display for Paint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some([red, green, blue]) => write!(f, "#{red:02x}{green:02x}{blue:02x}"),
            None => f.write_str("none"),
        }
    }
}

/// Escapes text for XML.
struct Escaped<'a>(&'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|ch| match ch {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            other => f.write_char(other),
        })
    }
}
