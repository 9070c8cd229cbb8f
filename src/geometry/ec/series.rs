//! The normalized B-basis of a space as power series at both ends of its interval, in double-double arithmetic.
//!
//! In the variable s = (u - start)/h the interval is [0, 1] and the roots are multiplied by h. The canonical solutions
//! y_k = s^k + O(s^(n+1)) come from a recurrence; a combination of y_i, …, y_n that has n - i zeros at 1 is basis
//! function i up to its factor (1.8 to 1.10), and the factors follow from the sum 1. The ordinary basis, nearly
//! dependent on short intervals, is never used.

use super::Space;
use super::dd::{Dd, ONE, ZERO};

/// The shortest interval.
pub(super) const SHORTEST: f64 = 1e-6;

/// The coefficients of the characteristic polynomial of a space whose roots are multiplied by `h`, from the constant to
/// the leading 1; mirrored, the roots have the other sign. Products of real factors: complex ones would leave dust.
pub(super) fn polynomial(space: &Space, h: Dd, mirrored: bool) -> Vec<Dd> {
    let mut product = vec![ONE];
    for root in space.roots() {
        let [re, im] = [root.re.value(), root.im.value()];
        let re = h * if mirrored { -re } else { re };
        let im = h * im;
        let factor = match root.im.value() {
            0.0 => vec![-re, ONE],
            _ => vec![re * re + im * im, -(re + re), ONE],
        };
        for _ in 0..root.multiplicity {
            let mut next = vec![ZERO; product.len() + factor.len() - 1];
            for (i, &a) in product.iter().enumerate() {
                for (b, sum) in factor.iter().zip(next.iter_mut().skip(i)) {
                    *sum += a * *b;
                }
            }
            product = next;
        }
    }
    product
}

/// The series of a basis.
#[derive(Clone, Debug)]
pub(super) struct Series {
    /// `start[i][m]` is the coefficient of s^m of function i.
    pub(super) start: Vec<Vec<Dd>>,
    /// `end[i][j]` is the coefficient of (s - 1)^j of function i, j = 0..n.
    pub(super) end: Vec<Vec<Dd>>,
    /// Whether the factor of every function is positive.
    pub(super) positive: bool,
}

/// The canonical solutions: row k holds the coefficients of y_k.
pub(super) fn canonical(polynomial: &[Dd], radius: f64) -> Vec<Vec<Dd>> {
    let dimension = polynomial.len() - 1;
    let terms = dimension + (std::f64::consts::E * radius).ceil().min(400.0) as usize + 60;
    let mut rows: Vec<Vec<Dd>> = (0..dimension)
        .map(|k| {
            let mut row = vec![ZERO; terms];
            row[k] = ONE;
            row
        })
        .collect();
    if polynomial.iter().take(dimension).all(|&g| g == ZERO) {
        return rows;
    }
    let mut factors = vec![ZERO; dimension];
    for j in 0..terms - dimension {
        // -g_i / ((j + i + 1) … (j + dimension)).
        let mut product = ONE;
        for i in (0..dimension).rev() {
            product = product * (j + i + 1) as f64;
            factors[i] = -polynomial[i] / product;
        }
        for row in &mut rows {
            let sum = factors.iter().zip(&row[j..]).fold(ZERO, |sum, (&factor, &c)| sum + factor * c);
            row[j + dimension] = sum;
        }
    }
    rows
}

/// C(m, j) for m below `terms` and j up to `most`.
fn binomials(terms: usize, most: usize) -> Vec<Vec<Dd>> {
    let mut rows: Vec<Vec<Dd>> = vec![vec![ZERO; most + 1]; terms];
    for m in 0..terms {
        rows[m][0] = ONE;
        for j in 1..=most.min(m) {
            rows[m][j] = rows[m - 1][j] + rows[m - 1][j - 1];
        }
    }
    rows
}

impl Series {
    /// The series of a space whose polynomial belongs to the interval [0, 1]; `radius` is its largest root. `None`
    /// where there is no such basis.
    pub(super) fn new(polynomial: &[Dd], radius: f64) -> Option<Self> {
        Self::of_canonical(&canonical(polynomial, radius))
    }

