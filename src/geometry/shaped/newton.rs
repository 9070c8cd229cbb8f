//! A damped Newton iteration for two unknowns, a parameter and a place on a span, within their limits.

use super::super::point::{norm, scaled_difference};
use super::super::{Point, dot};

/// Starts that are followed, the best ones of the grid.
const STARTS: usize = 48;
/// Steps from one start.
const STEPS: usize = 40;
/// Halvings of a step that does not come nearer.
const HALVINGS: usize = 12;
/// Values that each step of the grid of parameters is parted into, where no start succeeds.
const PARTS: usize = 4;
/// Places that the nearest one of a curve is searched from.
const PLACES: u32 = 32;
/// Golden sections between three such values.
const SECTIONS: usize = 45;

/// What a curve's point and derivatives by the place are at a parameter and a place.
pub(super) type At<'a, const D: usize> = &'a dyn Fn(f64, f64) -> Option<[Point<D>; 3]>;

/// A curve with a parameter, and a point that it should pass.
pub(super) struct Problem<'a, const D: usize> {
    pub(super) at: At<'a, D>,
    pub(super) target: Point<D>,
    /// Of the parameter; places have [0, 1].
    pub(super) limits: [f64; 2],
    /// The distance at which a start counts as successful.
    pub(super) enough: f64,
}

