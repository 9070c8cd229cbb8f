//! Bézier curves of a high degree at many parameters: as sums by binomial weights, of which only those near the middle
//! count.
//!
//! A point of the curve of degree `N` at `u` is a mean of the control points by the weights of a binomial distribution,
//! which lie around `N u` as widely as `s = sqrt(N u (1 - u))`. What lies further away than 26 + 8.83 s weighs less than
//! 1e-17 together (Bernstein's inequality), so that a point costs the square root of the degree.
//!
//! The curve itself is smooth on the same scale: where the control points differ by no more than `a` from some point, its
//! `m`-th derivative by the mean `N u` is at most `a sqrt(m!) / s^m` (the weights' derivatives are Krawtchouk's
//! polynomials). So between [`NODES`] Chebyshev points on a length of 4 s it is a polynomial but for `2 a / sqrt(32!)`,
//! 4e-18 of `a`. A long row of points costs a few hundred operations for every control point, whatever its length.

use super::Point;

/// How many parameters are computed side by side: the ratio of neighbouring weights is nearly the same for all of them.
pub(super) const LANES: usize = 4;

/// Points of the curve that a polynomial is drawn through.
pub(super) const NODES: usize = 32;

/// What is left out weighs less than 1e-17: so many deviations and control points away from the mean.
const DEVIATIONS: f64 = 8.83;
const BESIDE: f64 = 26.0;

/// The deviation, in steps from point to point, from which neighbours are computed side by side.
const LEAST_DEVIATION: f64 = 0.5;

/// The length of a polynomial in deviations.
const PANEL: f64 = 4.0;

/// Points of the Bézier curve by these control points; exactly its ends at 0 and 1. The parameters lie so near each other
/// that the means of their weights are a few deviations apart.
pub(super) fn together<const D: usize>(control: &[Point<D>], u: [f64; LANES]) -> [Point<D>; LANES] {
    let (Some(&first), Some(&end)) = (control.first(), control.last()) else { return [[0.0; D]; LANES] };
    let last = control.len() - 1;
    let degree = last as f64;
    let mean = u.map(|u| degree * u);
    let beside = u.map(|u| BESIDE + DEVIATIONS * (degree * (u * (1.0 - u)).max(0.0)).sqrt());
    // Casts keep within the length: they saturate.
    let low = (0..LANES).map(|lane| (mean[lane] - beside[lane]).max(0.0) as usize).fold(last, usize::min);
    let high =
        (0..LANES).map(|lane| ((mean[lane] + beside[lane]).ceil() as usize).min(last)).fold(0, usize::max);
    let middle = ((mean.iter().sum::<f64>() / LANES as f64).round() as usize).clamp(low, high);
    // From the middle outwards, where all weights are 1 at first. Differences from the middle keep the last bits of points
    // far from the origin.
    let base = control.get(middle).copied().unwrap_or(first);
    let mut sums = Sums { weights: [1.0; LANES], totals: [1.0; LANES], sums: [[0.0; LANES]; D] };
    let up = u.map(|u| u / (1.0 - u));
    let above = control.get(middle + 1..=high).unwrap_or_default();
    for (k, point) in (middle + 1..).zip(above) {
        sums.add((last + 1 - k) as f64 / k as f64, &up, base, point);
    }
    sums.weights = [1.0; LANES];
    let down = u.map(|u| (1.0 - u) / u);
    let below = control.get(low..middle).unwrap_or_default();
    for (k, point) in (low..middle).zip(below).rev() {
        sums.add((k + 1) as f64 / (last - k) as f64, &down, base, point);
    }
    std::array::from_fn(|lane| match u[lane] {
        u if u <= 0.0 => first,
        u if u >= 1.0 => end,
        _ => std::array::from_fn(|d| base[d] + sums.sums[d][lane] / sums.totals[lane]),
    })
}

/// The weights on the way outwards, and the sums so far.
struct Sums<const D: usize> {
    weights: [f64; LANES],
    totals: [f64; LANES],
    sums: [[f64; LANES]; D],
}

impl<const D: usize> Sums<D> {
    /// Goes on to the next point.
    #[inline]
    fn add(&mut self, ratio: f64, by: &[f64; LANES], base: Point<D>, point: &Point<D>) {
        for ((weight, total), by) in self.weights.iter_mut().zip(&mut self.totals).zip(by) {
            *weight *= ratio * by;
            *total += *weight;
        }
        for d in 0..D {
            let difference = point[d] - base[d];
            for (sum, weight) in self.sums[d].iter_mut().zip(&self.weights) {
                *sum += weight * difference;
            }
        }
    }
}

/// The points at `0, 1 / (n - 1), ..., 1` of the Bézier curve by these control points.
pub(super) fn equal_steps<const D: usize>(control: &[Point<D>], n: usize) -> Vec<Point<D>> {
    let steps = n.saturating_sub(1).max(1) as f64;
    let degree = control.len().saturating_sub(1).max(1) as f64;
    // The deviation of the weights, in steps.
    let deviation = |at: f64| {
        let u = (at / steps).clamp(0.0, 1.0);
        steps * (u * (1.0 - u) / degree).sqrt()
    };
    let nodes = Nodes::new();
    let mut points = Vec::with_capacity(n);
    while points.len() < n {
        let from = points.len() as f64;
        // The deviation has no least value between two places that is less than at both.
        let mut length = PANEL * deviation(from);
        length = length.min(PANEL * deviation(from + length)).min(steps - from);
        let whole = length as usize;
        if whole <= NODES {
            // Where the weights are too far from each other, each point has its own.
            let after = from + (LANES - 1) as f64;
            let near = deviation(from).min(deviation(after)) >= LEAST_DEVIATION;
            let several = if near { LANES } else { 1 };
            let place = |lane: usize| ((from + lane.min(several - 1) as f64) / steps).min(1.0);
            points.extend(
                together(control, std::array::from_fn(place)).into_iter().take(several.min(n - points.len())),
            );
            continue;
        }
        let through = nodes.through(control, [from / steps, (from + length) / steps]);
        points.extend((0..whole).map(|step| nodes.between(&through, 2.0 * step as f64 / length - 1.0)));
    }
    points
}

