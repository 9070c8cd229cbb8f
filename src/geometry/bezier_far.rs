//! Bézier curves of a high degree as cubic arcs, and their boxes: the arcs of halving by de Casteljau's algorithm, in time
//! that grows as the square of the degree at most.
//!
//! Halving costs the square of the degree for every piece, and the control points of most pieces are hardly needed. Here a
//! piece is a polynomial through [`NODES`] points of the curve, wherever that is all of it but for rounding. Its difference
//! from a cubic is a sum of Chebyshev polynomials; what these are as Bézier curves of the degree of the whole, a table
//! tells, so that the bound by control points is the same as that of the halved control points.

use super::binomial::{NODES, Nodes, together};
use super::point::{lerp, norm, scaled_difference};
use super::{BoundingBox, CubicBezier, Point};

/// The coefficients behind this one tell whether a polynomial is all of a piece.
const TAIL: usize = NODES - 4;

/// What rounding leaves of them, by the extent of the control points.
const ROUNDED: f64 = 1e-14;

/// How much larger than the curve its box is at most, by the same extent.
const SLACK: f64 = 5e-14;

/// Pieces that a box is made of, besides one for every control point.
const PATIENCE: usize = 1 << 12;

/// A curve of a high degree, with what is needed of it over and over.
pub(super) struct Far<'a, const D: usize> {
    control: &'a [Point<D>],
    /// The sides of the control polygon.
    sides: Vec<Point<D>>,
    nodes: Nodes,
    /// Chebyshev polynomial `k` at node `j`, scaled so that sums over the nodes are coefficients.
    cosines: [[f64; NODES]; NODES],
    /// What a polynomial may lack, and how much too large a box may be.
    rounded: f64,
    slack: f64,
}

/// What is known of the difference between a piece and its cubic.
pub(super) enum Near {
    /// It is nowhere larger than the tolerance.
    Yes,
    /// It is somewhere.
    No,
    /// The piece is no polynomial of the degree that is used here.
    Unknown,
}

impl<'a, const D: usize> Far<'a, D> {
    /// The curve by some control points, with the box round them.
    pub(super) fn new(control: &'a [Point<D>], bounds: &BoundingBox<D>) -> Self {
        let nodes = Nodes::new();
        let cosines = std::array::from_fn(|k| {
            let scale = if k == 0 { 1.0 } else { 2.0 } / NODES as f64;
            std::array::from_fn(|j| scale * (k as f64 * nodes.at[j].acos()).cos())
        });
        let sides = control.windows(2).map(|pair| scaled_difference(1.0, pair[0], pair[1])).collect();
        // Far from the origin the last bits of the coordinates count.
        let (extent, bits) = (bounds.extent(), bounds.last_bits());
        let (rounded, slack) = ((ROUNDED * extent).max(bits), (SLACK * extent).max(bits));
        Self { control, sides, nodes, cosines, rounded, slack }
    }

    /// The point at `u` and the derivative there.
    fn at(&self, u: f64) -> [Point<D>; 2] {
        let degree = self.sides.len() as f64;
        let [point, ..] = together(self.control, [u; 4]);
        let [side, ..] = together(&self.sides, [u; 4]);
        [point, side.map(|x| degree * x)]
    }

    /// The cubic with the ends of a piece and its tangents there.
    pub(super) fn cubic(&self, [from, to]: [f64; 2]) -> CubicBezier<D> {
        let [[a, leaving], [d, arriving]] = [from, to].map(|u| self.at(u));
        let third = (to - from) / 3.0;
        let beside = |p: Point<D>, by: f64, v: Point<D>| std::array::from_fn(|d| p[d] + by * v[d]);
        CubicBezier { p: [a, beside(a, third, leaving), beside(d, -third, arriving), d] }
    }

    /// Whether a piece is within a tolerance of its cubic, as the bound by control points says.
    pub(super) fn near(
        &self,
        part: [f64; 2],
        cubic: &CubicBezier<D>,
        tolerance: f64,
        table: &mut Option<Table>,
    ) -> Near {
        let points = self.nodes.through(self.control, part);
        let differences: [Point<D>; NODES] = std::array::from_fn(|j| {
            scaled_difference(1.0, cubic.eval(0.5 * (self.nodes.at[j] + 1.0)), points[j])
        });
        // The curve keeps within its control points.
        if differences.iter().any(|&difference| norm(difference) > tolerance) {
            return Near::No;
        }
        let coefficients = self.coefficients(&differences);
        if !self.is_all(&coefficients) {
            return Near::Unknown;
        }
        let table = table.get_or_insert_with(|| Table::new(self.sides.len()));
        let sums: Point<D> = std::array::from_fn(|d| {
            coefficients.iter().zip(&table.largest).map(|(c, largest)| c[d].abs() * largest).sum()
        });
        if norm(sums) <= tolerance || table.farthest(&coefficients) <= tolerance {
            Near::Yes
        } else {
            Near::No
        }
    }