impl<const D: usize> Problem<'_, D> {
    /// The way from the target.
    fn rest(&self, value: f64, x: f64) -> Option<Point<D>> {
        let [point, ..] = (self.at)(value, x)?;
        Some(scaled_difference(1.0, self.target, point))
    }

    fn clamped(&self, [value, x]: [f64; 2]) -> [f64; 2] {
        [value.clamp(self.limits[0], self.limits[1]), x.clamp(0.0, 1.0)]
    }

    /// The derivative by the parameter, by differences.
    fn slope(&self, value: f64, x: f64) -> Option<Point<D>> {
        let step = 1e-6 * (1.0 + value.abs());
        let ([low, _], [high, _]) = (self.clamped([value - step, x]), self.clamped([value + step, x]));
        let scale = if high > low { 1.0 / (high - low) } else { 0.0 };
        Some(scaled_difference(scale, self.rest(low, x)?, self.rest(high, x)?))
    }

    /// The step of least squares; an unknown that stands at its limit and is pushed out stays.
    fn step(&self, [value, x]: [f64; 2]) -> Option<[f64; 2]> {
        let [_, by_x, _] = (self.at)(value, x)?;
        let (by_value, rest) = (self.slope(value, x)?, self.rest(value, x)?);
        let alone = |by: Point<D>| {
            let square = dot(by, by);
            if square > 0.0 { -dot(by, rest) / square } else { 0.0 }
        };
        let (a, b, c) = (dot(by_value, by_value), dot(by_value, by_x), dot(by_x, by_x));
        let (f, g) = (-dot(by_value, rest), -dot(by_x, rest));
        let determinant = a * c - b * b;
        let both = if determinant > 1e-14 * a * c {
            [(c * f - b * g) / determinant, (a * g - b * f) / determinant]
        } else {
            [0.0, alone(by_x)]
        };
        let at_limit = |now: f64, step: f64, low: f64, high: f64| {
            (now <= low && step < 0.0) || (now >= high && step > 0.0)
        };
        let step = if at_limit(value, both[0], self.limits[0], self.limits[1]) {
            [0.0, alone(by_x)]
        } else if at_limit(x, both[1], 0.0, 1.0) {
            [alone(by_value), 0.0]
        } else {
            both
        };
        step.iter().all(|x| x.is_finite()).then_some(step)
    }

    /// Where the iteration from a start ends, and the distance there.
    fn follow(&self, start: [f64; 2]) -> Option<([f64; 2], f64)> {
        let mut place = self.clamped(start);
        let mut distance = norm(self.rest(place[0], place[1])?);
        for _ in 0..STEPS {
            let Some(step) = self.step(place) else { break };
            let mut part = 1.0;
            let mut nearer = None;
            for _ in 0..HALVINGS {
                let next = self.clamped([place[0] + part * step[0], place[1] + part * step[1]]);
                let off = norm(self.rest(next[0], next[1])?);
                if off < distance {
                    nearer = Some((next, off));
                    break;
                }
                part *= 0.5;
            }
            let Some((next, off)) = nearer else { break };
            (place, distance) = (next, off);
        }
        Some((place, distance))
    }

    /// The place of the curve of this parameter that is nearest to the target, and the distance there.
    fn nearest(&self, value: f64) -> Option<([f64; 2], f64)> {
        let off = |x: f64| self.rest(value, x).map(norm);
        let starts = (0..=PLACES).map(|k| f64::from(k) / f64::from(PLACES));
        let (mut x, mut distance) =
            starts.filter_map(|x| Some((x, off(x)?))).min_by(|a, b| a.1.total_cmp(&b.1))?;
        for _ in 0..STEPS {
            let [_, by_x, by_xx] = (self.at)(value, x)?;
            let rest = self.rest(value, x)?;
            let square = dot(by_x, by_x);
            let bend = square + dot(by_xx, rest);
            let step = -dot(by_x, rest) / if bend > 0.0 { bend } else { square };
            let nearer = (0..HALVINGS as i32).find_map(|halving| {
                let next = (x + step * 0.5_f64.powi(halving)).clamp(0.0, 1.0);
                off(next).filter(|far| *far < distance).map(|far| (next, far))
            });
            let Some(next) = nearer else { break };
            (x, distance) = next;
        }
        Some(([value, x], distance))
    }

    /// What is found by the curves of the parameters alone: where the distance from the nearest place is least, by
    /// golden sections. It takes longer than [`Problem::follow`], and does not mind a parameter that moves the point
    /// almost along its curve.
    fn swept(&self, values: &[f64]) -> Vec<([f64; 2], f64)> {
        let part = |pair: &[f64], k: usize| pair[0] + (pair[1] - pair[0]) * k as f64 / PARTS as f64;
        let mut all = vec![self.limits[0], self.limits[1]];
        all.extend(values.windows(2).flat_map(|pair| (0..=PARTS).map(move |k| part(pair, k))));
        all.sort_by(f64::total_cmp);
        all.dedup();
        let ends: Vec<([f64; 2], f64)> = all.iter().filter_map(|value| self.nearest(*value)).collect();
        let off = |k: usize| ends.get(k).map_or(f64::INFINITY, |end| end.1);
        let least = |k: &usize| off(*k) <= off(k.wrapping_sub(1)) && off(*k) <= off(k + 1);
        (0..ends.len())
            .filter(least)
            .filter_map(|k| {
                let around = [ends[k.saturating_sub(1)], ends[(k + 1).min(ends.len() - 1)]];
                let found = self.narrowed(around.map(|end| end.0[0]))?;
                self.follow(found.0)
            })
            .collect()
    }

    /// The parameter between two whose curve comes nearest to the target.
    fn narrowed(&self, [mut low, mut high]: [f64; 2]) -> Option<([f64; 2], f64)> {
        let ratio = (5.0_f64.sqrt() - 1.0) / 2.0;
        let (mut a, mut b) =
            (self.nearest(high - ratio * (high - low))?, self.nearest(low + ratio * (high - low))?);
        for _ in 0..SECTIONS {
            if a.1 < b.1 {
                (high, b) = (b.0[0], a);
                a = self.nearest(high - ratio * (high - low))?;
            } else {
                (low, a) = (a.0[0], b);
                b = self.nearest(low + ratio * (high - low))?;
            }
        }
        Some(if a.1 < b.1 { a } else { b })
    }
}

/// The ends of iterations from a grid of these parameters and sixteen places, the best starts first; where none succeeds,
/// those of a sweep through the parameters too. All that succeed, and the best of the others.
pub(super) fn solve<const D: usize>(problem: &Problem<'_, D>, values: &[f64]) -> Vec<[f64; 2]> {
    let mut starts: Vec<([f64; 2], f64)> = values
        .iter()
        .flat_map(|value| (0..16).map(|k| [*value, (f64::from(k) + 0.5) / 16.0]))
        .filter_map(|start| Some((start, norm(problem.rest(start[0], start[1])?))))
        .collect();
    starts.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut ends: Vec<([f64; 2], f64)> =
        starts.iter().take(STARTS).filter_map(|(start, _)| problem.follow(*start)).collect();
    if ends.iter().all(|end| end.1 > problem.enough) {
        ends.extend(problem.swept(values));
    }
    let least = ends.iter().fold(f64::INFINITY, |least, end| least.min(end.1));
    ends.into_iter().filter(|end| end.1 <= problem.enough.max(least)).map(|end| end.0).collect()
}
