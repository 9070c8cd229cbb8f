//! `grafika render`: a picture of a curve as PNG or SVG.

use crate::curve::{CurveArgs, Curved};
use crate::sample::extension;
use clap::Args;
use grafika::figure::{Figure, LARGEST_WIDTH, NOMINAL_WIDTH, SMALLEST_WIDTH, Style};
use grafika::geometry::{BoundingBox, Closure, CubicBezier, Curve, Point};
use grafika::launch::{Failure, write_output};
use std::path::PathBuf;

/// Greatest distance of a picture's arcs from the curve, by the size of the curve: far below a
/// thousandth of a pixel in a picture 800 pixels wide.
const TOLERANCE: f64 = 1e-7;
/// The same by the largest coordinate; doubles keep no less.
const LEAST_TOLERANCE: f64 = 1e-11;

const CURVE: [u8; 3] = [0, 0, 170];
const POLYGON: [u8; 3] = [130, 130, 130];
const POINT: [u8; 3] = [255, 255, 255];
const EDGE: [u8; 3] = [170, 0, 0];

/// The command line of `grafika render`.
#[derive(Args)]
pub(crate) struct Render {
    #[command(flatten)]
    curve: CurveArgs,
    /// Where to write; .png or .svg
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Width of the picture in pixels
    #[arg(long, value_name = "N", default_value_t = NOMINAL_WIDTH,
        value_parser = clap::value_parser!(u32).range(i64::from(SMALLEST_WIDTH)..=i64::from(LARGEST_WIDTH)))]
    width: u32,
    /// Show the control points with their numbers
    #[arg(long)]
    points: bool,
    /// Show the control polygon
    #[arg(long)]
    polygon: bool,
    /// Title above the picture
    #[arg(long)]
    title: Option<String>,
    /// Direction from which a space curve is seen [default: 0.7,0.2,0.3]
    #[arg(long, value_name = "A,B,C", value_parser = view, allow_hyphen_values = true)]
    view: Option<View>,
}

impl Render {
    /// Draws and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let format = Format::of(&self.output)?;
        let figure = match self.curve.curve()? {
            Curved::Plane(..) if self.view.is_some() => {
                return Err(Failure::usage(
                    "--view is for space curves; this file holds points of the plane",
                ));
            }
            Curved::Plane(points, curve) => self.figure(&points, arcs(&curve)?),
            Curved::Space(points, curve) => {
                let view = self.view.unwrap_or(View::BOOK);
                let points: Vec<Point<2>> = points.iter().map(|&point| view.project(point)).collect();
                let arcs = arcs(&curve)?.into_iter();
                let arcs = arcs.map(|arc| CubicBezier { p: arc.p.map(|p| view.project(p)) });
                self.figure(&points, arcs.collect())
            }
        };
        let content = match format {
            Format::Png => figure.to_png(self.width),
            Format::Svg => figure.to_svg_of_width(self.width).map(String::into_bytes),
        };
        write_output(Some(&self.output), &content.map_err(Failure::work)?)
    }

    fn figure(&self, points: &[Point<2>], arcs: Vec<CubicBezier<2>>) -> Figure {
        let closure = closure(&arcs);
        let mut figure = Figure::new();
        if let Some(title) = &self.title {
            figure.set_title(title);
        }
        if self.polygon {
            figure.polyline(points.to_vec(), closure, Style::line(POLYGON, 1.0).dashed(5.0, 4.0));
        }
        figure.curve(arcs, closure, Style::line(CURVE, 2.0));
        if self.points {
            for (index, &point) in points.iter().enumerate() {
                figure.disc(point, 4.0, Style::filled(POINT, EDGE), Some((index + 1).to_string()));
            }
        }
        figure
    }
}

