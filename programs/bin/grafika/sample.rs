//! `grafika sample`: points of a curve or a surface as CSV or JSON.

use crate::at::{self, Columns, Row};
use crate::curve::CurveArgs;
use crate::normals;
use crate::numbers::Numbers;
use crate::ph::PhShape;
use crate::source::{apart, is_stream};
use crate::steps::{self, For};
use clap::Args;
use grafika::design::ec::EcShapes;
use grafika::design::{Design, Shape};
use grafika::figure::{TableFormat, write_curve, write_quantities, write_surface};
use grafika::geometry::skin::Outline;
use grafika::geometry::{
    ParamCurve, ParamSurface, Point, Sample as Place, SurfaceSample, samples, surface_samples,
};
use grafika::launch::{Broken, Failure, Overwrite, Sort, progress};
use std::io::Write;
use std::path::PathBuf;

/// Steps a span of a surface, as most programs of the book draw them.
pub(crate) const SURFACE_STEPS: u32 = 10;

/// The command line of `grafika sample`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika sample A.IP2 --method spline --closed --per-span 20
  grafika sample A.ZMS -o a.json
  grafika sample Y.IP2 --method bspline3 --slopes -o slopes.csv
  grafika sample A.IP2 --method phspline --closed --uniform 200 --quantities
  cat six.json | grafika sample - --from json --method bspline3 -o - --to json > points.json")]
pub(crate) struct Sample {
    #[command(flatten)]
    curve: CurveArgs,
    /// Steps a span: u = 0, 1/N, ... 1 [default: 50, of surfaces 10 in either direction]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    per_span: Option<u32>,
    /// First, or first and second derivatives of a curve, by its parameter
    #[arg(long, value_name = "K", default_value_t = 0, value_parser = clap::value_parser!(u8).range(0..=2))]
    derivatives: u8,
    /// The slopes of a curve, dy/dx and in space dz/dx; empty where the curve goes straight up
    #[arg(long, conflicts_with_all = ["quantities", "uniform"])]
    slopes: bool,
    /// Length, speed, curvature and directions of a PH curve as well; normals and radii of curvature of a surface by pn
    #[arg(long, conflicts_with = "derivatives")]
    quantities: bool,
    /// N + 1 points of a PH curve at equal lengths from each other, instead of equal steps a span
    #[arg(long, value_name = "N", conflicts_with_all = ["derivatives", "per_span"],
        value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    uniform: Option<u32>,
    /// Points at these parameters: by the knots of a .CSM curve, by the position of an .ALP curve, else by span + u
    #[arg(long, value_name = "U,...", allow_hyphen_values = true, conflicts_with_all = ["per_span", "uniform", "quantities"])]
    at: Option<Numbers>,
    /// Which items of a scene that has both
    #[arg(long, value_name = "KIND")]
    items: Option<Items>,
    /// Where to write; .csv or .json [default: CSV on standard output]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Format of what is written, csv or json, where no name says it
    #[arg(long, value_name = "EXT", value_parser = ["csv", "json"], ignore_case = true)]
    to: Option<String>,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Which items of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Items {
    Curves,
    Surfaces,
}

impl Sample {
    /// Samples and writes, row by row.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        apart(&self.curve.source.file, self.output.as_deref())?;
        if self.quantities || self.uniform.is_some() {
            self.check_items(false)?;
            let (design, name) = self.curve.design()?;
            return self.exact(&design, &name);
        }
        let (design, shape) = self.curve.shape()?;
        self.check_items(matches!(shape, Shape::Parts(_)))?;
        let columns = Columns { derivatives: usize::from(self.derivatives), slopes: self.slopes };
        let own = match &self.at {
            Some(Numbers(at)) => Some(at::rows(&design, &shape, at, columns)?),
            None => at::steps(&design, self.per_span.unwrap_or(50) as usize, columns)?,
        };
        if let Some(own) = own {
            let header: Vec<&str> = own.header.iter().map(String::as_str).collect();
            return self.quantities(&header, 0, own.rows);
        }
        match shape {
            Shape::Plane(curve) => self.curves(&[(0, &*curve, 1.0)]),
            Shape::Space(curve) => self.curves(&[(0, &*curve, 1.0)]),
            Shape::Surface(surface) => self.surfaces(&[(0, &*surface)]),
            Shape::Parts(parts) => self.parts(&parts),
            Shape::Outlines(outlines) => self.outlines(&outlines),
        }
    }

