//! The Bézier curve by all control points: one arc of any degree (2.47)-(2.48).

use super::arclen::integrate;
use super::bezier_far::{Far, Near};
use super::cubic::check_arcs;
use super::method::Closure;
use super::param::{ParamCurve, check_tolerance, clipped};
use super::point::{add_scaled, check_count, check_points, lerp, norm, scaled_difference};
use super::{BoundingBox, CubicBezier, GeometryError, Point};

/// A Bézier curve of degree `points - 1`, at least 1, with checked coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Bezier<const D: usize> {
    points: Vec<Point<D>>,
}

/// Smallest tolerance of the cubic arcs, by the extent of the control points.
const LEAST_TOLERANCE: f64 = 1e-12;

/// From this degree on, pieces are computed from points of the curve instead of halving all control points, if the
/// tolerance leaves room for rounding: by the extent of the control points, and by the last bits of their coordinates.
const HIGH_DEGREE: usize = 400;
const ROOM: f64 = 1e-10;
const ROOM_FAR_AWAY: f64 = 16.0;

/// How often a piece is halved at most. Its control points are then equal but for rounding, so
/// searches end long before.
const DEPTH: u32 = 64;

impl<const D: usize> Bezier<D> {
    /// The curve by these control points. A closed one returns to its first point, which makes
    /// its degree the number of points; it has a corner there unless the points avoid it.
    ///
    /// # Errors
    /// Fewer than 2 points (3 when closed), too many, or a bad coordinate.
    pub fn new(closure: Closure, points: &[Point<D>]) -> Result<Self, GeometryError> {
        let needed = match closure {
            Closure::Open => 2,
            Closure::Closed => 3,
        };
        check_count(points.len(), needed)?;
        check_points(points)?;
        let seam = match closure {
            Closure::Open => None,
            Closure::Closed => points.first(),
        };
        Ok(Self { points: points.iter().chain(seam).copied().collect() })
    }

    /// The arcs of [`ParamCurve::to_cubics`] by halving.
    fn halved(&self, tolerance: f64) -> Vec<CubicBezier<D>> {
        let mut arcs = Vec::new();
        let mut waiting = vec![(self.points.clone(), DEPTH)];
        while let Some((piece, depth)) = waiting.pop() {
            let arc = cubic_like(&piece);
            if depth == 0 || deviation(&piece, &arc) <= tolerance {
                arcs.push(arc);
            } else {
                let [left, right] = split(&piece, 0.5);
                waiting.push((right, depth - 1));
                waiting.push((left, depth - 1));
            }
        }
        arcs
    }

    /// The same arcs but for rounding, of a high degree.
    fn far_cubics(&self, bounds: &BoundingBox<D>, tolerance: f64) -> Vec<CubicBezier<D>> {
        let (far, mut table) = (Far::new(&self.points, bounds), None);
        let mut arcs = Vec::new();
        let mut waiting = vec![([0.0, 1.0], DEPTH)];
        while let Some((part, depth)) = waiting.pop() {
            let arc = far.cubic(part);
            let near = match far.near(part, &arc, tolerance, &mut table) {
                Near::Yes => true,
                Near::No => false,
                Near::Unknown if part == [0.0, 1.0] => deviation(&self.points, &arc) <= tolerance,
                Near::Unknown => deviation(&far.piece(part), &arc) <= tolerance,
            };
            if depth == 0 || near {
                arcs.push(arc);
            } else {
                let middle = 0.5 * (part[0] + part[1]);
                waiting.extend([([middle, part[1]], depth - 1), ([part[0], middle], depth - 1)]);
            }
        }
        arcs
    }

    /// The control points; those of a closed curve end with the first one again.
    #[must_use]
    pub fn points(&self) -> &[Point<D>] {
        &self.points
    }

