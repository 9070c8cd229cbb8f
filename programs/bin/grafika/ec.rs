//! `grafika elevate`, `split` and `exact`: other control points of the same curve or surface over extended Chebyshev
//! spaces.

use crate::source::{Source, is_stream, kind_by_extension, output_kind};
use crate::space::written_interval;
use clap::{Args, ValueEnum};
use grafika::design::ec::{Bases, MOST_PARTS, equal_parts, patch_space};
use grafika::file::ec::{Coefficients, EcDocument, Item, Scene};
use grafika::file::{Document, FileKind};
use grafika::geometry::ec::{EcError, Real, Root};
use grafika::launch::{Failure, Opened, Overwrite, progress};
use std::path::PathBuf;

/// A direction of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Along {
    U,
    V,
}

/// Where a document goes.
#[derive(Args)]
struct Target {
    /// Where to write [default: JSON on standard output]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Format of what is written (json, kcg, kcj, ...), where no name says it
    #[arg(long, value_name = "EXT", value_parser = kind_by_extension)]
    to: Option<FileKind>,
    #[command(flatten)]
    overwrite: Overwrite,
}

impl Target {
    fn write(&self, document: EcDocument) -> Result<(), Failure> {
        let document = Document::from(document);
        let output = self.output.as_deref().filter(|path| !is_stream(path));
        let kind = match (output, self.to) {
            (_, Some(kind)) => kind,
            (None, None) => FileKind::Json,
            (Some(path), None) => output_kind(path, None)?,
        };
        let content = document.encode(kind).map_err(|error| match output {
            Some(path) => Failure::work(format!("{}: {error}", path.display())),
            None => Failure::work(error),
        })?;
        self.overwrite.write(output, &content)
    }
}

/// The item in a file, with its name.
fn item(source: &Source) -> Result<(Item, String), Failure> {
    let Opened { name, document, .. } = source.open()?;
    let Document::Ec(document) = document else {
        return Err(Failure::work(format!("{name}: a .kcg or .kcf file is needed here")));
    };
    let found = match *document {
        EcDocument::Curve(curve) => Some(Item::Curve(curve)),
        EcDocument::Patch(patch) => Some(Item::Patch(patch)),
        EcDocument::Scene(mut scene) if scene.items.len() == 1 => scene.items.pop(),
        _ => None,
    };
    let problem =
        || Failure::work(format!("{name}: one curve or one patch is needed here, a .kcg or .kcf file"));
    Ok((found.ok_or_else(problem)?, name))
}

/// The direction that is meant: curves have one, patches are asked.
fn direction(item: &Item, along: Option<Along>) -> Result<usize, Failure> {
    match (item, along) {
        (Item::Curve(_), None | Some(Along::U)) | (Item::Patch(_), Some(Along::U)) => Ok(0),
        (Item::Patch(_), Some(Along::V)) => Ok(1),
        (Item::Curve(_), Some(Along::V)) => Err(Failure::usage("a curve has no direction v")),
        (Item::Patch(_), None) => {
            Err(Failure::usage("which direction of the surface? Give --along u or --along v"))
        }
    }
}

fn failed(name: &str) -> impl Fn(EcError) -> Failure {
    let name = name.to_owned();
    move |error| Failure::work(format!("{name}: {error}"))
}

/// The command line of `grafika elevate`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika elevate arc.kcg --root 0 -o finer.kcg
  grafika elevate patch.kcf --root=-1/2+i^2 --along u -o finer.kcf")]
pub(crate) struct Elevate {
    #[command(flatten)]
    source: Source,
    /// The root that the space gets; one that it has gets a higher multiplicity
    #[arg(long, value_name = "ROOT[^M]", value_parser = root, allow_hyphen_values = true)]
    root: Root,
    /// The direction of a surface
    #[arg(long)]
    along: Option<Along>,
    #[command(flatten)]
    target: Target,
}

impl Elevate {
    /// Elevates and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let (item, name) = item(&self.source)?;
        let direction = direction(&item, self.along)?;
        let mut bases = Bases::default();
        let document = match &item {
            Item::Curve(curve) => bases.elevated_curve(curve, &self.root).map(EcDocument::Curve),
            Item::Patch(patch) => bases.elevated_patch(patch, direction, &self.root).map(EcDocument::Patch),
        };
        self.target.write(document.map_err(failed(&name))?)
    }
}

/// The command line of `grafika split`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika split arc.kcg --at pi/6 -o two.kcj
  grafika split patch.kcf --parts 4 --along v -o four.kcj")]
pub(crate) struct Split {
    #[command(flatten)]
    source: Source,
    /// The parameter to divide at; an expression
    #[arg(long, value_name = "G", value_parser = real, allow_hyphen_values = true)]
    at: Option<Real>,
    /// Divide into so many parts of equal length
    #[arg(long, value_name = "M", conflicts_with = "at", value_parser = clap::value_parser!(u16).range(1..=MOST_PARTS as i64))]
    parts: Option<u16>,
    /// The direction of a surface
    #[arg(long)]
    along: Option<Along>,
    #[command(flatten)]
    target: Target,
}

