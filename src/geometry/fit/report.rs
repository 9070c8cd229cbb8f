//! How far points are from a surface, in numbers and in classes for colours.

/// The distances of all points, in the unit of the points.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// How many points there are.
    pub points: usize,
    /// The root of the mean square.
    pub rms: f64,
    /// The largest, without its sign.
    pub largest: f64,
    /// The mean with signs: above the surface minus below it.
    pub mean: f64,
    /// What 95 % of the points are not farther away than.
    pub percentile_95: f64,
    /// The root of the mean square after every solution, the first without any correction of parameters.
    pub history: Vec<f64>,
}

impl Report {
    /// The report of signed distances; of none, all is 0.
    pub(super) fn new(distances: &[f64], history: Vec<f64>) -> Self {
        let points = distances.len();
        let share = 1.0 / points.max(1) as f64;
        let mut sizes: Vec<f64> = distances.iter().map(|d| d.abs()).collect();
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        // By the largest, so that no square is too large or too small for a double.
        let unit = if largest > 0.0 { largest } else { 1.0 };
        let square: f64 = sizes.iter().map(|d| (d / unit).powi(2)).sum();
        let mean: f64 = distances.iter().map(|d| d / unit).sum();
        let rank = (points * 95).div_ceil(100).saturating_sub(1);
        let percentile_95 = if points == 0 {
            0.0
        } else {
            let (_, value, _) = sizes.select_nth_unstable_by(rank, f64::total_cmp);
            *value
        };
        Self {
            points,
            rms: unit * (square * share).sqrt(),
            largest,
            mean: unit * (mean * share),
            percentile_95,
            history,
        }
    }
}

/// A class of distances, by a unit sigma that usually is their root mean square.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ErrorClass {
    /// Whether the point is below the surface, where distances are negative.
    pub below: bool,
    /// 0 within half of sigma, 1 within sigma, 2 within twice and 3 within four times of it, 4 beyond.
    pub level: usize,
}

impl ErrorClass {
    /// The number of levels on either side.
    pub const LEVELS: usize = 5;
    /// The limits between the levels as multiples of sigma.
    pub const LIMITS: [f64; 4] = [0.5, 1.0, 2.0, 4.0];

    /// The class of a signed distance. Where all distances are 0, so is sigma, and the level is 0.
    #[must_use]
    pub fn of(distance: f64, sigma: f64) -> Self {
        let size = distance.abs();
        let level =
            if size > 0.0 { Self::LIMITS.iter().filter(|limit| size >= *limit * sigma).count() } else { 0 };
        Self { below: distance < 0.0, level }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_distances() {
        let distances: Vec<f64> =
            (1..=100).map(|k| if k % 2 == 0 { f64::from(k) } else { -f64::from(k) }).collect();
        let report = Report::new(&distances, vec![]);
        assert_eq!((report.points, report.largest, report.percentile_95), (100, 100.0, 95.0));
        assert!((report.rms - 3383.5_f64.sqrt()).abs() < 1e-12 && (report.mean - 0.5).abs() < 1e-14);
        assert_eq!(Report::new(&[], vec![]).rms, 0.0);
        assert_eq!(Report::new(&[1e300, -1e300], vec![]).rms, 1e300);
        assert_eq!(Report::new(&[-3.0], vec![]).percentile_95, 3.0);
    }

    #[test]
    fn classes_are_halves_and_doubles_of_sigma() {
        let of = |distance| ErrorClass::of(distance, 2.0);
        for (distance, level) in
            [(0.0, 0), (0.99, 0), (1.0, 1), (1.99, 1), (2.0, 2), (3.9, 2), (4.0, 3), (8.0, 4)]
        {
            assert_eq!(of(distance), ErrorClass { below: false, level });
            assert_eq!(of(-distance).level, level);
        }
        assert!(of(-0.1).below && !of(0.0).below);
        assert_eq!(ErrorClass::of(0.0, 0.0).level, 0);
        assert_eq!(ErrorClass::of(1e-300, 0.0).level, 4);
    }
}
