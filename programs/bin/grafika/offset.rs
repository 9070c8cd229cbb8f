//! `grafika offset`: the exact offset of a plane PH curve, whole or trimmed, or of a surface with Pythagorean normals.

use crate::curve::CurveArgs;
use crate::models;
use crate::normals;
use crate::ph::PhShape;
use crate::picture::{Format, picture};
use crate::sample::{SURFACE_STEPS, extension};
use crate::source::{apart, is_stream};
use clap::Args;
use grafika::design::offset::document;
use grafika::design::{Design, NetDesign};
use grafika::figure::{
    CURVE_INK, Figure, Hidden, MODEL_TOLERANCE, ModelOptions, NOMINAL_WIDTH, OFFSET_INK, StepCurve,
    curves_step, quantity_csv, tolerance,
};
use grafika::file::{Document, FileKind, number};
use grafika::geometry::ph::{Offset, OffsetPart, Place, chords};
use grafika::geometry::{BoundingBox, GeometryError, ParamCurve, ParamSurface, View};
use grafika::launch::{Failure, Overwrite, progress, say};
use std::fmt::Write;
use std::path::PathBuf;

/// The command line of `grafika offset`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika offset A.IP2 --method phspline --closed --distance 10 -o a.json
  grafika offset A.IP2 --method phspline --closed --distance=-5 --trim -o a.step
  grafika offset N.PN --distance=-0.5 -o n.step
  grafika offset A.IC2 --method phhermite --distance 3 --trim --nc a.nc --tolerance 0.005")]
pub(crate) struct OffsetArgs {
    #[command(flatten)]
    curve: CurveArgs,
    /// Distance, positive to the left of the direction of travel, of surfaces along the normals
    #[arg(long, value_name = "D", allow_negative_numbers = true)]
    distance: f64,
    /// Keep only what is not nearer to the curve than the distance, and tell the crossings
    #[arg(long)]
    trim: bool,
    /// Where to write: .json (or .rbc, .rbs) and .step exactly, a picture .svg .pdf .png, points .csv, a surface also as a
    /// mesh .stl .obj .ply [default: JSON on standard output]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Format of what is written (json, step, svg, pdf, png, csv, stl, obj, ply), where no name says it
    #[arg(long, value_name = "EXT", ignore_case = true, 
        value_parser = ["json", "rbc", "rbs", "step", "svg", "pdf", "png", "csv", "stl", "obj", "ply"])]
    to: Option<String>,
    /// Steps a span in .csv [default: 50], of surfaces also in meshes [default: 10]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    per_span: Option<u32>,
    /// How far pictures may be from the curve, as a part of its size [default: 1e-7]; of --nc in mm [default: 0.01]
    #[arg(long, value_name = "X", value_parser = positive)]
    tolerance: Option<f64>,
    /// Write straight moves of a machine tool, G1 X Y F, whose chords keep within the tolerance
    #[arg(long, value_name = "FILE")]
    nc: Option<PathBuf>,
    /// Length of one unit of the file in mm, for --nc
    #[arg(long, value_name = "MM", default_value_t = 1.0, value_parser = positive, requires = "nc")]
    unit: f64,
    /// Feed in mm a minute, for --nc
    #[arg(long, value_name = "F", default_value_t = 100.0, value_parser = positive, requires = "nc")]
    feed: f64,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// What is said when trimming leaves nothing.
const NOTHING: &str = "the whole offset is nearer to the curve than its distance; nothing of it is kept";
/// The tolerance of moves in millimetres for which none is given.
const NC_TOLERANCE: f64 = 0.01;