    /// The coefficients of Chebyshev polynomials of values at the nodes.
    fn coefficients(&self, values: &[Point<D>; NODES]) -> [Point<D>; NODES] {
        std::array::from_fn(|k| {
            let mut sum = [0.0; D];
            for (value, cosine) in values.iter().zip(&self.cosines[k]) {
                for d in 0..D {
                    sum[d] += cosine * value[d];
                }
            }
            sum
        })
    }

    fn is_all(&self, coefficients: &[Point<D>; NODES]) -> bool {
        let tail = coefficients.iter().skip(TAIL).flatten();
        tail.fold(0.0_f64, |most, c| most.max(c.abs())) <= self.rounded
    }

    /// An upper bound of every coordinate, times a sign, on a piece, and the largest value that was seen there. The bound is
    /// infinite where the piece is no polynomial of the degree that is used here.
    fn top(&self, part: [f64; 2], sign: f64) -> [Point<D>; 2] {
        let points = self.nodes.through(self.control, part);
        let seen =
            std::array::from_fn(|d| points.iter().fold(f64::NEG_INFINITY, |top, p| top.max(sign * p[d])));
        // From one of the points, so that coordinates far from the origin lose nothing.
        let [base, ..] = points;
        let coefficients = self.coefficients(&points.map(|point| scaled_difference(1.0, base, point)));
        if !self.is_all(&coefficients) {
            return [[f64::INFINITY; D], seen];
        }
        let [mean, others @ ..] = &coefficients;
        let top = |d: usize| sign * (base[d] + mean[d]) + others.iter().map(|c| c[d].abs()).sum::<f64>();
        [std::array::from_fn(top), seen]
    }

    /// The largest values of the coordinates times a sign, too large by no more than 1e-13 of the extent of the control
    /// points and too small by rounding only.
    pub(super) fn tops(&self, sign: f64, depth: u32) -> Point<D> {
        let largest = |points: [Option<&Point<D>>; 2], d: usize| {
            points.into_iter().flatten().fold(f64::NEG_INFINITY, |top, p| top.max(sign * p[d]))
        };
        let mut reached: Point<D> =
            std::array::from_fn(|d| largest([self.control.first(), self.control.last()], d));
        // Nothing rises above the control points.
        let most: Point<D> = std::array::from_fn(|d| {
            self.control.iter().fold(f64::NEG_INFINITY, |top, p| top.max(sign * p[d]))
        });
        let mut bound = reached;
        let mut waiting = vec![([0.0, 1.0], depth)];
        // Far more than are ever needed; if rounding has its way, the box is a little too large.
        let mut patience = PATIENCE + self.control.len();
        while let Some((part, depth)) = waiting.pop() {
            let [top, seen] = self.top(part, sign);
            reached = std::array::from_fn(|d| reached[d].max(seen[d]));
            patience = patience.saturating_sub(1);
            if depth == 0 || patience == 0 || (0..D).all(|d| top[d] <= reached[d] + self.slack) {
                bound = std::array::from_fn(|d| bound[d].max(top[d].min(most[d])));
                continue;
            }
            let middle = 0.5 * (part[0] + part[1]);
            waiting.extend([([middle, part[1]], depth - 1), ([part[0], middle], depth - 1)]);
        }
        std::array::from_fn(|d| (bound[d].max(reached[d]) + 0.2 * self.slack).min(most[d]))
    }

    /// The control points of a piece.
    pub(super) fn piece(&self, [from, to]: [f64; 2]) -> Vec<Point<D>> {
        let before: Vec<Point<D>> =
            (0..self.control.len()).map(|i| point_of(self.control.get(..=i), to)).collect();
        let part = if to > 0.0 { from / to } else { 0.0 };
        (0..before.len()).map(|i| point_of(before.get(i..), part)).collect()
    }
}

/// The point at `u` of the curve by some control points.
fn point_of<const D: usize>(control: Option<&[Point<D>]>, u: f64) -> Point<D> {
    match control.unwrap_or_default() {
        [] => [0.0; D],
        [a] => *a,
        [a, b] => lerp(*a, *b, u),
        control => together(control, [u; 4])[0],
    }
}

/// Chebyshev polynomials on [0, 1] as Bézier curves of a degree.
pub(super) struct Table {
    /// For every control point those of all polynomials.
    rows: Vec<[f64; NODES]>,
    /// The largest of every polynomial, without its sign.
    largest: [f64; NODES],
}

