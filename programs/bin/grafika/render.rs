//! `grafika render`: a picture of a curve or a surface as PNG, SVG or PDF, or a surface as a model.

mod checks;
mod scene;
mod series;

use crate::curve::CurveArgs;
use crate::models;
use crate::normals;
use crate::offset::plot;
use crate::ph::PhShape;
use crate::picture::{Format, NAMES, picture};
use crate::sample::SURFACE_STEPS;
use crate::source::apart;
use crate::steps::{self, For};
use clap::Args;
use grafika::design::offset::curve as curve_of;
use grafika::design::{Controls, Design, NetDesign, Shape, knots, shaped, skin};
use grafika::figure::{
    Axes, CURVE_INK, Figure, Hidden, LARGEST_WIDTH, MODEL_TOLERANCE, ModelFormat, ModelOptions,
    NOMINAL_WIDTH, OFFSET_INK, SMALLEST_WIDTH, StepCurve, closure, curves_step, outline_step,
};
use grafika::file::{Circles, Method, SPACE_VIEW};
use grafika::geometry::ph::{Offset, PhCurve, RationalArc, RationalCurve};
use grafika::geometry::skin::Outline;
use grafika::geometry::{
    BoundingBox, Closure, GeometryError, ParamCurve, ParamSurface, PnSurface, Point, View,
};
use grafika::launch::{Failure, Overwrite, progress, say, words};
use std::path::PathBuf;

/// The command line of `grafika render`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika render A.IP2 --method spline --closed -o a.svg
  grafika render A.IP2 --method beta --closed --tension 0,2,5 --joints -o tensions.svg
  grafika render A.IP2 --method spline,coons,bspline3 --points -o methods.svg
  grafika render A.ZMS -o ball.step
  grafika render A.IP2 --method phspline --closed --distance 10 --distance=-10 --comb -o a.pdf
  grafika render - --from ip2 --method bezier -o - --to png > a.png")]
pub(crate) struct Render {
    #[command(flatten)]
    curve: CurveArgs,
    /// Draw the offset of a PH curve at this distance too, positive to the left, or of a surface by --method pn, positive
    /// along its normals; may be repeated
    #[arg(long, value_name = "D", allow_negative_numbers = true)]
    distance: Vec<f64>,
    /// Show the comb of curvature of a PH curve
    #[arg(long)]
    comb: bool,
    /// Show the speed of a PH curve over its length, below it
    #[arg(long)]
    speed: bool,
    /// Where to write: a picture .png .svg .pdf, a surface as a mesh .obj .stl .ply or exactly .step
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Format of what is written (png, svg, pdf, obj, stl, ply, step), where no name says it
    #[arg(long, value_name = "EXT", value_parser = Format::parse, add = words(&NAMES))]
    to: Option<Format>,
    /// Width of the picture in pixels [default: 640]
    #[arg(long, value_name = "N",
        value_parser = clap::value_parser!(u32).range(i64::from(SMALLEST_WIDTH)..=i64::from(LARGEST_WIDTH)))]
    width: Option<u32>,
    /// Show the control points with their numbers
    #[arg(long)]
    points: bool,
    /// Show the control polygon
    #[arg(long)]
    polygon: bool,
    /// Show the joints of a curve, where its spans end, as small circles
    #[arg(long)]
    joints: bool,
    /// Title above the picture, or name of the part in .step
    #[arg(long)]
    title: Option<String>,
    /// Caption below the picture
    #[arg(long)]
    caption: Option<String>,
    /// Show axes with ticks and numbers
    #[arg(long)]
    axes: bool,
    /// Steps a cell of a surface's net; very large ones have fewer [default: 10]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    per_span: Option<u32>,
    /// How far a fitted surface in .step may be from the exact one, as a part of its size [default: 1e-6]; how far the
    /// arcs of pictures may be from a PH curve and its offsets [default: 1e-7]
    #[arg(long, value_name = "X", value_parser = tolerance)]
    tolerance: Option<f64>,
    /// Direction from which a space curve or a surface is seen [default: that of the book's programs]
    #[arg(long, value_name = "A,B,C", value_parser = direction, allow_hyphen_values = true)]
    view: Option<Point<3>>,
    #[command(flatten)]
    overwrite: Overwrite,
}