    /// The polynomial degree, at least 1.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.points.len().saturating_sub(1)
    }

    /// The point at `u`, which is clipped to [0, 1]; exactly the end points at 0 and 1. In linear
    /// time by convex combinations only, so it is as stable as de Casteljau's algorithm.
    #[must_use]
    pub fn eval(&self, u: f64) -> Point<D> {
        bernstein_sum(self.points.iter().copied(), u)
    }

    /// The derivative by `u` at `u` in [0, 1].
    #[must_use]
    pub fn derivative(&self, u: f64) -> Point<D> {
        let degree = self.degree() as f64;
        let legs = self.points.windows(2).map(|p| scaled_difference(degree, p[0], p[1]));
        bernstein_sum(legs, u)
    }

    /// The second derivative by `u` at `u` in [0, 1].
    #[must_use]
    pub fn second_derivative(&self, u: f64) -> Point<D> {
        let degree = self.degree() as f64;
        let factor = degree * (degree - 1.0);
        let bend =
            |p: &[Point<D>]| std::array::from_fn(|d| factor * ((p[0][d] - p[1][d]) + (p[2][d] - p[1][d])));
        bernstein_sum(self.points.windows(3).map(bend), u)
    }

    /// The two parts before and after `u` (clipped to [0, 1]) by de Casteljau's algorithm.
    #[must_use]
    pub fn split(&self, u: f64) -> [Self; 2] {
        let [left, right] = split(&self.points, clipped(u));
        [Self { points: left }, Self { points: right }]
    }
}

/// One span.
impl<const D: usize> ParamCurve<D> for Bezier<D> {
    fn spans(&self) -> usize {
        1
    }

    fn closed(&self) -> bool {
        self.points.first() == self.points.last()
    }

    fn at(&self, span: usize, u: f64) -> Option<[Point<D>; 3]> {
        (span == 0).then(|| [self.eval(u), self.derivative(u), self.second_derivative(u)])
    }

    fn eval(&self, span: usize, u: f64) -> Option<Point<D>> {
        (span == 0).then(|| self.eval(u))
    }

    /// Cubic arcs that follow the curve at every parameter within `tolerance`, equal points and
    /// tangents at the joints included. The bound holds for sure: the difference of a piece and
    /// its arc is again a Bézier curve, which stays within its control points. Degrees up to 3 are
    /// one exact arc.
    ///
    /// # Errors
    /// `tolerance` not positive or NaN, or below 1e-12 of the extent of the control points or the last bits of
    /// their coordinates.
    fn to_cubics(&self, tolerance: f64) -> Result<Vec<CubicBezier<D>>, GeometryError> {
        check_tolerance(tolerance)?;
        let bounds = BoundingBox::of_points(&self.points);
        let least = bounds.map_or(0.0, |it| (LEAST_TOLERANCE * it.extent()).max(it.last_bits()));
        if self.degree() > 3 && tolerance < least {
            return Err(GeometryError::ToleranceTooSmall { value: tolerance, least });
        }
        let room = |bounds: &BoundingBox<D>| {
            tolerance >= (ROOM * bounds.extent()).max(ROOM_FAR_AWAY * bounds.last_bits())
        };
        match bounds.filter(room) {
            Some(bounds) if self.degree() >= HIGH_DEGREE => check_arcs(self.far_cubics(&bounds, tolerance)),
            _ => check_arcs(self.halved(tolerance)),
        }
    }

    /// A box round the curve, never too small and too large by no more than 1e-13 of the box of
    /// its control points; of a degree of 400 and more perhaps by the last bits of their coordinates.
    fn bounding_box(&self) -> Option<BoundingBox<D>> {
        if self.degree() >= HIGH_DEGREE {
            let far = Far::new(&self.points, &BoundingBox::of_points(&self.points)?);
            let [low, high] = [-1.0, 1.0].map(|sign| far.tops(sign, DEPTH));
            return Some(BoundingBox { min: low.map(|x| -x), max: high });
        }
        let coefficients = |d: usize, sign: f64| self.points.iter().map(|p| [sign * p[d]]).collect();
        Some(BoundingBox {
            min: std::array::from_fn(|d| -largest_value(coefficients(d, -1.0))),
            max: std::array::from_fn(|d| largest_value(coefficients(d, 1.0))),
        })
    }

