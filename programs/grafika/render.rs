//! `grafika render`: a picture of a curve as PNG or SVG.

use crate::curve::{CurveArgs, Curved};
use crate::sample::extension;
use clap::Args;
use grafika::figure::{Figure, LARGEST_WIDTH, NOMINAL_WIDTH, SMALLEST_WIDTH, Style};
use grafika::file::SPACE_VIEW;
use grafika::geometry::{BoundingBox, Closure, CubicBezier, Point, View};
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
    #[arg(long, value_name = "A,B,C", value_parser = direction, allow_hyphen_values = true)]
    view: Option<Point<3>>,
}

impl Render {
    /// Draws and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let format = Format::of(&self.output)?;
        let curved = self.curve.curve()?;
        if self.view.is_some() && !matches!(curved, Curved::Space(..)) {
            return Err(Failure::usage("--view is for space curves; this file holds a curve of the plane"));
        }
        let figure = match curved {
            Curved::Plane(points, curve) => {
                let tolerance = tolerance(curve.bounding_box());
                self.figure(&points, curve.to_cubics(tolerance).map_err(Failure::work)?)
            }
            Curved::Varying(points, curve) => {
                let tolerance = tolerance(BoundingBox::of_points(&points));
                self.figure(&points, curve.to_cubics(tolerance).map_err(Failure::work)?)
            }
            Curved::Fourier(curve) => {
                let tolerance = tolerance(Some(curve.bounding_box()));
                self.figure(&[], curve.to_cubics(tolerance).map_err(Failure::work)?)
            }
            Curved::Space(points, curve) => {
                let view = View::from_direction(self.view.unwrap_or(SPACE_VIEW));
                let points: Vec<Point<2>> = points.iter().map(|&point| view.place(point)).collect();
                let arcs = curve.to_cubics(tolerance(curve.bounding_box())).map_err(Failure::work)?;
                // The projection is linear: it takes arcs to arcs.
                let arcs = arcs.into_iter().map(|arc| CubicBezier { p: arc.p.map(|p| view.place(p)) });
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

/// How far the arcs of a picture may be from a curve that is no row of cubics.
fn tolerance<const D: usize>(bounds: Option<BoundingBox<D>>) -> f64 {
    let bounds = bounds.unwrap_or(BoundingBox::of_point([0.0; D]));
    let extent = bounds.size().into_iter().fold(0.0_f64, f64::max);
    let largest = bounds.min.iter().chain(&bounds.max).fold(0.0_f64, |m, x| m.max(x.abs()));
    (TOLERANCE * extent).max(LEAST_TOLERANCE * largest).max(f64::MIN_POSITIVE)
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

/// Reads a direction as three numbers, scaled to 1, not straight from above or below.
fn direction(text: &str) -> Result<Point<3>, String> {
    let wanted = "give three numbers A,B,C, of which A or B is not 0, as in 0.7,0.2,0.3";
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse::<f64>()).collect();
    let numbers: [f64; 3] = numbers.ok().and_then(|numbers| numbers.try_into().ok()).ok_or(wanted)?;
    let largest = numbers.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let [a, b, c] = numbers.map(|x| x / largest);
    // Not NaN, and steep enough to be divided by.
    if a.hypot(b) >= 1e-6 && [a, b, c].iter().all(|x| x.is_finite()) {
        Ok([a, b, c])
    } else {
        Err(wanted.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_checked() {
        assert_eq!(direction("-7,2,3"), Ok([-1.0, 2.0 / 7.0, 3.0 / 7.0]));
        for text in ["", "1,2", "1,2,3,4", "a,b,c", "0,0,1", "0,0,0", "nan,1,1", "inf,1,1", "1e-300,0,1"] {
            assert!(direction(text).is_err(), "{text}");
        }
    }
}
