//! `grafika basis` and `grafika critical`: the functions of an extended Chebyshev space and how long its intervals may be.

use crate::sample::extension;
use crate::source::{Source, is_stream};
use clap::Args;
use grafika::file::Document;
use grafika::file::ec::{EcDocument, SpaceFile, values};
use grafika::geometry::ec::{CriticalLength, EcBasis, EcError, Real, Space};
use grafika::launch::{Failure, Opened, Overwrite, input_kind, open_as, progress, write_output};
use serde_json::{Map, Value};
use std::fmt::Write;
use std::path::{Path, PathBuf};

const BASIS_EXAMPLES: &str = "Examples:
  grafika basis \"0^3,i^2,2i\" --interval=-pi/2,pi/2 --per-span 100 -o at8.csv
  grafika basis T3 --interval 0,2 --derivatives 2
  grafika basis arc.kcg --transform";

/// A space, as the first word of a command line.
#[derive(Args)]
pub(crate) struct SpaceArg {
    /// Roots as in "0^3,i^2,2i" or "0,1/4+i", a family (P5 T3 H2 AT2 AH2 AET1 M4(1,0.2)), or a .kct, .kcg or .kce file
    #[arg(value_name = "SPACE", allow_hyphen_values = true)]
    space: String,
}

impl SpaceArg {
    /// The space, and the interval that a file says.
    fn space(&self) -> Result<(Space, Option<[f64; 2]>), Failure> {
        let path = Path::new(&self.space);
        let is_file =
            extension(Some(path)).is_some_and(|it| ["kct", "kcg", "kce", "json"].contains(&it.as_str()));
        if !is_file {
            let space = self.space.parse().map_err(|error: EcError| Failure::work(error))?;
            return Ok((space, None));
        }
        let Opened { name, document, .. } = open_as(path, None, &Default::default())?;
        let Document::Ec(document) = document else {
            return Err(Failure::work(format!("{name}: this file holds no extended Chebyshev space")));
        };
        match *document {
            EcDocument::Space(file) => {
                let interval = file.interval.as_ref().map(values);
                Ok((file.space, interval))
            }
            EcDocument::Curve(curve) => Ok((curve.space, Some(values(&curve.interval)))),
            EcDocument::Coefficients(grafika::file::ec::Coefficients::Curve { space, interval, .. }) => {
                Ok((space, Some(values(&interval))))
            }
            _ => Err(Failure::work(format!("{name}: this file holds more than one space; give the roots"))),
        }
    }
}

/// The space that is written in place of a file, as in `0,i` or `T3`; `None` where a file is meant.
pub(crate) fn written(source: &Source) -> Result<Option<EcDocument>, Failure> {
    let text = source.file.to_string_lossy();
    if source.from.from.is_some() || input_kind(&source.file).is_some() || source.file.exists() {
        return Ok(None);
    }
    match text.parse::<Space>() {
        Ok(space) => Ok(Some(EcDocument::Space(SpaceFile { space, interval: None, name: None }))),
        // A list of roots has 0 among them, and is no name that a file would have.
        Err(error) if text.starts_with('0') || text.contains(',') => Err(Failure::work(error)),
        Err(_) => Ok(None),
    }
}

/// The command line of `grafika basis`.
#[derive(Args)]
#[command(after_help = BASIS_EXAMPLES)]
pub(crate) struct BasisTable {
    #[command(flatten)]
    space: SpaceArg,
    /// Interval of the parameter; its ends may be expressions
    #[arg(long, value_name = "A,B", value_parser = interval, allow_hyphen_values = true)]
    interval: Option<[f64; 2]>,
    /// Steps: u = A, A + (B - A)/N, ... B
    #[arg(long, value_name = "N", default_value_t = 50, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    per_span: u32,
    /// Derivatives by the parameter, d1 to dK
    #[arg(long, value_name = "K", default_value_t = 0, value_parser = clap::value_parser!(u8).range(0..=3))]
    derivatives: u8,
    /// The ordinary basis instead of the normalized B-basis
    #[arg(long)]
    ordinary: bool,
    /// The matrix of the transformation: ordinary function i is the sum of t(i,j) times B-basis function j
    #[arg(long, conflicts_with_all = ["per_span", "derivatives", "ordinary"])]
    transform: bool,
    /// Where to write; .csv or .json [default: CSV on standard output]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Format of what is written, csv or json, where no name says it
    #[arg(long, value_name = "EXT", value_parser = ["csv", "json"], ignore_case = true)]
    to: Option<String>,
    #[command(flatten)]
    overwrite: Overwrite,
}

