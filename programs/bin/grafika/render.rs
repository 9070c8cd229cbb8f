//! `grafika render`: a picture of a curve or a surface as PNG, SVG or PDF, or a surface as a model.

use crate::curve::CurveArgs;
use crate::sample::{SURFACE_STEPS, extension};
use clap::Args;
use grafika::design::{Design, NetDesign, Shape, Sketch};
use grafika::figure::{
    Axes, CURVE_INK, Figure, Hidden, LARGEST_WIDTH, ModelFormat, NOMINAL_WIDTH, SMALLEST_WIDTH, closure,
};
use grafika::file::SPACE_VIEW;
use grafika::geometry::{BoundingBox, Closure, GeometryError, ParamSurface, Point, View};
use grafika::launch::{Failure, progress, say, write_output};
use std::path::PathBuf;

/// The command line of `grafika render`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika render A.IP2 --method spline --closed -o a.svg
  grafika render A.ZMS -o ball.step
  grafika render - --from ip2 --method bezier -o - --to png > a.png")]
pub(crate) struct Render {
    #[command(flatten)]
    curve: CurveArgs,
    /// Where to write: a picture .png .svg .pdf, a surface as a mesh .obj .stl .ply or exactly .step
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Format of what is written (png, svg, pdf, obj, stl, ply, step), where no name says it
    #[arg(long, value_name = "EXT", value_parser = Format::parse)]
    to: Option<Format>,
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
    /// Title above the picture, or name of the part in .step
    #[arg(long)]
    title: Option<String>,
    /// Caption below the picture
    #[arg(long)]
    caption: Option<String>,
    /// Show axes with ticks and numbers
    #[arg(long)]
    axes: bool,
    /// Steps a cell of a surface's net [default: 10]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    per_span: Option<u32>,
    /// Direction from which a space curve or a surface is seen [default: that of the book's programs]
    #[arg(long, value_name = "A,B,C", value_parser = direction, allow_hyphen_values = true)]
    view: Option<Point<3>>,
}

