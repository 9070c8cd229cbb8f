//! Sampled curves and surfaces as tables for other programs: CSV and JSON.

use super::number::Number;
use crate::geometry::SurfaceSample;
use serde_json::{Map, Value, json};
use std::fmt::Write;

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

/// Rows of a sampled curve as CSV: the header `span,u,x,y` or `span,u,x,y,z`, with up to two derivatives
/// `dx,dy,dz,ddx,ddy,ddz` behind it, then a line each. Numbers have the fewest digits that read back as the same
/// double.
///
/// ```
/// let rows = [(0, 0.0, vec![[1.0, 2.0]]), (0, 0.5, vec![[1.5, 1e-9]])];
/// assert_eq!(grafika::figure::curve_csv(0, rows.into_iter()), "span,u,x,y\n0,0,1,2\n0,0.5,1.5,1e-9\n");
/// ```
pub fn curve_csv<const D: usize>(derivatives: usize, rows: impl Iterator<Item = CurveRow<D>>) -> String {
    let mut text = format!("span,u,{}\n", columns::<D>(derivatives).join(","));
    for (span, u, points) in rows {
        // Writing to a string cannot fail, here and below.
        let _ = write!(text, "{span},{}", Number(u));
        for coordinate in points.into_iter().flatten() {
            let _ = write!(text, ",{}", Number(coordinate));
        }
        text.push('\n');
    }
    text
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
    let columns = columns::<D>(derivatives);
    let mut text = String::from("[");
    for (index, (span, u, points)) in rows.enumerate() {
        let mut row = Map::new();
        row.insert("span".to_string(), Value::from(span));
        row.insert("u".to_string(), Value::from(u));
        for (column, coordinate) in columns.iter().zip(points.into_iter().flatten()) {
            row.insert(column.clone(), Value::from(coordinate));
        }
        let _ = write!(text, "{}{}", if index == 0 { "\n" } else { ",\n" }, Value::Object(row));
    }
    text.push_str("\n]\n");
    text
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
    let mut text = header.join(",") + "\n";
    for row in rows {
        for (index, value) in row.iter().enumerate() {
            // Writing to a string cannot fail, here and below.
            let _ = write!(text, "{}", if index == 0 { "" } else { "," });
            if let Some(value) = value {
                let _ = write!(text, "{}", Number(*value));
            }
        }
        text.push('\n');
    }
    text
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
    let mut text = String::from("[");
    for (index, row) in rows.iter().enumerate() {
        let fields = header.iter().zip(row).enumerate().map(|(column, (name, value))| {
            let value = match value {
                // Spans are counted from 0.
                Some(value) if column < counted => Value::from(*value as u64),
                value => Value::from(*value),
            };
            format!("{}:{value}", Value::from(*name))
        });
        let row = fields.collect::<Vec<String>>().join(",");
        let _ = write!(text, "{}{{{row}}}", if index == 0 { "\n" } else { ",\n" });
    }
    text.push_str("\n]\n");
    text
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
    let mut text = String::from("i,j,u,v,x,y,z\n");
    for SurfaceSample { spans: [i, j], parameters: [u, v], point: [x, y, z] } in samples {
        let [u, v, x, y, z] = [u, v, x, y, z].map(Number);
        let _ = writeln!(text, "{i},{j},{u},{v},{x},{y},{z}");
    }
    text
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
    let mut text = String::from("[");
    for (index, SurfaceSample { spans: [i, j], parameters: [u, v], point: [x, y, z] }) in samples.enumerate()
    {
        let row = json!({ "i": i, "j": j, "u": u, "v": v, "x": x, "y": y, "z": z });
        let _ = write!(text, "{}{row}", if index == 0 { "\n" } else { ",\n" });
    }
    text.push_str("\n]\n");
    text
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