    /// The accuracy is not taken smaller than 1e-14 of the control polygon.
    fn length(&self, accuracy: f64) -> f64 {
        let legs = self.points.windows(2).map(|p| norm(scaled_difference(1.0, p[0], p[1])));
        let polygon: f64 = legs.sum();
        integrate(&|u| norm(self.derivative(u)), [0.0, 1.0], accuracy.max(1e-14 * polygon))
    }
}

/// The Bernstein sum of `points` at `u` in [0, 1] (Woźny and Chudy, 2020): after point `k` the
/// value is the weighted mean of the points up to `k`, and `share` the part of the newest in it.
/// The origin when there are no points.
fn bernstein_sum<const D: usize>(points: impl ExactSizeIterator<Item = Point<D>>, u: f64) -> Point<D> {
    let u = clipped(u);
    let degree = points.len().saturating_sub(1);
    let mut share = 1.0;
    let mut mean = [0.0; D];
    for (k, point) in points.enumerate() {
        if k > 0 {
            let newest = (degree - k + 1) as f64 * u * share;
            // Never 0 / 0: at u = 1 the share stays 1, below 1 the first term is positive.
            share = newest / (k as f64 * (1.0 - u) + newest);
        }
        mean = lerp(mean, point, share);
    }
    mean
}

/// Control points before and after `u`. Each round of de Casteljau's algorithm shortens the list
/// by one; its first points are those of the left part, and what stays are those of the right.
fn split<const D: usize>(points: &[Point<D>], u: f64) -> [Vec<Point<D>>; 2] {
    let mut right = points.to_vec();
    let mut left = Vec::with_capacity(points.len());
    for finished in 0..points.len() {
        left.extend(right.first());
        let still = points.len() - finished;
        // right[..still] is the current round; its last point belongs to the right part.
        for i in 1..still {
            right[i - 1] = lerp(right[i - 1], right[i], u);
        }
    }
    [left, right]
}

/// The cubic with the end points and end tangents of a Bézier piece; the piece itself when its
/// degree is 3 or less.
fn cubic_like<const D: usize>(piece: &[Point<D>]) -> CubicBezier<D> {
    match *piece {
        [] => CubicBezier { p: [[0.0; D]; 4] },
        [a] => CubicBezier { p: [a; 4] },
        [a, b] => CubicBezier { p: [a, lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b] },
        [a, b, c] => CubicBezier { p: [a, lerp(a, b, 2.0 / 3.0), lerp(c, b, 2.0 / 3.0), c] },
        [a, b, c, d] => CubicBezier { p: [a, b, c, d] },
        [a, b, .., c, d] => {
            let third = (piece.len() - 1) as f64 / 3.0;
            let from = scaled_difference(third, a, b);
            CubicBezier {
                p: [a, add_scaled(a, 1.0, from), add_scaled(d, third, scaled_difference(1.0, d, c)), d],
            }
        }
    }
}

/// A bound of the distance at equal parameters between a piece and its cubic: the largest
/// distance of control points once the cubic is raised to the degree of the piece.
fn deviation<const D: usize>(piece: &[Point<D>], cubic: &CubicBezier<D>) -> f64 {
    let degree = piece.len().saturating_sub(1);
    if degree <= 3 {
        return 0.0;
    }
    let distance = |(i, p): (usize, &Point<D>)| norm(scaled_difference(1.0, raised(cubic, i, degree), *p));
    piece.iter().enumerate().map(distance).fold(0.0, f64::max)
}