/// Chebyshev points on [-1, 1], with the weights of the barycentric formula.
pub(super) struct Nodes {
    pub(super) at: [f64; NODES],
    weights: [f64; NODES],
}

impl Nodes {
    pub(super) fn new() -> Nodes {
        let angle = |j: usize| (2 * j + 1) as f64 * std::f64::consts::PI / (2 * NODES) as f64;
        let sign = |j: usize| if j.is_multiple_of(2) { 1.0 } else { -1.0 };
        Nodes {
            at: std::array::from_fn(|j| -angle(j).cos()),
            weights: std::array::from_fn(|j| sign(j) * angle(j).sin()),
        }
    }

    /// Points of the curve at the nodes of a part of it.
    pub(super) fn through<const D: usize>(
        &self,
        control: &[Point<D>],
        [from, to]: [f64; 2],
    ) -> [Point<D>; NODES] {
        let mut points = [[0.0; D]; NODES];
        let (groups, _) = points.as_chunks_mut::<LANES>();
        let (places, _) = self.at.as_chunks::<LANES>();
        for (group, places) in groups.iter_mut().zip(places) {
            *group = together(control, places.map(|at| from + 0.5 * (at + 1.0) * (to - from)));
        }
        points
    }

    /// The polynomial through points at the nodes.
    fn between<const D: usize>(&self, points: &[Point<D>; NODES], x: f64) -> Point<D> {
        let (mut sum, mut total) = ([0.0; D], 0.0);
        for ((&at, &weight), point) in self.at.iter().zip(&self.weights).zip(points) {
            if x == at {
                return *point;
            }
            let weight = weight / (x - at);
            total += weight;
            for d in 0..D {
                sum[d] += weight * point[d];
            }
        }
        sum.map(|x| x / total)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Bezier, Closure};
    use super::*;
    use proptest::prelude::*;

    /// Points with jumps of up to 2, around a place.
    fn noise(n: usize, seed: usize, around: f64) -> Vec<Point<2>> {
        let value = |i: usize| ((i * 7919 + seed * 104_729) % 1009) as f64 / 504.5 - 1.0;
        (0..n).map(|i| [around + value(i), value(3 * i + 1)]).collect()
    }

    fn farthest(ours: &[Point<2>], theirs: &[Point<2>]) -> f64 {
        let gaps = ours.iter().flatten().zip(theirs.iter().flatten()).map(|(a, b)| (a - b).abs());
        gaps.fold(0.0, f64::max)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        #[test]
        fn points_are_those_of_all_weights(
            n in 1_usize..3000, seed in 0_usize..99, at in 0.0..=1.0, near in prop::array::uniform4(-1.0..1.0),
        ) {
            let control = noise(n, seed, 0.0);
            // A deviation beside a place, where the weights are as wide.
            let u = near.map(|near: f64| f64::clamp(at + near * f64::sqrt(at * (1.0 - at) / n as f64), 0.0, 1.0));
            let theirs = match n {
                1 => [control[0]; LANES],
                _ => { let curve = Bezier::new(Closure::Open, &control).unwrap(); u.map(|u| curve.eval(u)) }
            };
            prop_assert!(farthest(&together(&control, u), &theirs) < 1e-13);
        }

        /// Also where polynomials are drawn through points of the curve.
        #[test]
        fn rows_are_those_of_all_weights(n in 2_usize..5000, density in prop::sample::select(vec![1_usize, 2, 5, 16, 300]), seed in 0_usize..99, far: bool) {
            let around = if far { 1e6 } else { 0.0 };
            let n = if density > 16 { 2 + n / 100 } else { n };
            let control = noise((n - 1) * density + 1, seed, around);
            let curve = Bezier::new(Closure::Open, &control).unwrap();
            let ours = equal_steps(&control, n);
            prop_assert_eq!(ours.len(), n);
            prop_assert_eq!((ours[0], ours[n - 1]), (control[0], control[control.len() - 1]));
            // Some of them: the other way takes long.
            let places: Vec<usize> = (0..n).step_by(n / 40 + 1).collect();
            let theirs: Vec<Point<2>> = places.iter().map(|&i| curve.eval(i as f64 / (n - 1) as f64)).collect();
            let ours: Vec<Point<2>> = places.iter().map(|&i| ours[i]).collect();
            prop_assert!(farthest(&ours, &theirs) < 1e-13 + 1e-14 * around, "{}", farthest(&ours, &theirs));
        }
    }

    #[test]
    fn equal_points_stay_where_they_are() {
        let control = vec![[0.1, -7e9]; 20_001];
        assert!(equal_steps(&control, 3000).iter().all(|point| farthest(&[*point], &[[0.1, -7e9]]) <= 1e-5));
        assert_eq!(together(&control, [0.2; 4]), [[0.1, -7e9]; 4]);
        assert!(equal_steps::<2>(&[], 0).is_empty());
    }
}