impl Table {
    /// For a degree that is larger than those of the polynomials.
    ///
    /// In terms of control points a product with `t` moves them to the next degree: point `i` of `t p` is `i / n` times
    /// point `i - 1` of `p` in degree `n - 1`, and of `(1 - t) p` it is `(n - i) / n` times point `i`. So
    /// `T(k + 1) = 2 (t - (1 - t)) T(k) - T(k - 1)` is computed for the degrees from `n - 31` to `n`. Rounding grows as
    /// the powers of 2 at most, to 1e-5 where coefficients are below 1e-14.
    fn new(degree: usize) -> Table {
        let mut before: Vec<[f64; NODES]> = Vec::new();
        for below in (0..NODES).rev() {
            let n = degree.saturating_sub(below);
            let known = NODES - below;
            let row = |i: usize| {
                let [here, other] = [(n - i) as f64, i as f64].map(|part| part / n.max(1) as f64);
                let mut row = [0.0; NODES];
                let of =
                    |at: Option<usize>, k: usize| at.and_then(|at| before.get(at)).map_or(0.0, |row| row[k]);
                for k in 0..known {
                    row[k] = match k {
                        0 => 1.0,
                        1 => other - here,
                        _ => {
                            let risen = other * of(i.checked_sub(1), k - 1) - here * of(Some(i), k - 1);
                            2.0 * risen - row[k - 2]
                        }
                    };
                }
                row
            };
            before = (0..=n).map(row).collect();
        }
        let largest =
            std::array::from_fn(|k| before.iter().fold(0.0_f64, |largest, row| largest.max(row[k].abs())));
        Table { rows: before, largest }
    }

    /// How far the control points of a sum of polynomials are from the origin at most.
    fn farthest<const D: usize>(&self, coefficients: &[Point<D>; NODES]) -> f64 {
        let by_coordinate: [[f64; NODES]; D] =
            std::array::from_fn(|d| std::array::from_fn(|k| coefficients[k][d]));
        let squares = self.rows.iter().map(|row| {
            let point = by_coordinate.each_ref().map(|column| dot(row, column));
            point.iter().map(|x| x * x).sum::<f64>()
        });
        squares.fold(0.0, f64::max).sqrt()
    }
}

/// The scalar product of long rows, in several sums that do not wait for each other.
fn dot(a: &[f64; NODES], b: &[f64; NODES]) -> f64 {
    let mut sums = [0.0; 4];
    let ((a, _), (b, _)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    for (a, b) in a.iter().zip(b) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

#[cfg(test)]
mod tests {
    use super::super::{Bezier, Closure};
    use super::*;

    /// Every Chebyshev polynomial is the Bézier curve that the table says, in the lowest degree that has one.
    #[test]
    fn the_table_holds_chebyshev_polynomials() {
        let table = Table::new(128);
        for k in 0..NODES {
            let points: Vec<Point<1>> = table.rows.iter().map(|row| [row[k]]).collect();
            assert_eq!(points.len(), 129);
            let curve = Bezier::new(Closure::Open, &points).unwrap();
            for step in 0..=20 {
                let t = f64::from(step) / 20.0;
                let theirs = (k as f64 * (2.0 * t - 1.0).clamp(-1.0, 1.0).acos()).cos();
                let slack = 1e-14 * 2.0_f64.powi(k as i32);
                assert!((curve.eval(t)[0] - theirs).abs() < slack, "{k} {t}");
            }
        }
    }

    #[test]
    fn a_piece_has_the_control_points_of_halving() {
        let points: Vec<Point<2>> = (0..300).map(|i| [f64::from(i), f64::from(i * 37 % 101)]).collect();
        let curve = Bezier::new(Closure::Open, &points).unwrap();
        let [_, after] = curve.split(0.5);
        let [before, _] = after.split(0.25);
        let far = Far::new(&points, &BoundingBox::of_points(&points).unwrap());
        for (ours, theirs) in far.piece([0.5, 0.625]).iter().zip(before.points()) {
            assert!(norm(scaled_difference(1.0, *ours, *theirs)) < 1e-10);
        }
        let (ours, theirs) = (far.cubic([0.5, 0.625]), before.points());
        assert!(norm(scaled_difference(1.0, ours.p[0], theirs[0])) < 1e-11);
        let tip = std::array::from_fn(|d| theirs[0][d] + (299.0 / 3.0) * (theirs[1][d] - theirs[0][d]));
        assert!(norm(scaled_difference(1.0, ours.p[1], tip)) < 1e-9);
    }
}
