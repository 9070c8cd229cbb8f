//! Sampled curves and surfaces as tables for other programs: CSV and JSON.
//!
//! Rows are written one by one, so that a table may be longer than memory; the functions that give the whole text do the
//! same.

use super::number::Number;
use crate::geometry::SurfaceSample;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::io;

/// The names of the coordinates.
const AXES: [&str; 3] = ["x", "y", "z"];

/// The names of a point's coordinates, of its first and of its second derivative.
const ORDERS: [&str; 3] = ["", "d", "dd"];

/// A row of a sampled curve: span from 0, parameter `u` in it, and the point with so many derivatives.
pub type CurveRow<const D: usize> = (usize, f64, Vec<[f64; D]>);

/// The names of the columns after `span` and `u`.
fn columns<const D: usize>(derivatives: usize) -> Vec<String> {
    let orders = ORDERS.iter().take(derivatives + 1);
    orders.flat_map(|order| AXES.iter().take(D).map(move |axis| format!("{order}{axis}"))).collect()
}

/// How rows of numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableFormat {
    /// A line of names, then a line for every row.
    Csv,
    /// An array with an object for every row.
    Json,
}

/// A row as it is written, the first one or another.
type WriteRow<'a, R> = &'a mut dyn FnMut(&mut String, &R);

/// Writes rows one by one: in JSON between the signs of an array.
fn write_rows<R, E: From<io::Error>>(
    out: &mut dyn io::Write,
    format: TableFormat,
    header: &str,
    rows: impl Iterator<Item = Result<R, E>>,
    write_row: WriteRow<'_, R>,
) -> Result<(), E> {
    match format {
        TableFormat::Csv => out.write_all(format!("{header}\n").as_bytes())?,
        TableFormat::Json => out.write_all(b"[")?,
    }
    let mut line = String::new();
    for (index, row) in rows.enumerate() {
        line.clear();
        if format == TableFormat::Json {
            line.push_str(if index == 0 { "\n" } else { ",\n" });
        }
        write_row(&mut line, &row?);
        if format == TableFormat::Csv {
            line.push('\n');
        }
        out.write_all(line.as_bytes())?;
    }
    if format == TableFormat::Json {
        out.write_all(b"\n]\n")?;
    }
    Ok(())
}

/// What is written as text.
fn text_of(write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>) -> String {
    let mut bytes = Vec::new();
    // Writing to a row of bytes cannot fail, and numbers and names are text.
    let _ = write(&mut bytes);
    String::from_utf8(bytes).unwrap_or_default()
}

/// Writes the rows of a sampled curve one by one, as [`curve_csv`] or [`curve_json`] have them.
///
/// # Errors
/// Those of the writer.
pub fn write_curve<const D: usize>(
    out: &mut dyn io::Write,
    format: TableFormat,
    derivatives: usize,
    rows: impl Iterator<Item = CurveRow<D>>,
) -> io::Result<()> {
    let columns = columns::<D>(derivatives);
    let header = format!("span,u,{}", columns.join(","));
    write_rows(out, format, &header, rows.map(io::Result::Ok), &mut |line, (span, u, points)| match format {
        TableFormat::Csv => {
            // Writing to a string cannot fail, here and below.
            let _ = write!(line, "{span},{}", Number(*u));
            for &coordinate in points.iter().flatten() {
                let _ = write!(line, ",{}", Number(coordinate));
            }
        }
        TableFormat::Json => {
            let mut row = Map::new();
            row.insert("span".to_string(), Value::from(*span));
            row.insert("u".to_string(), Value::from(*u));
            for (column, &coordinate) in columns.iter().zip(points.iter().flatten()) {
                row.insert(column.clone(), Value::from(coordinate));
            }
            let _ = write!(line, "{}", Value::Object(row));
        }
    })
}