impl Render {
    /// Draws and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        apart(&self.curve.source.file, Some(&self.output))?;
        let format = self.to.map_or_else(|| Format::of(&self.output), Ok)?;
        if self.curve.is_series() {
            return self.overwrite.write(Some(&self.output), &self.series(format)?);
        }
        let (design, shape) = self.curve.shape()?;
        self.check_joints(&shape)?;
        let exact = self.exact(&design)?;
        if exact.is_none()
            && format.is_model()
            && let Some(written) = self.modelled(&design, &shape, format)?
        {
            return Ok(written);
        }
        let alive = progress::alive("drawing");
        if let Some(curve) = exact {
            let content = self.ph(&design, &curve, format)?;
            drop(alive);
            return self.overwrite.write(Some(&self.output), &content);
        }
        let content = self.content(design, &shape, format)?;
        drop(alive);
        self.overwrite.write(Some(&self.output), &content)
    }

    /// Writes a model of a surface, if it is one that is asked for. A mesh need not stand in memory.
    fn modelled(&self, design: &Design, shape: &Shape, format: Format) -> Result<Option<()>, Failure> {
        match (design, shape) {
            (Design::Net(net), Shape::Surface(_)) => {
                self.check_model(format)?;
                let (solid, offsets) = (net.solid().map_err(Failure::work)?, self.offsets(net)?);
                let offsets = offsets.iter().map(|offset| offset as &dyn ParamSurface);
                self.model(&std::iter::once(&*solid).chain(offsets).collect::<Vec<_>>(), format).map(Some)
            }
            (Design::Patches(_) | Design::KnotNet(_), Shape::Surface(surface)) => {
                self.check_model(format)?;
                self.model(&[&**surface], format).map(Some)
            }
            (Design::Ec(_), Shape::Parts(parts)) if !self.has_other_tolerance(format) => {
                self.model_of_parts(parts, format).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// Whether a tolerance is given that the format has none of.
    fn has_other_tolerance(&self, format: Format) -> bool {
        self.tolerance.is_some() && format != Format::Step
    }

    /// What is written.
    fn content(&self, design: Design, shape: &Shape, format: Format) -> Result<Vec<u8>, Failure> {
        if let (Design::Net(net), Shape::Surface(surface)) = (&design, shape) {
            self.check_wires()?;
            let offsets = self.offsets(net)?;
            let all: Vec<&dyn ParamSurface> = std::iter::once(&**surface)
                .chain(offsets.iter().map(|offset| offset as &dyn ParamSurface))
                .collect();
            let steps = steps::of_surfaces(self.per_span, &all, For::Picture);
            return self.picture(&self.wireframe(net, &**surface, &offsets, steps)?, format);
        }
        if let (Design::Patches(_) | Design::KnotNet(_), Shape::Surface(surface)) = (&design, shape) {
            self.check_wires()?;
            let steps = steps::of_surfaces(self.per_span, &[&**surface], For::Picture);
            let (mut figure, view, bounds) = self.wires(&[&**surface], SPACE_VIEW, steps)?;
            match &design {
                Design::KnotNet(net) => self.plot_net(&mut figure, &net.points, &view),
                _ => self.check_points()?,
            }
            self.measure(&mut figure, view, [bounds, None]);
            return self.picture(&figure, format);
        }
        if let (Design::Skin(circles), Shape::Outlines(outlines)) = (&design, shape) {
            return self.skin(circles, outlines, format);
        }
        if format == Format::Step
            && let Some(curve) = self.step_curve(&design, shape)?
        {
            self.check_curve().and_then(|()| self.check_model(format))?;
            return self.step(&[curve]);
        }
        if self.has_other_tolerance(format) {
            return Err(Failure::usage("--tolerance is for .step"));
        }
        if let (Design::Ec(document), Shape::Parts(parts)) = (&design, shape) {
            return self.parts(document, parts, format);
        }
        if format.is_model() {
            let message = "models are of surfaces; a curve is drawn as .png, .svg or .pdf";
            return Err(Failure::usage(format!("-o {}: {message}", self.output.display())));
        }
        self.check_curve()?;
        if self.view.is_some() && !matches!(shape, Shape::Space(_)) {
            return Err(Failure::usage(
                "--view is for space curves and surfaces; this file holds a curve of the plane",
            ));
        }
        let figure = match (design.controls(), shape) {
            (Controls::Space(points), Shape::Space(curve)) => {
                let view = View::from_direction(self.view.unwrap_or(SPACE_VIEW));
                let bounds = [BoundingBox::of_points(&points), curve.bounding_box()];
                let places: Vec<Point<2>> = points.iter().map(|&point| view.place(point)).collect();
                let mut figure = self.figure(&places, closure(&**curve), |figure| {
                    figure.plot_space_curve(&**curve, &view, CURVE_INK)?;
                    self.plot_joints(figure, shape, &view, CURVE_INK);
                    Ok(())
                })?;
                self.measure(&mut figure, view, bounds);
                figure
            }
            (controls, Shape::Plane(curve)) => {
                let points = if let Controls::Plane(points) = controls { points } else { Vec::new() };
                let view = View::from_direction(SPACE_VIEW);
                self.figure(&points, closure(&**curve), |figure| {
                    figure.plot_curve(&**curve, CURVE_INK)?;
                    self.plot_joints(figure, shape, &view, CURVE_INK);
                    Ok(())
                })?
            }
            // A design has a shape of its own kind.
            _ => self.titled(),
        };
        self.picture(&figure, format)
    }

    fn picture(&self, figure: &Figure, format: Format) -> Result<Vec<u8>, Failure> {
        picture(figure, format, self.width.unwrap_or(NOMINAL_WIDTH))
    }

    /// The PH curve or the rational curve, where it has to be drawn as one.
    fn exact(&self, design: &Design) -> Result<Option<Exact>, Failure> {
        let name = "the file";
        let method = match design {
            Design::Plane(sketch) => sketch.method(),
            Design::Rational(spans) => {
                if let Some(option) = self.ph_option() {
                    return Err(Failure::usage(format!("{option} is for control points of a PH curve")));
                }
                return Ok(Some(Exact::Rational(curve_of(spans).map_err(Failure::work)?)));
            }
            Design::Net(_) if !self.comb && !self.speed => return Ok(None),
            _ => None,
        };
        match (method, self.ph_option()) {
            (Some(Method::PhSpline | Method::PhHermite | Method::PhCubic), _) => {
                PhShape::plane(design, name, "render").map(|curve| Some(Exact::Ph(curve)))
            }
            (_, Some(option)) => PhShape::plane(design, name, option).map(|curve| Some(Exact::Ph(curve))),
            (_, None) => Ok(None),
        }
    }

    /// An option that only plane PH curves have, if one is given.
    fn ph_option(&self) -> Option<&'static str> {
        let given =
            [("--distance", !self.distance.is_empty()), ("--comb", self.comb), ("--speed", self.speed)];
        given.into_iter().find(|(_, given)| *given).map(|(option, _)| option)
    }

    /// A PH curve with its offsets, or a rational curve: exactly in .step, else by arcs within the tolerance.
    fn ph(&self, design: &Design, exact: &Exact, format: Format) -> Result<Vec<u8>, Failure> {
        self.check_curve()?;
        if self.view.is_some() {
            return Err(Failure::usage(
                "--view is for space curves and surfaces; this file holds a curve of the plane",
            ));
        }
        if let Exact::Rational(_) = exact {
            self.check_points()?;
        }
        let offsets = match exact {
            Exact::Ph(curve) => self.distance.iter().map(|distance| curve.offset(*distance)).collect(),
            Exact::Rational(_) => Ok(Vec::new()),
        };
        let offsets: Vec<Offset> = offsets.map_err(Failure::work)?;
        if format == Format::Step {
            self.check_model(format)?;
            if self.comb || self.speed {
                return Err(Failure::usage("--comb and --speed are for pictures; models have no such thing"));
            }
            if self.tolerance.is_some() {
                return Err(Failure::usage("--tolerance is for pictures; .step holds these curves exactly"));
            }
            let first = match exact {
                Exact::Ph(curve) => StepCurve { arcs: curve.arcs(), closed: curve.closed() },
                Exact::Rational(curve) => StepCurve { arcs: curve.arcs().to_vec(), closed: curve.closed() },
            };
            let step = |offset: &Offset| StepCurve { arcs: offset.arcs(), closed: offset.closed() };
            let curves: Vec<StepCurve> = std::iter::once(first).chain(offsets.iter().map(step)).collect();
            return self.step(&curves);
        }
        if format.is_model() {
            let message =
                "meshes are of surfaces; a curve is drawn as .png, .svg or .pdf, and exactly as .step";
            return Err(Failure::usage(format!("-o {}: {message}", self.output.display())));
        }
        let points = if let Design::Plane(sketch) = design { sketch.points.as_slice() } else { &[] };
        let mut figure = self.titled();
        if self.polygon {
            figure.plot_polygon(points.to_vec(), closure(exact.curve()));
        }
        if let Exact::Ph(curve) = exact {
            if self.comb {
                figure.plot_comb(curve);
            }
            if self.speed {
                figure.plot_speed(curve);
            }
        }
        for offset in &offsets {
            plot(&mut figure, offset, OFFSET_INK, self.tolerance)?;
        }
        plot(&mut figure, exact.curve(), CURVE_INK, self.tolerance)?;
        if self.joints {
            exact.curve().joints().into_iter().for_each(|at| figure.plot_joint(at));
        }
        if self.points {
            figure.plot_points(points);
        }
        self.picture(&figure, format)
    }

    /// Curves of the plane for CAD programs.
    fn step(&self, curves: &[StepCurve]) -> Result<Vec<u8>, Failure> {
        let name = self.title.clone().or_else(|| Some(self.output.file_stem()?.to_string_lossy().into()));
        curves_step(curves, &name.unwrap_or_default()).map(String::into_bytes).map_err(Failure::work)
    }

    /// A curve of the plane by its knots or with shape parameters, exactly where it is rational, else by cubic arcs within
    /// the tolerance, which is told.
    fn step_curve(&self, design: &Design, shape: &Shape) -> Result<Option<StepCurve>, Failure> {
        let weighted = |points: &[Point<2>], weights: &[f64]| {
            let point = |(&[x, y], &w): (&Point<2>, &f64)| [x * w, y * w, w];
            RationalArc::new(points.iter().zip(weights).map(point).collect())
        };
        let plain = |points: &[Point<2>]| weighted(points, &vec![1.0; points.len()]);
        let Shape::Plane(curve) = shape else { return Ok(None) };
        let exact = match design {
            Design::Knots(document) => match knots::curve(document).map_err(Failure::work)? {
                knots::Curve::Plane(curve) => {
                    Some(curve.arcs().iter().map(|arc| weighted(&arc.points, &arc.weights)).collect())
                }
                knots::Curve::Space(_) => None,
            },
            Design::Shaped(document) => match shaped::curve(document).map_err(Failure::work)? {
                shaped::Curve::Plane(curve) => {
                    curve.bezier_arcs().map(|arcs| arcs.iter().map(|arc| plain(arc)).collect())
                }
                shaped::Curve::Space(_) => None,
            },
            _ => return Ok(None),
        };
        if exact.is_some() && self.tolerance.is_some() {
            return Err(Failure::usage(
                "--tolerance is for curves that are fitted; .step holds this one exactly",
            ));
        }
        let arcs = match exact {
            Some(arcs) => arcs,
            None => {
                let size = curve.bounding_box().map_or(1.0, |bounds| bounds.extent());
                let tolerance = self.tolerance.unwrap_or(MODEL_TOLERANCE) * size;
                let arcs = curve.to_cubics(tolerance).map_err(Failure::work)?;
                say("grafika", &format!("fitted by {} cubic arcs within {tolerance:e}", arcs.len()));
                arcs.iter().map(|arc| plain(&arc.p)).collect()
            }
        };
        Ok(Some(StepCurve { arcs, closed: curve.closed() }))
    }

    /// The outlines of a skin, exactly.
    fn skin(&self, circles: &Circles, outlines: &[Outline], format: Format) -> Result<Vec<u8>, Failure> {
        let given = [
            ("--per-span", self.per_span.is_some()),
            ("--tolerance", self.tolerance.is_some()),
            ("--view", self.view.is_some()),
            ("--polygon", self.polygon),
        ];
        if let Some((option, _)) = given.into_iter().find(|(_, given)| *given) {
            return Err(Failure::usage(format!("{option} is for other curves; skins are drawn as they are")));
        }
        if outlines.iter().any(|outline| !outline.closed) || outlines.is_empty() {
            return Err(Failure::work("these circles have no whole skin; grafika skin --check tells why"));
        }
        if format == Format::Step {
            self.check_model(format)?;
            return self.step(&outlines.iter().map(outline_step).collect::<Vec<_>>());
        }
        if format.is_model() {
            let message = "meshes are of surfaces; a skin of circles is drawn as .png, .svg or .pdf, and exactly as .step";
            return Err(Failure::usage(format!("-o {}: {message}", self.output.display())));
        }
        let mut figure = self.titled();
        if self.points {
            let circles = skin::circles(circles).map_err(Failure::work)?;
            figure.plot_discs(circles.circles()).map_err(Failure::work)?;
        }
        for outline in outlines {
            figure.plot_outline(outline, CURVE_INK, false).map_err(Failure::work)?;
        }
        self.picture(&figure, format)
    }

    /// The lines and points of a net over a surface.
    fn plot_net(&self, figure: &mut Figure, net: &[Vec<Point<3>>], view: &View) {
        let place = |&point: &Point<3>| view.place(point);
        if self.polygon {
            let columns = net.first().map_or(0, Vec::len);
            let across = (0..columns).map(|l| net.iter().filter_map(|row| row.get(l)).map(place).collect());
            let along = net.iter().map(|row| row.iter().map(place).collect());
            along.chain(across).for_each(|line: Vec<Point<2>>| figure.plot_polygon(line, Closure::Open));
        }
        if self.points {
            for (k, row) in net.iter().enumerate() {
                for (l, point) in row.iter().enumerate() {
                    figure.plot_point(place(point), Some(format!("{k},{l}")));
                }
            }
        }
    }

    /// Writes surfaces as a model.
    fn model(&self, surfaces: &[&dyn ParamSurface], format: Format) -> Result<(), Failure> {
        if format == Format::Step
            && self.tolerance.is_some()
            && surfaces.iter().all(|surface| surface.to_bspline().is_some())
        {
            return Err(Failure::usage(
                "--tolerance is for surfaces that are fitted; .step holds this one exactly",
            ));
        }
        let name = self.title.clone().or_else(|| Some(self.output.file_stem()?.to_string_lossy().into()));
        let model = format.model().unwrap_or(ModelFormat::Ply);
        let options = ModelOptions {
            steps: match model {
                ModelFormat::Step => self.per_span.unwrap_or(SURFACE_STEPS) as usize,
                _ => steps::of_surfaces(self.per_span, surfaces, For::Points),
            },
            tolerance: self.tolerance.unwrap_or(MODEL_TOLERANCE),
            name: &name.unwrap_or_default(),
        };
        models::write(&self.overwrite.target(Some(&self.output))?, model, surfaces, &options)
    }

    /// The visible lines of a surface, with its net over them.
    fn wireframe(
        &self,
        net: &NetDesign,
        surface: &dyn ParamSurface,
        offsets: &[PnSurface],
        steps: usize,
    ) -> Result<Figure, Failure> {
        let offsets = offsets.iter().map(|offset| offset as &dyn ParamSurface);
        let surfaces: Vec<&dyn ParamSurface> = std::iter::once(surface).chain(offsets).collect();
        let (mut figure, view, bounds) = self.wires(&surfaces, net.net.kind.view(), steps)?;
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
        self.measure(&mut figure, view, [bounds, None]);
        Ok(figure)
    }

    /// The offsets of a net's surface at the distances that are asked for, else at that of the file.
    fn offsets(&self, net: &NetDesign) -> Result<Vec<PnSurface>, Failure> {
        let own = net.net.settings.distance.filter(|distance| *distance != 0.0);
        let own = own.filter(|_| self.distance.is_empty() && net.pn_method().is_some());
        if self.distance.is_empty() && own.is_none() {
            return Ok(Vec::new());
        }
        let surface = normals::surface(net, "the file")?;
        let distances = self.distance.iter().copied().chain(own);
        distances.map(|distance| surface.offset(distance)).collect::<Result<_, _>>().map_err(Failure::work)
    }

    /// The visible lines of surfaces, how they are seen, and the box round them.
    fn wires(
        &self,
        surfaces: &[&dyn ParamSurface],
        from: Point<3>,
        steps: usize,
    ) -> Result<(Figure, View, Option<BoundingBox<3>>), Failure> {
        let view = View::from_direction(self.view.unwrap_or(from));
        let grids = surfaces.iter().map(|surface| surface.grid(steps)).collect::<Result<Vec<_>, _>>();
        let grids = grids.map_err(Failure::work)?;
        let mut figure = self.titled();
        figure.plot_surfaces(&grids, &view, Hidden::LeftOut);
        let bounds = grids.iter().filter_map(|grid| BoundingBox::of_points(grid.points()));
        Ok((figure, view, bounds.reduce(BoundingBox::union)))
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
        self.measure_space(figure, view, bounds.into_iter().flatten().reduce(BoundingBox::union));
    }

    /// The same for the box round all.
    fn measure_space(&self, figure: &mut Figure, view: View, bounds: Option<BoundingBox<3>>) {
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

/// A curve of the plane that .step holds exactly.
enum Exact {
    Ph(PhCurve),
    Rational(RationalCurve),
}

impl Exact {
    fn curve(&self) -> &dyn ParamCurve<2> {
        match self {
            Exact::Ph(curve) => curve,
            Exact::Rational(curve) => curve,
        }
    }
}

/// Reads a tolerance as a part of the size.
fn tolerance(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| *number > 0.0 && *number <= 1.0);
    number.ok_or_else(|| "give a part of the size, above 0 and at most 1, as in 1e-6".to_owned())
}

/// Reads a direction as three numbers, scaled to 1. Straight from above or below is one too: the top view.
fn direction(text: &str) -> Result<Point<3>, String> {
    let wanted = "give three numbers A,B,C, not all of them 0, as in 0.7,0.2,0.3";
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse::<f64>()).collect();
    let numbers: [f64; 3] = numbers.ok().and_then(|numbers| numbers.try_into().ok()).ok_or(wanted)?;
    let largest = numbers.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    // Not NaN, which all zeros and infinities become.
    let scaled = numbers.map(|x| x / largest);
    if scaled.iter().all(|x| x.is_finite()) { Ok(scaled) } else { Err(wanted.into()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_checked() {
        assert_eq!(direction("-7,2,3"), Ok([-1.0, 2.0 / 7.0, 3.0 / 7.0]));
        assert_eq!([direction("0,0,1"), direction("0,0,-2")], [Ok([0.0, 0.0, 1.0]), Ok([0.0, 0.0, -1.0])]);
        assert!(direction("1e-300,0,1").is_ok());
        for text in ["", "1,2", "1,2,3,4", "a,b,c", "0,0,0", "-0,0,0", "nan,1,1", "inf,1,1"] {
            assert!(direction(text).is_err(), "{text}");
        }
    }
}