impl BasisTable {
    /// Computes and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let (space, own) = self.space.space()?;
        let interval = self.interval.or(own);
        let interval = interval
            .ok_or_else(|| Failure::usage("which interval? Give --interval, as in --interval 0,pi/2"))?;
        let alive = progress::alive("computing");
        let basis = EcBasis::new(&space, interval).map_err(Failure::work)?;
        let (header, rows) = match self.transform {
            true => transformation(&basis)?,
            false => self.functions(&basis)?,
        };
        drop(alive);
        let said = self.to.as_ref().map(|said| said.to_lowercase());
        let json = match said.or_else(|| extension(self.output.as_deref())).as_deref() {
            None | Some("csv") => false,
            Some("json") => true,
            Some(other) => {
                return Err(Failure::usage(format!("-o: a basis is written as .csv or .json, not .{other}")));
            }
        };
        let output = self.output.as_deref().filter(|path| !is_stream(path));
        let text = if json { as_json(&header, &rows) } else { as_csv(&header, &rows) };
        self.overwrite.write(output, text.as_bytes())
    }

    /// A row for every function and place.
    fn functions(&self, basis: &EcBasis) -> Result<(Vec<String>, Vec<Vec<f64>>), Failure> {
        let [start, end] = basis.interval();
        let orders = usize::from(self.derivatives) + 1;
        let header = ["i", "s", "u"].map(str::to_owned).into_iter();
        let header = header.chain((0..orders).map(|order| format!("d{order}"))).collect();
        let steps = self.per_span;
        let mut places = Vec::with_capacity(steps as usize + 1);
        for k in 0..=steps {
            let s = f64::from(k) / f64::from(steps);
            let u = if k == steps { end } else { start + s * (end - start) };
            let orders = (0..orders).map(|order| match self.ordinary {
                true => basis.space().ordinary(order, u),
                false => {
                    let mut values = Vec::new();
                    basis.derivatives(order, s, &mut values);
                    let scale = basis.length().powi(order as i32);
                    values.into_iter().map(|value| value / scale).collect()
                }
            });
            places.push((s, u, orders.collect::<Vec<Vec<f64>>>()));
        }
        let row = |i: usize, (s, u, orders): &(f64, f64, Vec<Vec<f64>>)| -> Vec<f64> {
            [i as f64, *s, *u].into_iter().chain(orders.iter().map(|values| values[i])).collect()
        };
        let rows: Vec<Vec<f64>> = (0..basis.space().dimension())
            .flat_map(|i| places.iter().map(move |place| (i, place)))
            .map(|(i, place)| row(i, place))
            .collect();
        match rows.iter().flatten().all(|value| value.is_finite()) {
            true => Ok((header, rows)),
            false => Err(Failure::work("the ordinary functions are too large for doubles so far from 0")),
        }
    }
}

fn transformation(basis: &EcBasis) -> Result<(Vec<String>, Vec<Vec<f64>>), Failure> {
    let matrix = basis.transformation().map_err(Failure::work)?;
    let cells = matrix
        .into_iter()
        .enumerate()
        .flat_map(|(i, row)| row.into_iter().enumerate().map(move |(j, t)| vec![i as f64, j as f64, t]));
    Ok((["i", "j", "t"].map(str::to_owned).into(), cells.collect()))
}

fn as_csv(header: &[String], rows: &[Vec<f64>]) -> String {
    let mut text = header.join(",") + "\n";
    for row in rows {
        let cells: Vec<String> = row.iter().map(|value| number(*value)).collect();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

fn as_json(header: &[String], rows: &[Vec<f64>]) -> String {
    let objects = rows.iter().map(|row| {
        let fields = header.iter().cloned().zip(row.iter().map(|&value| {
            match value.fract() == 0.0 && value.abs() < 1e9 {
                true => Value::from(value as i64),
                false => Value::from(value),
            }
        }));
        Value::Object(fields.collect::<Map<String, Value>>()).to_string()
    });
    format!("[\n{}\n]\n", objects.collect::<Vec<_>>().join(",\n"))
}

/// The fewest digits that read back as the same double.
fn number(value: f64) -> String {
    if value.is_infinite() { "inf".to_owned() } else { grafika::file::number(value) }
}

/// The command line of `grafika critical`.
#[derive(Args)]
#[command(after_help = "Examples:\n  grafika critical \"0,1/4+i\"\n  grafika critical AT2")]
pub(crate) struct Critical {
    #[command(flatten)]
    space: SpaceArg,
}

impl Critical {
    /// Searches and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let (space, _) = self.space.space()?;
        let alive = progress::alive("searching");
        let lengths = [CriticalLength::new(&space), CriticalLength::of_itself(&space)];
        let [design, own] = lengths.map(|search| number(search.finish()));
        drop(alive);
        write_output(format!("lprime,l\n{design},{own}\n").as_bytes())
    }
}

/// Reads the two ends of an interval.
pub(crate) fn interval(text: &str) -> Result<[f64; 2], String> {
    let (start, end) = text.split_once(',').ok_or("give both ends, as in 0,pi/2")?;
    let end_of =
        |text: &str| text.parse::<Real>().map(|real| real.value()).map_err(|error| error.to_string());
    Ok([end_of(start)?, end_of(end)?])
}

/// Reads an interval whose ends are kept as written.
pub(crate) fn written_interval(text: &str) -> Result<[Real; 2], String> {
    let (start, end) = text.split_once(',').ok_or("give both ends, as in 0,pi/2")?;
    let end_of = |text: &str| Real::typed(text).map_err(|error| error.to_string());
    Ok([end_of(start)?, end_of(end)?])
}
