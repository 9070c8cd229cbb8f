//! `grafika knots`: what becomes of a B-spline when its knots move, and which knots bring it through a point.

use crate::numbers::{Numbers, places, row};
use crate::source::Source;
use clap::{Args, Subcommand};
use grafika::design::knots::{Curve, curve, document};
use grafika::file::{Document, KnotNet, Places};
use grafika::geometry::knots::{KnotCurve, KnotError, Pair, Through, Way};
use grafika::geometry::{Point, norm};
use grafika::launch::{Failure, Overwrite, meant, words, write_output};
use serde_json::{Value, json};
use std::path::PathBuf;

/// The command line of `grafika knots`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika knots path A.CSM --knot 6 --span 6 --at 6.5 --values 5.2,5.6,6
  grafika knots envelope A.CSM --knot 6 --at 5.5,6
  grafika knots through B.CSM --point 280,219 --by any
  grafika knots insert A.CSM --at 6.5 -o a.csm")]
pub(crate) struct Knots {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Where the point at a parameter goes while a knot takes other values
    Path(PathArgs),
    /// The envelope of all curves that a knot makes
    Envelope(EnvelopeArgs),
    /// Where the arcs before and after a knot end when it moves without end
    #[command(after_help = "Examples:\n  grafika knots limits B.CSM --knot 5")]
    Limits(KnotArgs),
    /// Where a point goes while two knots move against each other
    Symmetric(SymmetricArgs),
    /// Knots, or weights, that bring the curve through a point
    Through(ThroughArgs),
    /// Add a knot; the curve stays as it is
    Insert(InsertArgs),
    /// Take a knot away, if the curve stays as it is
    Remove(RemoveArgs),
    /// Raise the order by one; the curve stays as it is
    #[command(after_help = "Examples:\n  grafika knots elevate D.CSM -o d.csm")]
    Elevate(DocumentArgs),
}

/// A document that is made of another.
#[derive(Args)]
struct DocumentArgs {
    #[command(flatten)]
    source: Source,
    /// Where to write [default: standard output]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    #[command(flatten)]
    overwrite: Overwrite,
}

#[derive(Args)]
#[command(after_help = "Examples:\n  grafika knots path A.CSM --knot 6 --span 6 --at 6.5 --values 5.2,5.6,6")]
struct PathArgs {
    #[command(flatten)]
    source: Source,
    /// The knot that moves, counted from 0
    #[arg(long, value_name = "I")]
    knot: usize,
    /// The span of the arc: span J is from knot J to knot J + 1
    #[arg(long, value_name = "J")]
    span: usize,
    /// The parameter of the point
    #[arg(long, value_name = "U", allow_negative_numbers = true)]
    at: f64,
    /// Values of the knot
    #[arg(long, value_name = "V,...", allow_hyphen_values = true)]
    values: Numbers,
}

#[derive(Args)]
struct KnotArgs {
    #[command(flatten)]
    source: Source,
    /// The knot, counted from 0, the first of equal ones
    #[arg(long, value_name = "I")]
    knot: usize,
    /// How many equal knots move together
    #[arg(long, value_name = "M", default_value_t = 1)]
    multiplicity: usize,
}

#[derive(Args)]
#[command(
    after_help = "Examples:\n  grafika knots envelope A.CSM --knot 6\n  grafika knots envelope A.CSM --knot 6 --at 5.5,6"
)]
struct EnvelopeArgs {
    #[command(flatten)]
    knot: KnotArgs,
    /// Parameters of points of the envelope
    #[arg(long, value_name = "V,...", allow_hyphen_values = true)]
    at: Option<Numbers>,
}

#[derive(Args)]
#[command(after_help = "Examples:\n  grafika knots symmetric B.CSM --knot 1 --at 3.5 --values 0,0.25")]
struct SymmetricArgs {
    #[command(flatten)]
    source: Source,
    /// The first knot; the second is 2k - 3 further
    #[arg(long, value_name = "I")]
    knot: usize,
    /// The parameter of the point
    #[arg(long, value_name = "U", allow_negative_numbers = true)]
    at: f64,
    /// By how much the first knot grows and the second falls
    #[arg(long, value_name = "T,...", allow_hyphen_values = true)]
    values: Numbers,
}

#[derive(Args)]
#[command(after_help = "Examples:
  grafika knots through B.CSM --point 280,219 --by any
  grafika knots through B.CSM --point 280,219 --by pair:outer --knot 5 --at 5
  grafika knots through B.CSM --point 290,220 --by one --knot 5
  grafika knots through A.CSF --point 25,25,86 --by outer --at 5.5,5.5")]
