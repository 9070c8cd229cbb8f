//! Checks and facts that several formats share.

use super::{FileError, Format, settings};
use serde::Serialize;
use std::fmt::Write;

/// The most points that the DOS formats hold.
pub const MAX_POINTS: usize = 99;

/// Points in the order of their axes.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// The number of points, as record 0 holds it at `offset`.
pub(super) fn count(value: i16, offset: usize) -> Result<usize, FileError> {
    usize::try_from(value).ok().filter(|&n| n <= MAX_POINTS).ok_or_else(|| {
        FileError::value("number of points", offset, format!("{value}; it must be 0 to {MAX_POINTS}"))
    })
}

/// Every number is finite.
pub(super) fn finite<const N: usize>(name: &str, points: &[[f64; N]]) -> Result<(), FileError> {
    for (index, point) in points.iter().enumerate() {
        for (value, axis) in point.iter().zip(AXES) {
            if !value.is_finite() {
                let problem = format!("{name} {}: {axis} = {value} is not a finite number", index + 1);
                return Err(FileError::Invalid(problem));
            }
        }
    }
    Ok(())
}

/// There is one for every point.
pub(super) fn one_each(what: &str, count: usize, points: usize) -> Result<(), FileError> {
    if count == points {
        return Ok(());
    }
    let problem = format!("{count} {what} for {points} points; there must be one for every point");
    Err(FileError::Invalid(problem))
}

/// The document has no settings, which no DOS file holds.
pub(super) fn no_settings(format: Format, given: &impl Serialize) -> Result<(), FileError> {
    match settings::given(given).first() {
        Some(name) => Err(FileError::misfit(format, format!("the setting \"{name}\" has no place there"))),
        None => Ok(()),
    }
}

/// There are not more points than records.
pub(super) fn at_most(format: Format, found: usize) -> Result<(), FileError> {
    if found <= MAX_POINTS {
        return Ok(());
    }
    Err(FileError::misfit(format, format!("{found} points; it holds at most {MAX_POINTS}")))
}

/// A point as 16-bit integers, if it is whole and inside `limits`, which lie within 16 bits.
pub(super) fn whole(
    format: Format,
    name: &str,
    index: usize,
    point: [f64; 2],
    limits: [[f64; 2]; 2],
) -> Result<[i16; 2], FileError> {
    for ((value, axis), [low, high]) in point.into_iter().zip(AXES).zip(limits) {
        if value.fract() != 0.0 || !(low..=high).contains(&value) {
            let problem =
                format!("{name} {}: {axis} = {value}; it holds whole numbers {low} to {high}", index + 1);
            return Err(FileError::misfit(format, problem));
        }
    }
    Ok(point.map(|v| v as i16))
}

/// The smallest box with sides along the axes.
pub(super) struct Bounds<const N: usize> {
    low: [f64; N],
    high: [f64; N],
}

impl<const N: usize> Bounds<N> {
    /// The box of the points, if there are any.
    pub(super) fn of<'a>(points: impl Iterator<Item = &'a [f64; N]>) -> Option<Self> {
        points.fold(None, |bounds: Option<Self>, point| {
            let Self { mut low, mut high } = bounds.unwrap_or(Self { low: *point, high: *point });
            for ((l, h), v) in low.iter_mut().zip(&mut high).zip(point) {
                *l = l.min(*v);
                *h = h.max(*v);
            }
            Some(Self { low, high })
        })
    }

    /// `x 60 .. 520, y 60 .. 300`
    pub(super) fn describe(&self) -> String {
        let side = |((axis, low), high)| format!("{axis} {} .. {}", number(low), number(high));
        let sides: Vec<_> = AXES.into_iter().zip(self.low).zip(self.high).map(side).collect();
        sides.join(", ")
    }
}

/// `1 point`, `3 points`: `what` begins with its noun phrase, whose plural is made at `point` or `tangent`.
pub(super) fn counted(count: usize, what: &str) -> String {
    if count == 1 {
        return format!("1 {what}");
    }
    let plural = what.replacen("point", "points", 1).replacen("tangent", "tangents", 1);
    format!("{count} {plural}")
}

/// One line for every point: `point 3: 320, 120`.
pub(super) fn table<const N: usize>(name: &str, points: &[[f64; N]]) -> Vec<String> {
    let row = |(index, point): (usize, &[f64; N])| {
        format!("{name} {}: {}", index + 1, point.map(number).join(", "))
    };
    points.iter().enumerate().map(row).collect()
}

/// The shortest digits that read back as the same double: `60`, `0.1`, `1e300`.
#[must_use]
pub fn number(value: f64) -> String {
    let mut text = String::new();
    write_number(&mut text, value);
    text
}

/// Adds the digits of [`number`] to a text.
pub(super) fn write_number(text: &mut String, value: f64) {
    let start = text.len();
    // Writing to a string cannot fail.
    let _ = write!(text, "{value:?}");
    let whole = text.get(start..).and_then(|digits| digits.strip_suffix(".0"));
    if let Some(length) = whole.filter(|&whole| whole != "-0").map(str::len) {
        text.truncate(start + length);
    }
}
