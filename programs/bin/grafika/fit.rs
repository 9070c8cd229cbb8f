//! `grafika fit`: a net of neurons that learns a cloud of points, and the surface that is fitted to it.

use crate::models;
use crate::picture::Format as Picture;
use crate::sample::{SURFACE_STEPS, extension};
use crate::source::{InputFormat, apart};
use clap::Args;
use clap::builder::PossibleValuesParser;
use grafika::design::knots;
use grafika::figure::{MODEL_TOLERANCE, ModelOptions};
use grafika::file::{Document, KnotNet, SomNet, number};
use grafika::geometry::ParamSurface;
use grafika::geometry::cloud::Cloud;
use grafika::geometry::fit::{Fit, Fitted, Report};
use grafika::geometry::kohonen::{Learning, Net, Order, Rule, Topology, Weighting};
use grafika::launch::{Failure, Overwrite, TableArgs, Target, open, open_cloud, progress, say};
use std::fmt::Write;
use std::path::PathBuf;

/// Steps of learning between two looks at the progress.
const STEPS: u64 = 50_000;
/// Points of the fit between two looks at the progress.
const POINTS: usize = 100_000;

/// The command line of `grafika fit`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika fit TEREP.XYZ -o net.som
  grafika fit TEREP.XYZ -o hill.step --grid 15x15
  grafika fit scan.ply -o scan.csf --corrections 8 --residuals errors.csv
  grafika fit TORUSZ.XYZ -o ring.stl --topology torus --grid 10x16
  grafika fit NYOM.XYZ -o trace.csm --grid 30x1")]
pub(crate) struct FitArgs {
    /// Points: .xyz, .csv, .ply, .obj, .stl, a built-in sample, or - for standard input
    cloud: PathBuf,
    #[command(flatten)]
    from: InputFormat,
    #[command(flatten)]
    table: TableArgs,
    /// Where to write: .som for the net, .csf (of a polygon .csm), .step, .stl, .obj, .ply for the surface; .json for
    /// the surface with --corrections, else for the net
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Rows and columns of neurons; NxR with R = 1 is a polygon for plane clouds [default: 20x20]
    #[arg(long, value_name = "MxN", value_parser = grid, conflicts_with_all = ["grow", "initial"])]
    grid: Option<[usize; 2]>,
    /// Steps of learning [default: 100 for every neuron]
    #[arg(long, value_name = "T", conflicts_with = "grow")]
    steps: Option<u64>,
    /// Seed of the random numbers [default: 1]
    #[arg(long, value_name = "S")]
    seed: Option<u64>,
    /// How the net is joined [default: open]
    #[arg(long, value_parser = PossibleValuesParser::new(Topology::ALL.map(Topology::name)))]
    topology: Option<String>,
    /// Who learns with the winner
    #[arg(long, default_value = "gauss", value_parser = PossibleValuesParser::new(["gauss", "bubble"]), conflicts_with = "grow")]
    weighting: String,
    /// Begin with 2 x 2 neurons and insert rows and columns where the net wins most, up to so many neurons
    #[arg(long, value_name = "LIMIT", conflicts_with_all = ["initial", "order"])]
    grow: Option<usize>,
    /// Corrections of the parameters in the fit [default for surfaces: 5]
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u16).range(0..=1000))]
    corrections: Option<u16>,
    /// Where to write the signed distance of every point from the surface, as CSV
    #[arg(long, value_name = "CSV")]
    residuals: Option<PathBuf>,
    /// The net to begin with, instead of a random one
    #[arg(long, value_name = "NET")]
    initial: Option<PathBuf>,
    /// The order in which points are learnt; file goes through them once
    #[arg(long, default_value = "random", value_parser = PossibleValuesParser::new(["random", "file"]))]
    order: String,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// What is written.
enum Wanted {
    Net,
    Surface,
    Model(Picture),
}

