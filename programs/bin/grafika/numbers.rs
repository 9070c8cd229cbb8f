//! Lists of numbers in options.

use grafika::launch::Failure;
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
