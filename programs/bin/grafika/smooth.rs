//! `grafika smooth`: measured points smoothed by a B-spline and a Bézier curve (section 2.3.8).

use crate::at::Columns;
use crate::source::{InputFormat, apart, is_stream, kind_by_extension, output_kind};
use clap::{Args, ValueEnum};
use grafika::figure::{quantity_csv, quantity_json};
use grafika::file::{Document, FileKind, Format, PlanePoints, SpacePoints};
use grafika::geometry::{
    GeometryError, Point, Residuals, Smoothed, Smoothing, Stage, smooth, smoothed_tangents,
};
use grafika::launch::{Failure, Overwrite, TableArgs, answer, open_as, progress, say, write_output};
use serde_json::{Value, json};
use std::path::PathBuf;

/// The command line of `grafika smooth`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika smooth Y.IP2 -o y.csv
  grafika smooth Y.IP2 --stage bspline -o smooth.ip2
  grafika smooth Y.IP2 -o y.csv --json
  grafika smooth Y.IP2 --slopes --density 8 -o slopes.csv
  grafika smooth scope.csv --columns time,volts -o smooth.csv
  cat measured.csv | grafika smooth - --from csv -o - > smooth.csv")]
pub(crate) struct Smooth {
    /// Measured points: .IP2, .IC2, .IP3, a table as .csv, .json, a built-in sample, or - for standard input
    input: PathBuf,
    #[command(flatten)]
    from: InputFormat,
    #[command(flatten)]
    table: TableArgs,
    /// Where to write the points: .csv and .json as they are, .IP3, .IP2 and .IC2 rounded to whole numbers
    /// (which must lie in the field of 560x380); - is CSV on standard output
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Format of what is written, where no name says it [default on standard output: csv]
    #[arg(long, value_name = "EXT", value_parser = kind_by_extension)]
    to: Option<FileKind>,
    /// The step or both steps to take
    #[arg(long, value_enum, value_name = "STAGE", default_value_t = StageName::Both)]
    stage: StageName,
    /// Points of the B-spline for every measured point that the Bézier curve approaches; more smooth less
    /// [default: 16]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    density: Option<u32>,
    /// Write the slopes of the smooth curve at the points too, dy/dx and in space dz/dx; for .csv and .json
    #[arg(long)]
    slopes: bool,
    /// Tell the residuals as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// A stage by its name.
#[derive(Clone, Copy, ValueEnum)]
enum StageName {
    /// The cubic B-spline
    Bspline,
    /// The Bézier curve by the measured points
    Bezier,
    /// The B-spline, then the Bézier curve by its points
    Both,
}

impl Smooth {
    /// Smooths, writes, and says how far the points have moved.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if self.density.is_some() && !matches!(self.stage, StageName::Both) {
            return Err(Failure::usage("--density is for both steps together, --stage both"));
        }
        apart(&self.input, Some(&self.output))?;
        let to_stdout = is_stream(&self.output);
        if self.json && to_stdout {
            return Err(Failure::usage(
                "--json needs standard output for itself: name a file, as in -o FILE",
            ));
        }
        let kind = output_kind(&self.output, self.to.or(to_stdout.then_some(FileKind::Csv)))?;
        if let (true, FileKind::Dos(format)) = (self.slopes, kind) {
            return Err(Failure::usage(format!(
                "--slopes: .{} has no place for slopes; write .csv or .json",
                format.extension()
            )));
        }
        let mut opened = open_as(&self.input, self.from.from, &self.table.options())?;
        if let Document::Cloud(cloud) = &opened.document {
            // Measured points may come as a cloud whose points follow each other.
            let format = if cloud.is_plane() { Format::Ip2 } else { Format::Ip3 };
            opened.document = opened.document.adapted(format);
        }
        let alive = progress::alive("smoothing");
        let failure = |error: GeometryError| Failure::work(format!("{}: {}", opened.name, self.said(&error)));
        let sloped;
        let (document, residuals) = match &opened.document {
            Document::PlanePoints(plane) => {
                let Smoothed { points, residuals } = self.smoothed(&plane.points).map_err(failure)?;
                sloped = self.sloped(&plane.points, &points, kind).map_err(failure)?;
                (Document::PlanePoints(PlanePoints::new(stored(kind, points))), residuals)
            }
            Document::SpacePoints(space) => {
                let Smoothed { points, residuals } = self.smoothed(&space.points).map_err(failure)?;
                sloped = self.sloped(&space.points, &points, kind).map_err(failure)?;
                (Document::SpacePoints(SpacePoints::new(points)), residuals)
            }
            _ => {
                return Err(Failure::work(format!(
                    "{}: this file holds no points; .IP2, .IC2, .IP3, .csv, .json and clouds (.xyz, .ply, .obj, .stl) can",
                    opened.name
                )));
            }
        };
        drop(alive);
        let document = match kind {
            FileKind::Dos(format) => document.adapted(format),
            FileKind::Json | FileKind::Csv => document,
        };
        let encoded = || {
            document.encode(kind).map_err(|error| {
                Failure::work(format!("{} as {}: {error}", opened.name, self.output.display()))
            })
        };
        let content = sloped.map_or_else(encoded, |text| Ok(text.into_bytes()))?;
        self.overwrite.write(Some(&self.output), &content)?;
        let line = match self.json {
            true => as_json(&opened.name, &residuals).to_string(),
            false => format!("{}: {}", opened.name, told(&residuals)),
        };
        match to_stdout {
            // The points have standard output to themselves.
            true => say("grafika", &line),
            false if self.json => write_output(format!("{line}\n").as_bytes())?,
            false => answer(&format!("{line}\n"))?,
        }
        Ok(())
    }

    fn smoothed<const D: usize>(&self, points: &[Point<D>]) -> Result<Smoothed<D>, GeometryError> {
        smooth(points, self.smoothing(points.len()))
    }

    /// The smoothed points with their slopes as a table, if it is asked for.
    fn sloped<const D: usize>(
        &self,
        measured: &[Point<D>],
        smoothed: &[Point<D>],
        kind: FileKind,
    ) -> Result<Option<String>, GeometryError> {
        if !self.slopes {
            return Ok(None);
        }
        let tangents = smoothed_tangents(measured, self.smoothing(measured.len()))?;
        let columns = Columns { derivatives: 0, slopes: true };
        let rows = smoothed.iter().zip(tangents).map(|(&point, tangent)| columns.numbers(&[point, tangent]));
        let (rows, names) = (rows.collect::<Vec<_>>(), columns.names::<D>());
        let header: Vec<&str> = names.iter().map(String::as_str).collect();
        Ok(Some(match kind {
            FileKind::Json => quantity_json(&header, 0, &rows),
            _ => quantity_csv(&header, &rows),
        }))
    }

    /// How so many points are smoothed.
    fn smoothing(&self, measured: usize) -> Smoothing {
        let stage = match self.stage {
            StageName::Bspline => Stage::BSpline,
            StageName::Bezier => Stage::Bezier,
            StageName::Both => Stage::Both,
        };
        let usual = Smoothing::of(measured);
        let density = self.density.map_or(usual.density, |density| density as usize);
        Smoothing { stage, density, ..usual }
    }

    /// An error, with the option that avoids it.
    fn said(&self, error: &GeometryError) -> String {
        match error {
            GeometryError::TooManyPoints { .. } if self.density.is_some_and(|density| density > 1) => {
                format!("{error}; a smaller --density needs fewer")
            }
            _ => error.to_string(),
        }
    }
}

/// The points as a file of a kind holds them: those of the plane in whole numbers in the DOS files.
fn stored(kind: FileKind, points: Vec<Point<2>>) -> Vec<Point<2>> {
    match kind {
        FileKind::Dos(Format::Ip2 | Format::Ic2) => {
            points.into_iter().map(|point| point.map(f64::round_ties_even)).collect()
        }
        _ => points,
    }
}

fn as_json(name: &str, residuals: &Residuals) -> Value {
    json!({ "file": name, "rms": residuals.rms, "largest": residuals.largest, "at": residuals.at })
}

/// The residuals before any rounding, in a line.
fn told(residuals: &Residuals) -> String {
    let [rms, largest] = residuals.texts(4);
    format!("RMS residual {rms}, largest {largest} at point {}", residuals.at)
}
