//! `grafika shape`: what becomes of a curve when its shape parameters change, and which bring it through points.

use crate::at::positions;
use crate::numbers::{Numbers, places, row};
use crate::source::Source;
use clap::builder::PossibleValuesParser;
use clap::{Args, Subcommand};
use grafika::design::shaped::{Curve, curve};
use grafika::file::{Document, FamilyName, Format, LambdaValue, Places, ShapedPoints};
use grafika::geometry::Point;
use grafika::geometry::shaped::{Parameter, ShapedCurve, elevate_cyclic, interpolate};
use grafika::launch::{Failure, Overwrite, meant, words, write_output};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// The command line of `grafika shape`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika shape path FELKOR.ALP --at 0.5 --parameter alpha --values 0.5,1,2,3
  grafika shape through HAN.ALP --parameter lambda:4 --point 280,290
  grafika shape interpolate A.IP2 --family han --value 0.5 --closed -o a.alp
  grafika shape elevate KOR.ALP --by 2 -o b.alp")]
pub(crate) struct Shape {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Where a point goes while a parameter takes other values
    Path(PathArgs),
    /// The value of a parameter that brings the curve through a point
    Through(ThroughArgs),
    /// The curve of a family through points
    Interpolate(InterpolateArgs),
    /// Raise the degree of a cyclic curve; the curve stays as it is
    Elevate(ElevateArgs),
}

#[derive(Args)]
#[command(
    after_help = "Examples:\n  grafika shape path FELKOR.ALP --at 0.5 --parameter alpha --values 0.5,1,2,3"
)]
struct PathArgs {
    #[command(flatten)]
    source: Source,
    /// The position of the point: span + x, 0 to 1 on Bezier curves, 0 to 2 pi on cyclic ones
    #[arg(long, value_name = "X")]
    at: f64,
    /// alpha, beta, omega or lambda; lambda:K is that of control point K, from 0
    #[arg(long, value_name = "NAME", value_parser = parameter, add = words(&PARAMETERS))]
    parameter: Parameter,
    /// Values of the parameter
    #[arg(long, value_name = "V,...", allow_hyphen_values = true)]
    values: Numbers,
}

#[derive(Args)]
#[command(after_help = "Examples:\n  grafika shape through HAN.ALP --parameter lambda:4 --point 280,290")]
struct ThroughArgs {
    #[command(flatten)]
    source: Source,
    /// alpha, beta, omega or lambda; lambda:K is that of control point K, from 0
    #[arg(long, value_name = "NAME", value_parser = parameter, add = words(&PARAMETERS))]
    parameter: Parameter,
    /// The point, X,Y or X,Y,Z
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    point: Numbers,
}

#[derive(Args)]
#[command(
    after_help = "Examples:\n  grafika shape interpolate A.IP2 --family han --value 0.5 --closed -o a.alp"
)]
struct InterpolateArgs {
    #[command(flatten)]
    source: Source,
    /// The family
    #[arg(long, value_parser = PossibleValuesParser::new(SPLINES))]
    family: String,
    /// lambda, of c-bspline alpha, of f-bspline omega
    #[arg(long, value_name = "V", allow_negative_numbers = true)]
    value: f64,
    /// Join the last point to the first
    #[arg(long)]
    closed: bool,
    /// Where to write [default: standard output]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    #[command(flatten)]
    overwrite: Overwrite,
}

#[derive(Args)]
#[command(after_help = "Examples:\n  grafika shape elevate KOR.ALP --by 2 -o b.alp")]
struct ElevateArgs {
    #[command(flatten)]
    source: Source,
    /// By how much
    #[arg(long, value_name = "R")]
    by: usize,
    /// Where to write [default: standard output]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// The families that interpolate.
const SPLINES: [&str; 6] = ["c-bspline", "f-bspline", "han", "alpha", "gb", "spb"];

/// The names of parameters.
const PARAMETERS: [&str; 4] = ["alpha", "beta", "omega", "lambda"];

/// Reads the name of a parameter.
fn parameter(text: &str) -> Result<Parameter, String> {
    let wanted = "there are alpha, beta, omega, lambda, and lambda:K for control point K, from 0";
    Ok(match text {
        "alpha" => Parameter::Alpha,
        "beta" => Parameter::Beta,
        "omega" => Parameter::Omega,
        "lambda" => Parameter::Lambda,
        _ => {
            let index = text.strip_prefix("lambda:").and_then(|index| index.parse().ok());
            let alike = || format!("{wanted}{}", meant(text, PARAMETERS));
            Parameter::LambdaOf(index.ok_or_else(alike)?)
        }
    })
}

impl Source {
    /// The curve with shape parameters in a file; other points are those of a uniform cubic B-spline.
    fn shaped(&self) -> Result<ShapedPoints, Failure> {
        let opened = self.open()?;
        match opened.document.adapted(Format::Alp) {
            Document::Shaped(points) => Ok(*points),
            _ => Err(Failure::work(format!("{} holds no curve by control points", opened.name))),
        }
    }
}

fn written(document: ShapedPoints, output: Option<&Path>, overwrite: Overwrite) -> Result<(), Failure> {
    let text = Document::from(document).to_json().map_err(Failure::work)?;
    overwrite.write(output, text.as_bytes())
}

impl Shape {
    /// Computes and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match &self.command {
            Command::Path(args) => {
                let document = args.source.shaped()?;
                match curve(&document).map_err(Failure::work)? {
                    Curve::Plane(curve) => args.run(&document, &curve),
                    Curve::Space(curve) => args.run(&document, &curve),
                }
            }
            Command::Through(args) => {
                let document = args.source.shaped()?;
                match curve(&document).map_err(Failure::work)? {
                    Curve::Plane(curve) => args.run(&document, &curve),
                    Curve::Space(curve) => args.run(&document, &curve),
                }
            }
            Command::Interpolate(args) => args.run(),
            Command::Elevate(args) => args.run(),
        }
    }
}