struct ThroughArgs {
    #[command(flatten)]
    source: Source,
    /// The point, X,Y or X,Y,Z
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    point: Numbers,
    /// What moves: outer, pair:outer, pair:left, pair:right, pair:left-cross, pair:right-cross, pair:inner, one,
    /// weights, or any
    #[arg(long, value_name = "WAY", value_parser = By::parse, add = words(&WAYS))]
    by: By,
    /// The span, for outer
    #[arg(long, value_name = "J")]
    span: Option<usize>,
    /// The knot, for pair, one and weights
    #[arg(long, value_name = "I")]
    knot: Option<usize>,
    /// The knot's new value, for weights
    #[arg(long, value_name = "V", allow_negative_numbers = true)]
    value: Option<f64>,
    /// The parameter of the point; U,V of a surface
    #[arg(long, value_name = "U", allow_hyphen_values = true)]
    at: Option<Numbers>,
    /// The two control points whose weights change, counted from 0, for weights
    #[arg(long, value_name = "A,B")]
    weights: Option<Numbers>,
}

/// The names of what moves.
const WAYS: [&str; 10] = [
    "outer",
    "pair:outer",
    "pair:left",
    "pair:right",
    "pair:left-cross",
    "pair:right-cross",
    "pair:inner",
    "one",
    "weights",
    "any",
];

/// What moves.
#[derive(Clone, Copy, Debug, PartialEq)]
enum By {
    Outer,
    Pair(Pair),
    One,
    Weights,
    Any,
}

impl By {
    fn parse(text: &str) -> Result<By, String> {
        let pair = |name: &str| Pair::ALL.into_iter().find(|pair| pair.name() == name).map(By::Pair);
        let by = match text {
            "outer" => Some(By::Outer),
            "one" => Some(By::One),
            "weights" => Some(By::Weights),
            "any" => Some(By::Any),
            _ => text.strip_prefix("pair:").and_then(pair),
        };
        by.ok_or_else(|| format!("there are {}{}", WAYS.join(", "), meant(text, WAYS)))
    }

    fn name(self) -> String {
        match self {
            By::Outer => "outer".to_owned(),
            By::Pair(pair) => format!("pair:{}", pair.name()),
            By::One => "one".to_owned(),
            By::Weights => "weights".to_owned(),
            By::Any => "any".to_owned(),
        }
    }
}

impl Source {
    /// The curve by its knots in a file; points of other programs are those of a uniform cubic one.
    fn knot_curve(&self) -> Result<Curve, Failure> {
        let opened = self.open()?;
        match opened.document.adapted(grafika::file::Format::Csm) {
            Document::Knots(points) => {
                curve(&points).map_err(|error| Failure::work(format!("{}: {error}", opened.name)))
            }
            _ => Err(Failure::work(format!("{} holds no curve by control points", opened.name))),
        }
    }

    /// The plane curve by its knots in a file.
    fn plane_knot_curve(&self) -> Result<KnotCurve<2>, Failure> {
        match self.knot_curve()? {
            Curve::Plane(curve) => Ok(curve),
            Curve::Space(_) => {
                Err(Failure::usage("this is for curves of the plane, and this one is in space"))
            }
        }
    }
}

/// One line of JSON on standard output.
fn answer(value: &Value) -> Result<(), Failure> {
    write_output(format!("{value}\n").as_bytes())
}

/// The same for curves of the plane and in space.
macro_rules! either {
    ($curve:expr, $name:ident => $body:expr) => {
        match $curve {
            Curve::Plane($name) => $body,
            Curve::Space($name) => $body,
        }
    };
}

impl Knots {
    /// Computes and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        match &self.command {
            Command::Path(args) => {
                either!(args.source.knot_curve()?, curve => {
                    let path = curve.path(args.knot, args.span, args.at).map_err(Failure::work)?;
                    let points = args.values.0.iter().map(|&value| row("value", value, path.at(value)));
                    answer(&points.collect())
                })
            }
            Command::Envelope(EnvelopeArgs { knot, at }) => {
                either!(knot.source.knot_curve()?, curve => envelope(&curve, knot, at.as_ref()))
            }
            Command::Limits(args) => either!(args.source.knot_curve()?, curve => {
                let limits = curve.limits(args.knot, args.multiplicity).map_err(Failure::work)?;
                let [minus, plus] = [limits.after, limits.before].map(|it| it.map(|it| it.to_vec()));
                answer(&json!({ "minus": minus, "plus": plus }))
            }),
            Command::Symmetric(args) => either!(args.source.knot_curve()?, curve => {
                let path = curve.opposed(args.knot, args.at).map_err(Failure::work)?;
                let points: Value =
                    args.values.0.iter().map(|&value| row("value", value, path.at(value))).collect();
                answer(&json!({ "straight": path.straight(), "points": points }))
            }),
            Command::Through(args) => args.run(),
            Command::Insert(args) => args.run(),
            Command::Remove(args) => args.run(),
            Command::Elevate(args) => {
                either!(args.source.knot_curve()?, curve => args.write(curve.elevated()))
            }
        }
    }
}