    /// Writes a table, with a sign of life where it does not disturb.
    fn write(
        &self,
        rows: impl FnOnce(&mut dyn Write, TableFormat) -> Result<(), Broken>,
    ) -> Result<(), Failure> {
        let format = self.format()?;
        let target = self.overwrite.target(self.output.as_deref())?;
        let _alive = (!target.is_seen()).then(|| progress::alive("sampling"));
        target.write_with(Sort::Text, |out| rows(out, format))
    }

    /// Writes rows of numbers below these names.
    fn quantities(
        &self,
        header: &[&str],
        counted: usize,
        rows: impl Iterator<Item = Row>,
    ) -> Result<(), Failure> {
        let rows = rows.map(|row| row.map_err(Broken::from));
        self.write(|out, format| write_quantities(out, format, header, counted, rows))
    }

    fn check_items(&self, scene: bool) -> Result<(), Failure> {
        match self.items {
            Some(_) if !scene => Err(Failure::usage(
                "--items is for scenes over extended Chebyshev spaces; this file holds none",
            )),
            _ => Ok(()),
        }
    }

    /// What only PH curves know exactly.
    fn exact(&self, design: &Design, name: &str) -> Result<(), Failure> {
        if let (Design::Net(net), None) = (design, self.uniform) {
            let surface = normals::surface(net, name)?;
            let steps = steps::of_surfaces(self.per_span, &[&surface], For::Points);
            // What cannot be told is known before anything is written.
            if let Some(Err(failure)) = normals::quantities(&surface, steps)?.find(Result::is_err) {
                return Err(failure);
            }
            return self.quantities(&normals::QUANTITIES, 2, normals::quantities(&surface, steps)?);
        }
        let shape = PhShape::of(design, name)?;
        let header = shape.header(self.quantities);
        let row = |place| Ok(shape.row(place, self.quantities));
        match self.uniform {
            Some(steps) => {
                let places = shape.by_length(steps as usize)?;
                self.quantities(&header, 1, places.into_iter().map(row))
            }
            None => {
                let places = shape.by_parameter(self.per_span.unwrap_or(50) as usize)?;
                self.quantities(&header, 1, places.map(row))
            }
        }
    }

    /// The curves or the surfaces of a scene, numbered in their order.
    fn parts(&self, parts: &EcShapes) -> Result<(), Failure> {
        let items = match (self.items, parts.curves.is_empty(), parts.patches.is_empty()) {
            (Some(items), ..) => items,
            (None, false, false) => {
                return Err(Failure::usage(
                    "this scene has curves and surfaces; say --items curves or --items surfaces",
                ));
            }
            (None, true, false) => Items::Surfaces,
            (None, ..) => Items::Curves,
        };
        if let (Items::Curves, true, _) | (Items::Surfaces, _, true) =
            (items, parts.curves.is_empty(), parts.patches.is_empty())
        {
            return Err(Failure::usage("--items: this scene has no such items"));
        }
        match items {
            Items::Curves => {
                let curves = parts.curves.iter().enumerate();
                let curves = curves.map(|(k, arc)| (k, arc as &dyn ParamCurve<3>, arc.basis().length()));
                self.curves(&curves.collect::<Vec<_>>())
            }
            Items::Surfaces => {
                let patches = parts.patches.iter().enumerate();
                let patches = patches.map(|(k, patch)| (k, patch as &dyn ParamSurface));
                self.surfaces(&patches.collect::<Vec<_>>())
            }
        }
    }