    /// The same with all coefficients of the canonical solutions wrong in their last digits: how far it is off shows
    /// what rounding does.
    pub(super) fn disturbed(polynomial: &[Dd], radius: f64) -> Option<Self> {
        let mut y = canonical(polynomial, radius);
        let ulp = Dd::from(2.0_f64.powi(-104));
        for (at, c) in y.iter_mut().flatten().enumerate() {
            // Signs without a pattern, and the same every time.
            let up = (at as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 63 == 0;
            *c = *c + *c * if up { ulp } else { -ulp };
        }
        Self::of_canonical(&y)
    }

    fn of_canonical(y: &[Vec<Dd>]) -> Option<Self> {
        let (dimension, terms) = (y.len(), y.first()?.len());
        let n = dimension - 1;
        let choose = binomials(terms, n);
        // Taylor coefficients at 1, from the highest power down.
        let z: Vec<Vec<Dd>> = y
            .iter()
            .enumerate()
            .map(|(k, row)| {
                let at = |j: usize| {
                    let tail = (dimension..terms).rev().fold(ZERO, |sum, m| sum + row[m] * choose[m][j]);
                    tail + choose[k][j]
                };
                (0..dimension).map(at).collect()
            })
            .collect();
        let (mut start, mut end) = (Vec::with_capacity(dimension), Vec::with_capacity(dimension));
        for i in 0..dimension {
            let q = n - i;
            // Row j: sum over k > i of v_k z[k][j] = -z[i][j].
            let mut system: Vec<Vec<Dd>> =
                (0..q).map(|j| (i + 1..dimension).map(|k| z[k][j]).chain([-z[i][j]]).collect()).collect();
            let v = solve(&mut system)?;
            let combined = |rows: &[Vec<Dd>], at: usize| {
                v.iter().zip(&rows[i + 1..]).fold(rows[i][at], |sum, (&v, row)| sum + v * row[at])
            };
            start.push((0..terms).map(|m| if m < i { ZERO } else { combined(y, m) }).collect::<Vec<_>>());
            end.push((0..dimension).map(|j| if j < q { ZERO } else { combined(&z, j) }).collect::<Vec<_>>());
        }
        let mut series = Self { start, end, positive: true };
        series.scale();
        let finite = |rows: &[Vec<Dd>]| rows.iter().flatten().all(|c| c.is_finite());
        (finite(&series.start) && finite(&series.end)).then_some(series)
    }

    /// Multiplies the functions by the factors with which their sum is 1.
    fn scale(&mut self) {
        let mut factors: Vec<Dd> = Vec::with_capacity(self.start.len());
        for i in 0..self.start.len() {
            let wanted = if i == 0 { ONE } else { ZERO };
            let before = factors.iter().zip(&self.start).fold(ZERO, |sum, (&c, row)| sum + c * row[i]);
            factors.push((wanted - before) / self.start[i][i]);
        }
        self.positive = factors.iter().all(|factor| factor.value() > 0.0);
        for rows in [&mut self.start, &mut self.end] {
            for (row, &factor) in rows.iter_mut().zip(&factors) {
                row.iter_mut().for_each(|c| *c = *c * factor);
            }
        }
    }

    /// Function `i` at `s`.
    pub(super) fn value(&self, i: usize, s: Dd) -> Dd {
        self.start[i].iter().rev().fold(ZERO, |sum, &c| sum * s + c)
    }

    /// Whether the functions are those of a normalized B-basis, as far as this length alone can show it: all factors
    /// are positive and no function is negative.
    pub(super) fn passes(&self) -> bool {
        self.positive
            && (0..=40).all(|k| {
                let s = Dd::from(f64::from(k)) / Dd::from(40.0);
                (0..self.start.len()).all(|i| self.value(i, s).value() >= -1e-12)
            })
    }

    /// The Taylor coefficients at `t` of the curve with these control points, as many as there are functions: of
    /// (s - t)^j, one coordinate each.
    pub(super) fn jet<const D: usize>(&self, points: &[[Dd; D]], t: Dd) -> Vec<[Dd; D]> {
        let dimension = self.start.len();
        let blend = |rows: &[Vec<Dd>], m: usize| -> [Dd; D] {
            std::array::from_fn(|d| {
                rows.iter().zip(points).fold(ZERO, |sum, (row, point)| sum + row[m] * point[d])
            })
        };
        if t == ONE {
            return (0..dimension).map(|j| blend(&self.end, j)).collect();
        }
        if t == ZERO {
            return (0..dimension).map(|j| blend(&self.start, j)).collect();
        }
        let terms = self.start[0].len();
        let mut rest: Vec<[Dd; D]> = (0..terms).map(|m| blend(&self.start, m)).collect();
        // Repeated division by s - t.
        for j in 0..dimension {
            for m in (j..terms - 1).rev() {
                let above = rest[m + 1];
                for (here, above) in rest[m].iter_mut().zip(above) {
                    *here += above * t;
                }
            }
        }
        rest.truncate(dimension);
        rest
    }

    /// The control points of the function with these Taylor coefficients at both ends (1.35 to 1.44 in one): from
    /// each end half of them, one after the other.
    pub(super) fn control_points<const D: usize>(&self, start: &[[Dd; D]], end: &[[Dd; D]]) -> Vec<[Dd; D]> {
        let n = self.start.len() - 1;
        let mut points = vec![[ZERO; D]; n + 1];
        for j in 0..=n / 2 {
            points[j] = std::array::from_fn(|d| {
                let known = (0..j).fold(start[j][d], |sum, k| sum - points[k][d] * self.start[k][j]);
                known / self.start[j][j]
            });
        }
        for j in 0..n.div_ceil(2) {
            points[n - j] = std::array::from_fn(|d| {
                let known = (0..j).fold(end[j][d], |sum, k| sum - points[n - k][d] * self.end[n - k][j]);
                known / self.end[n - j][j]
            });
        }
        points
    }

    /// The Chebyshev coefficients of the `order`-th derivatives by s: row j holds those of T_j(2s - 1), one a
    /// function. Every derivative has its own: deriving the rounded ones would lose digits.
    pub(super) fn chebyshev(&self, order: usize) -> Vec<Vec<f64>> {
        let terms = self.start[0].len().saturating_sub(order);
        let derived: Vec<Vec<Dd>> = self
            .start
            .iter()
            .map(|row| {
                let coefficient = |m: usize| (1..=order).fold(row[m + order], |c, k| c * (m + k) as f64);
                (0..terms).map(coefficient).collect()
            })
            .collect();
        let mut rows = Vec::with_capacity(terms);
        let mut diagonal = ONE;
        for j in 0..terms {
            // C(2m, m - j) / 4^m, twice that for j > 0.
            let mut weight = if j == 0 { diagonal } else { diagonal + diagonal };
            let mut sums = vec![ZERO; derived.len()];
            for m in j..terms {
                for (sum, row) in sums.iter_mut().zip(&derived) {
                    *sum += row[m] * weight;
                }
                let (above, below) = ((2 * m + 1) * (2 * m + 2), 4 * (m + 1 - j) * (m + 1 + j));
                weight = weight * above as f64 / Dd::from(below as f64);
                if weight.value() == 0.0 {
                    break;
                }
            }
            rows.push(sums.into_iter().map(Dd::value).collect::<Vec<f64>>());
            diagonal = diagonal * 0.25;
        }
        let largest = rows.iter().flatten().fold(0.0_f64, |most, c| most.max(c.abs()));
        while rows.len() > 1 && rows.last().is_some_and(|row| row.iter().all(|c| c.abs() <= 1e-17 * largest))
        {
            rows.pop();
        }
        rows
    }
}

/// Gaussian elimination with partial pivoting of rows that end in their right sides; `None` where a pivot vanishes.
/// No threshold: good spaces of dimension 31 have tiny pivots.
pub(super) fn solve(rows: &mut [Vec<Dd>]) -> Option<Vec<Dd>> {
    let count = rows.len();
    for column in 0..count {
        let size = |row: &Vec<Dd>| row[column].abs().value();
        let pivot = (column..count).max_by(|&a, &b| size(&rows[a]).total_cmp(&size(&rows[b])))?;
        rows.swap(column, pivot);
        let (above, below) = rows.split_at_mut(column + 1);
        let first = above.last()?;
        if first[column].value() == 0.0 || !first[column].is_finite() {
            return None;
        }
        for row in below {
            let factor = row[column] / first[column];
            for (cell, &other) in row.iter_mut().zip(first).skip(column + 1) {
                *cell = *cell - factor * other;
            }
        }
    }
    let mut solution = vec![ZERO; count];
    for at in (0..count).rev() {
        let row = &rows[at];
        let known = (at + 1..count).fold(row[count], |sum, k| sum - row[k] * solution[k]);
        solution[at] = known / row[at];
    }
    Some(solution)
}