fn envelope<const D: usize>(
    curve: &KnotCurve<D>,
    args: &KnotArgs,
    at: Option<&Numbers>,
) -> Result<(), Failure> {
    let envelope = curve.envelope(args.knot, args.multiplicity).map_err(Failure::work)?;
    let [from, to] = envelope.curve.vector().domain();
    let rows: Vec<Value> = at
        .iter()
        .flat_map(|at| &at.0)
        .map(|&v| match envelope.curve.point_at(v) {
            Some(point) => Ok(row("v", v, Some(point))),
            None => Err(Failure::work(KnotError::Outside { name: "v", value: v, range: [from, to] })),
        })
        .collect::<Result<_, _>>()?;
    answer(&json!({
        "order": envelope.curve.vector().order(),
        "knots": envelope.knots,
        "points": envelope.curve.points().iter().map(|point| point.to_vec()).collect::<Vec<_>>(),
        "weights": envelope.curve.weights(),
        "from": from,
        "to": to,
        "at": rows,
        "curvature_ratio": envelope.curvature_ratio,
    }))
}

impl DocumentArgs {
    fn write<const D: usize>(&self, curve: Result<KnotCurve<D>, KnotError>) -> Result<(), Failure>
    where
        Places: From<Vec<Point<D>>>,
    {
        let document = Document::from(document(&curve.map_err(Failure::work)?));
        let text = document.to_json().map_err(Failure::work)?;
        self.overwrite.write(self.output.as_deref(), text.as_bytes())
    }
}

#[derive(Args)]
#[command(after_help = "Examples:\n  grafika knots insert A.CSM --at 6.5 -o a.csm")]
struct InsertArgs {
    #[command(flatten)]
    document: DocumentArgs,
    /// Where the new knot is
    #[arg(long, value_name = "U", allow_negative_numbers = true)]
    at: f64,
}

impl InsertArgs {
    fn run(&self) -> Result<(), Failure> {
        either!(self.document.source.knot_curve()?, curve => self.document.write(curve.with_inserted(self.at)))
    }
}

#[derive(Args)]
#[command(after_help = "Examples:\n  grafika knots remove A.CSM --knot 6 --tolerance 20 -o a.csm")]
struct RemoveArgs {
    #[command(flatten)]
    document: DocumentArgs,
    /// The knot
    #[arg(long, value_name = "I")]
    knot: usize,
    /// How far the curve may move, in the unit of the points [default: 1e-9 of the size]
    #[arg(long, value_name = "T")]
    tolerance: Option<f64>,
}

impl RemoveArgs {
    fn run(&self) -> Result<(), Failure> {
        if self.tolerance.is_some_and(|tolerance| !(tolerance >= 0.0 && tolerance.is_finite())) {
            return Err(Failure::usage("--tolerance: give a distance of 0 or more"));
        }
        either!(self.document.source.knot_curve()?, curve => {
            let tolerance = self.tolerance.unwrap_or_else(|| 1e-9 * size(curve.points()));
            self.document.write(curve.with_removed(self.knot, tolerance).map(|(curve, _)| curve))
        })
    }
}

/// The size of points: the diagonal of the box around them.
fn size<const D: usize>(points: &[Point<D>]) -> f64 {
    grafika::geometry::BoundingBox::of_points(points)
        .map_or(1.0, |it| norm::<D>(std::array::from_fn(|d| it.max[d] - it.min[d])))
}

impl ThroughArgs {
    fn run(&self) -> Result<(), Failure> {
        self.check()?;
        let opened = self.source.open()?;
        if let Document::KnotNet(net) = &opened.document {
            if self.span.is_some() {
                return Err(Failure::usage("--span is for curves; this file holds a surface"));
            }
            return self.surface(net);
        }
        let point: Point<2> = places(&self.point, "--point", "X,Y")?;
        let curve = self.source.plane_knot_curve()?;
        match self.found(&curve, point)? {
            Ok((by, through)) => {
                let knots = through.curve.vector().knots();
                let mut told = json!({ "admissible": true, "by": by, "u": through.u, "knots": knots });
                if let Some(weights) = through.curve.weights() {
                    told["weights"] = json!(weights);
                }
                answer(&told)
            }
            Err(reason) => {
                let mut told = json!({ "admissible": false, "reason": reason.to_string() });
                // The nearest point is the point itself where only this way does not reach it.
                if let Ok((way, _)) = curve.through_any(point) {
                    told["reached_by"] = json!(way_name(way));
                } else if let Ok(nearest) = curve.nearest_reached(point) {
                    told["nearest"] = json!(nearest.to_vec());
                }
                answer(&told)?;
                Err(Failure::work(reason))
            }
        }
    }

