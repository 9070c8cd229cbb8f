//! `grafika sample`: points of a curve or a surface as CSV or JSON.

use crate::curve::{CurveArgs, Curved};
use crate::source::is_stream;
use clap::Args;
use grafika::figure::{curve_csv, curve_json, surface_csv, surface_json};
use grafika::geometry::{GeometryError, ParamCurve, ParamSurface, Sample as Place, SurfaceSample};
use grafika::launch::{Failure, progress, write_output};
use std::path::PathBuf;

/// Steps a span of a surface, as most programs of the book draw them.
pub(crate) const SURFACE_STEPS: u32 = 10;

/// The command line of `grafika sample`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika sample A.IP2 --method spline --closed --per-span 20
  grafika sample A.ZMS -o a.json
  cat six.json | grafika sample - --from json --method bspline3 -o - --to json > points.json")]
pub(crate) struct Sample {
    #[command(flatten)]
    curve: CurveArgs,
    /// Steps a span: u = 0, 1/N, ... 1 [default: 50, of surfaces 10 in either direction]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    per_span: Option<u32>,
    /// Where to write; .csv or .json [default: CSV on standard output]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Format of what is written, csv or json, where no name says it
    #[arg(long, value_name = "EXT", value_parser = ["csv", "json"], ignore_case = true)]
    to: Option<String>,
}

impl Sample {
    /// Samples and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let steps = self.per_span.unwrap_or(50) as usize;
        let curved = self.curve.curve()?;
        let alive = progress::alive("sampling");
        let text = match curved {
            Curved::Plane(_, curve) => self.text(curve.sample(steps)),
            Curved::Varying(_, curve) => self.text(curve.sample(steps)),
            Curved::Space(_, curve) => self.text(curve.sample(steps)),
            Curved::Fourier(curve) => self.text(curve.sample(steps)),
            Curved::Surface(surfaced) => {
                let steps = self.per_span.unwrap_or(SURFACE_STEPS) as usize;
                let samples: Vec<SurfaceSample> = surfaced.surface.sample(steps).map_err(Failure::work)?;
                self.table(samples.into_iter(), surface_csv, surface_json)
            }
        }?;
        drop(alive);
        write_output(self.output.as_deref(), text.as_bytes())
    }

    fn text<const D: usize>(&self, samples: Result<Vec<Place<D>>, GeometryError>) -> Result<String, Failure> {
        let samples = samples.map_err(Failure::work)?;
        let rows = samples.iter().map(|sample| (sample.span, sample.u, sample.point));
        self.table(rows, curve_csv, curve_json)
    }

    /// The rows in the format of the output.
    fn table<I>(&self, rows: I, csv: fn(I) -> String, json: fn(I) -> String) -> Result<String, Failure> {
        let said = self.to.as_ref().map(|said| said.to_lowercase());
        match said.or_else(|| extension(self.output.as_deref())).as_deref() {
            None | Some("csv") => Ok(csv(rows)),
            Some("json") => Ok(json(rows)),
            Some(other) => {
                Err(Failure::usage(format!("-o: samples are written as .csv or .json, not .{other}")))
            }
        }
    }
}

/// The extension of an output file in lower case; none for standard output.
pub(crate) fn extension(path: Option<&std::path::Path>) -> Option<String> {
    let path = path.filter(|path| !is_stream(path))?;
    Some(path.extension().map(|extension| extension.to_string_lossy().to_lowercase()).unwrap_or_default())
}