/// Rows of a sampled curve as CSV: the header `span,u,x,y` or `span,u,x,y,z`, with up to two derivatives
/// `dx,dy,dz,ddx,ddy,ddz` behind it, then a line each. Numbers have the fewest digits that read back as the same
/// double.
///
/// ```
/// let rows = [(0, 0.0, vec![[1.0, 2.0]]), (0, 0.5, vec![[1.5, 1e-9]])];
/// assert_eq!(grafika::figure::curve_csv(0, rows.into_iter()), "span,u,x,y\n0,0,1,2\n0,0.5,1.5,1e-9\n");
/// ```
pub fn curve_csv<const D: usize>(derivatives: usize, rows: impl Iterator<Item = CurveRow<D>>) -> String {
    text_of(|out| write_curve(out, TableFormat::Csv, derivatives, rows))
}

/// The rows of [`curve_csv`] as a JSON array with an object a line: `span` (an integer), `u`, `x`, `y`
/// and in space `z`. Numbers read back as the same double; one that is not finite, which no curve of
/// this library has, becomes `null`.
///
/// ```
/// let rows = [(0, 0.0, vec![[1.0, 2.0]]), (0, 1.0, vec![[0.1, 3.0]])];
/// let text = grafika::figure::curve_json(0, rows.into_iter());
/// assert_eq!(text, r#"[
/// {"span":0,"u":0.0,"x":1.0,"y":2.0},
/// {"span":0,"u":1.0,"x":0.1,"y":3.0}
/// ]
/// "#);
/// ```
pub fn curve_json<const D: usize>(derivatives: usize, rows: impl Iterator<Item = CurveRow<D>>) -> String {
    text_of(|out| write_curve(out, TableFormat::Json, derivatives, rows))
}

/// Writes rows of numbers below these names one by one, as [`quantity_csv`] or [`quantity_json`] have them; the first
/// `counted` columns are integers in JSON.
///
/// # Errors
/// Those of the writer and of the rows.
pub fn write_quantities<E: From<io::Error>>(
    out: &mut dyn io::Write,
    format: TableFormat,
    header: &[&str],
    counted: usize,
    rows: impl Iterator<Item = Result<Vec<Option<f64>>, E>>,
) -> Result<(), E> {
    write_rows(out, format, &header.join(","), rows, &mut |line, row| {
        if format == TableFormat::Json {
            line.push('{');
        }
        for (column, (name, value)) in header.iter().zip(row).enumerate() {
            line.push_str(if column == 0 { "" } else { "," });
            match (format, value) {
                (TableFormat::Csv, Some(value)) => {
                    let _ = write!(line, "{}", Number(*value));
                }
                (TableFormat::Csv, None) => {}
                (TableFormat::Json, value) => {
                    let value = match value {
                        // Spans are counted from 0.
                        Some(value) if column < counted => Value::from(*value as u64),
                        value => Value::from(*value),
                    };
                    let _ = write!(line, "{}:{value}", Value::from(*name));
                }
            }
        }
        if format == TableFormat::Json {
            line.push('}');
        }
    })
}

/// A table of numbers as CSV, below a header of these names: rows of one number a column, and an empty field where there
/// is none.
///
/// ```
/// let rows = vec![vec![Some(0.0), Some(0.5), None]];
/// let text = grafika::figure::quantity_csv(&["span", "u", "kappa"], &rows);
/// assert_eq!(text, "span,u,kappa\n0,0.5,\n");
/// ```
#[must_use]
pub fn quantity_csv(header: &[&str], rows: &[Vec<Option<f64>>]) -> String {
    let rows = rows.iter().cloned().map(io::Result::Ok);
    text_of(|out| write_quantities(out, TableFormat::Csv, header, 0, rows))
}

/// The rows of [`quantity_csv`] as a JSON array with an object a line; the first `counted` columns are integers, and
/// `null` is where there is no number.
///
/// ```
/// let rows = vec![vec![Some(0.0), Some(0.5), None]];
/// let text = grafika::figure::quantity_json(&["span", "u", "kappa"], 1, &rows);
/// assert_eq!(text, "[\n{\"span\":0,\"u\":0.5,\"kappa\":null}\n]\n");
/// ```
#[must_use]
pub fn quantity_json(header: &[&str], counted: usize, rows: &[Vec<Option<f64>>]) -> String {
    let rows = rows.iter().cloned().map(io::Result::Ok);
    text_of(|out| write_quantities(out, TableFormat::Json, header, counted, rows))
}