    /// Refuses options that belong to another way.
    fn check(&self) -> Result<(), Failure> {
        let (outer, weights, any) = (self.by == By::Outer, self.by == By::Weights, self.by == By::Any);
        let unused = [
            ("--span", self.span.is_some() && !outer),
            ("--knot", self.knot.is_some() && (outer || any)),
            ("--value", self.value.is_some() && !weights),
            ("--at", self.at.is_some() && (any || self.by == By::One)),
            ("--weights", self.weights.is_some() && !weights),
        ];
        match unused.into_iter().find(|(_, unused)| *unused) {
            Some((option, _)) => {
                Err(Failure::usage(format!("{option} is for another way than --by {}", self.by.name())))
            }
            None => Ok(()),
        }
    }

    /// The way and the curve; inside, why there is none.
    fn found(
        &self,
        curve: &KnotCurve<2>,
        point: Point<2>,
    ) -> Result<Result<(String, Through<2>), KnotError>, Failure> {
        let by = self.by;
        let at = || self.at.as_ref().map(|at| places(at, "--at", "U").map(|[u]: [f64; 1]| u)).transpose();
        let found = match by {
            By::Any => curve.through_any(point).map(|(way, through)| (way_name(way), through)),
            By::Outer => {
                let (span, u) = (needed(self.span, "--span")?, needed(at()?, "--at")?);
                curve.through_outer(point, span, u).map(|through| (by.name(), through))
            }
            By::Pair(pair) => {
                let knot = needed(self.knot, "--knot")?;
                // The touching point is at the knot's present value, if no other is asked for.
                let present = curve.vector().knots().get(knot).copied();
                let t = needed(at()?.or(present), "--at")?;
                curve.through_pair(point, knot, t, pair).map(|through| (by.name(), through))
            }
            By::One => {
                let knot = needed(self.knot, "--knot")?;
                let found = curve.through_knot(point, knot).and_then(|found| {
                    let effort = |it: &Through<2>| it.effort(curve.vector());
                    let least = found.into_iter().min_by(|a, b| effort(a).total_cmp(&effort(b)));
                    least.ok_or(grafika::geometry::knots::Unreached::NotFound.into())
                });
                found.map(|through| (by.name(), through))
            }
            By::Weights => {
                let pair: [f64; 2] = places(&needed(self.weights.clone(), "--weights")?, "--weights", "A,B")?;
                let whole = |x: f64| (x >= 0.0 && x.fract() == 0.0 && x < 1e9).then_some(x as usize);
                let [Some(a), Some(b)] = pair.map(whole) else {
                    return Err(Failure::usage("--weights: give the numbers of two control points, from 0"));
                };
                let knot = needed(self.knot, "--knot")?;
                let value = needed(self.value.or(curve.vector().knots().get(knot).copied()), "--value")?;
                let u = needed(at()?, "--at")?;
                curve.through_weights(point, (knot, value), u, [a, b]).map(|through| (by.name(), through))
            }
        };
        match found {
            Err(error @ KnotError::Unreached(_)) => Ok(Err(error)),
            Err(error) => Err(Failure::work(error)),
            Ok(found) => Ok(Ok(found)),
        }
    }

    fn surface(&self, net: &KnotNet) -> Result<(), Failure> {
        if self.by != By::Outer {
            return Err(Failure::usage("surfaces have --by outer alone"));
        }
        let point: Point<3> = places(&self.point, "--point", "X,Y,Z")?;
        let at: [f64; 2] = places(&needed(self.at.clone(), "--at")?, "--at", "U,V")?;
        let surface = net.surface().map_err(Failure::work)?;
        match surface.through_outer(point, at) {
            Ok(found) => {
                let knots = found.vectors().each_ref().map(|vector| vector.knots().to_vec());
                answer(&json!({ "admissible": true, "at": at, "knots": knots }))
            }
            Err(reason @ KnotError::Unreached(_)) => {
                answer(&json!({ "admissible": false, "reason": reason.to_string() }))?;
                Err(Failure::work(reason))
            }
            Err(error) => Err(Failure::work(error)),
        }
    }
}

fn way_name(way: Way) -> String {
    match way {
        Way::Outer(span) => format!("outer of span {span}"),
        Way::Pair(knot, pair) => format!("pair:{} of knot {knot}", pair.name()),
        Way::Knot(knot) => format!("knot {knot}"),
    }
}

/// An option that this way needs.
fn needed<T>(value: Option<T>, option: &str) -> Result<T, Failure> {
    value.ok_or_else(|| Failure::usage(format!("this way needs {option}")))
}