impl FitArgs {
    /// Learns, fits and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let wanted = self.wanted()?;
        let topology = self.topology.as_deref().and_then(Topology::of_name);
        let (name, points) = open_cloud(&self.cloud, self.from.from, &self.table.options())?;
        points.skipped.told().iter().for_each(|told| say("grafika", &format!("{name}: left out: {told}")));
        let failed = |error: &dyn std::fmt::Display| Failure::work(format!("{name}: {error}"));
        let cloud = Cloud::new(points.points).map_err(|error| failed(&error))?;
        let start = self.start(&cloud, topology)?;
        self.check_kind(&wanted, start.is_polygon())?;
        let corrections = self.corrections.map_or(Fit::CORRECTIONS, usize::from);
        if !matches!(wanted, Wanted::Net) && self.grow.is_none() {
            // What the fit would refuse after all the learning is refused at once.
            Fit::new(&cloud, &start, corrections).map_err(|error| failed(&error))?;
        }
        for written in [Some(&self.output), self.residuals.as_ref()] {
            apart(&self.cloud, written.map(PathBuf::as_path))?;
        }
        // Asked before the work, not after it.
        let output = self.overwrite.target(Some(&self.output))?;
        let distances =
            self.residuals.as_deref().map(|path| self.overwrite.target(Some(path))).transpose()?;
        let mut learning = match self.grow {
            Some(limit) => Learning::growing(&cloud, start, limit, self.seed()),
            None => Learning::new(&cloud, start, self.rule()),
        }
        .map_err(|error| failed(&error))?;
        let alive = progress::alive("learning");
        while learning.advance(STEPS).is_none() {
            alive.say(format!("learning: {:.0} %", 100.0 * learning.progress()));
        }
        drop(alive);
        let [rows, columns] = learning.net().size();
        let rms =
            learning.rms().map_or(String::new(), |rms| format!(", RMS {} to the nearest neuron", short(rms)));
        say("grafika", &format!("{name}: {rows} x {columns} neurons after {} steps{rms}", learning.total()));
        if matches!(wanted, Wanted::Net) {
            let net = learning.net();
            let document = SomNet { topology: net.topology(), points: net.rows() };
            return written(&output, Document::Som(Box::new(document)));
        }
        let mut fit = Fit::new(&cloud, learning.net(), corrections).map_err(|error| failed(&error))?;
        let alive = progress::alive("fitting");
        let report = loop {
            if let Some(report) = fit.advance(POINTS) {
                break report.clone();
            }
            alive.say(format!("fitting: {:.0} %", 100.0 * fit.progress()));
        };
        drop(alive);
        say("grafika", &format!("{name}: {}", told(&report)));
        if let Some(target) = &distances {
            target.write(residuals(&cloud, fit.distances()).as_bytes())?;
        }
        let fitted = fit.fitted().map_err(|error| failed(&error))?;
        match wanted {
            Wanted::Model(format) => self.model(&output, &fitted, format),
            _ => written(
                &output,
                match &fitted {
                    Fitted::Surface(surface) => Document::KnotNet(Box::new(KnotNet::of(surface))),
                    Fitted::Curve(curve) => knots::document(curve).into(),
                },
            ),
        }
    }

    fn wanted(&self) -> Result<Wanted, Failure> {
        let fitted = self.corrections.is_some() || self.residuals.is_some();
        if self.initial.is_some() && self.order == "file" && self.seed.is_some() {
            return Err(Failure::usage("--seed: with --initial and --order file nothing is left to chance"));
        }
        let extension = extension(Some(&self.output));
        let wanted = match extension.as_deref() {
            Some("som") => Wanted::Net,
            Some("csf" | "csm") => Wanted::Surface,
            Some("json") if fitted => Wanted::Surface,
            Some("json") | None => Wanted::Net,
            Some(other) => match Picture::parse(other).ok().filter(|format| format.is_model()) {
                Some(format) => Wanted::Model(format),
                None => {
                    let known = ".som, .csf, .csm, .json, .step, .stl, .obj or .ply";
                    return Err(Failure::usage(format!(
                        "-o: nets and surfaces are written as {known}, not .{other}"
                    )));
                }
            },
        };
        if fitted && matches!(wanted, Wanted::Net) {
            let message = "--corrections and --residuals are of the fitted surface; a .som file holds the net before it";
            return Err(Failure::usage(message));
        }
        Ok(wanted)
    }

    /// A polygon becomes a curve, any other net a surface; a file of the other kind is refused before the work begins.
    fn check_kind(&self, wanted: &Wanted, polygon: bool) -> Result<(), Failure> {
        let extension = extension(Some(&self.output));
        match (wanted, polygon, extension.as_deref()) {
            (Wanted::Model(_), true, _) | (_, true, Some("csf")) => {
                Err(Failure::usage("a net of one row or column becomes a curve, which is written as .csm"))
            }
            (_, false, Some("csm")) => Err(Failure::usage(
                "this net becomes a surface, which is written as .csf; --grid Nx1 makes a curve",
            )),
            _ => Ok(()),
        }
    }

    fn seed(&self) -> u64 {
        self.seed.unwrap_or(1)
    }

    fn rule(&self) -> Rule {
        Rule {
            weighting: Weighting::of_name(&self.weighting).unwrap_or(Weighting::Gauss),
            order: if self.order == "file" { Order::Listed } else { Order::Random(self.seed()) },
            steps: self.steps,
            ..Rule::default()
        }
    }

    /// The net to begin with.
    fn start(&self, cloud: &Cloud, topology: Option<Topology>) -> Result<Net, Failure> {
        let Some(path) = &self.initial else {
            let topology = topology.unwrap_or(Topology::Open);
            let net = match self.grow {
                Some(_) => Net::seedling(cloud, topology, self.seed()),
                None => Net::random(cloud, self.grid.unwrap_or([20, 20]), topology, self.seed()),
            };
            return net.map_err(Failure::work);
        };
        let opened = open(path)?;
        let Document::Som(net) = opened.document else {
            return Err(Failure::work(format!(
                "{}: a net of neurons is needed, as a .som file holds it",
                opened.name
            )));
        };
        if let Some(other) = topology.filter(|topology| *topology != net.topology) {
            return Err(Failure::usage(format!(
                "--topology {}: the net of {} is {}",
                other.name(),
                opened.name,
                net.topology.name()
            )));
        }
        Net::new(net.topology, &net.points)
            .map_err(|error| Failure::work(format!("{}: {error}", opened.name)))
    }

    fn model(&self, output: &Target<'_>, fitted: &Fitted, format: Picture) -> Result<(), Failure> {
        // Checked before anything was learnt.
        let Some(surface) = fitted.surface() else { return Ok(()) };
        let name =
            self.output.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let options = ModelOptions { steps: SURFACE_STEPS as usize, tolerance: MODEL_TOLERANCE, name: &name };
        let surfaces: [&dyn ParamSurface; 1] = [surface];
        let Some(model) = format.model() else { return Ok(()) };
        models::write(output, model, &surfaces, &options)
    }
}