impl Render {
    /// Draws and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let format = self.to.map_or_else(|| Format::of(&self.output), Ok)?;
        let (design, shape) = self.curve.shape()?;
        let alive = progress::alive("drawing");
        let content = self.content(design, &shape, format)?;
        drop(alive);
        write_output(Some(&self.output), &content)
    }

    /// What is written.
    fn content(&self, design: Design, shape: &Shape, format: Format) -> Result<Vec<u8>, Failure> {
        if let (Design::Net(net), Shape::Surface(surface)) = (&design, shape) {
            return self.surface(net, &**surface, format);
        }
        if format.is_model() {
            let message = "models are of surfaces; a curve is drawn as .png, .svg or .pdf";
            return Err(Failure::usage(format!("-o {}: {message}", self.output.display())));
        }
        if self.per_span.is_some() {
            return Err(Failure::usage("--per-span is for surfaces; curves are drawn exactly"));
        }
        if self.view.is_some() && !matches!(shape, Shape::Space(_)) {
            return Err(Failure::usage(
                "--view is for space curves and surfaces; this file holds a curve of the plane",
            ));
        }
        let figure = match (design, shape) {
            (Design::Space(Sketch { points, .. }), Shape::Space(curve)) => {
                let view = View::from_direction(self.view.unwrap_or(SPACE_VIEW));
                let bounds = [BoundingBox::of_points(&points), curve.bounding_box()];
                let places: Vec<Point<2>> = points.iter().map(|&point| view.place(point)).collect();
                let mut figure = self.figure(&places, closure(&**curve), |figure| {
                    figure.plot_space_curve(&**curve, &view, CURVE_INK)
                })?;
                self.measure(&mut figure, view, bounds);
                figure
            }
            (design, Shape::Plane(curve)) => {
                let points = if let Design::Plane(sketch) = design { sketch.points } else { Vec::new() };
                self.figure(&points, closure(&**curve), |figure| figure.plot_curve(&**curve, CURVE_INK))?
            }
            // A design has a shape of its own kind.
            _ => self.titled(),
        };
        self.picture(&figure, format)
    }

    fn picture(&self, figure: &Figure, format: Format) -> Result<Vec<u8>, Failure> {
        if figure.lacks_axes() {
            say("grafika", NO_AXES);
        }
        let content = match format {
            Format::Svg => figure.to_svg_of_width(self.width).map(String::into_bytes),
            Format::Pdf => figure.to_pdf_of_width(self.width),
            _ => figure.to_png(self.width),
        };
        content.map_err(Failure::work)
    }

    /// A surface in any format.
    fn surface(
        &self,
        net: &NetDesign,
        surface: &dyn ParamSurface,
        format: Format,
    ) -> Result<Vec<u8>, Failure> {
        let steps = self.per_span.unwrap_or(SURFACE_STEPS) as usize;
        if !format.is_model() {
            return self.picture(&self.wireframe(net, surface, steps)?, format);
        }
        let unused = [
            ("--view", self.view.is_some()),
            ("--points", self.points),
            ("--polygon", self.polygon),
            ("--caption", self.caption.is_some()),
            ("--axes", self.axes),
        ];
        if let Some((option, _)) = unused.into_iter().find(|(_, given)| *given) {
            return Err(Failure::usage(format!("{option} is for pictures; models have no such thing")));
        }
        let surface = net.solid().map_err(Failure::work)?;
        let name = self.title.clone().or_else(|| Some(self.output.file_stem()?.to_string_lossy().into()));
        let model = match format {
            Format::Step => ModelFormat::Step,
            Format::Stl => ModelFormat::Stl,
            Format::Obj => ModelFormat::Obj,
            _ => ModelFormat::Ply,
        };
        let made = model.encode(&*surface, steps, &name.unwrap_or_default());
        let (content, warning) = made.map_err(Failure::work)?;
        if let Some(warning) = warning {
            say("grafika", &warning);
        }
        Ok(content)
    }

    /// The visible lines of a surface, with its net over them.
    fn wireframe(
        &self,
        net: &NetDesign,
        surface: &dyn ParamSurface,
        steps: usize,
    ) -> Result<Figure, Failure> {
        let view = View::from_direction(self.view.unwrap_or(net.net.kind.view()));
        let grid = surface.grid(steps).map_err(Failure::work)?;
        let mut figure = self.titled();
        figure.plot_surface(&grid, &view, Hidden::LeftOut);
        if self.polygon {
            for (line, closed) in net.polygons() {
                let line = line.iter().map(|&point| view.place(point)).collect();
                figure.plot_polygon(line, if closed { Closure::Closed } else { Closure::Open });
            }
        }
        if self.points {
            for ([k, l], point) in net.discs() {
                figure.plot_point(view.place(point), Some(format!("{k},{l}")));
            }
        }
        self.measure(&mut figure, view, [BoundingBox::of_points(grid.points()), None]);
        Ok(figure)
    }

    /// A figure with what stands around it.
    fn titled(&self) -> Figure {
        let mut figure = Figure::new();
        if let Some(title) = &self.title {
            figure.set_title(title);
        }
        if let Some(caption) = &self.caption {
            figure.set_caption(caption);
        }
        if self.axes {
            figure.set_axes(Axes::Plane);
        }
        figure
    }

    /// Gives a picture of space the axes of space, if there shall be axes.
    fn measure(&self, figure: &mut Figure, view: View, bounds: [Option<BoundingBox<3>>; 2]) {
        let bounds = bounds.into_iter().flatten().reduce(BoundingBox::union);
        if let Some(bounds) = bounds.filter(|_| self.axes) {
            figure.set_axes(Axes::Space { view, bounds });
        }
    }

    /// A curve that is plotted over its control polygon and under its points.
    fn figure(
        &self,
        points: &[Point<2>],
        closure: Closure,
        plot: impl FnOnce(&mut Figure) -> Result<(), GeometryError>,
    ) -> Result<Figure, Failure> {
        let mut figure = self.titled();
        if self.polygon {
            figure.plot_polygon(points.to_vec(), closure);
        }
        plot(&mut figure).map_err(Failure::work)?;
        if self.points {
            figure.plot_points(points);
        }
        Ok(figure)
    }
}

/// What is said where axes were asked for and cannot be drawn.
const NO_AXES: &str = "the picture has no axes: so far from the origin their numbers would need too many digits to be \
                       told apart; move the points nearer to the origin";

const FORMATS: &str = "pictures are written as .png .svg .pdf, surfaces also as .obj .stl .ply .step";

/// What is written, by the extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Png,
    Svg,
    Pdf,
    Obj,
    Stl,
    Ply,
    Step,
}

impl Format {
    fn of(path: &std::path::Path) -> Result<Format, Failure> {
        let Some(extension) = extension(Some(path)) else {
            return Err(Failure::usage(format!("-o - has no extension; say it, as in --to png: {FORMATS}")));
        };
        Format::parse(&extension).map_err(|why| Failure::usage(format!("-o {}: {why}", path.display())))
    }

    /// The format of an extension without its dot, in any case.
    fn parse(extension: &str) -> Result<Format, String> {
        Ok(match extension.to_lowercase().as_str() {
            "png" => Format::Png,
            "svg" => Format::Svg,
            "pdf" => Format::Pdf,
            "obj" => Format::Obj,
            "stl" => Format::Stl,
            "ply" => Format::Ply,
            "step" | "stp" => Format::Step,
            _ => return Err(FORMATS.to_owned()),
        })
    }

    fn is_model(self) -> bool {
        !matches!(self, Format::Png | Format::Svg | Format::Pdf)
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