/// Control point `i` of a cubic raised to `degree`: the weight of cubic point `j` is
/// C(i, j) C(degree - i, 3 - j) / C(degree, 3).
fn raised<const D: usize>(cubic: &CubicBezier<D>, i: usize, degree: usize) -> Point<D> {
    let choose = |m: usize| {
        let m = m as f64;
        [1.0, m, m * (m - 1.0) / 2.0, m * (m - 1.0) * (m - 2.0) / 6.0]
    };
    let (before, after, [.., all]) = (choose(i), choose(degree - i), choose(degree));
    let mut sum = [0.0; D];
    for (j, &p) in cubic.p.iter().enumerate() {
        sum = add_scaled(sum, before[j] * after[3 - j] / all, p);
    }
    sum
}

/// An upper bound of a polynomial on [0, 1] by its Bernstein coefficients, too large by no more
/// than 1e-13 of their range: pieces that cannot rise above a value already reached are dropped.
fn largest_value(coefficients: Vec<Point<1>>) -> f64 {
    let top = |piece: &[Point<1>]| piece.iter().fold(f64::NEG_INFINITY, |m, [x]| m.max(*x));
    let bottom = coefficients.iter().fold(f64::INFINITY, |m, [x]| m.min(*x));
    let slack = 1e-13 * (top(&coefficients) - bottom);
    let ends = [coefficients.first(), coefficients.last()];
    let mut reached = ends.into_iter().flatten().fold(f64::NEG_INFINITY, |m, [x]| m.max(*x));
    let mut bound = reached;
    let mut waiting = vec![(coefficients, DEPTH)];
    while let Some((piece, depth)) = waiting.pop() {
        let piece_top = top(&piece);
        if depth == 0 || piece_top <= reached + slack {
            bound = bound.max(piece_top);
            continue;
        }
        let [left, right] = split(&piece, 0.5);
        reached = right.first().map_or(reached, |[x]| reached.max(*x));
        waiting.push((left, depth - 1));
        waiting.push((right, depth - 1));
    }
    bound.max(reached)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(6))]
        /// Arcs and boxes of a high degree are those of halving.
        #[test]
        fn high_degrees_are_halved_the_same(
            n in 402_usize..450, seed in 0_usize..1000, noise in prop::sample::select(vec![0.0, 1e-9, 0.01, 1.0, 30.0]),
            part in prop::sample::select(vec![1e-5, 1e-3, 0.1]), far: bool,
        ) {
            let jump = |i: usize| ((i * 7919 + seed * 31) % 1000) as f64 * 1e-3 - 0.5;
            let around = if far { 100.0 } else { 0.0 };
            let point = |i: usize| [i as f64, around + 50.0 * (0.02 * i as f64).sin() + noise * jump(i)];
            let curve = Bezier::new(Closure::Open, &(0..n).map(point).collect::<Vec<_>>()).unwrap();
            let (ours, theirs) = (curve.to_cubics(part * n as f64).unwrap(), curve.halved(part * n as f64));
            prop_assert_eq!(ours.len(), theirs.len());
            for (ours, theirs) in ours.iter().flat_map(|arc| arc.p).zip(theirs.iter().flat_map(|arc| arc.p)) {
                prop_assert!(distance(ours, theirs) < 1e-12 * (n as f64 + around), "{:?} {:?}", ours, theirs);
            }
            let bounds = curve.bounding_box().unwrap();
            let extent = BoundingBox::of_points(&curve.points).unwrap().extent();
            for d in 0..2 {
                let values = |sign: f64| curve.points.iter().map(|p| [sign * p[d]]).collect();
                let theirs = [-largest_value(values(-1.0)), largest_value(values(1.0))];
                prop_assert!((bounds.min[d] - theirs[0]).abs() <= 3e-13 * extent + 1e-15 * around);
                prop_assert!((bounds.max[d] - theirs[1]).abs() <= 3e-13 * extent + 1e-15 * around);
            }
        }
    }

    fn wave(n: usize) -> Bezier<2> {
        let points: Vec<_> = (0..n).map(|i| [i as f64, 10.0 * (1.3 * i as f64).sin()]).collect();
        Bezier::new(Closure::Open, &points).unwrap()
    }

    fn distance(a: Point<2>, b: Point<2>) -> f64 {
        norm(scaled_difference(1.0, a, b))
    }

    #[test]
    fn parts_lie_on_the_curve() {
        let curve = wave(60);
        let [before, after] = curve.split(0.3);
        for j in 0..=20 {
            let u = f64::from(j) / 20.0;
            assert!(distance(before.eval(u), curve.eval(0.3 * u)) < 1e-12);
            assert!(distance(after.eval(u), curve.eval(0.3 + 0.7 * u)) < 1e-12);
        }
        assert_eq!(before.points().last(), after.points().first());
    }

    #[test]
    fn derivatives_agree_with_differences() {
        let curve = wave(12);
        let h = 1e-4;
        for u in [0.1, 0.4, 0.85] {
            let slope = scaled_difference(0.5 / h, curve.eval(u - h), curve.eval(u + h));
            assert!(distance(slope, curve.derivative(u)) < 1e-3);
            let bend = scaled_difference(0.5 / h, curve.derivative(u - h), curve.derivative(u + h));
            assert!(distance(bend, curve.second_derivative(u)) < 1e-2);
        }
        // Two points: a line with no second derivative.
        assert_eq!(wave(2).second_derivative(0.5), [0.0, 0.0]);
    }

    #[test]
    fn raised_cubic_is_the_same_curve() {
        let cubic = CubicBezier { p: [[0.0, 1.0], [5.0, -3.0], [2.0, 8.0], [9.0, 9.0]] };
        let points: Vec<_> = (0..=17).map(|i| raised(&cubic, i, 17)).collect();
        let curve = Bezier::new(Closure::Open, &points).unwrap();
        assert!(
            (0..=10).map(|j| f64::from(j) / 10.0).all(|u| distance(curve.eval(u), cubic.eval(u)) < 1e-13)
        );
        assert!(deviation(&points, &cubic) < 1e-13);
        assert_eq!(curve.to_cubics(1e-6).map(|arcs| arcs.len()), Ok(1));
    }

    #[test]
    fn low_degrees_are_one_exact_arc() {
        for n in 2..=4 {
            let curve = wave(n);
            let arcs = curve.to_cubics(1e-300).unwrap();
            assert_eq!(arcs.len(), 1);
            assert!(
                (0..=8).map(|j| f64::from(j) / 8.0).all(|u| distance(curve.eval(u), arcs[0].eval(u)) < 1e-14)
            );
        }
    }

    #[test]
    fn tolerances_that_cannot_be_kept_are_errors() {
        for tolerance in [0.0, -1.0, f64::NAN] {
            let error = wave(9).to_cubics(tolerance);
            assert!(matches!(error, Err(GeometryError::Parameter { name: "tolerance", .. })));
        }
        assert!(matches!(wave(9).to_cubics(1e-15), Err(GeometryError::ToleranceTooSmall { .. })));
        assert!(wave(9).to_cubics(1e-10).is_ok());
    }

    #[test]
    fn closed_curve_returns_to_its_first_point() {
        let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let curve = Bezier::new(Closure::Closed, &points).unwrap();
        assert_eq!((curve.degree(), curve.eval(0.0), curve.eval(1.0)), (3, points[0], points[0]));
        assert_eq!(curve.eval(0.5), [0.375, 0.375]);
    }

    #[test]
    fn length_is_that_of_the_arcs() {
        let curve = wave(20);
        let arcs = curve.to_cubics(1e-9).unwrap();
        let sum: f64 = arcs.iter().map(|arc| arc.length(1e-12)).sum();
        assert!((curve.length(1e-10) - sum).abs() < 1e-5);
    }

    #[test]
    fn box_of_a_line_is_exact() {
        let points: Vec<_> = (0..99).map(|i| [f64::from(i), 7.0]).collect();
        let bounds = Bezier::new(Closure::Open, &points).unwrap().bounding_box().unwrap();
        assert_eq!((bounds.min, bounds.max), ([0.0, 7.0], [98.0, 7.0]));
    }
}