/// The curve as cubic arcs: exact, but for Bézier curves of a higher degree.
fn arcs<const D: usize>(curve: &Curve<D>) -> Result<Vec<CubicBezier<D>>, Failure> {
    let bounds = curve.bounding_box().unwrap_or(BoundingBox::of_point([0.0; D]));
    let extent = bounds.size().into_iter().fold(0.0_f64, f64::max);
    let largest = bounds.min.iter().chain(&bounds.max).fold(0.0_f64, |m, x| m.max(x.abs()));
    let tolerance = (TOLERANCE * extent).max(LEAST_TOLERANCE * largest).max(f64::MIN_POSITIVE);
    curve.to_cubics(tolerance).map_err(Failure::work)
}

/// A curve that returns to its beginning is closed; rounding does not count.
fn closure(arcs: &[CubicBezier<2>]) -> Closure {
    let (Some(first), Some(last)) = (arcs.first(), arcs.last()) else { return Closure::Open };
    let largest = arcs.iter().flat_map(|arc| arc.p.iter().flatten()).fold(0.0_f64, |m, x| m.max(x.abs()));
    let apart = first.p[0].iter().zip(last.p[3]).any(|(a, b)| (a - b).abs() > 1e-12 * largest);
    if apart { Closure::Open } else { Closure::Closed }
}

/// What is written, by the extension.
enum Format {
    Png,
    Svg,
}

impl Format {
    fn of(path: &std::path::Path) -> Result<Format, Failure> {
        match extension(Some(path)).as_deref() {
            Some("png") => Ok(Format::Png),
            Some("svg") => Ok(Format::Svg),
            _ => Err(Failure::usage(format!("-o {}: pictures are written as .png or .svg", path.display()))),
        }
    }
}

/// The direction towards the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
struct View([f64; 3]);

impl View {
    /// Where the book's programs begin.
    const BOOK: View = View([0.7, 0.2, 0.3]);

    /// Orthogonal projection of space onto the plane across the direction: the third axis points
    /// upwards, lengths across are kept.
    fn project(self, [x, y, z]: Point<3>) -> Point<2> {
        let View([a, b, c]) = self;
        let across = a.hypot(b);
        let length = across * across.hypot(c);
        [(a * y - b * x) / across, (across * across * z - c * (a * x + b * y)) / length]
    }
}

/// Reads a direction as three numbers, scaled to 1, not straight from above or below.
fn view(text: &str) -> Result<View, String> {
    let wanted = "give three numbers A,B,C, of which A or B is not 0, as in 0.7,0.2,0.3";
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse::<f64>()).collect();
    let numbers: [f64; 3] = numbers.ok().and_then(|numbers| numbers.try_into().ok()).ok_or(wanted)?;
    let largest = numbers.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let [a, b, c] = numbers.map(|x| x / largest);
    // Not NaN, and steep enough to be divided by.
    if a.hypot(b) >= 1e-6 && [a, b, c].iter().all(|x| x.is_finite()) {
        Ok(View([a, b, c]))
    } else {
        Err(wanted.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn projection_keeps_lengths_across_the_direction() {
        let view = view("0.7, 0.2,0.3").unwrap();
        let View([a, b, c]) = view;
        // The direction itself is a point, whatever is across keeps its length.
        let close = |[x, y]: Point<2>, want: Point<2>| (x - want[0]).hypot(y - want[1]) < 1e-15;
        assert!(close(view.project([a, b, c]), [0.0, 0.0]));
        assert!(close(view.project([-b, a, 0.0]), [b.hypot(a), 0.0]));
        let up = [-a * c, -b * c, a * a + b * b];
        assert!(close(view.project(up), [0.0, up[0].hypot(up[1]).hypot(up[2])]));
    }

    #[test]
    fn directions_are_checked() {
        assert_eq!(view("-7,2,3"), Ok(View([-1.0, 2.0 / 7.0, 3.0 / 7.0])));
        for text in ["", "1,2", "1,2,3,4", "a,b,c", "0,0,1", "0,0,0", "nan,1,1", "inf,1,1", "1e-300,0,1"] {
            assert!(view(text).is_err(), "{text}");
        }
    }
}
