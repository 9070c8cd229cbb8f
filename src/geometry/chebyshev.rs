//! Functions of a span as Chebyshev series, side by side.

use super::Point;
use super::param::clipped;
use super::point::add_scaled;

/// How many places are evaluated side by side.
const LANES: usize = 8;

/// Some functions of `u` in [0, 1] as Chebyshev series: row j has the coefficients of T_j(2u - 1), one for each of
/// the functions.
#[derive(Clone, Debug, PartialEq)]
pub struct Chebyshev {
    rows: Vec<Vec<f64>>,
}

impl Chebyshev {
    /// The functions with these coefficients. All rows must be of one length.
    pub(super) fn new(rows: Vec<Vec<f64>>) -> Self {
        Self { rows }
    }

    /// Function n - i at 1 - u in place of function i at u, times a sign.
    pub(super) fn mirrored(mut self, sign: f64) -> Self {
        for (j, row) in self.rows.iter_mut().enumerate() {
            let sign = if j % 2 == 1 { -sign } else { sign };
            row.reverse();
            row.iter_mut().for_each(|c| *c *= sign);
        }
        self
    }

    /// Whether all coefficients are numbers.
    pub(super) fn is_finite(&self) -> bool {
        self.rows.iter().flatten().all(|c| c.is_finite())
    }

    /// Replaces `out` by the values of all functions at `u`, which is clipped to [0, 1] (Clenshaw).
    pub fn values(&self, u: f64, out: &mut Vec<f64>) {
        let count = self.rows.first().map_or(0, Vec::len);
        let x = 2.0 * clipped(u) - 1.0;
        // `out` is b_(j+1), `ahead` is b_(j+2).
        let mut ahead = vec![0.0; count];
        out.clear();
        out.resize(count, 0.0);
        let Some((first, rest)) = self.rows.split_first() else { return };
        for row in rest.iter().rev() {
            for ((here, ahead), &a) in out.iter_mut().zip(&mut ahead).zip(row) {
                let next = a + 2.0 * x * *here - *ahead;
                *ahead = *here;
                *here = next;
            }
        }
        for ((here, ahead), &a) in out.iter_mut().zip(&ahead).zip(first) {
            *here = a + x * *here - ahead;
        }
    }

    /// Fills `out` with points blended by the functions at equal steps of `u`, from 0 to 1; a single one is at 0.
    ///
    /// The series of the coordinates are made first: a point costs no more with many control points than with few.
    pub fn blend<const D: usize>(&self, points: &[Point<D>], out: &mut [Point<D>]) {
        let series: Vec<Point<D>> = self
            .rows
            .iter()
            .map(|row| row.iter().zip(points).fold([0.0; D], |sum, (&c, &point)| add_scaled(sum, c, point)))
            .collect();
        let Some((first, rest)) = series.split_first() else { return };
        let steps = out.len().saturating_sub(1).max(1) as f64;
        for (block, places) in out.chunks_mut(LANES).enumerate() {
            let x: [f64; LANES] =
                std::array::from_fn(|lane| 2.0 * clipped((block * LANES + lane) as f64 / steps) - 1.0);
            let (mut here, mut ahead) = ([[0.0; LANES]; D], [[0.0; LANES]; D]);
            for row in rest.iter().rev() {
                for ((here, ahead), &a) in here.iter_mut().zip(&mut ahead).zip(row) {
                    for ((here, ahead), x) in here.iter_mut().zip(ahead).zip(x) {
                        let next = a + 2.0 * x * *here - *ahead;
                        *ahead = *here;
                        *here = next;
                    }
                }
            }
            for (lane, place) in places.iter_mut().enumerate() {
                *place = std::array::from_fn(|d| first[d] + x[lane] * here[d][lane] - ahead[d][lane]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// T_j(x) by its cosine.
    fn term(j: usize, x: f64) -> f64 {
        (j as f64 * x.acos()).cos()
    }

    proptest! {
        #[test]
        fn sums_are_those_of_cosines(
            rows in prop::collection::vec(prop::collection::vec(-9.0..9.0_f64, 4), 1..12),
            points in prop::collection::vec(prop::array::uniform3(-9.0..9.0_f64), 4),
            steps in 1_usize..40,
        ) {
            let functions = Chebyshev::new(rows.clone());
            let mut blended = vec![[0.0; 3]; steps + 1];
            functions.blend(&points, &mut blended);
            let (mut values, mut other) = (Vec::new(), Vec::new());
            for (k, place) in blended.iter().enumerate() {
                let u = k as f64 / steps as f64;
                functions.values(u, &mut values);
                functions.clone().mirrored(-1.0).values(1.0 - u, &mut other);
                for i in 0..4 {
                    let sum: f64 = rows.iter().enumerate().map(|(j, row)| row[i] * term(j, 2.0 * u - 1.0)).sum();
                    prop_assert!((values[i] - sum).abs() < 1e-11);
                    prop_assert!((other[3 - i] + values[i]).abs() < 1e-11);
                }
                for d in 0..3 {
                    let sum: f64 = values.iter().zip(&points).map(|(value, point)| value * point[d]).sum();
                    prop_assert!((place[d] - sum).abs() < 1e-10);
                }
            }
        }
    }
}
