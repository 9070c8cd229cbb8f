//! The points of a cloud while they are read, and what is left out.

use super::super::FileError;
use crate::geometry::COORDINATE_LIMIT;
use std::fmt;

/// The most points of a cloud.
pub const MAX_CLOUD_POINTS: usize = 10_000_000;

/// Room for so many points is made at first.
const FIRST_ROOM: usize = 1024;

/// Where something stands in the file of a cloud, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spot {
    /// A line of text.
    Line(usize),
    /// A point of a binary file; in STL a corner.
    Point(usize),
}

impl fmt::Display for Spot {
    /// `line 7`, `point 7`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(number) => write!(f, "line {number}"),
            Self::Point(number) => write!(f, "point {number}"),
        }
    }
}

/// What of one kind was left out of a cloud.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LeftOut {
    /// How many.
    pub count: usize,
    /// The first of them.
    pub first: Option<Spot>,
}

impl LeftOut {
    fn add(&mut self, spot: Spot) {
        self.count += 1;
        self.first = self.first.or(Some(spot));
    }

    /// `2 short lines, the first in line 7`, with the words for one and for several; nothing if there is none.
    fn told(&self, one: &str, several: &str) -> Option<String> {
        let first = self.first?;
        Some(match self.count {
            1 => format!("1 {one}, in {first}"),
            count => format!("{count} {several}, the first in {first}"),
        })
    }
}

/// What was left out of a cloud when it was read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Skipped {
    /// Points with a coordinate that is NaN, infinite or beyond [`COORDINATE_LIMIT`].
    pub not_finite: LeftOut,
    /// Lines with too few coordinates.
    pub short: LeftOut,
}

impl Skipped {
    /// Whether nothing was left out.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.not_finite.count + self.short.count == 0
    }

    /// What was left out, in a phrase for each kind: `2 short lines, the first in line 7`.
    #[must_use]
    pub fn told(&self) -> Vec<String> {
        let not_finite = self.not_finite.told(
            "point with NaN, infinite or huge coordinates",
            "points with NaN, infinite or huge coordinates",
        );
        let short = self.short.told("line with too few coordinates", "lines with too few coordinates");
        not_finite.into_iter().chain(short).collect()
    }
}

/// The points that have been read so far.
#[derive(Debug, Default)]
pub(super) struct Gathered {
    points: Vec<[f64; 3]>,
    /// How many have been taken away before.
    taken: usize,
    skipped: Skipped,
    /// How many points the file announces.
    announced: Option<usize>,
}

impl Gathered {
    /// Room for the points that a file announces. It is made as they come: a file may announce what it has not.
    ///
    /// # Errors
    /// [`FileError::Invalid`] for more than [`MAX_CLOUD_POINTS`].
    pub(super) fn announce(&mut self, count: u64) -> Result<(), FileError> {
        let fits = usize::try_from(count).ok().filter(|&count| count <= MAX_CLOUD_POINTS);
        self.announced = Some(fits.ok_or_else(|| {
            FileError::Invalid(format!("{count} points are too many; at most {MAX_CLOUD_POINTS} are read"))
        })?);
        Ok(())
    }

    /// Adds a point, or counts it among those left out.
    ///
    /// # Errors
    /// [`FileError::Invalid`] for one more than [`MAX_CLOUD_POINTS`].
    pub(super) fn push(&mut self, point: [f64; 3], spot: Spot) -> Result<(), FileError> {
        if !is_usable(&point) {
            self.skipped.not_finite.add(spot);
            return Ok(());
        }
        let length = self.points.len();
        if self.taken + length >= MAX_CLOUD_POINTS {
            let problem = format!("{spot}: there are more than {MAX_CLOUD_POINTS} points; no more are read");
            return Err(FileError::Invalid(problem));
        }
        if length == self.points.capacity() {
            // Twice as much as before, but never more than there can be.
            let most = self.announced.unwrap_or(MAX_CLOUD_POINTS).max(length + 1);
            self.points.reserve_exact((2 * length).clamp(FIRST_ROOM.min(most), most) - length);
        }
        self.points.push(point);
        Ok(())
    }

    /// Counts a line with too few coordinates.
    pub(super) fn short(&mut self, line: usize) {
        self.skipped.short.add(Spot::Line(line));
    }

    /// The points so far.
    pub(super) fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// Takes the points so far away, in exchange for an empty row to go on with.
    pub(super) fn take(&mut self, points: &mut Vec<[f64; 3]>) {
        points.clear();
        std::mem::swap(&mut self.points, points);
        self.taken += points.len();
    }

    /// All points that were not taken, and what was left out.
    ///
    /// # Errors
    /// [`FileError::Invalid`] when there is no point.
    pub(super) fn finish(mut self) -> Result<(Vec<[f64; 3]>, Skipped), FileError> {
        if self.taken + self.points.len() == 0 {
            let mut problem = "there are no points".to_owned();
            for told in self.skipped.told() {
                problem += &format!("; left out: {told}");
            }
            return Err(FileError::Invalid(problem));
        }
        self.points.shrink_to_fit();
        Ok((self.points, self.skipped))
    }
}

/// Whether every coordinate is a number that can be computed with.
pub(super) fn is_usable(point: &[f64; 3]) -> bool {
    point.iter().all(|value| value.abs() <= COORDINATE_LIMIT)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_is_told() {
        let mut gathered = Gathered::default();
        gathered.push([0.0; 3], Spot::Line(1)).unwrap();
        assert!(gathered.skipped.is_empty());
        for (line, value) in [(2, f64::NAN), (3, f64::INFINITY), (5, 1e151), (6, -1e150)] {
            gathered.push([0.0, 0.0, value], Spot::Line(line)).unwrap();
        }
        gathered.short(9);
        let (points, skipped) = gathered.finish().unwrap();
        assert_eq!(points, [[0.0; 3], [0.0, 0.0, -1e150]]);
        assert_eq!(
            skipped.told(),
            [
                "3 points with NaN, infinite or huge coordinates, the first in line 2",
                "1 line with too few coordinates, in line 9"
            ]
        );
    }

    #[test]
    fn no_points_are_an_error_with_what_was_left_out() {
        let mut gathered = Gathered::default();
        gathered.push([f64::NAN; 3], Spot::Point(4)).unwrap();
        let problem = gathered.finish().unwrap_err().to_string();
        assert_eq!(
            problem,
            "there are no points; left out: 1 point with NaN, infinite or huge coordinates, in point 4"
        );
        assert_eq!(Gathered::default().finish().unwrap_err().to_string(), "there are no points");
    }

    #[test]
    fn there_is_a_limit() {
        let mut gathered = Gathered::default();
        for number in 1..=MAX_CLOUD_POINTS {
            gathered.push([0.0; 3], Spot::Line(number)).unwrap();
        }
        assert_eq!(gathered.points.capacity(), MAX_CLOUD_POINTS);
        let problem = gathered.push([0.0; 3], Spot::Line(MAX_CLOUD_POINTS + 1)).unwrap_err().to_string();
        assert_eq!(problem, "line 10000001: there are more than 10000000 points; no more are read");
        assert!(Gathered::default().announce(10_000_001).is_err());
    }
}