/// Writes the samples of a surface one by one, as [`surface_csv`] or [`surface_json`] have them.
///
/// # Errors
/// Those of the writer.
pub fn write_surface(
    out: &mut dyn io::Write,
    format: TableFormat,
    samples: impl Iterator<Item = SurfaceSample>,
) -> io::Result<()> {
    write_rows(out, format, "i,j,u,v,x,y,z", samples.map(io::Result::Ok), &mut |line, sample| {
        let SurfaceSample { spans: [i, j], parameters: [u, v], point: [x, y, z] } = *sample;
        match format {
            TableFormat::Csv => {
                let [u, v, x, y, z] = [u, v, x, y, z].map(Number);
                let _ = write!(line, "{i},{j},{u},{v},{x},{y},{z}");
            }
            TableFormat::Json => {
                let row = json!({ "i": i, "j": j, "u": u, "v": v, "x": x, "y": y, "z": z });
                let _ = write!(line, "{row}");
            }
        }
    })
}

/// Samples of a surface as CSV: the header `i,j,u,v,x,y,z` (spans from 0, parameters in them, the point),
/// then a line each. Numbers have the fewest digits that read back as the same double.
///
/// ```
/// use grafika::geometry::SurfaceSample;
///
/// let sample = SurfaceSample { spans: [0, 2], parameters: [0.5, 1.0], point: [1.0, 0.1, 1e-9] };
/// let text = grafika::figure::surface_csv([sample].into_iter());
/// assert_eq!(text, "i,j,u,v,x,y,z\n0,2,0.5,1,1,0.1,1e-9\n");
/// ```
pub fn surface_csv(samples: impl Iterator<Item = SurfaceSample>) -> String {
    text_of(|out| write_surface(out, TableFormat::Csv, samples))
}

/// The rows of [`surface_csv`] as a JSON array with an object a line.
///
/// ```
/// use grafika::geometry::SurfaceSample;
///
/// let sample = SurfaceSample { spans: [0, 2], parameters: [0.5, 1.0], point: [1.0, 0.1, 3.0] };
/// let text = grafika::figure::surface_json([sample].into_iter());
/// assert_eq!(text, r#"[
/// {"i":0,"j":2,"u":0.5,"v":1.0,"x":1.0,"y":0.1,"z":3.0}
/// ]
/// "#);
/// ```
pub fn surface_json(samples: impl Iterator<Item = SurfaceSample>) -> String {
    text_of(|out| write_surface(out, TableFormat::Json, samples))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const FINITE: proptest::num::f64::Any = proptest::num::f64::NORMAL;

    #[test]
    fn no_rows() {
        let none = || std::iter::empty::<CurveRow<3>>();
        assert_eq!(curve_csv(0, none()), "span,u,x,y,z\n");
        assert_eq!(serde_json::from_str::<Value>(&curve_json(0, none())).unwrap(), Value::Array(Vec::new()));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn tables_read_back(span: usize, u in FINITE, point in prop::array::uniform3(FINITE)) {
            let row = || std::iter::once((span, u, vec![point]));
            let csv = curve_csv(0, row());
            let line: Vec<&str> = csv.lines().nth(1).unwrap().split(',').collect();
            prop_assert_eq!(line[0].parse::<usize>().unwrap(), span);
            let numbers: Vec<f64> = line[1..].iter().map(|number| number.parse().unwrap()).collect();
            prop_assert_eq!(numbers, [u, point[0], point[1], point[2]]);
            let json: Value = serde_json::from_str(&curve_json(0, row())).unwrap();
            prop_assert_eq!(json[0]["span"].as_u64(), Some(span as u64));
            let numbers = ["u", "x", "y", "z"].map(|name| json[0][name].as_f64().unwrap());
            prop_assert_eq!(numbers, [u, point[0], point[1], point[2]]);
        }
    }
}