    /// The outlines of a skin, with their pieces numbered in their order.
    fn outlines(&self, outlines: &[Outline]) -> Result<(), Failure> {
        let firsts = outlines.iter().scan(0, |next, outline| {
            let first = *next;
            *next += outline.spans();
            Some(first)
        });
        let curves = firsts.zip(outlines).map(|(k, outline)| (k, outline as &dyn ParamCurve<2>, 1.0));
        self.curves(&curves.collect::<Vec<_>>())
    }

    /// The points of curves, each with the number of its first span and the length of its parameter in a span, by
    /// which derivatives are taken.
    fn curves<const D: usize>(&self, curves: &[(usize, &dyn ParamCurve<D>, f64)]) -> Result<(), Failure> {
        let steps = self.per_span.unwrap_or(50) as usize;
        let derivatives = usize::from(self.derivatives);
        let known = derivatives.max(usize::from(self.slopes));
        let sampled = curves.iter().map(|&(first, curve, length)| {
            samples(curve, steps).map_err(Failure::work).map(|samples| (first, curve, length, samples))
        });
        let rows = sampled.collect::<Result<Vec<_>, _>>()?.into_iter().flat_map(
            |(first, curve, length, samples)| {
                samples.map(move |Place { span, u, point }| {
                    let mut points = vec![point];
                    let derived = if known > 0 { curve.at(span, u) } else { None };
                    let scaled = |(by, point): (f64, Point<D>)| point.map(|x| x / by);
                    points.extend(derived.into_iter().flat_map(|[_, first, second]| {
                        [(length, first), (length * length, second)].map(scaled).into_iter().take(known)
                    }));
                    (first + span, u, points)
                })
            },
        );
        if self.slopes {
            let columns = Columns { derivatives, slopes: true };
            let names = columns.names::<D>();
            let header: Vec<&str> =
                ["span", "u"].into_iter().chain(names.iter().map(String::as_str)).collect();
            return self.quantities(
                &header,
                1,
                rows.map(|(span, u, points)| {
                    let place = [Some(span as f64), Some(u)];
                    Ok(place.into_iter().chain(columns.numbers(&points)).collect())
                }),
            );
        }
        self.write(|out, format| Ok(write_curve(out, format, derivatives, rows)?))
    }

    fn surfaces(&self, surfaces: &[(usize, &dyn ParamSurface)]) -> Result<(), Failure> {
        let given = [("--derivatives", self.derivatives > 0), ("--slopes", self.slopes)];
        if let Some((option, _)) = given.into_iter().find(|(_, given)| *given) {
            return Err(Failure::usage(format!("{option} is for curves; this file holds a surface")));
        }
        let all: Vec<&dyn ParamSurface> = surfaces.iter().map(|(_, surface)| *surface).collect();
        let steps = steps::of_surfaces(self.per_span, &all, For::Points);
        let sampled = surfaces.iter().map(|&(first, surface)| {
            surface_samples(surface, steps).map_err(Failure::work).map(|samples| (first, samples))
        });
        let rows = sampled.collect::<Result<Vec<_>, _>>()?.into_iter().flat_map(|(first, samples)| {
            samples.map(move |sample| {
                let [i, j] = sample.spans;
                SurfaceSample { spans: [first + i, j], ..sample }
            })
        });
        self.write(|out, format| Ok(write_surface(out, format, rows)?))
    }

    /// The format of the output.
    fn format(&self) -> Result<TableFormat, Failure> {
        let said = self.to.as_ref().map(|said| said.to_lowercase());
        match said.or_else(|| extension(self.output.as_deref())).as_deref() {
            None | Some("csv") => Ok(TableFormat::Csv),
            Some("json") => Ok(TableFormat::Json),
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