impl PathArgs {
    fn run<const D: usize>(&self, document: &ShapedPoints, curve: &ShapedCurve<D>) -> Result<(), Failure> {
        let [from, to] = positions(curve, document.family);
        if !(from..=to).contains(&self.at) {
            return Err(Failure::work(format!(
                "the position is {}; it must be between {from} and {to}",
                self.at
            )));
        }
        let (span, x) = curve.basis().place(self.at);
        let points = curve.path(self.parameter, span, x, &self.values.0).map_err(Failure::work)?;
        let points = self.values.0.iter().zip(points);
        let rows: Value = points.map(|(&value, point)| row("value", value, Some(point))).collect();
        write_output(format!("{rows}\n").as_bytes())
    }
}

impl ThroughArgs {
    fn run<const D: usize>(&self, document: &ShapedPoints, curve: &ShapedCurve<D>) -> Result<(), Failure> {
        let target: Point<D> = places(&self.point, "--point", if D == 2 { "X,Y" } else { "X,Y,Z" })?;
        let reach = curve.through(self.parameter, target).map_err(Failure::work)?;
        let changed = curve.with(self.parameter, reach.value).map_err(Failure::work)?;
        let changed = document.with_parameters(changed.basis().family());
        let name = self.parameter.name();
        let value = match (name, &changed.lambda) {
            ("lambda", Some(LambdaValue::Each(all))) => json!(all),
            _ => json!(reach.value),
        };
        let at = curve.basis().position(reach.span, reach.x);
        let told = match reach.admissible {
            true => json!({ "admissible": true, "parameters": { name: value }, "at": at }),
            false => json!({
                "admissible": false,
                "reason": NOT_REACHABLE,
                "nearest": reach.point.to_vec(),
                "parameters": { name: value },
                "at": at,
            }),
        };
        write_output(format!("{told}\n").as_bytes())?;
        if reach.admissible { Ok(()) } else { Err(Failure::work(NOT_REACHABLE)) }
    }
}

const NOT_REACHABLE: &str = "not reachable: no value of this parameter brings the curve through the point";

impl InterpolateArgs {
    fn run(&self) -> Result<(), Failure> {
        let family = FamilyName::of_name(&self.family).unwrap_or_default();
        let value = Some(self.value);
        let closed = self.closed;
        let mut document = ShapedPoints { family, closed, ..ShapedPoints::default() };
        match family {
            FamilyName::CBSpline => document.alpha = value,
            FamilyName::FBSpline => document.omega = value,
            _ => document.lambda = Some(LambdaValue::One(self.value)),
        }
        let parameters = document.parameters().map_err(Failure::work)?;
        let data = self.source.shaped()?.points;
        let (points, blend) = match &data {
            Places::Plane(data) => {
                let found = interpolate(&parameters, data, closed).map_err(Failure::work)?;
                (Places::from(found.points), found.blend.map(Places::from))
            }
            Places::Space(data) => {
                let found = interpolate(&parameters, data, closed).map_err(Failure::work)?;
                (Places::from(found.points), found.blend.map(Places::from))
            }
        };
        written(ShapedPoints { points, blend, ..document }, self.output.as_deref(), self.overwrite)
    }
}

impl ElevateArgs {
    fn run(&self) -> Result<(), Failure> {
        let document = self.source.shaped()?;
        if document.family != FamilyName::Cyclic {
            let name = document.family.name();
            return Err(Failure::work(format!("elevation is for cyclic curves; this is a {name} curve")));
        }
        let points = match &document.points {
            Places::Plane(points) => Places::from(elevate_cyclic(points, self.by).map_err(Failure::work)?),
            Places::Space(points) => Places::from(elevate_cyclic(points, self.by).map_err(Failure::work)?),
        };
        written(ShapedPoints { points, ..document }, self.output.as_deref(), self.overwrite)
    }
}