impl Split {
    /// Divides and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if self.at.is_none() && self.parts.is_none() {
            return Err(Failure::usage(
                "where to divide? Give --at, as in --at pi/6, or --parts, as in --parts 4",
            ));
        }
        let (item, name) = item(&self.source)?;
        let direction = direction(&item, self.along)?;
        let interval = match &item {
            Item::Curve(curve) => &curve.interval,
            Item::Patch(patch) => patch_space(patch, direction).1,
        };
        let places: Vec<Real> = match (&self.at, self.parts) {
            (Some(at), _) => vec![at.clone()],
            (None, parts) => {
                let parts = equal_parts(interval, usize::from(parts.unwrap_or(1)));
                parts.into_iter().skip(1).map(|[start, _]| start).collect()
            }
        };
        let items = Bases::default().divided(&item, direction, &places).map_err(failed(&name))?;
        self.target.write(EcDocument::Scene(Scene { items, ..Scene::default() }))
    }
}

/// The command line of `grafika exact`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika exact SNAIL.KCE --parts auto -o snail.kcj
  grafika exact SNAIL.KCE --parts-u 4 --parts-v 3 -o snail.kcj")]
pub(crate) struct Exact {
    #[command(flatten)]
    source: Source,
    /// Interval instead of that of the file
    #[arg(long, value_name = "A,B", value_parser = written_interval, allow_hyphen_values = true)]
    interval: Option<[Real; 2]>,
    /// Interval along u instead of that of the file
    #[arg(long, value_name = "A,B", value_parser = written_interval, allow_hyphen_values = true)]
    interval_u: Option<[Real; 2]>,
    /// Interval along v instead of that of the file
    #[arg(long, value_name = "A,B", value_parser = written_interval, allow_hyphen_values = true)]
    interval_v: Option<[Real; 2]>,
    /// Arcs over so many equal parts of the interval; auto takes as few as are good
    #[arg(long, value_name = "M", value_parser = parts)]
    parts: Option<Parts>,
    /// Patches over so many equal parts along u, or auto
    #[arg(long, value_name = "M", value_parser = parts)]
    parts_u: Option<Parts>,
    /// Patches over so many equal parts along v, or auto
    #[arg(long, value_name = "M", value_parser = parts)]
    parts_v: Option<Parts>,
    #[command(flatten)]
    target: Target,
}

impl Exact {
    /// Describes and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let Opened { name, document, .. } = self.source.open()?;
        let coefficients = match document {
            Document::Ec(document) => match *document {
                EcDocument::Coefficients(coefficients) => Some(coefficients),
                _ => None,
            },
            _ => None,
        };
        let problem = || Failure::work(format!("{name}: a .kce file with coefficients is needed here"));
        let coefficients = self.over_intervals(coefficients.ok_or_else(problem)?)?;
        let alive = progress::alive("computing");
        let parts = match &coefficients {
            Coefficients::Curve { .. } => [self.parts, None],
            Coefficients::Surface { .. } => [self.parts_u.or(self.parts), self.parts_v.or(self.parts)],
        };
        let mut bases = Bases::default();
        let document = if parts == [None; 2] {
            match bases.described(&coefficients).map_err(failed(&name))? {
                Item::Curve(curve) => EcDocument::Curve(curve),
                Item::Patch(patch) => EcDocument::Patch(patch),
            }
        } else {
            // A direction that nothing is said about stays whole.
            let count = |parts: Option<Parts>| match parts {
                None => Some(1),
                Some(Parts::Auto) => None,
                Some(Parts::Many(count)) => Some(count),
            };
            let items = bases.strips(&coefficients, parts.map(count)).map_err(failed(&name))?;
            EcDocument::Scene(Scene { items, ..Scene::default() })
        };
        drop(alive);
        self.target.write(document)
    }

    /// The coefficients over the intervals that the command line says.
    fn over_intervals(&self, coefficients: Coefficients) -> Result<Coefficients, Failure> {
        let for_curves = self.interval.is_some();
        let for_surfaces = [&self.interval_u, &self.interval_v].iter().any(|it| it.is_some())
            || [self.parts_u, self.parts_v].iter().any(|it| it.is_some());
        Ok(match coefficients {
            Coefficients::Curve { .. } if for_surfaces => {
                return Err(Failure::usage("this file describes a curve: give --interval and --parts"));
            }
            Coefficients::Surface { .. } if for_curves => {
                return Err(Failure::usage(
                    "this file describes a surface: give --interval-u and --interval-v",
                ));
            }
            Coefficients::Curve { space, interval, coefficients } => Coefficients::Curve {
                space,
                interval: self.interval.clone().unwrap_or(interval),
                coefficients,
            },
            Coefficients::Surface { space_u, interval_u, space_v, interval_v, coefficients } => {
                Coefficients::Surface {
                    space_u,
                    interval_u: self.interval_u.clone().unwrap_or(interval_u),
                    space_v,
                    interval_v: self.interval_v.clone().unwrap_or(interval_v),
                    coefficients,
                }
            }
        })
    }
}

/// How many parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parts {
    Auto,
    Many(usize),
}

fn parts(text: &str) -> Result<Parts, String> {
    if text.eq_ignore_ascii_case("auto") {
        return Ok(Parts::Auto);
    }
    let count = text.parse().ok().filter(|count| (1..=MOST_PARTS).contains(count));
    count.map(Parts::Many).ok_or_else(|| format!("give a number, 1 to {MOST_PARTS}, or auto"))
}

fn root(text: &str) -> Result<Root, String> {
    text.parse().map_err(|error: EcError| error.to_string())
}

fn real(text: &str) -> Result<Real, String> {
    Real::typed(text).map_err(|error| error.to_string())
}
