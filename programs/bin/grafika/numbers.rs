//! Lists of numbers in options, and numbers with points in answers.

use grafika::geometry::Point;
use grafika::launch::Failure;
use serde_json::{Map, Value, json};
use std::str::FromStr;

/// Numbers joined by commas.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Numbers(pub(crate) Vec<f64>);

impl FromStr for Numbers {
    type Err = String;

    fn from_str(text: &str) -> Result<Numbers, String> {
        let number = |word: &str| {
            let number = word.trim().parse::<f64>().ok().filter(|number| number.is_finite());
            number.ok_or_else(|| format!("{:?} is no number; give numbers joined by commas", word.trim()))
        };
        text.split(',').map(number).collect::<Result<_, _>>().map(Numbers)
    }
}

/// As many numbers as are needed.
pub(crate) fn places<const N: usize>(
    numbers: &Numbers,
    option: &str,
    wanted: &str,
) -> Result<[f64; N], Failure> {
    let found = numbers.0.len();
    <[f64; N]>::try_from(numbers.0.clone())
        .map_err(|_| Failure::usage(format!("{option} has {found} numbers; give {wanted}")))
}

/// A number and a point beside it, as JSON; a point that there is not is nulls.
pub(crate) fn row<const D: usize>(name: &str, value: f64, point: Option<Point<D>>) -> Value {
    let mut row = Map::new();
    row.insert(name.to_owned(), json!(value));
    for (d, axis) in ["x", "y", "z"].into_iter().take(D).enumerate() {
        row.insert(axis.to_owned(), json!(point.map(|point| point[d])));
    }
    Value::Object(row)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_read() {
        assert_eq!("1, -2.5,1e3".parse(), Ok(Numbers(vec![1.0, -2.5, 1000.0])));
        for text in ["", "1,,2", "a", "nan", "1;2", "inf"] {
            assert!(text.parse::<Numbers>().is_err(), "{text}");
        }
    }
}