impl OffsetArgs {
    /// Offsets and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        for written in [&self.output, &self.nc] {
            apart(&self.curve.source.file, written.as_deref())?;
        }
        let (design, name) = self.curve.design()?;
        if let Design::Net(net) = &design {
            return self.of_surface(net, &name);
        }
        let curve = PhShape::plane(&design, &name, "offset")?;
        let failed = |error: GeometryError| Failure::work(format!("{name}: {error}"));
        let alive = progress::alive("offsetting");
        let offset = curve.offset(self.distance).map_err(failed)?;
        let trimmed = self.trim.then(|| offset.trimmed());
        let whole = [Place { span: 0, u: 0.0 }, Place { span: curve.spans().saturating_sub(1), u: 1.0 }];
        let parts: Vec<OffsetPart<'_>> = match &trimmed {
            Some(trimmed) => offset.parts(trimmed).collect(),
            None => vec![offset.part(whole)],
        };
        if parts.is_empty() {
            // A tool needs a path; a picture, a table or a document may be empty.
            if self.nc.is_some() {
                return Err(Failure::work(format!("{name}: {NOTHING}")));
            }
            say("grafika", NOTHING);
        }
        let moves = match &self.nc {
            Some(_) => Some(self.moves(&parts)?),
            None => None,
        };
        let said = self.to.as_ref().map(|said| said.to_lowercase());
        let output = self.output.as_deref().filter(|path| !is_stream(path));
        let wanted = said.or_else(|| extension(output));
        let picture = matches!(wanted.as_deref(), Some("svg" | "pdf" | "png"));
        self.check(wanted.as_deref() == Some("csv"), picture || self.nc.is_some())?;
        let content = match wanted.as_deref() {
            // A path of a tool alone needs nothing else.
            None if self.nc.is_some() && self.output.is_none() => None,
            None | Some("json" | "rbc") => {
                let spans = document(&offset, trimmed.as_ref());
                Some(Document::Rational(Box::new(spans)).encode(FileKind::Json).map_err(Failure::work)?)
            }
            Some("csv") => Some(self.points(&parts)?.into_bytes()),
            Some("step" | "stp") => {
                let title = output.and_then(|path| path.file_stem()).map(|stem| stem.to_string_lossy());
                Some(step(&parts, &title.unwrap_or_default())?)
            }
            Some(other) => Some(self.drawn(&offset, &parts, other)?),
        };
        drop(alive);
        if let (Some(path), Some(moves)) = (&self.nc, moves) {
            self.overwrite.write(Some(path), moves.as_bytes())?;
        }
        match content {
            Some(content) => self.overwrite.write(output, &content),
            None => Ok(()),
        }
    }

    /// Refuses options that what is written has no place for.
    fn check(&self, steps: bool, tolerance: bool) -> Result<(), Failure> {
        if self.per_span.is_some() && !steps {
            return Err(Failure::usage(
                "--per-span: what is written here has no steps; .csv has, of surfaces also meshes",
            ));
        }
        if self.tolerance.is_some() && !tolerance {
            return Err(Failure::usage(
                "--tolerance is for pictures of curves and --nc, of surfaces for .step; anything else is exact",
            ));
        }
        Ok(())
    }

    /// The offset of a surface with Pythagorean normals: exactly, or as a mesh or points.
    fn of_surface(&self, net: &NetDesign, name: &str) -> Result<(), Failure> {
        let curves_only = [("--trim", self.trim), ("--nc", self.nc.is_some())];
        if let Some((option, _)) = curves_only.into_iter().find(|(_, given)| *given) {
            return Err(Failure::usage(format!(
                "{option} is for curves of the plane; {name} holds a surface"
            )));
        }
        let alive = progress::alive("offsetting");
        let surface = normals::surface(net, name)?;
        let offset = surface.offset(self.distance).map_err(Failure::usage)?;
        let said = self.to.as_ref().map(|said| said.to_lowercase());
        let output = self.output.as_deref().filter(|path| !is_stream(path));
        let steps = self.per_span.unwrap_or(SURFACE_STEPS) as usize;
        let wanted = said.or_else(|| extension(output));
        let exact = matches!(wanted.as_deref(), None | Some("json" | "rbs" | "step" | "stp"));
        self.check(!exact, matches!(wanted.as_deref(), Some("step" | "stp")))?;
        let tell_folds =
            || normals::folded(&surface, self.distance).iter().for_each(|note| say("grafika", note));
        let content = match wanted.as_deref() {
            None | Some("json" | "rbs") => normals::written(&offset)?.into_bytes(),
            Some("csv") => {
                let rows = normals::quantities(&offset, steps)?.collect::<Result<Vec<_>, _>>()?;
                quantity_csv(&normals::QUANTITIES, &rows).into_bytes()
            }
            Some(other) => {
                let unknown = || {
                    Failure::usage(format!(
                        "-o: the offset of a surface is written as .json, .step, .stl, .obj, .ply, .csv, .svg, .pdf or \
                         .png, not .{other}"
                    ))
                };
                let format = Format::parse(other).map_err(|_| unknown())?;
                match format.model() {
                    Some(model) => {
                        let title =
                            output.and_then(|path| path.file_stem()).map(|stem| stem.to_string_lossy());
                        let name = title.unwrap_or_default();
                        let tolerance = self.tolerance.unwrap_or(MODEL_TOLERANCE);
                        let options = ModelOptions { steps, tolerance, name: &name };
                        drop(alive);
                        tell_folds();
                        return models::write(&self.overwrite.target(output)?, model, &[&offset], &options);
                    }
                    None => {
                        let mut figure = Figure::new();
                        let grids = [surface.grid(steps), offset.grid(steps)];
                        let grids =
                            grids.into_iter().collect::<Result<Vec<_>, _>>().map_err(Failure::work)?;
                        let view = View::from_direction(net.net.kind.view());
                        figure.plot_surfaces(&grids, &view, Hidden::LeftOut);
                        picture(&figure, format, NOMINAL_WIDTH)?
                    }
                }
            }
        };
        drop(alive);
        tell_folds();
        self.overwrite.write(output, &content)
    }

    /// The points at equal steps of the parameter, with the places of the curve that they belong to.
    fn points(&self, parts: &[OffsetPart<'_>]) -> Result<String, Failure> {
        let steps = self.per_span.unwrap_or(50) as usize;
        let mut rows = Vec::new();
        for part in parts {
            let samples = part.sample(steps).map_err(Failure::work)?;
            rows.extend(samples.into_iter().filter_map(|sample| {
                let place = part.place(sample.span, sample.u)?;
                let [x, y] = sample.point;
                Some([place.span as f64, place.u, x, y].map(Some).to_vec())
            }));
        }
        Ok(quantity_csv(&["span", "u", "x", "y"], &rows))
    }

    /// A picture of what is kept.
    fn drawn(&self, offset: &Offset, parts: &[OffsetPart<'_>], extension: &str) -> Result<Vec<u8>, Failure> {
        let format = Format::parse(extension).ok().filter(|format| !format.is_model());
        let format = format.ok_or_else(|| {
            Failure::usage(format!(
                "-o: an offset is written as .json, .step, .svg, .pdf, .png or .csv, not .{extension}"
            ))
        })?;
        let mut figure = Figure::new();
        figure.plot_curve(offset.curve(), CURVE_INK).map_err(Failure::work)?;
        for part in parts {
            plot(&mut figure, part, OFFSET_INK, self.tolerance)?;
        }
        picture(&figure, format, NOMINAL_WIDTH)
    }

    /// The moves of a tool along the parts.
    fn moves(&self, parts: &[OffsetPart<'_>]) -> Result<String, Failure> {
        let error = self.tolerance.unwrap_or(NC_TOLERANCE) / self.unit;
        let mut text = String::from("G21 G90\n");
        for part in parts {
            let corners = chords(part, error).map_err(Failure::work)?;
            for (index, corner) in corners.iter().enumerate() {
                let [x, y] = corner.map(|value| decimal(value * self.unit));
                // Writing to a string cannot fail.
                let _ = match index {
                    0 => writeln!(text, "G0 X{x} Y{y}"),
                    _ => writeln!(text, "G1 X{x} Y{y} F{}", decimal(self.feed)),
                };
            }
        }
        text.push_str("M2\n");
        Ok(text)
    }
}

/// A number without an exponent, which machines do not read, to a millionth.
fn decimal(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Adds a curve by arcs within a tolerance that is a part of its size, if one is given.
pub(crate) fn plot(
    figure: &mut Figure,
    curve: &dyn ParamCurve<2>,
    ink: [u8; 3],
    part_of_size: Option<f64>,
) -> Result<(), Failure> {
    let bounds = curve.bounding_box();
    let within = part_of_size.map_or_else(|| tolerance(bounds), |part| part * size(bounds));
    // A point has no size.
    let within = if within > 0.0 { within } else { tolerance(bounds) };
    figure.plot_curve_within(curve, ink, within).map_err(Failure::work)
}

fn size(bounds: Option<BoundingBox<2>>) -> f64 {
    bounds.map_or(0.0, |bounds| bounds.extent())
}

/// The parts as exact curves in a STEP file.
fn step(parts: &[OffsetPart<'_>], name: &str) -> Result<Vec<u8>, Failure> {
    let curves: Vec<StepCurve> =
        parts.iter().map(|part| StepCurve { arcs: part.arcs(), closed: part.closed() }).collect();
    curves_step(&curves, name).map(String::into_bytes).map_err(Failure::work)
}

/// Reads a positive number.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    let value = text.parse::<f64>().ok().filter(|value| *value > 0.0 && value.is_finite());
    value.ok_or_else(|| format!("give a positive number, as in {}", number(0.01)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_machines_have_no_exponents() {
        let texts = [0.0, -0.0, 1e-9, -1e-9, 12.5, 100.0, 1e12, -0.1234567].map(decimal);
        assert_eq!(texts, ["0", "0", "0", "0", "12.5", "100", "1000000000000", "-0.123457"]);
    }
}