fn written(output: &Target<'_>, document: Document) -> Result<(), Failure> {
    let text = document.to_json().map_err(Failure::work)?;
    output.write(text.as_bytes())
}

/// Four digits.
fn short(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        format!("{value:.4e}").parse::<f64>().map_or_else(|_| String::new(), number)
    }
}

/// The quality of a fit in a line.
fn told(report: &Report) -> String {
    let [rms, largest, mean, most] =
        [report.rms, report.largest, report.mean, report.percentile_95].map(short);
    let history: Vec<String> = report.history.iter().copied().map(short).collect();
    format!(
        "{} points, RMS {rms}, largest {largest}, mean {mean}, 95 % within {most}; RMS by solution: {}",
        report.points,
        history.join(" ")
    )
}

/// The points with their distances, as a table.
fn residuals(cloud: &Cloud, distances: &[f64]) -> String {
    let mut text = "x,y,z,distance\n".to_owned();
    for (point, distance) in cloud.points().iter().zip(distances) {
        let [x, y, z] = point.map(number);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{x},{y},{z},{}", number(*distance));
    }
    text
}

/// Reads numbers of rows and columns.
fn grid(text: &str) -> Result<[usize; 2], String> {
    let sides = text
        .split_once(['x', 'X'])
        .and_then(|(rows, columns)| Some([rows.trim().parse().ok()?, columns.trim().parse().ok()?]));
    sides.ok_or_else(|| "give rows and columns, as in 20x20".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_are_read() {
        assert_eq!(grid("15x20"), Ok([15, 20]));
        for text in ["", "15", "x", "15x", "ax2", "2x3x4"] {
            assert!(grid(text).is_err(), "{text}");
        }
    }

    #[test]
    fn numbers_are_shortened() {
        assert_eq!([0.0203456, 0.0, 12345.678, 1e-9].map(short), ["0.020346", "0", "12346", "1e-9"]);
    }
}
